# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens an example project with one click: computed in another process, then written into a new document."""

from __future__ import annotations

from typing import Any, Callable

import FreeCAD
import FreeCADGui

from .. import make
from ..features.tasks import write_example_task
from .labels import label_document
from .qt import invoke_later
from .status_work import work_in_status_bar
from .transactions import record, told, transaction

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

    def take(folder: str) -> None:
        make.take_results(folder)
        invoke_later(write)  # between reading and showing the window has its turn

    def write() -> None:
        with told():
            done(_write(name))

    work_in_status_bar(lambda folder: write_example_task(folder, name), take)


def _write(name: str) -> Any:
    """Everything is at hand: the document's objects find it by the keys of their inputs."""
    record("import FreeCAD")
    record("from freecad_trabecula import make")
    record(f'document = FreeCAD.newDocument("Example_{name}")')
    document = FreeCAD.ActiveDocument
    label_document(document)
    with transaction(document, translate("Trabecula", "Example project")):
        record(f"make.make_example(document, {name!r})")
    for obj in document.Objects:
        if getattr(obj, "Proxy", None) is None and hasattr(obj, "Shape"):
            obj.ViewObject.Visibility = False  # the envelope: its scaffold is seen
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.viewIsometric()
    view.fitAll()
    return document
