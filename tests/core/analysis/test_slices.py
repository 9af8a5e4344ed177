# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slices against closed forms, against what cannot change, and against a table that another program agreed to."""

import json
import math
import os
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.analysis import slices as s
from freecad_trabecula.core.analysis.contours import contour_measures
from freecad_trabecula.core.analysis.neighbours import neighbours
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import read_soup
from freecad_trabecula.core.meshes import Mesh, join, mesh_volume
from freecad_trabecula.errors import Cancelled, ParameterError

ROOT = Path(__file__).resolve().parents[3]
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))
REFERENCE = json.loads((ROOT / "tests" / "data" / "slice_reference.json").read_text(encoding="utf-8"))


def box(low, high):
    corners = np.where(np.arange(8)[:, None] >> np.arange(3) & 1, np.asarray(high, float), np.asarray(low, float))
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return Mesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


def inside_out(mesh):
    return Mesh(mesh.vertices, mesh.triangles[:, ::-1])


def torus(n, m, major=4.0, minor=1.5):
    a, b = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    reach = major + minor * np.cos(b)
    points = np.stack([reach * np.cos(a), reach * np.sin(a), minor * np.sin(b)], -1).reshape(-1, 3)
    i, j = (k.ravel() for k in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    corner = [(i + di) % n * m + (j + dj) % m for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
    triangles = [np.stack([corner[k] for k in t], 1) for t in ((0, 1, 2), (0, 2, 3))]
    return Mesh(points, np.concatenate(triangles))


def tube(sides, hole, height=10.0):
    """A cube of 10 mm with a hole of a regular polygon along z; walls only, no caps."""
    angle = 2 * np.pi * np.arange(sides) / sides
    rings = [np.array([[5, 5], [-5, 5], [-5, -5], [5, -5]]), hole * np.stack([np.cos(-angle), np.sin(-angle)], 1)]
    points, triangles, first = [], [], 0
    for ring in rings:
        k = np.arange(len(ring))
        points += [np.column_stack([ring, np.full(len(ring), z)]) for z in (0.0, height)]
        a, b, c, d = k, (k + 1) % len(ring), (k + 1) % len(ring) + len(ring), k + len(ring)
        triangles += [first + np.stack(t, 1) for t in ((a, b, c), (a, c, d))]
        first += 2 * len(ring)
    return Mesh(np.concatenate(points), np.concatenate(triangles))


def corners(mesh):
    return mesh.corners.astype(np.float32)


def measured(triangles, axis, heights, **more):
    contours = s.slice_contours(triangles, axis, heights, **more)
    return contours, contour_measures(contours, SliceParameters())


def shuffled(count, salt):
    """An order of ``count`` things that looks like none."""
    return np.argsort((np.arange(count, dtype=np.uint64) + np.uint64(salt)) * np.uint64(0x9E3779B97F4A7C15))


# ------------------------------------------------------------------------------------------------------ closed forms


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_boxes_in_one_another_have_their_areas_counts_and_parents(axis):
    body = join([box([-5] * 3, [5] * 3), inside_out(box([-3] * 3, [3] * 3)), box([-1] * 3, [1] * 3)])
    contours, measures = measured(corners(body), axis, [-4.5, -2.0, 0.0])
    assert s.sliced_areas(corners(body), axis, [-4.5, -2.0, 0.0]).tolist() == [100.0, 64.0, 68.0]
    by_size = np.lexsort((-np.abs(measures.area), measures.plane))
    assert measures.area[by_size].tolist() == [100.0, 100.0, -36.0, 100.0, -36.0, 4.0]
    assert measures.net_area[by_size].tolist() == pytest.approx([100, 64, math.nan, 64, math.nan, 4], nan_ok=True)
    parents = measures.parent[by_size]
    assert parents[[0, 1, 3]].tolist() == [-1] * 3
    assert parents[[2, 4, 5]].tolist() == by_size[[1, 3, 4]].tolist()
    assert contours.closed.all()


@pytest.mark.parametrize("sides", [3, 64, 1000])
def test_a_cube_with_a_polygonal_hole_has_its_closed_form(sides):
    hole = sides / 2 * math.sin(2 * math.pi / sides) * 4
    _, measures = measured(tube(sides, 2.0).corners, "z", [1.0, 5.0])
    assert sorted(measures.area) == pytest.approx([-hole, -hole, 100, 100], rel=1e-7)  # single precision


@pytest.mark.parametrize("height", [0.3, -0.9, 1.37])
def test_a_torus_across_has_two_rings_of_its_tessellation_s_own_polygons(height):
    n, m = 90, 60
    mesh = torus(n, m)
    areas = s.sliced_areas(corners(mesh), "z", [height])
    # on the plane the torus' facets are an outer and an inner ring about z; each of their n quads, cut by its diagonal,
    # gives two segments: the polygon's corners are where the m-gon's two edges at this height meet the plane, and where
    # the diagonals do. Shoelace over both, from the edges' own end points.
    expected = 0.0
    ring = 2 * np.pi * np.arange(m + 1) / m
    u, w = 4 + 1.5 * np.cos(ring), 1.5 * np.sin(ring)
    for k in np.flatnonzero((w[:-1] < height) != (w[1:] < height)):
        t = (height - w[k]) / (w[k + 1] - w[k])
        # along a row: the meridian's point, then the diagonal's from (angle, k) to (angle + 1, k + 1)
        step = 2 * np.pi / n
        straight = np.array([u[k] + t * (u[k + 1] - u[k]), 0.0])
        start, end = np.array([u[k], 0.0]), u[k + 1] * np.array([math.cos(step), math.sin(step)])
        diagonal = start + t * (end - start)
        onward = straight[0] * np.array([math.cos(step), math.sin(step)])
        cross = sum(p[0] * q[1] - p[1] * q[0] for p, q in ((straight, diagonal), (diagonal, onward)))
        expected += n * cross / 2 * (1 if u[k] + u[k + 1] > 8 else -1)
    assert areas[0] == pytest.approx(expected, rel=1e-6)
    contours, measures = measured(corners(mesh), "z", [height])
    assert len(contours) == 2 and (measures.area > 0).sum() == 1


@pytest.mark.parametrize(("n", "most"), [(32, 2.5e-2), (128, 3e-3), (512, 2e-4)])
def test_a_torus_comes_near_the_smooth_one_as_its_facets_get_smaller(n, most):
    heights = np.array([-1.1, -0.3, 0.4, 1.2])
    exact = 4 * math.pi * 4 * np.sqrt(1.5**2 - heights**2)
    assert np.abs(s.sliced_areas(corners(torus(2 * n, n)), "z", heights) / exact - 1).max() < most


# -------------------------------------------------------------------------------------------------------- invariants


@pytest.fixture(scope="module")
def bumpy():
    """A closed body without symmetry, from a torus."""
    mesh = torus(70, 40)
    x, y, z = mesh.vertices.T
    return Mesh(np.stack([x * (1 + 0.1 * np.sin(y)), y * (1 + 0.05 * np.cos(2 * z + x)), z + 0.2 * np.sin(x + y)], 1),
                mesh.triangles)  # fmt: skip


@pytest.mark.parametrize("axis", ["x", "y", "z", "0.6,0.8,0", "1,-2,3"])
def test_sliced_areas_add_up_to_the_volume_and_to_the_areas_of_the_contours(bumpy, axis):
    low, high = s.placed(corners(bumpy), axis).height.min(), s.placed(corners(bumpy), axis).height.max()
    step = (float(high) - float(low)) / 2000
    heights = float(low) + step * (np.arange(2000) + 0.5)
    areas = s.sliced_areas(corners(bumpy), axis, heights)
    assert areas.sum() * step == pytest.approx(mesh_volume(bumpy), rel=2e-5)
    contours, measures = measured(corners(bumpy), axis, heights)
    assert contours.closed.all()
    assert np.bincount(measures.plane, measures.area, 2000) == pytest.approx(areas, rel=1e-11, abs=1e-11)


def test_the_order_of_triangles_and_of_their_corners_changes_nothing(bumpy):
    triangles, heights = corners(bumpy), np.linspace(-1.6, 1.6, 23)
    other = triangles[shuffled(len(triangles), 3)]
    turns = shuffled(len(triangles), 8) % 3
    other = other[np.arange(len(other))[:, None], (np.arange(3) + turns[:, None]) % 3]
    assert s.sliced_areas(other, "z", heights) == pytest.approx(s.sliced_areas(triangles, "z", heights), rel=1e-13)
    (one, a), (two, b) = measured(triangles, "z", heights), measured(other, "z", heights)
    assert len(one) == len(two) and two.closed.all()
    for plane in range(23):
        assert sorted(b.area[b.plane == plane]) == pytest.approx(sorted(a.area[a.plane == plane]), rel=1e-12)


def test_a_body_turned_and_moved_has_the_same_slices_along_the_turned_axis(bumpy):
    heights = np.linspace(-4.5, 4.5, 31)
    along_x = s.sliced_areas(corners(bumpy), "x", heights)
    turned = Mesh(bumpy.vertices[:, [1, 2, 0]], bumpy.triangles)  # x is z now
    assert s.sliced_areas(corners(turned), "z", heights) == pytest.approx(along_x, rel=1e-12)
    moved = Mesh(bumpy.vertices.astype(np.float32) + np.array([64.0, -32.0, 0.0]), bumpy.triangles)
    assert s.sliced_areas(moved.corners, "x", heights + 64) == pytest.approx(along_x, rel=1e-9)


def test_an_oblique_axis_is_the_z_of_the_turned_body(bumpy):
    frame = np.array([[0.8, -0.6, 0.0], [0.0, 0.0, 1.0], [-0.6, -0.8, 0.0]])  # rows; the last one is the axis
    heights = np.linspace(-3.5, 3.5, 15)
    turned = Mesh(bumpy.vertices @ frame.T, bumpy.triangles)
    oblique = s.sliced_areas(bumpy.corners, "-0.6,-0.8,0", heights)
    assert oblique == pytest.approx(s.sliced_areas(turned.corners, "z", heights), rel=1e-10)


def test_a_nanometre_changes_no_count_and_no_area_by_more_than_it_sweeps(bumpy):
    heights = np.linspace(-1.5, 1.5, 40) + 1e-4
    (one, a), (two, b) = (measured(bumpy.corners, "z", h) for h in (heights, heights + 1e-6))
    assert (one.plane == two.plane).all()
    assert np.abs(a.area - b.area).max() < 1e-6 * 2 * math.pi * 6 * 10


def test_blocks_of_planes_are_seams_that_do_not_show(bumpy, monkeypatch):
    heights = np.linspace(-1.6, 1.6, 57)
    whole, _ = measured(corners(bumpy), "z", heights)
    monkeypatch.setattr(s, "_NODES", 100)
    monkeypatch.setattr(s, "_CHUNK", 64)
    parts, measures = measured(corners(bumpy), "z", heights)
    assert parts.closed.all() and len(parts) == len(whole)
    area = np.bincount(measures.plane, measures.area, 57)
    assert area == pytest.approx(s.sliced_areas(corners(bumpy), "z", heights), rel=1e-12)


# -------------------------------------------------------------------------------------------- corners on the planes


@pytest.mark.parametrize("side", s.SIDES)
def test_planes_through_corners_leave_nothing_open(bumpy, side):
    triangles = np.round(bumpy.corners * 8).astype(np.float32) / 8  # most corners on some plane; facets fall flat
    heights = np.arange(-14, 15) / 8
    contours, measures = measured(triangles, "z", heights, side=side)
    assert contours.closed.all() and len(contours) > 29
    area = np.bincount(measures.plane, measures.area, len(heights))
    assert area == pytest.approx(s.sliced_areas(triangles, "z", heights, side), abs=1e-12)


def test_a_plane_in_a_cap_has_the_slice_below_it_or_above_it():
    body = corners(join([box([0, 0, 0], [2, 2, 1]), box([0, 0, 2], [3, 3, 4])]))
    assert s.sliced_areas(body, "z", [0, 1, 2, 4]).tolist() == [0, 4, 0, 9]
    assert s.sliced_areas(body, "z", [0, 1, 2, 4], side="above").tolist() == [4, 0, 9, 0]


def test_heights_between_two_single_precision_numbers_fall_on_their_own_side():
    body = box([0, 0, 0], [1, 1, np.float32(0.1)]).corners.astype(np.float32)  # its top is at 0.100000001490116
    top = float(np.float32(0.1))
    assert s.sliced_areas(body, "z", [0.1, top, np.nextafter(top, 1)]).tolist() == [1, 1, 0]
    assert s.sliced_areas(body, "z", [0.1, top, np.nextafter(top, 1)], side="above").tolist() == [1, 0, 0]


@pytest.mark.parametrize("heights", [[0.25], [0.25, 0.25 + 1e-12, 0.5], np.append(np.linspace(0.1, 0.1001, 50), 0.9)])
def test_planes_crowded_in_one_place_are_told_apart(heights):
    assert s.sliced_areas(corners(box([0, 0, 0], [1, 1, 1])), "z", heights) == pytest.approx(np.ones(len(heights)))


# ------------------------------------------------------------------------------------------------------ small bodies


def test_planes_beside_the_body_or_no_planes_give_empty_slices():
    body = corners(box([0, 0, 0], [1, 1, 1]))
    assert s.sliced_areas(body, "z", [-5.0, 7.0]).tolist() == [0, 0]
    assert len(s.slice_contours(body, "z", [-5.0, 7.0])) == 0
    assert len(measured(body, "z", [])[1]) == 0 and s.sliced_areas(body, "z", []).shape == (0,)


def test_one_facet_is_an_open_chain_of_two_points():
    triangle = np.array([[[0, 0, 0], [2, 0, 0], [0, 0, 2]]], np.float32)
    contours, measures = measured(triangle, "z", [0.5])
    assert contours.closed.tolist() == [False]
    assert sorted(contours.points[:, 0].tolist()) == [0.0, 1.5]
    assert measures.area.tolist() == [0.0] and np.isnan(measures.perimeter).all()


def test_facets_without_area_change_nothing():
    body = corners(box([0, 0, 0], [1, 1, 1]))
    point, line = np.full((1, 3, 3), 0.3, np.float32), np.array([[[0, 0, 0], [1, 1, 1], [0, 0, 0]]], np.float32)
    contours, measures = measured(np.concatenate([point, body, line]), "z", [0.5])
    assert measures.area[contours.closed].max() == 1.0
    assert s.sliced_areas(np.concatenate([point, body, line]), "z", [0.5]).tolist() == [1.0]


# ------------------------------------------------------------------------------------------------------ the reference


@pytest.mark.parametrize("name", sorted(REFERENCE))
def test_every_plane_of_the_reference_has_its_area_contours_and_holes(name):
    known = REFERENCE[name]
    if not (DATA / known["file"]).exists():
        pytest.skip(f"{known['file']} is not in {DATA}")
    triangles = read_soup(DATA / known["file"]).triangles
    partners = neighbours(triangles)
    assert (partners >= 0).all()
    for axis, planes in known["axes"].items():
        contours, measures = measured(triangles, axis, planes["plane"], partners=partners)
        count = len(planes["plane"])
        assert contours.closed.all()
        area = np.bincount(measures.plane, measures.area, count)
        assert np.abs(area / planes["area_mm2"] - 1).max() < 1e-12
        assert np.abs(s.sliced_areas(triangles, axis, planes["plane"]) / planes["area_mm2"] - 1).max() < 1e-12
        for which, key in ((measures.area > 1e-6, "outer_contours"), (measures.area < -1e-6, "holes")):
            assert np.bincount(measures.plane[which], minlength=count).tolist() == planes[key]


# --------------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize("heights", [[0.5, 0.5], [0.5, 0.2], [0.1, math.nan], [math.inf]])
def test_heights_that_do_not_rise_are_refused(heights):
    for function in (s.sliced_areas, s.slice_contours):
        with pytest.raises(ParameterError, match="finite and rise"):
            function(corners(box([0, 0, 0], [1, 1, 1])), "z", heights)


def test_an_axis_or_a_side_that_is_none_is_refused():
    with pytest.raises(ParameterError, match="an axis must be"):
        s.sliced_areas(corners(box([0, 0, 0], [1, 1, 1])), "w", [0.5])
    with pytest.raises(ParameterError, match="below, above"):
        s.sliced_areas(corners(box([0, 0, 0], [1, 1, 1])), "z", [0.5], side="beside")


def test_slicing_can_be_cancelled_and_its_progress_rises(bumpy):
    seen = []
    s.slice_contours(corners(bumpy), "z", np.linspace(-1, 1, 9), lambda done, total, what: seen.append(done / total))
    assert seen == sorted(seen) and seen[-1] == 1.0

    def stop(done, total, what):
        raise Cancelled

    with pytest.raises(Cancelled):
        s.slice_contours(corners(bumpy), "z", np.linspace(-1, 1, 9), stop)
