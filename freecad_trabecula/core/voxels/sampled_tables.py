# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many tables have given sums and a cap: sequential importance sampling, row by row.

The weight of a value x in a column is the number of ways in which the rows left can complete the column, by the
saddle-point approximation; a row's values are drawn one by one under the condition of its sum, for which the rest of
the row counts as Gaussian but for its skewness (Edgeworth), and exactly for the last few. Whatever the approximations,
each sample is weighted by 1 / its probability, so that the mean is the number of tables (Chen, Diaconis, Holmes, Liu
2005, section 6, doi:10.1198/016214504000001303).
"""

from __future__ import annotations

from typing import NamedTuple, Tuple

import numpy as np

from ..progress import Progress, silent
from ..streams import Stream
from .cell_laws import geometric
from .feasibility import table_shortfall
from .log_counts import LogCount, log_count

#: Tilts of a column's law at which its completions are worked out; denser near 0.
_TILTS = 12.0 * np.sinh(np.linspace(-5.0, 5.0, 801)) / np.sinh(5.0)
_EXACT = 8  # values of a row that are drawn exactly: there the rest is too short to be Gaussian
_NEWTON = 40  # steps to the tilt that makes a row's mean sum right


class _Completions(NamedTuple):
    """For the rows from i on: logarithm of the sum, mean, and variance of a tilted column, (P + 1, T) each."""

    log_sum: np.ndarray
    mean: np.ndarray
    variance: np.ndarray


def count_tables(
    rows: np.ndarray, columns: np.ndarray, cap: int, samples: int, stream: Stream, progress: Progress = silent
) -> LogCount:
    """Return how many tables of whole numbers 0..cap have these row and column sums.

    Parameters
    ----------
    rows, columns : ndarrays of int, equal sums
    cap : int
    samples : int
    stream : Stream
    progress : callable
    """
    rows, columns = np.asarray(rows, np.int64), np.asarray(columns, np.int64)
    if rows.sum() != columns.sum() or table_shortfall(rows, columns, cap):
        return LogCount(-np.inf, np.nan, samples, 0.0)
    rows = np.sort(rows[rows > 0])[::-1]
    columns = columns[columns > 0]
    if not len(rows):
        return LogCount(0.0, 0.0, samples, float(samples))
    tilts = _tilts_of(rows / len(columns), cap)
    ahead = _completions(tilts, cap)
    rest = np.tile(columns, (samples, 1))
    log_weights, alive = np.zeros(samples), np.ones(samples, bool)
    for i in range(len(rows) - 1):
        progress(i, len(rows), "counting tables")
        left = len(rows) - i - 1
        values, log_chance = _drawn_rows(rest, int(rows[i]), left, cap, ahead, i, tilts[i], stream)
        alive &= np.isfinite(log_chance)
        log_weights -= np.where(alive, log_chance, 0.0)
        rest = np.where(alive[:, None], rest - values, rest)
    alive &= (rest <= cap).all(1) & (rest.sum(1) == rows[-1])
    return log_count(np.where(alive, log_weights, -np.inf))


def _tilts_of(means: np.ndarray, cap: int) -> np.ndarray:
    """Tilts at which the law on 0..cap has the given means, (P,), by halving."""
    low, high = np.full(len(means), _TILTS[0]), np.full(len(means), _TILTS[-1])
    for _ in range(60):
        middle = (low + high) / 2
        above = geometric(middle, cap)[1] > means
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    return (low + high) / 2


def _completions(tilts: np.ndarray, cap: int) -> _Completions:
    shape = (len(tilts) + 1, len(_TILTS))
    parts = [np.zeros(shape) for _ in range(3)]
    for i in range(len(tilts) - 1, -1, -1):
        for total, value in zip(parts, geometric(tilts[i] + _TILTS, cap)):
            total[i] = total[i + 1] + value
    return _Completions(*parts)


def _log_ways(ahead: _Completions, i: int, rest: np.ndarray) -> np.ndarray:
    """Logarithm of the tilted number of ways to complete columns that need ``rest`` in the rows from i on."""
    tilt = np.interp(rest, ahead.mean[i], _TILTS)
    log_sum, variance = np.interp(tilt, _TILTS, ahead.log_sum[i]), np.interp(tilt, _TILTS, ahead.variance[i])
    return log_sum - tilt * rest - 0.5 * np.log(2 * np.pi * np.maximum(variance, 0.05))


def _drawn_rows(
    rest: np.ndarray, total: int, left: int, cap: int, ahead: _Completions, i: int, tilt: float, stream: Stream
) -> Tuple[np.ndarray, np.ndarray]:
    """One row for each sample (S, K), and the logarithm of its chance (S,), -inf where there was none."""
    values = np.arange(cap + 1)
    low, high = np.maximum(rest - left * cap, 0), np.minimum(rest, cap)
    needs = np.arange(int(rest.max()) + 1)
    ways = _log_ways(ahead, i + 1, needs.astype(float))  # once for each need that occurs
    log_weight = ways[np.maximum(rest[:, :, None] - values, 0)] + tilt * values
    log_weight = np.where((values >= low[:, :, None]) & (values <= high[:, :, None]), log_weight, -np.inf)
    chance = _tilted(log_weight, values, total)
    mean = chance @ values.astype(float)
    return _conditional_draw(chance, mean, low, high, total, stream)


def _tilted(log_weight: np.ndarray, values: np.ndarray, total: int) -> np.ndarray:
    """Chances (S, K, X) tilted so that each row's mean sum is the total."""
    tilt = np.zeros(len(log_weight))
    for _ in range(_NEWTON):
        log_chance = log_weight + tilt[:, None, None] * values
        chance = np.exp(log_chance - log_chance.max(2, keepdims=True))
        chance /= chance.sum(2, keepdims=True)
        moments = chance @ np.stack([values, values**2.0], 1)
        mean = moments[:, :, 0]
        variance = (moments[:, :, 1] - mean**2).sum(1)
        wrong = total - mean.sum(1)
        if np.abs(wrong).max() < 0.5:
            break
        tilt += np.clip(wrong / np.maximum(variance, 1e-6), -0.5, 0.5)
    return chance


