# SPDX-License-Identifier: LGPL-2.1-or-later
"""The help: a dock that shows the pages of ``docs``, with links, pictures, a way back, and a search."""

from __future__ import annotations

from pathlib import Path
from typing import Any, List

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .help_pages import CONTENTS, DOCS, GLOSSARY, column_shares, page_in, page_of_hits, slug
from .language import language
from .qt import WISHES, icon, small_button

translate = FreeCAD.Qt.translate
_NAME = "TrabeculaHelpDock"
WIDTH = 620  # pixels at which a page can be read
_BELOW = 90  # pixels below the window's upper edge: menus and toolbars stay free
_MARGIN, _PADDING = 10, 4  # pixels around a page, and within the cells of its tables
_SEARCH = "search.md"  # the page that is made of what a search found
_WAIT = 150  # ms after which a new width counts: pictures are scaled anew


class PageView(QtGui.QTextBrowser):
    """Shows pages; pictures are as wide as the view, links to headings lead to them."""

    def __init__(self) -> None:
        super().__init__()
        self.setOpenExternalLinks(True)
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOn)  # the width stays, whatever the page's length
        self.document().setDocumentMargin(_MARGIN)
        self.sourceChanged.connect(self._dress)
        self._wait = QtCore.QTimer(self)
        self._wait.setSingleShot(True)
        self._wait.timeout.connect(self._fit_pictures)

    def show_page(self, page: str) -> None:
        """Show a page of the docs, ``page.md`` or ``page.md#heading``, or what a search found."""
        name, _, heading = page.partition("#")
        url = QtCore.QUrl.fromLocalFile(str(DOCS / name))
        if heading:
            url.setFragment(heading)
        self.setSource(url)

    def search(self, words: str) -> None:
        """Show the passages of all pages in which the words stand."""
        url = QtCore.QUrl.fromLocalFile(str(DOCS / _SEARCH))
        url.setQuery(words)
        self.setSource(url)

    def page(self) -> str:
        """Return the path of the page that is shown."""
        return str(self.source().toLocalFile())

    # --------------------------------------------------------------------------------------------------- Qt's calls

    def loadResource(self, kind: Any, url: Any) -> Any:
        """Return a page's text or a picture (Qt's protocol)."""
        if url.fileName() == _SEARCH:
            words = url.query(QtCore.QUrl.FullyDecoded)
            return page_of_hits(
                words,
                translate("Trabecula", "Search: {}").format(words),
                translate("Trabecula", "Nothing was found."),
            )
        # Pictures in a page have no scheme: they are beside it.
        path = self.source().resolved(url).toLocalFile()
        if url.fileName().lower().endswith((".png", ".svg")):
            return self._picture(path)
        if path.endswith(".md") and DOCS in Path(path).parents:
            url = QtCore.QUrl.fromLocalFile(str(DOCS / page_in(language(), Path(path).relative_to(DOCS).as_posix())))
        return super().loadResource(kind, url)

    def _picture(self, path: str) -> Any:
        if path.endswith(".svg"):
            from PySide import QtSvg

            image = QtGui.QImage(32, 32, QtGui.QImage.Format_ARGB32)
            image.fill(0)
            painter = QtGui.QPainter(image)
            QtSvg.QSvgRenderer(path).render(painter)
            painter.end()
            return image
        image, width = QtGui.QImage(path), max(self.viewport().width() - 2 * _MARGIN - 4, 100)
        return image.scaledToWidth(width, QtCore.Qt.SmoothTransformation) if image.width() > width else image

    def resizeEvent(self, event: Any) -> None:
        """Scale pictures to the new width, a moment later (Qt's protocol)."""
        super().resizeEvent(event)
        if not self.source().isEmpty() and event.oldSize().width() != event.size().width():
            self._wait.start(_WAIT)

    def _fit_pictures(self) -> None:
        place = self.verticalScrollBar().value()
        self.reload()
        self.verticalScrollBar().setValue(place)

    # ------------------------------------------------------------------------------------------------------ the page

    def _dress(self, url: Any) -> None:
        """Give the page's tables a frame, and go to the heading that the link named."""
        for table in self.document().rootFrame().childFrames():
            if isinstance(table, QtGui.QTextTable):
                table.setFormat(_framed(table, self.palette().mid()))
        if url.fileName() != _SEARCH and url.hasFragment():
            self._go_to(url.fragment())

    def _go_to(self, heading: str) -> None:
        block = self.document().begin()
        while block.isValid():
            if block.blockFormat().headingLevel() and slug(block.text()) == heading:
                self.setTextCursor(QtGui.QTextCursor(block))
                top = self.document().documentLayout().blockBoundingRect(block).top()
                self.verticalScrollBar().setValue(int(top))
                return
            block = block.next()


