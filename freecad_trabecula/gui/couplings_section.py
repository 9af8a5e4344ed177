# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the design panel for couplings: an ordered table of face pairs, with what each gave (tables 4.2, 4.5)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, List, Sequence, Tuple

import FreeCAD
from PySide import QtCore, QtGui

from ..core.couplings import CouplingRow
from ..core.parameters import Coupling, PathParameters
from ..core.sites import OPPOSITE_FACES, PRISM_FACES
from .fields import Changed, ChoiceField, row_widget
from .form import Form
from .language import choice
from .paths_section import PathsSection, paths_summary
from .qt import Buttons, run_dialog, small_button
from .transactions import told

translate = FreeCAD.Qt.translate
_FACES, _PAIRS, _AVAILABLE, _RODS, _LEFT = range(5)


class CouplingsSection(QtGui.QWidget):
    """The table of couplings, and what more there is to set for the chosen one.

    Parameters
    ----------
    changed : callable
    design_path : callable
        Returns the paths of the design, for a coupling that is to have its own.
    """

    def __init__(self, changed: Changed, design_path: Callable[[], PathParameters]) -> None:
        super().__init__()
        self._report, self._showing = changed, False
        self._design_path = design_path
        self._couplings: List[Coupling] = []
        self._faces: Tuple[str, ...] = PRISM_FACES
        self.table = QtGui.QTableWidget(0, 5)
        self.first = ChoiceField((), self._ends_changed, translate("Trabecula", "Face at which the rods start"))
        self.second = ChoiceField((), self._ends_changed, translate("Trabecula", "Face at which they end"))
        rows = (
            ("association", translate("Trabecula", "Pairs"), 1.0),
            ("limit", translate("Trabecula", "Most rods"), 1.0),
            ("reuse", translate("Trabecula", "Reuse sites"), 1.0),
        )
        self.form = Form(Coupling, rows, self._form_changed)
        self.path_button = QtGui.QPushButton()
        self.path_button.setToolTip(translate("Trabecula", "Paths of this coupling alone"))
        self.path_button.clicked.connect(self._edit_path)
        self._lay_out()

    def _lay_out(self) -> None:
        titles = (
            translate("Trabecula", "Faces"), translate("Trabecula", "Pairs"), translate("Trabecula", "Available"),
            translate("Trabecula", "Rods"), translate("Trabecula", "Left"),
        )  # fmt: skip
        self.table.setHorizontalHeaderLabels(titles)
        header = self.table.horizontalHeader()
        header.setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(_FACES, QtGui.QHeaderView.Stretch)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(24)
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.setFixedHeight(152)
        self.table.itemSelectionChanged.connect(self._show_chosen)
        self.table.itemChanged.connect(self._ticked)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        ends = row_widget()
        for widget, stretch in ((QtGui.QLabel(translate("Trabecula", "From")), 0), (self.first.widget, 1),
                                (QtGui.QLabel(translate("Trabecula", "to")), 0), (self.second.widget, 1)):  # fmt: skip
            ends.layout().addWidget(widget, stretch)
        for widget in (self._buttons(), self.table, ends, self.form, self.path_button):
            column.addWidget(widget)
        self._show_chosen()

    def _buttons(self) -> Any:
        buttons = row_widget()
        self.opposite_button = QtGui.QPushButton(translate("Trabecula", "Opposite faces"))
        self.opposite_button.setToolTip(translate("Trabecula", "Couple the opposite faces of the prism"))
        self.opposite_button.clicked.connect(self._couple_opposite)
        buttons.layout().addWidget(self.opposite_button, 1)
        for name, tip, pressed in (
            ("list-add", translate("Trabecula", "Add a coupling"), self._add),
            ("list-remove", translate("Trabecula", "Remove the chosen coupling"), self._remove),
            (
                "button_up",
                translate("Trabecula", "Earlier: its faces' sites are taken first"),
                lambda *_: self._move(-1),
            ),
            ("button_down", translate("Trabecula", "Later"), lambda *_: self._move(1)),
        ):
            button = small_button(name, tip, pressed)
            setattr(self, name.replace("-", "_") + "_button", button)
            buttons.layout().addWidget(button)
        return buttons

    # ---------------------------------------------------------------------------------------------- the couplings

    def value(self) -> Tuple[Coupling, ...]:
        """Return the couplings, in order."""
        return tuple(self._couplings)

    def set_value(self, couplings: Sequence[Coupling], faces: Sequence[str]) -> None:
        """Show couplings of the given faces."""
        self._couplings, self._faces = list(couplings), tuple(faces)
        self._fill(0)

    def set_faces(self, faces: Sequence[str]) -> None:
        """Offer other faces; couplings of faces that are no more go."""
        if tuple(faces) == self._faces:
            return
        self._faces = tuple(faces)
        self._couplings = [c for c in self._couplings if c.first in faces and c.second in faces]
        self._fill(0)

    def set_rows(self, rows: Sequence[CouplingRow]) -> None:
        """Show what each coupling gave; those that are off gave nothing."""
        given = iter(rows)
        self._showing = True
        for number, coupling in enumerate(self._couplings):
            row = next(given, None) if coupling.on else None
            texts = ("", "", "")
            if row is not None:
                available = f"{row.available_first} · {row.available_second}"
                texts = (available, str(row.rods), f"{row.left_first} · {row.left_second}")
            for column, text in zip((_AVAILABLE, _RODS, _LEFT), texts):
                self.table.setItem(number, column, _item(text))
        self._showing = False

    def _changed(self, chosen: int) -> None:
        self._fill(chosen)
        self._report()

    def _fill(self, chosen: int) -> None:
        self._showing = True
        for field in (self.first, self.second):
            field.set_choices(self._faces)
        self.table.setRowCount(len(self._couplings))
        for row, coupling in enumerate(self._couplings):
            faces = _item(f"{short(coupling.first)} – {short(coupling.second)}")
            faces.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable | QtCore.Qt.ItemIsUserCheckable)
            faces.setCheckState(QtCore.Qt.Checked if coupling.on else QtCore.Qt.Unchecked)
            self.table.setItem(row, _FACES, faces)
            self.table.setItem(row, _PAIRS, _item(choice(coupling.association)))
        self._showing = False
        if self._couplings:
            self.table.selectRow(min(max(chosen, 0), len(self._couplings) - 1))
        self._show_chosen()

    def _set(self, row: int, **values: Any) -> None:
        self._couplings[row] = replace(self._couplings[row], **values)
        self._changed(row)

    def _ticked(self, item: Any) -> None:
        if not self._showing and item.column() == _FACES:
            on = item.checkState() == QtCore.Qt.Checked
            if on != self._couplings[item.row()].on:
                self._set(item.row(), on=on)

    def _add(self, *_: object) -> None:
        if self._faces:
            used = {(c.first, c.second) for c in self._couplings}
            pairs = [(a, b) for i, a in enumerate(self._faces) for b in self._faces[i + 1 :]]
            first, second = next((p for p in pairs if p not in used), (self._faces[0], self._faces[-1]))
            self._couplings.append(Coupling(first, second))
            self._changed(len(self._couplings) - 1)

    def _remove(self, *_: object) -> None:
        row = self.chosen_row()
        if row >= 0:
            del self._couplings[row]
            self._changed(row)

    def _move(self, by: int) -> None:
        row = self.chosen_row()
        if row >= 0 and 0 <= row + by < len(self._couplings):
            self._couplings.insert(row + by, self._couplings.pop(row))
            self._changed(row + by)

    def _couple_opposite(self, *_: object) -> None:
        association = self._couplings[0].association if self._couplings else "random"
        self._couplings = [
            Coupling(a, b, association) for a, b in OPPOSITE_FACES if a in self._faces and b in self._faces
        ]
        self._changed(0)

    # ----------------------------------------------------------------------------------------- the chosen coupling

    def chosen_row(self) -> int:
        """Return the row of the chosen coupling, -1 if there is none."""
        row = self.table.currentRow()
        return row if 0 <= row < len(self._couplings) else -1

    def _show_chosen(self) -> None:
        row = self.chosen_row()
        for widget in (self.form, self.path_button, self.first.widget, self.second.widget):
            widget.setEnabled(row >= 0)
        self.opposite_button.setEnabled(set(PRISM_FACES) <= set(self._faces))
        path = self._couplings[row].path if row >= 0 else None
        own = paths_summary(path) if path else translate("Trabecula", "as the design")
        self.path_button.setText(translate("Trabecula", "Path: {}").format(own))
        if row >= 0:
            self._showing = True
            self.first.set_value(self._couplings[row].first)
            self.second.set_value(self._couplings[row].second)
            self.form.set_value(self._couplings[row])
            self._showing = False

    def _ends_changed(self) -> None:
        row = self.chosen_row()
        if not self._showing and row >= 0 and self.first.value() and self.second.value():
            self._set(row, first=self.first.value(), second=self.second.value())

    def _form_changed(self) -> None:
        row = self.chosen_row()
        if row >= 0:
            self._set(row, **self.form.values())

    def _edit_path(self, *_: object) -> None:
        row = self.chosen_row()
        with told():
            self.ask_path(row)

    def ask_path(self, row: int) -> None:
        """Ask for the paths of one coupling, starting from those of the design.

        Raises
        ------
        ParameterError
            If the paths of the design break a rule.
        """
        dialog = PathDialog(self, self._couplings[row], self._design_path())
        if run_dialog(dialog):
            self._set(row, path=dialog.value())


