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
from .core.parameters import FaceParameters, PrismParameters, SiteEdit
from .core.progress import Progress, part, silent
from .core.wireframe import WireframeParameters
from .errors import KernelError, ParameterError, TrabeculaError
from .features import base, tasks
from .features.base import Feature, lines_of, records_of, write_parameters
from .features.face_sites import FaceSites
from .features.network import Network
from .features.prism_sites import PrismSites
from .features.wireframe import Wireframe


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
    base.attach_view(obj)
    return obj


def update(obj: Any, progress: Progress = silent) -> None:
    """Compute an object again.

    Raises
    ------
    TrabeculaError
        What its recompute would put into the report view.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> box = make_box(document)
    >>> sites = make_prism_sites(box)
    >>> sites.SitesX = 3
    >>> update(sites)
    >>> sites.Count
    182
    """
    if isinstance(getattr(obj, "Proxy", None), Feature):
        obj.Proxy.prepare(obj, progress)
    obj.touch()
    obj.Document.recompute([obj])
    if not obj.isValid():
        raise KernelError(f"{obj.Label} could not be computed: {getattr(obj, 'Status', '') or 'the kernel refused it'}")


# ---------------------------------------------------------------------------------------------- the envelope, sites


def make_box(
    document: FreeCAD.Document, l: float = 10.0, w: float = 10.0, h: float = 10.0, name: str = "Envelope"
) -> Any:  # noqa: E741
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


def edits_of(wireframe: Any) -> Sequence[SiteEdit]:
    """Return the changes by hand of a wireframe object."""
    return records_of(wireframe.Edits, SiteEdit, "edit")


def set_pore(wireframe: Any, site: str, size: Optional[float] = None, turns: Optional[Sequence[float]] = None) -> None:
    """Set size and tangents of one pore by hand.

    Parameters
    ----------
    wireframe : document object
    site : str
        Name of the site, e.g. ``Face1.2.3``.
    size : float, mm, optional
    turns : sequence of float, optional
        Tangent components in 0..1, one per corner.

    Raises
    ------
    ParameterError
        If there is no such site or a value is refused; nothing is changed then.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make_design(document, preset("case3")).wireframe
    >>> set_pore(wireframe, "Face1.2.3", size=0.5)
    >>> wireframe.Edits
    ['{"site": "Face1.2.3", "action": "pore", "size": 0.5}']
    """
    _edit(wireframe, SiteEdit(site, "pore", size=size, turns=None if turns is None else tuple(turns)))


def move_site(wireframe: Any, site: str, point: Sequence[float]) -> None:
    """Move one site by hand to a point (3,), mm, on its face.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make_design(document, preset("case3")).wireframe
    >>> move_site(wireframe, "Face1.2.3", (0, 2.5, 3.5))
    >>> len(wireframe.Edits)
    1
    """
    _edit(wireframe, SiteEdit(site, "move", point=tuple(float(c) for c in point)))


def switch_off_site(wireframe: Any, site: str) -> None:
    """Switch one site off by hand: no rod uses it.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make_design(document, preset("case3")).wireframe
    >>> switch_off_site(wireframe, "Face1.2.3")
    >>> wireframe.Rods
    146
    """
    _edit(wireframe, SiteEdit(site, "off"))


def add_site(wireframe: Any, face: str, point: Sequence[float]) -> str:
    """Add a site by hand at a point (3,), mm, of a face; return its name.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make_design(document, preset("case3")).wireframe
    >>> add_site(wireframe, "Face1", (0, 3, 3.2)), add_site(wireframe, "Face2", (10, 3, 3.2))
    ('Face1.hand.1', 'Face2.hand.1')
    >>> wireframe.Rods
    148
    """
    own = [e for e in edits_of(wireframe) if e.action == "add" and e.site.split(".")[0] == face]
    name = f"{face}.hand.{len(own) + 1}"
    _edit(wireframe, SiteEdit(name, "add", point=tuple(float(c) for c in point)))
    return name


def take_back_edits(wireframe: Any, site: str) -> None:
    """Take back the changes by hand of one site.

    One that was added is switched off and not taken away: the names of those added later count on it.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make_design(document, preset("case3")).wireframe
    >>> switch_off_site(wireframe, "Face1.2.3")
    >>> take_back_edits(wireframe, "Face1.2.3")
    >>> wireframe.Rods
    147
    """
    edits = edits_of(wireframe)
    added = [e for e in edits if e.site == site and e.action == "add"]
    _set_edits(wireframe, [e for e in edits if e.site != site] + added + [SiteEdit(site) for _ in added])


def _edit(wireframe: Any, edit: SiteEdit) -> None:
    """Put a change behind the others; it replaces an earlier one of the same kind of the same site."""
    kept = [e for e in edits_of(wireframe) if (e.site, e.action) != (edit.site, edit.action)]
    _set_edits(wireframe, [*kept, edit])


def _set_edits(wireframe: Any, edits: Sequence[SiteEdit]) -> None:
    before = wireframe.Edits
    wireframe.Edits = lines_of(edits)
    try:
        update(wireframe)
    except TrabeculaError:
        wireframe.Edits = before
        wireframe.Document.recompute([wireframe])
        raise


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


# ------------------------------------------------------------------------------------ long work in another process


def write_task(folder: str, objects: Sequence[Any]) -> None:
    """Write what another process needs to compute objects of one design into an empty folder.

    Parameters
    ----------
    folder : str
    objects : sequence of document objects
        A wireframe, networks, scaffolds, all of one wireframe.

    Examples
    --------
    >>> document = FreeCAD.newDocument()
    >>> import tempfile
    >>> from freecad_trabecula.core.presets import preset
    >>> design = make_design(document, preset("case1"))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_task(folder, [design.wireframe])
    ...     run_task(folder)  # in another process: freecad_trabecula.shell.worker
    ...     take_results(folder)
    1
    """
    tasks.write_task(folder, objects)


def run_task(folder: str, progress: Progress = silent) -> None:
    """Compute what a task asks for and write its results; see ``write_task``."""
    tasks.run_task(folder, progress)


def take_results(folder: str) -> int:
    """Load the results of a task and return how many; objects find them when recomputed. See ``write_task``."""
    return tasks.take_results(folder)


# ----------------------------------------------------------------------------------------------- a design at once


def make_design(document: FreeCAD.Document, job: Job, progress: Progress = silent) -> Design:
    """Add all objects of a job to a document and return them.

    Parameters
    ----------
    document : App.Document
    job : Job
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
        envelope = _job_envelope(document, job)
        if job.faces:
            sites = [make_face_sites(envelope, one) for one in job.faces]
        else:
            sites = [make_prism_sites(envelope, job.prism)]
        wireframe = make_wireframe(envelope, sites, job.wireframe, part(progress, 0.0, 0.2))
    return Design(envelope, sites, wireframe)


def _job_envelope(document: FreeCAD.Document, job: Job) -> Any:
    if job.prism is None:
        raise ParameterError("not yet")
    return make_box(document, job.prism.l, job.prism.w, job.prism.h)
