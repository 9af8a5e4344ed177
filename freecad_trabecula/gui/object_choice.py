# SPDX-License-Identifier: LGPL-2.1-or-later
"""A list of objects of the document, of which one is chosen, or a file in its place."""

from __future__ import annotations

from typing import Any, Sequence

from PySide import QtGui


class ObjectChoice(QtGui.QComboBox):
    """Labels of objects; a file stands below them."""

    def __init__(self) -> None:
        super().__init__()
        self._file = ""
        self.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)

    def offer(self, objects: Sequence[Any], none: str = "") -> None:
        """Offer objects; ``none`` are the words for no object, which stands first."""
        self.clear()
        if none:
            self.addItem(none, "")
        for obj in objects:
            self.addItem(obj.Label, obj.Name)

    def choose(self, obj: Any) -> None:
        """Choose an object; None is no object."""
        self.setCurrentIndex(max(self.findData(obj.Name if obj is not None else ""), 0))

    def set_file(self, path: str) -> None:
        """Choose a file."""
        self._file = path
        place = self.findData("")
        if place < 0:
            self.addItem("", "")
            place = self.count() - 1
        self.setItemText(place, path.replace("\\", "/").rsplit("/", 1)[-1])
        self.setItemData(place, "")
        self.setCurrentIndex(place)

    def object_name(self) -> str:
        """Return the name of the chosen object; empty for a file or none."""
        return str(self.currentData() or "")

    def file(self) -> str:
        """Return the path of the chosen file; empty for an object."""
        return "" if self.object_name() else self._file
