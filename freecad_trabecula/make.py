# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scripting: one function for every step of a design, with or without the window.

Functions add objects to a document and compute them; on an error they raise it and leave the document as it was. They
open no transaction: that is the caller's, so that a command in the window is one step to undo.
"""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Iterator, NamedTuple, Optional, Sequence

import FreeCAD

from .core.job import Job
from .core.parameters import FaceParameters, PrismParameters
from .core.progress import Progress, part, silent
from .core.wireframe import WireframeParameters
from .features.base import lines_of, write_parameters
from .features.edits import add_site, edits_of, move_site, set_pore, switch_off_site, take_back_edits
from .features.envelope import fill
from .features.face_sites import FaceSites
from .features.feature import attach_view, update
from .features.jobs import job_of
from .features.network import Network
from .features.prism_sites import PrismSites
from .features.tasks import run_task, take_results, write_task
from .features.wireframe import Wireframe
from .geometry.envelopes import load_envelope

__all__ = [
    "Design",
    "add_site",
    "change_design",
    "edits_of",
    "job_of",
    "make_box",
    "make_design",
    "make_envelope",
    "make_face_sites",
    "make_network",
    "make_prism_sites",
    "make_wireframe",
    "move_site",
    "run_task",
    "set_pore",
    "set_wireframe_parameters",
    "switch_off_site",
    "take_back_edits",
    "take_results",
    "update",
    "write_task",
]


class Design(NamedTuple):
    """The objects of a design; None where one was not asked for."""

    envelope: Any
    sites: Sequence[Any]
    wireframe: Any
    network: Any = None
    scaffold: Any = None
    solid_scaffold: Any = None


@contextmanager
def _all_or_nothing(document: FreeCAD.Document) -> Iterator[None]:
    """Remove the objects added inside, if an error leaves."""
    before = {obj.Name for obj in document.Objects}
    try:
        yield
    except BaseException:
        for name in [obj.Name for obj in document.Objects if obj.Name not in before][::-1]:
            document.removeObject(name)
        raise


def _add(document: FreeCAD.Document, cls: type, name: str, kind: str = "Part::FeaturePython") -> Any:
    obj = document.addObject(kind, name)
    cls(obj)
    attach_view(obj)
    return obj


# ---------------------------------------------------------------------------------------------- the envelope, sites


def make_box(
    document: FreeCAD.Document,
    l: float = 10.0,  # noqa: E741  the thesis' letter
    w: float = 10.0,
    h: float = 10.0,
    name: str = "Envelope",
) -> Any:
    """Add a box, one corner at the origin, and return it.

    Parameters
    ----------
    document : App.Document
    l, w, h : float, mm
        Edges along X, Y, Z.
    name : str

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> round(make_box(document, 51, 40.6, 8.55).Shape.Volume, 2)
    17703.63
    """
    prism = PrismParameters(l=l, w=w, h=h, a_x=0, a_y=0, a_z=0)  # checks the edges
    with _all_or_nothing(document):
        box = document.addObject("Part::Box", name)
        box.Length, box.Width, box.Height = prism.l, prism.w, prism.h
        update(box)
    return box


def make_prism_sites(box: Any, prism: Optional[PrismParameters] = None) -> Any:
    """Add the sites of a box's six faces (Eq. 2.1) and return the object.

    Parameters
    ----------
    box : Part::Box
    prism : PrismParameters, optional
        Numbers and border distances of the sites; its edges are not used: those of the box count.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> make_prism_sites(make_box(document), PrismParameters(n_x=5, n_y=5, n_z=5)).Count
    150
    """
    with _all_or_nothing(box.Document):
        sites = _add(box.Document, PrismSites, "Sites")
        sites.Box = box
        write_parameters(sites, prism or PrismParameters())
        update(sites)
    return sites


def make_face_sites(envelope: Any, parameters: FaceParameters) -> Any:
    """Add the sites of one face by curvilinear co-ordinates (thesis 4.2.2) and return the object.

    Parameters
    ----------
    envelope : document object
        The object on whose solid the face is.
    parameters : FaceParameters

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> make_face_sites(make_box(document), FaceParameters("Face6", "top", c_u=2, c_v=2, b_u=1, b_v=1)).Count
    25
    """
    document = envelope.Document
    with _all_or_nothing(document):
        sites = _add(document, FaceSites, f"Sites_{parameters.label}")
        sites.Label = f"Sites {parameters.label}"
        sites.Face = (envelope, [parameters.face])
        write_parameters(sites, parameters)
        update(sites)
    return sites


def make_envelope(document: FreeCAD.Document, path: str, solid: str = "", name: str = "Envelope") -> Any:
    """Add the solid in a file and return the object.

    Parameters
    ----------
    document : App.Document
    path : str
        STEP, IGES or BREP (units of the file become mm), or a closed mesh: STL, OBJ, PLY (mm).
    solid : str
        Which of several solids: ``Solid2`` or ``2``.
    name : str

    Raises
    ------
    EnvelopeError, ExportError
        If there is no solid that can be filled, or the file cannot be read.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> import os, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "cube.step")
    >>> make_box(document, 5, 5, 5).Shape.exportStep(path)
    >>> round(make_envelope(document, path).Shape.Volume, 6)
    125.0
    """
    envelope = load_envelope(path, solid)
    with _all_or_nothing(document):
        obj = document.addObject("Part::Feature", name)
        fill(obj, envelope, str(path), solid)
        obj.purgeTouched()
    return obj


# ------------------------------------------------------------------------------------------------- the wireframe


def make_wireframe(
    envelope: Any, sites: Sequence[Any], parameters: WireframeParameters, progress: Progress = silent
) -> Any:
    """Add the wireframe of an envelope with sites and return the object.

    Parameters
    ----------
    envelope : document object
    sites : sequence of document objects
        Made by ``make_prism_sites`` or ``make_face_sites``.
    parameters : WireframeParameters
        Pores, paths, couplings, rods, changes by hand, seed.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> box = make_box(document)
    >>> make_wireframe(box, [make_prism_sites(box)], preset("case6").wireframe).Rods
    147
    """
    document = envelope.Document
    with _all_or_nothing(document):
        wireframe = _add(document, Wireframe, "Wireframe")
        wireframe.Envelope, wireframe.Sites = envelope, list(sites)
        set_wireframe_parameters(wireframe, parameters)
        update(wireframe, progress)
    return wireframe


def set_wireframe_parameters(wireframe: Any, parameters: WireframeParameters) -> None:
    """Set all properties of a wireframe object; it is not computed yet."""
    for one in (parameters.pores, parameters.path, parameters.rods):
        write_parameters(wireframe, one)
    wireframe.Couplings, wireframe.Edits = lines_of(parameters.couplings), lines_of(parameters.edits)
    wireframe.Seed = parameters.seed


def make_network(wireframe: Any, progress: Progress = silent) -> Any:
    """Add the network of a wireframe, a compound of the rods' solids, and return the object.

    Parameters
    ----------
    wireframe : document object
        Made by ``make_wireframe``.
    progress : callable

    Raises
    ------
    KernelError
        If a rod cannot be built, or the volumes of solid and mesh differ.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> network = make_network(make_design(document, preset("case1")).wireframe)
    >>> network.Rods, len(network.Shape.Solids)
    (75, 75)
    """
    document = wireframe.Document
    with _all_or_nothing(document):
        network = _add(document, Network, "Network")
        network.Wireframe = wireframe
        update(network, progress)
    return network


# ----------------------------------------------------------------------------------------------- a design at once


def make_design(
    document: FreeCAD.Document, job: Job, envelope: Any = None, network: bool = False, progress: Progress = silent
) -> Design:
    """Add all objects of a job to a document and return them.

    Parameters
    ----------
    document : App.Document
    job : Job
    envelope : document object, optional
        A body to be filled that the document has already; none means that of the job.
    network : bool
        Whether the rods are to be made as solids, too.
    progress : callable

    Raises
    ------
    TrabeculaError
        If a step fails; the document is then as it was.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> make_design(document, preset("case1")).wireframe.Rods
    75
    """
    with _all_or_nothing(document):
        progress(0.0, 1.0, "envelope")
        envelope = envelope or _job_envelope(document, job)
        sites = _job_sites(envelope, job, part(progress, 0.05, 0.3))
        wireframe = make_wireframe(envelope, sites, job.wireframe, part(progress, 0.3, 0.5))
        rods = make_network(wireframe, part(progress, 0.5, 1.0)) if network else None
    return Design(envelope, sites, wireframe, rods)


def _job_envelope(document: FreeCAD.Document, job: Job) -> Any:
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
        If a step fails; the caller's transaction takes back what was changed.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make_design(document, preset("case1")).wireframe
    >>> change_design(wireframe, preset("case6"))
    >>> wireframe.Rods
    147
    """
    envelope, old = wireframe.Envelope, list(wireframe.Sites)
    if job.prism is not None and envelope.TypeId == "Part::Box":
        envelope.Length, envelope.Width, envelope.Height = job.prism.l, job.prism.w, job.prism.h
        update(envelope)
    wanted = list(job.faces) or [job.prism]
    kept = {}
    for one in old:
        kept[type(one.Proxy), getattr(one.Proxy.parameters(one), "face", "")] = one
    sites = []
    for parameters in wanted:
        key = (FaceSites if job.faces else PrismSites, getattr(parameters, "face", ""))
        if key in kept:
            write_parameters(kept[key], parameters)
            update(kept[key])
            sites.append(kept[key])
        else:
            sites.append(make_face_sites(envelope, parameters) if job.faces else make_prism_sites(envelope, parameters))
    wireframe.Sites = sites
    set_wireframe_parameters(wireframe, job.wireframe)
    for one in old:
        if one not in sites and not one.InList:
            wireframe.Document.removeObject(one.Name)
    update(wireframe, progress)
