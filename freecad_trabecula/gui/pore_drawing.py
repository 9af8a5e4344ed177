# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing of one pore: its square, its corners and its curve."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from PySide import QtCore, QtGui

from ..core.parameters import PoreParameters
from ..core.pores import bezier_poles, circles, make_pores

_POINTS = 16  # of each piece of the curve
_FILL, _LINE, _CORNER = "#cfa765", "#7c3a1e", "#3f8fd0"


class PoreDrawing(QtGui.QWidget):
    """The pore seen from outside the envelope."""

    def __init__(self) -> None:
        super().__init__()
        self._curve, self._corners, self._size = np.zeros((0, 2)), np.zeros((0, 2)), 1.0
        self.setFixedHeight(150)

    def set_pore(self, parameters: PoreParameters, size: float, turns: Sequence[float]) -> None:
        """Show the pore of a size (mm) with tangent components; values that no pore can have change nothing."""
        turns = np.array([turns], float)
        is_circle = parameters.layout == "circle"
        is_whole = is_circle or turns.shape[1] == parameters.corners
        if not (is_whole and np.isfinite(size) and size > 0 and ((turns >= 0) & (turns <= 1)).all()):
            return
        sizes = np.array([size])
        if is_circle:
            pore = circles(sizes)
        else:
            shape = turns.shape
            pore = make_pores(parameters, sizes, turns, np.ones(shape), np.zeros((*shape, 2)))
        poles = bezier_poles(pore)[0]
        t = np.linspace(0, 1, _POINTS, endpoint=False)[:, None]
        weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3)
        self._curve = np.concatenate([sum(w * p for w, p in zip(weights, piece)) for piece in poles])
        self._corners, self._size = pore.corners[0] * size, size
        self.update()

    def paintEvent(self, event: Any) -> None:
        """Paint square, curve, corners."""
        if not len(self._curve):
            return
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        reach = np.abs(self._curve).max() * 1.15
        scale = min(self.width(), self.height()) / 2 / reach
        middle = np.array([self.width() / 2, self.height() / 2])

        def polygon(points: np.ndarray) -> Any:
            placed = middle + points * [scale, -scale]
            return QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in placed.tolist()])

        painter.setPen(QtGui.QPen(QtGui.QColor(_LINE), 2))
        painter.setBrush(QtGui.QColor(_FILL))
        painter.drawPolygon(polygon(self._curve))
        painter.setBrush(QtCore.Qt.NoBrush)
        painter.setPen(QtGui.QPen(QtGui.QColor(_CORNER), 1, QtCore.Qt.DashLine))
        painter.drawPolygon(polygon(self._corners))
        painter.setBrush(QtGui.QColor(_CORNER))
        for point in polygon(self._corners):
            painter.drawEllipse(point, 3, 3)
        painter.end()
