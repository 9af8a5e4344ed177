# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: texts, icon, when they can be used, how their errors are told."""

from __future__ import annotations

from typing import Any, Dict, List

import FreeCAD
import FreeCADGui

from ..features.relations import type_of
from .qt import icon_path
from .transactions import record, told

translate = FreeCAD.Qt.translate


def active_document() -> Any:
    """Return the active document; None if there is none."""
    return FreeCAD.ActiveDocument


def selected_objects() -> List[Any]:
    """Return what is selected in the active document."""
    return FreeCADGui.Selection.getSelection(FreeCAD.ActiveDocument.Name) if FreeCAD.ActiveDocument else []


def document_or_new() -> Any:
    """Return the active document; a new one if there is none."""
    if FreeCAD.ActiveDocument is None:
        record("import FreeCAD")
        record("FreeCAD.newDocument()")
    return FreeCAD.ActiveDocument


class Command:
    """Base: texts and icon, and when the command can be used."""

    NAME, ICON, TEXT, TIP = "", "", "", ""
    #: What must be there: nothing, a "document", or a "design".
    NEEDS = ""

    def GetResources(self) -> Dict[str, str]:
        """Return icon, text and tooltip."""
        return {
            "Pixmap": icon_path(self.ICON),
            "MenuText": translate(self.NAME, self.TEXT),
            "ToolTip": translate(self.NAME, self.TIP),
        }

    def IsActive(self) -> bool:
        """Return whether the command can be used now; cheap, FreeCAD asks often."""
        if not self.NEEDS:
            return True
        if active_document() is None:
            return False
        return self.NEEDS == "document" or any(
            type_of(obj) == "Trabecula::Wireframe" for obj in active_document().Objects
        )

    def Activated(self, index: int = 0) -> None:
        """Do it; errors raised on purpose are told in a dialog."""
        with told():
            self.run(index)

    def run(self, index: int) -> None:
        """Do it."""
        raise NotImplementedError


class PanelCommand(Command):
    """A command that opens a task panel."""

    def IsActive(self) -> bool:
        """Return whether the command can be used now: one panel at a time."""
        return not FreeCADGui.Control.activeDialog() and super().IsActive()
