# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the design panel for paths (thesis 2.4.4, 3.2.4, 4.2.4)."""

from __future__ import annotations

from typing import List, Tuple

import FreeCAD
from PySide import QtGui

from ..core.laws import Law
from ..core.parameters import PathParameters, Point
from ..core.path_laws import PATH_LAWS
from .fields import Changed, PointField, row_widget
from .form import Form
from .language import choice, local_number
from .pores_section import law_text
from .qt import small_button

translate = FreeCAD.Qt.translate


def _rows() -> List[Tuple[str, str, float]]:
    """Field, label and step of each row: all that some kind of path needs."""
    titles = {
        "box": translate("Trabecula", "Box"),
        "choice": translate("Trabecula", "Choice"),
        "tension_first": translate("Trabecula", "First tension"),
        "tension_second": translate("Trabecula", "Second tension"),
    }
    names = dict.fromkeys(name for law in PATH_LAWS.values() for name in law.fields if name != "points")
    rows = [(name, titles.get(name, name.replace("_", " ").capitalize()), 0.5) for name in names]
    return [("kind", translate("Trabecula", "Path"), 1.0), *rows]


class PathsSection(QtGui.QWidget):
    """Kind of path, convergence points, box and tensions."""

    def __init__(self, changed: Changed) -> None:
        super().__init__()
        self._changed = changed
        self.form = Form(PathParameters, _rows(), self._form_changed)
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
        fields = PATH_LAWS[self.form.fields["kind"].value()].fields
        for name, *_ in _rows()[1:]:
            self.form.show_row(name, name in fields and (name != "choice" or len(self.points.value()) > 1))
        self.points.setVisible("points" in fields)

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
    """Return one line about paths: the kind and the lengths that it needs."""
    shown = []
    for value in (getattr(path, name) for name in PATH_LAWS[path.kind].fields if name not in ("points", "choice")):
        edges = value if isinstance(value, tuple) else (value,)
        shown.append(law_text(value) if isinstance(value, Law) else " × ".join(map(local_number, edges)))
    return f"{choice(path.kind)} {', '.join(shown)} mm" if shown else choice(path.kind)
