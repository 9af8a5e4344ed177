# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many solutions one equation, and how many designs one row, has, exactly (thesis 6.2.2.1, 6.2.4); all of a design.

What cannot be counted exactly (tables, layers) is estimated by ``sampled_tables`` and ``sampled_layers``.
"""

from __future__ import annotations

import math
from itertools import accumulate
from typing import Any, Dict, NamedTuple, Optional, Sequence

import numpy as np

from ..parameters import require
from ..progress import Progress, part, silent
from ..streams import Stream
from .design import VoxelDesign
from .feasibility import caps_of
from .log_counts import LogCount
from .sampled_layers import count_layers
from .sampled_tables import count_tables
from .targets import Targets

_SAMPLES = 24  # of a table: 3 s for 100 x 100
_LAYER_SAMPLES = 6  # of each layer of a design; their errors are independent and add as squares
_STEPS = 60  # of Newton's method


def free_solutions(n: int, k: int) -> int:
    """Return how many solutions X_1 + ... + X_k = n has in whole numbers from 0 (6.11): (n + k - 1)! / (n! (k - 1)!).

    Examples
    --------
    >>> free_solutions(3, 2)
    4
    """
    require(n >= 0 and k >= 1, "an equation must have n >= 0 and k >= 1", (n, k))
    return math.comb(n + k - 1, k - 1)


def bounded_solutions(n: int, most: Sequence[int], least: Optional[Sequence[int]] = None) -> int:
    """Return how many solutions X_1 + ... + X_k = n has with least_j <= X_j <= most_j (6.12, 6.13).

    Parameters
    ----------
    n : int
    most, least : sequences of int
        Bounds; ``least`` is 0 when it is left out.

    Raises
    ------
    ParameterError
        If the bounds are of different lengths, or one is negative.

    Notes
    -----
    Whole numbers of any size: for each variable prefix sums, less the same moved by its bound + 1.

    Examples
    --------
    >>> bounded_solutions(3, [1, 2, 2])
    5
    >>> bounded_solutions(3, [1, 2, 2], [1, 0, 0])
    3
    """
    least = [0] * len(most) if least is None else list(least)
    require(len(least) == len(most) > 0, "each variable must have two bounds", (len(least), len(most)))
    require(min(least) >= 0 and n >= 0, "bounds and sum must not be negative", (min(least), n))
    rest = n - sum(least)
    widths = [high - low for high, low in zip(most, least)]
    if rest < 0 or min(widths) < 0:
        return 0
    ways = [1] + [0] * rest
    for width in widths:
        sums = list(accumulate(ways))
        ways = sums[: width + 1] + [sums[i] - sums[i - width - 1] for i in range(width + 1, rest + 1)]
    return ways[rest]


def row_designs(columns: int, voxels: int, zeros: int = 0) -> int:
    """Return how many designs one row of a layer has: N! / (b! (N - b)!), or with N - v for N (6.19, 6.20).

    Parameters
    ----------
    columns : int
        N.
    voxels : int
        beta_j: voxels of the row.
    zeros : int
        v: columns that need no voxel.

    Examples
    --------
    >>> row_designs(5, 2), row_designs(5, 2, 1)
    (10, 6)
    """
    require(0 <= zeros <= columns and voxels >= 0, "a row must have 0 <= v <= N and voxels >= 0", (zeros, columns))
    return math.comb(columns - zeros, voxels)


def log10_of(number: int) -> float:
    """Return the logarithm of a whole number of any size, -inf for 0.

    Examples
    --------
    >>> round(log10_of(10**400), 9)
    400.0
    """
    if number <= 0:
        return -math.inf
    shift = max(number.bit_length() - 60, 0)
    return math.log10(number >> shift) + shift * math.log10(2)


class SystemCounts(NamedTuple):
    """How many designs there are; the logarithms are to base 10.

    Attributes
    ----------
    alpha, beta : LogCount
        Tables of the systems (6.5) and (6.9) with these sums and caps, each by itself.
    layers : LogCount
        Designs with the tables of this design: the product over its layers.
    designs : LogCount
        Designs with these counts along X, Y and Z, whatever their tables.
    """

    alpha: LogCount
    beta: LogCount
    layers: LogCount
    designs: LogCount


def count_systems(design: VoxelDesign, progress: Progress = silent) -> SystemCounts:
    """Return how many tables, layers and designs there are beside this one.

    Parameters
    ----------
    design : VoxelDesign
    progress : callable

    Raises
    ------
    ParameterError
        If the design lies in a mask: lines of different lengths are not counted.
    """
    require(design.mask is None, "designs are counted in boxes, not in", "a mask")
    targets, seed = design.targets, design.parameters.seed
    cap_alpha, cap_beta = caps_of(targets, design.parameters)
    streams = [Stream(seed, "voxels", "counting", name) for name in ("alpha", "beta", "layers")]
    return SystemCounts(
        count_tables(targets.c, targets.d, cap_alpha, _SAMPLES, streams[0], part(progress, 0.0, 0.4)),
        count_tables(targets.c, targets.e, cap_beta, _SAMPLES, streams[1], part(progress, 0.4, 0.75)),
        count_layers(design.alpha, design.beta, _LAYER_SAMPLES, streams[2], part(progress, 0.75, 1.0)),
        count_designs(targets),
    )


def counting_record(design: VoxelDesign, progress: Progress = silent) -> Dict[str, Any]:
    """Return ``count_systems`` as plain values for a report."""
    counts = count_systems(design, progress)
    names = ("tables alpha", "tables beta", "designs with this design's tables", "designs with these counts (entropy)")
    return {
        name: {
            "log10": count.log10 if math.isfinite(count.log10) else None,  # no sample came to its end
            "standard_error": None if math.isnan(count.standard_error) else count.standard_error,
            "samples": count.samples,
        }
        for name, count in zip(names, counts)
    }


def count_designs(targets: Targets) -> LogCount:
    """Return about how many designs have these counts along X, Y and Z: entropy and a Gaussian factor, no sampling.

    Cells are taken as independent, with the chances that make the counts their means and the entropy largest; the
    chance that the sums come out exactly is that of a Gaussian with their covariance (Barvinok, Hartigan 2010,
    doi:10.1016/j.aam.2010.01.004). For tables and layers, where it can be checked, it is too high by less than 1 in the
    logarithm; there is no standard error.

    Parameters
    ----------
    targets : Targets
    """
    counts = [np.asarray(c, float) for c in (targets.c, targets.e, targets.d)]
    sizes = [targets.layer_sizes[2 - k] for k in range(3)]
    if any(((c == 0) | (c == size)).any() for c, size in zip(counts, sizes)):
        return _designs_of_open_layers(targets)
    offsets = [np.zeros(len(c)) for c in counts]
    density = targets.total / math.prod(len(c) for c in counts)
    offsets[0] += math.log(density / (1 - density))
    for _ in range(_STEPS):
        log_odds = _sum_of(offsets)
        chance = 1 / (1 + np.exp(-log_odds))
        covariance = _covariance(chance * (1 - chance))
        wrong = np.concatenate([c - chance.sum(_others(k)) for k, c in enumerate(counts)])
        if np.abs(wrong).max() < 1e-6:
            break
        step = np.linalg.lstsq(covariance, wrong, rcond=1e-12)[0]
        step *= min(1.0, 1.5 / max(float(np.abs(step).max()), 1e-12))
        start = 0
        for k, c in enumerate(counts):
            offsets[k] = offsets[k] + step[start : start + len(c)]
            start += len(c)
    entropy = float(np.logaddexp(0, log_odds).sum()) - sum(float(o @ c) for o, c in zip(offsets, counts))
    # the three sums share one total: two of the rows are determined by the others
    p, m, n = (len(c) for c in counts)
    kept = [k for k in range(p + m + n) if k not in (p, p + m)]
    determinant = float(np.linalg.slogdet(covariance[np.ix_(kept, kept)])[1])
    value = (entropy - 0.5 * (determinant + len(kept) * math.log(2 * math.pi))) / math.log(10)
    return LogCount(value, math.nan, 0, math.nan)


def _designs_of_open_layers(targets: Targets) -> LogCount:
    """The count without layers that are empty or full: in those nothing is left to choose."""
    for axis in range(3):
        size = targets.layer_sizes[axis]
        fixed = np.flatnonzero((targets.counts[axis] == 0) | (targets.counts[axis] == size))
        if not len(fixed):
            continue
        if len(fixed) == targets.layers[axis]:
            return LogCount(0.0, math.nan, 0, math.nan)
        counts = list(targets.counts)
        for other in range(3):
            if other != axis:
                full = int((counts[axis][fixed] == size).sum())
                counts[other] = counts[other] - full * (size // targets.layers[other])
        counts[axis] = np.delete(counts[axis], fixed)
        return count_designs(Targets(*counts, targets.voxel))
    return count_designs(targets)


def _sum_of(offsets: Sequence[np.ndarray]) -> np.ndarray:
    return offsets[0][:, None, None] + offsets[1][None, :, None] + offsets[2][None, None, :]


def _others(axis: int) -> tuple:
    return tuple(k for k in range(3) if k != axis)


def _covariance(variance: np.ndarray) -> np.ndarray:
    """Covariance of the sums along z, y, x, (P + M + N)^2, of independent cells."""
    p, m, n = variance.shape
    covariance = np.zeros((p + m + n, p + m + n))
    covariance[:p, p : p + m] = variance.sum(2)
    covariance[:p, p + m :] = variance.sum(1)
    covariance[p : p + m, p + m :] = variance.sum(0)
    covariance += covariance.T
    np.fill_diagonal(covariance, np.concatenate([variance.sum(_others(k)) for k in range(3)]))
    return covariance
