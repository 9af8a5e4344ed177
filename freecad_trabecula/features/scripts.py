# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document's designs as the Python that makes them again, in the functions of ``make``."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any, Callable, Dict, List, Sequence, Set, Tuple

import FreeCAD

from ..core.analysis.parameters import SliceParameters
from ..core.parameters import PrismParameters, ScaffoldParameters
from ..core.python_text import Name, call_text, import_lines, python_text, same
from ..core.voxels.parameters import VoxelParameters
from ..core.wireframe import WireframeParameters
from ..errors import ParameterError
from .analysis import Analysis
from .analysis_makers import default_parameters, design_envelope
from .arguments import given_document, given_object, given_value
from .base import read_parameters
from .envelope import source_of
from .face_sites import FaceSites
from .feature import ERROR, is_a
from .makers import body_objects
from .network import Network
from .prism_sites import PrismSites
from .relations import wireframe_of
from .scaffold import Body, Scaffold
from .solid_scaffold import SolidScaffold
from .voxel_design import VoxelDesign
from .voxel_inputs import sample_of
from .wireframe import Wireframe

_HEAD = "# {}: made again by these lines; paste them into FreeCAD's Python console or run them with freecadcmd."


class Script:
    """Lines that grow, object by object: each is written when it is first referred to, what it needs before it."""

    def __init__(self) -> None:
        self.lines: List[str] = []
        self.needs: List[str] = []
        self.used: Set[type] = set()
        self.analyses: List[Any] = []
        self.needs_document = False
        self._names: Dict[str, Name] = {}

    def refer(self, obj: Any) -> Name:
        """Return the variable that holds an object; its lines are written if they are not there yet."""
        if obj.Name not in self._names:
            if str(getattr(obj, "Status", "")).startswith(ERROR):
                raise ParameterError(f"{obj.Label} must be without error to be written as a script, got: {obj.Status}")
            for cls, write in _WRITERS:
                if is_a(obj, cls):
                    write(self, obj)
                    break
            else:
                _write_body(self, obj)
        return self._names[obj.Name]

    def call(self, obj: Any, word: str, function: str, *arguments: Tuple[str, Any]) -> Name:
        """Write ``word = make.function(arguments)`` and return the variable."""
        name = self.variable(obj, word)
        head = f"{name} = "
        self.lines.append(head + call_text(f"make.{function}", arguments, self.used, len(head)))
        return name

    def variable(self, obj: Any, word: str) -> Name:
        """Return a new variable for an object."""
        taken = set(self._names.values())
        names = [word, *(f"{word}_{number}" for number in range(2, len(taken) + 3))]
        self._names[obj.Name] = Name(next(name for name in names if name not in taken))
        return self._names[obj.Name]

    def keep_label(self, obj: Any, name: Name, usual: str) -> None:
        """Write the label of an object, if it is not the one that it gets by itself."""
        if re.fullmatch(re.escape(usual) + r"\d*", obj.Label) is None:
            self.lines.append(f"{name}.Label = {python_text(obj.Label, self.used)}")

    def text(self, title: str) -> str:
        """Return the whole script."""
        document = "FreeCAD.ActiveDocument or FreeCAD.newDocument()" if self.needs_document else "FreeCAD.newDocument()"
        head = [_HEAD.format(title), *(f"# Needs {need}." for need in self.needs)]
        imports = ["import FreeCAD", "from freecad_trabecula import make", *import_lines(self.used)]
        return "\n".join([*head, *imports, "", f"document = {document}", *self.lines, ""])


_DOCUMENT = ("", Name("document"))


def design_as_script(obj: Any) -> str:
    """Return the Python that makes a design again, with what was made of it: bodies, analyses, comparisons, voxels.

    Parameters
    ----------
    obj : document object or App.Document
        One of ours: a wireframe (or what belongs to it), an analysis, a voxel design; or a document: all in it.

    Returns
    -------
    str
        Only what differs from the defaults is written. What the lines need and cannot make, a body that was modelled
        or a file, is told in comments at their top.

    Raises
    ------
    ParameterError
        If there is no design, or an object is in error.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> design = make.make_design(FreeCAD.newDocument(), preset("case1"))
    >>> [line for line in make.design_as_script(design.wireframe).splitlines() if "make_box" in line]
    ['envelope = make.make_box(document)']
    """
    chosen = _chosen(obj if hasattr(obj, "Objects") else given_object(obj))
    if not chosen:
        raise ParameterError(f"a script must have a design, an analysis or voxels to make, got none in {obj.Label}")
    script = Script()
    for one in chosen:
        script.refer(one)
    _write_comparison(script)
    title = obj.Label if hasattr(obj, "Objects") else f"{obj.Label} of {obj.Document.Label}"
    return script.text(" ".join(title.split()))  # a comment is one line


