# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers drawn from all that the tables allow."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress, part
from ...streams import Stream
from ..layer_fill import propagated_layers, shuffled_layers
from ..parameters import VoxelParameters
from ..table_design import design_of_tables
from ..table_pairs import TABLE_OPTIONS, TablePair

NAME = "random-layers"
SUMMARY = "random tables; each layer drawn nearly uniformly from all that have these row and column sums"
OPTIONS = (*TABLE_OPTIONS, "direction")
SECONDS_PER_MILLION = 0.5  # CPU, of cells, measured


def fill(pair: TablePair, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> np.ndarray:
    """Return random layers of a pair of tables, (P, M, N) bool."""
    start = part(progress, 0.0, 0.1)
    voxels = propagated_layers(pair.alpha, pair.beta, parameters.direction, "minimum", start, mask)
    stream = Stream(parameters.seed, "voxels", "random layers")
    return shuffled_layers(voxels, stream, progress=part(progress, 0.1, 1.0), mask=mask)


design = design_of_tables(fill, 0.2)
