# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design again with other seeds, side by side: pictures, numbers, their spread; one of them can be taken."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Optional, Sequence, Tuple

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ..core.estimates import Work
from ..core.stl import whole_file
from ..core.variants import MOST, RAYS, SCAFFOLD, VOXELS, Variants, seeds_from, spread
from ..errors import ParameterError, TrabeculaError
from ..features.estimates import variants_work
from ..features.relations import type_of
from ..features.tasks import write_variants_task
from ..features.variants import read_variants
from .child_work import ChildWork, Progress, start_task, time_text
from .fields import row_widget
from .histogram import Histogram
from .language import filled, in_words, local_number
from .qt import icon
from .tables import fill, let_grow, table
from .transactions import say, told, transaction
from .why import WhyButton
from .work_text import work_text

translate = FreeCAD.Qt.translate
USUAL = 10  # variants of one click
_PICTURE, _ROW = 110, 116  # pixels
_CSV = "CSV (*.csv)"


class VariantsDialog(QtGui.QDialog):
    """Makes variants of a wireframe or a voxel design in another process and shows them.

    Parameters
    ----------
    obj : document object
    """

    def __init__(self, obj: Any) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self._document, self._name = obj.Document.Name, obj.Name
        self.variants: Optional[Variants] = None
        self.work: Optional[ChildWork] = None
        self._known: Dict[Tuple[str, str], Work] = {}
        is_rods = type_of(obj) == "Trabecula::Wireframe"
        self.setWindowTitle(translate("Trabecula", "Other seeds: {}").format(obj.Label))
        self.setWindowIcon(icon("Trabecula_variants"))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.count, self.first, self.by = QtGui.QSpinBox(), QtGui.QSpinBox(), QtGui.QComboBox()
        self.count.setRange(1, MOST)
        self.count.setValue(USUAL)
        self.first.setRange(0, 2**31 - 1 - MOST)
        self.first.setValue(int(obj.Seed if is_rods else obj.VoxelSeed))
        self.by.addItem(translate("Trabecula", "Estimate by rays (quick)"), RAYS)
        self.by.addItem(translate("Trabecula", "Scaffold of each (exact)"), SCAFFOLD)
        self.by.setVisible(is_rods)
        self.start_button = QtGui.QPushButton(translate("Trabecula", "Again"))
        self.cancel_button = QtGui.QPushButton(translate("Trabecula", "Cancel"))
        self.bar, self.message, self.estimate = QtGui.QProgressBar(), QtGui.QLabel(), QtGui.QLabel()
        self.bar.setRange(0, 1000)
        self.message.setWordWrap(True)
        self.table = table(1)
        fill(self.table, [translate("Trabecula", "Seed")], [])
        let_grow(self.table)
        self.table.setIconSize(QtCore.QSize(_PICTURE, _PICTURE))
        self.table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.histogram = Histogram(translate("Trabecula", "Porosity, %") if is_rods else "%")
        self.take_button = QtGui.QPushButton(translate("Trabecula", "Take this seed"))
        self.save_button = QtGui.QPushButton(translate("Trabecula", "Save CSV …"))
        self._lay_out()
        self.count.valueChanged.connect(lambda *_: self._show_estimate())
        self.by.currentIndexChanged.connect(lambda *_: self._show_estimate())
        self._show_estimate()
        self.start_button.clicked.connect(lambda *_: self.start())
        self.cancel_button.clicked.connect(lambda *_: self.cancel())
        self.take_button.clicked.connect(lambda *_: self.take())
        self.save_button.clicked.connect(lambda *_: self._ask_and_save())
        self.table.itemSelectionChanged.connect(self._offer)
        self._offer()

    def _lay_out(self) -> None:
        choices, work, ends = row_widget(), row_widget(), row_widget()
        words = (translate("Trabecula", "Variants"), translate("Trabecula", "from seed"))
        for word, box in zip(words, (self.count, self.first)):
            choices.layout().addWidget(QtGui.QLabel(word))
            choices.layout().addWidget(box)
        for widget in (self.by, self.start_button, self.estimate):
            choices.layout().addWidget(widget)
        choices.layout().addStretch(1)
        work.layout().addWidget(self.bar, 1)
        work.layout().addWidget(self.cancel_button)
        ends.layout().addWidget(self.take_button)
        ends.layout().addWidget(self.save_button)
        ends.layout().addStretch(1)
        ends.layout().addWidget(WhyButton(self._keys))
        column = QtGui.QVBoxLayout(self)
        for widget, stretch in ((choices, 0), (work, 0), (self.message, 0), (self.table, 1), (self.histogram, 0),
                                (ends, 0)):  # fmt: skip
            column.addWidget(widget, stretch)
        self.resize(900, 720)

    def _keys(self) -> Sequence[str]:
        if self.variants is None:
            return ()
        if self.variants.by == VOXELS:
            return ["voxels.overlap", "voxels.components", "voxels.trabeculae"]
        first = "design.estimate" if self.variants.by == RAYS else "design.porosity"
        return [first, "design.spread_mean", "design.spread_sd", "design.spread_range"]

    # ------------------------------------------------------------------------------------------------------- the work

    def start(self) -> None:
        """Make the variants in another process."""
        with told():
            seeds = seeds_from(self.first.value(), self.count.value())
            obj = self.obj()
            self.work = start_task(
                lambda folder: write_variants_task(folder, obj, seeds, self.by.currentData()),
                self._show_progress,
                self._show_results,
                self._fail,
            )
            self.bar.setValue(0)
            self.message.setText(self._what(translate("Trabecula", "being computed"), None))
        self._offer()

    def cancel(self) -> None:
        """End the work."""
        if self.work is not None:
            work, self.work = self.work, None
            work.cancel()
            self.message.setText(translate("Trabecula", "Cancelled"))
            self._offer()

    def done(self, code: int) -> None:
        """End the work with the dialog."""
        self.cancel()
        super().done(code)

    def _show_progress(self, progress: Progress) -> None:
        self.bar.setValue(int(1000 * progress.share))
        self.message.setText(self._what(in_words(progress.what), progress.left))

    def _what(self, text: str, left: Optional[float]) -> str:
        """What is done, and how long it still takes; what it will take in all until that is known."""
        if left:
            return text + translate("Trabecula", ", {} left").format(time_text(left))
        estimate = self.estimate.text()
        return f"{text} ({estimate})" if estimate else text

    def _work_of_one(self) -> Work:
        """What a variant takes; worked out once, for a number is typed, and the triangles of many rods are many."""
        obj, by = self.obj(), self.by.currentData()
        key = obj.ResultKey, by
        if key not in self._known:
            self._known[key] = variants_work(obj, 1, by)
        return self._known[key]

    def _show_estimate(self) -> None:
        """Say what will be done at the next click."""
        try:
            text = work_text(self._work_of_one().times(self.count.value()))
        except TrabeculaError:  # not computed yet, or closed: said when it is begun
            text = ""
        self.estimate.setText(text)

    def _fail(self, text: str) -> None:
        self.work = None
        self.message.setText(in_words(text))
        self._offer()

    def _show_results(self, folder: str) -> None:
        self.work = None
        self.bar.setValue(1000)
        with told():
            self.show_variants(read_variants(folder))
        self._offer()

    # ----------------------------------------------------------------------------------------------- what it shows

    def obj(self) -> Any:
        """Return the design.

        Raises
        ------
        ParameterError
            If it is no more.
        """
        document = FreeCAD.listDocuments().get(self._document)
        found = document.getObject(self._name) if document is not None else None
        if found is None:
            raise ParameterError(f"the design {self._name} must be open to be made again, got none: it was closed")
        return found

    def show_variants(self, variants: Variants) -> None:
        """Show pictures, numbers and their spread."""
        self.variants = variants
        names = list(variants.rows[0].numbers)
        self.table.setColumnCount(len(names) + 1)
        rows = [[str(row.seed), *(local_number(row.numbers[name], ".5g") for name in names)] for row in variants.rows]
        fill(self.table, [translate("Trabecula", "Seed"), *(in_words(name) for name in names)], rows)
        let_grow(self.table)
        self.table.verticalHeader().setDefaultSectionSize(_ROW)
        self.table.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        for number, row in enumerate(variants.rows):
            self.table.item(number, 0).setIcon(QtGui.QIcon(_pixmap(row.picture)))
        values = variants.values(variants.spreads)
        self.histogram.set_values(values)
        self.message.setText(self._words(variants, values))

    def _words(self, variants: Variants, values: np.ndarray) -> str:
        found = spread(values)
        text = filled(
            translate("Trabecula", "{}: mean {:.2f}, standard deviation {:.2f}, {:.2f} to {:.2f}, of {} variants"),
            in_words(variants.spreads), found.mean, found.sd, found.least, found.greatest, found.count,
        )  # fmt: skip
        how = {
            RAYS: translate("Trabecula", "by rays, loose pieces left in"),
            SCAFFOLD: translate("Trabecula", "of the scaffold of each"),
            VOXELS: filled(translate("Trabecula", "chance: {:.1f} %"), 100 * float(variants.chance)),
        }
        return f"{text} ({how[variants.by]})"

    def seed(self) -> Optional[int]:
        """Return the seed of the chosen row; None if there is none."""
        rows = sorted({index.row() for index in self.table.selectedIndexes()})
        return self.variants.rows[rows[0]].seed if rows and self.variants is not None else None

    def _offer(self) -> None:
        works = self.work is not None
        self.start_button.setEnabled(not works)
        self.cancel_button.setEnabled(works)
        self.take_button.setEnabled(not works and self.seed() is not None)
        self.save_button.setEnabled(not works and self.variants is not None)

    # -------------------------------------------------------------------------------------------------- what is done

    def take(self) -> None:
        """Give the design the chosen seed: one step to undo."""
        seed = self.seed()
        with told():
            obj = self.obj()
            with transaction(obj.Document, translate("Trabecula", "Take this seed")):
                setattr(obj, "Seed" if type_of(obj) == "Trabecula::Wireframe" else "VoxelSeed", seed)
                obj.Document.recompute()
            say(translate("Trabecula", "{} has the seed {}").format(obj.Label, seed))

    def _ask_and_save(self) -> None:
        path, _ = QtGui.QFileDialog.getSaveFileName(self, translate("Trabecula", "Save variants"), "", _CSV)
        if path:
            self.save(path)

    def save(self, path: str) -> None:
        """Save seeds and numbers as CSV."""
        with told():
            with whole_file(Path(path)) as file:
                file.write(self.variants.csv().encode("utf-8"))
            say(translate("Trabecula", "{} was written").format(path))


def _pixmap(picture: np.ndarray) -> Any:
    data = np.ascontiguousarray(picture)
    rows, columns = data.shape
    image = QtGui.QImage(data.tobytes(), columns, rows, columns, QtGui.QImage.Format_Grayscale8)
    return QtGui.QPixmap.fromImage(image.copy())  # its own bytes: those of the array go


def open_variants(obj: Any) -> VariantsDialog:
    """Open the dialog on a design and begin at once."""
    dialog = VariantsDialog(obj)
    dialog.show()
    dialog.start()
    return dialog
