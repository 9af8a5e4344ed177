# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangle meshes between the core and FreeCAD's mesh kernel.

The kernel keeps single precision, and its ``Volume`` is summed in single precision too (2e-4 off for half a million
triangles): volumes are taken from the core's mesh. PLY through memory carries 500,000 triangles in 0.1 s CPU with their
vertices as numbered; tuples of vectors take ten times as long, STL forgets which triangles share a vertex.
"""

from __future__ import annotations

import io
import tempfile
from pathlib import Path

import Mesh
import numpy as np

from ..core import meshes
from ..core.mesh_formats import mesh_from_ply, ply_bytes
from ..errors import KernelError


def mesh_object(mesh: meshes.Mesh) -> Mesh.Mesh:
    """Return FreeCAD's mesh of a mesh, the same vertices and triangles.

    Parameters
    ----------
    mesh : meshes.Mesh
        Pass it through ``meshes.printable`` first if vertices may lie closer than single precision tells apart.

    Raises
    ------
    KernelError
        If the kernel took it differently: other counts, or open where the mesh is closed.
    """
    result = Mesh.Mesh()
    if not len(mesh.triangles):
        return result
    result.read(Stream=io.BytesIO(ply_bytes(mesh)), Format="PLY")
    counts = result.CountPoints, result.CountFacets
    if counts != (len(mesh.vertices), len(mesh.triangles)):
        raise KernelError(
            f"the mesh kernel must hold {len(mesh.vertices)} vertices and {len(mesh.triangles)} triangles, "
            f"got {counts[0]} and {counts[1]}"
        )
    if meshes.is_closed(mesh) and not result.isSolid():
        raise KernelError(f"the mesh kernel must hold a closed mesh, got an open one of {counts[1]} triangles")
    return result


def core_mesh(mesh: Mesh.Mesh) -> meshes.Mesh:
    """Return a FreeCAD mesh, where it is placed, as vertices and triangles.

    Raises
    ------
    MeshError
        If the kernel wrote what cannot be read.
    """
    if not mesh.CountFacets:
        return meshes.Mesh(np.zeros((0, 3)), np.zeros((0, 3), int))
    with tempfile.TemporaryDirectory(prefix="trabecula-") as folder:
        path = Path(folder) / "mesh.ply"  # writing to a stream loses the first kilobytes (0.20.2 and 1.1.3)
        mesh.write(str(path))
        return mesh_from_ply(path.read_bytes())
