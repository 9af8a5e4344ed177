# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which contour lies in which: holes in trabeculae, islands in holes, on all planes at once."""

from __future__ import annotations

from typing import List, NamedTuple

import numpy as np

_CELLS = 1024  # of a plane's range, at most: an edge meets the few contours in its own cells
_ALL_CELLS = 4_000_000


class Polygons(NamedTuple):
    """Closed polylines on planes: what is needed to nest them.

    Attributes
    ----------
    u, v : ndarray (N,), mm
        Points, polygon by polygon.
    starts : ndarray (C + 1,), plane : ndarray (C,)
        First point and plane of each.
    area : ndarray (C,), mm²
        Signed; those of the area 0 hold nothing.
    leftmost : ndarray (C,)
        Position of a point of least u.
    """

    u: np.ndarray
    v: np.ndarray
    starts: np.ndarray
    plane: np.ndarray
    area: np.ndarray
    leftmost: np.ndarray


def contour_parents(polygons: Polygons, points_at_once: int) -> np.ndarray:
    """Return the smallest polygon (C,) of the same plane that each lies in, -1 for none.

    Notes
    -----
    From the leftmost point of each polygon a ray runs left; the nearest edge that it meets is of the parent, or of a
    polygon beside it with the same parent: the way the edge runs tells which. Edges find the rays that may meet them
    by cells of v. Polygons that cross each other have no nesting; each still gets an answer.
    """
    rays = _Rays(polygons)
    hits = [_hits(polygons, rays, begin, points_at_once) for begin in range(0, len(polygons.u), points_at_once)]
    parent = np.full(len(polygons.plane), -1, np.int64)
    if not hits:
        return parent
    ray, at, polygon, inside = (np.concatenate(column) for column in zip(*hits))
    order = np.lexsort((at, ray))
    nearest = order[np.flatnonzero(np.append(ray[order][1:] != ray[order][:-1], True))] if len(order) else order
    ray, polygon, inside = ray[nearest], polygon[nearest], inside[nearest]
    parent[ray[inside]] = polygon[inside]
    beside = np.arange(len(parent))
    beside[ray[~inside]] = polygon[~inside]
    while True:  # each lies to the left of the one before: no circles
        further = beside[beside]
        if (further == beside).all():
            return parent[beside]
        beside = further


class _Rays:
    """Rays to the left, sorted by plane and cell of v."""

    def __init__(self, polygons: Polygons) -> None:
        planes = int(polygons.plane.max(initial=-1)) + 1
        crowd = int(np.bincount(polygons.plane, minlength=1).max())
        self.cells = max(1, min(_CELLS, 4 * crowd, _ALL_CELLS // max(planes, 1)))
        self.low = polygons.v.min(initial=np.inf)
        extent = polygons.v.max(initial=-np.inf) - self.low
        self.scale = (self.cells - 1) / extent if extent > 0 else 0.0
        cell = polygons.plane * self.cells + self.cell(polygons.v[polygons.leftmost])
        self.order = np.argsort(cell, kind="stable")
        self.before = np.append(0, np.cumsum(np.bincount(cell, minlength=planes * self.cells)))

    def cell(self, v: np.ndarray) -> np.ndarray:
        return ((v - self.low) * self.scale).astype(np.int64)


def _hits(polygons: Polygons, rays: _Rays, begin: int, count: int) -> List[np.ndarray]:
    """Edges from the points ``begin`` on that rays meet: ray, where (u), polygon, whether the ray comes from inside."""
    u, v, starts = polygons.u[begin : begin + count], polygons.v[begin : begin + count], polygons.starts
    point = np.arange(begin, begin + len(u))
    first = int(np.searchsorted(starts, begin, "right")) - 1
    last = int(np.searchsorted(starts, begin + len(u), "left"))
    sizes = np.minimum(starts[first + 1 : last + 1], begin + len(u)) - np.maximum(starts[first:last], begin)
    of = np.repeat(np.arange(first, last), sizes)
    cell = rays.cell(v)
    after = point + 1
    ends = starts[first + 1 : last + 1]
    ends = ends[ends <= begin + len(u)]
    after[ends - 1 - begin] = starts[first : first + len(ends)]
    outside = after - begin
    cell_after = np.where((outside >= 0) & (outside < len(u)), cell[outside % len(u)], -1)
    far = np.flatnonzero(cell_after < 0)
    cell_after[far] = rays.cell(polygons.v[after[far]])
    base = polygons.plane[of] * rays.cells
    low = rays.before[base + np.minimum(cell, cell_after)]
    number = rays.before[base + np.maximum(cell, cell_after) + 1] - low
    some = np.flatnonzero(number)
    number, low = number[some], low[some]
    edge = np.repeat(some, number)
    ray = rays.order[np.arange(len(edge)) + np.repeat(low - np.cumsum(number) + number, number)]
    a, b = u[edge], v[edge]
    c, d = polygons.u[after[edge]], polygons.v[after[edge]]
    tip, level, of = polygons.u[polygons.leftmost[ray]], polygons.v[polygons.leftmost[ray]], of[edge]
    meets = np.flatnonzero(((b <= level) != (d <= level)) & (of != ray) & (polygons.area[of] != 0))
    a, b, c, d, level = (x[meets] for x in (a, b, c, d, level))
    at = a + (level - b) * ((c - a) / (d - b))
    left = np.flatnonzero(at < tip[meets])
    of = of[meets][left]
    return [ray[meets][left], at[left], of, (polygons.area[of] > 0) == (d < b)[left]]
