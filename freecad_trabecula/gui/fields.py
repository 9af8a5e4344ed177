# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input fields: one value each, and the widget that shows it."""

from __future__ import annotations

from typing import Any, Callable, Optional, Sequence, Tuple

import FreeCAD
from PySide import QtGui

from ..core.parameters import Point
from .language import choice
from .qt import quantity_box, set_length, take_both_signs

translate = FreeCAD.Qt.translate
Changed = Callable[[], None]
_WIDE, _NARROW = 88, 60  # pixels: a length needs room for its unit


class Field:
    """One value and the widget that shows it. ``value`` is what ``set_value`` got until the user changes it."""

    def __init__(self, widget: Any, tip: str = "") -> None:
        self.widget = widget
        widget.setToolTip(tip)

    def value(self) -> Any:
        """Return the value."""
        raise NotImplementedError

    def set_value(self, value: Any) -> None:
        """Show a value."""
        raise NotImplementedError


class NumberField(Field):
    """A length with FreeCAD's quantity box, or a pure number."""

    def __init__(self, unit: str, step: float, changed: Changed, tip: str = "") -> None:
        self._is_length = unit == "mm"
        box = quantity_box() if self._is_length else QtGui.QDoubleSpinBox()
        super().__init__(box, tip)
        box.setMinimumWidth(_WIDE if self._is_length else _NARROW)
        box.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
        if self._is_length:
            box.setProperty("singleStep", step)
        else:
            box.setRange(-1e9, 1e9)
            box.setDecimals(3)
            box.setSingleStep(step)
            if unit:
                box.setSuffix(" " + unit)
            take_both_signs(box)
        self._exact: Tuple[Optional[float], float] = (None, 0.0)
        box.valueChanged.connect(lambda *_: changed())

    def _shown(self) -> float:
        return float(self.widget.property("rawValue")) if self._is_length else float(self.widget.value())

    def value(self) -> float:
        """Return the number; a length in mm."""
        exact, shown = self._exact
        # the box rounds what it shows: a third must not become 0.333 because its panel was opened
        return exact if exact is not None and self._shown() == shown else self._shown()

    def set_value(self, value: float) -> None:
        """Show a number; a length in mm."""
        if self._is_length:
            set_length(self.widget, value)
        else:
            self.widget.setValue(float(value))
        self._exact = (float(value), self._shown())


class WholeField(Field):
    """A whole number; the least one may mean that the design finds it."""

    def __init__(self, low: int, high: int, changed: Changed, tip: str = "", is_automatic: bool = False) -> None:
        box = QtGui.QSpinBox()
        super().__init__(box, tip)
        box.setRange(low, high)
        if is_automatic:
            box.setSpecialValueText(translate("Trabecula", "automatic"))
        box.setMinimumWidth(_NARROW)
        box.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
        box.valueChanged.connect(lambda *_: changed())

    def value(self) -> int:
        """Return the number."""
        return int(self.widget.value())

    def set_value(self, value: int) -> None:
        """Show a number."""
        self.widget.setValue(int(value))


class ChoiceField(Field):
    """One of several words."""

    def __init__(self, choices: Sequence[str], changed: Changed, tip: str = "") -> None:
        box = QtGui.QComboBox()
        super().__init__(box, tip)
        offer_words(choices, box)
        box.currentIndexChanged.connect(lambda *_: changed())

    def set_choices(self, choices: Sequence[str]) -> None:
        """Offer other words."""
        self.widget.blockSignals(True)
        self.widget.clear()
        offer_words(choices, self.widget)
        self.widget.blockSignals(False)

    def value(self) -> str:
        """Return the word."""
        return str(self.widget.currentData() or "")

    def set_value(self, value: str) -> None:
        """Choose a word; one that is not among the choices is added, so that no file's value is lost."""
        if self.widget.findData(value) < 0:
            offer_words([value], self.widget)
        self.widget.setCurrentIndex(self.widget.findData(value))


