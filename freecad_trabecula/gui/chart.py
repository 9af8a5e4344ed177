# SPDX-License-Identifier: LGPL-2.1-or-later
"""Diagrams of curves, marks and counts, painted in the colours of the window; a cursor follows the mouse.

What is published is drawn by ``core.analysis.plots``; this one is for looking: it needs no plotting package, is painted
in a few milliseconds, and tells where the mouse is.
"""

from __future__ import annotations

import math
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from PySide import QtCore, QtGui

from ..core.axis_range import shown_range
from ..core.colours import scale_colours
from .language import local_number
from .qt import paper_and_ink

_LEFT, _RIGHT, _TOP, _BOTTOM = 58, 12, 22, 34  # pixels around the axes
_TICKS = 6  # about so many along an axis
_CURSOR = "#3a8ee6"  # stands out on light and on dark


class Curve(NamedTuple):
    """Points (N,) joined by a line, or marked one by one (``marks``); ``faint`` ones stand back."""

    label: str
    x: np.ndarray
    y: np.ndarray
    colour: str
    marks: bool = False
    faint: bool = False


class Counts(NamedTuple):
    """A heat map: how much there is between borders x (M + 1,) and y (N + 1,), counts (M, N)."""

    x: np.ndarray
    y: np.ndarray
    counts: np.ndarray


class Diagram(NamedTuple):
    """What a chart shows; ``size`` is that of what was compared, where y are differences."""

    x_label: str
    y_label: str
    curves: Sequence[Curve] = ()
    counts: Optional[Counts] = None
    is_log: bool = False
    size: float = 0.0


class Axis(NamedTuple):
    """An axis from ``low`` to ``high``, of the logarithms if ``is_log``."""

    low: float
    high: float
    is_log: bool = False

    def share(self, values: Any) -> np.ndarray:
        """Return where values lie, 0 at the low end, 1 at the high one."""
        values = np.asarray(values, float)
        if self.is_log:
            with np.errstate(divide="ignore", invalid="ignore"):
                values = np.log10(values)
        return (values - self.low) / (self.high - self.low)

    def ticks(self) -> List[Tuple[float, str]]:
        """Return shares and texts of the ticks."""
        if self.is_log:
            whole = range(math.ceil(self.low - 1e-9), math.floor(self.high + 1e-9) + 1)
            return [((k - self.low) / (self.high - self.low), local_number(10.0**k)) for k in whole]
        steps = nice_steps(self.low, self.high)
        return [((value - self.low) / (self.high - self.low), local_number(value)) for value in steps]


def nice_steps(low: float, high: float, count: int = _TICKS) -> List[float]:
    """Return about ``count`` round numbers from ``low`` to ``high``.

    Examples
    --------
    >>> nice_steps(0.0, 10.3)
    [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]
    """
    raw = (high - low) / max(count - 1, 1)
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= raw * 0.999)
    digits = max(0, 2 - math.floor(math.log10(step)))
    first = math.ceil(low / step - 1e-9)
    return [round(k * step, digits) + 0.0 for k in range(first, math.floor(high / step + 1e-9) + 1)]


def axes_of(diagram: Diagram) -> Tuple[Axis, Axis]:
    """Return the axes that hold all of a diagram, each at least a little long."""
    x = [curve.x for curve in diagram.curves] + ([diagram.counts.x] if diagram.counts else [])
    y = [curve.y for curve in diagram.curves] + ([diagram.counts.y] if diagram.counts else [])
    return _axis(x, False, 0.0), _axis(y, diagram.is_log, 0.0 if diagram.counts else 0.06, diagram.size)


def _axis(columns: Sequence[np.ndarray], is_log: bool, margin: float, size: float = 0.0) -> Axis:
    values = np.concatenate([np.zeros(0), *(np.asarray(c, float).ravel() for c in columns)])
    values = values[np.isfinite(values) & ((values > 0) | (not is_log))]
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.1, 1.0)
    if is_log:
        low, high = math.log10(low), math.log10(high)
    low, high = shown_range(low, high, size)
    room = margin * (high - low)
    return Axis(low - room, high + room, is_log)


