# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that make voxel designs in a document, and shapes of their layers."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any, List, Optional, Sequence, Tuple, Union

import FreeCAD
import numpy as np

from ..core.booleans import combine
from ..core.meshes import printable, weld
from ..core.progress import Progress, silent
from ..core.voxels.blocks import block_mesh
from ..core.voxels.design import Estimate, estimate
from ..core.voxels.drawn_curves import DrawnCurves, targets_of_curves
from ..core.voxels.parameters import VoxelParameters
from ..core.voxels.sources import MESHES, areas_of_profiles, layers_of_source, read_triangles, targets_of_profiles
from ..core.voxels.targets import layer_counts_of_box
from ..errors import ParameterError
from ..geometry.mesh_objects import mesh_object
from ..geometry.voxel_shapes import layer_solids, layer_wires
from .analysis import Analysis, analysis_of
from .analysis_source import file_source, object_source, soup_of_source
from .arguments import given_in, given_numbers, given_object, given_value
from .base import write_parameters
from .containers import place_beside
from .feature import is_a, update
from .makers import add, all_or_nothing
from .voxel_design import VoxelDesign, check_surface, voxel_design_of
from .voxel_inputs import curves_of, flat_tables, keep_curves


def make_voxel_design(
    document: FreeCAD.Document,
    source: Union[Any, str, DrawnCurves],
    parameters: Optional[VoxelParameters] = None,
    envelope: Any = None,
    surface: str = "blocks",
    progress: Progress = silent,
    tables: Optional[Sequence[Any]] = None,
) -> Any:
    """Add voxels whose sliced areas along X, Y and Z equal those of a sample, and return the object.

    Parameters
    ----------
    document : App.Document
    source : document object, str or DrawnCurves
        The sample: a mesh, a solid, an analysis, a body of ours; or the path of a file; or curves.
    parameters : VoxelParameters, optional
    envelope : document object, optional
        Body within which voxels may lie.
    surface : str
        ``blocks`` or ``smooth``.
    progress : callable
    tables : pair of arrays (N, P), (M, P), optional
        alpha and beta, of which the layers are to be filled; their cells may also stand one after the other.

    Raises
    ------
    TrabeculaError
        If there is no such design, or a value is refused; the document is as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.voxels.parameters import VoxelParameters
    >>> document = FreeCAD.newDocument()
    >>> ring = document.addObject("Part::Feature", "Ring")
    >>> ring.Shape = make.make_box(document, 4, 4, 4).Shape.cut(make.make_box(document, 2, 2, 4).Shape)
    >>> design = make.make_voxel_design(document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
    >>> design.Voxels, design.Exact, design.Components
    (384, True, 1)
    """
    check_surface(surface)
    given_value(parameters, VoxelParameters, type(None))
    if not isinstance(source, (DrawnCurves, str)):
        given_in(document, given_object(source))
    given_in(document, envelope)
    with all_or_nothing(document):
        obj = add(document, VoxelDesign, "VoxelDesign", "Mesh::FeaturePython", Surface=surface, Envelope=envelope)
        if isinstance(source, DrawnCurves):
            keep_curves(obj, source)
            obj.Label = "Voxels of drawn curves"
        elif isinstance(source, str):
            obj.File, obj.Label = source, f"Voxels {Path(source).stem}"
        else:
            place_beside(obj, source)
            obj.Source, obj.Label = source, f"Voxels {source.Label}"
        write_parameters(obj, parameters or VoxelParameters())
        obj.Alpha, obj.Beta = flat_tables(tables) or ((), ())
        update(obj, progress)
    return obj


