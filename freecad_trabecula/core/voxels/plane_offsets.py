# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offsets per plane that give a field its layer counts: v = field + a[z] + b[y] + c[x] > 0.

Of all voxel sets with given counts on the planes of three axes, the one over which the field sums highest has this
form; (a, b, c) minimise a convex function (the dual), whose gradient is what the counts lack. The step of v is first a
ramp of half width eps, which Newton can follow, then ever steeper. Values stay multiples of ``texture.QUANTUM`` and
steps are cut to few digits, so that sums are exact and no library's rounding decides a voxel.
"""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

import numpy as np

from ...errors import ParameterError
from ..progress import Progress, silent
from .texture import QUANTUM

#: What the field is set to where no solid may be: no offset reaches it.
FORBIDDEN = np.float32(-1024.0)
LARGEST_OFFSET = 24.0
_WIDEST, _NARROWEST = 0.5, 2.0**-7  # half widths of the ramp
_SMALL = 1 << 18  # voxels; a larger field is first solved on every other voxel
_SLAB_VALUES = 1 << 18
_STEPS_PER_WIDTH = 8
_STALLED = 0.9  # of what was lacking a step before: the width has nothing more to give
_LINE = 16  # planes along x gathered at once: what a line of the processor's cache holds
_NEAR = 2.0**-5  # of its offset: where a plane's new one is looked for first
_STEP_DIGITS = 12  # bits kept of the longest component of a step


def layer_sums(voxels: np.ndarray) -> List[np.ndarray]:
    """Return the solid voxels of each layer along z, y, x: int64 arrays (P,), (M,), (N,)."""
    z = np.count_nonzero(voxels.reshape(len(voxels), -1), axis=1)
    rows = np.zeros(voxels.shape[1:], np.int64)
    for layer in voxels:
        rows += layer
    return [z.astype(np.int64), rows.sum(1), rows.sum(0)]


def on_field(
    field: np.ndarray, offsets: Sequence[np.ndarray], first: int = 0, last: Optional[int] = None
) -> np.ndarray:
    """Return field + offsets of the layers first .. last - 1 along z; float32 (layers, M, N)."""
    a, b, c = (np.asarray(o, np.float32) for o in offsets)
    return field[first:last] + (a[first:last, None, None] + (b[:, None] + c[None, :]))


def solid_of(field: np.ndarray, offsets: Sequence[np.ndarray]) -> np.ndarray:
    """Return where field + offsets > 0; (P, M, N) bool."""
    solid = np.empty(field.shape, bool)
    slab = _slab(field.shape)
    for first in range(0, len(field), slab):
        np.greater(on_field(field, offsets, first, first + slab), 0, out=solid[first : first + slab])
    return solid


def _slab(shape: tuple) -> int:
    return max(1, _SLAB_VALUES // (shape[1] * shape[2]))


def _rounded(values: np.ndarray, quantum: float) -> np.ndarray:
    return np.rint(values / quantum) * quantum


class _Ramp:
    """Counts of the ramped step on all planes, and how many voxels stand on the ramp for each pair of planes."""

    def __init__(self, field: np.ndarray, offsets: Sequence[np.ndarray], half_width: float) -> None:
        p, m, n = field.shape
        self.sums = [np.zeros(p), np.zeros(m), np.zeros(n)]
        self.zy, self.zx, self.yx = np.zeros((p, m)), np.zeros((p, n)), np.zeros((m, n))
        steepness = np.float32(0.5 / half_width)
        slab = _slab(field.shape)
        for first in range(0, p, slab):
            here = slice(first, first + slab)
            g = on_field(field, offsets, first, first + slab)
            g *= steepness
            g += np.float32(0.5)
            on_ramp = ((g > 0) & (g < 1)).view(np.uint8)
            np.minimum(np.maximum(g, 0.0, out=g), 1.0, out=g)  # twice as fast as np.clip
            # multiples of 2^-18 below 2^9 times the plane's side: exact in float64 whatever the order
            rows = g.sum(2, dtype=np.float64)
            self.sums[0][here] = rows.sum(1)
            self.sums[1] += rows.sum(0)
            self.sums[2] += g.sum(0, dtype=np.float64).sum(0)
            self.zy[here] = on_ramp.sum(2, dtype=np.uint16)
            self.zx[here] = on_ramp.sum(1, dtype=np.uint16)
            self.yx += on_ramp.sum(0, dtype=np.uint16)

    def step(self, lacking: np.ndarray, half_width: float) -> np.ndarray:
        """Return Newton's step for what all planes lack (P + M + N,), no longer than the ramp is wide."""
        p, m = self.zy.shape
        size = p + m + self.zx.shape[1]
        matrix = np.zeros((size, size))
        matrix[:p, p : p + m], matrix[:p, p + m :], matrix[p : p + m, p + m :] = self.zy, self.zx, self.yx
        matrix += matrix.T
        own = np.concatenate((self.zy.sum(1), self.zy.sum(0), self.zx.sum(0)))
        # the offsets are known but for two constants: the small part on the diagonal chooses the shortest
        matrix[np.arange(size), np.arange(size)] = own * 1.001 + 1e-3 * own.mean() + 1e-9
        step = np.linalg.solve(matrix * (0.5 / half_width), lacking)
        longest = np.abs(step).max()
        if longest > 2 * half_width:
            step *= 2 * half_width / longest
            longest = 2 * half_width
        digits = 2.0 ** (np.ceil(np.log2(max(longest, QUANTUM))) - _STEP_DIGITS)
        return _rounded(step, max(digits, QUANTUM))


