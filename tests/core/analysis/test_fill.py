# SPDX-License-Identifier: LGPL-2.1-or-later
"""Union and offset of contours, against closed forms; without manifold3d a clear error."""

import math
import os
import sys
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import Contours, contour_measures
from freecad_trabecula.core.analysis.fill import offset_contours, united
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.repair import mend
from freecad_trabecula.core.analysis.slices import slice_contours
from freecad_trabecula.core.analysis.triangles import read_soup
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.stl import read_stl
from freecad_trabecula.errors import Cancelled, DependencyError

ROOT = Path(__file__).resolve().parents[3]
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))

needs_library = pytest.mark.skipif(not manifold_available(), reason="manifold3d is not installed")
SQUARE = np.array([[0.0, 0], [2, 0], [2, 2], [0, 2]])


def stack(*slices):
    polygons = [np.asarray(p, float) for contours in slices for p in contours]
    return Contours(
        "z", np.arange(len(slices)) + 0.5, np.concatenate(polygons), np.cumsum([0] + [len(p) for p in polygons]),
        np.repeat(np.arange(len(slices)), [len(c) for c in slices]), np.ones(len(polygons), bool),
    )  # fmt: skip


def areas(contours):
    return contour_measures(contours, SliceParameters()).area.tolist()


@needs_library
def test_what_overlaps_counts_once_and_other_planes_stay_as_they_are():
    overlapping, apart = [SQUARE, SQUARE + 1], [SQUARE, SQUARE[::-1] * 0.5 + 0.5]
    old = stack(overlapping, apart)
    new, counts = united(old)
    assert areas(new) == pytest.approx([7, 4, -1]) and counts.tolist() == [2, 0]
    assert all((a == b).all() for a, b in zip(old.of_plane(1), new.of_plane(1)))
    assert sum(areas(old)[:2]) == 8  # the signed sum counts the overlap twice


@needs_library
def test_bodies_that_overlap_a_hole_fill_it_and_loops_turned_wrong_are_void():
    ring = [SQUARE * 3, SQUARE[::-1] + 2, SQUARE + 1.5]
    new, counts = united(stack(ring, [SQUARE[::-1]]))
    measures = contour_measures(new, SliceParameters())
    assert measures.area.sum() == pytest.approx(36 - 4 + 1.5**2) and counts.tolist() == [3, 1]


@needs_library
def test_a_closed_body_without_overlaps_is_not_changed_by_union():
    old = stack([SQUARE, SQUARE[::-1] * 0.5 + 0.5, SQUARE + 5])
    new, counts = united(old)
    assert new is old and counts.tolist() == [0]


@needs_library
def test_an_offset_into_the_material_shrinks_it_and_widens_holes():
    new, counts = offset_contours(stack([SQUARE, SQUARE[::-1] * 0.25 + 0.75]), 0.1)
    outer, hole = sorted(areas(new), reverse=True)
    assert outer == pytest.approx(1.8**2) and counts.tolist() == [2]
    assert hole == pytest.approx(-(0.25 + 4 * 0.5 * 0.1 + math.pi * 0.01), rel=1e-3)  # round corners


@needs_library
def test_an_offset_out_of_the_material_joins_what_it_reaches_and_too_much_leaves_nothing():
    two = stack([SQUARE, SQUARE + [2.1, 0]], [SQUARE])
    assert len(offset_contours(two, -0.06)[0]) == 2
    new, counts = offset_contours(two, 1.1)
    assert len(new) == 0 and counts.tolist() == [2, 1]


@needs_library
def test_both_are_counted_among_the_repairs():
    chosen = SliceParameters(fill="union", compensation=0.1)
    new, repairs = mend(stack([SQUARE, SQUARE + 1]), chosen)
    assert areas(new) == pytest.approx([7 - 0.1 * 12 + 0.01 * (6 - math.pi / 2)], rel=1e-2)
    assert repairs.offset.tolist() == [2] and repairs.united.tolist() == [0]  # the offset united them already


@needs_library
def test_uniting_can_be_cancelled():
    def stop(done, total, what):
        raise Cancelled

    with pytest.raises(Cancelled):
        united(stack([SQUARE]), stop)


@pytest.mark.parametrize("chosen", [{"fill": "union"}, {"compensation": 0.1}])
def test_without_manifold3d_the_error_says_how_to_install_it(monkeypatch, chosen):
    monkeypatch.setitem(sys.modules, "manifold3d", None)
    with pytest.raises(DependencyError, match="pip install"):
        mend(stack([SQUARE]), SliceParameters(**chosen))
    assert len(mend(stack([SQUARE]), SliceParameters())[0]) == 1


@needs_library
def test_self_intersecting_bone_has_the_union_s_areas_that_manifold3d_finds_by_cutting_the_solid():
    path = DATA / "trab_ior_10mm_13MB.stl"
    if not path.exists():
        pytest.skip(f"{path.name} is not in {DATA}")
    import manifold3d as library

    mesh = read_stl(path)
    solid = library.Manifold(library.Mesh(mesh.vertices.astype(np.float32), mesh.triangles.astype(np.uint32)))
    heights = np.linspace(0.13, 10.27, 21)
    expected = np.array([solid.slice(height).area() for height in heights])
    winding = slice_contours(read_soup(path).triangles, "z", heights)
    away = [np.abs(np.bincount(c.plane, contour_measures(c, SliceParameters()).area, 21) / expected - 1)
            for c in (winding, united(winding)[0])]  # fmt: skip
    assert away[1].max() < 1e-8  # both work on a grid of 1e-8 mm
    assert away[0].max() > 1e-7  # what runs through itself counts twice without union
