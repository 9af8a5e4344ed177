# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners with so many decimals, none twice."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import Contours
from freecad_trabecula.core.analysis.layer_corners import distinct_corners


def contours_of(*polygons, closed=None):
    """All on one plane."""
    corners = [np.array(p, float).reshape(-1, 2) for p in polygons]
    count = len(corners)
    return Contours(
        axis="z",
        heights=np.zeros(1),
        points=np.concatenate([np.zeros((0, 2)), *corners]),
        starts=np.concatenate([[0], np.cumsum([len(c) for c in corners])]).astype(int),
        plane=np.zeros(count, int),
        closed=np.ones(count, bool) if closed is None else np.array(closed),
    )


SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]


def test_corners_that_round_to_one_are_one_also_across_the_end():
    points, starts, plane, closed = distinct_corners(contours_of([*SQUARE, [0.2, 0.0004], [0, 0.0001]]), 1.0, 1)
    assert points.tolist() == [[1.0, 0.0], [1, 1], [0, 1], [0.2, 0], [0, 0]]
    assert starts.tolist() == [0, 5] and plane.tolist() == [0] and closed.tolist() == [True]


def test_an_open_polyline_may_end_where_it_began():
    line = [[0, 0], [1, 0], [0, 0]]
    points, starts, _, closed = distinct_corners(contours_of(SQUARE, line, closed=[True, False]), 1.0, 3)
    assert starts.tolist() == [0, 4, 7] and points[4:].tolist() == line and closed.tolist() == [True, False]


@pytest.mark.parametrize("polygon", [[], [[1, 1]], [[1, 1], [2, 2]], [[1, 1], [1, 1], [1.00004, 1], [1, 1]]])
def test_what_has_no_extent_at_this_precision_is_left_out(polygon):
    points, starts, plane, _ = distinct_corners(contours_of(polygon, SQUARE), 1.0, 4)
    assert points.tolist() == SQUARE and starts.tolist() == [0, 4] and len(plane) == 1


def test_lengths_are_counted_in_the_unit_and_zero_has_no_sign():
    points = distinct_corners(contours_of([[-1e-9, 0], [25.4, 0], [25.4, 50.8]]), 25.4, 6)[0]
    assert points.tolist() == [[0, 0], [1, 0], [1, 2]]
    assert not np.signbit(points).any()


def test_no_contours_have_no_corners():
    points, starts, plane, closed = distinct_corners(contours_of(), 1.0, 6)
    assert len(points) == len(plane) == len(closed) == 0 and starts.tolist() == [0]
