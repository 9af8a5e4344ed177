# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a solid, checked: closed, turned outwards, as much volume as the solid has, no face through another.

Curved bodies get triangles by our own rules (``face_triangles``), the same on every version of the kernel; the kernel's
mesher serves flat bodies, where its triangles are exact, and bodies for which ours do not come out right.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Optional

import FreeCAD
import MeshPart
import numpy as np
import Part

from ..core import meshes
from ..errors import EnvelopeError, KernelError, ParameterError, TrabeculaError
from .face_triangles import solid_triangles
from .vectors import point_array

ANGULAR_DEFLECTION = (
    0.3  # radians between neighbouring triangles on a curved face; the kernel's 0.5 is coarse on fillets
)
_FINER = (1.0, 0.7, 0.4)  # parts of the deflection that are tried until the mesh is closed
_FEW_FACES, _FLAT = 60, 1e-9  # of a body of which it is quickly seen that it is convex; share of its size
_STEEP = math.sin(math.radians(15))  # triangles that cross at less belong to a fold of the mesh, not of the body


class Tessellation(NamedTuple):
    """Triangles of a solid, and why they are the kernel's where they may differ between its versions, else ""."""

    mesh: meshes.Mesh
    note: str


class Crossing(NamedTuple):
    """Where the triangles of a solid cross each other: their pairs, the longest crossing (mm) and its middle (mm)."""

    pairs: int
    longest: float
    middle: FreeCAD.Vector


def default_deflection(solid: Part.Shape) -> float:
    """Return the greatest distance (mm) of triangles from the solid: 1/500 of the side of a cube of its volume."""
    return abs(solid.Volume) ** (1 / 3) / 500


def tessellate(solid: Part.Shape, deflection: float = 0.0, angle: float = ANGULAR_DEFLECTION) -> Tessellation:
    """Return the triangles of a solid, in double precision.

    Parameters
    ----------
    solid : Part.Shape
    deflection : float, mm
        Distance of triangles from the solid; 0 chooses ``default_deflection``. A few may be 4/3 of it off; the
        kernel's, 1.7 times on a sphere (0.20.2).
    angle : float
        Greatest angle between neighbouring triangles of one face.

    Raises
    ------
    ParameterError
        If the deflection is negative or no number.
    EnvelopeError
        If the triangles of a part point inwards: the solid is inside out.
    KernelError
        If the kernel gives no closed mesh, or one whose volume is not the solid's to deflection times area.

    Notes
    -----
    The two kernels (OCCT 7.6, 7.9) place triangles on curved faces differently: their volumes agree to the deflection
    only, ours to rounding.
    """
    if not (math.isfinite(deflection) and deflection >= 0):
        raise ParameterError(f"the deflection must be 0 mm or more, got {deflection:g} mm")
    deflection = deflection or default_deflection(solid)
    if _is_flat(solid):
        mesh = _closed_mesh(solid, deflection, angle)
        _require_volume(mesh, solid, deflection)
        return Tessellation(mesh, "")
    try:
        mesh = solid_triangles(solid, deflection, angle).mesh
        meshes.require_closed(mesh, "the triangles of a solid")
        _require_volume(mesh, solid, deflection)
        return Tessellation(mesh, "")
    except (TrabeculaError, Part.OCCError, RuntimeError, ValueError, TypeError, StopIteration) as error:
        reason = str(error)
    mesh = _closed_mesh(solid, deflection, angle)
    _require_volume(mesh, solid, deflection)
    note = f"the envelope's triangles are the kernel's and may differ between versions of FreeCAD: {reason}"
    return Tessellation(mesh, note)


def _is_flat(solid: Part.Shape) -> bool:
    """Return whether all faces are planes between straight edges."""
    if not all(isinstance(face.Surface, Part.Plane) for face in solid.Faces):
        return False
    return all(isinstance(edge.Curve, Part.Line) for edge in solid.Edges if not edge.Degenerated)


