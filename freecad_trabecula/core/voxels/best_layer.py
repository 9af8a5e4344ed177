# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layer of given tables that is highest on a field: a transportation problem, whose corners are whole numbers."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...errors import InfeasibleError
from ..optional_packages import optional_module
from ..progress import Progress, silent


def best_layer(field: np.ndarray, alpha: np.ndarray, beta: np.ndarray, mask: Optional[np.ndarray] = None) -> np.ndarray:
    """Return the voxels of a layer with the greatest sum of the field, ndarray of shape (M, N), bool.

    Parameters
    ----------
    field : ndarray of shape (M, N), float
    alpha : ndarray of shape (N,), int
        Voxels in each column.
    beta : ndarray of shape (M,), int
        Voxels in each row.
    mask : ndarray of shape (M, N), bool, optional
        Cells that may be solid.

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
    purpose = "the best layer of given tables needs scipy 1.6 or later"
    sparse, optimize = (optional_module(name, purpose) for name in ("scipy.sparse", "scipy.optimize"))
    rows, columns = field.shape
    cells = np.arange(rows * columns) if mask is None else np.flatnonzero(mask)
    sums = sparse.vstack(
        [
            sparse.kron(np.ones((1, rows)), sparse.eye(columns)),
            sparse.kron(sparse.eye(rows), np.ones((1, columns))),
        ]
    ).tocsc()
    result = optimize.linprog(
        -np.asarray(field, float).ravel()[cells],
        A_eq=sums[:, cells],
        b_eq=np.concatenate([alpha, beta]).astype(float),
        bounds=(0, 1),
        method="highs-ds",
    )
    if result.x is None:
        raise InfeasibleError(
            f"no layer has these {int(np.sum(alpha))} voxels in columns and {int(np.sum(beta))} in rows"
        )
    layer = np.zeros(rows * columns, bool)
    layer[cells] = result.x > 0.5
    return layer.reshape(rows, columns)


def best_layers(
    field: np.ndarray,
    alpha: np.ndarray,
    beta: np.ndarray,
    progress: Progress = silent,
    mask: Optional[np.ndarray] = None,
) -> np.ndarray:
    """Return the best layer of each pair, ndarray of shape (P, M, N), bool.

    Parameters
    ----------
    field : ndarray of shape (P, M, N), float
    alpha : ndarray of shape (N, P), int
    beta : ndarray of shape (M, P), int
    progress : callable
    mask : ndarray of shape (P, M, N), bool, optional
        Cells that may be solid.

    Raises
    ------
    InfeasibleError, DependencyError
        As ``best_layer``.
    """
    voxels = np.zeros(field.shape, bool)
    for layer in range(len(field)):
        progress(layer, len(field), "best layers")
        own = None if mask is None else mask[layer]
        voxels[layer] = best_layer(field[layer], alpha[:, layer], beta[:, layer], own)
    return voxels
