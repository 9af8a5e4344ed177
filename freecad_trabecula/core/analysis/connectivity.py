# SPDX-License-Identifier: LGPL-2.1-or-later
"""Topology of voxels: Euler number, connectivity density, parts, closed cavities.

Solid voxels hang together by faces, edges and corners (26 neighbours), void voxels by faces only (6): the pair that
keeps Euler's relation, parts - handles + cavities = Euler number (Odgaard and Gundersen, Bone 14 (1993) 173, DOI
10.1016/8756-3282(93)90245-6).
"""

from __future__ import annotations

from typing import List, NamedTuple, Tuple

import numpy as np

from ..labelling import scipy_ndimage
from ..progress import Progress, silent

_LAYERS = 16  # of voxels at once


class Connectivity(NamedTuple):
    """Topology of a body in a box.

    Attributes
    ----------
    euler : int
        Euler number of the solid voxels as a closed body: parts - handles + cavities.
    parts : int
        Pieces of solid, 26 neighbours.
    cavities : int
        Pieces of void, 6 neighbours, that touch no face of the box.
    euler_in_bulk : float
        What the body adds to the Euler number of the endless structure it was cut out of: faces of the box count half,
        edges a quarter, corners an eighth, since neighbouring boxes share them.
    connections : float
        1 - euler_in_bulk (Conn): struts that could be cut before the structure falls apart.
    """

    euler: int
    parts: int
    cavities: int
    euler_in_bulk: float
    connections: float


def euler_number(solid: np.ndarray, progress: Progress = silent) -> int:
    """Return the Euler number of voxels [z, y, x]: corners - edges + faces - voxels of their union, each once.

    Planes (M, N) and rows (N,) have Euler numbers too, those of the union of their pixels and segments.
    """
    solid = np.asarray(solid, bool)
    if solid.ndim < 3:
        return _cells(np.pad(solid, 1))
    total = 0
    for first in range(0, len(solid) + 1, _LAYERS):
        progress(first, len(solid) + 1, "Euler number")
        # planes between layers first - 1 .. end - 1, and the layers below all of them but the first
        low, end = first - 1, min(first + _LAYERS, len(solid) + 1)
        block = np.zeros((end - low, *solid.shape[1:]), bool)
        stretch = slice(max(low, 0), min(end, len(solid)))
        block[stretch.start - low : stretch.stop - low] = solid[stretch]
        total += _cells(np.pad(block, ((0, 0), (1, 1), (1, 1))), open_end=True)
    return total


def _cells(padded: np.ndarray, open_end: bool = False) -> int:
    """Alternating sum of the cells of all dimensions; with ``open_end`` those inside the first layer are left out.

    A cell of lower dimension belongs to the union if any voxel at it is solid: merged pairwise, direction by direction.
    """
    merged: List[Tuple[Tuple[bool, ...], np.ndarray]] = [((), padded)]
    for direction in range(padded.ndim):
        skip = 1 if open_end and direction == 0 else 0
        ahead = (slice(None),) * direction
        merged = [
            pair
            for thick, cells in merged
            for pair in (
                ((*thick, True), cells[(*ahead, slice(skip, None))]),
                ((*thick, False), cells[(*ahead, slice(1, None))] | cells[(*ahead, slice(None, -1))]),
            )
        ]
    return sum((-1) ** sum(thick) * int(np.count_nonzero(cells)) for thick, cells in merged)


def euler_in_bulk(solid: np.ndarray, euler: int) -> float:
    """Return the Euler number less the shares of what lies in the box's faces (1/2), plus edges (1/4), less corners.

    Source: inclusion and exclusion over boxes that tile space; the edge-of-volume correction of Odgaard and Gundersen.
    """
    ends = (0, -1)
    planes = sum(euler_number(np.take(solid, end, axis)) for axis in range(3) for end in ends)
    rows = sum(
        euler_number(np.take(np.take(solid, end, axis), other, side))
        for axis in range(3)
        for end in ends
        for side in range(2)
        for other in ends
    )
    corners = int(np.count_nonzero(solid[np.ix_(*(ends,) * 3)]))
    # each edge of the box was met from both of its faces
    return euler - planes / 2 + rows / 2 / 4 - corners / 8


def parts_and_cavities(solid: np.ndarray) -> Tuple[int, int]:
    """Return the number of parts (26 neighbours) and of closed cavities (6 neighbours, no face of the box touched).

    Raises
    ------
    DependencyError
        If scipy is missing.
    """
    ndimage = scipy_ndimage()
    parts = ndimage.label(solid, np.ones((3, 3, 3), bool))[1]
    labels, pieces = ndimage.label(~solid)
    border = np.zeros(pieces + 1, bool)
    border[0] = True
    for axis in range(3):
        for end in (0, -1):
            border[np.take(labels, end, axis)] = True
    return int(parts), int(np.count_nonzero(~border))


def connectivity(solid: np.ndarray, progress: Progress = silent) -> Connectivity:
    """Return the topology of voxels, ndarray of shape (P, M, N), bool, [z, y, x].

    Raises
    ------
    DependencyError
        If scipy is missing.
    """
    euler = euler_number(solid, progress)
    parts, cavities = parts_and_cavities(solid)
    bulk = euler_in_bulk(solid, euler)
    return Connectivity(euler, parts, cavities, bulk, 1 - bulk)