def _require_volume(mesh: meshes.Mesh, solid: Part.Shape, deflection: float) -> None:
    volume = meshes.mesh_volume(mesh)
    if not volume > 0:
        raise EnvelopeError(
            f"a solid must have a volume greater than 0, got {volume:.6g} mm3: it is empty or inside out"
        )
    tolerance = deflection * solid.Area + 1e-9 * abs(solid.Volume)
    if not abs(volume - solid.Volume) <= tolerance:
        raise KernelError(
            f"the triangles' volume must be the solid's to {tolerance:.3g} mm3 (deflection times area), "
            f"got {volume:.6g} against {solid.Volume:.6g} mm3"
        )


def _closed_mesh(solid: Part.Shape, deflection: float, angle: float) -> meshes.Mesh:
    for part in _FINER:
        # A copy of its own: the triangles of a shape on screen stay as they are.
        copy = solid.copy()
        kernel_mesh(copy, part * deflection, angle)
        # The shape now holds those triangles; this reads them, in double precision and with common vertices.
        points, triangles = copy.tessellate(part * deflection)
        mesh = meshes.Mesh(point_array(points), np.array(triangles, np.int64).reshape(-1, 3))
        if meshes.is_closed(mesh):
            return mesh
    meshes.require_closed(mesh, "the triangles of a solid")
    raise AssertionError  # not reached: the line above raises


def kernel_mesh(shape: Part.Shape, deflection: float, angle: float = ANGULAR_DEFLECTION) -> Any:
    """Return the kernel's mesh of a shape, single precision; the shape keeps its triangles.

    Raises
    ------
    KernelError
        If the mesher fails.
    """
    try:
        return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection, AngularDeflection=angle, Relative=False)
    except (Part.OCCError, RuntimeError, ValueError) as error:
        raise KernelError(f"the kernel made no triangles of a solid at a deflection of {deflection:g} mm") from error


def _is_convex(solid: Part.Shape) -> bool:
    """Return whether a solid has a few plane faces and lies on one side of each."""
    if len(solid.Faces) > _FEW_FACES or not all(isinstance(face.Surface, Part.Plane) for face in solid.Faces):
        return False
    corners = point_array(vertex.Point for vertex in solid.Vertexes)
    near = _FLAT * np.ptp(corners, axis=0).max()
    for face in solid.Faces:
        heights = (corners - np.array(tuple(face.Surface.Position))) @ np.array(tuple(face.Surface.Axis))
        if heights.max() > near and heights.min() < -near:
            return False
    return True


def find_crossing(solid: Part.Shape, deflection: float = 0.0) -> Optional[Crossing]:
    """Return where the faces of a solid cross, or None if they do not.

    The triangles are asked, not the surfaces: the kernel's own check of a 4-face femur takes 215 s, this 0.2 s. Two
    that cross at a small angle, or one of which is a sliver, are left out: meshes fold like that at the poles of domes.

    A convex body has no such faces and is not asked, so that a box never is: the window checks boxes in another thread,
    and Qt crashed once while FreeCAD's search, which has a progress bar, ran there.
    """
    if _is_convex(solid):
        return None
    deflection = deflection or default_deflection(solid)
    copy = solid.copy()
    # Near the origin single precision is good enough.
    shift = solid.CenterOfMass
    copy.translate(shift * -1)
    mesh = kernel_mesh(copy, deflection)
    pairs = mesh.getSelfIntersections()
    if not pairs:
        return None
    points, triangles = mesh.Topology
    corners = point_array(points)[np.array(triangles)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    normals /= lengths[:, None].clip(1e-30)
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(1)
    height = lengths / edges.clip(1e-30)
    first, second = (np.array([pair[k] for pair in pairs]) for k in (0, 1))
    start, end = (point_array([pair[k] for pair in pairs]) for k in (2, 3))
    length = np.linalg.norm(end - start, axis=1)
    real = (np.linalg.norm(np.cross(normals[first], normals[second]), axis=1) > _STEEP) & (length > deflection)
    real &= np.minimum(height[first], height[second]) > deflection
    if not real.any():
        return None
    k = int(np.argmax(np.where(real, length, 0)))
    return Crossing(int(real.sum()), float(length[k]), FreeCAD.Vector(*((start[k] + end[k]) / 2).tolist()) + shift)
