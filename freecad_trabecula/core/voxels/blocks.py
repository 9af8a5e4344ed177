# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of a design's voxels as blocks: exact volume, closed, every edge between two triangles.

Where two voxels touch by an edge or a corner alone, their common vertices are split: each voxel keeps its own.
"""

from __future__ import annotations

from typing import Sequence, Tuple

import numpy as np

from ...errors import MeshError
from ..meshes import Mesh

#: Corners (z, y, x) of a face of a unit voxel, counter-clockwise from outside, by the face's outer step (z, y, x).
_FACES = (
    ((0, 0, -1), ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))),
    ((0, 0, 1), ((0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1))),
    ((0, -1, 0), ((0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 0, 0))),
    ((0, 1, 0), ((0, 1, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1))),
    ((-1, 0, 0), ((0, 0, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1))),
    ((1, 0, 0), ((1, 0, 0), (1, 0, 1), (1, 1, 1), (1, 1, 0))),
)


def block_mesh(voxels: np.ndarray, voxel: Sequence[float], origin: Sequence[float] = (0.0, 0.0, 0.0)) -> Mesh:
    """Return the blocks of all solid voxels as one mesh.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    voxel : sequence of float, mm
        Edges dx, dy, dz.
    origin : sequence of float, mm
        Low corner of the box.

    Raises
    ------
    MeshError
        If no voxel is solid.

    Examples
    --------
    >>> mesh = block_mesh(np.ones((1, 1, 2), bool), (1, 1, 1))
    >>> mesh.vertices.shape, mesh.triangles.shape
    ((12, 3), (20, 3))
    """
    if not voxels.any():
        raise MeshError("a design must have at least one voxel to have a mesh, got 0")
    corners, owners = _outer_faces(voxels)
    partner = _partners(corners, owners)
    _, first, quads = np.unique(_fans(partner), return_index=True, return_inverse=True)
    quads = quads.reshape(-1, 4)
    places = corners.ravel()[first]
    z, y, x = np.unravel_index(places, [s + 1 for s in voxels.shape])
    points = np.stack([x, y, z], 1).astype(float)
    points, triangles = _with_middles(points, quads, partner)
    return Mesh(points * np.asarray(voxel, float) + np.asarray(origin, float), triangles)


def _outer_faces(voxels: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Faces between solid and void: grid vertices of their corners (F, 4), and the voxels they belong to (F,)."""
    padded = np.pad(voxels, 1)
    size = tuple(s + 1 for s in voxels.shape)
    corners, owners = [], []
    for step, places in _FACES:
        beyond = padded[tuple(slice(1 + s, 1 + s + n) for s, n in zip(step, voxels.shape))]
        owner = np.flatnonzero(voxels & ~beyond)
        low = np.stack(np.unravel_index(owner, voxels.shape), 1)
        corners.append(np.stack([np.ravel_multi_index(tuple((low + place).T), size) for place in places], 1))
        owners.append(owner)
    return np.concatenate(corners), np.concatenate(owners)


def _partners(corners: np.ndarray, owners: np.ndarray) -> np.ndarray:
    """For each half-edge (F * 4,), corner k to k + 1 of a face, the one that runs the other way along the same edge.

    Where two voxels touch by an edge alone it has four faces: those of the same voxel are partners.
    """
    start, end = corners.ravel(), np.roll(corners, -1, axis=1).ravel()
    edge = np.minimum(start, end) * (int(corners.max()) + 1) + np.maximum(start, end)
    order = np.lexsort((np.repeat(owners, 4), edge))
    partner = np.empty(len(order), np.int64)
    partner[order[0::2]], partner[order[1::2]] = order[1::2], order[0::2]
    return partner


def _fans(partner: np.ndarray) -> np.ndarray:
    """Number of the fan of faces that each corner belongs to, (F * 4,): one fan is one vertex of the mesh."""
    corner = np.arange(len(partner)).reshape(-1, 4)
    following, before = np.roll(corner, -1, axis=1).ravel(), np.roll(corner, 1, axis=1).ravel()
    # a half-edge's start is the end of its partner's: the corner after that one
    one, two = following[partner], partner[before]
    numbers = corner.ravel().copy()
    while True:
        least = np.minimum(numbers, np.minimum(numbers[one], numbers[two]))
        least = least[least]
        if (least == numbers).all():
            return numbers
        numbers = least


def _with_middles(points: np.ndarray, quads: np.ndarray, partner: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Two triangles for each quad; of two pairs of faces between the same two vertices, one gets a vertex between.

    That happens where two voxels touch by an edge whose both ends hang together some other way.
    """
    start, end = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    pairs = np.flatnonzero(np.arange(len(partner)) < partner)
    low, high = np.minimum(start[pairs], end[pairs]), np.maximum(start[pairs], end[pairs])
    _, first = np.unique(low * len(points) + high, return_index=True)
    again = np.ones(len(pairs), bool)
    again[first] = False
    halves = pairs[again]
    middle = {}
    for number, half in enumerate(halves.tolist(), len(points)):
        middle[half] = middle[int(partner[half])] = number
    faces = sorted({half // 4 for half in middle})
    triangles, centre = [], len(points) + len(halves)
    for number, face in enumerate(faces, centre):
        ring = []
        for k in range(4):
            ring.append(int(quads[face, k]))
            if 4 * face + k in middle:
                ring.append(middle[4 * face + k])
        triangles += [(number, ring[k], ring[(k + 1) % len(ring)]) for k in range(len(ring))]
    points = np.concatenate([points, (points[start[halves]] + points[end[halves]]) / 2, points[quads[faces]].mean(1)])
    plain = np.delete(quads, faces, axis=0)
    parts = [plain[:, [0, 1, 2]], plain[:, [0, 2, 3]], np.array(triangles, np.int64).reshape(-1, 3)]
    return points, np.concatenate(parts)
