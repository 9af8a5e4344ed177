# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens an example project with one click: computed in another process, then written into a new document."""

from __future__ import annotations

from typing import Any, Callable

import FreeCAD
import FreeCADGui

from .. import make
from ..features.tasks import write_example_task
from .status_work import work_in_status_bar
from .transactions import record, transaction

translate = FreeCAD.Qt.translate


def open_example(name: str, done: Callable[[Any], None]) -> None:
    """Open an example; the status bar shows how far it is and can end it.

    Parameters
    ----------
    name : str
        ``rods``, ``measure`` or ``voxels``.
    done : callable
        Takes the new document.

    Raises
    ------
    TrabeculaError
        If the work cannot be started.
    """
    work_in_status_bar(lambda folder: write_example_task(folder, name), lambda folder: done(_write(folder, name)))


def _write(folder: str, name: str) -> Any:
    """Everything is at hand: the document's objects find it by the keys of their inputs."""
    make.take_results(folder)
    record("import FreeCAD")
    record("from freecad_trabecula import make")
    record(f'document = FreeCAD.newDocument("Example_{name}")')
    document = FreeCAD.ActiveDocument
    with transaction(document, translate("Trabecula", "Example project")):
        record(f"make.make_example(document, {name!r})")
    for obj in document.Objects:
        if getattr(obj, "Proxy", None) is None and hasattr(obj, "Shape"):
            obj.ViewObject.Visibility = False  # the envelope: its scaffold is seen
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.viewIsometric()
    view.fitAll()
    return document
