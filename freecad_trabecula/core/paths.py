# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths of rods as two cubic Bezier pieces each, and equidistant stations on them (thesis 2.4.4, 4.2.4)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Tuple

import numpy as np

_FINE = 128  # steps a piece for arc length by the midpoint rule: stations are within 1e-4 of the length
_KNOTS = np.linspace(0, 2, 2 * _FINE + 1)


def straight_paths(p0: np.ndarray, p1: np.ndarray) -> np.ndarray:
    """Return straight paths (R, 2, 4, 3) from p0 (R, 3) to p1 (R, 3), mm."""
    t = np.linspace(0, 1, 7)[:, None, None]
    points = p0 + t * (p1 - p0)
    return np.stack([points[:4], points[3:]]).transpose(2, 0, 1, 3)


def middle_paths(p0: np.ndarray, middle: np.ndarray, p1: np.ndarray) -> np.ndarray:
    """Return paths (R, 2, 4, 3) through three points: the natural cubic spline by chord length.

    It has straight ends and, of all curves through the points, the least bending; C2 at the middle point.

    Parameters
    ----------
    p0, middle, p1 : ndarray (R, 3), mm
    """
    h0 = np.linalg.norm(middle - p0, axis=1, keepdims=True).clip(1e-9)
    h1 = np.linalg.norm(p1 - middle, axis=1, keepdims=True).clip(1e-9)
    d0, d1 = (middle - p0) / h0, (p1 - middle) / h1
    bend = 3 * (d1 - d0) / (h0 + h1)  # second derivative at the middle point; 0 at the ends
    start, inner, end = d0 - bend * h0 / 6, d0 + bend * h0 / 3, d1 + bend * h1 / 6
    first = np.stack([p0, p0 + start * h0 / 3, middle - inner * h0 / 3, middle], 1)
    second = np.stack([middle, middle + inner * h1 / 3, p1 - end * h1 / 3, p1], 1)
    return np.stack([first, second], 1)


def tension_paths(
    p0: np.ndarray, n0: np.ndarray, p1: np.ndarray, n1: np.ndarray, tension0: np.ndarray, tension1: np.ndarray
) -> np.ndarray:
    """Return two-point paths (R, 2, 4, 3): Hermite cubics that leave along n0 and arrive along n1 (thesis 4.2.4).

    Parameters
    ----------
    p0, p1 : ndarray (R, 3), mm
    n0, n1 : ndarray (R, 3)
        Unit directions of travel at the ends: the inner normal at p0, the outer normal at p1.
    tension0, tension1 : ndarray (R,), mm
        Lengths of the tangents.
    """
    a, d = p0, p1
    b, c = p0 + n0 * tension0[:, None] / 3, p1 - n1 * tension1[:, None] / 3
    ab, bc, cd = (a + b) / 2, (b + c) / 2, (c + d) / 2
    abc, bcd = (ab + bc) / 2, (bc + cd) / 2
    half = (abc + bcd) / 2
    return np.stack([np.stack([a, ab, abc, half], 1), np.stack([half, bcd, cd, d], 1)], 1)


@dataclass(frozen=True)
class Stations:
    """K stations on R paths.

    Attributes
    ----------
    centres, tangents, curvatures : ndarray (R, K, 3)
        Points in mm, unit tangents, curvature vectors in 1/mm.
    shares : ndarray (R, K)
        Share 0..1 of the arc length.
    lengths : ndarray (R,), mm
    """

    centres: np.ndarray
    tangents: np.ndarray
    curvatures: np.ndarray
    shares: np.ndarray
    lengths: np.ndarray


def stations(paths: np.ndarray, count: int, to_bends: bool = False) -> Stations:
    """Return ``count`` stations on paths (R, 2, 4, 3): at equal arc length, or closer together where a path bends.

    Chords between stations that are h apart miss a path of curvature k by k h^2 / 8, so that with ``to_bends`` their
    density goes with the root of the curvature, beside an even share.
    """
    rods = len(paths)
    even = np.linspace(0, 1, count)
    if rods == 0:
        empty = np.zeros((0, count, 3))
        return Stations(empty, empty, empty, np.zeros((0, count)), np.zeros(0))
    length, bend = _fine_lengths(paths)
    total = length.sum(1)
    weight = length / total[:, None] + bend / np.sqrt(total)[:, None] if to_bends else length
    shift = 2.0 * np.arange(rods)[:, None]  # one np.interp for all rods: each has its own stretch of the number line
    at_fine, length_at = _running(weight) + shift, _running(length)
    where = np.interp((even + shift).ravel(), at_fine.ravel(), np.tile(_KNOTS, rods)).reshape(rods, count)
    shares = np.interp((even + shift).ravel(), at_fine.ravel(), length_at.ravel()).reshape(rods, count)
    where[:, 0], where[:, -1], shares[:, 0], shares[:, -1] = 0.0, 2.0, 0.0, 1.0
    place, velocity, acceleration = _evaluate(*_pieces_at(paths, where))
    pace = np.linalg.norm(velocity, axis=2, keepdims=True).clip(1e-12)
    tangent = velocity / pace
    along = (acceleration * tangent).sum(2, keepdims=True)
    return Stations(place, tangent, (acceleration - along * tangent) / pace**2, shares, total)


def path_bends(paths: np.ndarray) -> np.ndarray:
    """Return the integrals (R,) of the root of the curvature along paths (R, 2, 4, 3), mm^0.5.

    Divided by the root of 8 d, this is how many chords keep within d of the path.
    """
    return _fine_lengths(paths)[1].sum(1) if len(paths) else np.zeros(0)


def _fine_lengths(paths: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Arc lengths (R, F) of fine steps, and these times the root of the curvature.

    The parameter's speed jumps where the pieces meet: it is taken in the middle of each step.
    """
    middles = (_KNOTS[1 : _FINE + 1] + _KNOTS[:_FINE]) / 2
    t = middles[None, :, None]  # the same in both pieces: no pole is looked up step by step
    found = [_evaluate(t, paths[:, k, None]) for k in (0, 1)]
    velocity, acceleration = (np.concatenate([one[n] for one in found], 1) for n in (1, 2))
    speed = np.linalg.norm(velocity, axis=2)
    curvature = np.linalg.norm(np.cross(velocity, acceleration), axis=2) / np.maximum(speed, 1e-12) ** 3
    length = speed * _KNOTS[1]
    return length, length * np.sqrt(curvature)


def _running(steps: np.ndarray) -> np.ndarray:
    """Running sums (R, F + 1) from 0 to 1 of steps (R, F)."""
    sums = np.concatenate([np.zeros((len(steps), 1)), np.cumsum(steps, axis=1)], 1)
    return sums / sums[:, -1:]


def _pieces_at(paths: np.ndarray, where: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Parameters (R, K, 1) in 0..1 and poles (R, K, 4, 3) of the pieces at parameters ``where`` (R, K) in 0..2."""
    piece = (where >= 1).astype(int)
    return (where - piece)[..., None], np.where(piece[..., None, None] == 0, paths[:, :1], paths[:, 1:])


def _evaluate(t: np.ndarray, poles: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points, first and second derivatives (R, K, 3) of cubic pieces (R, K or 1, 4, 3) at parameters (R or 1, K, 1)."""
    a, b, c, d = (poles[:, :, i] for i in range(4))
    s = 1 - t
    points = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d
    first = 3 * (s**2 * (b - a) + 2 * s * t * (c - b) + t**2 * (d - c))
    return points, first, 6 * (s * (c - 2 * b + a) + t * (d - 2 * c + b))
