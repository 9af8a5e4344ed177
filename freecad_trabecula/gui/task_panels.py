# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD shows one task panel at a time: whether it is free, what is open; and what all panels have in common.

A panel can be closed in four ways: by its own buttons, with its document, with its object, and by whoever calls
``FreeCADGui.Control.closeDialog()``, of which FreeCAD tells the panel nothing but that its form is destroyed. Whichever
it is, ``let_go`` is called once, and what workers, timers and FreeCAD say afterwards is not heard any more.
"""

from __future__ import annotations

import functools
from typing import Any, Callable, List, Sequence

import FreeCAD
import FreeCADGui

from ..features.relations import type_of, wireframe_of
from .qt import Buttons, flags_of, invoke_later, is_alive, widen_dock
from .task_dock import lay_tasks_beside_view, note_tree, show_tree_again
from .transactions import say

translate = FreeCAD.Qt.translate
_PAUSE = 100  # ms after a panel's end in which the next one may open


def is_free() -> bool:
    """Return whether no task panel is open; else say so in the status bar."""
    if FreeCADGui.Control.activeDialog():
        say(translate("Trabecula", "Close the open task panel first"))
        return False
    return True


def while_open(method: Callable[..., None]) -> Callable[..., None]:
    """Decorate what a panel does when others tell it something: nothing once it is closed."""

    @functools.wraps(method)
    def heard(self: Any, *values: Any) -> None:
        if self.is_open:
            method(self, *values)

    return heard


class DocumentPanel:
    """Base of the task panels: it belongs to one document and ends with it.

    Parameters
    ----------
    document : App.Document
    width : int, pixels
        That the form needs.

    Attributes
    ----------
    form : QWidget
        What FreeCAD shows.
    is_open : bool
        From ``begin`` until it is closed, in whatever way.
    """

    #: What stands above the form.
    BUTTONS: Sequence[Any] = (Buttons.Close,)
    form: Any = None

    def __init__(self, document: Any, width: int) -> None:
        self.document, self.document_name, self.is_open = document, document.Name, True
        self._width = width

    def begin(self) -> None:
        """Follow the document and the form, which is there by now."""
        form = self.form  # FreeCAD takes it from the panel in the end
        form.destroyed.connect(self._form_destroyed)
        FreeCAD.addDocumentObserver(self)
        invoke_later(lambda: widen_dock(form, self._width) if is_alive(form) else None)

    def let_go(self, has_document: bool) -> None:
        """Give back what the panel holds; its widgets may be gone. Called once, when it is not open any more.

        Parameters
        ----------
        has_document : bool
            False: the document is being closed.
        """

    def objects(self) -> Sequence[Any]:
        """Return the objects without which the panel has no sense."""
        return ()

    def close(self) -> None:
        """Close the panel; nothing else that is open by now."""
        self._leave()
        if is_alive(self.form):
            FreeCADGui.Control.closeDialog()

    def _leave(self, has_document: bool = True) -> None:
        if self.is_open:
            self.is_open = False
            FreeCAD.removeDocumentObserver(self)
            self.let_go(has_document)
            invoke_later(show_tree_again, _PAUSE)

    def _form_destroyed(self, *_: Any) -> None:
        self._leave(self.document_name in FreeCAD.listDocuments())

    # ------------------------------------------------------------------------------------------- FreeCAD's protocols

    def getStandardButtons(self) -> Any:
        """Return the buttons above the form."""
        return flags_of(*self.BUTTONS)

    def reject(self) -> bool:
        """Close the panel."""
        self.close()
        return True

    def slotDeletedDocument(self, document: Any) -> None:
        """Close the panel when its document is closed (FreeCAD's observer protocol)."""
        if self.is_open and document.Name == self.document_name:
            self._leave(False)
            invoke_later(lambda: self.close())

    def slotDeletedObject(self, obj: Any) -> None:
        """Close the panel when its object goes, by undo for instance (FreeCAD's observer protocol)."""
        if self.is_open and obj in self.objects():
            self._leave()
            invoke_later(lambda: self.close())


_panel: List[Any] = []


def current() -> Any:
    """Return the panel that was opened last."""
    return _panel[-1]


def show_panel(panel: Any) -> None:
    """Open a task panel and remember it."""
    _panel[:] = [panel]
    note_tree()
    FreeCADGui.Control.showDialog(panel)
    invoke_later(lay_tasks_beside_view, 200)  # once it is on the screen


def wireframes(document: Any) -> list:
    """Return the wireframes of a document, those to which the selection belongs last."""
    every = [obj for obj in document.Objects if type_of(obj) == "Trabecula::Wireframe"]
    chosen = [wireframe_of(obj) for obj in FreeCADGui.Selection.getSelection(document.Name)]
    return sorted(every, key=lambda one: one in chosen)
