# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seams of two surfaces as C1 cubics in space and in both surfaces' parameters, as exact as asked for."""

from __future__ import annotations

from typing import List, NamedTuple, Sequence, Tuple

import numpy as np

from .patchwork import Patchwork
from .seams import NEAR, Meeting, Nodes, Surfaces, meet

EXACT = 2e-6  # mm; seams are refined until their curves are this near to both surfaces
_CLOSE = 0.002  # mm; points of triangles that are closer are left out
_SPACING = 0.08  # mm; at first the points of a seam are this far apart,
_TURN = 0.3  # radians; or nearer, where it turns by more
_FAR = 0.1  # mm; a point that Newton's method takes further away is left out
_GRAZING = 0.02  # sine of the angle of two surfaces below which their normals do not give the direction of the seam
_REFINEMENTS = 5
_LEAST_SINE = 0.01
_LEAST_STEP = 1e-6  # mm, of a polygon's parameter
_CHECKS = (0.25, 0.5, 0.75)


class SeamCurve(NamedTuple):
    """A seam from node to node: a C1 cubic in space or a polygon, and its images on its two surfaces.

    Attributes
    ----------
    knots : ndarray (N,)
        About the arc length, mm.
    points, slopes : ndarray (N, 3)
        mm, and derivatives by the parameter; those of a polygon are empty (0, 3).
    images, image_slopes : tuple of ndarray (N, 2)
        Parameters on the left and the right surface and their derivatives; empty (0, 2) for a plane.
    distance : float, mm
        How far the curve is from the surfaces at most.
    error : float, mm
        About how far it is from the true seam at most: where the surfaces nearly touch, that is further.
    worst : tuple of (int, ndarray (2,))
        Where that is: strips and parameters.
    """

    knots: np.ndarray
    points: np.ndarray
    slopes: np.ndarray
    images: Tuple[np.ndarray, np.ndarray]
    image_slopes: Tuple[np.ndarray, np.ndarray]
    distance: float
    error: float
    worst: Tuple[Tuple[int, np.ndarray], ...]


class _Run:
    """The points of many seams that have the same kinds of surfaces, sorted by seam and along it."""

    def __init__(self, seam: np.ndarray, order: np.ndarray, end: np.ndarray, meeting: Meeting) -> None:
        self.seam, self.order, self.end, self.meeting = seam, order, end, meeting
        self.points = meeting.guess

    def keep(self, mask: np.ndarray) -> None:
        """Leave out the other points."""
        self.seam, self.order, self.end, self.points = (a[mask] for a in (self.seam, self.order, self.end, self.points))
        self.meeting = Meeting(*(getattr(self.meeting, n)[mask] for n in Meeting.__dataclass_fields__))

    def insert(self, seam: np.ndarray, order: np.ndarray, meeting: Meeting, points: np.ndarray) -> None:
        """Add points between others."""
        seam, order = np.append(self.seam, seam), np.append(self.order, order)
        sorting = np.lexsort((order, seam))
        self.seam, self.order = seam[sorting], order[sorting]
        self.end = np.append(self.end, np.zeros(len(points), bool))[sorting]
        self.points = np.concatenate([self.points, points])[sorting]
        both = (np.concatenate([getattr(m, n) for m in (self.meeting, meeting)]) for n in Meeting.__dataclass_fields__)
        self.meeting = Meeting(*(a[sorting] for a in both))

    @property
    def joined(self) -> np.ndarray:
        """True (N - 1,) where a point and the next belong to one seam."""
        return self.seam[1:] == self.seam[:-1]


def seam_curves(
    surfaces: Surfaces, work: Patchwork, vertices: np.ndarray, nodes: Nodes, which: Sequence[int]
) -> List[SeamCurve]:
    """Return the curves of the given free seams (of two rods, or of a rod and a plane).

    Parameters
    ----------
    surfaces : Surfaces
    work : Patchwork
    vertices : ndarray (V, 3), mm
        Of its mesh.
    nodes : Nodes
    which : sequence of int
        Numbers of seams.
    """
    curves: List[SeamCurve] = [None] * len(which)  # type: ignore[list-item]
    for strips in (2, 1):
        some = [k for k, n in enumerate(which) if _strips_of(surfaces, work.seams[n].surfaces) == strips]
        if not some:
            continue
        run = _run(surfaces, work, vertices, nodes, [which[k] for k in some])
        _solve(surfaces, run)
        for _ in range(_REFINEMENTS):
            if not _refine(surfaces, run):
                break
        for k, curve in zip(some, _curves(surfaces, run, [work.seams[which[k]].surfaces for k in some])):
            curves[k] = curve
    return curves


