# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks which body of a design is to be written in which format, with the size of the file beforehand."""

from __future__ import annotations

import os
from typing import Any, Callable, List, Optional, Sequence, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..errors import ParameterError
from ..features.relations import parts_of
from ..geometry.files import (
    MESH_FORMATS,
    SHAPE_FORMATS,
    estimate_mesh_size,
    estimate_shape_size,
    write_mesh,
    write_shape,
)
from ..geometry.mesh_objects import core_mesh
from .labels import file_name
from .language import local_number
from .preferences import folder_for
from .qt import Buttons, run_dialog
from .transactions import say

translate = FreeCAD.Qt.translate
_SAME = {"stp", "brp", "igs"}  # other words for formats that are offered already


class ExportDialog(QtGui.QDialog):
    """Body, format, size."""

    def __init__(self, parent: Any, bodies: List[Any]) -> None:
        super().__init__(parent)
        self.setWindowTitle(translate("Trabecula", "Export"))
        self._bodies = bodies
        self._sizes: dict = {}
        self.body, self.format = QtGui.QComboBox(), QtGui.QComboBox()
        self.size, self.note = QtGui.QLabel(), QtGui.QLabel()
        self.note.setWordWrap(True)
        self.body.addItems([obj.Label for obj in bodies])
        self.body.currentIndexChanged.connect(lambda *_: self._offer_formats())
        self.format.currentIndexChanged.connect(lambda *_: self._show_size())
        buttons = Buttons(Buttons.Save | Buttons.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        grid = QtGui.QFormLayout(self)
        grid.addRow(translate("Trabecula", "Body"), self.body)
        grid.addRow(translate("Trabecula", "Format"), self.format)
        grid.addRow(translate("Trabecula", "Size of the file"), self.size)
        grid.addRow(self.note)
        grid.addRow(buttons)
        self.resize(380, 160)
        self._offer_formats()

    def chosen(self) -> Tuple[Any, str]:
        """Return the body and the format."""
        return self._bodies[max(self.body.currentIndex(), 0)], str(self.format.currentText())

    def kinds(self, obj: Any) -> Sequence[str]:
        """Return the formats that are offered for a body."""
        return MESH_FORMATS if hasattr(obj, "Mesh") else [kind for kind in SHAPE_FORMATS if kind not in _SAME]

    def size_of(self, obj: Any, kind: str) -> int:
        """Return about how many bytes a body takes in a file."""
        return estimated_size(obj, kind)

    def _offer_formats(self) -> None:
        obj = self._bodies[max(self.body.currentIndex(), 0)]
        self.format.blockSignals(True)
        self.format.clear()
        self.format.addItems(list(self.kinds(obj)))
        self.format.blockSignals(False)
        self._show_size()

    def _show_size(self) -> None:
        obj, kind = self.chosen()
        if (obj.Name, kind) not in self._sizes:
            self._sizes[obj.Name, kind] = self.size_of(obj, kind)
        self.size.setText(size_text(self._sizes[obj.Name, kind]))
        current = getattr(obj, "UpToDate", True)
        self.note.setText("" if current else translate("Trabecula", "This body is out of date: build it again first"))


def estimated_size(obj: Any, kind: str) -> int:
    """Return about how many bytes a body takes in a file."""
    if hasattr(obj, "Mesh"):
        return estimate_mesh_size(kind, core_mesh(obj.Mesh))
    return estimate_shape_size(kind, obj.Shape.Solids)


def size_text(size: float) -> str:
    """Return a number of bytes as a person would say it.

    Examples
    --------
    >>> size_text(4.84e6)
    '4.8 MB'
    """
    for unit in ("B", "kB", "MB"):
        if size < 1000:
            return f"{size:.0f} {unit}" if unit == "B" else f"{local_number(size, '.1f')} {unit}"
        size /= 1000
    return f"{local_number(size, '.2f')} GB"


def write_body(obj: Any, path: str) -> None:
    """Write a body into a file, by the name's extension.

    Raises
    ------
    ExportError
        If it cannot be written.
    """
    QtGui.QApplication.setOverrideCursor(QtGui.QCursor(QtCore.Qt.WaitCursor))
    try:
        if hasattr(obj, "Mesh"):
            write_mesh(path, core_mesh(obj.Mesh))
        else:
            write_shape(path, obj.Shape)
    finally:
        QtGui.QApplication.restoreOverrideCursor()


def export_design(wireframe: Any) -> Optional[str]:
    """Ask what is to be written and where, and write it; return the file's name, None if it was not to be.

    Raises
    ------
    TrabeculaError
        If there is nothing to write, or it cannot be written.
    """
    bodies = [one for one in parts_of(wireframe) if exists(one)]
    if not bodies:
        raise ParameterError("a design needs a network or a scaffold to be exported, got none: build one first")
    dialog = ExportDialog(FreeCADGui.getMainWindow(), bodies)
    if not run_dialog(dialog):
        return None
    return ask_and_write(*dialog.chosen(), write_body)


def ask_and_write(obj: Any, kind: str, write: Callable[[Any, str], None]) -> Optional[str]:
    """Ask for a file of a kind and have a body written there; return the file's name, None if it was not to be.

    Raises
    ------
    TrabeculaError
        If it cannot be written.
    """
    folder, name = folder_for(obj.Document), file_name(obj, f".{kind}")
    path, _ = QtGui.QFileDialog.getSaveFileName(
        FreeCADGui.getMainWindow(), translate("Trabecula", "Export"), os.path.join(folder, name),
        f"{kind.upper()} (*.{kind})",
    )  # fmt: skip
    if not path:
        return None
    path = path if path.lower().endswith("." + kind) else f"{path}.{kind}"
    write(obj, path)
    say(translate("Trabecula", "{} was written: {}").format(path, size_text(os.path.getsize(path))))
    return path


def exists(obj: Any) -> bool:
    """Return whether a body has something to write."""
    return obj.Mesh.CountFacets > 0 if hasattr(obj, "Mesh") else not obj.Shape.isNull()