class SwitchField(Field):
    """On or off."""

    def __init__(self, changed: Changed, tip: str = "", text: str = "") -> None:
        super().__init__(QtGui.QCheckBox(text), tip)
        self.widget.toggled.connect(lambda *_: changed())

    def value(self) -> bool:
        """Return whether it is on."""
        return bool(self.widget.isChecked())

    def set_value(self, value: bool) -> None:
        """Switch on or off."""
        self.widget.setChecked(bool(value))


class TextField(Field):
    """A short text."""

    def __init__(self, changed: Changed, tip: str = "") -> None:
        super().__init__(QtGui.QLineEdit(), tip)
        self.widget.textChanged.connect(lambda *_: changed())

    def value(self) -> str:
        """Return the text without surrounding blanks."""
        return str(self.widget.text()).strip()

    def set_value(self, value: str) -> None:
        """Show a text."""
        self.widget.setText(value)


class PointField(Field):
    """Three numbers side by side."""

    def __init__(self, unit: str, step: float, changed: Changed, tip: str = "") -> None:
        super().__init__(row_widget(), tip)
        self.parts = [NumberField(unit, step, changed, f"{axis}: {tip}") for axis in "XYZ"]
        for part in self.parts:
            part.widget.setMinimumWidth(_NARROW)
            part.widget.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            self.widget.layout().addWidget(part.widget)

    def value(self) -> Point:
        """Return the three numbers."""
        return tuple(part.value() for part in self.parts)

    def set_value(self, value: Point) -> None:
        """Show three numbers."""
        for part, number in zip(self.parts, value):
            part.set_value(number)


class OptionalPointField(Field):
    """Three numbers that count only when their switch is on."""

    def __init__(self, unit: str, step: float, changed: Changed, tip: str = "") -> None:
        super().__init__(row_widget(), tip)
        self.point = PointField(unit, step, changed, tip)
        self.switch = SwitchField(changed, tip)
        self.switch.widget.toggled.connect(self.point.widget.setEnabled)
        self.point.widget.setEnabled(False)
        self.widget.layout().addWidget(self.switch.widget)
        self.widget.layout().addWidget(self.point.widget, 1)

    def value(self) -> Optional[Point]:
        """Return the three numbers, or None."""
        return self.point.value() if self.switch.value() else None

    def set_value(self, value: Optional[Point]) -> None:
        """Show three numbers, or none."""
        self.switch.set_value(value is not None)
        if value is not None:
            self.point.set_value(value)


class AutomaticField(Field):
    """A value that is found by the design unless its switch is off.

    Parameters
    ----------
    field : Field
        Of the value itself.
    automatic : value
        What stands for "found by the design" in the parameters.
    start : value
        Shown first when the switch is put off.
    """

    def __init__(self, field: Field, automatic: Any, start: Any, changed: Changed, tip: str = "") -> None:
        super().__init__(row_widget(), tip)
        self.field, self._automatic, self._start, self._has_own = field, automatic, start, False
        self.switch = SwitchField(lambda: None, tip, translate("Trabecula", "automatic"))
        self.switch.set_value(True)
        self.switch.widget.toggled.connect(self._show)
        self.switch.widget.toggled.connect(lambda *_: changed())
        field.widget.setVisible(False)
        self.widget.layout().addWidget(self.switch.widget)
        self.widget.layout().addWidget(field.widget, 1)

    def _show(self, is_automatic: bool) -> None:
        self.field.widget.setVisible(not is_automatic)
        if not is_automatic and not self._has_own:
            self._has_own = True
            self.field.set_value(self._start)

    def value(self) -> Any:
        """Return the value; that which stands for "found by the design" if it is automatic."""
        return self._automatic if self.switch.value() else self.field.value()

    def set_value(self, value: Any) -> None:
        """Show a value."""
        if value != self._automatic:
            self._has_own = True
            self.field.set_value(value)
        self.switch.set_value(value == self._automatic)


def offer_words(words: Sequence[str], box: Any) -> None:
    """Add words to a combo box: shown in the language of the window, kept as they are."""
    for word in words:
        box.addItem(choice(word), word)


def row_widget() -> Any:
    """Return a widget that lays its children in a row without margins."""
    widget = QtGui.QWidget()
    layout = QtGui.QHBoxLayout(widget)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(4)
    return widget
