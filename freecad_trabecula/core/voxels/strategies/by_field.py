# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voxels where a chosen field is high: tables and layers follow it as nearly as the counts allow."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ...progress import Progress, part
from ..best_layer import best_layers
from ..chosen_fields import chosen_field
from ..layer_fill import layer_sums
from ..parameters import VoxelParameters
from ..plane_offsets import newton_offsets, polished, solid_of
from ..table_pairs import TABLE_OPTIONS, draw_pair
from ..targets import Targets
from ..texture import QUANTUM

NAME = "by-field"
SUMMARY = "voxels where the chosen field is highest, as nearly as the counts of the layers allow"
OPTIONS = (*TABLE_OPTIONS, "field")
SECONDS_PER_MILLION = 5.0  # CPU, of cells, measured


def design(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray], progress: Progress) -> np.ndarray:
    """Return voxels with exactly these counts, (P, M, N) bool.

    Offsets of the planes give voxels whose counts are nearly right; tables near to those voxels' own are exact, and the
    best layers of these tables are the design.

    Raises
    ------
    InfeasibleError, ExactnessError
        As ``table_pairs.draw_pair``.
    ParameterError
        If there is a mask.
    DependencyError
        If scipy is missing.
    """
    field = chosen_field(parameters, targets.shape)
    field = (np.rint(field / field.std() / QUANTUM) * QUANTUM).astype(np.float32)
    counts = [targets.c, targets.e, targets.d]
    offsets = newton_offsets(field, counts, progress=part(progress, 0.0, 0.05))
    offsets = polished(field, counts, offsets, progress=part(progress, 0.05, 0.08))
    pair = draw_pair(targets, parameters, part(progress, 0.08, 0.1), mask, layer_sums(solid_of(field, offsets)))
    return best_layers(field, pair.alpha, pair.beta, part(progress, 0.1, 1.0))
