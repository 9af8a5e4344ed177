# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that carry meaning on the objects of a document: a view property says which, a legend says what they mean.

What is chosen is saved with the document. Colours of faces and edges are FreeCAD's own and are saved too; those of
triangles are put into the scene anew when the document is opened.
"""

from __future__ import annotations

from itertools import count
from typing import Any, Dict, Iterator, Optional, Tuple

import FreeCAD
import numpy as np
from pivy import coin

from ..core.colours import Colouring, Legend
from ..errors import TrabeculaError
from ..features.colouring import PLAIN, axis_of, choices, colouring_work, layers_work, missing_of
from ..features.relations import type_of
from .aside import compute_aside, filled_in_pieces, in_turns
from .language import in_words
from .legend import LegendOverlay, Titled
from .lost_rods import LostRods
from .merged_blocks import LayerColours, blocks_of, is_merged
from .qt import invoke_later

PROPERTY, _KEPT = "ColourBy", "PlainColour"
LEAST_FACETS = 20_000  # of a mesh whose colours come piece by piece
_overlays: Dict[str, LegendOverlay] = {}
_legends: Dict[str, Dict[str, Legend]] = {}  # by names of document and object
_lost: Dict[str, Dict[str, LostRods]] = {}
_also: Dict[str, Titled] = {}  # a legend of something else, by the document's name
_waiting: set = set()
_wanted: Dict[Tuple[str, str], int] = {}  # the latest colouring of an object: others that were begun are not finished
_numbers = count()


def add_property(view: Any) -> None:
    """Give a view the property, if its object has something to be coloured.

    Of objects that are not ours, such as a bone, the command alone changes it. An observer of all views would see them
    while they are being made, and FreeCAD 1.1 then takes a solid's for one without colours of faces, for good.
    """
    offered = choices(view.Object)
    if offered and not hasattr(view, PROPERTY):
        view.addProperty("App::PropertyEnumeration", PROPERTY, "Trabecula", "What the colours mean")
        setattr(view, PROPERTY, list(offered))
        if not type_of(view.Object):
            view.setEditorMode(PROPERTY, 2)


def is_coloured(obj: Any) -> bool:
    """Return whether the colours of an object mean something."""
    return getattr(obj.ViewObject, PROPERTY, PLAIN) != PLAIN


def colour(obj: Any) -> None:
    """Colour an object by what its view property says, and show the legend; many triangles get theirs a little later.

    Raises
    ------
    TrabeculaError
        If it cannot be coloured by that; it is plain then.
    """
    view, found = obj.ViewObject, _legends.setdefault(obj.Document.Name, {})
    key = obj.Document.Name, obj.Name
    was_coloured = key in _wanted
    found.pop(obj.Name, None)
    _waiting.discard(key)
    _wanted[key] = number = next(_numbers)
    try:
        if is_coloured(obj):
            by = getattr(view, PROPERTY)
            if is_merged(view):
                compute_aside(layers_work(obj, by), lambda found: _colour_blocks(key, number, found, axis_of(by)))
                return
            work = colouring_work(obj, by)
            if hasattr(obj, "Mesh") and obj.Mesh.CountFacets > LEAST_FACETS:
                compute_aside(work, lambda colouring: in_turns(_coloured_in_pieces(key, number, colouring)))
                return
            colouring = work()
            _put(view, colouring.colours)
            found[obj.Name] = colouring.legend
            _take_lost(obj, missing_of(obj, by))
        elif was_coloured:
            _put(view, None)
    except TrabeculaError:
        _put(view, None)
        raise
    finally:
        show_legends(obj.Document.Name)


def _coloured_in_pieces(key: Tuple[str, str], number: int, colouring: Colouring) -> Iterator[None]:
    """Put the colours of many triangles into the scene; not if the object goes, or is wanted otherwise by then."""
    obj = _present(key, number)
    if obj is None or obj.Mesh.CountFacets != len(colouring.colours):
        return
    for _ in _triangles_in_pieces(obj.ViewObject, colouring.colours):
        yield
        if _present(key, number) is None:
            return
    _explain(key, number, colouring)


def _colour_blocks(key: Tuple[str, str], number: int, colouring: Colouring, axis: int) -> None:
    """Put the colours of a voxel design's layers into the scene."""
    obj = _present(key, number)
    if obj is not None and is_merged(obj.ViewObject):
        blocks_of(obj.ViewObject).colour(
            LayerColours(colouring.colours, axis), lambda: _explain(key, number, colouring)
        )


