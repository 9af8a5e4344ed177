# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes from files and from document objects, read and checked in another process."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any, Optional

import Mesh
import Part
from PySide import QtCore

from ..features import results
from ..features.packing import read_value
from ..geometry.fingerprints import fingerprint
from .child_work import ChildWork
from .envelope_child import ENVELOPE, SHAPE

_MESH = "mesh.ply"
_MODULE = "freecad_trabecula.gui.envelope_child"


class EnvelopeSource(QtCore.QObject):
    """Asks for one envelope at a time; a later question replaces an earlier one."""

    #: A ``geometry.envelopes.Envelope``.
    ready = QtCore.Signal(object)
    refused = QtCore.Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._work: Optional[ChildWork] = None

    def load(self, file: str, solid: str) -> None:
        """Read a file.

        Raises
        ------
        DependencyError
            If FreeCAD's console program is not found.
        """
        self._start(file, solid, None)

    def check(self, shape: Part.Shape) -> None:
        """Check a shape; its envelope is kept where ``features.envelope`` finds it.

        Raises
        ------
        DependencyError
            If FreeCAD's console program is not found.
        """
        self._start("", "", shape)

    def convert(self, mesh: Mesh.Mesh) -> None:
        """Make a solid of a closed mesh.

        Raises
        ------
        DependencyError
            If FreeCAD's console program is not found.
        """
        self._start("", "", None, mesh)

    def cancel(self) -> None:
        """Ask no more."""
        if self._work is not None:
            self._work.cancel()
            self._work = None

    def _start(self, file: str, solid: str, shape: Optional[Part.Shape], mesh: Optional[Mesh.Mesh] = None) -> None:
        self.cancel()
        folder = tempfile.mkdtemp(prefix="trabecula-")
        if shape is not None:
            shape.exportBinary(str(Path(folder) / SHAPE))
        if mesh is not None:
            file = str(Path(folder) / _MESH)
            mesh.write(file)
        mark = fingerprint(shape) if shape is not None else ""
        work = ChildWork(_MODULE, {"folder": folder, "file": file, "solid": solid}, folder)
        work.succeeded.connect(lambda place: self._take(place, mark))
        work.failed.connect(self._fail)
        self._work = work
        work.start()

    def _take(self, folder: str, mark: str) -> None:
        self._work = None
        envelope = read_value(Path(folder) / ENVELOPE)
        if mark:
            results.keep("envelope", mark, envelope)
        self.ready.emit(envelope)

    def _fail(self, text: str) -> None:
        self._work = None
        self.refused.emit(text)


def is_known(shape: Any) -> bool:
    """Return whether the envelope of a shape has been checked already."""
    return results.find("envelope", fingerprint(shape)) is not None
