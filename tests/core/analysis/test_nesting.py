# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parents of polygons against testing every point in every polygon."""

import numpy as np
import pytest

from freecad_trabecula.core.analysis import nesting


def polygons_of(loops, planes):
    loops = [np.asarray(loop, float) for loop in loops]
    area = [((p[:, 0] * np.roll(p[:, 1], -1)) - (np.roll(p[:, 0], -1) * p[:, 1])).sum() / 2 for p in loops]
    return nesting.Polygons(
        np.concatenate(loops), np.cumsum([0] + [len(p) for p in loops]), np.array(planes), np.array(area),
        np.stack([p.min(0) for p in loops], 1), np.stack([p.max(0) for p in loops], 1),
    )  # fmt: skip


def contains(loop, point):
    """Winding number by angles: another route than counting crossings."""
    around = np.asarray(loop) - point
    angle = np.arctan2(around[:, 1], around[:, 0])
    turn = (np.diff(angle, append=angle[:1]) + np.pi) % (2 * np.pi) - np.pi
    return abs(turn.sum()) > np.pi


def fractions(count, salt):
    return (np.arange(count) * 2654435761 + salt * 40503) % 2**32 / 2**32


@pytest.fixture(scope="module")
def forest():
    """Rings in rings of wavy outline, side by side, on twelve planes."""
    loops, planes = [], []
    for plane in range(12):
        for k in range(1 + plane):
            x, y = 10 * (k % 4) + fractions(99, plane)[k], 10 * (k // 4) + fractions(99, 7 + plane)[k]
            for ring in range(1 + int(5 * fractions(99, 3 * plane)[k])):
                t = 2 * np.pi * np.arange(60) / 60
                r = (4.5 - 0.9 * ring) * (1 + 0.06 * np.sin(5 * t + k))
                loop = np.stack([x + r * np.cos(t), y + r * np.sin(t)], 1)
                loops.append(loop[:: -1 if ring % 2 else 1])
                planes.append(plane)
    return loops, planes


@pytest.mark.parametrize("points", [50, 50_000])
def test_parents_are_the_smallest_of_the_other_sign_that_contain(forest, points, monkeypatch):
    monkeypatch.setattr(nesting, "_POINTS", points)
    monkeypatch.setattr(nesting, "_PAIRS", points)
    loops, planes = forest
    polygons = polygons_of(loops, planes)
    expected = []
    for k, loop in enumerate(loops):
        around = [m for m, other in enumerate(loops) if planes[m] == planes[k] and m != k
                  and polygons.area[m] * polygons.area[k] < 0 and contains(other, loop[0])]  # fmt: skip
        expected.append(min(around, key=lambda m: abs(polygons.area[m]), default=-1))
    assert nesting.contour_parents(polygons).tolist() == expected
    assert sum(parent >= 0 for parent in expected) > 50


def test_a_hole_in_the_bay_of_a_bent_contour_is_not_in_it():
    bay = [[0, 0], [9, 0], [9, 9], [0, 9], [0, 7], [7, 7], [7, 2], [0, 2]]
    hole = [[3, 4], [3, 5], [4, 5], [4, 4]]
    solid = [[7.5, 4], [7.5, 5], [8, 5], [8, 4]]
    assert nesting.contour_parents(polygons_of([bay, hole, solid], [0, 0, 0])).tolist() == [-1, -1, 0]


def test_corners_at_the_height_of_a_ray_count_once():
    diamond = [[-5, 0], [0, -5], [5, 0], [0, 5]]
    hole = [[-1, 0], [0, 1], [1, 0], [0, -1]]  # its leftmost corner is as high as two of the diamond's
    beside = [[6, 0], [7, 1], [8, 0], [7, -1]]
    assert nesting.contour_parents(polygons_of([diamond, hole, beside], [0, 0, 0])).tolist() == [-1, 0, -1]


def test_outer_contours_that_overlap_are_not_nested():
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    assert nesting.contour_parents(polygons_of([square * 3, square + 1], [0, 0])).tolist() == [-1, -1]
