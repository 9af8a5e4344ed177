# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hangs together: parts, closed cavities, contacts by an edge or a corner, and flips that change none of it.

Solid and void both hang together by faces (6 neighbours); outside the box is void, and so is what lies outside a mask.
Whether a flip keeps the number of parts is read from the 18 neighbours (faces and edges) of its voxel: the set face
neighbours that edge neighbours join are one group, and one group stays one part whether the voxel is there or not.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from typing import Optional

import numpy as np

from ..labelling import scipy_ndimage

#: Steps (z, y, x) to the neighbours by a face, an edge, a corner: bits 0-5, 6-17 and 18-25 of a neighbour code.
FACES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
EDGES = tuple(s for s in product((-1, 0, 1), repeat=3) if sum(map(abs, s)) == 2)
CORNERS = tuple(s for s in product((-1, 0, 1), repeat=3) if sum(map(abs, s)) == 3)
STEPS = np.array(FACES + EDGES + CORNERS)
_CODES = 1 << (len(FACES) + len(EDGES))
_FACE_BITS = (1 << len(FACES)) - 1
_LOW_BITS = _CODES - 1


def _faces_of(edge: tuple) -> tuple:
    """Return the two faces, as bits, that an edge neighbour touches."""
    return tuple(i for i, face in enumerate(FACES) if sum(a * b for a, b in zip(face, edge)) == 1)


def _bits(codes: np.ndarray) -> list:
    """Return the 18 bits of codes (C,) as bool arrays (C,)."""
    return [(codes >> bit) & 1 == 1 for bit in range(len(FACES) + len(EDGES))]


@lru_cache(maxsize=1)
def face_groups() -> np.ndarray:
    """Return the number of groups of set face neighbours joined by set edge neighbours, (2^18,) uint8, by code."""
    codes = np.arange(_CODES)
    is_set = _bits(codes)
    faces = (codes & _FACE_BITS).astype(np.uint8)
    # the group of the lowest set face not yet counted, spread over the twelve edges until it stops growing
    left, groups = faces.copy(), np.zeros(_CODES, np.uint8)
    joined = [((1 << a) | (1 << b), is_set[6 + e]) for e, (a, b) in enumerate(map(_faces_of, EDGES))]
    masks = [(np.uint8(pair), active & ((faces & pair) == pair)) for pair, active in joined]
    while left.any():
        group = left & (~left + np.uint8(1))
        groups += group > 0
        before = None
        while before is None or not np.array_equal(before, group):
            before = group.copy()
            for pair, active in masks:
                group |= np.where(active & ((group & pair) > 0), pair, np.uint8(0))
        left &= ~group
    return groups


@lru_cache(maxsize=1)
def edge_contact_changes() -> np.ndarray:
    """Return by how much the contacts by an edge alone change when the voxel is added, (2^18,) int8, by code."""
    is_set = _bits(np.arange(_CODES))
    change = np.zeros(_CODES, np.int8)
    for e, (a, b) in enumerate(map(_faces_of, EDGES)):
        change += (is_set[6 + e] & ~is_set[a] & ~is_set[b]).astype(np.int8)
        change -= (~is_set[6 + e] & is_set[a] & is_set[b]).astype(np.int8)
    return change


@lru_cache(maxsize=1)
def planar_groups() -> np.ndarray:
    """Return, for the plane across z, y, x, the groups of set face neighbours joined by its edge neighbours.

    ndarray of shape (3, 2^18), uint8, by code. Where it is 1, the flip keeps the plane's number of parts.
    """
    is_set = _bits(np.arange(_CODES))
    groups = np.zeros((3, _CODES), np.uint8)
    for axis in range(3):
        faces = [i for i, face in enumerate(FACES) if face[axis] == 0]
        links = np.zeros(_CODES, np.uint8)
        for e, edge in enumerate(EDGES):
            if edge[axis] == 0:
                a, b = _faces_of(edge)
                links += is_set[a] & is_set[6 + e] & is_set[b]
        # four faces and four links are a ring: as many groups as missing links, one if it is closed
        groups[axis] = sum(is_set[i].astype(np.uint8) for i in faces) - links + (links == 4)
    return groups


