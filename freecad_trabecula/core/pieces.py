# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of a cut envelope: the scaffold, loose pieces that channels cut off all round, voids that no opening reaches.

Any engine gives two closed surfaces: the envelope's part outside the rods and its part inside them. Each falls into
shells; a shell of positive volume with the cavities in it is a piece. The largest piece outside the rods is the
scaffold, the others are loose; a cavity of the scaffold is a void.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, NamedTuple, Sequence, Tuple

import numpy as np

from ..errors import MeshError
from .meshes import Mesh, bounds, components, join, mesh_volume, split
from .parameters import SMALLEST_SIZE
from .rays import RayGrid, contains, crossings, union_intervals

#: Shells below this volume (mm³: a cube of the smallest pore's size, 1 micrometre) are crumbs of rounding: left out,
#: counted.
SLIVER = SMALLEST_SIZE**3
_SAME = 1e-6  # relative difference of two volumes of one shell, seen from both sides


class Piece(NamedTuple):
    """A connected body.

    Attributes
    ----------
    shell : Mesh
        Its outer surface.
    cavities : tuple of Mesh
        Its inner surfaces, as they stand in the body (volumes negative).
    shell_volume, volume : float, mm³
        Of the shell alone, and less the cavities.
    """

    shell: Mesh
    cavities: Tuple[Mesh, ...]
    shell_volume: float
    volume: float

    @property
    def mesh(self) -> Mesh:
        """Shell and cavities."""
        return _joined([self])


@dataclass(frozen=True)
class Parts:
    """What a cut envelope consists of.

    Attributes
    ----------
    scaffold, channels : Mesh
        As they are exported.
    scaffold_volume, channel_volume : float, mm³
        Their volumes.
    loose, voids : tuple of Mesh
        Pieces that channels cut off all round; pieces of the channels that no opening reaches; the largest first.
    loose_volumes, void_volumes : tuple of float, mm³
        A void's volume is what filling it adds to the scaffold: pieces inside it count with it, and not as loose.
    pieces, openings : int
        Connected pieces of the exported scaffold and of the exported channels.
    slivers : int
        Shells below ``SLIVER``, left out of all the above.
    cavities, matched : int
        Cavities of both bodies, and how many of them have the volume of a shell of the other body: they must all.
    filled : bool
        True if the voids are filled in the exported scaffold.
    """

    scaffold: Mesh
    channels: Mesh
    scaffold_volume: float
    channel_volume: float
    loose: Tuple[Mesh, ...]
    voids: Tuple[Mesh, ...]
    loose_volumes: Tuple[float, ...]
    void_volumes: Tuple[float, ...]
    pieces: int
    openings: int
    slivers: int
    cavities: int
    matched: int
    filled: bool = False


class Pieces(NamedTuple):
    """The pieces of a closed mesh, the largest first, and the number of slivers left out."""

    found: List[Piece]
    slivers: int


def pieces(mesh: Mesh) -> Pieces:
    """Return the pieces of a closed mesh.

    Raises
    ------
    MeshError
        If a cavity lies in no shell: the mesh is inside out.
    """
    shells = [(mesh_volume(shell), shell) for shell in _shells(mesh)]
    outer = sorted((s for s in shells if s[0] >= SLIVER), key=lambda s: -s[0])
    inner = [s for s in shells if s[0] <= -SLIVER]
    inside: List[List[Tuple[float, Mesh]]] = [[] for _ in outer]
    for cavity, owner in zip(inner, _owners(inner, outer)):
        inside[owner].append(cavity)
    found = [
        Piece(shell, tuple(m for _, m in holes), volume, volume + sum(v for v, _ in holes))
        for (volume, shell), holes in zip(outer, inside)
    ]
    return Pieces(found, len(shells) - len(outer) - len(inner))


def _shells(mesh: Mesh) -> List[Mesh]:
    """The components as ``meshes.split`` gives them, but the largest is taken out first, without sorting it."""
    labels = components(mesh)
    sizes = np.bincount(labels)
    if len(sizes) < 2:
        return [mesh] * len(sizes)
    of_largest = labels == np.argmax(sizes)
    largest, rest = (_selected(mesh, of) for of in (of_largest, ~of_largest))
    return [largest, *split(rest)]


def _selected(mesh: Mesh, chosen: np.ndarray) -> Mesh:
    triangles = mesh.triangles[chosen]
    used = np.zeros(len(mesh.vertices), bool)
    used[triangles] = True
    return Mesh(mesh.vertices[used], (np.cumsum(used, dtype=triangles.dtype) - 1)[triangles])


