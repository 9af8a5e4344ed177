# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the way in: the guide with its three doors, bodies from files, bringing all up to date."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from ..features.stages import stale_objects
from .command import Command, PanelCommand, active_document, document_or_new
from .guide_dock import guide_dock
from .renewing import renew

translate = FreeCAD.Qt.translate


class Start(Command):
    """Shows the guide."""

    NAME, ICON, KEYS = "Trabecula_Start", "Trabecula_start", "Y, G"
    TEXT, TIP = "Start", "Show or hide the guide: three ways to work, step by step, and examples. Needs nothing"

    def run(self, index: int) -> None:
        """Show or hide it."""
        dock = guide_dock()
        if dock.isVisible():
            dock.hide()
        else:
            dock.open()


class BringBody(PanelCommand):
    """Brings a body in from a file."""

    NAME, ICON, KEYS = "Trabecula_Body", "Trabecula_body", "Y, K"
    TEXT, TIP = (
        "Body from a file",
        "Bring a solid or a mesh into the document: STEP, IGES, BREP, STL, 3MF. Needs nothing",
    )

    def run(self, index: int) -> None:
        """Let FreeCAD ask for the file."""
        document_or_new()
        FreeCADGui.runCommand("Std_Import")


class Renew(Command):
    """Brings everything up to date."""

    NAME, ICON, NEEDS = "Trabecula_Renew", "Trabecula_renew", ("document",)
    TEXT, KEYS = "Bring up to date", "Y, Z"
    TIP = "Compute anew what is out of date; analyses and comparisons follow. Needs a design that was changed"

    def reason(self) -> str:
        """Return why not: there must be something out of date."""
        current = "" if stale_objects(active_document()) else translate("Trabecula", "everything is up to date")
        return super().reason() or current

    def run(self, index: int) -> None:
        """Have it computed."""
        renew(active_document())


#: In the order of toolbar and menu.
COMMANDS = (Start, BringBody, Renew)
