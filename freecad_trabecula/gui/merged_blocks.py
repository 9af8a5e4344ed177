# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks of a voxel design in the 3D view: coplanar faces merged, and coarser blocks while the camera moves.

Layers may have colours of their own: then only faces of one layer are merged.
"""

from __future__ import annotations

from itertools import count
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from pivy import coin
from PySide import QtCore

from .. import make
from ..core.voxels.design import VoxelDesign
from ..core.voxels.merged_faces import Rectangles, coarse_faces, layers_of, merged_faces, sampled_faces
from ..errors import TrabeculaError
from .aside import compute_aside, filled_in_pieces, in_turns

MODE, PLAIN = "Merged blocks", "Shaded"
LEAST_FACETS = 100_000  # of a mesh; smaller ones are drawn fast as they are
_MOVING = 30_000  # rectangles at most while the camera moves: software draws them 20 times a second
_REST = 350  # milliseconds after which a camera is taken to stand still
_KEPT = 4_000_000  # corners at most of shapes without colours that are kept while coloured ones are seen
_SAMPLED = 30  # blocks along the longest edge of what is shown at once
_NORMALS = ((-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1))
_numbers = count(1)


class LayerColours(NamedTuple):
    """Colours (S, 3) of 0..255 of the layers along an axis: 0, 1, 2."""

    colours: np.ndarray
    axis: int


class Side(NamedTuple):
    """Rectangles that face one way: corners (4 R, 3), mm; the way; colours (4 R, 3) of 0..1, if they have any."""

    points: np.ndarray
    normal: Tuple[int, int, int]
    colours: Optional[np.ndarray]


Sides = List[Side]


class MergedBlocks:
    """The node of a display mode; filled when it is seen for the first time.

    Parameters
    ----------
    view : view provider of a voxel design

    Attributes
    ----------
    is_whole : bool
        Whether all of the design is shown, not a sample of it.
    """

    def __init__(self, view: Any) -> None:
        self._object, self._key, self._asked = view.Object, "", ""
        self.is_whole = self._is_coloured = False
        self._wanted = 0  # what is under way for another number is not finished
        self._plain: Optional[List[List[Any]]] = None  # shapes without colours, at rest and while the camera moves
        self._cameras: Dict[Tuple[int, ...], Tuple[Any, ...]] = {}
        self.node, self.switch, self.material = coin.SoSeparator(), coin.SoSwitch(), coin.SoMaterial()
        self.fine, self.coarse = coin.SoSeparator(), coin.SoSeparator()
        self._watch = coin.SoCallback()
        self._watch.setCallback(self._drawn, None)
        hints, unseen, unpickable = coin.SoShapeHints(), coin.SoDrawStyle(), coin.SoPickStyle()
        hints.vertexOrdering, hints.shapeType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.SOLID
        unseen.style, unpickable.style = coin.SoDrawStyle.INVISIBLE, coin.SoPickStyle.UNPICKABLE
        picked, seen = coin.SoSeparator(), coin.SoSeparator()
        for parent, children in (
            (self.switch, (self.fine, self.coarse)),
            (picked, (unseen, self.coarse)),  # a mouse over millions of faces would wait for each move
            (seen, (unpickable, self.switch)),
            (self.node, (self._watch, hints, self.material, picked, seen)),
        ):
            for child in children:
                parent.addChild(child)
        self.switch.whichChild = 0
        self.node.renderCulling = coin.SoSeparator.OFF  # what is empty would never be drawn, and so never filled
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._rest)
        self.paint(view)
        view.addDisplayMode(self.node, MODE)

    def paint(self, view: Any) -> None:
        """Take the view's own colour and transparency."""
        looks = getattr(view, "ShapeAppearance", None)  # FreeCAD 1.x
        colour = looks[0].DiffuseColor if looks else view.ShapeColor
        self.material.diffuseColor.setValue(*(float(part) for part in colour[:3]))
        self.material.transparency.setValue(view.Transparency / 100.0)

    def fill(self) -> None:
        """Show the design as it is now: at once a coarse sample of it, and all of it when it has been computed."""
        if self._begin():
            self._compute(None, lambda: None)

    def _begin(self) -> bool:
        """Show a sample of another design, without colours; return whether there is one that is not shown yet."""
        if self._key == self._object.ResultKey:
            return False
        self._key, self._plain = self._object.ResultKey, None
        self.is_whole = self._is_coloured = False
        try:
            design = make.voxel_design_of(self._object)
        except TrabeculaError:
            return False  # there is none yet
        self.coarse.removeAllChildren()
        self._show(self.fine, _shapes_at_once(_sides(sampled_faces(design.voxels, _SAMPLED), design, None)))
        return True

    def colour(self, colours: Optional[LayerColours], shown: Callable[[], None] = lambda: None) -> None:
        """Give layers their colours, or all blocks the view's own; what was seen stays until that has been computed.

        Parameters
        ----------
        colours : LayerColours or None
        shown : callable
            Called when they are seen; not if others are wanted by then.

        Raises
        ------
        TrabeculaError
            If there is no design.
        """
        if colours is None and not self._is_coloured:
            return
        self._begin()
        self._is_coloured = colours is not None
        if colours is None and self._plain is not None:
            self._wanted = next(_numbers)
            self._take(self._plain)
        else:
            self._compute(colours, shown)

    def _compute(self, colours: Optional[LayerColours], shown: Callable[[], None]) -> None:
        design = make.voxel_design_of(self._object)
        self._wanted = number = next(_numbers)
        compute_aside(
            lambda: _all_sides(design, colours) if self._wanted == number else ([], []),
            lambda found: in_turns(self._filled(found, number, colours is None, shown)),
        )

    def _filled(self, found: Sequence[Sides], number: int, is_plain: bool, shown: Callable[[], None]) -> Iterator[None]:
        """Make shapes piece by piece and show them when they are whole; not if others are wanted by then."""
        made: List[List[Any]] = [[], []]
        for shapes, sides in zip(made, found):
            for side in sides:
                yield from _filled_shape(side, shapes)
                if self._wanted != number:
                    return
        if self._wanted == number:
            if is_plain and sum(len(side.points) for side in found[0]) <= _KEPT:
                self._plain = made
            self._take(made)
            shown()

    def _take(self, made: Sequence[Sequence[Any]]) -> None:
        """Show shapes of all blocks."""
        for place, shapes in zip((self.fine, self.coarse), made):
            self._show(place, shapes)
        self.is_whole = True

    @staticmethod
    def _show(place: Any, shapes: Sequence[Any]) -> None:
        place.removeAllChildren()
        for shape in shapes:
            place.addChild(shape)

    # ----------------------------------------------------------------------------------------------- while it is drawn

    def _drawn(self, data: Any, action: Any) -> None:
        """Choose what is drawn: coarse blocks in a picture whose camera is not where it was in the last."""
        if not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            return
        if self._object.ResultKey not in (self._key, self._asked):  # of a file that was opened
            self._asked = self._object.ResultKey
            QtCore.QTimer.singleShot(0, self.fill)
        state = action.getState()
        size = tuple(coin.SoViewportRegionElement.get(state).getViewportSizePixels())
        camera = tuple(
            element.get(state).getValue() for element in (coin.SoViewingMatrixElement, coin.SoProjectionMatrixElement)
        )
        before = self._cameras.get(size)
        self._cameras[size] = camera
        moves = before is not None and before != camera
        self.switch.enableNotify(False)  # no picture asks for the next
        self.switch.whichChild = 1 if moves else 0
        self.switch.enableNotify(True)
        if moves:
            self._timer.start(_REST)

    def _rest(self) -> None:
        """Have it drawn once more, whole."""
        self.switch.touch()


