# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles that run through each other."""

from __future__ import annotations

from typing import Iterator, Tuple

import numpy as np

from ..progress import Progress, silent

_PAIRS = 500_000  # worked on at once


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
    for a, b in _close_pairs(corners, progress):
        a, b = _apart_or_touching(keys, a, b)
        for edges_of, face in ((a, b), (b, a)):
            for k in range(3):
                start, end = keys[k, edges_of], keys[(k + 1) % 3, edges_of]
                fresh = np.flatnonzero(((keys[:, face] != start) & (keys[:, face] != end)).all(0))
                one, other = edges_of[fresh], face[fresh]
                hit = _pierces(corners[one, k].astype(float), corners[one, (k + 1) % 3].astype(float),
                               corners[other].astype(float))  # fmt: skip
                crossing[one[hit]] = crossing[other[hit]] = True
    return crossing


def _apart_or_touching(keys: np.ndarray, a: np.ndarray, b: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Leave out pairs that share an edge."""
    shared = sum((keys[k, a] == keys[m, b]).astype(np.int8) for k in range(3) for m in range(3))
    return a[shared < 2], b[shared < 2]


def _pierces(start: np.ndarray, end: np.ndarray, face: np.ndarray) -> np.ndarray:
    """Which edges (E, 3) to (E, 3) run through the triangles (E, 3, 3)."""
    a, b, c = (face[:, k] - start for k in range(3))
    line = end - start
    normal = np.cross(b - a, c - a)
    below, above = -(normal * a).sum(1), (normal * (line - a)).sum(1)
    sides = [(np.cross(p, q) * line).sum(1) for p, q in ((a, b), (b, c), (c, a))]
    same = (np.minimum.reduce(sides) > 0) | (np.maximum.reduce(sides) < 0)
    return np.flatnonzero((below * above < 0) & same)


def _close_pairs(corners: np.ndarray, progress: Progress) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
    """Pairs of triangles whose boxes meet, each once: cells of a grid first, some cells at a time."""
    low, high = corners.min(1), corners.max(1)
    origin = low.min(0)
    size = max(float(np.median((high - low).max(1))) * 2.0, float((high.max(0) - origin).max()) / 1000, 1e-9)
    first, last = (np.floor((x - origin) / size).astype(np.int64) for x in (low, high))
    spans = last - first + 1
    number = spans.prod(1)
    shape = last.max(0) + 1
    of = np.repeat(np.arange(len(corners)), number)
    step = np.arange(len(of)) - np.repeat(np.cumsum(number) - number, number)
    offset = np.stack(
        [step % spans[of, 0], step // spans[of, 0] % spans[of, 1], step // (spans[of, 0] * spans[of, 1])], 1
    )
    at = first[of] + offset
    cell = (at[:, 2] * shape[1] + at[:, 1]) * shape[0] + at[:, 0]
    order = np.argsort(cell, kind="stable")
    of, cell, at = of[order], cell[order], at[order]
    # partners of an entry: those after it in its cell
    ends = np.searchsorted(cell, cell, "right")
    later = ends - np.arange(len(cell)) - 1
    total, begin = np.cumsum(later), 0
    while begin < len(cell):
        before = total[begin - 1] if begin else 0
        stop = max(begin + 1, int(np.searchsorted(total, before + _PAIRS, "right")))
        entry = np.repeat(np.arange(begin, stop), later[begin:stop])
        other = (
            entry
            + 1
            + np.arange(len(entry))
            - np.repeat(total[begin:stop] - later[begin:stop] - before, later[begin:stop])
        )
        a, b = of[entry], of[other]
        overlap = ((low[a] <= high[b]) & (low[b] <= high[a])).all(1)
        # each pair once: in the cell of the lowest corner of what their boxes share
        overlap &= (np.maximum(first[a], first[b]) == at[entry]).all(1)
        yield a[overlap], b[overlap]
        progress(total[stop - 1], total[-1], "looking for triangles that cross")
        begin = stop
