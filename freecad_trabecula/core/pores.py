# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pores: closed C1 curves of cubic pieces through corners (thesis 2.4.1, 2.4.2), many at once.

A pore lies in the tangent plane of its site, in the axes (u, n x u) seen against the outer normal n,
counter-clockwise. For the rod that starts there the same curve is seen from inside: ``mirrored``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Dict, Sequence

import numpy as np

from ..errors import ParameterError
from .laws import Region
from .parameters import PoreParameters, SiteEdit
from .sites import Sites
from .streams import Stream

#: Tangent length, in sides, of four corners at 45 degrees that enclose exactly the circle's area: the root of the
#: quadratic that Green's theorem gives; the radius then errs by less than 0.05 %.
CIRCLE_PULL = 7.5 * (math.sqrt(0.32) - math.sqrt(0.32 - (math.pi / 2 - 1) / 3.75))


@dataclass(frozen=True)
class Pores:
    """P pores with M corners each.

    Attributes
    ----------
    size : ndarray (P,), mm
        Diameter of a circle; side of the square whose area the corners enclose.
    corners : ndarray (P, M, 2)
        Corners in units of ``size``.
    angles : ndarray (P, M)
        Direction of the tangent at each corner, radians; grows with the corner and is not wrapped, so that it can be
        averaged.
    lengths : ndarray (P, M)
        Length of the tangent (derivative over one piece) in units of ``size``.
    """

    size: np.ndarray
    corners: np.ndarray
    angles: np.ndarray
    lengths: np.ndarray

    def __len__(self) -> int:
        return len(self.size)

    def take(self, which: np.ndarray) -> Pores:
        """Return the pores of the given indices or mask."""
        return Pores(self.size[which], self.corners[which], self.angles[which], self.lengths[which])

    @property
    def estimated_areas(self) -> np.ndarray:
        """Estimated areas size^2 (thesis 2.4.1), ndarray (P,), mm2."""
        return self.size**2

    @property
    def areas(self) -> np.ndarray:
        """True areas inside the curves, ndarray (P,), mm2."""
        return bezier_areas(bezier_poles(self))


def join_pores(parts: Sequence[Pores]) -> Pores:
    """Return all pores of several sets as one set."""
    return Pores(*(np.concatenate([getattr(p, name) for p in parts]) for name in Pores.__dataclass_fields__))


def regular_corners(count: int) -> np.ndarray:
    """Return the corners (M, 2) of the regular polygon with area 1; with 4 the unit square from (-1/2, -1/2) on.

    The polygon is its own mirror image in the first axis, corner k being that of M - 1 - k, which ``mirrored`` needs.
    """
    angle = math.pi / count - math.pi + 2 * math.pi / count * np.arange(count)
    radius = math.sqrt(2 / (count * math.sin(2 * math.pi / count)))
    return radius * np.stack([np.cos(angle), np.sin(angle)], 1)


def _edge_angles(count: int) -> np.ndarray:
    """Direction (M,) of the edge that arrives at each corner of the regular polygon, growing."""
    return -math.pi / 2 + 2 * math.pi / count * np.arange(count)


def draw_turns(
    parameters: PoreParameters, seed: int, site: str, attempt: int, point: np.ndarray, region: Region
) -> np.ndarray:
    """Return the tangent components (M,) of one pore; ``attempt`` > 0 draws them anew (thesis 3.3.5)."""
    return parameters.turn.draw(Stream(seed, "turn", site, attempt), parameters.corners, point, region)


def draw_pores(parameters: PoreParameters, seed: int, sites: Sites, region: Region, attempt: int = 0) -> Pores:
    """Return a pore for each site of a face, drawn from the site's own stream.

    Parameters
    ----------
    parameters : PoreParameters
    seed : int
    sites : Sites
    region : Region
        What the laws of place refer to.
    attempt : int
        0 first; the tangents (not the sizes) of attempt 1, 2, ... are other draws.
    """
    count = parameters.corners
    drawn = [
        _draw_one(parameters, seed, name, attempt, point, region) for name, point in zip(sites.names, sites.points)
    ]
    if not drawn:
        return Pores(np.zeros(0), np.zeros((0, count, 2)), np.zeros((0, count)), np.zeros((0, count)))
    size, turns, pulls, shifts = (np.array(column) for column in zip(*drawn))
    return make_pores(parameters, size, turns, pulls, shifts)


def _draw_one(
    parameters: PoreParameters, seed: int, site: str, attempt: int, point: np.ndarray, region: Region
) -> tuple:
    count = parameters.corners
    size = parameters.size.draw(Stream(seed, "size", site), 1, point, region)[0]
    turns = draw_turns(parameters, seed, site, attempt, point, region)
    pulls = parameters.pull.draw(Stream(seed, "pull", site, attempt), count, point, region)
    shifts = (2 * Stream(seed, "scatter", site, attempt).uniform(2 * count) - 1) * parameters.scatter
    return size, turns, pulls, shifts.reshape(count, 2)


def make_pores(
    parameters: PoreParameters, size: np.ndarray, turns: np.ndarray, pulls: np.ndarray, shifts: np.ndarray
) -> Pores:
    """Return pores from their numbers.

    Parameters
    ----------
    parameters : PoreParameters
        The layout.
    size : ndarray (P,), mm
    turns : ndarray (P, M)
        Components in [0, 1] of the unit tangents; the component is the one along the leaving edge at even corners and
        along the arriving edge at odd ones, so that it is always the same axis of the square (thesis 2.4.2).
    pulls : ndarray (P, M)
    shifts : ndarray (P, M, 2)
        Displacements of the corners in units of size.
    """
    if parameters.layout == "circle":
        return circles(size)
    count = parameters.corners
    regular = regular_corners(count)
    quarter = np.where(np.arange(count) % 2 == 0, np.arcsin(turns), np.arccos(turns))
    angles = _edge_angles(count) + quarter * 4 / count
    side = float(np.linalg.norm(regular[1] - regular[0]))
    return Pores(size, regular + shifts, angles, pulls * side)


