# SPDX-License-Identifier: LGPL-2.1-or-later
"""How variants spread, and their table."""

import csv
import io
import math
import statistics

import numpy as np
import pytest

from freecad_trabecula.core.variants import MOST, Variant, Variants, seeds_from, spread
from freecad_trabecula.errors import ParameterError


def test_the_spread_is_that_of_a_sample():
    values = [43.4, 42.2, 34.7, 36.1]
    found = spread(values)
    assert found.mean == pytest.approx(statistics.mean(values))
    assert found.sd == pytest.approx(statistics.stdev(values))
    assert (found.least, found.greatest, found.count) == (34.7, 43.4, 4)


def test_one_variant_has_no_deviation_and_none_no_spread():
    assert math.isnan(spread([1.0]).sd)
    with pytest.raises(ParameterError, match="at least 1 value, got 0"):
        spread([])


def test_seeds_are_consecutive_and_bounded():
    assert seeds_from(3, 4) == [3, 4, 5, 6]
    for first, count, words in ((1, 0, "1 to 200, got 0"), (1, MOST + 1, "got 201"), (-1, 2, "got -1 to 0"),
                                (2**31 - 2, 3, "got 2147483646 to 2147483648")):  # fmt: skip
        with pytest.raises(ParameterError, match=words):
            seeds_from(first, count)
    assert seeds_from(2**31 - 2, 2) == [2147483646, 2147483647]


def test_the_table_has_a_row_a_variant_and_the_overlaps():
    rows = tuple(Variant(seed, {"a": seed + 0.5, "b": 1.0}, np.zeros((2, 2), np.uint8)) for seed in (7, 8))
    found = Variants("voxels", "a", rows, np.array([[1.0, 0.25], [0.25, 1.0]]), 0.2)
    table = list(csv.DictReader(io.StringIO(found.csv())))
    assert [float(row["a"]) for row in table] == [7.5, 8.5]
    assert [float(row["overlap with seed 8"]) for row in table] == [0.25, 1.0]
    assert found.values("b").tolist() == [1.0, 1.0]
