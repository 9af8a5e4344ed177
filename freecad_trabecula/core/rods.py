# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods: sections that turn and change along paths, all rods at once; their triangles and their faults.

Rotation, interpolation and skinning are plain array work: 147 rods take a few hundredths of a second, so that a
preview can follow a dragged value.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Dict, Tuple, Union

import numpy as np

from .paths import Stations, stations
from .pores import Pores, bezier_poles, loops, outlines, turned

#: Least cosine between path and section normal: a rod leaving its face at more than 72 degrees is flat .
FLAT = 0.3
_RING = 16  # points of rings that serve volumes only: they have the exact area of their sections
#: A lean that stands for planes carried along the path instead of turned from end to end.
CARRIED = 2.0
_TIE = 1e-9  # frames exactly half-way between two turns must round the same way on every machine


@dataclass(frozen=True)
class RodEnds:
    """The two ends of R rods, in the direction of travel.

    Attributes
    ----------
    frames : ndarray (R, 2, 3, 3)
        Rows u, v, n of the section planes at both ends; n points along the rod, v = n x u.
    first, second : Pores
        End sections in those axes.
    leans : ndarray (R,)
        0..1: tilt of each rod's inner section planes towards its path's normal planes, full half-way, none at the ends.
        ``CARRIED``: all planes are normal to the path, for paths that leave and arrive along the ends' normals.
    rolls : bool
        True if the second section has a place of its own (two sections); False if the first is carried along (one
        section).
    """

    frames: np.ndarray
    first: Pores
    second: Pores
    leans: np.ndarray
    rolls: bool = True


@dataclass(frozen=True)
class Rods:
    """R rods with K sections each.

    Attributes
    ----------
    stations : Stations
        Centres, tangents, curvatures (R, K, 3), mm.
    frames : ndarray (R, K, 3, 3)
        Rows u, v, n of the section planes.
    poles : ndarray (R, K, M, 4, 2), mm
        Bezier poles of the closed sections in those planes.
    rings : ndarray (R, K, m, 3), mm
        Polygons of the sections, each with its curve's exact area.
    """

    stations: Stations
    frames: np.ndarray
    poles: np.ndarray
    rings: np.ndarray

    def __len__(self) -> int:
        return len(self.frames)


def _rotate(vectors: np.ndarray, axes: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Rodrigues' formula: vectors (..., 3) about unit axes (..., 3) by angles (...)."""
    c, s = np.cos(angles)[..., None], np.sin(angles)[..., None]
    along = (axes * vectors).sum(-1, keepdims=True)
    return vectors * c + np.cross(axes, vectors) * s + axes * along * (1 - c)


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True).clip(1e-300)


