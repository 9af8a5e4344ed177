# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the strategies of given or random tables share: a pair of tables, then layers filled from it."""

from __future__ import annotations

from typing import Callable, Optional

import numpy as np

from ..progress import Progress, part
from .parameters import VoxelParameters
from .table_pairs import TablePair, Wishes, draw_pair
from .targets import Targets

#: Takes the tables, the parameters, the mask and progress; returns the voxels (P, M, N).
Fill = Callable[[TablePair, VoxelParameters, Optional[np.ndarray], Progress], np.ndarray]
#: Takes the targets, the parameters, the mask and progress; returns the tables that the pair shall be near to.
Wish = Callable[[Targets, VoxelParameters, Optional[np.ndarray], Progress], Wishes]
Design = Callable[[Targets, VoxelParameters, Optional[np.ndarray], Progress], np.ndarray]


def design_of_tables(fill: Fill, share: float, wish: Optional[Wish] = None) -> Design:
    """Return a strategy's ``design``: tables, in a share of its time, then their layers.

    Parameters
    ----------
    fill : callable
        Makes the layers.
    share : float
        Of the time that the tables take, 0 .. 1.
    wish : callable, optional
        Makes tables to be near to; without it they are random.
    """

    def design(
        targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress
    ) -> np.ndarray:
        """Return voxels with exactly these counts, (P, M, N) bool, within the mask if there is one.

        Raises
        ------
        InfeasibleError, ExactnessError, ParameterError
            As ``table_pairs.draw_pair``.
        DependencyError
            If scipy is missing where a mask or a linear program needs it.
        """
        near = (None, None) if wish is None else wish(targets, parameters, mask, part(progress, 0.0, 0.8 * share))
        pair = draw_pair(targets, parameters, part(progress, 0.8 * share if wish else 0.0, share), mask, near)
        return fill(pair, parameters, mask, part(progress, share, 1.0))

    return design
