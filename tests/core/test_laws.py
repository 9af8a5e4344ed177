# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laws of variation against their closed forms."""

import numpy as np
import pytest

from freecad_trabecula.core.laws import Law, Region, constant, evaluate_expression, parse_expression, uniform
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.errors import ParameterError

CUBE = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))


def draws(law, count=20_000, point=(1.0, 2.0, 3.0)):
    return law.draw(Stream(5, "law"), count, np.array(point), CUBE)


def test_uniform_law_follows_equation_2_4():
    values = draws(uniform(0.2, 0.8))
    assert (values == 0.2 + (0.8 - 0.2) * Stream(5, "law").uniform(20_000)).all()
    assert values.mean() == pytest.approx(0.5, abs=4 * 0.6 / 12**0.5 / 20_000**0.5)


def test_normal_law_has_its_mean_and_stays_within_three_standard_deviations():
    values = draws(Law("normal", 0.2, 0.8))
    assert values.min() >= 0.2 and values.max() <= 0.8
    assert values.mean() == pytest.approx(0.5, abs=0.004)
    # variance of a normal law cut at 3 sd: 1 - 6 phi(3) / (2 Phi(3) - 1) = 0.97334
    assert values.std() == pytest.approx(0.1 * 0.97334**0.5, rel=0.03)


@pytest.mark.parametrize("z, value", [(0.0, 0.2), (5.0, 0.5), (10.0, 0.8)])
def test_linear_law_runs_from_low_to_high_along_its_direction(z, value):
    assert draws(Law("linear", 0.2, 0.8), 1, (3.0, 1.0, z))[0] == pytest.approx(value)


def test_linear_law_may_fall():
    assert draws(Law("linear", 0.8, 0.2, direction=(1, 0, 0)), 1, (10.0, 0, 0))[0] == pytest.approx(0.2)


def test_radial_law_is_low_at_the_centre_and_high_in_the_corner():
    law = Law("radial", 0.2, 0.8)
    assert draws(law, 1, (5.0, 5.0, 5.0))[0] == pytest.approx(0.2)
    assert draws(law, 1, (10.0, 10.0, 10.0))[0] == pytest.approx(0.8)
    assert draws(law, 1, (10.0, 5.0, 5.0))[0] == pytest.approx(0.2 + 0.6 / 3**0.5)


def test_expression_sees_place_and_random_number():
    law = Law("expression", 0.0, 10.0, expression="x + 10*y - z**2 + u")
    random = Stream(5, "law").uniform(3)
    assert draws(law, 3, (4.0, 0.5, 2.0)) == pytest.approx(4 + 5 - 4 + random)


def test_expression_is_clipped_to_its_bounds():
    assert draws(Law("expression", 0.2, 0.8, expression="100*u - 50"), 200).min() == 0.2


@pytest.mark.parametrize(
    "text, value",
    [("sqrt(x)+abs(-y)", 4.0), ("min(x, y) % 3", 2.0), ("-pi*0 + max(1, 2)", 2.0), ("hypot(3, 4)", 5.0)],
)
def test_expression_functions_have_their_usual_meaning(text, value):
    assert evaluate_expression(text, np.array([4.0, 2.0, 0.0]), np.zeros(1))[0] == pytest.approx(value)


@pytest.mark.parametrize("kind", ["constant", "uniform", "normal", "linear", "radial", "expression"])
def test_every_law_takes_one_number_per_value(kind):
    stream = Stream(1, "one")
    Law(kind, 0.2, 0.8, expression="u").draw(stream, 3, np.zeros(3), CUBE)
    assert stream.uniform(1)[0] == Stream(1, "one").uniform(4)[3]


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').system('x')", "x.__class__", "[1,2]", "lambda: 1", "'a'", "open(x)", "x if x else y", "",
        "x = 1", "q + 1", "sin", "(" * 300, "x" * 501, "True", "x << 2", "sin(x, out=y)", "1j",
    ],
)  # fmt: skip
def test_anything_but_a_formula_is_refused(text):
    with pytest.raises(ParameterError):
        evaluate_expression(text, np.zeros(3), np.zeros(1))


@pytest.mark.parametrize("text", ["1/x", "log(x)", "sqrt(-1)", "10**400", "9**9**9", "sin(1, 2, 3)"])
def test_a_formula_without_a_finite_value_is_refused_and_named(text):
    with pytest.raises(ParameterError, match="expression"):
        evaluate_expression(text, np.zeros(3), np.zeros(1))


@pytest.mark.parametrize("low, high", [(0.8, 0.2), (float("nan"), 1.0), (0.0, float("inf"))])
def test_bounds_upside_down_or_not_finite_are_refused(low, high):
    with pytest.raises(ParameterError, match="bounds"):
        Law("uniform", low, high)


def test_unknown_kind_and_zero_direction_are_refused():
    with pytest.raises(ParameterError, match="one of"):
        Law("gaussian", 0, 1)
    with pytest.raises(ParameterError, match="direction"):
        Law("linear", 0, 1, direction=(0, 0, 0))


def test_range_is_what_the_law_can_give():
    assert constant(3.0).range == (3.0, 3.0)
    assert Law("linear", 0.8, 0.2).range == (0.2, 0.8)
    assert parse_expression("x") is not None
