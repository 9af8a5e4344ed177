# SPDX-License-Identifier: LGPL-2.1-or-later
"""Co-ordinate lines on a face (thesis 4.2.2): the curve in which a plane through a point meets it, by arc length.

The line is followed from its origin both ways in steps. Between two stations it is the graph of a function over the
tangent of the first, so that each point of it is the root of two equations, and its length an integral (Gauss and
Legendre). It stops at the trimmed border, where the plane cuts an edge of the face; at its own origin, when it comes
round; and where it meets another co-ordinate line from which sites are traced as well.
"""

from __future__ import annotations

import bisect
import math
from typing import List, NamedTuple, Optional, Sequence, Tuple

import FreeCAD
import numpy as np

from ..errors import KernelError, ParameterError
from .surfaces import FaceSurface, Parameters

Vector = FreeCAD.Vector

BORDER, ROUND, MEETING, LOST = "border", "round", "meeting", "lost"

_COARSE, _FINE = ([a.tolist() for a in np.polynomial.legendre.leggauss(n)] for n in (4, 5))
_LENGTH_ERROR = 1e-8  # mm; a step is halved while its length by 4 and by 5 points differs by more
_SHORTEST = (
    1e-4  # of the face's size; shorter steps are taken as they are: the line runs over a knot or an edge of the surface
)
_LONGEST = 1 / 16  # of the face's size
_TURN = math.cos(0.35)  # a step turns by less than 20 degrees
_ON_LINE = 2e-4  # mm; an edge lies this near to its surface in imported files
_REFINEMENTS = 30  # of the place of an arc length; quadratic convergence needs about four
_STATIONS = 20000  # a line that needs more is lost in a surface that cannot be followed
_ALONG_NORMAL = 1e-3  # sine of the least angle between a direction and the normal


class Station(NamedTuple):
    """A point of a co-ordinate line: arc length from the origin (mm, always positive), place, unit tangent ahead."""

    s: float
    point: Vector
    tangent: Vector
    at: Parameters


class Stop(NamedTuple):
    """A point at which a line stops if it comes by."""

    point: Vector
    kind: str


class Half(NamedTuple):
    """One side of a line: its stations, its length (mm) and why it ends."""

    stations: List[Station]
    length: float
    end: str


