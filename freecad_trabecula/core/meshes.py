# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed triangle meshes: volume, area, faults of edges, pieces, welding, rounding to single precision."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ..errors import MeshError

_BLOCK = 200_000  # triangles worked on at once: about 60 MB of temporary arrays
_EDGE_BLOCK = 2_000_000  # triangles whose edges are sorted at once, while a mesh is checked: about 100 MB
_NUDGES = 1000  # rounds of nudging; each moves a point further than the one before, so a few are enough


@dataclass(frozen=True)
class Mesh:
    """A triangle mesh, counter-clockwise seen from outside.

    Attributes
    ----------
    vertices : ndarray of shape (V, 3), float64, mm
    triangles : ndarray of shape (T, 3), int64; int32 is kept, to halve the memory of millions of triangles
        Numbers of the vertices.

    Raises
    ------
    MeshError
        If an array has another shape.
    """

    vertices: np.ndarray
    triangles: np.ndarray

    def __post_init__(self) -> None:
        short = getattr(self.triangles, "dtype", None) == np.int32
        for name, dtype in (("vertices", np.float64), ("triangles", np.int32 if short else np.int64)):
            array = np.asarray(getattr(self, name), dtype)
            if array.ndim != 2 or array.shape[1] != 3:
                raise MeshError(f"{name} of a mesh must have the shape (count, 3), got {array.shape}")
            object.__setattr__(self, name, array)

    @property
    def corners(self) -> np.ndarray:
        """Corners of the triangles, ndarray of shape (T, 3, 3), mm."""
        return self.vertices[self.triangles]


class EdgeFaults(NamedTuple):
    """What keeps a mesh from being closed; all 0 if it is.

    Attributes
    ----------
    open : int
        Edges of one triangle only.
    non_manifold : int
        Edges of three or more triangles.
    unbalanced : int
        Edges that triangles run along more often one way than the other.
    degenerate : int
        Triangles that name a vertex twice.
    """

    open: int
    non_manifold: int
    unbalanced: int
    degenerate: int


def bounds(mesh: Mesh) -> Tuple[np.ndarray, np.ndarray]:
    """Return the lowest and the highest co-ordinates (3,), mm.

    Raises
    ------
    MeshError
        If the mesh has no vertices.
    """
    if not len(mesh.vertices):
        raise MeshError("a mesh must have at least one vertex to have bounds, got 0")
    return mesh.vertices.min(0), mesh.vertices.max(0)


def mesh_volume(mesh: Mesh) -> float:
    """Return the signed volume, mm³, of a closed mesh: positive if it turns counter-clockwise seen from outside."""
    return float(sum(volumes.sum() for volumes in _tetrahedra(mesh)))


def component_volumes(mesh: Mesh, labels: np.ndarray) -> np.ndarray:
    """Return the signed volume (C,), mm³, of each component; cavities' are negative. ``labels`` from ``components``."""
    volumes = np.concatenate([np.zeros(0)] + list(_tetrahedra(mesh)))
    return np.bincount(labels, volumes)


def mesh_area(mesh: Mesh) -> float:
    """Return the area of the surface, mm²."""
    return float(
        sum(np.sqrt((np.cross(b - a, c - a) ** 2).sum(1)).sum() / 2 for a, b, c in _corner_blocks(mesh, np.zeros(3)))
    )