def _present(key: Tuple[str, str], number: int) -> Any:
    """The object, if it is there and its latest colouring is this one; else None."""
    document, name = key
    obj = FreeCAD.getDocument(document).getObject(name) if document in FreeCAD.listDocuments() else None
    return obj if obj is not None and _wanted.get(key) == number else None


def _explain(key: Tuple[str, str], number: int, colouring: Colouring) -> None:
    """Show the legend of colours that are seen now."""
    if _present(key, number) is not None:
        _legends.setdefault(key[0], {})[key[1]] = colouring.legend
        show_legends(key[0])


def refresh(obj: Any) -> None:
    """Colour an object, whose property or result changed, as soon as the event loop is free."""
    key = obj.Document.Name, obj.Name
    if key not in _waiting:
        _waiting.add(key)
        invoke_later(lambda: _refresh(*key))


def refresh_source(analysis: Any) -> None:
    """Colour what an analysis slices, once that is known, if its colours are those of slices."""
    document, name = analysis.Document.Name, analysis.Name

    def later() -> None:
        found = FreeCAD.getDocument(document).getObject(name) if document in FreeCAD.listDocuments() else None
        source = getattr(found, "Source", None)
        if source is not None and is_coloured(source):
            refresh(source)

    invoke_later(later)


def _refresh(document: str, name: str) -> None:
    if (document, name) not in _waiting:
        return  # it has been coloured since
    _waiting.discard((document, name))
    obj = FreeCAD.getDocument(document).getObject(name) if document in FreeCAD.listDocuments() else None
    if obj is None:
        return
    try:
        colour(obj)
    except TrabeculaError as error:
        FreeCAD.Console.PrintWarning(in_words(str(error)) + "\n")


def show_also(document: str, legend: Optional[Titled]) -> None:
    """Show a legend besides those of the objects; None takes it away."""
    if legend is None:
        _also.pop(document, None)
    else:
        _also[document] = legend
    show_legends(document)


def legends_of(document: str) -> tuple:
    """Return the legends that the views of a document show."""
    return _overlays[document].legends if document in _overlays else ()


def show_legends(document: str) -> None:
    """Show the legends of the coloured objects that are seen."""
    if document not in FreeCAD.listDocuments():
        _forget(document)
        return
    shown = []
    found = _legends.get(document, {})
    for obj in FreeCAD.getDocument(document).Objects if found else ():
        if obj.Name in found and obj.ViewObject.Visibility:
            shown.append(Titled(found[obj.Name], obj.Label))
    for name, lost in _lost.get(document, {}).items():
        obj = FreeCAD.getDocument(document).getObject(name)
        lost.set_visible(name in found and obj is not None and obj.ViewObject.Visibility)
    shown += [_also[document]] if document in _also else []
    if shown or document in _overlays:
        _overlays.setdefault(document, LegendOverlay()).show(document, shown)


def _forget(document: str) -> None:
    for kept in (_overlays, _legends, _lost, _also):
        kept.pop(document, None)
    for key in [one for one in _wanted if one[0] == document]:
        del _wanted[key]


# ------------------------------------------------------------------------------------------------ into the scene


def _take_lost(obj: Any, lines: np.ndarray) -> None:
    """Draw what failed beside an object; it moves with it and is seen while the object is."""
    kept = _lost.setdefault(obj.Document.Name, {})
    if len(lines) and obj.Name not in kept:
        kept[obj.Name] = LostRods()
        obj.ViewObject.RootNode.addChild(kept[obj.Name].node)
    if obj.Name in kept:
        kept[obj.Name].take(lines)


