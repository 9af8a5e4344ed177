# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of the command line to values."""

from __future__ import annotations

import argparse

import pytest

from freecad_trabecula.shell.option_values import axes, heights, number, pair, value_range, whole_number


def test_texts_become_values():
    assert whole_number("-3") == -3 and number("1e-2") == 0.01
    assert pair(" A : B ") == "A:B"
    assert axes("x,y") == ["x", "y"] and axes("1,0,-2") == ["1.0,0.0,-2.0"]
    assert heights("1,2") == [1, 2] and value_range(":3") == [None, 3]


@pytest.mark.parametrize(
    ("read", "text"),
    [
        *((whole_number, "1.0"), (whole_number, ""), (number, "one"), (number, "-inf"), (number, "NaN")),
        *((pair, "A"), (pair, "A:"), (pair, "A:B:C"), (axes, "xq"), (axes, "1,2,3,4"), (axes, ",")),
        *((heights, ""), (heights, "1;2"), (value_range, "1-2"), (value_range, "a:b"), (value_range, ":")),
    ],
)
def test_what_is_no_value_is_refused_with_the_text(read, text):
    with pytest.raises(argparse.ArgumentTypeError, match="must"):
        read(text)
