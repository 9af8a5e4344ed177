# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that change what is seen, not what is there: colours that mean something, how far the eye looks through."""

from __future__ import annotations

from functools import partial
from typing import Any, List, Tuple

import FreeCAD

from ..features.colouring import choices
from ..features.relations import type_of
from .colouring import PROPERTY, add_property, colour
from .command import Command, active_document, selected_objects
from .section_dock import section_dock
from .transactions import record, transaction
from .transparency import SIGHTS, look_through

translate = FreeCAD.Qt.translate


def _colourable(by: str) -> List[Any]:
    """Selected objects that can be coloured by something; else those of the document that are seen."""
    document = active_document()
    chosen = [obj for obj in selected_objects() if by in choices(obj)]
    seen = [obj for obj in document.Objects if obj.ViewObject.Visibility and by in choices(obj)] if document else []
    return chosen or seen


class ColourBy(Command):
    """Colours objects by one thing, or plainly."""

    ICON, NEEDS = "Trabecula_colours", ("ours",)
    TIP = translate(
        "Trabecula", "Give colours a meaning; a legend says which. Select objects, or nothing for all that are seen"
    )

    def __init__(self, by: str, text: str) -> None:
        self._by, self.TEXT = by, text
        self.NAME = "Trabecula_Colour_" + by.replace(" along ", "_")

    def reason(self) -> str:
        """Return why not: nothing that is seen has such colours."""
        without = translate("Trabecula", "nothing that is seen can be coloured by that")
        return super().reason() or ("" if _colourable(self._by) else without)

    def run(self, index: int) -> None:
        """Colour them; what cannot be coloured stays as it was."""
        document, chosen = active_document(), _colourable(self._by)
        for obj in chosen:
            add_property(obj.ViewObject)  # a bone's has it from now on: undo changes its value alone
        with transaction(document, translate("Trabecula", "Colour by")):
            for obj in chosen:
                record(f"FreeCADGui.getDocument({document.Name!r}).getObject({obj.Name!r}).{PROPERTY} = {self._by!r}")
                colour(obj)


#: What the menu says, by what colours can mean, in its order.
_COLOURINGS = {
    "plain": translate("Trabecula", "Plain colours"),
    "size": translate("Trabecula", "Rods by size"),
    "coupling": translate("Trabecula", "Rods by coupling"),
    "recovery": translate("Trabecula", "Rods by recovery"),
    "porosity along x": translate("Trabecula", "Porosity of slices along X"),
    "porosity along y": translate("Trabecula", "Porosity of slices along Y"),
    "porosity along z": translate("Trabecula", "Porosity of slices along Z"),
    "trabeculae along x": translate("Trabecula", "Trabeculae in layers along X"),
    "trabeculae along y": translate("Trabecula", "Trabeculae in layers along Y"),
    "trabeculae along z": translate("Trabecula", "Trabeculae in layers along Z"),
}
_COLOUR_COMMANDS = tuple(partial(ColourBy, by, text) for by, text in _COLOURINGS.items())


class Colours(Command):
    """The group of the colours: one button with a menu."""

    NAME, ICON, NEEDS = "Trabecula_Colours", "Trabecula_colours", ("ours",)
    TEXT = "Colours"
    TIP = "Give colours a meaning; a legend says which. Select objects, or nothing for all that are seen"

    def GetCommands(self) -> Tuple[str, ...]:
        """Return the commands of the group."""
        return tuple(kind().NAME for kind in _COLOUR_COMMANDS)

    def GetDefaultCommand(self) -> int:
        """Return which of them the button itself means."""
        return 1


class LookThrough(Command):
    """Makes designs and their envelopes let the eye through, or not."""

    NEEDS = ("ours",)

    def __init__(self, sight: str, text: str, tip: str) -> None:
        self._sight, self.TEXT, self.TIP = sight, text, tip
        self.NAME, self.ICON = f"Trabecula_Sight_{sight}", f"Trabecula_sight_{sight}"

    def run(self, index: int) -> None:
        """Set what is seen of the selected design, or of all, in one step."""
        document = active_document()
        chosen = [obj for obj in selected_objects() if type_of(obj)]
        with transaction(document, translate("Trabecula", "Look through")):
            look_through(document, self._sight, chosen)


_SIGHTS = (
    (
        "solid",
        translate("Trabecula", "Solid"),
        translate("Trabecula", "Show bodies solid, no envelope. Select a design, or nothing for all"),
    ),
    (
        "glass",
        translate("Trabecula", "Glass envelope"),
        translate("Trabecula", "Show bodies in a clear envelope. Select a design, or nothing for all"),
    ),
    (
        "xray",
        translate("Trabecula", "X-ray"),
        translate("Trabecula", "Look through bodies and envelope. Select a design, or nothing for all"),
    ),
)
_SIGHT_COMMANDS = tuple(partial(LookThrough, *row) for row in _SIGHTS)


class Sights(Command):
    """The group of the ways to look through: one button with a menu."""

    NAME, ICON, NEEDS = "Trabecula_Sights", "Trabecula_sight_glass", ("ours",)
    TEXT, TIP = "Look through", "Solid, in a glass envelope, or as an X-ray. Select a design, or nothing for all"

    def GetCommands(self) -> Tuple[str, ...]:
        """Return the commands of the group."""
        return tuple(f"Trabecula_Sight_{sight}" for sight in SIGHTS)

    def GetDefaultCommand(self) -> int:
        """Return which of them the button itself means."""
        return 1


class SectionPlane(Command):
    """Shows the dock of the section plane."""

    NAME, ICON, NEEDS = "Trabecula_Section", "Trabecula_section", ("document",)
    TEXT = "Section plane"
    TIP = "Cut the 3D view open along X, Y, Z or as you look at it. Needs a document; the document does not change"

    def run(self, index: int) -> None:
        """Show or hide it."""
        dock = section_dock()
        if dock.isVisible():
            dock.hide()
        else:
            dock.open()


#: In the order of toolbar and menu; those of the groups besides.
COMMANDS = (Colours, Sights, SectionPlane, *_COLOUR_COMMANDS, *_SIGHT_COMMANDS)