def _tetrahedra(mesh: Mesh) -> Iterator[np.ndarray]:
    """Signed volumes of the tetrahedra from the mesh's middle to its triangles: near it, so that little cancels."""
    if len(mesh.vertices):
        for corners in _corner_blocks(mesh, np.add(*bounds(mesh)) / 2):
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (corner.T for corner in corners)
            yield (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6


def _corner_blocks(mesh: Mesh, origin: np.ndarray) -> Iterator[Tuple[np.ndarray, np.ndarray, np.ndarray]]:
    for start in range(0, len(mesh.triangles), _BLOCK):
        block = mesh.triangles[start : start + _BLOCK]
        yield tuple(np.take(mesh.vertices, block[:, k], 0) - origin for k in range(3))  # type: ignore[misc]


def directed_edges(mesh: Mesh) -> Tuple[np.ndarray, np.ndarray]:
    """Return start and end vertex (3 T,) of all edges: first to second, second to third, third to first."""
    return mesh.triangles.T.ravel(), mesh.triangles[:, [1, 2, 0]].T.ravel()


def _edge_keys(mesh: Mesh, first: int, last: int) -> Tuple[np.ndarray, np.ndarray]:
    """Numbers of the edges that run up (in vertex numbers) and of those that run down, one number both ways.

    Of the edges whose lower vertex is ``first`` .. ``last - 1``.
    """
    corners, keys = mesh.triangles.T, []
    for start, end in ((0, 1), (1, 0)):
        found = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            low, high = corners[(a, b)[start]], corners[(a, b)[end]]
            chosen = np.flatnonzero((low < high) & (low >= first) & (low < last))
            key = low[chosen].astype(np.int64)
            key *= len(mesh.vertices)
            key += high[chosen]
            found.append(key)
        keys.append(np.concatenate(found))
    return keys[0], keys[1]


def is_closed(mesh: Mesh) -> bool:
    """Return True if every edge is in exactly two triangles that run along it opposite ways; False if empty.

    Notes
    -----
    No edge may run up twice; then those that run down are the same ones if as many have the same sum of 64-bit hashes
    (but for one chance in 10^19), which saves half of the sorting.
    """
    blocks, count, found = 1 + len(mesh.triangles) // _EDGE_BLOCK, len(mesh.vertices), 0
    for k in range(blocks):
        up, down = _edge_keys(mesh, k * count // blocks, (k + 1) * count // blocks)
        if len(up) != len(down) or _hash_sum(up) != _hash_sum(down):
            return False
        up.sort()
        if (up[1:] == up[:-1]).any():
            return False
        found += len(up)
    return bool(found) and 2 * found == 3 * len(mesh.triangles)


def _hash_sum(keys: np.ndarray) -> int:
    """Sum of the keys' hashes (finaliser of splitmix64, doi:10.1145/2714064.2660195), whatever their order."""
    mixed = keys.view(np.uint64).copy()
    for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB)):
        mixed ^= mixed >> np.uint64(shift)
        mixed *= np.uint64(factor)
    mixed ^= mixed >> np.uint64(31)
    return int(mixed.sum(dtype=np.uint64))


def edge_faults(mesh: Mesh) -> EdgeFaults:
    """Return the counts of what keeps a mesh from being closed."""
    up, down = map(np.sort, _edge_keys(mesh, 0, len(mesh.vertices)))
    keys = np.concatenate([up, down])
    order = np.argsort(keys, kind="stable")
    first = np.flatnonzero(np.diff(keys[order], prepend=-1))
    uses, balance = np.zeros(0, np.int64), np.zeros(0, np.int64)
    if len(keys):
        uses = np.diff(first, append=len(keys))
        balance = np.add.reduceat(np.where(order < len(up), 1, -1), first)
    t = mesh.triangles
    return EdgeFaults(
        open=int((uses == 1).sum()),
        non_manifold=int((uses > 2).sum()),
        unbalanced=int((balance != 0).sum()),
        degenerate=int(((t[:, 0] == t[:, 1]) | (t[:, 1] == t[:, 2]) | (t[:, 2] == t[:, 0])).sum()),
    )


def require_closed(mesh: Mesh, name: str) -> None:
    """Raise MeshError with the counts of faults if the mesh called ``name`` is not closed."""
    if not is_closed(mesh):
        f = edge_faults(mesh)
        raise MeshError(
            f"{name} must be a closed mesh, each edge in two triangles that run along it opposite ways; it has "
            f"{len(mesh.triangles)} triangles, {f.open} open edges, {f.non_manifold} edges of more than two triangles, "
            f"{f.unbalanced} edges run unevenly, {f.degenerate} triangles with a vertex named twice"
        )


