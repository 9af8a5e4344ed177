# SPDX-License-Identifier: LGPL-2.1-or-later
"""Least thickness of solid and of void: every voxel lies in a cube of its kind with so many voxels along an edge.

The box cuts the structure: a cube may reach out of it, where it counts as of the kind that is asked for. (Were that
not so, no layer at the box's side could have more voxels than the next one, and few samples are like that.) A solid of
cubes is made from the field, whose layers' counts are raised until what the cubes leave is nearly enough; then it is
flipped voxel by voxel, as far as no voxel loses its last cube. Counts stay exact, or the search says that it gave up.
"""

from __future__ import annotations

from itertools import product
from typing import List, Optional, Sequence, Tuple

import numpy as np

from ...errors import ExactnessError
from ..progress import Progress, silent
from .connectivity import Solid, edge_contact_voxels
from .joining import one_part
from .plane_offsets import FORBIDDEN, layer_sums, newton_offsets, polished, solid_of

_RAISES = 10
_GROWTHS = 30
_NEAR = 0.01  # of the voxels: what may be lacking when the flips begin
_CHUNK = 1 << 22  # voxels of neighbourhoods gathered at once


def in_cubes(solid: np.ndarray, edge: int) -> np.ndarray:
    """Return the voxels that lie in a solid cube with so many voxels along an edge, which may reach out of the box.

    Parameters
    ----------
    solid : ndarray of shape (P, M, N), bool
    edge : int
    """
    whole = _opened(np.pad(solid, edge - 1, constant_values=True), edge)
    return whole[tuple(slice(edge - 1, edge - 1 + n) for n in solid.shape)] & solid


def _opened(solid: np.ndarray, edge: int) -> np.ndarray:
    """Return the voxels that lie in a solid cube inside the array; the last three axes are z, y, x."""
    cubes = solid
    for axis in (-3, -2, -1):
        cubes = _windows(cubes, edge, axis, np.logical_and)
    covered = np.pad(cubes, [(0, 0)] * (solid.ndim - 3) + [(edge - 1, edge - 1)] * 3)
    for axis in (-3, -2, -1):
        covered = _windows(covered, edge, axis, np.logical_or)
    return covered


def _windows(values: np.ndarray, edge: int, axis: int, join: np.ufunc) -> np.ndarray:
    """Return values joined over windows of so many along an axis, which gets shorter by edge - 1."""
    values = np.moveaxis(values, axis, 0)
    count = len(values) - edge + 1
    result = values[:count].copy()
    for step in range(1, edge):
        join(result, values[step : step + count], out=result)
    return np.moveaxis(result, 0, axis)


def thin_voxels(solid: np.ndarray, thickness: int, void: int = 1) -> Tuple[int, int]:
    """Return how many solid voxels are thinner than ``thickness``, and how many void ones narrower than ``void``.

    Parameters
    ----------
    solid : ndarray of shape (P, M, N), bool
    thickness, void : int
        Edges in voxels; 1 asks for nothing.
    """
    thin = np.count_nonzero(solid & ~in_cubes(solid, thickness))
    return int(thin), int(np.count_nonzero(~solid & ~in_cubes(~solid, void)))