def _put(view: Any, colours: Optional[np.ndarray]) -> None:
    """Give faces, edges or triangles their colours (N, 3) of 0..255; None gives back the plain one."""
    if hasattr(view.Object, "Mesh"):
        _put_on_triangles(view, colours)
        return
    has_faces = hasattr(view.Object, "RodKeys")
    name = "DiffuseColor" if has_faces else "LineColorArray"
    if len(getattr(view, name)) <= 1:
        _keep_plain(view, view.ShapeColor if has_faces else view.LineColor)
    plain = getattr(view, _KEPT)[:3]
    rows = [plain] if colours is None else (colours / 255.0).tolist()
    if not has_faces and colours is not None:  # the pores keep theirs
        rows += [plain] * max(view.Object.Shape.countElement("Edge") - len(rows), 0)
    fourth = _fourth(view) if has_faces else 0.0
    setattr(view, name, [(*row, fourth) for row in rows])


def _keep_plain(view: Any, plain: Any) -> None:
    """FreeCAD 1.x takes the first face's colour for that of the whole: the plain one is kept aside."""
    if not hasattr(view, _KEPT):
        view.addProperty("App::PropertyColor", _KEPT, "Trabecula", "Colour when plain")
        view.setEditorMode(_KEPT, 2)
    setattr(view, _KEPT, plain[:3])


def _fourth(view: Any) -> float:
    """The fourth number of a colour: how clear it is up to FreeCAD 0.21, how dense since 1.0."""
    clear = view.Transparency / 100.0
    return 1.0 - clear if hasattr(view, "ShapeAppearance") else clear


def _put_on_triangles(view: Any, colours: Optional[np.ndarray]) -> None:
    """Give a mesh one colour, or each of its triangles its own, at once."""
    if colours is not None:
        for _ in _triangles_in_pieces(view, colours):
            pass
        return
    blocks = blocks_of(view)
    if blocks is not None:
        blocks.colour(None)
    material, binding = _looks_of_triangles(view)
    if material is not None and binding is not None:
        binding.value = coin.SoMaterialBinding.OVERALL
        material.diffuseColor.setNum(1)
        material.diffuseColor.setValue(*view.ShapeColor[:3])


def _triangles_in_pieces(view: Any, colours: np.ndarray) -> Iterator[None]:
    """Triangles have no colours of their own in FreeCAD's meshes, but the scene knows how to draw them."""
    material, binding = _looks_of_triangles(view)
    if material is None or binding is None:
        return
    binding.value = coin.SoMaterialBinding.OVERALL  # until there is a colour for each
    yield from filled_in_pieces(material.diffuseColor, colours / np.float32(255))
    binding.value = coin.SoMaterialBinding.PER_FACE


def _looks_of_triangles(view: Any) -> Tuple[Any, Any]:
    """Material and its binding, which all display modes of a mesh share; merged blocks have others."""
    blocks = blocks_of(view)
    apart = blocks.node if blocks is not None else None
    return _first(view.RootNode, coin.SoMaterial, apart), _first(view.RootNode, coin.SoMaterialBinding, apart)


def _first(root: Any, kind: Any, apart: Any) -> Any:
    """The first node of a kind, not below another node; also where a mode is switched off."""
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(root)
    paths = search.getPaths()
    found = (paths[number] for number in range(paths.getLength()))
    return next((path.getTail() for path in found if apart is None or not path.containsNode(apart)), None)


def _refresh_others(document: Any) -> None:
    for obj in document.Objects:
        if not type_of(obj) and hasattr(obj.ViewObject, PROPERTY):
            refresh(obj)


class _Observer:
    """Forgets documents that are closed, and follows names and deletions (FreeCAD's observer protocol)."""

    def slotDeletedDocument(self, document: Any) -> None:
        """Forget its legends; its views go with it."""
        _forget(document.Name)

    def slotDeletedObject(self, obj: Any) -> None:
        """Take its legend away."""
        _lost.get(obj.Document.Name, {}).pop(obj.Name, None)
        if _legends.get(obj.Document.Name, {}).pop(obj.Name, None) is not None:
            name = obj.Document.Name
            invoke_later(lambda: show_legends(name))

    def slotUndoDocument(self, document: Any) -> None:
        """Colour what is not ours by what its view says again: its view tells nobody (see ``add_property``)."""
        _refresh_others(document)

    def slotRedoDocument(self, document: Any) -> None:
        """The same after redo."""
        _refresh_others(document)

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Follow its label, and whether it is seen."""
        if name in ("Label", "Visibility") and obj.Name in _legends.get(obj.Document.Name, {}):
            show_legends(obj.Document.Name)


_observer = _Observer()
FreeCAD.addDocumentObserver(_observer)
