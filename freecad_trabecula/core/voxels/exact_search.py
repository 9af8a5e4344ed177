# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a small design exists, decided for certain: a linear program, then branch and bound (HiGHS, by scipy).

Tables drawn at random solve all but a few targets in ten thousand. What they leave is decided here: the linear program
finds weights of the layers that no design can meet (Farkas), branch and bound a design, or that there is none.
"""

from __future__ import annotations

import math
import time
from typing import Any, Optional, Tuple

import numpy as np

from ...errors import ExactnessError, InfeasibleError
from ..optional_packages import optional_module
from .feasibility import caps_of, layers_in_words
from .parameters import VoxelParameters
from .targets import AXES, Targets

#: Cells up to which branch and bound is used: 20 x 20 x 20 takes seconds.
LARGEST_SEARCH = 8000
_SECONDS = 60.0  # of branch and bound
_DENOMINATOR = 24  # of the weights, at most
_ZERO = 1e-7  # HiGHS' own tolerance of feasibility


def searched_design(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray] = None) -> np.ndarray:
    """Return a design, (P, M, N) bool, or say for certain that there is none.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
        Its caps.
    mask : ndarray of shape (P, M, N), bool, optional

    Raises
    ------
    InfeasibleError
        If there is none, with the layers that contradict each other where weights of layers prove it.
    ExactnessError
        If there are more than ``LARGEST_SEARCH`` cells, or time ran out.
    DependencyError
        If scipy is missing or too old.
    """
    allowed = np.ones(targets.shape, bool) if mask is None else mask
    if int(allowed.sum()) > LARGEST_SEARCH:
        raise ExactnessError(
            f"designs are searched for exhaustively up to {LARGEST_SEARCH} cells, got {int(allowed.sum())}"
        )
    check_programs()
    from scipy.sparse import vstack

    _check_weights(targets, allowed)
    matrix, sums = _layer_sums(targets, allowed)
    lines, caps = _line_caps(targets, parameters, allowed)
    low, high = np.concatenate([sums, np.full(len(caps), -np.inf)]), np.concatenate([sums, caps])
    chosen, certain = solved_program(vstack([matrix, lines]).tocsr(), low, high, np.ones(matrix.shape[1]), _SECONDS)
    if chosen is None and certain:
        raise InfeasibleError(
            "no design has these counts: no set of layers contradicts another by itself, but a search of all designs "
            "found none"
        )
    if chosen is None:
        raise ExactnessError(f"the search for a design gave up after {_SECONDS:g} s")
    voxels = np.zeros(targets.shape, bool)
    voxels[allowed] = chosen
    return voxels


def check_programs() -> None:
    """Refuse to search where scipy has no integer programs.

    Raises
    ------
    DependencyError
        If scipy is missing or older than 1.9.
    """
    optional_module("scipy.optimize", "the search for a design needs scipy 1.9 or later", "milp")


def solved_program(
    matrix: Any, low: np.ndarray, high: np.ndarray, most: np.ndarray, seconds: float
) -> Tuple[Optional[np.ndarray], bool]:
    """Return variables of 0 or 1 that keep all constraints, (cells,) bool or None, and whether the answer is certain.

    Parameters
    ----------
    matrix : sparse matrix of shape (rows, cells)
    low, high : ndarrays of shape (rows,)
        Bounds of matrix x variables.
    most : ndarray of shape (cells,)
        Upper bounds of the variables, 0 or 1.
    seconds : float
        After which it gives up.

    Notes
    -----
    The presolver of the HiGHS in scipy 1.10 gives variables of 3 and -2 for some programs, and calls them optimal: what
    it says is believed where the constraints hold; else, and where it finds nothing, the program is solved without it.
    """
    from scipy.optimize import Bounds, LinearConstraint, milp

    end = time.perf_counter() + seconds
    for presolve in (True, False):
        result = milp(
            np.zeros(len(most)),
            integrality=np.ones(len(most)),
            bounds=Bounds(0, most),
            constraints=LinearConstraint(matrix, low, high),
            options={"time_limit": max(end - time.perf_counter(), 0.1), "presolve": presolve},
        )
        if result.x is not None:
            chosen = result.x > 0.5
            sums = matrix @ chosen.astype(float)
            if (chosen <= most).all() and ((low <= sums) & (sums <= high)).all():
                return chosen, True
    return None, result.status == 2


def _layer_sums(targets: Targets, allowed: np.ndarray) -> Tuple[Any, np.ndarray]:
    """Matrix of the layers' sums over the allowed cells, sparse (N + M + P, cells), and the counts."""
    from scipy.sparse import csr_matrix

    z, y, x = np.nonzero(allowed)
    n, m, _ = targets.layers
    rows = np.concatenate([x, n + y, n + m + z])
    columns = np.tile(np.arange(len(x)), 3)
    matrix = csr_matrix((np.ones(len(rows)), (rows, columns)), shape=(sum(targets.layers), len(x)))
    return matrix, np.concatenate(targets.counts).astype(float)


