# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's meshes and solids as triangles to be sliced, and the exact slices of a solid: the second route."""

from __future__ import annotations

from typing import List

import FreeCAD
import Mesh
import numpy as np
import Part

from ..core import meshes
from ..core.analysis.parameters import axis_frame
from ..core.analysis.triangles import Soup, soup_of
from ..core.parameters import RodParameters
from ..core.progress import Progress, silent
from ..core.rods import rod_mesh
from ..core.wireframe import Wireframe, skin
from ..errors import EnvelopeError, KernelError, MeshError
from .mesh_objects import core_mesh
from .tessellation import tessellate

_MARGIN = 1.0  # mm by which a cutting plane is larger than the body


def mesh_soup(mesh: Mesh.Mesh, source: str = "") -> Soup:
    """Return the triangles of a FreeCAD mesh where it is placed.

    Raises
    ------
    MeshError
        If it has none.

    Examples
    --------
    >>> mesh_soup(Mesh.createBox(1, 2, 3)).triangles.shape
    (12, 3, 3)
    """
    return soup_of(core_mesh(mesh), source)


def shape_soup(shape: Part.Shape, deflection: float = 0.0, source: str = "", progress: Progress = silent) -> Soup:
    """Return the triangles of the solids of a shape, where they are placed.

    Parameters
    ----------
    shape : Part.Shape
        Solids that overlap are not united: see ``SliceParameters.fill``.
    deflection : float, mm
        Distance of the triangles from the surface; 0 chooses it from each solid's size.
    source : str
    progress : callable

    Raises
    ------
    EnvelopeError
        If there is no solid, or one has no closed mesh.

    Examples
    --------
    >>> shape_soup(Part.makeBox(1, 2, 3)).triangles.shape
    (12, 3, 3)
    """
    if not shape.Solids:
        kind = "no shape" if shape.isNull() else f"a {shape.ShapeType.lower()} without one"
        raise EnvelopeError(f"{source or 'what is sliced'} must have at least one solid, got {kind}")
    found: List[meshes.Mesh] = []
    for done, solid in enumerate(shape.Solids):
        progress(done, len(shape.Solids), "triangles of solids")
        found.append(tessellate(solid, deflection).mesh)
    return soup_of(meshes.join(found), source)


def rods_soup(wireframe: Wireframe, parameters: RodParameters, source: str = "") -> Soup:
    """Return the triangles of a wireframe's rods, each closed by its end sections; they overlap where rods cross.

    Raises
    ------
    MeshError
        If there is no rod.
    """
    if not len(wireframe):
        raise MeshError(f"{source or 'a network'} must have at least one rod, got 0")
    vertices, triangles = rod_mesh(skin(wireframe, parameters), 0.0)
    return Soup(vertices.astype(np.float32)[:, triangles].reshape(-1, 3, 3), source=source)


def exact_areas(shape: Part.Shape, axis: str, heights: np.ndarray, progress: Progress = silent) -> np.ndarray:
    """Return the area (S,), mm², in which planes cut the solids of a shape; no triangles are made.

    Parameters
    ----------
    shape : Part.Shape
        Solids that overlap count once each, as often as they overlap.
    axis : str
        ``x``, ``y``, ``z`` or a direction (see ``core.analysis.parameters.axis_name``).
    heights : ndarray of shape (S,), mm
        Co-ordinates of the planes along the axis; one that lies in a face of the body has no certain area.
    progress : callable

    Raises
    ------
    EnvelopeError
        If there is no solid.
    KernelError
        If the kernel cannot cut.

    Examples
    --------
    >>> exact_areas(Part.makeBox(1, 2, 3), "x", np.array([0.5])).round(9).tolist()
    [6.0]
    """
    if not shape.Solids:
        raise EnvelopeError("a shape that is cut must have at least one solid, got none")
    first, _, along = (FreeCAD.Vector(*row) for row in axis_frame(axis))
    box = shape.BoundBox
    half = box.DiagonalLength / 2 + _MARGIN
    areas = np.zeros(len(heights))
    for k, height in enumerate(heights.tolist()):
        progress(k, len(heights), "exact slices")
        middle = box.Center + along * (height - box.Center.dot(along))
        across = along.cross(first)
        corner = middle - first * half - across * half
        plane = Part.makePlane(2 * half, 2 * half, corner, along, first)
        for solid in shape.Solids:
            try:
                areas[k] += sum(face.Area for face in plane.common(solid).Faces)
            except Part.OCCError as error:
                raise KernelError(f"the plane at {height:g} mm along {axis} could not be cut: {error}") from error
    return areas