def corner_contact_changes(codes: np.ndarray) -> np.ndarray:
    """Return by how much the contacts by a corner alone change when the voxels are added; (C,) int8.

    Parameters
    ----------
    codes : ndarray of shape (C,), int32
        Neighbour codes with all 26 bits.
    """
    change = np.zeros(codes.shape, np.int8)
    for whole, far, pairs in _octants():
        octant = codes & whole
        change += (octant == far).astype(np.int8) - (octant == whole ^ far).astype(np.int8)
        for pair in pairs:
            change += (octant == whole ^ pair).astype(np.int8) - (octant == pair).astype(np.int8)
    return change


@lru_cache(maxsize=1)
def _octants() -> tuple:
    """Return for the 8 blocks of 2 x 2 x 2 at a voxel the bits of its 7 others, of the opposite one, of 3 pairs."""
    bits = {tuple(step): 1 << bit for bit, step in enumerate(STEPS.tolist())}
    found = []
    for corner in CORNERS:
        cells = [tuple(c if keep else 0 for c, keep in zip(corner, kept)) for kept in product((False, True), repeat=3)]
        others = [cell for cell in cells if any(cell)]
        opposite = {cell: tuple(c - a for c, a in zip(corner, cell)) for cell in others if cell != corner}
        pairs = {bits[cell] | bits[other] for cell, other in opposite.items()}
        found.append((sum(bits[cell] for cell in others), bits[corner], tuple(sorted(pairs))))
    return tuple(found)


def parts(solid: np.ndarray) -> tuple:
    """Return the 6-connected parts of a solid.

    Parameters
    ----------
    solid : ndarray of shape (P, M, N), bool

    Returns
    -------
    labels : ndarray of shape (P, M, N), int32
        0 is void, the parts are 1, 2, ... in the order of their first voxels.
    sizes : ndarray of shape (parts + 1,), int64
        Voxels of each label; ``sizes[0]`` is 0.
    """
    ndimage = scipy_ndimage()

    labels, count = ndimage.label(solid)
    return labels, _sizes(labels, count)


def _sizes(labels: np.ndarray, count: int) -> np.ndarray:
    """Return how many voxels have each label 0 .. count, (count + 1,) int64, with 0 for label 0."""
    sizes = np.zeros(count + 1, np.int64)
    for layer in labels:
        sizes += np.bincount(layer.reshape(-1), minlength=count + 1)
    sizes[0] = 0
    return sizes


def closed_cavities(solid: np.ndarray, mask: Optional[np.ndarray] = None) -> tuple:
    """Return the void that no way by faces leads out of, as ``parts`` returns the solid.

    Parameters
    ----------
    solid : ndarray of shape (P, M, N), bool
    mask : ndarray of shape (P, M, N), bool, optional
        Where solid may be; void that touches the outside of the mask or of the box is open.
    """
    ndimage = scipy_ndimage()

    labels, count = ndimage.label(~solid)
    is_open = np.zeros(count + 1, bool)
    is_open[0] = True
    for axis in range(3):
        for end in (0, -1):
            is_open[np.unique(np.take(labels, end, axis))] = True
    if mask is not None:
        is_open[np.unique(labels[~mask])] = True
    if is_open.all():
        return np.zeros_like(labels), np.zeros(1, np.int64)
    numbers = np.cumsum(~is_open) * ~is_open
    numbers = numbers.astype(np.int32)
    for layer in labels:
        layer[:] = numbers[layer]
    return labels, _sizes(labels, int(numbers.max()))


def edge_contacts(solid: np.ndarray) -> int:
    """Return how many edges of the grid have solid on two opposite sides only: contacts by an edge alone."""
    count = 0
    for axis in range(3):
        s = np.moveaxis(solid, axis, 0)
        a, b, c, d = s[:, :-1, :-1], s[:, 1:, 1:], s[:, :-1, 1:], s[:, 1:, :-1]
        count += int(np.count_nonzero((a == b) & (c == d) & (a != c)))
    return count


