# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our objects look in the tree and in the 3D view, and what a double click on them does."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import FreeCADGui
from PySide import QtGui

from ..features.on_demand import hand_long_work_to
from ..features.relations import roles_of, type_of
from ..features.stateless import Stateless
from . import colouring
from .looks import ANGLE, DARK, DEVIATION, PLAIN, look_of
from .merged_blocks import MODE, MergedBlocks, choose_mode
from .qt import icon_path, invoke_later
from .thumbnail import add_pictures_to_files


def attach(obj: Any) -> None:
    """Give an object its view provider and its look; also one that was made without a window and is opened in one."""
    ViewProvider(obj.ViewObject)
    apply_look(obj)
    # a document made without a window hides everything
    obj.ViewObject.Visibility = look_of(obj).visible


def apply_look(obj: Any) -> None:
    """Give an object the colours and sizes of its look."""
    view, look = obj.ViewObject, look_of(obj)
    for name, value in (
        ("ShapeColor", look.colour),
        ("PointColor", look.colour),
        ("LineColor", DARK if look.icon == "Trabecula_network" else look.colour),
        ("PointSize", look.points),
        ("LineWidth", look.lines),
        ("Deviation", DEVIATION),
        ("AngularDeflection", ANGLE),
    ):
        if hasattr(view, name):
            setattr(view, name, value)


def _side_light() -> Any:
    """Return a light beside that of the view, which shines alike on all faces of blocks when they are seen aslant."""
    from pivy import coin

    light = coin.SoDirectionalLight()
    light.direction, light.intensity = (-0.25, 0.55, -0.8), 0.55
    return light


#: Commands that the tree offers for an object, by its kind; of all other objects those of the design they belong to.
OFFERED: Dict[str, Tuple[str, ...]] = {
    "Trabecula::Analysis": ("Trabecula_Analysis", "Trabecula_Plots", "Trabecula_Compare", "Trabecula_CopyScript"),
    "Trabecula::VoxelDesign": (
        *("Trabecula_Voxels", "Trabecula_VoxelLayers", "Trabecula_AnalyseNow", "Trabecula_VoxelExport"),
        "Trabecula_CopyScript",
    ),
}
OFFERED_TO_PARTS = (
    *("Trabecula_Design", "Trabecula_Results", "Trabecula_AnalyseNow", "Trabecula_Export", "Trabecula_CopyScript"),
)
MOST_COUNTED = 200_000  # triangles of a mesh that is listed in the property editor


class ViewProvider(Stateless):
    """View provider of all our objects. It keeps nothing: data live in the objects' properties."""

    def __init__(self, view: Any) -> None:
        view.Proxy = self

    def attach(self, view: Any) -> None:
        """Remember the object (called by FreeCAD, also after a file was opened)."""
        self.Object = view.Object
        if type_of(view.Object) == "Trabecula::VoxelDesign":
            view.RootNode.insertChild(_side_light(), 0)
            self.blocks = MergedBlocks(view)
        colouring.add_property(view)
        if type_of(view.Object) == "Trabecula::Analysis":
            colouring.refresh_source(view.Object)

    def isShow(self) -> bool:
        """Return whether the tree shows the object as seen: an analysis has nothing that could be hidden."""
        obj = getattr(self, "Object", None)
        return obj is None or type_of(obj) == "Trabecula::Analysis" or bool(obj.ViewObject.Visibility)

    def getIcon(self) -> str:
        """Return the path of the icon in the tree."""
        obj = getattr(self, "Object", None)
        return icon_path(look_of(obj).icon if obj is not None else PLAIN.icon)

    def updateData(self, obj: Any, name: str) -> None:
        """Change the look with the role of a scaffold's part, and meaningful colours with the result."""
        if obj.ViewObject is None:
            return
        if name == "Role":
            apply_look(obj)
            obj.ViewObject.Visibility = look_of(obj).visible
        elif name == "ResultKey" and colouring.is_coloured(obj):
            colouring.refresh(obj)
        if name == "Mesh":
            # for the property editor FreeCAD counts the edges of a mesh at each selection: 0.2 s of 1,300,000 triangles
            obj.setEditorMode(name, 2 if obj.Mesh.CountFacets > MOST_COUNTED else 0)
        if name == "ResultKey" and type_of(obj) == "Trabecula::Analysis":
            colouring.refresh_source(obj)
        if name == "ResultKey" and hasattr(self, "blocks"):
            choose_mode(obj)

    def onChanged(self, view: Any, name: str) -> None:
        """Follow the property that says what the colours mean, and what is seen."""
        if name == colouring.PROPERTY:
            colouring.refresh(view.Object)
        elif name == "DisplayMode" and hasattr(self, "blocks") and colouring.is_coloured(view.Object):
            colouring.refresh(view.Object)  # blocks and triangles have colours of their own
        elif name in ("ShapeColor", "ShapeAppearance", "Transparency") and hasattr(self, "blocks"):
            self.blocks.paint(view)
        elif name == "Visibility":
            colouring.show_legends(view.Object.Document.Name)

    def getDisplayModes(self, view: Any) -> List[str]:
        """Return the display modes of our own."""
        return [MODE] if hasattr(self, "blocks") else []

    def claimChildren(self) -> List[Any]:
        """Return what stands below in the tree: envelope and sites below a wireframe, its parts below a scaffold."""
        obj = getattr(self, "Object", None)
        if obj is None:
            return []
        if type_of(obj) == "Trabecula::Wireframe":
            return [one for one in (obj.Envelope, *obj.Sites) if one is not None]
        return roles_of(obj)

    def doubleClicked(self, view: Any) -> bool:
        """Open the object's panel."""
        edit(view.Object)
        return True

    def setupContextMenu(self, view: Any, menu: Any) -> None:
        """Offer what can be done with the object, at a click with the right button (FreeCAD's protocol)."""
        known = FreeCADGui.listCommands()
        for name in OFFERED.get(type_of(view.Object), OFFERED_TO_PARTS):
            if name in known:
                command = FreeCADGui.Command.get(name)
                info = command.getInfo()
                action = menu.addAction(QtGui.QIcon(info["pixmap"]), info["menuText"].replace("&", ""))
                action.setEnabled(bool(command.isActive()))
                action.triggered.connect(lambda *_, name=name: FreeCADGui.runCommand(name))

    def setEdit(self, view: Any, mode: int) -> Optional[bool]:
        """Open the object's panel from the menu; FreeCAD's own edit mode is not entered."""
        if mode != 0:
            return None
        edit(view.Object)
        return False

    def onDelete(self, view: Any, subelements: Any) -> bool:
        """Allow to delete the object."""
        return True


def edit(obj: Any) -> None:
    """Open the panel of one of our objects as soon as the event loop is free."""
    from . import panels

    document, name = obj.Document.Name, obj.Name
    invoke_later(lambda: panels.open_for(document, name))


def _compute_elsewhere(obj: Any, key: str) -> bool:
    from .recomputing import of_window

    return of_window().take(obj, key)


hand_long_work_to(_compute_elsewhere)
add_pictures_to_files()