def _strips_of(surfaces: Surfaces, pair: Tuple[int, int]) -> int:
    return sum(surfaces.strip(s) >= 0 for s in pair)


def _run(surfaces: Surfaces, work: Patchwork, vertices: np.ndarray, nodes: Nodes, which: Sequence[int]) -> _Run:
    """The seams' points as the triangles give them, thinned; nodes where they were found."""
    seam, order, end, points, strips, planes, uvs = [], [], [], [], [], [], []
    for k, number in enumerate(which):
        line, pair = work.seams[number].vertices, work.seams[number].surfaces
        own = [s for s in pair if surfaces.strip(s) >= 0]
        flat = [surfaces.plane(s)[:2] for s in pair if surfaces.strip(s) < 0]
        kept = _thinned(vertices[line])
        for i in kept:
            vertex, is_end = int(line[i]), i in (0, len(line) - 1)
            seam.append(k)
            order.append(float(i))
            end.append(is_end)
            points.append(nodes.points[vertex] if is_end else vertices[vertex])
            known = nodes.uv if is_end else work.corners
            uvs.append([known[vertex, s] for s in own])
            strips.append(own)
            planes.append(flat)
    count = len(seam)
    uv = np.array(uvs, float).clip(0, 1)  # (count, strips, 2)
    meeting = Meeting(
        np.array(strips), np.array(planes, float).reshape(count, 2 - uv.shape[1], 2, 3), uv, np.zeros(uv.shape, bool),
        np.array(points),
    )  # fmt: skip
    return _Run(np.array(seam), np.array(order), np.array(end), meeting)


def _thinned(points: np.ndarray) -> List[int]:
    """Numbers of points, the ends among them, that keep a small distance."""
    step = np.linalg.norm(np.diff(points, axis=0), axis=1)
    length = np.concatenate([[0.0], np.cumsum(step)])
    kept, last = [0], 0.0
    for i in range(1, len(points) - 1):
        if length[i] - last >= _CLOSE and length[-1] - length[i] >= _CLOSE:
            kept.append(i)
            last = length[i]
    return [*kept, len(points) - 1]


def _solve(surfaces: Surfaces, run: _Run) -> None:
    """Move all inner points to where their surfaces meet; leave out those that go astray or back."""
    inner = np.nonzero(~run.end)[0]
    some = Meeting(*(getattr(run.meeting, n)[inner] for n in Meeting.__dataclass_fields__))
    met = meet(surfaces, some)
    good = np.ones(len(run.seam), bool)
    good[inner] = (met.distances <= NEAR) & (np.linalg.norm(met.points - some.guess, axis=1) <= _FAR)
    run.points = run.points.copy()
    run.points[inner] = met.points
    run.meeting.uv[inner] = met.uv
    run.keep(good)
    for _ in range(3):
        step = np.diff(run.points, axis=0)
        turns_back = np.zeros(len(run.seam), bool)
        turns_back[1:-1] = ((step[1:] * step[:-1]).sum(1) <= 0) & run.joined[1:] & run.joined[:-1]
        out = turns_back & ~run.end
        if not out.any():
            break
        run.keep(~out)
    run.keep(_spread(run, _slopes(surfaces, run)[0]))


def _spread(run: _Run, tangent: np.ndarray) -> np.ndarray:
    """Which points to keep: the ends, and of the others enough for the seam's turns."""
    step = np.append(np.linalg.norm(np.diff(run.points, axis=0), axis=1) / _SPACING, 0.0)
    turn = np.append(np.arccos((tangent[1:] * tangent[:-1]).sum(1).clip(-1, 1)) / _TURN, 0.0)
    gain = np.maximum(step, turn).tolist()
    kept, passed = run.end.tolist(), 0.0
    for i, is_end in enumerate(kept):
        if is_end or passed >= 1:
            kept[i], passed = True, 0.0
        passed += gain[i]
    return np.array(kept)


