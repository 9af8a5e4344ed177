# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs that differ by their seed alone: what each of them is, and how far they spread."""

from __future__ import annotations

import math
from typing import Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from ..errors import ParameterError
from .analysis.tables import Column, csv_text
from .parameters import LARGEST_SEED

MOST = 200  # variants of one run
RAYS, SCAFFOLD, VOXELS = "estimate by rays", "scaffold", "voxels"


class Variant(NamedTuple):
    """One design of a run.

    Attributes
    ----------
    seed : int
    numbers : dict
        Name in words to value: porosity, its error, rods; or what is known of voxels.
    picture : ndarray of shape (rows, columns), uint8
        Grey, seen from a corner.
    """

    seed: int
    numbers: Dict[str, float]
    picture: np.ndarray


class Variants(NamedTuple):
    """A run.

    Attributes
    ----------
    by : str
        How the numbers were found: ``estimate by rays``, ``scaffold`` or ``voxels``.
    spreads : str
        Name of the number whose spread is told first.
    rows : tuple of Variant
    overlap : ndarray of shape (S, S)
        Share of solid voxels in common (Dice); of rods none, (0, 0).
    chance : float
        Overlap to expect of unrelated voxels with the same layers; nan of rods.
    """

    by: str
    spreads: str
    rows: Tuple[Variant, ...]
    overlap: np.ndarray
    chance: float

    def values(self, name: str) -> np.ndarray:
        """Return one number of all variants, (S,) float64."""
        return np.array([row.numbers[name] for row in self.rows], float)

    def csv(self) -> str:
        """Return seeds and numbers as CSV text, and of voxels the overlaps, a row a variant."""
        columns: Dict[str, Column] = {"seed": [row.seed for row in self.rows]}
        for name in self.rows[0].numbers:
            columns[name] = self.values(name)
        for number, row in enumerate(self.rows if len(self.overlap) else ()):
            columns[f"overlap with seed {row.seed}"] = self.overlap[:, number]
        return csv_text(columns)


class Spread(NamedTuple):
    """Mean, standard deviation of a sample (nan of one), least and greatest of some values, and how many they are."""

    mean: float
    sd: float
    least: float
    greatest: float
    count: int  # type: ignore[assignment]  # of tuple.count, which nobody asks a spread for


def spread(values: Sequence[float]) -> Spread:
    """Return how values spread.

    Raises
    ------
    ParameterError
        If there are none.

    Examples
    --------
    >>> spread([1.0, 2.0, 3.0])
    Spread(mean=2.0, sd=1.0, least=1.0, greatest=3.0, count=3)
    """
    found = np.asarray(values, float)
    if not len(found):
        raise ParameterError("a spread must be that of at least 1 value, got 0")
    sd = float(found.std(ddof=1)) if len(found) > 1 else math.nan
    return Spread(float(found.mean()), sd, float(found.min()), float(found.max()), len(found))


def seeds_from(first: int, count: int) -> List[int]:
    """Return consecutive seeds.

    Raises
    ------
    ParameterError
        If there are too many or none, or one is no seed.
    """
    if not 1 <= count <= MOST:
        raise ParameterError(f"variants must be 1 to {MOST}, got {count}")
    if not 0 <= first <= LARGEST_SEED - count + 1:
        raise ParameterError(f"seeds must lie in 0..{LARGEST_SEED}, got {first} to {first + count - 1}")
    return list(range(first, first + count))