def _chosen(obj: Any) -> List[Any]:
    """What is asked for, in the order of the document; what it needs comes by itself."""
    document = obj if hasattr(obj, "Objects") else obj.Document
    kinds = (Wireframe, Network, Scaffold, SolidScaffold, Analysis, VoxelDesign)
    if obj is document:
        wanted = document.Objects
    else:
        first = wireframe_of(obj) or obj
        wanted = [first, *first.InListRecursive]
    names = {one.Name for one in wanted if is_a(one, *kinds)}
    return [one for one in document.Objects if one.Name in names]


def named_body(document: FreeCAD.Document, name: str) -> Any:
    """Return the body of that name in a document, which a script needs and cannot make.

    Raises
    ------
    ParameterError
        If there is none.

    Examples
    --------
    >>> from freecad_trabecula import make
    >>> document = FreeCAD.newDocument()
    >>> make.named_body(document, make.make_box(document).Name).Name
    'Envelope'
    """
    found = given_document(document).getObject(given_value(name, str))
    if found is None:
        raise ParameterError(
            f"the document must have the body {name!r}, got none in {document.Label}: "
            "open the document with it first, or give one of yours this name"
        )
    return found


# -------------------------------------------------------------------------------------------------- bodies, sites


def _write_body(script: Script, obj: Any) -> None:
    file, solid = source_of(obj)
    if file:
        script.needs.append(_file_need(file))
        more = [("solid", solid)] if solid else []
        name = script.call(obj, "envelope", "make_envelope", _DOCUMENT, ("", file), *more)
        _write_place(script, obj, name)
    elif obj.TypeId == "Part::Box":
        edges = [(letter, getattr(obj, edge).Value) for letter, edge in zip("lwh", ("Length", "Width", "Height"))]
        name = script.call(obj, "envelope", "make_box", _DOCUMENT, *(one for one in edges if one[1] != 10.0))
        _write_place(script, obj, name)
    else:
        label = " ".join(obj.Label.split())
        script.needs_document = True
        script.needs.append(f"the body {obj.Name} ({label}, {obj.TypeId}) in the active document; it was modelled")
        name = script.call(obj, "body", "named_body", _DOCUMENT, ("", obj.Name))
    if file or obj.TypeId == "Part::Box":
        script.keep_label(obj, name, "Envelope")


def _file_need(file: str) -> str:
    gone = "" if Path(file).exists() else "; it is not there now"
    return f"the file {file}{gone}"


def _write_place(script: Script, obj: Any, name: Name) -> None:
    place = obj.Placement
    if not place.isIdentity():
        base, turn = (", ".join(map(repr, values)) for values in (tuple(place.Base), place.Rotation.Q))
        script.lines.append(
            f"{name}.Placement = FreeCAD.Placement(FreeCAD.Vector({base}), FreeCAD.Rotation({turn}))\n"
            f"make.update({name})"
        )


def _write_prism_sites(script: Script, obj: Any) -> None:
    box, plain = script.refer(obj.Box), PrismParameters()
    parameters = replace(obj.Proxy.parameters(obj), l=plain.l, w=plain.w, h=plain.h)  # the box has the edges
    script.call(obj, "sites", "make_prism_sites", ("", box), *_unless("", parameters, plain))


def _write_face_sites(script: Script, obj: Any) -> None:
    envelope, parameters = script.refer(obj.Proxy.envelope(obj)), obj.Proxy.parameters(obj)
    word = "sites_" + re.sub(r"\W", "_", parameters.label)
    script.call(obj, word, "make_face_sites", ("", envelope), ("", parameters))


def _unless(key: str, value: Any, usual: Any) -> Sequence[Tuple[str, Any]]:
    """An argument, if it is not what the function takes by itself."""
    return [] if same(value, usual) else [(key, value)]


# ------------------------------------------------------------------------------------------------------- the rods


