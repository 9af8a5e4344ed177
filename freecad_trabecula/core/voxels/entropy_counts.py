# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many tables, or designs, have given sums: by the largest entropy, and the chance that free cells hit the sums.

Let each cell be drawn by itself, by the law exp(tilt x) on 0..cap whose tilts are sums of one number per layer of each
axis, chosen so that the sums asked for are the means. Then every solution has the same probability exp(-H), H being the
entropy, and their number is exp(H) times the chance P that all sums come out as asked for (Barvinok, Hartigan 2010,
doi:10.1016/j.aam.2010.01.004). P is an integral of the characteristic function of the sums over all angles,

    P = (2 pi)^-d  int  prod over cells of phi(angle of the cell's layers) exp(-i angle . sums),

near which the Gaussian of the same covariance lies. Angles are sampled from it and from wider ones beside it, and what
the integrand is beside their density is averaged: the mean is P whatever the Gaussian is worth, and its spread over the
samples is the standard error.
"""

from __future__ import annotations

import math
from functools import reduce
from typing import List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ..progress import Progress, silent
from ..streams import Stream
from .cell_laws import geometric
from .log_counts import LogCount

_STEPS = 100  # of Newton's method
_CLOSE = 1e-7  # voxels that a mean may differ from its sum
_LONGEST = 0.7  # step of a tilt
_WORK = 1.5e7  # cells times samples
_MOST, _LEAST = 40_000, 16  # samples
_AT_ONCE = 1 << 17  # cells times samples held in memory
_WIDER = np.array([0.0, 1.5, 4.0])  # by so many times 1 / sqrt(sums) are the Gaussians wider
_SHARES = np.array([0.6, 0.25, 0.15])  # of the samples drawn from each
_FEW_SUMS, _ALIKE = 14, 0.3  # up to so many sums, this share of the samples is drawn from all angles alike
_UNSURE = 0.5  # relative standard error above which the estimate says nothing


class FreeCells(NamedTuple):
    """The law of largest entropy whose mean sums are those asked for.

    Attributes
    ----------
    tilts : list of arrays
        One number per layer of each axis; a cell's tilt is the sum of those of its layers.
    covariance : ndarray of shape (d + axes - 1, d + axes - 1)
        Of all sums.
    entropy : float
        Natural logarithm of 1 / probability of a solution.
    """

    tilts: List[np.ndarray]
    covariance: np.ndarray
    entropy: float


def _spread(values: Sequence[np.ndarray]) -> np.ndarray:
    """Return sums of one value per layer of each axis, for all cells."""
    return reduce(np.add, np.ix_(*values)) if len(values) > 1 else values[0]


def _covariance(variance: np.ndarray) -> np.ndarray:
    """Return the covariance of the sums along all axes of independent cells."""
    starts = np.concatenate([[0], np.cumsum(variance.shape)])
    covariance = np.zeros((starts[-1], starts[-1]))
    axes = range(variance.ndim)
    for a in axes:
        for b in axes:
            block = variance.sum(tuple(k for k in axes if k not in (a, b)))
            block = np.diag(block) if a == b else block if a < b else block.T
            covariance[starts[a] : starts[a + 1], starts[b] : starts[b + 1]] = block
    return covariance


def free_cells(sums: Sequence[np.ndarray], cap: int) -> Optional[FreeCells]:
    """Return the law of largest entropy, or None where it has none: some cells can take one value only.

    Parameters
    ----------
    sums : sequence of arrays
        What the layers of each axis sum to; the totals of all axes agree.
    cap : int
        Cells hold 0..cap.
    """
    wanted = [np.asarray(s, float) for s in sums]
    shape = [len(s) for s in wanted]
    mean = wanted[0].sum() / math.prod(shape)
    tilts = [np.zeros(n) for n in shape]
    tilts[0] += math.log(mean / (mean + 1.0) * (cap - mean + 1.0) / (cap - mean))
    ends = np.cumsum(shape)[:-1]
    axes = range(len(shape))
    for _ in range(_STEPS):
        log_sum, means, variance = geometric(_spread(tilts), cap)
        covariance = _covariance(variance)
        wrong = np.concatenate([w - means.sum(tuple(a for a in axes if a != k)) for k, w in enumerate(wanted)])
        if np.abs(wrong).max() < _CLOSE:
            entropy = float(log_sum.sum()) - sum(float(t @ w) for t, w in zip(tilts, wanted))
            return FreeCells(tilts, covariance, entropy)
        step = np.linalg.lstsq(covariance, wrong, rcond=1e-12)[0]
        step *= min(1.0, _LONGEST / max(float(np.abs(step).max()), 1e-12))
        tilts = [t + s for t, s in zip(tilts, np.split(step, ends))]
    return None


def open_sums(sums: Sequence[np.ndarray], cap: int) -> List[np.ndarray]:
    """Return the sums without the layers that are empty or full: in those nothing is left to choose.

    Parameters
    ----------
    sums : sequence of int arrays
    cap : int

    Examples
    --------
    >>> [s.tolist() for s in open_sums([np.array([0, 2, 2, 4]), np.array([3, 2, 2, 1])], 1)]
    [[1, 1], [1, 1]]
    """
    left = [np.asarray(s, np.int64) for s in sums]
    while True:
        size = cap * math.prod(len(s) for s in left)
        holds = [size // max(len(s), 1) for s in left]
        closed = [(s == 0) | (s == hold) for s, hold in zip(left, holds)]
        axis = next((k for k, is_closed in enumerate(closed) if is_closed.any()), None)
        if axis is None:
            return left
        full = int((closed[axis] & (left[axis] > 0)).sum())
        for other in range(len(left)):
            if other != axis:
                left[other] = left[other] - full * (holds[axis] // max(len(left[other]), 1))
        left[axis] = left[axis][~closed[axis]]


def count_by_entropy(
    sums: Sequence[np.ndarray], cap: int, stream: Stream, progress: Progress = silent, samples: int = 0
) -> Optional[LogCount]:
    """Return how many arrays of whole numbers 0..cap have these sums along each axis.

    Parameters
    ----------
    sums : sequence of 2 or 3 int arrays
        Their totals are equal.
    cap : int
    stream : Stream
    progress : callable
    samples : int, optional
        As many as a second or two allows if left out.

    Returns
    -------
    LogCount or None
        None if no such law exists, or if the samples differ so much that their mean says nothing.
    """
    sums = open_sums(sums, cap)
    shape = [len(s) for s in sums]
    if not all(shape):
        return LogCount(0.0, 0.0, 0, math.inf)  # nothing is left to choose
    cells = free_cells(sums, cap)
    if cells is None:
        return None
    # the totals agree: one sum of every axis but the first follows from the others
    kept = np.delete(np.arange(sum(shape)), np.cumsum(shape)[:-1])
    try:
        root = np.linalg.cholesky(cells.covariance[np.ix_(kept, kept)])
    except np.linalg.LinAlgError:
        return None
    size = math.prod(shape)
    samples = samples or int(np.clip(_WORK / size, _LEAST, _MOST))
    target = np.concatenate([np.asarray(s, float) for s in sums])
    log_root = float(np.log(np.diag(root)).sum())
    ratios, batch = [], max(1, _AT_ONCE // size)
    for first in range(0, samples, batch):
        progress(first, samples, "counting by entropy")
        drawn, log_density = _drawn_angles(min(batch, samples - first), root, stream)
        angles = np.zeros((len(drawn), sum(shape)))
        angles[:, kept] = drawn
        inside = (np.abs(angles) <= math.pi).all(1)
        log_ratio = _log_characteristic(cells, cap, angles, shape) - 1j * (angles @ target) - log_density
        ratios.append(np.where(inside, np.exp(log_ratio).real, 0.0))
    gauss = cells.entropy - log_root - 0.5 * len(kept) * math.log(2 * math.pi)
    return _counted(np.concatenate(ratios), gauss)


def _counted(ratios: np.ndarray, log_scale: float) -> Optional[LogCount]:
    mean = float(ratios.mean())
    error = float(ratios.std(ddof=1)) / math.sqrt(len(ratios))
    if not mean > error / _UNSURE:
        return None
    effective = len(ratios) * mean**2 / float((ratios**2).mean())
    return LogCount((log_scale + math.log(mean)) / math.log(10), error / mean / math.log(10), len(ratios), effective)


def _drawn_angles(count: int, root: np.ndarray, stream: Stream) -> Tuple[np.ndarray, np.ndarray]:
    """Return angles (S, d) and the logarithm of their density beside the height of the Gaussian of the covariance.

    Wider Gaussians, and for few sums all angles alike, keep the ratios small where the integrand is wider.
    """
    sums = len(root)
    scales = 1.0 + _WIDER / math.sqrt(sums)
    alike = _ALIKE if sums <= _FEW_SUMS else 0.0
    shares = _SHARES * (1.0 - alike)
    chosen = np.searchsorted(np.cumsum(shares), stream.many(count), side="right")
    radius = np.sqrt(-2.0 * np.log1p(-stream.many(count * sums)))
    turn = stream.many(count * sums).reshape(count, sums)
    normal = radius.reshape(count, sums) * np.cos(2.0 * math.pi * turn)
    angles = np.linalg.solve(root.T, (normal * np.append(scales, 1.0)[chosen][:, None]).T).T
    angles = np.where(chosen[:, None] < len(scales), angles, math.pi * (2.0 * turn - 1.0))
    square = 0.5 * ((angles @ root) ** 2).sum(1)
    parts = [math.log(w) - sums * math.log(s) - square / s**2 for w, s in zip(shares, scales)]
    if alike:
        height = 0.5 * sums * math.log(2.0 * math.pi) + float(np.log(np.diag(root)).sum())
        parts.append(np.full(count, math.log(alike) - height))
    return angles, np.logaddexp.reduce(parts)


def _log_characteristic(cells: FreeCells, cap: int, angles: np.ndarray, shape: List[int]) -> np.ndarray:
    """Return the logarithm of the product over all cells of the mean of exp(i angle x), complex (S,)."""
    turns = [np.exp(1j * part) for part in np.split(angles, np.cumsum(shape)[:-1], axis=1)]
    across = turns[1]
    for turn in turns[2:]:
        across = (across[:, :, None] * turn[:, None, :]).reshape(len(across), -1)
    weights = np.exp(_spread(cells.tilts)).reshape(shape[0], -1)
    rows = max(1, _AT_ONCE // across.size)
    total = np.zeros(len(angles), complex)
    for first in range(0, shape[0], rows):
        here = weights[first : first + rows]
        turn = turns[0][:, first : first + rows, None] * across[:, None, :]
        if cap == 1:
            values = (1.0 + here * turn) / (1.0 + here)
        else:
            values = _geometric_series(here * turn, cap) / _geometric_series(here, cap)
        total += np.log(np.multiply.reduce(values, axis=2)).sum(1)
    return total


def _geometric_series(ratio: np.ndarray, cap: int) -> np.ndarray:
    """Return 1 + r + ... + r^cap."""
    near = np.abs(ratio - 1.0) < 1e-9
    safe = np.where(near, 0.5, ratio)
    return np.where(near, cap + 1.0, (1.0 - safe ** (cap + 1)) / (1.0 - safe))
