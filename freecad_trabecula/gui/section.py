# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plane that cuts the 3D view open: what lies before it is not drawn, the cut is filled as our slicer sees it.

It lives in the scene alone: the document knows nothing of it, and nothing is left when it is closed.
"""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import FreeCADGui
import numpy as np
from pivy import coin
from PySide import QtCore, QtGui

from ..core.analysis.contours import Contours, contour_measures
from ..core.analysis.cross_section import Sections
from ..core.analysis.parameters import SliceParameters, axis_frame
from ..core.colours import BLUE, VERMILION, Entry, Legend
from .legend import LEGEND_NODE
from .slice_view import plane_box

FILLS = ("plain", "rods and plates", "none")
_PIXELS = 1024  # along the longer side of the picture of the cut


class Body(NamedTuple):
    """What is cut: its triangles (T, 3, 3), mm, and the colour (0..1) of its cut."""

    name: str
    triangles: np.ndarray
    colour: Tuple[float, float, float]


class Section:
    """A section through the views of one document, until ``close``.

    Parameters
    ----------
    document : str
    """

    def __init__(self, document: str) -> None:
        self.axis, self.height, self.flipped, self.fill = "z", 0.0, False, FILLS[0]
        self.legend: Optional[Legend] = None
        self._bodies: Tuple[Body, ...] = ()
        self._sections: Dict[str, Sections] = {}
        self._box = np.zeros((2, 3))
        self.node = coin.SoGroup()
        self._clip = coin.SoClipPlane()
        self._corners, self._texture = coin.SoCoordinate3(), coin.SoTexture2()
        self.node.addChild(self._cap())  # before the plane, which cuts only what comes after it
        self.node.addChild(self._clip)
        self._scenes: List[Any] = []
        for view in FreeCADGui.getDocument(document).mdiViewsOfType("Gui::View3DInventor"):
            # scenes, not views: FreeCAD crashes when a view is asked whose document was closed
            self._scenes.append(view.getSceneGraph())
            self._scenes[-1].insertChild(self.node, _place(self._scenes[-1]))

    def _cap(self) -> Any:
        skip = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()  # FreeCAD's: "fit all" passes it over
        cap, unpickable, light = coin.SoSeparator(), coin.SoPickStyle(), coin.SoLightModel()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        white, hints, places = coin.SoBaseColor(), coin.SoShapeHints(), coin.SoTextureCoordinate2()
        white.rgb = (1, 1, 1)
        hints.vertexOrdering = coin.SoShapeHints.UNKNOWN_ORDERING
        places.point.setValues(0, 4, [(0, 0), (1, 0), (1, 1), (0, 1)])
        self._texture.wrapS = self._texture.wrapT = coin.SoTexture2.CLAMP
        self._face = coin.SoFaceSet()
        self._face.numVertices = 4
        for child in (unpickable, light, white, hints, self._texture, places, self._corners, self._face):
            cap.addChild(child)
        self._switch = coin.SoSwitch()
        self._switch.addChild(cap)
        skip.addChild(self._switch)
        return skip

    # ------------------------------------------------------------------------------------------------ what is cut

    def set_bodies(self, bodies: Sequence[Body], box: np.ndarray) -> None:
        """Take what is cut, and the box (2, 3) of all that is seen, mm."""
        self._bodies, self._box, self._sections = tuple(bodies), box, {}

    def range(self, axis: str) -> Tuple[float, float]:
        """Return the lowest and highest height at which planes across an axis cut the box, mm."""
        corners = np.array([[self._box[k >> axis & 1, axis] for axis in range(3)] for k in range(8)])
        heights = corners @ axis_frame(axis)[2]
        return float(heights.min()), float(heights.max())

    def show(self, axis: str, height: float, flipped: bool, fill: str) -> None:
        """Cut at a height (mm) along an axis; what lies above it is not drawn, or, if flipped, what lies below."""
        if axis != self.axis:
            self._sections = {}
        self.axis, self.height, self.flipped, self.fill = axis, height, flipped, fill
        normal = axis_frame(axis)[2] * (1 if flipped else -1)
        distance = height if flipped else -height
        self._clip.plane = coin.SbPlane(coin.SbVec3f(*normal.tolist()), distance)
        self._fill()

    def _contours(self, body: Body) -> Contours:
        if body.name not in self._sections:
            self._sections[body.name] = Sections(body.triangles, self.axis)
        return self._sections[body.name].at(self.height)

    def _fill(self) -> None:
        is_filled = self.fill != FILLS[2] and bool(self._bodies)
        self._switch.whichChild = coin.SO_SWITCH_ALL if is_filled else coin.SO_SWITCH_NONE
        self.legend = None
        if not is_filled:
            return
        low, high = plane_box(self.axis, self._box)
        picture = Picture(low, high)
        counts = np.zeros(2, int)
        for body in self._bodies:
            contours = self._contours(body)
            if not len(contours.plane):
                continue
            if self.fill == FILLS[0]:
                picture.paint(contours, [(np.ones(len(contours.plane), bool), body.colour)])
                continue
            measures = contour_measures(contours, SliceParameters())
            rods = _owner_is(measures.is_rod, measures.parent, measures.area)
            kinds = [(rods, np.array(BLUE) / 255), (~rods, np.array(VERMILION) / 255)]
            picture.paint(contours, kinds)
            outer = measures.area > 0
            counts += [int((outer & measures.is_rod).sum()), int((outer & ~measures.is_rod).sum())]
        if self.fill == FILLS[1]:
            rows = (("rods", BLUE, counts[0]), ("plates", VERMILION, counts[1]))
            self.legend = Legend("kind", entries=tuple(Entry(name, colour, int(n)) for name, colour, n in rows))
        self._texture.image.setValue(coin.SbVec2s(*picture.size), 4, picture.pixels())
        first, second, normal = axis_frame(self.axis)
        places = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
        corners = [(u * first + v * second + self.height * normal).tolist() for u, v in places]
        self._corners.point.setValues(0, 4, corners)

    def close(self) -> None:
        """Take it out of the views."""
        for scene in self._scenes:
            if scene.findChild(self.node) >= 0:
                scene.removeChild(self.node)
        self._scenes = []


def _place(scene: Any) -> int:
    """Where the node goes: after legends, which are not cut."""
    has_legend = scene.getNumChildren() > 0 and scene.getChild(0).getName().getString() == LEGEND_NODE
    return 1 if has_legend else 0


def _owner_is(flags: np.ndarray, parent: np.ndarray, area: np.ndarray) -> np.ndarray:
    """Flags of the outer contours, handed to their holes."""
    return np.where((area < 0) & (parent >= 0), flags[parent], flags)


class Picture:
    """Contours painted into a picture of a plane's box, clear where there is nothing.

    Parameters
    ----------
    low, high : ndarray (2,), mm
    """

    def __init__(self, low: np.ndarray, high: np.ndarray) -> None:
        size = np.maximum(high - low, 1e-9)
        self._low, self._scale = low, _PIXELS / float(size.max())
        self.size = tuple(max(int(round(edge * self._scale)), 1) for edge in size.tolist())
        self._image = QtGui.QImage(*self.size, QtGui.QImage.Format_RGBA8888)
        self._image.fill(QtCore.Qt.transparent)

    def paint(self, contours: Contours, kinds: Sequence[Tuple[np.ndarray, Sequence[float]]]) -> None:
        """Paint contours; what runs counter-clockwise is filled, overlaps once, holes are left out.

        Parameters
        ----------
        contours : Contours
            Of one plane.
        kinds : sequence of (mask (C,), colour of 0..1)
        """
        points = (contours.points - self._low) * self._scale  # upside down in the picture, upright in the texture
        painter = QtGui.QPainter(self._image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(QtCore.Qt.NoPen)
        for mask, colour in kinds:
            path = QtGui.QPainterPath()
            path.setFillRule(QtCore.Qt.WindingFill)
            for k in np.flatnonzero(mask & contours.closed).tolist():
                part = points[contours.starts[k] : contours.starts[k + 1]].tolist()
                path.addPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in part]))
                path.closeSubpath()
            painter.fillPath(path, QtGui.QColor.fromRgbF(*(float(one) for one in colour)))
        painter.end()

    def pixels(self) -> bytes:
        """Return the picture as a texture takes it: rows from below."""
        return bytes(self._image.constBits())

    def colour_at(self, u: float, v: float) -> Tuple[int, int, int, int]:
        """Return the colour (0..255, the last one how dense) at in-plane co-ordinates, mm."""
        x, y = (int((one - low) * self._scale) for one, low in zip((u, v), self._low))
        return self._image.pixelColor(x, y).getRgb()
