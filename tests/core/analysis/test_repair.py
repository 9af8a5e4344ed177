# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repairs: what closes, what goes, what is counted, and that closed contours stay as they are."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import Contours, contour_measures
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.repair import mend, nearest_starts, smoothed
from freecad_trabecula.core.analysis.slices import slice_contours, sliced_areas
from freecad_trabecula.core.analysis.soundness import mesh_facts
from freecad_trabecula.core.analysis.triangles import Soup
from freecad_trabecula.errors import Cancelled, ParameterError


def stack(*slices):
    """Contours of planes 0, 1, ...: lists of (points, closed)."""
    lines = [(np.asarray(p, float), closed) for contours in slices for p, closed in contours]
    return Contours(
        "z", np.arange(len(slices)) + 0.5, np.concatenate([np.zeros((0, 2)), *(p for p, _ in lines)]),
        np.cumsum([0] + [len(p) for p, _ in lines]), np.repeat(np.arange(len(slices)), [len(c) for c in slices]),
        np.array([closed for _, closed in lines], bool),
    )  # fmt: skip


def circle(radius, n=400, x=0.0, noise=0.0):
    t = 2 * np.pi * np.arange(n) / n
    r = radius + noise * np.sin(77 * t)
    return np.stack([x + r * np.cos(t), r * np.sin(t)], 1)


def areas(contours):
    measures = contour_measures(contours, SliceParameters())
    return np.bincount(measures.plane, measures.area, len(contours.heights))


