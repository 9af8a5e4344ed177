# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a solid, each sampled once for both faces that share it: the border of their triangles."""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Tuple

import numpy as np
import Part

from ..core.face_meshes import spread, steps_per_unit
from .vectors import point_array

_INTERVALS = 96  # of a curve that has no knots, over which its bend counts as linear
_PER_SPAN = 4  # the same of each span between knots
_STRAIGHT = 1e-9  # of an edge's length; a chord that lies closer makes one step
BESIDE = 1e-7  # of the range of a parameter; how far from a knot its two sides are looked at
SMOOTH = 1 - 1e-6  # cosine between the two sides of a knot that is no kink: 0.08 degrees


class EdgeSamples(NamedTuple):
    """Parameters (K,) along an edge, rising, and numbers (K,) of the vertices there."""

    at: np.ndarray
    numbers: np.ndarray


class BorderSamples:
    """The vertices of a mesh in the making: first those of the edges, then what faces add.

    Parameters
    ----------
    solid : Part.Shape
    deflection : float, mm
        Greatest distance of chords from their edges.
    angle : float
        Greatest angle between neighbouring chords.
    """

    def __init__(self, solid: Part.Shape, deflection: float, angle: float) -> None:
        self._blocks: List[np.ndarray] = []
        self._count = 0
        self._corners: Dict[int, List[Tuple[Part.Shape, int]]] = {}
        self._edges: Dict[int, List[Tuple[Part.Shape, EdgeSamples]]] = {}
        corners = solid.Vertexes
        for vertex, number in zip(corners, self.add(point_array([v.Point for v in corners])).tolist()):
            self._corners.setdefault(vertex.hashCode(), []).append((vertex, number))
        for edge in solid.Edges:
            self._edges.setdefault(edge.hashCode(), []).append((edge, self._sample(edge, deflection, angle)))

    @property
    def vertices(self) -> np.ndarray:
        """All vertices, ndarray of shape (V, 3), mm."""
        return np.concatenate(self._blocks)

    def add(self, points: np.ndarray) -> np.ndarray:
        """Take further vertices (P, 3), mm; return their numbers (P,)."""
        self._blocks.append(points)
        self._count += len(points)
        return np.arange(self._count - len(points), self._count)

    def of(self, edge: Part.Edge) -> EdgeSamples:
        """Return the samples of an edge, the same for each face it borders."""
        return next(samples for known, samples in self._edges[edge.hashCode()] if known.isSame(edge))

    def _corner(self, vertex: Part.Vertex) -> int:
        return next(number for known, number in self._corners[vertex.hashCode()] if known.isSame(vertex))

    def _sample(self, edge: Part.Edge, deflection: float, angle: float) -> EdgeSamples:
        first, last = edge.FirstParameter, edge.LastParameter
        ends = self._corner(edge.firstVertex()), self._corner(edge.lastVertex())
        if edge.Degenerated:
            return EdgeSamples(np.array([first, last]), np.array(ends))
        at = _parameters(edge, deflection, angle)
        inner = self.add(point_array([edge.Curve.value(t) for t in at[1:-1].tolist()]))
        return EdgeSamples(at, np.array([ends[0], *inner.tolist(), ends[1]]))


def _parameters(edge: Part.Edge, deflection: float, angle: float) -> np.ndarray:
    """Parameters of the samples of an edge: its ends, its kinks and what the deflection asks for."""
    curve, first, last = edge.Curve, edge.FirstParameter, edge.LastParameter
    if isinstance(curve, Part.Line):
        return np.array([first, last])
    at, breaks = fine_parameters(curve, first, last)
    along, second = (point_array([curve.getDN(t, n) for t in at.tolist()]) for n in (1, 2))
    length = np.linalg.norm(along, axis=1)
    bend = np.linalg.norm(np.cross(along, second), axis=1) / np.maximum(length, 1e-12 * length.max())
    if not breaks and bend.max() * (last - first) ** 2 <= 8 * _STRAIGHT * length.mean() * (last - first):
        return np.array([first, last])
    # two chords, or three where the edge comes back to its start: fewer would fall together with others
    return spread(at, steps_per_unit(bend, length, deflection, angle), breaks, 3 if edge.Closed else 2)


def fine_parameters(curve: Part.Curve, first: float, last: float) -> Tuple[np.ndarray, List[float]]:
    """Return parameters at which a curve's bend tells all of it, and those of its kinks."""
    if not isinstance(curve, Part.BSplineCurve):
        return np.linspace(first, last, _INTERVALS + 1), []
    at, doubtful = between_knots(curve.getKnots(), curve.getMultiplicities(), curve.Degree, first, last)
    beside = BESIDE * (last - first)
    kinks = []
    for t in doubtful:
        before, after = curve.getDN(t - beside, 1), curve.getDN(t + beside, 1)
        if not before.dot(after) > SMOOTH * before.Length * after.Length:
            kinks.append(t)
    return at, kinks


def between_knots(
    knots: List[float], multiplicities: List[int], degree: int, first: float, last: float, per_span: int = _PER_SPAN
) -> Tuple[np.ndarray, List[float]]:
    """Return parameters through the spans of a spline from ``first`` to ``last``, and knots where it may have kinks."""
    hair = 1e-9 * (last - first)
    within = [(k, m) for k, m in zip(knots, multiplicities) if first + hair < k < last - hair]
    ends = np.array([first, *(k for k, _ in within), last])
    per_span = max(per_span, int(np.ceil(_INTERVALS / 4 / (len(ends) - 1))))
    share = np.arange(per_span) / per_span
    at = (ends[:-1, None] + np.diff(ends)[:, None] * share).ravel()
    return np.concatenate([at, [last]]), [k for k, m in within if m >= degree]
