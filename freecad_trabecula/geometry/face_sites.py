# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites on any face by curvilinear co-ordinates (thesis 4.2.2), and the frame of a site placed by hand."""

from __future__ import annotations

import math
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

import FreeCAD
import numpy as np
import Part

from ..core.parameters import FaceParameters
from ..core.progress import Progress, silent
from ..core.sites import Sites
from ..errors import KernelError, ParameterError
from .coordinate_lines import MEETING, CoordinateLine, Half, tangential
from .surfaces import FaceSurface, Parameters
from .vectors import point_array, vector

Vector = FreeCAD.Vector

LENGTH_TOLERANCE = 1e-6  # mm; a site this much too near to the border still counts, so that 5 mm hold 5 steps of 1 mm
COINCIDENCE = 1e-3  # mm; sites nearer to each other are one: lines that converge at a pole share it
MOST_SITES = 100_000  # on one face; more take minutes, and no printer would make them
PICK_REACH = 1.0  # mm; farther from the face a point is not meant to be on it
_CHECKED = (
    1e-3  # mm; sites nearer to the border are not asked whether the face has them: the kernel's answer is not sure
)
_STEEP = 0.1  # sine of the angle between d1 and the normal below which a site takes its line's own tangent
_PARALLEL = math.sin(math.radians(1))  # d1 and d2 must part by this much


class _Site(NamedTuple):
    index: Tuple[int, int]
    point: Vector
    u: Vector
    normal: Vector


def face_sites(
    face: Part.Face, name: str, parameters: FaceParameters, outer: int = 1, progress: Progress = silent
) -> Sites:
    """Return the sites of a face.

    Parameters
    ----------
    face : Part.Face
        A face of the envelope's solid.
    name : str
        Name of the face in couplings and reports.
    parameters : FaceParameters
    outer : int
        1 if the oriented face's normal points out of the envelope (faces of a proper solid), -1 if it points in.
    progress : callable

    Returns
    -------
    Sites
        ``index`` is (i along u, j along v); site (0, 0) is the origin, if it is not too near to the border.

    Raises
    ------
    ParameterError
        If the origin is off the face, a direction is along the normal there or along the other, or the spacings give
        more than ``MOST_SITES``.
    KernelError
        If a line cannot be followed.

    Notes
    -----
    Thesis 4.2.2: sites on the line u at u_i = c_u i, n+ = Int((l+ - b_u) / c_u), n- likewise; the same along v, each
    point of which is the origin of a line u' (d1 projected). On a line that comes round after L the sites are those
    in (-L/2, L/2], at least c apart also across its end; it has no border. Where a line u' meets the line v again
    (the far side of a sphere), it ends half way, since the other half is another origin's.

    Examples
    --------
    >>> box = Part.makeBox(10, 10, 10)
    >>> len(face_sites(box.Faces[5], "top", FaceParameters(c_u=2.0, c_v=2.0, b_u=1.0, b_v=1.0)))
    25
    """
    _check_number(face, name, parameters)
    surface = FaceSurface(face, outer)
    at = _origin(surface, name, parameters)
    d1, d2 = directions(surface, at, parameters.d1, parameters.d2)
    line_v = CoordinateLine(surface, at, d2)
    steps = _steps(line_v, parameters.c_v, parameters.b_v)
    found: List[_Site] = []
    for done, j in enumerate(steps):
        progress(done, len(steps), f"sites on {name}")
        found += _sites_of_line(surface, line_v, j, d1, parameters)
    return _join(name, _without_doubles(found))


