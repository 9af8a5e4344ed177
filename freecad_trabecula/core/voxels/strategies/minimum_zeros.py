# SPDX-License-Identifier: LGPL-2.1-or-later
"""Minimum zeros propagation (thesis 6.2.4.1, case 1)."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress, part
from ..layer_fill import propagated_layers
from ..parameters import VoxelParameters
from ..table_pairs import TABLE_OPTIONS, draw_pair
from ..targets import Targets

NAME = "minimum-zeros"
SUMMARY = "random tables; in each layer the shortest line first, into the lines that need most (thesis case 1)"
OPTIONS = (*TABLE_OPTIONS, "direction")
SECONDS_PER_MILLION = 0.1  # CPU, of cells, measured


def design(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> np.ndarray:
    """Return voxels with exactly these counts, (P, M, N) bool.

    Raises
    ------
    InfeasibleError, ExactnessError
        As ``table_pairs.draw_pair``.
    ParameterError
        If there is a mask.
    """
    pair = draw_pair(targets, parameters, part(progress, 0.0, 0.5), mask)
    return propagated_layers(pair.alpha, pair.beta, parameters.direction, "minimum", part(progress, 0.5, 1.0))
