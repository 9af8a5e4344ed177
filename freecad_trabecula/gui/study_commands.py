# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands on designs as wholes: made again as lines of Python, told in one page, made anew with other seeds."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from .. import make
from ..features.relations import type_of
from .command import Command, active_document, selected_objects
from .report_writing import ask_and_write
from .transactions import say

translate = FreeCAD.Qt.translate


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
    TEXT, KEYS = "Write report", "T, M"
    TIP = "Write designs, analyses, their comparison and voxels of the document into one HTML page, and open it"

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        ask_and_write(active_document())


def _chosen() -> Any:
    """What of ours is selected; else the document."""
    return next((obj for obj in selected_objects() if type_of(obj)), active_document())


#: In the order of toolbar and menu.
COMMANDS = (CopyScript, WriteReport)
