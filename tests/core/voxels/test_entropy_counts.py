# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of tables and designs by entropy and sampled angles: against counts of all of them."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.counting import bounded_solutions, log10_of
from freecad_trabecula.core.voxels.entropy_counts import count_by_entropy, open_sums
from freecad_trabecula.core.voxels.sampled_tables import count_tables

SHAPES = ((3, 3, 3), (4, 3, 3), (2, 3, 4), (5, 2, 3), (6, 3, 2))


def layers_by_sums(rows, columns):
    """How many 0/1 layers have each row and column sums, by number of voxels."""
    cells = rows * columns
    layers = ((np.arange(1 << cells)[:, None] >> np.arange(cells)) & 1).reshape(-1, rows, columns)
    found = {}
    for key, count in Counter(map(tuple, np.hstack([layers.sum(2), layers.sum(1)]).tolist())).items():
        found.setdefault(sum(key[:rows]), []).append((np.array(key), count))
    return found


def designs(sums):
    """How many designs have these sums along z, y, x: layer by layer, with what the other axes still need."""
    layers = layers_by_sums(len(sums[1]), len(sums[2]))
    ways = {tuple(np.concatenate(sums[1:]).tolist()): 1}
    for voxels in sums[0]:
        further = Counter()
        for rest, count in ways.items():
            for key, number in layers.get(int(voxels), ()):
                left = np.array(rest) - key
                if (left >= 0).all():
                    further[tuple(left.tolist())] += count * number
        ways = further
    return ways.get((0,) * (len(sums[1]) + len(sums[2])), 0)


def sums_of(voxels):
    axes = range(voxels.ndim)
    return [voxels.sum(tuple(a for a in axes if a != k)) for k in axes]


def test_the_stated_error_covers_the_number_of_designs_as_often_as_it_says():
    off = []
    for seed in range(40):
        shape = SHAPES[seed % len(SHAPES)]
        draws = Stream(seed, "box").many(math.prod(shape) + 1)
        sums = sums_of((draws[1:].reshape(shape) < 0.3 + 0.4 * draws[0]).astype(int))
        found = count_by_entropy(sums, 1, Stream(seed, "count"), samples=20_000)
        if found is not None and found.samples:
            off.append((found.log10 - math.log10(designs(sums))) / max(found.standard_error, 1e-9))
    assert len(off) >= 30
    # of n intervals of one (two) standard errors a normal law covers 68 % (95 %), give or take 0.5 / sqrt(n)
    assert np.mean(np.abs(off) < 1) == pytest.approx(0.68, abs=0.2)
    assert np.mean(np.abs(off) < 2) >= 0.88


def test_two_rows_are_one_equation():
    columns = np.array([5, 4, 6, 3])
    found = count_by_entropy([np.array([7, 11]), columns], 6, Stream(1, "t"))
    # the first row decides the second: x_j from 0 to the column's sum
    assert found.log10 == pytest.approx(log10_of(bounded_solutions(7, columns.tolist())), abs=4 * found.standard_error)
    assert found.standard_error < 0.05


def test_samples_that_differ_too_much_say_nothing():
    # two rows of many columns are far from Gaussian: no number is better than a wrong one
    columns = np.array([3, 5, 2, 4, 6, 1, 7, 2])
    assert count_by_entropy([np.array([15, 15]), columns], 7, Stream(1, "t")) is None


def test_a_large_table_agrees_with_the_one_drawn_row_by_row():
    rows, columns = (
        np.array([30, 42, 55, 41, 22, 50] * 3),
        np.array([48, 40, 60, 62, 38, 40, 72, 50, 60, 50, 0]),
    )
    columns[-1] = rows.sum() - columns[:-1].sum()
    by_angles = count_by_entropy([rows, columns], 12, Stream(1, "angles"))
    by_rows = count_tables(rows, columns, 12, 600, Stream(1, "rows"))
    apart = abs(by_angles.log10 - by_rows.log10)
    assert apart < 4 * math.hypot(by_angles.standard_error, by_rows.standard_error)


def test_layers_that_are_empty_or_full_are_left_out():
    left = open_sums([np.array([0, 4, 2]), np.array([1, 2, 2, 1])], 1)
    assert not any(len(part) for part in left)  # row 1 is full, so columns 0 and 3 have all they ask for, 1 and 2 too
    assert count_by_entropy([np.array([0, 4, 4]), np.array([2, 2, 2, 2])], 1, Stream(1, "t")).log10 == 0


def test_sums_that_leave_some_cells_no_choice_are_not_counted_wrong():
    # two rows and two columns of 3: their four cells are full, the opposite four empty; 2 x 2 choices are left
    found = count_by_entropy([np.array([3, 3, 1, 1]), np.array([3, 3, 1, 1])], 1, Stream(1, "t"))
    assert found is None or found.log10 == pytest.approx(math.log10(4), abs=4 * found.standard_error)