def _slopes(surfaces: Surfaces, run: _Run) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Unit tangents (N, 3) of the seams, the derivatives (N, k, 2) of the parameters, sines of the surfaces' angles."""
    count, k = run.meeting.uv.shape[:2]
    slope = surfaces.at(run.meeting.strips.ravel(), run.meeting.uv.reshape(-1, 2))[1].reshape(count, k, 3, 2)
    normals = np.cross(slope[..., 0], slope[..., 1])
    normals /= np.linalg.norm(normals, axis=2, keepdims=True).clip(1e-300)
    other = normals[:, 1] if k == 2 else run.meeting.planes[:, 0, 1]
    tangent = np.cross(normals[:, 0], other)
    sine = np.linalg.norm(tangent, axis=1, keepdims=True)
    step = np.where(run.joined[:, None], np.diff(run.points, axis=0), 0.0)
    chord = np.zeros_like(run.points)
    chord[:-1] += step
    chord[1:] += step
    chord /= np.linalg.norm(chord, axis=1, keepdims=True).clip(1e-300)
    tangent /= sine.clip(1e-300)
    cosine = (tangent * chord).sum(1, keepdims=True)
    weak = (sine < _GRAZING) | (np.abs(cosine) < 0.5)
    tangent = np.where(weak, chord, np.sign(cosine) * tangent)
    square = slope.transpose(0, 1, 3, 2) @ slope
    right = np.einsum("nkxi,nx->nki", slope, tangent)
    return tangent, np.linalg.solve(square + 1e-18 * np.eye(2), right[..., None])[..., 0], sine[:, 0]


def _steps(run: _Run, tangent: np.ndarray) -> np.ndarray:
    """Arc lengths (N - 1,) from point to point: those of circles that have the tangents' turns."""
    chord = np.linalg.norm(np.diff(run.points, axis=0), axis=1)
    cosine = (tangent[1:] * tangent[:-1]).sum(1).clip(-1, 1)
    half = np.arccos(cosine).clip(0, 2.5) / 2
    return chord / np.sinc(half / np.pi)


def between(a: np.ndarray, da: np.ndarray, b: np.ndarray, db: np.ndarray, h: np.ndarray, t: float) -> np.ndarray:
    """Return Hermite's cubics from values a, slopes da to b, db (N, ...) over steps h (N,), at share t of each."""
    h = h.reshape((-1,) + (1,) * (a.ndim - 1))
    return (
        (1 + 2 * t) * (1 - t) ** 2 * a + t * (1 - t) ** 2 * h * da + t * t * (3 - 2 * t) * b + t * t * (t - 1) * h * db
    )


class _Errors(NamedTuple):
    """Between points: distances (N - 1,) of curves from surfaces and from seams, middles and parameters there."""

    distance: np.ndarray
    true: np.ndarray
    middle: np.ndarray
    uv: np.ndarray


def _errors(surfaces: Surfaces, run: _Run) -> _Errors:
    tangent, change, sine = _slopes(surfaces, run)
    h = _steps(run, tangent)
    uv, strips = run.meeting.uv, run.meeting.strips
    error = np.zeros(len(h))
    for t in _CHECKS:
        point = between(run.points[:-1], tangent[:-1], run.points[1:], tangent[1:], h, t)
        image = between(uv[:-1], change[:-1], uv[1:], change[1:], h, t)
        for i in range(uv.shape[1]):
            on = surfaces.at(strips[:-1, i], image[:, i])[0]
            error = np.maximum(error, np.linalg.norm(on - point, axis=1))
        for plane in run.meeting.planes[:-1].transpose(1, 0, 2, 3):
            error = np.maximum(error, np.abs(((point - plane[:, 0]) * plane[:, 1]).sum(1)))
        if t == 0.5:
            middle, middle_uv = point, image
    error = np.where(run.joined, error, 0.0)
    return _Errors(error, error / np.minimum(sine[1:], sine[:-1]).clip(_LEAST_SINE, 1), middle, middle_uv)


