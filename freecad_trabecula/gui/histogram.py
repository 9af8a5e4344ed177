# SPDX-License-Identifier: LGPL-2.1-or-later
"""A histogram, painted; it needs no plotting package."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from PySide import QtCore, QtGui

from .language import local_number

_LEFT, _RIGHT, _BOTTOM, _TOP = 30, 24, 34, 6  # pixels around the bars
_FILL, _LINE = "#cfa765", "#7c3a1e"


class Histogram(QtGui.QWidget):
    """Bars of how often values occur.

    Parameters
    ----------
    label : str
        Below the axis.
    """

    def __init__(self, label: str) -> None:
        super().__init__()
        self._label = label
        self._counts, self._edges = np.zeros(0, int), np.zeros(0)
        self.setMinimumHeight(150)

    def set_values(self, values: Sequence[float]) -> None:
        """Show other values."""
        values = np.asarray(values, float)
        bins = int(np.clip(np.sqrt(len(values)), 4, 24)) if len(values) else 1
        self._counts, self._edges = np.histogram(values, bins) if len(values) else (np.zeros(0, int), np.zeros(0))
        self.update()

    def paintEvent(self, event: Any) -> None:
        """Paint bars and axes."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        box = QtCore.QRectF(_LEFT, _TOP, self.width() - _LEFT - _RIGHT, self.height() - _BOTTOM - _TOP)
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        painter.drawLine(box.bottomLeft(), box.bottomRight())
        painter.drawLine(box.bottomLeft(), box.topLeft())
        if len(self._counts):
            self._paint_numbers(painter, box)
            self._paint_bars(painter, box)
        painter.end()

    def _paint_bars(self, painter: Any, box: Any) -> None:
        painter.setPen(QtGui.QColor(_LINE))
        painter.setBrush(QtGui.QColor(_FILL))
        width, most = box.width() / len(self._counts), max(int(self._counts.max()), 1)
        for k, count in enumerate(self._counts.tolist()):
            height = box.height() * count / most
            painter.drawRect(QtCore.QRectF(box.left() + k * width, box.bottom() - height, width, height))

    def _paint_numbers(self, painter: Any, box: Any) -> None:
        right, centre = QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter, QtCore.Qt.AlignCenter
        painter.drawText(QtCore.QRectF(0, box.top() - 4, _LEFT - 4, 14), right, str(int(self._counts.max())))
        painter.drawText(QtCore.QRectF(0, box.bottom() - 10, _LEFT - 4, 14), right, "0")
        for share in (0.0, 0.5, 1.0):
            value = self._edges[0] + share * (self._edges[-1] - self._edges[0])
            x = box.left() + share * box.width()
            painter.drawText(QtCore.QRectF(x - 30, box.bottom() + 2, 60, 14), centre, local_number(value, ".3g"))
        painter.drawText(QtCore.QRectF(box.left(), box.bottom() + 16, box.width(), 16), centre, self._label)
