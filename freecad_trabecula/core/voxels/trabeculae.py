# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of trabeculae per layer as further targets (thesis ch. 9), along one, two or three axes.

A trabecula of a layer is a part of it whose voxels hang together by sides (4 neighbours). Single flips cut one in two,
join two, put one where there was none or take one away; what a flip does to the number along each axis is known from
its eight neighbours in the plane, and, where they fall into two groups, from whether these are one part elsewhere: two
groups of solid are joined if their parts differ; a voxel between two groups of void cuts if the void is one part.
"""

from __future__ import annotations

from typing import List, Mapping, Optional, Sequence, Tuple

import numpy as np

from ...errors import ParameterError
from ..labelling import scipy_ndimage
from ..triples import triple
from .connectivity import EDGES, FACES, Solid, planar_groups
from .exact_moves import ExactMoves
from .targets import Targets

_ROUNDS = 60
_SHARE = 0.8  # of all voxels that are looked at: those nearest to the field's level
_SPECK = 0.25  # field units by which a new speck is dearer than a cut
_NEED = 0.05  # field units that a layer lacking a voxel is worth
_FREE = 0.9  # gain that a flip loses which may change a number that is free
_UNCERTAIN = 9  # stands for a change that is not known or spoils what is


def trabecula_counts(voxels: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the number of 4-connected parts in each layer along x, y, z: int64 arrays (N,), (M,), (P,).

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    """
    return triple(_counts_along(voxels, axis) for axis in (2, 1, 0))


def wanted_trabeculae(targets: Targets, axes: str) -> List[Optional[np.ndarray]]:
    """Return the numbers wanted along z, y, x, None where they are free: the targets' own, or else the sample's.

    Parameters
    ----------
    targets : Targets
    axes : str
        ``off``, or the axes whose numbers are targets: ``z``, ``xy``, ``xyz`` ...

    Raises
    ------
    ParameterError
        If the targets have neither numbers of trabeculae nor a sample to count them in.
    """
    if axes == "off":
        return [None, None, None]
    counts = targets.trabeculae
    if counts is None:
        if targets.sample is None:
            raise ParameterError(
                f"numbers of trabeculae along {axes.upper()} need a sample, or targets that hold them; got neither"
            )
        counts = trabecula_counts(targets.sample)
    return [np.asarray(count, np.int64) if axis in axes else None for axis, count in zip("zyx", counts[::-1])]


def mean_deviation(counts: np.ndarray, wanted: np.ndarray) -> float:
    """Return the mean over layers of |count - wanted| / wanted (1 where none is wanted)."""
    return float(np.mean(np.abs(counts - wanted) / np.maximum(wanted, 1)))


def _plane_structure(axis: int, corners: bool) -> np.ndarray:
    """Return which of 3 x 3 x 3 neighbours are one part with the middle in planes across an axis."""
    steps = FACES + (EDGES if corners else ())
    structure = np.zeros((3, 3, 3), bool)
    structure[1, 1, 1] = True
    for step in steps:
        if step[axis] == 0:
            structure[tuple(1 + s for s in step)] = True
    return structure


def _counts_along(voxels: np.ndarray, axis: int) -> np.ndarray:
    ndimage = scipy_ndimage()

    layers = np.ascontiguousarray(np.moveaxis(voxels, axis, 0))
    labels, _ = ndimage.label(layers, _plane_structure(0, False))
    # labels are given in the order of the layers
    highest = np.maximum.accumulate(labels.reshape(len(labels), -1).max(1))
    return np.diff(highest, prepend=0).astype(np.int64)


