# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saves what the dock of slice analyses shows: tables, report and plots in a folder, written by another process."""

from __future__ import annotations

import importlib.util
from typing import Any, Callable, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..core.estimates import Work
from ..features.analysis_files import NO_PLOTS, work_of_saving
from ..features.tasks import write_saving_task
from .preferences import folder_for
from .status_work import work_in_status_bar
from .transactions import say
from .work_text import work_text

translate = FreeCAD.Qt.translate


def ask_and_save(objects: Sequence[Any]) -> None:
    """Ask for a folder and save one analysis there, or the comparison of several."""
    words, estimate = translate("Trabecula", "Folder for tables, report and plots"), work_text(work_of(objects))
    folder = QtGui.QFileDialog.getExistingDirectory(
        FreeCADGui.getMainWindow(),
        f"{words}: {estimate}" if estimate else words,
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
    plots = "png" if _draws() else NO_PLOTS
    estimate = work_text(work_of(objects))
    work_in_status_bar(lambda place: write_saving_task(place, objects, folder, plots), lambda _: done(), estimate)


def work_of(objects: Sequence[Any]) -> Work:
    """Return what it will take to save them."""
    return work_of_saving(objects, _draws())


def _draws() -> bool:
    return importlib.util.find_spec("matplotlib") is not None
