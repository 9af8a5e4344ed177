# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picking faces and points of one body in the 3D view; gate and observer are always taken away together."""

from __future__ import annotations

from typing import Any, Callable, Optional, Tuple

import FreeCAD
import FreeCADGui

from ..features.bodies import whole
from ..features.containers import frame_of

translate = FreeCAD.Qt.translate
#: ``picked(face, point)``: FreeCAD's name of the face, and the place of the click (mm).
Picked = Callable[[str, Tuple[float, float, float]], None]


class FaceGate:
    """Lets faces of one object be selected, nothing else."""

    def __init__(self, envelope: Any) -> None:
        self._names = (envelope.Document.Name, envelope.Name)
        self._label = envelope.Label

    def allow(self, document: Any, obj: Any, sub: str) -> bool:
        """Return whether something may be selected."""
        ok = (document.Name, whole(obj).Name) == self._names and sub.split(".")[-1].startswith("Face")
        if not ok:
            self.notAllowedReason = translate("Trabecula", "Pick a face of {}").format(self._label)
        return ok


class FacePicker:
    """Calls ``picked`` for each click on a face of the envelope, from ``start`` to ``stop``."""

    def __init__(self, picked: Picked) -> None:
        self._picked = picked
        self._envelope: Optional[Any] = None

    @property
    def active(self) -> bool:
        """Whether clicks are being listened to."""
        return self._envelope is not None

    def start(self, envelope: Any) -> None:
        """Listen to clicks on faces of an object."""
        self.stop()
        FreeCADGui.Selection.clearSelection()
        self._envelope = envelope
        FreeCADGui.Selection.addSelectionGate(FaceGate(envelope))
        FreeCADGui.Selection.addObserver(self)

    def stop(self) -> None:
        """Listen no more; harmless when not started."""
        if self._envelope is None:
            return
        self._envelope = None
        FreeCADGui.Selection.removeObserver(self)
        FreeCADGui.Selection.removeSelectionGate()

    def addSelection(self, document: str, obj: str, sub: str, point: Tuple[float, float, float]) -> None:
        """Take a click (FreeCAD's observer protocol)."""
        face = sub.split(".")[-1]
        envelope = self._envelope
        if envelope is None or document != envelope.Document.Name or not face.startswith("Face"):
            return
        if whole(envelope.Document.getObject(obj)) is envelope:
            here = frame_of(envelope).inverse().multVec(FreeCAD.Vector(*point))
            self._picked(face, tuple(here))
