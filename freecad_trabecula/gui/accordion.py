# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections one below the other, of which one is open; each header says in a few words what is inside."""

from __future__ import annotations

from typing import Any, List, Tuple

import FreeCADGui
from PySide import QtCore, QtGui

from .qt import icon, is_alive


class Accordion(QtGui.QWidget):
    """Headers with pages; a click on a header opens its page and closes the others, a second click closes it."""

    def __init__(self, *sections: Tuple[str, str, Any]) -> None:
        """Take sections as (title, name of an icon, page)."""
        super().__init__()
        self._pages: List[Tuple[Any, Any, str]] = []
        self._column = QtGui.QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(2)
        for title, picture, page in sections:
            self.add(title, icon("Trabecula_" + picture), page)

    def add(self, title: str, picture: Any, page: Any) -> None:
        """Add a section; the first one is open."""
        number = len(self._pages)
        header = QtGui.QPushButton()
        header.setToolTip(title)
        header.setIcon(picture)
        header.setStyleSheet("QPushButton { text-align: left; padding: 2px 6px; }")
        header.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
        header.clicked.connect(lambda *_: self.open(-1 if self.opened() == number else number))
        holder = QtGui.QWidget()
        inside = QtGui.QVBoxLayout(holder)
        inside.setContentsMargins(8, 4, 2, 6)
        inside.addWidget(page)
        self._pages.append((header, holder, title))
        self._column.addWidget(header)
        self._column.addWidget(holder)
        self.open(0)

    def open(self, number: int) -> None:
        """Open one section; -1 closes all."""
        for k, (_, page, _) in enumerate(self._pages):
            page.setVisible(k == number)
            self._write(k)
        if number >= 0:
            QtCore.QTimer.singleShot(0, lambda: self._scroll_to(number))

    def _scroll_to(self, number: int) -> None:
        """Move a section into sight once it has got its size; its header first."""
        if not is_alive(self):
            return
        header, page, _ = self._pages[number]
        # never by parentWidget(): PySide2 takes widgets for deleted when their parents' wrappers are collected
        for area in FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea):
            if area.isAncestorOf(self):
                for widget in (page, header):
                    area.ensureWidgetVisible(widget, 0, 4)

    def opened(self) -> int:
        """Return the open section, -1 if none is."""
        return next((k for k, (header, page, _) in enumerate(self._pages) if not page.isHidden()), -1)

    def set_summary(self, number: int, text: str) -> None:
        """Show what a section holds, beside its title."""
        header, page, title = self._pages[number]
        header.setToolTip(f"{title}:  {text}" if text else title)
        self._write(number)

    def _write(self, number: int) -> None:
        """Write a header: an arrow, which themes colour as they do all texts, and what is inside."""
        header, page, _ = self._pages[number]
        words = ("▸ " if page.isHidden() else "▾ ") + header.toolTip()
        room = max(header.width(), 200) - 40
        header.setText(header.fontMetrics().elidedText(words, QtCore.Qt.ElideRight, room))
