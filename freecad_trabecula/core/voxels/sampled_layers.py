# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many layers given tables have: sequential importance sampling of 0/1 matrices with given sums.

Column after column, the fullest first, its voxels are drawn by a conditional Poisson law with the odds r / (left - r)
of rows that still need r in the columns left (Chen, Diaconis, Holmes, Liu 2005, doi:10.1198/016214504000001303). All
samples of all layers are drawn together.
"""

from __future__ import annotations

from typing import List, Tuple

import numpy as np

from ..progress import Progress, part, silent
from ..streams import Stream
from .log_counts import LogCount, log_count, product

_TINY = 1e-300
_POOR, _MORE = 10, 10  # layers that are drawn again at most, and with how many times the samples


def count_layer(alpha: np.ndarray, beta: np.ndarray, samples: int, stream: Stream) -> LogCount:
    """Return how many 0/1 matrices have these column and row sums.

    Parameters
    ----------
    alpha : ndarray of shape (N,), int
        Column sums.
    beta : ndarray of shape (M,), int
        Row sums.
    samples : int
    stream : Stream
    """
    return count_layers(np.asarray(alpha)[:, None], np.asarray(beta)[:, None], samples, stream)


def count_layers(
    alpha: np.ndarray, beta: np.ndarray, samples: int, stream: Stream, progress: Progress = silent
) -> LogCount:
    """Return how many designs have these tables: the product over their layers.

    A few layers with few samples of weight are drawn again with ten times as many.

    Parameters
    ----------
    alpha : ndarray of shape (N, P), int
    beta : ndarray of shape (M, P), int
    samples : int
        Of each layer, at first.
    stream : Stream
    progress : callable

    Returns
    -------
    LogCount
        -inf if no sample of some layer came to its end: where the sums are either 0 or at a tight cap, few do.
    """
    counts = _layer_counts(alpha, beta, samples, stream, part(progress, 0.0, 0.5))
    poor = [k for k, count in enumerate(counts) if count.effective < min(samples, 4) / 2 + 1]
    for done, k in enumerate(poor if len(poor) <= _POOR else ()):
        step = part(progress, 0.5 + 0.5 * done / len(poor), 0.5 + 0.5 * (done + 1) / len(poor))
        again = _layer_counts(alpha[:, [k]], beta[:, [k]], samples * _MORE, stream, step)[0]
        counts[k] = max(counts[k], again, key=lambda count: count.effective)
    return product(counts)


def _layer_counts(
    alpha: np.ndarray, beta: np.ndarray, samples: int, stream: Stream, progress: Progress
) -> List[LogCount]:
    layers = alpha.shape[1]
    columns = -np.sort(-np.repeat(alpha.T, samples, axis=0), axis=1)  # (P S, N)
    rest = np.repeat(beta.T, samples, axis=0).astype(np.int64)  # (P S, M)
    log_weights = np.zeros(len(rest))
    alive = columns.sum(1) == rest.sum(1)
    for k in range(columns.shape[1]):
        progress(k, columns.shape[1], "counting layers")
        left = columns.shape[1] - k
        takes, log_chance, possible = _drawn_column(rest, columns[:, k], left, stream)
        alive &= possible
        log_weights -= np.where(alive, log_chance, 0.0)
        rest = rest - takes
        alive &= (rest >= 0).all(1) & (rest <= left - 1).all(1)
        rest[~alive] = 0
    log_weights[~alive] = -np.inf
    return [log_count(w) for w in log_weights.reshape(layers, samples)]


def _drawn_column(
    rest: np.ndarray, counts: np.ndarray, left: int, stream: Stream
) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rows that take a voxel of the column (B, M), the logarithm of their chance (B,), and whether any could (B,)."""
    forced = rest == left
    free = (rest > 0) & ~forced
    odds = np.where(free, rest / np.maximum(left - rest, 0.5), 0.0)
    odds /= np.maximum(odds.max(1, keepdims=True), _TINY)
    need = counts - forced.sum(1)
    possible = (need >= 0) & (free.sum(1) >= need)
    need = np.where(possible, need, 0)
    sums, scale = _symmetric_sums(odds, int(need.max(initial=0)))
    every, rows = np.arange(len(rest)), rest.shape[1]
    log_total = np.log(np.maximum(sums[0, every, need], _TINY)) + scale[0]
    drawn = stream.many(rest.size).reshape(rows, -1)
    takes, log_chance = forced.copy(), np.zeros(len(rest))
    log_odds = np.log(np.maximum(odds, _TINY))
    for i in range(rows):
        share = odds[:, i] * sums[i + 1, every, np.maximum(need - 1, 0)] * np.exp(scale[i + 1] - scale[i])
        taken = (need > 0) & (drawn[i] * sums[i, every, need] < share)
        takes[:, i] |= taken
        log_chance += np.where(taken, log_odds[:, i], 0.0)
        need = need - taken
    return takes, log_chance - log_total, possible & (need == 0)


def _symmetric_sums(odds: np.ndarray, most: int) -> Tuple[np.ndarray, np.ndarray]:
    """Sums over all choices of 0..most of the rows i.. of the product of their odds, (M + 1, B, most + 1), scaled."""
    count, rows = odds.shape
    sums = np.zeros((rows + 1, count, most + 1))
    sums[rows, :, 0] = 1.0
    scale = np.zeros((rows + 1, count))
    for i in range(rows - 1, -1, -1):
        sums[i] = sums[i + 1]
        sums[i, :, 1:] += odds[:, i : i + 1] * sums[i + 1, :, :-1]
        top = sums[i].max(1)
        sums[i] /= top[:, None]
        scale[i] = scale[i + 1] + np.log(top)
    return sums, scale
