# SPDX-License-Identifier: LGPL-2.1-or-later
"""Minimum zeros propagation (thesis 6.2.4.1, case 1)."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress
from ..layer_fill import propagated_layers
from ..parameters import VoxelParameters
from ..table_design import design_of_tables
from ..table_pairs import TABLE_OPTIONS, TablePair

NAME = "minimum-zeros"
SUMMARY = "random tables; in each layer the shortest line first, into the lines that need most (thesis case 1)"
OPTIONS = (*TABLE_OPTIONS, "direction")
SECONDS_PER_MILLION = 0.1  # CPU, of cells, measured


def fill(pair: TablePair, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> np.ndarray:
    """Return the layers of a pair of tables, the shortest line first, (P, M, N) bool."""
    return propagated_layers(pair.alpha, pair.beta, parameters.direction, "minimum", progress, mask)


design = design_of_tables(fill, 0.5)
