# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve of sliced area along one axis that is drawn with the mouse: points are added, dragged and taken away."""

from __future__ import annotations

import math
from typing import Any, Callable, List, Optional, Tuple

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from ..core.voxels.drawn_curves import LEAST_APART, SHAPE, Points, checked_points, curve_values
from ..errors import ParameterError
from .chart import nice_steps
from .language import local_number
from .qt import paper_and_ink
from .voxel_layers import DESIGN, SAMPLE

translate = FreeCAD.Qt.translate
_LEFT, _RIGHT, _TOP, _BOTTOM = 54, 12, 27, 20  # pixels around the axes
_NEAR = 9.0  # pixels from a point within which the mouse takes it
_LEAST_TOP = 0.05  # of the axis of shares


class CurveView(QtGui.QWidget):
    """Shows the curve, and changes it only into curves that can be.

    Parameters
    ----------
    axis : str
        ``x``, ``y`` or ``z``.
    changed : callable
        Called after every change.
    refused : callable
        Takes the sentence that says why a change was not made.
    """

    def __init__(self, axis: str, changed: Callable[[], None], refused: Callable[[str], None]) -> None:
        super().__init__()
        self.axis, self._changed, self._refused = axis, changed, refused
        self.points: Points = SHAPE
        self.profile: Optional[np.ndarray] = None
        self.edge, self.area = 10.0, 0.0  # mm along the axis; mm2 of a layer, 0 shows shares
        self._grabbed = -1
        self._top = 1.0
        self.setMinimumSize(360, 130)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Expanding)
        self.setToolTip(translate("Trabecula", "Click for a new point, drag points, right click takes one away"))
        self.show_points(SHAPE)

    def show_points(self, points: Points, profile: Optional[np.ndarray] = None) -> None:
        """Show other points, and the shares of a profile's layers (N,) behind them."""
        self.points, self.profile = points, profile
        self._fit()

    def show_scale(self, edge: float, area: float) -> None:
        """Show lengths along an edge in mm, and areas of a layer of ``area`` mm²; 0: shares in %."""
        self.edge, self.area = edge, area
        self.update()

    def _fit(self) -> None:
        """Give the axis of shares the room that the curve needs."""
        most = max(share for _, share in self.points)
        if self.profile is not None:
            most = max(most, float(self.profile.max()))
        self._top = min(1.0, max(1.25 * most, _LEAST_TOP))
        self.update()

    # --------------------------------------------------------------------------------------------------- the places

    def box(self) -> Any:
        """Return the rectangle between the axes, pixels."""
        return QtCore.QRectF(_LEFT, _TOP, max(self.width() - _LEFT - _RIGHT, 1),
                             max(self.height() - _TOP - _BOTTOM, 1))  # fmt: skip

    def pixel(self, place: float, share: float) -> Tuple[float, float]:
        """Return where a point is painted."""
        box = self.box()
        return box.left() + place * box.width(), box.bottom() - share / self._top * box.height()

    def value(self, x: float, y: float) -> Tuple[float, float]:
        """Return place and share at a pixel; beyond the axes too."""
        box = self.box()
        return (x - box.left()) / box.width(), (box.bottom() - y) / box.height() * self._top

    def _near(self, x: float, y: float) -> int:
        """Number of the point at a pixel; -1 if there is none."""
        far = [math.dist((x, y), self.pixel(*point)) for point in self.points]
        nearest = int(np.argmin(far))
        return nearest if far[nearest] <= _NEAR else -1

    # ----------------------------------------------------------------------------------------------------- the mouse

    def mousePressEvent(self, event: Any) -> None:
        """Take a point, make one, or take one away."""
        x, y = float(event.pos().x()), float(event.pos().y())
        near = self._near(x, y)
        if event.button() == QtCore.Qt.RightButton:
            if near >= 0:
                self._take([point for k, point in enumerate(self.points) if k != near])
        elif event.button() == QtCore.Qt.LeftButton:
            if near < 0:
                new = self.value(x, y)
                if self._take([*self.points, new]):
                    near = self.points.index(new)
            self._grabbed = near

    def mouseMoveEvent(self, event: Any) -> None:
        """Drag the point that was taken, between its neighbours."""
        if self._grabbed < 0:
            return
        k = self._grabbed
        place, share = self.value(float(event.pos().x()), float(event.pos().y()))
        low = self.points[k - 1][0] + LEAST_APART * 1.5 if k else 0.0
        high = self.points[k + 1][0] - LEAST_APART * 1.5 if k + 1 < len(self.points) else 1.0
        moved = (min(max(place, low), high), share)
        if not self._take([*self.points[:k], moved, *self.points[k + 1 :]]):  # as far as it may go
            edge = (moved[0], min(max(share, 0.0), 1.0))
            self._take([*self.points[:k], edge, *self.points[k + 1 :]], True)

    def mouseReleaseEvent(self, event: Any) -> None:
        """Let the point go."""
        self._grabbed = -1
        self._fit()

    def _take(self, points: List[Tuple[float, float]], quietly: bool = False) -> bool:
        """Take points if they make a curve; say why not otherwise."""
        try:
            self.points = checked_points(points, self.axis)
        except ParameterError as error:
            self._refused(str(error))
            return False
        self.update()
        if not quietly:
            self._changed()
        return True

    # ---------------------------------------------------------------------------------------------------- the picture

    def paintEvent(self, event: Any) -> None:
        """Paint axes, the profile behind, the curve and its points."""
        paper, ink = paper_and_ink()
        painter = QtGui.QPainter(self)
        painter.fillRect(self.rect(), paper)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        self._paint_axes(painter, paper, ink)
        if self.profile is not None:
            faint = QtGui.QColor(SAMPLE)
            faint.setAlpha(130)
            places = (np.arange(len(self.profile)) + 0.5) / len(self.profile)
            self._paint_line(painter, places, self.profile, QtGui.QPen(faint, 1.2))
        places = np.linspace(0, 1, 300)
        self._paint_line(painter, places, curve_values(self.points, places), QtGui.QPen(QtGui.QColor(DESIGN), 2.0))
        painter.setPen(QtGui.QPen(paper, 1.0))
        painter.setBrush(QtGui.QColor(DESIGN))
        for point in self.points:
            painter.drawEllipse(QtCore.QPointF(*self.pixel(*point)), 4.5, 4.5)
        painter.end()

    def _paint_line(self, painter: Any, places: np.ndarray, shares: np.ndarray, pen: Any) -> None:
        painter.setPen(pen)
        painter.setBrush(QtCore.Qt.NoBrush)
        pixels = (self.pixel(float(place), float(share)) for place, share in zip(places, shares))
        painter.drawPolyline(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in pixels]))

    def _paint_axes(self, painter: Any, paper: Any, ink: Any) -> None:
        box, scale = self.box(), self.area or 100.0
        grid = QtGui.QColor(*((7 * p + i) // 8 for p, i in zip(paper.getRgb()[:3], ink.getRgb()[:3])))
        for value in nice_steps(0.0, self._top * scale, 5):
            y = self.pixel(0.0, value / scale)[1]
            painter.setPen(grid)
            painter.drawLine(QtCore.QPointF(box.left(), y), QtCore.QPointF(box.right(), y))
            painter.setPen(ink)
            painter.drawText(QtCore.QRectF(0, y - 8, _LEFT - 5, 16), QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter,
                             local_number(value))  # fmt: skip
        for value in nice_steps(0.0, self.edge):
            x = self.pixel(value / self.edge, 0.0)[0]
            painter.setPen(grid)
            painter.drawLine(QtCore.QPointF(x, box.top()), QtCore.QPointF(x, box.bottom()))
            painter.setPen(ink)
            painter.drawText(QtCore.QRectF(x - 30, box.bottom() + 2, 60, 14), QtCore.Qt.AlignCenter,
                             local_number(value))  # fmt: skip
        unit = "mm²" if self.area else "%"
        words = translate("Trabecula", "sliced area along {}, {}").format(self.axis.upper(), unit)
        painter.drawText(QtCore.QPointF(6, 14), words)
        painter.drawText(QtCore.QRectF(box.right() - 60, 3, 60, 14), QtCore.Qt.AlignRight, "mm →")
        painter.drawLine(box.bottomLeft(), box.bottomRight())
        painter.drawLine(box.bottomLeft(), box.topLeft())
