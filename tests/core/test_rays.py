# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays against boxes, polygon prisms, spheres and random polyhedra: exactly closed sums, volumes, insides."""

import math

import numpy as np
import pytest

from freecad_trabecula.core import rays as r
from freecad_trabecula.errors import MeshError, ParameterError


def box(low, high):
    corners = np.where(np.arange(8)[:, None] >> np.arange(3) & 1, np.asarray(high, float), np.asarray(low, float))
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return corners[np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])]


def ball(radius, centre=(0.0, 0.0, 0.0), rings=12, sides=24):
    """A polyhedron inscribed in a sphere, and its exact volume as the sum of frusta over regular polygons."""
    theta = np.pi * np.arange(1, rings) / rings
    phi = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack(
        [np.outer(np.sin(theta), np.cos(phi)), np.outer(np.sin(theta), np.sin(phi)), np.cos(theta)[:, None] + 0 * phi],
        2,
    )
    points = np.concatenate([ring.reshape(-1, 3), [[0, 0, 1.0], [0, 0, -1.0]]]) * radius + centre
    n = (rings - 1) * sides
    i = np.arange(n).reshape(rings - 1, sides)
    j = np.roll(i, -1, 1)
    a, b, c, d = i[1:].ravel(), j[1:].ravel(), j[:-1].ravel(), i[:-1].ravel()
    top, bottom = np.full(sides, n), np.full(sides, n + 1)
    triangles = [(a, b, c), (a, c, d), (top, i[0], j[0]), (bottom, j[-1], i[-1])]
    areas = sides / 2 * math.sin(2 * math.pi / sides) * np.concatenate([[0], np.sin(theta) ** 2, [0]])
    heights = -np.diff(np.concatenate([[1], np.cos(theta), [-1]]))
    # equal polygons one over the other: a frustum
    volume = (heights / 3 * (areas[1:] + areas[:-1] + np.sqrt(areas[1:] * areas[:-1]))).sum() * radius**3
    return points[np.concatenate([np.stack(t, 1) for t in triangles])], volume


def whole_grid(axis, count=8, origin=0.0, step=1.0):
    return r.RayGrid(axis, (origin, origin), (step, step), (0, 0), (count, count))


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_rays_through_the_corners_edges_and_faces_of_a_box_enter_as_often_as_they_leave(axis):
    found = r.crossings(box([2, 2, 2], [5, 5, 5]), whole_grid(axis))
    assert np.bincount(found.ray, found.sign, 64).tolist() == [0.0] * 64
    # moved a hair towards larger co-ordinates: rays 2, 3, 4 of each direction are inside, ray 5 is not
    expected = [8 * i + j for i in (2, 3, 4) for j in (2, 3, 4)]
    assert np.unique(found.ray).tolist() == expected
    assert found.at.tolist() == [2.0, 5.0] * 9
    assert found.sign.tolist() == [1, -1] * 9


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("seed", range(5))
def test_signs_add_to_zero_for_closed_meshes_with_vertices_on_the_rays(axis, seed):
    # a tetrahedron's net with whole co-ordinates: corners, edges and faces lie on rays everywhere
    rng = np.random.default_rng(seed)
    corners = rng.integers(0, 8, (200, 4, 3)).astype(float)
    triangles = np.concatenate([corners[:, t] for t in ([0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3])])
    found = r.crossings(triangles, whole_grid(axis))
    assert not np.bincount(found.ray, found.sign, 64).any()
    assert len(found.ray) > 100


@pytest.mark.parametrize("seed", range(5))
def test_signs_add_to_zero_where_rounding_decides(seed):
    # needles and nearly flat tetrahedra through points that are no whole multiples of the step
    rng = np.random.default_rng(seed)
    corners = np.repeat(rng.uniform(0, 1, (300, 1, 3)), 4, 1) + rng.normal(0, [1e-9, 1e-3, 1], (300, 4, 3))
    triangles = np.concatenate([corners[:, t] for t in ([0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3])])
    for axis in range(3):
        found = r.crossings(triangles, r.RayGrid(axis, (-1 / 3, -1 / 7), (1e-3, 0.1), (0, 0), (2000, 20)))
        assert not np.bincount(found.ray, found.sign).any()


