# SPDX-License-Identifier: LGPL-2.1-or-later
"""Magics' fix parameters (thesis Fig. 5.1): gap fill, filters, smoothing, compensation; what they change is counted."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Iterator, List, NamedTuple, Optional, Tuple

import numpy as np

from ..progress import Progress, part, silent
from .contours import Contours
from .fill import offset_contours, united
from .parameters import SliceParameters

#: Smoothing moves a contour by no more than this share of a layer.
SMOOTHING_SHARE = {"off": 0.0, "normal": 0.02, "heavy": 0.1}
_ROWS = 512  # of a table of distances


@dataclass(frozen=True)
class Repairs:
    """What was found and changed on each plane (S,).

    Attributes
    ----------
    open_chains : ndarray of int
        Chains that did not close before any repair; where there are some the plane is spoilt.
    gaps_filled : ndarray of int
        Gaps of at most ``parameters.gap`` that were closed.
    gaps_bridged : ndarray of int
        Longer ones, joined end to nearest start all the same, so that the plane's area means something.
    longest_gap : ndarray, mm
        Of those that were closed, 0 if none.
    removed_open, removed_closed : ndarray of int
        Contours that the filters left out.
    points_smoothed : ndarray of int
        Points that smoothing left out.
    offset : ndarray of int
        Contours replaced by the compensation.
    united : ndarray of int
        Contours replaced by the union.
    """

    open_chains: np.ndarray
    gaps_filled: np.ndarray
    gaps_bridged: np.ndarray
    longest_gap: np.ndarray
    removed_open: np.ndarray
    removed_closed: np.ndarray
    points_smoothed: np.ndarray
    offset: np.ndarray
    united: np.ndarray

    @property
    def spoilt(self) -> np.ndarray:
        """Planes (S,) on which the mesh was not closed."""
        return self.open_chains > 0


def mend(contours: Contours, parameters: SliceParameters, progress: Progress = silent) -> Tuple[Contours, Repairs]:
    """Return contours as the parameters want them, and what that changed.

    In this order: gap fill, filter of open contours, bridging of what is still open, filter of closed contours,
    smoothing, compensation or else union. Contours that are closed are not touched by the first three. A compensation
    unites what overlaps, whatever the fill rule.

    Raises
    ------
    DependencyError
        If compensation or union is asked for and manifold3d is missing.
    """
    slices = len(contours.heights)
    found = Repairs(*(np.zeros(slices, float if f.name == "longest_gap" else np.int64) for f in fields(Repairs)))
    found.open_chains[:] = _per_plane(contours, ~contours.closed)
    if not contours.closed.all():
        fill, bridge = _Joins(parameters.gap, parameters.iterations), _Joins(np.inf, None)
        contours = _joined(contours, fill, found.gaps_filled, found.longest_gap, part(progress, 0.0, 0.3))
        contours = _filtered(contours, ~contours.closed, parameters.filter_open, found.removed_open)
        contours = _joined(contours, bridge, found.gaps_bridged, found.longest_gap, part(progress, 0.3, 0.6))
    rest = part(progress, 0.6, 1.0)
    contours = _filtered(contours, contours.closed, parameters.filter_closed, found.removed_closed)
    tolerance = SMOOTHING_SHARE[parameters.smoothing] * parameters.thickness
    if tolerance:
        contours, found.points_smoothed[:] = smoothed(contours, tolerance)
    if parameters.compensation:
        contours, found.offset[:] = offset_contours(contours, parameters.compensation, rest)  # unites them too
    elif parameters.fill == "union":
        contours, found.united[:] = united(contours, rest)
    return contours, found


def _per_plane(contours: Contours, which: np.ndarray) -> np.ndarray:
    return np.bincount(contours.plane[which], minlength=len(contours.heights))


def _filtered(contours: Contours, which: np.ndarray, least: float, removed: np.ndarray) -> Contours:
    """Leave out contours among ``which`` that are shorter than ``least``."""
    if not least or not which.any():
        return contours
    out = which & (contours.lengths() < least)
    removed += _per_plane(contours, out)
    return contours.replaced(~out, [], []) if out.any() else contours


# ----------------------------------------------------------------------------------------------------------- joining


class _Joins(NamedTuple):
    """Longest gap (mm) that is closed, and rounds of closing (None: as many as it takes)."""

    limit: float
    rounds: Optional[int]


def _joined(contours: Contours, joins: _Joins, counts: np.ndarray, longest: np.ndarray,
            progress: Progress) -> Contours:  # fmt: skip
    """Join ends of open chains to nearest starts on their plane; ``counts`` and ``longest`` (S,) are counted up."""
    loose = np.flatnonzero(~contours.closed)
    planes: Tuple[List[int], List[int]] = ([], [])
    lines: Tuple[List[np.ndarray], List[np.ndarray]] = ([], [])
    for plane in np.unique(contours.plane[loose]):
        chains = loose[slice(*np.searchsorted(contours.plane[loose], [plane, plane + 1]))]
        starts, ends = contours.points[contours.starts[chains]], contours.points[contours.starts[chains + 1] - 1]
        follow, gaps = nearest_starts(starts, ends, *joins)
        counts[plane] += len(gaps)
        progress(plane, len(contours.heights), "joining open contours")
        longest[plane] = max(longest[plane], gaps.max(initial=0.0))
        pieces = [contours.points[contours.starts[c] : contours.starts[c + 1]] for c in chains]
        for ring, order in _strung(follow):
            planes[ring].append(int(plane))
            lines[ring].append(np.concatenate([pieces[k] for k in order]))
    contours = contours.replaced(contours.closed, planes[1], lines[1], closed=True)
    return contours.replaced(np.ones(len(contours), bool), planes[0], lines[0], closed=False)


def nearest_starts(starts: np.ndarray, ends: np.ndarray, limit: float,
                   rounds: Optional[int]) -> Tuple[np.ndarray, np.ndarray]:  # fmt: skip
    """Return the chain (K,) that follows each, -1 for none, and the lengths of the gaps that this closes.

    Parameters
    ----------
    starts, ends : ndarray of shape (K, 2), mm
    limit : float, mm
        Longest gap.
    rounds : int or None
        In each round every end and start that are each other's nearest are joined: the same pairs as joining always the
        nearest two of all.
    """
    follow = np.full(len(starts), -1, np.int64)
    gaps: List[np.ndarray] = [np.zeros(0)]
    free_ends = free_starts = np.arange(len(starts))
    done = 0
    while len(free_ends) and (rounds is None or done < rounds):
        to, distance = _nearest(ends[free_ends], starts[free_starts])
        back, _ = _nearest(starts[free_starts], ends[free_ends])
        mutual = (back[to] == np.arange(len(to))) & (distance <= limit)
        if not mutual.any():
            break
        follow[free_ends[mutual]] = free_starts[to[mutual]]
        gaps.append(distance[mutual])
        free_starts = np.delete(free_starts, to[mutual])
        free_ends = free_ends[~mutual]
        done += 1
    return follow, np.concatenate(gaps)


def _nearest(points: np.ndarray, others: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """For each point the first of the nearest others, and its distance."""
    to, square = np.zeros(len(points), np.int64), np.zeros(len(points))
    for start in range(0, len(points), _ROWS):
        rows = slice(start, start + _ROWS)
        table = (points[rows, 0, None] - others[:, 0]) ** 2 + (points[rows, 1, None] - others[:, 1]) ** 2
        to[rows] = table.argmin(1)
        square[rows] = table.min(1)
    return to, np.sqrt(square)


def _strung(follow: np.ndarray) -> Iterator[Tuple[bool, List[int]]]:
    """Yield whether it is a ring, and its chains in order, for everything that ``follow`` strings together."""
    has_before = np.zeros(len(follow), bool)
    has_before[follow[follow >= 0]] = True
    used = np.zeros(len(follow), bool)
    for first in np.argsort(has_before, kind="stable"):  # open ones first, from their own start
        order, k = [], int(first)
        while k >= 0 and not used[k]:
            used[k] = True
            order.append(k)
            k = int(follow[k])
        if order:
            yield bool(has_before[first]), order


# --------------------------------------------------------------------------------------------------------- smoothing


def smoothed(contours: Contours, tolerance: float) -> Tuple[Contours, np.ndarray]:
    """Return closed contours with fewer points, none moved by more than the tolerance (mm), and how many went (S,).

    Points whose distance from the line between their neighbours is least go first, never two beside each other in one
    round; what went before is added up, so that no point of the old contour is further than the tolerance from the new
    one. Contours of fewer than six points, and open ones, stay as they are.
    """
    removed = np.zeros(len(contours.heights), np.int64)
    error = np.zeros(len(contours.points))  # of the line from each point to the next
    while True:
        after = contours.next_points()
        before = np.empty_like(after)
        before[after] = np.arange(len(after))
        sizes = np.diff(contours.starts)
        able = np.repeat((sizes > 5) & contours.closed, sizes)
        worst = np.maximum(error, error[before]) + _distances(contours.points, before, after)
        worst = np.where(able & (worst <= tolerance), worst, np.inf)
        out = np.isfinite(worst) & (worst < worst[before]) & (worst <= worst[after])
        if not out.any():
            return contours, removed
        error[before[out]] = worst[out]
        gone = np.add.reduceat(out.astype(np.int64), contours.starts[:-1])
        removed += np.bincount(contours.plane, gone, len(removed)).astype(np.int64)
        error = error[~out]
        starts = np.append(0, np.cumsum(sizes - gone))
        points = np.ascontiguousarray(contours.points[~out].T).T
        contours = Contours(contours.axis, contours.heights, points, starts, contours.plane, contours.closed)


def _distances(points: np.ndarray, before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Distance (N,) of each point from the line between two others, its ends included."""
    line, own = points[after] - points[before], points - points[before]
    square = (line**2).sum(1)
    share = np.clip((own * line).sum(1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    return np.sqrt(((own - share[:, None] * line) ** 2).sum(1))
