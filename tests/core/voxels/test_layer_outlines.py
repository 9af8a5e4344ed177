# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines of layers: area, number and shape against counts by other routes."""

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.layer_outlines import corner_count, layer_outlines
from freecad_trabecula.errors import ParameterError


def area(corners):
    x, y = corners.T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()) / 2


def random_layers(count):
    for k in range(count):
        u = Stream(k, "layer").uniform(100)
        yield (u[10:].reshape(9, 10) < u[0])[: 1 + int(8 * u[1]), : 1 + int(9 * u[2])]


def parts(squares, across_corners):
    """Number of connected parts of squares, by flooding."""
    left, count = {(int(y), int(x)) for y, x in zip(*np.nonzero(squares))}, 0
    steps = [(dy, dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if across_corners or not dy or not dx]
    while left:
        count, front = count + 1, [left.pop()]
        while front:
            y, x = front.pop()
            near = {(y + dy, x + dx) for dy, dx in steps} & left
            left -= near
            front += near
    return count


def test_the_outlines_enclose_the_solid_squares_and_no_corner_lies_in_line():
    for layer in random_layers(200):
        outlines = layer_outlines(layer)
        assert sum(map(area, outlines)) == layer.sum()
        for corners in outlines:
            steps = np.sign(np.roll(corners, -1, 0) - corners)
            assert (np.abs(steps).sum(1) == 1).all()
            assert (steps != np.roll(steps, 1, 0)).any(1).all()


def test_each_part_has_one_outer_outline_and_each_hole_one_more():
    for layer in random_layers(100):
        areas = [area(corners) for corners in layer_outlines(layer)]
        holes = parts(~np.pad(layer, 1), True) - 1
        assert sum(a > 0 for a in areas) == parts(layer, False)
        assert sum(a < 0 for a in areas) == holes


def test_squares_that_touch_by_a_corner_stay_apart():
    assert [o.tolist() for o in layer_outlines(np.eye(2, dtype=bool))] == [
        [[0, 0], [1, 0], [1, 1], [0, 1]],
        [[1, 1], [2, 1], [2, 2], [1, 2]],
    ]


def test_a_hole_runs_clockwise():
    ring = np.ones((3, 3), bool)
    ring[1, 1] = False
    assert [o.tolist() for o in layer_outlines(ring)] == [
        [[0, 0], [3, 0], [3, 3], [0, 3]],
        [[1, 1], [1, 2], [2, 2], [2, 1]],
    ]


def test_corners_are_counted_without_tracing():
    for layer in random_layers(100):
        assert corner_count(layer[None]) == sum(map(len, layer_outlines(layer)))


def test_an_empty_layer_has_none_and_an_array_of_three_axes_is_refused():
    assert layer_outlines(np.zeros((2, 2), bool)) == []
    with pytest.raises(ParameterError, match="two axes, got"):
        layer_outlines(np.zeros((2, 2, 2), bool))
