# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compact layers: faces of the envelope thickened inwards or outwards, with or without the channels (thesis 4.3.1).

Made after the channels, a layer closes them; made before, they go through it. Channels that are to go through an
outward layer need rods that are longer there (``reaches``). An inward layer through which the channels go changes
nothing: the envelope was there before.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple, Sequence, Tuple

import numpy as np

from ..errors import MeshError
from .booleans import combine
from .meshes import Mesh, directed_edges, join, mesh_volume
from .optional_packages import optional_module
from .parameters import Coupling, LayerParameters
from .pieces import pieces
from .wireframe import Wireframe

_REACHES = (0.5, 0.75, 1.0, 1.5, 2.0, 3.0)  # thicknesses over which normals are smoothed, one after the other
_SAME_COSINE = 0.9998  # 1 degree; normals that turn less count as they were
_LEAST_COSINE = (
    0.5  # between a smoothed direction and the face's normal: a layer is nowhere thinner than half of its thickness
)
_HALVINGS = 24  # of the shift of a border; 0.1 mm is then below a nanometre
_NEEDLE = 1e-6  # of the largest triangle; the direction of smaller ones is rounding
_HAIR = 0.1  # thicknesses; how far a layer reaches past the face and its border, so that no surfaces coincide


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
    wider, tucked = _aside(patch, widening), _aside(patch, -tuck)
    for _ in range(_HALVINGS):
        face = patch.vertices + wider
        top, bottom = face + outer * patch.normals, face - inner * patch.normals + tucked
        folded = np.union1d(_folds(patch, top), _folds(patch, bottom))
        if not len(folded):
            break
        touched = np.unique(patch.triangles[folded])  # triangles narrower than the shift of their border
        wider[touched] /= 2
        tucked[touched] /= 2
    else:
        raise MeshError(
            f"a layer must be thinner than the least radius of its face's curvature: at {max(inner, outer):g} mm "
            f"{len(folded)} of {len(patch.triangles)} triangles fold"
        )
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


def _aside(patch: Patch, distance: float) -> np.ndarray:
    """Shifts (P, 3), mm, that move the border outwards in the tangent planes of the face; 0 inside the face."""
    start, end = border_edges(patch)
    along = patch.vertices[end] - patch.vertices[start]
    total = np.zeros_like(patch.vertices)
    for at in (start, end):
        np.add.at(total, at, _unit(np.cross(along, patch.normals[at])))
    length = np.linalg.norm(total, axis=1, keepdims=True)
    # two unit vectors at an angle a add to 2 cos(a/2): a mitre is 1 / cos(a/2) long; sharp ones are cut at 3
    mitre = np.where(length > _NEEDLE, (2 / length.clip(_NEEDLE)).clip(0, 3), 0.0)
    return distance * mitre * _unit(total)


def _walls(start: np.ndarray, end: np.ndarray, count: int, between: object) -> np.ndarray:
    """Triangles of the walls along the border, from top (0..) to bottom (count..), by way of a ring between if any."""
    levels = [0, count] if between is None else [0, int(between), count]  # type: ignore[call-overload]
    walls = []
    for upper, lower in zip(levels, levels[1:]):
        walls.append(np.stack([start + upper, start + lower, end + lower], 1))
        walls.append(np.stack([start + upper, end + lower, end + upper], 1))
    return np.concatenate(walls)


def _folds(patch: Patch, moved: np.ndarray) -> np.ndarray:
    """Numbers of the triangles that turn over when the vertices are moved."""
    t = patch.triangles
    before, after = (np.cross(v[t[:, 1]] - v[t[:, 0]], v[t[:, 2]] - v[t[:, 0]]) for v in (patch.vertices, moved))
    area = np.linalg.norm(before, axis=1)
    return np.flatnonzero(((before * after).sum(1) < 0) & (area > _NEEDLE * area.max()))


