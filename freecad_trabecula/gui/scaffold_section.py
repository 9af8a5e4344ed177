# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of the design panel for what is made of the wireframe: surface of the rods, engine, layers."""

from __future__ import annotations

from dataclasses import replace
from typing import Sequence, Tuple

import FreeCAD
from PySide import QtCore, QtGui

from ..core.parameters import LayerParameters, RodParameters, ScaffoldParameters
from .fields import Changed
from .form import Form
from .language import choice, local_number

translate = FreeCAD.Qt.translate


class ScaffoldSection(QtGui.QWidget):
    """Engine, loose pieces, compact layers."""

    def __init__(self, changed: Changed) -> None:
        super().__init__()
        self._changed = changed
        self.scaffold = Form(
            ScaffoldParameters,
            (
                ("engine", translate("Trabecula", "Engine"), 1.0),
                ("cell", translate("Trabecula", "Cell"), 0.01),
                ("seconds", translate("Trabecula", "Time budget"), 60.0),
                ("memory_gb", translate("Trabecula", "Memory budget"), 1.0),
                ("keep_loose", translate("Trabecula", "Keep loose pieces"), 1.0),
            ),
            self._scaffold_changed,
        )
        self.layers = LayersForm(changed)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.scaffold)
        column.addWidget(QtGui.QLabel(f"<b>{translate('Trabecula', 'Compact layers')}</b>"))
        column.addWidget(self.layers)

    def _scaffold_changed(self) -> None:
        self._show_rows()
        self._changed()

    def _show_rows(self) -> None:
        engine = self.scaffold.fields["engine"].value()
        self.scaffold.show_row("cell", engine in ("auto", "field"))
        for name in ("seconds", "memory_gb"):
            self.scaffold.show_row(name, engine == "brep")

    def value(self) -> ScaffoldParameters:
        """Return the parameters.

        Raises
        ------
        ParameterError
            If a value breaks a rule.
        """
        return self.scaffold.value(layers=self.layers.value())

    def set_value(self, scaffold: ScaffoldParameters) -> None:
        """Show the parameters."""
        self.scaffold.set_value(scaffold)
        self.layers.set_value(scaffold.layers)
        self._show_rows()

    def set_faces(self, faces: Sequence[str]) -> None:
        """Offer faces for compact layers."""
        self.layers.set_faces(faces)


class LayersForm(QtGui.QWidget):
    """Compact layers: which faces, how thick, where."""

    def __init__(self, changed: Changed) -> None:
        super().__init__()
        self._changed = changed
        self.faces = QtGui.QListWidget()
        self.faces.setFlow(QtGui.QListView.LeftToRight)
        self.faces.setWrapping(True)
        self.faces.setResizeMode(QtGui.QListView.Adjust)
        self.faces.setMaximumHeight(48)
        self.faces.setToolTip(translate("Trabecula", "Tick the faces that get a compact layer"))
        self.faces.itemChanged.connect(lambda *_: self._ticked())
        rows = (
            ("thickness", translate("Trabecula", "Thickness"), 0.1),
            ("side", translate("Trabecula", "Side"), 1.0),
            ("closed", translate("Trabecula", "Closes channels"), 1.0),
        )
        self.form = Form(LayerParameters, rows, changed)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.faces)
        column.addWidget(self.form)

    def _ticked(self) -> None:
        self.form.setVisible(bool(self.chosen()))
        self._changed()

    def chosen(self) -> Tuple[str, ...]:
        """Return the ticked faces."""
        items = [self.faces.item(k) for k in range(self.faces.count())]
        return tuple(str(item.text()) for item in items if item.checkState() == QtCore.Qt.Checked)

    def value(self) -> LayerParameters:
        """Return the parameters."""
        return self.form.value(faces=self.chosen())

    def set_value(self, layers: LayerParameters) -> None:
        """Show the parameters."""
        self.form.set_value(replace(layers))
        self._show(sorted({*self._names(), *layers.faces}, key=_natural), layers.faces)

    def set_faces(self, faces: Sequence[str]) -> None:
        """Offer faces; those already ticked stay, though they vanish from the list if they are not offered."""
        if list(faces) != self._names():
            self._show(faces, self.chosen())

    def _names(self) -> list:
        return [str(self.faces.item(k).text()) for k in range(self.faces.count())]

    def _show(self, names: Sequence[str], ticked: Sequence[str]) -> None:
        self.faces.blockSignals(True)
        self.faces.clear()
        for name in names:
            item = QtGui.QListWidgetItem(name)
            item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Checked if name in ticked else QtCore.Qt.Unchecked)
            self.faces.addItem(item)
        self.faces.blockSignals(False)
        self.form.setVisible(bool(self.chosen()))


def _natural(name: str) -> Tuple[str, int]:
    digits = name.lstrip("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz")
    return name[: len(name) - len(digits)], int(digits) if digits.isdigit() else 0


def scaffold_summary(scaffold: ScaffoldParameters) -> str:
    """Return one line about the scaffold."""
    text = translate("Trabecula", "{} engine").format(choice(scaffold.engine))
    if scaffold.layers.faces:
        text += translate("Trabecula", ", layers on {} faces").format(len(scaffold.layers.faces))
    return text


class SurfaceSection(Form):
    """Surface and recovery of the rods."""

    def __init__(self, changed: Changed) -> None:
        rows = (
            ("deflection", translate("Trabecula", "Deflection"), 0.005),
            ("stations", translate("Trabecula", "Stations"), 1.0),
            ("lean", translate("Trabecula", "Lean"), 0.1),
            ("redraws", translate("Trabecula", "Redraws"), 1.0),
        )
        super().__init__(RodParameters, rows, changed)


def surface_summary(rods: RodParameters) -> str:
    """Return one line about the surface of the rods."""
    deflection = f"{local_number(rods.deflection)} mm" if rods.deflection else choice("auto")
    return translate("Trabecula", "deflection {}, {} stations").format(deflection, rods.stations)
