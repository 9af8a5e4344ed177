# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole analyses: bodies of known slices along every axis, real bone, spoilt files."""

import os
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.analysis.analysis import analyse, contours_of
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import Soup, read_soup, soup_of
from freecad_trabecula.core.meshes import Mesh, join
from freecad_trabecula.errors import Cancelled, ParameterError

ROOT = Path(__file__).resolve().parents[3]
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))


def box(low, high):
    corners = np.where(np.arange(8)[:, None] >> np.arange(3) & 1, np.asarray(high, float), np.asarray(low, float))
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return Mesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


def hollow():
    """A box of 4 x 2 x 1 mm with a cavity of 1 x 1 x 0.5 mm, and a small cube apart."""
    cavity = box([1, 0.5, 0.25], [2, 1.5, 0.75])
    return soup_of(join([box([0, 0, 0], [4, 2, 1]), Mesh(cavity.vertices, cavity.triangles[:, ::-1]),
                         box([0, 0, 3], [1, 1, 4])]), "hollow")  # fmt: skip


def quick(soup, progress=lambda *_: None, envelope=None, **chosen):
    return analyse(soup, SliceParameters(**chosen), False, progress, envelope)


def test_an_analysis_holds_profiles_measures_and_facts_of_every_axis():
    a = quick(hollow(), thickness=0.25)
    assert a.name == "hollow" and a.unit == "mm" and a.box.tolist() == [[0, 0, 0], [4, 2, 4]]
    assert list(a.profiles) == list(a.measures) == list(a.repairs) == ["x", "y", "z"]
    assert a.facts.volume == pytest.approx(8 - 0.5 + 1) and a.facts.parts == 3 and a.facts.is_sound
    assert a.profiles["z"].sliced_area == pytest.approx([8, 7, 7, 8, *[0] * 8, 1, 1, 1, 1])
    assert a.profiles["z"].contours.tolist() == [1, 2, 2, 1, *[0] * 8, 1, 1, 1, 1]
    assert a.profiles["x"].envelope_area[0] == 8.0 and a.profiles["x"].porosity[0] == pytest.approx(1 - 3 / 8)
    for axis in "xyz":
        assert a.summary(axis).volume == pytest.approx(a.facts.volume)
        assert a.summary(axis).mean_bone_fraction == pytest.approx(8.5 / 32)
    assert a.morphometry is None and a.seconds > 0


def test_bottoms_belong_to_their_layers():
    a = quick(hollow(), thickness=0.25, at="bottom", axes=("z",))
    assert a.profiles["z"].sliced_area == pytest.approx([8, 7, 7, 8, *[0] * 8, 1, 1, 1, 1])
    assert a.profiles["z"].coordinate[0] == 0


def test_porosity_against_an_envelope_is_that_of_its_slices():
    around = soup_of(box([0, 0, 0], [4, 4, 4]), "block")
    profile = quick(hollow(), envelope=around, axes=("z",), thickness=0.25).profiles["z"]
    assert profile.envelope == "block" and profile.envelope_area == pytest.approx(np.full(16, 16.0))
    assert profile.porosity == pytest.approx([8 / 16, 9 / 16, 9 / 16, 8 / 16, *[1] * 8, *[15 / 16] * 4])


def test_a_turned_part_is_sliced_along_its_own_direction():
    turn = np.array([[0.8, 0.6, 0], [-0.6, 0.8, 0], [0, 0, 1]])
    body = hollow()
    turned = Soup(body.triangles.astype(float) @ turn.T)  # its own x is the direction (0.8, -0.6, 0) now
    straight, oblique = quick(body, axes=("x",)), quick(turned, axes=((0.8, -0.6, 0),))
    assert list(oblique.profiles) == ["0.8,-0.6,0"]
    assert oblique.profiles["0.8,-0.6,0"].sliced_area == pytest.approx(straight.profiles["x"].sliced_area, rel=1e-5)
    assert oblique.profiles["0.8,-0.6,0"].envelope_area == pytest.approx(straight.profiles["x"].envelope_area, rel=1e-5)


def test_a_body_thinner_than_a_layer_has_one_slice_and_one_facet_has_spoilt_ones():
    thin = quick(soup_of(box([0, 0, 0], [1, 1, 0.01])), axes=("z",))
    assert thin.profiles["z"].sliced_area.tolist() == [1.0]
    facet = quick(Soup(np.array([[[0, 0, 0], [1, 0, 0], [0, 0, 1]]])))
    assert facet.profiles["z"].spoilt.all() and not facet.profiles["z"].sliced_area.any()
    assert facet.facts.open_edges == 3 and facet.profiles["y"].porosity.shape == (1,)


def test_spoilt_slices_are_those_of_the_mesh_before_it_was_mended():
    whole = hollow()
    a = quick(Soup(whole.triangles[1:]), thickness=0.25)
    assert a.facts.open_edges == 3
    assert a.profiles["z"].spoilt.tolist() == [True] * 4 + [False] * 12  # the facet was in the wall at x = 0
    assert (a.repairs["z"].spoilt == a.profiles["z"].spoilt).all() and not a.profiles["x"].spoilt.any()


def test_contours_for_views_are_those_that_were_measured():
    soup, chosen = hollow(), SliceParameters(thickness=0.25, smoothing="normal")
    contours, repairs = contours_of(soup, chosen, "z")
    assert len(contours) == len(analyse(soup, chosen, False).measures["z"]) and not repairs.spoilt.any()


def test_real_bone_has_one_fraction_on_all_axes_and_its_volume():
    path = DATA / "shrew_cube_10mm.stl"
    if not path.exists():
        pytest.skip(f"{path.name} is not in {DATA}")
    a = quick(read_soup(path))
    for axis in "xyz":
        s = a.summary(axis)
        assert s.slices == 100 and s.spoilt_slices == 0
        assert s.volume == pytest.approx(a.facts.volume, rel=2e-3)
        assert s.mean_bone_fraction == pytest.approx(0.28928, rel=2e-3)


# --------------------------------------------------------------------------------------------------------- refusals


def test_too_many_planes_and_a_range_beside_the_body_are_refused():
    with pytest.raises(ParameterError, match="4000000 planes"):
        quick(hollow(), thickness=1e-6)
    with pytest.raises(ParameterError, match="must meet the body"):
        quick(hollow(), low=7.0)


def test_progress_rises_to_the_end_and_may_cancel():
    seen = []
    quick(hollow(), lambda done, total, what: seen.append(done / total))
    assert seen == sorted(seen) and 0.9 < seen[-1] <= 1.0

    def stop(done, total, what):
        raise Cancelled

    with pytest.raises(Cancelled):
        quick(hollow(), stop)
