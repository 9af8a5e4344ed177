# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small boxes: single flips, drawn at random, that bring counts and contacts right while the solid stays one part.

Layers that are full, or nearly so, leave next to no flips that help at once; a way to the counts then leads over
flips that harm first. Those are allowed at random, the fewer the cooler it gets (Kirkpatrick, Gelatt, Vecchi 1983,
doi:10.1126/science.220.4598.671). Energies are whole numbers, so that every machine takes the same way.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Dict, Optional, Sequence

import numpy as np

from ..labelling import scipy_ndimage
from ..progress import Progress, silent
from ..streams import Stream
from .connectivity import (
    STEPS,
    closed_cavities,
    corner_contact_changes,
    corner_contacts,
    edge_contact_changes,
    edge_contacts,
    face_groups,
)  # fmt: skip
from .plane_offsets import layer_sums

_UNIT = 16  # energy of one voxel that a layer lacks or has too many
_CONTACT = 24  # of one contact that is to be avoided
_HEIGHT = 3.0  # of a voxel that lies one field unit on the wrong side
_HIGHEST = 6
#: Height of voxels that are solid in every design (negative: void); they stay what they are once they are that.
FORCED = 1000.0
_KEPT = 64  # energy of such a voxel
_HOT, _COLD = 14.0, 2.5  # first and last temperature of a cycle
_STAGES = 24  # temperatures of a cycle
_FACES = 63
_LOW = (1 << 18) - 1


@lru_cache(maxsize=1)
def _tables() -> tuple:
    """Return by 18-bit code: whether a void voxel may be added, a solid one removed, and the contacts' change + 16."""
    codes = np.arange(1 << 18)
    faces = codes & _FACES
    add = (faces > 0) & (face_groups()[_LOW ^ codes] <= 1)
    remove = (faces != _FACES) & (face_groups() == 1)
    return add.tobytes(), remove.tobytes(), (edge_contact_changes() + 16).astype(np.uint8).tobytes()


