# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles between borders in the plane."""

import numpy as np
import pytest

from freecad_trabecula.core.plane_triangles import distances, inside, triangulate
from freecad_trabecula.errors import MeshError


def ring(count, radius=1.0, first=0):
    angle = 2 * np.pi * np.arange(count) / count
    numbers = first + np.arange(count)
    return radius * np.stack([np.cos(angle), np.sin(angle)], 1), np.stack([numbers, np.roll(numbers, -1)], 1)


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


def polygon_area(count, radius):
    return count * radius**2 * np.sin(2 * np.pi / count) / 2


def test_points_on_one_circle_give_a_polygon_whole():
    points, segments = ring(60)
    triangles = triangulate(points, segments)
    assert len(triangles) == 58
    assert area(points, triangles).min() > 0
    assert area(points, triangles).sum() == pytest.approx(polygon_area(60, 1))


def test_a_hole_is_left_out():
    outer, some = ring(40, 3.0)
    inner, more = ring(12, 1.0, 40)
    points = np.concatenate([outer, inner])
    triangles = triangulate(points, np.concatenate([some, more]))
    assert area(points, triangles).sum() == pytest.approx(polygon_area(40, 3) - polygon_area(12, 1))


def test_the_same_triangles_come_back_whatever_rounding_does():
    x, y = (c.ravel() for c in np.meshgrid(np.arange(9.0), np.arange(9.0)))
    points = np.stack([x, y], 1)
    numbers = np.arange(81).reshape(9, 9)
    border = np.concatenate([numbers[0], numbers[1:, -1], numbers[-1, -2::-1], numbers[-2:0:-1, 0]])
    segments = np.stack([border, np.roll(border, -1)], 1)
    triangles = triangulate(points, segments)
    noise = 1e-12 * np.sin(1e6 * points + 1)
    np.testing.assert_array_equal(triangulate(points + noise, segments), triangles)
    assert len(triangles) == 128


def test_segments_that_delaunay_lacks_are_recovered():
    # a narrow wedge between two rows of points: the long border would be crossed by shorter edges
    points = np.array([[0, 0], [10, 0], [10, 4], [5, 0.2], [0, 4], [5, 0.1]], float)
    segments = np.array([[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]])
    triangles = triangulate(points, segments)
    edges = {frozenset(e) for t in triangles.tolist() for e in (t[:2], t[1:], (t[2], t[0]))}
    assert {frozenset(s) for s in segments.tolist()} <= edges
    x, y = points[[0, 1, 2, 3, 4]].T
    assert area(points, triangles).sum() == pytest.approx(abs(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2)


def test_insides_and_distances_of_a_square():
    points = np.array([[0, 0], [2, 0], [2, 2], [0, 2]], float)
    segments = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    places = np.array([[1, 0.5], [3, 1], [1, -1], [-3, -4]])
    np.testing.assert_array_equal(inside(places, points, segments), [True, False, False, False])
    np.testing.assert_allclose(distances(places, points, segments), [0.5, 1, 1, 5])


def test_a_border_that_crosses_itself_is_refused():
    points = np.array([[0, 0], [2, 2], [2, 0], [0, 2]], float)
    with pytest.raises(MeshError, match="must not cross itself|crosses itself"):
        triangulate(points, np.array([[0, 1], [1, 2], [2, 3], [3, 0]]))


def test_a_point_outside_is_refused():
    points, segments = ring(8)
    with pytest.raises(MeshError, match="must be used"):
        triangulate(np.concatenate([points, [[5.0, 0]]]), segments)
