# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a document's report in one file, with views that the window takes, and opens it."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any, Dict, List, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import make
from ..core.html_report.sections import Picture
from ..core.language import Language
from ..features.relations import products_of, type_of
from .language import choice, in_words, language
from .transactions import say

translate = FreeCAD.Qt.translate
_SIZE = (720, 560)  # pixels
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

    Raises
    ------
    TrabeculaError
        If there is nothing to tell, or the file cannot be written.
    """
    notes = make.write_report(document, path, pictures=views_of(document), language=Language(language(), report_words))
    text = translate("Trabecula", "{} was written").format(path)
    say(text + "".join(f"; {in_words(note)}" for note in notes))
    QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(path))


def report_words(text: str) -> str:
    """Return a text of a report in the window's language: a word that stands in a combo box too, or what core says."""
    shown = choice(text)
    return in_words(text) if shown == text else shown


def views_of(document: Any) -> Dict[str, Sequence[Picture]]:
    """Return views of a document's bodies from a corner, by the name of the object of whose section they are."""
    views = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
    if not views:
        return {}
    found: Dict[str, List[Picture]] = {}
    view, shown = views[0], {one.Name: one.ViewObject.Visibility for one in document.Objects}
    camera = view.getCamera()
    with tempfile.TemporaryDirectory() as folder:
        try:
            for owner, body in _bodies(document):
                for one in document.Objects:
                    one.ViewObject.Visibility = one is body or one.Name == body.Name
                view.viewIsometric()
                view.fitAll()
                path = Path(folder) / "view.png"
                view.saveImage(str(path), *_SIZE, "White")
                found.setdefault(owner.Name, []).append(Picture(body.Label, "image/png", path.read_bytes()))
        finally:
            for name, visible in shown.items():
                document.getObject(name).ViewObject.Visibility = visible
            view.setCamera(camera)
    return found


def _bodies(document: Any) -> Sequence[Any]:
    """Pairs of the object whose section it is, and the body that is shown."""
    found = []
    for obj in document.Objects:
        if type_of(obj) == "Trabecula::Wireframe":
            found += [(obj, one) for one in products_of(obj) if one.UpToDate] or [(obj, obj)]
        elif type_of(obj) == "Trabecula::VoxelDesign" and obj.ResultKey:
            found.append((obj, obj))
    return found
