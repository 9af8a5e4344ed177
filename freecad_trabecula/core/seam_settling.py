# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams that bound all patches of a body without crossing: exact where that holds, the triangles' own elsewhere.

Exact seams of surfaces that nearly touch may run otherwise than the triangles': then borders of a patch cross, or turn
round. The triangles' seams never do, as polygons in the parameters of their surfaces; they miss the surfaces by the
triangles' sag, which their edges carry as a tolerance. So every seam that is found to be wrong goes back to them.
"""

from __future__ import annotations

from typing import Dict, Iterable, List, NamedTuple, Set, Tuple

import numpy as np

from .patchwork import LabelledMesh, Patchwork
from .progress import Progress, silent
from .seam_curves import EXACT, SeamCurve, between, polygon_curve, seam_curves
from .seams import Nodes, Surfaces, find_nodes, kind_of

_TOGETHER = 1e-6  # mm; nodes nearer to each other than this are not told apart
_LOOSE = 1e-5  # mm; a curve further from the seam is wrong
_SAMPLES = 3  # pieces of polygons to each cubic, when borders are looked at for crossings
_ROUNDS = 40


class Lines(NamedTuple):
    """Nodes, and the curves of the free seams by their numbers."""

    nodes: Nodes
    curves: Dict[int, SeamCurve]


class Settling:
    """Nodes and curves of a patchwork, as exact as they can be had without crossings.

    Parameters
    ----------
    surfaces : Surfaces
    mesh : LabelledMesh
    work : Patchwork
        Of that mesh.
    """

    def __init__(self, surfaces: Surfaces, mesh: LabelledMesh, work: Patchwork) -> None:
        self.surfaces, self.work, self._vertices = surfaces, work, mesh.vertices
        self._rough = find_nodes(surfaces, work, mesh.vertices, exact=False)
        self._nodes = find_nodes(surfaces, work, mesh.vertices)
        self._free = [k for k, seam in enumerate(work.seams) if kind_of(surfaces, seam) == "free"]
        self._curves = dict(zip(self._free, seam_curves(surfaces, work, mesh.vertices, self._nodes, self._free)))
        self._touching: Dict[int, List[int]] = {}
        for number, seam in enumerate(work.seams):
            for vertex in set(seam.vertices[[0, -1]].tolist()):
                self._touching.setdefault(vertex, []).append(number)
        self._own = set(self._free)
        self.lowered: Set[int] = set()
        self.lowered_nodes: Set[int] = set()
        self._stale: Set[int] = set()
        self._places: List[Tuple[int, np.ndarray]] = []
        self._is_first = True
        for vertex, distance in list(self._nodes.distances.items()):
            if distance > EXACT:
                self._lower_node(vertex)
        for number, curve in list(self._curves.items()):
            if curve.error > _LOOSE or np.diff(curve.knots).min() < _TOGETHER:
                self._places += curve.worst
                self.lower({number} - self.lowered)

    def lower(self, seams: Iterable[int]) -> bool:
        """Take the triangles' own lines for seams, and their ends if that was done before; return whether it helps."""
        changed = False
        for number in seams:
            if number in self._own and number not in self.lowered:
                self.lowered.add(number)
                self._stale.add(number)
                changed = True
            else:
                for vertex in self.work.seams[number].vertices[[0, -1]].tolist():
                    changed |= self._lower_node(vertex)
        return changed

    def _lower_node(self, vertex: int) -> bool:
        if vertex in self.lowered_nodes:
            return False
        self.lowered_nodes.add(vertex)
        self._nodes.points[vertex] = self._rough.points[vertex]
        self._nodes.distances[vertex] = self._rough.distances[vertex]
        for surface in self.work.meeting[vertex]:
            if (vertex, surface) in self._rough.uv:
                self._nodes.uv[vertex, surface] = self._rough.uv[vertex, surface]
        touched = {number for number in self._touching[vertex] if number in self._own}
        self.lowered |= touched
        self._stale |= touched
        return True

    def settle(self, progress: Progress = silent) -> Lines:
        """Return nodes and curves whose patches' borders do not cross."""
        for step in range(_ROUNDS):
            progress(step, _ROUNDS, "seams of channels")
            lines = self.lines()
            wrong = self._turned(lines) | self._crossing(lines, self._is_first)
            if self._is_first:  # later ones follow from the triangles' lines, not from the surfaces
                self._places += self._places_of(self.lowered | wrong, self.lowered_nodes)
            self._is_first = False
            if not self.lower(wrong):
                break
        return self.lines()

    def doubtful(self, seams: Iterable[int] = ()) -> List[Tuple[int, np.ndarray]]:
        """Return places, a surface and parameters (2,) on it, at which finer triangles would tell more.

        Where seams were wrong before any was lowered for others' sake, and along more ``seams``.
        """
        return self._places + self._places_of(set(seams), set())

    def _places_of(self, seams: Set[int], nodes: Set[int]) -> List[Tuple[int, np.ndarray]]:
        """Where seams are furthest from their surfaces, and at their ends and other nodes."""
        nodes = nodes | {v for n in seams for v in self.work.seams[n].vertices[[0, -1]].tolist()}
        places = [(surface, self.work.corners[v, surface]) for v in sorted(nodes) for surface in self.work.meeting[v]]
        for number in sorted(seams & self._own):
            places += self._curves[number].worst
        return places

    def lines(self) -> Lines:
        """Return nodes and curves as they are now."""
        for number in self._stale:
            self._curves[number] = polygon_curve(self.surfaces, self.work, self._vertices, self._nodes, number)
        self._stale = set()
        return Lines(self._nodes, self._curves)

    def _turned(self, lines: Lines) -> Set[int]:
        """Seams whose ends fall together, or lie the other way round than the triangles' do."""
        found = set()
        for number, seam in enumerate(self.work.seams):
            first, last = seam.vertices[[0, -1]].tolist()
            if first == last:
                continue
            step = lines.nodes.points[last] - lines.nodes.points[first]
            if (
                np.linalg.norm(step) < _TOGETHER
                or number not in self._own
                and step @ (self._vertices[last] - self._vertices[first]) <= 0
            ):
                found.add(number)
        return found

    def _crossing(self, lines: Lines, noted: bool) -> Set[int]:
        """Seams whose images cross on a patch; the places are noted if that is asked for."""
        start, end, seam, patch = [], [], [], []
        images = _Images(self.surfaces, self.work, lines)
        for k, own in enumerate(self.work.patches):
            for number in {number for border in own.borders for number, _ in border}:
                line = images.line(number, own.surface)
                start.append(line[:-1])
                end.append(line[1:])
                seam.append(np.full(len(line) - 1, number))
                patch.append(np.full(len(line) - 1, k))
        i, j = crossings(*(np.concatenate(a) for a in (start, end, patch)))
        numbers, patches, points = np.concatenate(seam), np.concatenate(patch), np.concatenate(start)
        if noted:
            self._places += [(self.work.patches[k].surface, uv) for k, uv in zip(patches[i].tolist(), points[i])]
        return set(numbers[i].tolist()) | set(numbers[j].tolist())


