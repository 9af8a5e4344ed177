# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a region of the plane between border segments, through given points: constrained Delaunay.

scipy's Delaunay triangulation is unique but for points on one circle, and those are parted by a small shift that
depends on their place alone, so that every version gives the same triangles. Border segments that it lacks are
recovered by flipping edges (Sloan 1993, doi:10.1016/0045-7949(93)90239-A).
"""

from __future__ import annotations

from typing import Dict, List, Tuple

import numpy as np

from ..errors import MeshError
from .optional_packages import optional_module

_SHIFT = 1e-5  # of the mean length of a border segment
_WAVES = np.array([[3.7, -2.3], [1.9, 4.1]])  # radians per length; any that do not fit a regular grid
_BLOCK = 2_000_000  # pairs of points and segments worked on at once


def triangulate(points: np.ndarray, segments: np.ndarray) -> np.ndarray:
    """Return the triangles (T, 3), counter-clockwise, of the region that segments enclose.

    Parameters
    ----------
    points : ndarray of shape (P, 2)
        All points; those inside the region and those of its border.
    segments : ndarray of shape (S, 2), int
        The border, closed; holes count by parity. Ways round do not matter.

    Raises
    ------
    DependencyError
        If scipy is not installed.
    MeshError
        If a segment crosses another or runs through a point, or a point stays unused.
    """
    spatial = optional_module("scipy.spatial", "triangles between trimmed borders need the Python package scipy")
    shifted = _shifted(points, segments)
    triangles = spatial.Delaunay(shifted).simplices.astype(np.int64)
    a, b, c = (shifted[triangles[:, k]] for k in range(3))
    turned = _cross(b - a, c - a) < 0
    triangles[turned] = triangles[turned][:, [0, 2, 1]]
    third = {(i, j): k for t in triangles.tolist() for i, j, k in (t, t[1:] + t[:1], t[2:] + t[:2])}
    xy = list(map(tuple, shifted.tolist()))
    for start, end in segments.tolist():
        if (start, end) not in third and (end, start) not in third:
            _recover(third, xy, start, end)
    triangles = np.array(sorted({_first_least(i, j, k) for (i, j), k in third.items()}), np.int64)
    triangles = triangles[inside(shifted[triangles].mean(1), shifted, segments)]
    if len(np.unique(triangles)) != len(points):
        raise MeshError("each point of a face must be used by its triangles; a border crosses itself")
    return triangles


def inside(places: np.ndarray, points: np.ndarray, segments: np.ndarray) -> np.ndarray:
    """Return which places (Q, 2) lie inside closed borders, by parity, ndarray of shape (Q,), bool."""
    a, b = points[segments[:, 0]], points[segments[:, 1]]
    found = np.zeros(len(places), bool)
    block = max(1, _BLOCK // max(1, len(segments)))
    for start in range(0, len(places), block):
        x, y = places[start : start + block].T[:, :, None]
        over = (a[:, 1] > y) != (b[:, 1] > y)
        rise = np.where(b[:, 1] == a[:, 1], 1.0, b[:, 1] - a[:, 1])
        beyond = a[:, 0] + (y - a[:, 1]) * ((b[:, 0] - a[:, 0]) / rise) > x
        found[start : start + block] = (over & beyond).sum(1) % 2 == 1
    return found


def distances(places: np.ndarray, points: np.ndarray, segments: np.ndarray) -> np.ndarray:
    """Return the distance of places (Q, 2) to the nearest segment, ndarray of shape (Q,)."""
    a, along = points[segments[:, 0]], points[segments[:, 1]] - points[segments[:, 0]]
    length2 = np.maximum((along**2).sum(1), 1e-300)
    found = np.zeros(len(places))
    block = max(1, _BLOCK // max(1, len(segments)))
    for start in range(0, len(places), block):
        off = places[start : start + block, None] - a
        share = ((off * along).sum(2) / length2).clip(0, 1)
        found[start : start + block] = np.sqrt(((off - share[:, :, None] * along) ** 2).sum(2).min(1))
    return found


def _shifted(points: np.ndarray, segments: np.ndarray) -> np.ndarray:
    """Points, each moved a little by waves over the plane: points that differ by rounding still do by no more."""
    length = np.linalg.norm(points[segments[:, 1]] - points[segments[:, 0]], axis=1).mean()
    return points + _SHIFT * length * np.sin(points / length @ _WAVES)


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _first_least(i: int, j: int, k: int) -> Tuple[int, int, int]:
    return (i, j, k) if i < j and i < k else (j, k, i) if j < k else (k, i, j)


def _turn(xy: List[Tuple[float, float]], i: int, j: int, k: int) -> float:
    """Twice the signed area of the triangle i, j, k."""
    (x0, y0), (x1, y1), (x2, y2) = xy[i], xy[j], xy[k]
    return (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)


def _crosses(xy: List[Tuple[float, float]], a: int, b: int, i: int, j: int) -> bool:
    if len({a, b, i, j}) < 4:
        return False
    return _turn(xy, a, b, i) * _turn(xy, a, b, j) < 0 and _turn(xy, i, j, a) * _turn(xy, i, j, b) < 0


def _recover(third: Dict[Tuple[int, int], int], xy: List[Tuple[float, float]], a: int, b: int) -> None:
    """Flip the edges that cross the segment a, b until it is one."""
    queue = [(i, j) for i, j in third if i < j and _crosses(xy, a, b, i, j)]
    for _ in range(20 + 10 * len(queue) ** 2):
        if not queue:
            break
        i, j = queue.pop(0)
        k, l = third[i, j], third[j, i]  # noqa: E741  four corners of a quadrangle
        if not _crosses(xy, i, j, k, l):  # not convex
            queue.append((i, j))
            continue
        for edge in ((i, j), (j, k), (k, i), (j, i), (i, l), (l, j)):
            del third[edge]
        for p, q, r in ((k, l, j), (l, k, i)):
            third[p, q], third[q, r], third[r, p] = r, p, q
        if _crosses(xy, a, b, k, l):
            queue.append((k, l))
    if (a, b) not in third and (b, a) not in third:
        raise MeshError("the border of a face must not cross itself, nor run through a point of its own")
