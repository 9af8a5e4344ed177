# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work for another process: what it needs as files, the work itself, and its results.

The window writes a task into a folder, starts FreeCAD's console with ``shell/worker.py``, and when that has ended well
loads the results; the document's objects then find them by the same keys as if they had computed them.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, Sequence, Tuple

import FreeCAD
import Part

from ..core.job import Job
from ..core.parameters import ScaffoldParameters
from ..core.progress import Progress, part, silent
from ..core.records import from_record, to_record
from ..errors import ExportError, ParameterError
from ..geometry.design import SitedFace, placed_prism_sites
from . import network, results
from .analysis import Analysis, run_inputs, write_inputs
from .analysis import Inputs as AnalysisInputs
from .analysis_files import run_saving, write_saving
from .arguments import given_objects, given_value
from .base import read_parameters
from .envelope import checked_envelope
from .examples import make_example
from .face_sites import FaceSites, sites_key, sites_on
from .feature import is_a
from .jobs import job_of
from .network import Network, rods_by_key, shown_rods
from .packing import read_value, write_value
from .report_sections import Facts, run_records, write_facts
from .scaffold import Scaffold, cut, scaffold_key
from .solid_scaffold import SolidScaffold, solid_key, solid_of
from .variants import RAYS, rod_seeds, run_seeds, write_voxel_seeds
from .voxel_design import VoxelDesign
from .voxel_design import run_inputs as run_voxel_inputs
from .voxel_inputs import Inputs as VoxelInputs
from .voxel_inputs import write_inputs as write_voxel_inputs
from .wireframe import SEEN, Inputs, Wireframe, history, made, recall, seen_of, wireframe_key

_TASK, _ENVELOPE, _RESULTS = "task.json", "envelope.bin", "results"
#: What the objects show: rods that have not changed are taken from there.
_BEFORE, _SHOWN = "wireframe", "network"
#: Objects that another process may compute.
_COMPUTED = (Wireframe, FaceSites, Network, Scaffold, SolidScaffold, Analysis, VoxelDesign)
#: Kinds of results that a project's objects show.
_OF_OBJECTS = ("envelope", "sites", "wireframe", SEEN, "scaffold", "analysis", "contours", "voxels")


def write_task(folder: str, objects: Sequence[Any]) -> None:
    """Write what another process needs to compute objects of one design.

    Parameters
    ----------
    folder : str
        An empty folder.
    objects : sequence of document objects
        A wireframe, networks, scaffolds, all of one wireframe; or one analysis, or one voxel design.

    Examples
    --------
    >>> import tempfile
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> design = make.make_design(FreeCAD.newDocument(), preset("case1"))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     make.write_task(folder, [design.wireframe])
    ...     make.run_task(folder)  # in another process: freecad_trabecula.shell.worker
    ...     make.take_results(folder)  # envelope, wireframe, what is seen of it
    3
    """
    if not given_objects(objects, *_COMPUTED):
        raise ParameterError("a task must have an object to compute, got none")
    if is_a(objects[0], Analysis):
        write_analysis_task(folder, objects[0].Proxy.inputs(objects[0]))
        return
    if is_a(objects[0], VoxelDesign):
        write_voxel_task(folder, objects[0].Proxy.inputs(objects[0]))
        return
    wireframe = next(obj if is_a(obj, Wireframe) else obj.Wireframe for obj in objects)
    job = job_of(wireframe, envelope=_ENVELOPE)
    _write(folder, job, wireframe.Envelope.Shape, [{"kind": "envelope"}, *(_wanted(obj) for obj in objects)])
    recall(wireframe)
    before = results.find(Wireframe.KIND, wireframe.ResultKey)
    if before is not None:
        write_value(before, Path(folder) / _BEFORE)
    for obj in objects:
        if is_a(obj, Network) and obj.RodKeys:
            write_value(shown_rods(obj), Path(folder) / _SHOWN)


def write_job_task(folder: str, job: Job, envelope: Part.Shape, kinds: Sequence[str]) -> None:
    """Write what another process needs to compute results of a job of which no document has objects yet.

    Parameters
    ----------
    folder : str
        An empty folder.
    job : Job
        Its own envelope is not looked at.
    envelope : Part.Shape
    kinds : sequence of str
        Of ``results.KINDS``: ``wireframe``, ``network``, ``scaffold``, ``solid``.
    """
    wanted: List[Dict[str, Any]] = [{"kind": kind} for kind in kinds]
    for one in wanted:
        if one["kind"] in ("scaffold", "solid"):
            one["scaffold"] = to_record(job.scaffold)
    _write(folder, job, envelope, wanted)


