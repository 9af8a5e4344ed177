# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compact layers: faces of the envelope thickened inwards or outwards, with or without the channels (thesis 4.3.1).

Made after the channels, a layer closes them; made before, they go through it. Channels that are to go through an
outward layer need rods that are longer there (``reaches``). An inward layer through which the channels go changes
nothing: the envelope was there before.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple, Sequence, Tuple

import numpy as np

from ..errors import MeshError
from .booleans import combine
from .meshes import Mesh, directed_edges, mesh_volume
from .parameters import Coupling, LayerParameters
from .wireframe import Wireframe

_NEEDLE = 1e-6  # of the largest triangle; the direction of smaller ones is rounding
_HAIR = 0.05  # thicknesses; how far a layer reaches past the face and its border, so that no surfaces coincide


@dataclass(frozen=True)
class Patch:
    """A triangulated face of the envelope.

    Attributes
    ----------
    vertices : ndarray of shape (P, 3), mm
    normals : ndarray of shape (P, 3)
        Unit outer normals.
    triangles : ndarray of shape (F, 3), int64
        Counter-clockwise seen from outside.
    """

    vertices: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray

    def __post_init__(self) -> None:
        if self.vertices.shape != self.normals.shape:
            raise MeshError(
                f"a face must have one normal per vertex, got {len(self.normals)} for {len(self.vertices)} vertices"
            )
        if not len(self.triangles):
            raise MeshError("a face to be thickened must have at least one triangle, got 0")


class LayeredBody(NamedTuple):
    """The envelope with its layers, ready to be cut.

    Attributes
    ----------
    body : Mesh
        The envelope and what was added to it.
    closed_by : tuple of Mesh
        Solids through which no channel goes.
    added : float
        Volume that outward layers add, mm³.
    note : str
        What the user must know; empty if nothing.
    """

    body: Mesh
    closed_by: Tuple[Mesh, ...]
    added: float
    note: str


def welded_patch(vertices: np.ndarray, normals: np.ndarray, triangles: np.ndarray) -> Patch:
    """Return the face with vertices in one place made one: kernels give a periodic face its seam twice.

    Parameters
    ----------
    vertices, normals : ndarray of shape (P, 3), mm
    triangles : ndarray of shape (F, 3), int
        Those that lose their area (at the pole of a sphere) are left out.
    """
    _, first, number = np.unique(np.round(vertices, 7), axis=0, return_index=True, return_inverse=True)
    number = number.reshape(-1)[triangles]
    whole = (number != np.roll(number, 1, 1)).all(1)
    return Patch(vertices[first], normals[first], number[whole].astype(np.int64))


def thicken(patch: Patch, inner: float, outer: float, widening: float = 0.0, tuck: float = 0.0) -> Mesh:
    """Return the closed solid between a face moved inwards and the same face moved outwards along its normals.

    Parameters
    ----------
    patch : Patch
    inner, outer : float, mm
        How far it reaches on the inner and on the outer side of the face.
    widening : float, mm
        The border is moved outwards by this much, across its own direction, within the face's tangent planes.
    tuck : float, mm
        On the inner side the border is moved back by this much, so that the wall below the face runs inside the
        envelope.

    Raises
    ------
    MeshError
        If the solid would fold: the face bends more sharply than the thickness allows.
    """
    start, end = border_edges(patch)
    aside = _aside(patch, start, end)
    face = patch.vertices + widening * aside
    top, bottom = face + outer * patch.normals, face - inner * patch.normals - tuck * aside
    for moved in (top, bottom):
        _check_folds(patch, moved, max(inner, outer))
    count = len(face)
    rings = [top, bottom] + ([face] if tuck else [])
    walls = _walls(start, end, count, 2 * count if tuck else None)
    triangles = np.concatenate([patch.triangles, patch.triangles[:, ::-1] + count, walls])
    return _compact(np.concatenate(rings), triangles)


def border_edges(patch: Patch) -> Tuple[np.ndarray, np.ndarray]:
    """Return the start and the end vertex (B,) of the edges that one triangle has alone, in the triangle's direction.

    Raises
    ------
    MeshError
        If triangles do not fit together.
    """
    start, end = directed_edges(Mesh(patch.vertices, patch.triangles))
    count = len(patch.vertices)
    key, reverse = start * count + end, end * count + start
    if len(np.unique(key)) < len(key):
        raise MeshError("the triangles of a face must run along each edge at most once each way")
    alone = ~np.isin(key, reverse)
    return start[alone], end[alone]


