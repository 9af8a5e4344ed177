# SPDX-License-Identifier: LGPL-2.1-or-later
"""No contacts by an edge alone, or by a corner alone: voxels there are added or taken, the cheapest first.

Where two voxels touch by an edge alone the body's surface is not a manifold there, and a print breaks. Flips are those
that neither split the solid nor close a cavity, chosen by how many contacts they undo, how near the field's level they
lie, and whether their layers need them.
"""

from __future__ import annotations

from itertools import product
from typing import Tuple

import numpy as np

from ...errors import ExactnessError
from ..streams import mix
from .connectivity import Solid, closed_cavities
from .exact_moves import ExactMoves

_ROUNDS = 200
_SHAKES = 100  # voxels beside contacts that resist are flipped at random, so often at most
_FILLING = 8  # every so many shakes what still resists is filled, and the cavities that this closes
_COST = 3.0  # contacts undone that one field unit away from the level outweighs
_MOST_COST = 2.0
_NEED = 0.1  # contacts undone that a layer which needs the flip outweighs
_AXES = ((1, 2), (0, 2), (0, 1))  # the two axes across an edge along z, y, x


def _edge_sites(solid: Solid) -> np.ndarray:
    """Return the contacts by an edge alone, (S, 4) padded indices: two of one kind, then the other two."""
    strides = solid.padded.strides
    filled = solid.padded
    found = []
    for u, v in _AXES:
        low = [slice(None)] * 3
        low[u], low[v] = slice(0, -1), slice(0, -1)
        shifted = []
        for du, dv in ((0, 0), (1, 1), (1, 0), (0, 1)):
            here = list(low)
            here[u], here[v] = slice(du, du - 1 or None), slice(dv, dv - 1 or None)
            shifted.append(filled[tuple(here)])
        a, b, c, d = shifted
        places = np.nonzero((a == b) & (c == d) & (a != c))
        base = np.dot(strides, places)
        found.append(base[:, None] + np.array([0, strides[u] + strides[v], strides[u], strides[v]]))
    return np.concatenate(found)


def _edge_sites_near(solid: Solid, index: np.ndarray) -> np.ndarray:
    """Return the contacts by an edge alone among the squares that hold one of the voxels (C,), (S, 4)."""
    strides = solid.padded.strides
    found = []
    for u, v in _AXES:
        corners = np.array([0, strides[u] + strides[v], strides[u], strides[v]])
        found.append((index[:, None, None] - corners[:, None] + corners).reshape(-1, 4))
    return _still_edges(solid, np.concatenate(found))


def _still_edges(solid: Solid, sites: np.ndarray) -> np.ndarray:
    a, b, c, d = solid.flat[sites].T
    return sites[(a == b) & (c == d) & (a != c)]


def _block(solid: Solid) -> np.ndarray:
    """Return the offsets of a 2 x 2 x 2 block, opposite corners in pairs: (8,)."""
    offsets = np.array([np.dot(p, solid.padded.strides) for p in product((0, 1), repeat=3)])
    return offsets[[0, 7, 1, 6, 2, 5, 4, 3]]


def _corner_sites_near(solid: Solid, index: np.ndarray) -> np.ndarray:
    """Return the contacts by a corner alone among the blocks that hold one of the voxels (C,), (S, 8)."""
    block = _block(solid)
    sites = (index[:, None, None] - block[:, None] + block).reshape(-1, 8)
    low = sites.min(1)
    size = solid.flat.size
    sites = sites[(low >= 0) & (sites.max(1) < size)]
    filled = solid.flat[sites]
    total = filled.sum(1)
    pairs = filled.reshape(-1, 4, 2).astype(np.int8).sum(2)
    return sites[((total == 2) & (pairs == 2).any(1)) | ((total == 6) & (pairs == 0).any(1))]


def _corner_sites(solid: Solid) -> np.ndarray:
    """Return the contacts by a corner alone, (S, 8) padded indices of their blocks."""
    filled = solid.padded
    counts = np.zeros(tuple(n - 1 for n in filled.shape), np.uint8)
    for start in product((0, 1), repeat=3):
        counts += filled[tuple(slice(s, s - 1 or None) for s in start)]
    places = np.nonzero((counts == 2) | (counts == 6))
    base = np.dot(solid.padded.strides, places)
    return np.unique(_corner_sites_near(solid, base), axis=0) if len(base) else np.zeros((0, 8), np.int64)