def roots(count: int, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the lowest number (count,) that each thing is joined with, directly or through others, by links a to b.

    Notes
    -----
    Hooking and pointer jumping (Shiloach and Vishkin 1982, doi:10.1016/0196-6774(82)90008-6): everything that is joined
    with a lower number points to one of them, chains are cut short to their roots, links inside a tree drop out.
    """
    root = np.arange(count, dtype=a.dtype)
    while len(a):
        root[np.maximum(a, b)] = np.minimum(a, b)  # always to a lower number: no circles, whichever wins
        while True:
            jumped = root[root]
            if (jumped == root).all():
                break
            root = jumped
        a, b = root[a], root[b]
        apart = a != b
        a, b = a[apart], b[apart]
    return root


def components(mesh: Mesh) -> np.ndarray:
    """Return the number of each triangle's component, (T,) from 0: triangles that share a vertex belong together."""
    a, b = mesh.triangles[:, :2].ravel(), mesh.triangles[:, 1:].ravel()
    root = roots(len(mesh.vertices), a, b)
    of_triangle = root[mesh.triangles[:, 0]]
    used = np.zeros(len(root), bool)
    used[of_triangle] = True
    return (np.cumsum(used, dtype=root.dtype) - 1)[of_triangle]


def split(mesh: Mesh) -> List[Mesh]:
    """Return the components as meshes of their own, in the order of ``components``, without unused vertices."""
    labels = components(mesh)
    count = int(labels.max(initial=-1)) + 1
    of_vertex = np.full(len(mesh.vertices), count)
    of_vertex[mesh.triangles.ravel()] = np.repeat(labels, 3)
    parts = []
    vertex_order, triangle_order = (np.argsort(of, kind="stable") for of in (of_vertex, labels))
    vertex_start, triangle_start = (
        np.searchsorted(of[order], np.arange(count + 1))
        for of, order in ((of_vertex, vertex_order), (labels, triangle_order))
    )
    number = np.empty(len(mesh.vertices), np.int64)
    for k in range(count):
        vertices = vertex_order[vertex_start[k] : vertex_start[k + 1]]
        number[vertices] = np.arange(len(vertices))
        triangles = mesh.triangles[triangle_order[triangle_start[k] : triangle_start[k + 1]]]
        parts.append(Mesh(mesh.vertices[vertices], number[triangles]))
    return parts


def join(meshes: Sequence[Mesh]) -> Mesh:
    """Return several meshes as one; nothing is merged."""
    first = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    return Mesh(
        np.concatenate([np.zeros((0, 3))] + [mesh.vertices for mesh in meshes]),
        np.concatenate([np.zeros((0, 3), np.int64)] + [mesh.triangles + k for mesh, k in zip(meshes, first)]),
    )


def weld(corners: np.ndarray) -> Mesh:
    """Return the mesh of triangles given by their corners: exactly equal points become one vertex.

    Parameters
    ----------
    corners : ndarray of shape (T, 3, 3), float32 or float64, mm
    """
    points = corners.reshape(-1, 3) + corners.dtype.type(0)  # -0 becomes 0
    for keys in (_hash(points), None):
        order, first = _groups(points, keys)
        earliest = np.minimum.reduceat(order, first) if len(points) else order
        by_appearance = np.argsort(earliest)
        number = np.empty(len(first), np.int64)
        number[by_appearance] = np.arange(len(first))
        of_point = np.empty(len(points), np.int64)
        of_point[order] = np.repeat(number, np.diff(first, append=len(points)))
        vertices = points[earliest[by_appearance]]
        if (vertices[of_point] == points).all():  # else two points share a hash: once in 10^6 meshes of 10^6 triangles
            break
    return Mesh(vertices, of_point.reshape(-1, 3))


def printable(mesh: Mesh) -> Mesh:
    """Return the mesh as a file of single precision (STL) keeps it, vertices still distinct.

    Co-ordinates are rounded to float32; vertices that fall on the same point are nudged apart by a few units in the
    last place, so that a reader that welds equal points finds exactly the same triangles: what was closed stays closed.

    Raises
    ------
    MeshError
        If a co-ordinate is not finite in single precision.
    """
    points = mesh.vertices.astype(np.float32) + np.float32(0)
    if not np.isfinite(points).all():
        raise MeshError(
            f"co-ordinates must be finite and below 3.4e38 mm for a file, got {np.abs(mesh.vertices).max()}"
        )
    unit = np.spacing(np.abs(points).max(initial=0.0))  # of the largest co-ordinate: changes every other one too
    for nudge in range(_NUDGES):
        order, first = _groups(points, _hash(points))
        if len(first) == len(points):
            return Mesh(points, mesh.triangles)
        rank = np.arange(len(points)) - np.repeat(first, np.diff(first, append=len(points)))
        copies = np.flatnonzero(rank)
        points[order[copies], nudge % 3] += unit * (nudge // 3 + rank[copies]).astype(np.float32)
    raise MeshError(
        f"{len(points) - len(first)} vertices still share their point in single precision after {_NUDGES} nudges"
    )


def _hash(points: np.ndarray) -> np.ndarray:
    """One 64-bit number per point (P,): sorting these is three times as fast as sorting co-ordinates."""
    bits = points.view(np.uint32 if points.dtype == np.float32 else np.uint64)
    key = np.zeros(len(points), np.uint64)
    for column, factor in zip(
        bits.T, (0x9E3779B97F4A7C15, 0xBF58476D1CE4E5B9, 0x94D049BB133111EB)
    ):  # as in streams.mix
        key = (key ^ column) * np.uint64(factor)
        key ^= key >> np.uint64(31)
    return key


def _groups(points: np.ndarray, keys: Optional[np.ndarray]) -> Tuple[np.ndarray, np.ndarray]:
    """Order (P,) that puts equal points side by side, and where in it each group starts (G,); by keys if given."""
    if keys is None:
        order = np.lexsort(points.T)
        new = (points[order[1:]] != points[order[:-1]]).any(1)
    else:
        order = np.argsort(keys)
        keys = keys[order]
        new = keys[1:] != keys[:-1]
    return order, np.flatnonzero(np.concatenate([np.ones(min(1, len(points)), bool), new]))