def directions(
    surface: FaceSurface, at: Parameters, d1: Optional[Sequence[float]] = None, d2: Optional[Sequence[float]] = None
) -> Tuple[Vector, Vector]:
    """Return the directions d1 and d2 (unit, in the tangent plane at the origin), those not given from the face itself.

    The face's own d1 is its longest straight edge if it is plane, the meridian on cones, tori and other surfaces of
    revolution, else the direction in which its first parameter grows;
    the other direction lies across the first, such that d1, d2 and the outer normal are right-handed.

    Raises
    ------
    ParameterError
        If a direction is along the normal, or both are parallel.
    """
    normal = surface.normal(at)
    if d1 is None and d2 is not None:
        second = tangential(vector(d2), normal)
        return second.cross(normal), second
    first = tangential(vector(d1), normal) if d1 is not None else _own_direction(surface, at, normal)
    second = tangential(vector(d2), normal) if d2 is not None else normal.cross(first)
    if first.cross(second).Length < _PARALLEL:
        angle = math.degrees(math.asin(min(1.0, first.cross(second).Length)))
        raise ParameterError(f"d1 and d2 must differ by at least 1 degree on the face, got {angle:.3g} degrees")
    return first, second


def pick_site(
    face: Part.Face,
    point: Sequence[float],
    d1: Optional[Sequence[float]] = None,
    outer: int = 1,
    reach: float = PICK_REACH,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the site at a point of a face: for sites added or moved by hand.

    Parameters
    ----------
    face : Part.Face
    point : sequence of 3 floats, mm
        On the face or near it.
    d1 : sequence of 3 floats, optional
        Direction of the first axis; none means the face's own there.
    outer : int
        As in ``face_sites``.
    reach : float, mm
        Greatest distance of the point from the face.

    Returns
    -------
    point, u, normal : ndarray of shape (3,)
        The nearest point of the face (mm), unit first axis, unit outer normal.

    Raises
    ------
    ParameterError
        If the point is farther from the face than ``reach``.
    """
    surface = FaceSurface(face, outer)
    at = _on_face(surface, vector(point), reach, "a site placed by hand")
    normal = surface.normal(at)
    try:
        u = directions(surface, at, d1)[0]
    except ParameterError:  # d1 belongs to the face's origin; it may be steep elsewhere
        u = directions(surface, at)[0]
    return tuple(point_array([surface.point(at), u, normal]))


# ------------------------------------------------------------------------------------------------------ the origin


def _origin(surface: FaceSurface, name: str, parameters: FaceParameters) -> Parameters:
    if parameters.origin is None:
        return surface.centre()
    return _on_face(surface, vector(parameters.origin), PICK_REACH, f"the origin on face {name}")


def _on_face(surface: FaceSurface, point: Vector, reach: float, what: str) -> Parameters:
    """Return the parameters of the face's point nearest to a point."""
    at = surface.nearest(point)
    if not surface.has(at):
        distance, pairs, _ = surface.face.distToShape(Part.Vertex(point))
        at = surface.nearest(pairs[0][0])
    distance = (surface.point(at) - point).Length
    if not distance <= reach:
        raise ParameterError(f"{what} must lie on it to {reach:g} mm, got a distance of {distance:.4g} mm")
    return at


def _own_direction(surface: FaceSurface, at: Parameters, normal: Vector) -> Vector:
    """Return the face's own first direction."""
    if isinstance(surface.geometry, Part.Plane):
        straight = [e for e in surface.face.Edges if isinstance(e.Curve, (Part.Line, Part.LineSegment))]
        if straight:
            longest = max(round(e.Length, 6) for e in straight)
            edge = next(e for e in straight if round(e.Length, 6) == longest)
            return tangential(_positive(edge.Vertexes[-1].Point - edge.Vertexes[0].Point), normal)
        return tangential(_positive(surface.tangents(at)[0]), normal)
    # Lines u' along the meridians cover a torus; those around it would meet the line v again.
    round_axis = isinstance(surface.geometry, (Part.Cone, Part.Toroid, Part.SurfaceOfRevolution))
    along_u = surface.tangents(at)[1 if round_axis else 0]
    if along_u.Length < 1e-9 * surface.size:  # at a pole every direction is as good as another
        axis = min((Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)), key=lambda a: round(abs(a.dot(normal)), 6))
        return tangential(axis, normal)
    return tangential(along_u, normal)


def _positive(direction: Vector) -> Vector:
    """Return a direction or its opposite: the one whose largest component is positive."""
    largest = max(direction, key=lambda c: round(abs(c), 9))
    return direction if largest > 0 else direction * -1


