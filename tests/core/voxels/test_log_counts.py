# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimates of large numbers from weights."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freecad_trabecula.core.voxels.log_counts import LogCount, log_count, product


def test_the_mean_of_weights_too_large_for_a_float():
    found = log_count(np.array([5000.0, 5000.0 + math.log(3)]))
    assert found.log10 == pytest.approx((5000 + math.log(2)) / math.log(10))
    assert found.effective == pytest.approx(16 / 10)
    assert found.standard_error == pytest.approx(0.5 / math.log(10))


def test_samples_that_are_no_solutions_count_as_zeros():
    assert log_count(np.array([math.log(100), -math.inf])).log10 == pytest.approx(math.log10(50))
    assert log_count(np.array([-math.inf, -math.inf])).log10 == -math.inf


def test_logarithms_of_factors_add_and_errors_add_as_squares():
    both = product([LogCount(2.0, 0.3, 10, 9.0), LogCount(5.0, 0.4, 10, 8.0)])
    assert (both.log10, both.standard_error, both.effective) == (7.0, pytest.approx(0.5), 8.0)
