# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saves what the dock of slice analyses shows: tables, report and plots in a folder, written by another process."""

from __future__ import annotations

import importlib.util
from typing import Any, Callable, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..features.analysis_files import NO_PLOTS
from ..features.tasks import write_saving_task
from .preferences import folder_for
from .status_work import work_in_status_bar
from .transactions import say

translate = FreeCAD.Qt.translate


def ask_and_save(objects: Sequence[Any]) -> None:
    """Ask for a folder and save one analysis there, or the comparison of several."""
    folder = QtGui.QFileDialog.getExistingDirectory(
        FreeCADGui.getMainWindow(),
        translate("Trabecula", "Folder for tables, report and plots"),
        folder_for(FreeCAD.ActiveDocument),
    )
    if folder:
        save(objects, folder, lambda: say(translate("Trabecula", "Tables, report and plots are in {}").format(folder)))


def save(objects: Sequence[Any], folder: str, done: Callable[[], None]) -> None:
    """Save one analysis, or the comparison of several; the status bar shows how far it is and can end it.

    Parameters
    ----------
    objects : sequence of document objects
        Analyses that are up to date.
    folder : str
    done : callable
        Called when all is written.

    Raises
    ------
    TrabeculaError
        If the work cannot be started.
    """
    plots = "png" if importlib.util.find_spec("matplotlib") else NO_PLOTS
    work_in_status_bar(lambda place: write_saving_task(place, objects, folder, plots), lambda _: done())
