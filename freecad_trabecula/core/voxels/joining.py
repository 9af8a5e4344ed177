# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part without closed cavities: large islands are joined by bars, small ones dropped, cavities filled.

What that adds and takes is made good by the field's offsets when it is much, by exact moves when it is little. Where
waves are so short that small islands are many, what hangs together is looked for below the level: islands that the
lower level will join are kept, and those that it will not are dropped with the shell that would come up around them.
"""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

import numpy as np

from ...errors import ExactnessError
from ..labelling import scipy_ndimage
from ..progress import Progress, silent
from .connectivity import FACES, closed_cavities, parts
from .plane_offsets import FORBIDDEN, newton_offsets, polished, solid_of

#: Islands of at least this share of the voxels, but of 8 to 150 of them, are joined; smaller ones are dropped.
LEAST_ISLAND = 5e-4
_SMALLEST_ISLAND, _LARGEST_LEAST = 8, 150
#: Changes up to this share of the voxels are left to exact moves; more than that goes through the field again.
_LITTLE = 0.01
#: Small islands of more than this share of the voxels are judged below the level; what is left then is little.
_MANY, _LITTLE_OF_MANY = 0.05, 0.04
_DEEPER = 1.5  # voxels that the lower level adds for each one dropped: some of them are islands again
_ROUNDS = 5
_LIFT = np.float32(4.0)  # above all that a field spans
_FIRST_MARGIN = 8  # voxels around an island that are searched first for its neighbour
_BAR = np.array(((0, 0, 0), *FACES))


def joined_solid(
    field: np.ndarray, targets: Sequence[np.ndarray], progress: Progress = silent
) -> Tuple[np.ndarray, List[np.ndarray]]:
    """Return one part without closed cavities whose counts are nearly the targets, and the field's offsets.

    Parameters
    ----------
    field : ndarray of shape (P, M, N), float32
        ``plane_offsets.FORBIDDEN`` where no solid may be. Changed where islands are dropped and bars drawn.
    targets : sequence of 3 int arrays
        Voxels of each layer along z, y, x.
    progress : callable

    Raises
    ------
    ExactnessError
        If nothing solid is left.
    """
    total = int(targets[0].sum())
    mask = field > FORBIDDEN / 2
    offsets: Optional[List[np.ndarray]] = None
    little = _LITTLE
    for attempt in range(_ROUNDS):
        widest = 0.5 if offsets is None else 2.0**-6
        offsets = newton_offsets(field, targets, offsets, widest, progress=progress)
        offsets = polished(field, targets, offsets, 1, progress)
        wanted = solid_of(field, offsets)
        found = parts(wanted)
        small = int(found[1][found[1] < _least_island(total)].sum())
        if small > _MANY * total and attempt < _ROUNDS - 1:
            del found
            little = _LITTLE_OF_MANY
            depth = depth_below_level(field, offsets, total + _DEEPER * small)
            wanted = solid_of(field, [offsets[0] + depth, *offsets[1:]])
            solid = _hung_together(wanted, mask, progress)
            changed = solid != wanted
        else:
            solid = one_part(wanted, mask, progress, found=found)
            del found
            changed = solid != wanted
            if np.count_nonzero(changed) <= little * total or attempt == _ROUNDS - 1:
                break
        field[changed & solid] += _LIFT
        field[changed & wanted] -= _LIFT
    if offsets is None or not solid.any():
        raise ExactnessError(f"no part with {total} voxels was found in the field")
    return solid, offsets


def _least_island(total: int) -> float:
    """Return how many voxels an island must have to be joined to a solid of so many."""
    return min(max(_SMALLEST_ISLAND, LEAST_ISLAND * total), _LARGEST_LEAST)


def depth_below_level(field: np.ndarray, offsets: Sequence[np.ndarray], wanted: float) -> np.float32:
    """Return how far under the level of field + offsets about so many voxels are solid, from every third voxel."""
    a, b, c = (np.asarray(o, np.float32)[::3] for o in offsets)
    heights = np.sort((field[::3, ::3, ::3] + (a[:, None, None] + (b[:, None] + c))).reshape(-1))
    rank = heights.size - int(wanted / field.size * heights.size)
    highest = heights[np.clip(rank, 0, heights.size - 1)]
    return max(np.float32(0), -highest) if highest > FORBIDDEN / 2 else np.float32(0)


def one_part(
    solid: np.ndarray,
    mask: np.ndarray,
    progress: Progress = silent,
    bar: np.ndarray = _BAR,
    found: Optional[tuple] = None,
) -> np.ndarray:
    """Return the solid as one part: islands joined or dropped, closed cavities filled.

    Parameters
    ----------
    solid, mask : ndarray of shape (P, M, N), bool
        Nothing is added outside the mask.
    progress : callable
    bar : ndarray of shape (B, 3), int
        Steps (z, y, x) that bars cover around their lines.
    found : tuple, optional
        The solid's ``parts``, where they are known.
    """
    solid = _hung_together(solid, mask, progress, bar, found)
    cavities, sizes = closed_cavities(solid, mask)
    progress(1, 1, "islands")
    if len(sizes) > 1:
        solid |= cavities > 0
    return solid


def _hung_together(
    solid: np.ndarray, mask: np.ndarray, progress: Progress, bar: np.ndarray = _BAR, found: Optional[tuple] = None
) -> np.ndarray:
    """Return the solid as one part: islands joined or dropped; parameters as of ``one_part``."""
    solid = solid.copy()
    least = _least_island(np.count_nonzero(solid))
    while True:
        labels, sizes = parts(solid) if found is None else found
        found = None
        progress(0, 1, "islands")
        islands = np.flatnonzero(sizes >= least)
        if len(islands) < 2:
            break
        before = np.count_nonzero(solid)
        _join_islands(solid, mask, labels, islands, int(np.argmax(sizes)), bar)
        if np.count_nonzero(solid) == before:
            break
    if len(sizes) > 2:
        solid &= labels == int(np.argmax(sizes))
    return solid


def _join_islands(
    solid: np.ndarray, mask: np.ndarray, labels: np.ndarray, islands: np.ndarray, main: int, bar: np.ndarray
) -> None:
    """Draw a bar from every island but the main one to its nearest neighbour that is worth joining."""
    ndimage = scipy_ndimage()

    is_worth = np.zeros(int(labels.max()) + 1, bool)
    is_worth[islands] = True
    boxes = ndimage.find_objects(labels)
    for island in islands:
        if island == main:
            continue
        for start, end in _nearest_ends(labels, int(island), is_worth, boxes[island - 1]):
            _draw_bar(solid, mask, start, end, bar)


def _nearest_ends(labels: np.ndarray, island: int, is_worth: np.ndarray, box: tuple) -> list:
    """Return [(place on the island, nearest place on another)], or [] if it is alone; places are (z, y, x)."""
    ndimage = scipy_ndimage()

    margin = _FIRST_MARGIN
    while True:
        low = np.array([max(s.start - margin, 0) for s in box])
        window = tuple(slice(a, min(s.stop + margin, n)) for a, s, n in zip(low, box, labels.shape))
        near = labels[window]
        others = is_worth[near] & (near != island)
        distance, nearest = ndimage.distance_transform_edt(~others, return_indices=True)
        own = np.where(near == island, distance, np.inf) if others.any() else np.full(near.shape, np.inf)
        start = np.unravel_index(int(np.argmin(own)), own.shape)
        is_whole = near.shape == labels.shape
        if own[start] <= margin or (is_whole and np.isfinite(own[start])):
            return [(low + start, low + nearest[(slice(None), *start)])]
        if is_whole:
            return []
        margin *= 2


def _draw_bar(solid: np.ndarray, mask: np.ndarray, start: np.ndarray, end: np.ndarray, bar: np.ndarray) -> None:
    """Make a straight bar solid where the mask lets it be."""
    steps = 2 * int(np.abs(end - start).max()) + 1
    line = np.rint(start + np.linspace(0.0, 1.0, steps + 1)[:, None] * (end - start)).astype(int)
    places = (line[:, None, :] + bar).reshape(-1, 3)
    inside = ((places >= 0) & (places < solid.shape)).all(1)
    z, y, x = places[inside].T
    solid[z, y, x] |= mask[z, y, x]
