# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs of the same targets with other seeds: how much of each lies in each other one."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from ...errors import ParameterError


def overlaps(designs: Sequence[np.ndarray]) -> np.ndarray:
    """Return the share of solid voxels that two designs have in common, (S, S) float64; 1 on the diagonal.

    Parameters
    ----------
    designs : sequence of S arrays of one shape, bool

    Raises
    ------
    ParameterError
        If shapes differ or a design is empty.

    Notes
    -----
    Twice the common voxels over the sum of both (Dice 1945, doi:10.2307/1932409). Two unrelated designs share about
    what ``chance_overlap`` says.
    """
    flat = [np.asarray(design, bool).reshape(-1) for design in designs]
    shapes = {np.shape(design) for design in designs}
    if len(shapes) > 1 or not all(design.any() for design in flat):
        raise ParameterError(f"designs must have one shape and solid voxels, got shapes {sorted(shapes)}")
    sizes = np.array([np.count_nonzero(design) for design in flat], float)
    common = np.array([[np.count_nonzero(a & b) for b in flat] for a in flat], float)
    return 2.0 * common / (sizes[:, None] + sizes[None, :])


def chance_overlap(design: np.ndarray) -> float:
    """Return the overlap to expect of an unrelated design with the same layer counts.

    A voxel is solid in it about as often as the product of its three layers' shares over the square of the whole's.
    """
    design = np.asarray(design, bool)
    share = design.mean()
    if share == 0:
        raise ParameterError("a design must have solid voxels, got 0")
    z, y, x = design.mean((1, 2)), design.mean((0, 2)), design.mean((0, 1))
    expected = np.minimum(z[:, None, None] * (y[:, None] * x) / share**2, 1.0)
    return float((expected * design).sum() / design.sum())
