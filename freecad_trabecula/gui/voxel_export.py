# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks how a voxel design is to be written: mesh, voxels, images of the layers, with the size beforehand."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path
from typing import Any, Optional, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import make
from ..core.voxels import file_sizes
from ..core.voxels.image_stacks import KINDS as IMAGES
from ..core.voxels.image_stacks import write_stack
from ..core.voxels.volume_files import WRITERS
from ..errors import ExportError
from ..geometry.files import MESH_FORMATS
from .export_dialog import ExportDialog, ask_and_write, size_text, write_body
from .labels import file_name
from .preferences import folder_for
from .qt import run_dialog
from .transactions import say

translate = FreeCAD.Qt.translate


class VoxelExportDialog(ExportDialog):
    """Format and size; images go into a folder of their own."""

    def kinds(self, obj: Any) -> Sequence[str]:
        """Return the formats that are offered."""
        return (*MESH_FORMATS, *file_sizes.VOLUMES, *IMAGES)

    def size_of(self, obj: Any, kind: str) -> int:
        """Return about how many bytes it takes; of images all together."""
        if kind in MESH_FORMATS:
            return super().size_of(obj, kind)
        return file_sizes.estimated_size(kind, make.voxel_design_of(obj).voxels)

    def _show_size(self) -> None:
        super()._show_size()
        if not self.note.text() and self.chosen()[1] in IMAGES:
            self.note.setText(translate("Trabecula", "One image a layer along Z, in a new folder"))


def write_voxels(obj: Any, path: str) -> None:
    """Write a voxel design as mesh, NPY, NRRD or VTI, by the name's extension.

    Raises
    ------
    TrabeculaError
        If it cannot be written.
    """
    kind = Path(path).suffix[1:].lower()
    if kind in MESH_FORMATS:
        write_body(obj, path)
        return
    design = make.voxel_design_of(obj)
    WRITERS[kind](path, design.voxels, design.targets.voxel, design.targets.origin)


def write_images(obj: Any, kind: str, folder: str) -> str:
    """Write images of a design's layers into a new folder inside ``folder``, all or none; return its name.

    Raises
    ------
    TrabeculaError
        If the new folder is there already, or an image cannot be written.
    """
    design = make.voxel_design_of(obj)
    target = Path(folder) / file_name(obj, "-layers")
    if target.exists():
        raise ExportError(f"the images need a new folder, but {target} is there already")
    QtGui.QApplication.setOverrideCursor(QtGui.QCursor(QtCore.Qt.WaitCursor))
    aside = None
    try:
        aside = tempfile.mkdtemp(prefix=".layers-", dir=folder)
        write_stack(aside, design.voxels, design.targets.voxel, kind)
        os.chmod(aside, 0o755)  # mkdtemp's own is for one user alone
        os.rename(aside, target)
    except OSError as error:
        raise ExportError(f"{target} could not be written: {error.strerror or error}") from error
    finally:
        if aside is not None:
            shutil.rmtree(aside, ignore_errors=True)
        QtGui.QApplication.restoreOverrideCursor()
    return str(target)


def export_voxels(obj: Any) -> Optional[str]:
    """Ask how and where a design is to be written, and write it; return file or folder, None if it was not to be.

    Raises
    ------
    TrabeculaError
        If it cannot be written.
    """
    make.voxel_design_of(obj)  # refused before anything is asked
    window = FreeCADGui.getMainWindow()
    dialog = VoxelExportDialog(window, [obj])
    if not run_dialog(dialog):
        return None
    _, kind = dialog.chosen()
    if kind not in IMAGES:
        return ask_and_write(obj, kind, write_voxels)
    words = translate("Trabecula", "Folder for the images' folder")
    folder = QtGui.QFileDialog.getExistingDirectory(window, words, folder_for(obj.Document))
    if not folder:
        return None
    path = write_images(obj, kind, folder)
    size = sum(one.stat().st_size for one in Path(path).iterdir())
    say(translate("Trabecula", "{} was written: {}").format(path, size_text(size)))
    return path
