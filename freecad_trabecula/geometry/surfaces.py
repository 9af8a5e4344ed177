# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface under a face: points, tangents, outer normals, the nearest point, and where a plane cuts its border.

Closed surfaces go round, open ones end at their natural bounds, and points where a parameter has no meaning (the pole
of a sphere) are points like others. Everything is computed from values and derivatives of the surface, never by the
kernel's intersection algorithms, so that two versions of FreeCAD give the same numbers.
"""

from __future__ import annotations

import math
from typing import Iterator, List, Optional, Tuple

import FreeCAD
import numpy as np
import Part

from ..errors import KernelError
from .vectors import point_array

Vector = FreeCAD.Vector
Parameters = Tuple[float, float]

_NEWTON_STEPS = 30  # quadratic convergence needs about five; more means that there is no root near
_GRID = 24  # samples each way from which the nearest point of a face is sought
_EDGE_SAMPLES = (64, 2048)  # least and most samples of one edge; four per pole between
_NEAR_POLE = 1e-4  # of the parameters' range; the normal of a smooth pole is still all but the same so far from it
_RING = 12  # starts around a pole; Newton's iteration finds its way from 30 degrees off
_SINGULAR = 1e-9  # mm per unit of a parameter; shorter tangents have no direction
_SMOOTH = math.cos(0.05)  # normals around a pole that part by more are those of an apex
_TIE = 1e-6  # mm; points of a face whose distances differ by less are equally near


class _Range:
    """One parameter of a surface: how it is brought back when it leaves the surface."""

    def __init__(self, low: float, high: float, closed: bool, face_low: float, face_high: float) -> None:
        self.low, self.high, self.closed = low, high, closed
        self.face_low, self.face_high = face_low, face_high
        #: The longest step that Newton's iteration may take.
        self.most = 0.25 * (face_high - face_low)

    def back(self, value: float) -> float:
        if self.closed:
            return self.low + (value - self.low) % (self.high - self.low)
        return min(max(value, self.low), self.high)

    def in_face(self, value: float) -> float:
        """Return the turn of a closed parameter that lies in the face's own range, if one does."""
        if self.closed:
            turn = self.high - self.low
            value -= turn * math.floor((value - self.face_low) / turn)
            if value > self.face_high and value - turn > self.face_low - 1e-9 * turn:
                value -= turn
        return value

    def step(self, value: float, change: float) -> float:
        return self.back(value + min(max(change, -self.most), self.most))


