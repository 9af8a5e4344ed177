# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which contour lies in which: holes in trabeculae, islands in holes, on all planes at once."""

from __future__ import annotations

from typing import Iterator, NamedTuple, Tuple

import numpy as np

_POINTS = 50_000  # worked on at once: temporary arrays stay in the processor's cache
_PAIRS = 500_000
_CELLS = 1024  # of the range of v on a plane, at most: an edge meets the rays in its own cells only
_ALL_CELLS = 1_000_000


class Polygons(NamedTuple):
    """Closed polylines on planes.

    Attributes
    ----------
    points : ndarray (N, 2), mm
        Polygon by polygon; the first point is not repeated.
    starts : ndarray (C + 1,), plane : ndarray (C,)
        First point of each; its plane, ascending.
    area : ndarray (C,), mm²
        Positive for outer ones, negative for holes.
    low, high : ndarray (2, C), mm
        Corners of the boxes.
    """

    points: np.ndarray
    starts: np.ndarray
    plane: np.ndarray
    area: np.ndarray
    low: np.ndarray
    high: np.ndarray


class _Rays(NamedTuple):
    """Rays to the left from points (R, 2) of polygons, sorted by plane and cell of v; how many before each cell."""

    polygon: np.ndarray
    tip: np.ndarray
    before: np.ndarray
    cells: int
    low: float
    scale: float

    def cell(self, v: np.ndarray) -> np.ndarray:
        return ((v - self.low) * self.scale).astype(np.int32)


def contour_parents(polygons: Polygons) -> np.ndarray:
    """Return the smallest outer polygon (C,) round each hole, and hole round each outer one; -1 for none.

    Notes
    -----
    Only those come into question whose boxes lie in one another. From the leftmost point of the inner one a ray runs
    left: it is inside if the ray meets the outer one's edges an odd number of times. Edges find the rays that they may
    meet by cells of v.
    """
    parent = np.full(len(polygons.plane), -1, np.int64)
    inner, outer = np.zeros(len(parent), bool), np.zeros(len(parent), bool)
    for hole, solid in _pairs_of_opposite_sign(polygons):
        for one, other in (_boxed(polygons, hole, solid), _boxed(polygons, solid, hole)):
            inner[one] = outer[other] = True
    if not inner.any():
        return parent
    rays, hosts = _rays(polygons, np.flatnonzero(inner)), np.flatnonzero(outer)
    ends = np.cumsum(np.diff(polygons.starts)[hosts])
    begin, hits = 0, []
    while begin < len(hosts):
        done = ends[begin - 1] if begin else 0
        stop = max(begin + 1, int(np.searchsorted(ends, done + _POINTS, "right")))
        hits.append(_hits(polygons, rays, hosts[begin:stop]))
        begin = stop
    # (inner, outer) of each hit; those hit an odd number of times
    pairs, times = np.unique(np.concatenate(hits), return_counts=True)
    a, b = np.divmod(pairs[times % 2 == 1], len(parent))
    fits = (polygons.area[a] > 0) != (polygons.area[b] > 0)
    a, b = a[fits], b[fits]
    order = np.argsort(-np.abs(polygons.area[b]), kind="stable")
    parent[a[order]] = b[order]  # the smallest is written last
    return parent


def _boxed(polygons: Polygons, one: np.ndarray, other: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Those pairs in which the box of one lies in the box of the other; each side leaves fewer for the next."""
    for k in range(2):
        for side in (polygons.low[k], -polygons.high[k]):
            fits = np.flatnonzero(side[other] <= side[one])
            one, other = one[fits], other[fits]
    return one, other


def _pairs_of_opposite_sign(polygons: Polygons) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
    """All pairs of a hole and an outer polygon of the same plane, some at a time."""
    holes = np.flatnonzero(polygons.area < 0)
    first = np.searchsorted(polygons.plane, polygons.plane[holes], "left")
    number = np.searchsorted(polygons.plane, polygons.plane[holes], "right") - first
    ends, begin = np.cumsum(number), 0
    while begin < len(holes):
        done = ends[begin - 1] if begin else 0
        stop = max(begin + 1, int(np.searchsorted(ends, done + _PAIRS, "right")))
        size = number[begin:stop]
        hole = np.repeat(holes[begin:stop], size)
        other = np.arange(len(hole)) + np.repeat(first[begin:stop] - np.cumsum(size) + size, size)
        solid = polygons.area[other] > 0
        yield hole[solid], other[solid]
        begin = stop


def _rays(polygons: Polygons, inner: np.ndarray) -> _Rays:
    planes = int(polygons.plane[-1]) + 1
    crowd = int(np.bincount(polygons.plane[inner]).max())
    cells = max(1, min(_CELLS, 4 * crowd, _ALL_CELLS // planes))
    low, high = float(polygons.low[1].min()), float(polygons.high[1].max())
    tip = _leftmost(polygons, inner)
    rays = _Rays(inner, tip, np.zeros(1), cells, low, (cells - 1) / (high - low) if high > low else 0.0)
    cell = polygons.plane[inner] * cells + rays.cell(tip[:, 1])
    order = np.argsort(cell, kind="stable")
    before = np.append(0, np.cumsum(np.bincount(cell, minlength=planes * cells))).astype(np.int32)
    return rays._replace(polygon=inner[order], tip=tip[order], before=before)


def _leftmost(polygons: Polygons, some: np.ndarray) -> np.ndarray:
    """A point (R, 2) of least u of each of some polygons."""
    source, begins = _points_of(polygons, some)
    u = polygons.points[source, 0]
    at_low = np.flatnonzero(u == np.repeat(polygons.low[0, some], np.diff(polygons.starts)[some]))
    return polygons.points[source[at_low[np.searchsorted(at_low, begins)]]]


def _points_of(polygons: Polygons, some: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Positions of all points of some polygons, and where among them each begins."""
    sizes = np.diff(polygons.starts)[some]
    begins = np.cumsum(sizes) - sizes
    return np.arange(begins[-1] + sizes[-1]) + np.repeat(polygons.starts[some] - begins, sizes), begins


def _hits(polygons: Polygons, rays: _Rays, hosts: np.ndarray) -> np.ndarray:
    """One number, ray x C + polygon, for each time that a ray meets an edge of the polygons ``hosts``."""
    source, begins = _points_of(polygons, hosts)
    sizes = np.diff(polygons.starts)[hosts]
    u, v = polygons.points[source, 0], polygons.points[source, 1]
    after = np.arange(1, len(u) + 1)
    after[begins + sizes - 1] = begins
    cell = rays.cell(v) + np.repeat((polygons.plane[hosts] * rays.cells).astype(np.int32), sizes)
    other = cell[after]
    low = rays.before[np.minimum(cell, other)]
    number = rays.before[np.maximum(cell, other) + 1] - low
    edges = np.flatnonzero(number)
    low, number = low[edges], number[edges]
    edge = np.repeat(edges, number)
    ray = np.arange(len(edge)) + np.repeat(low - np.cumsum(number) + number, number)
    tip = rays.tip[ray]
    meets = np.flatnonzero((v[edge] <= tip[:, 1]) != (v[after[edge]] <= tip[:, 1]))
    edge, ray, tip = edge[meets], ray[meets], tip[meets]
    a, b, c, d = u[edge], v[edge], u[after[edge]], v[after[edge]]
    left = np.flatnonzero(a + (tip[:, 1] - b) * ((c - a) / (d - b)) < tip[:, 0])
    host = hosts[np.searchsorted(begins, edge[left], "right") - 1]
    return rays.polygon[ray[left]].astype(np.int64) * len(polygons.plane) + host