# ------------------------------------------------------------------------------------------------------- the lines


def _check_number(face: Part.Face, name: str, parameters: FaceParameters) -> None:
    number = face.Area / (parameters.c_u * parameters.c_v)
    if not number <= MOST_SITES:
        raise ParameterError(
            f"a face must have at most {MOST_SITES} sites, but spacings of {parameters.c_u:g} and "
            f"{parameters.c_v:g} mm give about {number:.3g} on {name}"
        )


def _sites_of_line(
    surface: FaceSurface, line_v: CoordinateLine, j: int, d1: Vector, parameters: FaceParameters
) -> List[_Site]:
    """Return the sites of the line u' whose origin is the point j of the line v."""
    v = j * parameters.c_v
    at = line_v.at(v)
    direction = _leading(d1, surface.normal(at), line_v.across * (1 if d1.dot(line_v.across) > 0 else -1))
    across = surface.normal(at).cross(direction)
    line = CoordinateLine(surface, at, direction, line_v.crossings(surface.point(at), across, but=v))
    found = []
    for i in _steps(line, parameters.c_u, parameters.b_u, later=j > 0):
        here = line.at(i * parameters.c_u)
        if min(parameters.b_u, parameters.b_v) > _CHECKED and not surface.has(here):
            raise KernelError(
                f"site ({i}, {j}) came to lie outside its face, a line of which crossed the border unnoticed"
            )
        normal = surface.normal(here)
        found.append(_Site((i, j), surface.point(here), _leading(d1, normal, line.tangent_at(here)), normal))
    return found


def _leading(d1: Vector, normal: Vector, spare: Vector) -> Vector:
    """Return d1's part in the tangent plane, unit; that of ``spare`` where d1 is all but along the normal."""
    return tangential(d1 if d1.cross(normal).Length > _STEEP else spare, normal)


def _steps(line: CoordinateLine, spacing: float, border: float, later: bool = False) -> range:
    """Return the numbers of the points on a line (thesis 4.2.2)."""
    if line.closed:
        number = math.floor((line.plus.length + LENGTH_TOLERANCE) / spacing)
        return range(-((number - 1) // 2), number // 2 + 1)
    return range(-_steps_of(line.minus, spacing, border, later), _steps_of(line.plus, spacing, border, later) + 1)


def _steps_of(half: Half, spacing: float, border: float, later: bool) -> int:
    """Return n of one half of a line: Int((l - b) / c); -1 where even the origin is too near to the border."""
    if half.end == MEETING:  # the point half way belongs to one of the two lines
        return math.floor((half.length / 2 + (-LENGTH_TOLERANCE if later else LENGTH_TOLERANCE)) / spacing)
    return math.floor((half.length - border + LENGTH_TOLERANCE) / spacing)


# ------------------------------------------------------------------------------------------------------- the sites


def _without_doubles(found: List[_Site]) -> List[_Site]:
    """Return the sites without those that coincide with one of a line nearer to the origin."""
    taken: Dict[Tuple[int, ...], List[Vector]] = {}
    kept = []
    for site in sorted(found, key=lambda s: (abs(s.index[1]), abs(s.index[0]), s.index)):
        cell = tuple(math.floor(c / COINCIDENCE) for c in site.point)
        around = (tuple(c + d for c, d in zip(cell, shift)) for shift in np.ndindex(3, 3, 3))
        around = (tuple(c - 1 for c in key) for key in around)
        if all((p - site.point).Length > COINCIDENCE for key in around for p in taken.get(key, ())):
            taken.setdefault(cell, []).append(site.point)
            kept.append(site)
    return sorted(kept, key=lambda s: s.index[::-1])


def _join(name: str, found: List[_Site]) -> Sites:
    return Sites(
        name,
        np.array([site.index for site in found], np.int64).reshape(-1, 2),
        point_array(site.point for site in found),
        point_array(site.u for site in found),
        point_array(site.normal for site in found),
        np.ones(len(found), bool),
    )
