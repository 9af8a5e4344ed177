# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide: three doors at first, then the steps of one, with what is done, what is next, and what must be renewed."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..features.stages import DONE, FAILED, STALE, WORKING, Stages, stages_of
from .analysis_dock import dock_of_window
from .command import REGISTERED
from .doors import DOORS, LATER, NEXT, OPEN, Door, Marked, Seen, door_of, marked
from .example_projects import open_example
from .outcome import GREEN, RED
from .preferences import GROUP, preference
from .qt import help_buttons, icon, invoke_later, is_alive, word_colour
from .status_work import is_working
from .transactions import say, told
from .voxel_dock import voxel_dock

translate = FreeCAD.Qt.translate
_NAME, _WIDTH, _PICTURE = "TrabeculaGuideDock", 260, 48  # pixels
_PAUSE = 400  # ms between two looks at the document: it is only looked at while the guide is seen
#: Where it is kept whether the guide opens with the workbench.
AT_START = "ShowStartPanel"
_SIGNS = {DONE: "✓", NEXT: "➤", OPEN: "○", LATER: "○", STALE: "↻", WORKING: "…", FAILED: "✗"}


def opens_at_start() -> bool:
    """Return whether the guide opens when the workbench is first chosen."""
    return preference(AT_START)


class DoorCard(QtGui.QFrame):
    """Picture, title and line of a door, and two buttons: begin, or open its example."""

    def __init__(self, door: Door, begin: Any, example: Any) -> None:
        super().__init__()
        self.setFrameShape(QtGui.QFrame.StyledPanel)
        picture, words = QtGui.QLabel(), QtGui.QLabel(f"<b>{door.title}</b><br>{door.line}")
        picture.setPixmap(icon(door.picture).pixmap(_PICTURE, _PICTURE))
        picture.setAlignment(QtCore.Qt.AlignTop)
        words.setWordWrap(True)
        self.begin = QtGui.QPushButton(translate("Trabecula", "Begin"))
        self.example = QtGui.QPushButton(translate("Trabecula", "Example"))
        self.example.setToolTip(translate("Trabecula", "Open a small project of this kind, in a new document"))
        self.begin.clicked.connect(lambda *_: begin(door))
        self.example.clicked.connect(lambda *_: example(door))
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(6, 6, 6, 6)
        grid.addWidget(picture, 0, 0)
        grid.addWidget(words, 0, 1, 1, 2)
        grid.addWidget(self.begin, 1, 1)
        grid.addWidget(self.example, 1, 2)
        grid.setColumnStretch(1, 1)
        grid.setColumnStretch(2, 1)


class StepRow(QtGui.QWidget):
    """One step: its mark and title on a button, and what to do below it while it is its turn."""

    def __init__(self, run: Any) -> None:
        super().__init__()
        self.button, self.text = QtGui.QPushButton(), QtGui.QLabel()
        self.button.setStyleSheet("QPushButton { text-align: left; padding: 4px 6px; }")
        self.text.setWordWrap(True)
        self.text.setContentsMargins(24, 0, 4, 6)
        self.button.clicked.connect(lambda *_: run(self.shown))
        self.shown: Optional[Marked] = None
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(self.button)
        column.addWidget(self.text)

    def show_step(self, number: int, one: Marked) -> None:
        """Show a step and its mark."""
        self.shown = one
        self.button.setText(f"{_SIGNS[one.mark]}  {number}  {one.step.title}")
        font = self.button.font()
        font.setBold(one.mark in (NEXT, STALE, FAILED))
        self.button.setFont(font)
        self.button.setEnabled(one.mark not in (LATER, WORKING))
        self.button.setToolTip(
            translate("Trabecula", "Not now: the steps before it come first") if one.mark == LATER else one.step.text
        )
        self.text.setText(_words(one))
        self.text.setVisible(one.mark in (NEXT, STALE, WORKING, FAILED))


