# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why a number is what it is: a click on its row tells formula, source, second route and the values by both routes."""

from __future__ import annotations

import re
from html import escape
from typing import Any, Callable, List, Sequence

import FreeCAD
from PySide import QtCore, QtGui

from ..core.explanations.registry import explanation
from ..errors import TrabeculaError
from .figures import with_powers
from .language import in_words
from .qt import paper_and_ink

translate = FreeCAD.Qt.translate
WIDTH = 430  # pixels
_SIGN = "?"
_DOI = re.compile(r"DOI (10\.\d{4,9}/[^\s;,]+)")
#: ``found(key)`` gives both values of a number and their difference as sentences.
Found = Callable[[str], Sequence[str]]


def nothing_found(key: str) -> Sequence[str]:
    """Return no values: what is asked about is no object of a document."""
    return ()


def why_html(keys: Sequence[str], found: Found = nothing_found) -> str:
    """Return the explanations of numbers as HTML."""
    words = {
        "number": translate("Trabecula", "Number"),
        "formula": translate("Trabecula", "Formula"),
        "source": translate("Trabecula", "Source"),
        "second route": translate("Trabecula", "Second route"),
        "both routes": translate("Trabecula", "Both routes"),
    }
    parts = []
    for key in keys:
        rows = explanation(key).rows(_found(found, key), in_words)
        parts.append(f"<p><b>{_text(rows[0][1])}</b></p><table cellspacing='3'>")
        parts += [
            f"<tr><td style='color:gray'>{words[word]}&nbsp;</td><td>{_text(text)}</td></tr>" for word, text in rows[1:]
        ]
        parts.append("</table>")
    return "".join(parts)


def _found(found: Found, key: str) -> Sequence[str]:
    try:
        return found(key)
    except TrabeculaError as error:  # an object that is being computed has no values yet
        return [str(error)]


def _text(text: str) -> str:
    return _DOI.sub(r'<a href="https://doi.org/\1">DOI \1</a>', escape(with_powers(text)))


class WhyPopup(QtGui.QLabel):
    """A text beside the mouse that goes with the next click elsewhere."""

    def __init__(self, text: str, parent: Any) -> None:
        super().__init__(text, parent)
        self.setWindowFlags(QtCore.Qt.Popup)
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.setTextFormat(QtCore.Qt.RichText)
        self.setTextInteractionFlags(QtCore.Qt.TextBrowserInteraction)
        self.setOpenExternalLinks(True)
        self.setWordWrap(True)
        self.setMargin(10)
        # a dark theme's letters are light, and a label has no ground of its own
        paper, ink = (colour.name() for colour in paper_and_ink())
        self.setStyleSheet(f"QLabel {{ background: {paper}; color: {ink}; border: 1px solid {ink}; }}")
        self.setFixedWidth(WIDTH)
        self.setFixedHeight(self.heightForWidth(WIDTH))

    def show_at(self, point: Any) -> None:
        """Show it near a point of the screen, whole."""
        screen = QtGui.QGuiApplication.screenAt(point) or QtGui.QGuiApplication.primaryScreen()
        room = screen.availableGeometry()
        x = max(min(point.x(), room.right() - self.width()), room.left())
        y = max(min(point.y(), room.bottom() - self.height()), room.top())
        self.move(x, y)
        self.show()


def tell(keys: Sequence[str], found: Found, widget: Any, point: Any) -> WhyPopup:
    """Tell why numbers are what they are, at a point of a widget; return what is shown."""
    popup = WhyPopup(why_html(keys, found), widget)
    popup.show_at(widget.mapToGlobal(point))
    return popup


class WhyTable(QtCore.QObject):
    """Makes the rows of a table tell why: a click on one, or on the sign in its last column.

    Parameters
    ----------
    table : QTableWidget
    found : callable
        See ``Found``.
    """

    def __init__(self, table: Any, found: Found = nothing_found) -> None:
        super().__init__(table)
        self.table, self.found, self.keys = table, found, []  # type: ignore[var-annotated]
        table.cellClicked.connect(lambda row, column: self.tell(row))

    def set_keys(self, keys: Sequence[str]) -> None:
        """Say which numbers each row has, parted by spaces, and put the sign into the last column; "" has none."""
        self.keys: List[str] = list(keys)
        last = self.table.columnCount() - 1
        for row, key in enumerate(self.keys):
            item = QtGui.QTableWidgetItem(_SIGN if key else "")
            item.setTextAlignment(QtCore.Qt.AlignCenter)
            item.setToolTip(translate("Trabecula", "Why? Formula, source, second route") if key else "")
            self.table.setItem(row, last, item)

    def tell(self, row: int) -> Any:
        """Tell why the number of a row is what it is."""
        if not (0 <= row < len(self.keys) and self.keys[row]):
            return None
        where = self.table.visualItemRect(self.table.item(row, 0)).bottomLeft()
        return tell(self.keys[row].split(), self.found, self.table.viewport(), where)


class WhyButton(QtGui.QToolButton):
    """A small button that tells why the numbers beside it are what they are.

    Parameters
    ----------
    keys : callable
        Gives the keys of the numbers that are shown now.
    found : callable
        See ``Found``.
    """

    def __init__(self, keys: Callable[[], Sequence[str]], found: Found = nothing_found) -> None:
        super().__init__()
        self.keys, self.found = keys, found
        self.setText(_SIGN)
        self.setAutoRaise(True)
        self.setToolTip(translate("Trabecula", "Why? Formula, source, second route"))
        self.clicked.connect(lambda *_: self.tell())

    def tell(self) -> Any:
        """Tell."""
        return tell(self.keys(), self.found, self, self.rect().bottomLeft()) if self.keys() else None
