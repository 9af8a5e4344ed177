# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts of a design's layers, and whether they are those asked for (thesis 6.4).

A routine of its own: it finds the solid voxels by their co-ordinates and counts these, where the strategies add and
subtract along the array's axes.
"""

from __future__ import annotations

from typing import List, NamedTuple, Tuple

import numpy as np

from ...errors import ExactnessError
from .targets import AXES, Targets

_NAMED = 3  # layers named in a message


class LayerError(NamedTuple):
    """A layer whose count is not the one asked for."""

    axis: str
    layer: int
    asked: int
    got: int


def layer_counts(voxels: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the solid voxels in each layer along X, Y, Z: ndarrays (N,), (M,), (P,) of int64.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    """
    p, m, n = voxels.shape
    cells = np.flatnonzero(voxels)
    rows = cells // n
    return (
        np.bincount(cells % n, minlength=n).astype(np.int64),
        np.bincount(rows % m, minlength=m).astype(np.int64),
        np.bincount(rows // m, minlength=p).astype(np.int64),
    )


def layer_errors(voxels: np.ndarray, targets: Targets) -> List[LayerError]:
    """Return the layers along X, Y and Z whose counts are not those asked for; none if the design is exact.

    Raises
    ------
    ExactnessError
        If the design has other layers than the targets.
    """
    if voxels.shape != targets.shape:
        raise ExactnessError(f"a design for these targets must have the shape {targets.shape}, got {voxels.shape}")
    errors = []
    for axis, asked, got in zip(AXES, targets.counts, layer_counts(voxels)):
        errors += [LayerError(axis, int(i), int(asked[i]), int(got[i])) for i in np.flatnonzero(asked != got)]
    return errors


def check_exact(voxels: np.ndarray, targets: Targets) -> None:
    """Refuse a design that is not exact on every layer of the three axes.

    Raises
    ------
    ExactnessError
        Naming the first layers that differ.
    """
    errors = layer_errors(voxels, targets)
    if errors:
        named = "; ".join(f"layer {e.layer} along {e.axis.upper()}: {e.got} for {e.asked}" for e in errors[:_NAMED])
        raise ExactnessError(f"every layer must have its count of voxels; {len(errors)} layers differ: {named}")