class FaceSurface:
    """The surface of one face.

    Parameters
    ----------
    face : Part.Face
        With its placement, as ``solid.Faces`` gives it.
    outer : int
        1 if the oriented face's normal points out of the body, as for faces of a proper solid; -1 if it points in.
    """

    def __init__(self, face: Part.Face, outer: int = 1) -> None:
        self.face, self.geometry = face, face.Surface
        low_u, high_u, low_v, high_v = self.geometry.bounds()
        face_range = face.ParameterRange
        self.u = _Range(low_u, high_u, _is_closed(self.geometry, "U"), *face_range[:2])
        self.v = _Range(low_v, high_v, _is_closed(self.geometry, "V"), *face_range[2:])
        self._sign = outer * (-1 if face.Orientation == "Reversed" else 1)
        samples = point_array([self.point(at) for at in self.grid()])
        self._middle = Vector(*((samples.min(0) + samples.max(0)) / 2))
        #: Diagonal (mm) of the box around the samples. FreeCAD's BoundBox is another one once the face is triangulated.
        self.size = float(np.linalg.norm(np.ptp(samples, axis=0)))
        far = float(np.abs(samples).max())
        #: Distance below which two points are one: rounding of co-ordinates of this size, in mm.
        self.exact = max(1e-11, 4e-14 * far)
        #: Whether a side of the parameters is one point, around which they turn.
        self.has_pole = any(edge.Degenerated for edge in face.Edges)
        self._samples: Optional[List[_EdgeSamples]] = None
        self._apexes: List[Vector] = []

    def point(self, at: Parameters) -> Vector:
        """Return the point (mm) at parameters (u, v)."""
        return self.geometry.value(*at)

    def tangents(self, at: Parameters) -> Tuple[Vector, Vector]:
        """Return the derivatives of the point by u and by v."""
        return self.geometry.getDN(at[0], at[1], 1, 0), self.geometry.getDN(at[0], at[1], 0, 1)

    def normal(self, at: Parameters) -> Vector:
        """Return the unit normal that points out of the body.

        Raises
        ------
        KernelError
            If the surface has no normal there, as at the apex of a cone.
        """
        along_u, along_v = self.tangents(at)
        normal = along_u.cross(along_v)
        if min(along_u.Length, along_v.Length) < _SINGULAR or normal.Length <= 1e-9 * along_u.Length * along_v.Length:
            normal = self._singular_normal(at)
        return normal * (self._sign / normal.Length)

    def _singular_normal(self, at: Parameters) -> Vector:
        """Return the kernel's normal, not turned outwards, where the tangents give none but the surface is smooth."""
        if not self._is_apex(at):
            try:
                normal = self.geometry.normal(*at)  # the kernel takes higher derivatives
                if normal.Length > 0:
                    return normal
            except (Part.OCCError, RuntimeError, ValueError):
                pass  # told below
        raise KernelError(f"the face has no normal at ({_text(self.point(at))}) mm")

    def has(self, at: Parameters) -> bool:
        """Return whether the trimmed face has the point at these parameters."""
        return self.face.isPartOfDomain(self.u.in_face(at[0]), self.v.in_face(at[1]))

    def is_near(self, point: Vector) -> bool:
        """Return whether a point is within the face's size of its middle, as all of the face is."""
        return (point - self._middle).Length <= self.size

    def nearest(self, point: Vector) -> Parameters:
        """Return the parameters of the surface's point nearest to a point that lies on it or near it."""
        try:
            u, v = self.geometry.parameter(point)
        except (Part.OCCError, RuntimeError, ValueError) as error:
            raise KernelError(f"no point of the face's surface lies near ({_text(point)}) mm") from error
        return self._foot(point, (self.u.back(u), self.v.back(v)))

    def starts(self, point: Vector) -> Iterator[Parameters]:
        """Yield parameters from which to seek a point beside a pole, where a parameter turns by half a circle at once.

        First those of the nearest point as the kernel finds it; it may be the pole, where all directions are one. Then
        a ring about that, as wide as the point is far from it.
        """
        at = self.nearest(point)
        yield at
        longest = max(tangent.Length for tangent in self.tangents(at))
        yield from self._ring(at, (point - self.point(at)).Length / longest, _RING)

    def _ring(self, pole: Parameters, width: float, count: int) -> List[Parameters]:
        """Return parameters around a pole, ``width`` (of the parameter that does not turn) inside the face."""
        along_u, along_v = self.tangents(pole)
        u_turns = along_u.Length < along_v.Length
        turning, inwards, here = (self.u, self.v, pole[1]) if u_turns else (self.v, self.u, pole[0])
        there = here + width * (1 if here < 0.5 * (inwards.face_low + inwards.face_high) else -1)
        turned = [turning.face_low + (turning.face_high - turning.face_low) * k / count for k in range(count)]
        return [(t, there) if u_turns else (there, t) for t in turned]

    def _is_apex(self, at: Parameters) -> bool:
        """Return whether normals around a singular point part: an apex, not a smooth pole."""
        along_u, along_v = self.tangents(at)
        inwards = self.v if along_u.Length < along_v.Length else self.u
        around = self._ring(at, _NEAR_POLE * (inwards.face_high - inwards.face_low), 8)
        crosses = [a.cross(b) for a, b in map(self.tangents, around)]
        return not all(a.dot(b) > _SMOOTH * a.Length * b.Length for a in crosses for b in crosses)

    def _foot(self, point: Vector, at: Parameters) -> Parameters:
        """Sharpen the parameters of a foot point by Gauss and Newton; the start comes back if that fails."""
        start, best = at, (self.point(at) - point).Length
        for _ in range(_NEWTON_STEPS):
            off = point - self.point(at)
            along_u, along_v = self.tangents(at)
            du, dv = _least_squares(along_u, along_v, off)
            at = (self.u.step(at[0], du), self.v.step(at[1], dv))
            if (along_u * du + along_v * dv).Length < self.exact:
                break
        return at if (self.point(at) - point).Length <= best + self.exact else start

    def ahead(self, at: Parameters, off: Vector) -> Parameters:
        """Return, to first order, the parameters of the point that lies ``off`` (mm) from the one at ``at``."""
        du, dv = _least_squares(*self.tangents(at), off)
        return self.u.step(at[0], du), self.v.step(at[1], dv)

    def solve(self, base: Vector, across: Vector, along: Vector, reach: float, at: Parameters) -> Optional[Parameters]:
        """Return where the surface meets the line {x : (x - base) . across = 0, (x - base) . along = reach}.

        Parameters
        ----------
        base : Vector, mm
        across, along : Vector, unit
        reach : float, mm
        at : (u, v)
            Where to start.

        Returns
        -------
        (u, v) or None
            None if Newton's iteration finds no root near.
        """
        for _ in range(_NEWTON_STEPS):
            off = self.point(at) - base
            f, g = off.dot(across), off.dot(along) - reach
            if abs(f) + abs(g) < self.exact:
                return at
            along_u, along_v = self.tangents(at)
            du, dv = solve_two(along_u.dot(across), along_v.dot(across), along_u.dot(along), along_v.dot(along), -f, -g)
            at = (self.u.step(at[0], du), self.v.step(at[1], dv))
        return None

    def centre(self) -> Parameters:
        """Return the face's centre: its point nearest to its centre of mass.

        The centre of mass of a cylinder's side is equally far from a whole circle: then it is the point nearest the
        middle of the parameters. Where a hole or a bay is, it is the nearest of some hundred points inside the face.
        """
        target, grid = self.face.CenterOfMass, self.grid()
        distance = np.array([(self.point(at) - target).Length for at in grid])
        # Equal distances come in the order of the grid, which begins at the middle of the parameters.
        order = np.lexsort((np.arange(len(grid)), np.round(distance / _TIE)))
        foot = self._foot(target, grid[order[0]])
        if self.has(foot):
            return foot
        for k in order.tolist():
            if self.has(grid[k]):
                return grid[k]
        raise KernelError(f"none of {len(grid)} points tried lies inside the face of {self.face.Area:g} mm2")

    def grid(self) -> List[Parameters]:
        """Return parameters all over the face's range, those nearest to its middle first."""
        share = np.concatenate([[0.5], (np.arange(_GRID) + 0.5) / _GRID])
        a, b = (g.ravel() for g in np.meshgrid(share, share, indexing="ij"))
        order = np.argsort(np.round((a - 0.5) ** 2 + (b - 0.5) ** 2, 9), kind="stable")
        u = self.u.face_low + (self.u.face_high - self.u.face_low) * a[order]
        v = self.v.face_low + (self.v.face_high - self.v.face_low) * b[order]
        return list(zip(u.tolist(), v.tolist()))

    def border_crossings(self, base: Vector, across: Vector) -> List[Vector]:
        """Return the points where the plane through ``base`` with normal ``across`` cuts the border of the face.

        The border is the outer one and those of holes; the seam of a closed face is none. Edges that lie in the plane
        count by their ends, which belong to their neighbours too.
        """
        if self._samples is None:
            edges = self.face.Edges
            self._samples = [_EdgeSamples(e) for e in edges if not (e.Degenerated or e.isSeam(self.face))]
            self._apexes = [e.Vertexes[0].Point for e in edges if e.Degenerated and self._is_sharp(e)]
        found = [point for samples in self._samples for point in samples.crossings(base, across, self.exact)]
        return found + [p for p in self._apexes if abs((p - base).dot(across)) < 1e-7]

    def _is_sharp(self, edge: Part.Edge) -> bool:
        """Return whether a side of the parameters that is one point is an apex."""
        curve, first, _ = self.face.curveOnSurface(edge)
        at = curve.value(first)
        return self._is_apex((at.x, at.y))