class CoordinateLine:
    """The curve in which the plane of a point's normal and a direction meets a face.

    Parameters
    ----------
    surface : FaceSurface
    at : (u, v)
        The origin P.
    direction : Vector
        d; its part in the tangent plane at P is the line's positive sense.
    meetings : sequence of Vector, mm
        Points at which the line ends because another line's sites begin.

    Raises
    ------
    ParameterError
        If the direction is along the normal at P.
    """

    def __init__(
        self, surface: FaceSurface, at: Parameters, direction: Vector, meetings: Sequence[Vector] = ()
    ) -> None:
        self._surface = surface
        self.origin, normal = surface.point(at), surface.normal(at)
        self.tangent = tangential(direction, normal)
        #: Unit normal of the line's plane.
        self.across = normal.cross(self.tangent)
        stops = [Stop(p, BORDER) for p in surface.border_crossings(self.origin, self.across)]
        stops += [Stop(p, MEETING) for p in meetings]
        stops.append(Stop(self.origin, ROUND))
        self.plus = self._trace(at, 1.0, stops)
        closed = self.plus.end == ROUND
        self.minus = Half([], self.plus.length, ROUND) if closed else self._trace(at, -1.0, stops)

    @property
    def closed(self) -> bool:
        """True if the line comes round to its origin; both lengths are then the whole way."""
        return self.plus.end == ROUND

    def at(self, s: float) -> Parameters:
        """Return the surface parameters at a signed arc length (mm) from the origin, within the line."""
        half = self.plus if s >= 0 or self.closed else self.minus
        s = s % half.length if self.closed else abs(s)
        arcs = [station.s for station in half.stations]
        if s >= arcs[-1] - self._surface.exact:
            return half.stations[-1].at
        k = bisect.bisect_right(arcs, s) - 1
        if s - arcs[k] < self._surface.exact:
            return half.stations[k].at
        station, after = half.stations[k : k + 2]
        most = (after.point - station.point).dot(station.tangent)
        reach = most * (s - station.s) / (after.s - station.s)
        for _ in range(_REFINEMENTS):
            rate = self._rate(station, self._there(station, reach))
            change = (s - station.s - self._length(station, reach)) / rate
            reach = min(max(reach + change, 0.0), most)
            if abs(change) < self._surface.exact:
                break
        return self._there(station, reach)

    def tangent_at(self, at: Parameters) -> Vector:
        """Return the unit tangent in the line's positive sense at a point of it."""
        return self._tangent(at, self.across.cross(self._surface.normal(at)))

    def crossings(self, base: Vector, across: Vector, but: float) -> List[Vector]:
        """Return the points where the line crosses a plane, without the one at arc length ``but``.

        Parameters
        ----------
        base, across : Vector
            A point (mm) and the unit normal of the plane.
        but : float, mm
            Signed arc length from the origin.
        """
        s, points = self._samples()
        height = (points - np.array(tuple(base))) @ np.array(tuple(across))
        if self.closed:
            but = but % self.plus.length
        found = []
        for k in np.nonzero(height[:-1] * height[1:] < 0)[0].tolist():
            low, high = s[k], s[k + 1]
            own = low - _ON_LINE <= but <= high + _ON_LINE or (
                self.closed and but < _ON_LINE and high > s[-1] - _ON_LINE
            )
            if not own:
                found.append(self._crossing(base, across, low, high, height[k] < 0))
        return found

    def _samples(self) -> Tuple[List[float], np.ndarray]:
        """Return signed arc lengths and points (K, 3) of the stations, in order along the line."""
        minus = [(-station.s, station.point) for station in self.minus.stations[:0:-1]]
        plus = [(station.s, station.point) for station in self.plus.stations]
        return [s for s, _ in minus + plus], np.array([tuple(point) for _, point in minus + plus])

    def _crossing(self, base: Vector, across: Vector, low: float, high: float, rising: bool) -> Vector:
        while high - low > 1e-7:
            middle = 0.5 * (low + high)
            below = (self._surface.point(self.at(middle)) - base).dot(across) < 0
            low, high = (middle, high) if below == rising else (low, middle)
        return self._surface.point(self.at(0.5 * (low + high)))

    # -------------------------------------------------------------------------------------------- one step of a line

    def _there(self, station: Station, reach: float) -> Parameters:
        """Return the line's point whose distance from a station along the station's tangent is ``reach``."""
        guess, surface = station.at, self._surface
        start = surface.ahead(guess, station.tangent * reach)
        found = surface.solve(station.point, self.across, station.tangent, reach, start)
        if self._is_ahead(station, reach, found):
            return found
        if surface.has_pole:
            for start in surface.starts(station.point + station.tangent * reach):
                found = surface.solve(station.point, self.across, station.tangent, reach, start)
                if self._is_ahead(station, reach, found):
                    return found
        raise KernelError(f"a co-ordinate line could not be followed for {reach:.3g} mm")

    def _is_ahead(self, station: Station, reach: float, found: Optional[Parameters]) -> bool:
        """Return whether a point was found, and on the branch of the line that the station is on."""
        if found is None:
            return False
        off = self._surface.point(found) - station.point
        return (off - station.tangent * reach).Length <= 0.5 * abs(reach) + 1e-9

    def _tangent(self, at: Parameters, sense: Vector) -> Vector:
        """Return the line's unit tangent, on the side of ``sense``."""
        tangent = self.across.cross(self._surface.normal(at))
        length = tangent.Length
        if length < _ALONG_NORMAL:
            raise KernelError("a co-ordinate line's plane touches the face")
        return tangent * ((1 if tangent.dot(sense) > 0 else -1) / length)

    def _length(self, station: Station, reach: float, rule: Sequence = _FINE) -> float:
        """Return the arc length (mm) from a station to ``reach`` along its tangent."""
        total = 0.0
        for x, weight in zip(*rule):
            at = self._there(station, 0.5 * reach * (1 + x))
            total += weight * self._rate(station, at)
        return 0.5 * reach * total

    def _rate(self, station: Station, at: Parameters) -> float:
        """Return the arc length per distance along a station's tangent, at a point of the line."""
        return 1.0 / self._tangent(at, station.tangent).dot(station.tangent)

    def _step(self, station: Station, reach: float, last: bool) -> Optional[Station]:
        """Return the station ``reach`` ahead, or None if so long a step is not sure or not exact.

        The last one needs no tangent: it may be the apex of a cone.
        """
        try:
            at = self._there(station, reach)
            tangent = station.tangent if last else self._tangent(at, station.tangent)
            if tangent.dot(station.tangent) < _TURN:
                return None
            length = self._length(station, reach)
            short = reach <= _SHORTEST * self._surface.size
            if not short and abs(length - self._length(station, reach, _COARSE)) > _LENGTH_ERROR:
                return None
        except KernelError:
            return None
        return Station(station.s + length, self._surface.point(at), tangent, at)

    # ------------------------------------------------------------------------------------------------ the whole line

    def _trace(self, at: Parameters, sense: float, stops: Sequence[Stop]) -> Half:
        station = Station(0.0, self.origin, self.tangent * sense, at)
        if self._leaves_at_once(station, stops):
            return Half([station], 0.0, BORDER)
        stations, step = [station], _LONGEST * self._surface.size
        for _ in range(_STATIONS):
            station = stations[-1]
            stop, reach = self._next_stop(station, step, stops)
            after = self._step(station, reach, last=stop is not None)
            if after is None:
                step = 0.5 * reach
                if step < 1e-3 * _SHORTEST * self._surface.size:
                    return Half(stations, station.s, LOST)
            elif stop is not None:
                return Half([*stations, after], after.s, stop.kind)
            elif not self._surface.is_near(after.point):
                raise KernelError(f"a co-ordinate line left the face unnoticed after {after.s:.4g} mm")
            else:
                stations.append(after)
                step = min(1.6 * step, _LONGEST * self._surface.size)
        raise KernelError(f"a co-ordinate line has no end after {_STATIONS} steps and {stations[-1].s:.3g} mm")

    def _leaves_at_once(self, station: Station, stops: Sequence[Stop]) -> bool:
        """Return whether the line begins on the border and leads out of the face."""
        if all(stop.kind != BORDER or (stop.point - station.point).Length > _ON_LINE for stop in stops):
            return False
        try:
            return not self._surface.has(self._there(station, 10 * _ON_LINE))
        except KernelError:
            return True

    def _next_stop(self, station: Station, step: float, stops: Sequence[Stop]) -> Tuple[Optional[Stop], float]:
        """Return the first stop that the line meets within a step and how far ahead it is, or None and the step."""
        near = []
        for stop in stops:
            off = stop.point - station.point
            reach = off.dot(station.tangent)
            if 0 < reach <= step and off.Length <= 1.5 * reach and station.s + reach > _ON_LINE:
                near.append((reach, stop))
        for reach, stop in sorted(near, key=lambda pair: pair[0]):
            try:
                there = self._surface.point(self._there(station, reach))
            except KernelError:
                continue  # not this way; if the line does come by, a shorter step will see it
            if (there - stop.point).Length < _ON_LINE:
                return stop, reach
        return None, step


def tangential(direction: Vector, normal: Vector) -> Vector:
    """Return a direction's part in the tangent plane, unit.

    Raises
    ------
    ParameterError
        If the direction is along the normal.
    """
    part = direction - normal * direction.dot(normal)
    if part.Length <= _ALONG_NORMAL * direction.Length:
        raise ParameterError(
            "a direction must not be along the face's normal at the origin of its line, got "
            f"({direction.x:.4g}, {direction.y:.4g}, {direction.z:.4g})"
        )
    return part * (1 / part.Length)
