# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that add one object to a document and compute it.

On an error they raise it and leave the document as it was. They open no transaction: that is the caller's, so that a
command in the window is one step to undo.
"""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import Any, Dict, Iterator, Optional, Sequence

import FreeCAD

from ..core.parameters import FaceParameters, PrismParameters, ScaffoldParameters
from ..core.progress import Progress, silent
from ..core.wireframe import WireframeParameters
from ..geometry.envelopes import load_envelope
from ..views import attach_view
from .arguments import given_document, given_in, given_object, given_objects, given_value
from .base import lines_of, write_parameters
from .containers import place_beside
from .envelope import fill
from .face_sites import FaceSites
from .feature import is_a, update
from .network import Network
from .prism_sites import PrismSites
from .scaffold import ROLES, Body, Scaffold
from .solid_scaffold import SolidScaffold
from .wireframe import Wireframe

#: Kinds of properties that are computed, or FreeCAD's own: they are not given back, but computed again.
_COMPUTED = ("Part::", "Mesh::", "App::PropertyPythonObject", "App::PropertyExpressionEngine", "App::PropertyPlacement")


@contextmanager
def all_or_nothing(document: FreeCAD.Document, changed: Sequence[Any] = ()) -> Iterator[None]:
    """Remove the objects added inside, and give those that are changed their values back, if an error leaves."""
    before = {obj.Name for obj in given_document(document).Objects}
    kept = [(obj, _values(obj)) for obj in changed]
    try:
        yield
    except BaseException:
        for obj, values in kept:
            for name, value in values.items():
                if getattr(obj, name) != value:
                    setattr(obj, name, value)
        for name in [obj.Name for obj in document.Objects if obj.Name not in before][::-1]:
            document.removeObject(name)
        if kept:
            document.recompute([obj for obj, _ in kept])
        raise


def _values(obj: Any) -> Dict[str, Any]:
    """Return what an object was told, by property: not what was computed."""
    names = [name for name in obj.PropertiesList if "ReadOnly" not in obj.getTypeOfProperty(name)]
    return {name: getattr(obj, name) for name in names if not obj.getTypeIdOfProperty(name).startswith(_COMPUTED)}


def add(document: FreeCAD.Document, cls: type, name: str, kind: str = "Part::FeaturePython", **properties: Any) -> Any:
    """Add an object of one of our classes with some properties set, beside what it is made of; not computed yet."""
    obj = document.addObject(kind, name)
    cls(obj)
    for key, value in properties.items():
        if isinstance(value, FreeCAD.DocumentObject):
            place_beside(obj, value)
        setattr(obj, key, value)
    attach_view(obj)  # its look may depend on them
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
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> round(make.make_box(document, 51, 40.6, 8.55).Shape.Volume, 2)
    17703.63
    """
    prism = PrismParameters(l=l, w=w, h=h, a_x=0, a_y=0, a_z=0)  # checks the edges
    with all_or_nothing(document):
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
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> make.make_prism_sites(make.make_box(document), PrismParameters(n_x=5, n_y=5, n_z=5)).Count
    150
    """
    document = given_object(box).Document
    given_value(prism, PrismParameters, type(None))
    with all_or_nothing(document):
        sites = add(document, PrismSites, "Sites", Box=box)
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
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> make.make_face_sites(make.make_box(document), FaceParameters("Face6", "top", c_u=2, c_v=2, b_u=1, b_v=1)).Count
    25
    """
    document = given_object(envelope).Document
    given_value(parameters, FaceParameters)
    with all_or_nothing(document):
        sites = add(document, FaceSites, f"Sites_{parameters.label}")
        place_beside(sites, envelope)
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
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> import os, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "cube.step")
    >>> make.make_box(document, 5, 5, 5).Shape.exportStep(path)
    >>> round(make.make_envelope(document, path).Shape.Volume, 6)
    125.0
    """
    envelope = load_envelope(str(given_value(path, str, Path)), solid)
    with all_or_nothing(document):
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
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> box = make.make_box(document)
    >>> make.make_wireframe(box, [make.make_prism_sites(box)], preset("case6").wireframe).Rods
    147
    """
    document = given_object(envelope).Document
    given_value(parameters, WireframeParameters)
    own = given_objects(sites, PrismSites, FaceSites)
    given_in(document, *own)
    with all_or_nothing(document):
        wireframe = add(document, Wireframe, "Wireframe", Envelope=envelope, Sites=own)
        set_wireframe_parameters(wireframe, parameters)
        update(wireframe, progress)
    return wireframe