def _line_caps(targets: Targets, parameters: VoxelParameters, allowed: np.ndarray) -> Tuple[Any, np.ndarray]:
    """Matrix of the lines (x, z) and (y, z) over the allowed cells, sparse, and their caps."""
    from scipy.sparse import csr_matrix

    z, y, x = np.nonzero(allowed)
    n, m, p = targets.layers
    cap_alpha, cap_beta = caps_of(targets, parameters)
    rows = np.concatenate([x * p + z, n * p + y * p + z])
    columns = np.tile(np.arange(len(x)), 2)
    matrix = csr_matrix((np.ones(len(rows)), (rows, columns)), shape=((n + m) * p, len(x)))
    return matrix, np.repeat([cap_alpha, cap_beta], [n * p, m * p]).astype(float)


def _check_weights(targets: Targets, allowed: np.ndarray) -> None:
    """Refuse targets that weights of the layers contradict.

    The linear program seeks voxels between 0 and 1 that miss the counts by as little as can be. When that is not 0, the
    weights of its dual are the proof: a design weighs at most what its cells of positive weight do.
    """
    from scipy.optimize import linprog
    from scipy.sparse import eye, hstack

    matrix, sums = _layer_sums(targets, allowed)
    layers, cells = matrix.shape
    both = hstack([matrix, eye(layers), -eye(layers)])
    costs = np.concatenate([np.zeros(cells), np.ones(2 * layers)])
    bounds = [(0, 1)] * cells + [(0, None)] * (2 * layers)
    result = linprog(costs, A_eq=both, b_eq=sums, bounds=bounds, method="highs")
    if result.x is None or result.fun < _ZERO:
        return
    weights = _whole_weights(result.eqlin.marginals)
    asked = int(weights @ np.concatenate(targets.counts))
    most = int(np.maximum(matrix.T @ weights, 0).sum())
    if asked > most:  # else it is not that simple: branch and bound decides
        raise InfeasibleError(
            f"{_weights_in_words(weights, targets)}: the counts weigh {asked}, no design above {most}"
        )


def _whole_weights(weights: np.ndarray) -> np.ndarray:
    """Weights as the smallest whole numbers in their proportion; vertices of the program have small denominators."""
    scaled = weights / max(float(np.abs(weights).max()), 1e-12)
    for scale in range(1, _DENOMINATOR + 1):
        if np.allclose(scaled * scale, np.round(scaled * scale), atol=1e-6):
            return np.round(scaled * scale).astype(np.int64)
    return np.round(scaled * 1000).astype(np.int64)


def _weights_in_words(weights: np.ndarray, targets: Targets) -> str:
    words, start = [], 0
    for axis, counts in zip(AXES, targets.counts):
        own = weights[start : start + len(counts)]
        start += len(counts)
        for value in sorted(set(own.tolist()) - {0}, reverse=True):
            words.append(f"{layers_in_words(np.flatnonzero(own == value), axis)} {value} times")
    return f"the layers contradict each other; count {', '.join(words)}"


def is_small(targets: Targets, mask: Optional[np.ndarray] = None) -> bool:
    """Return whether the existence of a design can be decided for certain."""
    return (math.prod(targets.layers) if mask is None else int(mask.sum())) <= LARGEST_SEARCH
