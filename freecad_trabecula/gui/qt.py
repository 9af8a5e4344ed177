# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between PySide2 (FreeCAD 0.20) and PySide6 (FreeCAD 1.x), and FreeCAD's own widgets, in one place.

Widgets come from ``PySide.QtGui`` everywhere: FreeCAD 0.20 has no ``PySide.QtWidgets``.
"""

from __future__ import annotations

import re
import weakref
from pathlib import Path
from typing import Any, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from . import language  # its translations come before the first text
from .contrast import readable
from .help_pages import CONTENTS, GLOSSARY

translate = FreeCAD.Qt.translate
LEAST_TAB = 80  # pixels of a tab whose word is shortened
RESOURCES = Path(__file__).resolve().parents[2] / "resources"
MOST_DIGITS = 4  # of a length in mm that is shown; the value itself keeps all
_LESS = ("\u00b5m", "\u03bcm", "nm")  # units that FreeCAD shows below 0.1 mm
_OWN_UNIT = re.compile(r"(.*\d\s*[^\d\s.,]+\s*) mm")  # and the mm that was written behind the number before
_BARE = re.compile(r"\s*[-+]?(\d+[.,]?\d*|[.,]\d+)\s*")  # a number without a unit
_SMALL = 14  # pixels: icons of the buttons that lead to the help
Buttons = QtGui.QDialogButtonBox
FreeCADGui.addIconPath(str(RESOURCES / "icons"))


def run_dialog(dialog: Any) -> bool:
    """Show a dialog until it is closed; return whether it was accepted."""
    run = getattr(dialog, "exec", None) or dialog.exec_
    return int(run()) == 1


def flags_of(*buttons: Any) -> Any:
    """Return standard buttons as FreeCAD's task panels want them: a number up to 0.21, the flag itself since."""
    flags = buttons[0]
    for button in buttons[1:]:
        flags = flags | button
    try:
        return int(flags)
    except TypeError:  # PySide6: scoped enumerations are no numbers
        return flags


def icon_path(name: str) -> str:
    """Return the path of an icon of the workbench."""
    return str(RESOURCES / "icons" / (name + ".svg"))


def icon(name: str) -> Any:
    """Return an icon of the workbench, drawn by FreeCAD: Qt's own reader of SVG may not be installed."""
    return FreeCADGui.getIcon(name)


def is_alive(widget: Any) -> bool:
    """Return whether the C++ half of a widget still exists: FreeCAD deletes panels when a document closes."""
    try:
        widget.objectName()
    except (RuntimeError, AttributeError):  # FreeCAD puts None in the place of a closed panel's form
        return False
    return True


class PanelForm(QtGui.QWidget):
    """A task panel's form: the way to its page of the help; Return ends the typing of a value, it does not press OK.

    Parameters
    ----------
    title, picture : str
        Name of the panel, and its icon.
    page : str
        Its page of the docs.
    """

    def __init__(self, title: str, picture: str, page: str = CONTENTS) -> None:
        super().__init__()
        self.setWindowTitle(title)
        self.setWindowIcon(icon(picture))
        self.help = help_buttons(page)
        self.help.setParent(self)
        # whatever layout the form gets, the buttons have a line above it
        self.setContentsMargins(0, self.help.sizeHint().height(), 0, 0)

    def resizeEvent(self, event: Any) -> None:
        """Keep the way to the help at the upper right (Qt's protocol)."""
        super().resizeEvent(event)
        size = self.help.sizeHint()
        self.help.setGeometry(self.width() - size.width(), 0, size.width(), size.height())

    def keyPressEvent(self, event: Any) -> None:
        """Keep Return from FreeCAD's task view."""
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            event.accept()
        else:
            super().keyPressEvent(event)


def _is_new(box: Any) -> bool:
    """Return whether a wrapper is that of the box just made, not of a deleted one of a panel that somebody still holds.

    PySide keeps such a wrapper under the address of its box, and gives it for the next box there; PySide6 takes it for
    alive, all but its signals.
    """
    try:
        box.valueChanged.connect(_is_new)
        box.valueChanged.disconnect(_is_new)
    except (RuntimeError, AttributeError):
        return False
    return is_alive(box)


def quantity_box() -> Any:
    """Return FreeCAD's spin box for lengths: it takes units and formulas, and the decimal sign of the locale.

    FreeCAD shows less than 0.1 mm as micrometres, and takes a number without a unit for what it shows. Here it is one
    of mm: the unit is written behind it as soon as it is typed.
    """
    box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    while not _is_new(box):
        box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    box.setProperty("unit", "mm")
    # weak: a wrapper that outlives its deleted widget would be taken for the next one at its place in memory
    known = weakref.ref(box)

    take_both_signs(box)

    def edited(*_: Any) -> None:
        less = _shows_less(known())  # now: in a moment the box has taken what was typed
        invoke_later(lambda: _mend_unit(known(), less))

    box.findChild(QtGui.QLineEdit).textEdited.connect(edited)
    return box


def take_both_signs(box: Any) -> None:
    """Have the point and the comma that are typed into a spin box both be its decimal sign, at once and seen."""
    known = weakref.ref(box)

    def edited(text: str) -> None:
        line, mended = known().findChild(QtGui.QLineEdit), language.typed_numbers(text)
        if mended != text:
            place = line.cursorPosition() + len(mended) - len(text)
            line.setText(mended)
            line.setCursorPosition(place)

    box.findChild(QtGui.QLineEdit).textEdited.connect(edited)