def _write_wireframe(script: Script, obj: Any) -> None:
    envelope = script.refer(obj.Envelope)
    sites = tuple(script.refer(one) for one in obj.Sites)
    parameters: WireframeParameters = obj.Proxy.parameters(obj)
    name = script.call(obj, "wireframe", "make_wireframe", ("", envelope), ("", sites), ("", parameters))
    script.keep_label(obj, name, "Wireframe")


def _write_network(script: Script, obj: Any) -> None:
    name = script.call(obj, "network", "make_network", ("", script.refer(obj.Wireframe)))
    script.keep_label(obj, name, "Network")


def _write_scaffold(script: Script, obj: Any, word: str = "scaffold", label: str = "Scaffold") -> None:
    parameters = _unless("", read_parameters(obj, ScaffoldParameters), ScaffoldParameters())
    name = script.call(obj, word, f"make_{word}", ("", script.refer(obj.Wireframe)), *parameters)
    script.keep_label(obj, name, label)


def _write_solid_scaffold(script: Script, obj: Any) -> None:
    _write_scaffold(script, obj, "solid_scaffold", "SolidScaffold")


def _write_part(script: Script, obj: Any) -> None:
    scaffold = script.refer(obj.Scaffold)
    parts = [one.Name for one in body_objects(obj.Scaffold)]
    script.lines.append(f"{script.variable(obj, obj.Role)} = make.body_objects({scaffold})[{parts.index(obj.Name)}]")


# ---------------------------------------------------------------------------------------------- analyses, voxels


def _write_analysis(script: Script, obj: Any) -> None:
    source, parameters = obj.Source, obj.Proxy.parameters(obj)
    arguments = [_DOCUMENT, ("", _sample(script, obj))]
    usual = default_parameters(source) if source is not None else SliceParameters()
    arguments += _unless("", parameters, usual)
    arguments += _unless("morphometry", bool(obj.Morphometry), False)
    if source is None:
        arguments += _unless("unit", obj.Unit, "auto")
    if obj.Envelope != (design_envelope(source) if source is not None else None):
        arguments.append(("envelope", script.refer(obj.Envelope) if obj.Envelope is not None else None))
    name = script.call(obj, "analysis", "make_analysis", *arguments)
    if obj.Deflection.Value:
        script.lines += [f"{name}.Deflection = {obj.Deflection.Value!r}", f"make.update({name})"]
    script.keep_label(obj, name, f"Analysis {source.Label if source is not None else Path(obj.File).stem}")
    script.analyses.append(obj)


def _sample(script: Script, obj: Any) -> Any:
    """The body of an analysis or a voxel design as an argument: a variable, or the path of a file."""
    if obj.Source is not None:
        return script.refer(obj.Source)
    if not obj.File:
        return sample_of(obj)  # drawn curves
    need = _file_need(obj.File)
    if need not in script.needs:
        script.needs.append(need)
    return obj.File


def _write_comparison(script: Script) -> None:
    """Lay the analyses side by side that have an axis in common with the first, as the window does."""
    first = script.analyses[:1]
    axes = [set(one.Proxy.parameters(one).axes) for one in script.analyses]
    names = ", ".join(script.refer(one) for one, own in zip(script.analyses, axes) if own & axes[0])
    if len(first) and "," in names:
        script.lines.append(f"comparison = make.compare_analyses([{names}])")


def _write_voxels(script: Script, obj: Any) -> None:
    arguments = [_DOCUMENT, ("", _sample(script, obj))]
    arguments += _unless("", read_parameters(obj, VoxelParameters), VoxelParameters())
    if obj.Envelope is not None:
        arguments.append(("envelope", script.refer(obj.Envelope)))
    arguments += _unless("surface", obj.Surface, "blocks")
    if obj.Alpha:
        arguments.append(("tables", (list(obj.Alpha), list(obj.Beta))))
    name = script.call(obj, "voxels", "make_voxel_design", *arguments)
    label = obj.Source.Label if obj.Source is not None else Path(obj.File).stem or "of drawn curves"
    script.keep_label(obj, name, f"Voxels {label}")


#: How each kind of object is written; the first that fits. A new kind of object is one line here.
_WRITERS: Sequence[Tuple[type, Callable[[Script, Any], None]]] = (
    (PrismSites, _write_prism_sites),
    (FaceSites, _write_face_sites),
    (Wireframe, _write_wireframe),
    (Network, _write_network),
    (SolidScaffold, _write_solid_scaffold),
    (Scaffold, _write_scaffold),
    (Body, _write_part),
    (Analysis, _write_analysis),
    (VoxelDesign, _write_voxels),
)