class _Planes:
    """Parts of solid and of void in all layers along one axis, and what flips would do to their number."""

    def __init__(self, solid: Solid, axis: int) -> None:
        ndimage = scipy_ndimage()

        filled = solid.padded.view(bool)
        self.axis = axis
        self._solid = ndimage.label(filled, _plane_structure(axis, False))[0].reshape(-1)
        self._void = ndimage.label(~filled, _plane_structure(axis, True))[0].reshape(-1)
        offsets = solid.offsets
        self._sides = offsets[:6][[face[axis] == 0 for face in FACES]]
        self._ring = np.append(self._sides, offsets[6:18][[edge[axis] == 0 for edge in EDGES]])

    def changes(self, index: np.ndarray, is_solid: np.ndarray, code: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
        """Return how flips (C,) change the number of parts, int8 (C,), and a label that each join uses up, (C,)."""
        groups = planar_groups()[self.axis][code]
        sign = np.where(is_solid, np.int8(-1), np.int8(1))
        change = np.full(len(index), _UNCERTAIN, np.int8)
        change[groups == 1] = 0
        change[groups == 0] = sign[groups == 0]
        used = np.zeros(len(index), np.int64)
        two = np.flatnonzero((groups == 2) & ~is_solid)
        low, high = self._ends(self._solid, index[two], self._sides)
        change[two[low != high]] = -1
        used[two] = high
        two = np.flatnonzero((groups == 2) & is_solid)
        low, high = self._ends(self._void, index[two], self._ring)
        change[two[low == high]] = 1
        return change, used

    @staticmethod
    def _ends(labels: np.ndarray, index: np.ndarray, steps: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
        """Return the lowest and the highest label, but 0, next to voxels (C,)."""
        near = labels[index[:, None] + steps]
        return np.where(near == 0, np.iinfo(near.dtype).max, near).min(1, initial=2**31 - 1), near.max(1, initial=0)


def match_trabeculae(moves: ExactMoves, wanted: Sequence[Optional[np.ndarray]]) -> List[float]:
    """Flip voxels until the layers have as many trabeculae as wanted, or no flip brings them nearer.

    Parameters
    ----------
    moves : ExactMoves
        Its solid is changed, and made to keep the numbers along these axes from then on.
    wanted : sequence of 3 int arrays or None, along z, y, x
        None: along this axis the numbers are free.

    Returns
    -------
    list of 3 floats
        Mean deviation along z, y, x, relative; nan where the numbers are free.
    """
    solid = moves.solid
    axes = tuple(axis for axis in range(3) if wanted[axis] is not None)
    solid.kept_planes = ()
    near = moves.near_level(_SHARE)
    best = None
    for number in range(_ROUNDS):
        voxels = solid.voxels
        short = {a: goal - _counts_along(voxels, a) for a, goal in enumerate(wanted) if goal is not None}
        error = sum(float((own**2).sum()) for own in short.values())
        if error == 0 or (best is not None and error > best - 1e-3):
            break
        best = error
        chosen = _chosen(moves, near, short, axes)
        if not len(chosen):
            break
        moves.flip(chosen)
        moves.progress(number, _ROUNDS, "trabeculae")
    solid.kept_planes = axes
    voxels = solid.voxels
    return [float("nan") if w is None else mean_deviation(_counts_along(voxels, a), w) for a, w in enumerate(wanted)]


def _chosen(moves: ExactMoves, near: np.ndarray, short: Mapping[int, np.ndarray], axes: Tuple[int, ...]) -> np.ndarray:
    """Return flips, of voxels (C,), that may go together and bring the numbers nearer to what is wanted."""
    solid = moves.solid
    code = solid.codes(near)
    odd = np.zeros(len(near), bool)
    for axis in axes:
        odd |= planar_groups()[axis][code] != 1
    near, code = near[odd], code[odd]
    legal = solid.flippable(near)
    near, code = near[legal], code[legal]
    is_solid = solid.flat[near] == 1
    places = solid.places_of(near)
    gain = np.zeros(len(near))
    changes, labels = [], []
    for axis in axes:
        change, used = _Planes(solid, axis).changes(near, is_solid, code)
        lack = short[axis][np.minimum(places[axis], len(short[axis]) - 1)]
        gain += np.where(change == _UNCERTAIN, -1e9, 2.0 * change * lack - change.astype(float) ** 2)
        changes.append(change)
        labels.append(used)
    for axis in set(range(3)) - set(axes):
        gain -= np.where(planar_groups()[axis][code] == 1, 0.0, _FREE)
    specks = (~is_solid & (planar_groups()[list(axes)][:, code] == 0).any(0)).astype(float)
    cost = np.abs(moves.heights(near)) + _SPECK * specks - _NEED * moves.gains(near)
    order = np.flatnonzero(gain > 0)
    order = order[np.lexsort((cost[order], -gain[order]))]
    order = order[solid.apart(near[order])]
    keep = np.ones(len(order), bool)
    for axis, change, used in zip(axes, changes, labels):
        keep &= _within(places[axis][order], change[order], short[axis]) & _first_uses(used[order])
    return near[order[keep]]


def _within(layers: np.ndarray, change: np.ndarray, short: np.ndarray) -> np.ndarray:
    """Return which flips (C,), in order of preference, their layer still needs; those that change nothing all are."""
    good = np.ones(len(layers), bool)
    changing = np.flatnonzero(change != 0)
    by_layer = changing[np.argsort(layers[changing], kind="stable")]
    rank = np.arange(len(by_layer)) - np.searchsorted(layers[by_layer], layers[by_layer])
    good[by_layer] = rank < np.abs(short[layers[by_layer]])
    return good


def _first_uses(labels: np.ndarray) -> np.ndarray:
    """Return which flips (C,) are the first to use up their part; 0 uses none."""
    good = labels == 0
    good[np.unique(labels, return_index=True)[1]] = True
    return good
