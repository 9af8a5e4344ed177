# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which surfaces bound a body of rods, and where they meet: faces, seams and nodes read off a labelled mesh Boolean.

The mesh Boolean decides what meets what (it always yields a closed body); the surfaces themselves then say where
exactly (``seams``). Nothing that a kernel's Boolean does is needed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, NamedTuple, Tuple

import numpy as np

from ..errors import MeshError
from .meshes import Mesh, components

#: A seam as part of a face's border: its number, and whether it is run through backwards.
Use = Tuple[int, bool]


@dataclass(frozen=True)
class LabelledMesh:
    """A closed mesh that knows the surface each of its triangles lies on.

    Attributes
    ----------
    vertices : ndarray (V, 3), mm
    triangles : ndarray (T, 3), int
        Counter-clockwise seen from outside.
    surfaces : ndarray (T,), int
    parameters : ndarray (T, 3, 2)
        Parameters (u, v) of the corners on that surface, as far as triangles tell them.
    """

    vertices: np.ndarray
    triangles: np.ndarray
    surfaces: np.ndarray
    parameters: np.ndarray


class Seam(NamedTuple):
    """A line in which two surfaces meet.

    Attributes
    ----------
    vertices : ndarray (N,), int
        Of the mesh, in order; the first and the last are nodes, the same one if the seam is closed.
    surfaces : tuple of int
        The one to its left and the one to its right, seen from outside.
    """

    vertices: np.ndarray
    surfaces: Tuple[int, int]


class Patch(NamedTuple):
    """A connected piece of a surface.

    Attributes
    ----------
    surface : int
    borders : tuple of tuple of Use
        Closed borders, the patch to the left of each, seen from outside.
    shell : int
        Number of the closed surface to which it belongs.
    forward : bool
        Whether the surface's own normal, about which its parameters turn counter-clockwise, points out of the body.
    """

    surface: int
    borders: Tuple[Tuple[Use, ...], ...]
    shell: int
    forward: bool


@dataclass(frozen=True)
class Patchwork:
    """The faces of a body: its topology, without geometry.

    Attributes
    ----------
    seams : list of Seam
    patches : list of Patch
    shell_volumes : ndarray, mm3
        Of the closed surfaces by the triangles; cavities are negative.
    corners : dict
        Parameters (u, v) of a vertex on a surface: (vertex, surface) -> ndarray (2,).
    meeting : dict
        The surfaces that meet at a node: vertex -> tuple of int.
    """

    seams: List[Seam]
    patches: List[Patch]
    shell_volumes: np.ndarray
    corners: Dict[Tuple[int, int], np.ndarray]
    meeting: Dict[int, Tuple[int, ...]]


class _HalfEdges:
    """The sides of triangles, 3 T of them: side 3 t + k runs from corner k of triangle t to the next."""

    def __init__(self, triangles: np.ndarray) -> None:
        self.start = triangles.ravel()
        self.end = np.roll(triangles, -1, 1).ravel()
        span = int(self.start.max(initial=0)) + 1
        key, back = self.start * span + self.end, self.end * span + self.start
        order = np.argsort(key)
        place = np.searchsorted(key[order], back).clip(0, len(key) - 1)
        self.twin = order[place]
        if (key[self.twin] != back).any() or (np.diff(key[order]) == 0).any():
            raise MeshError("a patchwork needs a closed mesh each of whose edges has two triangles")
        side = np.arange(len(key))
        self.next = side - side % 3 + (side + 1) % 3


def patchwork(mesh: LabelledMesh) -> Patchwork:
    """Return faces, seams and nodes of a labelled mesh.

    Raises
    ------
    MeshError
        If the mesh is not closed, or a surface bounds a body alone, without any border.
    """
    sides = _HalfEdges(mesh.triangles)
    surface = np.repeat(mesh.surfaces, 3)
    border = np.nonzero(surface != surface[sides.twin])[0]
    after = _next_on_border(sides, surface, border)
    degree = np.bincount(sides.start[border], minlength=len(mesh.vertices))
    seam_of, back_of, seams = _trace(sides, surface, border, after, (degree > 0) & (degree != 2))
    shells = components(Mesh(mesh.vertices, mesh.triangles))
    piece = _pieces(sides, surface)
    patches = _patches(mesh, piece, border, after, seam_of, back_of, shells)
    corners: Dict[Tuple[int, int], np.ndarray] = {}
    touching = np.unique(sides.start[border])
    at_border = np.nonzero(np.isin(sides.start, touching))[0]
    for vertex, own, uv in zip(
        sides.start[at_border].tolist(),
        surface[at_border].tolist(),
        mesh.parameters.reshape(-1, 2)[at_border],
    ):
        corners.setdefault((vertex, own), uv)
    meeting: Dict[int, set] = {int(v): set() for seam in seams for v in seam.vertices[[0, -1]]}
    for vertex, own in corners:
        if vertex in meeting:
            meeting[vertex].add(own)
    return Patchwork(
        seams,
        patches,
        _shell_volumes(mesh, shells),
        corners,
        {v: tuple(sorted(s)) for v, s in meeting.items()},
    )