def torus(n=150, m=80):
    a, b = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    points = np.stack([(4 + np.cos(b)) * np.cos(a), (4 + np.cos(b)) * np.sin(a), np.sin(b)], -1).reshape(-1, 3)
    i, j = (k.ravel() for k in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    corner = [(i + di) % n * m + (j + dj) % m for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
    faces = np.concatenate([np.stack([corner[k] for k in t], 1) for t in ((0, 1, 2), (0, 2, 3))])
    return points.astype(np.float32)[faces]


def picked(count, one_in):
    return (np.arange(count) * 2654435761 % 2**32) % one_in == 0


HEIGHTS = np.linspace(-0.95, 0.95, 60)


# ---------------------------------------------------------------------------------------------------- spoilt meshes


def spoilt(how, triangles):
    which = picked(len(triangles), 700)
    if how == "missing":
        return triangles[~which]
    if how == "flipped":
        return np.where(which[:, None, None], triangles[:, ::-1], triangles)
    corners = picked(3 * len(triangles), 700).reshape(-1, 3, 1)
    return np.where(corners, np.nextafter(triangles, np.float32(99)), triangles)


@pytest.mark.parametrize(("how", "most"), [("missing", 1e-9), ("flipped", 1e-9), ("a bit off", 1e-6)])
def test_planes_of_a_spoilt_mesh_are_named_and_come_out_right(how, most):
    triangles = torus()
    right = sliced_areas(triangles, "z", HEIGHTS)
    bad = spoilt(how, triangles)
    raw = slice_contours(bad, "z", HEIGHTS)
    contours, repairs = mend(raw, SliceParameters())
    error = np.abs(areas(contours) / right - 1)
    # a missing facet leaves a gap of one straight segment: the line that closes it is the one that was there
    assert contours.closed.all() and error.max() < most
    assert repairs.spoilt.any()
    before = np.abs(sliced_areas(bad, "z", HEIGHTS) / right - 1) > 1e-9
    assert not (before & ~repairs.spoilt).any()  # no wrong plane without a mark
    joined = repairs.gaps_filled + repairs.gaps_bridged
    assert ((joined > 0) == repairs.spoilt).all() and ((repairs.longest_gap > 0.01) == (repairs.gaps_bridged > 0)).all()
    assert joined.sum() == repairs.open_chains.sum() == (~raw.closed).sum()
    assert not mesh_facts(Soup(bad), crossings=False).is_closed


def test_a_large_hole_is_bridged_and_its_width_is_told():
    triangles = torus()
    middle = triangles.mean(1)
    gone = (np.abs(middle - [5, 0, 0]) < [0.5, 0.8, 0.5]).all(1)
    contours, repairs = mend(slice_contours(triangles[~gone], "z", [0.0, 0.9]), SliceParameters())
    assert contours.closed.all() and repairs.gaps_bridged.tolist() == [1, 0] and repairs.gaps_filled.sum() == 0
    assert 1.4 < repairs.longest_gap[0] < 1.9
    exact = sliced_areas(triangles, "z", [0.0, 0.9])
    segment = 25 * (math.asin(0.8 / 5) - 0.16 * math.sqrt(1 - 0.16**2))  # of the outer circle, cut off by the bridge
    assert areas(contours) == pytest.approx(exact - [segment, 0], abs=0.03)


def test_a_closed_mesh_is_not_touched():
    raw = slice_contours(torus(), "z", HEIGHTS)
    contours, repairs = mend(raw, SliceParameters(gap=5.0, iterations=50))
    assert contours is raw
    for counts in vars(repairs).values():
        assert not counts.any()


def test_a_mesh_given_twice_has_doubled_areas_and_says_so_by_its_duplicates():
    triangles = torus(40, 20)
    twice = np.concatenate([triangles] * 2)
    assert sliced_areas(twice, "z", [0.1])[0] == pytest.approx(2 * sliced_areas(triangles, "z", [0.1])[0])
    assert mesh_facts(Soup(twice), crossings=False).duplicates == len(triangles)


# ---------------------------------------------------------------------------------------------------------- joining


def test_arcs_are_joined_end_to_start_and_keep_the_closed_ones():
    ring = circle(1.0)
    arcs = [(ring[:100], False), (ring[300:], False), (circle(0.5, x=3), True), (ring[100:300], False)]
    contours, repairs = mend(stack(arcs, [(circle(2.0), True)]), SliceParameters(gap=0.1))
    assert repairs.gaps_filled.tolist() == [3, 0] and repairs.open_chains.tolist() == [3, 0]
    assert repairs.longest_gap[0] == pytest.approx(2 * math.sin(math.pi / 400))
    assert areas(contours)[0] == pytest.approx(areas(stack([(ring, True), (circle(0.5), True)]))[0])


def test_gap_fill_takes_gaps_up_to_its_maximum_in_its_rounds_and_the_rest_is_bridged():
    lines = [([[0, 0], [1, 0]], False), ([[1.005, 0], [1, 1]], False), ([[1, 1.2], [0, 1]], False)]
    _, repairs = mend(stack(lines), SliceParameters(gap=0.01))
    assert (repairs.gaps_filled[0], repairs.gaps_bridged[0]) == (1, 2) and repairs.longest_gap[0] == 1.0
    _, repairs = mend(stack(lines), SliceParameters(gap=0.3, iterations=0))
    assert (repairs.gaps_filled[0], repairs.gaps_bridged[0]) == (0, 3)
    _, repairs = mend(stack(lines), SliceParameters(gap=2.0))
    assert (repairs.gaps_filled[0], repairs.gaps_bridged[0]) == (3, 0)


@pytest.mark.parametrize("count", [1, 7, 700])
def test_joining_is_that_of_the_nearest_two_of_all_first(count):
    key = np.arange(4 * count) * 2654435761 % 2**32 / 2**32
    starts, ends = key[: 2 * count].reshape(-1, 2), key[2 * count :].reshape(-1, 2)
    table = np.hypot(ends[:, None, 0] - starts[:, 0], ends[:, None, 1] - starts[:, 1])
    expected = np.full(count, -1)
    left = table.copy()
    for _ in range(count):
        e, s = np.unravel_index(left.argmin(), left.shape)
        expected[e] = s
        left[e], left[:, s] = np.inf, np.inf
    follow, gaps = nearest_starts(starts, ends, np.inf, None)
    assert (follow == expected).all() and sorted(gaps) == pytest.approx(sorted(table[np.arange(count), expected]))


def test_nothing_is_joined_beyond_the_limit():
    follow, gaps = nearest_starts(np.array([[0.0, 0], [5, 0]]), np.array([[0.5, 0], [9, 0]]), 1.0, None)
    assert follow.tolist() == [0, -1] and gaps.tolist() == [0.5]


# ---------------------------------------------------------------------------------------------- filters, smoothing


def test_short_contours_are_left_out_and_counted():
    line, stub = ([[0, 0], [9, 0]], False), ([[0, 3], [0.1, 3]], False)
    slices = [[(circle(1.0), True), (circle(0.01, x=5), True)], [line, stub], [(circle(3.0), True)]]
    contours, repairs = mend(stack(*slices), SliceParameters(filter_open=0.5, filter_closed=1.0))
    assert repairs.removed_open.tolist() == [0, 1, 0] and repairs.removed_closed.tolist() == [1, 0, 0]
    assert contours.plane.tolist() == [0, 1, 2] and contours.closed.all()


@pytest.mark.parametrize("smoothing", ["normal", "heavy"])
def test_smoothing_leaves_out_points_and_stays_within_its_tolerance(smoothing):
    rough = stack([(circle(2.0, 3000, noise=4e-4), True), (circle(1.0, 5, x=9), True)], [(circle(1.0, 900), True)])
    contours, repairs = mend(rough, SliceParameters(smoothing=smoothing, thickness=0.1))
    tolerance = {"normal": 0.002, "heavy": 0.01}[smoothing]
    sizes = np.diff(contours.starts)
    assert repairs.points_smoothed.tolist() == [3005 - sizes[:2].sum(), 900 - sizes[2]]
    assert sizes[1] == 5 and sizes[0] < 400 and sizes[2] < 100
    new = next(contours.of_plane(0))
    for old in next(rough.of_plane(0))[::7]:
        a, b = new, np.roll(new, -1, 0)
        t = np.clip(((old - a) * (b - a)).sum(1) / ((b - a) ** 2).sum(1), 0, 1)
        assert np.hypot(*(a + t[:, None] * (b - a) - old).T).min() <= tolerance * (1 + 1e-9)
    assert areas(contours)[0] == pytest.approx(areas(rough)[0], rel=3 * tolerance)


def test_points_on_a_line_go_at_any_tolerance_and_corners_stay():
    sides = [np.linspace(a, b, 50, endpoint=False) for a, b in (((0, 0), (1, 0)), ((1, 0), (1, 1)), ((1, 1), (0, 0)))]
    contours, removed = smoothed(stack([(np.concatenate(sides), True)]), 1e-9)
    assert removed[0] >= 144 and areas(contours)[0] == pytest.approx(0.5)
    corners = {tuple(p) for p in contours.points.tolist()}
    assert {(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)} <= corners


def test_open_chains_are_not_smoothed():
    line = stack([(np.stack([np.linspace(0, 1, 99), np.zeros(99)], 1), False)])
    assert smoothed(line, 1.0)[1].tolist() == [0]


def test_options_that_cannot_be_are_refused_before_anything_is_mended():
    for wrong in ({"gap": -0.01}, {"filter_closed": -1}, {"smoothing": "light"}):
        with pytest.raises(ParameterError):
            mend(stack([(circle(1.0), True)]), SliceParameters(**wrong))


def test_joining_can_be_cancelled():
    def stop(done, total, what):
        raise Cancelled

    with pytest.raises(Cancelled):
        mend(stack([([[0, 0], [1, 0], [1, 1]], False)]), SliceParameters(), stop)
