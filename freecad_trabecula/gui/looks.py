# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our objects look: icon, colours, sizes of points and lines, and how finely they are drawn."""

from __future__ import annotations

from typing import Any, Dict, NamedTuple, Tuple

from ..features.relations import type_of
from .preferences import shares

#: Of what is seen, not of what is made: % of the size, and degrees. With FreeCAD's 0.2 % and 28.65 degrees the window
#: stands still for 1.6 s when 147 rods appear, with these for 0.3 s.
DEVIATION, ANGLE = 2.0, 60.0
Colour = Tuple[float, float, float]
_BONE, DARK, _BLUE = (0.93, 0.85, 0.68), (0.30, 0.17, 0.08), (0.25, 0.45, 0.70)
_TEAL, _RED, _ORANGE = (0.35, 0.62, 0.65), (0.84, 0.27, 0.27), (0.93, 0.60, 0.10)


class Look(NamedTuple):
    """Icon, colour of the faces or lines, size of points, width of lines, whether it is seen at first.

    ``preferred`` is the preference that the colour comes from; none: it is always the same.
    """

    icon: str
    colour: Colour
    points: float = 2.0
    lines: float = 1.0
    visible: bool = True
    preferred: str = ""


LOOKS: Dict[str, Look] = {
    "Trabecula::PrismSites": Look("Trabecula_prism_sites", DARK, points=4.0),
    "Trabecula::FaceSites": Look("Trabecula_face_sites", DARK, points=4.0),
    "Trabecula::Wireframe": Look("Trabecula_wireframe", _BLUE, lines=1.5, preferred="ColourWireframe"),
    "Trabecula::Network": Look("Trabecula_network", _BONE, preferred="ColourRods"),
    "Trabecula::Scaffold": Look("Trabecula_scaffold", _BONE, preferred="ColourScaffold"),
    "Trabecula::SolidScaffold": Look("Trabecula_solid_scaffold", _BONE, preferred="ColourScaffold"),
    "Trabecula::VoxelDesign": Look("Trabecula_voxels", _BONE, preferred="ColourScaffold"),
    "Trabecula::Analysis": Look("Trabecula_analysis", _BONE),
    "Trabecula::Body channels": Look("Trabecula_channels", _TEAL, visible=False, preferred="ColourChannels"),
    "Trabecula::Body loose": Look("Trabecula_loose", _RED),
    "Trabecula::Body voids": Look("Trabecula_voids", _ORANGE),
}
PLAIN = Look("Trabecula_design", _BONE)


def look_of(obj: Any) -> Look:
    """Return how one of our objects looks; parts of a scaffold by their role."""
    kind = type_of(obj)
    look = LOOKS.get(f"{kind} {obj.Role}" if kind == "Trabecula::Body" else kind, PLAIN)
    return look._replace(colour=shares(look.preferred)) if look.preferred else look
