# SPDX-License-Identifier: LGPL-2.1-or-later
"""The voxel design in the document: what it is to equal and how, its voxels, its mesh; live when its source changes.

The document holds the voxels as bits, the targets and the mesh; all else is worked out when it is looked at.
"""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import Mesh
import numpy as np

from ..core.meshes import is_closed, mesh_volume, printable
from ..core.parameters import require
from ..core.progress import Progress, part, silent
from ..core.records import from_record
from ..core.voxels import design as core
from ..core.voxels.blocks import block_mesh
from ..core.voxels.parameters import VoxelParameters
from ..core.voxels.report import connection_record, trabeculae_record
from ..core.voxels.smooth_surface import smooth_surface
from ..core.voxels.sources import mask_of_triangles
from ..core.voxels.targets import Targets
from ..core.voxels.verification import layer_errors
from ..errors import ExportError, KernelError, ParameterError
from ..geometry.mesh_objects import mesh_object
from . import results
from .arguments import given_object
from .base import read_parameters
from .feature import HIDDEN, Property, result, show_in_place
from .on_demand import OnDemand, waiting
from .packing import from_numbers, to_numbers
from .voxel_inputs import Inputs, inputs_of, is_table, read_inputs, sample_of, triangles_of

SURFACES = ("blocks", "smooth")
_BITS = 48  # of one number: a double keeps 53


class Built(NamedTuple):
    """A design with what is told about it.

    Attributes
    ----------
    design : core.VoxelDesign
    figures : dict
        Values of the read-only properties, by name.
    mesh : Mesh.Mesh
    """

    design: core.VoxelDesign
    figures: Dict[str, Any]
    mesh: Mesh.Mesh


class Kept(NamedTuple):
    """What a document keeps of a design: voxels as bits, 48 in a number."""

    bits: np.ndarray
    mask: np.ndarray
    targets: Targets
    seconds: Dict[str, float]
    notes: Tuple[str, ...]