def write_analysis_task(folder: str, inputs: AnalysisInputs) -> None:
    """Write what another process needs to compute an analysis of which no document has an object yet."""
    _write_record(Path(folder), {"analysis": write_inputs(Path(folder), inputs)})


def write_saving_task(folder: str, objects: Sequence[Any], target: str, plots: str) -> None:
    """Write what another process needs to save one analysis object into a folder, or the comparison of several."""
    _write_record(Path(folder), {"saving": write_saving(Path(folder), objects, target, plots)})


def write_report_task(folder: str, found: Facts) -> None:
    """Write what another process needs for the records of a report; ``report_sections.read_records`` takes them."""
    write_facts(Path(folder), found)
    _write_record(Path(folder), {"report": True})


def write_voxel_task(folder: str, inputs: VoxelInputs) -> None:
    """Write what another process needs to compute a voxel design of which no document has an object yet."""
    _write_record(Path(folder), {"voxels": write_voxel_inputs(Path(folder), inputs)})


def write_variants_task(folder: str, obj: Any, seeds: Sequence[int], by: str = RAYS) -> None:
    """Write what another process needs to make variants of a wireframe or a voxel design with other seeds.

    ``features.variants.read_variants`` takes them when the task has been run.
    """
    place = Path(folder)
    if is_a(obj, VoxelDesign):
        _write_record(place, {"variants": write_voxel_seeds(place, obj.Proxy.inputs(obj), seeds)})
        return
    job = job_of(obj, envelope=_ENVELOPE)
    _write(folder, job, obj.Envelope.Shape, [], variants=rod_seeds(obj, seeds, by))


def write_example_task(folder: str, name: str) -> None:
    """Write what another process needs to compute all of an example project."""
    _write_record(Path(folder), {"example": name})


def _write(folder: str, job: Job, envelope: Part.Shape, wanted: Sequence[Dict[str, Any]], **more: Any) -> None:
    try:
        envelope.exportBinary(str(Path(folder) / _ENVELOPE))
    except OSError as error:
        raise ExportError(f"the task could not be written into {folder}: {error}") from error
    _write_record(Path(folder), {"job": to_record(job), "wanted": list(wanted), **more})


def _write_record(folder: Path, record: Dict[str, Any]) -> None:
    try:
        (folder / _TASK).write_text(json.dumps(record), encoding="utf-8")
    except OSError as error:
        raise ExportError(f"the task could not be written into {folder}: {error}") from error


def _wanted(obj: Any) -> Dict[str, Any]:
    kind = "wireframe" if is_a(obj, Wireframe) else obj.Proxy.KIND
    record: Dict[str, Any] = {"kind": kind}
    if ScaffoldParameters in obj.Proxy.PARAMETERS:
        record["scaffold"] = to_record(read_parameters(obj, ScaffoldParameters))
    return record


