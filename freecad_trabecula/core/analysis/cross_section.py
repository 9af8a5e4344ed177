# SPDX-License-Identifier: LGPL-2.1-or-later
"""One plane through a body, quickly enough to follow a slider: only the triangles that the plane cuts are looked at."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from .contours import Contours
from .parameters import axis_frame
from .slices import slice_contours


class Sections:
    """The cross-sections of one body across one axis.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
    axis : str
        ``x``, ``y``, ``z`` or a direction (see ``parameters.axis_name``).

    Examples
    --------
    >>> corner = np.array([[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [0, 1, 0], [0, 0, 1]],
    ...                    [[0, 0, 0], [0, 0, 1], [1, 0, 0]], [[1, 0, 0], [0, 0, 1], [0, 1, 0]]])
    >>> len(Sections(corner, "z").at(0.5).plane)
    1
    """

    def __init__(self, triangles: np.ndarray, axis: str) -> None:
        self._triangles, self._axis = np.asarray(triangles), axis
        heights = self._triangles @ axis_frame(axis)[2]
        self._low, self._high = heights.min(1), heights.max(1)

    @property
    def bounds(self) -> Tuple[float, float]:
        """Lowest and highest co-ordinate along the axis, mm."""
        return float(self._low.min()), float(self._high.max())

    def at(self, height: float) -> Contours:
        """Return the contours of the plane at a height, mm: round material positive, round voids negative."""
        cut = (self._low <= height) & (self._high >= height)
        return slice_contours(self._triangles[cut], self._axis, np.array([height]))
