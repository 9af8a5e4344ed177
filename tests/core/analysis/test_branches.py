# SPDX-License-Identifier: LGPL-2.1-or-later
"""The graph of trabeculae over the slices, on stacks of polygons whose branches and junctions are known."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis import branches as b
from freecad_trabecula.core.analysis.contours import Contours, contour_measures
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.slices import slice_contours
from freecad_trabecula.errors import Cancelled, ParameterError


def square(x, y, half=0.4, hole=False):
    points = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half + [x, y]
    return points[::-1] if hole else points


def stack(*slices, distance=1.0):
    """Return contours and measures of slices, each a list of polygons."""
    polygons = [(k, polygon) for k, polygons in enumerate(slices) for polygon in polygons]
    points = np.concatenate([p for _, p in polygons]) if polygons else np.zeros((0, 2))
    contours = Contours(
        "z", distance * np.arange(len(slices)), points, np.cumsum([0] + [len(p) for _, p in polygons]),
        np.array([k for k, _ in polygons], int), np.ones(len(polygons), bool),
    )  # fmt: skip
    return contours, contour_measures(contours, SliceParameters())


def trace(*slices, **more):
    return b.trace_branches(*stack(*slices), spacing=0.05, **more)


def test_a_straight_rod_is_one_branch_without_events():
    found = trace(*[[square(0, 0)]] * 5)
    assert found.edges.tolist() == [[0, 1], [1, 2], [2, 3], [3, 4]]
    assert (found.branches, found.junctions, found.parts, found.loops) == (1, 0, 1, 0)
    assert [a.sum() for a in (found.appear, found.end, found.split, found.join)] == [0, 0, 0, 0]
    assert (found.branches_per_mm, found.junctions_per_mm) == (0.25, 0.0)


def test_a_letter_y_has_one_split_and_three_branches():
    whole, two = [square(0, 0, 2)], [square(-1, 0), square(1, 0)]
    found = trace(whole, whole, two, two)
    assert (found.branches, found.junctions, found.loops) == (3, 1, 0)
    assert found.split.tolist() == [0, 1, 0, 0]
    upside_down = trace(two, two, whole, whole)
    assert (upside_down.branches, upside_down.junctions) == (3, 1)
    assert upside_down.join.tolist() == [0, 0, 1, 0]


def test_a_ring_on_its_edge_splits_joins_and_has_one_loop():
    whole, two = [square(0, 0, 2)], [square(-1, 0), square(1, 0)]
    found = trace(whole, two, two, whole)
    assert (found.branches, found.junctions, found.loops, found.parts) == (4, 2, 1, 1)


def test_trabeculae_that_begin_and_end_inside_are_counted_and_cut_ones_are_not():
    a, c = square(0, 0), square(5, 5)
    found = trace([a], [a, c], [a, c], [a])
    assert found.appear.tolist() == [0, 1, 0, 0]
    assert found.end.tolist() == [0, 0, 1, 0]
    assert (found.branches, found.parts) == (2, 2)


def test_what_stands_in_a_hole_is_not_connected_with_the_wall_around_it():
    tube, rod = [square(0, 0, 2), square(0, 0, 1, hole=True)], square(0, 0, 0.5)
    found = trace(tube, [*tube, rod], [rod])
    # below the rod is the tube's hole; above the tube nothing
    assert found.appear.tolist() == [0, 1, 0]
    assert found.end.tolist() == [0, 1, 0]
    assert len(found.edges) == 2


def test_trabeculae_that_overlap_on_their_own_slice_are_each_connected():
    # rods of a network that runs through itself: the long one is there before and after the short one
    long, short = square(0, 0, 3), square(-2, 0, 0.4)
    found = trace([long, short], [square(2.5, 0)], [square(2.5, 0)])
    assert found.edges.tolist() == [[0, 2], [2, 3]]


def test_touching_without_overlap_is_no_connection():
    found = trace([square(0, 0, 0.5)], [square(1, 0, 0.5)])
    assert len(found.edges) == 0
    assert (found.branches, found.parts) == (2, 2)


@pytest.mark.parametrize("seed", range(5))
def test_overlaps_of_rectangles_agree_with_brute_force(seed):
    rng = np.random.default_rng(seed)

    def tiles():
        # one rectangle in some cells of a grid: none overlaps another of its slice
        cells = rng.permutation(64)[:30]
        for cell in cells:
            low = np.array([cell // 8, cell % 8]) + rng.uniform(0, 0.4, 2)
            high = np.array([cell // 8, cell % 8]) + rng.uniform(0.6, 1, 2)
            yield np.array([low, [high[0], low[1]], high, [low[0], high[1]]])

    slices = [list(tiles()) for _ in range(4)]
    shift = rng.uniform(-0.5, 0.5, (4, 2))
    slices = [[p + s for p in polygons] for polygons, s in zip(slices, shift)]
    found = b.trace_branches(*stack(*slices), spacing=1e-3)
    boxes = [(k, p.min(0), p.max(0)) for k, polygons in enumerate(slices) for p in polygons]
    expected = [
        [i, j]
        for i, (k, low, high) in enumerate(boxes)
        for j, (above, low_2, high_2) in enumerate(boxes)
        if above == k + 1 and (np.minimum(high, high_2) - np.maximum(low, low_2) > [0, 2e-3]).all()
    ]
    assert found.edges.tolist() == expected


def test_a_torus_of_triangles_has_one_split_one_join_and_one_loop():
    u = 2 * np.pi * np.arange(48) / 48
    v = 2 * np.pi * np.arange(24) / 24
    ring = (4 + 1.5 * np.cos(v))[None, :]
    grid = np.stack([ring * np.cos(u)[:, None], 0 * u[:, None] + 1.5 * np.sin(v), ring * np.sin(u)[:, None]], 2)
    turned = np.roll(grid, -1, 0)
    a, c, d, e = grid, turned, np.roll(turned, -1, 1), np.roll(grid, -1, 1)
    triangles = np.concatenate([np.stack(t, 2).reshape(-1, 3, 3) for t in ([a, d, c], [a, e, d])])
    contours = slice_contours(triangles.astype(np.float32), "z", np.linspace(-5.4, 5.4, 55))
    found = b.trace_branches(contours, contour_measures(contours, SliceParameters()))
    assert (found.branches, found.junctions, found.loops, found.parts) == (4, 2, 1, 1)


def test_trabeculae_between_two_rows_are_left_out_and_counted():
    small = square(0.5, 0.5, 0.1)
    found = b.trace_branches(*stack([small, square(0, 9, 2)], [small]), spacing=1.0)
    assert found.unresolved == 2
    assert found.contours.tolist() == [1]


def test_trabeculae_below_the_least_area_are_left_out():
    assert len(trace([square(0, 0, 0.1), square(3, 3)], least_area=0.05).plane) == 1


def test_slices_without_any_contour_have_no_branches():
    found = b.trace_branches(*stack([], []))
    assert (found.branches, found.junctions, found.parts, found.loops) == (0, 0, 0, 0)
    assert math.isnan(trace([square(0, 0)]).branches_per_mm)


def test_default_rows_lie_a_quarter_of_the_slices_distance_apart():
    assert b.trace_branches(*stack([square(0, 0)], [square(0, 0)], distance=0.2)).spacing == pytest.approx(0.05)


@pytest.mark.parametrize("spacing", [0.0, -1.0, math.nan, math.inf])
def test_a_spacing_that_is_none_is_refused(spacing):
    with pytest.raises(ParameterError, match="spacing of rows must be > 0"):
        b.trace_branches(*stack([square(0, 0)]), spacing=spacing)


def test_measures_of_other_contours_are_refused():
    with pytest.raises(ParameterError, match="one row of measures for each contour, got 2, 1"):
        b.trace_branches(stack([square(0, 0)])[0], stack([square(0, 0), square(2, 2)])[1])


def test_cancelling_stops_the_search_for_branches():
    def cancel(done, total, what):
        raise Cancelled("stop")

    with pytest.raises(Cancelled):
        trace([square(0, 0)], progress=cancel)
