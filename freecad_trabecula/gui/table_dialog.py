# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables alpha and beta of a voxel design: shown as in the thesis' Fig. 6.6, edited, written to files and read."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, List, Optional, Tuple

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtGui

from .. import make
from ..core.voxels.design import heeds_tables
from ..core.voxels.table_files import (
    SHEETS,
    ReadTable,
    read_table_csv,
    read_tables_xlsx,
    write_table_csv,
    write_tables_xlsx,
)
from ..core.voxels.table_pairs import pair_errors
from ..errors import ParameterError
from .language import choice, in_words
from .qt import Buttons, run_dialog
from .table_model import TableModel
from .transactions import told

translate = FreeCAD.Qt.translate
_FILES = "XLSX (*.xlsx);;CSV (*.csv)"
_WIDTH = 44  # pixels of a column: four digits


class TableDialog(QtGui.QDialog):
    """Both tables with their sums; what breaks a rule is marked.

    Parameters
    ----------
    parent : widget
    obj : document object
        A voxel design.
    """

    def __init__(self, parent: Any, obj: Any) -> None:
        super().__init__(parent)
        self.setWindowTitle(translate("Trabecula", "Tables of {}").format(obj.Label))
        self.design = make.voxel_design_of(obj)
        self.models = [
            TableModel(letter, table, self.check) for letter, table in zip("XY", (self.design.alpha, self.design.beta))
        ]
        self.tabs, self.message, self.buttons = QtGui.QTabWidget(), QtGui.QLabel(), Buttons()
        self.message.setWordWrap(True)
        self.views = [self._make_view(model) for model in self.models]
        for view, words in zip(self.views, (translate("Trabecula", "alpha: voxels in the lines (x, z)"),
                                            translate("Trabecula", "beta: voxels in the lines (y, z)"))):  # fmt: skip
            self.tabs.addTab(view, words)
        self.use = self._add_button(translate("Trabecula", "Design with these"), Buttons.AcceptRole, self.accept)
        self.reset = self._add_button(translate("Trabecula", "As they were"), Buttons.ResetRole, self.show_design)
        for words, pressed in (
            (translate("Trabecula", "Read …"), self._ask_and_read),
            (translate("Trabecula", "Write …"), self._ask_and_write),
        ):
            self._add_button(words, Buttons.ActionRole, pressed)
        self._add_button(translate("Trabecula", "Close"), Buttons.RejectRole, self.reject)
        column = QtGui.QVBoxLayout(self)
        column.addWidget(self.tabs, 1)
        column.addWidget(self.message)
        column.addWidget(self.buttons)
        self.resize(860, 560)
        for model in self.models:
            model.can_edit = heeds_tables(self.design.parameters.strategy)
        self.check()

    def _make_view(self, model: TableModel) -> Any:
        view = QtGui.QTableView()
        view.setModel(model)
        for header, size in ((view.horizontalHeader(), _WIDTH), (view.verticalHeader(), 20)):
            header.setMinimumSectionSize(18)
            header.setDefaultSectionSize(size)
        view.setColumnWidth(0, 2 * _WIDTH)
        return view

    def _add_button(self, words: str, role: Any, pressed: Callable[[], Any]) -> Any:
        button = self.buttons.addButton(words, role)
        button.clicked.connect(lambda *_: pressed())
        return button

    def tables(self) -> Tuple[np.ndarray, np.ndarray]:
        """Return alpha (N, P) and beta (M, P) as they stand."""
        return self.models[0].cells, self.models[1].cells

    def show_design(self) -> None:
        """Show the tables that the design has."""
        self.show_tables((self.design.alpha, self.design.beta))

    def show_tables(self, tables: Tuple[np.ndarray, np.ndarray]) -> None:
        """Show tables."""
        for model, table in zip(self.models, tables):
            model.show_cells(table)
        self.check()

    def check(self) -> None:
        """Mark what is wrong and say it; only tables that are right can be designed with."""
        design, tables = self.design, self.tables()
        errors = pair_errors(design.targets, design.parameters, *tables, design.mask)
        for model, own in zip(self.models, (errors.alpha, errors.beta)):
            model.show_errors(own, errors.layers)
        changed = not all((a == b).all() for a, b in zip(tables, (design.alpha, design.beta)))
        self.use.setEnabled(changed and not errors and self.models[0].can_edit)
        self.reset.setEnabled(changed)
        self.message.setText(self._words(errors, changed))

    def _words(self, errors: Any, changed: bool) -> str:
        if not self.models[0].can_edit:
            return translate(
                "Trabecula", "Strategy {} makes voxels without tables; another strategy fills layers from edited ones"
            ).format(choice(self.design.parameters.strategy))
        words, count = errors.first()
        if count:
            return translate("Trabecula", "{}; {} sums or cells are wrong").format(in_words(words), count)
        if len(errors.layers):
            return translate("Trabecula", "No voxels fill layer {} along Z; {} layers do not go").format(
                int(errors.layers[0]), len(errors.layers)
            )
        if changed:
            return translate("Trabecula", "All sums are right and every layer can be filled")
        return translate("Trabecula", "The design's own tables; cells can be edited, their sums must stay")

    # ------------------------------------------------------------------------------------------------------- files

    def read(self, path: str) -> None:
        """Show the tables of a workbook, or of a CSV file the one whose tab is open.

        Raises
        ------
        TrabeculaError
            If the file cannot be read, or holds a table of another shape.
        """
        now = list(self.tables())
        if Path(path).suffix.lower() == ".csv":
            chosen = self.tabs.currentIndex()
            now[chosen] = _cells(read_table_csv(path), now[chosen].shape, SHEETS[chosen])
        else:
            pairs = zip(read_tables_xlsx(path), now, SHEETS)
            now = [_cells(table, own.shape, name) for table, own, name in pairs]
        self.show_tables((now[0], now[1]))

    def write(self, path: str) -> None:
        """Write both tables as a workbook, or the one whose tab is open as CSV.

        Raises
        ------
        TrabeculaError
            If the file cannot be written.
        """
        if Path(path).suffix.lower() == ".csv":
            write_table_csv(path, self.tables()[self.tabs.currentIndex()])
        else:
            write_tables_xlsx(path if path.lower().endswith(".xlsx") else path + ".xlsx", *self.tables())

    def _ask_and_read(self) -> None:
        path, _ = QtGui.QFileDialog.getOpenFileName(self, translate("Trabecula", "Read tables"), "", _FILES)
        if path:
            with told():
                self.read(path)

    def _ask_and_write(self) -> None:
        path, _ = QtGui.QFileDialog.getSaveFileName(self, translate("Trabecula", "Write tables"), "", _FILES)
        if path:
            with told():
                self.write(path)


def _cells(table: ReadTable, shape: Tuple[int, ...], name: str) -> np.ndarray:
    """The cells of a table from a file."""
    if table.cells.shape != shape:
        raise ParameterError(
            f"table {name} must have {shape[0]} lines and {shape[1]} layers along Z, got {table.cells.shape[0]} and "
            f"{table.cells.shape[1]}"
        )
    return table.cells


def ask_for_tables(obj: Any) -> Optional[List[np.ndarray]]:
    """Show the tables of a voxel design; return those that it is to be designed with, None if none were chosen.

    Raises
    ------
    TrabeculaError
        If the design is not there yet.
    """
    dialog = TableDialog(FreeCADGui.getMainWindow(), obj)
    return list(dialog.tables()) if run_dialog(dialog) else None
