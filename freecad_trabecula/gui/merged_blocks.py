# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks of a voxel design in the 3D view: coplanar faces merged, and coarser blocks while the camera moves."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, Sequence, Tuple

import numpy as np
from pivy import coin
from PySide import QtCore

from .. import make
from ..core.voxels.design import VoxelDesign
from ..core.voxels.merged_faces import Rectangles, coarse_faces, merged_faces, sampled_faces
from ..errors import TrabeculaError
from .aside import compute_aside, filled_in_pieces, in_turns

MODE, PLAIN = "Merged blocks", "Shaded"
LEAST_FACETS = 100_000  # of a mesh; smaller ones are drawn fast as they are
_MOVING = 30_000  # rectangles at most while the camera moves: software draws them 20 times a second
_REST = 350  # milliseconds after which a camera is taken to stand still
_SAMPLED = 30  # blocks along the longest edge of what is shown at once
_NORMALS = ((-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1))
Side = Tuple[np.ndarray, Tuple[int, int, int]]  # corners (4 R, 3) of rectangles, mm, and where they face


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
        self.is_whole = False
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
        if self._key == self._object.ResultKey:
            return
        self._key = key = self._object.ResultKey
        try:
            design = make.voxel_design_of(self._object)
        except TrabeculaError:
            return  # there is none yet
        self.is_whole = False
        self.coarse.removeAllChildren()
        self._show(self.fine, _shapes_at_once(_sides(sampled_faces(design.voxels, _SAMPLED), design)))
        compute_aside(lambda: _all_sides(design), lambda found: in_turns(self._filled(found, key)))

    def _filled(self, found: Sequence[Sequence[Side]], key: str) -> Iterator[None]:
        """Make shapes piece by piece and show them when they are whole; not if another design is wanted by then."""
        made: List[List[Any]] = [[], []]
        for shapes, sides in zip(made, found):
            for side in sides:
                yield from _filled_shape(side, shapes)
                if self._key != key:
                    return
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


def _all_sides(design: VoxelDesign) -> Tuple[List[Side], List[Side]]:
    """What is drawn at rest and while the camera moves; no part of the scene is touched."""
    fine = merged_faces(design.voxels)
    coarse = fine if len(fine.corners) <= _MOVING else coarse_faces(design.voxels, _MOVING)
    return _sides(fine, design), _sides(coarse, design)


def _sides(rectangles: Rectangles, design: VoxelDesign) -> List[Side]:
    """The corners (4 R, 3) of rectangles, mm, and where they face; those of each way that there are."""
    targets, sides, start = design.targets, [], 0
    for normal, count in zip(_NORMALS, rectangles.counts):
        corners = rectangles.corners[start : start + count].reshape(-1, 3)
        start += count
        if count:
            points = corners * np.asarray(targets.voxel) + np.asarray(targets.origin)
            sides.append((points.astype(np.float32), normal))
    return sides


def _filled_shape(side: Side, shapes: List[Any]) -> Iterator[None]:
    """Add the shape of one side to others, piece by piece."""
    points, normal = side
    places, shape = coin.SoVertexProperty(), coin.SoFaceSet()
    yield from filled_in_pieces(places.vertex, points)
    # one normal for all is not sent with arrays of vertices: the shapes would be without shade
    yield from filled_in_pieces(places.normal, np.broadcast_to(np.array(normal, np.float32), points.shape))
    places.normalBinding = coin.SoVertexProperty.PER_VERTEX
    shape.vertexProperty = places
    yield from filled_in_pieces(shape.numVertices, np.full(len(points) // 4, 4))
    shapes.append(shape)


def _shapes_at_once(sides: Sequence[Side]) -> List[Any]:
    shapes: List[Any] = []
    for side in sides:
        for _ in _filled_shape(side, shapes):
            pass
    return shapes


def choose_mode(obj: Any, is_coloured: bool) -> None:
    """Draw many blocks merged, and as their mesh what is smooth, small, or has colours of its own."""
    view = obj.ViewObject
    merged = obj.Surface == "blocks" and obj.Mesh.CountFacets > LEAST_FACETS and not is_coloured
    if MODE in view.listDisplayModes() and view.DisplayMode in (MODE, PLAIN):
        wanted = MODE if merged else PLAIN
        if view.DisplayMode != wanted:
            view.DisplayMode = wanted
        if merged and obj.ResultKey:
            view.Proxy.blocks.fill()  # before the view is fitted to what it shows
