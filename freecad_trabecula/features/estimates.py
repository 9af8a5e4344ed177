# SPDX-License-Identifier: LGPL-2.1-or-later
"""What it will take to compute objects of a document anew, or a design of which there is none yet."""

from __future__ import annotations

from functools import reduce
from typing import Any, NamedTuple, Optional, Sequence

import numpy as np
import Part

from ..core.engines import choose
from ..core.estimates import (
    Work,
    analysis_work,
    design_work,
    network_work,
    planes_of,
    rod_variant_work,
    scaffold_work,
    voxel_variant_work,
    voxel_work,
)
from ..core.job import Job
from ..core.parameters import ScaffoldParameters
from ..core.recovery import find_faults
from ..core.rods import rod_mesh
from ..core.variants import RAYS, SCAFFOLD
from ..core.voxels.design import estimate
from ..core.voxels.parameters import VoxelParameters
from ..core.wireframe import skin
from ..geometry.design import design_draft
from . import results
from .analysis import Analysis
from .analysis import Inputs as AnalysisInputs
from .analysis_source import body_of_source, reading_of_source
from .arguments import given_value
from .base import read_parameters
from .feature import is_a
from .network import Network
from .scaffold import Scaffold
from .tasks import job_inputs
from .variants import scaffold_parameters
from .voxel_design import VoxelDesign, voxel_design_of
from .voxel_inputs import sample_of
from .voxel_makers import estimate_voxel_design
from .wireframe import Wireframe, recall


def work_of(objects: Sequence[Any]) -> Work:
    """Return what it will take to compute objects of one design anew; quick.

    Parameters
    ----------
    objects : sequence of document objects
        As ``tasks.write_task`` takes them: a wireframe and what is made of it; or one analysis, or one voxel design.

    Raises
    ------
    TrabeculaError
        If an object's inputs are missing.

    Notes
    -----
    A wireframe is taken to get about as many rods as it shows.
    """
    first = objects[0]
    if is_a(first, Analysis):
        return work_of_analysis(first.Proxy.inputs(first))
    if is_a(first, VoxelDesign):
        return voxel_work(estimate_voxel_design(sample_of(first), read_parameters(first, VoxelParameters)))
    parts = [] if first.ResultKey == first.Proxy.key(first) else [design_work(first.Rods, len(first.Recoveries))]
    bodies = objects[1:]
    rods = _rods_of(first) if bodies else None
    if rods is not None:
        parts += [_network(rods) for obj in bodies if is_a(obj, Network)]
        parts += [_scaffold(rods, read_parameters(obj, ScaffoldParameters)) for obj in bodies if is_a(obj, Scaffold)]
    return reduce(Work.and_then, parts, Work(0.0))


def work_of_analysis(inputs: AnalysisInputs) -> Work:
    """Return what an analysis of some inputs will take, the reading of a file included.

    Raises
    ------
    TrabeculaError
        If a file is not there, or a rule is broken.
    """
    body = body_of_source(inputs.body, inputs.unit)
    planes = list(planes_of(inputs.parameters, body.box).values())
    return reading_of_source(inputs.body, body).and_then(analysis_work(body, planes, inputs.morphometry))


class _Rods(NamedTuple):
    """Triangles of rods, as ``rods.rod_mesh`` has them, and the bounds of their envelope."""

    vertices: np.ndarray
    triangles: np.ndarray
    low: Sequence[float]
    high: Sequence[float]


def _rods_of(wireframe: Any) -> Optional[_Rods]:
    """The rods that a wireframe shows, whatever its inputs are by now; None if it shows none. Nothing is computed."""
    recall(wireframe)
    shown = results.find(Wireframe.KIND, wireframe.ResultKey)
    if shown is None or not len(shown.wireframe):
        return None
    box, rods = wireframe.Envelope.Shape.BoundBox, wireframe.Proxy.parameters(wireframe).rods
    mesh = rod_mesh(skin(shown.wireframe, rods), shown.wireframe.mean_size)
    return _Rods(*mesh, (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax))


def _network(rods: _Rods) -> Work:
    return network_work(len(rods.vertices) * len(rods.triangles))


def _scaffold(rods: _Rods, parameters: ScaffoldParameters) -> Work:
    return scaffold_work(choose(parameters, *rods))


def variants_work(obj: Any, count: int, by: str = RAYS) -> Work:
    """Return what so many variants of a design will take; arguments as for ``variants.make_variants``.

    Raises
    ------
    ParameterError
        If the design is not computed yet.
    """
    if is_a(obj, VoxelDesign):
        layers = voxel_design_of(obj).voxels.shape[::-1]
        return voxel_variant_work(estimate(layers, read_parameters(obj, VoxelParameters).strategy)).times(count)
    faulty = len(obj.Recoveries)
    rods = _rods_of(obj) if by == SCAFFOLD else None
    if rods is not None:
        return design_work(obj.Rods, faulty).and_then(_scaffold(rods, scaffold_parameters(obj))).times(count)
    return rod_variant_work(obj.Rods, faulty).times(count)


def estimate_design(job: Job, envelope: Part.Shape) -> Work:
    """Return what the rods, their solids and the scaffold of a job will take in an envelope, before they are made.

    Parameters
    ----------
    job : Job
        Its own envelope is not looked at.
    envelope : Part.Shape

    Raises
    ------
    TrabeculaError
        If the job breaks a rule.

    Examples
    --------
    >>> import Part
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> job = preset("case6")
    >>> make.estimate_design(job, Part.makeBox(job.prism.l, job.prism.w, job.prism.h)).is_heavy
    True
    """
    inputs = job_inputs(given_value(job, Job), given_value(envelope, Part.Shape))
    body, parameters = inputs.envelope, inputs.parameters
    draft = design_draft(parameters, body, inputs.faces)
    if not len(draft):
        return Work(0.0)
    faulty = int((find_faults(draft, parameters, body.contains) > 0).sum())
    rods = _Rods(*rod_mesh(skin(draft, parameters.rods), draft.mean_size), body.low, body.high)
    return reduce(Work.and_then, (design_work(len(draft), faulty), _network(rods), _scaffold(rods, job.scaffold)))
