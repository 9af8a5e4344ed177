# SPDX-License-Identifier: LGPL-2.1-or-later
"""A quiet notice in the corner of the window: work has ended while one was elsewhere. It stays until it is seen."""

from __future__ import annotations

from typing import Any, Callable, List

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .qt import paper_and_ink, small_button, word_colour

translate = FreeCAD.Qt.translate
_MOST, _AWAY = 4, 14  # notices at once; pixels from the corner
_GOOD, _BAD = "#009E73", "#D55E00"


def is_elsewhere(document: str) -> bool:
    """Return whether the user looks at something else than a document."""
    active = FreeCAD.ActiveDocument
    return active is None or active.Name != document or not FreeCADGui.getMainWindow().isActiveWindow()


def tell_of(document: str, name: str, is_good: bool) -> None:
    """Tell that work for an object of a document has ended, if the user is elsewhere.

    Parameters
    ----------
    document, name : str
        Of the object; without one the document is named.
    is_good : bool
        False: it failed.
    """
    if document not in FreeCAD.listDocuments() or not is_elsewhere(document):
        return
    owner = FreeCAD.getDocument(document)
    obj = owner.getObject(name) if name else None
    label = f"{owner.Label}: {obj.Label}" if obj is not None else owner.Label
    words = translate("Trabecula", "{} is done") if is_good else translate("Trabecula", "{} failed")
    notices().tell(document, words.format(label), is_good, lambda: _turn_to(document, name))


def _turn_to(document: str, name: str) -> None:
    """Make a document the active one and select the object."""
    if document not in FreeCAD.listDocuments():
        return
    FreeCAD.setActiveDocument(document)
    gui = FreeCADGui.getDocument(document)
    views = gui.mdiViewsOfType("Gui::View3DInventor")
    if views:
        FreeCADGui.getMainWindow().setActiveWindow(views[0])
    if name and FreeCAD.getDocument(document).getObject(name) is not None:
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(document, name)


class Notices(QtGui.QFrame):
    """The notices that have not been seen, newest last, each with a button that leads there and one that drops it."""

    def __init__(self) -> None:
        window = FreeCADGui.getMainWindow()
        super().__init__(window)
        self.setObjectName("TrabeculaNotices")
        self.setFrameShape(QtGui.QFrame.StyledPanel)
        self.setAutoFillBackground(True)
        self._column = QtGui.QVBoxLayout(self)
        self._column.setContentsMargins(8, 4, 4, 4)
        self._rows: List[Any] = []
        window.installEventFilter(self)
        self.hide()

    def texts(self) -> List[str]:
        """Return what is told."""
        return [row.label.text() for row in self._rows]

    def tell(self, document: str, text: str, is_good: bool, show: Callable[[], None]) -> None:
        """Add a notice; the oldest goes when there are many."""
        row = _Row(document, text, is_good, show, self.drop)
        self._rows.append(row)
        self._column.addWidget(row)
        for old in self._rows[:-_MOST]:
            self.drop(old)
        paper, ink = paper_and_ink()
        palette = self.palette()
        palette.setColor(QtGui.QPalette.Window, paper)
        palette.setColor(QtGui.QPalette.WindowText, ink)
        self.setPalette(palette)
        self.show()
        self._settle()
        QtGui.QApplication.alert(FreeCADGui.getMainWindow())  # the task bar of the desktop, where there is one

    def drop(self, row: Any) -> None:
        """Take a notice away: it was seen."""
        if row in self._rows:
            self._rows.remove(row)
            self._column.removeWidget(row)
            row.hide()
            row.deleteLater()
        self.setVisible(bool(self._rows))
        self._settle()

    def forget(self, document: str) -> None:
        """Take the notices of a document away that was closed."""
        for row in [one for one in self._rows if one.document == document]:
            self.drop(row)

    def _settle(self) -> None:
        """Lie in the lower right corner, above the status bar."""
        self.adjustSize()
        window = FreeCADGui.getMainWindow()
        below = window.statusBar().height() if window.statusBar().isVisible() else 0
        self.move(window.width() - self.width() - _AWAY, window.height() - self.height() - below - _AWAY)
        self.raise_()

    def eventFilter(self, window: Any, event: Any) -> bool:
        """Stay in the corner when the window changes its size."""
        if event.type() == QtCore.QEvent.Resize and self._rows:
            self._settle()
        return False


class _Row(QtGui.QWidget):
    """One notice."""

    def __init__(
        self, document: str, text: str, is_good: bool, show: Callable[[], None], drop: Callable[[Any], None]
    ) -> None:
        super().__init__()
        self.document = document
        self.label = QtGui.QLabel(text)
        mark = QtGui.QLabel("\N{BLACK CIRCLE}")
        mark.setStyleSheet(f"color: {word_colour(_GOOD if is_good else _BAD)}")
        self.show_button = QtGui.QPushButton(translate("Trabecula", "Show"))
        self.show_button.clicked.connect(lambda *_: (drop(self), show()))
        self.close_button = small_button(
            "", translate("Trabecula", "Seen"), lambda *_: drop(self), "\N{MULTIPLICATION SIGN}"
        )
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (mark, self.label, self.show_button, self.close_button):
            row.addWidget(widget)


class _Observer:
    """Drops the notices of documents that are closed (FreeCAD's observer protocol)."""

    def slotDeletedDocument(self, document: Any) -> None:
        """Forget it."""
        if _notices:
            _notices[0].forget(document.Name)


_notices: List[Notices] = []
_observer = _Observer()
FreeCAD.addDocumentObserver(_observer)


def notices() -> Notices:
    """Return the window's notices, made when they are first asked for."""
    if not _notices:
        _notices.append(Notices())
    return _notices[0]
