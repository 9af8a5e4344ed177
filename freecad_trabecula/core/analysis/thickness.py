# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness of a body everywhere: the largest sphere inside that covers a place.

Hildebrand and Rüegsegger, J. Microsc. 185 (1997) 67, DOI 10.1046/j.1365-2818.1997.1340694.x. Exact on the voxels:
squared distances are whole numbers, every ball that could matter is painted, and balls are left out only where a
neighbour's ball covers all their voxels. What lies outside the array is unknown, not void: balls may reach out of it,
as in other programs.

Distances run from voxel centre to voxel centre, as in other programs too: beyond the surface on one side, short of the
true middle on the other. Measured over all angles and places, a plate comes out 0.4 voxels too thick, a rod 0.2 and a
ball 0.9 voxels too thin; a plate along the grid that is n voxels thick gets n if n is even, n + 1 if it is odd.
"""

from __future__ import annotations

from typing import Iterator, NamedTuple, Optional, Tuple

import numpy as np

from ...errors import MeshError
from ..progress import Progress, part, silent
from ..triples import triple

_FAR = np.int32(1 << 14)  # more voxels than any direction has
_WRITES = 4_000_000  # voxels painted at once


class SizeDistribution(NamedTuple):
    """Diameters over a volume.

    Attributes
    ----------
    mean, deviation, largest : float, mm
        Over the volume; 0 where there is none.
    edges : ndarray of shape (B + 1,), mm
        Borders of bins one voxel wide.
    shares : ndarray of shape (B,)
        Share of the volume whose diameter lies in each bin; the sum is 1, or 0 where there is no volume.
    """

    mean: float
    deviation: float
    largest: float
    edges: np.ndarray
    shares: np.ndarray

    def quantile(self, share: float) -> float:
        """Return the diameter, mm, up to which a share of the volume goes, linear inside a bin."""
        return float(np.interp(share, np.concatenate([[0.0], np.cumsum(self.shares)]), self.edges))


def squared_distances(inside: np.ndarray, progress: Progress = silent) -> np.ndarray:
    """Return the squared distance from each voxel's centre to the nearest voxel that is not inside.

    Parameters
    ----------
    inside : ndarray of shape (P, M, N), bool

    Returns
    -------
    ndarray of shape (P, M, N), int32, in voxels²
        0 outside; the squared diagonal of the array where nothing is outside.

    Notes
    -----
    Exact, direction by direction (Saito and Toriwaki 1994, DOI 10.1016/0031-3203(94)90133-3): a row's own distances by
    running maxima, then the least of d² + k² over shifts k of whole planes, until k² is beyond the largest d².
    """
    squared = np.empty(inside.shape, np.int32)
    cap = np.int32(sum(n * n for n in inside.shape))
    for z, plane in enumerate(inside):
        progress(z, 2 * len(inside), "distances")
        squared[z] = _least_over_shifts(np.minimum(_row_distances(plane), cap))
    rows = inside.shape[1]
    for y in range(0, rows, 2):
        progress(rows + y, 2 * rows, "distances")
        squared[:, y : y + 2] = _least_over_shifts(np.ascontiguousarray(squared[:, y : y + 2]))
    return squared


def _row_distances(plane: np.ndarray) -> np.ndarray:
    """Squared distances (M, N) along the last direction."""
    index = np.arange(plane.shape[-1], dtype=np.int32)
    before = np.maximum.accumulate(np.where(plane, -_FAR, index), axis=-1)
    after = np.minimum.accumulate(np.where(plane, _FAR, index)[:, ::-1], axis=-1)[:, ::-1]
    return np.minimum(index - before, after - index) ** 2


def _least_over_shifts(squared: np.ndarray) -> np.ndarray:
    """Return the least of squared[i + k] + k² over all k, along the first direction."""
    least = squared.copy()
    largest = int(squared.max())
    for k in range(1, len(squared)):
        if k * k >= largest:
            break
        step = np.int32(k * k)
        np.minimum(least[k:], squared[:-k] + step, out=least[k:])
        np.minimum(least[:-k], squared[k:] + step, out=least[:-k])
        if k % 8 == 0:
            largest = int(least.max())
    return least


def squared_radii(inside: np.ndarray, progress: Progress = silent) -> np.ndarray:
    """Return for each voxel inside the squared radius of the largest ball inside that covers its centre.

    Parameters
    ----------
    inside : ndarray of shape (P, M, N), bool

    Returns
    -------
    ndarray of shape (P, M, N), int32, in voxels²
        0 outside. A ball of squared radius r² about a voxel covers the voxels at squared distances below r².
    """
    squared = squared_distances(inside, part(progress, 0.0, 0.1))
    largest = int(squared.max())
    if not largest:
        return squared
    # balls reach out of the array by less than their radius: painted into a margin that is cut off
    margin = _reach(largest)
    padded = np.pad(squared, margin)
    centres = _centres(padded, largest, part(progress, 0.1, 0.4))
    values, levels = np.unique(padded.ravel()[centres], return_inverse=True)
    painted = _painted(padded.shape, centres, values, levels.ravel(), part(progress, 0.4, 1.0))
    inner = painted[tuple(slice(margin, margin + n) for n in inside.shape)]
    return np.where(inside, np.concatenate([[0], values]).astype(np.int32)[inner], 0)


def _reach(squared_radius: int) -> int:
    """Largest whole offset below a radius."""
    return int(np.ceil(np.sqrt(squared_radius)))


def _ball(largest: int) -> Tuple[np.ndarray, np.ndarray]:
    """Offsets (K, 3) of the voxels within a squared radius, nearest first, and their squared distances (K,)."""
    span = np.arange(-_reach(largest), _reach(largest) + 1)
    offsets = np.stack(np.meshgrid(span, span, span, indexing="ij"), -1).reshape(-1, 3)
    squared = (offsets**2).sum(1)
    keep = squared < largest
    order = np.argsort(squared[keep], kind="stable")
    return offsets[keep][order], squared[keep][order]


def _needed(step: Tuple[int, int, int], largest: int) -> np.ndarray:
    """Least squared radius (largest + 1,) that a ball ``step`` away needs to cover the ball of each squared radius."""
    offsets, squared = _ball(largest)
    farthest = np.maximum.accumulate(((offsets - step) ** 2).sum(1))
    count = np.searchsorted(squared, np.arange(largest + 1), side="left")
    return np.concatenate([[0], farthest + 1])[count].astype(np.int32)


def _centres(padded: np.ndarray, largest: int, progress: Progress) -> np.ndarray:
    """Flat places of the balls that no single ball up to two voxels away covers.

    A ball that covers another has a larger radius, so of any chain of covering balls the last is kept.
    """
    flat = padded.ravel()
    places = np.nonzero(flat)[0]
    strides = np.array([padded.shape[1] * padded.shape[2], padded.shape[2], 1])
    span = range(-2, 3)
    steps = sorted((s for s in ((z, y, x) for z in span for y in span for x in span) if any(s)), key=_length)
    limits = {}
    for number, step in enumerate(steps):
        progress(number, len(steps), "largest balls")
        kind = triple(sorted(abs(s) for s in step))
        if kind not in limits:
            limits[kind] = _needed(kind, largest)
        neighbours = flat[(places + int(strides @ step)).clip(0, len(flat) - 1)]
        places = places[neighbours < limits[kind][flat[places]]]
    return places


def _length(step: Tuple[int, int, int]) -> int:
    return sum(s * s for s in step)


def _painted(
    shape: Tuple[int, ...], centres: np.ndarray, values: np.ndarray, levels: np.ndarray, progress: Progress
) -> np.ndarray:
    """Return the number, from 1, of the largest ball's radius that covers each voxel; 0 where none does.

    Parameters
    ----------
    shape : tuple of three ints
        Of the array, with a margin as wide as the largest ball.
    centres : ndarray of shape (C,)
        Flat places.
    values : ndarray of shape (L,)
        Squared radii, rising.
    levels : ndarray of shape (C,)
        Numbers of the balls' radii among the values.

    Notes
    -----
    A ball is a bundle of rows along the last direction. The middle of a row with half length h is painted in turn h,
    and between two turns all that is painted grows by one voxel both ways: r² writes for a ball, not r³. In one turn
    the largest ball is painted last.
    """
    kind = np.uint16 if len(values) < 1 << 16 else np.int32
    painted, turn = np.zeros(int(np.prod(shape)), kind), np.empty(int(np.prod(shape)), kind)
    order = np.argsort(levels, kind="stable")
    of_level = np.split(centres[order], np.searchsorted(levels[order], np.arange(1, len(values))))
    offsets, squared = _disc(int(values[-1]), shape)
    longest = _reach(int(values[-1])) - 1
    for half in range(longest, -1, -1):
        turn[:] = 0
        for level in range(int(np.searchsorted(values, half * half, side="right")), len(values)):
            # rows of half length h: h² + q < r² <= (h + 1)² + q
            first, end = np.searchsorted(squared, values[level] - np.array([(half + 1) ** 2, half * half]), side="left")
            for block, rows in _blocks(of_level[level], offsets[first:end]):
                turn[(block[:, None] + rows).ravel()] = level + 1
                progress((longest - half) / (longest + 1), 1.0, "painting balls")
        np.maximum(painted, turn, out=painted)
        if half:
            turn[:] = painted
            np.maximum(painted[1:], turn[:-1], out=painted[1:])
            np.maximum(painted[:-1], turn[1:], out=painted[:-1])
    return painted.reshape(shape)


def _disc(largest: int, shape: Tuple[int, ...]) -> Tuple[np.ndarray, np.ndarray]:
    """Flat offsets (K,) of rows whose squared distance q is below a squared radius, nearest first, and q (K,)."""
    span = np.arange(-_reach(largest), _reach(largest) + 1)
    squared = (span[:, None] ** 2 + span**2).ravel()
    offsets = (span[:, None] * (shape[1] * shape[2]) + span * shape[2]).ravel()
    order = np.argsort(squared, kind="stable")
    order = order[squared[order] < largest]
    return offsets[order], squared[order]


def _blocks(centres: np.ndarray, offsets: np.ndarray) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
    """Yield centres and offsets whose product stays bounded."""
    step = max(1, _WRITES // max(len(offsets), 1))
    if len(offsets):
        for start in range(0, len(centres), step):
            yield centres[start : start + step], offsets


def local_thickness(inside: np.ndarray, size: float, progress: Progress = silent) -> np.ndarray:
    """Return the local thickness: the diameter of the largest inscribed sphere that covers each voxel's centre.

    Parameters
    ----------
    inside : ndarray of shape (P, M, N), bool
    size : float, mm
        Edge of a voxel.

    Returns
    -------
    ndarray of shape (P, M, N), float32, mm
        0 outside.

    Raises
    ------
    MeshError
        If all voxels are inside: no surface, no thickness.
    """
    if inside.all():
        raise MeshError("a thickness needs a surface, got voxels that are all on one side of it")
    radii = squared_radii(inside, progress)
    return (2 * size * np.sqrt(np.arange(int(radii.max()) + 1))).astype(np.float32)[radii]


def size_distribution(thickness: np.ndarray, size: float, within: Optional[np.ndarray] = None) -> SizeDistribution:
    """Return how diameters are spread over a volume.

    Parameters
    ----------
    thickness : ndarray of shape (P, M, N), mm
        As ``local_thickness``.
    size : float, mm
        Edge of a voxel: width of the bins.
    within : ndarray of shape (P, M, N), bool, optional
        Only these voxels count.
    """
    values = thickness[thickness > 0 if within is None else (thickness > 0) & within].astype(np.float64)
    if not len(values):
        return SizeDistribution(0.0, 0.0, 0.0, np.array([0.0, size]), np.zeros(1))
    edges = size * np.arange(int(np.floor(values.max() / size)) + 2)
    counts = np.bincount((values / size).astype(np.int64), minlength=len(edges) - 1)
    return SizeDistribution(float(values.mean()), float(values.std()), float(values.max()), edges, counts / len(values))
