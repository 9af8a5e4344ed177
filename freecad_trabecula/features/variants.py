# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of a design by other seeds: computed here or in another process; the document keeps its own seed."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any, Callable, Dict, List, Sequence

import numpy as np

from ..core.html_report.shaded_view import shaded_view
from ..core.meshes import Mesh
from ..core.parameters import ScaffoldParameters
from ..core.porosity_estimate import estimate_porosity
from ..core.progress import Progress, part, silent
from ..core.records import from_record, to_record
from ..core.variants import RAYS, SCAFFOLD, VOXELS, Variant, Variants
from ..core.voxels.blocks import block_mesh
from ..core.voxels.design import make_design
from ..core.voxels.parameters import VoxelParameters
from ..core.voxels.sources import mask_of_triangles
from ..core.voxels.trabeculae import trabecula_counts
from ..core.voxels.variants import chance_overlap, overlaps
from ..errors import ParameterError
from ..geometry.design import design_wireframe
from . import results
from .arguments import given_numbers, given_object
from .base import read_parameters
from .feature import is_a
from .packing import read_value, write_value
from .relations import products_of
from .scaffold import Scaffold, cut
from .voxel_design import VoxelDesign
from .voxel_design import figures_of as voxel_figures
from .voxel_inputs import Inputs as VoxelInputs
from .voxel_inputs import is_table, read_inputs, triangles_of, write_inputs
from .wireframe import Inputs, Wireframe, history

_PIXELS = 150
_FILE = "variants"
_NAMES = (
    ("Components", "connected parts"),
    ("ClosedCavities", "closed cavities"),
    ("EdgeContacts", "contacts by an edge alone"),
    ("CornerContacts", "contacts by a corner alone"),
)
POROSITY = "porosity, %"


def make_variants(obj: Any, seeds: Sequence[int], by: str = RAYS, progress: Progress = silent) -> Variants:
    """Return what a design would be with other seeds; the document stays as it is.

    Parameters
    ----------
    obj : document object
        A wireframe or a voxel design.
    seeds : sequence of int
    by : str
        Of rods: ``estimate by rays`` (quick), or ``scaffold``: each is cut, as its own would be.
    progress : callable

    Raises
    ------
    ParameterError
        If it is neither, or there is no such way.
    TrabeculaError
        If a variant cannot be made; the message names its seed.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make.make_design(FreeCAD.newDocument(), preset("case1")).wireframe
    >>> [row.seed for row in make.make_variants(wireframe, [1, 2]).rows]
    [1, 2]
    """
    given_numbers(seeds)
    if is_a(given_object(obj), Wireframe):
        return rod_variants(obj.Proxy.inputs(obj), scaffold_parameters(obj), seeds, by, progress)
    if is_a(obj, VoxelDesign):
        inputs = obj.Proxy.inputs(obj)
        body = None if inputs.body is None or is_table(inputs.body) else triangles_of(inputs.body, silent)
        envelope = triangles_of(inputs.envelope, silent) if inputs.envelope else None
        return voxel_variants(inputs, body, envelope, seeds, progress)
    raise ParameterError(f"variants must be those of a wireframe or of a voxel design, got {obj.Label}")


def scaffold_parameters(wireframe: Any) -> ScaffoldParameters:
    """Return the parameters of a wireframe's scaffold, or the default ones."""
    found = [one for one in products_of(wireframe) if is_a(one, Scaffold)]
    return read_parameters(found[0], ScaffoldParameters) if found else ScaffoldParameters()


def rod_variants(
    inputs: Inputs, scaffold: ScaffoldParameters, seeds: Sequence[int], by: str, progress: Progress = silent
) -> Variants:
    """Return variants of the inputs of a wireframe; arguments as for ``make_variants``."""
    if by not in (RAYS, SCAFFOLD):
        raise ParameterError(f"porosities must be found by one of {RAYS}, {SCAFFOLD}, got {by!r}")
    one = _by_rays if by == RAYS else _by_scaffold
    rows = [
        one(_with_seed(inputs, seed), scaffold, seed, step) for seed, step in zip(seeds, _steps(progress, len(seeds)))
    ]
    return Variants(by, POROSITY, tuple(rows), np.zeros((0, 0)), math.nan)


def _steps(progress: Progress, count: int) -> List[Progress]:
    return [part(progress, k / count, (k + 1) / count) for k in range(count)]


def _with_seed(inputs: Inputs, seed: int) -> Inputs:
    return inputs._replace(
        parameters=replace(inputs.parameters, seed=seed), key=results.key_of("variant", inputs.key, seed)
    )


