# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimates of large numbers from weights."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.log_counts import LogCount, log_count, product


def test_the_mean_of_weights_too_large_for_a_float():
    found = log_count(np.array([5000.0, 5000.0 + math.log(3)]))
    assert found.log10 == pytest.approx((5000 + math.log(2)) / math.log(10))
    assert found.effective == pytest.approx(16 / 10)
    # without one of them the mean is 3 or 1 (times e^5000): half the distance of the logarithms
    assert found.standard_error == pytest.approx(math.log10(3) / 2)


def test_samples_that_are_no_solutions_count_as_zeros():
    assert log_count(np.array([math.log(100), -math.inf])).log10 == pytest.approx(math.log10(50))
    assert log_count(np.array([-math.inf, -math.inf])).log10 == -math.inf


def test_one_weight_that_is_all_has_no_known_error():
    assert math.isnan(log_count(np.array([0.0, -math.inf, -math.inf])).standard_error)
    assert math.isnan(log_count(np.array([0.0])).standard_error)


def test_the_error_of_many_like_weights_is_that_of_their_mean():
    weights = 1.0 + 0.1 * np.sin(np.arange(1000.0))
    expected = weights.std(ddof=1) / math.sqrt(1000) / weights.mean() / math.log(10)
    assert log_count(np.log(weights)).standard_error == pytest.approx(expected, rel=1e-3)


def test_logarithms_of_factors_add_and_errors_add_as_squares():
    both = product([LogCount(2.0, 0.3, 10, 9.0), LogCount(5.0, 0.4, 10, 8.0)])
    # exp(X) of a normal X has the mean exp(s^2 / 2): what the logarithms of means lie low by
    low = 0.5 * (0.5 * math.log(10)) ** 2 / math.log(10)
    assert (both.log10, both.standard_error, both.effective) == (pytest.approx(7.0 + low), pytest.approx(0.5), 8.0)


def test_products_of_many_estimates_are_right_on_average():
    # 200 factors, each the mean of five weights whose mean is 1: log10 of the product is 0
    draws = Stream(3, "test").many(60 * 200 * 5).reshape(60, 200, 5)
    found = [product([log_count(np.log(0.2 + 1.6 * w)) for w in factors]) for factors in draws]
    off = np.array([f.log10 / f.standard_error for f in found])
    assert abs(np.mean(off)) < 3 / math.sqrt(len(off)) + 0.15
    assert np.mean(np.abs(off) < 1) == pytest.approx(0.68, abs=0.2)
