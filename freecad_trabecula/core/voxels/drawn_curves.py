# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles that are drawn: curves of the share of material along X, Y and Z, and the targets that they ask for.

A curve goes smoothly through its points and never beyond their values between them (monotone cubics: Fritsch, Carlson
1980, doi:10.1137/0717021), so that a curve whose points lie within a layer does, too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Dict, List, Sequence, Tuple

import numpy as np

from ...errors import ParameterError
from ..parameters import require
from ..triples import triple
from .parameters import VoxelParameters
from .targets import AXES, Targets, layer_counts_of_box, targets_from_areas

#: Points (place along the axis, share of the layer), both 0 .. 1.
Points = Tuple[Tuple[float, float], ...]
Triple = Tuple[float, float, float]

SHAPE: Points = ((0.0, 0.3), (0.5, 0.2), (1.0, 0.3))  # what an empty drawing begins with
LEAST_APART = 1e-3  # of places along an axis
_FINE = 2000  # steps of an integral
_ENOUGH = 0.01  # of a profile's greatest share: points are taken from it until no value is further off
_RIM = 0.05  # above a full layer: a body may reach half a layer beyond its last one
_MOST = 40  # points taken from a profile along an axis


@dataclass(frozen=True)
class DrawnCurves:
    """Shares of material along X, Y and Z in a box.

    Attributes
    ----------
    edges : tuple of 3 floats, mm
        Of the box.
    x, y, z : tuples of (place, share)
        Place from the low side over the edge, share of the layer that is material; 0 .. 1.

    Raises
    ------
    ParameterError
        If an edge is not above 0, a curve has no points or two at one place, or a point lies outside 0 .. 1.
    """

    edges: Triple = (10.0, 10.0, 10.0)
    x: Points = SHAPE
    y: Points = SHAPE
    z: Points = SHAPE

    def __post_init__(self) -> None:
        require(len(self.edges) == 3, "the box of drawn curves must have three edges", len(self.edges))
        for edge in self.edges:
            require(math.isfinite(edge) and edge > 0, "the edges of a drawn box must be above 0", f"{edge:g}", "mm")
        object.__setattr__(self, "edges", tuple(float(edge) for edge in self.edges))
        for axis in AXES:
            object.__setattr__(self, axis, checked_points(getattr(self, axis), axis))

    @property
    def curves(self) -> Tuple[Points, Points, Points]:
        """The points along X, Y, Z."""
        return self.x, self.y, self.z


def checked_points(points: Sequence[Sequence[float]], axis: str) -> Points:
    """Return the points of a curve in their order along the axis.

    Raises
    ------
    ParameterError
        If there are none, two share a place, or one lies outside 0 .. 1.
    """
    ordered = tuple(sorted((float(place), float(share)) for place, share in points))
    require(bool(ordered), f"a curve along {axis.upper()} must have at least one point", 0, "points")
    for place, share in ordered:
        if not 0 <= place <= 1:
            raise ParameterError(f"a curve's places along {axis.upper()} must lie in 0..1 of the edge, got {place:g}")
        if not 0 <= share <= 1:
            rule = "must not be negative" if share < 0 else "must not be larger than its layer"
            raise ParameterError(f"a sliced area along {axis.upper()} {rule}, got {share:g} of it at {place:g}")
    for (first, _), (second, _) in zip(ordered, ordered[1:]):
        require(second - first >= LEAST_APART, f"points along {axis.upper()} must lie apart by at least {LEAST_APART}",
                f"{first:g} and {second:g}")  # fmt: skip
    return ordered


def curve_values(points: Sequence[Sequence[float]], places: np.ndarray) -> np.ndarray:
    """Return the shares of a curve at places 0 .. 1, ndarray like ``places``; constant beyond its first and last point.

    Parameters
    ----------
    points : sequence of (place, share), in order
    places : ndarray of float

    Examples
    --------
    >>> curve_values([(0.0, 0.2), (1.0, 0.4)], np.array([0.0, 0.25, 1.0])).tolist()
    [0.2, 0.25, 0.4]
    """
    x, y = np.asarray(points, float).T
    if len(x) == 1:
        return np.full(np.shape(places), y[0])
    slopes = _slopes(x, y)
    at = np.clip(np.asarray(places, float), x[0], x[-1])
    k = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(x) - 2)
    width = x[k + 1] - x[k]
    t = (at - x[k]) / width
    rise = y[k + 1] - y[k]
    a, b = slopes[k] * width - rise, rise - slopes[k + 1] * width
    return y[k] + t * rise + t * (1 - t) * ((1 - t) * a + t * b)


