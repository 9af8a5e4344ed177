# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the design panel for a prism and its sites (Eq. 2.1): edges, numbers, borders along X, Y, Z."""

from __future__ import annotations

from typing import Dict, Sequence

import FreeCAD
from PySide import QtCore, QtGui

from ..core.parameters import PrismParameters
from .fields import Changed, Field
from .form import field_for
from .language import local_number

translate = FreeCAD.Qt.translate


class PrismSection(QtGui.QWidget):
    """Edges, numbers of sites and border distances of a prism."""

    def __init__(self, changed: Changed) -> None:
        super().__init__()
        self._changed, self._showing = changed, False
        self.fields: Dict[str, Field] = {}
        self._site_widgets: list = []
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        for column, axis in enumerate("XYZ"):
            label = QtGui.QLabel(f"<b>{axis}</b>")
            label.setAlignment(QtCore.Qt.AlignCenter)
            grid.addWidget(label, 0, column + 1)
            grid.setColumnStretch(column + 1, 1)
        rows = (
            (translate("Trabecula", "Edge"), ("l", "w", "h"), 0.5),
            (translate("Trabecula", "Sites"), ("n_x", "n_y", "n_z"), 1.0),
            (translate("Trabecula", "Border"), ("a_x", "a_y", "a_z"), 0.1),
        )
        for row, (label, names, step) in enumerate(rows):
            title = QtGui.QLabel(label)
            grid.addWidget(title, row + 1, 0)
            self._site_widgets += [title] if row else []
            for column, name in enumerate(names):
                field = field_for(PrismParameters, name, self._report, step)
                field.widget.setMinimumWidth(64)
                if not name.startswith("n_"):  # the unit needs the room of the arrows
                    field.widget.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
                self.fields[name] = field
                self._site_widgets += [field.widget] if row else []
                grid.addWidget(field.widget, row + 1, column + 1)

    def _report(self) -> None:
        if not self._showing:
            self._changed()

    def show_sites(self, visible: bool) -> None:
        """Show or hide what belongs to the sites by Eq. 2.1."""
        for widget in self._site_widgets:
            widget.setVisible(visible)

    def set_edges(self, edges: Sequence[float]) -> None:
        """Show other edges (mm), of a box that is there."""
        self._showing = True
        for name, edge in zip("lwh", edges):
            self.fields[name].set_value(edge)
        self._showing = False

    def allow_edges(self, allowed: bool) -> None:
        """Let the edges be changed or not."""
        for name in "lwh":
            self.fields[name].widget.setEnabled(allowed)

    def bare_value(self) -> PrismParameters:
        """Return the edges alone, for sites that are set another way."""
        edges = [self.fields[name].value() for name in "lwh"]
        return PrismParameters(*edges, a_x=0.0, a_y=0.0, a_z=0.0)

    def value(self) -> PrismParameters:
        """Return the parameters.

        Raises
        ------
        ParameterError
            If a value breaks a rule.
        """
        return PrismParameters(**{name: field.value() for name, field in self.fields.items()})

    def set_value(self, prism: PrismParameters) -> None:
        """Show the parameters."""
        self._showing = True
        try:
            for name, field in self.fields.items():
                field.set_value(getattr(prism, name))
        finally:
            self._showing = False


def prism_summary(prism: PrismParameters) -> str:
    """Return one line about the sites of a prism."""
    counts = " × ".join(str(n) for _, _, n, _ in prism.axes)
    borders = sorted({a for _, _, _, a in prism.axes})
    return f"{counts}, a = {'/'.join(map(local_number, borders))} mm"