def run_task(folder: str, progress: Progress = silent) -> None:
    """Compute what a task asks for and write the results beside it; a task without results was not finished.

    Raises
    ------
    ExportError
        If the folder holds no task.
    TrabeculaError
        What computing it raises.
    """
    place = Path(given_value(folder, str, Path))
    try:
        task = json.loads((place / _TASK).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ExportError(f"{folder} holds no task that can be read: {error}") from error
    if "analysis" in task:
        results.save(str(place / _RESULTS), *run_inputs(place, task["analysis"], progress))
        return
    if "saving" in task:
        run_saving(place, task["saving"], progress)
        return
    if "report" in task:
        run_records(place, progress)
        return
    if "example" in task:
        _run_example(place, task["example"], progress)
        return
    if "voxels" in task:
        results.save(str(place / _RESULTS), *run_voxel_inputs(place, task["voxels"], progress))
        return
    if "variants" in task:
        run_seeds(place, task["variants"], lambda step: _read_rods(place, task, step)[1], progress)
        return
    job, inputs = _read_rods(place, task, part(progress, 0.0, 0.1))
    found = [("wireframe", inputs.key)]
    if (place / _BEFORE).is_dir():
        history().learn(read_value(place / _BEFORE))
    bodies = [one for one in task["wanted"] if one["kind"] not in (Wireframe.KIND, "envelope")]
    rest = 0.8 if bodies else 0.0
    wireframe = made(inputs, part(progress, 0.1, 1.0 - rest))
    results.found_or_made(SEEN, inputs.key, lambda: seen_of(inputs, wireframe))
    found.append((SEEN, inputs.key))
    if len(bodies) < len(task["wanted"]):
        found += _known(job, inputs)
    shown = place / _SHOWN
    kept = rods_by_key(read_value(shown)) if shown.is_dir() else {}
    for number, wanted in enumerate(bodies):
        start, share = 1.0 - rest + number * rest / len(bodies), rest / len(bodies)
        found += _compute(wanted, inputs, kept, part(progress, start, start + share))
    results.save(str(place / _RESULTS), *dict.fromkeys(found))


def _read_rods(place: Path, task: Dict[str, Any], progress: Progress) -> Tuple[Job, Inputs]:
    """Return the job of a task and the inputs of its wireframe."""
    job = from_record(Job, task["job"], "job")
    envelope = Part.Shape()
    envelope.importBinary(str(place / _ENVELOPE))
    return job, job_inputs(job, envelope, progress)


def _run_example(place: Path, name: str, progress: Progress) -> None:
    """Make the project in a document that is thrown away; its objects' results are what is wanted."""
    document = FreeCAD.newDocument("Example")
    try:
        make_example(document, name, progress)
        for kind, key in results.all_of(Scaffold.KIND):
            results.keep(kind, key, results.find(kind, key)._replace(bodies=None))  # a file holds no bodies
        results.save(str(place / _RESULTS), *results.all_of(*_OF_OBJECTS))
    finally:
        FreeCAD.closeDocument(document.Name)


def job_inputs(job: Job, envelope: Part.Shape, progress: Progress = silent) -> Inputs:
    """Return the inputs of a job's wireframe in an envelope, with the key that its document objects would have."""
    body = checked_envelope(envelope)
    faces: Dict[str, SitedFace] = {}
    for done, one in enumerate(job.faces):
        progress(done, len(job.faces), f"sites on {one.label}")
        face = body.envelope.face(one.face)
        faces[one.label] = SitedFace(sites_on(face, body.mark, one), face)
    if not job.faces and job.prism is not None:
        faces = placed_prism_sites(job.prism, body.envelope)
    key = wireframe_key(body.mark, job.faces or (job.prism,), job.wireframe)
    return Inputs(body.envelope, faces, job.wireframe, body.mark, key)


def _known(job: Job, inputs: Inputs) -> List[Tuple[str, str]]:
    """Return where envelope and sites are kept, which the objects would have to compute too."""
    sites = [(FaceSites.KIND, sites_key(inputs.mark, one)) for one in job.faces]
    return [("envelope", inputs.mark), *sites]


def _compute(
    wanted: Dict[str, Any], inputs: Inputs, kept: Dict[str, network.Kept], progress: Progress
) -> List[Tuple[str, str]]:
    """Compute one result; return where it is kept."""
    kind = wanted["kind"]
    if kind == Network.KIND:
        rods = network.build(made(inputs), inputs.parameters.rods, kept, progress)
        results.keep(kind, inputs.key, rods)
        return [(kind, inputs.key)]
    if kind == Scaffold.KIND:
        parameters = from_record(ScaffoldParameters, wanted["scaffold"], "scaffold")
        key = scaffold_key(inputs.key, parameters)
        results.keep(kind, key, cut(inputs, parameters, progress)._replace(bodies=None))
        return [(kind, key)]
    if kind == SolidScaffold.KIND:
        parameters = from_record(ScaffoldParameters, wanted["scaffold"], "scaffold")
        key = solid_key(inputs.key, parameters)
        results.keep(kind, key, solid_of(inputs, parameters, progress))
        return [(kind, key)]
    return []


def take_results(folder: str) -> int:
    """Load the results of a task that has been run; return how many. The objects find them at their next recompute.

    Raises
    ------
    ExportError
        If the task was not run to its end.
    """
    return results.load(str(Path(folder) / _RESULTS))
