# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points and directions: numpy to ``FreeCAD.Vector`` and back."""

from __future__ import annotations

from typing import Iterable, List, Sequence

import FreeCAD
import numpy as np


def vector(point: Sequence[float]) -> FreeCAD.Vector:
    """Return three numbers (ndarray (3,), tuple or Vector) as a Vector.

    numpy's scalars become floats first: FreeCAD refuses some of them.
    """
    x, y, z = point
    return FreeCAD.Vector(float(x), float(y), float(z))


def vectors(points: Iterable[Sequence[float]]) -> List[FreeCAD.Vector]:
    """Return points (P, 3) as a list of Vectors."""
    return [FreeCAD.Vector(*point) for point in np.asarray(points, float).reshape(-1, 3).tolist()]


def point_array(points: Iterable[FreeCAD.Vector]) -> np.ndarray:
    """Return Vectors as an ndarray of shape (P, 3), float; (0, 3) if there are none."""
    return np.array([(p.x, p.y, p.z) for p in points], float).reshape(-1, 3)
