# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dataclasses with arrays to JSON and back."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any, Dict, NamedTuple, Optional, Tuple

import numpy as np
import pytest

from freecad_trabecula.core.analysis.json_values import from_values, to_values, values_json
from freecad_trabecula.errors import ParameterError


class Pair(NamedTuple):
    name: str
    value: float


@dataclass(frozen=True)
class Inner:
    count: int
    on: bool = True


@dataclass(frozen=True)
class Outer:
    name: str
    size: float
    numbers: np.ndarray
    inner: Inner
    pairs: Tuple[Pair, ...] = ()
    range: Tuple[float, float] = (0.0, 1.0)
    more: Optional[Inner] = None
    table: Dict[str, float] = None  # type: ignore[assignment]
    free: Any = None


OUTER = Outer(
    "µ", math.nan, np.array([[1.5, math.nan], [3, 4]]), Inner(3, False), (Pair("a", 1.0), Pair("b", math.inf)),
    (-1.0, 2.0), Inner(1), {"k": 2.0}, [1, "x"],
)  # fmt: skip


def through_text(value):
    return json.loads(values_json(to_values(value)))


def test_a_dataclass_comes_back_from_its_text():
    found = from_values(Outer, through_text(OUTER), "here")
    assert (found.name, found.inner, found.range, found.more) == ("µ", Inner(3, False), (-1.0, 2.0), Inner(1))
    assert math.isnan(found.size)
    assert np.array_equal(found.numbers, OUTER.numbers, equal_nan=True)
    assert found.pairs[0] == Pair("a", 1.0)
    assert math.isnan(found.pairs[1].value)  # JSON has no infinity: what is no number is none
    assert found.table == {"k": 2.0} and found.free == [1, "x"]


def test_keys_that_are_missing_take_the_default_and_unknown_ones_are_passed_over():
    values = {"name": "a", "size": 1, "numbers": [1, 2], "inner": {"count": 1, "later": 5}, "extra": 3}
    found = from_values(Outer, values, "here")
    assert found.pairs == () and found.more is None and found.inner == Inner(1)
    assert found.numbers.dtype.kind == "i"


def test_arrays_of_bools_stay_bools():
    assert from_values(Outer, through_text(OUTER), "here").inner.on is False
    assert to_values(np.array([True, False])) == [True, False]
    assert to_values(np.float64(2.5)) == 2.5 and to_values(np.int64(2)) == 2


def test_lists_of_numbers_stand_in_one_line():
    text = values_json({"a": [1.5, -2e-7, None, True], "b": ["x", "y, [1]"], "c": [[1, 2], [3, 4]], "d": []})
    assert json.loads(text) == {"a": [1.5, -2e-7, None, True], "b": ["x", "y, [1]"], "c": [[1, 2], [3, 4]], "d": []}
    assert '"a": [1.5, -2e-07, null, true]' in text
    assert "[1, 2]" in text


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"name": 3}, "here.name must be a text, got 3"),
        ({"size": "1"}, "here.size must be a number, got '1'"),
        ({"size": True}, "here.size must be a number"),
        ({"numbers": "12"}, "here.numbers must be a list of numbers"),
        ({"numbers": [[1], [2, 3]]}, "here.numbers must be a list of numbers"),
        ({"numbers": ["a"]}, "here.numbers must be a list of numbers"),
        ({"inner": 5}, "here.inner must be an object"),
        ({"inner": {"count": 1.5}}, "here.inner.count must be a whole number, got 1.5"),
        ({"inner": {"count": True}}, "here.inner.count must be a whole number"),
        ({"inner": {"count": 1, "on": 1}}, "here.inner.on must be true or false"),
        ({"inner": {}}, "here.inner is incomplete: .*count"),
        ({"range": [1.0]}, "here.range must be a list"),
        ({"pairs": {}}, "here.pairs must be a list"),
        ({"table": [1]}, "here.table must be an object"),
    ],
)
def test_wrong_values_are_named_with_their_place(change, message):
    values = {"name": "a", "size": 1.0, "numbers": [1.0], "inner": {"count": 1}, **change}
    with pytest.raises(ParameterError, match=message):
        from_values(Outer, values, "here")
