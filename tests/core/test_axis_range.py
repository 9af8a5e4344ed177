# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ranges of axes: what differs is shown from end to end, what is equal but for rounding as a level line."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.axis_range import shown_range


@pytest.mark.parametrize("value", [1e-3, 6.0, 100.0, 4e5, -12.0])
def test_single_precision_leaves_a_level_line_in_the_middle(value):
    low, high = float(np.nextafter(np.float32(value), np.float32(-1e9))), float(np.float32(value))
    bottom, top = shown_range(low, high)
    assert (high - low) / (top - bottom) < 1e-4  # less than a pixel of any screen
    assert (value - bottom) / (top - bottom) == pytest.approx(0.5, abs=1e-3)
    assert shown_range(0.0, 0.0) == (-0.5, 0.5)


@pytest.mark.parametrize("low, high", [(0.0, 1.0), (-3.0, 5.0), (100.0, 100.01), (1e-9, 2e-9)])
def test_values_that_differ_have_the_range_for_themselves(low, high):
    assert shown_range(low, high) == (low, high)


def test_differences_are_held_against_what_was_compared():
    assert shown_range(-1e-12, 1e-12) == (-1e-12, 1e-12)
    bottom, top = shown_range(-1e-12, 1e-12, size=100.0)
    assert bottom <= -5 and top >= 5
