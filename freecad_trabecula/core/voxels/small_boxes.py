# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs of small boxes, where fields and exact moves find no way: annealed, and decided for certain where that fails.

A refusal says which rules no design keeps together, which layer of the nearest one found is off, and what to relax.
"""

from __future__ import annotations

from typing import Optional, Sequence

import numpy as np

from ...errors import DependencyError, ExactnessError, InfeasibleError
from ..progress import Progress, part
from ..streams import Stream
from .annealing import FORCED, Annealing
from .connectivity import closed_cavities, edge_contact_voxels, parts
from .exact_rules import LARGEST_PROGRAM, Verdict, decided
from .exact_search import LARGEST_SEARCH
from .feasibility import forced_cells

_CYCLES = 3
_TRIES_PER_CELL = 250  # of one cycle
_LEAST_TRIES, _MOST_TRIES = 60_000, 1_200_000
_SECONDS = 4.0  # of the program
#: What a design avoids, from the option that asks for most to the one that asks for least.
_LOOSER = {"corner": ("edge", "any"), "edge": ("any",), "any": ()}


def is_small_box(shape: Sequence[int]) -> bool:
    """Return whether a box has so few cells that its designs are annealed."""
    return int(np.prod(shape)) <= LARGEST_SEARCH


class SmallBox:
    """What a design of a small box is to be.

    Parameters
    ----------
    counts : sequence of 3 int arrays
        Voxels of each layer along z, y, x.
    allowed : ndarray of shape (P, M, N), bool, or None
        Where solid may be.
    contacts : str
        ``any``, ``edge`` or ``corner``, as in ``VoxelParameters``.
    seed : int
    """

    def __init__(self, counts: Sequence[np.ndarray], allowed: Optional[np.ndarray], contacts: str, seed: int) -> None:
        self.counts, self.allowed, self.contacts, self.seed = counts, allowed, contacts, seed
        self.shape = tuple(len(count) for count in counts)

    def design(self, start: np.ndarray, heights: np.ndarray, progress: Progress) -> np.ndarray:
        """Return one exact part, (P, M, N) bool.

        Parameters
        ----------
        start : ndarray of shape (P, M, N), bool
            Where to begin; what is not its largest part, and its cavities, are mended first.
        heights : ndarray of shape (P, M, N)
            Of the field over its level.
        progress : callable

        Raises
        ------
        InfeasibleError
            If there is none for certain.
        ExactnessError
            If none was found.
        """
        solid, void = forced_cells(self.counts)
        heights = np.where(solid, FORCED, np.where(void, -FORCED, heights))
        whole = self._whole(start, heights)
        annealing = self._annealed(whole, heights, self.contacts, part(progress, 0.0, 0.6))
        if annealing.is_right:
            return annealing.voxels
        verdict = self._verdict(self.contacts)
        progress(0.65, 1.0, "small box")
        if verdict.voxels is not None:  # not taken: other versions of scipy may find another one
            raise ExactnessError("a design with these counts and rules exists, but was not found; another seed may do")
        relaxed = self._relaxed(whole, heights, part(progress, 0.7, 0.9))
        words = f"{self._rules(verdict)}; {self._nearest(annealing)}; {relaxed}"
        raise InfeasibleError(words) if verdict.decided else ExactnessError(words)

    def _whole(self, start: np.ndarray, heights: np.ndarray) -> np.ndarray:
        """Return the start's largest part without cavities; the highest voxel where there is none."""
        whole = start.copy()
        if not whole.any():
            free = heights if self.allowed is None else np.where(self.allowed, heights, -np.inf)
            whole[np.unravel_index(int(np.argmax(free)), self.shape)] = True
        labels, sizes = parts(whole)
        whole &= labels == int(np.argmax(sizes))
        return whole | (closed_cavities(whole, self.allowed)[0] > 0)

    def _annealed(self, start: np.ndarray, heights: np.ndarray, contacts: str, progress: Progress) -> Annealing:
        annealing = Annealing(start, heights, self.counts, self.allowed, contacts != "any", contacts == "corner")
        tries = min(max(_TRIES_PER_CELL * start.size, _LEAST_TRIES), _MOST_TRIES)
        annealing.run(Stream(self.seed, "small box", contacts), _CYCLES, tries, progress)
        return annealing

    def _verdict(self, contacts: str) -> Verdict:
        """Return what a program of all designs knows; nothing if there are too many cells, or no scipy that has it."""
        if int(np.prod(self.shape)) > LARGEST_PROGRAM:
            return Verdict(None, (), False)
        allowed = np.ones(self.shape, bool) if self.allowed is None else self.allowed
        try:
            return decided(self.counts, allowed, contacts != "any", contacts == "corner", _SECONDS)
        except DependencyError:
            return Verdict(None, (), False)

    def _rules(self, verdict: Verdict) -> str:
        """Return which rules are not kept, as far as that is known."""
        avoided = {"any": "", "edge": " by an edge", "corner": " by an edge or a corner"}[self.contacts]
        words = {
            "contacts": f"no contact{avoided} alone",
            "one part": "one part",
            "no closed cavity": "no closed cavity",
        }
        kept = [word for rule, word in words.items() if (self.contacts != "any" or rule != "contacts")]
        if not verdict.decided:
            return f"every layer must have its count in a design with {', '.join(kept)}; none was found"
        broken = [words[rule] for rule in verdict.broken]
        return f"no design with these counts exists{' that has ' if broken else ''}{', '.join(broken)}"

    def _nearest(self, annealing: Annealing) -> str:
        """Return where the nearest design found is off."""
        if annealing.missing:
            axis = int(np.argmax([np.abs(lack).max() for lack in annealing.lacking]))
            layer = int(np.argmax(np.abs(annealing.lacking[axis])))
            asked = int(self.counts[axis][layer])
            has = asked - int(annealing.lacking[axis][layer])
            return f"the nearest one found has {has} voxels instead of {asked} in layer {layer} along {'ZYX'[axis]}"
        places = edge_contact_voxels(annealing.voxels)
        where = f", one of them in layer {int(np.flatnonzero(places.any((1, 2)))[0])} along Z" if places.any() else ""
        return f"the nearest one found has {annealing.contacts} contacts{where}"

    def _relaxed(self, start: np.ndarray, heights: np.ndarray, progress: Progress) -> str:
        """Return what to relax: looser contacts where they are enough, else the one part."""
        for contacts in _LOOSER[self.contacts]:
            if self._annealed(start, heights, contacts, progress).is_right:
                return f"with contacts '{contacts}' there is one"
        verdict = self._verdict("any")
        if verdict.voxels is not None:
            return "with contacts 'any' there is one"
        if verdict.decided:
            return "only a strategy that fills tables, in several parts or with cavities, can have these counts"
        return "another seed, counts that differ less between layers or a strategy that fills tables may do"