def set_wireframe_parameters(wireframe: Any, parameters: WireframeParameters) -> None:
    """Set all properties of a wireframe object; it is not computed yet."""
    given_object(wireframe, Wireframe)
    given_value(parameters, WireframeParameters)
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
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> network = make.make_network(make.make_design(document, preset("case1")).wireframe)
    >>> network.Rods, len(network.Shape.Solids)
    (75, 75)
    """
    document = given_object(wireframe, Wireframe).Document
    with all_or_nothing(document):
        network = add(document, Network, "Network", Wireframe=wireframe)
        update(network, progress)
    return network


def make_scaffold(wireframe: Any, parameters: Optional[ScaffoldParameters] = None, progress: Progress = silent) -> Any:
    """Add the scaffold of a wireframe, with its channels, loose pieces and voids, all meshes; return the scaffold.

    Parameters
    ----------
    wireframe : document object
    parameters : ScaffoldParameters, optional
    progress : callable

    Raises
    ------
    TrabeculaError
        If the channels cannot be cut, or two routes to a volume differ.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> from freecad_trabecula.core.presets import preset
    >>> scaffold = make.make_scaffold(make.make_design(document, preset("case1")).wireframe)
    >>> 10 < scaffold.Porosity < 20
    True
    >>> [body.Role for body in make.body_objects(scaffold)]
    ['channels', 'loose', 'voids']
    """
    document = given_object(wireframe, Wireframe).Document
    given_value(parameters, ScaffoldParameters, type(None))
    with all_or_nothing(document):
        scaffold = add(document, Scaffold, "Scaffold", "Mesh::FeaturePython", Wireframe=wireframe)
        write_parameters(scaffold, parameters or ScaffoldParameters())
        update(scaffold, progress)
        for role in ROLES:
            update(add(document, Body, role.capitalize(), "Mesh::FeaturePython", Scaffold=scaffold, Role=role))
    return scaffold


def make_solid_scaffold(
    wireframe: Any, parameters: Optional[ScaffoldParameters] = None, progress: Progress = silent
) -> Any:
    """Add the scaffold of a wireframe as a solid: the B-Rep engine, slow, every step checked against the mesh engine.

    Parameters
    ----------
    wireframe : document object
    parameters : ScaffoldParameters, optional
        Its time and memory budgets count.
    progress : callable

    Raises
    ------
    KernelError
        If the engine cannot finish; it says how far it came, and the document is as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from dataclasses import replace
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> job = preset("case1")
    >>> job = replace(job, couplings=(replace(job.couplings[0], limit=4),))
    >>> solid = make.make_solid_scaffold(make.make_design(FreeCAD.newDocument(), job).wireframe)
    >>> solid.RodsCut, solid.Shape.isValid(), solid.Difference < 0.2
    (4, True, True)
    """
    document = given_object(wireframe, Wireframe).Document
    given_value(parameters, ScaffoldParameters, type(None))
    with all_or_nothing(document):
        solid = add(document, SolidScaffold, "SolidScaffold", Wireframe=wireframe)
        write_parameters(solid, parameters or ScaffoldParameters())
        update(solid, progress)
    return solid


def body_objects(scaffold: Any) -> Sequence[Any]:
    """Return the objects that show channels, loose pieces and voids of a scaffold, in this order."""
    found = [obj for obj in given_object(scaffold, Scaffold).InList if is_a(obj, Body)]
    return sorted(found, key=lambda obj: ROLES.index(obj.Role))
