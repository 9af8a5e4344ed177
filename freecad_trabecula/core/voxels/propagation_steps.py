# SPDX-License-Identifier: LGPL-2.1-or-later
"""Minimum zeros propagation of one layer, step by step, with what Fig. 6.8 to 6.11 of the thesis show of each."""

from __future__ import annotations

from typing import List, NamedTuple

import numpy as np

from ..parameters import require
from .layer_fill import ORDERS
from .parameters import DIRECTIONS


class Step(NamedTuple):
    """The state before a line is solved (the last: when all are).

    Attributes
    ----------
    alpha : ndarray of shape (N,), int
        What the columns still need.
    beta : ndarray of shape (M,), int
        What the rows still need.
    voxels : ndarray of shape (M, N), bool
        Placed so far.
    line : int
        The line that is solved next: a row for direction ``rows``, else a column; -1 at the end.
    columns, rows : int
        N and M.
    """

    alpha: np.ndarray
    beta: np.ndarray
    voxels: np.ndarray
    line: int
    columns: int
    rows: int

    @property
    def v(self) -> int:
        """Zeros in alpha."""
        return int((self.alpha == 0).sum())

    @property
    def u(self) -> int:
        """Zeros in beta."""
        return int((self.beta == 0).sum())

    @property
    def condition_6_21(self) -> bool:
        """Max(beta) > N - v: a row needs more columns than are left; the design has become impossible."""
        return int(self.beta.max()) > self.columns - self.v

    @property
    def condition_6_22(self) -> bool:
        """Max(alpha) > M - u: a column needs more rows than are left; the design has become impossible."""
        return int(self.alpha.max()) > self.rows - self.u

    @property
    def is_impossible(self) -> bool:
        """Whether one of the two conditions holds."""
        return self.condition_6_21 or self.condition_6_22


def propagation_steps(
    alpha: np.ndarray, beta: np.ndarray, direction: str = "rows", order: str = "minimum"
) -> List[Step]:
    """Return the steps of one layer, from the empty template to the design or to the step that cannot go on.

    Parameters
    ----------
    alpha : ndarray of shape (N,), int
        Voxels asked for in each column.
    beta : ndarray of shape (M,), int
        Voxels asked for in each row.
    direction : str
        ``rows``: rows are solved one after the other, v stays smallest (Fig. 6.8); ``columns``: u.
    order : str
        ``minimum``: the shortest line first; ``sequential``: as they stand.

    Raises
    ------
    ParameterError
        If the sums differ, or a count is negative or beyond the layer.

    Examples
    --------
    >>> steps = propagation_steps(np.array([2, 1]), np.array([1, 2]))
    >>> steps[-1].voxels.astype(int).tolist()
    [[1, 0], [1, 1]]
    """
    require(direction in DIRECTIONS, f"the direction must be one of {', '.join(DIRECTIONS)}", repr(direction))
    require(order in ORDERS, f"the order must be one of {', '.join(ORDERS)}", repr(order))
    alpha, beta = np.array(alpha, np.int64), np.array(beta, np.int64)
    for name, counts, most in (("alpha", alpha, len(beta)), ("beta", beta, len(alpha))):
        require(bool(((counts >= 0) & (counts <= most)).all()), f"{name} must lie in 0..{most}", counts.tolist())
    require(alpha.sum() == beta.sum(), "alpha and beta must have the same sum", f"{alpha.sum()} and {beta.sum()}")
    if direction == "columns":
        return [_turned(step) for step in _row_steps(beta, alpha, order)]
    return _row_steps(alpha, beta, order)


def _turned(step: Step) -> Step:
    return Step(step.beta, step.alpha, step.voxels.T, step.line, step.rows, step.columns)


def _row_steps(alpha: np.ndarray, beta: np.ndarray, order: str) -> List[Step]:
    columns, rows = len(alpha), len(beta)
    voxels = np.zeros((rows, columns), bool)
    lines = np.argsort(beta, kind="stable") if order == "minimum" else np.arange(rows)
    steps = []
    for line in lines[beta[lines] > 0]:
        steps.append(Step(alpha.copy(), beta.copy(), voxels.copy(), int(line), columns, rows))
        if steps[-1].is_impossible:
            return steps
        fullest = np.argsort(-alpha, kind="stable")[: beta[line]]
        voxels[line, fullest] = True
        alpha[fullest] -= 1
        beta[line] = 0
    return [*steps, Step(alpha.copy(), beta.copy(), voxels.copy(), -1, columns, rows)]
