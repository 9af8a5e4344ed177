# SPDX-License-Identifier: LGPL-2.1-or-later
"""The passport's scores against closed forms; identical samples score 0 and 1 without a rounding error."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_trabecula.core.analysis import passport as p
from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import Soup
from freecad_trabecula.errors import ParameterError


def sample(name, sliced, areas, axes="xyz", morphometry=None):
    """Return what a passport reads of an analysis; one trabecula for each of ``areas``, all in the first slice."""
    sliced, areas = np.asarray(sliced, float), np.asarray(areas, float)
    counts = np.round(sliced)
    profile = SimpleNamespace(
        thickness=0.1, coordinate=0.05 + 0.1 * np.arange(len(sliced)), sliced_area=sliced, porosity=1 - sliced / 100,
        contours=counts, outer_contours=counts, holes=0 * counts, envelope_area=np.full(len(sliced), 100.0),
    )  # fmt: skip
    measures = SimpleNamespace(
        plane=np.zeros(len(areas), int), area=areas, net_area=np.where(areas > 0, areas, np.nan), is_rod=areas > 1
    )
    measured = None if morphometry is None else SimpleNamespace(
        measures=tuple(SimpleNamespace(symbol=s, value=v) for s, v in morphometry.items())
    )  # fmt: skip
    return SimpleNamespace(
        name=name, box=np.array([[0.0] * 3, [0.1 * len(sliced)] * 3]),
        parameters=SimpleNamespace(at="middle", least_area=1e-6),
        profiles=dict.fromkeys(axes, profile), measures=dict.fromkeys(axes, measures), morphometry=measured,
    )  # fmt: skip


def value(scores, of, symbol):
    return next(s.value for s in scores if (s.of, s.symbol) == (of, symbol))


@pytest.mark.parametrize("seed", range(20))
def test_identical_analyses_score_zero_and_one_exactly(seed):
    rng = np.random.default_rng(seed)
    sliced, areas = rng.uniform(3, 30, 97), rng.lognormal(0, 3, 500)
    measured = {"BV/TV": 0.19, "Conn.D": 3.3, "nought": 0.0}
    found = p.passport(*(sample(name, sliced, areas, morphometry=measured) for name in "ab"))
    for where, of, symbol, got, _ in found.rows():
        assert got == (1.0 if symbol == "r" else 0.0), (where, of, symbol)


def test_every_score_has_a_definition_and_is_finite_for_two_common_samples():
    found = p.passport(sample("a", [5, 7, 9], [1, 2, 3]), sample("b", [6, 7, 7], [1, 2]))
    assert list(found.axes) == ["x", "y", "z"]
    for scores in (*found.axes.values(), found.whole):
        assert all(len(s.definition) > 20 and math.isfinite(s.value) for s in scores)


def test_distances_of_profiles_have_their_closed_forms():
    a, b = np.array([3.0, 4.0]), np.array([3.0, 1.0])
    assert p.profile_distance(a, b, 1) == pytest.approx(3 / 7)
    assert p.profile_distance(a, b, 2) == pytest.approx(3 / 5)
    assert p.profile_distance(a, 1.1 * a, 1) == pytest.approx(0.1)
    assert p.profile_distance(a, 1.1 * a, 2) == pytest.approx(0.1)


def test_distance_from_a_profile_of_zeros_is_none_unless_both_are():
    nought = np.zeros(3)
    assert math.isnan(p.profile_distance(nought, nought + 1, 1))
    assert p.profile_distance(nought, nought, 2) == 0.0


def test_correlation_ignores_scale_and_shift_and_follows_the_sign():
    a = np.array([1.0, 5.0, 2.0, 8.0])
    assert p.correlation(a, 3 * a - 7) == pytest.approx(1.0, abs=1e-15)
    assert p.correlation(a, -a) == pytest.approx(-1.0, abs=1e-15)
    assert p.correlation(a, a[::-1]) == pytest.approx(np.corrcoef(a, a[::-1])[0, 1], abs=1e-15)


def test_correlation_with_a_constant_is_none_but_of_two_equal_constants_one():
    assert math.isnan(p.correlation(np.ones(4), np.arange(4.0)))
    assert p.correlation(np.ones(4), np.ones(4)) == 1.0


def test_kolmogorov_smirnov_has_its_values_by_hand():
    assert p.kolmogorov_smirnov(np.array([1.0, 2, 3, 4]), np.array([3.0, 4, 5, 6])) == 0.5
    assert p.kolmogorov_smirnov(np.array([1.0, 2]), np.array([3.0])) == 1.0
    assert p.kolmogorov_smirnov(np.array([1.0, 1, 2]), np.array([1.0, 2])) == pytest.approx(2 / 3 - 1 / 2)


@pytest.mark.parametrize("seed", range(5))
def test_kolmogorov_smirnov_agrees_with_another_program(seed):
    stats = pytest.importorskip("scipy.stats")
    rng = np.random.default_rng(seed)
    a, b = rng.lognormal(0, 1, 200).round(1), rng.lognormal(0.2, 1.2, 150).round(1)
    assert p.kolmogorov_smirnov(a, b) == pytest.approx(stats.ks_2samp(a, b).statistic, abs=1e-14)


def test_hellinger_has_its_values_by_hand():
    # bins five per decade: 1.1 and 1.2 share one, 2.0 and 200 have others
    assert p.hellinger(np.array([1.1, 1.2]), np.array([1.2])) == 0.0
    assert p.hellinger(np.array([1.1]), np.array([200.0])) == pytest.approx(1.0)
    expected = math.sqrt(((1 - math.sqrt(0.5)) ** 2 + 0.5) / 2)
    assert p.hellinger(np.array([1.1, 1.2]), np.array([1.2, 2.0])) == pytest.approx(expected, abs=1e-15)


def test_distributions_without_a_trabecula_are_equal_only_to_each_other():
    none, some = np.zeros(0), np.ones(2)
    for distance in (p.kolmogorov_smirnov, p.hellinger):
        assert distance(none, none) == 0.0
        assert math.isnan(distance(none, some))


def test_scores_along_an_axis_are_differences_of_second_and_first():
    found = p.passport(sample("a", [10, 20], [0.5, 3.0, -2.0]), sample("b", [13, 19], [2.0, 4.0]))
    scores = found.axes["y"]
    assert value(scores, "sliced area", "dmean") == pytest.approx(1.0)
    assert value(scores, "sliced area", "dlow") == pytest.approx(3.0)
    assert value(scores, "sliced area", "dhigh") == pytest.approx(-1.0)
    assert value(scores, "sliced area", "L1") == pytest.approx(4 / 30)
    assert value(scores, "porosity", "dmean") == pytest.approx(-0.01)
    assert value(scores, "trabecular area", "dmean area") == pytest.approx(3.0 - 1.75)  # voids are no trabeculae
    assert value(scores, "contours", "drods") == pytest.approx(1 - 1 / 3)
    assert value(found.whole, "sliced area", "L1") == pytest.approx(4 / 30)  # three axes alike


def test_morphometry_is_compared_by_ratios_of_what_both_have():
    a = sample("a", [1, 2], [1.0], morphometry={"Tb.Th": 0.2, "Conn.D": 0.0, "DA": 1.5})
    b = sample("b", [1, 2], [1.0], morphometry={"Tb.Th": 0.3, "Conn.D": 2.0})
    whole = p.passport(a, b).whole
    assert value(whole, "Tb.Th", "ratio") == pytest.approx(0.5)
    assert math.isnan(value(whole, "Conn.D", "ratio"))
    assert "DA" not in {s.of for s in whole}


def test_layers_without_a_porosity_are_left_out_of_its_scores():
    a, b = sample("a", [10, 20], [1.0], axes="x"), sample("b", [10, 30], [1.0], axes="x")
    a.profiles["x"].porosity[0] = np.nan
    scores = p.passport(a, b).axes["x"]
    assert value(scores, "porosity", "dmean") == pytest.approx(-0.1)
    a.profiles["x"].porosity[1] = np.nan
    assert math.isnan(value(p.passport(a, b).axes["x"], "porosity", "L2"))


def test_analyses_with_nothing_in_common_are_refused():
    with pytest.raises(ParameterError, match="must have an axis in common"):
        p.passport(sample("a", [1], [1.0], axes="x"), sample("b", [1], [1.0], axes="z"))
    with pytest.raises(ParameterError, match="share at least one layer of 2 mm"):
        p.passport(sample("a", [1], [1.0]), sample("b", [1], [1.0]), thickness=2.0)


def rods(*corners):
    """Triangles of boxes, given as pairs of corners."""
    faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2)]
    faces += [(2, 4, 6), (1, 3, 5), (3, 7, 5)]
    points = [[[(low, high)[n >> k & 1][k] for k in range(3)] for n in range(8)] for low, high in corners]
    return np.concatenate([np.array(eight, np.float32)[np.array(faces)] for eight in points])


def test_whole_analyses_are_scored_from_triangles_on():
    # one rod and two rods of 2 x 2 mm in boxes of the same size: sliced area along z 4 and 8 mm2 everywhere
    frame = ([0, 0, 0], [10, 1, 10])
    one = Soup(rods(frame, ([4, 4, 0], [6, 6, 10])), source="one")
    two = Soup(rods(frame, ([4, 4, 0], [6, 6, 10]), ([0, 4, 0], [2, 6, 10])), source="two")
    first, second = (analyse(soup, SliceParameters(thickness=0.25), morphometry=False) for soup in (one, two))
    found = p.passport(first, second)
    assert found.names == ("one", "two")
    scores = found.axes["z"]
    assert value(scores, "sliced area", "L1") == pytest.approx(4 / 14, rel=1e-6)
    assert value(scores, "contours", "dmean") == 1.0
    assert value(scores, "porosity", "dmean") == pytest.approx(-4 / 60, rel=1e-6)
    assert value(scores, "trabecular area", "KS") == pytest.approx(2 / 3 - 1 / 2)  # of areas 10, 4 and 10, 4, 4
    again = p.passport(first, analyse(one, SliceParameters(thickness=0.25), morphometry=False))
    assert {row[3] for row in again.rows() if row[2] != "r" and math.isfinite(row[3])} == {0.0}
    assert {row[3] for row in again.rows() if row[2] == "r"} == {1.0}
