# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many solutions one equation, and how many designs one row, has, exactly (thesis 6.2.2.1, 6.2.4); all of a design.

What cannot be counted exactly (tables, layers, designs) is estimated with a standard error by ``entropy_counts``,
``sampled_tables`` and ``sampled_layers``.
"""

from __future__ import annotations

import math
from itertools import accumulate
from typing import Any, Dict, NamedTuple, Optional, Sequence

import numpy as np

from ..parameters import require
from ..progress import Progress, part, silent
from ..streams import Stream
from .design import VoxelDesign
from .entropy_counts import count_by_entropy
from .feasibility import caps_of, table_shortfall
from .log_counts import LogCount
from .sampled_layers import count_layers
from .sampled_tables import count_tables
from .targets import Targets

_SAMPLES = 24  # of a table that is drawn row by row: 3 s for 100 x 100
_LAYER_SAMPLES = 6  # of each layer of a design; their errors are independent and add as squares


def free_solutions(n: int, k: int) -> int:
    """Return how many solutions X_1 + ... + X_k = n has in whole numbers from 0 (6.11): (n + k - 1)! / (n! (k - 1)!).

    Examples
    --------
    >>> free_solutions(3, 2)
    4
    """
    require(n >= 0 and k >= 1, "an equation must have n >= 0 and k >= 1", (n, k))
    return math.comb(n + k - 1, k - 1)


def bounded_solutions(n: int, most: Sequence[int], least: Optional[Sequence[int]] = None) -> int:
    """Return how many solutions X_1 + ... + X_k = n has with least_j <= X_j <= most_j (6.12, 6.13).

    Parameters
    ----------
    n : int
    most, least : sequences of int
        Bounds; ``least`` is 0 when it is left out.

    Raises
    ------
    ParameterError
        If the bounds are of different lengths, or one is negative.

    Notes
    -----
    Whole numbers of any size: for each variable prefix sums, less the same moved by its bound + 1.

    Examples
    --------
    >>> bounded_solutions(3, [1, 2, 2])
    5
    >>> bounded_solutions(3, [1, 2, 2], [1, 0, 0])
    3
    """
    least = [0] * len(most) if least is None else list(least)
    require(len(least) == len(most) > 0, "each variable must have two bounds", (len(least), len(most)))
    require(min(least) >= 0 and n >= 0, "bounds and sum must not be negative", (min(least), n))
    rest = n - sum(least)
    widths = [high - low for high, low in zip(most, least)]
    if rest < 0 or min(widths) < 0:
        return 0
    ways = [1] + [0] * rest
    for width in widths:
        sums = list(accumulate(ways))
        ways = sums[: width + 1] + [sums[i] - sums[i - width - 1] for i in range(width + 1, rest + 1)]
    return ways[rest]


def row_designs(columns: int, voxels: int, zeros: int = 0) -> int:
    """Return how many designs one row of a layer has: N! / (b! (N - b)!), or with N - v for N (6.19, 6.20).

    Parameters
    ----------
    columns : int
        N.
    voxels : int
        beta_j: voxels of the row.
    zeros : int
        v: columns that need no voxel.

    Examples
    --------
    >>> row_designs(5, 2), row_designs(5, 2, 1)
    (10, 6)
    """
    require(0 <= zeros <= columns and voxels >= 0, "a row must have 0 <= v <= N and voxels >= 0", (zeros, columns))
    return math.comb(columns - zeros, voxels)


def log10_of(number: int) -> float:
    """Return the logarithm of a whole number of any size, -inf for 0.

    Examples
    --------
    >>> round(log10_of(10**400), 9)
    400.0
    """
    if number <= 0:
        return -math.inf
    shift = max(number.bit_length() - 60, 0)
    return math.log10(number >> shift) + shift * math.log10(2)


class SystemCounts(NamedTuple):
    """How many designs there are; the logarithms are to base 10.

    Attributes
    ----------
    alpha, beta : LogCount
        Tables of the systems (6.5) and (6.9) with these sums and caps, each by itself.
    layers : LogCount
        Designs with the tables of this design: the product over its layers.
    designs : LogCount
        Designs with these counts along X, Y and Z, whatever their tables.
    """

    alpha: LogCount
    beta: LogCount
    layers: LogCount
    designs: LogCount


def count_systems(design: VoxelDesign, progress: Progress = silent) -> SystemCounts:
    """Return how many tables, layers and designs there are beside this one.

    Parameters
    ----------
    design : VoxelDesign
    progress : callable

    Raises
    ------
    ParameterError
        If the design lies in a mask: lines of different lengths are not counted.
    """
    require(design.mask is None, "designs are counted in boxes, not in", "a mask")
    targets, seed = design.targets, design.parameters.seed
    cap_alpha, cap_beta = caps_of(targets, design.parameters)
    streams = [Stream(seed, "voxels", "counting", name) for name in ("alpha", "beta", "layers", "designs")]
    return SystemCounts(
        _tables(targets.c, targets.d, cap_alpha, streams[0], part(progress, 0.0, 0.2)),
        _tables(targets.c, targets.e, cap_beta, streams[1], part(progress, 0.2, 0.4)),
        count_layers(design.alpha, design.beta, _LAYER_SAMPLES, streams[2], part(progress, 0.4, 0.8)),
        count_designs(targets, streams[3], part(progress, 0.8, 1.0)),
    )


def counting_record(design: VoxelDesign, progress: Progress = silent) -> Dict[str, Any]:
    """Return ``count_systems`` as plain values for a report."""
    counts = count_systems(design, progress)
    names = ("tables alpha", "tables beta", "designs with this design's tables", "designs with these counts")
    return {
        name: {
            "log10": count.log10 if math.isfinite(count.log10) else None,  # no sample came to its end
            "standard_error": None if math.isnan(count.standard_error) else count.standard_error,
            "samples": count.samples,
            "effective": count.effective if math.isfinite(count.effective) else None,
        }
        for name, count in zip(names, counts)
    }


def count_designs(targets: Targets, stream: Stream, progress: Progress = silent) -> LogCount:
    """Return how many designs have these counts along X, Y and Z, by ``entropy_counts``.

    Parameters
    ----------
    targets : Targets
    stream : Stream
    progress : callable

    Returns
    -------
    LogCount
        nan where the counts leave some cells no choice, so that there is no law of largest entropy.
    """
    found = count_by_entropy([targets.c, targets.e, targets.d], 1, stream, progress)
    return LogCount(math.nan, math.nan, 0, math.nan) if found is None else found


def _tables(rows: np.ndarray, columns: np.ndarray, cap: int, stream: Stream, progress: Progress) -> LogCount:
    """Return how many tables 0..cap have these sums: by entropy, or row by row where that says nothing."""
    if rows.sum() == columns.sum() and not table_shortfall(rows, columns, cap):
        found = count_by_entropy([rows, columns], cap, stream, progress)
        if found is not None:
            return found
    return count_tables(rows, columns, cap, _SAMPLES, stream, progress)