def _all_sides(design: VoxelDesign, colours: Optional[LayerColours]) -> Tuple[Sides, Sides]:
    """What is drawn at rest and while the camera moves; no part of the scene is touched."""
    apart = None if colours is None else colours.axis
    fine = merged_faces(design.voxels, apart)
    coarse = fine if len(fine.corners) <= _MOVING else coarse_faces(design.voxels, _MOVING, apart)
    return _sides(fine, design, colours), _sides(coarse, design, colours)


def _sides(rectangles: Rectangles, design: VoxelDesign, colours: Optional[LayerColours]) -> Sides:
    """Rectangles by where they face; those of each way that there are."""
    targets, sides, start = design.targets, [], 0
    if colours is not None:
        shares = (colours.colours / np.float32(255))[layers_of(rectangles, colours.axis)]
    for normal, number in zip(_NORMALS, rectangles.counts):
        rows = slice(start, start + number)
        start += number
        if number:
            points = rectangles.corners[rows].reshape(-1, 3) * np.asarray(targets.voxel) + np.asarray(targets.origin)
            given = None if colours is None else np.repeat(shares[rows], 4, 0)
            sides.append(Side(points.astype(np.float32), normal, given))
    return sides


def _filled_shape(side: Side, shapes: List[Any]) -> Iterator[None]:
    """Add the shape of one side to others, piece by piece."""
    points = side.points
    places, shape = coin.SoVertexProperty(), coin.SoFaceSet()
    yield from filled_in_pieces(places.vertex, points)
    # one normal for all is not sent with arrays of vertices: the shapes would be without shade
    yield from filled_in_pieces(places.normal, np.broadcast_to(np.array(side.normal, np.float32), points.shape))
    places.normalBinding = coin.SoVertexProperty.PER_VERTEX
    shape.vertexProperty = places
    yield from filled_in_pieces(shape.numVertices, np.full(len(points) // 4, 4))
    if side.colours is None:
        shapes.append(shape)
        return
    # not packed beside the vertices: such are not sent with arrays of vertices either
    colour, binding, whole = coin.SoBaseColor(), coin.SoMaterialBinding(), coin.SoSeparator()
    yield from filled_in_pieces(colour.rgb, side.colours)
    binding.value = coin.SoMaterialBinding.PER_VERTEX
    for child in (colour, binding, shape):
        whole.addChild(child)
    shapes.append(whole)


def _shapes_at_once(sides: Sequence[Side]) -> List[Any]:
    shapes: List[Any] = []
    for side in sides:
        for _ in _filled_shape(side, shapes):
            pass
    return shapes


def choose_mode(obj: Any) -> None:
    """Draw many blocks merged, and as their mesh what is smooth or small."""
    view = obj.ViewObject
    merged = obj.Surface == "blocks" and obj.Mesh.CountFacets > LEAST_FACETS
    if MODE in view.listDisplayModes() and view.DisplayMode in (MODE, PLAIN):
        wanted = MODE if merged else PLAIN
        if view.DisplayMode != wanted:
            view.DisplayMode = wanted
        if merged and obj.ResultKey:
            view.Proxy.blocks.fill()  # before the view is fitted to what it shows


def blocks_of(view: Any) -> Optional[MergedBlocks]:
    """Return the merged blocks of a view, seen or not; None if it has none."""
    return getattr(getattr(view, "Proxy", None), "blocks", None)


def is_merged(view: Any) -> bool:
    """Return whether a view draws merged blocks, not a mesh."""
    return blocks_of(view) is not None and view.DisplayMode == MODE
