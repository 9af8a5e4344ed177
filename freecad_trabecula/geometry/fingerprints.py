# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fingerprints of shapes: the same after saving and opening and on every FreeCAD version, another for another shape."""

from __future__ import annotations

import hashlib
from typing import List, Tuple

import numpy as np
import Part

from .vectors import point_array

_DIGITS = 6  # 1e-6 mm: no two designs differ by less, and kernels agree far better
_SAMPLES = np.linspace(0.1, 0.9, 5).tolist()  # shares of a parameter's range at which faces and edges are sampled
_KEPT: List[Tuple[Part.Shape, str]] = []
_MOST_KEPT = 8


def fingerprint(shape: Part.Shape) -> str:
    """Return a hash of a shape's geometry: corners, points of edges and faces, and all poles of B-spline surfaces.

    The text form of a BREP would do within one session, but its digits and its header depend on the version.

    Examples
    --------
    >>> fingerprint(Part.makeBox(1, 2, 3)) == fingerprint(Part.makeBox(1, 2, 3))
    True
    """
    for kept, digest in tuple(_KEPT):  # another thread may add to it
        if kept.isSame(shape) and kept.Orientation == shape.Orientation:
            return digest
    digest = hashlib.blake2b(digest_size=12)
    digest.update(repr((len(shape.Solids), len(shape.Faces), len(shape.Edges), shape.Orientation)).encode())
    points = [v.Point for v in shape.Vertexes]
    for edge in shape.Edges:
        if not edge.Degenerated:
            low, high = edge.ParameterRange
            points += [edge.valueAt(low + s * (high - low)) for s in _SAMPLES]
    for face in shape.Faces:
        digest.update(f"{type(face.Surface).__name__} {face.Orientation}".encode())
        points += _face_points(face)
    # adding 0 turns -0 into 0
    digest.update((np.round(point_array(points), _DIGITS) + 0.0).tobytes())
    _KEPT.append((shape, digest.hexdigest()))
    del _KEPT[:-_MOST_KEPT]
    return digest.hexdigest()


def _face_points(face: Part.Face) -> list:
    u0, u1, v0, v1 = face.ParameterRange
    points = [face.valueAt(u0 + s * (u1 - u0), v0 + t * (v1 - v0)) for s in _SAMPLES for t in _SAMPLES]
    if isinstance(face.Surface, Part.BSplineSurface):  # an edit of one pole may miss all samples
        points += [face.Placement.multVec(pole) for row in face.Surface.getPoles() for pole in row]
    return points
