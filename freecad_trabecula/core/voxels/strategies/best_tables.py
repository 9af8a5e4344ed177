# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layer of given tables that is highest on a field."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress
from ..best_layer import best_layers
from ..chosen_fields import chosen_field
from ..parameters import VoxelParameters
from ..table_design import design_of_tables
from ..table_pairs import TABLE_OPTIONS, TablePair

NAME = "best-tables"
SUMMARY = "random tables; of all layers that they allow the one that is highest on the chosen field (linear program)"
OPTIONS = (*TABLE_OPTIONS, "field")
SECONDS_PER_MILLION = 5.0  # CPU, of cells, measured


def fill(pair: TablePair, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> np.ndarray:
    """Return the layers of a pair of tables that are highest on the chosen field, (P, M, N) bool."""
    shape = pair.alpha.shape[1], len(pair.beta), len(pair.alpha)
    return best_layers(chosen_field(parameters, shape), pair.alpha, pair.beta, progress, mask)


design = design_of_tables(fill, 0.05)
