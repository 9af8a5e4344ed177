# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trabecular: one part of sheets and rods like the sample's, exact on the three axes (thesis ch. 9's wishes).

Field -> offsets -> islands joined -> contacts removed -> exact moves. No floating voxel, no closed cavity.
"""

from __future__ import annotations

from typing import List, Optional, Tuple

import numpy as np

from ....errors import ExactnessError, InfeasibleError
from ...progress import Progress, part, silent
from ..connectivity import Solid
from ..contacts import remove_contacts
from ..exact_moves import ExactMoves
from ..joining import joined_solid, one_part
from ..local_scale import locally_fitted
from ..masks import allowed_voxels, main_part
from ..parameters import VoxelParameters
from ..plane_offsets import FORBIDDEN, newton_offsets, on_field, solid_of
from ..small_boxes import SmallBox, is_small_box
from ..targets import Targets
from ..texture import Texture, trabecular_field
from ..texture_fit import DEFAULT_MIX, fitted_texture, has_surface
from ..thinnest import ThickSolid, thick_start
from ..trabeculae import match_trabeculae, trabecula_counts, wanted_trabeculae

NAME = "trabecular"
SUMMARY = "One connected part of sheets and rods, like the sample's; no floating voxel, no closed cavity"
OPTIONS = ("wavelength", "rods", "contacts", "thickness", "void", "trabeculae", "boundary")

#: Wavelength without a sample, voxels: struts of two to three voxels.
DEFAULT_WAVELENGTH = 8.0
#: Least mix where trabeculae are counted: sheets alone join what is to be cut.
COUNTED_MIX = 0.1
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
    allowed = allowed_voxels(counts, None if mask is None else main_part(mask))
    order = _Order(targets, parameters, counts, allowed, chosen_texture(targets, parameters))
    attempts = 1 if order.is_small else _ATTEMPTS
    for attempt in range(attempts):
        try:
            return order.filled(attempt, progress)
        except ExactnessError:
            if attempt == attempts - 1:
                raise
    raise ExactnessError("no field was tried")


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


def chosen_texture(targets: Targets, parameters: VoxelParameters) -> Texture:
    """Return the texture that the parameters ask for, in voxels: theirs, the sample's where they leave it open."""
    mix = parameters.rods if parameters.rods >= 0 else None
    lengths = np.array([length / edge for length, edge in zip(parameters.wavelength, targets.voxel)])
    if lengths.all() and mix is not None:
        fitted = Texture(mix=mix)
    elif targets.sample is None or not has_surface(targets.sample):
        fitted = Texture((DEFAULT_WAVELENGTH,) * 3, mix=DEFAULT_MIX if mix is None else mix)
    else:
        fitted = fitted_texture(targets.sample, mix)
        if parameters.trabeculae != "off" and fitted.mix < COUNTED_MIX:
            fitted = fitted_texture(targets.sample, COUNTED_MIX)
    if not lengths.any():
        return fitted
    own = np.diag(fitted.wave_matrix())
    return Texture(tuple(max(2.5, float(w)) for w in np.where(lengths > 0, lengths, own)), mix=fitted.mix)


class _Order:
    """What one design is to be."""

    def __init__(
        self,
        targets: Targets,
        parameters: VoxelParameters,
        counts: List[np.ndarray],
        allowed: Optional[np.ndarray],
        texture: Texture,
    ) -> None:
        self.parameters, self.counts, self.allowed, self.texture = parameters, counts, allowed, texture
        self.shape = targets.shape
        self.wanted = wanted_trabeculae(targets, parameters.trabeculae)

    @property
    def counts_trabeculae(self) -> bool:
        """Whether numbers of trabeculae are targets."""
        return any(w is not None for w in self.wanted)

    def filled(self, attempt: int, progress: Progress) -> np.ndarray:
        """Return one exact part, (P, M, N) bool, along the field of an attempt.

        Raises
        ------
        ExactnessError
            If it was not found.
        """
        ends = (0.5, 0.7) if self.counts_trabeculae else (0.1, 0.6)
        field = self.field(attempt, part(progress, 0.0, ends[0]))
        solid, offsets = self._started(field, part(progress, *ends))
        moves = ExactMoves(solid, field, offsets, self.counts, part(progress, ends[1], 1.0))
        try:
            if self.parameters.contacts != "any":
                remove_contacts(moves, self.parameters.contacts == "corner")
            if self.counts_trabeculae:
                match_trabeculae(moves, self.wanted)
            return moves.run()
        except ExactnessError:
            if not self.is_small:
                raise
        return self._of_small_box(moves, part(progress, ends[1], 1.0))

    @property
    def is_small(self) -> bool:
        """Whether a small box is searched when fields and exact moves find nothing."""
        return is_small_box(self.shape) and self.parameters.thickness == self.parameters.void == 1

    def _of_small_box(self, moves: ExactMoves, progress: Progress) -> np.ndarray:
        """Return one exact part where moves found none, with trabeculae counted as far as that leaves it exact."""
        box = SmallBox(self.counts, self.allowed, self.parameters.contacts, self.parameters.seed)
        voxels = box.design(moves.solid.voxels, on_field(moves.field, moves.offsets), progress)
        if not self.counts_trabeculae:
            return voxels
        avoided = self.parameters.contacts != "any", self.parameters.contacts == "corner"
        counted = ExactMoves(Solid(voxels, self.allowed, *avoided), moves.field, moves.offsets, self.counts, progress)
        try:
            match_trabeculae(counted, self.wanted)
            return counted.run()
        except ExactnessError:
            return voxels

    def _started(self, field: np.ndarray, progress: Progress) -> Tuple[Solid, List[np.ndarray]]:
        """Return one part with nearly the counts, thick enough if asked for, and the field's offsets."""
        thickness, void = self.parameters.thickness, self.parameters.void
        if thickness == 1 and void == 1:
            try:
                solid, offsets = joined_solid(field, self.counts, progress)
            except ExactnessError:
                if not self.is_small:
                    raise
                solid, offsets = np.zeros(self.shape, bool), [np.zeros(n, np.float32) for n in self.shape]
            return Solid(solid, self.allowed), offsets
        may_touch = self.parameters.contacts == "any"
        solid, offsets = thick_start(field, self.counts, thickness, void, may_touch, progress)
        return ThickSolid(solid, self.allowed, thickness, void), offsets

    def field(self, attempt: int, progress: Progress) -> np.ndarray:
        """Return the field of an attempt, float32, ``FORBIDDEN`` where no solid may be."""
        seed, identity = self.parameters.seed, (attempt,)
        if self.counts_trabeculae:
            field = locally_fitted(
                self.texture, self.shape, seed, identity, self.wanted, self._quickly, self._counted, progress
            )
        else:
            field = trabecular_field(self.texture, self.shape, seed, identity, progress)
        if self.allowed is not None:
            field[~self.allowed] = FORBIDDEN
        return field

    def _quickly(self, field: np.ndarray) -> np.ndarray:
        """Return one part along a field, not exact, for counting; changes the field."""
        if self.allowed is not None:
            field[~self.allowed] = FORBIDDEN
        offsets = newton_offsets(field, self.counts, narrowest=2.0**-5)
        solid = one_part(solid_of(field, offsets), field > FORBIDDEN / 2)
        moves = ExactMoves(Solid(solid, self.allowed), field, offsets, self.counts)
        if self.parameters.contacts != "any":
            remove_contacts(moves)
        return moves.solid.voxels

    def _counted(self, solid: np.ndarray) -> List[np.ndarray]:
        return list(trabecula_counts(solid))[::-1]
