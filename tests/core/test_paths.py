# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths against their defining properties."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.paths import middle_paths, stations, straight_paths, tension_paths

RNG = np.random.default_rng(1)
P0, P1, MIDDLE = RNG.uniform(0, 10, (3, 8, 3))


def derivative(bezier, t, order):
    """Derivative of cubic Bezier poles (..., 4, 3) at t by differences of the poles."""
    for k in range(order):
        bezier = (3 - k) * np.diff(bezier, axis=-2)
    while bezier.shape[-2] > 1:
        bezier = bezier[..., :-1, :] * (1 - t) + bezier[..., 1:, :] * t
    return bezier[..., 0, :]


def test_straight_stations_are_evenly_spaced_on_the_line():
    on = stations(straight_paths(P0, P1), 9)
    assert np.allclose(on.centres, P0[:, None] + np.linspace(0, 1, 9)[:, None] * (P1 - P0)[:, None])
    assert np.allclose(on.lengths, np.linalg.norm(P1 - P0, axis=1))
    assert np.abs(on.curvatures).max() < 1e-9


def test_three_point_path_goes_through_its_points():
    path = middle_paths(P0, MIDDLE, P1)
    assert (path[:, 0, 0] == P0).all() and (path[:, 0, 3] == MIDDLE).all()
    assert (path[:, 1, 0] == MIDDLE).all() and (path[:, 1, 3] == P1).all()


def test_three_point_path_is_the_natural_spline_by_chord_length():
    path = middle_paths(P0, MIDDLE, P1)
    h = [np.linalg.norm(MIDDLE - P0, axis=1)[:, None], np.linalg.norm(P1 - MIDDLE, axis=1)[:, None]]
    for order in (1, 2):
        left = derivative(path[:, 0], 1.0, order) / h[0] ** order
        right = derivative(path[:, 1], 0.0, order) / h[1] ** order
        assert np.allclose(left, right)
    assert np.allclose(derivative(path[:, 0], 0.0, 2), 0)
    assert np.allclose(derivative(path[:, 1], 1.0, 2), 0)


def test_three_points_on_a_line_give_the_line():
    path = middle_paths(P0, (P0 + P1) / 2, P1)
    assert np.allclose(np.cross(path - P0[:, None, None], (P1 - P0)[:, None, None]), 0)


def test_two_point_path_leaves_and_arrives_along_the_normals_with_its_tensions():
    n0, n1 = (v / np.linalg.norm(v, axis=1, keepdims=True) for v in RNG.normal(size=(2, 8, 3)))
    tension = np.linspace(0.1, 5, 8)
    path = tension_paths(P0, n0, P1, n1, tension, 2 * tension)
    # each half runs over half of the parameter: the whole curve's derivative is twice that of the half
    assert np.allclose(2 * derivative(path[:, 0], 0.0, 1), n0 * tension[:, None])
    assert np.allclose(2 * derivative(path[:, 1], 1.0, 1), n1 * 2 * tension[:, None])
    middle = (P0 + P1) / 2 + (n0 * tension[:, None] - n1 * 2 * tension[:, None]) / 8  # Hermite cubic at t = 1/2
    assert np.allclose(path[:, 0, 3], middle)


def test_stations_are_equidistant_along_the_curve():
    on = stations(middle_paths(P0, MIDDLE, P1), 17)
    fine = stations(middle_paths(P0, MIDDLE, P1), 1601)
    steps = np.linalg.norm(np.diff(fine.centres, axis=1), axis=2).reshape(8, 16, 100).sum(2)
    assert np.allclose(steps / steps.mean(1, keepdims=True), 1, atol=1e-3)
    assert on.lengths == pytest.approx(steps.sum(1), rel=1e-4)


def test_tangents_are_unit_and_curvature_is_that_of_a_circle():
    # two quarter circles of radius 2 as Bezier pieces: the curve is within 3e-4 of the circle
    c = 4 / 3 * (math.sqrt(2) - 1) * 2
    path = np.array(
        [[[[2, 0, 0], [2, c, 0], [c, 2, 0], [0, 2, 0]], [[0, 2, 0], [-c, 2, 0], [-2, c, 0], [-2, 0, 0]]]], float
    )
    on = stations(path, 9)
    assert np.allclose(np.linalg.norm(on.tangents, axis=2), 1)
    assert on.lengths[0] == pytest.approx(2 * math.pi, rel=5e-4)
    assert np.linalg.norm(on.curvatures, axis=2) == pytest.approx(np.full((1, 9), 0.5), rel=0.03)
    assert np.allclose((on.curvatures * on.tangents).sum(2), 0, atol=1e-9)


def test_no_path_gives_no_station():
    assert stations(np.zeros((0, 2, 4, 3)), 5).centres.shape == (0, 5, 3)
