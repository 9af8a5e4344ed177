# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that FreeCAD opens and writes through us (*File, Open*, *Import*, *Export*): jobs, and voxels of voxel designs.

``Init.py`` registers it; FreeCAD calls ``open``, ``insert`` and ``export``, with and without a window.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Sequence

import FreeCAD

from .core.job import read_job
from .core.voxels.volume_files import WRITERS
from .errors import ParameterError
from .features.designs import make_design
from .features.jobs import write_job
from .features.relations import type_of, wireframe_of
from .features.voxel_design import voxel_design_of


def open(path: str) -> Any:  # noqa: A001  FreeCAD's name for it
    """Make the design of a job file in a new document, and return the document; the wireframe only: bodies take time.

    Raises
    ------
    TrabeculaError
        If the file is no job, or the design cannot be made; there is no new document then.
    """
    job = read_job(path)
    document = FreeCAD.newDocument(Path(path).stem)
    try:
        make_design(document, job)
    except BaseException:
        FreeCAD.closeDocument(document.Name)
        raise
    return document


def insert(path: str, name: str) -> Any:
    """Make the design of a job file in a document that is open, and return the document.

    Raises
    ------
    TrabeculaError
        If the file is no job, or the design cannot be made; the document is as it was.
    """
    document = FreeCAD.getDocument(name)
    make_design(document, read_job(path))
    return document


def export(objects: Sequence[Any], path: str) -> None:
    """Write what belongs to the selected objects: the job of a design, the voxels of a voxel design.

    Raises
    ------
    TrabeculaError
        If there is no such object, or the file cannot be written.
    """
    kind = Path(path).suffix[1:].lower()
    if kind in WRITERS:
        chosen = next((obj for obj in objects if type_of(obj) == "Trabecula::VoxelDesign"), None)
        if chosen is None:
            raise ParameterError(f"a voxel design must be selected to write {Path(path).name}, got none")
        design = voxel_design_of(chosen)
        WRITERS[kind](path, design.voxels, design.targets.voxel, design.targets.origin)
        return
    wireframe = next((wireframe_of(obj) for obj in objects if type_of(obj) and wireframe_of(obj) is not None), None)
    if wireframe is None:
        raise ParameterError(f"a design of rods must be selected to write {Path(path).name}, got none")
    write_job(wireframe, path)