def remove_contacts(moves: ExactMoves, corners: bool = False) -> Tuple[int, int]:
    """Flip voxels until no contact by an edge alone is left, nor, if asked for, one by a corner alone.

    Parameters
    ----------
    moves : ExactMoves
        Its solid is changed, and made to refuse flips that would bring contacts back.
    corners : bool

    Returns
    -------
    edges, corners : int
        How many contacts of each kind there were.

    Raises
    ------
    ExactnessError
        If some contacts could not be removed; the message says how many.
    """
    solid = moves.solid
    edges = _edge_sites(solid)
    corner_sites = _corner_sites(solid) if corners else np.zeros((0, 8), np.int64)
    counts = len(edges), len(corner_sites)
    solid.no_edges = True
    shakes = 0
    for number in range(_ROUNDS):
        sites = np.unique(np.concatenate([edges.reshape(-1), corner_sites.reshape(-1)]))
        if not len(sites):
            solid.no_corners = corners
            return counts
        flipped = _undo_some(moves, sites, corners)
        if not len(flipped):
            shakes += 1
            flipped = _filled(moves, sites) if shakes % _FILLING == 0 else _shake(moves, sites, shakes)
        if not len(flipped) or shakes > _SHAKES:
            break
        edges = _kept_sites(_still_edges(solid, edges), _edge_sites_near(solid, flipped))
        if corners:
            near = _corner_sites_near(solid, np.unique(np.concatenate([flipped, corner_sites.reshape(-1)])))
            corner_sites = np.unique(near, axis=0)
        moves.progress(number, _ROUNDS, "contacts")
    raise ExactnessError(
        f"there must be no contacts by an edge{' or a corner' if corners else ''} alone, but of {sum(counts)} contacts "
        f"{len(edges) + len(corner_sites)} could not be removed without splitting the solid or closing a cavity; "
        "another seed or smaller voxels may do"
    )


def _kept_sites(old: np.ndarray, new: np.ndarray) -> np.ndarray:
    """Return sites of both lists, each once."""
    both = np.concatenate([old, new])
    # the first place and the way to the one across tell which site it is
    across = both[:, 1] - both[:, 0]
    keys = both[:, 0] * (across.max(initial=0) + 1) + across
    return both[np.unique(keys, return_index=True)[1]]


def _undo_some(moves: ExactMoves, index: np.ndarray, corners: bool) -> np.ndarray:
    """Flip, of voxels (C,) at contacts, those that undo contacts and may go together; returns them."""
    solid = moves.solid
    edge_change, corner_change = solid.contact_changes(index, corners)
    gain = -edge_change.astype(np.int64)
    if corners:
        gain = 8 * gain - corner_change  # an edge is never given for corners
    good = (gain > 0) & solid.flippable(index)
    index, gain = index[good], gain[good]
    cost = np.minimum(_COST * np.abs(moves.heights(index)), _MOST_COST)
    score = gain / (8.0 if corners else 1.0) - cost + _NEED * moves.gains(index)
    index = index[np.argsort(-score, kind="stable")]
    index = index[solid.apart(index)]
    moves.flip(index)
    return index


def _shake(moves: ExactMoves, index: np.ndarray, turn: int) -> np.ndarray:
    """Flip some voxels on or beside voxels (C,) at contacts that resist, others at every turn; returns them."""
    solid = moves.solid
    near = np.unique((index[:, None] + np.append(solid.offsets, 0)).reshape(-1))
    near = near[(near > -solid.offsets.min()) & (near < solid.flat.size - solid.offsets.max())]
    near = near[solid.flippable(near)]
    order = mix(near.astype(np.uint64), np.array([turn], np.uint64))[:, 0]
    near = near[np.argsort(order, kind="stable")]
    near = near[solid.apart(near)][: max(1, len(index) // 8)]
    moves.flip(near)
    return near


def _filled(moves: ExactMoves, index: np.ndarray) -> np.ndarray:
    """Make voxels (C,) at contacts solid where they may be, and cavities that this closes; returns what was flipped."""
    solid = moves.solid
    if not solid.may_be_filled:
        return _shake(moves, index, 0)
    index = index[(solid.flat[index] == 0) & solid.may_hold(index)]
    moves.flip(index)
    mask = None if solid.allowed is None else solid.allowed.reshape(solid.padded.shape)[(slice(1, -1),) * 3]
    z, y, x = np.nonzero(closed_cavities(solid.voxels, mask)[0])
    cavities = solid.index_of(z, y, x)
    moves.flip(cavities)
    return np.concatenate([index, cavities])