def edge_samples(edge: Part.Edge) -> Tuple[np.ndarray, np.ndarray]:
    """Return parameters (K,) along an edge and its points (K, 3), mm, there; denser where a spline has many poles."""
    curve = edge.Curve
    count = min(max(4 * getattr(curve, "NbPoles", 16), _EDGE_SAMPLES[0]), _EDGE_SAMPLES[1])
    t = np.linspace(edge.FirstParameter, edge.LastParameter, count + 1)
    return t, point_array([curve.value(s) for s in t.tolist()])


class _EdgeSamples:
    """An edge with points along it, from which its crossings with planes are sharpened."""

    def __init__(self, edge: Part.Edge) -> None:
        self._curve = edge.Curve
        self._t, self._points = edge_samples(edge)

    def crossings(self, base: Vector, across: Vector, exact: float) -> List[Vector]:
        height = (self._points - np.array(tuple(base))) @ np.array(tuple(across))
        flat = np.abs(height) <= exact
        if flat.all():
            return [self._curve.value(float(t)) for t in (self._t[0], self._t[-1])]
        side = np.where(flat, 0.0, height)
        found = [self._curve.value(float(t)) for t in self._t[flat]]
        for k in np.nonzero(side[:-1] * side[1:] < 0)[0].tolist():
            found.append(self._root(base, across, float(self._t[k]), float(self._t[k + 1])))
        # Between three samples on one side the edge may touch the plane or dip through it.
        dip = (side[1:-1] * (side[1:-1] - side[:-2]) <= 0) & (side[1:-1] * (side[1:-1] - side[2:]) <= 0)
        dip &= (side[:-2] * side[1:-1] > 0) & (side[1:-1] * side[2:] > 0)
        for k in (np.nonzero(dip)[0] + 1).tolist():
            found += self._dip(base, across, float(self._t[k - 1]), float(self._t[k + 1]))
        return found

    def _height(self, base: Vector, across: Vector, t: float) -> float:
        return (self._curve.value(t) - base).dot(across)

    def _root(self, base: Vector, across: Vector, low: float, high: float) -> Vector:
        """Return the point of the one crossing between two parameters: Newton's iteration, kept between them."""
        rising = self._height(base, across, low) < 0
        t = 0.5 * (low + high)
        for _ in range(100):
            height = self._height(base, across, t)
            low, high = (t, high) if (height < 0) == rising else (low, t)
            slope = self._curve.getDN(t, 1).dot(across)
            after = t - height / slope if slope else low
            if not low < after < high:
                after = 0.5 * (low + high)
            if abs(after - t) <= 1e-15 * max(1.0, abs(t)):
                break
            t = after
        return self._curve.value(t)

    def _dip(self, base: Vector, across: Vector, low: float, high: float) -> List[Vector]:
        """Return both crossings of an edge that dips through the plane between two parameters, if it does."""
        sign = 1.0 if self._height(base, across, low) > 0 else -1.0
        ends, golden = (low, high), (math.sqrt(5) - 1) / 2
        for _ in range(60):
            a, b = high - golden * (high - low), low + golden * (high - low)
            heights = [sign * self._height(base, across, t) for t in (a, b)]
            for t, height in zip((a, b), heights):
                if height < 0:
                    return [self._root(base, across, *sorted((t, end))) for end in ends]
            low, high = (low, b) if heights[0] < heights[1] else (a, high)
        return []