def _owners(inner: Sequence[Tuple[float, Mesh]], outer: Sequence[Tuple[float, Mesh]]) -> List[int]:
    """For each cavity the number of the smallest outer shell around it; ``outer`` by falling volume.

    A shell that is the only one large enough needs no rays: the cavity must lie somewhere.
    """
    if not inner:
        return []
    places = np.array([m.vertices[0] for _, m in inner])
    volumes = np.array([-v for v, _ in inner])
    boxes = [bounds(shell) for _, shell in outer]
    may = np.zeros((len(outer), len(inner)), bool)
    for k, ((volume, _), (low, high)) in enumerate(zip(outer, boxes)):
        may[k] = (volumes < volume) & ((places >= low) & (places <= high)).all(1)
    homeless = int((~may.any(0)).sum())
    if homeless:
        raise MeshError(
            f"every cavity must lie in a body, but {homeless} of {len(inner)} lie in none: "
            "the mesh is inside out or crosses itself"
        )
    owners = may.argmax(0)  # the largest, unless a smaller one is found to be around it
    for k in range(len(outer) - 1, 0, -1):
        doubtful = np.flatnonzero(may[k] & (owners < k))
        if len(doubtful):
            found = doubtful[contains(outer[k][1].corners, places[doubtful])]
            owners[found], may[:k, found] = k, False
    return owners.tolist()


def inner_point(mesh: Mesh) -> np.ndarray:
    """Return a point (3,) well inside a closed mesh: the middle of the longest stretch that a few rays have in it.

    Raises
    ------
    MeshError
        If it holds no volume that 81 x 81 rays would meet.
    """
    low, high = bounds(mesh)
    for cells in (3, 9, 27, 81) if (high > low).all() else ():
        grid = RayGrid.of_box(low, high, cells, 0)
        ray, start, end = union_intervals(crossings(mesh.corners, grid))
        if len(ray):
            k = int(np.argmax(end - start))
            u, v = (grid.origin[d] + grid.step[d] * n for d, n in enumerate(divmod(int(ray[k]), cells)))
            return np.array([(start[k] + end[k]) / 2, u, v])
    raise MeshError(f"a closed mesh must hold some volume, got {mesh_volume(mesh):g} mm3")


def separate(outside: Pieces, inside: Pieces, keep_loose: bool, keep_voids: bool) -> Parts:
    """Return what the two halves of a cut envelope consist of.

    Parameters
    ----------
    outside, inside : Pieces
        Of the envelope's parts outside and inside the rods.
    keep_loose : bool
        False: loose pieces are taken away, since they cannot be printed.
    keep_voids : bool
        False: voids are filled with all that hangs in them, since they keep their powder.

    Raises
    ------
    MeshError
        If nothing is left outside the rods.
    """
    if not outside.found:
        raise MeshError(
            "the channels must leave some material, got 0 mm3 of scaffold: the rods fill the whole envelope"
        )
    main, others, holes = outside.found[0], outside.found[1:], inside.found
    void, hung = _in_cavities(main, holes), _in_cavities(main, others)
    loose = [p for p, h in zip(others, hung) if keep_voids or not h]
    voids = [p for p, v in zip(holes, void) if v]
    solid = main if keep_voids else main._replace(cavities=(), volume=main.shell_volume)
    scaffold = [solid, *(loose if keep_loose else ())]
    channels = [p for p, v in zip(holes, void) if keep_voids or not v]
    cavities, matched = _matched(outside.found, holes)
    return Parts(
        scaffold=_joined(scaffold),
        channels=_joined(channels),
        scaffold_volume=float(sum(p.volume for p in scaffold)),
        channel_volume=float(sum(p.volume for p in channels)),
        loose=tuple(p.mesh for p in loose),
        voids=tuple(p.mesh for p in voids),
        loose_volumes=tuple(float(p.volume) for p in loose),
        void_volumes=tuple(sorted((float(-mesh_volume(c)) for c in main.cavities), reverse=True)),
        pieces=len(scaffold),
        openings=len(channels),
        slivers=outside.slivers + inside.slivers,
        cavities=cavities,
        matched=matched,
        filled=not keep_voids,
    )


def _joined(parts: Sequence[Piece]) -> Mesh:
    surfaces = [surface for piece in parts for surface in (piece.shell, *piece.cavities)]
    return surfaces[0] if len(surfaces) == 1 else join(surfaces)  # a mesh of millions of triangles is not copied


def _in_cavities(piece: Piece, others: Sequence[Piece]) -> np.ndarray:
    """True (N,) for pieces that lie in a cavity of one."""
    found = np.zeros(len(others), bool)
    boxes = [bounds(other.shell) for other in others] if piece.cavities else []
    for cavity in piece.cavities:
        low, high = bounds(cavity)
        hair = 1e-9 * (high - low)  # a void's shell is its cavity, up to rounding
        near = [k for k, (a, b) in enumerate(boxes) if (a >= low - hair).all() and (b <= high + hair).all()]
        if near:
            points = np.array([inner_point(others[k].mesh) for k in near])
            found[near] |= contains(cavity.corners[:, ::-1], points)
    return found


def _matched(solids: Sequence[Piece], holes: Sequence[Piece]) -> Tuple[int, int]:
    """Cavities of both bodies, and those whose volume a shell of the other body has: each is seen from both sides."""
    count = found = 0
    for these, others in ((solids, holes), (holes, solids)):
        volumes = np.array([-mesh_volume(c) for p in these for c in p.cavities])
        shells = np.sort([p.shell_volume for p in others])
        count += len(volumes)
        if len(volumes) and len(shells):
            right = np.searchsorted(shells, volumes).clip(0, len(shells) - 1)
            near = np.minimum(np.abs(shells[right] - volumes), np.abs(shells[np.maximum(right - 1, 0)] - volumes))
            found += int((near <= _SAME * volumes + SLIVER).sum())
    return count, found
