# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where FreeCAD's Tasks stand: since 1.0 they lie over the 3D view (an overlay), where our panels cover what they show.

The first panel of ours lays them beside the view, behind the tree. That is done once: who lays them back keeps them so.
There FreeCAD leaves the Tasks in front, empty, when a panel closes: the tree that was seen before comes back.
"""

from __future__ import annotations

from typing import Any, List, Optional

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .preferences import GROUP

_TO_LAY = "LayTasksBesideView"  # beside the preferences: whether it is still to be done
_WIDTH = 400  # pixels that our panels need
_covered: List[str] = []  # name of the tree's dock, if it was seen before the panel that is open


def _dock(name: str) -> Optional[Any]:
    return next((one for one in _window().findChildren(QtGui.QDockWidget) if one.objectName() == name), None)


def _window() -> Any:
    return FreeCADGui.getMainWindow()


def lies_over_view(dock: Any) -> bool:
    """Return whether a dock is one of FreeCAD's overlays: in no area, though it does not float."""
    return _window().dockWidgetArea(dock) == QtCore.Qt.NoDockWidgetArea and not dock.isFloating()


def note_tree() -> None:
    """Note whether the tree is seen, which a panel is about to cover."""
    tree = _dock("Model")
    if tree is not None and not tree.visibleRegion().isEmpty():
        _covered[:] = [tree.objectName()]


def show_tree_again() -> None:
    """Bring the tree before the Tasks again, if it was seen before a panel and none is open any more."""
    if FreeCADGui.Control.activeDialog():
        return  # the next panel of a row: its end counts
    tasks = _dock("Tasks")
    for tree in filter(None, map(_dock, _covered)):
        if tasks in _window().tabifiedDockWidgets(tree):
            tree.raise_()
    _covered.clear()


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
