# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a document's report in one file, with views that the window takes, and opens it."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any, Dict, Iterator, List, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..core.html_report.sections import Picture
from ..core.language import Language
from ..features.relations import products_of, type_of
from ..features.report_sections import Facts, facts_of, read_records, write_page
from ..features.tasks import write_report_task
from .aside import in_turns
from .language import choice, in_words, language
from .status_work import work_in_status_bar
from .transactions import say, told

translate = FreeCAD.Qt.translate
_SIZE = (720, 560)  # pixels
_END = object()
_PAGES = "HTML (*.html)"


def ask_and_write(document: Any) -> None:
    """Ask for a file, write the report of a document and open it."""
    name = os.path.join(os.path.dirname(document.FileName), f"{document.Name}.html")
    path, _ = QtGui.QFileDialog.getSaveFileName(
        FreeCADGui.getMainWindow(), translate("Trabecula", "Write report"), name, _PAGES
    )
    if path:
        write(document, path if path.lower().endswith((".html", ".htm")) else path + ".html")


def write(document: Any, path: str) -> None:
    """Write the report of a document and open it in the browser; what could not be told is said.

    Its views are taken first, one in each turn of the event loop; another process works out its numbers.
    """
    pictures: Dict[str, List[Picture]] = {}
    name = document.Name

    def steps() -> Iterator[None]:
        yield from views_in_turns(document, pictures)
        with told():
            found = facts_of(document)
            work_in_status_bar(
                lambda folder: write_report_task(folder, found),
                lambda folder: _write_page(found, read_records(folder), path, pictures),
            )

    in_turns(_while_open(name, steps()), 0.0)


def _write_page(found: Facts, records: Sequence[Any], path: str, pictures: Dict[str, List[Picture]]) -> None:
    notes = write_page(found, records, path, pictures, Language(language(), report_words))
    text = translate("Trabecula", "{} was written").format(path)
    say(text + "".join(f"; {in_words(note)}" for note in notes))
    QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(path))


def _while_open(name: str, steps: Iterator[None]) -> Iterator[None]:
    """The steps, as long as a document is open."""
    while name in FreeCAD.listDocuments() and next(steps, _END) is not _END:
        yield


def report_words(text: str) -> str:
    """Return a text of a report in the window's language: a word that stands in a combo box too, or what core says."""
    shown = choice(text)
    return in_words(text) if shown == text else shown


def views_in_turns(document: Any, found: Dict[str, List[Picture]]) -> Iterator[None]:
    """Take views of a document's bodies from a corner, one after the other; between two of them all is as it was.

    Parameters
    ----------
    document : App.Document
    found : dict
        Takes the views, by the name of the object of whose section they are.
    """
    for owner, body in _bodies(document):
        views = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
        if views:
            found.setdefault(owner.Name, []).append(_view_of(document, views[0], body))
            yield


def _view_of(document: Any, view: Any, body: Any) -> Picture:
    camera, shown = view.getCamera(), [(one, one.ViewObject.Visibility) for one in document.Objects]
    with tempfile.TemporaryDirectory() as folder:
        try:
            for one, _ in shown:
                one.ViewObject.Visibility = one is body or one.Name == body.Name
            view.viewIsometric()
            view.fitAll()
            path = Path(folder) / "view.png"
            view.saveImage(str(path), *_SIZE, "White")
            return Picture(body.Label, "image/png", path.read_bytes())
        finally:
            for one, visible in shown:
                one.ViewObject.Visibility = visible
            view.setCamera(camera)


def _bodies(document: Any) -> Sequence[Any]:
    """Pairs of the object whose section it is, and the body that is shown."""
    found = []
    for obj in document.Objects:
        if type_of(obj) == "Trabecula::Wireframe":
            found += [(obj, one) for one in products_of(obj) if one.UpToDate] or [(obj, obj)]
        elif type_of(obj) == "Trabecula::VoxelDesign" and obj.ResultKey:
            found.append((obj, obj))
    return found