def edge_contact_voxels(solid: np.ndarray) -> np.ndarray:
    """Return the four voxels around every contact by an edge alone, bool like ``solid``."""
    found = np.zeros(solid.shape, bool)
    for axis in range(3):
        s, f = np.moveaxis(solid, axis, 0), np.moveaxis(found, axis, 0)
        a, b, c, d = s[:, :-1, :-1], s[:, 1:, 1:], s[:, :-1, 1:], s[:, 1:, :-1]
        touch = (a == b) & (c == d) & (a != c)
        for part in (f[:, :-1, :-1], f[:, 1:, 1:], f[:, :-1, 1:], f[:, 1:, :-1]):
            part |= touch
    return found


def corner_contacts(solid: np.ndarray) -> int:
    """Return how many 2 x 2 x 2 blocks have two opposite corners alone of their kind (solid or void)."""
    size = tuple(n - 1 for n in solid.shape)
    cells = {
        s: solid[s[0] : s[0] + size[0], s[1] : s[1] + size[1], s[2] : s[2] + size[2]] for s in product((0, 1), repeat=3)
    }
    total = sum(cell.astype(np.int8) for cell in cells.values())
    count = 0
    for near in ((0, 0, 0), (0, 0, 1), (0, 1, 0), (1, 0, 0)):
        a, b = cells[near], cells[tuple(1 - i for i in near)]
        count += int(np.count_nonzero((total == 2) & a & b)) + int(np.count_nonzero((total == 6) & ~a & ~b))
    return count


