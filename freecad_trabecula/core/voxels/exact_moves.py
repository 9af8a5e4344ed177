# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flips that bring every layer to its count, and neither split the solid nor close a cavity.

First many at once: voxels near the field's level whose flip helps more layers than it hurts. Then one by one: a voxel
added in a layer that lacks one and a voxel removed, on the same line, from one that has one too many, so that the
other two axes see nothing. Where no line serves, the two are chosen freely and the other axes heal what that costs.
"""

from __future__ import annotations

from functools import reduce
from typing import Callable, Iterator, List, Optional, Sequence, Tuple

import numpy as np

from ...errors import ExactnessError
from ..labelling import scipy_ndimage
from ..progress import Progress, silent
from ..streams import mix
from .connectivity import Solid
from .plane_offsets import FORBIDDEN, layer_sums

#: Which of voxels (C,) may be flipped.
Legal = Callable[[np.ndarray], np.ndarray]

_PAIRS = 12  # pairs of layers tried before a line is given up for free places
_FEW = 1024  # best places looked at together
_SORTED = 4 * _FEW  # of the best places, sorted before the others
_LOOPS = 40
_STALLS = 8  # loops without getting nearer after which the search gives up
_FAILURES = 50  # of lines along one axis before the others have their turn
_BATCHES = 60
_BATCH = 20_000  # voxels looked at for one batch, or an eighth of those near the level
_SHARE_NEAR = 0.04  # of all voxels that batches choose from: those nearest to the field's level
_HEAL = 0.05  # field units that a voxel lacking on another axis weighs at a free place


class ExactMoves:
    """A solid on its way to exact counts.

    Parameters
    ----------
    solid : Solid
        One part without closed cavities.
    field : ndarray of shape (P, M, N), float32
    offsets : sequence of 3 arrays
        Of the field: voxels where field + offsets is near 0 are flipped rather than others.
    targets : sequence of 3 int arrays
        Voxels of each layer along z, y, x.
    progress : callable

    Attributes
    ----------
    lacking : list of 3 int64 arrays
        Voxels that each layer along z, y, x has too few (negative: too many).
    flips : int
        Voxels turned over so far.
    """

    def __init__(
        self,
        solid: Solid,
        field: np.ndarray,
        offsets: Sequence[np.ndarray],
        targets: Sequence[np.ndarray],
        progress: Progress = silent,
    ) -> None:
        self.solid, self.field, self.progress = solid, field, progress
        self.offsets = [np.asarray(o, np.float32) for o in offsets]
        self.lacking = [np.asarray(t, np.int64) - s for t, s in zip(targets, layer_sums(solid.voxels))]
        self.flips = 0
        strides = [solid.padded.strides[i] for i in range(3)]
        self._strides = strides
        self._lines = []  # per axis: padded index of each line's place in the first layer of the border
        for axis in range(3):
            places = [
                np.zeros(1, np.int64) if i == axis else np.arange(n) + solid.pad for i, n in enumerate(solid.shape)
            ]
            self._lines.append(reduce(np.add, np.ix_(*[p * s for p, s in zip(places, strides)])).reshape(-1))

    # ------------------------------------------------------------------------------------------------- what is where

    @property
    def missing(self) -> int:
        """Sum over all layers of what they lack or have too many."""
        return int(sum(np.abs(lack).sum() for lack in self.lacking))

    def heights(self, index: np.ndarray) -> np.ndarray:
        """Return field + offsets at voxels (C,), float32."""
        z, y, x = self.solid.places_of(index)
        a, b, c = self.offsets
        return self.field[z, y, x] + (a[z] + (b[y] + c[x]))

    def gains(self, index: np.ndarray, places: Optional[tuple] = None) -> np.ndarray:
        """Return how much nearer to their counts flips of voxels (C,) bring their three layers: -3, -1, 1 or 3."""
        is_void = self.solid.flat[index] == 0
        gain = np.full(len(index), -3, np.int8)
        for lack, place in zip(self.lacking, places or self.solid.places_of(index)):
            gain += np.int8(2) * np.where(is_void, (lack > 0)[place], (lack < 0)[place])
        return gain

    def flip(self, index: np.ndarray) -> None:
        """Turn voxels (C,) over, each once, and count."""
        change = 2 * self.solid.flat[index].astype(np.int64) - 1  # a removed voxel is lacking afterwards
        for lack, place in zip(self.lacking, self.solid.places_of(index)):
            np.add.at(lack, place, change)
        self.solid.flip(index)
        self.flips += len(index)

    def _layer(self, axis: int, number: int) -> Tuple[np.ndarray, np.ndarray]:
        """Return padded indices and heights of a layer's voxels, each raveled."""
        index = self._lines[axis] + (number + self.solid.pad) * self._strides[axis]
        across = [o for i, o in enumerate(self.offsets) if i != axis]
        table = across[0][:, None] + (across[1] + self.offsets[axis][number])
        return index, (np.take(self.field, number, axis) + table).reshape(-1)

    # ------------------------------------------------------------------------------------------------------ all steps

    def run(self) -> np.ndarray:
        """Make every count exact; returns the voxels, (P, M, N) bool.

        Raises
        ------
        ExactnessError
            If some layers could not be brought to their counts; the message says how far off the worst is.
        """
        self.spread()
        best, stalled = self.missing, 0
        for loop in range(_LOOPS):
            self._match_total()
            for axis in range(3):
                self._match_axis(axis, loop)
            if not self.missing:
                return self.solid.voxels.copy()
            best, stalled = (self.missing, 0) if self.missing < best else (best, stalled + 1)
            if stalled == _STALLS:
                break
            if stalled:
                self._stir(loop)
        raise ExactnessError(self._failure())

    def _failure(self) -> str:
        axis = int(np.argmax([np.abs(lack).max() for lack in self.lacking]))
        layer = int(np.argmax(np.abs(self.lacking[axis])))
        layers = sum(int(np.count_nonzero(lack)) for lack in self.lacking)
        return (
            f"every layer must have its count in one part without closed cavities; after {self.flips} flips {layers} "
            f"layers are off by {self.missing} voxels together, layer {layer} along {'ZYX'[axis]} by "
            f"{-int(self.lacking[axis][layer])}; another seed, fewer restrictions or smaller voxels may do"
        )

    # -------------------------------------------------------------------------------------------------- many at once

    def near_level(self, share: float = _SHARE_NEAR) -> np.ndarray:
        """Return voxels whose height is next to 0, about that share of all, nearest first; padded indices."""
        a, b, c = self.offsets
        sample = np.abs(self.field[::3, ::3, ::3] + (a[::3, None, None] + (b[::3, None] + c[::3]))).reshape(-1)
        level = np.sort(sample)[min(int(share * sample.size), sample.size - 1)]
        found, heights = [], []
        for layer in range(len(self.field)):
            height = np.abs(self.field[layer] + (a[layer] + (b[:, None] + c)))
            y, x = np.nonzero(height <= level)
            found.append(self.solid.index_of(np.full(len(y), layer), y, x))
            heights.append(height[y, x])
        order = np.argsort(np.concatenate(heights), kind="stable")
        return np.concatenate(found)[order]

    def spread(self) -> None:
        """Flip batches of voxels near the field's level as long as that brings the layers nearer to their counts."""
        if self.missing <= sum(self.field.shape):
            return
        near = self.near_level()
        places = self.solid.places_of(near)
        for batch in range(_BATCHES):
            before = self.missing
            gain = self.gains(near, places)
            chosen = np.concatenate([near[gain == 3], near[gain == 1]])[: max(_BATCH, len(near) // 8)]
            chosen = chosen[self.solid.flippable(chosen)]
            self._flip_by_need(chosen[self.solid.apart(chosen)])
            self.progress(batch, _BATCHES, "exact moves")
            if self.missing > 0.98 * before:
                return

    def _flip_by_need(self, index: np.ndarray) -> None:
        """Flip those of voxels (C,) that help, few at a time: what a layer needs changes with every flip."""
        for least in (3, 1):
            for first in range(0, len(index), _FEW):
                some = index[first : first + _FEW]
                some = some[self.gains(some) >= least]
                self.flip(some[self.within_need(some)])

    def _stir(self, turn: int) -> None:
        """Flip some voxels near the level at random, others at every turn: new places for moves that found none."""
        near = self.near_level(2 * _SHARE_NEAR)
        order = mix(near.astype(np.uint64), np.array([turn], np.uint64))[:, 0]
        near = near[np.argsort(order, kind="stable")][:_BATCH]
        near = near[self.solid.flippable(near)]
        near = near[self.solid.apart(near)][: max(8, self.missing)]
        self.flip(near)

    def within_need(self, index: np.ndarray) -> np.ndarray:
        """Return which flips (C,), in order of preference, no layer has had enough of before; bool (C,)."""
        good = np.ones(len(index), bool)
        sign = 1 - 2 * self.solid.flat[index].astype(np.int64)
        for lack, place in zip(self.lacking, self.solid.places_of(index)):
            for kind in (1, -1):
                of_kind = np.flatnonzero(sign == kind)
                by_layer = of_kind[np.argsort(place[of_kind], kind="stable")]
                layers = place[by_layer]
                rank = np.arange(len(layers)) - np.searchsorted(layers, layers)
                good[by_layer] &= rank < np.maximum(kind * lack[layers], 1)
        return good

    # ------------------------------------------------------------------------------------------------------ one by one

    def _best(self, index: np.ndarray, cost: np.ndarray, legal: Legal, most: int = 1) -> np.ndarray:
        """Return up to so many legal voxels of least cost among voxels (C,), which may be flipped at once."""
        for order in ascending(cost):
            some = index[order]
            some = some[legal(some)]
            if len(some):
                return some[self.solid.apart(some)][:most] if most > 1 else some[:1]
        return index[:0]

    def _match_total(self) -> None:
        """Add or remove voxels, in the layers that need it most, until the total is right."""
        tries = 0
        while self.lacking[0].sum() != 0 and tries < 4 * len(self.field) + 64:
            tries += 1
            wrong = int(self.lacking[0].sum())
            sign = 1 if wrong > 0 else -1
            neediest = np.argsort(-sign * self.lacking[0], kind="stable")[:8]
            layer = int(neediest[tries % len(neediest) if tries > 64 else 0])
            needed = max(1, min(abs(wrong), sign * int(self.lacking[0][layer])))
            chosen = self._free_places(0, layer, sign, needed)
            self.flip(chosen)
            if not len(chosen):
                self._reach(0, layer)
            self.progress(0, 1, "exact moves")

    def _free_places(self, axis: int, number: int, sign: int, most: int = 1) -> np.ndarray:
        """Return voxels of a layer, up to so many, that are best added (sign 1) or removed (-1)."""
        index, height = self._layer(axis, number)
        right = (self.solid.flat[index] == (sign < 0)) & (height > FORBIDDEN / 2)
        index, height = index[right], height[right]
        places = self.solid.places_of(index)
        need = sum(self.lacking[i][places[i]] for i in range(3) if i != axis)
        cost = -sign * (height + np.float32(_HEAL) * need)
        return self._best(index, cost, self.solid.addable if sign > 0 else self.solid.removable, most)

    def _match_axis(self, axis: int, loop: int) -> None:
        """Move voxels along the lines of one axis until its layers have their counts, or nothing more can be done."""
        lack = self.lacking[axis]
        failures = 0
        while failures <= _FAILURES:
            short, full = np.flatnonzero(lack > 0), np.flatnonzero(lack < 0)
            if not len(short) or not len(full):
                return
            distance = np.abs(short[:, None] - full[None, :]).reshape(-1)
            order = np.argsort(distance, kind="stable")[:_PAIRS]
            pairs = [(int(short[o // len(full)]), int(full[o % len(full)])) for o in order]
            self.progress(0, 1, "exact moves")
            if any(self._along_a_line(axis, i, j) for i, j in pairs):
                continue
            failures += 1
            i, j = pairs[(failures + loop) % len(pairs)]
            if not self._relay(axis, i, j, failures) and not self._freely(axis, i, j):
                return

    def _along_a_line(self, axis: int, short: int, full: int) -> bool:
        """Add in one layer and remove from another on the same lines, as often as both need it; tell if any."""
        add, high = self._layer(axis, short)
        remove, low = self._layer(axis, full)
        lines = np.flatnonzero((self.solid.flat[add] == 0) & (self.solid.flat[remove] == 1) & (high > FORBIDDEN / 2))
        if not len(lines):
            return False
        cost = np.maximum(low[lines], 0) + np.maximum(-high[lines], 0)
        needed = min(int(self.lacking[axis][short]), -int(self.lacking[axis][full]))
        for order in ascending(cost):
            some = lines[order]
            some = some[self.solid.addable(add[some])]
            some = some[self.solid.removable(remove[some])]
            some = some[self.solid.apart(add[some])][: max(needed, 1)]
            if self._pairs(add[some], remove[some]):
                return True
        return False

    def _pairs(self, add: np.ndarray, remove: np.ndarray) -> int:
        """Add voxels (C,) and remove others on the same lines, which are apart; return how many pairs may be."""
        self.flip(add)
        good = self.solid.removable(remove)
        self.flip(remove[good])
        self.flip(add[~good])  # a voxel just added may always go again
        return int(good.sum())

    def _relay(self, axis: int, short: int, full: int, turn: int) -> bool:
        """Add in the short layer and remove from a third on a line, so that the next pair is another one."""
        third = (short + full) // 2 + (-1) ** turn * (turn // 2)
        if not 0 <= third < len(self.lacking[axis]) or third in (short, full):
            return False
        return self._along_a_line_once(axis, short, third)

    def _along_a_line_once(self, axis: int, short: int, other: int) -> bool:
        add, high = self._layer(axis, short)
        remove, _ = self._layer(axis, other)
        lines = np.flatnonzero((self.solid.flat[add] == 0) & (self.solid.flat[remove] == 1) & (high > FORBIDDEN / 2))
        lines = lines[self.solid.addable(add[lines])]
        lines = lines[self.solid.removable(remove[lines])]
        lines = lines[np.argsort(-high[lines], kind="stable")]
        return any(self._pairs(add[line : line + 1], remove[line : line + 1]) for line in lines)

    def _freely(self, axis: int, short: int, full: int) -> bool:
        """Add anywhere in one layer and remove anywhere in the other; tell if it was possible."""
        add = self._free_places(axis, short, 1)
        if not len(add):
            return self._reach(axis, short)
        self.flip(add)
        remove = self._free_places(axis, full, -1)
        if not len(remove) or remove[0] == add[0]:
            self.flip(add)
            return False
        self.flip(remove)
        return True

    def _reach(self, axis: int, number: int) -> bool:
        """Grow a path by faces from the nearest solid to a layer that touches none; tell if it grew."""
        ndimage = scipy_ndimage()

        voxels = self.solid.voxels
        index, height = self._layer(axis, number)
        distance, nearest = ndimage.distance_transform_cdt(~voxels, "taxicab", return_indices=True)
        far = np.take(distance, number, axis).reshape(-1)
        free = (self.solid.flat[index] == 0) & (height > FORBIDDEN / 2)
        if not free.any():
            return False
        goal = int(index[np.argmin(np.where(free, far - np.float32(0.1) * height, np.inf))])
        end = _single(self.solid, goal)
        place = [int(n[tuple(end)]) for n in nearest]
        before = self.flips
        for i in [k for k in range(3) if k != axis] + [axis]:  # across first, then along the axis
            while place[i] != end[i]:
                place[i] += 1 if end[i] > place[i] else -1
                one = self.solid.index_of(*(np.array([n]) for n in place))
                if self.solid.flat[one][0]:
                    continue
                if not self.solid.addable(one)[0]:
                    return self.flips > before
                self.flip(one)
        return self.flips > before


def ascending(cost: np.ndarray) -> Iterator[np.ndarray]:
    """Yield the places of costs (C,) from the least on, few at a time; ties in their order.

    Mostly the first few are enough: the rest is sorted only when it is asked for.
    """
    order = np.arange(0)
    rest = np.arange(len(cost))
    if len(cost) > 4 * _SORTED:
        is_first = cost <= np.partition(cost, _SORTED)[_SORTED]
        first, rest = np.flatnonzero(is_first), np.flatnonzero(~is_first)
        order = first[np.argsort(cost[first], kind="stable")]
        whole = len(order) // _FEW * _FEW
        for start in range(0, whole, _FEW):
            yield order[start : start + _FEW]
        order = order[whole:]
    order = np.concatenate([order, rest[np.argsort(cost[rest], kind="stable")]])
    for start in range(0, len(order), _FEW):
        yield order[start : start + _FEW]


def _single(solid: Solid, index: int) -> List[int]:
    """Return [z, y, x] of one voxel."""
    return [int(p[0]) for p in solid.places_of(np.array([index]))]