def _conditional_draw(
    chance: np.ndarray, mean: np.ndarray, low: np.ndarray, high: np.ndarray, total: int, stream: Stream
) -> Tuple[np.ndarray, np.ndarray]:
    """Values one by one under the condition of their sum, (S, K), and the logarithm of their chance."""
    samples, count, width = chance.shape
    values = np.arange(width)
    raw = chance @ np.stack([values**2.0, values**3.0], 1)  # moments about 0
    second = raw[:, :, 0] - mean**2
    third = raw[:, :, 1] - 3 * mean * raw[:, :, 0] + 2 * mean**3
    after = [
        np.hstack([a[:, ::-1].cumsum(1)[:, ::-1][:, 1:], np.zeros((samples, 1))])
        for a in (mean, second, third, low, high)
    ]
    tails = _exact_tails(chance[:, max(count - _EXACT, 0) :])
    needed = np.full(samples, total)
    drawn, log_chance = np.zeros((samples, count), np.int64), np.zeros(samples)
    uniform = stream.many(samples * count).reshape(count, samples)
    for j in range(count):
        rest = needed[:, None] - values
        if count - j > _EXACT:
            spread = np.sqrt(np.maximum(after[1][:, j : j + 1], 0.05))
            z = (rest - after[0][:, j : j + 1]) / spread
            skewed = 1 + after[2][:, j : j + 1] / (6 * spread**3) * z * (z * z - 3)
            share = np.exp(-z * z / 2) * np.clip(skewed, 0.1, 10.0)
            share *= (rest >= after[3][:, j : j + 1]) & (rest <= after[4][:, j : j + 1])
        else:
            tail = tails[count - j - 1]
            share = np.take_along_axis(tail, np.clip(rest, 0, tail.shape[1] - 1), 1)
            share = np.where((rest >= 0) & (rest < tail.shape[1]), share, 0.0)
        cumulative = (chance[:, j] * share).cumsum(1)
        all_of = cumulative[:, -1]
        pick = np.minimum((cumulative <= (uniform[j] * all_of)[:, None]).sum(1), width - 1)
        own = chance[np.arange(samples), j, pick] * share[np.arange(samples), pick]
        with np.errstate(divide="ignore", invalid="ignore"):
            log_chance += np.where((own > 0) & (all_of > 0), np.log(own / all_of), -np.inf)
        drawn[:, j] = pick
        needed = needed - pick
    return drawn, np.where(needed == 0, log_chance, -np.inf)


def _exact_tails(chance: np.ndarray) -> list:
    """Law of the sum of the last 0, 1, 2 ... values, (S, sums) each."""
    samples, count, width = chance.shape
    tails = [np.ones((samples, 1))]
    for j in range(count - 1, 0, -1):
        tail = np.zeros((samples, tails[-1].shape[1] + width - 1))
        for x in range(width):
            tail[:, x : x + tails[-1].shape[1]] += chance[:, j, x : x + 1] * tails[-1]
        tails.append(tail)
    return tails
