# SPDX-License-Identifier: LGPL-2.1-or-later
"""A voxel design: targets in, exact voxels out (thesis chapter 6)."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, field, replace
from typing import Mapping, NamedTuple, Optional, Tuple

import numpy as np

from ...errors import ParameterError
from ..progress import Progress, part, silent
from ..triples import triple
from .exact_search import is_small
from .feasibility import check_feasible
from .parameters import BYTES_PER_VOXEL, VoxelParameters, check_voxel_count
from .registry import find_strategy, strategy_names
from .table_pairs import draw_pair
from .targets import Targets
from .verification import check_exact

#: Below so many voxels of mean thickness much of the bone lies outside any block of 2 x 2 x 2 voxels.
LEAST_THICKNESS = 3.0


@dataclass(frozen=True, eq=False)
class VoxelDesign:
    """Voxels with exactly the counts asked for, and what they were made from.

    Attributes
    ----------
    voxels : ndarray of shape (P, M, N), bool
        Solid voxels; axes [z, y, x].
    targets : Targets
    parameters : VoxelParameters
    mask : ndarray of shape (P, M, N), bool, or None
        The envelope; None is the whole box.
    seconds : dict
        Time of each phase.
    notes : tuple of str
        What the user should know.
    """

    voxels: np.ndarray
    targets: Targets
    parameters: VoxelParameters
    mask: Optional[np.ndarray] = None
    seconds: Mapping[str, float] = field(default_factory=dict)
    notes: Tuple[str, ...] = ()

    @property
    def alpha(self) -> np.ndarray:
        """Voxels in each line (x, z), ndarray of shape (N, P), int64: the table of system (6.5)."""
        return self.voxels.sum(1, dtype=np.int64).T

    @property
    def beta(self) -> np.ndarray:
        """Voxels in each line (y, z), ndarray of shape (M, P), int64: the table of system (6.9)."""
        return self.voxels.sum(2, dtype=np.int64).T


def make_design(
    targets: Targets,
    parameters: VoxelParameters,
    mask: Optional[np.ndarray] = None,
    progress: Progress = silent,
) -> VoxelDesign:
    """Return a design that has exactly the voxels asked for in every layer along X, Y and Z.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
    mask : ndarray of shape (P, M, N), bool, optional
        Cells that may be solid.
    progress : callable
        May raise ``Cancelled``.

    Raises
    ------
    InfeasibleError
        If there is no such design; the message names the layers that contradict each other.
    ExactnessError
        If the search gave up.
    ParameterError
        If the mask has another shape than the targets, or no cells; if tables are given to a strategy that heeds none.
    """
    seconds = {}
    start = time.perf_counter()
    check_heeds_tables(parameters.strategy, targets)
    mask = _checked_mask(mask, targets)
    check_feasible(targets, parameters, mask)
    if mask is None and is_small(targets):
        draw_pair(targets, replace(parameters, pairing="constraint", solver="proportional"))  # else it says why not
    seconds["feasibility"] = time.perf_counter() - start
    start = time.perf_counter()
    strategy = find_strategy(parameters.strategy)
    voxels = strategy.design(targets, parameters, mask, part(progress, 0.0, 0.95))
    seconds["design"] = time.perf_counter() - start
    start = time.perf_counter()
    progress(0.97, 1.0, "verification")
    check_exact(voxels, targets)
    seconds["verification"] = time.perf_counter() - start
    return VoxelDesign(voxels, targets, parameters, mask, seconds, tuple(target_notes(targets)))


def heeds_tables(strategy: str) -> bool:
    """Return whether a strategy fills layers from tables, also from given ones."""
    return "pairing" in find_strategy(strategy).OPTIONS


def check_heeds_tables(strategy: str, targets: Targets) -> None:
    """Refuse given tables where the strategy makes no use of them.

    Raises
    ------
    ParameterError
        Naming the strategies that do.
    """
    if targets.tables is not None and not heeds_tables(strategy):
        others = ", ".join(name for name in strategy_names() if heeds_tables(name))
        raise ParameterError(f"given tables need a strategy that fills layers from them ({others}), got {strategy}")


class Estimate(NamedTuple):
    """What a design will take.

    Attributes
    ----------
    layers : tuple of int
        N, M, P.
    cells : int
    gigabytes : float
        Of memory at its peak.
    seconds : float
        On a processor of 2020.
    """

    layers: Tuple[int, int, int]
    cells: int
    gigabytes: float
    seconds: float

    @property
    def words(self) -> str:
        """The estimate as a sentence."""
        n, m, p = self.layers
        return (
            f"{n} x {m} x {p} layers, {self.cells:,} cells: about {self.gigabytes:.2g} GB of memory and "
            f"{max(self.seconds, 0.1):.2g} s"
        )


def estimate(layers: Tuple[int, int, int], strategy: str) -> Estimate:
    """Return what a design of so many layers will take; it grows with the cells.

    Parameters
    ----------
    layers : tuple of int
        N, M, P.
    strategy : str

    Raises
    ------
    ParameterError
        If the cells are too many, or the strategy is unknown.
    """
    check_voxel_count(layers)
    cells = math.prod(layers)
    per_million = getattr(find_strategy(strategy), "SECONDS_PER_MILLION", 1.0)
    return Estimate(triple(layers), cells, 0.1 + cells * BYTES_PER_VOXEL / 1e9, per_million * cells / 1e6)


def _checked_mask(mask: Optional[np.ndarray], targets: Targets) -> Optional[np.ndarray]:
    if mask is None:
        return None
    mask = np.asarray(mask, bool)
    if mask.shape != targets.shape:
        raise ParameterError(f"a mask for these targets must have the shape {targets.shape}, got {mask.shape}")
    if not mask.any():
        raise ParameterError("a mask must have at least one voxel, got 0")
    return None if mask.all() else mask


def share_outside_blocks(voxels: np.ndarray) -> float:
    """Return the share of the solid that lies in no block of 2 x 2 x 2 solid voxels.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool

    Examples
    --------
    >>> share_outside_blocks(np.ones((2, 2, 3), bool)), share_outside_blocks(np.ones((1, 2, 3), bool))
    (0.0, 1.0)
    """
    blocks = voxels
    for axis in range(3):
        blocks = np.moveaxis(blocks, axis, 0)
        blocks = np.moveaxis(blocks[1:] & blocks[:-1], 0, axis)
    covered = np.pad(blocks, 1)
    for axis in range(3):
        covered = np.moveaxis(covered, axis, 0)
        covered = np.moveaxis(covered[1:] | covered[:-1], 0, axis)
    return 1.0 - float(np.count_nonzero(covered)) / max(int(np.count_nonzero(voxels)), 1)


def target_notes(targets: Targets) -> Tuple[str, ...]:
    """Return what the user should know of targets before a design is made of them: sentences, maybe none."""
    notes = []
    thickness = targets.thickness / max(targets.voxel)
    if thickness < LEAST_THICKNESS:
        outside = ""
        if targets.sample is not None:
            share = 100 * share_outside_blocks(targets.sample)
            outside = f" ({share:.0f} % of it lie outside any block of 2 x 2 x 2 voxels)"
        notes.append(
            f"the sample's mean thickness is {thickness:.2g} voxels; below {LEAST_THICKNESS:g} its trabeculae are not "
            f"resolved{outside}: voxels of {targets.thickness / LEAST_THICKNESS:.2g} mm would resolve them"
        )
    for axis, counts in zip("XYZ", targets.counts):
        used = np.flatnonzero(counts)
        holes = np.flatnonzero(counts[used[0] : used[-1] + 1] == 0) + used[0] if len(used) else []
        if len(holes):
            notes.append(f"layer {holes[0]} along {axis} is empty between others: no design is one piece")
    return tuple(notes)
