# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our objects look in the tree and in the 3D view, and what a double click on them does."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Tuple

from ..features.on_demand import hand_long_work_to
from .qt import icon_path, invoke_later

#: Of what is seen, not of what is made: % of the size, and degrees. With FreeCAD's 0.2 % and 28.65 degrees the window
#: stands still for 1.6 s when 147 rods appear, with these for 0.3 s.
DEVIATION, ANGLE = 2.0, 60.0
Colour = Tuple[float, float, float]
_BONE, _DARK, _BLUE = (0.93, 0.85, 0.68), (0.30, 0.17, 0.08), (0.25, 0.45, 0.70)
_TEAL, _RED, _ORANGE = (0.35, 0.62, 0.65), (0.84, 0.27, 0.27), (0.93, 0.60, 0.10)


class Look(NamedTuple):
    """Icon, colour of the faces or lines, size of points, width of lines, and whether it is seen at first."""

    icon: str
    colour: Colour
    points: float = 2.0
    lines: float = 1.0
    visible: bool = True


LOOKS: Dict[str, Look] = {
    "Trabecula::PrismSites": Look("Trabecula_prism_sites", _DARK, points=4.0),
    "Trabecula::FaceSites": Look("Trabecula_face_sites", _DARK, points=4.0),
    "Trabecula::Wireframe": Look("Trabecula_wireframe", _BLUE, lines=1.5),
    "Trabecula::Network": Look("Trabecula_network", _BONE),
    "Trabecula::Scaffold": Look("Trabecula_scaffold", _BONE),
    "Trabecula::SolidScaffold": Look("Trabecula_solid_scaffold", _BONE),
    "Trabecula::VoxelDesign": Look("Trabecula_voxels", _BONE),
    "Trabecula::Analysis": Look("Trabecula_analysis", _BONE),
    "Trabecula::Body channels": Look("Trabecula_channels", _TEAL, visible=False),
    "Trabecula::Body loose": Look("Trabecula_loose", _RED),
    "Trabecula::Body voids": Look("Trabecula_voids", _ORANGE),
}
_PLAIN = Look("Trabecula_design", _BONE)


def type_of(obj: Any) -> str:
    """Return the word by which one of our objects is known; empty for others."""
    name = getattr(getattr(obj, "Proxy", None), "Type", "")
    return name if isinstance(name, str) and name.startswith("Trabecula::") else ""


def look_of(obj: Any) -> Look:
    """Return how one of our objects looks; parts of a scaffold by their role."""
    kind = type_of(obj)
    return LOOKS.get(f"{kind} {obj.Role}" if kind == "Trabecula::Body" else kind, _PLAIN)


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
        ("LineColor", _DARK if look.icon == "Trabecula_network" else look.colour),
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


class ViewProvider:
    """View provider of all our objects. It keeps nothing: data live in the objects' properties."""

    def __init__(self, view: Any) -> None:
        view.Proxy = self

    def attach(self, view: Any) -> None:
        """Remember the object (called by FreeCAD, also after a file was opened)."""
        self.Object = view.Object
        if type_of(view.Object) == "Trabecula::VoxelDesign":
            view.RootNode.insertChild(_side_light(), 0)

    def isShow(self) -> bool:
        """Return whether the tree shows the object as seen: an analysis has nothing that could be hidden."""
        obj = getattr(self, "Object", None)
        return obj is None or type_of(obj) == "Trabecula::Analysis" or bool(obj.ViewObject.Visibility)

    def getIcon(self) -> str:
        """Return the path of the icon in the tree."""
        obj = getattr(self, "Object", None)
        return icon_path(look_of(obj).icon if obj is not None else _PLAIN.icon)

    def updateData(self, obj: Any, name: str) -> None:
        """Change the look with the role of a scaffold's part."""
        if name == "Role" and obj.ViewObject is not None:
            apply_look(obj)
            obj.ViewObject.Visibility = look_of(obj).visible

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

    def setEdit(self, view: Any, mode: int) -> Optional[bool]:
        """Open the object's panel from the menu; FreeCAD's own edit mode is not entered."""
        if mode != 0:
            return None
        edit(view.Object)
        return False

    def onDelete(self, view: Any, subelements: Any) -> bool:
        """Allow to delete the object."""
        return True

    def dumps(self) -> None:
        """Return the state: none."""
        return None

    def loads(self, state: Any) -> None:
        """Take the state: none."""
        return None

    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None


def edit(obj: Any) -> None:
    """Open the panel of one of our objects as soon as the event loop is free."""
    from . import panels

    document, name = obj.Document.Name, obj.Name
    invoke_later(lambda: panels.open_for(document, name))


def wireframe_of(obj: Any) -> Any:
    """Return the wireframe to which one of our objects belongs, None if there is none."""
    kind = type_of(obj)
    if kind == "Trabecula::Wireframe":
        return obj
    if kind in ("Trabecula::FaceSites", "Trabecula::PrismSites"):
        return next((one for one in obj.InList if type_of(one) == "Trabecula::Wireframe"), None)
    if kind == "Trabecula::Body":
        return wireframe_of(obj.Scaffold)
    return getattr(obj, "Wireframe", None) if kind else None


def products_of(wireframe: Any) -> List[Any]:
    """Return networks and scaffolds made of a wireframe."""
    return [one for one in wireframe.InList if type_of(one) and getattr(one, "Wireframe", None) == wireframe]


def roles_of(scaffold: Any) -> List[Any]:
    """Return channels, loose pieces and voids that belong to a scaffold."""
    return [one for one in scaffold.InList if type_of(one) == "Trabecula::Body" and one.Scaffold == scaffold]


def parts_of(wireframe: Any) -> List[Any]:
    """Return all bodies made of a wireframe, parts of scaffolds included."""
    return [part for one in products_of(wireframe) for part in (one, *roles_of(one))]


def _compute_elsewhere(obj: Any, key: str) -> bool:
    from .recomputing import of_window

    return of_window().take(obj, key)


hand_long_work_to(_compute_elsewhere)