def _aside(patch: Patch, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Per vertex (P, 3): on the border the way out of the face, in its plane, so long that edges move by 1; else 0."""
    along = patch.vertices[end] - patch.vertices[start]
    out = np.zeros((2,) + patch.vertices.shape)
    for side, at in enumerate((start, end)):
        across = np.cross(along, patch.normals[at])
        across /= np.linalg.norm(across, axis=1, keepdims=True).clip(1e-300)
        np.add.at(out[side], at, across)
    total = out.sum(0)
    length = np.linalg.norm(total, axis=1, keepdims=True)
    # two unit vectors at an angle a add to 2 cos(a/2): a mitre is 1 / cos(a/2) long; sharp ones are cut at 3
    mitre = (2 / length.clip(1e-300)).clip(0, 3)
    return np.where(length > 1e-9, total / length.clip(1e-300) * mitre, 0.0)


def _walls(start: np.ndarray, end: np.ndarray, count: int, between: object) -> np.ndarray:
    """Triangles of the walls along the border, from top (0..) to bottom (count..), by way of a ring between if any."""
    levels = [0, count] if between is None else [0, int(between), count]  # type: ignore[call-overload]
    walls = []
    for upper, lower in zip(levels, levels[1:]):
        walls.append(np.stack([start + upper, start + lower, end + lower], 1))
        walls.append(np.stack([start + upper, end + lower, end + upper], 1))
    return np.concatenate(walls)


def _check_folds(patch: Patch, moved: np.ndarray, thickness: float) -> None:
    t = patch.triangles
    before, after = (np.cross(v[t[:, 1]] - v[t[:, 0]], v[t[:, 2]] - v[t[:, 0]]) for v in (patch.vertices, moved))
    area = np.linalg.norm(before, axis=1)
    folded = int((((before * after).sum(1) < 0) & (area > _NEEDLE * area.max())).sum())
    if folded:
        raise MeshError(
            f"a layer must be thinner than the least radius of its face's curvature: at {thickness:g} mm {folded} of "
            f"{len(patch.triangles)} triangles fold"
        )


def _compact(vertices: np.ndarray, triangles: np.ndarray) -> Mesh:
    used, number = np.unique(triangles, return_inverse=True)
    return Mesh(vertices[used], number.reshape(-1, 3))


def layered_body(envelope: Mesh, patches: Sequence[Patch], layers: LayerParameters) -> LayeredBody:
    """Return the envelope with compact layers on the given faces (thesis 4.3.1).

    Parameters
    ----------
    envelope : Mesh
    patches : sequence of Patch
        The faces; none, no layer.
    layers : LayerParameters

    Raises
    ------
    MeshError
        If a layer is thicker than its face's curvature allows, or inwards takes the whole envelope.
    DependencyError
        If manifold3d is not installed.

    Notes
    -----
    A layer is the face extruded along its normals; inwards it is the part of the envelope in that extrusion. Where a
    neighbour face leans away by more than a right angle, it does not reach that face below the border.
    """
    if not patches:
        return LayeredBody(envelope, (), 0.0, "")
    t = layers.thickness
    if layers.side == "inwards":
        if not layers.closed:
            note = "layers inwards that the channels go through are the envelope itself: nothing changes"
            return LayeredBody(envelope, (), 0.0, note)
        solids = tuple(thicken(p, t, _HAIR * t, widening=_HAIR * t) for p in patches)
        if not len(combine([envelope, *solids], "difference").triangles):
            raise MeshError(f"layers inwards must leave a part of the envelope, but {t:g} mm take all of it")
        return LayeredBody(envelope, solids, 0.0, "")
    plugs = [thicken(p, _HAIR * t, t, tuck=_HAIR * t) for p in patches]
    body = combine([envelope, *plugs], "union")
    solids = tuple(thicken(p, 0.0, t) for p in patches) if layers.closed else ()
    return LayeredBody(body, solids, mesh_volume(body) - mesh_volume(envelope), "")


def reaches(wireframe: Wireframe, couplings: Sequence[Coupling], layers: LayerParameters, beyond: float) -> np.ndarray:
    """Return how far each rod must be prolonged at its two ends, ndarray (R, 2), mm.

    ``beyond`` mm everywhere; through an outward layer that the channels go through, its thickness more.
    """
    ends = np.array([[c.first, c.second] for c in couplings], dtype=object).reshape(-1, 2)
    through = layers.side == "outwards" and not layers.closed
    in_layer = np.isin(ends.astype(str), list(layers.faces)) if through and layers.faces else np.zeros(ends.shape, bool)
    return beyond + layers.thickness * in_layer[wireframe.coupling]
