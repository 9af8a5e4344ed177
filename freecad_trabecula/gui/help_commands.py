# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command of the help."""

from __future__ import annotations

from .command import Command
from .help_dock import help_dock, show_help


class Help(Command):
    """Shows the dock of the help."""

    NAME, ICON = "Trabecula_Help", "Trabecula_help"
    TEXT, KEYS = "Help", "Y, F"
    TIP = "Show or hide the help: tutorials, commands, files, the method, the glossary. Needs nothing"

    def run(self, index: int) -> None:
        """Show or hide it."""
        if help_dock().isVisible():
            help_dock().hide()
        else:
            show_help()


#: In the order of toolbar and menu.
COMMANDS = (Help,)