class Annealing:
    """One part without closed cavities on its way to exact counts.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
        One part without closed cavities.
    heights : ndarray of shape (P, M, N)
        Of the field over its level: solid is rather where they are high.
    targets : sequence of 3 int arrays
        Voxels of each layer along z, y, x.
    allowed : ndarray of shape (P, M, N), bool, optional
        Where solid may be.
    edges, corners : bool
        Whether contacts by an edge alone, by a corner alone, are to go.

    Attributes
    ----------
    missing, contacts : int
        Sum over all layers of what they lack or have too many; contacts that are to go.
    """

    def __init__(
        self,
        voxels: np.ndarray,
        heights: np.ndarray,
        targets: Sequence[np.ndarray],
        allowed: Optional[np.ndarray] = None,
        edges: bool = True,
        corners: bool = False,
    ) -> None:
        self.allowed, self.edges, self.corners = allowed, edges, corners
        padded = np.pad(voxels, 1)
        self.shape, self.strides = padded.shape, [padded.strides[i] for i in range(3)]
        self.filled = bytearray(padded.tobytes())
        self.offsets = (STEPS @ np.array(self.strides)).tolist()
        flat = padded.reshape(-1).astype(np.int64)
        codes = np.zeros(flat.size, np.int64)
        for bit, offset in enumerate(self.offsets):
            codes |= np.roll(flat, -offset) << bit
        self.codes = codes.tolist()
        # flipping a voxel changes at its neighbour by a step the bit of the opposite step
        opposite = [int(np.flatnonzero((-step == STEPS).all(1))[0]) for step in STEPS]
        self.spread = [(offset, 1 << opposite[bit]) for bit, offset in enumerate(self.offsets)]
        places = np.indices(self.shape).reshape(3, -1) - 1
        self.places = [place.tolist() for place in places]
        self.lacking = [[*(np.asarray(t) - s).tolist()] for t, s in zip(targets, layer_sums(voxels))]
        self.missing = sum(abs(lack) for own in self.lacking for lack in own)
        self.contacts = (edge_contacts(voxels) if edges else 0) + (corner_contacts(voxels) if corners else 0)
        whole = np.rint(np.clip(_HEIGHT * heights, -_HIGHEST, _HIGHEST)).astype(np.int64)
        whole += np.where(np.abs(heights) >= FORCED, np.sign(heights) * _KEPT, 0).astype(np.int64)
        self.heights = np.pad(whole, 1).reshape(-1).tolist()
        free = np.ones(voxels.shape, bool) if allowed is None else allowed
        self.is_free = np.pad(free, 1).tobytes()
        self.cells = np.flatnonzero(np.pad(free, 1)).tolist()
        self._corner_changes: Dict[int, int] = {}

    @property
    def voxels(self) -> np.ndarray:
        """The solid, (P, M, N) bool: a copy."""
        return np.frombuffer(bytes(self.filled), bool).reshape(self.shape)[1:-1, 1:-1, 1:-1].copy()

    @property
    def is_right(self) -> bool:
        """Whether every layer has its count and no contact is left that is to go."""
        return not self.missing and not self.contacts

    def run(self, stream: Stream, cycles: int, length: int, progress: Progress = silent) -> bool:
        """Cool down so many times, in so many tries each, until all is right; return whether it is."""
        if self.is_right:
            return True
        for cycle in range(cycles):
            for stage in range(_STAGES):
                heat = _HOT * (_COLD / _HOT) ** (stage / (_STAGES - 1))
                progress(cycle * _STAGES + stage, cycles * _STAGES, "small box")
                if self._stage(stream, heat, length // _STAGES):
                    return True
        return False

    def _stage(self, stream: Stream, heat: float, tries: int) -> bool:
        """Try flips at one temperature; return whether all is right."""
        drawn = stream.many(3 * tries).reshape(3, -1)
        whole = (drawn * (1 << 20)).astype(np.int64)
        cells = (whole[0] * len(self.cells) >> 20).tolist()
        rooms = np.floor(-heat * np.log((whole[1] + 1) / float(1 << 20))).astype(np.int64).tolist()
        choices = whole[2].tolist()
        sizes, strides, places = [n - 2 for n in self.shape], self.strides, self.places
        filled, is_free = self.filled, self.is_free
        for cell, room, choice in zip(cells, rooms, choices):
            index = self.cells[cell]
            axis = choice & 3
            if axis == 3:
                good = self._flip_one(index, room)
            else:
                place = places[axis][index]
                other = index + ((choice >> 2) % sizes[axis] - place) * strides[axis]
                if filled[other] == filled[index] or not is_free[other]:
                    continue
                removed, added = (index, other) if filled[index] else (other, index)
                good = self._flip_two(axis, removed, added, room)
            if good and self.is_right:
                return True
        return False

    def _flip_one(self, index: int, room: int) -> bool:
        """Flip one voxel if the energy rises by no more than there is room for; tell if it was."""
        sign = -1 if self.filled[index] else 1
        change = sum(1 if sign * own[place[index]] <= 0 else -1 for own, place in zip(self.lacking, self.places))
        energy = _UNIT * change - sign * self.heights[index] + _CONTACT * self._contact_change(index, sign)
        if energy > room or not self._may_flip(index):
            return False
        self.contacts += self._contact_change(index, sign)
        self._flip(index)
        self.missing += change
        for own, place in zip(self.lacking, self.places):
            own[place[index]] -= sign
        return True

    def _flip_two(self, axis: int, removed: int, added: int, room: int) -> bool:
        """Remove a voxel and add another on its line if the energy rises by no more than there is room for."""
        own, place = self.lacking[axis], self.places[axis]
        short, full = own[place[added]], own[place[removed]]
        change = (1 if short <= 0 else -1) + (1 if full >= 0 else -1)
        energy = _UNIT * change + self.heights[removed] - self.heights[added]
        first = self._contact_change(added, 1)
        if energy + _CONTACT * (first - 4) > room or not self._may_flip(added):
            return False
        self._flip(added)
        second = self._contact_change(removed, -1)
        if energy + _CONTACT * (first + second) > room or not self._may_flip(removed):
            self._flip(added)
            return False
        self._flip(removed)
        self.contacts += first + second
        self.missing += change
        own[place[added]] -= 1
        own[place[removed]] += 1
        return True

    def _contact_change(self, index: int, sign: int) -> int:
        code, change = self.codes[index], 0
        if self.edges:
            change = _tables()[2][code & _LOW] - 16
        if self.corners:
            if code not in self._corner_changes:
                self._corner_changes[code] = int(corner_contact_changes(np.array([code], np.int32))[0])
            change += self._corner_changes[code]
        return sign * change

    def _flip(self, index: int) -> None:
        self.filled[index] ^= 1
        codes = self.codes
        for offset, bit in self.spread:
            codes[index + offset] ^= bit

    def _may_flip(self, index: int) -> bool:
        """Return whether a flip keeps one part and closes no cavity, judged by the neighbours, else by the whole."""
        code = self.codes[index] & _LOW
        faces = code & _FACES
        if self.filled[index]:
            if _tables()[1][code]:
                return True
            if not faces or faces == _FACES:
                return False
        else:
            if _tables()[0][code]:
                return True
            if not faces:
                return False
        return self._is_whole_with(index)

    def _is_whole_with(self, index: int) -> bool:
        """Return whether the solid with a voxel flipped is one part without closed cavities."""
        ndimage = scipy_ndimage()

        self.filled[index] ^= 1
        padded = np.frombuffer(self.filled, np.uint8).reshape(self.shape)
        if self.filled[index]:
            if self.allowed is None:
                whole = ndimage.label(padded == 0)[1] == 1
            else:
                whole = len(closed_cavities(padded[1:-1, 1:-1, 1:-1].view(bool), self.allowed)[1]) == 1
        else:
            whole = ndimage.label(padded)[1] == 1
        del padded
        self.filled[index] ^= 1
        return whole
