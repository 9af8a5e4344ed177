# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands on designs as wholes: made again as lines of Python, told in one page, made anew with other seeds."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from .. import make
from ..features.relations import type_of
from .command import Command, active_document, selected_objects
from .transactions import say

translate = FreeCAD.Qt.translate


class OfOurs(Command):
    """A command that needs something of ours in the document."""

    NEEDS = "document"

    def IsActive(self) -> bool:
        """Return whether there is something."""
        return super().IsActive() and any(type_of(obj) for obj in active_document().Objects)


class CopyScript(OfOurs):
    """Puts the Python that makes the design again onto the clipboard."""

    NAME, ICON = "Trabecula_CopyScript", "Trabecula_copy_script"
    TEXT, TIP = "Copy as script", "Copy the Python that makes the selected design, or all of the document, again"

    def run(self, index: int) -> None:
        """Write the script and copy it."""
        chosen = _chosen()
        text = make.design_as_script(chosen)
        QtGui.QApplication.clipboard().setText(text)
        lines = len(text.splitlines())
        say(translate("Trabecula", "{} lines that make {} again are on the clipboard").format(lines, chosen.Label))


def _chosen() -> Any:
    """What of ours is selected; else the document."""
    return next((obj for obj in selected_objects() if type_of(obj)), active_document())


#: In the order of toolbar and menu.
COMMANDS = (CopyScript,)
