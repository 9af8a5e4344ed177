# SPDX-License-Identifier: LGPL-2.1-or-later
"""Minimum zeros propagation watched step by step (thesis Fig. 6.8 to 6.11): of a design's layer, or of own numbers."""

from __future__ import annotations

import re
from typing import Any, List, Optional, Sequence

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from .. import make
from ..core.voxels.layer_fill import ORDERS
from ..core.voxels.parameters import DIRECTIONS
from ..core.voxels.propagation_steps import Step, propagation_steps
from ..errors import ParameterError, TrabeculaError
from .fields import row_widget
from .language import in_words
from .propagation_view import PropagationView
from .qt import small_button, word_colour

translate = FreeCAD.Qt.translate
#: Shown when there is no design: six columns and six rows that go together.
_ALPHA, _BETA = (4, 2, 3, 1, 5, 3), (3, 5, 2, 4, 1, 3)
_WAIT = 700  # milliseconds between steps while they run
_ALL = 10**9  # steps
_TRUE, _FALSE = "#c62828", "#2e7d32"  # a condition that holds ends the design


class PropagationDialog(QtGui.QDialog):
    """Alpha and beta of one layer, and the steps in which it is filled.

    Parameters
    ----------
    parent : widget
    obj : document object or None
        A voxel design whose layers can be chosen.
    """

    def __init__(self, parent: Any, obj: Any = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(translate("Trabecula", "Watch a layer being filled"))
        self.design = make.voxel_design_of(obj) if obj is not None else None
        self.steps: List[Step] = []
        self.buttons: List[Any] = []
        self.layer, self.alpha, self.beta = QtGui.QSpinBox(), QtGui.QLineEdit(), QtGui.QLineEdit()
        self.direction, self.order = QtGui.QComboBox(), QtGui.QComboBox()
        self.view, self.slider = PropagationView(), QtGui.QSlider(QtCore.Qt.Horizontal)
        self.words, self.conditions = QtGui.QLabel(), [QtGui.QLabel(), QtGui.QLabel()]
        self.timer = QtCore.QTimer(self)
        self.timer.timeout.connect(lambda: self.go(1))
        self.direction.addItem(translate("Trabecula", "rows, v stays smallest"), DIRECTIONS[1])
        self.direction.addItem(translate("Trabecula", "columns, u stays smallest"), DIRECTIONS[0])
        self.order.addItem(translate("Trabecula", "the shortest first"), ORDERS[0])
        self.order.addItem(translate("Trabecula", "as they stand"), ORDERS[1])
        self._lay_out()
        self.layer.setRange(0, len(self.design.voxels) - 1 if self.design is not None else 0)
        self.layer.setEnabled(self.design is not None)
        self.layer.valueChanged.connect(lambda *_: self._take_layer())
        for box in (self.direction, self.order):
            box.currentIndexChanged.connect(lambda *_: self.refresh())
        for line in (self.alpha, self.beta):
            line.textEdited.connect(lambda *_: self.refresh())
        self.slider.valueChanged.connect(lambda *_: self._show_step())
        self.layer.setValue(self.layer.maximum() // 2)
        self._take_layer()

    def _lay_out(self) -> None:
        self.alpha.setToolTip(translate("Trabecula", "Voxels asked for in each column, from the left"))
        self.beta.setToolTip(translate("Trabecula", "Voxels asked for in each row, from the lowest"))
        top = QtGui.QFormLayout()
        choices = row_widget()
        for words, widget in (
            (translate("Trabecula", "Layer along Z"), self.layer),
            (translate("Trabecula", "Lines solved"), self.direction),
            (translate("Trabecula", "Order"), self.order),
        ):
            choices.layout().addWidget(QtGui.QLabel(words))
            choices.layout().addWidget(widget, 1)
        top.addRow(choices)
        top.addRow(translate("Trabecula", "alpha, columns"), self.alpha)
        top.addRow(translate("Trabecula", "beta, rows"), self.beta)
        bar = row_widget()
        style = QtGui.QStyle
        for kind, tip, step in (
            (style.SP_MediaSkipBackward, translate("Trabecula", "To the empty layer"), -_ALL),
            (style.SP_MediaSeekBackward, translate("Trabecula", "One step back"), -1),
            (style.SP_MediaPlay, translate("Trabecula", "Run on, or stop"), 0),
            (style.SP_MediaSeekForward, translate("Trabecula", "One step on"), 1),
            (style.SP_MediaSkipForward, translate("Trabecula", "To the last step"), _ALL),
        ):
            pressed = self.play if not step else (lambda *_, step=step: self.go(step))
            button = small_button("", tip, pressed, " ", not step)
            button.setText("")
            button.setIcon(self.style().standardIcon(kind))
            bar.layout().addWidget(button)
            self.buttons.append(button)
        self.play_button = self.buttons[2]
        bar.layout().addWidget(self.slider, 1)
        column = QtGui.QVBoxLayout(self)
        column.addLayout(top)
        column.addWidget(self.view, 1)
        for label in (*self.conditions, self.words):
            label.setWordWrap(True)
            column.addWidget(label)
        column.addWidget(bar)
        self.resize(560, 680)

    # -------------------------------------------------------------------------------------------------- what is shown

    def _take_layer(self) -> None:
        """Show alpha and beta of the chosen layer."""
        k = self.layer.value()
        alpha = _ALPHA if self.design is None else self.design.alpha[:, k].tolist()
        beta = _BETA if self.design is None else self.design.beta[:, k].tolist()
        for line, numbers in ((self.alpha, alpha), (self.beta, beta)):
            line.setText(" ".join(str(number) for number in numbers))
            line.setCursorPosition(0)
        self.refresh()

    def refresh(self) -> None:
        """Work out the steps anew and show the first."""
        self.timer.stop()
        self.play_button.setChecked(False)
        try:
            direction, order = self.direction.currentData(), self.order.currentData()
            self.steps = propagation_steps(_whole_numbers(self.alpha), _whole_numbers(self.beta), direction, order)
        except TrabeculaError as error:
            self.steps = []
            self.view.show_words(in_words(str(error)))
        self.slider.setEnabled(bool(self.steps))
        self.slider.blockSignals(True)
        self.slider.setRange(0, max(len(self.steps) - 1, 0))
        self.slider.setValue(0)
        self.slider.blockSignals(False)
        self._show_step()

    def go(self, count: int) -> None:
        """Go on or back by some steps."""
        self.slider.setValue(min(max(self.slider.value() + count, 0), self.slider.maximum()))
        if self.slider.value() == self.slider.maximum():
            self.play_button.setChecked(False)

    def play(self, on: bool) -> None:
        """Let the steps run, or stop them."""
        kind = QtGui.QStyle.SP_MediaPause if on else QtGui.QStyle.SP_MediaPlay
        self.play_button.setIcon(self.style().standardIcon(kind))
        if on and self.steps:
            if self.slider.value() == self.slider.maximum():
                self.slider.setValue(0)
            self.timer.start(max(_WAIT * 8 // max(len(self.steps), 8), 30))
        else:
            self.timer.stop()

    def _show_step(self) -> None:
        for label in (*self.conditions, self.words):
            label.setVisible(bool(self.steps))
        if not self.steps:
            return
        number = self.slider.value()
        step, rows_are_solved = self.steps[number], self.direction.currentData() == "rows"
        self.view.show_step(self.steps, number, rows_are_solved)
        for label, words, holds in zip(self.conditions, _conditions(step), (step.condition_6_21, step.condition_6_22)):
            answer = translate("Trabecula", "true") if holds else translate("Trabecula", "false")
            label.setText(f'{words}: <b style="color:{word_colour(_TRUE if holds else _FALSE)}">{answer}</b>')
        self.words.setText(self._told(step, number, rows_are_solved))

    def _told(self, step: Step, number: int, rows_are_solved: bool) -> str:
        where = translate("Trabecula", "Step {} of {}").format(number, len(self.steps) - 1)
        if step.is_impossible:
            return translate("Trabecula", "{}: no design with these numbers any more").format(where)
        if step.line < 0:
            return translate("Trabecula", "{}: the layer is filled").format(where)
        need = int((step.beta if rows_are_solved else step.alpha)[step.line])
        if rows_are_solved:
            words = translate("Trabecula", "{}: next row {}, {} voxels into the columns that need most")
        else:
            words = translate("Trabecula", "{}: next column {}, {} voxels into the rows that need most")
        return words.format(where, step.line, need)

    def closeEvent(self, event: Any) -> None:
        """Stop what runs."""
        self.timer.stop()
        super().closeEvent(event)


def _conditions(step: Step) -> Sequence[str]:
    """The conditions (6.21) and (6.22) with their values."""
    return (
        f"(6.21)  max beta {int(step.beta.max())} &gt; N − v = {step.columns} − {step.v} = {step.columns - step.v}",
        f"(6.22)  max alpha {int(step.alpha.max())} &gt; M − u = {step.rows} − {step.u} = {step.rows - step.u}",
    )


def _whole_numbers(line: Any) -> np.ndarray:
    words = [word for word in re.split(r"[\s,;]+", str(line.text())) if word]
    if not words or not all(re.fullmatch(r"\d{1,9}", word) for word in words):
        raise ParameterError(f"alpha and beta must be whole numbers with blanks between, got {line.text()!r}")
    return np.array([int(word) for word in words])


_open: List[PropagationDialog] = []  # shown beside the window until it is closed


def watch_layer(obj: Optional[Any] = None) -> PropagationDialog:
    """Open the dialog on a voxel design; without one on numbers to be typed.

    Raises
    ------
    TrabeculaError
        If the design is not there yet.
    """
    dialog = PropagationDialog(FreeCADGui.getMainWindow(), obj)
    for other in _open:
        other.close()
    _open[:] = [dialog]
    dialog.show()
    return dialog