def unfolded(patch: Patch, inner: float, outer: float) -> Tuple[Patch, int]:
    """Return the face with normals along which it can be thickened without folds, and how many vertices that took.

    Where a face bends more sharply than the layer is thick (bumps of real bone), its normals would cross inside the
    layer. There and around they are replaced by their mean over a neighbourhood, which grows until no triangle turns
    over.

    Raises
    ------
    MeshError
        If a direction would leave its normal by more than 60 degrees, or smoothing does not help.
    DependencyError
        If smoothing is needed and scipy is not installed.
    """
    thickness, vertices, normals = max(inner, outer), patch.vertices, patch.normals
    zone = np.zeros(len(vertices), bool)
    for reach in (0.0, *_REACHES):
        if reach:
            normals = _smoothed(patch, zone, reach * thickness)
        folded = np.union1d(*(_folds(patch, vertices + step * normals) for step in (outer, -inner)))
        if not len(folded):
            break
        zone[patch.triangles[folded]] = True
    if len(folded) or (normals * patch.normals).sum(1).min() < _LEAST_COSINE:
        raise MeshError(
            f"a layer must be thinner than the least radius of its face's curvature: at {thickness:g} mm "
            f"{len(folded)} of {len(patch.triangles)} triangles fold, and smoothing does not help"
        )
    changed = (normals * patch.normals).sum(1) < _SAME_COSINE
    return replace(patch, normals=normals), int(changed.sum())


def _smoothed(patch: Patch, zone: np.ndarray, reach: float) -> np.ndarray:
    """Normals (P, 3): in the zone their Gaussian mean over ``reach`` mm, far from it as they were, else a blend."""
    purpose = "layers on faces that bend sharply need the package scipy"
    cKDTree = optional_module("scipy.spatial", purpose).cKDTree
    points, t = patch.vertices, patch.triangles
    area = np.linalg.norm(np.cross(points[t[:, 1]] - points[t[:, 0]], points[t[:, 2]] - points[t[:, 0]]), axis=1)
    share = np.bincount(t.ravel(), area.repeat(3), len(points))
    away = cKDTree(points[zone]).query(points)[0]
    near = np.flatnonzero(away < 3 * reach)
    found = cKDTree(points[near]).sparse_distance_matrix(cKDTree(points), 2 * reach, output_type="coo_matrix")
    weights = np.exp(-((found.data / reach) ** 2)) * share[found.col]
    mean = np.stack([np.bincount(found.row, weights * patch.normals[found.col, k], len(near)) for k in range(3)], 1)
    blend = np.exp(-((away[near, None] / (1.5 * reach)) ** 2))
    normals = patch.normals.copy()
    normals[near] = _unit((1 - blend) * patch.normals[near] + blend * _unit(mean))
    return normals


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True).clip(1e-300)


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
    if layers.side == "inwards" and not layers.closed:
        note = "layers inwards that the channels go through are the envelope itself: nothing changes"
        return LayeredBody(envelope, (), 0.0, note)
    smoothed = [unfolded(p, *((t, _HAIR * t) if layers.side == "inwards" else (_HAIR * t, t))) for p in patches]
    patches, changed = [p for p, _ in smoothed], sum(n for _, n in smoothed)
    note = f"layers follow smoothed normals at {changed} points where a face bends more sharply than {t:g} mm"
    note = note if changed else ""
    if layers.side == "inwards":
        solids = tuple(thicken(p, t, _HAIR * t, widening=_HAIR * t) for p in patches)
        if not len(combine([envelope, *solids], "difference").triangles):
            raise MeshError(f"layers inwards must leave a part of the envelope, but {t:g} mm take all of it")
        return LayeredBody(envelope, solids, 0.0, note)
    plugs = [thicken(p, _HAIR * t, t, tuck=_HAIR * t) for p in patches]
    body = _without_gaps(combine([envelope, *plugs], "union"), envelope)
    solids = tuple(thicken(p, 0.0, t) for p in patches) if layers.closed else ()
    return LayeredBody(body, solids, mesh_volume(body) - mesh_volume(envelope), note)


def _without_gaps(body: Mesh, envelope: Mesh) -> Mesh:
    """The body less the cavities that the envelope does not have: a face and its layer are triangulated differently."""
    own = [mesh_volume(c) for piece in pieces(envelope).found for c in piece.cavities]
    kept = []
    for piece in pieces(body).found:
        kept.append(piece.shell)
        kept += [c for c in piece.cavities if np.isclose(mesh_volume(c), own, rtol=1e-6, atol=0).any()]
    return join(kept)


def reaches(wireframe: Wireframe, couplings: Sequence[Coupling], layers: LayerParameters, beyond: float) -> np.ndarray:
    """Return how far each rod must be prolonged at its two ends, ndarray (R, 2), mm.

    ``beyond`` mm everywhere; through an outward layer that the channels go through, its thickness more.
    """
    ends = np.array([[c.first, c.second] for c in couplings], dtype=object).reshape(-1, 2)
    through = layers.side == "outwards" and not layers.closed
    in_layer = np.isin(ends.astype(str), list(layers.faces)) if through and layers.faces else np.zeros(ends.shape, bool)
    return beyond + layers.thickness * in_layer[wireframe.coupling]
