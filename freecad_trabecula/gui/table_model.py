# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table alpha or beta for a table view, in the layout of the thesis' Fig. 6.6: sums first, layer 0 at the bottom."""

from __future__ import annotations

from typing import Any, Callable, Dict, Sequence, Tuple

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from ..core.voxels.tables import SumError
from .language import in_words
from .qt import paper_and_ink

translate = FreeCAD.Qt.translate
_WRONG, _APART = "#e57373", "#ffb74d"  # a sum or cell that breaks a rule; a layer that no voxels can fill


class TableModel(QtCore.QAbstractTableModel):
    """Cells that can be edited, and their sums against those asked for.

    Parameters
    ----------
    letter : str
        Of the lines: X for alpha, Y for beta.
    cells : ndarray of shape (K, P), int
    changed : callable
        Called after each edit.
    """

    def __init__(self, letter: str, cells: np.ndarray, changed: Callable[[], None]) -> None:
        super().__init__()
        self.letter, self.cells, self.can_edit = letter, np.array(cells, np.int64), True
        self._changed = changed
        self._wrong: Dict[Tuple[str, int, int], SumError] = {}
        self._apart: frozenset = frozenset()

    def show_cells(self, cells: np.ndarray) -> None:
        """Show another table of the same shape."""
        self.beginResetModel()
        self.cells = np.array(cells, np.int64)
        self.endResetModel()

    def show_errors(self, errors: Sequence[SumError], layers: Sequence[int]) -> None:
        """Mark what is wrong, and layers along Z that no voxels can fill."""
        self._wrong = {(one.kind, one.row, one.column): one for one in errors}
        self._apart = frozenset(int(k) for k in layers)
        self.layoutChanged.emit()

    # ------------------------------------------------------------------------------------------------ Qt's protocol

    def rowCount(self, parent: Any = None) -> int:
        """Return the rows: one of sums, one a layer along Z."""
        return self.cells.shape[1] + 1

    def columnCount(self, parent: Any = None) -> int:
        """Return the columns: one of sums, one a line."""
        return self.cells.shape[0] + 1

    def place(self, index: Any) -> Tuple[int, int]:
        """Return line and layer of a cell; -1 for sums."""
        row = index.row()
        return index.column() - 1, self.cells.shape[1] - row if row else -1

    def headerData(self, section: int, orientation: Any, role: Any = QtCore.Qt.DisplayRole) -> Any:
        """Return the numbers of lines and layers."""
        if role != QtCore.Qt.DisplayRole:
            return None
        if orientation == QtCore.Qt.Horizontal:
            return f"{self.letter} {section - 1}" if section else translate("Trabecula", "sum")
        return f"Z {self.cells.shape[1] - section}" if section else translate("Trabecula", "sum")

    def data(self, index: Any, role: Any = QtCore.Qt.DisplayRole) -> Any:
        """Return what a cell shows."""
        line, layer = self.place(index)
        if role in (QtCore.Qt.DisplayRole, QtCore.Qt.EditRole):
            return self._text(line, layer)
        if role == QtCore.Qt.TextAlignmentRole:
            return int(QtCore.Qt.AlignRight) | int(QtCore.Qt.AlignVCenter)
        if role == QtCore.Qt.BackgroundRole:
            return self._ground(line, layer)
        if role == QtCore.Qt.ForegroundRole and (self.error(line, layer) or self._is_apart(line, layer)):
            return QtGui.QBrush(QtGui.QColor("black"))
        if role == QtCore.Qt.ToolTipRole:
            return self._tip(line, layer)
        return None

    def _text(self, line: int, layer: int) -> str:
        if line >= 0 and layer >= 0:
            return str(int(self.cells[line, layer]))
        if line < 0 and layer < 0:
            return ""
        total = int(self.cells[line].sum() if layer < 0 else self.cells[:, layer].sum())
        wrong = self.error(line, layer)
        return f"{total} ≠ {wrong.asked}" if wrong and line < 0 else str(total)  # columns are narrow: their tip says it

    def error(self, line: int, layer: int) -> Any:
        """Return the rule that a cell or sum breaks, or None."""
        if line < 0 and layer < 0:
            return None
        kind = "cell" if line >= 0 and layer >= 0 else "column" if layer < 0 else "row"
        return self._wrong.get((kind, layer, line))

    def _is_apart(self, line: int, layer: int) -> bool:
        return line < 0 and layer in self._apart

    def _ground(self, line: int, layer: int) -> Any:
        if self.error(line, layer):
            return QtGui.QBrush(QtGui.QColor(_WRONG))
        if self._is_apart(line, layer):
            return QtGui.QBrush(QtGui.QColor(_APART))
        if line < 0 or layer < 0:
            paper, ink = paper_and_ink()
            return QtGui.QBrush(
                QtGui.QColor(*((9 * p + i) // 10 for p, i in zip(paper.getRgb()[:3], ink.getRgb()[:3])))
            )
        return None

    def _tip(self, line: int, layer: int) -> Any:
        wrong = self.error(line, layer)
        if wrong:
            return in_words(wrong.words)
        return translate("Trabecula", "no voxels have these sums in columns and rows") if self._is_apart(
            line, layer) else None  # fmt: skip

    def flags(self, index: Any) -> Any:
        """Return what can be done with a cell."""
        flags = QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable
        return flags | QtCore.Qt.ItemIsEditable if self.can_edit and min(self.place(index)) >= 0 else flags

    def setData(self, index: Any, value: Any, role: Any = QtCore.Qt.EditRole) -> bool:
        """Take a whole number; anything else leaves the cell as it was."""
        text = str(value).strip()
        if role != QtCore.Qt.EditRole or not text.isdigit() or len(text) > 9:
            return False
        self.cells[self.place(index)] = int(text)
        self._changed()
        return True
