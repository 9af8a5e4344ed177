# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids made from closed triangle meshes by FreeCAD's own shape-from-mesh, where that is reasonable."""

from __future__ import annotations

from typing import Any, List, Tuple

import numpy as np
import Part

from ..core import meshes
from ..core.rays import contains
from ..errors import EnvelopeError, KernelError
from .mesh_objects import core_mesh
from .vectors import vectors

#: Triangles above which a solid of as many faces is not reasonable: 8,000 take 7 s to make, 16,000 half a minute, and
#: every later step sees that many faces.
MOST_TRIANGLES = 8000
_SEWING = 1e-6  # mm; equal vertices are one already, so that nothing is left to be sewn
_COPLANAR = 1e-6  # sine of the angle of neighbours that are one plane face


def solids_of_mesh(mesh: Any) -> Tuple[List[Part.Shape], List[str]]:
    """Return the solids that a mesh bounds, and notes of what was mended.

    Parameters
    ----------
    mesh : Mesh.Mesh

    Returns
    -------
    solids : list of Part.Solid
        One per body; neighbouring triangles of one plane are one face, cavities belong to the body around them.
    notes : list of str

    Raises
    ------
    EnvelopeError
        If the mesh is empty, has holes or edges of more than two triangles, is turned unevenly, or has more than
        ``MOST_TRIANGLES``.
    KernelError
        If the kernel makes another solid of it.
    """
    closed = _closed(mesh)
    notes: List[str] = []
    if meshes.mesh_volume(closed) < 0:
        closed = meshes.Mesh(closed.vertices, closed.triangles[:, ::-1])
        notes.append("the mesh was inside out; its triangles have been turned round")
    parts = meshes.split(closed)
    bodies = [part for part in parts if meshes.mesh_volume(part) > 0]
    cavities = [part for part in parts if meshes.mesh_volume(part) <= 0]
    return [_solid(body, [c for c in cavities if _is_in(c, body)]) for body in bodies], notes


def _closed(mesh: Any) -> meshes.Mesh:
    """Return the triangles of a mesh, welded; refuse what bounds no body."""
    if not mesh.CountFacets:
        raise EnvelopeError("a mesh must have triangles, got 0")
    if mesh.CountFacets > MOST_TRIANGLES:
        raise EnvelopeError(
            f"a mesh must have at most {MOST_TRIANGLES} triangles to become a solid, got {mesh.CountFacets}: reduce it "
            "(Mesh > Decimation) or give a STEP file"
        )
    welded = meshes.weld(core_mesh(mesh).corners)
    t = welded.triangles
    welded = meshes.Mesh(welded.vertices, t[(t[:, 0] != t[:, 1]) & (t[:, 1] != t[:, 2]) & (t[:, 2] != t[:, 0])])
    faults = meshes.edge_faults(welded)
    if faults.open:
        raise EnvelopeError(
            f"a mesh must be closed to become a solid, got {_holes(welded)} holes with {faults.open} open edges"
        )
    if not meshes.is_closed(welded):
        raise EnvelopeError(
            "a mesh must have two triangles at each edge, turned alike, to become a solid; got "
            f"{faults.non_manifold} edges of more than two and {faults.unbalanced} edges of triangles turned unevenly"
        )
    return welded


def _holes(mesh: meshes.Mesh) -> int:
    """Return the number of holes: pieces of the open border that hang together."""
    start, end = (ends.astype(np.int64) for ends in meshes.directed_edges(mesh))
    key = np.minimum(start, end) * len(mesh.vertices) + np.maximum(start, end)
    _, inverse, uses = np.unique(key, return_inverse=True, return_counts=True)
    one = uses[inverse] == 1
    # Open edges as triangles without area, so that `components` counts them.
    border = meshes.Mesh(mesh.vertices, np.stack([start[one], end[one], end[one]], 1))
    return int(meshes.components(border).max(initial=-1)) + 1


def _is_in(cavity: meshes.Mesh, body: meshes.Mesh) -> bool:
    return bool(contains(body.corners, cavity.vertices[:1])[0])


def _solid(body: meshes.Mesh, cavities: List[meshes.Mesh]) -> Part.Shape:
    """Return one body as a solid, its plane regions one face each."""
    shells = [shell for part in (body, *cavities) for shell in _shells(part)]
    try:
        solid = Part.Solid(Part.Compound(shells))
        if _has_coplanar(body):
            refined = solid.removeSplitter()
            if len(refined.Solids) == 1 and abs(refined.Volume - solid.Volume) <= 1e-6 * abs(solid.Volume):
                solid = refined.Solids[0]
    except (Part.OCCError, RuntimeError, ValueError) as error:
        raise KernelError(f"the kernel made no solid of {len(body.triangles)} triangles: {error}") from error
    volume = sum(meshes.mesh_volume(part) for part in (body, *cavities))
    if not abs(abs(solid.Volume) - volume) <= 1e-6 * volume:
        raise KernelError(f"a solid from a mesh must have its volume of {volume:.6g} mm3, got {solid.Volume:.6g} mm3")
    return solid


def _shells(mesh: meshes.Mesh) -> List[Part.Shape]:
    shape = Part.Shape()
    shape.makeShapeFromMesh((vectors(mesh.vertices), [tuple(t) for t in mesh.triangles.tolist()]), _SEWING, True)
    return shape.Shells


def _has_coplanar(mesh: meshes.Mesh) -> bool:
    """Return whether neighbouring triangles lie in one plane: only then is there anything to unite, which is slow."""
    corners = mesh.corners
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True).clip(1e-300)
    start, end = meshes.directed_edges(mesh)
    triangle = np.tile(np.arange(len(corners)), 3)
    order = np.argsort(np.minimum(start, end) * len(mesh.vertices) + np.maximum(start, end), kind="stable")
    a, b = triangle[order[::2]], triangle[order[1::2]]
    aligned = (np.linalg.norm(np.cross(normals[a], normals[b]), axis=1) < _COPLANAR) & (
        (normals[a] * normals[b]).sum(1) > 0
    )
    return bool(aligned.any())
