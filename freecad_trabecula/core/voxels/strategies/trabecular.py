# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trabecular: one part of sheets and rods like the sample's, exact on the three axes (thesis ch. 9's wishes).

Field -> offsets -> islands joined -> contacts removed -> exact moves. No floating voxel, no closed cavity.
"""

from __future__ import annotations

from typing import List, Optional

import numpy as np

from ....errors import ExactnessError, InfeasibleError
from ...progress import Progress, part, silent
from ..connectivity import Solid
from ..contacts import remove_contacts
from ..exact_moves import ExactMoves
from ..joining import joined_solid
from ..parameters import VoxelParameters
from ..plane_offsets import FORBIDDEN
from ..targets import Targets
from ..texture import Texture, trabecular_field

NAME = "trabecular"
SUMMARY = "One connected part of sheets and rods, like the sample's; no floating voxel, no closed cavity"

#: Wavelength without a sample, voxels: struts of two to three voxels.
DEFAULT_WAVELENGTH = 8.0
_ATTEMPTS = 3  # fields tried before the search gives up


def design(
    targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray] = None, progress: Progress = silent
) -> np.ndarray:
    """Return a trabecular design, (P, M, N) bool: one part of 6-neighbours, no closed cavity, every count exact.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
        ``seed``, ``wavelength``, ``rods``, ``contacts``, ``thickness``, ``void``, ``trabeculae`` matter.
    mask : ndarray of shape (P, M, N), bool, optional
        Where solid may be.
    progress : callable
        May raise ``Cancelled``.

    Raises
    ------
    InfeasibleError
        If empty layers would cut the design in two.
    ExactnessError
        If no design was found with all that is asked for; the message says what is left.
    """
    counts = [targets.c, targets.e, targets.d]
    check_one_part(counts)
    texture = chosen_texture(targets, parameters)
    allowed = allowed_voxels(counts, mask)
    for attempt in range(_ATTEMPTS):
        share = part(progress, attempt / _ATTEMPTS if attempt else 0.0, 1.0)
        try:
            field = trabecular_field(texture, targets.shape, parameters.seed, (attempt,), part(share, 0.0, 0.1))
            if allowed is not None:
                field[~allowed] = FORBIDDEN
            return exact_solid(field, counts, parameters, allowed, part(share, 0.1, 1.0))
        except ExactnessError:
            if attempt == _ATTEMPTS - 1:
                raise
    raise AssertionError("unreachable")


def check_one_part(counts: List[np.ndarray]) -> None:
    """Refuse counts with an empty layer between layers that are not: they cannot be one part.

    Raises
    ------
    InfeasibleError
        Naming the layers.
    """
    for axis, count in zip("ZYX", counts):
        used = np.flatnonzero(count)
        gaps = np.flatnonzero(np.diff(used) > 1)
        if len(gaps):
            first, last = used[gaps[0]], used[gaps[0] + 1]
            raise InfeasibleError(
                f"one part needs voxels in every layer between its first and last; along {axis} layers {first} and "
                f"{last} are asked for {int(count[first])} and {int(count[last])} voxels, and {last - first - 1} "
                "between them for none"
            )


def allowed_voxels(counts: List[np.ndarray], mask: Optional[np.ndarray]) -> Optional[np.ndarray]:
    """Return where solid may be: in the mask, and in no layer that is to be empty; None is everywhere."""
    if mask is None and all(count.all() for count in counts):
        return None
    c, e, d = (count > 0 for count in counts)
    box = c[:, None, None] & e[:, None] & d
    return box if mask is None else box & mask


def chosen_texture(targets: Targets, parameters: VoxelParameters) -> Texture:
    """Return the texture that the parameters ask for, in voxels."""
    wavelengths = tuple(
        max(2.5, length / edge) if length > 0 else DEFAULT_WAVELENGTH
        for length, edge in zip(parameters.wavelength, targets.voxel)
    )
    return Texture(wavelengths, mix=parameters.rods)


def exact_solid(
    field: np.ndarray,
    counts: List[np.ndarray],
    parameters: VoxelParameters,
    allowed: Optional[np.ndarray],
    progress: Progress = silent,
) -> np.ndarray:
    """Return one exact part along the heights of a field, (P, M, N) bool.

    Parameters
    ----------
    field : ndarray of shape (P, M, N), float32
        ``plane_offsets.FORBIDDEN`` where no solid may be. Changed.
    counts : list of 3 int arrays
        Voxels of each layer along z, y, x.
    parameters : VoxelParameters
    allowed : ndarray of shape (P, M, N), bool, or None
    progress : callable

    Raises
    ------
    ExactnessError
        If it was not found.
    """
    solid, offsets = joined_solid(field, counts, part(progress, 0.0, 0.6))
    moves = ExactMoves(Solid(solid, allowed), field, offsets, counts, part(progress, 0.6, 1.0))
    if parameters.contacts != "any":
        remove_contacts(moves, parameters.contacts == "corner")
    return moves.run()
