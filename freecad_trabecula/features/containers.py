# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies in an ``App::Part``: what is made of them lies in the same one, so that it moves with them."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np


def place_beside(obj: Any, other: Any) -> None:
    """Put an object into the ``App::Part`` in which another lies, if it lies in one."""
    container = _container_of(other)
    if container is not None:
        container.addObject(obj)


def frame_of(obj: Any) -> FreeCAD.Placement:
    """Return the placement of the ``App::Part`` in which an object lies; without one it is the identity."""
    container = _container_of(obj)
    return container.getGlobalPlacement() if container is not None else FreeCAD.Placement()


def seen_at(points: np.ndarray, obj: Any) -> np.ndarray:
    """Return points (..., 3), mm, of an object's own co-ordinates where they are seen in the 3D view."""
    frame = frame_of(obj)
    if frame.isIdentity():
        return points
    matrix = np.array(frame.toMatrix().A).reshape(4, 4)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _container_of(obj: Any) -> Any:
    found = obj.getParentGeoFeatureGroup() if obj is not None else None
    return found if found is not None and found.TypeId != "PartDesign::Body" else None  # it takes its own steps only
