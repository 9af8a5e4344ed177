# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parallel rays through closed meshes: volumes and insides of their union without any Boolean.

Every place where rounding could decide differently for two triangles that share an edge or a vertex is computed from
that edge or vertex alone: a row of rays meets an edge whose ends lie on different sides (half open: on the line
counts as beyond), and the point where it does comes from the edge's lower and upper end, never from the triangle. So
on a closed mesh the signs of every ray add to 0 exactly, also where rays run through vertices, edges or faces. All
rays behave as if moved by an infinitely small step towards larger co-ordinates.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterator, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import MeshError, ParameterError

_BLOCK = 400_000  # rows or crossings worked on at once: about 60 MB of temporary arrays
_BUCKETS = 512  # most buckets per direction when points are looked up


class RayVolume(NamedTuple):
    """A volume by rays and its estimated error, both mm³."""

    volume: float
    error: float


class Crossings(NamedTuple):
    """Where rays cross triangles.

    Attributes
    ----------
    ray : ndarray of shape (H,), int64
        Number of the ray: ``i * count_v + j`` for ray (i, j) of the grid.
    at : ndarray of shape (H,), mm
        Co-ordinate along the axis.
    sign : ndarray of shape (H,), int8
        +1 entering, -1 leaving, for triangles that turn counter-clockwise seen from outside.
    """

    ray: np.ndarray
    at: np.ndarray
    sign: np.ndarray


@dataclass(frozen=True)
class RayGrid:
    """Rays along ``axis`` through a regular grid in the plane of the other two, u = axis + 1 and v = axis + 2 (mod 3).

    Attributes
    ----------
    axis : int
        0, 1 or 2.
    origin, step : tuple of two floats, mm
        Ray (i, j) runs at (origin_u + i step_u, origin_v + j step_v).
    first, count : tuple of two ints
        Rays with first <= i < first + count take part; the same ray has the same place in every part of a grid.
    """

    axis: int
    origin: Tuple[float, float]
    step: Tuple[float, float]
    first: Tuple[int, int]
    count: Tuple[int, int]

    @property
    def axes(self) -> Tuple[int, int, int]:
        """The axes u, v and that of the rays."""
        return (self.axis + 1) % 3, (self.axis + 2) % 3, self.axis

    @classmethod
    def of_box(cls, low: ArrayLike, high: ArrayLike, cells: int, axis: int) -> RayGrid:
        """Return ``cells`` x ``cells`` rays through the centres of equal cells of the box ``low``..``high`` (3,), mm.

        Raises
        ------
        ParameterError
            If ``cells`` < 1, the box is empty, or there is no such axis.
        """
        low, high = np.asarray(low, float), np.asarray(high, float)
        if axis not in (0, 1, 2):
            raise ParameterError(f"the axis of rays must be 0, 1 or 2, got {axis}")
        if cells < 1:
            raise ParameterError(f"rays per direction must be >= 1, got {cells}")
        if not (np.isfinite(low).all() and np.isfinite(high).all() and (high > low).all()):
            raise ParameterError(f"a box must satisfy low < high on every axis, got {low} and {high} mm")
        u, v = (axis + 1) % 3, (axis + 2) % 3
        step = (high - low) / cells
        start = low + step / 2
        return cls(axis, (start[u], start[v]), (step[u], step[v]), (0, 0), (cells, cells))

    def numbers(self, values: np.ndarray, direction: int) -> np.ndarray:
        """Return how many rays of the whole line lie below each value (mm), cut to first..first + count; int32."""
        number = np.ceil((values - self.origin[direction]) * (1.0 / self.step[direction]))
        first = self.first[direction]
        return np.clip(number, first, first + self.count[direction]).astype(np.int32)


def crossings(triangles: np.ndarray, grid: RayGrid) -> Crossings:
    """Return where the rays of a grid cross triangles, sorted by ray, then along it.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
        Corners of one or many closed meshes; meshes may overlap, and equal corners must be equal bit by bit.
    grid : RayGrid

    Returns
    -------
    Crossings
        On each ray the signs add to 0 if the meshes are closed.
    """
    blocks = list(crossing_blocks(triangles, grid))
    if not blocks:
        return Crossings(np.zeros(0, np.int64), np.zeros(0), np.zeros(0, np.int8))
    i, j, at, sign = (np.concatenate(column) for column in zip(*blocks))
    return sorted_crossings(i * grid.count[1] + j, at, sign)


