# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scripting: one function for every step of a design, with or without the window.

Functions add objects to a document and compute them; on an error they raise it and leave the document as it was. They
open no transaction: that is the caller's, so that a command in the window is one step to undo.
"""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Iterator, NamedTuple, Optional, Sequence

from .core.job import Job
from .core.parameters import FaceParameters, PrismParameters
from .core.progress import Progress, part, silent
from .core.wireframe import WireframeParameters
from .errors import KernelError, ParameterError
from .features import base
from .features.base import Feature, lines_of, write_parameters
from .features.face_sites import FaceSites
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
def _all_or_nothing(document: Any) -> Iterator[None]:
    """Remove the objects added inside, if an error leaves."""
    before = {obj.Name for obj in document.Objects}
    try:
        yield
    except BaseException:
        for name in [obj.Name for obj in document.Objects if obj.Name not in before][::-1]:
            document.removeObject(name)
        raise


def _add(document: Any, cls: type, name: str, kind: str = "Part::FeaturePython") -> Any:
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
    >>> box = make_box(document)
    >>> sites = make_prism_sites(box)
    >>> sites.SitesX = 3
    >>> update(sites)
    >>> sites.Count
    182
    """
    if isinstance(getattr(obj, "Proxy", None), Feature):
        obj.Proxy.prepare(obj, progress)
    obj.recompute()
    if not obj.isValid():
        raise KernelError(f"{obj.Label} could not be computed: {getattr(obj, 'Status', '') or 'the kernel refused it'}")


# ---------------------------------------------------------------------------------------------- the envelope, sites


def make_box(document: Any, l: float = 10.0, w: float = 10.0, h: float = 10.0, name: str = "Envelope") -> Any:  # noqa: E741
    """Add a box, one corner at the origin, and return it.

    Parameters
    ----------
    document : App.Document
    l, w, h : float, mm
        Edges along X, Y, Z.
    name : str

    Examples
    --------
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


# ----------------------------------------------------------------------------------------------- a design at once


def make_design(document: Any, job: Job, progress: Progress = silent) -> Design:
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


def _job_envelope(document: Any, job: Job) -> Any:
    if job.prism is None:
        raise ParameterError("not yet")
    return make_box(document, job.prism.l, job.prism.w, job.prism.h)
