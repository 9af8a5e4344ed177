# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes against boxes, tetrahedra and prisms with closed forms, and against deliberate damage."""

import math

import numpy as np
import pytest

from freecad_trabecula.core import meshes as m
from freecad_trabecula.errors import MeshError


def box(low, high):
    """Corners at bits 0, 1, 2; two triangles a face, counter-clockwise from outside."""
    corners = np.where(np.arange(8)[:, None] >> np.arange(3) & 1, np.asarray(high, float), np.asarray(low, float))
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return m.Mesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


def prism(sides, radius, height):
    """Upright prism over a regular polygon, with a vertex in the middle of each cap."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([radius * np.cos(angle), radius * np.sin(angle)], 1)
    points = [np.column_stack([ring, np.full(sides, z)]) for z in (0.0, height)] + [[[0, 0, 0.0]], [[0, 0, height]]]
    i = np.arange(sides)
    j = (i + 1) % sides
    bottom, top = np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    triangles = [(i, j, j + sides), (i, j + sides, i + sides), (bottom, j, i), (top, i + sides, j + sides)]
    return m.Mesh(np.concatenate(points), np.concatenate([np.stack(t, 1) for t in triangles]))


def turned(mesh):
    return m.Mesh(mesh.vertices, mesh.triangles[:, ::-1])


@pytest.mark.parametrize("sides", [3, 4, 12, 97])
def test_a_prism_over_a_regular_polygon_has_its_volume_and_area(sides):
    mesh = prism(sides, 2.0, 5.0)
    polygon = sides / 2 * 4.0 * math.sin(2 * math.pi / sides)
    side = 2 * 2.0 * math.sin(math.pi / sides)
    assert m.mesh_volume(mesh) == pytest.approx(5 * polygon, rel=1e-12)
    assert m.mesh_area(mesh) == pytest.approx(2 * polygon + sides * side * 5, rel=1e-12)


def test_a_volume_far_from_the_origin_keeps_its_digits():
    shift = 1e6
    mesh = box([shift] * 3, [shift + 0.5] * 3)
    assert m.mesh_volume(mesh) == pytest.approx(0.125, rel=1e-12)


def test_a_mesh_inside_out_has_a_negative_volume_and_is_still_closed():
    mesh = turned(box([0, 0, 0], [1, 2, 3]))
    assert m.mesh_volume(mesh) == pytest.approx(-6)
    assert m.is_closed(mesh)


def test_a_mesh_of_more_triangles_than_one_block_has_its_volume_and_area():
    count = m._BLOCK // 12 + 5
    boxes = m.join([box([0, 0, 0], [1, 1, 1])] * count)
    assert m.mesh_volume(boxes) == pytest.approx(count)
    assert m.mesh_area(boxes) == pytest.approx(6 * count)


def test_a_mesh_without_triangles_has_no_volume_no_area_and_is_not_closed():
    empty = m.join([])
    assert m.mesh_volume(empty) == 0 and m.mesh_area(empty) == 0
    assert not m.is_closed(empty)
    assert m.edge_faults(empty) == (0, 0, 0, 0)
    assert m.split(empty) == []
    assert len(m.weld(np.zeros((0, 3, 3))).vertices) == 0


def test_a_missing_triangle_leaves_three_open_edges():
    mesh = box([0, 0, 0], [1, 1, 1])
    damaged = m.Mesh(mesh.vertices, mesh.triangles[1:])
    assert not m.is_closed(damaged)
    assert m.edge_faults(damaged) == (3, 0, 3, 0)


def test_a_turned_triangle_leaves_three_edges_unbalanced_but_none_open():
    mesh = box([0, 0, 0], [1, 1, 1])
    triangles = mesh.triangles.copy()
    triangles[4] = triangles[4][::-1]
    damaged = m.Mesh(mesh.vertices, triangles)
    assert not m.is_closed(damaged)
    assert m.edge_faults(damaged) == (0, 0, 3, 0)


def test_two_boxes_that_share_an_edge_are_not_closed_though_every_edge_balances():
    shared = m.weld(m.join([box([0, 0, 0], [1, 1, 1]), box([1, 1, 0], [2, 2, 1])]).corners)
    assert not m.is_closed(shared)
    assert m.edge_faults(shared) == (0, 1, 0, 0)


def test_a_triangle_that_names_a_vertex_twice_is_counted_and_spoils_the_mesh():
    mesh = box([0, 0, 0], [1, 1, 1])
    damaged = m.Mesh(mesh.vertices, np.vstack([mesh.triangles, [[0, 1, 1]]]))
    assert not m.is_closed(damaged)
    assert m.edge_faults(damaged).degenerate == 1


def test_an_open_mesh_is_refused_by_its_name_with_the_counts():
    mesh = box([0, 0, 0], [1, 1, 1])
    with pytest.raises(MeshError, match=r"the envelope must be a closed mesh.*3 open edges"):
        m.require_closed(m.Mesh(mesh.vertices, mesh.triangles[1:]), "the envelope")
    m.require_closed(mesh, "the envelope")


@pytest.mark.parametrize("vertices, triangles", [(np.zeros((4, 2)), np.zeros((1, 3))), (np.zeros((4, 3)), np.zeros(6))])
def test_arrays_of_a_wrong_shape_are_refused(vertices, triangles):
    with pytest.raises(MeshError, match=r"must have the shape \(count, 3\)"):
        m.Mesh(vertices, triangles)


def test_a_mesh_without_vertices_has_no_bounds():
    with pytest.raises(MeshError, match="at least one vertex"):
        m.bounds(m.join([]))


def test_bounds_are_those_of_the_box():
    low, high = m.bounds(box([-1, 2, 3], [4, 5, 6]))
    assert low.tolist() == [-1, 2, 3] and high.tolist() == [4, 5, 6]


def test_welding_finds_the_eight_corners_of_a_box_and_keeps_the_order_of_triangles():
    mesh = box([0, 0, 0], [1, 2, 3])
    welded = m.weld(mesh.corners)
    assert len(welded.vertices) == 8
    assert (welded.corners == mesh.corners).all()
    assert m.is_closed(welded)


def test_welding_takes_minus_zero_for_zero():
    corners = box([0, 0, 0], [1, 1, 1]).corners.copy()
    corners[3][corners[3] == 0] = -0.0
    assert len(m.weld(corners).vertices) == 8


def test_welding_does_not_merge_points_that_differ_in_the_last_bit():
    corners = box([0, 0, 0], [1, 1, 1]).corners.copy()
    corners[0, 0, 0] = np.nextafter(0.0, 1.0)
    assert len(m.weld(corners).vertices) == 9


def test_welding_is_right_even_if_all_points_share_one_hash(monkeypatch):
    monkeypatch.setattr(m, "_hash", lambda points: np.zeros(len(points), np.uint64))
    mesh = prism(7, 1.0, 2.0)
    welded = m.weld(mesh.corners)
    assert len(welded.vertices) == len(mesh.vertices)
    assert (welded.corners == mesh.corners).all()


def test_components_of_a_shuffled_chain_of_boxes_are_the_boxes():
    rng = np.random.default_rng(0)
    boxes = m.join([box([3 * k, 0, 0], [3 * k + 1 + k, 1, 1]) for k in range(40)])
    order = rng.permutation(len(boxes.vertices))
    number = np.argsort(order)
    shuffled = m.Mesh(boxes.vertices[order], number[boxes.triangles][rng.permutation(len(boxes.triangles))])
    labels = m.components(shuffled)
    assert np.bincount(labels).tolist() == [12] * 40
    assert sorted(m.component_volumes(shuffled, labels)) == pytest.approx([1 + k for k in range(40)])


def test_one_long_strip_is_one_component_whatever_its_numbering():
    count = 20_000
    triangles = np.arange(count)[:, None] + np.arange(3)
    number = np.random.default_rng(1).permutation(count + 2)
    labels = m.components(m.Mesh(np.zeros((count + 2, 3)), number[triangles]))
    assert (labels == 0).all()


def test_components_that_meet_in_one_vertex_belong_together():
    corner = m.weld(m.join([box([0, 0, 0], [1, 1, 1]), box([1, 1, 1], [2, 2, 2])]).corners)
    assert (m.components(corner) == 0).all()


def test_a_cavity_is_a_component_with_a_negative_volume():
    hollow = m.join([box([0, 0, 0], [4, 4, 4]), turned(box([1, 1, 1], [2, 2, 2]))])
    assert m.component_volumes(hollow, m.components(hollow)) == pytest.approx([64, -1])
    assert m.mesh_volume(hollow) == pytest.approx(63)


def test_splitting_and_joining_give_the_mesh_back():
    whole = m.join([box([0, 0, 0], [1, 1, 1]), prism(5, 1.0, 1.0), box([5, 5, 5], [6, 7, 8])])
    parts = m.split(whole)
    assert [len(p.vertices) for p in parts] == [8, 12, 8]
    assert all(m.is_closed(p) for p in parts)
    assert (m.join(parts).corners == whole.corners).all()


def test_splitting_leaves_out_vertices_that_no_triangle_uses():
    mesh = box([0, 0, 0], [1, 1, 1])
    (part,) = m.split(m.Mesh(np.vstack([[[9, 9, 9]], mesh.vertices]), mesh.triangles + 1))
    assert len(part.vertices) == 8


def test_a_printable_mesh_is_in_single_precision_and_closed_after_welding():
    mesh = prism(30, 1.0 / 3, 10.0 / 3)
    printable = m.printable(mesh)
    assert (printable.vertices == printable.vertices.astype(np.float32)).all()
    assert np.abs(printable.vertices - mesh.vertices).max() < 1e-6
    assert m.is_closed(m.weld(printable.corners.astype(np.float32)))


@pytest.mark.parametrize("centre", [(0.0, 0.0, 0.0), (1000.0, -1000.0, 1e-3), (0.0, 0.0, 777.0)])
def test_vertices_that_fall_together_in_single_precision_are_nudged_apart(centre):
    # a ball of 3 nm with 1,000 vertices: many fall on one point of float32 away from the origin
    rng = np.random.default_rng(2)
    tiny = prism(500, 3e-6, 3e-6)
    mesh = m.Mesh(tiny.vertices + rng.normal(0, 1e-9, tiny.vertices.shape) + centre, tiny.triangles)
    printable = m.printable(mesh)
    points = printable.vertices.astype(np.float32)
    assert len(np.unique(points, axis=0)) == len(points)
    welded = m.weld(printable.corners.astype(np.float32))
    assert m.is_closed(welded) and len(welded.vertices) == len(mesh.vertices)
    units = np.abs(printable.vertices - mesh.vertices).max() / np.spacing(np.float32(np.abs(mesh.vertices).max()))
    assert units < len(points)


def test_a_mesh_whose_vertices_are_all_equal_is_spread_as_well():
    mesh = box([0, 0, 0], [1, 1, 1])
    printable = m.printable(m.Mesh(np.full((8, 3), 5.0), mesh.triangles))
    assert m.is_closed(m.weld(printable.corners))


def test_coordinates_too_large_for_single_precision_are_refused():
    mesh = box([0, 0, 0], [1, 1, 1e39])
    with np.errstate(over="ignore"), pytest.raises(MeshError, match="finite and below 3.4e38 mm"):
        m.printable(mesh)


def test_roots_are_the_lowest_of_what_hangs_together():
    a, b = np.array([5, 3, 9, 7, 1]), np.array([3, 5, 2, 9, 8])
    assert m.roots(10, a, b).tolist() == [0, 1, 2, 3, 4, 3, 6, 2, 1, 2]
