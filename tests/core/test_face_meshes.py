# SPDX-License-Identifier: LGPL-2.1-or-later
"""Samples of curves and surfaces by their bends; grids joined to borders."""

import numpy as np
import pytest

from freecad_trabecula.core.face_meshes import (
    Bends,
    Side,
    even_steps,
    facing,
    four_sided,
    grid_densities,
    sagittas,
    spread,
    steps_per_unit,
    zipped,
)


def circle_density(radius, deflection, angle=10.0):
    return steps_per_unit(np.full(9, radius), np.full(9, radius), deflection, angle)


def edge_counts(triangles):
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return {tuple(edge) for edge in edges.tolist()}, len(edges)


@pytest.mark.parametrize("radius", [0.5, 5.0, 200.0])
@pytest.mark.parametrize("deflection", [0.001, 0.05])
def test_chords_of_a_circle_keep_the_deflection_and_no_more(radius, deflection):
    at = np.linspace(0, 2 * np.pi, 9)
    steps = np.diff(spread(at, circle_density(radius, deflection)))
    assert np.ptp(steps) < 1e-12
    sagitta = radius * (1 - np.cos(steps[0] / 2))
    one_less = radius * (1 - np.cos(np.pi / (len(steps) - 1)))
    assert sagitta <= deflection < 1.02 * one_less


def test_neighbouring_chords_keep_the_angle():
    steps = np.diff(spread(np.linspace(0, 2 * np.pi, 9), circle_density(1e-3, 1.0, angle=0.3)))
    assert len(steps) == 21  # 2 pi / 0.3 is 20.9


def test_a_straight_line_is_one_step_and_kinks_are_kept():
    at = np.linspace(0, 1, 5)
    np.testing.assert_array_equal(spread(at, np.zeros(5)), [0, 1])
    np.testing.assert_allclose(spread(at, np.zeros(5), [0.3]), [0, 0.3, 1])
    assert len(spread(at, np.zeros(5), least=3)) == 4


def test_a_count_that_is_whole_but_for_rounding_stays():
    at = np.linspace(0, 1, 5)
    for hair in (-1e-12, 0, 1e-12):
        assert len(spread(at, np.full(5, 7 + hair))) == 8


def test_diagonals_of_a_sphere_keep_the_deflection():
    radius, deflection = 10.0, 0.02
    u, v = np.linspace(0, 1, 25), np.linspace(-0.5, 0.5, 25)
    cosine = np.broadcast_to(np.cos(v), (25, 25))
    bends = Bends(u, v, radius * cosine, np.full((25, 25), radius), radius * cosine**2, np.zeros((25, 25)),
                  np.full((25, 25), radius))  # fmt: skip
    over_u, over_v = grid_densities(bends, deflection, 10.0)
    du, dv = np.diff(spread(u, over_u.max(1)))[0], np.diff(spread(v, over_v.max(0)))[0]
    diagonal = radius * np.hypot(du, dv)
    assert 0.8 * deflection < diagonal**2 / (8 * radius) <= deflection * 1.0001


def test_steps_of_a_cylinder_are_shortened_along_its_axis():
    ones = np.ones((3, 3))
    bends = Bends(np.linspace(0, 1, 3), np.linspace(0, 100, 3), 5 * ones, ones, 5 * ones, 0 * ones, 0 * ones)
    over_u, over_v = even_steps(bends, grid_densities(bends, 0.01, 10.0), 4.0)
    np.testing.assert_allclose((1 / over_v) / (5 / over_u), 4)


def test_rows_are_zipped_with_every_edge_in_one_triangle():
    first, second = Side(np.linspace(0, 1, 5), np.arange(5)), Side(np.array([0.1, 0.4, 0.9]), np.arange(5, 8))
    triangles = zipped(first, second)
    edges, count = edge_counts(triangles)
    assert len(triangles) == 4 + 2
    assert len(edges) == count
    assert {(0, 1), (1, 2), (2, 3), (3, 4), (6, 5), (7, 6)} <= edges


def test_a_rectangle_is_covered_once_whatever_its_border():
    u, v = np.linspace(0, 1, 6)[1:-1], np.linspace(0, 1, 4)[1:-1]
    points = [(x, y) for x in u for y in v]
    inner = np.arange(len(points)).reshape(len(u), len(v))
    corners = {(x, y): len(points) + k for k, (x, y) in enumerate([(0, 0), (1, 0), (0, 1), (1, 1)])}
    points += list(corners)

    def side(count, place):
        at = np.linspace(0, 1, count)
        numbers = []
        for t in at.tolist():
            if place(t) not in corners:
                corners[place(t)] = len(points)
                points.append(place(t))
            numbers.append(corners[place(t)])
        return Side(at, np.array(numbers))

    sides = [side(9, lambda t: (t, 0)), side(2, lambda t: (t, 1)), side(3, lambda t: (0, t)), side(6, lambda t: (1, t))]
    triangles = four_sided(sides, u, v, inner)
    a, b, c = (np.array(points, float)[triangles[:, k]] for k in range(3))
    areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert areas.min() > 0
    assert areas.sum() == pytest.approx(1)


def test_the_sagitta_of_a_chord_comes_from_the_normals():
    angle = np.array([0.0, 0.1, 0.2])
    normals = np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1)[None]
    exact = 4 * (1 - np.cos(0.1))  # radius 4, the longest chord spans 0.2
    assert sagittas(4 * normals, normals)[0] == pytest.approx(exact, rel=0.01)


def test_a_triangle_turned_over_faces_away():
    corners = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]]], float)
    up = np.tile([0.0, 0, 1], (1, 3, 1))
    assert facing(corners, up)[0] == pytest.approx(1)
    assert facing(corners[:, ::-1], up)[0] == pytest.approx(-1)