def _next_on_border(sides: _HalfEdges, surface: np.ndarray, border: np.ndarray) -> np.ndarray:
    """For each side on a border (others: -1) the one that follows on the border of the same patch."""
    on_border = np.zeros(len(surface), bool)
    on_border[border] = True
    ahead = sides.next[border]
    while True:
        inside = ~on_border[ahead]
        if not inside.any():
            break
        ahead[inside] = sides.next[sides.twin[ahead[inside]]]
    after = np.full(len(surface), -1)
    after[border] = ahead
    return after


def _trace(
    sides: _HalfEdges, surface: np.ndarray, border: np.ndarray, after: np.ndarray, node: np.ndarray
) -> Tuple[np.ndarray, np.ndarray, List[Seam]]:
    """Seams from node to node; for each side on a border the number of its seam, and whether it runs against it."""
    seam_of, back_of = np.full(len(surface), -1), np.zeros(len(surface), bool)
    start, end, twin, follow = sides.start.tolist(), sides.end.tolist(), sides.twin.tolist(), after.tolist()
    is_node, own = node.tolist(), surface.tolist()
    seams: List[Seam] = []
    known = seam_of.tolist()
    back = back_of.tolist()
    from_nodes = border[node[sides.start[border]]].tolist()
    for first in [*from_nodes, *border.tolist()]:  # closed seams without a node come last and get one
        if known[first] >= 0:
            continue
        side, vertices = first, [start[first]]
        while True:
            known[side] = known[twin[side]] = len(seams)
            back[twin[side]] = True
            vertices.append(end[side])
            if is_node[end[side]] or end[side] == vertices[0]:
                break
            side = follow[side]
        seams.append(Seam(np.array(vertices), (own[first], own[twin[first]])))
    return np.array(known), np.array(back), seams


def _patches(
    mesh: LabelledMesh,
    piece: np.ndarray,
    border: np.ndarray,
    after: np.ndarray,
    seam_of: np.ndarray,
    back_of: np.ndarray,
    shells: np.ndarray,
) -> List[Patch]:
    """Connected pieces of surfaces with their borders, in the order of their numbers."""
    borders: Dict[int, List[Tuple[Use, ...]]] = {}
    seen = np.zeros(len(after), bool).tolist()
    follow, seam, back = after.tolist(), seam_of.tolist(), back_of.tolist()
    for first in border.tolist():
        if seen[first]:
            continue
        uses: List[Use] = []
        side = first
        while not seen[side]:
            seen[side] = True
            use = (seam[side], back[side])
            if not uses or uses[-1] != use:
                uses.append(use)
            side = follow[side]
        if len(uses) > 1 and uses[0] == uses[-1]:  # the walk began inside a seam
            uses.pop()
        borders.setdefault(int(piece[first // 3]), []).append(tuple(uses))
    count = int(piece.max(initial=-1)) + 1
    if len(borders) != count:
        raise MeshError("a surface of a patchwork must meet others, got one that is closed in itself")
    a, b, c = mesh.parameters.transpose(1, 0, 2)
    turning = np.bincount(piece, (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    one = np.zeros(count, np.int64)
    one[piece] = np.arange(len(piece))  # some triangle of each
    return [
        Patch(int(mesh.surfaces[t]), tuple(borders[n]), int(shells[t]), bool(turning[n] > 0))
        for n, t in enumerate(one.tolist())
    ]


def _pieces(sides: _HalfEdges, surface: np.ndarray) -> np.ndarray:
    """Number of the connected piece of one surface to which each triangle belongs."""
    inner = surface == surface[sides.twin]
    a, b = np.nonzero(inner)[0] // 3, sides.twin[inner] // 3
    root = np.arange(len(surface) // 3)
    while len(a):  # as in meshes.components
        root[np.maximum(a, b)] = np.minimum(a, b)
        while (root[root] != root).any():
            root = root[root]
        a, b = root[a], root[b]
        apart = a != b
        a, b = a[apart], b[apart]
    return np.unique(root, return_inverse=True)[1].ravel()


def _shell_volumes(mesh: LabelledMesh, shells: np.ndarray) -> np.ndarray:
    a, b, c = (mesh.vertices[mesh.triangles[:, i]] - mesh.vertices[:1] for i in range(3))
    return np.bincount(shells, np.einsum("ij,ij->i", a, np.cross(b, c)) / 6)
