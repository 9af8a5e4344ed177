# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables with given sums: exact, within their caps, without dead ends."""

from __future__ import annotations

import itertools
from collections import Counter

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.tables import (
    capped_ranks,
    draw_row,
    fits,
    levelling_row,
    partner_ranks,
    solve_table,
    solve_thesis_table,
    start_near,
    table_errors,
)
from freecad_trabecula.errors import InfeasibleError, ParameterError

ROWS = np.array([9, 7, 5, 3, 6])
COLUMNS = np.array([8, 8, 8, 6])


@pytest.mark.parametrize("solver", ["thesis", "proportional"])
@pytest.mark.parametrize("cap", [5, 3])
def test_a_table_has_its_sums_and_keeps_its_cap(solver, cap):
    for seed in range(30):
        table = solve_table(ROWS, COLUMNS, capped_ranks(ROWS, 4, cap), solver, Stream(seed, "t"))
        assert table_errors(table.cells, ROWS, COLUMNS, cap) == []


def test_the_thesis_own_routine_is_right_when_it_comes_to_its_end():
    tables = [solve_thesis_table(ROWS, COLUMNS, 5, Stream(seed, "t")) for seed in range(30)]
    done = [t for t in tables if t is not None]
    assert done
    assert all(table_errors(t, ROWS, COLUMNS, 5) == [] for t in done)


def test_minima_that_see_one_column_at_a_time_run_into_dead_ends_and_the_guarded_solver_does_not():
    # the second row is empty, so that both columns of two need one in the first
    rows, columns, cap = np.array([3, 0, 3]), np.array([2, 2, 1, 1]), 1
    plain = [solve_thesis_table(rows, columns, cap, Stream(seed, "d")) for seed in range(40)]
    assert sum(table is None for table in plain) > 10
    for seed in range(40):
        table = solve_table(rows, columns, capped_ranks(rows, 4, cap), "thesis", Stream(seed, "d"))
        assert table_errors(table.cells, rows, columns, cap) == []
        assert table.cells[0, :2].tolist() == [1, 1]


def test_unit_increments_at_once_have_the_law_of_increments_one_by_one():
    # two units into three cells with room for 1, 2, 2: by hand, a full cell being drawn again
    law = {(1, 1, 0): 1 / 3, (1, 0, 1): 1 / 3, (0, 2, 0): 1 / 9, (0, 0, 2): 1 / 9, (0, 1, 1): 2 / 9}
    law[(1, 1, 0)] = law[(1, 0, 1)] = 1 / 3 * 1 / 2 + 1 / 3 * 1 / 3
    low, high = np.zeros(3, int), np.array([1, 2, 2])
    drawn = Counter(tuple(draw_row(2, low, high, np.ones(3, int), Stream(s, "law"))) for s in range(9000))
    total = sum(law.values())
    assert total == pytest.approx(1)
    for row, chance in law.items():
        assert abs(drawn[row] / 9000 - chance) < 5 * np.sqrt(chance * (1 - chance) / 9000)


def test_rows_in_proportion_follow_their_weights():
    weights = np.array([1, 2, 7])
    rows = sum(draw_row(1, np.zeros(3, int), np.full(3, 9), weights, Stream(s, "w")) for s in range(3000))
    assert np.abs(rows / 3000 - weights / 10).max() < 0.05


def test_ranks_of_a_partner_are_the_condition_of_gale_and_ryser():
    # every pair of rows of two and three cells: held against all 0/1 matrices
    matrices = [np.array(bits).reshape(3, 2) for bits in itertools.product((0, 1), repeat=6)]
    exist = {(tuple(m.sum(0)), tuple(m.sum(1))) for m in matrices}
    for alpha in itertools.product(range(4), repeat=2):
        for beta in itertools.product(range(3), repeat=3):
            if sum(alpha) == sum(beta):
                ranks = partner_ranks(np.array([alpha]), 3, 2)[0]
                assert fits(np.array(beta), ranks) == ((alpha, beta) in exist)


def test_the_levelling_row_leaves_the_most_level_rest():
    rest, ranks = np.array([5, 3, 3, 1]), np.array([2, 3, 4, 4])
    row = levelling_row(rest, 4, ranks)
    left = sorted(rest - row)
    for other in itertools.product(range(3), repeat=4):
        other = np.array(other)
        if other.sum() == 4 and fits(other, ranks) and (other <= rest).all():
            assert sum(x * x for x in left) <= ((rest - other) ** 2).sum()


def test_a_row_near_a_wish_is_the_wish_where_that_is_possible():
    wish, low, high = np.array([3, 0, 2]), np.zeros(3, int), np.full(3, 4)
    assert start_near(wish, 5, low, high, Stream(1, "n")).tolist() == [3, 0, 2]
    assert start_near(wish, 4, low, high, Stream(1, "n")).sum() == 4


def test_the_same_seed_gives_the_same_table():
    first, again, other = (
        solve_table(ROWS, COLUMNS, capped_ranks(ROWS, 4, 5), "thesis", Stream(s, "t")).cells for s in (1, 1, 2)
    )
    assert (first == again).all() and (first != other).any()


# ------------------------------------------------------------------------------------------------------- refusals


def test_every_wrong_sum_and_cell_of_a_table_is_named():
    table = np.array([[1, 2], [3, 9]])
    errors = table_errors(table, np.array([3, 11]), np.array([4, 11]), 5)
    assert [e.words for e in errors] == [
        "row 1 sums to 12, asked for 11",
        "cell (1, 1) is 9, beyond its bound 5",
    ]


def test_sums_without_a_table_are_refused():
    with pytest.raises(InfeasibleError, match="the 1 fullest columns ask for 5, and the rows can give them 3"):
        solve_table(np.array([3, 3, 0]), np.array([5, 1]), np.array([[1, 3], [1, 3], [1, 0]]), "thesis", Stream(1, "t"))
    with pytest.raises(InfeasibleError, match="must agree, got 30 and 31"):
        solve_table(ROWS, COLUMNS + [1, 0, 0, 0], capped_ranks(ROWS, 4, 5), "thesis", Stream(1, "t"))


def test_a_table_of_another_size_is_refused():
    with pytest.raises(ParameterError, match="must have 5 rows and 4 columns"):
        table_errors(np.zeros((4, 5), int), ROWS, COLUMNS, 5)


def test_a_row_between_bounds_that_do_not_allow_its_sum_is_none():
    assert draw_row(5, np.zeros(2, int), np.array([2, 2]), np.ones(2, int), Stream(1, "t")) is None
