# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voxels where a chosen field is high: tables and layers follow it as nearly as the counts allow.

Offsets of the planes give voxels whose counts are nearly right; tables near to those voxels' own are exact, and the
best layers of these tables are the design.
"""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress
from ..chosen_fields import chosen_field
from ..layer_fill import layer_sums
from ..masked_tables import solid_near
from ..parameters import VoxelParameters
from ..table_design import design_of_tables
from ..table_pairs import TABLE_OPTIONS, Wishes
from ..targets import Targets
from ..texture import QUANTUM
from .best_tables import fill

NAME = "by-field"
SUMMARY = "voxels where the chosen field is highest, as nearly as the counts of the layers allow"
OPTIONS = (*TABLE_OPTIONS, "field")
SECONDS_PER_MILLION = 5.0  # CPU, of cells, measured


def near_field(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> Wishes:
    """Return the tables (N, P), (M, P) of voxels that lie highest on the chosen field, their counts nearly right."""
    field = chosen_field(parameters, targets.shape)
    field = (np.rint(field / field.std() / QUANTUM) * QUANTUM).astype(np.float32)
    return layer_sums(solid_near(field, targets, mask, progress))


design = design_of_tables(fill, 0.1, near_field)
