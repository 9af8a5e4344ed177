# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture of the 3D view in saved files, where FreeCAD puts none: up to 0.21 it does so only if asked to.

FreeCAD's preference ("Save thumbnail") is not changed; who has switched it off gets none from us either.
"""

from __future__ import annotations

import shutil
import tempfile
import zipfile
from pathlib import Path
from typing import Any, List

import FreeCAD
import FreeCADGui

from ..errors import ExportError
from ..features.relations import type_of
from ..geometry.files import replacing

ENTRY = "thumbnails/Thumbnail.png"  # where FreeCAD and desktops look for it
_EDGE = 128  # pixels


def is_unwanted() -> bool:
    """Return whether the user has switched pictures off in FreeCAD's preferences."""
    chosen = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document").GetContents() or ()
    return ("Boolean", "SaveThumbnail", False) in [tuple(one) for one in chosen]


def add_thumbnail(document: Any, path: str) -> bool:
    """Put a picture of a document's view into its file, if it holds something of ours and no picture yet.

    Returns
    -------
    bool
        Whether there was something to be done.

    Raises
    ------
    ExportError
        If the file cannot be written; it is as it was.
    """
    views = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
    if not views or is_unwanted() or not any(type_of(obj) for obj in document.Objects):
        return False
    with zipfile.ZipFile(path) as archive:
        if ENTRY in archive.namelist():
            return False
    with tempfile.TemporaryDirectory(prefix="trabecula-") as folder:
        picture = Path(folder) / "view.png"
        views[0].saveImage(str(picture), _EDGE, _EDGE, "Current")
        with replacing(path) as part:
            shutil.copy(path, part)
            with zipfile.ZipFile(part, "a") as archive:
                archive.write(str(picture), ENTRY)
    return True


class SaveObserver:
    """Adds the picture when a document has been saved (FreeCAD's observer protocol)."""

    def slotFinishSaveDocument(self, document: Any, path: str) -> None:
        """Add it; a file that cannot be written keeps what FreeCAD wrote."""
        try:
            add_thumbnail(document, path)
        except (ExportError, OSError, zipfile.BadZipFile) as error:
            FreeCAD.Console.PrintLog(f"no picture in {path}: {error}\n")


_observers: List[SaveObserver] = []


def add_pictures_to_files() -> None:
    """Have pictures added from now on."""
    if not _observers:
        _observers.append(SaveObserver())
        FreeCAD.addDocumentObserver(_observers[0])