def _slopes(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Slopes at the points: weighted harmonic means of the chords', 0 at a turn, three-point ones at the ends."""
    widths, chords = np.diff(x), np.diff(y) / np.diff(x)
    if len(chords) == 1:
        return np.repeat(chords, 2)
    first, second = 2 * widths[1:] + widths[:-1], widths[1:] + 2 * widths[:-1]
    before, after = chords[:-1], chords[1:]
    rising = before * after > 0
    safe = np.where(rising, before, 1.0), np.where(rising, after, 1.0)
    inner = np.where(rising, (first + second) / (first / safe[0] + second / safe[1]), 0.0)
    ends = [_end_slope(*pair) for pair in ((widths[:2], chords[:2]), (widths[:-3:-1], chords[:-3:-1]))]
    return np.concatenate([ends[:1], inner, ends[1:]])


def _end_slope(widths: np.ndarray, chords: np.ndarray) -> float:
    """Slope at an end from the two pieces next to it, without leaving their range."""
    slope = ((2 * widths[0] + widths[1]) * chords[0] - widths[0] * chords[1]) / (widths[0] + widths[1])
    if slope * chords[0] <= 0:
        return 0.0
    return float(3 * chords[0] if chords[0] * chords[1] <= 0 and abs(slope) > 3 * abs(chords[0]) else slope)


def curve_volumes(curves: DrawnCurves) -> Tuple[float, float, float]:
    """Return the volume of material that each curve asks for, mm³; a design needs them to be one.

    Examples
    --------
    >>> curve_volumes(DrawnCurves((2.0, 1.0, 1.0), ((0, 0.25),), ((0, 0.5),), ((0, 0.25), (1, 0.75))))
    (0.5, 1.0, 1.0)
    """
    middles = (np.arange(_FINE) + 0.5) / _FINE
    box = math.prod(curves.edges)
    return triple(round(box * float(curve_values(points, middles).mean()), 9) for points in curves.curves)


def reconciled(curves: DrawnCurves) -> DrawnCurves:
    """Return curves that ask for one volume, the mean of the three: their shares in proportion, none above 1.

    Raises
    ------
    ParameterError
        If a curve asks for nothing at all.
    """
    volumes = curve_volumes(curves)
    goal = sum(volumes) / 3
    changed: Dict[str, Any] = {}
    for axis, points, volume in zip(AXES, curves.curves, volumes):
        require(volume > 0, f"a curve along {axis.upper()} must ask for some material", "0", "mm³")
        low, high = 0.0, 1.0 / max(min(share for _, share in points if share > 0), 1e-9)
        for _ in range(60):  # the factor with which the curve, cut at full layers, has the volume
            factor = (low + high) / 2
            scaled = tuple((place, min(1.0, factor * share)) for place, share in points)
            changed[axis] = scaled
            got = curve_volumes(replace(curves, **changed))["xyz".index(axis)]
            low, high = (factor, high) if got < goal else (low, factor)
    return replace(curves, **changed)


def curves_of_areas(areas: Sequence[np.ndarray], thickness: float) -> DrawnCurves:
    """Return curves near to profiles of sliced areas, with as few points as that takes: to be bent.

    Parameters
    ----------
    areas : sequence of 3 ndarrays (N,), (M,), (P,), mm²
        Along X, Y, Z.
    thickness : float, mm
        Of the layers.

    Raises
    ------
    ParameterError
        If an area is negative or larger than its layer.
    """
    edges = triple(len(a) * thickness for a in areas)
    box = math.prod(edges)
    return DrawnCurves(edges, *triple(_few_points(a * edge / box) for a, edge in zip(areas, edges)))


def _few_points(shares: np.ndarray) -> Points:
    """Points of a profile: its ends, then always the layer at which the curve is furthest off."""
    places = (np.arange(len(shares)) + 0.5) / len(shares)
    shares = np.where((shares > 1) & (shares < 1 + _RIM), 1.0, np.where(np.abs(shares) < 1e-12, 0.0, shares))
    chosen: List[int] = sorted({0, len(shares) - 1})
    while len(chosen) < min(_MOST, len(shares)):
        off = np.abs(curve_values([(places[k], shares[k]) for k in chosen], places) - shares)
        off[chosen] = -1.0
        worst = int(np.argmax(off))
        if off[worst] <= _ENOUGH * shares.max():
            break
        chosen = sorted([*chosen, worst])
    return tuple((float(places[k]), float(shares[k])) for k in chosen)


def targets_of_curves(curves: DrawnCurves, parameters: VoxelParameters) -> Targets:
    """Return the targets of drawn curves: their values in the middles of the layers.

    Raises
    ------
    ParameterError
        If a voxel is larger than the box, or the curves leave it empty or full.
    InfeasibleError
        As ``targets_from_areas``.
    """
    layers = layer_counts_of_box(curves.edges, parameters.size)
    lengths = [count * size for count, size in zip(layers, parameters.size)]
    areas = []
    for points, count, length in zip(curves.curves, layers, lengths):
        shares = curve_values(points, (np.arange(count) + 0.5) / count)
        areas.append(shares * math.prod(lengths) / length)
    return targets_from_areas(areas, parameters)