def test_crossings_come_sorted_by_ray_and_along_it():
    found = r.crossings(ball(3.0, (4, 4, 4))[0], whole_grid(1))
    assert (np.diff(found.ray) >= 0).all()
    assert (np.diff(found.at)[np.diff(found.ray) == 0] >= 0).all()


def test_a_part_of_a_grid_gives_the_same_crossings_as_the_whole():
    triangles, _ = ball(3.3, (4, 4, 4))
    whole = r.crossings(triangles, whole_grid(2, 80, 0.03, 0.1))
    part = r.crossings(triangles, r.RayGrid(2, (0.03, 0.03), (0.1, 0.1), (10, 20), (30, 40)))
    i, j = whole.ray // 80, whole.ray % 80
    inner = (i >= 10) & (i < 40) & (j >= 20) & (j < 60)
    assert part.at.tolist() == whole.at[inner].tolist()
    assert part.ray.tolist() == ((i - 10) * 40 + j - 20)[inner].tolist()


def test_small_blocks_give_the_same_crossings(monkeypatch):
    triangles, _ = ball(3.3, (4, 4, 4))
    whole = r.crossings(triangles, whole_grid(0, 50, 0.01, 0.16))
    monkeypatch.setattr(r, "_BLOCK", 64)
    blocks = r.crossings(triangles, whole_grid(0, 50, 0.01, 0.16))
    assert all((a == b).all() for a, b in zip(whole, blocks))


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_overlapping_nested_and_touching_boxes_have_the_volume_of_their_union(axis):
    boxes = [box([1, 1, 1], [4, 4, 4]), box([2, 2, 2], [6, 3, 3]), box([2, 2, 2], [3, 3, 3]), box([4, 1, 1], [5, 2, 2])]
    found = r.union_volume(np.concatenate(boxes), [0, 0, 0], [8, 8, 8], 8, axis)
    # the second box sticks out by 4..6 x 2..3 x 2..3, the third is inside, the last touches the first
    assert found.volume == pytest.approx(27 + 2 + 1, abs=1e-12)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_union_is_clipped_to_the_box(axis):
    found = r.union_volume(box([-5, -5, -5], [5, 5, 5]), [0, 1, 2], [3, 3, 3], 10, axis)
    assert found.volume == pytest.approx(3 * 2 * 1)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_union_is_clipped_to_an_envelope_with_a_cavity(axis):
    envelope = np.concatenate([box([0, 0, 0], [8, 8, 8]), box([2, 2, 2], [4, 4, 4])[:, ::-1]])
    rods = np.concatenate([box([-1, 3, 3], [9, 5, 5]), box([3, -1, 3], [5, 9, 5])])
    found = r.union_volume(rods, [0, 0, 0], [8, 8, 8], 16, axis, envelope)
    # two rods of 8 x 2 x 2 that cross in 2 x 2 x 2, less the cavity: 2 x 1 x 1 of each, 1 x 1 x 1 of both
    assert found.volume == pytest.approx(2 * 32 - 8 - (2 + 2 - 1))


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("cells", [20, 60, 200])
def test_the_volume_of_a_ball_lies_within_four_standard_errors(axis, cells):
    triangles, volume = ball(3.0, (4.1, 4.2, 3.9))
    found = r.union_volume(triangles, [0, 0, 0], [8, 8, 8], cells, axis)
    assert abs(found.volume - volume) < 4 * found.error
    assert found.error < 6 * volume / cells**1.5


def test_errors_of_random_boxes_are_as_large_as_said():
    rng = np.random.default_rng(3)
    ratios = []
    for k in range(60):
        low, high = rng.uniform(0, 0.4, 3), rng.uniform(0.6, 1, 3)
        found = r.union_volume(box(low, high), [0] * 3, [1] * 3, 30, k % 3)
        ratios.append((found.volume - np.prod(high - low)) / found.error)
    assert 0.5 < np.std(ratios) < 2
    assert np.max(np.abs(ratios)) < 4.5


