# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the surfaces of a patchwork meet exactly: its nodes and seams, from the triangles' guess by Newton's method."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from .patchwork import Patchwork, Seam
from .strips import Strips

NEAR = 1e-7  # mm; a point on two surfaces lies nearer than this to both
_FAR = 0.1  # mm; a solution further from the triangles' guess than this is another one
_STEP = 0.05  # mm, the longest step
_ROUNDS = 12
_SPACING = 0.03  # mm; points of a seam keep this distance at first
_GRAZING = 0.02  # sine of the angle between two surfaces below which their normals do not give the seam's direction


class Surfaces:
    """The surfaces of a patchwork by number: M strips and 2 caps of each rod, then the envelope's planes.

    Parameters
    ----------
    strips : Strips
    planes : ndarray (P, 4, 3)
        A point (mm), the unit outer normal, and two axes, right-handed.
    """

    def __init__(self, strips: Strips, planes: np.ndarray) -> None:
        self.strips = strips
        self.corners = strips.patches.shape[1]
        caps = strips.caps.copy()
        self.planes = np.concatenate([caps.reshape(-1, 4, 3), np.asarray(planes, float).reshape(-1, 4, 3)])
        self.first_plane = len(strips) * (self.corners + 2)

    def rod(self, surface: int) -> int:
        """Return the rod of a surface, -1 for the envelope's planes."""
        return surface // (self.corners + 2) if surface < self.first_plane else -1

    def strip(self, surface: int) -> int:
        """Return the strip's number on its rod, -1 for planes."""
        k = surface % (self.corners + 2)
        return k if surface < self.first_plane and k < self.corners else -1

    def cap(self, surface: int) -> int:
        """Return 0 or 1 for a rod's first or last cap, -1 for others."""
        k = surface % (self.corners + 2) - self.corners
        return k if surface < self.first_plane and k >= 0 else -1

    def plane(self, surface: int) -> np.ndarray:
        """Return point, normal and axes (4, 3) of a plane."""
        if surface >= self.first_plane:
            return self.planes[2 * len(self.strips) + surface - self.first_plane]
        return self.planes[2 * self.rod(surface) + self.cap(surface)]

    def at(self, surface: np.ndarray, uv: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
        """Return points (N, 3), mm, of strips at parameters (N, 2), and the derivatives (N, 3, 2)."""
        rod, strip = surface // (self.corners + 2), surface % (self.corners + 2)
        knots = self.strips.knots[rod]
        span = (uv[:, 1:] >= knots[:, 1:-1]).sum(1)
        row = np.arange(len(rod))
        start, width = knots[row, span], knots[row, span + 1] - knots[row, span]
        u, v = uv[:, 0], (uv[:, 1] - start) / width
        poles = self.strips.patches[rod, strip, span]
        (bu, du), (bv, dv) = _bernstein(u), _bernstein(v)
        along = np.einsum("nb,nabx->nax", bv, poles)
        point = np.einsum("na,nax->nx", bu, along)
        by_u = np.einsum("na,nax->nx", du, along)
        by_v = np.einsum("na,nb,nabx->nx", bu, dv, poles) / width[:, None]
        return point, np.stack([by_u, by_v], 2)


def _bernstein(t: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Bernstein's cubics (N, 4) and their derivatives."""
    s = 1 - t
    value = np.stack([s**3, 3 * t * s**2, 3 * t**2 * s, t**3], 1)
    return value, 3 * np.stack([-(s**2), s**2 - 2 * t * s, 2 * t * s - t**2, t**2], 1)


@dataclass(frozen=True)
class Meeting:
    """N points at each of which k strips and m planes meet.

    Attributes
    ----------
    strips : ndarray (N, k), int
    planes : ndarray (N, m, 2, 3)
        A point and the normal.
    uv : ndarray (N, k, 2)
        Parameters on the strips.
    fixed : ndarray (N, k, 2), bool
        Parameters that are known: a strip's border, a rod's end.
    guess : ndarray (N, 3), mm
    """

    strips: np.ndarray
    planes: np.ndarray
    uv: np.ndarray
    fixed: np.ndarray
    guess: np.ndarray


class Met(NamedTuple):
    """Points (N, 3), mm, their parameters (N, k, 2), and how far from the strips and planes they are at most, (N,)."""

    points: np.ndarray
    uv: np.ndarray
    distances: np.ndarray


def meet(surfaces: Surfaces, meeting: Meeting) -> Met:
    """Return where strips and planes meet: Newton's method with the least step, from the guess.

    Where there is no such point near the guess, the guess itself and its feet on the strips.
    """
    uv = _newton(surfaces, meeting)
    met = _met(surfaces, meeting, uv)
    lost = (met.distances > NEAR) | (np.linalg.norm(met.points - meeting.guess, axis=1) > _FAR)
    if not lost.any():
        return met
    some = Meeting(*(getattr(meeting, name)[lost] for name in Meeting.__dataclass_fields__))
    feet = _feet(surfaces, some)
    uv[lost] = feet
    again = _met(surfaces, some, feet)
    points, distances = met.points.copy(), met.distances.copy()
    points[lost], distances[lost] = again.points, again.distances
    return Met(points, uv, distances)


def _met(surfaces: Surfaces, meeting: Meeting, uv: np.ndarray) -> Met:
    """The mean of the points on the strips, and its distances from them and from the planes."""
    count, k = uv.shape[:2]
    on = surfaces.at(meeting.strips.ravel(), uv.reshape(-1, 2))[0].reshape(count, k, 3)
    point = on.mean(1)
    for plane in meeting.planes.transpose(1, 0, 2, 3):  # planes are met exactly
        point = point - ((point - plane[:, 0]) * plane[:, 1]).sum(1, keepdims=True) * plane[:, 1]
    return Met(point, uv, np.linalg.norm(on - point[:, None], axis=2).max(1, initial=0.0))


def _newton(surfaces: Surfaces, meeting: Meeting) -> np.ndarray:
    uv = meeting.uv.copy()
    active = np.arange(len(uv))
    k = uv.shape[1]
    for _ in range(_ROUNDS):
        strips, some = meeting.strips[active], uv[active]
        point, slope = surfaces.at(strips.ravel(), some.reshape(-1, 2))
        point, slope = point.reshape(-1, k, 3), slope.reshape(-1, k, 3, 2)
        scale = np.linalg.norm(slope, axis=2).clip(1e-9)  # mm for one unit of a parameter
        slope = np.where(meeting.fixed[active][:, :, None], 0.0, slope / scale[:, :, None])
        matrix, gap = _system(point, slope, meeting.planes[active])
        square = matrix @ matrix.transpose(0, 2, 1)
        trace = np.trace(square, axis1=1, axis2=2)
        square += (1e-12 * trace + 1e-30)[:, None, None] * np.eye(square.shape[1])
        step = -(matrix.transpose(0, 2, 1) @ np.linalg.solve(square, gap[..., None]))[..., 0].reshape(-1, k, 2)
        length = np.abs(step).max((1, 2), initial=0.0)
        step *= np.minimum(1, _STEP / length.clip(1e-300))[:, None, None]
        uv[active] = np.clip(some + step / scale, 0.0, 1.0)
        active = active[length > 1e-10]
        if not len(active):
            break
    return uv


def _system(point: np.ndarray, slope: np.ndarray, planes: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Matrices (N, equations, 2 k) and what is to vanish: strips apart from the first one, the first from planes."""
    count, k = point.shape[:2]
    matrix = np.zeros((count, 3 * (k - 1) + planes.shape[1], k, 2))
    gap = np.zeros(matrix.shape[:2])
    for other in range(1, k):
        rows = slice(3 * other - 3, 3 * other)
        matrix[:, rows, other], matrix[:, rows, 0] = slope[:, other], -slope[:, 0]
        gap[:, rows] = point[:, other] - point[:, 0]
    for m in range(planes.shape[1]):
        row = 3 * (k - 1) + m
        matrix[:, row, 0] = np.einsum("nx,nxi->ni", planes[:, m, 1], slope[:, 0])
        gap[:, row] = ((point[:, 0] - planes[:, m, 0]) * planes[:, m, 1]).sum(1)
    return matrix.reshape(count, -1, 2 * k), gap


def _feet(surfaces: Surfaces, meeting: Meeting) -> np.ndarray:
    """Parameters (N, k, 2) of the points of strips next to the guess, known ones kept."""
    k = meeting.strips.shape[1]
    start, fixed = meeting.uv.reshape(-1, 2), meeting.fixed.reshape(-1, 2)
    goal = np.repeat(meeting.guess, k, 0)
    return _strip_feet(surfaces, meeting.strips.ravel(), start, fixed, goal).reshape(meeting.uv.shape)


def _strip_feet(
    surfaces: Surfaces, strips: np.ndarray, uv: np.ndarray, fixed: np.ndarray, goal: np.ndarray
) -> np.ndarray:
    """Parameters (N, 2) of the points of strips next to points (N, 3), by Newton's method from ``uv``."""
    uv = uv.clip(0, 1)
    for _ in range(_ROUNDS):
        point, slope = surfaces.at(strips, uv)
        scale = np.linalg.norm(slope, axis=1).clip(1e-9)
        slope = np.where(fixed[:, None], 0.0, slope / scale[:, None])
        square = slope.transpose(0, 2, 1) @ slope + 1e-12 * np.eye(2)
        step = np.linalg.solve(square, np.einsum("nxi,nx->ni", slope, goal - point)[..., None])[..., 0]
        uv = np.clip(uv + step.clip(-_STEP, _STEP) / scale, 0.0, 1.0)
    return uv


# ----------------------------------------------------------------------------------------------------------- nodes


@dataclass(frozen=True)
class Nodes:
    """The nodes of a patchwork, by vertex of its mesh.

    Attributes
    ----------
    points : dict
        vertex -> ndarray (3,), mm.
    uv : dict
        (vertex, surface) -> ndarray (2,): parameters on each strip that meets there.
    distances : dict
        vertex -> float, mm: how far its surfaces are from it at most.
    """

    points: Dict[int, np.ndarray]
    uv: Dict[Tuple[int, int], np.ndarray]
    distances: Dict[int, float]


class _NodeStrips(NamedTuple):
    """Which strips a node needs: one a rod, with what is known of its parameters."""

    strips: Tuple[int, ...]
    uv: Tuple[np.ndarray, ...]
    fixed: Tuple[Tuple[bool, bool], ...]
    planes: Tuple[int, ...]


def find_nodes(surfaces: Surfaces, work: Patchwork, vertices: np.ndarray, exact: bool = True) -> Nodes:
    """Return the nodes of a patchwork whose mesh has the given vertices (V, 3), mm.

    ``exact`` ones lie where the surfaces meet, others where the triangles do.
    """
    groups: Dict[Tuple[int, int], List[Tuple[int, _NodeStrips]]] = {}
    found = Nodes({}, {}, {})
    for vertex, met_by in work.meeting.items():
        wanted = _node_strips(surfaces, work, vertex, met_by)
        groups.setdefault((len(wanted.strips), len(wanted.planes)), []).append((vertex, wanted))
    for (strips, planes), members in groups.items():
        numbers = [vertex for vertex, _ in members]
        guess = vertices[numbers]
        if strips:
            meeting = _meeting(surfaces, members, guess, strips, planes)
            met = meet(surfaces, meeting) if exact else Met(guess, meeting.uv, _away(surfaces, meeting))
        else:
            met = Met(guess, np.zeros((len(members), 0, 2)), np.zeros(len(members)))
        for k, (vertex, wanted) in enumerate(members):
            found.points[vertex], found.distances[vertex] = met.points[k], float(met.distances[k])
            for i, strip in enumerate(wanted.strips):
                for own in work.meeting[vertex]:
                    if surfaces.strip(own) >= 0 and surfaces.rod(own) == surfaces.rod(strip):
                        found.uv[vertex, own] = _seen_from(surfaces, strip, own, met.uv[k, i])
    return found


def _away(surfaces: Surfaces, meeting: Meeting) -> np.ndarray:
    """Distances (N,) of the guess from its points on the strips, the largest."""
    count, k = meeting.strips.shape
    on = surfaces.at(meeting.strips.ravel(), meeting.uv.reshape(-1, 2))[0].reshape(count, k, 3)
    return np.linalg.norm(on - meeting.guess[:, None], axis=2).max(1, initial=0.0)


def _meeting(
    surfaces: Surfaces, members: Sequence[Tuple[int, _NodeStrips]], guess: np.ndarray, strips: int, planes: int
) -> Meeting:
    wanted, count = [w for _, w in members], len(members)
    return Meeting(
        np.array([w.strips for w in wanted], int).reshape(count, strips),
        np.array([[surfaces.plane(p)[:2] for p in w.planes] for w in wanted], float).reshape(count, planes, 2, 3),
        np.array([w.uv for w in wanted], float).reshape(count, strips, 2).clip(0, 1),
        np.array([w.fixed for w in wanted], bool).reshape(count, strips, 2),
        guess,
    )


def _node_strips(surfaces: Surfaces, work: Patchwork, vertex: int, meeting: Sequence[int]) -> _NodeStrips:
    """One strip of each rod; between two strips of a rod u is known, at a rod's own cap v is."""
    rods: Dict[int, List[int]] = {}
    ends, planes = {}, []
    for own in meeting:
        if surfaces.strip(own) >= 0:
            rods.setdefault(surfaces.rod(own), []).append(own)
    for own in meeting:
        if surfaces.strip(own) < 0:
            if surfaces.cap(own) >= 0 and surfaces.rod(own) in rods:
                ends[surfaces.rod(own)] = surfaces.cap(own)
            else:
                planes.append(own)
    strips, uvs, fixed = [], [], []
    for rod, owned in rods.items():
        strip, u_known = owned[0], len(owned) > 1
        uv = np.array(work.corners[vertex, strip], float)
        if u_known:
            uv[0] = 1.0 if surfaces.strip(owned[1]) == (surfaces.strip(strip) + 1) % surfaces.corners else 0.0
        if rod in ends:
            uv[1] = ends[rod]
        strips.append(strip)
        uvs.append(uv)
        fixed.append((u_known, rod in ends))
    return _NodeStrips(tuple(strips), tuple(uvs), tuple(fixed), tuple(planes))


def _seen_from(surfaces: Surfaces, strip: int, own: int, uv: np.ndarray) -> np.ndarray:
    """Parameters of a point of one strip on its neighbour."""
    if own == strip:
        return uv
    ahead = surfaces.strip(own) == (surfaces.strip(strip) + 1) % surfaces.corners
    return np.array([0.0 if ahead else 1.0, uv[1]])


# ----------------------------------------------------------------------------------------------------------- seams


def kind_of(surfaces: Surfaces, seam: Seam) -> str:
    """Return what a seam is: ``border`` of a rod's strips, ``ring`` at a rod's end, ``line`` of planes, or ``free``."""
    a, b = seam.surfaces
    if surfaces.strip(a) < 0 and surfaces.strip(b) < 0:
        return "line"
    if surfaces.rod(a) == surfaces.rod(b):
        return "ring" if min(surfaces.strip(a), surfaces.strip(b)) < 0 else "border"
    return "free"