class Chart(QtGui.QWidget):
    """Shows one diagram; painted once, the cursor over it."""

    #: Where the mouse is along x.
    pointed = QtCore.Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self.diagram = Diagram("", "")
        self._axes = axes_of(self.diagram)
        self._picture: Any = None
        self._cursor: Optional[float] = None
        self.setMouseTracking(True)
        self.setMinimumSize(260, 170)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Expanding)

    def show_diagram(self, diagram: Diagram) -> None:
        """Show a diagram in place of the one before."""
        self.diagram, self._axes, self._picture = diagram, axes_of(diagram), None
        self.update()

    def set_cursor(self, x: Optional[float]) -> None:
        """Move the cursor; None hides it."""
        self._cursor = x
        self.update()

    def box(self) -> Any:
        """Return the rectangle between the axes, pixels."""
        width, height = self.width() - _LEFT - _RIGHT, self.height() - _TOP - _BOTTOM
        return QtCore.QRectF(_LEFT, _TOP, max(width, 1), max(height, 1))

    def mouseMoveEvent(self, event: Any) -> None:
        """Tell where the mouse is."""
        box, place = self.box(), event.pos()
        if box.left() <= place.x() <= box.right() and self.diagram.x_label:
            share = (place.x() - box.left()) / box.width()
            axis = self._axes[0]
            self.pointed.emit(axis.low + share * (axis.high - axis.low))

    def resizeEvent(self, event: Any) -> None:
        """Paint anew at the next occasion."""
        self._picture = None

    def changeEvent(self, event: Any) -> None:
        """Paint anew when the theme changes."""
        self._picture = None
        super().changeEvent(event)

    def paintEvent(self, event: Any) -> None:
        """Paint the diagram, from the picture if there is one, and the cursor."""
        if self._picture is None:
            self._picture = QtGui.QPixmap(self.size())
            self._picture.fill(paper_and_ink()[0])
            painter = QtGui.QPainter(self._picture)
            painter.setFont(self.font())
            self._paint(painter)
            painter.end()
        painter = QtGui.QPainter(self)
        painter.drawPixmap(0, 0, self._picture)
        if self._cursor is not None and self.diagram.x_label:
            box, share = self.box(), float(self._axes[0].share(self._cursor))
            if 0 <= share <= 1:
                painter.setPen(QtGui.QPen(QtGui.QColor(_CURSOR), 1.5))
                x = box.left() + share * box.width()
                painter.drawLine(QtCore.QPointF(x, box.top()), QtCore.QPointF(x, box.bottom()))
        painter.end()

    # -------------------------------------------------------------------------------------------------- the picture

    def _paint(self, painter: Any) -> None:
        if not self.diagram.x_label:
            return
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        box = self.box()
        self._paint_axes(painter, box)
        painter.setClipRect(box)
        if self.diagram.counts is not None:
            self._paint_counts(painter, box)
        for curve in self.diagram.curves:
            self._paint_curve(painter, box, curve)
        painter.setClipping(False)
        self._paint_legend(painter, box)

    def _paint_axes(self, painter: Any, box: Any) -> None:
        paper, ink = paper_and_ink()
        grid = QtGui.QColor(*((7 * p + i) // 8 for p, i in zip(paper.getRgb()[:3], ink.getRgb()[:3])))
        centre, right = QtCore.Qt.AlignCenter, QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter
        for share, text in self._axes[0].ticks():
            x = box.left() + share * box.width()
            painter.setPen(grid)
            painter.drawLine(QtCore.QPointF(x, box.top()), QtCore.QPointF(x, box.bottom()))
            painter.setPen(ink)
            painter.drawText(QtCore.QRectF(x - 30, box.bottom() + 2, 60, 14), centre, text)
        for share, text in self._axes[1].ticks():
            y = box.bottom() - share * box.height()
            painter.setPen(grid)
            painter.drawLine(QtCore.QPointF(box.left(), y), QtCore.QPointF(box.right(), y))
            painter.setPen(ink)
            painter.drawText(QtCore.QRectF(0, y - 8, _LEFT - 5, 16), right, text)
        painter.setPen(ink)
        painter.drawLine(box.bottomLeft(), box.bottomRight())
        painter.drawLine(box.bottomLeft(), box.topLeft())
        painter.drawText(QtCore.QRectF(box.left(), box.bottom() + 17, box.width(), 16), centre, self.diagram.x_label)
        painter.drawText(QtCore.QPointF(6, 14), self.diagram.y_label)

    def _places(self, box: Any, x: Any, y: Any) -> np.ndarray:
        """Pixels (N, 2); nan where there is nothing."""
        across, up = self._axes[0].share(x), self._axes[1].share(y)
        return np.stack([box.left() + across * box.width(), box.bottom() - up * box.height()], 1)

    def _paint_curve(self, painter: Any, box: Any, curve: Curve) -> None:
        colour = QtGui.QColor(curve.colour)
        if curve.faint:
            colour.setAlpha(110)
        places = self._places(box, curve.x, curve.y)
        good = np.isfinite(places).all(1)
        if curve.marks or good.sum() == 1:
            painter.setPen(QtCore.Qt.NoPen)
            painter.setBrush(colour)
            for x, y in places[good].tolist():
                painter.drawEllipse(QtCore.QPointF(x, y), 1.6, 1.6)
            return
        painter.setPen(QtGui.QPen(colour, 1.2 if curve.faint else 1.8))
        painter.setBrush(QtCore.Qt.NoBrush)
        breaks = np.flatnonzero(np.diff(good.astype(int), prepend=0, append=0))
        for first, last in breaks.reshape(-1, 2).tolist():
            painter.drawPolyline(QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in places[first:last].tolist()]))

    def _paint_counts(self, painter: Any, box: Any) -> None:
        counts = self.diagram.counts
        across = box.left() + self._axes[0].share(counts.x) * box.width()
        up = box.bottom() - self._axes[1].share(counts.y) * box.height()
        most = math.log(max(float(counts.counts.max()), 2.0))
        painter.setRenderHint(QtGui.QPainter.Antialiasing, False)
        for i, j in zip(*np.nonzero(counts.counts)):
            share = math.log(float(counts.counts[i, j])) / most
            colour = scale_colours(share).tolist()
            place = QtCore.QRectF(across[i], up[j + 1], across[i + 1] - across[i] + 0.6, up[j] - up[j + 1] + 0.6)
            painter.fillRect(place, QtGui.QColor(*colour))
        painter.setRenderHint(QtGui.QPainter.Antialiasing)

    def _paint_legend(self, painter: Any, box: Any) -> None:
        """Names of the curves above the axes, from the right, as many as have room."""
        ink, x = paper_and_ink()[1], box.right()
        least = painter.fontMetrics().boundingRect(self.diagram.y_label).width() + 16
        for curve in reversed([one for one in self.diagram.curves if one.label]):
            width = painter.fontMetrics().boundingRect(curve.label).width()
            if x - width - 26 < least:
                break
            painter.setPen(ink)
            painter.drawText(QtCore.QPointF(x - width, 14), curve.label)
            painter.setPen(QtGui.QPen(QtGui.QColor(curve.colour), 3))
            painter.drawLine(QtCore.QPointF(x - width - 20, 10), QtCore.QPointF(x - width - 5, 10))
            x -= width + 32