class _Images:
    """Polygons of the seams in the parameters of their surfaces."""

    def __init__(self, surfaces: Surfaces, work: Patchwork, lines: Lines) -> None:
        self.surfaces, self.work, self.nodes, self.curves = surfaces, work, lines.nodes, lines.curves

    def line(self, number: int, surface: int) -> np.ndarray:
        """Return the image (N, 2) of a seam."""
        curve, seam = self.curves.get(number), self.work.seams[number]
        flat = self.surfaces.strip(surface) < 0
        if curve is None:
            ends = seam.vertices[[0, -1]].tolist()
            if flat:
                return self._on_plane(surface, np.array([self.nodes.points[v] for v in ends]))
            return np.array([self.nodes.uv[v, surface] for v in ends])
        if flat:
            return self._on_plane(surface, _sampled(curve.knots, curve.points, curve.slopes))
        side = seam.surfaces.index(surface)
        return _sampled(curve.knots, curve.images[side], curve.image_slopes[side])

    def _on_plane(self, surface: int, points: np.ndarray) -> np.ndarray:
        plane = self.surfaces.plane(surface)
        return (points - plane[0]) @ plane[2:].T


def _sampled(knots: np.ndarray, values: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Points of a C1 cubic, some to each of its pieces, or of a polygon; the given values among them unchanged."""
    if not len(slopes):
        return values
    h = np.diff(knots)
    pieces = [between(values[:-1], slopes[:-1], values[1:], slopes[1:], h, k / _SAMPLES) for k in range(1, _SAMPLES)]
    inner = np.stack([values[:-1], *pieces], 1)
    return np.concatenate([inner.reshape(-1, values.shape[1]), values[-1:]])


def crossings(start: np.ndarray, end: np.ndarray, group: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Return the pieces (X,), (X,) that cross others of the same group; common ends are no crossings.

    Parameters
    ----------
    start, end : ndarray (N, 2)
    group : ndarray (N,), int
    """
    low, high = np.minimum(start, end), np.maximum(start, end)
    bottom = np.full((int(group.max(initial=-1)) + 1, 2), np.inf)
    top = -bottom
    np.minimum.at(bottom, group, low)
    np.maximum.at(top, group, high)
    size = (top - bottom).clip(1e-300)
    share = np.zeros((len(bottom), 2))
    np.add.at(share, group, (high - low) / size[group])
    axis = share.argmin(1)[group]  # along which fewer pieces lie side by side
    row = np.arange(len(group))
    a = 2.0 * group + (low[row, axis] - bottom[group, axis]) / size[group, axis]
    b = 2.0 * group + (high[row, axis] - bottom[group, axis]) / size[group, axis] + 1e-9
    order = np.argsort(a)
    count = np.searchsorted(a[order], b[order], side="right") - np.arange(len(a)) - 1
    i = np.repeat(np.arange(len(a)), count)
    j = i + 1 + np.arange(len(i)) - np.repeat(np.cumsum(count) - count, count)
    i, j = order[i], order[j]
    near = ((low[i] <= high[j]) & (low[j] <= high[i])).all(1)
    i, j = i[near], j[near]
    along, other, off = end[i] - start[i], end[j] - start[j], start[j] - start[i]
    hit = (_cross(along, off) * _cross(along, off + other) < 0) & (_cross(other, -off) * _cross(other, along - off) < 0)
    return i[hit], j[hit]


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