def circles(diameter: np.ndarray) -> Pores:
    """Return circles of the given diameters (P,), mm, as four cubic pieces of the exact area."""
    count = len(diameter)
    corners = regular_corners(4) / math.sqrt(2)
    angles = _edge_angles(4) + math.pi / 4
    return Pores(
        np.asarray(diameter, float),
        np.tile(corners, (count, 1, 1)),
        np.tile(angles, (count, 1)),
        np.full((count, 4), CIRCLE_PULL / math.sqrt(2)),
    )


def edit_pores(parameters: PoreParameters, pores: Pores, names: Sequence[str], edits: Sequence[SiteEdit]) -> Pores:
    """Return the pores with sizes and tangents that were set by hand.

    Raises
    ------
    ParameterError
        If the tangent components are not one per corner.
    """
    places: Dict[str, int] = {name: k for k, name in enumerate(names)}
    size, angles = pores.size.copy(), pores.angles.copy()
    for edit in edits:
        k = places.get(edit.site)
        if k is None:
            continue
        if edit.size is not None:
            size[k] = edit.size
        if edit.turns is not None:
            if len(edit.turns) != parameters.corners or parameters.layout == "circle":
                raise ParameterError(
                    f"the pore at {edit.site} takes {parameters.corners if parameters.layout == 'spline' else 0} "
                    f"tangent components, got {len(edit.turns)}"
                )
            one = make_pores(parameters, size[k : k + 1], np.array([edit.turns]), np.ones((1, len(edit.turns))),
                             np.zeros((1, len(edit.turns), 2)))  # fmt: skip
            angles[k] = one.angles[0]
    return replace(pores, size=size, angles=angles)


def mirrored(pores: Pores) -> Pores:
    """Return the same curves seen from the other side of their plane: axes (u, -v), counter-clockwise again."""
    corners = pores.corners[:, ::-1] * [1.0, -1.0]
    return Pores(pores.size, corners, math.pi - pores.angles[:, ::-1], pores.lengths[:, ::-1])


def turned(pores: Pores, quarters: np.ndarray) -> Pores:
    """Return the same curves in axes turned back by ``quarters`` (P,) M-ths of a turn, corners renumbered to match."""
    count = pores.corners.shape[1]
    step = 2 * math.pi / count
    old = np.arange(count)[None] - quarters[:, None]
    wraps = np.floor_divide(old, count)
    old = old - wraps * count
    angle = step * quarters
    cosine, sine = np.cos(angle)[:, None], np.sin(angle)[:, None]
    corners = np.take_along_axis(pores.corners, old[..., None], 1)
    x, y = corners[..., 0], corners[..., 1]
    return Pores(
        pores.size,
        np.stack([cosine * x - sine * y, sine * x + cosine * y], -1),
        np.take_along_axis(pores.angles, old, 1) + angle[:, None] + 2 * math.pi * wraps,
        np.take_along_axis(pores.lengths, old, 1),
    )


def bezier_poles(pores: Pores) -> np.ndarray:
    """Return the Bezier poles (P, M, 4, 2), mm, of the closed curves; a Hermite tangent is three times its handle."""
    size = pores.size[:, None, None]
    corner = size * pores.corners
    handle = size / 3 * pores.lengths[..., None] * np.stack([np.cos(pores.angles), np.sin(pores.angles)], -1)
    after = np.roll(corner, -1, 1)
    return np.stack([corner, corner + handle, after - np.roll(handle, -1, 1), after], 2)


def bezier_areas(poles: np.ndarray) -> np.ndarray:
    """Return the exact signed areas (...,) inside closed curves of Bezier pieces (..., M, 4, 2): Green's theorem."""

    def cross(i: int, j: int) -> np.ndarray:
        return poles[..., i, 0] * poles[..., j, 1] - poles[..., i, 1] * poles[..., j, 0]

    pieces = 6 * cross(0, 1) + 3 * cross(0, 2) + cross(0, 3) + 3 * cross(1, 2) + 3 * cross(1, 3) + 6 * cross(2, 3)
    return pieces.sum(-1) / 20


def outlines(poles: np.ndarray, points: int) -> np.ndarray:
    """Return polygons (..., m, 2) of closed curves of Bezier pieces (..., M, 4, 2), widened to the curves' exact areas.

    ``points`` is rounded up to a multiple of M: m = M * ceil(points / M).
    """
    pieces = poles.shape[-3]
    each = -(-points // pieces)
    t = np.arange(each) / each
    weight = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], 1)
    polygon = np.einsum("ti,...pic->...ptc", weight, poles).reshape(*poles.shape[:-3], pieces * each, 2)
    after = np.roll(polygon, -1, -2)
    area = (polygon[..., 0] * after[..., 1] - polygon[..., 1] * after[..., 0]).sum(-1) / 2
    ratio = np.abs(bezier_areas(poles)) / np.maximum(np.abs(area), 1e-300)
    return polygon * np.sqrt(ratio)[..., None, None]


def loops(polygons: np.ndarray) -> np.ndarray:
    """Return True (...,) where a closed polygon (..., m, 2) does not run once about its origin (not star-shaped)."""
    after = np.roll(polygons, -1, -2)
    return (polygons[..., 0] * after[..., 1] - polygons[..., 1] * after[..., 0] <= 0).any(-1)
