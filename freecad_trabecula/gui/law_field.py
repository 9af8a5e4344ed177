# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field for a law of variation: its kind, its two bounds, and a direction or a formula where the kind has one."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from ..core.laws import KINDS, Law
from .fields import Changed, ChoiceField, Field, NumberField, PointField, TextField, row_widget

translate = FreeCAD.Qt.translate


class LawField(Field):
    """A law: constant, at random between two bounds, or by place."""

    def __init__(self, unit: str, step: float, changed: Changed, tip: str = "") -> None:
        super().__init__(QtGui.QWidget(), tip)
        self.kind = ChoiceField(KINDS, self._kind_changed, tip)
        self.low = NumberField(unit, step, changed, translate("Trabecula", "Constant value, or least; at the start"))
        self.high = NumberField(unit, step, changed, translate("Trabecula", "Greatest value; at the end"))
        self.direction = PointField("", 1.0, changed, translate("Trabecula", "Direction in which the value grows"))
        self.expression = TextField(changed, translate("Trabecula", "Formula of x, y, z (mm) and a random u in 0..1"))
        self.expression.widget.setPlaceholderText("0.2 + 0.05 * z + 0.1 * u")
        self._changed = changed
        self._lay_out()
        self._show_parts()

    def _lay_out(self) -> None:
        first = row_widget()
        for field, stretch, width in ((self.kind, 0, 80), (self.low, 1, 72), (self.high, 1, 72)):
            field.widget.setMinimumWidth(width)
            if field is not self.kind:
                field.widget.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            first.layout().addWidget(field.widget, stretch)
        first.layout().setSpacing(2)
        column = QtGui.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        for widget in (first, self.direction.widget, self.expression.widget):
            column.addWidget(widget)

    def _kind_changed(self) -> None:
        self._show_parts()
        self._changed()

    def _show_parts(self) -> None:
        kind = self.kind.value()
        self.high.widget.setVisible(kind != "constant")
        self.direction.widget.setVisible(kind == "linear")
        self.expression.widget.setVisible(kind == "expression")

    def value(self) -> Law:
        """Return the law.

        Raises
        ------
        ParameterError
            If its bounds, direction or formula break a rule.
        """
        kind, low = self.kind.value(), self.low.value()
        high = low if kind == "constant" else self.high.value()
        return Law(kind, low, high, self.direction.value(), self.expression.value())

    def set_value(self, value: Any) -> None:
        """Show a law."""
        self.kind.set_value(value.kind)
        self.low.set_value(value.low)
        self.high.set_value(value.high)
        self.direction.set_value(value.direction)
        self.expression.set_value(value.expression)
        self._show_parts()
