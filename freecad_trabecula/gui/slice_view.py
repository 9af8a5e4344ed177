# SPDX-License-Identifier: LGPL-2.1-or-later
"""One slice as filled contours: rods and plates in two colours, voids left out; and its plane in the 3D view."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from pivy import coin
from PySide import QtCore, QtGui

from ..core.analysis.parameters import axis_frame
from ..core.colours import Entry, Legend
from .legend import Titled, height_of, paint_legend
from .preferences import preferred_colour
from .qt import paper_and_ink

_MARGIN, _TEXT, _LEGEND = 10, 18, 56  # pixels
#: Kinds of contours, and the preferences that hold their colours.
KINDS = {"rods": "ColourRodContours", "plates": "ColourPlateContours"}
_PLANE = (0.0, 0.45, 0.7)


class Slice(NamedTuple):
    """What is seen of one slice.

    Attributes
    ----------
    contours : sequence of ndarray (K, 2), mm
    areas : ndarray (C,), mm²
        Negative: a void.
    rods : ndarray (C,) of bool
    low, high : ndarray (2,), mm
        Corners of the body's box in the plane.
    words : sequence of str
        Lines above it: where it is, its numbers.
    """

    contours: Sequence[np.ndarray]
    areas: np.ndarray
    rods: np.ndarray
    low: np.ndarray
    high: np.ndarray
    words: Sequence[str]


def legend_of(one: Slice) -> Legend:
    """Return what the colours of a slice mean, and how many trabeculae have each."""
    outer = one.areas > 0
    counts = (int((outer & one.rods).sum()), int((outer & ~one.rods).sum()))
    colours = [QtGui.QColor(preferred_colour(name)).getRgb()[:3] for name in KINDS.values()]
    return Legend("kind", entries=tuple(map(Entry, KINDS, colours, counts)))


class SliceView(QtGui.QWidget):
    """Paints a slice, the same scale for all slices of a body."""

    def __init__(self) -> None:
        super().__init__()
        self.slice: Optional[Slice] = None
        self.notice = ""
        self.setMinimumSize(190, 170)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Expanding)

    def show_slice(self, one: Optional[Slice], notice: str = "") -> None:
        """Show a slice, or a notice in its place."""
        self.slice, self.notice = one, notice
        self.update()

    def paintEvent(self, event: Any) -> None:
        """Paint box, contours from the largest to the smallest, words."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        paper, ink = paper_and_ink()
        painter.fillRect(self.rect(), paper)
        painter.setPen(ink)
        if self.slice is None:
            painter.drawText(self.rect(), QtCore.Qt.AlignCenter | QtCore.Qt.TextWordWrap, self.notice)
        else:
            self._paint_slice(painter, paper, ink)
        painter.end()

    def _paint_slice(self, painter: Any, paper: Any, ink: Any) -> None:
        one = self.slice
        for number, line in enumerate(one.words):
            words = painter.fontMetrics().elidedText(line, QtCore.Qt.ElideRight, self.width() - 2 * _MARGIN)
            painter.drawText(QtCore.QPointF(_MARGIN, 14 + 15 * number), words)
        scale, place = self._scale(one)
        frame = place(np.stack([one.low, one.high]))
        painter.setPen(QtGui.QPen(ink, 0.8, QtCore.Qt.DotLine))
        painter.drawRect(QtCore.QRectF(QtCore.QPointF(*frame[0]), QtCore.QPointF(*frame[1])))
        painter.setPen(QtCore.Qt.NoPen)
        rod, plate = (QtGui.QColor(preferred_colour(name)) for name in KINDS.values())
        for k in np.argsort(-np.abs(one.areas), kind="stable").tolist():  # islands in voids come after the voids
            colour = paper if one.areas[k] < 0 else rod if one.rods[k] else plate
            painter.setBrush(colour)
            painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in place(one.contours[k]).tolist()]))
        legend = Titled(legend_of(one))
        box = QtCore.QRectF(_MARGIN, self.height() - _LEGEND, self.width() - 2 * _MARGIN, height_of(legend))
        paint_legend(painter, box, legend, ink)

    def _scale(self, one: Slice) -> Tuple[float, Any]:
        """Pixels per mm, and the function from mm (K, 2) to pixels (K, 2)."""
        size = np.maximum(one.high - one.low, 1e-9)
        room = np.array([self.width() - 2 * _MARGIN, self.height() - _MARGIN - 2 * _TEXT - _LEGEND], float)
        scale = float((room / size).min())
        middle = (one.low + one.high) / 2
        centre = np.array([self.width() / 2, 2 * _TEXT + (self.height() - 2 * _TEXT - _LEGEND) / 2])
        return scale, lambda points: centre + (np.asarray(points, float) - middle) * (scale, -scale)


class SlicePlane:
    """A translucent plane in a 3D view, neither picked nor boxed."""

    def __init__(self, view: Any) -> None:
        self.node = coin.SoSeparator()
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        hints, material = coin.SoShapeHints(), coin.SoMaterial()
        hints.vertexOrdering = coin.SoShapeHints.UNKNOWN_ORDERING
        material.diffuseColor = _PLANE
        material.emissiveColor = tuple(0.4 * c for c in _PLANE)
        material.transparency = 0.55
        self._corners, faces = coin.SoCoordinate3(), coin.SoFaceSet()
        for child in (unpickable, hints, material, self._corners, faces):
            self.node.addChild(child)
        # the scene, not the view: FreeCAD crashes when a view is asked whose document was closed
        self._scene = view.getSceneGraph()
        self._scene.addChild(self.node)

    def show(self, corners: np.ndarray) -> None:
        """Show the plane between four corners (4, 3), mm."""
        self._corners.point.setValues(0, 4, np.asarray(corners, float).tolist())

    def close(self) -> None:
        """Take the plane out of the view."""
        if self._scene.findChild(self.node) >= 0:
            self._scene.removeChild(self.node)


def plane_corners(axis: str, height: float, box: np.ndarray, margin: float = 0.04) -> np.ndarray:
    """Return the corners (4, 3) of the plane at a height across the box (2, 3) of a body, a little larger than it.

    Examples
    --------
    >>> plane_corners("z", 1.0, np.array([[0.0, 0, 0], [1, 2, 3]]), 0.0).tolist()
    [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 2.0, 1.0], [0.0, 2.0, 1.0]]
    """
    frame = axis_frame(axis)
    low, high = plane_box(axis, box)
    room = margin * float((high - low).max())
    low, high = low - room, high + room
    places = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    return np.array([u * frame[0] + v * frame[1] + height * frame[2] for u, v in places])


def plane_box(axis: str, box: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Return the lowest and highest in-plane co-ordinates (2,) of a body's box (2, 3)."""
    corners = np.array([[box[i, 0], box[j, 1], box[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    places = corners @ axis_frame(axis)[:2].T
    return places.min(0), places.max(0)