def _refine(surfaces: Surfaces, run: _Run) -> bool:
    """Add points where the curves are too far from the surfaces; return whether there were any."""
    errors = _errors(surfaces, run)
    rough = np.nonzero(errors.true > EXACT)[0]
    if not len(rough):
        return False
    meeting = Meeting(
        run.meeting.strips[rough], run.meeting.planes[rough], errors.uv[rough].clip(0, 1),
        run.meeting.fixed[rough], errors.middle[rough],
    )  # fmt: skip
    met = meet(surfaces, meeting)
    chord = np.linalg.norm(run.points[rough + 1] - run.points[rough], axis=1)
    moved = np.linalg.norm(met.points - meeting.guess, axis=1)
    good = (met.distances <= NEAR) & (moved < chord / 4) & (chord > 1e-4)
    if not good.any():
        return False
    rough = rough[good]
    order = (run.order[rough] + run.order[rough + 1]) / 2
    added = Meeting(*(getattr(meeting, n)[good] for n in Meeting.__dataclass_fields__))
    added.uv[:] = met.uv[good]
    run.insert(run.seam[rough], order, added, met.points[good])
    return True


def _curves(surfaces: Surfaces, run: _Run, pairs: Sequence[Tuple[int, int]]) -> List[SeamCurve]:
    tangent, change, _ = _slopes(surfaces, run)
    h = _steps(run, tangent)
    errors = _errors(surfaces, run)
    bounds = np.searchsorted(run.seam, np.arange(len(pairs) + 1))
    none = np.zeros((0, 2))
    curves = []
    for k, pair in enumerate(pairs):
        a, b = bounds[k], bounds[k + 1]
        images, slopes, column = [], [], 0
        for surface in pair:
            if surfaces.strip(surface) < 0:
                images.append(none)
                slopes.append(none)
                continue
            images.append(run.meeting.uv[a:b, column])
            slopes.append(change[a:b, column])
            column += 1
        knots = np.concatenate([[0.0], np.cumsum(h[a : b - 1])])
        at = a + int(errors.true[a : b - 1].argmax())
        worst = tuple(zip(run.meeting.strips[at].tolist(), errors.uv[at]))
        away, true = (float(e[a : b - 1].max()) for e in (errors.distance, errors.true))
        both = (images[0], images[1]), (slopes[0], slopes[1])
        curves.append(SeamCurve(knots, run.points[a:b], tangent[a:b], *both, away, true, worst))
    return curves


def polygon_curve(surfaces: Surfaces, work: Patchwork, vertices: np.ndarray, nodes: Nodes, number: int) -> SeamCurve:
    """Return a seam as the triangles' polygon, between the given nodes."""
    seam = work.seams[number]
    first, last = seam.vertices[[0, -1]].tolist()
    points = vertices[seam.vertices].copy()
    points[0], points[-1] = nodes.points[first], nodes.points[last]
    knots = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1).clip(_LEAST_STEP))])
    images, away, worst = [], 0.0, []
    for surface in seam.surfaces:
        if surfaces.strip(surface) < 0:
            images.append(np.zeros((0, 2)))
            continue
        uv = np.array([work.corners[v, surface] for v in seam.vertices.tolist()])
        uv[0], uv[-1] = nodes.uv[first, surface], nodes.uv[last, surface]
        images.append(uv.clip(0, 1))
        at = np.concatenate([(1 - share) * uv[:-1] + share * uv[1:] for share in (0.0, *_CHECKS)])
        on = surfaces.at(np.full(len(at), surface), at)[0]
        line = np.concatenate([(1 - share) * points[:-1] + share * points[1:] for share in (0.0, *_CHECKS)])
        apart = np.linalg.norm(on - line, axis=1)
        away = max(away, float(apart.max()))
        worst.append((surface, at[apart.argmax()]))
    none = (np.zeros((0, 2)), np.zeros((0, 2)))
    return SeamCurve(knots, points, np.zeros((0, 3)), (images[0], images[1]), none, away, away, tuple(worst))
