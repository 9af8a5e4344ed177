# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of changes of single sites and pores made by hand, each of which can be taken back."""

from __future__ import annotations

from typing import List, Sequence, Tuple

import FreeCAD
from PySide import QtGui

from ..core.parameters import SiteEdit
from .fields import Changed, row_widget
from .language import choice, local_number, place_text
from .qt import small_button

translate = FreeCAD.Qt.translate


class EditsList(QtGui.QWidget):
    """Changes by hand; hidden while there are none."""

    def __init__(self, changed: Changed) -> None:
        super().__init__()
        self._changed = changed
        self._edits: List[SiteEdit] = []
        self.list = QtGui.QListWidget()
        self.list.setMaximumHeight(70)
        head = row_widget()
        head.layout().addWidget(QtGui.QLabel(translate("Trabecula", "Changes by hand")), 1)
        head.layout().addWidget(
            small_button("list-remove", translate("Trabecula", "Take the chosen change back"), self._take_back)
        )
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(head)
        column.addWidget(self.list)

    def value(self) -> Tuple[SiteEdit, ...]:
        """Return the changes."""
        return tuple(self._edits)

    def set_value(self, edits: Sequence[SiteEdit]) -> None:
        """Show changes."""
        self._edits = list(edits)
        self.list.clear()
        self.list.addItems([edit_text(edit) for edit in edits])
        self.setVisible(bool(edits))

    def _take_back(self, *_: object) -> None:
        row = self.list.currentRow()
        if 0 <= row < len(self._edits):
            self.set_value(self._edits[:row] + self._edits[row + 1 :])
            self._changed()


def edit_text(edit: SiteEdit) -> str:
    """Return a change in a few words."""
    parts = [edit.site, choice(edit.action)]
    if edit.point is not None:
        parts.append(place_text(edit.point, ".3g"))
    if edit.size is not None:
        parts.append(f"{local_number(edit.size)} mm")
    return " ".join(parts)
