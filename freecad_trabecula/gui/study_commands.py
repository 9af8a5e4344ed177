# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands on designs as wholes: made again as lines of Python, told in one page, made anew with other seeds."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from .. import make
from ..features.relations import type_of, wireframe_of
from .command import Command, active_document, objects_of, selected_objects
from .report_writing import ask_and_write
from .transactions import say
from .variants_dialog import open_variants

translate = FreeCAD.Qt.translate
#: What is made again with another seed.
_SEEDED = ("Trabecula::Wireframe", "Trabecula::VoxelDesign")


class CopyScript(Command):
    """Puts the Python that makes the design again onto the clipboard."""

    NAME, ICON, NEEDS = "Trabecula_CopyScript", "Trabecula_copy_script", ("ours",)
    TEXT, KEYS = "Copy as script", "Y, Y"
    TIP = "Copy the Python that makes it again. Select a design or an analysis, or nothing for all of the document"

    def run(self, index: int) -> None:
        """Write the script and copy it."""
        chosen = _chosen()
        text = make.design_as_script(chosen)
        QtGui.QApplication.clipboard().setText(text)
        lines = len(text.splitlines())
        say(translate("Trabecula", "{} lines that make {} again are on the clipboard").format(lines, chosen.Label))


class WriteReport(Command):
    """Writes all of the document into one HTML page and opens it."""

    NAME, ICON, NEEDS = "Trabecula_WriteReport", "Trabecula_report", ("ours",)
    TEXT, KEYS = "Write report", "Y, 1"
    TIP = "Write all of the document into one HTML page and open it. Needs a scaffold, an analysis or voxels"

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        ask_and_write(active_document())


class OtherSeeds(Command):
    """Makes the design again with other seeds and lays the variants side by side."""

    NAME, ICON, NEEDS = "Trabecula_Variants", "Trabecula_variants", ("ours",)
    TEXT, KEYS = "Other seeds", "Y, 2"
    TIP = "Make the design again with 10 other seeds, side by side with their spread. Select a design or voxels"

    def reason(self) -> str:
        """Return why the command cannot be used now: seeds are those of rods and of voxels."""
        missing = (
            "" if any(map(objects_of, _SEEDED)) else translate("Trabecula", "there is no design of rods or voxels yet")
        )
        return super().reason() or missing

    def run(self, index: int) -> None:
        """Open the dialog, which begins at once."""
        open_variants(_design())


def _design() -> Any:
    """The selected design of rods or voxels, else the latest of the document."""
    chosen = [wireframe_of(obj) or obj for obj in selected_objects() if type_of(obj)]
    found = [obj for obj in chosen if type_of(obj) in _SEEDED]
    return (found or [obj for obj in active_document().Objects if type_of(obj) in _SEEDED][::-1])[0]


def _chosen() -> Any:
    """What of ours is selected; else the document."""
    return next((obj for obj in selected_objects() if type_of(obj)), active_document())


#: In the order of toolbar and menu.
COMMANDS = (CopyScript, WriteReport, OtherSeeds)