def sorted_crossings(ray: np.ndarray, at: np.ndarray, sign: np.ndarray) -> Crossings:
    """Return crossings in the order of the rays and along them."""
    return Crossings(*_sorted(ray, at, sign))


def crossing_blocks(triangles: np.ndarray, grid: RayGrid) -> Iterator[Tuple[np.ndarray, ...]]:
    """Yield crossings, not sorted, in blocks of bounded size: i and j from the grid's first, at, sign, each (H,)."""
    if not np.isfinite(triangles).all():
        raise MeshError("co-ordinates of triangles must be finite, got nan or infinite mm")
    met = np.nonzero(_may_meet(triangles, grid))[0]
    for start in range(0, len(met), _BLOCK // 4):
        corners, turn = _by_height(triangles[met[start : start + _BLOCK // 4]], grid.axes)
        rows = grid.numbers(corners[:, :, 1], 1)
        edges = _edges(corners)
        for triangle, row in _expanded(rows[:, 0], rows[:, 2] - rows[:, 0]):
            short = triangle + len(corners) * np.where(row < rows[triangle, 1], 1, 2)
            v = grid.origin[1] + row * grid.step[1]
            yield from _along_rows(
                _at_height(edges[triangle], v), _at_height(edges[short], v), turn[triangle], row, grid
            )


def _may_meet(triangles: np.ndarray, grid: RayGrid) -> np.ndarray:
    """True (T,) where a triangle's bounding box, a hair wider than it since crossings are rounded, meets a ray."""
    may = np.ones(len(triangles), bool)
    for direction in (0, 1):
        of_axis = triangles[:, :, grid.axes[direction]]
        hair = 1e-9 * grid.step[direction]
        low = np.minimum(np.minimum(of_axis[:, 0], of_axis[:, 1]), of_axis[:, 2])
        high = np.maximum(np.maximum(of_axis[:, 0], of_axis[:, 1]), of_axis[:, 2])
        may &= grid.numbers(low - hair, direction) < grid.numbers(high + hair, direction)
    return may


def _by_height(triangles: np.ndarray, axes: Tuple[int, int, int]) -> Tuple[np.ndarray, np.ndarray]:
    """Corners (T, 3, 3) as (u, v, along) in rising v, and +1 (T,) where that order is an even permutation, else -1."""
    order = np.argsort(triangles[:, :, axes[1]], axis=1, kind="stable")
    corners = triangles[np.arange(len(triangles))[:, None, None], order[:, :, None], np.array(axes)]
    return corners, np.where((order[:, 1] - order[:, 0]) % 3 == 1, 1, -1).astype(np.int8)


def _edges(corners: np.ndarray) -> np.ndarray:
    """Edges (3 T, 5), long, lower, upper: (u, v, along) of the lower end, slopes of u and along over v.

    From the edge's own ends in rising v and nothing else: triangles that share it get the same bits.
    """
    start = corners[:, [0, 0, 1]].transpose(1, 0, 2).reshape(-1, 3)
    end = corners[:, [2, 1, 2]].transpose(1, 0, 2).reshape(-1, 3)
    rise = end[:, 1] - start[:, 1]
    rise[rise == 0] = 1.0  # no row meets a level edge
    return np.concatenate([start, (end[:, [0, 2]] - start[:, [0, 2]]) / rise[:, None]], axis=1)


def _at_height(edges: np.ndarray, v: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Return u and along (S,) where edges (S, 5) reach the heights v (S,)."""
    climbed = v - edges[:, 1]
    return edges[:, 0] + climbed * edges[:, 3], edges[:, 2] + climbed * edges[:, 4]


def _expanded(first: np.ndarray, count: np.ndarray) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
    """Yield (item, first[item] + 0..count[item]-1) for all items, about ``_BLOCK`` pairs at a time."""
    total = np.concatenate([[0], np.cumsum(count, dtype=np.int64)])
    start = 0
    while start < len(count):
        end = max(start + 1, int(np.searchsorted(total, total[start] + _BLOCK, side="right")) - 1)
        some = count[start:end]
        item = np.repeat(np.arange(start, end), some)
        if len(item):
            yield item, np.arange(len(item)) + np.repeat(first[start:end] - total[start:end] + total[start], some)
        start = end


def _along_rows(
    long: Tuple[np.ndarray, np.ndarray],
    short: Tuple[np.ndarray, np.ndarray],
    turn: np.ndarray,
    row: np.ndarray,
    grid: RayGrid,
) -> Iterator[Tuple[np.ndarray, ...]]:
    """Yield crossings of rows of rays with triangles: a row covers the rays between the long and the short edge."""
    of_long, of_short = grid.numbers(long[0], 0), grid.numbers(short[0], 0)
    cover = np.nonzero(of_long != of_short)[0]
    row, first, count = row[cover] - grid.first[1], of_long[cover], (of_short - of_long)[cover]
    # an even order with the short edge beyond turns counter-clockwise about the axis: its outside is ahead, the ray
    # leaves
    sign = np.where(count > 0, -turn[cover], turn[cover])
    first, count = first + np.minimum(count, 0), np.abs(count)
    u, at = long[0][cover], long[1][cover]
    width, rise = short[0][cover] - u, short[1][cover] - at
    for span, i in _expanded(first, count):
        share = ((grid.origin[0] + grid.step[0] * i - u[span]) / width[span]).clip(0.0, 1.0)
        yield i - grid.first[0], row[span], at[span] + share * rise[span], sign[span]


def _sorted(ray: np.ndarray, at: np.ndarray, *others: np.ndarray) -> Tuple[np.ndarray, ...]:
    """All columns in the order of the rays and along them; 16-bit halves are sorted by counting, which is faster."""
    upper = (ray >> 16).astype(np.uint16 if ray.max(initial=0) < 1 << 32 else np.int64)
    order = np.lexsort((at, (ray & 0xFFFF).astype(np.uint16), upper))
    return tuple(column[order] for column in (ray, at) + others)


def union_intervals(rods: Crossings, inside: Optional[Crossings] = None) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the stretches of rays that lie inside at least one rod, and inside an envelope if one is given.

    Parameters
    ----------
    rods, inside : Crossings
        Sorted crossings of the same rays with closed meshes. Inside is where the winding number is above 0.

    Returns
    -------
    ray (N,) int64, start (N,) mm, end (N,) mm
        In the order of the rays.

    Raises
    ------
    MeshError
        If the signs on some ray do not add to 0: a mesh is open.
    """
    if inside is None:
        ray, at = rods.ray, rods.at
        within = _winding(ray, rods.sign) > 0
    else:
        none = np.zeros(len(inside.sign), np.int8), np.zeros(len(rods.sign), np.int8)
        columns = (
            np.concatenate(c)
            for c in ((rods.ray, inside.ray), (rods.at, inside.at), (rods.sign, none[0]), (none[1], inside.sign))
        )
        ray, at, of_rods, of_inside = _sorted(*columns)
        within = (_winding(ray, of_rods) > 0) & (_winding(ray, of_inside) > 0)
    before = np.concatenate([[False], within])[:-1]
    start = within & ~before
    return ray[start], at[start], at[before & ~within]


def _winding(ray: np.ndarray, sign: np.ndarray) -> np.ndarray:
    """Winding number after each crossing; 0 at the end of each ray or the mesh is open."""
    winding = np.cumsum(sign, dtype=np.int32)
    last = np.concatenate([ray[1:] != ray[:-1], [True]]) if len(ray) else np.zeros(0, bool)
    if winding[last].any():
        open_rays = int(np.count_nonzero(np.diff(winding[last], prepend=0)))
        raise MeshError(f"rays need closed meshes: each ray must leave as often as it enters; {open_rays} rays do not")
    return winding


def union_volume(
    triangles: np.ndarray,
    low: ArrayLike,
    high: ArrayLike,
    cells: int,
    axis: int = 0,
    inside: Optional[np.ndarray] = None,
) -> RayVolume:
    """Return the volume of the union of closed meshes inside a box, and inside an envelope if one is given.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
        All meshes' triangles; the meshes may overlap in any way.
    low, high : sequence of three floats, mm
        The box.
    cells : int
        Rays along ``axis`` run through the centres of ``cells`` x ``cells`` cells.
    axis : int
    inside : ndarray of shape (E, 3, 3), mm, optional
        Triangles of the envelope, a closed mesh.

    Returns
    -------
    RayVolume
        The error is an estimated standard error (nan below 3 x 3 rays).

    Raises
    ------
    MeshError
        If a mesh is open or a co-ordinate is not finite.
    ParameterError
        As ``RayGrid.of_box``.

    Notes
    -----
    A jump D of the rays' lengths somewhere between two rays makes an error up to D/2 of a cell, evenly spread:
    variance D²/12. It shows as two second differences of D and -D, so the sum of their squares over 24 estimates the
    variance of a row (smooth changes leave nothing). Rows err together where faces run along them: the row sums are
    treated alike.
    """
    grid = RayGrid.of_box(low, high, cells, axis)
    envelope = None if inside is None else crossings(inside, grid)
    ray, start, end = union_intervals(crossings(triangles, grid), envelope)
    first, last = (float(np.asarray(edge, float)[axis]) for edge in (low, high))
    length = end.clip(first, last) - start.clip(first, last)
    lengths = np.bincount(ray, length, cells * cells).reshape(cells, cells)
    area = grid.step[0] * grid.step[1]
    return RayVolume(float(lengths.sum() * area), float(_standard_error(lengths) * area))


def _standard_error(lengths: np.ndarray) -> float:
    """Standard error of the sum of lengths (N, N) sampled on a grid; nan below 3 x 3."""
    if len(lengths) < 3:
        return float("nan")
    return max(
        float(np.sqrt(((np.diff(of.sum(1), 2) ** 2).sum() + (np.diff(of, 2, axis=1) ** 2).sum()) / 24))
        for of in (lengths, lengths.T)
    )


def contains(triangles: np.ndarray, points: np.ndarray, axis: Optional[int] = None) -> np.ndarray:
    """Return which points lie inside closed meshes (winding number above 0).

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
    points : ndarray of shape (P, 3), mm
    axis : int, optional
        Direction of the rays that start at the points; by default the one along which the mesh is shortest.

    Returns
    -------
    ndarray of shape (P,), bool
        Points on the surface fall on either side, like points moved by an infinitely small step.
    """
    low, high = triangles.min((0, 1)), triangles.max((0, 1))
    axis = int(np.argmin(high - low)) if axis is None else axis
    axes = ((axis + 1) % 3, (axis + 2) % 3, axis)
    winding = np.zeros(len(points), np.int64)
    candidates = np.nonzero(((points >= low) & (points <= high)).all(1))[0]
    places = points[candidates][:, list(axes)]
    corners, turn = _by_height(triangles, axes)
    edges = _edges(corners)
    for triangle, k in _near(corners, places):
        u, v, at = places[k].T
        u_long, at_long = _at_height(edges[triangle], v)
        u_short, at_short = _at_height(edges[triangle + len(corners) * np.where(v < corners[triangle, 1, 1], 1, 2)], v)
        hit = np.nonzero((u < u_long) != (u < u_short))[0]
        width = u_short[hit] - u_long[hit]
        share = ((u[hit] - u_long[hit]) / width).clip(0.0, 1.0)
        hit_at = at_long[hit] + share * (at_short[hit] - at_long[hit])
        leaving = np.where(width > 0, turn[triangle[hit]], -turn[triangle[hit]])
        above = hit_at > at[hit]
        winding += np.bincount(candidates[k[hit[above]]], leaving[above], len(points)).astype(np.int64)
    return winding > 0


def _near(corners: np.ndarray, places: np.ndarray) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
    """Yield pairs (triangle, place) where the place may lie in the triangle's rows and below its top, in blocks."""
    if not len(places):
        return
    low, high = corners.min(1), corners.max(1)
    start, size = low[:, :2].min(0), (high[:, :2].max(0) - low[:, :2].min(0)).clip(1e-300)
    low[:, 0], high[:, 0] = low[:, 0] - 1e-9 * size[0], high[:, 0] + 1e-9 * size[0]  # crossings are rounded
    buckets = int(np.clip(np.sqrt(len(corners)), 1, _BUCKETS))

    def bucket(values: np.ndarray) -> np.ndarray:
        return ((values - start) * (buckets / size)).astype(np.int64).clip(0, buckets - 1)

    of_place = bucket(places[:, :2]) @ [buckets, 1]
    order = np.argsort(of_place, kind="stable")
    first = np.searchsorted(of_place[order], np.arange(buckets * buckets + 1))
    low_bucket, high_bucket = bucket(low[:, :2]), bucket(high[:, :2])
    for triangle, i in _expanded(low_bucket[:, 0], high_bucket[:, 0] - low_bucket[:, 0] + 1):
        # the buckets of one column are neighbours in the order: one stretch of places for each
        a, b = first[i * buckets + low_bucket[triangle, 1]], first[i * buckets + high_bucket[triangle, 1] + 1]
        for pair, number in _expanded(a, b - a):
            t, k = triangle[pair], order[number]
            p = places[k]
            near = (p[:, 1] >= low[t, 1]) & (p[:, 1] < high[t, 1]) & (p[:, 2] <= high[t, 2])
            near = np.nonzero(near & (p[:, 0] >= low[t, 0]) & (p[:, 0] <= high[t, 0]))[0]
            yield t[near], k[near]
