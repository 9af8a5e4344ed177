# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners of contours as files of layers hold them: with so many decimals, none twice."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from .contours import Contours


def distinct_corners(
    contours: Contours, scale: float, decimals: int
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return points, starts, plane, closed as a text file holds them: rounded, without corners that fall together.

    Closed contours that are left with fewer than three corners, and open ones with fewer than two, have no extent at
    this precision and are left out.

    Parameters
    ----------
    contours : Contours
    scale : float, mm
        Of one unit of the file.
    decimals : int
    """
    points = np.round(contours.points / scale, decimals) + 0.0  # + 0.0: no minus zero
    counts = np.diff(contours.starts)
    of_point = np.repeat(np.arange(len(counts)), counts)
    before = np.arange(len(points)) - 1
    before[contours.starts[:-1][counts > 0]] = contours.starts[1:][counts > 0] - 1  # the first follows the last ...
    same = (points == points[before]).all(1)
    opens = contours.starts[:-1][(counts > 0) & ~contours.closed]
    same[opens] = False  # ... unless the polyline is open
    left = np.bincount(of_point[~same], minlength=len(counts))
    keep = left >= np.where(contours.closed, 3, 2)
    rows = ~same & keep[of_point]
    starts = np.concatenate([[0], np.cumsum(left[keep])]).astype(int)
    return points[rows], starts, contours.plane[keep], contours.closed[keep]