def test_no_triangles_have_no_volume():
    assert r.union_volume(np.zeros((0, 3, 3)), [0] * 3, [1] * 3, 5) == (0, 0)


def test_an_open_mesh_is_refused_with_the_number_of_rays():
    with pytest.raises(MeshError, match="each ray must leave as often as it enters; 4 rays do not"):
        r.union_volume(box([1, 1, 1], [3, 3, 3])[2:], [0, 0, 0], [4, 4, 4], 4, 0)


def test_a_coordinate_that_is_not_a_number_is_refused():
    triangles = box([1, 1, 1], [3, 3, 3])
    triangles[3, 1, 2] = np.nan
    with pytest.raises(MeshError, match="must be finite"):
        r.union_volume(triangles, [0, 0, 0], [4, 4, 4], 4)


@pytest.mark.parametrize(
    "low, high, cells, axis, rule",
    [
        ([0, 0, 0], [1, 1, 1], 0, 0, "rays per direction must be >= 1, got 0"),
        ([0, 0, 0], [1, 0, 1], 5, 0, "low < high"),
        ([0, 0, math.nan], [1, 1, 1], 5, 0, "low < high"),
        ([0, 0, 0], [1, 1, 1], 5, 3, "must be 0, 1 or 2, got 3"),
    ],
)
def test_an_impossible_grid_is_refused(low, high, cells, axis, rule):
    with pytest.raises(ParameterError, match=rule):
        r.union_volume(box([0] * 3, [1] * 3), low, high, cells, axis)


@pytest.mark.parametrize("axis", [None, 0, 1, 2])
def test_points_inside_and_outside_a_ball_are_told_apart(axis):
    rng = np.random.default_rng(4)
    triangles, _ = ball(3.0, (1, 2, 3))
    points = rng.uniform(-4, 8, (20_000, 3))
    distance = np.linalg.norm(points - [1, 2, 3], axis=1)
    inside = r.contains(triangles, points, axis)
    inner = 3 * math.cos(math.pi / 12) * math.cos(math.pi / 24)  # the ball that lies inside the polyhedron
    assert inside[distance < inner].all()
    assert not inside[distance > 3].any()


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_points_on_a_box_fall_inside_at_its_lower_faces_and_outside_at_its_upper_ones(axis):
    points = np.stack(np.meshgrid(*[np.arange(-1.0, 5.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    assert (r.contains(box([0, 0, 0], [3, 3, 3]), points, axis) == ((points >= 0) & (points < 3)).all(1)).all()


def test_a_point_in_two_meshes_is_inside_and_one_in_a_cavity_is_not():
    meshes = np.concatenate([box([0, 0, 0], [4, 4, 4]), box([1, 1, 1], [2, 2, 2])[:, ::-1], box([3, 3, 3], [6, 6, 6])])
    points = np.array([[3.5, 3.5, 3.5], [1.5, 1.5, 1.5], [5, 5, 5], [0.5, 3, 3], [5, 1, 1]])
    assert r.contains(meshes, points).tolist() == [True, False, True, True, False]


def test_no_points_give_no_answers_and_far_points_are_outside():
    triangles, _ = ball(1.0)
    assert r.contains(triangles, np.zeros((0, 3))).shape == (0,)
    assert not r.contains(triangles, np.array([[9.0, 9, 9], [0, 0, 2]])).any()


def test_small_blocks_of_points_give_the_same_answers(monkeypatch):
    triangles, _ = ball(3.0, rings=30, sides=40)
    points = np.random.default_rng(5).uniform(-3, 3, (3000, 3))
    whole = r.contains(triangles, points)
    monkeypatch.setattr(r, "_BLOCK", 100)
    assert (r.contains(triangles, points) == whole).all()
