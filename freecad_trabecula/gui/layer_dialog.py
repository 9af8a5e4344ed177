# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks which layers of a voxel design become shapes, with an estimate beforehand, and makes them."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import make
from ..errors import Cancelled, ParameterError
from ..geometry.voxel_shapes import ShapeEstimate, shape_estimate
from .child_work import time_text
from .export_dialog import size_text
from .language import in_words, local_number
from .qt import Buttons, run_dialog
from .transactions import transaction

translate = FreeCAD.Qt.translate
MOST_MEMORY = 4e9  # bytes of shapes; more would bring FreeCAD down


class LayerDialog(QtGui.QDialog):
    """First and last layer, wires or solids, and what they take."""

    def __init__(self, parent: Any, obj: Any) -> None:
        super().__init__(parent)
        self.setWindowTitle(translate("Trabecula", "Layer shapes"))
        self._voxels = make.voxel_design_of(obj).voxels
        self.first, self.last, self.kind = QtGui.QSpinBox(), QtGui.QSpinBox(), QtGui.QComboBox()
        self.estimate = QtGui.QLabel()
        self.estimate.setWordWrap(True)
        self.kind.addItems([translate("Trabecula", "outlines as wires"), translate("Trabecula", "solids")])
        middle = len(self._voxels) // 2
        for box in (self.first, self.last):
            box.setRange(0, len(self._voxels) - 1)
            box.setValue(middle)
            box.valueChanged.connect(lambda *_: self._show_estimate())
        self.kind.currentIndexChanged.connect(lambda *_: self._show_estimate())
        self.buttons = Buttons(Buttons.Ok | Buttons.Cancel)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        grid = QtGui.QFormLayout(self)
        grid.addRow(translate("Trabecula", "First layer along Z"), self.first)
        grid.addRow(translate("Trabecula", "Last layer"), self.last)
        grid.addRow(translate("Trabecula", "As"), self.kind)
        grid.addRow(self.estimate)
        grid.addRow(self.buttons)
        self.resize(380, 180)
        self._show_estimate()

    def chosen(self) -> Tuple[range, bool]:
        """Return the layers, and whether they become solids."""
        return range(self.first.value(), self.last.value() + 1), self.kind.currentIndex() == 1

    def work(self) -> ShapeEstimate:
        """Return what the chosen layers take.

        Raises
        ------
        ParameterError
            If there is no layer, or they take too much memory.
        """
        layers, solid = self.chosen()
        if not layers:
            raise ParameterError(f"the last layer must not lie below the first, got {self.first.value()} to "
                                 f"{self.last.value()}")  # fmt: skip
        work = shape_estimate(self._voxels, layers, solid)
        if work.memory > MOST_MEMORY:
            raise ParameterError(
                f"shapes of layers must take at most {size_text(MOST_MEMORY)} of memory; fewer layers take less, "
                f"got {size_text(work.memory)}"
            )
        return work

    def _show_estimate(self) -> None:
        try:
            work = self.work()
            text = translate("Trabecula", "{} corners: about {}, {} of memory, {} as STEP").format(
                local_number(work.corners, ","), time_text(work.seconds), size_text(work.memory), size_text(work.step)
            )
        except ParameterError as error:
            work, text = None, in_words(str(error))
        self.estimate.setText(text)
        self.buttons.button(Buttons.Ok).setEnabled(work is not None)


def ask_and_make(obj: Any) -> Optional[Any]:
    """Ask which layers become shapes and make them in one step; return the object, None if it was not to be.

    Raises
    ------
    TrabeculaError
        If the design is not there yet, or the kernel fails.
    """
    dialog = LayerDialog(FreeCADGui.getMainWindow(), obj)
    return make_shapes(obj, *dialog.chosen()) if run_dialog(dialog) else None


def make_shapes(obj: Any, layers: range, solid: bool) -> Any:
    """Make shapes of layers in one step, with a bar and a button that ends it between two layers.

    Raises
    ------
    Cancelled
        By the button; the document is as it was.
    TrabeculaError
        If the kernel fails.
    """
    words, cancel = translate("Trabecula", "Layers"), translate("Trabecula", "Cancel")
    bar = QtGui.QProgressDialog(words, cancel, 0, len(layers), FreeCADGui.getMainWindow())
    bar.setWindowModality(QtCore.Qt.WindowModal)
    bar.setMinimumDuration(500)

    def progress(done: float, total: float, what: str) -> None:
        bar.setLabelText(what)
        bar.setValue(int(done))
        QtGui.QApplication.processEvents()
        if bar.wasCanceled():
            raise Cancelled("the layers were not to be made")

    try:
        with transaction(obj.Document, translate("Trabecula", "Layer shapes")):
            found = make.make_layer_shapes(obj, layers, solid, progress)
    finally:
        bar.close()
        bar.deleteLater()
    return found
