# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables to be read."""

from __future__ import annotations

from typing import Any, Sequence

from PySide import QtCore, QtGui

_ROW, _MOST_ROWS = 20, 22  # pixels of a table's row, rows that are seen at once
_MOST_PIXELS = 16777215  # Qt's QWIDGETSIZE_MAX


def table(columns: int) -> Any:
    """Return a table to be read."""
    widget = QtGui.QTableWidget(0, columns)
    widget.verticalHeader().hide()
    widget.verticalHeader().setDefaultSectionSize(_ROW)
    header = widget.horizontalHeader()
    header.setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
    header.setSectionResizeMode(0, QtGui.QHeaderView.Stretch)
    widget.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
    widget.setSelectionMode(QtGui.QAbstractItemView.NoSelection)
    widget.setTextElideMode(QtCore.Qt.ElideRight)
    widget.setWordWrap(False)
    widget.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAsNeeded)
    return widget


def fill(widget: Any, names: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Show rows of texts in a table."""
    widget.setHorizontalHeaderLabels(list(names))
    widget.setRowCount(len(rows))
    for number, row in enumerate(rows):
        for column, text in enumerate(row):
            item = QtGui.QTableWidgetItem(text)
            item.setToolTip(text)
            if column:
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            widget.setItem(number, column, item)
    height = widget.horizontalHeader().sizeHint().height() + (len(rows) + 1) * _ROW
    widget.setFixedHeight(min(height, _MOST_ROWS * _ROW))


def let_grow(widget: Any) -> None:
    """Give a table the height of its place, not that of all its rows."""
    widget.setMinimumHeight(0)
    widget.setMaximumHeight(_MOST_PIXELS)
