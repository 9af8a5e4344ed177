# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layer while it is filled, as Fig. 6.8 of the thesis shows it: cells, and what its columns and rows still need."""

from __future__ import annotations

from typing import Any, List, Optional, Sequence

from PySide import QtCore, QtGui

from ..core.voxels.propagation_steps import Step
from .qt import paper_and_ink
from .voxel_layers import DESIGN, SAMPLE

_FOOT = 20  # pixels of the words below
_LEAST_NUMBER = 13  # pixels of a cell in whose margin a number can be read; smaller ones get bars
_MARGIN, _GAP = 34, 8  # pixels: of the numbers, around the whole
_NEXT = "#3a8ee6"


class PropagationView(QtGui.QWidget):
    """Paints one step: solid cells, the newest in another colour, the line that is solved next in a frame."""

    def __init__(self) -> None:
        super().__init__()
        self.step: Optional[Step] = None
        self._before: Optional[Step] = None
        self._first: Optional[Step] = None
        self._rows_are_solved = True
        self.words = ""
        self.setMinimumSize(320, 300)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Expanding)

    def show_step(self, steps: Sequence[Step], number: int, rows_are_solved: bool) -> None:
        """Show one of the steps of a layer."""
        self._first, self.step = steps[0], steps[number]
        self._before = steps[number - 1] if number else None
        self._rows_are_solved = rows_are_solved
        self.update()

    def show_words(self, words: str) -> None:
        """Show a sentence in place of a layer."""
        self.step, self.words = None, words
        self.update()

    def cell(self) -> float:
        """Return the edge of a cell, pixels."""
        width, height = self.width() - _MARGIN - 2 * _GAP, self.height() - _MARGIN - 2 * _GAP
        return max(min((width - _MARGIN) / self.step.columns, (height - _FOOT) / self.step.rows, 40.0), 1.0)

    def paintEvent(self, event: Any) -> None:
        """Paint the step."""
        paper, ink = paper_and_ink()
        painter = QtGui.QPainter(self)
        painter.fillRect(self.rect(), paper)
        painter.setPen(ink)
        if self.step is None:
            room = self.rect().adjusted(_GAP, 0, -_GAP, 0)
            painter.drawText(room, QtCore.Qt.AlignCenter | QtCore.Qt.TextWordWrap, self.words)
        else:
            self._paint_layer(painter, paper, ink)
        painter.end()

    def _paint_layer(self, painter: Any, paper: Any, ink: Any) -> None:
        step, edge = self.step, self.cell()
        left = (self.width() - _MARGIN - edge * step.columns) / 2 + _MARGIN / 2
        bottom = (self.height() - _FOOT + _MARGIN + edge * step.rows) / 2
        grid = QtGui.QColor(*((3 * p + i) // 4 for p, i in zip(paper.getRgb()[:3], ink.getRgb()[:3])))
        painter.setPen(grid if edge > 4 else QtCore.Qt.NoPen)
        for row in range(step.rows):
            for column in range(step.columns):
                painter.setBrush(self._colour(row, column, paper))
                painter.drawRect(QtCore.QRectF(left + edge * column, bottom - edge * (row + 1), edge, edge))
        self._paint_margins(painter, ink, left, bottom, edge)
        if step.line >= 0:
            painter.setPen(QtGui.QPen(QtGui.QColor(_NEXT), 2.0))
            painter.setBrush(QtCore.Qt.NoBrush)
            painter.drawRect(self._line_place(left, bottom, edge))

    def _colour(self, row: int, column: int, paper: Any) -> Any:
        if not self.step.voxels[row, column]:
            return paper
        is_new = self._before is not None and not self._before.voxels[row, column]
        return QtGui.QColor(SAMPLE if is_new else DESIGN)

    def _line_place(self, left: float, bottom: float, edge: float) -> Any:
        step = self.step
        if self._rows_are_solved:
            return QtCore.QRectF(left, bottom - edge * (step.line + 1), edge * step.columns, edge)
        return QtCore.QRectF(left + edge * step.line, bottom - edge * step.rows, edge, edge * step.rows)

    def _paint_margins(self, painter: Any, ink: Any, left: float, bottom: float, edge: float) -> None:
        """What is still needed beside rows and above columns, as numbers or as bars; v and u at their ends."""
        step = self.step
        top, right = bottom - edge * step.rows, left + edge * step.columns
        columns = [QtCore.QRectF(left + edge * k, top - _MARGIN, edge, _MARGIN - 3) for k in range(step.columns)]
        rows = [QtCore.QRectF(left - _MARGIN, bottom - edge * (k + 1), _MARGIN - 4, edge) for k in range(step.rows)]
        upward = QtCore.Qt.AlignHCenter | QtCore.Qt.AlignBottom
        sideways = QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter
        if edge >= _LEAST_NUMBER:
            _numbers(painter, ink, columns, step.alpha.tolist(), upward)
            _numbers(painter, ink, rows, step.beta.tolist(), sideways)
        else:
            _bars(painter, columns, step.alpha.tolist(), max(int(self._first.alpha.max()), 1), True)
            _bars(painter, rows, step.beta.tolist(), max(int(self._first.beta.max()), 1), False)
        painter.setPen(ink)
        painter.drawText(QtCore.QRectF(right + 4, top - _MARGIN, _MARGIN + 20, _MARGIN - 3),
                         QtCore.Qt.AlignLeft | QtCore.Qt.AlignBottom, f"v = {step.v}")  # fmt: skip
        painter.drawText(QtCore.QRectF(left - _MARGIN - 12, bottom + 1, _MARGIN + 10, 18), sideways, f"u = {step.u}")


def _numbers(painter: Any, ink: Any, places: List[Any], numbers: List[int], where: Any) -> None:
    faint = QtGui.QColor(ink)
    faint.setAlpha(90)
    for place, number in zip(places, numbers):
        painter.setPen(ink if number else faint)
        painter.drawText(place, where, str(number))


def _bars(painter: Any, places: List[Any], numbers: List[int], most: int, upright: bool) -> None:
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(SAMPLE))
    for place, number in zip(places, numbers):
        share = number / most
        if upright:
            place = QtCore.QRectF(place.left(), place.bottom() - share * place.height(), place.width(),
                                  share * place.height())  # fmt: skip
        else:
            place = QtCore.QRectF(place.right() - share * place.width(), place.top(), share * place.width(),
                                  place.height())  # fmt: skip
        painter.drawRect(place)
