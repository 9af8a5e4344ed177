# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guides: triangle meshes of rods that tell which surfaces of a body meet, made finer where they cannot tell.

A guide's triangles miss the rods' surfaces by their sag, so that where surfaces nearly touch, triangles may meet that
should not, or pass each other that should meet. Such places show: the surfaces then do not meet near the triangles'
nodes. There the guide gets more lines, and the Boolean is done again.
"""

from __future__ import annotations

import math
from typing import Any, Dict, Iterable, List, NamedTuple, Optional, Tuple

import numpy as np

from .booleans import _library
from .meshes import Mesh
from .patchwork import LabelledMesh
from .progress import Progress, silent
from .seams import Surfaces

_ROUND = 8  # lines to a strip, across it: about 32 around a rod
_LENGTH = 0.25  # mm between the lines along a rod
_WINDOW = 0.02  # mm to either side of a doubtful place in which lines are added
_FINER = 7.0  # times that the lines are closer there; the sag falls by the square


class _Lines(NamedTuple):
    """The grid lines of one rod: across it for each strip, u in 0..1, and along it, v in 0..1, all with both ends."""

    across: List[np.ndarray]
    along: np.ndarray


class Guide:
    """The guide of a body made of rods.

    Parameters
    ----------
    surfaces : Surfaces
        The rods, and the envelope's planes.
    envelope : Mesh or None
        Triangles of the envelope; the body is what rods leave of it. Without one the body is the rods' union.
    envelope_surfaces : ndarray (T,), int
        The surface of each of its triangles.
    """

    def __init__(
        self, surfaces: Surfaces, envelope: Optional[Mesh] = None, envelope_surfaces: Optional[np.ndarray] = None
    ) -> None:
        self.surfaces, self.envelope, self.envelope_surfaces = surfaces, envelope, envelope_surfaces
        self._lines = [self._first_lines(rod) for rod in range(len(surfaces.strips))]
        self._spacing = 1.0

    def _first_lines(self, rod: int) -> _Lines:
        strips = self.surfaces.strips
        knots = strips.knots[rod]
        ends = strips.patches[rod, 0, :, 0][:, [0, -1]]
        spans = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        along = [np.linspace(a, b, max(2, math.ceil(s / _LENGTH)), endpoint=False)
                 for a, b, s in zip(knots[:-1], knots[1:], spans)]  # fmt: skip
        return _Lines([np.linspace(0, 1, _ROUND + 1)] * self.surfaces.corners, np.append(np.concatenate(along), 1.0))

    def refine(self, places: Iterable[Tuple[int, np.ndarray]]) -> None:
        """Add lines about places (surface, parameters (2,)) on strips, closer than those added before."""
        self._spacing /= _FINER
        window = _WINDOW * math.sqrt(self._spacing * _FINER)
        sums: Dict[int, Tuple[Dict[int, List[np.ndarray]], List[np.ndarray]]] = {}
        for surface, uv in places:
            rod, strip = self.surfaces.rod(surface), self.surfaces.strip(surface)
            if strip < 0:
                continue
            slope = self.surfaces.at(np.array([surface]), uv[None])[1][0]
            wide = np.linalg.norm(slope, axis=0).clip(1e-9)
            across, along = sums.setdefault(rod, ({}, []))
            across.setdefault(strip, []).append(_about(uv[0], window / wide[0], self._spacing / _ROUND))
            along.append(_about(uv[1], window / wide[1], self._spacing * _LENGTH / wide[1]))
        for rod, (across, along) in sums.items():
            old = self._lines[rod]
            new = [_merged(lines, across.get(k, []), self._spacing / _ROUND / 3) for k, lines in enumerate(old.across)]
            length = self._spacing * _LENGTH / 3 / 10
            self._lines[rod] = _Lines(new, _merged(old.along, along, length))

    def labelled(self, progress: Progress = silent) -> LabelledMesh:
        """Return the body's triangles with their surfaces.

        Raises
        ------
        DependencyError
            If manifold3d is not installed.
        MeshError
            If a rod's triangles are inside out.
        """
        manifold = _library()
        count = len(self._lines)
        first = manifold.Manifold.reserve_ids(count + 1)
        grids = [self._grid(rod) for rod in range(count)]
        solids = [_solid(manifold, g.vertices, g.triangles, first + k) for k, g in enumerate(grids)]
        body = _union(solids, progress)
        if self.envelope is not None:
            body = _solid(manifold, self.envelope.vertices, self.envelope.triangles, first + count) - body
        return self._with_labels(body.to_mesh64(), grids, first)

    def _grid(self, rod: int) -> _Grid:
        lines = self._lines[rod]
        columns = np.concatenate([lines_u[:-1] for lines_u in lines.across])
        strip = np.repeat(np.arange(len(lines.across)), [len(u) - 1 for u in lines.across])
        right = np.concatenate([lines_u[1:] for lines_u in lines.across])
        m, k = len(columns), len(lines.along)
        own = rod * (self.surfaces.corners + 2) + strip
        uv = np.stack([np.tile(columns, k), np.repeat(lines.along, m)], 1)
        points = self.surfaces.at(np.tile(own, k), uv)[0]
        vertices = np.concatenate([points, self.surfaces.strips.caps[rod, :, 0]])
        i = np.arange(k * m).reshape(k, m)
        j = np.roll(i, -1, 1)
        a, b, c, d = i[:-1].ravel(), j[:-1].ravel(), j[1:].ravel(), i[1:].ravel()
        near = np.stack([np.full(m, k * m), j[0], i[0]], 1)
        far = np.stack([np.full(m, k * m + 1), i[-1], j[-1]], 1)
        triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1), near, far])
        quads = np.tile(np.stack([columns, right], 1), (k - 1, 1))
        low, high = np.repeat(lines.along[:-1], m), np.repeat(lines.along[1:], m)
        u, w = quads[:, 0], quads[:, 1]
        lower = np.stack([np.stack([u, w, w], 1), np.stack([low, low, high], 1)], 2)
        upper = np.stack([np.stack([u, w, u], 1), np.stack([low, high, high], 1)], 2)
        surfaces = np.concatenate(
            [
                np.tile(own, 2 * (k - 1)),
                np.repeat(rod * (self.surfaces.corners + 2) + self.surfaces.corners + np.arange(2), m),
            ]
        )
        return _Grid(vertices, triangles, surfaces, np.concatenate([lower, upper]))

    def _with_labels(self, mesh: Any, grids: List[_Grid], first: int) -> LabelledMesh:
        vertices = np.array(mesh.vert_properties)[:, :3]
        triangles = np.array(mesh.tri_verts, np.int64)
        rod = np.repeat(
            np.array(mesh.run_original_id, np.int64) - first, np.diff(np.array(mesh.run_index, np.int64)) // 3
        )
        source = np.array(mesh.face_id, np.int64)
        surfaces = np.zeros(len(triangles), np.int64)
        parameters = np.zeros((len(triangles), 3, 2))
        order = np.argsort(rod, kind="stable")
        bounds = np.searchsorted(rod[order], np.arange(len(grids) + 2))
        for k, grid in enumerate(grids):
            own = order[bounds[k] : bounds[k + 1]]
            surfaces[own] = grid.surfaces[source[own]]
            side = own[source[own] < len(grid.uv)]
            corners = grid.vertices[grid.triangles[source[side]]]
            parameters[side] = _interpolated(corners, grid.uv[source[side]], vertices[triangles[side]])
        own = order[bounds[-2] :]
        if self.envelope_surfaces is not None:
            surfaces[own] = self.envelope_surfaces[source[own]]
        for surface in np.unique(surfaces):
            if self.surfaces.strip(int(surface)) < 0:
                plane, of = self.surfaces.plane(int(surface)), np.nonzero(surfaces == surface)[0]
                parameters[of] = (vertices[triangles[of]] - plane[0]) @ plane[2:].T
        return LabelledMesh(vertices, triangles, surfaces, parameters)


class _Grid(NamedTuple):
    """A rod's triangles (strips, then caps), their surfaces, and the parameters (T, 3, 2) of the strips' corners."""

    vertices: np.ndarray
    triangles: np.ndarray
    surfaces: np.ndarray
    uv: np.ndarray


def _about(centre: float, window: float, step: float) -> np.ndarray:
    reach = max(1, math.ceil(window / step))
    return centre + step * np.arange(-reach, reach + 1)


def _merged(lines: np.ndarray, added: List[np.ndarray], least: float) -> np.ndarray:
    """The lines with others between them, no two of them closer than ``least``."""
    if not added:
        return lines
    new = np.unique(np.concatenate(added))
    new = new[(new > 0) & (new < 1)]
    new = new[np.abs(new[:, None] - lines[None]).min(1) > least]
    if len(new) > 1:
        kept = [new[0]]
        for value in new[1:]:
            if value - kept[-1] > least:
                kept.append(value)
        new = np.array(kept)
    return np.unique(np.concatenate([lines, new]))


def _solid(manifold: Any, vertices: np.ndarray, triangles: np.ndarray, number: int) -> Any:
    """A solid whose triangles can be told apart after a Boolean."""
    mesh = manifold.Mesh64(
        np.ascontiguousarray(vertices, np.float64),
        np.ascontiguousarray(triangles, np.uint64),
        run_index=np.array([0, 3 * len(triangles)], np.uint64),
        run_original_id=np.array([number], np.uint32),
        face_id=np.arange(len(triangles), dtype=np.uint64),
    )
    return manifold.Manifold(mesh)


def _union(solids: List[Any], progress: Progress) -> Any:
    """The union, halves first (see ``booleans``)."""
    done, total = 0, max(len(solids) - 1, 1)

    def between(first: int, last: int) -> Any:
        nonlocal done
        if last - first == 1:
            return solids[first]
        middle = (first + last) // 2
        union = between(first, middle) + between(middle, last)
        union.num_tri()
        done += 1
        progress(done, total, "what meets what")
        return union

    return between(0, len(solids))


def _interpolated(corners: np.ndarray, values: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Values (N, k, 2) at points (N, k, 3) of triangles with values (N, 3, 2) at their corners (N, 3, 3)."""
    e, f = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    ee, ef, ff = ((x * y).sum(1)[:, None] for x, y in ((e, e), (e, f), (f, f)))
    off = points - corners[:, :1]
    oe, of = np.einsum("nkx,nx->nk", off, e), np.einsum("nkx,nx->nk", off, f)
    scale = (ee * ff - ef**2).clip(1e-300)
    a, b = (ff * oe - ef * of) / scale, (ee * of - ef * oe) / scale
    return (
        values[:, :1] + a[..., None] * (values[:, 1:2] - values[:, :1]) + b[..., None] * (values[:, 2:] - values[:, :1])
    )