def change_voxel_design(
    obj: Any,
    parameters: VoxelParameters,
    envelope: Any = None,
    surface: str = "blocks",
    progress: Progress = silent,
    tables: Optional[Sequence[Any]] = None,
    curves: Optional[DrawnCurves] = None,
) -> None:
    """Design the voxels of an object in another way; arguments as for ``make_voxel_design``.

    Parameters
    ----------
    obj : document object
        A voxel design.
    parameters, envelope, surface, progress, tables
        What it is to have; without tables they are drawn.
    curves : DrawnCurves, optional
        In place of those it has, if it was made of curves.

    Raises
    ------
    TrabeculaError
        If there is no such design; the document is as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.voxels.parameters import VoxelParameters
    >>> document = FreeCAD.newDocument()
    >>> ring = document.addObject("Part::Feature", "Ring")
    >>> ring.Shape = make.make_box(document, 4, 4, 4).Shape.cut(make.make_box(document, 2, 2, 4).Shape)
    >>> design = make.make_voxel_design(document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
    >>> make.change_voxel_design(design, VoxelParameters(size=(1.0, 1.0, 1.0)))
    >>> design.Voxels
    48
    """
    check_surface(surface)
    given_value(parameters, VoxelParameters)
    given_in(given_object(obj, VoxelDesign).Document, envelope)
    if curves is not None and curves_of(obj) is None:
        raise ParameterError(f"{obj.Label} must be made of curves to get others, it follows another sample")
    with all_or_nothing(obj.Document, [obj]):
        write_parameters(obj, parameters)
        obj.Envelope, obj.Surface = envelope, surface
        obj.Alpha, obj.Beta = flat_tables(tables) or ((), ())
        if curves is not None:
            keep_curves(obj, given_value(curves, DrawnCurves))
        update(obj, progress)


def layer_areas_of(analysis: Any) -> Tuple[List[np.ndarray], float]:
    """Return the sliced areas of an analysis along X, Y and Z, mm², and the thickness of its layers, mm.

    Parameters
    ----------
    analysis : document object

    Raises
    ------
    ParameterError
        If it has not all three axes, or layers of different thickness.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> analysis = make.make_analysis(document, make.make_box(document, 2, 3, 4))
    >>> areas, thickness = make.layer_areas_of(analysis)
    >>> [round(float(own.mean()), 6) for own in areas]
    [12.0, 8.0, 6.0]
    """
    found, thickness = analysis_of(analysis), float(analysis.SliceThickness.Value)
    return areas_of_profiles(found, (thickness,) * 3), thickness


def make_layer_shapes(obj: Any, layers: Sequence[int], solid: bool = False, progress: Progress = silent) -> Any:
    """Add the merged outlines of layers along Z of a voxel design (Fig. 6.12) as wires, or the layers as solids.

    Parameters
    ----------
    obj : document object
        A voxel design.
    layers : sequence of int
        From 0.
    solid : bool
    progress : callable

    Raises
    ------
    TrabeculaError
        If a layer is none of the design's; the document is as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.voxels.parameters import VoxelParameters
    >>> document = FreeCAD.newDocument()
    >>> ring = document.addObject("Part::Feature", "Ring")
    >>> ring.Shape = make.make_box(document, 4, 4, 4).Shape.cut(make.make_box(document, 2, 2, 4).Shape)
    >>> design = make.make_voxel_design(document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
    >>> round(make.make_layer_shapes(design, [0, 7], True).Shape.Volume, 6)
    12.0
    """
    design = voxel_design_of(obj)
    make = layer_solids if solid else layer_wires
    shape = make(design.voxels, design.targets.voxel, design.targets.origin, given_numbers(layers), progress)
    with all_or_nothing(obj.Document):
        found = obj.Document.addObject("Part::Feature", "Layers")
        place_beside(found, obj)
        found.Label = f"Layers of {obj.Label}"
        found.Shape = shape
    return found


