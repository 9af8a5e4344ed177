# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles that run through each other."""

from __future__ import annotations

from typing import Iterator, NamedTuple, Tuple

import numpy as np

from ..progress import Progress, part, silent
from .triangles import by_corners

_PAIRS = 200_000  # worked on at once
_TRIANGLES = 100_000  # in a slab of cells
_CELL = 1.5  # edge of a cell in sizes of the middle triangle: fewer triangles in a cell, or in fewer cells
_MOST_CELLS = 1000  # in a direction
_WHAT = "looking for triangles that cross"
_TOUCHING = 1e-9  # of the size of a triangle: nearer is touching


def crossing_triangles(triangles: np.ndarray, keys: np.ndarray, progress: Progress = silent) -> np.ndarray:
    """Return whether each triangle (T,) bool is run through by an edge of another, or runs an edge through one.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), float32, mm
    keys : ndarray of shape (3, T), uint64
        A number for each corner, equal for equal points (``neighbours.corner_keys``).

    Notes
    -----
    Pairs whose boxes meet are found in a grid of cells; edges that share a corner with the other triangle are left out,
    so that neighbours do not count. An edge crosses a triangle if its ends lie on both sides of it, and the triangle's
    edges all on one side of the edge's line (signed volumes, double precision). Touching does not count.
    """
    crossing = np.zeros(len(triangles), bool)
    corners = np.ascontiguousarray(triangles, np.float32)
    progress(0.0, 1.0, _WHAT)
    for a, b in _close_pairs(by_corners(triangles).reshape(3, 3, -1), progress):
        shared = sum((keys[k, a] == keys[m, b]).view(np.int8) for k in range(3) for m in range(3))
        a, b = a[shared < 2], b[shared < 2]
        for _ in range(2):
            apart = _on_one_side(corners[a], corners[b])
            b, a = a[~apart], b[~apart]
        for edges_of, face in ((a, b), (b, a)):
            for k in range(3):
                start, end = keys[k, edges_of], keys[(k + 1) % 3, edges_of]
                fresh = np.flatnonzero(((keys[:, face] != start) & (keys[:, face] != end)).all(0))
                one, other = edges_of[fresh], face[fresh]
                hit = _pierces(corners[one, k].astype(float), corners[one, (k + 1) % 3].astype(float),
                               corners[other].astype(float))  # fmt: skip
                crossing[one[hit]] = crossing[other[hit]] = True
    return crossing


def _cross(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Cross products (3, E), co-ordinates first: several times as fast as ``np.cross``."""
    return np.stack([p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]])


def _on_one_side(faces: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Whether each other triangle lies on one side of a face's plane, corners near it allowed; (E, 3, 3) both."""
    a, b, c = (faces[:, k].T.astype(float) for k in range(3))
    normal = _cross(b - a, c - a)
    sides = np.stack([((others[:, k].T - a) * normal).sum(0) for k in range(3)])
    slack = _TOUCHING * (normal**2).sum(0) ** 0.75  # |normal| is the square of a length
    return (sides >= -slack).all(0) | (sides <= slack).all(0)


def _pierces(start: np.ndarray, end: np.ndarray, face: np.ndarray) -> np.ndarray:
    """Which edges (E, 3) to (E, 3) run through the triangles (E, 3, 3)."""
    a, b, c = ((face[:, k] - start).T for k in range(3))
    line = (end - start).T
    normal = _cross(b - a, c - a)
    below, above = -(normal * a).sum(0), (normal * (line - a)).sum(0)
    sides = [(_cross(p, q) * line).sum(0) for p, q in ((a, b), (b, c), (c, a))]
    same = (np.minimum.reduce(sides) > 0) | (np.maximum.reduce(sides) < 0)
    return np.flatnonzero((below * above < 0) & same)


class _Cells(NamedTuple):
    """First and last cell (T, 3) of each triangle's box, and the boxes."""

    first: np.ndarray
    last: np.ndarray
    low: np.ndarray
    high: np.ndarray


def _close_pairs(points: np.ndarray, progress: Progress) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
    """Pairs of triangles whose boxes meet, each once: slab by slab of cells; points (co-ordinate, corner, T)."""
    low, high = (np.ascontiguousarray(x.T) for x in (points.min(1), points.max(1)))
    origin = low.min(0)
    extent = float((high.max(0) - origin).max())
    size = max(float(np.median((high - low).max(1))) * _CELL, extent / _MOST_CELLS, 1e-9)
    first, last = (((x - origin) / size).astype(np.int32) for x in (low, high))
    cells = _Cells(first, last, low, high)
    layers = np.cumsum(np.bincount(cells.first[:, 2]))
    bottom, top = 0, len(layers)
    while bottom < top:
        done = layers[bottom - 1] if bottom else 0
        stop = min(max(bottom + 1, int(np.searchsorted(layers, done + _TRIANGLES, "right"))), top)
        yield from _pairs_in_slab(cells, bottom, stop, part(progress, bottom / top, stop / top))
        bottom = stop


def _pairs_in_slab(cells: _Cells, bottom: int, top: int,
                   progress: Progress) -> Iterator[Tuple[np.ndarray, np.ndarray]]:  # fmt: skip
    """Pairs that meet in the cells of some layers: each in the cell of the lowest corner of what their boxes share."""
    progress(0.0, 1.0, _WHAT)
    some = np.flatnonzero((cells.first[:, 2] < top) & (cells.last[:, 2] >= bottom)).astype(np.int32)
    first, last = cells.first[some].copy(), cells.last[some].copy()
    first[:, 2], last[:, 2] = np.maximum(first[:, 2], bottom), np.minimum(last[:, 2], top - 1)
    spans = last - first + 1
    number = spans.prod(1)
    of = np.repeat(np.arange(len(some), dtype=np.int32), number)
    step = np.arange(len(of)) - np.repeat(np.cumsum(number) - number, number)
    wide, deep = spans[of, 0], spans[of, 1]
    at = (first[of, 0] + step % wide, first[of, 1] + step // wide % deep, first[of, 2] + step // (wide * deep))
    columns, rows = int(last[:, 0].max()) + 1, int(last[:, 1].max()) + 1
    cell = (at[2].astype(np.int64) * rows + at[1]) * columns + at[0]
    order = np.argsort(cell, kind="stable")
    of, cell, at = some[of[order]], cell[order], np.stack(at, 1)[order]
    later = np.searchsorted(cell, cell, "right") - np.arange(len(cell)) - 1  # those after each in its cell
    ends, begin = np.cumsum(later), 0
    while begin < len(cell):
        done = ends[begin - 1] if begin else 0
        stop = max(begin + 1, int(np.searchsorted(ends, done + _PAIRS, "right")))
        count = later[begin:stop]
        entry = np.repeat(np.arange(begin, stop), count)
        other = entry + 1 + np.arange(len(entry)) - np.repeat(ends[begin:stop] - count - done, count)
        a, b = of[entry], of[other]
        for k in range(3):
            meet = np.flatnonzero((cells.low[a, k] <= cells.high[b, k]) & (cells.low[b, k] <= cells.high[a, k])
                                  & (np.maximum(cells.first[a, k], cells.first[b, k]) == at[entry, k]))  # fmt: skip
            a, b, entry = a[meet], b[meet], entry[meet]
        yield a, b
        progress(ends[stop - 1], max(int(ends[-1]), 1), _WHAT)
        begin = stop
