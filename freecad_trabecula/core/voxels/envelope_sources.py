# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets of an envelope that is to be filled to a given share, without a sample."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from ..parameters import require
from ..progress import Progress, silent
from ..triples import triple
from .masks import main_part, targets_within
from .parameters import VoxelParameters
from .sources import cells_inside, check_closed
from .targets import Targets, layer_counts_of_box


def targets_of_envelope(
    triangles: np.ndarray, density: float, parameters: VoxelParameters, progress: Progress = silent
) -> Tuple[Targets, np.ndarray]:
    """Return targets that fill a share of the envelope's cells in every layer, and its mask, (P, M, N) bool.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
        Closed.
    density : float
        Share of the cells, between 0 and 1.
    parameters : VoxelParameters
        Its size and boundary rule.
    progress : callable

    Raises
    ------
    ParameterError
        If the density is not between 0 and 1, the mesh is open, or its cells are none or in two parts.
    """
    require(0 < density < 1, "the density of an envelope must lie between 0 and 1", f"{density:g}")
    check_closed(triangles)
    low, high = triangles.min((0, 1)).astype(float), triangles.max((0, 1)).astype(float)
    layers = layer_counts_of_box(high - low, parameters.size, "slab")
    # the grid about the middle of the box: what is left over is shared by both ends
    origin = (low + high - np.asarray(layers) * np.asarray(parameters.size)) / 2
    mask = main_part(cells_inside(triangles, layers, parameters.size, origin, parameters.boundary, progress))
    return targets_within(mask, [density] * 3, parameters.size, triple(origin.tolist())), mask
