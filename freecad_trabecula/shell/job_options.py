# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the options of the command line to a job."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List, Mapping, Sequence, Tuple

from ..core.job import Job, read_job, set_values, with_seed
from ..core.parameters import Coupling, FaceParameters
from ..core.presets import preset
from ..errors import ExportError, ParameterError
from ..geometry.envelopes import load_envelope
from ..geometry.opposite_faces import opposite_faces

_USUAL = "case6"  # whose pores and paths an envelope gets when nothing else is said


def job_of_options(options: Mapping[str, Any]) -> Job:
    """Return the job that the options describe.

    Parameters
    ----------
    options : dict
        As ``arguments.read_arguments`` returns them.

    Raises
    ------
    ParameterError
        If the job file, a preset or a setting is wrong.
    EnvelopeError
        If an envelope has no faces that lie opposite each other, where these are to be coupled.
    """
    if options["job"]:
        job = read_job(options["job"])
    else:
        job = preset(options["preset"] or _USUAL)
    if options["envelope"]:
        job = with_envelope(job, options["envelope"], options["couple"])
    if options["seed"] is not None:
        job = with_seed(job, options["seed"])
    if options["engine"]:
        job = replace(job, scaffold=replace(job.scaffold, engine=options["engine"]))
    return set_values(job, options["set"])


def with_envelope(job: Job, path: str, pairs: Sequence[str]) -> Job:
    """Return the job with another envelope.

    Parameters
    ----------
    job : Job
    path : str
    pairs : sequence of str
        ``Face1:Face2``; none means those of the job, or, if that is a prism's, the faces that lie opposite each other.
    """
    if job.faces and not pairs:
        return replace(job, envelope=path, prism=None)
    couples = [tuple(pair.split(":")) for pair in pairs] or _opposite(path, job.solid)
    known = {face.label: face for face in job.faces}
    faces: Dict[str, FaceParameters] = {}
    for name in (name for couple in couples for name in couple):
        faces.setdefault(name, known.get(name) or FaceParameters(name))
    return replace(
        job,
        name=Path(path).stem,
        envelope=path,
        prism=None,
        faces=tuple(faces.values()),
        couplings=tuple(Coupling(first, second) for first, second in couples),
        edits=(),
    )


def _opposite(path: str, solid: str) -> List[Tuple[str, str]]:
    try:
        couples = opposite_faces(load_envelope(path, solid).solid)
    except ExportError as error:
        raise ParameterError(str(error)) from error
    if not couples:
        raise ParameterError(
            f"the envelope {Path(path).name} has no two faces that lie opposite each other: name the faces to be "
            "coupled by --couple FACE:FACE"
        )
    return couples
