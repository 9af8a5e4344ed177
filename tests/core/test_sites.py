# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites of prisms against Eq. 2.1, changes by hand, overlaps."""

import numpy as np
import pytest

from freecad_trabecula.core.parameters import PrismParameters, SiteEdit
from freecad_trabecula.core.sites import OPPOSITE_FACES, edit_sites, overlapping_pairs, prism_sites
from freecad_trabecula.errors import ParameterError

PRISM = PrismParameters(l=51.0, w=40.6, h=8.55, n_x=39, n_y=31, n_z=6)


def test_sites_follow_equation_2_1():
    points = prism_sites(PRISM)["Face5"].points
    x = sorted({round(v, 9) for v in points[:, 0]})
    y = sorted({round(v, 9) for v in points[:, 1]})
    assert x == pytest.approx([1 + (51 - 2) / 38 * (i - 1) for i in range(1, 40)])
    assert y == pytest.approx([1 + (40.6 - 2) / 30 * (j - 1) for j in range(1, 32)])
    assert (points[:, 2] == 0).all()


def test_every_face_has_its_number_of_sites_and_its_outer_normal():
    sites = prism_sites(PRISM)
    assert [len(sites[f"Face{k}"]) for k in range(1, 7)] == [31 * 6, 31 * 6, 6 * 39, 6 * 39, 39 * 31, 39 * 31]
    centre = np.array([51, 40.6, 8.55]) / 2
    for s in sites.values():
        assert (((s.points - centre) * s.normals).sum(1) > 0).all()
        assert np.allclose(np.linalg.norm(s.normals, axis=1), 1)
        assert np.allclose((s.u * s.normals).sum(1), 0)


@pytest.mark.parametrize("first, second", OPPOSITE_FACES)
def test_equal_numbers_are_opposite_each_other(first, second):
    a, b = (prism_sites(PRISM)[f] for f in (first, second))
    assert (a.index == b.index).all() and (a.u == b.u).all()
    across = b.points - a.points
    assert np.allclose(np.cross(across, a.normals), 0)


def test_names_tell_face_and_numbers():
    assert prism_sites(PrismParameters(n_x=2, n_y=2, n_z=2))["Face3"].names == (
        "Face3.1.1", "Face3.1.2", "Face3.2.1", "Face3.2.2",
    )  # fmt: skip


def test_sites_of_a_prism_face_are_flat():
    assert prism_sites(PRISM)["Face1"].flat


def test_a_site_is_switched_off_moved_and_added():
    sites = prism_sites(PrismParameters())["Face1"]
    place = (np.array([0.0, 2.0, 3.0]), sites.u[0], sites.normals[0])
    edits = [
        SiteEdit("Face1.1.1", "off"),
        SiteEdit("Face1.1.2", "move", point=(0.0, 2.0, 3.0)),
        SiteEdit("Face1.extra", "add", point=(0.0, 2.0, 3.0)),
        SiteEdit("Face2.1.1", "off"),
    ]
    edited = edit_sites(sites, edits, {"Face1.1.2": place, "Face1.extra": place})
    assert len(edited) == 50 and edited.names[-1] == "Face1.hand.1"
    assert list(np.nonzero(~edited.on)[0]) == [0]
    assert (edited.points[[1, -1]] == place[0]).all()
    assert sites.on.all() and len(sites) == 49  # the originals are as they were


def test_a_change_of_an_unknown_site_is_refused():
    with pytest.raises(ParameterError, match=r"face Face1 \(49 sites\), got 'Face1.9.9'"):
        edit_sites(prism_sites(PrismParameters())["Face1"], [SiteEdit("Face1.9.9", "off")], {})


def test_overlaps_are_counted_once_each():
    points = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 0.5, 0]], float)
    assert overlapping_pairs(points, np.full(4, 0.9)).tolist() == [[2, 3]]
    assert len(overlapping_pairs(points, np.full(4, 1.1))) == 3  # 1.118 mm apart is not under 1.1
    assert len(overlapping_pairs(points[:0], np.zeros(0))) == 0
