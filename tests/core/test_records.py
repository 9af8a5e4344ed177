# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records: dataclasses to plain values and back, with an error that says where for everything that does not fit."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Optional, Tuple

import pytest

from freecad_trabecula.core.records import from_record, to_record
from freecad_trabecula.errors import ParameterError


@dataclass(frozen=True)
class Inner:
    length: float = 1.0

    def __post_init__(self):
        if self.length < 0:
            raise ParameterError(f"length must be at least 0, got {self.length:g} mm")


@dataclass(frozen=True)
class Outer:
    count: int = 2
    word: str = "a"
    on: bool = True
    point: Tuple[float, float, float] = (0.0, 0.0, 0.0)
    maybe: Optional[Tuple[float, float, float]] = None
    inner: Inner = Inner()
    inners: Tuple[Inner, ...] = ()


FULL = Outer(3, "b", False, (1.0, 2.0, 3.0), (4.0, 5.0, 6.0), Inner(7.0), (Inner(8.0), Inner()))


def test_a_record_gives_back_what_it_was_made_of():
    for everything in (False, True):
        record = json.loads(json.dumps(to_record(FULL, everything)))
        assert from_record(Outer, record, "x") == FULL


def test_defaults_are_left_out_and_come_back():
    assert to_record(Outer()) == {}
    assert from_record(Outer, {}, "x") == Outer()


def test_everything_names_every_field():
    record = to_record(Outer(), everything=True)
    assert set(record) == set(Outer.__dataclass_fields__)
    assert record["inner"] == {"length": 1.0}


def test_a_whole_number_is_taken_for_a_number_but_not_the_reverse():
    assert from_record(Outer, {"inner": {"length": 3}}, "x").inner == Inner(3.0)
    with pytest.raises(ParameterError, match=r"x\.count must be a whole number, got 2\.5 \(float\)"):
        from_record(Outer, {"count": 2.5}, "x")


def test_null_is_nothing_only_where_nothing_is_allowed():
    assert from_record(Outer, {"maybe": None}, "x").maybe is None
    with pytest.raises(ParameterError, match=r"x\.count must be a whole number, got None"):
        from_record(Outer, {"count": None}, "x")


@pytest.mark.parametrize(
    ("record", "message"),
    [
        ({"kount": 2}, r"x has no key 'kount'; known are count, word, on, point, maybe, inner, inners"),
        ({"inner": {"lenght": 2}}, r"x\.inner has no key 'lenght'; known are length"),
        ({"inners": [{}, {"a": 1}]}, r"x\.inners\[1\] has no key 'a'"),
        ({"count": "2"}, r"x\.count must be a whole number, got '2' \(str\)"),
        ({"count": True}, r"x\.count must be a whole number, got True \(bool\)"),
        ({"inner": {"length": True}}, r"x\.inner\.length must be a number, got True"),
        ({"inner": 3}, r"x\.inner must be an object with keys, got 3 \(int\)"),
        ({"on": 1}, r"x\.on must be true or false, got 1 \(int\)"),
        ({"word": 1}, r"x\.word must be a text, got 1 \(int\)"),
        ({"point": [1, 2]}, r"x\.point must have 3 values, got 2"),
        ({"point": "123"}, r"x\.point must be a list, got '123'"),
        ({"point": [1, 2, "c"]}, r"x\.point\[2\] must be a number, got 'c'"),
        ({"inners": {}}, r"x\.inners must be a list, got {}"),
        ({"inner": {"length": -1}}, r"x\.inner: length must be at least 0, got -1 mm"),
        ({"inner": {"length": 10**400}}, r"x\.inner\.length must be a number a computer can hold"),
        ([], r"x must be an object with keys, got \[\] \(list\)"),
        (None, r"x must be an object with keys, got None"),
    ],
)
def test_what_does_not_fit_is_refused_with_its_place(record, message):
    with pytest.raises(ParameterError, match=message):
        from_record(Outer, record, "x")


def test_a_long_value_is_cut_in_the_message():
    with pytest.raises(ParameterError) as error:
        from_record(Outer, {"count": "9" * 10_000}, "x")
    assert len(str(error.value)) < 200