def _framed(table: Any, brush: Any) -> Any:
    """Return a table's format with lines, and columns as wide as their texts want them."""
    form = table.format()
    form.setBorder(1)
    form.setCellSpacing(0)
    form.setCellPadding(_PADDING)
    form.setBorderBrush(brush)
    form.setBorderStyle(QtGui.QTextFrameFormat.BorderStyle_Solid)
    form.setBorderCollapse(True)
    form.setWidth(QtGui.QTextLength(QtGui.QTextLength.PercentageLength, 99))
    texts = [
        [_cell_text(table.cellAt(row, column)) for row in range(table.rows())] for column in range(table.columns())
    ]
    wanted = column_shares(texts)
    form.setColumnWidthConstraints(
        [QtGui.QTextLength(QtGui.QTextLength.PercentageLength, 100 * share) for share in wanted]
    )
    return form


def _cell_text(cell: Any) -> str:
    cursor = cell.firstCursorPosition()
    cursor.setPosition(cell.lastCursorPosition().position(), QtGui.QTextCursor.KeepAnchor)
    return str(cursor.selectedText())


class HelpDock(QtGui.QDockWidget):
    """The dock: ways through the pages, a search, the page. It floats at first: pages want room."""

    def __init__(self) -> None:
        super().__init__(translate("Trabecula", "Trabecula help"), FreeCADGui.getMainWindow())
        self.setObjectName(_NAME)
        self.setWindowIcon(icon("Trabecula_help"))
        self.view, self.words = PageView(), QtGui.QLineEdit()
        self.words.setPlaceholderText(translate("Trabecula", "Search all pages"))
        self.words.setClearButtonEnabled(True)
        self.words.returnPressed.connect(lambda: self.view.search(self.words.text()) if self.words.text() else None)
        bar, page = QtGui.QHBoxLayout(), QtGui.QWidget()
        back = small_button("button_left", translate("Trabecula", "Back"), lambda *_: self.view.backward())
        forward = small_button("button_right", translate("Trabecula", "Forward"), lambda *_: self.view.forward())
        for button, signal in ((back, self.view.backwardAvailable), (forward, self.view.forwardAvailable)):
            button.setEnabled(False)
            signal.connect(button.setEnabled)
            bar.addWidget(button)
        for picture, tip, name in (
            ("Trabecula_help", translate("Trabecula", "Contents"), CONTENTS),
            ("Trabecula_glossary", translate("Trabecula", "Glossary"), GLOSSARY),
        ):
            bar.addWidget(small_button(picture, tip, lambda *_, name=name: self.view.show_page(name)))
        bar.addWidget(self.words, 1)
        column = QtGui.QVBoxLayout(page)
        column.setContentsMargins(2, 2, 2, 2)
        column.setSpacing(2)
        column.addLayout(bar)
        column.addWidget(self.view, 1)
        self.setWidget(page)


_docks: List[HelpDock] = []


def help_dock() -> HelpDock:
    """Return the window's dock, made when it is first asked for."""
    if not _docks:
        _docks.append(HelpDock())
        window = FreeCADGui.getMainWindow()
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, _docks[0])
        _docks[0].setFloating(True)
        place = window.geometry().intersected(QtGui.QGuiApplication.primaryScreen().availableGeometry())
        size = QtCore.QSize(min(WIDTH, place.width()), place.height() * 3 // 4)
        _docks[0].setGeometry(QtCore.QRect(place.topRight() - QtCore.QPoint(size.width(), -_BELOW), size))
    return _docks[0]


def show_help(page: str = CONTENTS) -> HelpDock:
    """Show a page of the docs: ``page.md`` or ``page.md#heading``."""
    dock = help_dock()
    dock.show()
    dock.raise_()
    dock.view.show_page(page)
    return dock


WISHES.page.connect(show_help)