class VoxelDesign(OnDemand):
    """Voxels whose sliced areas along X, Y and Z equal those of a sample."""

    Type = "Trabecula::VoxelDesign"
    KIND = "voxels"
    PARAMETERS = (VoxelParameters,)
    PROPERTIES = (
        Property("App::PropertyLink", "Source", "Base", "The sample: a body, or an analysis; none: the file"),
        Property("App::PropertyFile", "File", "Base", "STL, OBJ, PLY, 3MF, an analysis' CSV or JSON, NPY"),
        Property("App::PropertyLink", "Envelope", "Base", "Body within which voxels may lie; none: the sample's box"),
        Property("App::PropertyEnumeration", "Surface", "Base", "Blocks keep volume and areas exactly; smooth keeps "
                 "the volume", 0, list(SURFACES)),
        Property("App::PropertyVectorList", "CurveX", "Base", "Drawn curve along X: place over the edge, share of the "
                 "layer; none: the sample's"),
        Property("App::PropertyVectorList", "CurveY", "Base", "Drawn curve along Y"),
        Property("App::PropertyVectorList", "CurveZ", "Base", "Drawn curve along Z"),
        Property("App::PropertyVector", "CurveEdges", "Base", "Edges of the box of drawn curves, mm"),
        Property("App::PropertyIntegerList", "Alpha", "Base", "Given table alpha, lines (x, z); none: drawn", HIDDEN),
        Property("App::PropertyIntegerList", "Beta", "Base", "Given table beta, lines (y, z); none: drawn", HIDDEN),
        *waiting(True),
        result("Bool", "Exact", "Whether every layer along X, Y and Z has the voxels asked for"),
        result("Integer", "LayersX", "Layers along X (N)"),
        result("Integer", "LayersY", "Layers along Y (M)"),
        result("Integer", "LayersZ", "Layers along Z (P)"),
        result("Integer", "Voxels", "Solid voxels"),
        result("Volume", "VoxelVolume", "Volume of the solid voxels"),
        result("Volume", "MeshVolume", "Volume of the mesh: the independent route"),
        result("Float", "BoneFraction", "Solid voxels over all of the envelope, %"),
        result("Integer", "Components", "Connected parts (6 neighbours)"),
        result("Float", "LargestFraction", "Share of the voxels in the largest part, %"),
        result("Integer", "ClosedCavities", "Voids that no opening reaches"),
        result("Integer", "EdgeContacts", "Contacts by an edge alone"),
        result("Integer", "CornerContacts", "Contacts by a corner alone"),
        result("FloatList", "TrabeculaDeviation", "Mean deviation of the numbers of trabeculae per layer along X, Y, "
               "Z, %; none if they were not asked for"),
        result("Bool", "Watertight", "Whether the mesh is closed"),
        result("StringList", "Notes", "What is to be known"),
        result("Float", "Seconds", "Time that it took, s"),
        result("String", "Structure", "The design: names, places of its numbers", hidden=True),
        result("FloatList", "Numbers", "The design: its numbers", hidden=True),
    )  # fmt: skip

    def inputs(self, obj: Any) -> Inputs:
        """Return all that the design depends on.

        Raises
        ------
        ParameterError
            If there is no sample, or a value is refused.
        ExportError
            If the file is not there.
        """
        parameters, tables = read_parameters(obj, VoxelParameters), (obj.Alpha, obj.Beta)
        return inputs_of(sample_of(obj), parameters, obj.Envelope, obj.Surface, tables)

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs."""
        return self.inputs(obj).key

    def make(self, obj: Any, progress: Progress) -> Built:
        """Design."""
        inputs = self.inputs(obj)
        step = part(progress, 0.0, 0.1)
        body = None if inputs.body is None or is_table(inputs.body) else triangles_of(inputs.body, step)
        envelope = triangles_of(inputs.envelope, step) if inputs.envelope else None
        return built(inputs, body, envelope, part(progress, 0.1, 1.0))

    def show(self, obj: Any, value: Built) -> None:
        """Check the design by counting, and the mesh by its volume, and show both."""
        design, figures = value.design, value.figures
        wrong = layer_errors(design.voxels, design.targets)
        if wrong:
            raise KernelError(f"all layers must have the voxels asked for, but {len(wrong)} have not: {wrong[0]}")
        apart = abs(figures["MeshVolume"] / figures["VoxelVolume"] - 1)
        if not figures["Watertight"] or (obj.Surface == "blocks" and apart > 1e-9):
            raise KernelError(
                f"the mesh must be closed and hold the {figures['VoxelVolume']:.9g} mm3 of its voxels, got "
                f"{figures['MeshVolume']:.9g} mm3"
            )
        obj.Structure, obj.Numbers = to_numbers(_kept(design))
        for name, figure in figures.items():
            setattr(obj, name, figure)
        show_in_place(obj, "Mesh", value.mesh)

    def said(self, obj: Any) -> str:
        """Return how many voxels in how many parts."""
        parts = "one part" if obj.Components == 1 else f"{obj.Components} parts"
        return f"{obj.Voxels} voxels in {parts}, exact along X, Y and Z, bone fraction {obj.BoneFraction:.2f} %"


def built(
    inputs: Inputs, body: Optional[np.ndarray], envelope: Optional[np.ndarray], progress: Progress = silent
) -> Built:
    """Return the design of some inputs.

    Parameters
    ----------
    inputs : Inputs
    body, envelope : ndarray of shape (T, 3, 3), mm, or None
        Triangles of the sample, if it has any, and of the body within which voxels may lie.
    progress : callable

    Raises
    ------
    TrabeculaError
        If there is no such design, or the search gave up.
    """
    started, parameters = time.perf_counter(), inputs.parameters
    targets = inputs.targets(body, part(progress, 0.0, 0.15))
    mask = None
    if envelope is not None:
        mask = mask_of_triangles(envelope, targets, parameters.boundary, part(progress, 0.15, 0.2), "the envelope")
    design = core.make_design(targets, parameters, mask, part(progress, 0.2, 0.8))
    progress(0.85, 1.0, "mesh")
    if inputs.surface == "blocks":
        mesh = block_mesh(design.voxels, targets.voxel, targets.origin)
    else:
        mesh = smooth_surface(design.voxels, targets.voxel, targets.origin).mesh
    figures = figures_of(design)
    figures.update(MeshVolume=mesh_volume(mesh), Watertight=is_closed(mesh))
    shown = mesh_object(printable(mesh))
    figures["Seconds"] = time.perf_counter() - started
    return Built(design, figures, shown)


def figures_of(design: core.VoxelDesign) -> Dict[str, Any]:
    """Return the values of the read-only properties that voxels tell."""
    connection, counts = connection_record(design.voxels, design.mask), trabeculae_record(design)
    n, m, p = design.targets.layers
    cells = design.voxels.size if design.mask is None else int(design.mask.sum())
    deviations = [100 * one["mean_deviation"] for one in counts.values() if "mean_deviation" in one]
    return {
        "Exact": not layer_errors(design.voxels, design.targets),
        "LayersX": n,
        "LayersY": m,
        "LayersZ": p,
        "Voxels": int(design.voxels.sum()),
        "VoxelVolume": float(design.voxels.sum()) * math.prod(design.targets.voxel),
        "BoneFraction": 100 * int(design.voxels.sum()) / cells,
        "Components": int(connection["components"]),
        "LargestFraction": 100 * float(connection["largest_fraction"]),
        "ClosedCavities": int(connection["closed_cavities"]),
        "EdgeContacts": int(connection["edge_contacts"]),
        "CornerContacts": int(connection["corner_contacts"]),
        "TrabeculaDeviation": [float(one) for one in deviations],
        "Notes": list(design.notes),
    }


# -------------------------------------------------------------------------------------------- what a document keeps


def _kept(design: core.VoxelDesign) -> Kept:
    mask = np.zeros(0) if design.mask is None else packed_bits(design.mask)
    plain = {name: getattr(design.targets, name) for name in Targets.__dataclass_fields__}
    targets = Targets(**dict(plain, sample=None))  # the sample is the source's, not the design's
    return Kept(packed_bits(design.voxels), mask, targets, dict(design.seconds), design.notes)


def packed_bits(flags: np.ndarray) -> np.ndarray:
    """Return flags, 48 in a number, ndarray of float64: whole numbers, which doubles keep exactly."""
    count = -(-flags.size // _BITS)
    bits = np.zeros(count * _BITS, np.uint8)
    bits[: flags.size] = flags.ravel()
    six = np.packbits(bits).reshape(count, _BITS // 8).astype(np.float64)
    return six @ 256.0 ** np.arange(_BITS // 8)[::-1]


def unpacked_bits(numbers: np.ndarray, shape: Tuple[int, ...]) -> np.ndarray:
    """Return the flags of a shape that ``packed_bits`` made into numbers."""
    whole = np.asarray(numbers, np.float64).astype(np.int64)
    six = np.stack([whole >> shift & 255 for shift in range(_BITS - 8, -1, -8)], 1).astype(np.uint8)
    return np.unpackbits(six.ravel())[: math.prod(shape)].reshape(shape).astype(bool)


def design_at_hand(obj: Any) -> Optional[core.VoxelDesign]:
    """Return the design that an object shows with its sample, if it has one; None if it would have to be made anew."""
    found = results.find(VoxelDesign.KIND, obj.ResultKey)
    return found.design if found is not None else None


def voxel_design_of(obj: Any) -> core.VoxelDesign:
    """Return the design that a document object shows.

    Raises
    ------
    ParameterError
        If it shows none yet.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.voxels.parameters import VoxelParameters
    >>> document = FreeCAD.newDocument()
    >>> ring = document.addObject("Part::Feature", "Ring")
    >>> ring.Shape = make.make_box(document, 4, 4, 4).Shape.cut(make.make_box(document, 2, 2, 4).Shape)
    >>> parameters = VoxelParameters(size=(0.5, 0.5, 0.5), strategy="minimum-zeros")
    >>> design = make.make_voxel_design(document, ring, parameters)
    >>> int(make.voxel_design_of(design).voxels.sum())
    384
    """
    if not given_object(obj, VoxelDesign).ResultKey:
        raise ParameterError(f"{obj.Label} must have been computed, got: {obj.Status or 'nothing yet'}")
    found = design_at_hand(obj)
    if found is not None:
        return found
    try:
        kept = from_numbers(obj.Structure, obj.Numbers)
    except ExportError as error:
        raise ParameterError(f"{obj.Label} must be computed anew: {error}") from error
    shape = kept.targets.shape
    mask = unpacked_bits(kept.mask, shape) if len(kept.mask) else None
    voxels, parameters = unpacked_bits(kept.bits, shape), read_parameters(obj, VoxelParameters)
    return core.VoxelDesign(voxels, kept.targets, parameters, mask, kept.seconds, tuple(kept.notes))


# -------------------------------------------------------------------------------------------- for another process


def run_inputs(folder: Path, record: Dict[str, Any], progress: Progress = silent) -> List[Tuple[str, str]]:
    """Compute what ``write_inputs`` wrote; return where the result is kept."""
    parameters = from_record(VoxelParameters, record["parameters"], "parameters")
    inputs, body, envelope = read_inputs(folder, record, parameters, part(progress, 0.0, 0.1))
    value = built(inputs, body, envelope, part(progress, 0.1, 1.0))
    results.keep(VoxelDesign.KIND, record["key"], value)
    return [(VoxelDesign.KIND, record["key"])]


def check_surface(surface: str) -> None:
    """Refuse a kind of surface that there is not."""
    require(surface in SURFACES, f"the surface must be one of {', '.join(SURFACES)}", repr(surface))
