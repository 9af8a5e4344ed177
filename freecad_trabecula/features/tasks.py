# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work for another process: what it needs as files, the work itself, and its results.

The window writes a task into a folder, starts FreeCAD's console with ``shell/worker.py``, and when that has ended well
loads the results; the document's objects then find them by the same keys as if they had computed them.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, Sequence, Tuple

import Part

from ..core.job import Job
from ..core.parameters import ScaffoldParameters
from ..core.progress import Progress, part, silent
from ..core.records import from_record, to_record
from ..errors import ExportError
from ..geometry.design import SitedFace, placed_prism_sites
from . import network, results
from .base import read_parameters
from .envelope import checked_envelope, envelope_of
from .face_sites import sites_on
from .feature import is_a
from .jobs import job_of
from .network import Network
from .scaffold import Scaffold, cut, scaffold_key
from .solid_scaffold import SolidScaffold, solid_key, solid_of
from .wireframe import Inputs, Wireframe, made, wireframe_key

_TASK, _ENVELOPE, _RESULTS = "task.json", "envelope.bin", "results"


def write_task(folder: str, objects: Sequence[Any]) -> None:
    """Write what another process needs to compute objects of one design.

    Parameters
    ----------
    folder : str
        An empty folder.
    objects : sequence of document objects
        A wireframe, networks, scaffolds, all of one wireframe.

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
    ...     make.take_results(folder)
    1
    """
    wireframe = next(obj if is_a(obj, Wireframe) else obj.Wireframe for obj in objects)
    envelope_of(wireframe.Envelope)  # refuses what cannot be filled
    job = job_of(wireframe, envelope=_ENVELOPE)
    _write(folder, job, wireframe.Envelope.Shape, [_wanted(obj) for obj in objects])


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


def _write(folder: str, job: Job, envelope: Part.Shape, wanted: Sequence[Dict[str, Any]]) -> None:
    place = Path(folder)
    try:
        envelope.exportBinary(str(place / _ENVELOPE))
        text = json.dumps({"job": to_record(job), "wanted": list(wanted)})
        (place / _TASK).write_text(text, encoding="utf-8")
    except OSError as error:
        raise ExportError(f"the task could not be written into {folder}: {error}") from error


def _wanted(obj: Any) -> Dict[str, Any]:
    kind = "wireframe" if is_a(obj, Wireframe) else obj.Proxy.KIND
    record: Dict[str, Any] = {"kind": kind}
    if ScaffoldParameters in obj.Proxy.PARAMETERS:
        record["scaffold"] = to_record(read_parameters(obj, ScaffoldParameters))
    return record


def run_task(folder: str, progress: Progress = silent) -> None:
    """Compute what a task asks for and write the results beside it; a task without results was not finished."""
    place = Path(folder)
    task = json.loads((place / _TASK).read_text(encoding="utf-8"))
    job = from_record(Job, task["job"], "job")
    envelope = Part.Shape()
    envelope.importBinary(str(place / _ENVELOPE))
    inputs = job_inputs(job, envelope, part(progress, 0.0, 0.1))
    found = [("wireframe", inputs.key)]
    made(inputs, part(progress, 0.1, 0.2))
    for number, wanted in enumerate(task["wanted"]):
        share = 0.8 / len(task["wanted"])
        found += _compute(wanted, inputs, part(progress, 0.2 + number * share, 0.2 + (number + 1) * share))
    results.save(str(place / _RESULTS), *dict.fromkeys(found))


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


def _compute(wanted: Dict[str, Any], inputs: Inputs, progress: Progress) -> List[Tuple[str, str]]:
    """Compute one result; return where it is kept."""
    kind = wanted["kind"]
    if kind == Network.KIND:
        rods = network.build(made(inputs), inputs.parameters.rods, None, progress)
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
