# SPDX-License-Identifier: LGPL-2.1-or-later
"""One example project for each way to work: small, whole, and computed again in seconds.

The bone is real: two specimens of 4 mm from one cube (resources/examples, CC0).
"""

from __future__ import annotations

from typing import Any, Callable, Dict

import FreeCAD

from ..core.analysis.parameters import SliceParameters
from ..core.job import Job, opposite_couplings
from ..core.laws import uniform
from ..core.mesh_readers import read_mesh
from ..core.meshes import weld
from ..core.parameters import PathParameters, PoreParameters, PrismParameters
from ..core.presets import example_file
from ..core.progress import Progress, part, silent
from ..core.voxels.parameters import VoxelParameters
from ..errors import ParameterError
from ..geometry.mesh_objects import mesh_object
from .analysis_makers import make_analysis
from .arguments import given_value
from .designs import make_design
from .makers import all_or_nothing
from .voxel_makers import make_voxel_design

EDGE = 4.0  # mm, of the specimens
_SLICES = SliceParameters(thickness=0.1)


def rods_job() -> Job:
    """Return the design of the first example: a cube as large as the specimens, 3 x 3 sites a face."""
    sides = dict.fromkeys(("l", "w", "h"), EDGE)
    return Job(
        name="example",
        prism=PrismParameters(**sides, n_x=3, n_y=3, n_z=3, a_x=0.7, a_y=0.7, a_z=0.7),
        pores=PoreParameters(size=uniform(0.5, 0.9)),
        path=PathParameters("straight"),
        couplings=opposite_couplings("random"),
    )


def _bone(document: FreeCAD.Document, letter: str, label: str) -> Any:
    bone = document.addObject("Mesh::Feature", "Bone")
    path = example_file(f"shrew_bone_{letter}.ply")
    bone.Label, bone.Mesh = label, mesh_object(weld(read_mesh(path)[0]))
    return bone


def _rods(document: FreeCAD.Document, progress: Progress) -> None:
    """A scaffold in a box, analysed, and bone beside it."""
    design = make_design(document, rods_job(), ("scaffold",), progress=part(progress, 0.0, 0.6))
    make_analysis(document, design.scaffold, _SLICES, progress=part(progress, 0.6, 0.8))
    bone = _bone(document, "a", "Bone")
    bone.Placement.Base = FreeCAD.Vector(1.5 * EDGE, 0, 0)
    make_analysis(document, bone, _SLICES, progress=part(progress, 0.8, 1.0))


def _measure(document: FreeCAD.Document, progress: Progress) -> None:
    """Two specimens of one bone, measured."""
    for number, letter in enumerate("ab"):
        bone = _bone(document, letter, f"Specimen {letter.upper()}")
        bone.Placement.Base = FreeCAD.Vector(1.5 * EDGE * number, 0, 0)
        step = part(progress, 0.5 * number, 0.5 * number + 0.5)
        make_analysis(document, bone, _SLICES, morphometry=True, progress=step)


def _voxels(document: FreeCAD.Document, progress: Progress) -> None:
    """Voxels with the sliced areas of a specimen, measured as it was."""
    bone = _bone(document, "a", "Bone")
    make_analysis(document, bone, _SLICES, progress=part(progress, 0.0, 0.2))
    parameters = VoxelParameters(size=(_SLICES.thickness,) * 3)
    design = make_voxel_design(document, bone, parameters, progress=part(progress, 0.2, 0.8))
    design.Placement.Base = FreeCAD.Vector(1.5 * EDGE, 0, 0)
    make_analysis(document, design, progress=part(progress, 0.8, 1.0))


#: By the name of the way to work.
EXAMPLES: Dict[str, Callable[[FreeCAD.Document, Progress], None]] = {
    "rods": _rods,
    "measure": _measure,
    "voxels": _voxels,
}


def make_example(document: FreeCAD.Document, name: str, progress: Progress = silent) -> None:
    """Add an example project to a document.

    Parameters
    ----------
    document : App.Document
    name : str
        ``rods``, ``measure`` or ``voxels``.
    progress : callable

    Raises
    ------
    ParameterError
        If there is no such example.
    TrabeculaError
        If a step fails; the document is then as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> make.make_example(document, "measure")
    >>> [obj.Label for obj in document.Objects]
    ['Specimen A', 'Analysis Specimen A', 'Specimen B', 'Analysis Specimen B']
    """
    if given_value(name, str) not in EXAMPLES:
        raise ParameterError(f"an example must be one of {', '.join(EXAMPLES)}, got {name!r}")
    with all_or_nothing(document):
        EXAMPLES[name](document, progress)
