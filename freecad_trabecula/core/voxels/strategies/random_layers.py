# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers drawn from all that the tables allow."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress, part
from ...streams import Stream
from ..layer_fill import propagated_layers, shuffled_layers
from ..parameters import VoxelParameters
from ..table_pairs import TABLE_OPTIONS, draw_pair
from ..targets import Targets

NAME = "random-layers"
SUMMARY = "random tables; each layer drawn nearly uniformly from all that have these row and column sums"
OPTIONS = (*TABLE_OPTIONS, "direction")
SECONDS_PER_MILLION = 0.5  # CPU, of cells, measured


def design(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> np.ndarray:
    """Return voxels with exactly these counts, (P, M, N) bool.

    Raises
    ------
    InfeasibleError, ExactnessError
        As ``table_pairs.draw_pair``.
    ParameterError
        If there is a mask.
    """
    pair = draw_pair(targets, parameters, part(progress, 0.0, 0.2), mask)
    voxels = propagated_layers(pair.alpha, pair.beta, parameters.direction, "minimum", part(progress, 0.2, 0.3))
    stream = Stream(parameters.seed, "voxels", "random layers")
    return shuffled_layers(voxels, stream, progress=part(progress, 0.3, 1.0))
