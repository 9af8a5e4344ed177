# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact box around a solid.

FreeCAD's ``BoundBox`` is loose for B-splines (it holds their poles) and tight once the shape has been triangulated, and
``optimalBoundingBox`` fails in 0.20: no law that refers to the box could be repeated. Here the box follows from the
extreme points of edges and of faces alone.
"""

from __future__ import annotations

from typing import List, Tuple

import FreeCAD
import numpy as np
import Part

from .surfaces import FaceSurface, Parameters, edge_samples, solve_two
from .vectors import point_array

Vector = FreeCAD.Vector

_AXES = (Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1))
_TRIED = 20  # highest points of a face's grid of which one lies within its border
_STEPS = 30  # of Newton's iteration to the top of a face or an edge


def exact_box(shape: Part.Shape) -> Tuple[np.ndarray, np.ndarray]:
    """Return the lowest and the highest co-ordinates (3,), mm, of a shape with faces.

    Notes
    -----
    The top of a curved face is sought from the highest of its sampled points; a bump narrower than 1/24 of a face that
    rises above all else may be cut off.
    """
    points = [vertex.Point for vertex in shape.Vertexes]
    for edge in shape.Edges:
        if not edge.Degenerated:
            points += _edge_extremes(edge)
    for face in shape.Faces:
        if not isinstance(face.Surface, Part.Plane):  # the extremes of a plane lie on its border
            points += _face_extremes(FaceSurface(face))
    every = point_array(points)
    return every.min(0), every.max(0)


def _edge_extremes(edge: Part.Edge) -> List[Vector]:
    """Return the points of an edge that are highest and lowest along each axis."""
    curve = edge.Curve
    t, points = edge_samples(edge)
    found = []
    for axis in range(3):
        for k in (int(points[:, axis].argmin()), int(points[:, axis].argmax())):
            low, high, at = t[max(k - 1, 0)], t[min(k + 1, len(t) - 1)], float(t[k])
            for _ in range(_STEPS):
                slope, bend = (curve.getDN(at, order)[axis] for order in (1, 2))
                after = min(max(at - slope / bend, low), high) if bend else at
                if after == at:
                    break
                at = float(after)
            found += [curve.value(at), Vector(*points[k])]
    return found


def _face_extremes(surface: FaceSurface) -> List[Vector]:
    """Return points of a face among which are those inside it that are highest and lowest along each axis."""
    grid = surface.grid()
    points = point_array([surface.point(at) for at in grid])
    found = []
    for axis in _AXES:
        for sign in (1, -1):
            order = np.argsort(-sign * (points @ np.array(tuple(axis))), kind="stable")[:_TRIED].tolist()
            start = next((grid[k] for k in order if surface.has(grid[k])), None)
            if start is not None:
                top = _top(surface, start, axis)
                found.append(surface.point(top if surface.has(top) else start))
    return found


def _top(surface: FaceSurface, at: Parameters, axis: Vector) -> Parameters:
    """Return where the surface's height along an axis is stationary, by Newton's iteration."""
    for _ in range(_STEPS):
        along_u, along_v = surface.tangents(at)
        uu, uv, vv = (surface.geometry.getDN(at[0], at[1], *order).dot(axis) for order in ((2, 0), (1, 1), (0, 2)))
        du, dv = solve_two(uu, uv, uv, vv, -along_u.dot(axis), -along_v.dot(axis))
        at = (surface.u.step(at[0], du), surface.v.step(at[1], dv))
        if (along_u * du + along_v * dv).Length < surface.exact:
            break
    return at