def _by_rays(inputs: Inputs, scaffold: ScaffoldParameters, seed: int, progress: Progress) -> Variant:
    parameters, envelope, step = inputs.parameters, inputs.envelope, part(progress, 0.0, 0.7)
    mended = design_wireframe(parameters, envelope, inputs.faces, history(), inputs.mark, step)
    wireframe = mended.wireframe
    if not len(wireframe):
        raise ParameterError(f"a variant must have rods, got none with seed {seed}")
    step = part(progress, 0.7, 0.9)
    found = estimate_porosity(
        wireframe, parameters.rods, envelope.low, envelope.high, envelope.volume, envelope.mesh, step
    )
    progress(0.95, 1.0, f"picture of seed {seed}")
    count = found.vertices.shape[1]
    triangles = (found.triangles[None] + count * np.arange(len(wireframe))[:, None, None]).reshape(-1, 3)
    picture = shaded_view(Mesh(found.vertices.reshape(-1, 3), triangles), _PIXELS)
    numbers = {
        POROSITY: 100 * found.porosity,
        "standard error, %": 100 * found.error,
        "plain sum of the rods, %": 100 * found.plain_sum,
        "rods": float(len(wireframe)),
        "rods mended": float(len(wireframe.recoveries)),
        "rods left out": float(len(wireframe.failed)),
    }
    return Variant(seed, numbers, picture)


def _by_scaffold(inputs: Inputs, scaffold: ScaffoldParameters, seed: int, progress: Progress) -> Variant:
    found = cut(inputs, scaffold, part(progress, 0.0, 0.9))
    progress(0.95, 1.0, f"picture of seed {seed}")
    figures = found.figures
    numbers = {
        POROSITY: figures["Porosity"],
        "union of the rods, %": figures["UnionPorosity"],
        "plain sum of the rods, %": figures["SumPorosity"],
        "loose pieces": float(figures["LoosePieces"]),
        "voids without an opening": float(figures["Voids"]),
        "checks that failed": float(sum(not check.ok for check in found.checks)),
    }
    return Variant(seed, numbers, shaded_view(found.bodies.scaffold, _PIXELS))


def voxel_variants(
    inputs: VoxelInputs, body: Any, envelope: Any, seeds: Sequence[int], progress: Progress = silent
) -> Variants:
    """Return variants of the inputs of a voxel design; ``body`` and ``envelope`` are triangles (T, 3, 3), or None."""
    targets = inputs.targets(body, part(progress, 0.0, 0.1))
    mask = None
    if envelope is not None:
        mask = mask_of_triangles(envelope, targets, inputs.parameters.boundary, silent, "the envelope")
    rows, voxels = [], []
    for seed, step in zip(seeds, _steps(part(progress, 0.1, 0.95), len(seeds))):
        design = make_design(targets, replace(inputs.parameters, seed=seed), mask, part(step, 0.0, 0.8))
        figures = voxel_figures(design)
        step(0.9, 1.0, f"picture of seed {seed}")
        mesh = block_mesh(design.voxels, targets.voxel, targets.origin)
        numbers = {words: float(figures[name]) for name, words in _NAMES}
        for axis, counts in zip("XYZ", trabecula_counts(design.voxels)):
            numbers[f"trabeculae a layer along {axis}"] = float(counts.mean())
        voxels.append(design.voxels)
        rows.append(Variant(seed, numbers, shaded_view(mesh, _PIXELS)))
    progress(0.97, 1.0, "overlaps")
    shared = overlaps(voxels)
    for number, row in enumerate(rows):
        others = np.delete(shared[number], number)
        row.numbers["mean overlap, %"] = 100 * float(others.mean()) if len(others) else 100.0
    return Variants(VOXELS, "mean overlap, %", tuple(rows), shared, chance_overlap(voxels[0]))


# -------------------------------------------------------------------------------------------- for another process


def write_voxel_seeds(folder: Path, inputs: VoxelInputs, seeds: Sequence[int]) -> Dict[str, Any]:
    """Write what another process needs for variants of a voxel design; return the record of its task."""
    return {"voxels": write_inputs(folder, inputs), "seeds": [int(seed) for seed in seeds]}


def rod_seeds(wireframe: Any, seeds: Sequence[int], by: str) -> Dict[str, Any]:
    """Return the part of a task that tells which variants of a wireframe are wanted."""
    return {"scaffold": to_record(scaffold_parameters(wireframe)), "seeds": [int(seed) for seed in seeds], "by": by}


def run_seeds(
    folder: Path, record: Dict[str, Any], rods: Callable[[Progress], Inputs], progress: Progress = silent
) -> None:
    """Make the variants of a task and write them beside it; ``rods(progress)`` gives the inputs of a wireframe."""
    seeds = record["seeds"]
    if "voxels" in record:
        own = record["voxels"]
        parameters = from_record(VoxelParameters, own["parameters"], "parameters")
        inputs, body, envelope = read_inputs(folder, own, parameters, part(progress, 0.0, 0.05))
        found = voxel_variants(inputs, body, envelope, seeds, part(progress, 0.05, 1.0))
    else:
        scaffold = from_record(ScaffoldParameters, record["scaffold"], "scaffold")
        inputs = rods(part(progress, 0.0, 0.05))
        found = rod_variants(inputs, scaffold, seeds, record["by"], part(progress, 0.05, 1.0))
    write_value(found, folder / _FILE)


def read_variants(folder: str) -> Variants:
    """Return the variants that another process made of a task.

    Raises
    ------
    ExportError
        If it did not come to its end.
    """
    return read_value(Path(folder) / _FILE)
