# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a small design can keep its counts and the rules of one part, decided for certain (HiGHS, by scipy).

Contacts by an edge or a corner alone are linear in the voxels. Parts and closed cavities are cut off as they appear:
a solid voxel of a set that is smaller than the design needs one among the set's neighbours, a void one likewise.
"""

from __future__ import annotations

import time
from itertools import product
from typing import List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ..labelling import scipy_ndimage
from .connectivity import closed_cavities, parts
from .exact_search import check_programs, solved_program

#: Cells up to which the program is tried.
LARGEST_PROGRAM = 1000


class Verdict(NamedTuple):
    """What is known of designs with given counts and rules.

    Attributes
    ----------
    voxels : ndarray of shape (P, M, N), bool, or None
        A design that keeps all of them.
    broken : tuple of str
        If there is none for certain: the rules which no design keeps together, of ``contacts``, ``one part``,
        ``no closed cavity``; () if the counts alone forbid it.
    decided : bool
        Whether that is for certain.
    """

    voxels: Optional[np.ndarray]
    broken: Tuple[str, ...]
    decided: bool


class _Program:
    """Linear constraints on the voxels, added as they are needed."""

    def __init__(self, counts: Sequence[np.ndarray], allowed: np.ndarray) -> None:
        self.shape, self.allowed = allowed.shape, allowed
        self.total = int(counts[0].sum())
        self.cells = np.arange(allowed.size).reshape(allowed.shape)
        self._parts: List[tuple] = []  # (rows, columns, values, low, high), rows from 0
        for axis, count in enumerate(counts):
            layers = np.moveaxis(self.cells, axis, 0).reshape(len(count), -1)
            self.add(layers, np.ones(layers.shape), count, count)

    def add(self, columns: np.ndarray, values: np.ndarray, low: ArrayLike, high: ArrayLike) -> None:
        """Add constraints low <= sum of values x voxels <= high; arrays (rows, terms), bounds (rows,) or numbers."""
        rows = np.repeat(np.arange(len(columns)), columns.shape[1])
        bounds = [np.broadcast_to(np.asarray(bound, float), (len(columns),)) for bound in (low, high)]
        self._parts.append((rows, columns.reshape(-1), np.asarray(values, float).reshape(-1), *bounds))

    def forbid_edges(self) -> None:
        """Forbid that two voxels across an edge are of one kind and the other two at it of the other."""
        for axis in range(3):
            c = np.moveaxis(self.cells, axis, 0)
            square = [c[:, :-1, :-1], c[:, 1:, 1:], c[:, :-1, 1:], c[:, 1:, :-1]]
            columns = np.stack([part.reshape(-1) for part in square], 1)
            self.add(columns, np.broadcast_to([1, 1, -1, -1], columns.shape), -1, 1)

    def forbid_corners(self) -> None:
        """Forbid that two opposite voxels of a 2 x 2 x 2 block are alone of their kind."""
        low = [[slice(s, n - 1 + s) for s, n in zip(step, self.shape)] for step in product((0, 1), repeat=3)]
        block = np.stack([self.cells[tuple(window)].reshape(-1) for window in low], 1)
        for first in range(4):
            values = np.full(8, -1)
            values[[first, 7 - first]] = 1
            self.add(block, np.broadcast_to(values, block.shape), -5, 1)

    def cut_off(self, places: np.ndarray, is_solid: bool) -> None:
        """Ask that a voxel of a set (bool, like the box) has one of its kind among the neighbours of the set."""
        ndimage = scipy_ndimage()

        ring = ndimage.binary_dilation(places) & ~places & (self.allowed | ~np.bool_(is_solid))
        beside, inside = self.cells[ring], self.cells[places]
        columns = np.concatenate([inside[:, None], np.broadcast_to(beside, (len(inside), len(beside)))], 1)
        values = np.concatenate([np.ones((len(inside), 1)), -np.ones((len(inside), len(beside)))], 1)
        if is_solid:
            self.add(columns, values, -np.inf, 0)
        else:  # the same of 1 - voxel
            self.add(columns, values, 1 - len(beside), np.inf)

    def solved(self, seconds: float) -> Tuple[Optional[np.ndarray], bool]:
        """Return voxels that keep all constraints, if any were found, and whether the answer is certain."""
        from scipy.sparse import csr_matrix

        starts = np.cumsum([0] + [len(part[3]) for part in self._parts])
        rows = np.concatenate([part[0] + start for part, start in zip(self._parts, starts)])
        columns, values, low, high = (np.concatenate([part[i] for part in self._parts]) for i in range(1, 5))
        matrix = csr_matrix((values, (rows, columns)), shape=(int(starts[-1]), self.cells.size))
        chosen, certain = solved_program(matrix, low, high, self.allowed.reshape(-1), seconds)
        return None if chosen is None else chosen.reshape(self.shape), certain


def decided(counts: Sequence[np.ndarray], allowed: np.ndarray, edges: bool, corners: bool, seconds: float) -> Verdict:
    """Return whether some design has the counts, is one part without closed cavities, and avoids the contacts.

    Parameters
    ----------
    counts : sequence of 3 int arrays
        Voxels of each layer along z, y, x.
    allowed : ndarray of shape (P, M, N), bool
        Where solid may be.
    edges, corners : bool
        Whether contacts by an edge alone, by a corner alone, are forbidden.
    seconds : float
        After which it gives up.

    Raises
    ------
    DependencyError
        If scipy is missing or older than 1.9.
    """
    check_programs()
    program, rules = _Program(counts, allowed), []
    end = time.perf_counter() + seconds
    if edges or corners:
        rules.append("contacts")
    if edges:
        program.forbid_edges()
    if corners:
        program.forbid_corners()
    while time.perf_counter() < end:
        voxels, certain = program.solved(end - time.perf_counter())
        if voxels is None:
            return Verdict(None, tuple(rules) if certain else (), certain)
        labels, sizes = parts(voxels)
        cavities, holes = closed_cavities(voxels, allowed if not allowed.all() else None)
        if len(sizes) == 2 and len(holes) == 1:
            return Verdict(voxels, (), True)
        for number in range(1, len(sizes)) if len(sizes) > 2 else ():
            program.cut_off(labels == number, True)
        for number in range(1, len(holes)):
            program.cut_off(cavities == number, False)
        for rule, found in (("one part", len(sizes) > 2), ("no closed cavity", len(holes) > 1)):
            if found and rule not in rules:
                rules.append(rule)
    return Verdict(None, (), False)
