# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables alpha and beta: whole numbers with given row and column sums (systems 6.5 and 6.9).

A table is solved row by row as in the thesis (6.2.3): unit increments of random cells between the row's minima (6.17)
and maxima. What the thesis lacks: a row is kept only when the rest still has a solution. Which vectors a row may be is
given by its ``ranks``: the most that any k cells of it hold together, k = 1 .. columns. A table has ranks
min(row sum, k cap); for beta under a given alpha they follow from Gale and Ryser, so that compatible pairs and capped
tables are one problem. Rows whose ranks are concave are polymatroids, and so is their sum: a solution exists if and
only if the k largest column sums are at most the sum of the ranks, for every k.

In this module tables are (rows, columns) = (P, N) or (P, M), bottom layer first; ``alpha`` and ``beta`` elsewhere are
their transposes, (N, P) and (M, P).
"""

from __future__ import annotations

from typing import List, NamedTuple, Optional, Union

import numpy as np

from ...errors import ExactnessError, InfeasibleError
from ..parameters import require
from ..progress import Progress, silent
from ..streams import Stream
from .parameters import SOLVERS

REDRAWS = 5  # of a row after which the rest has no solution; then the row that levels the rest is taken


class Table(NamedTuple):
    """A solved table and what it took.

    Attributes
    ----------
    cells : ndarray of shape (rows, columns), int64
    redrawn : int
        Rows that were drawn again because the rest would have had no solution.
    levelled : int
        Rows that were not drawn at all for that reason, but level the rest.
    """

    cells: np.ndarray
    redrawn: int
    levelled: int


class SumError(NamedTuple):
    """A sum of a table, or a cell, that breaks a rule.

    Attributes
    ----------
    kind : str
        ``row``, ``column`` or ``cell``.
    row, column : int
        -1 where it does not apply.
    asked, got : int
        For a cell: the nearer bound, and its value.
    """

    kind: str
    row: int
    column: int
    asked: int
    got: int

    @property
    def words(self) -> str:
        """The violation as a sentence."""
        if self.kind == "cell":
            return f"cell ({self.column}, {self.row}) is {self.got}, beyond its bound {self.asked}"
        which = self.row if self.kind == "row" else self.column
        return f"{self.kind} {which} sums to {self.got}, asked for {self.asked}"


def table_errors(
    cells: np.ndarray, rows: np.ndarray, columns: np.ndarray, cap: Union[int, np.ndarray]
) -> List[SumError]:
    """Return every row sum, column sum and cell that breaks a rule.

    Parameters
    ----------
    cells : ndarray of shape (rows, columns), int
    rows, columns : ndarrays of int
        Sums asked for.
    cap : int, or ndarray of shape (rows, columns)
        Most in a cell.
    """
    shape = (len(rows), len(columns))
    require(cells.shape == shape, f"the table must have {shape[0]} rows and {shape[1]} columns", cells.shape)
    got_rows, got_columns = cells.sum(1), cells.sum(0)
    errors = [SumError("row", int(i), -1, int(rows[i]), int(got_rows[i])) for i in np.flatnonzero(got_rows != rows)]
    errors += [
        SumError("column", -1, int(j), int(columns[j]), int(got_columns[j]))
        for j in np.flatnonzero(got_columns != columns)
    ]
    caps = np.broadcast_to(cap, shape)
    for i, j in np.argwhere((cells < 0) | (cells > caps)):
        value, most = int(cells[i, j]), int(caps[i, j])
        errors.append(SumError("cell", int(i), int(j), most if value > most else 0, value))
    return errors


# ---------------------------------------------------------------------------------------------------------- the ranks


def capped_ranks(rows: np.ndarray, count: int, cap: int) -> np.ndarray:
    """Return the ranks of rows whose cells hold up to a cap, ndarray of shape (rows, count): min(row, k cap)."""
    return np.minimum(np.asarray(rows)[:, None], np.arange(1, count + 1)[None, :] * cap)


def partner_ranks(partner: np.ndarray, count: int, cap: int) -> np.ndarray:
    """Return the ranks of the rows that are compatible with those of another table, ndarray of shape (rows, count).

    Parameters
    ----------
    partner : ndarray of shape (rows, lines), int
        The other table, e.g. alpha (P, N): entry (i, j) says how many of the ``count`` cells line j of layer i takes.
    count : int
        Columns of the table sought.
    cap : int
        Most in a cell of it.

    Notes
    -----
    k cells of row i hold at most sum_j min(partner_ij, k) (Gale and Ryser), and at most k caps.

    Examples
    --------
    >>> partner_ranks(np.array([[3, 1]]), 3, 2).tolist()
    [[2, 3, 4]]
    >>> partner_ranks(np.array([[3, 1]]), 3, 1).tolist()
    [[1, 2, 3]]
    """
    rows, lines = partner.shape
    takes = np.zeros((rows, count + 1), np.int64)
    np.add.at(takes, (np.repeat(np.arange(rows), lines), np.minimum(partner, count).ravel()), 1)
    at_least = takes[:, ::-1].cumsum(1)[:, ::-1][:, 1:]  # lines that take k or more, k = 1 .. count
    return np.minimum(at_least.cumsum(1), np.arange(1, count + 1) * cap)


def fits(sums: np.ndarray, ranks: np.ndarray) -> bool:
    """Return whether the k largest sums are at most ranks[k - 1], for every k."""
    return bool((np.sort(sums)[::-1].cumsum() <= ranks).all())


# --------------------------------------------------------------------------------------------------------- the solver


def solve_table(
    rows: np.ndarray,
    columns: np.ndarray,
    ranks: np.ndarray,
    solver: str,
    stream: Stream,
    progress: Progress = silent,
    wish: Optional[np.ndarray] = None,
) -> Table:
    """Return a random table with the given sums, each row within its ranks; it never runs into a dead end.

    Parameters
    ----------
    rows : ndarray of shape (R,), int
    columns : ndarray of shape (K,), int
    ranks : ndarray of shape (R, K), int
        ``capped_ranks`` or ``partner_ranks``.
    solver : str
        ``thesis``: every increment takes any cell with the same probability; ``proportional``: in proportion to what
        its column still needs, which keeps the rest level.
    stream : Stream
    progress : callable
    wish : ndarray of shape (R, K), int, optional
        Each row starts there and is changed as little as its sum and bounds ask for.

    Raises
    ------
    InfeasibleError
        If there is no such table.
    """
    require(solver in SOLVERS, f"the solver must be one of {', '.join(SOLVERS)}", repr(solver))
    after = np.vstack([ranks[::-1].cumsum(0)[::-1], np.zeros((1, len(columns)), np.int64)])
    _check_solvable(rows, columns, after[0])
    cells = np.zeros(ranks.shape, np.int64)
    rest = np.array(columns, np.int64)
    redrawn = levelled = 0
    for i, total in enumerate(rows):
        if i % 16 == 0:
            progress(i, len(rows), "tables")
        low, high = np.maximum(rest - after[i + 1][0], 0), np.minimum(rest, ranks[i][0])
        weights = np.ones_like(rest) if solver == "thesis" else rest
        for _ in range(REDRAWS):
            start = low if wish is None else start_near(wish[i], int(total), low, high, stream)
            row = draw_row(int(total), start, high, weights, stream)
            if row is not None and fits(row, ranks[i]) and fits(rest - row, after[i + 1]):
                break
            redrawn += 1
        else:
            row = levelling_row(rest, int(total), ranks[i])
            levelled += 1
        cells[i] = row
        rest -= row
    return Table(cells, redrawn, levelled)


def _check_solvable(rows: np.ndarray, columns: np.ndarray, ranks: np.ndarray) -> None:
    if int(np.sum(rows)) != int(np.sum(columns)):
        raise InfeasibleError(
            f"row sums and column sums must agree, got {int(np.sum(rows))} and {int(np.sum(columns))}"
        )
    asked = np.sort(columns)[::-1].cumsum()
    worst = int(np.argmax(asked - ranks))
    if asked[worst] > ranks[worst]:
        raise InfeasibleError(
            f"the {worst + 1} fullest columns ask for {int(asked[worst])}, "
            f"and the rows can give them {int(ranks[worst])}"
        )


def draw_row(
    total: int, low: np.ndarray, high: np.ndarray, weights: np.ndarray, stream: Stream
) -> Optional[np.ndarray]:
    """Return a random row between bounds with a given sum, (K,) int64, or None when the bounds do not allow it.

    All missing increments are drawn at once, and those beyond a bound again: the same law as the thesis' increments one
    by one, each rejected where its cell is full.

    Parameters
    ----------
    total : int
    low, high : ndarrays of shape (K,), int
    weights : ndarray of shape (K,), int
        Of the cells in the draw.
    stream : Stream
    """
    row = low.astype(np.int64)
    missing = total - int(row.sum())
    if missing < 0 or (low > high).any():
        return None
    while missing:
        chances = np.where(row < high, weights, 0).cumsum()
        if chances[-1] <= 0:
            return None
        picks = np.searchsorted(chances, np.floor(stream.many(missing) * chances[-1]), side="right")
        grown = np.minimum(row + np.bincount(picks, minlength=len(row)), high)
        missing -= int((grown - row).sum())
        row = grown
    return row


def start_near(wish: np.ndarray, total: int, low: np.ndarray, high: np.ndarray, stream: Stream) -> np.ndarray:
    """Return the row between bounds nearest to a wish, less random units where its sum is above the total; (K,) int64.

    Parameters
    ----------
    wish, low, high : ndarrays of shape (K,), int
    total : int
    stream : Stream
    """
    row = np.maximum(np.minimum(wish, high), low).astype(np.int64)
    excess = int(row.sum()) - total
    while excess > 0 and (row > low).any():
        chances = (row - low).cumsum()
        picks = np.searchsorted(chances, np.floor(stream.many(excess) * chances[-1]), side="right")
        less = np.maximum(row - np.bincount(picks, minlength=len(row)), low)
        excess -= int((row - less).sum())
        row = less
    return row


def levelling_row(rest: np.ndarray, total: int, ranks: np.ndarray) -> np.ndarray:
    """Return the row within its ranks that leaves the column sums as level as can be, (K,) int64.

    If any row leaves a rest that has a solution, this one does: what it leaves is majorised by what any other leaves
    (Frank, Murota 2021, doi:10.1007/s10107-021-01722-2: bases of a polymatroid have a least majorised element, found by
    unit steps).

    Parameters
    ----------
    rest : ndarray of shape (K,), int
        What the columns still need.
    total : int
        Sum of the row.
    ranks : ndarray of shape (K,), int
        Most that any k cells hold.

    Raises
    ------
    ExactnessError
        If the ranks do not hold the total; callers check beforehand.
    """
    row = np.zeros(len(rest), np.int64)
    for _ in range(total):
        ordered = np.sort(row)[::-1]
        tight = np.flatnonzero(ordered.cumsum() >= ranks)
        # cells as large as the smallest of a tight set would break it
        limit = ordered[tight[-1]] if len(tight) else np.iinfo(np.int64).max
        need = np.where((row < limit) & (row < rest), rest - row, -1)
        best = int(np.argmax(need))
        if need[best] < 0:
            raise ExactnessError(f"a row of {total} does not fit into its ranks")
        row[best] += 1
    return row


def solve_thesis_table(rows: np.ndarray, columns: np.ndarray, cap: int, stream: Stream) -> Optional[np.ndarray]:
    """Return a table by the thesis' own routine, (R, K) int64, or None when it runs into a dead end (6.2.3).

    Its minima (6.17) look at one column at a time, so that the last rows may have no solution.

    Parameters
    ----------
    rows, columns : ndarrays of int, equal sums
    cap : int
        Most in a cell (M, or the artificial maximum of 6.2.4.3).
    stream : Stream
    """
    cells = np.zeros((len(rows), len(columns)), np.int64)
    rest = np.array(columns, np.int64)
    for i, total in enumerate(rows):
        low = np.maximum(rest - (len(rows) - i - 1) * cap, 0)
        row = draw_row(int(total), low, np.minimum(rest, min(cap, int(total))), np.ones_like(rest), stream)
        if row is None:
            return None
        cells[i] = row
        rest -= row
    return cells
