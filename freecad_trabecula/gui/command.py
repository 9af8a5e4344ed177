# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: texts, icon, keys, why one cannot be used now, how their errors are told.

A new command is a small class with texts, what it needs (``NEEDS``) and ``run``; it is registered by standing in the
``COMMANDS`` of its module, and it is seen where ``commands.py`` places its name.
"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Tuple

import FreeCAD
import FreeCADGui

from ..features.bodies import wholes
from ..features.relations import type_of
from .qt import icon_path, invoke_later
from .transactions import record, told

translate = FreeCAD.Qt.translate


def active_document() -> Any:
    """Return the active document; None if there is none."""
    return FreeCAD.ActiveDocument


def selected_objects() -> List[Any]:
    """Return what is selected in the active document, of a PartDesign body the body itself."""
    return wholes(FreeCADGui.Selection.getSelection(FreeCAD.ActiveDocument.Name)) if FreeCAD.ActiveDocument else []


def document_or_new() -> Any:
    """Return the active document; a new one if there is none."""
    if FreeCAD.ActiveDocument is None:
        record("import FreeCAD")
        record("FreeCAD.newDocument()")
    return FreeCAD.ActiveDocument


def in_document(act: Callable[[Any], None]) -> None:
    """Do something in the active document; without one in a new one, once the window has had its turn.

    A new document with its view alone takes FreeCAD nearly 0.2 s.

    Parameters
    ----------
    act : callable
        Takes the document.
    """
    if FreeCAD.ActiveDocument is not None:
        act(FreeCAD.ActiveDocument)
        return
    name = document_or_new().Name

    def later() -> None:
        with told():
            if name in FreeCAD.listDocuments():
                act(FreeCAD.getDocument(name))

    invoke_later(later)


def objects_of(kind: str) -> List[Any]:
    """Return the objects of one of our kinds in the active document, e.g. ``Trabecula::Analysis``."""
    return [obj for obj in active_document().Objects if type_of(obj) == kind] if active_document() else []


# ------------------------------------------------------------------------------------------------ why one cannot run


def _without_panel() -> str:
    return translate("Trabecula", "close the open task panel first") if FreeCADGui.Control.activeDialog() else ""


def _with_document() -> str:
    return "" if active_document() else translate("Trabecula", "no document is open")


def _with_ours() -> str:
    document = active_document()
    found = document is not None and any(type_of(obj) for obj in document.Objects)
    return "" if found else translate("Trabecula", "nothing has been designed or analysed yet")


def _with_design() -> str:
    return "" if objects_of("Trabecula::Wireframe") else translate("Trabecula", "there is no design of rods yet")


def _with_voxels() -> str:
    return "" if objects_of("Trabecula::VoxelDesign") else translate("Trabecula", "there is no voxel design yet")


def _with_analysis() -> str:
    return "" if objects_of("Trabecula::Analysis") else translate("Trabecula", "there is no analysis yet")


#: What a command may need, by name: a function that returns what is missing, empty if nothing is. Cheap: asked often.
NEEDED: Dict[str, Callable[[], str]] = {
    "no panel": _without_panel,
    "document": _with_document,
    "ours": _with_ours,
    "design": _with_design,
    "voxels": _with_voxels,
    "analysis": _with_analysis,
}


class Command:
    """Base: texts, icon, keys, and when the command can be used.

    Attributes
    ----------
    NAME, ICON : str
        ``Trabecula_...``, and the icon's file without its ending.
    TEXT, TIP : str
        What the menu says; what it does and, in the same words for all ("Select ...", "Needs ..."), what for.
    KEYS : str
        Its keys, e.g. ``"Y, D"``: one after the other.
    NEEDS : tuple of str
        Names of ``NEEDED``, in the order in which they are missed.
    """

    NAME, ICON, TEXT, TIP, KEYS = "", "", "", "", ""
    NEEDS: Tuple[str, ...] = ()

    def GetResources(self) -> Dict[str, str]:
        """Return icon, text, tooltip and keys; FreeCAD translates the texts, with the command's name for a context."""
        resources = {"Pixmap": icon_path(self.ICON), "MenuText": self.TEXT, "ToolTip": self.TIP}
        return {**resources, "Accel": self.KEYS} if self.KEYS else resources

    def reason(self) -> str:
        """Return why the command cannot be used now, empty if it can; cheap, FreeCAD asks often."""
        return next(filter(None, (NEEDED[name]() for name in self.NEEDS)), "")

    def IsActive(self) -> bool:
        """Return whether the command can be used now; its tooltip says why not."""
        reason = self.reason()
        explain(self.NAME, reason)
        return not reason

    def Activated(self, index: int = 0) -> None:
        """Do it; errors raised on purpose are told in a dialog."""
        with told():
            self.run(index)

    def run(self, index: int) -> None:
        """Do it."""
        raise NotImplementedError


class PanelCommand(Command):
    """A command that opens a task panel: one at a time."""

    NEEDS = ("no panel",)


#: The commands by their names, once ``commands.py`` has registered them.
REGISTERED: Dict[str, Command] = {}
_explained: Dict[str, Tuple[str, str]] = {}  # tooltip without and with the reason, by the command's name


def explain(name: str, reason: str) -> None:
    """Let the tooltip and the status tip of a command say why it cannot be used; none: as they were."""
    found = FreeCADGui.Command.get(name)
    for number, action in enumerate(found.getAction() if found is not None else ()):  # a group has several
        key, present = f"{name} {number}", action.toolTip()
        plain, told_before = _explained.get(key, ("", ""))
        if present != told_before or not plain:
            plain = present  # FreeCAD's own, anew after a change of language or keys
        line = translate("Trabecula", "Not now: {}").format(reason)
        wanted = f"{plain}<p><b>{line}</b></p>" if reason else plain
        if wanted != present:
            action.setToolTip(wanted)
            action.setStatusTip(line if reason else found.getInfo()["toolTip"])
        _explained[key] = plain, wanted