class Solid:
    """A solid whose voxels are flipped one by one or many at once, without splitting it or closing a cavity.

    Voxels are named by their index in the padded, raveled array (``index_of``); each may be flipped if it is
    ``addable`` or ``removable``, and any number at once whose neighbourhoods (26) do not hold one another.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    mask : ndarray of shape (P, M, N), bool, optional
        Where solid may be.
    no_edges, no_corners : bool
        Whether flips may not raise the number of contacts by an edge alone, by a corner alone.

    Attributes
    ----------
    kept_planes : tuple of int
        Axes (0 z, 1 y, 2 x) along whose layers flips may not change the number of parts.
    """

    #: Layers of void around the box.
    pad = 1
    #: Whether any void voxel beside the solid may be filled, whatever else the solid must keep.
    may_be_filled = True

    def __init__(
        self, voxels: np.ndarray, mask: Optional[np.ndarray] = None, no_edges: bool = False, no_corners: bool = False
    ) -> None:
        self.shape = voxels.shape
        self.padded = np.pad(voxels, self.pad).view(np.uint8)
        self.flat = self.padded.reshape(-1)
        self.allowed = None if mask is None else np.pad(mask, self.pad).reshape(-1)
        self.no_edges, self.no_corners = no_edges, no_corners
        self.kept_planes: tuple = ()
        rows, columns = self.padded.shape[1:]
        self._strides = (rows * columns, columns, 1)
        self.offsets = STEPS @ np.array(self._strides)
        inside = np.zeros(self.padded.shape, bool)
        inside[self._box] = True
        self._inside = inside.reshape(-1)
        self._preference: Optional[np.ndarray] = None  # 0 but for the voxels that ``apart`` compares

    @property
    def voxels(self) -> np.ndarray:
        """The solid, (P, M, N) bool: a view."""
        return self.padded[self._box].view(bool)

    @property
    def _box(self) -> tuple:
        return (slice(self.pad, -self.pad),) * 3

    def index_of(self, z: np.ndarray, y: np.ndarray, x: np.ndarray) -> np.ndarray:
        """Return the indices of voxels (z, y, x), which may lie one voxel outside the box."""
        a, b, c = self._strides
        return (z + self.pad) * a + (y + self.pad) * b + (x + self.pad) * c

    def places_of(self, index: np.ndarray) -> tuple:
        """Return (z, y, x) of indices: three int arrays like them."""
        z, y, x = np.unravel_index(index, self.padded.shape)
        return z - self.pad, y - self.pad, x - self.pad

    def codes(self, index: np.ndarray, corners: bool = False) -> np.ndarray:
        """Return the neighbour codes of voxels, int32 (C,): bit i tells whether neighbour ``STEPS[i]`` is solid."""
        code = np.zeros(len(index), np.int32)
        for bit in range(26 if corners else 18):
            code |= self.flat[index + self.offsets[bit]].astype(np.int32) << bit
        return code

    def contact_changes(self, index: np.ndarray, corners: bool = True) -> tuple:
        """Return how the contacts by an edge, and by a corner, change when voxels (C,) are flipped: two int8 (C,).

        Those by a corner are 0 where they are not asked for, which takes half the time.
        """
        code = self.codes(index, corners)
        sign = 1 - 2 * self.flat[index].astype(np.int8)
        by_corner = sign * corner_contact_changes(code) if corners else np.zeros_like(sign)
        return sign * edge_contact_changes()[code & _LOW_BITS], by_corner

    def _rules_kept(self, code: np.ndarray, sign: int) -> np.ndarray:
        """Return which flips keep contacts and planes as they must be; sign is 1 for adding, -1 for removing."""
        kept = np.ones(code.shape, bool)
        if self.no_edges:
            kept &= sign * edge_contact_changes()[code & _LOW_BITS] <= 0
        if self.no_corners:
            kept &= sign * corner_contact_changes(code) <= 0
        for axis in self.kept_planes:
            kept &= planar_groups()[axis][code & _LOW_BITS] == 1
        return kept

    def addable(self, index: np.ndarray) -> np.ndarray:
        """Return which voxels (C,) are void and may become solid; bool (C,)."""
        code = self.codes(index, self.no_corners)
        low = code & _LOW_BITS
        good = (self.flat[index] == 0) & ((low & _FACE_BITS) > 0) & (face_groups()[_LOW_BITS ^ low] <= 1)
        return good & self.may_hold(index) & self._rules_kept(code, 1)

    def may_hold(self, index: np.ndarray) -> np.ndarray:
        """Return which voxels (C,) are in the box and the mask; bool (C,)."""
        return self._inside[index] if self.allowed is None else self.allowed[index]

    def removable(self, index: np.ndarray) -> np.ndarray:
        """Return which voxels (C,) are solid and may become void; bool (C,)."""
        code = self.codes(index, self.no_corners)
        low = code & _LOW_BITS
        good = (self.flat[index] == 1) & ((low & _FACE_BITS) != _FACE_BITS) & (face_groups()[low] == 1)
        return good & self._rules_kept(code, -1)

    def flippable(self, index: np.ndarray) -> np.ndarray:
        """Return which voxels (C,) may be flipped, whatever they are; bool (C,)."""
        is_solid = self.flat[index] == 1
        good = np.zeros(len(index), bool)
        good[is_solid] = self.removable(index[is_solid])
        good[~is_solid] = self.addable(index[~is_solid])
        return good

    def flip(self, index: np.ndarray) -> None:
        """Turn voxels over: one index or an array of them, each once."""
        self.flat[index] ^= 1

    def apart(self, index: np.ndarray) -> np.ndarray:
        """Return which of the voxels (C,), in order of preference, may be flipped at once; bool (C,).

        A voxel is chosen if no better one lies among its 26 neighbours, so that no flip sees another.
        """
        if self._preference is None:
            self._preference = np.zeros(self.flat.size, np.int32)
        order = np.argsort(index)  # neighbours in space are near in memory too
        places, worth = index[order], np.int32(len(index)) - order.astype(np.int32)
        self._preference[places] = worth
        for some in (self.offsets[:6], self.offsets[6:18], self.offsets[18:]):  # who is beaten is looked at no more
            best = np.ones(len(places), bool)
            for offset in some:
                best &= self._preference[places + offset] < worth
            places, worth, order = places[best], worth[best], order[best]
        self._preference[index] = 0
        chosen = np.zeros(len(index), bool)
        chosen[order] = True
        return chosen
