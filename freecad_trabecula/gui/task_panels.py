# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD shows one task panel at a time: whether it is free, what is open, and whose turn it is."""

from __future__ import annotations

from typing import Any, List

import FreeCAD
import FreeCADGui

from ..features.relations import type_of, wireframe_of
from .qt import invoke_later
from .task_dock import lay_tasks_beside_view
from .transactions import say

translate = FreeCAD.Qt.translate


def is_free() -> bool:
    """Return whether no task panel is open; else say so in the status bar."""
    if FreeCADGui.Control.activeDialog():
        say(translate("Trabecula", "Close the open task panel first"))
        return False
    return True


_panel: List[Any] = []


def current() -> Any:
    """Return the panel that was opened last."""
    return _panel[-1]


def show_panel(panel: Any) -> None:
    """Open a task panel and remember it."""
    _panel[:] = [panel]
    FreeCADGui.Control.showDialog(panel)
    invoke_later(lay_tasks_beside_view, 200)  # once it is on the screen


def wireframes(document: Any) -> list:
    """Return the wireframes of a document, those to which the selection belongs last."""
    every = [obj for obj in document.Objects if type_of(obj) == "Trabecula::Wireframe"]
    chosen = [wireframe_of(obj) for obj in FreeCADGui.Selection.getSelection(document.Name)]
    return sorted(every, key=lambda one: one in chosen)
