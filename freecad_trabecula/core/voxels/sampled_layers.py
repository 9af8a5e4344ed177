# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many layers given tables have: sequential importance sampling of 0/1 matrices with given sums.

Column after column, the fullest first, its voxels are drawn by a conditional Poisson law (Chen, Diaconis, Holmes, Liu
2005, doi:10.1198/016214504000001303). The odds of a row that still needs r are those of its completions: the ways to
put r - 1 beside the ways to put r into the columns left, each column weighted by its odds of largest entropy. (Their
odds r / (left - r) take all columns as alike, and miss most designs where some are nearly empty and others full.)
Samples of many layers are drawn together.
"""

from __future__ import annotations

from typing import List, Tuple

import numpy as np

from ..progress import Progress, part, silent
from ..streams import Stream
from .log_counts import LogCount, log_count, product

_TINY = 1e-300
_POOR, _MORE = 10, 10  # layers that are drawn again at most, and with how many times the samples
_TABLE_VALUES = 1 << 22  # of completions held at once
_TURNS = 30  # to the odds of largest entropy
_ODDS = (1e-6, 1e6)


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
    group = max(1, _TABLE_VALUES // (len(alpha) + 1) ** 2)
    counts = []
    for first in range(0, layers, group):
        here = slice(first, first + group)
        step = part(progress, first / layers, min(first + group, layers) / layers)
        counts += _counts_together(alpha[:, here].T, beta[:, here].T, samples, stream, step)
    return counts


def _counts_together(
    alpha: np.ndarray, beta: np.ndarray, samples: int, stream: Stream, progress: Progress
) -> List[LogCount]:
    """Counts of layers (P,) with column sums alpha (P, N) and row sums beta (P, M)."""
    order = np.argsort(-alpha, axis=1, kind="stable")
    weights = np.stack([_column_odds(a, b) for a, b in zip(alpha, beta)])
    completions = _log_completions(np.take_along_axis(weights, order, 1))
    columns = np.repeat(np.take_along_axis(alpha, order, 1), samples, axis=0)  # (P S, N)
    rest = np.repeat(beta, samples, axis=0).astype(np.int64)  # (P S, M)
    layer = np.repeat(np.arange(len(alpha)), samples)[:, None]
    log_weights = np.zeros(len(rest))
    alive = columns.sum(1) == rest.sum(1)
    for k in range(columns.shape[1]):
        progress(k, columns.shape[1], "counting layers")
        left = columns.shape[1] - k
        odds = _row_odds(completions[:, k + 1], layer, rest, left)
        takes, log_chance, possible = _drawn_column(odds, rest == left, columns[:, k], stream)
        alive &= possible
        log_weights -= np.where(alive, log_chance, 0.0)
        rest = rest - takes
        alive &= (rest >= 0).all(1) & (rest <= left - 1).all(1)
        rest[~alive] = 0
    log_weights[~alive] = -np.inf
    return [log_count(w) for w in log_weights.reshape(len(alpha), samples)]


def _column_odds(columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Odds of the columns (N,) in the law of largest entropy, by turns with those of the rows; any would do."""
    count = len(rows)
    odds = (columns + 0.25) / (count - columns + 0.25)
    of_rows = np.ones(count)
    for _ in range(_TURNS):
        ways = odds / (1.0 + np.outer(of_rows, odds))
        of_rows = np.clip(rows / np.maximum(ways.sum(1), _TINY), *_ODDS)
        ways = of_rows[:, None] / (1.0 + np.outer(of_rows, odds))
        odds = np.clip(columns / np.maximum(ways.sum(0), _TINY), *_ODDS)
    return odds


def _log_completions(odds: np.ndarray) -> np.ndarray:
    """Logarithm of the weighted ways to put r voxels into the columns k.., (P, N + 1, N + 1) by k and r."""
    layers, count = odds.shape
    ways = np.full((layers, count + 1, count + 1), -np.inf)
    ways[:, count, 0] = 0.0
    for k in range(count - 1, -1, -1):
        ways[:, k, 0] = 0.0
        ways[:, k, 1:] = np.logaddexp(ways[:, k + 1, 1:], np.log(odds[:, k : k + 1]) + ways[:, k + 1, :-1])
    return ways


def _row_odds(ways: np.ndarray, layer: np.ndarray, rest: np.ndarray, left: int) -> np.ndarray:
    """Odds of the rows (B, M) that may take a voxel of the column or leave it, the highest 1; 0 for the others."""
    free = (rest > 0) & (rest < left)
    need = np.where(free, rest, 1)
    with np.errstate(invalid="ignore"):
        log_odds = np.where(free, ways[layer, need - 1] - ways[layer, need], -np.inf)
    top = log_odds.max(1, keepdims=True)
    return np.exp(log_odds - np.where(np.isfinite(top), top, 0.0))


def _drawn_column(
    odds: np.ndarray, forced: np.ndarray, counts: np.ndarray, stream: Stream
) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rows that take a voxel of the column (B, M), the logarithm of their chance (B,), and whether any could (B,)."""
    need = counts - forced.sum(1)
    possible = (need >= 0) & ((odds > 0).sum(1) >= need)
    need = np.where(possible, need, 0)
    sums, scale = _symmetric_sums(odds, int(need.max(initial=0)))
    every, rows = np.arange(len(odds)), odds.shape[1]
    log_total = np.log(np.maximum(sums[0, every, need], _TINY)) + scale[0]
    drawn = stream.many(odds.size).reshape(rows, -1)
    takes, log_chance = forced.copy(), np.zeros(len(odds))
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