class ThickSolid(Solid):
    """A solid that also keeps least thicknesses of solid and void when voxels are flipped.

    Parameters
    ----------
    voxels, mask
        As ``Solid``.
    thickness, void : int
        Edges in voxels of the cubes that every solid voxel, every void voxel lies in.
    """

    may_be_filled = False

    def __init__(self, voxels: np.ndarray, mask: Optional[np.ndarray], thickness: int, void: int) -> None:
        self.thickness, self.void = thickness, void
        self.pad = 2 * max(thickness, void)
        super().__init__(voxels, mask)

    def addable(self, index: np.ndarray) -> np.ndarray:
        """Return which voxels (C,) are void and may become solid; bool (C,)."""
        good = super().addable(index)
        good[good] = self._gains_cube(index[good], 1, self.thickness)
        good[good] = self._leaves_cubes(index[good], 0, self.void)
        return good

    def removable(self, index: np.ndarray) -> np.ndarray:
        """Return which voxels (C,) are solid and may become void; bool (C,)."""
        good = super().removable(index)
        good[good] = self._gains_cube(index[good], 0, self.void)
        good[good] = self._leaves_cubes(index[good], 1, self.thickness)
        return good

    def apart(self, index: np.ndarray) -> np.ndarray:
        """Return which of the voxels (C,), in order of preference, may be flipped at once; bool (C,).

        Cubes reach further than 26 neighbours: voxels must be more than two cubes apart.
        """
        reach = 2 * max(self.thickness, self.void)
        z, y, x = self.places_of(index)
        cells = np.stack([z, y, x], 1) // reach
        # one voxel of a cell, and of every other cell along each axis: the parity of the best voxel's
        _, first = np.unique(cells, axis=0, return_index=True)
        chosen = np.zeros(len(index), bool)
        if len(index):
            parity = cells % 2
            chosen[first] = (parity[first] == parity[0]).all(1)
        return chosen

    def _around(self, index: np.ndarray, reach: int, kind: int) -> np.ndarray:
        """Return which voxels around others (C,) are of a kind, bool (C, 2 reach + 1, 2 reach + 1, 2 reach + 1)."""
        steps = range(-reach, reach + 1)
        offsets = np.array([np.dot(s, self.padded.strides) for s in product(steps, repeat=3)])
        places = index[:, None] + offsets
        near = (self.flat[places] == kind) | ~self._inside[places]
        return near.reshape(len(index), *(len(steps),) * 3)

    def _gains_cube(self, index: np.ndarray, kind: int, edge: int) -> np.ndarray:
        """Return which voxels (C,) lie in a cube of a kind once they are of it; bool (C,)."""
        if edge == 1:
            return np.ones(len(index), bool)
        near = self._around(index, edge - 1, kind)
        near[:, edge - 1, edge - 1, edge - 1] = True
        return _opened(near, edge)[:, edge - 1, edge - 1, edge - 1]

    def _leaves_cubes(self, index: np.ndarray, kind: int, edge: int) -> np.ndarray:
        """Return which voxels (C,) no other of their kind needs for its last cube; bool (C,)."""
        if edge == 1:
            return np.ones(len(index), bool)
        reach = 2 * (edge - 1)
        chunk = max(1, _CHUNK // (2 * reach + 1) ** 3)
        inner = (slice(None),) + (slice(edge - 1, 1 - edge),) * 3
        good = [np.zeros(0, bool)]
        for first in range(0, len(index), chunk):
            near = self._around(index[first : first + chunk], reach, kind)
            near[:, reach, reach, reach] = False
            good.append((_opened(near, edge)[inner] | ~near[inner]).all((1, 2, 3)))
        return np.concatenate(good)


def thick_start(
    field: np.ndarray,
    targets: Sequence[np.ndarray],
    thickness: int,
    void: int,
    contacts: bool = False,
    progress: Progress = silent,
) -> Tuple[np.ndarray, List[np.ndarray]]:
    """Return one part of cubes with nearly the counts wanted, and the field's offsets.

    Parameters
    ----------
    field : ndarray of shape (P, M, N), float32
        ``plane_offsets.FORBIDDEN`` where no solid may be.
    targets : sequence of 3 int arrays
        Voxels of each layer along z, y, x.
    thickness, void : int
    contacts : bool
        Whether voxels may touch by an edge alone.
    progress : callable

    Raises
    ------
    ExactnessError
        If no solid of such cubes was found in the field; the message says how many voxels are too thin.
    """
    mask = field > FORBIDDEN / 2
    room = layer_sums(in_cubes(mask, thickness))
    wanted = [np.asarray(t, float) for t in targets]
    raised = [w.copy() for w in wanted]
    best: Tuple[float, Optional[np.ndarray], list] = (np.inf, None, [])
    offsets = None
    for number in range(_RAISES):
        start = None if number == 0 else offsets
        offsets = newton_offsets(field, raised, start, 0.5 if start is None else 2.0**-3, 2.0**-5, progress)
        whole = [np.rint(r).astype(np.int64) for r in raised]
        offsets = [np.asarray(o, float) for o in polished(field, whole, offsets, 1, progress)]
        solid = _of_cubes(solid_of(field, offsets), mask, thickness, void, contacts)
        lacking = [w - s for w, s in zip(wanted, layer_sums(solid))]
        missing = float(sum(np.abs(lack).sum() for lack in lacking))
        if missing < best[0] and solid.any() and thin_voxels(solid, thickness, void) == (0, 0):
            best = (missing, solid, offsets)
        if missing <= _NEAR * float(wanted[0].sum()):
            break
        raised = [np.clip(r + lack, 0, np.maximum(n, w)) for r, lack, n, w in zip(raised, lacking, room, wanted)]
        progress(number + 1, _RAISES, "thickness")
    if best[1] is None:
        thin, narrow = thin_voxels(solid, thickness, void)
        raise ExactnessError(
            f"solid must be at least {thickness} and void {void} voxels thick; of {np.count_nonzero(solid)} solid ones "
            f"{thin} and of the void {narrow} stayed thinner; longer waves or smaller voxels may do"
        )
    return best[1], best[2]


def _of_cubes(solid: np.ndarray, mask: np.ndarray, thickness: int, void: int, contacts: bool) -> np.ndarray:
    """Return one part without cavities, of cubes, with void of cubes; `contacts` tells if edges alone may touch."""
    low = -((thickness - 1) // 2)
    cube = np.array(list(product(range(low, low + thickness), repeat=3)))
    solid = in_cubes(solid, thickness)
    for _ in range(_GROWTHS):
        solid = one_part(solid, mask, bar=cube)
        count = np.count_nonzero(solid)
        solid |= ~solid & ~in_cubes(~solid, void) & mask
        seeds = solid & ~in_cubes(solid, thickness)
        if not contacts:
            seeds |= edge_contact_voxels(solid)
        z, y, x = (np.nonzero(seeds)[axis][:, None] + cube[:, axis] for axis in range(3))
        inside = (z >= 0) & (y >= 0) & (x >= 0) & (z < solid.shape[0]) & (y < solid.shape[1]) & (x < solid.shape[2])
        z, y, x = z[inside], y[inside], x[inside]
        solid[z, y, x] |= mask[z, y, x]
        if np.count_nonzero(solid) == count:
            break
    return solid
