# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layer of given tables that is highest on a field: a transportation problem, whose corners are whole numbers."""

from __future__ import annotations

import numpy as np

from ...errors import DependencyError, InfeasibleError
from ..progress import Progress, silent


def best_layer(field: np.ndarray, alpha: np.ndarray, beta: np.ndarray) -> np.ndarray:
    """Return the voxels of a layer with the greatest sum of the field, ndarray of shape (M, N), bool.

    Parameters
    ----------
    field : ndarray of shape (M, N), float
    alpha : ndarray of shape (N,), int
        Voxels in each column.
    beta : ndarray of shape (M,), int
        Voxels in each row.

    Raises
    ------
    InfeasibleError
        If no layer has these sums.
    DependencyError
        If scipy is missing.

    Notes
    -----
    A linear program over cells 0..1 (HiGHS dual simplex); its matrix is totally unimodular, so that the corner found is
    whole (Hoffman, Kruskal 1956).

    Examples
    --------
    >>> best_layer(np.array([[1.0, 5.0], [4.0, 2.0]]), np.array([1, 1]), np.array([1, 1])).astype(int).tolist()
    [[0, 1], [1, 0]]
    """
    try:
        from scipy.optimize import linprog
        from scipy.sparse import eye, kron, vstack
    except ImportError as error:
        raise DependencyError("the best layer of given tables needs scipy 1.6 or later: pip install scipy") from error
    rows, columns = field.shape
    sums = vstack([kron(np.ones((1, rows)), eye(columns)), kron(eye(rows), np.ones((1, columns)))]).tocsr()
    result = linprog(
        -np.asarray(field, float).ravel(),
        A_eq=sums,
        b_eq=np.concatenate([alpha, beta]).astype(float),
        bounds=(0, 1),
        method="highs-ds",
    )
    if result.x is None:
        raise InfeasibleError(
            f"no layer has these {int(np.sum(alpha))} voxels in columns and {int(np.sum(beta))} in rows"
        )
    return result.x.reshape(rows, columns) > 0.5


def best_layers(field: np.ndarray, alpha: np.ndarray, beta: np.ndarray, progress: Progress = silent) -> np.ndarray:
    """Return the best layer of each pair, ndarray of shape (P, M, N), bool.

    Parameters
    ----------
    field : ndarray of shape (P, M, N), float
    alpha : ndarray of shape (N, P), int
    beta : ndarray of shape (M, P), int
    progress : callable

    Raises
    ------
    InfeasibleError, DependencyError
        As ``best_layer``.
    """
    voxels = np.zeros(field.shape, bool)
    for layer in range(len(field)):
        progress(layer, len(field), "best layers")
        voxels[layer] = best_layer(field[layer], alpha[:, layer], beta[:, layer])
    return voxels
