# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs in an envelope: the mask's main part, and targets per layer within it.

A mask tells which cells may be solid. Boundary cells belong to it by the rule that ``VoxelParameters.boundary`` names
(by their centre; touched at all; wholly inside): a body's area in a layer then differs from its cells' by the rim.
"""

from __future__ import annotations

import math
from typing import Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ...errors import InfeasibleError, ParameterError
from ..parameters import require
from ..triples import triple
from .connectivity import parts
from .plane_offsets import layer_sums
from .targets import Targets

#: Parts of a mask below this share are strays of its boundary and stay empty; above it, the mask is in two.
STRAY = 1e-3


def main_part(mask: np.ndarray) -> np.ndarray:
    """Return the mask without cells that hang on it by an edge or a corner alone, or not at all.

    Parameters
    ----------
    mask : ndarray of shape (P, M, N), bool

    Raises
    ------
    ParameterError
        If the mask is empty, or has a second part that is no stray: no design in it could be one part.
    """
    labels, sizes = parts(np.asarray(mask, bool))
    require(len(sizes) > 1, "a mask must have at least one cell", 0, "cells")
    largest, *others = np.sort(sizes[1:])[::-1].tolist()
    if others and others[0] > STRAY * sizes.sum():
        raise ParameterError(f"a mask must be in one part, got parts of {largest} and {others[0]} cells")
    return labels == int(np.argmax(sizes))


def allowed_voxels(counts: Sequence[np.ndarray], mask: Optional[np.ndarray]) -> Optional[np.ndarray]:
    """Return where solid may be, (P, M, N) bool: in the mask, and in no layer that is to be empty; None is everywhere.

    Parameters
    ----------
    counts : sequence of ndarrays (P,), (M,), (N,)
        Voxels asked for along Z, Y, X.
    mask : ndarray of shape (P, M, N), bool, or None
    """
    if mask is None and all(count.all() for count in counts):
        return None
    c, e, d = (count > 0 for count in counts)
    box = c[:, None, None] & e[:, None] & d
    return box if mask is None else box & mask


def targets_within(
    mask: np.ndarray,
    densities: Sequence[ArrayLike],
    voxel: Tuple[float, float, float] = (0.1, 0.1, 0.1),
    origin: Tuple[float, float, float] = (0.0, 0.0, 0.0),
    sample: Optional[np.ndarray] = None,
) -> Targets:
    """Return targets that fill a share of the mask's cells in every layer.

    Each axis' layers ask for share times cells; the three totals are scaled to their mean and rounded by largest
    remainders, no layer above its cells.

    Parameters
    ----------
    mask : ndarray of shape (P, M, N), bool
    densities : sequence of 3 arrays or numbers, along x, y, z
        Share of each layer's cells that is to be solid, 0 .. 1: a bone's BV/TV profile, or one number.
    voxel, origin : tuple, mm
    sample : ndarray of shape (P, M, N), bool, optional
        As in ``Targets``.

    Raises
    ------
    ParameterError
        If the mask is empty or in two parts, or a density is not in 0 .. 1.
    InfeasibleError
        If the layers along some axis have not cells enough for the common total.
    """
    cells = layer_sums(main_part(mask))[::-1]
    real = []
    for axis, (density, room) in enumerate(zip(densities, cells)):
        share = np.broadcast_to(np.asarray(density, float), room.shape)
        bad = ~((share >= 0) & (share <= 1))
        if bad.any():
            raise ParameterError(
                f"densities must be 0 to 1, got {share[bad][0]:g} in layer {np.argmax(bad)} along {'XYZ'[axis]}"
            )
        real.append(share * room)
    total = math.floor(sum(float(r.sum()) for r in real) / 3 + 0.5)
    require(total > 0, "a design must have at least one voxel; the densities in this mask make", total, "voxels")
    counts = triple(_shared(r, room, total, axis) for axis, (r, room) in enumerate(zip(real, cells)))
    return Targets(*counts, triple(voxel), triple(origin), sample=sample)


def _shared(real: np.ndarray, room: np.ndarray, total: int, axis: int) -> np.ndarray:
    """Return whole counts with a total, in proportion to real ones as far as layers have room; int64 like ``real``."""
    asked = room * (real > 0)
    if asked.sum() < total:
        raise InfeasibleError(
            f"the mask's layers along {'XYZ'[axis]} have {int(asked.sum())} cells, but the common total is {total}"
        )
    low, high = 0.0, float(total) + 1.0
    for _ in range(200):  # the factor at which layers, cut at their room, make the total
        factor = (low + high) / 2
        low, high = (factor, high) if np.minimum(real * factor, asked).sum() < total else (low, factor)
    scaled = np.minimum(real * high, asked)
    counts = np.floor(scaled + 1e-9).astype(np.int64)
    while counts.sum() != total:
        left = total - int(counts.sum())
        free = np.flatnonzero(counts < asked) if left > 0 else np.flatnonzero(counts > 0)
        rest = np.sign(left) * (scaled - counts)[free]
        chosen = free[np.argsort(-rest, kind="stable")][: abs(left)]
        counts[chosen] += np.sign(left)
    return counts
