# SPDX-License-Identifier: LGPL-2.1-or-later
"""One command, one step to undo; an error is one dialog with its sentence, and nothing has changed."""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Iterator

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..errors import Cancelled, DependencyError, TrabeculaError
from .labels import label_new, names_in
from .language import in_words

translate = FreeCAD.Qt.translate


@contextmanager
def transaction(document: Any, name: str) -> Iterator[None]:
    """Make what happens inside one step to undo; an error takes all of it back and goes on.

    What was made gets its labels in the language of the window.
    """
    before = names_in(document)
    document.openTransaction(name)
    try:
        yield
        label_new(document, before)
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()


@contextmanager
def told() -> Iterator[None]:
    """Show errors raised on purpose in a dialog; others go on to the report view."""
    try:
        yield
    except Cancelled:
        return
    except DependencyError as error:
        from .install import offer_installation

        offer_installation(in_words(str(error)))
    except TrabeculaError as error:
        show_error(in_words(str(error)))


def show_error(text: str) -> None:
    """Show an error's sentence."""
    QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), translate("Trabecula", "Trabecula"), text)


def say(text: str) -> None:
    """Show a short notice in the status bar."""
    FreeCADGui.getMainWindow().statusBar().showMessage(text, 8000)


def record(text: str) -> None:
    """Run a line of Python as if typed, so that a macro records it.

    Raises
    ------
    TrabeculaError
        Whatever the line raises.
    """
    FreeCADGui.doCommand(text)