def estimate_voxel_design(sample: Any, parameters: VoxelParameters) -> Estimate:
    """Return what a design of a sample will take, before it is made; quick, but for the first look at a file.

    Parameters
    ----------
    sample : document object, str or DrawnCurves
        A body, an analysis, the path of a file, or curves.
    parameters : VoxelParameters

    Raises
    ------
    TrabeculaError
        If a voxel is larger than the sample, there are too many, or the sample does not go with the voxel size.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.voxels.parameters import VoxelParameters
    >>> box = make.make_box(FreeCAD.newDocument(), 4, 5, 6)
    >>> make.estimate_voxel_design(box, VoxelParameters(size=(0.5, 0.5, 0.5))).layers
    (8, 10, 12)
    """
    given_value(parameters, VoxelParameters)
    if isinstance(sample, DrawnCurves):
        layers = targets_of_curves(sample, parameters).layers
    elif isinstance(sample, str):
        mark = file_source(sample).key  # changes when the file does
        if Path(sample).suffix.lower() in MESHES:
            layers = layer_counts_of_box(_edges_of_file(sample, mark), parameters.size, parameters.areas)
        else:
            layers = _layers_of_file(sample, mark, parameters)
    elif is_a(sample, Analysis):
        layers = targets_of_profiles(analysis_of(sample), parameters).layers
    else:
        shown = getattr(given_object(sample), "Mesh", None) or getattr(sample, "Shape", None)
        if shown is None or not shown.BoundBox.isValid():
            raise ParameterError(f"a sample must have a mesh or a shape, got {sample.Label} without one")
        box = shown.BoundBox
        layers = layer_counts_of_box((box.XLength, box.YLength, box.ZLength), parameters.size, parameters.areas)
    return estimate(layers, parameters.strategy)


@lru_cache(maxsize=8)
def _edges_of_file(path: str, mark: str) -> Tuple[float, ...]:
    triangles = read_triangles(path)
    return tuple((triangles.max((0, 1)).astype(float) - triangles.min((0, 1))).tolist())


@lru_cache(maxsize=64)
def _layers_of_file(path: str, mark: str, parameters: VoxelParameters) -> Tuple[int, int, int]:
    return layers_of_source(path, parameters)


def combine_with_body(obj: Any, body: Any, kind: str = "union", progress: Progress = silent) -> Any:
    """Add a voxel design to a body, or cut it from it, and return the new mesh object.

    Parameters
    ----------
    obj : document object
        A voxel design.
    body : document object
        A mesh or a solid.
    kind : str
        ``union``: both as one; ``difference``: the body less the design; ``intersection``: what both fill.
    progress : callable

    Raises
    ------
    TrabeculaError
        If there is no such kind, nothing is left, or manifold3d is missing; the document is as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.voxels.parameters import VoxelParameters
    >>> document = FreeCAD.newDocument()
    >>> ring = document.addObject("Part::Feature", "Ring")
    >>> ring.Shape = make.make_box(document, 4, 4, 4).Shape.cut(make.make_box(document, 2, 2, 4).Shape)
    >>> design = make.make_voxel_design(document, ring, VoxelParameters(size=(0.5, 0.5, 0.5)))
    >>> round(make.combine_with_body(design, make.make_box(document, 4, 4, 2), "union").Mesh.Volume, 3)
    56.0
    """
    design = voxel_design_of(obj)
    progress(0, 3, "triangles of the body")
    triangles = soup_of_source(object_source(given_object(body)), "auto", 0.0).triangles
    progress(1, 3, f"{kind} of the body and the voxels")
    voxels = block_mesh(design.voxels, design.targets.voxel, design.targets.origin)
    mesh = combine([weld(triangles), voxels], kind)
    if not len(mesh.triangles):
        raise ParameterError(f"the {kind} of {body.Label} and {obj.Label} must leave some volume, got 0 mm3")
    progress(2, 3, "mesh")
    shown = mesh_object(printable(mesh))
    with all_or_nothing(obj.Document):
        found = obj.Document.addObject("Mesh::Feature", "Combination")
        place_beside(found, obj)
        found.Label = f"{kind} of {body.Label} and {obj.Label}"
        found.Mesh = shown
    return found
