# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outside of blocks as few rectangles, to be looked at: faces of voxels that lie in one plane are merged.

Corners of rectangles lie on the edges of others: it is no closed mesh. What is printed is ``blocks.block_mesh``.
"""

from __future__ import annotations

from typing import NamedTuple, Optional, Tuple

import numpy as np


class Rectangles(NamedTuple):
    """Rectangles along the axes, the six ways they face one after the other.

    Attributes
    ----------
    corners : ndarray of shape (R, 4, 3), int32
        Corners (x, y, z) in voxels, counter-clockwise from outside.
    counts : tuple of 6 int
        Rectangles that face -X, +X, -Y, +Y, -Z, +Z.
    """

    corners: np.ndarray
    counts: Tuple[int, ...]


def merged_faces(voxels: np.ndarray, apart: Optional[int] = None) -> Rectangles:
    """Return the faces between solid and void as rectangles: runs of faces, and runs that lie side by side as one.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    apart : int or None
        0, 1, 2: the layers along x, y or z have rectangles of their own, which can be told apart by colours.

    Examples
    --------
    >>> merged_faces(np.ones((2, 3, 4), bool)).counts
    (1, 1, 1, 1, 1, 1)
    >>> merged_faces(np.ones((2, 3, 4), bool), apart=2).counts
    (2, 2, 2, 2, 1, 1)
    >>> merged_faces(np.array([[[1, 1], [1, 0]]], bool)).counts  # an L
    (1, 2, 1, 2, 2, 2)
    """
    found, counts = [], []
    for axis in range(3):  # x, y, z
        layers = np.moveaxis(voxels, 2 - axis, 0)
        rest = [k for k in range(3) if k != axis]  # the layer's columns and rows
        for side in (0, 1):
            beyond = np.zeros_like(layers)
            if side:
                beyond[:-1] = layers[1:]
            else:
                beyond[1:] = layers[:-1]
            rows = _rectangles(layers & ~beyond, rest.index(apart) if apart in rest else None)
            corners = np.empty((len(rows), 4, 3), np.int32)
            layer, low_row, high_row, low, high = rows.T
            corners[:, :, axis] = (layer + side)[:, None]
            corners[:, :, rest[0]] = np.stack([low, high, high, low], 1)
            corners[:, :, rest[1]] = np.stack([low_row, low_row, high_row, high_row], 1)
            # columns x rows points along +X and +Z, but along -Y
            found.append(corners if (axis != 1) == bool(side) else corners[:, ::-1])
            counts.append(len(rows))
    return Rectangles(np.concatenate(found), tuple(counts))


def _rectangles(faces: np.ndarray, apart: Optional[int]) -> np.ndarray:
    """Layer, first and last row, first and last column (ends excluded) of rectangles that cover faces, (R, 5).

    ``apart``: 0, each lies in one column; 1, each lies in one row.
    """
    found = []
    if apart != 0:
        found.append(_merged_runs(faces, apart is None))
    if apart != 1:
        found.append(_merged_runs(faces.transpose(0, 2, 1), apart is None)[:, [0, 3, 4, 1, 2]])
    return min(found, key=len)


def _merged_runs(faces: np.ndarray, merges_rows: bool) -> np.ndarray:
    """The same, of runs along columns; those that are as long and follow each other row by row as one."""
    layers, rows, columns = faces.shape
    padded = np.zeros((layers, rows, columns + 2), np.int8)
    padded[:, :, 1:-1] = faces
    steps = np.diff(padded, axis=2)
    layer, row, low = np.nonzero(steps > 0)
    high = np.nonzero(steps < 0)[2]
    order = np.lexsort((row, high, low, layer))
    layer, row, low, high = layer[order], row[order], low[order], high[order]
    first = np.ones(len(row), bool)
    same = (np.diff(layer) == 0) & (np.diff(low) == 0) & (np.diff(high) == 0)
    first[1:] = ~(same & (np.diff(row) == 1) & merges_rows)
    starts = np.flatnonzero(first)
    lengths = np.diff(np.append(starts, len(row)))
    return np.stack([layer[starts], row[starts], row[starts] + lengths, low[starts], high[starts]], 1)


def layers_of(rectangles: Rectangles, axis: int) -> np.ndarray:
    """Return the layer along x, y or z (0, 1, 2), (R,), that rectangles bound, or in whose middle one is.

    Examples
    --------
    >>> layers_of(merged_faces(np.ones((2, 1, 1), bool), apart=2), 2).tolist()  # -X, +X, -Y, +Y, -Z, +Z
    [0, 1, 0, 1, 0, 1, 0, 1, 0, 1]
    """
    places = rectangles.corners[:, :, axis]
    inwards = np.zeros(6)
    inwards[2 * axis : 2 * axis + 2] = 0.5, -0.5
    middles = (places.min(1) + places.max(1)) / 2 + np.repeat(inwards, rectangles.counts)
    return np.floor(middles).astype(np.int64)


def coarse_faces(voxels: np.ndarray, most: int, apart: Optional[int] = None) -> Rectangles:
    """Return the faces of coarser blocks, of 2, 3 ... voxels' edge, that take no more than so many rectangles.

    A coarse block is solid where at least half of its cells are. Corners are in voxels, none outside the box.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    most : int
    apart : int or None
        As ``merged_faces``, of layers of coarser blocks.
    """
    box = np.array(voxels.shape[::-1], np.int32)
    for size in range(2, int(box.max()) + 2):
        padded = np.pad(voxels, [(0, -count % size) for count in voxels.shape])
        p, m, n = (count // size for count in padded.shape)
        share = padded.reshape(p, size, m, size, n, size).mean((1, 3, 5), dtype=np.float32)
        found = merged_faces(share >= 0.5, apart)
        if len(found.corners) <= most:
            break
    return Rectangles(np.minimum(found.corners * size, box), found.counts)


def sampled_faces(voxels: np.ndarray, most: int) -> Rectangles:
    """Return the faces of blocks that stand for every s-th voxel, at most so many along an edge: a first look, at once.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    most : int

    Examples
    --------
    >>> sampled_faces(np.ones((90, 60, 30), bool), 30).corners.max((0, 1)).tolist()
    [30, 60, 90]
    """
    size = -(-max(voxels.shape) // most)
    found = merged_faces(voxels[size // 2 :: size, size // 2 :: size, size // 2 :: size])
    return Rectangles(np.minimum(found.corners * size, np.array(voxels.shape[::-1], np.int32)), found.counts)
