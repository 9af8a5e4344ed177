# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where FreeCAD's Tasks stand: since 1.0 they lie over the 3D view (an overlay), where our panels cover what they show.

The first panel of ours lays them beside the view, behind the tree. That is done once: who lays them back keeps them so.
"""

from __future__ import annotations

from typing import Any, Optional

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .preferences import GROUP

_TO_LAY = "LayTasksBesideView"  # beside the preferences: whether it is still to be done
_WIDTH = 400  # pixels that our panels need


def _dock(name: str) -> Optional[Any]:
    return next((one for one in _window().findChildren(QtGui.QDockWidget) if one.objectName() == name), None)


def _window() -> Any:
    return FreeCADGui.getMainWindow()


def lies_over_view(dock: Any) -> bool:
    """Return whether a dock is one of FreeCAD's overlays: in no area, though it does not float."""
    return _window().dockWidgetArea(dock) == QtCore.Qt.NoDockWidgetArea and not dock.isFloating()


def lay_tasks_beside_view() -> None:
    """Lay the Tasks behind the tree, if they lie over the view and that was never done before."""
    settings, dock = FreeCAD.ParamGet(GROUP), _dock("Tasks")
    if dock is None or not dock.isVisible() or not lies_over_view(dock) or not settings.GetBool(_TO_LAY, True):
        return
    # FreeCAD has no call for it: its command turns the dock under the mouse
    before = QtGui.QCursor.pos()
    QtGui.QCursor.setPos(dock.mapToGlobal(dock.rect().center()))
    under = QtGui.QApplication.widgetAt(QtGui.QCursor.pos())
    if under is not None and dock.isAncestorOf(under):
        FreeCADGui.runCommand("Std_DockOverlayToggle")
    QtGui.QCursor.setPos(before)
    if lies_over_view(dock):
        return
    settings.SetBool(_TO_LAY, False)
    tree = _dock("Model")
    if tree is not None and _window().dockWidgetArea(tree) == QtCore.Qt.LeftDockWidgetArea:
        _window().tabifyDockWidget(tree, dock)
    dock.show()
    dock.raise_()
    _window().resizeDocks([dock], [_WIDTH], QtCore.Qt.Horizontal)
