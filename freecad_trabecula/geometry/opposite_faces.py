# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces of a solid that lie opposite each other: what is coupled when nobody says otherwise."""

from __future__ import annotations

from typing import List, NamedTuple, Tuple

import numpy as np
import Part

from .vectors import point_array

_SMALLEST = 0.05  # of the largest face's area; smaller ones are edges and corners of the body
_FACING = 0.7  # least cosine between one outer normal and the other's opposite: 45 degrees
_ACROSS = 0.5  # least cosine between the inner normal and the way to the other face: 60 degrees


class FaceView(NamedTuple):
    """A face from afar: its name, centre (3,) mm, mean outer normal (3,), area mm²."""

    name: str
    centre: np.ndarray
    normal: np.ndarray
    area: float


def face_views(solid: Part.Shape) -> List[FaceView]:
    """Return the faces of a solid from afar; one that closes on itself (a cylinder's) is left out."""
    found = []
    for number, face in enumerate(solid.Faces, 1):
        # of a copy: triangles stay with a shape, and others may want finer ones
        points, triangles = face.copy().tessellate(max(face.BoundBox.DiagonalLength / 100, 1e-4))
        a, b, c = point_array(points)[np.array(triangles)].transpose(1, 0, 2)
        vector = np.cross(b - a, c - a).sum(0) / 2
        length = np.linalg.norm(vector)
        if length > 0.3 * face.Area:
            found.append(FaceView(f"Face{number}", np.array(tuple(face.CenterOfMass)), vector / length, face.Area))
    return found


def opposite_faces(solid: Part.Shape) -> List[Tuple[str, str]]:
    """Return pairs of faces that look at each other through the solid, best first; each face is in one pair at most.

    Parameters
    ----------
    solid : Part.Shape
        Its faces' normals point outwards.

    Examples
    --------
    >>> opposite_faces(Part.makeBox(30, 20, 5))
    [('Face5', 'Face6'), ('Face3', 'Face4'), ('Face1', 'Face2')]
    """
    views = face_views(solid)
    largest = max((view.area for view in views), default=0.0)
    views = [view for view in views if view.area >= _SMALLEST * largest]
    scored = sorted(
        ((_score(a, b), i, j) for i, a in enumerate(views) for j, b in enumerate(views) if i < j), key=lambda s: -s[0]
    )
    pairs, taken = [], set()
    for score, i, j in scored:
        if score > 0 and not taken & {i, j}:
            taken |= {i, j}
            pairs.append((views[i].name, views[j].name))
    return pairs


def _score(a: FaceView, b: FaceView) -> float:
    """Area (mm²) that two faces turn towards each other; 0 if they do not face each other across the solid."""
    facing = float(-a.normal @ b.normal)
    way = (b.centre - a.centre) / max(float(np.linalg.norm(b.centre - a.centre)), 1e-12)
    if facing < _FACING or min(-a.normal @ way, b.normal @ way) < _ACROSS:
        return 0.0
    return facing * min(a.area, b.area)
