# SPDX-License-Identifier: LGPL-2.1-or-later
"""What contours measure, against closed forms; which are rods, however they are turned."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import Contours, contour_measures
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.errors import Cancelled, ContourError


def stack(*slices, closed=True):
    """Contours of planes 0, 1, ...: a list of polygons (K, 2) each."""
    polygons = [np.asarray(p, float) for contours in slices for p in contours]
    return Contours(
        "z", np.arange(len(slices)) + 0.5, np.concatenate([np.zeros((0, 2)), *polygons]),
        np.cumsum([0] + [len(p) for p in polygons]), np.repeat(np.arange(len(slices)), [len(c) for c in slices]),
        np.full(len(polygons), closed),
    )  # fmt: skip


def measures(*polygons, **more):
    return contour_measures(stack(polygons), SliceParameters(**more))


def turned(polygon, degrees, x=0.0, y=0.0):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.asarray(polygon) @ np.array([[c, s], [-s, c]]) + [x, y]


def rectangle(a, b):
    return np.array([[-a, -b], [a, -b], [a, b], [-a, b]]) / 2


def ellipse(a, b, n=4000):
    t = 2 * np.pi * np.arange(n) / n
    return np.stack([a * np.cos(t), b * np.sin(t)], 1)


@pytest.mark.parametrize("degrees", [0, 17, 45, 90])
@pytest.mark.parametrize(("a", "b"), [(1, 1), (5, 1), (0.3, 0.2)])
def test_a_rectangle_anywhere_has_its_moments(degrees, a, b):
    m = measures(turned(rectangle(a, b), degrees, 700, -300))
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    along, across = a**3 * b / 12, a * b**3 / 12
    assert m.area[0] == pytest.approx(a * b, rel=1e-9) and m.perimeter[0] == pytest.approx(2 * (a + b), rel=1e-9)
    assert m.centroid[0] == pytest.approx([700, -300], abs=1e-9)
    expected = [along * c * c + across * s * s, (along - across) * s * c, along * s * s + across * c * c]
    assert m.moments[0] == pytest.approx(expected, rel=1e-8, abs=1e-8)
    assert m.aspect[0] == pytest.approx(max(a, b) / min(a, b), rel=1e-6)
    assert m.equivalent_diameter[0] == pytest.approx(math.sqrt(4 * a * b / math.pi), rel=1e-9)
    assert m.circularity[0] == pytest.approx(6 / math.pi * a * b / (a * a + b * b), rel=1e-6)
    assert (m.width[0], m.height[0]) == pytest.approx((a * abs(c) + b * abs(s), a * abs(s) + b * abs(c)), rel=1e-9)


@pytest.mark.parametrize("aspect", [1.0, 2.0, 2.9, 3.1, 8.0])
def test_an_ellipse_has_its_circularity_and_is_a_rod_up_to_three_times_as_long_as_wide(aspect):
    m = measures(*(turned(ellipse(aspect, 1.0), degrees) for degrees in (0, 30, 45, 77)))
    assert m.circularity == pytest.approx(np.full(4, 2 * aspect / (1 + aspect**2)), rel=1e-5)
    assert m.aspect == pytest.approx(np.full(4, aspect), rel=1e-5, abs=1e-3)
    assert m.is_rod_invariant.tolist() == [aspect < 3] * 4


def test_the_thesis_rule_sees_the_box_and_so_the_turn():
    shapes = [ellipse(1, 1), rectangle(1, 1), turned(rectangle(1, 1), 45), rectangle(5, 1), turned(rectangle(5, 1), 45)]
    m = measures(*shapes)
    assert m.ratio == pytest.approx([math.pi / 4, 1.0, 0.5, 1.0, 5 / 18], rel=1e-4)
    assert m.is_rod.tolist() == [True, True, False, True, False]
    assert m.is_rod_invariant.tolist() == [True, True, True, False, False]
    assert measures(*shapes, rod_ratio=0.9).is_rod.tolist() == [False, True, False, True, False]


def test_a_bent_strip_is_a_plate_however_it_is_turned():
    t = np.linspace(0, 1.5 * math.pi, 200)
    arc = np.concatenate([np.stack([r * np.cos(a), r * np.sin(a)], 1) for r, a in ((3.0, t), (2.7, t[::-1]))])
    m = measures(*(turned(arc, degrees) for degrees in range(0, 180, 15)))
    assert not m.is_rod_invariant.any() and np.ptp(m.circularity) < 1e-9
    assert m.area == pytest.approx(np.full(12, 0.75 * math.pi * (9 - 2.7**2)), rel=1e-4)


def test_holes_are_negative_and_no_rods_and_islands_lie_in_holes():
    m = measures(rectangle(10, 10), rectangle(6, 6)[::-1], rectangle(2, 2), rectangle(1, 1)[::-1] + [0, 4])
    assert m.area.tolist() == [100, -36, 4, -1]
    assert m.net_area[[0, 2]].tolist() == [63, 4] and np.isnan(m.net_area[[1, 3]]).all()
    assert m.parent.tolist() == [-1, 0, 1, 0]
    assert m.is_rod.tolist() == [True, False, True, False] == m.is_rod_invariant.tolist()
    assert (m.moments[:, [0, 2]] > 0).all() and m.circularity[1] == pytest.approx(3 / math.pi)


def test_contours_of_other_planes_are_no_parents():
    m = contour_measures(stack([rectangle(9, 9)], [rectangle(3, 3)[::-1]], [], [rectangle(1, 1)]), SliceParameters())
    assert m.parent.tolist() == [-1] * 3 and m.plane.tolist() == [0, 1, 3]


def test_many_nested_rings_on_many_planes_find_their_parents():
    rings = [turned(ellipse(r, 0.8 * r, 37), 11 * r)[:: -1 if r % 2 == 0 else 1] for r in range(9, 0, -1)]
    rings += [rectangle(0.5, 0.5)[::-1] + [7.9 * math.cos(0.3 * k), 0.0] for k in range(1)]
    slices = [[ring + [30 * k, 7 * k] for ring in rings[: 1 + k % 9]] for k in range(40)]
    m = contour_measures(stack(*slices), SliceParameters())
    for k in range(40):
        first = int(np.searchsorted(m.plane, k))
        assert m.parent[m.plane == k].tolist() == [-1, *range(first, first + k % 9)]


def test_open_chains_count_for_nothing():
    contours = stack([rectangle(2, 2)], [rectangle(1, 1)], closed=False)
    m = contour_measures(contours, SliceParameters())
    assert m.area.tolist() == [0, 0] and m.parent.tolist() == [-1, -1] and not m.is_rod.any()
    for name in ("perimeter", "width", "height", "centroid", "moments", "ratio", "circularity", "aspect"):
        assert np.isnan(getattr(m, name)).all()
    assert contours.lengths().tolist() == [6, 3]  # without the line from end to start


def test_a_contour_without_area_has_no_shape():
    m = measures([[0, 0], [1, 0]], [[2, 2]] * 4)
    assert m.area.tolist() == [0, 0] and m.perimeter.tolist() == [2, 0]
    assert np.isnan(m.ratio).all() and not m.is_rod.any() and not m.is_rod_invariant.any()


def test_no_contours_have_no_measures():
    m = contour_measures(stack([], []), SliceParameters())
    assert len(m) == 0 and m.centroid.shape == (0, 2) and m.moments.shape == (0, 3)
    assert stack([], []).lengths().shape == (0,)


def test_contours_that_replace_others_stand_on_their_planes():
    old = stack([rectangle(1, 1), rectangle(2, 2)], [rectangle(3, 3)])
    new = old.replaced(np.array([True, False, True]), [1, 0], [rectangle(5, 5), rectangle(4, 4)])
    assert new.plane.tolist() == [0, 0, 1, 1]
    assert [np.ptp(p[:, 0]) for k in (0, 1) for p in new.of_plane(k)] == [1, 4, 3, 5]
    assert list(new.of_plane(7)) == []


# --------------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    ("starts", "plane", "closed"),
    [([0, 4], [0, 0], [True, True]), ([0, 3], [0], [True]), ([0, 4], [0], [True, False]), ([0, 4], [2], [True]),
     ([0, 4], [-1], [True]), ([0, 2, 4], [1, 0], [True, True])],
)  # fmt: skip
def test_arrays_that_do_not_fit_together_are_refused(starts, plane, closed):
    with pytest.raises(ContourError, match="contours must"):
        Contours("z", np.arange(2.0), np.zeros((4, 2)), np.array(starts), np.array(plane), np.array(closed))


def test_measuring_can_be_cancelled():
    def stop(done, total, what):
        raise Cancelled

    with pytest.raises(Cancelled):
        contour_measures(stack([rectangle(1, 1)]), SliceParameters(), stop)
