# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers from their tables: 0/1 cells with alpha_i voxels in column i and beta_j in row j (thesis 6.2.4).

Minimum zeros propagation solves one line after the other, the shortest first, and puts its voxels into the cross lines
that still need most. In the order of the thesis or in any other, it finds a layer whenever there is one (Ryser 1957,
doi:10.4153/CJM-1957-044-3). All layers are worked on at once.

Within a mask a line puts its voxels into the cross lines that have the fewest cells to spare: cells of the mask in
lines not yet solved, less the voxels still needed. Without a mask all have the same cells, and this is the thesis'
rule. With one it may end beside the sums; a flow then moves as few voxels as it takes, and finds the layer if there is
one.
"""

from __future__ import annotations

from typing import Optional, Tuple

import numpy as np

from ...errors import InfeasibleError
from ..parameters import require
from ..progress import Progress, silent
from ..streams import Stream
from .flows import completed_table
from .parameters import DIRECTIONS

ORDERS = ("minimum", "sequential")
_LATE = 1 << 40  # key of cross lines that need nothing more; twice that: that have no cell


def propagated_layers(
    alpha: np.ndarray,
    beta: np.ndarray,
    direction: str = "columns",
    order: str = "minimum",
    progress: Progress = silent,
    mask: Optional[np.ndarray] = None,
) -> np.ndarray:
    """Return all layers by minimum zeros propagation, ndarray of shape (P, M, N), bool.

    Parameters
    ----------
    alpha : ndarray of shape (N, P), int
        Voxels in each column (x, z).
    beta : ndarray of shape (M, P), int
        Voxels in each row (y, z).
    direction : str
        ``columns``: columns are solved one after the other, each takes the rows that need most, and u, the number of
        rows without need, stays smallest (thesis cases 1 and 2); ``rows``: the other way round, for v.
    order : str
        ``minimum``: the shortest line first (case 1); ``sequential``: as they stand (case 2).
    progress : callable
    mask : ndarray of shape (P, M, N), bool, optional
        Cells that may be solid.

    Raises
    ------
    InfeasibleError
        If the tables are not compatible; the message names the first such layer.
    DependencyError
        If a layer within a mask needs a flow, and scipy is missing.
    """
    require(direction in DIRECTIONS, f"the direction must be one of {', '.join(DIRECTIONS)}", repr(direction))
    require(order in ORDERS, f"the order must be one of {', '.join(ORDERS)}", repr(order))
    if direction == "rows":
        turned = None if mask is None else mask.transpose(0, 2, 1)
        return propagated_layers(beta, alpha, "columns", order, progress, turned).transpose(0, 2, 1)
    lines, need = alpha.T, beta.T.astype(np.int64)  # (P, N), (P, M)
    layers, count = lines.shape
    voxels = np.zeros((layers, count, need.shape[1]), bool)  # line by line; turned at the end
    every = np.arange(layers)
    turns = np.argsort(lines, axis=1, kind="stable") if order == "minimum" else np.tile(np.arange(count), (layers, 1))
    places = np.arange(need.shape[1])
    cells = None if mask is None else mask.transpose(0, 2, 1)  # (P, N, M)
    spare = -need if mask is None else mask.sum(2) - need  # cells of lines not yet solved, less the need
    for k in range(count):
        if k % 16 == 0:
            progress(k, count, "layers")
        line = turns[:, k]
        takes = lines[every, line]
        own = None if cells is None else cells[every, line]
        keys = spare if own is None else np.where(own, np.where(need > 0, spare, _LATE), 2 * _LATE)
        tightest = np.argsort(keys, axis=1, kind="stable")
        layer, place = np.nonzero(places[None, :] < takes[:, None])
        row = tightest[layer, place]
        voxels[layer, line[layer], row] = True
        need[layer, row] -= 1
        spare[layer, row] += 1
        if own is not None:
            spare -= own
    if cells is not None:
        _mend(voxels, need, lines, beta.T, cells)
    _check_layers(need, lines.sum(1), beta.sum(0))
    return voxels.transpose(0, 2, 1)


def _mend(voxels: np.ndarray, need: np.ndarray, lines: np.ndarray, asked: np.ndarray, cells: np.ndarray) -> None:
    """Bring layers (P, N, M) that missed their sums to them by flows, in place; ``need`` stays where there is none."""
    outside = (voxels & ~cells).any((1, 2))
    need[outside, 0] += ~(need[outside] != 0).any(1)  # a voxel too few within the mask
    for layer in np.flatnonzero((need != 0).any(1)):
        start = (voxels[layer] & cells[layer]).astype(np.int64)
        for row in np.flatnonzero(start.sum(0) > asked[layer]):  # a flow adds and moves, it takes nothing away
            start[np.flatnonzero(start[:, row])[asked[layer, row] :], row] = 0
        found, cut = completed_table(lines[layer], asked[layer], cells[layer].astype(np.int64), start)
        if cut is None and lines[layer].sum() == asked[layer].sum():
            voxels[layer], need[layer] = found > 0, 0


def _check_layers(left: np.ndarray, asked: np.ndarray, given: np.ndarray) -> None:
    bad = np.flatnonzero((left != 0).any(1))
    if len(bad):
        layer = int(bad[0])
        raise InfeasibleError(
            f"the tables are not compatible: no layer {layer} along Z has these {int(asked[layer])} voxels in columns "
            f"and {int(given[layer])} in rows; {len(bad)} of {len(left)} layers fail"
        )


def shuffled_layers(
    voxels: np.ndarray,
    stream: Stream,
    rounds: int = 12,
    progress: Progress = silent,
    mask: Optional[np.ndarray] = None,
) -> np.ndarray:
    """Return layers drawn nearly uniformly from all with the same row and column sums, (P, M, N), bool.

    Each round pairs the rows of each layer at random; a pair trades at random the voxels that only one of them has
    (global curveball: Carstens, Berger, Strona 2016, arXiv:1609.05137). Sums never change, every layer is reached, and
    the chain's law tends to the uniform one. Within a mask a pair trades in the cells that both rows have; every layer
    that such trades reach is as likely, but they may not reach all.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    stream : Stream
    rounds : int
        After about ten rounds nothing of the start can be seen any more.
    progress : callable
    mask : ndarray of shape (P, M, N), bool, optional
        Cells that may be solid.
    """
    voxels = np.array(voxels, bool, order="C")
    for done in range(rounds):
        for number, layer in enumerate(voxels):
            if number % 16 == 0:
                progress(done + number / len(voxels), rounds, "random layers")
            _trade(layer, stream, None if mask is None else mask[number])
    return voxels


def _trade(layer: np.ndarray, stream: Stream, mask: Optional[np.ndarray]) -> None:
    """Trade the voxels of random pairs of a layer's rows, in place."""
    rows, columns = layer.shape
    half = rows // 2
    if not half:
        return
    order = np.argsort(stream.many(rows), kind="stable")
    first, second = layer[order[:half]], layer[order[half : 2 * half]]
    single = first != second
    if mask is not None:
        single &= mask[order[:half]] & mask[order[half : 2 * half]]
    keys = np.where(single, stream.many(half * columns).reshape(half, columns), 2.0)
    ranks = np.empty((half, columns), np.int64)
    np.put_along_axis(ranks, np.argsort(keys, axis=1), np.arange(columns)[None, :], axis=1)
    gets = ranks < (first & single).sum(1)[:, None]
    layer[order[:half]] = (first & ~single) | (single & gets)
    layer[order[half : 2 * half]] = (second & ~single) | (single & ~gets)


def layer_sums(voxels: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Return alpha (N, P) and beta (M, P) of a design (P, M, N)."""
    return voxels.sum(1, dtype=np.int64).T, voxels.sum(2, dtype=np.int64).T
