# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks of faces: points and normals by which a face is found again when its body has numbered its faces anew."""

from __future__ import annotations

from typing import List, Optional, Sequence

import FreeCAD
import Part

_SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)  # of a parameter's range
_FINE = [(k + 0.5) / 40 for k in range(40)]  # for faces of which the coarse grid meets nothing
_NEAR = 1e-4  # mm: the same place
_ALONG = 0.999  # cosine between normals that look the same way
_LENGTH = 6  # numbers of one point: its place, its normal


def face_mark(face: Part.Face) -> List[float]:
    """Return points on a face with their outer normals, flat: x, y, z, nx, ny, nz of each.

    Examples
    --------
    >>> mark = face_mark(Part.makeBox(1, 2, 3).Faces[5])
    >>> len(mark) // 6, [round(value, 6) for value in mark[:6]]
    (25, [0.1, 0.2, 3.0, 0.0, 0.0, 1.0])
    """
    found = _samples(face, _SHARES) or _samples(face, _FINE)[:25]
    return [float(value) for point, normal in found for value in (*point, *normal)]


def _samples(face: Part.Face, shares: Sequence[float]) -> list:
    u0, u1, v0, v1 = face.ParameterRange
    places = [(u0 + s * (u1 - u0), v0 + t * (v1 - v0)) for s in shares for t in shares]
    return [(face.valueAt(u, v), face.normalAt(u, v)) for u, v in places if face.isPartOfDomain(u, v)]


def faces_like(shape: Part.Shape, mark: Sequence[float]) -> List[float]:
    """Return for each face of a shape which share of a mark's points lies on it, with the same normal.

    Examples
    --------
    >>> box = Part.makeBox(1, 2, 3)
    >>> [round(share, 3) for share in faces_like(box, face_mark(box.Faces[5]))]
    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    """
    points = _points(mark)
    return [sum(_is_on(face, *one) for one in points) / max(len(points), 1) for face in shape.Faces]


def _points(mark: Sequence[float]) -> list:
    rows = [mark[k : k + _LENGTH] for k in range(0, len(mark), _LENGTH)]
    return [(FreeCAD.Vector(*row[:3]), FreeCAD.Vector(*row[3:])) for row in rows]


def _is_on(face: Part.Face, point: FreeCAD.Vector, normal: FreeCAD.Vector) -> bool:
    box = face.BoundBox
    box.enlarge(_NEAR)
    if not box.isInside(point):
        return False
    distance, _, places = face.distToShape(Part.Vertex(point))
    if distance > _NEAR:
        return False
    kind, _, where = places[0][:3]
    # next to an edge the normal is not told; the point of a mark lies well inside of its face
    return kind == "Face" and face.normalAt(*where).dot(normal) > _ALONG


def found_again(shape: Part.Shape, mark: Sequence[float], number: int, same_count: bool) -> Optional[int]:
    """Return the number, from 1, of the face of a shape that has a mark; None if there is none.

    Parameters
    ----------
    shape : Part.Shape
    mark : sequence of float
        Of ``face_mark``.
    number : int
        That of the face so far; 0 if there is no such face any more.
    same_count : bool
        Whether the shape has as many faces as it had. The number then holds, unless the face with it has nothing of
        the mark and another has all of it: faces move when a body's sizes change.
    """
    faces = shape.Faces
    if same_count and 1 <= number <= len(faces) and any(_is_on(faces[number - 1], *one) for one in _points(mark)):
        return number  # mostly so, and found with the first point: to look everywhere takes a third of a second
    shares = faces_like(shape, mark)
    own = shares[number - 1] if 1 <= number <= len(shares) else -1.0
    best = max(shares, default=0.0)
    if same_count and own >= 0 and best < 1:
        return number
    if best <= 0:
        return None
    return number if own == best else shares.index(best) + 1