def _words(one: Marked) -> str:
    if one.mark == STALE:
        text, colour = translate("Trabecula", "Out of date: click to bring everything up to date."), RED
    elif one.mark == FAILED:
        text, colour = translate("Trabecula", "It could not be computed: its Status says why."), RED
    elif one.mark == WORKING:
        text, colour = translate("Trabecula", "Being computed …"), GREEN
    else:
        return one.step.text
    return f'<span style="color:{word_colour(colour)}">{text}</span>'


class GuideDock(QtGui.QDockWidget):
    """Follows the active document while it is seen."""

    def __init__(self) -> None:
        super().__init__(translate("Trabecula", "Guide"), FreeCADGui.getMainWindow())
        self.setObjectName(_NAME)
        self.setWindowIcon(icon("Trabecula_start"))
        self.rows: List[StepRow] = []
        self.cards: Dict[str, DoorCard] = {}
        self._chosen: Dict[str, str] = {}  # door by the document's Uid, where it is not that of its objects
        self._last: Any = None
        self.pages = QtGui.QStackedWidget()
        self.pages.addWidget(self._scrolled(self._make_doors()))
        self.pages.addWidget(self._scrolled(self._make_steps()))
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(help_buttons("commands/Start.md"), 0, QtCore.Qt.AlignRight)
        column.addWidget(self.pages)
        self.setWidget(page)
        self.setMinimumWidth(_WIDTH)  # beside a wide task panel its buttons were cut off
        self._clock = QtCore.QTimer(self)
        self._clock.setInterval(_PAUSE)
        self._clock.timeout.connect(self.look)
        self.visibilityChanged.connect(self._follow)

    def _make_doors(self) -> Any:
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.addWidget(QtGui.QLabel("<b>" + translate("Trabecula", "What do you want to do?") + "</b>"))
        for door in DOORS:
            self.cards[door.name] = DoorCard(door, self.begin, self.open_example)
            column.addWidget(self.cards[door.name])
        self.at_start = QtGui.QCheckBox(translate("Trabecula", "Show when Trabecula is chosen"))
        self.at_start.setChecked(opens_at_start())
        self.at_start.toggled.connect(lambda on: FreeCAD.ParamGet(GROUP).SetBool(AT_START, on))
        column.addWidget(self.at_start)
        column.addStretch(1)
        return page

    def _make_steps(self) -> Any:
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.setSpacing(3)
        self.back = QtGui.QPushButton(translate("Trabecula", "All ways to work"))
        self.back.clicked.connect(lambda *_: self.leave())
        self.title = QtGui.QLabel()
        self.title.setWordWrap(True)
        column.addWidget(self.back)
        column.addWidget(self.title)
        self._list = QtGui.QVBoxLayout()
        self._list.setSpacing(2)
        column.addLayout(self._list)
        column.addStretch(1)
        return page

    def _scrolled(self, page: Any) -> Any:
        area = QtGui.QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QtGui.QFrame.NoFrame)
        area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        area.setWidget(page)
        return area

    def sizeHint(self) -> Any:
        """Ask for room for the lines of the steps."""
        return QtCore.QSize(_WIDTH, 500)

    def open(self) -> None:
        """Show the guide at the right of the window."""
        window = FreeCADGui.getMainWindow()
        if window.dockWidgetArea(self) == QtCore.Qt.NoDockWidgetArea and not self.isFloating():
            window.setCorner(QtCore.Qt.BottomRightCorner, QtCore.Qt.RightDockWidgetArea)  # plots leave it its height
            window.addDockWidget(QtCore.Qt.RightDockWidgetArea, self)
        self.show()
        self.raise_()
        window.resizeDocks([self], [_WIDTH], QtCore.Qt.Horizontal)
        self.look()

    # -------------------------------------------------------------------------------------------------- what is shown

    def _follow(self, visible: bool) -> None:
        (self._clock.start if visible else self._clock.stop)()

    def stages(self) -> Stages:
        """Return what the active document holds."""
        document = FreeCAD.ActiveDocument
        chosen = FreeCADGui.Selection.getSelection(document.Name) if document is not None else []
        return stages_of(document, chosen)

    def door(self, stages: Stages) -> Optional[Door]:
        """Return the door of the active document: the chosen one, else that of its objects; None: all are shown."""
        mark = FreeCAD.ActiveDocument.Uid if FreeCAD.ActiveDocument is not None else ""
        wanted = self._chosen.get(mark, door_of(stages))
        return next((door for door in DOORS if door.name == wanted), None)

    def look(self) -> None:
        """Look at the document and the docks, and show what has changed."""
        if not is_alive(self):
            return
        stages = self.stages()
        door = self.door(stages)
        steps = marked(door, stages, seen_in_window()) if door is not None else []
        now = (door.name if door else "", [(one.mark, one.click and one.click[0]) for one in steps])
        if now != self._last:
            self._last = now
            self._show(door, steps)
        else:
            for row, one in zip(self.rows, steps):
                row.shown = one  # objects of the same kinds may be others

    def _show(self, door: Optional[Door], steps: List[Marked]) -> None:
        self.pages.setCurrentIndex(0 if door is None else 1)
        if door is None:
            return
        self.title.setText(f"<b>{door.title}</b>")
        while len(self.rows) < len(steps):
            self.rows.append(StepRow(self.run))
            self._list.addWidget(self.rows[-1])
        for number, row in enumerate(self.rows):
            row.setVisible(number < len(steps))
            if number < len(steps):
                row.show_step(number + 1, steps[number])

    # ----------------------------------------------------------------------------------------------------- its buttons

    def begin(self, door: Door) -> None:
        """Go through a door with the active document; a new one if there is none."""
        if FreeCAD.ActiveDocument is None:
            FreeCAD.newDocument()
        self._chosen[FreeCAD.ActiveDocument.Uid] = door.name
        self.look()

    def leave(self) -> None:
        """Show all doors; the document stays as it is."""
        if FreeCAD.ActiveDocument is not None:
            self._chosen[FreeCAD.ActiveDocument.Uid] = ""
        self.look()

    def open_example(self, door: Door) -> None:
        """Open the example of a door."""
        if is_working():
            say(translate("Trabecula", "Something is on its way already: wait, or cancel it"))
            return

        def follow(document: Any) -> None:
            if is_alive(self):
                self.look()

        with told():
            open_example(door.name, follow)

    def run(self, one: Optional[Marked]) -> None:
        """Run the command of a step with the right selection; the status bar says why if it cannot be."""
        document = FreeCAD.ActiveDocument
        if one is None or one.click is None or document is None:
            return
        name, objects = one.click
        if objects:
            FreeCADGui.Selection.clearSelection()
            for obj in objects:
                FreeCADGui.Selection.addSelection(document.Name, obj.Name)
        reason = REGISTERED[name].reason()
        if reason:
            say(translate("Trabecula", "Not now: {}").format(reason))
        else:
            FreeCADGui.runCommand(name)
        FreeCADGui.Selection.clearSelection()  # the command has read it; it would colour what is designed
        invoke_later(self.look)


def seen_in_window() -> Seen:
    """Return what the docks show."""
    plots, layers = dock_of_window(), voxel_dock()
    names: Tuple[str, ...] = tuple(obj.Name for obj in plots.ticked()) if plots.isVisible() else ()
    return Seen(names, layers.isVisible())


_docks: List[GuideDock] = []


def guide_dock() -> GuideDock:
    """Return the window's dock, made when it is first asked for."""
    if not _docks:
        _docks.append(GuideDock())
        _docks[0].hide()
    return _docks[0]


def welcome() -> None:
    """Open the guide when the workbench is chosen for the first time and nothing is there to work on."""
    is_empty = not any(document.Objects for document in FreeCAD.listDocuments().values())
    if not _docks and is_empty and opens_at_start():
        invoke_later(lambda: guide_dock().open())