def _smallest_rotation(a: np.ndarray, b: np.ndarray, spare: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Axes (R, 3) and angles (R,) of the smallest rotations from a to b; ``spare`` decides when they are opposite."""
    axis, cosine = np.cross(a, b), (a * b).sum(-1).clip(-1, 1)
    vanishing = np.linalg.norm(axis, axis=-1) < 1e-9
    if vanishing.any():
        least = np.eye(3)[np.abs(a[vanishing]).argmin(-1)]
        other = np.cross(a[vanishing], spare[vanishing])
        weak = np.linalg.norm(other, axis=-1, keepdims=True) < 1e-6
        axis[vanishing] = np.where(weak, np.cross(a[vanishing], least), other)
    return _unit(axis), np.arccos(cosine)


def section_frames(ends: RodEnds, on_path: Stations) -> Tuple[np.ndarray, np.ndarray]:
    """Return the planes of all sections, and the turns of the second section that they absorb.

    The planes turn from end to end by slerp, or are carried along the path. Of the roll that is left, whole M-ths of a
    turn (the symmetry of the corners) are taken off by renumbering the second section's corners; the rest is spread
    evenly.

    Parameters
    ----------
    ends : RodEnds
    on_path : Stations

    Returns
    -------
    frames : ndarray (R, K, 3, 3)
    turns : ndarray (R,) of int
    """
    tangents, shares = on_path.tangents, on_path.shares
    count, k = tangents.shape[:2]
    first, second = ends.frames[:, 0], ends.frames[:, 1]
    axis, angle = _smallest_rotation(first[:, 2], second[:, 2], tangents[:, k // 2])
    angles, axes = angle[:, None] * shares, np.repeat(axis[:, None], k, 1)
    u, n = (_rotate(np.repeat(first[:, None, i], k, 1), axes, angles) for i in (0, 2))
    carried = ends.leans >= CARRIED
    if carried.any():
        u[carried], n[carried] = _carried(first[carried, 0], on_path.centres[carried], tangents[carried])
    turns = np.zeros(count, int)
    if ends.rolls:
        last, goal = u[:, -1], second[:, 0]
        roll = np.arctan2((goal * np.cross(second[:, 2], last)).sum(-1), (goal * last).sum(-1))
        step = 2 * math.pi / ends.first.corners.shape[1]
        turns = np.floor(roll / step + 0.5 - _TIE).astype(int)
        u = _rotate(u, n, (roll - turns * step)[:, None] * shares)
    leans = np.where(carried, 0.0, ends.leans)
    if leans.any():
        across = np.cross(n, tangents)
        sine = np.linalg.norm(across, axis=-1)
        tilt = leans[:, None] * 4 * shares * (1 - shares) * np.arctan2(sine, (n * tangents).sum(-1))
        u, n = (_rotate(a, _unit(across), tilt) for a in (u, n))
    return np.stack([u, np.cross(n, u), n], 2), turns


def _carried(start: np.ndarray, centres: np.ndarray, tangents: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """First axes and normals (R, K, 3) of planes normal to the paths that turn about them as little as can be.

    Double reflection (Wang, Juttler, Zheng, Liu 2008, doi:10.1145/1330511.1330513); its error falls as the fourth power
    of the distance of the stations.
    """
    u = np.empty_like(tangents)
    u[:, 0] = _unit(start - (start * tangents[:, 0]).sum(-1, keepdims=True) * tangents[:, 0])

    def reflected(vectors: np.ndarray, mirror: np.ndarray) -> np.ndarray:
        square = (mirror**2).sum(-1, keepdims=True).clip(1e-300)
        return vectors - 2 * (vectors * mirror).sum(-1, keepdims=True) / square * mirror

    for k in range(tangents.shape[1] - 1):
        step = centres[:, k + 1] - centres[:, k]
        half = reflected(tangents[:, k], step)
        u[:, k + 1] = reflected(reflected(u[:, k], step), tangents[:, k + 1] - half)
    return u, tangents


def build_rods(paths: np.ndarray, ends: RodEnds, count: int, points: int, to_bends: bool = False) -> Rods:
    """Return rods along ``paths`` (R, 2, 4, 3) with ``count`` sections of about ``points`` ring points each.

    Sections change from end to end linearly in size, corners, tangent directions and tangent lengths.
    """
    on_path = stations(paths, count, to_bends)
    frames, turns = section_frames(ends, on_path)
    second = turned(ends.second, turns) if ends.rolls else ends.first
    share = on_path.shares

    def between(name: str) -> np.ndarray:
        a, b = getattr(ends.first, name), getattr(second, name)
        w = share.reshape(share.shape + (1,) * (a.ndim - 1))
        return ((1 - w) * a[:, None] + w * b[:, None]).reshape((-1,) + a.shape[1:])

    pores = Pores(*(between(name) for name in Pores.__dataclass_fields__))
    poles = bezier_poles(pores)
    flat = outlines(poles, points)
    poles, flat = (a.reshape((len(paths), count) + a.shape[1:]) for a in (poles, flat))
    rings = flat[..., :1] * frames[:, :, None, 0]
    rings += flat[..., 1:] * frames[:, :, None, 1]
    rings += on_path.centres[:, :, None]
    return Rods(on_path, frames, poles, rings)


def tessellation(mean_size: float, deflection: float, bend: float) -> Tuple[int, int]:
    """Return stations K and ring points m that keep triangles within ``deflection`` mm of the rods.

    A ring of m chords about a radius r sags by r (1 - cos(pi / m)); r is 0.68 sizes, a spline section's mean radius
    (area 1.46 size^2). ``bend`` is the greatest of ``paths.path_bends``.
    """
    radius = 0.68 * mean_size
    m = math.pi / math.acos(max(1 - deflection / radius, 0.5))
    k = math.ceil(bend / math.sqrt(8 * deflection)) + 1
    return int(np.clip(k, 9, 65)), int(np.clip(4 * math.ceil(m / 4), 8, 64))


def default_deflection(mean_size: float) -> float:
    """Return the default deflection, mm: 1/40 of the mean pore size (0.0125 mm for 0.2 to 0.8 mm pores)."""
    return mean_size / 40


def rod_mesh(rods: Rods, beyond: Union[float, np.ndarray] = 0.0) -> Tuple[np.ndarray, np.ndarray]:
    """Return closed triangle meshes of all rods: vertices (R, V, 3), mm, and the triangles (T, 3) that each has.

    ``beyond`` > 0 prolongs each rod by that distance, measured across its end planes, so that caps never lie in faces;
    an array (R, 2) gives each end a distance of its own.
    """
    rings, centres = rods.rings, rods.stations.centres
    ends = [centres[:, 0], centres[:, -1]]
    if np.any(beyond):
        reach = np.broadcast_to(beyond, (len(rods), 2))
        shifts = [_prolongation(rods, 0, -reach[:, :1]), _prolongation(rods, -1, reach[:, 1:])]
        rings = np.concatenate(
            [rings[:, :1] + shifts[0][:, None, None], rings, rings[:, -1:] + shifts[1][:, None, None]], 1
        )
        ends = [c + s for c, s in zip(ends, shifts)]
    count, k, m = rings.shape[:3]
    vertices = np.concatenate([rings.reshape(count, k * m, 3), ends[0][:, None], ends[1][:, None]], 1)
    return vertices, _grid_triangles(k, m)


def _prolongation(rods: Rods, end: int, distance: np.ndarray) -> np.ndarray:
    tangent, normal = rods.stations.tangents[:, end], rods.frames[:, end, 2]
    slope = (tangent * normal).sum(-1, keepdims=True).clip(FLAT, 1)
    return distance / slope * tangent


def _grid_triangles(k: int, m: int) -> np.ndarray:
    """Triangles (T, 3) of a tube of k rings of m points and two caps with a centre each, outward."""
    i = np.arange(k * m).reshape(k, m)
    j = np.roll(i, -1, 1)
    a, b, c, d = i[:-1].ravel(), j[:-1].ravel(), j[1:].ravel(), i[1:].ravel()
    near = np.stack([np.full(m, k * m), j[0], i[0]], 1)
    far = np.stack([np.full(m, k * m + 1), i[-1], j[-1]], 1)
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1), near, far])


def rod_volumes(rods: Rods) -> np.ndarray:
    """Return the volumes of the rods' meshes, ndarray (R,), mm3 (divergence theorem)."""
    vertices, triangles = rod_mesh(rods)
    local = vertices - rods.stations.centres[:, :1]
    a, b, c = (local[:, triangles[:, i]] for i in range(3))
    return np.einsum("rti,rti->r", a, np.cross(b, c)) / 6


def rod_triangles(rods: Rods, beyond: Union[float, np.ndarray] = 0.0) -> np.ndarray:
    """Return the triangles of all rods, ndarray (R * T, 3, 3), mm."""
    vertices, triangles = rod_mesh(rods, beyond)
    return vertices[:, triangles].reshape(-1, 3, 3)


def rod_faults(rods: Rods) -> Dict[str, np.ndarray]:
    """Return, for each kind of fault, which rods have it: dict of ndarray (R,) bool. No Boolean, no kernel.

    ``loop``: a section crosses itself. ``flat``: the path leaves a section plane at more than 72 degrees from its
    normal. ``crossing``: neighbouring section planes cross inside the rod, so that its surface folds.
    """
    normals, rings, centres = rods.frames[:, :, 2], rods.rings, rods.stations.centres
    ahead = _heights(rings[:, 1:], centres[:, :-1], normals[:, :-1])
    behind = _heights(rings[:, :-1], centres[:, 1:], normals[:, 1:])
    slope = np.einsum("rkx,rkx->rk", rods.stations.tangents, normals)
    flat = np.stack([_heights(rings, centres, rods.frames[:, :, axis]) for axis in (0, 1)], -1)
    return {
        "loop": loops(flat).any(-1),
        "flat": slope.min(1, initial=1.0) < FLAT,
        "crossing": (ahead <= 0).any((1, 2)) | (behind >= 0).any((1, 2)),
    }


def _heights(points: np.ndarray, origins: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Products (R, K, m) of normals (R, K, 3) with points (R, K, m, 3) less origins (R, K, 3), summed as they stand."""
    found = points[..., 0] * normals[:, :, None, 0]
    for axis in (1, 2):
        found += points[..., axis] * normals[:, :, None, axis]
    found -= (origins * normals).sum(-1)[:, :, None]
    return found


def sharpest_bends(rods: Rods) -> np.ndarray:
    """Return each rod's greatest curvature times its half-width towards the centre of curvature, ndarray (R,).

    From 1 on a rod whose sections are normal to its path folds; a measure of how sharply it bends for others.
    """
    return _heights(rods.rings, rods.stations.centres, rods.stations.curvatures).max((1, 2), initial=0.0)


def true_volumes(paths: np.ndarray, ends: RodEnds) -> np.ndarray:
    """Return the volumes (R,), mm3, that the rods' meshes tend to as their stations grow more.

    Richardson's extrapolation from 128 and 256 intervals: a mesh between its sections errs by the square of their
    distance. The measure of a rod's solid, which no deflection blurs.
    """
    coarse, fine = (rod_volumes(build_rods(paths, ends, n + 1, _RING, to_bends=True)) for n in (128, 256))
    return (4 * fine - coarse) / 3
