# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes cut through triangles: sliced areas, and contours in order.

A corner on a plane counts as above it (``side="below"``: the slice is that of a plane a hair's breadth below;
``"above"``: corners on a plane count as below it). So planes cut edges only, and a closed mesh gives closed contours
only. The point on an edge is interpolated from its lower to its upper end by both of its triangles: bit by bit the
same. Seen from the positive end of the axis material lies on the left: contours round material have a positive area,
round voids a negative one.

On each plane a triangle's segment runs from its falling edge (upper to lower corner) to its rising one. A *piece* is a
triangle and the planes that cut the same two of its edges; a *node* is the point of one plane on its falling edge.
"""

from __future__ import annotations

from typing import Iterator, List, NamedTuple, Optional, Tuple

import numpy as np

from ...errors import ParameterError
from ..progress import Progress, part, silent
from .chains import order_chains
from .contours import Contours
from .neighbours import next_corner, partners_of
from .parameters import AXES, axis_frame, axis_name
from .triangles import by_corners

_CHUNK = 1 << 15  # triangles or pieces worked on at once: temporary arrays stay in the processor's cache
_NODES = 400_000  # points of the planes worked on at once: less than 0.3 s
_CROWDED = 8  # planes in one cell of the table of levels: then a search is faster
SIDES = ("below", "above")


class _Cut(NamedTuple):
    """Triangles that planes cut (K,): planes below the lowest, middle, highest corner; which are lowest and highest."""

    triangle: np.ndarray
    low: np.ndarray
    middle: np.ndarray
    high: np.ndarray
    lowest: np.ndarray
    highest: np.ndarray


class _Pieces(NamedTuple):
    """Triangles that planes cut (M,): half-edges that fall and rise, first plane, number of planes."""

    fall: np.ndarray
    rise: np.ndarray
    first: np.ndarray
    planes: np.ndarray


class Placed(NamedTuple):
    """Triangles in the frame of an axis: height (3 T,) and in-plane co-ordinates (3 T,) of all corners."""

    height: np.ndarray
    first: np.ndarray
    second: np.ndarray


def placed(triangles: np.ndarray, axis: str) -> Placed:
    """Return the corners of triangles (T, 3, 3) in the frame of an axis: in double precision if it is oblique."""
    points, name = by_corners(np.asarray(triangles)), axis_name(axis)
    if name in AXES:
        k = AXES.index(name)
        return Placed(points[k], points[k - 2], points[k - 1])
    rows = [sum(float(c) * x.astype(float) for c, x in zip(row, points)) for row in axis_frame(name)]
    return Placed(rows[2], rows[0], rows[1])


def sliced_areas(triangles: np.ndarray, axis: str, heights: np.ndarray, side: str = "below",
                 progress: Progress = silent) -> np.ndarray:  # fmt: skip
    """Return the sliced area (S,) of each plane, mm², without contours: material counts positive.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
        Closed, counter-clockwise seen from outside; elsewhere the areas mean nothing. What overlaps counts twice.
    axis : str
        ``x``, ``y``, ``z`` or a direction (see ``parameters.axis_name``).
    heights : ndarray of shape (S,), mm
        Co-ordinates of the planes along the axis, rising.

    Raises
    ------
    ParameterError
        If the heights do not rise.

    Notes
    -----
    Shoelace formula (thesis Eq. 5.1) over the segments of a plane in any order.
    """
    heights, corners = _checked(heights, side), placed(triangles, axis)
    count, areas = len(corners.height) // 3, np.zeros(len(heights))
    middle = [float(c.min() + (c.max() - c.min()) / 2) for c in (corners.first, corners.second)]
    for cut in _cut_triangles(corners.height, heights, side, progress):
        pieces = _pieces(cut, count, 0, len(heights))
        of, plane = _nodes(pieces.first, pieces.planes)
        height = heights[plane]
        u, v = _crossings(corners, next_corner(pieces.fall, count), pieces.fall, of, height)
        p, q = _crossings(corners, pieces.rise, next_corner(pieces.rise, count), of, height)
        areas += np.bincount(plane, (u + p - 2 * middle[0]) * (q - v), len(heights))
    return areas / 2 + 0.0


def slice_contours(triangles: np.ndarray, axis: str, heights: np.ndarray, progress: Progress = silent,
                   partners: Optional[np.ndarray] = None, side: str = "below") -> Contours:  # fmt: skip
    """Return the contours of all planes.

    Parameters
    ----------
    triangles, axis, heights, side
        As of ``sliced_areas``; the triangles may be open anywhere: chains that do not close are marked.
    partners : ndarray of shape (3 T,), optional
        From ``neighbours``, if known.

    Raises
    ------
    ParameterError
        If the heights do not rise.
    """
    heights, corners = _checked(heights, side), placed(triangles, axis)
    partners = partners_of(triangles, partners, part(progress, 0.0, 0.2))
    cut = _joined_cuts(list(_cut_triangles(corners.height, heights, side, part(progress, 0.2, 0.4))))
    base, blocks, report = np.zeros(len(partners) // 3, np.int32), [], part(progress, 0.4, 1.0)
    for low, high, some in _blocks(cut, len(heights)):
        pieces = _pieces(_Cut(*(column[some] for column in cut)), len(base), low, high)
        blocks.append(_block(corners, partners, heights, pieces, base))
        report(high, len(heights), f"slicing along {axis}")
    return _joined(axis_name(axis), heights, blocks)


def _checked(heights: np.ndarray, side: str) -> np.ndarray:
    heights = np.asarray(heights, float).reshape(-1)
    if not np.isfinite(heights).all() or not (heights[1:] > heights[:-1]).all():
        raise ParameterError("heights of planes must be finite and rise")
    if side not in SIDES:
        raise ParameterError(f"the side of a plane must be one of {', '.join(SIDES)}, got {side!r}")
    return heights


def _joined_cuts(cuts: List[_Cut]) -> _Cut:
    if not cuts:
        return _Cut(*(np.zeros(0, np.int32) for _ in _Cut._fields))
    return _Cut(*(np.concatenate(column) for column in zip(*cuts)))


def _blocks(cut: _Cut, planes: int) -> Iterator[Tuple[int, int, np.ndarray]]:
    """Ranges of planes with about ``_NODES`` nodes each, one plane at least; and which triangles they cut."""
    starting, ending = (np.bincount(level, minlength=planes + 1) for level in (cut.low, cut.high))
    ends, bounds = np.cumsum(np.cumsum(starting - ending)), [0]  # nodes up to each plane
    while bounds[-1] < planes:
        done = ends[bounds[-1] - 1] if bounds[-1] else 0
        bounds.append(min(max(bounds[-1] + 1, int(np.searchsorted(ends, done + _NODES, "right"))), planes))
    block = np.repeat(np.arange(len(bounds) - 1), np.diff(bounds))
    kind = np.int16 if len(bounds) < 2**15 else np.int32  # short numbers are sorted by counting
    order = np.argsort(block.astype(kind)[cut.low], kind="stable").astype(np.int32) if planes else cut.low
    first = np.append(0, np.cumsum(starting))[bounds]
    some = np.zeros(0, np.int32)
    for k, (low, high) in enumerate(zip(bounds[:-1], bounds[1:])):
        some = np.append(some[cut.high[some] > low], order[first[k] : first[k + 1]])
        yield low, high, some


# ----------------------------------------------------------------------------------------------------------- pieces


def _bounds(heights: np.ndarray, side: str, dtype: np.dtype) -> np.ndarray:
    """Least co-ordinates of the corners' type that count as above each plane."""
    bounds = heights.astype(dtype)
    low = bounds < heights if side == "below" else bounds <= heights
    return np.where(low, np.nextafter(bounds, np.array(np.inf, dtype)), bounds)


