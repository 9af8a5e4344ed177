# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole designs in a document: made from a job, changed to another."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Sequence

import FreeCAD

from ..core.job import Job
from ..core.progress import Progress, part, silent
from ..errors import ParameterError
from .arguments import given_in, given_object, given_value
from .base import write_parameters
from .face_sites import FaceSites
from .feature import update
from .makers import (
    all_or_nothing,
    make_box,
    make_envelope,
    make_face_sites,
    make_network,
    make_prism_sites,
    make_scaffold,
    make_wireframe,
    set_wireframe_parameters,
)
from .prism_sites import PrismSites
from .wireframe import Wireframe

#: What can be made of a wireframe: the rods' solids, the scaffold as a mesh.
PARTS = ("network", "scaffold")


class Design(NamedTuple):
    """The objects of a design; None where one was not asked for."""

    envelope: Any
    sites: Sequence[Any]
    wireframe: Any
    network: Any = None
    scaffold: Any = None
    solid_scaffold: Any = None


def make_design(
    document: FreeCAD.Document,
    job: Job,
    parts: Sequence[str] = (),
    envelope: Any = None,
    progress: Progress = silent,
) -> Design:
    """Add all objects of a job to a document and return them.

    Parameters
    ----------
    document : App.Document
    job : Job
    parts : sequence of str
        Which of ``PARTS`` are to be made beside the wireframe.
    envelope : document object, optional
        A body to be filled that the document has already; none means that of the job.
    progress : callable

    Raises
    ------
    TrabeculaError
        If a step fails; the document is then as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> make.make_design(document, preset("case1")).wireframe.Rods
    75
    """
    given_value(job, Job)
    unknown = [one for one in given_value(parts, tuple, list) if one not in PARTS]
    if unknown:
        raise ParameterError(f"parts of a design are {', '.join(PARTS)}, got {unknown[0]!r}")
    with all_or_nothing(document):
        progress(0.0, 1.0, "envelope")
        given_in(document, envelope)
        envelope = envelope or make_job_envelope(document, job)
        sites = _job_sites(envelope, job, part(progress, 0.05, 0.3))
        wireframe = make_wireframe(envelope, sites, job.wireframe, part(progress, 0.3, 0.4))
        network = make_network(wireframe, part(progress, 0.4, 0.6)) if "network" in parts else None
        scaffold = make_scaffold(wireframe, job.scaffold, part(progress, 0.6, 1.0)) if "scaffold" in parts else None
    return Design(envelope, sites, wireframe, network, scaffold)


def make_job_envelope(document: FreeCAD.Document, job: Job) -> Any:
    """Add the body that a job fills: its prism, or the solid of its file; return it.

    Raises
    ------
    TrabeculaError
        If the file cannot be read, or holds no solid.
    """
    if job.prism is None:
        return make_envelope(document, job.envelope, job.solid)
    return make_box(document, job.prism.l, job.prism.w, job.prism.h)


def _job_sites(envelope: Any, job: Job, progress: Progress) -> Sequence[Any]:
    if not job.faces:
        return [make_prism_sites(envelope, job.prism)]
    found = []
    for done, one in enumerate(job.faces):
        progress(done, len(job.faces), f"sites on {one.label}")
        found.append(make_face_sites(envelope, one))
    return found


def change_design(wireframe: Any, job: Job, progress: Progress = silent) -> None:
    """Make a design that is there into that of a job: sites, wireframe, a prism's edges; not the file of the envelope.

    Sites of faces that the job does not name are removed, those of new faces are added.

    Parameters
    ----------
    wireframe : document object
    job : Job
    progress : callable

    Raises
    ------
    TrabeculaError
        If a step fails; the document is then as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make.make_design(document, preset("case1")).wireframe
    >>> make.change_design(wireframe, preset("case6"))
    >>> wireframe.Rods
    147
    """
    given_object(wireframe, Wireframe)
    given_value(job, Job)
    envelope, old = wireframe.Envelope, list(wireframe.Sites)
    with all_or_nothing(wireframe.Document, [*([envelope] if envelope else []), *old, wireframe]):
        if job.prism is not None and envelope.TypeId == "Part::Box":
            envelope.Length, envelope.Width, envelope.Height = job.prism.l, job.prism.w, job.prism.h
            update(envelope)
        wireframe.Sites = sites = _changed_sites(envelope, old, job)
        set_wireframe_parameters(wireframe, job.wireframe)
        update(wireframe, progress)
    for one in old:
        if one not in sites and not one.InList:
            wireframe.Document.removeObject(one.Name)


def _changed_sites(envelope: Any, old: Sequence[Any], job: Job) -> List[Any]:
    """Return the sites that a job names: of those that are there as many as there are, changed; the others new."""
    kept = {(type(one.Proxy), getattr(one.Proxy.parameters(one), "face", "")): one for one in old}
    sites = []
    for parameters in list(job.faces) or [job.prism]:
        found = kept.get((FaceSites if job.faces else PrismSites, getattr(parameters, "face", "")))
        if found is not None:
            write_parameters(found, parameters)
            update(found)
        elif job.faces:
            found = make_face_sites(envelope, parameters)
        else:
            found = make_prism_sites(envelope, parameters)
        sites.append(found)
    return sites
