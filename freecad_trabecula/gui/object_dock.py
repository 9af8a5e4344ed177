# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of docks that show objects of the active document: they follow it while they are seen."""

from __future__ import annotations

from typing import Any, List, Optional

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ..features.containers import seen_at
from ..features.relations import type_of
from .qt import icon
from .slice_view import SlicePlane

HEIGHT = 330  # pixels at which diagrams can be read


class ObjectDock(QtGui.QDockWidget):
    """Follows objects of one kind, and shows a plane in the 3D view.

    Parameters
    ----------
    kind : str
        ``Type`` of the objects.
    name, title, picture : str
        Of the dock.
    """

    def __init__(self, kind: str, name: str, title: str, picture: str) -> None:
        super().__init__(title, FreeCADGui.getMainWindow())
        self.kind, self._document, self._observing = kind, "", False
        self._slice_plane: Optional[SlicePlane] = None
        self.setObjectName(name)
        self.setWindowIcon(icon(picture))
        self._wait = QtCore.QTimer(self)
        self._wait.setSingleShot(True)
        self._wait.timeout.connect(self.show_objects)
        self.visibilityChanged.connect(self._observe)

    def show_objects(self) -> None:
        """Show what there is in the active document."""
        raise NotImplementedError

    def objects(self) -> List[Any]:
        """Return the objects of the active document."""
        document = FreeCAD.ActiveDocument
        self._document = document.Name if document is not None else ""
        return [obj for obj in document.Objects if type_of(obj) == self.kind] if document is not None else []

    def sizeHint(self) -> Any:
        """Ask for a height at which diagrams can be read."""
        return QtCore.QSize(900, HEIGHT)

    def open(self) -> None:
        """Show the dock at the bottom of the window; task panels keep their height."""
        window = FreeCADGui.getMainWindow()
        if window.dockWidgetArea(self) == QtCore.Qt.NoDockWidgetArea and not self.isFloating():
            window.setCorner(QtCore.Qt.BottomLeftCorner, QtCore.Qt.LeftDockWidgetArea)
            others = [one for one in window.findChildren(QtGui.QDockWidget) if isinstance(one, ObjectDock)]
            window.addDockWidget(QtCore.Qt.BottomDockWidgetArea, self)
            for one in others:
                if one is not self and window.dockWidgetArea(one) == QtCore.Qt.BottomDockWidgetArea:
                    window.tabifyDockWidget(one, self)  # one behind the other: side by side they are too narrow
                    break
        self.show()
        self.raise_()
        window.resizeDocks([self], [HEIGHT], QtCore.Qt.Vertical)

    # ------------------------------------------------------------------------------------------------- the 3D view

    def move_plane(self, corners: np.ndarray, obj: Any) -> None:
        """Show a plane between four corners (4, 3), mm, of an object's co-ordinates in the 3D view."""
        if self._slice_plane is None and self.isVisible() and self._document in FreeCAD.listDocuments():
            views = FreeCADGui.getDocument(self._document).mdiViewsOfType("Gui::View3DInventor")
            self._slice_plane = SlicePlane(views[0]) if views else None
        if self._slice_plane is not None:
            self._slice_plane.show(seen_at(corners, obj))

    def drop_plane(self) -> None:
        """Take the plane out of the view."""
        if self._slice_plane is not None:
            self._slice_plane.close()
            self._slice_plane = None

    # ------------------------------------------------------------------------------------------ FreeCAD's observer

    def _observe(self, visible: bool) -> None:
        """Follow the documents only while the dock is seen."""
        if visible and not self._observing:
            FreeCAD.addDocumentObserver(self)
            self._wait.start(0)
        elif not visible and self._observing:
            FreeCAD.removeDocumentObserver(self)
            self.drop_plane()
        self._observing = visible

    def _later(self) -> None:
        self._wait.start(50)  # many signals, one change

    def slotRecomputedObject(self, obj: Any) -> None:
        """Show an object anew that has been computed (FreeCAD's observer protocol)."""
        if type_of(obj) == self.kind:
            self._later()

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Follow labels (FreeCAD's observer protocol)."""
        if name == "Label" and type_of(obj) == self.kind:
            self._later()

    def slotDeletedObject(self, obj: Any) -> None:
        """Let go of an object (FreeCAD's observer protocol)."""
        if type_of(obj) == self.kind:
            self._later()

    def slotActivateDocument(self, document: Any) -> None:
        """Show another document's objects (FreeCAD's observer protocol)."""
        if document.Name != self._document:
            self.drop_plane()
            self._later()

    def slotDeletedDocument(self, document: Any) -> None:
        """Let go of a document that is closed (FreeCAD's observer protocol)."""
        if document.Name == self._document:
            self._slice_plane = None  # its scene goes with it
            self._later()