def _levels(height: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    """How many planes are below each corner: ``searchsorted(bounds, height, "right")`` by a table of cells.

    Rounding keeps the order, so that all planes in lower cells than a corner's are below it; those in its own cell are
    climbed one by one.
    """
    cells, low, high = 4 * len(bounds), bounds[0], bounds[-1]
    if not high > low:
        return np.where(height >= low, len(bounds), 0).astype(np.int32)
    scale = height.dtype.type((cells - 1) / (float(high) - float(low)))

    def cell(z: np.ndarray) -> np.ndarray:
        return (np.clip(z, low, high) - low) * scale

    of_plane = cell(bounds).astype(np.int32)
    if np.bincount(of_plane).max() > _CROWDED:
        return np.searchsorted(bounds, height, "right").astype(np.int32)
    level = np.searchsorted(of_plane, np.arange(cells + 1)).astype(np.int32)[cell(height).astype(np.int32)]
    bounds = np.append(bounds, height.dtype.type(np.inf))
    while True:
        climbs = height >= bounds[level]
        if not climbs.any():
            return level
        level += climbs


def _cut_triangles(height: np.ndarray, heights: np.ndarray, side: str, progress: Progress) -> Iterator[_Cut]:
    """Triangles that planes cut, of some thousand triangles at a time, in their order."""
    if not len(heights):
        return
    bounds, count = _bounds(heights, side, height.dtype), len(height) // 3
    height = height.reshape(3, count)
    for begin in range(0, count, _CHUNK):
        level = _levels(height[:, begin : begin + _CHUNK], bounds)
        cut = np.flatnonzero((level[0] != level[1]) | (level[1] != level[2])).astype(np.int32)
        a, b, c = level[:, cut]
        low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
        lowest = np.where(a == low, 0, np.where(b == low, 1, 2)).astype(np.int8)
        highest = np.where(a == high, 0, np.where(b == high, 1, 2)).astype(np.int8)
        if begin // _CHUNK % 8 == 0:
            progress(begin, count, "cutting triangles")
        yield _Cut(cut + np.int32(begin), low, a + b + c - low - high, high, lowest, highest)


def _pieces(cut: _Cut, count: int, first: int, last: int) -> _Pieces:
    """Pieces of triangles on the planes ``first`` up to ``last``; ``count`` triangles in all.

    A triangle has up to two, one after the other: planes with only its lowest corner below them, then planes with only
    its highest one above them.
    """
    low, middle, high = (np.clip(level, first, last) for level in (cut.low, cut.middle, cut.high))
    starts = np.arange(3, dtype=np.int32) * np.int32(count)
    before = starts[[2, 0, 1]]  # half-edges that end at each corner
    fall = np.stack([before[cut.lowest] + cut.triangle, starts[cut.highest] + cut.triangle], 1).ravel()
    rise = np.stack([starts[cut.lowest] + cut.triangle, before[cut.highest] + cut.triangle], 1).ravel()
    begin, planes = np.stack([low, middle], 1).ravel(), np.stack([middle - low, high - middle], 1).ravel()
    some = np.flatnonzero(planes)
    return _Pieces(fall[some], rise[some], begin[some], planes[some])


def _nodes(first: np.ndarray, count: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Piece (N,) and plane (N,) of the nodes of pieces, in the order of the pieces and then of the planes."""
    of = np.repeat(np.arange(len(count), dtype=np.int32), count)
    shift = (first - np.cumsum(count) + count).astype(np.int32)
    return of, np.arange(len(of), dtype=np.int32) + shift[of]


def _crossings(corners: Placed, lower: np.ndarray, upper: np.ndarray, of: np.ndarray,
               height: np.ndarray) -> Iterator[np.ndarray]:  # fmt: skip
    """In-plane co-ordinates, first and second (N,), where edges (M,; lower and upper corner) meet the nodes' planes."""
    foot = corners.height[lower].astype(float)
    rise = corners.height[upper] - foot
    step = height - foot[of]
    for c in (corners.first, corners.second):
        start = c[lower].astype(float)
        yield start[of] + step * ((c[upper] - start) / rise)[of]


# ---------------------------------------------------------------------------------------------------------- contours


class _Block(NamedTuple):
    """Contours of some planes: points (2, N), sizes (C,), planes (C,), whether each is closed (C,)."""

    points: np.ndarray
    sizes: np.ndarray
    plane: np.ndarray
    closed: np.ndarray


def _block(corners: Placed, partners: np.ndarray, heights: np.ndarray, pieces: _Pieces, base: np.ndarray) -> _Block:
    """Contours of the planes that these pieces reach; ``base`` (T,) is working space.

    The nodes of a triangle follow each other, so that node = base[triangle] + plane; the node after one is its
    neighbour's across the rising edge. Where there is no neighbour the segment ends in a node of its own.
    """
    fall, rise, first, count = pieces
    triangles, nodes = len(base), int(count.sum())
    own = (np.cumsum(count) - count - first).astype(np.int32)
    base[fall % triangles] = own
    across = partners[rise]
    loose = np.flatnonzero(across < 0)
    to = base[across % triangles]
    end = (nodes + np.cumsum(count[loose]) - count[loose] - first[loose]).astype(np.int32)
    to[loose] = end
    own, to = np.append(own, end), np.append(to, end)
    lower = np.append(next_corner(fall, triangles), rise[loose])
    upper = np.append(fall, next_corner(rise[loose], triangles))
    count = np.append(count, count[loose])
    starts = np.append(0, np.cumsum(count))
    points, follow, planes = np.empty((2, starts[-1])), *(np.empty(starts[-1], np.int32) for _ in range(2))
    for begin in range(0, len(count), _CHUNK):
        chunk = slice(begin, begin + _CHUNK)
        of = np.repeat(np.arange(len(count[chunk]), dtype=np.int32), count[chunk])
        here = slice(starts[begin], starts[begin] + len(of))
        plane = np.arange(here.start, here.stop, dtype=np.int32) - own[chunk][of]
        for row, crossing in zip(points, _crossings(corners, lower[chunk], upper[chunk], of, heights[plane])):
            row[here] = crossing
        follow[here], planes[here] = to[chunk][of] + plane, plane
    place, sizes, plane = order_chains(follow, planes)
    ordered = np.empty_like(points)
    ordered[0, place], ordered[1, place] = points
    closed = np.ones(len(sizes), bool)
    closed[np.searchsorted(np.cumsum(sizes), place[nodes:], "right")] = False
    return _Block(ordered, sizes, plane, closed)


def _joined(axis: str, heights: np.ndarray, blocks: List[_Block]) -> Contours:
    """All blocks as one; each is let go when it is copied."""
    sizes, plane, closed = (
        np.concatenate([np.zeros(0, kind), *(getattr(block, name) for block in blocks)])
        for name, kind in (("sizes", np.int64), ("plane", np.int32), ("closed", bool))
    )
    starts = np.append(0, np.cumsum(sizes))
    points, begin = np.empty((2, starts[-1])), 0
    blocks.reverse()
    while blocks:
        some = blocks.pop().points
        points[:, begin : begin + some.shape[1]] = some
        begin += some.shape[1]
    return Contours(axis, heights, points.T, starts, plane, closed)
