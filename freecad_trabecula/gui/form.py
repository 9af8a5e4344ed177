# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forms made from the parameter classes: type, unit, limits and tooltip of a field say what widget it gets."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, Dict, Optional, Sequence, Tuple

from PySide import QtCore, QtGui

from ..core.laws import Law
from ..core.parameters import Point
from ..core.records import types_of_fields
from .fields import (
    AutomaticField,
    Changed,
    ChoiceField,
    Field,
    NumberField,
    OptionalPointField,
    PointField,
    SwitchField,
    TextField,
    WholeField,
    row_widget,
)
from .language import description
from .law_field import LawField

_MOST = 2**31 - 1


def _side_by_side(widgets: Sequence[Any]) -> Any:
    row = row_widget()
    for widget in widgets:
        widget.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
        row.layout().addWidget(widget)
    return row


def field_for(cls: type, name: str, changed: Changed, step: float = 0.1) -> Field:
    """Return the input field for a field of a parameter class.

    Parameters
    ----------
    cls : type
        A dataclass of ``core.parameters`` or ``core.job``.
    name : str
    changed : callable
        Called after every change.
    step : float
        What one click on an arrow adds.
    """
    declared = {f.name: f for f in dataclasses.fields(cls)}[name]
    hint, meta = types_of_fields(cls)[name], declared.metadata
    unit, tip = meta["unit"], description(meta["doc"])
    if hint is str:
        return ChoiceField(meta["choices"], changed, tip) if "choices" in meta else TextField(changed, tip)
    if hint is int:
        return WholeField(meta.get("low", 0), meta.get("high", _MOST), changed, tip, "automatic" in meta)
    makers: Dict[Any, Callable[[], Field]] = {
        Law: lambda: LawField(unit, step, changed, tip),
        bool: lambda: SwitchField(changed, tip),
        float: lambda: NumberField(unit, step, changed, tip),
        Point: lambda: PointField(unit, step, changed, tip),
        Optional[Point]: lambda: OptionalPointField(unit, step, changed, tip),
    }
    made = makers[hint]()
    return AutomaticField(made, declared.default, meta["automatic"], changed, tip) if "automatic" in meta else made


class Form(QtGui.QWidget):
    """Fields of one parameter class, one below the other.

    Parameters
    ----------
    cls : type
        The parameter class.
    rows : sequence of (field name, label, step)
        Names joined by a comma stand side by side.
    changed : callable
        Called after every change by the user, not while values are being shown.
    """

    def __init__(self, cls: type, rows: Sequence[Tuple[str, str, float]], changed: Changed) -> None:
        super().__init__()
        self.cls, self._changed, self._showing = cls, changed, False
        self.fields: Dict[str, Field] = {}
        self._labels: Dict[str, Any] = {}
        grid = QtGui.QFormLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        grid.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        for names, label, step in rows:
            made = {name: field_for(cls, name, self.report, step) for name in names.split(",")}
            self.fields.update(made)
            text, widgets = QtGui.QLabel(label), [field.widget for field in made.values()]
            text.setToolTip(widgets[0].toolTip())
            text.setAlignment(QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter)
            self._labels.update(dict.fromkeys(made, text))
            grid.addRow(text, widgets[0] if len(widgets) == 1 else _side_by_side(widgets))

    def report(self) -> None:
        """Tell the owner of a change."""
        if not self._showing:
            self._changed()

    def show_row(self, name: str, visible: bool) -> None:
        """Show or hide a row."""
        self.fields[name].widget.setVisible(visible)
        self._labels[name].setVisible(visible)

    def values(self) -> Dict[str, Any]:
        """Return the values by field name."""
        return {name: field.value() for name, field in self.fields.items()}

    def value(self, **others: Any) -> Any:
        """Return the parameter object; ``others`` are fields that the form does not show.

        Raises
        ------
        ParameterError
            If the class refuses a value.
        """
        return self.cls(**others, **self.values())

    def set_value(self, parameters: Any) -> None:
        """Show a parameter object."""
        self._showing = True
        try:
            for name, field in self.fields.items():
                field.set_value(getattr(parameters, name))
        finally:
            self._showing = False