class PathDialog(QtGui.QDialog):
    """Asks for the paths of one coupling."""

    def __init__(self, parent: Any, coupling: Coupling, design_path: PathParameters) -> None:
        super().__init__(parent)
        self.setWindowTitle(translate("Trabecula", "Paths from {} to {}").format(coupling.first, coupling.second))
        self.own = QtGui.QCheckBox(translate("Trabecula", "Paths of its own"))
        self.section = PathsSection(lambda: None)
        self.section.set_value(coupling.path or design_path)
        self.own.toggled.connect(self.section.setEnabled)
        self.own.setChecked(coupling.path is not None)
        self.section.setEnabled(coupling.path is not None)
        buttons = Buttons(Buttons.Ok | Buttons.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        column = QtGui.QVBoxLayout(self)
        for widget in (self.own, self.section, buttons):
            column.addWidget(widget)

    def accept(self) -> None:
        """Close the dialog, unless a value breaks a rule."""
        with told():
            self.value()
            super().accept()

    def value(self) -> Any:
        """Return the paths, None for those of the design."""
        return self.section.value() if self.own.isChecked() else None


def _item(text: str) -> QtGui.QTableWidgetItem:
    item = QtGui.QTableWidgetItem(text)
    item.setTextAlignment(QtCore.Qt.AlignCenter)
    return item


def couplings_summary(couplings: Sequence[Coupling]) -> str:
    """Return one line about couplings."""
    on = [c for c in couplings if c.on]
    if not on:
        return translate("Trabecula", "none")
    return ", ".join(f"{short(c.first)}–{short(c.second)}" for c in on[:4]) + (" …" if len(on) > 4 else "")


def short(face: str) -> str:
    """Return a face's name without FreeCAD's word for it."""
    return face[4:] if face.startswith("Face") and face[4:].isdigit() else face
