# SPDX-License-Identifier: LGPL-2.1-or-later
"""The law of one cell of a table: exp(tilt x) on 0..cap."""

from __future__ import annotations

from typing import Tuple

import numpy as np

_NEARLY_EVEN = 1e-5  # tilts below it: by the first terms of the series, where the closed form loses its digits


def geometric(tilt: np.ndarray, cap: int) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return logarithm of the sum, mean and variance of the law exp(tilt x) on 0..cap, arrays like the tilts.

    Examples
    --------
    >>> [round(float(v[0]), 3) for v in geometric(np.zeros(1), 4)[1:]]
    [2.0, 2.0]
    """
    steep = np.minimum(-np.abs(tilt), -_NEARLY_EVEN)
    count = cap + 1
    one, all_of = -np.expm1(steep), -np.expm1(count * steep)
    log_sum = np.log(all_of / one)
    mean = np.exp(steep) / one - count * np.exp(count * steep) / all_of
    variance = np.exp(steep) / one**2 - count**2 * np.exp(count * steep) / all_of**2
    up = tilt > 0
    even = np.abs(tilt) < _NEARLY_EVEN
    spread = cap * (cap + 2) / 12.0
    log_sum = np.where(up, log_sum + cap * tilt, log_sum)
    log_sum = np.where(even, np.log(cap + 1.0) + tilt * (0.5 * cap) + 0.5 * spread * tilt**2, log_sum)
    mean = np.where(even, 0.5 * cap + tilt * spread, np.where(up, cap - mean, mean))
    return log_sum, mean, np.where(even, spread, np.maximum(variance, 1e-9))
