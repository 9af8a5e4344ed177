# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of tables, estimated, against lists of all of them."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.counting import bounded_solutions, log10_of
from freecad_trabecula.core.voxels.sampled_tables import count_tables


def tables(rows, columns, cap):
    """How many there are: column by column, with what the rows still need."""
    ways = {tuple(rows): 1}
    for total in columns:
        further = {}
        choices = [x for x in itertools.product(range(cap + 1), repeat=len(rows)) if sum(x) == total]
        for rest, count in ways.items():
            for choice in choices:
                left = tuple(r - c for r, c in zip(rest, choice))
                if min(left) >= 0:
                    further[left] = further.get(left, 0) + count
        ways = further
    return ways.get((0,) * len(rows), 0)


@pytest.mark.parametrize(
    ("rows", "columns", "cap"),
    [
        ([5, 4, 6], [4, 3, 5, 3], 4),
        ([7, 2, 6, 5], [5, 5, 5, 5], 3),
        ([9, 1, 5], [6, 6, 3], 6),
        ([4, 4, 4, 4], [1, 2, 3, 4, 6], 2),
        ([0, 5, 4], [3, 0, 3, 3], 3),
    ],
)
def test_the_estimate_is_within_four_standard_errors_of_the_number(rows, columns, cap):
    exact = tables(rows, columns, cap)
    found = count_tables(np.array(rows), np.array(columns), cap, 3000, Stream(1, "tables"))
    assert found.log10 == pytest.approx(math.log10(exact) if exact else -math.inf, abs=4 * found.standard_error + 1e-9)
    assert found.standard_error < 0.02


def test_sums_without_a_table_count_nothing():
    assert count_tables(np.array([4, 0]), np.array([3, 1]), 2, 50, Stream(1, "t")).log10 == -math.inf
    assert count_tables(np.array([4, 0]), np.array([3, 2]), 9, 50, Stream(1, "t")).log10 == -math.inf


def test_one_row_has_one_table():
    assert count_tables(np.array([6]), np.array([1, 2, 3]), 4, 50, Stream(1, "t")).log10 == pytest.approx(0)


def test_two_rows_are_one_equation():
    # with two rows the first determines the second: x_j between 0 and the column's sum
    columns = np.array([3, 5, 2, 4, 6, 1, 7, 2])
    found = count_tables(np.array([15, 15]), columns, 7, 2000, Stream(1, "t"))
    assert found.log10 == pytest.approx(log10_of(bounded_solutions(15, columns.tolist())), abs=4 * found.standard_error)
