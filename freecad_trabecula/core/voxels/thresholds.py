# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grey values of a scan -> material or void: by a given value, or Otsu's."""

from __future__ import annotations

from typing import Optional

import numpy as np

from ..parameters import require

_BINS = 256


def otsu_threshold(values: np.ndarray) -> float:
    """Return the value that parts grey values into two classes of the greatest variance between them.

    Parameters
    ----------
    values : ndarray of any shape, numbers

    Returns
    -------
    float
        Between the highest value of the lower class and the next; values above it are material.

    Raises
    ------
    ParameterError
        If all values are equal.

    Notes
    -----
    Otsu 1979, doi:10.1109/TSMC.1979.4310076, on a histogram of 256 bins between the least and the greatest value (on
    the values themselves where they are whole numbers of at most 256 kinds). Where several thresholds are as good, the
    middle one.

    Examples
    --------
    >>> otsu_threshold(np.array([10, 12, 11, 200, 202]))
    106.0
    """
    values = np.asarray(values)
    low, high = float(values.min()), float(values.max())
    require(high > low, "a scan must have more than one grey value to be parted by Otsu's threshold", low)
    counts, edges = np.histogram(values, _BINS, (low, high))
    centres = (edges[1:] + edges[:-1]) / 2
    below = np.cumsum(counts)[:-1]
    above = below[-1] + counts[-1] - below
    first = np.cumsum(counts * centres)
    means = first[:-1] / np.maximum(below, 1), (first[-1] - first[:-1]) / np.maximum(above, 1)
    between = below.astype(float) * above * (means[1] - means[0]) ** 2
    best = np.flatnonzero(between >= between.max() * (1 - 1e-12))
    return float((edges[1 + best[0]] + edges[1 + best[-1]]) / 2)


def material(values: np.ndarray, threshold: Optional[float] = None) -> np.ndarray:
    """Return which values are material, bool of the same shape: those above the threshold.

    Parameters
    ----------
    values : ndarray
        Numbers; bool, and whole numbers of two kinds (a mask), need no threshold: the greater is material.
    threshold : float or None
        None: Otsu's.

    Raises
    ------
    ParameterError
        If nothing or everything is material.
    """
    values = np.asarray(values)
    if values.dtype == bool:
        solid = values
    else:
        solid = values > (otsu_threshold(values) if threshold is None else threshold)
    count = int(solid.sum())
    words = "" if threshold is None else f" above {threshold:g}"
    rule = f"a sample must have material and voids: of {solid.size} voxels{words} are solid"
    require(0 < count < solid.size, rule, count)
    return solid
