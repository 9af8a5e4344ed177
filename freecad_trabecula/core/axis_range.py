# SPDX-License-Identifier: LGPL-2.1-or-later
"""The range of a diagram's axis: all values are in it, and rounding is not blown up to the height of the diagram."""

from __future__ import annotations

from typing import Tuple

#: Of the largest value. STL co-ordinates are single precision, 6e-8 of each; areas are sums and products of many.
ROUNDING = 1e-5
_WIDENED = (0.05, 0.5)  # of the largest value; at least, in the unit of the axis


def shown_range(low: float, high: float, size: float = 0.0) -> Tuple[float, float]:
    """Return the range that shows values from ``low`` to ``high``.

    Parameters
    ----------
    low, high : float
    size : float
        Of what the values were computed from, where that is larger than they are: of differences, the size of what
        was taken from each other.

    Notes
    -----
    Values that differ by no more than rounding lie in the middle of a wider range: a level line.

    Examples
    --------
    >>> shown_range(1.0, 3.0), shown_range(100.0, 100.0)
    ((1.0, 3.0), (95.0, 105.0))
    """
    size = max(abs(low), abs(high), size)
    if high - low > ROUNDING * size:
        return low, high
    room = max(_WIDENED[0] * size, _WIDENED[1])
    return low - room, high + room
