# SPDX-License-Identifier: LGPL-2.1-or-later
"""What objects show, as files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ..errors import ParameterError
from ..geometry.files import write_mesh, write_shape
from ..geometry.mesh_objects import core_mesh
from .arguments import given_object, given_value
from .on_demand import OUT_OF_DATE


def export(obj: Any, path: str) -> None:
    """Write what an object shows into a file; unit mm.

    Parameters
    ----------
    obj : document object
        A mesh (scaffold, channels, loose pieces, voids) or a shape (network, solid scaffold, envelope).
    path : str
        A mesh goes to ``.stl`` (binary), ``.ply``, ``.obj``, ``.3mf``, a shape to ``.step``, ``.brep``, ``.iges``.

    Raises
    ------
    ParameterError
        If the object is in error or out of date, shows nothing, or the extension is not of its kind.
    ExportError
        If the file cannot be written; what stood under that name before stays.

    Examples
    --------
    >>> import os, tempfile, FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> scaffold = make.make_scaffold(make.make_design(FreeCAD.newDocument(), preset("case1")).wireframe)
    >>> path = os.path.join(tempfile.mkdtemp(), "scaffold.stl")
    >>> make.export(scaffold, path)
    >>> os.path.getsize(path) == 84 + 50 * scaffold.Mesh.CountFacets
    True
    """
    if not given_object(obj).isValid():
        raise ParameterError(
            f"{obj.Label} must be without error to be written, got {getattr(obj, 'Status', 'an error')}"
        )
    if getattr(obj, "Status", "") == OUT_OF_DATE:
        raise ParameterError(f"{obj.Label} must be up to date to be written: update it first")
    if hasattr(obj, "Mesh"):
        if not obj.Mesh.CountFacets:
            raise ParameterError(f"{obj.Label} must have triangles to be written, got 0")
        write_mesh(given_value(path, str, Path), core_mesh(obj.Mesh))
    elif hasattr(obj, "Shape"):
        write_shape(given_value(path, str, Path), obj.Shape)
    else:
        raise ParameterError(f"{obj.Label} must have a mesh or a shape to be written, got neither")
