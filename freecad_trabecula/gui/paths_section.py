# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the design panel for paths (thesis 2.4.4, 3.2.4, 4.2.4)."""

from __future__ import annotations

from typing import List, Tuple

import FreeCAD
from PySide import QtGui

from ..core.parameters import PathParameters, Point
from .fields import Changed, PointField, row_widget
from .form import Form
from .language import choice, local_number
from .pores_section import law_text
from .qt import small_button

translate = FreeCAD.Qt.translate
#: The kinds of path for which a row counts; the others hide it.
_ROWS = {
    "box": ("box",),
    "choice": ("centre", "box"),
    "tension_first": ("tension",),
    "tension_second": ("tension",),
}


class PathsSection(QtGui.QWidget):
    """Kind of path, convergence points, box and tensions."""

    def __init__(self, changed: Changed) -> None:
        super().__init__()
        self._changed = changed
        rows = (
            ("kind", translate("Trabecula", "Path"), 1.0),
            ("box", translate("Trabecula", "Box"), 0.5),
            ("choice", translate("Trabecula", "Choice"), 1.0),
            ("tension_first", translate("Trabecula", "First tension"), 0.5),
            ("tension_second", translate("Trabecula", "Second tension"), 0.5),
        )
        self.form = Form(PathParameters, rows, self._form_changed)
        self.form.fields["kind"].widget.currentIndexChanged.connect(lambda *_: self._show_rows())
        self.points = PointsList(self._points_changed)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.form)
        column.addWidget(self.points)

    def _form_changed(self) -> None:
        self._changed()

    def _points_changed(self) -> None:
        self._show_rows()
        self._changed()

    def _show_rows(self) -> None:
        kind = self.form.fields["kind"].value()
        for name, kinds in _ROWS.items():
            self.form.show_row(name, kind in kinds)
        self.form.show_row("choice", kind in _ROWS["choice"] and len(self.points.value()) > 1)
        self.points.setVisible(kind in _ROWS["choice"])

    def value(self) -> PathParameters:
        """Return the parameters.

        Raises
        ------
        ParameterError
            If a value breaks a rule.
        """
        return self.form.value(points=self.points.value())

    def set_value(self, path: PathParameters) -> None:
        """Show the parameters."""
        self.form.set_value(path)
        self.points.set_value(path.points)
        self._show_rows()


class PointsList(QtGui.QWidget):
    """Convergence points, one a row; none means the centre of the envelope."""

    def __init__(self, changed: Changed) -> None:
        super().__init__()
        self._changed = changed
        self._rows: List[Tuple[PointField, object]] = []
        self._column = QtGui.QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(2)
        head = row_widget()
        self._title = QtGui.QLabel()
        self.add_button = small_button("list-add", translate("Trabecula", "Add a convergence point"), self._add)
        head.layout().addWidget(self._title, 1)
        head.layout().addWidget(self.add_button)
        self._column.addWidget(head)
        self._show_title()

    def _show_title(self) -> None:
        count = len(self._rows)
        text = translate("Trabecula", "Convergence: centre of the envelope")
        self._title.setText(translate("Trabecula", "Convergence points: {}").format(count) if count else text)

    def _add(self) -> None:
        self._add_row((0.0, 0.0, 0.0))
        self._changed()

    def _add_row(self, point: Point) -> None:
        field = PointField("mm", 0.5, self._changed, translate("Trabecula", "Convergence point"))
        field.set_value(point)
        row = row_widget()
        tip = translate("Trabecula", "Remove this point")
        row.layout().addWidget(field.widget, 1)
        row.layout().addWidget(small_button("list-remove", tip, lambda *_: self._remove(row)))
        self._column.addWidget(row)
        self._rows.append((field, row))
        self._show_title()

    def _remove(self, row: object) -> None:
        self._rows = [one for one in self._rows if one[1] is not row]
        row.setParent(None)
        row.deleteLater()
        self._show_title()
        self._changed()

    def value(self) -> Tuple[Point, ...]:
        """Return the points."""
        return tuple(field.value() for field, _ in self._rows)

    def set_value(self, points: Tuple[Point, ...]) -> None:
        """Show points."""
        for _, row in self._rows:
            row.setParent(None)
            row.deleteLater()
        self._rows = []
        for point in points:
            self._add_row(point)
        self._show_title()


def paths_summary(path: PathParameters) -> str:
    """Return one line about paths."""
    if path.kind == "box":
        return f"{choice(path.kind)} {' × '.join(local_number(edge) for edge in path.box)} mm"
    if path.kind == "tension":
        return f"{choice(path.kind)} {law_text(path.tension_first)}, {law_text(path.tension_second)} mm"
    return choice(path.kind)