def _is_closed(surface: Part.GeometrySurface, name: str) -> bool:
    """Return whether a surface comes round in the parameter U or V."""
    return bool(getattr(surface, f"is{name}Periodic")() or getattr(surface, f"is{name}Closed")())


def solve_two(a: float, b: float, c: float, d: float, f: float, g: float) -> Parameters:
    """Return (x, y) with a x + b y = f, c x + d y = g; at a pole, where one column vanishes, only the other counts."""
    determinant = a * d - b * c
    if abs(determinant) > 1e-12 * math.hypot(a, c) * math.hypot(b, d):
        return (f * d - b * g) / determinant, (a * g - f * c) / determinant
    if a * a + c * c > b * b + d * d:
        return (a * f + c * g) / (a * a + c * c), 0.0
    return (0.0, (b * f + d * g) / (b * b + d * d)) if b or d else (0.0, 0.0)


def _least_squares(along_u: Vector, along_v: Vector, off: Vector) -> Parameters:
    """Return the (du, dv) that best make ``along_u du + along_v dv = off``."""
    cross = along_u.dot(along_v)
    return solve_two(along_u.dot(along_u), cross, cross, along_v.dot(along_v), along_u.dot(off), along_v.dot(off))


def _text(point: Vector) -> str:
    return ", ".join(f"{c:.4g}" for c in point)