def _shows_less(box: Any) -> bool:
    """Whether the length of a box, before it is edited, is shown in a smaller unit than mm."""
    if not is_alive(box):
        return False
    quantity = FreeCAD.Units.Quantity(float(box.property("rawValue") or 0.0), FreeCAD.Units.Length)
    return bool(quantity.UserString.endswith(_LESS))


def _mend_unit(box: Any, less: bool) -> None:
    """Write mm behind a number, and take it away before what is no number: a unit of the user's own, a formula."""
    if not is_alive(box):
        return
    line = box.findChild(QtGui.QLineEdit)
    text, place = line.text(), line.cursorPosition()
    own = _OWN_UNIT.fullmatch(text)
    if own or (less and _BARE.fullmatch(text)):
        line.setText(own[1] if own else text + " mm")
        line.setCursorPosition(place)


def set_length(box: Any, length: float) -> None:
    """Show a length in mm in a quantity box, with as many digits as it or a step has, at most ``MOST_DIGITS``."""
    quantity = FreeCAD.Units.Quantity(float(length), FreeCAD.Units.Length)
    step = float(box.property("singleStep") or 0.0)
    digits = max(len((f"{value:.{MOST_DIGITS}f}").rstrip("0").partition(".")[2]) for value in (length, step))
    if 0 < abs(length) < 0.1:
        digits -= 3  # FreeCAD shows micrometres
    quantity.Format = {"Precision": max(digits, 0), "NumberFormat": "f", "Denominator": 8}
    box.setProperty("value", quantity)
    box.findChild(QtGui.QLineEdit).home(False)  # the number, not the unit, is what must be seen


def small_button(name: str, tip: str, pressed: Any, text: str = "", checkable: bool = False) -> Any:
    """Return a flat button with one of our or FreeCAD's icons, or a text."""
    button = QtGui.QToolButton()
    button.setAutoRaise(True)
    if text:
        button.setText(text)
    else:
        button.setIcon(icon(name))
    button.setToolTip(tip)
    button.setCheckable(checkable)
    (button.toggled if checkable else button.clicked).connect(pressed)
    return button


class Wishes(QtCore.QObject):
    """What the window's parts wish for and do not make themselves.

    Attributes
    ----------
    page : signal
        A page of the help: ``gui/help_dock.py`` shows it.
    """

    page = QtCore.Signal(str)


WISHES = Wishes()


def help_buttons(page: str, *before: Any) -> Any:
    """Return two small buttons, behind others: a page of the docs, and the glossary."""
    widget = QtGui.QWidget()
    row = QtGui.QHBoxLayout(widget)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(0)
    for one in before:
        row.addWidget(one)
    for picture, tip, name in (
        ("Trabecula_glossary", translate("Trabecula", "Glossary: what the words mean"), GLOSSARY),
        ("Trabecula_help", translate("Trabecula", "Help: what can be done here"), page),
    ):
        button = small_button(picture, tip, lambda *_, name=name: WISHES.page.emit(name))
        button.setIconSize(QtCore.QSize(_SMALL, _SMALL))
        row.addWidget(button)
    return widget


class _TabBar(QtGui.QTabBar):
    """Tabs whose words are shortened, but not beyond what can be read."""

    def minimumTabSizeHint(self, index: int) -> Any:
        """Return the least size of a tab (Qt's protocol)."""
        size = self.tabSizeHint(index)
        return QtCore.QSize(min(size.width(), LEAST_TAB), size.height())


class Tabs(QtGui.QTabWidget):
    """Pages whose tabs' words are shortened with little room, and told by tooltips; with less two arrows move them."""

    def __init__(self) -> None:
        super().__init__()
        self.setTabBar(_TabBar())
        self.setUsesScrollButtons(True)
        self.setElideMode(QtCore.Qt.ElideRight)

    def tabInserted(self, index: int) -> None:
        """Give a new tab its tooltip (Qt's protocol)."""
        super().tabInserted(index)
        self.setTabToolTip(index, self.tabText(index))

    def setTabText(self, index: int, text: str) -> None:
        """Give a tab another word."""
        super().setTabText(index, text)
        self.setTabToolTip(index, text)


def paper_and_ink() -> Tuple[Any, Any]:
    """Return the colours of the ground and of the lines of what is painted.

    The main window knows the theme; the palette of a widget of our own holds half of it.
    """
    paper = FreeCADGui.getMainWindow().palette().color(QtGui.QPalette.Base)
    return paper, QtGui.QColor(235, 235, 235) if paper.lightness() < 128 else QtGui.QColor(25, 25, 25)


def word_colour(code: str) -> str:
    """Return a colour as light or dark as words need it in the theme of the window."""
    return readable(code, paper_and_ink()[0].getRgb()[:3])


def invoke_later(function: Any, milliseconds: int = 0) -> None:
    """Call a function when the event loop is free again."""
    QtCore.QTimer.singleShot(milliseconds, function)


def widen_dock(widget: Any, width: int) -> None:
    """Make the dock that holds a widget at least as wide as the widget needs; FreeCAD's own default is too narrow."""
    window = FreeCADGui.getMainWindow()
    # never by widget.parent(): PySide2 takes the widget for deleted when the parents' wrappers are collected
    docks = [dock for dock in window.findChildren(QtGui.QDockWidget) if dock.isAncestorOf(widget)]
    # FreeCAD 1.x may lay docks over the 3D view: those belong to no area
    docks = [dock for dock in docks if window.dockWidgetArea(dock) != QtCore.Qt.NoDockWidgetArea]
    if docks and docks[0].width() < width:
        window.resizeDocks(docks[:1], [width], QtCore.Qt.Horizontal)
