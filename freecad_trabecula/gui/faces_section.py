# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the design panel for sites on picked faces (thesis 4.2.2): faces, and values of the chosen one."""

from __future__ import annotations

from dataclasses import replace
from typing import Callable, Dict, List, Optional, Sequence, Tuple

import FreeCAD
from PySide import QtCore, QtGui

from ..core.parameters import FaceParameters, Point
from ..errors import ParameterError
from .fields import Changed, row_widget
from .form import Form
from .language import local_number
from .qt import small_button

translate = FreeCAD.Qt.translate
_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"


class FacesSection(QtGui.QWidget):
    """A list of faces with sites.

    Parameters
    ----------
    changed : callable
    pick_faces : callable
        Called with True and False when picking in the 3D view is to begin and to end.
    pick_point : callable
        Called when the origin of the chosen face is to be picked.
    """

    def __init__(self, changed: Changed, pick_faces: Callable[[bool], None], pick_point: Callable[[], None]) -> None:
        super().__init__()
        self._changed = changed
        self._faces: List[FaceParameters] = []
        self._counts: Dict[str, int] = {}
        self._error: Optional[ParameterError] = None
        self.table = QtGui.QTableWidget(0, 3)
        self.pick_button = QtGui.QPushButton(translate("Trabecula", "Pick faces"))
        self.pick_button.setToolTip(translate("Trabecula", "Click faces in the 3D view; a second click takes one away"))
        self.pick_button.setCheckable(True)
        self.pick_button.toggled.connect(pick_faces)
        self.origin_button = small_button(
            "Trabecula_site", translate("Trabecula", "Pick the origin on the chosen face"), lambda *_: pick_point()
        )
        self.form = Form(FaceParameters, self._rows(), self._form_changed)
        self._lay_out()

    @staticmethod
    def _rows() -> tuple:
        return (
            ("name", translate("Trabecula", "Name"), 1.0),
            ("c_u,c_v", translate("Trabecula", "Spacing u, v"), 0.25),
            ("b_u,b_v", translate("Trabecula", "Border u, v"), 0.1),
            ("origin", translate("Trabecula", "Origin"), 0.5),
            ("d1", translate("Trabecula", "Direction u"), 0.1),
            ("d2", translate("Trabecula", "Direction v"), 0.1),
        )

    def _lay_out(self) -> None:
        names = [translate("Trabecula", "Name"), translate("Trabecula", "Face"), translate("Trabecula", "Sites")]
        self.table.setHorizontalHeaderLabels(names)
        self.table.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.Stretch)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(22)
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.setFixedHeight(118)
        self.table.itemSelectionChanged.connect(self._show_chosen)
        buttons = row_widget()
        self.remove_button = small_button(
            "list-remove", translate("Trabecula", "Take the chosen face away"), self._take
        )
        self.all_button = small_button(
            "", translate("Trabecula", "Give all faces the spacings and borders of the chosen one"), self._to_all,
            translate("Trabecula", "To all"),
        )  # fmt: skip
        buttons.layout().addWidget(self.pick_button, 1)
        for button in (self.origin_button, self.all_button, self.remove_button):
            buttons.layout().addWidget(button)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (buttons, self.table, self.form):
            column.addWidget(widget)
        self._show_chosen()

    # ------------------------------------------------------------------------------------------------- the faces

    def value(self) -> Tuple[FaceParameters, ...]:
        """Return the faces.

        Raises
        ------
        ParameterError
            If a value of the chosen face breaks a rule.
        """
        if self._error is not None:
            raise self._error
        return tuple(self._faces)

    def set_value(self, faces: Sequence[FaceParameters]) -> None:
        """Show faces."""
        self._faces, self._error = list(faces), None
        self._fill()
        if faces:
            self.table.selectRow(0)
        self._show_chosen()

    def toggle(self, face: str) -> None:
        """Add a face by FreeCAD's name, or take it away; a new one gets the next letter and the last one's values."""
        known = [one.face for one in self._faces]
        if face in known:
            del self._faces[known.index(face)]
        else:
            taken = {one.label for one in self._faces}
            name = next((letter for letter in _LETTERS if letter not in taken), "")
            model = self._faces[-1] if self._faces else FaceParameters()
            self._faces.append(replace(model, face=face, name=name, origin=None, d1=None, d2=None))
        self._fill()
        self.table.selectRow(len(self._faces) - 1)
        self._changed()

    def set_origin(self, face: str, point: Point) -> None:
        """Set the origin of a face that is in the list."""
        for row, one in enumerate(self._faces):
            if one.face == face:
                self._faces[row] = replace(one, origin=point)
                self.table.selectRow(row)
                self._show_chosen()
                self._changed()

    def set_counts(self, counts: Dict[str, int]) -> None:
        """Show how many sites each face has, by label."""
        self._counts = counts
        for row, one in enumerate(self._faces):
            self.table.setItem(row, 2, _item(str(counts.get(one.label, ""))))

    def _fill(self) -> None:
        self.table.blockSignals(True)
        self.table.setRowCount(len(self._faces))
        for row, one in enumerate(self._faces):
            for column, text in enumerate((one.label, one.face, str(self._counts.get(one.label, "")))):
                self.table.setItem(row, column, _item(text))
        self.table.blockSignals(False)

    # -------------------------------------------------------------------------------------------- the chosen face

    def chosen_row(self) -> int:
        """Return the row of the chosen face, -1 if there is none."""
        row = self.table.currentRow()
        return row if 0 <= row < len(self._faces) else -1

    def _show_chosen(self) -> None:
        row = self.chosen_row()
        for widget in (self.form, self.remove_button, self.all_button, self.origin_button):
            widget.setEnabled(row >= 0)
        if row >= 0:
            self.form.set_value(self._faces[row])

    def _form_changed(self) -> None:
        row = self.chosen_row()
        if row < 0:
            return
        try:
            self._faces[row] = self.form.value(face=self._faces[row].face)
            self._error = None
        except ParameterError as error:
            self._error = error
        self.table.setItem(row, 0, _item(self._faces[row].label))
        self._changed()

    def _take(self, *_: object) -> None:
        if self.chosen_row() >= 0:
            self.toggle(self._faces[self.chosen_row()].face)

    def _to_all(self, *_: object) -> None:
        if self.chosen_row() >= 0:
            model = self._faces[self.chosen_row()]
            shared = {name: getattr(model, name) for name in ("c_u", "c_v", "b_u", "b_v")}
            self._faces = [replace(one, **shared) for one in self._faces]
            self._changed()


def _item(text: str) -> QtGui.QTableWidgetItem:
    item = QtGui.QTableWidgetItem(text)
    item.setTextAlignment(QtCore.Qt.AlignCenter)
    return item


def faces_summary(faces: Sequence[FaceParameters]) -> str:
    """Return one line about faces with sites."""
    if not faces:
        return translate("Trabecula", "no face picked")
    spacings = sorted({local_number(value) for one in faces for value in (one.c_u, one.c_v)})
    names = " ".join(one.label for one in faces)
    return translate("Trabecula", "{}, c = {} mm").format(names, "/".join(spacings))