def _start(field: np.ndarray, targets: Sequence[np.ndarray]) -> List[np.ndarray]:
    """Return offsets that give the total: one number for all planes."""
    values = field.reshape(-1)[:: max(1, field.size // 50_000)]
    values = np.sort(values[values > FORBIDDEN / 2])
    if not len(values):  # so small a mask that the samples missed it
        values = np.sort(field[field > FORBIDDEN / 2])
    available = max(1, int(np.count_nonzero(field > FORBIDDEN / 2)))
    rank = int(len(values) * (1.0 - float(targets[0].sum()) / available))
    level = float(values[min(max(rank, 0), len(values) - 1)])
    return [np.full(field.shape[0], -level), np.zeros(field.shape[1]), np.zeros(field.shape[2])]


def _from_half(field: np.ndarray, targets: Sequence[np.ndarray], progress: Progress) -> List[np.ndarray]:
    """Return offsets from every other voxel: their planes' offsets, and the means of neighbours between them."""
    half = np.ascontiguousarray(field[::2, ::2, ::2])
    available = layer_sums(field > FORBIDDEN / 2)
    of_half = layer_sums(half > FORBIDDEN / 2)
    shares = [t[::2] / np.maximum(a[::2], 1) * h for t, a, h in zip(targets, available, of_half)]
    coarse = newton_offsets(half, shares, narrowest=2.0**-4, progress=progress)
    return [
        _rounded(np.interp(np.arange(n), np.arange(0, n, 2), offsets), QUANTUM)
        for n, offsets in zip(field.shape, coarse)
    ]


def newton_offsets(
    field: np.ndarray,
    targets: Sequence[np.ndarray],
    offsets: Optional[Sequence[np.ndarray]] = None,
    widest: float = _WIDEST,
    narrowest: float = _NARROWEST,
    progress: Progress = silent,
) -> List[np.ndarray]:
    """Return offsets whose counts differ from the targets by a few voxels a plane.

    Parameters
    ----------
    field : ndarray of shape (P, M, N), float32
        Multiples of ``texture.QUANTUM``; ``FORBIDDEN`` where no solid may be.
    targets : sequence of 3 arrays, (P,), (M,), (N,)
        Voxels of each layer along z, y, x.
    offsets : sequence of 3 arrays, optional
        Where to start, with a ramp as wide as they may be wrong.
    widest, narrowest : float
        Half widths of the first and last ramp, powers of 2.
    progress : callable

    Returns
    -------
    list of 3 float64 arrays (P,), (M,), (N,)
        Multiples of ``texture.QUANTUM``.
    """
    if [len(t) for t in targets] != list(field.shape):
        raise ParameterError(f"targets of {[len(t) for t in targets]} layers do not fit a field of {field.shape}")
    half_width = widest
    if offsets is None and field.size > _SMALL:
        offsets, half_width = _from_half(field, targets, progress), 2.0**-4
    current = np.concatenate(_start(field, targets) if offsets is None else [np.asarray(o, float) for o in offsets])
    wanted = np.concatenate([np.asarray(t, float) for t in targets])
    ends = np.cumsum(field.shape)[:-1]
    while True:
        before = np.inf
        for _ in range(_STEPS_PER_WIDTH):
            ramp = _Ramp(field, np.split(current, ends), half_width)
            lacking = wanted - np.concatenate(ramp.sums)
            most = np.abs(lacking).max()
            if most < 1.0 or most > _STALLED * before:  # sums of shares may differ by axis: those nothing meets
                break
            before = most
            current = np.clip(current + ramp.step(lacking, half_width), -LARGEST_OFFSET, LARGEST_OFFSET)
            progress(0, 1, "offsets")
        if half_width <= narrowest:
            return np.split(current, ends)
        half_width = max(half_width / 2, narrowest)


def polished(
    field: np.ndarray,
    targets: Sequence[np.ndarray],
    offsets: Sequence[np.ndarray],
    sweeps: int = 2,
    progress: Progress = silent,
) -> List[np.ndarray]:
    """Return offsets after sweeps in which each plane in turn takes the offset that gives it exactly its count.

    Later axes spoil the earlier ones a little, less with every sweep; the last axis (x) comes out exact but for ties.
    """
    offsets = [np.asarray(o, np.float32).copy() for o in offsets]
    for sweep in range(sweeps):
        for axis in range(3):
            _give_counts(field, np.asarray(targets[axis]), offsets, axis)
            progress(3 * sweep + axis + 1, 3 * sweeps, "offsets")
    return offsets


def _give_counts(field: np.ndarray, counts: np.ndarray, offsets: list, axis: int) -> None:
    """Give every plane of one axis the offset that makes its count exact; changes ``offsets[axis]``."""
    size = field.shape[axis]
    across = [o for i, o in enumerate(offsets) if i != axis]
    table = (across[0][:, None] + across[1][None, :]).reshape(-1)
    block = _LINE if axis == 2 else max(1, min(_LINE, _SLAB_VALUES // table.size + 1))
    for first in range(0, size, block):
        here = (slice(None),) * axis + (slice(first, first + block),)
        planes = np.moveaxis(field[here], axis, 0).reshape(-1, table.size) + table
        for plane, values in enumerate(planes, first):
            count = int(counts[plane])
            if int(np.count_nonzero(values > -offsets[axis][plane])) != count:
                offsets[axis][plane] = _level(values, count, offsets[axis][plane])


def _neighbours_of_rank(values: np.ndarray, rank: int, near: float) -> Tuple[np.float32, np.float32]:
    """Return the values of the sorted array before and at a rank, which are looked for near a number first."""
    low, high = np.float32(near - _NEAR), np.float32(near + _NEAR)
    above = values > low
    before = values.size - int(np.count_nonzero(above))
    above &= values < high
    close = values[above]
    if before < rank < before + close.size:
        values, rank = close, rank - before
    parted = np.partition(values, (rank - 1, rank))
    return parted[rank - 1], parted[rank]


def _level(values: np.ndarray, count: int, offset: float) -> float:
    """Return the offset above which `count` of the values lie, or the old one if the plane has not so many."""
    if count <= 0 or count >= values.size:
        return offset
    below, above = _neighbours_of_rank(values, values.size - count, -offset)
    if below < FORBIDDEN / 2:  # all that may be solid is: the level just under it
        below = above - np.float32(1.0)
    if above < FORBIDDEN / 2:
        return offset
    level = np.rint((above + below) * np.float32(-0.5 / QUANTUM)) * np.float32(QUANTUM)
    return float(np.clip(level, -LARGEST_OFFSET, LARGEST_OFFSET))
