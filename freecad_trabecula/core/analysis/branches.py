# SPDX-License-Identifier: LGPL-2.1-or-later
"""Interconnectivity (thesis ch. 9): how trabeculae join, split, appear and end from slice to slice.

A graph over the slices: its nodes are the trabeculae of every slice (outer contours less their holes), its edges join
trabeculae of neighbouring slices that overlap, seen along the axis. Where a trabecula has one neighbour on the next
slice and is that one's only neighbour, it goes on; all else is an event.

Overlaps are found on rows: lines in the plane, evenly spaced, the same on every slice. Stretches of a trabecula on a
row are exact; two trabeculae overlap if stretches of theirs do on any row, so that an overlap narrower than the rows'
spacing may be missed. Trabeculae that no row meets are left out and counted.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Optional, Tuple

import numpy as np

from ...errors import ParameterError
from ..progress import Progress, silent
from .contours import ContourMeasures, Contours

ROWS_PER_LAYER = 4  # default spacing of the rows: a quarter of the distance between slices
MOST_ROWS = 4000  # of a slice, by default
_EDGES = 200_000  # of polygons worked on at once


@dataclass(frozen=True)
class Branches:
    """The graph of the trabeculae along one axis, and what is counted on it.

    Attributes
    ----------
    axis : str
    heights : ndarray of shape (S,), mm
        Of the slices.
    spacing : float, mm
        Between the rows on which overlaps were found.
    contours : ndarray of shape (N,), int
        Outer contour of each node.
    plane : ndarray of shape (N,), int
        Slice of each node.
    edges : ndarray of shape (E, 2), int
        Nodes that overlap, the one on the lower slice first.
    appear, end, split, join : ndarray of shape (S,), int
        Trabeculae of each slice with none on the slice below, none above, more than one above, more than one below. The
        first slice has no appearing and no joining trabeculae, the last no ending and no splitting ones.
    unresolved : int
        Trabeculae that no row met.
    """

    axis: str
    heights: np.ndarray
    spacing: float
    contours: np.ndarray
    plane: np.ndarray
    edges: np.ndarray
    appear: np.ndarray
    end: np.ndarray
    split: np.ndarray
    join: np.ndarray
    unresolved: int = 0

    @property
    def length(self) -> float:
        """Distance, mm, from the first to the last slice; 0 for a single one."""
        return float(self.heights[-1] - self.heights[0]) if len(self.heights) else 0.0

    @property
    def branches(self) -> int:
        """Number of chains of trabeculae that go on from slice to slice without an event."""
        above, below = self._degrees()
        lower, upper = self.edges.T
        return len(self.plane) - int(np.count_nonzero((above[lower] == 1) & (below[upper] == 1)))

    @property
    def junctions(self) -> int:
        """Number of splits and joins."""
        return int(self.split.sum() + self.join.sum())

    @property
    def branches_per_mm(self) -> float:
        """Branches per mm along the axis; nan for a single slice."""
        return self.branches / self.length if self.length > 0 else float("nan")

    @property
    def junctions_per_mm(self) -> float:
        """Junctions per mm along the axis; nan for a single slice."""
        return self.junctions / self.length if self.length > 0 else float("nan")

    @property
    def parts(self) -> int:
        """Pieces of the graph: what hangs together by overlaps from slice to slice."""
        return int(len(np.unique(_pieces(len(self.plane), self.edges))))

    @property
    def loops(self) -> int:
        """Independent loops of the graph, edges - nodes + parts: ways that part and meet again along the axis."""
        return len(self.edges) - len(self.plane) + self.parts

    def _degrees(self) -> Tuple[np.ndarray, np.ndarray]:
        """Numbers (N,) of neighbours on the slice above and on the slice below."""
        count = len(self.plane)
        return np.bincount(self.edges[:, 0], minlength=count), np.bincount(self.edges[:, 1], minlength=count)


def trace_branches(
    contours: Contours,
    measures: ContourMeasures,
    least_area: float = 0.0,
    spacing: Optional[float] = None,
    progress: Progress = silent,
) -> Branches:
    """Return how the trabeculae of slices hang together.

    Parameters
    ----------
    contours : Contours
    measures : ContourMeasures
        Of these contours.
    least_area : float, mm²
        Trabeculae of no more than this are left out.
    spacing : float, mm, optional
        Between rows; by default a quarter of the mean distance between slices, but at most 4,000 rows.
    progress : callable

    Raises
    ------
    ParameterError
        If the measures are not those of the contours, or the spacing is not above 0.
    """
    if len(contours) != len(measures):
        raise ParameterError(
            f"there must be one row of measures for each contour, got {len(measures)}, {len(contours)}"
        )
    spacing = _default_spacing(contours) if spacing is None else spacing
    if not (np.isfinite(spacing) and spacing > 0):
        raise ParameterError(f"the spacing of rows must be > 0, got {spacing} mm")
    trabecula = _trabeculae(measures, least_area)
    nodes = np.nonzero((trabecula == np.arange(len(trabecula))) & contours.closed)[0]
    node_of = np.full(len(trabecula) + 1, -1)
    node_of[nodes] = np.arange(len(nodes))
    of_contour = np.where(contours.closed, node_of[trabecula], -1)
    slices = len(contours.heights)
    node, row, start, stop = _stretches(contours, of_contour, spacing, progress)
    plane = contours.plane[nodes]
    edges = _overlaps(plane[node] if len(node) else node, node, row, start, stop)
    met = np.bincount(node, minlength=len(nodes)) > 0
    return _branches(contours, spacing, nodes, plane, edges, met, slices)


def _default_spacing(contours: Contours) -> float:
    """A quarter of the mean distance between slices, or what makes 4,000 rows, whichever is more."""
    extent = float(np.ptp(contours.points[:, 1])) if len(contours.points) else 0.0
    distance = float(np.ptp(contours.heights)) / max(len(contours.heights) - 1, 1)
    return max(distance / ROWS_PER_LAYER, extent / MOST_ROWS) or 1.0


def _trabeculae(measures: ContourMeasures, least_area: float) -> np.ndarray:
    """Outer contour (C,) that each contour is the border of: itself, or the one a hole lies in; -1 for none."""
    itself = np.arange(len(measures))
    trabecula = np.where(measures.area > 0, itself, measures.parent)
    small = (measures.area[trabecula] <= least_area) | (trabecula < 0)
    return np.where(small, -1, trabecula)


def _stretches(
    contours: Contours, of_contour: np.ndarray, spacing: float, progress: Progress
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Stretches of rows inside trabeculae: node, row, start, stop, each (H,)."""
    count = np.diff(contours.starts)
    follower = np.arange(1, len(contours.points) + 1)
    follower[contours.starts[1:] - 1] = contours.starts[:-1]
    node = np.repeat(of_contour, count)
    edges = np.nonzero(node >= 0)[0]
    blocks: List[Tuple[np.ndarray, ...]] = [(np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0))]
    for first in range(0, len(edges), _EDGES):
        progress(first, len(edges), "branches")
        some = edges[first : first + _EDGES]
        blocks.append(_row_crossings(contours.points[some], contours.points[follower[some]], node[some], spacing))
    nodes, rows, at = (np.concatenate(column) for column in zip(*blocks))
    order = np.lexsort((at, rows, nodes))
    # a closed curve meets a row an even number of times: in, out, in, out
    pairs = order[: len(order) // 2 * 2].reshape(-1, 2)
    return nodes[pairs[:, 0]], rows[pairs[:, 0]], at[pairs[:, 0]], at[pairs[:, 1]]


def _row_crossings(
    start: np.ndarray, stop: np.ndarray, node: np.ndarray, spacing: float
) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Where edges (K, 2) cross rows at whole multiples of the spacing (half open): node, row, place along the row."""
    upward = (start[:, 1] <= stop[:, 1])[:, None]
    low, high = np.where(upward, start, stop), np.where(upward, stop, start)  # both sides of an edge get the same bits
    first = np.ceil(low[:, 1] / spacing).astype(np.int64)
    count = np.ceil(high[:, 1] / spacing).astype(np.int64) - first
    edge = np.repeat(np.arange(len(count)), count)
    row = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count) + first[edge]
    rise = high[edge, 1] - low[edge, 1]
    share = (row * spacing - low[edge, 1]) / rise
    return node[edge], row, low[edge, 0] + share * (high[edge, 0] - low[edge, 0])


def _overlaps(plane: np.ndarray, node: np.ndarray, row: np.ndarray, start: np.ndarray, stop: np.ndarray) -> np.ndarray:
    """Pairs (E, 2) of nodes on neighbouring planes whose stretches overlap on a row, the lower one first.

    In the order of their starts, the stretches that may overlap one of the slice above are neighbours: from the first
    up to which any stop is beyond its start, to the last that starts before its stop.
    """
    if not len(node):
        return np.zeros((0, 2), np.int64)
    low = row.min()
    line = plane * (int(row.max() - low) + 2) + (row - low)
    above = line + int(row.max() - low) + 2
    order = np.lexsort((start, line))
    # ranks of starts and stops where they lie, and as they are seen from the slice below
    of_start, of_stop, seen_start, seen_stop = _ranks(line, start, line, stop, above, start, above, stop)
    first = np.searchsorted(np.maximum.accumulate(of_stop[order]), seen_start, side="right")
    end = np.searchsorted(of_start[order], seen_stop, side="left")
    count = np.maximum(end - first, 0)
    lower = np.repeat(np.arange(len(node)), count)
    upper = order[np.arange(len(lower)) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first, count)]
    do = of_stop[upper] > seen_start[lower]
    return np.unique(np.stack([node[lower[do]], node[upper[do]]], 1), axis=0)


def _ranks(*columns: np.ndarray) -> List[np.ndarray]:
    """Ranks of pairs (line, place), given as columns in turn, in one common order; equal pairs have equal ranks."""
    lines, places = np.concatenate(columns[::2]), np.concatenate(columns[1::2])
    order = np.lexsort((places, lines))
    changes = (np.diff(lines[order]) != 0) | (np.diff(places[order]) != 0)
    ranks = np.empty(len(order), np.int64)
    ranks[order] = np.concatenate([[0], np.cumsum(changes)])
    return np.split(ranks, np.cumsum([len(column) for column in columns[::2]])[:-1])


def _branches(
    contours: Contours,
    spacing: float,
    nodes: np.ndarray,
    plane: np.ndarray,
    edges: np.ndarray,
    met: np.ndarray,
    slices: int,
) -> Branches:
    """Count the events; nodes that no row met are taken out."""
    number = np.cumsum(met) - 1
    nodes, plane, edges = nodes[met], plane[met], number[edges].reshape(-1, 2)
    above = np.bincount(edges[:, 0], minlength=len(nodes))
    below = np.bincount(edges[:, 1], minlength=len(nodes))

    def per_slice(which: np.ndarray) -> np.ndarray:
        return np.bincount(plane[which], minlength=slices)

    return Branches(
        contours.axis,
        contours.heights,
        float(spacing),
        nodes,
        plane,
        edges,
        appear=per_slice((below == 0) & (plane > 0)),
        end=per_slice((above == 0) & (plane < slices - 1)),
        split=per_slice(above > 1),
        join=per_slice(below > 1),
        unresolved=int(np.count_nonzero(~met)),
    )


def _pieces(count: int, edges: np.ndarray) -> np.ndarray:
    """Lowest node (count,) of the piece of a graph that each node is in."""
    lowest = np.arange(count)
    while len(edges):
        before = lowest.copy()
        for a, b in (edges.T, edges.T[::-1]):
            np.minimum.at(lowest, lowest[a], lowest[b])
        while True:
            shorter = lowest[lowest]
            if np.array_equal(shorter, lowest):
                break
            lowest = shorter
        if np.array_equal(before, lowest):
            break
    return lowest
