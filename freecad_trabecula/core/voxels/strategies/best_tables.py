# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layer of given tables that is highest on a field."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress, part
from ..best_layer import best_layers
from ..chosen_fields import chosen_field
from ..parameters import VoxelParameters
from ..table_pairs import TABLE_OPTIONS, draw_pair
from ..targets import Targets

NAME = "best-tables"
SUMMARY = "random tables; of all layers that they allow the one that is highest on the chosen field (linear program)"
OPTIONS = (*TABLE_OPTIONS, "field")
SECONDS_PER_MILLION = 5.0  # CPU, of cells, measured


def design(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> np.ndarray:
    """Return voxels with exactly these counts, (P, M, N) bool.

    Raises
    ------
    InfeasibleError, ExactnessError
        As ``table_pairs.draw_pair``.
    ParameterError
        If there is a mask.
    DependencyError
        If scipy is missing.
    """
    pair = draw_pair(targets, parameters, part(progress, 0.0, 0.05), mask)
    field = chosen_field(parameters, targets.shape)
    return best_layers(field, pair.alpha, pair.beta, part(progress, 0.05, 1.0))
