# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers too large to write, estimated from weighted samples: their logarithm and its standard error."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np


class LogCount(NamedTuple):
    """An estimate of a number.

    Attributes
    ----------
    log10 : float
        -inf for 0.
    standard_error : float
        Of the logarithm; nan where it is not known.
    samples : int
    effective : float
        How many samples of equal weight would be as good.
    """

    log10: float
    standard_error: float
    samples: int
    effective: float


def log_count(log_weights: np.ndarray) -> LogCount:
    """Return the estimate from samples' weights: their mean.

    Parameters
    ----------
    log_weights : ndarray of shape (S,)
        Natural logarithms of 1 / probability of each sample; -inf for one that is no solution.

    Examples
    --------
    >>> log_count(np.zeros(3))
    LogCount(log10=0.0, standard_error=0.0, samples=3, effective=3.0)
    """
    count = len(log_weights)
    top = float(log_weights.max())
    if not math.isfinite(top):
        return LogCount(-math.inf, math.nan, count, 0.0)
    weights = np.exp(log_weights - top)
    mean = float(weights.mean())
    effective = float(weights.sum() ** 2 / (weights**2).sum())
    return LogCount((top + math.log(mean)) / math.log(10), _jackknife_error(weights), count, effective)


def _jackknife_error(weights: np.ndarray) -> float:
    """Return the standard error of the logarithm of the weights' mean, from the means without one of them.

    Where one weight outweighs the others, that is more than the spread of the weights says; nan where it is all.
    """
    without = weights.sum() - weights
    if len(weights) < 2 or not (without > 1e-12 * weights.sum()).all():
        return math.nan
    logs = np.log10(without)
    return float(np.sqrt((len(weights) - 1) * np.mean((logs - logs.mean()) ** 2)))


def product(factors: list) -> LogCount:
    """Return the product of independent estimates: logarithms add, standard errors as squares.

    The logarithm of a mean lies low, on average by half the square of its (natural) standard error: little in one
    factor, much in the sum over a hundred. It is made good.
    """
    low = 0.5 * math.log(10) * sum(f.standard_error**2 for f in factors)
    return LogCount(
        sum(f.log10 for f in factors) + (low if math.isfinite(low) else 0.0),
        math.sqrt(sum(f.standard_error**2 for f in factors)),
        min(f.samples for f in factors),
        min(f.effective for f in factors),
    )
