# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of designs of rods."""

from __future__ import annotations

from typing import Any, List, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..core.presets import PRESETS, preset
from ..errors import ParameterError
from ..features.bodies import is_body, is_solid, whole
from ..features.jobs import write_job
from ..features.relations import parts_of, type_of, wireframe_of
from . import panels
from .command import Command, PanelCommand, active_document, in_document, selected_objects
from .design_form import preset_text
from .export_dialog import exists, export_design
from .preferences import folder_for
from .results_panel import open_results
from .rod_dock import toggle_dock
from .site_panel import open_site_panel
from .task_panels import wireframes
from .transactions import say, transaction

translate = FreeCAD.Qt.translate


def _wireframe() -> Any:
    """The design of the selection, else the document's only or latest; None if there is none."""
    chosen = [wireframe_of(obj) for obj in selected_objects() if type_of(obj)]
    found = [one for one in chosen if one is not None] or wireframes(active_document())[-1:]
    return found[0] if found else None


def _channels(wireframe: Any) -> List[Any]:
    return [one for one in parts_of(wireframe) if getattr(one, "Role", "") == "channels"]


def _to_be_filled(chosen: List[Any]) -> Any:
    """The first body of a selection; None if nothing else is selected than what is ours."""
    others = [obj for obj in chosen if not type_of(obj)]
    found = [obj for obj in others if is_body(obj)]
    if others and not found:
        raise ParameterError(
            f"rods are designed in a solid or a closed mesh, got {others[0].Label}, which has neither: select a body, "
            "or nothing for a new prism"
        )
    return found[0] if found else None


class DesignRods(PanelCommand):
    """Opens the design panel: for the selected design, or for a new one in the selected solid or in a prism."""

    NAME, ICON = "Trabecula_Design", "Trabecula_design"
    TEXT, KEYS = "Design rods", "Y, D"
    TIP = "Design a network of rods. Select a solid, or a design to change; with nothing selected a prism is filled"

    def run(self, index: int) -> None:
        """Open the panel."""
        chosen = selected_objects()
        design = next((wireframe_of(obj) for obj in chosen if type_of(obj)), None)
        if design is not None:
            panels.open_change(design)
        else:
            body = _to_be_filled(chosen)
            in_document(lambda document: panels.open_new(document, envelope=body))


class LoadPreset(PanelCommand):
    """Opens the design panel with one of the thesis' designs."""

    ICON = "Trabecula_preset"

    def __init__(self, preset_name: str) -> None:
        self._preset = preset_name
        self.NAME = "Trabecula_Preset_" + preset_name
        self.TEXT = preset_text(preset_name)
        self.TIP = translate(
            "Trabecula", "Start from this design of the thesis. Select nothing: it brings its own body"
        )

    def run(self, index: int) -> None:
        """Open the panel."""
        in_document(lambda document: panels.open_new(document, preset(self._preset)))


class Presets(PanelCommand):
    """The group of the designs of the thesis: one button with a menu."""

    NAME, ICON = "Trabecula_Presets", "Trabecula_preset"
    TEXT, TIP = "Designs of the thesis", "Start from a design of the thesis. Select nothing: it brings its own body"

    def GetCommands(self) -> Tuple[str, ...]:
        """Return the commands of the group."""
        return tuple("Trabecula_Preset_" + name for name in PRESETS)

    def GetDefaultCommand(self) -> int:
        """Return which of them the button itself means."""
        return PRESETS.index("case6")


class FaceSitesCommand(PanelCommand):
    """Opens the design panel with the selected faces."""

    NAME, ICON, NEEDS = "Trabecula_FaceSites", "Trabecula_face_sites", ("no panel", "document")
    TEXT, TIP = "Sites on faces", "Lay sites on faces. Select a solid, whose faces you pick next, or faces of one"

    def reason(self) -> str:
        """Return why not: without a solid there are no faces."""
        without = "" if self._chosen() else translate("Trabecula", "select a solid, or faces of one")
        return super().reason() or without

    def run(self, index: int) -> None:
        """Open the panel."""
        chosen = self._chosen()[0]
        body = whole(chosen.Object)
        is_seen = chosen.Object in (body, getattr(body, "Tip", None))  # an earlier step has faces of its own
        faces = [name for name in chosen.SubElementNames if name.startswith("Face") and is_seen]
        panels.open_on_faces(active_document(), body, faces)

    def _chosen(self) -> List[Any]:
        document = active_document()
        selection = FreeCADGui.Selection.getSelectionEx(document.Name) if document is not None else []
        return [one for one in selection if is_solid(whole(one.Object))]


class EditSite(PanelCommand):
    """Opens the panel that changes single sites and pores."""

    NAME, ICON, NEEDS = "Trabecula_EditSite", "Trabecula_edit_pore", ("no panel", "design")
    TEXT, TIP = (
        "Edit site and pore",
        "Change, move or switch off one site or its pore. Needs a design; select one of several",
    )

    def run(self, index: int) -> None:
        """Open the panel."""
        open_site_panel(_wireframe())


class BuildBody(PanelCommand):
    """Builds one kind of body of a design in another process."""

    NEEDS, KIND = ("no panel", "design"), ""

    def run(self, index: int) -> None:
        """Open the design panel, which builds at once."""
        panels.open_and_build(_wireframe(), self.KIND)


class BuildNetwork(BuildBody):
    """Builds the rods as solids."""

    NAME, ICON, KIND = "Trabecula_Network", "Trabecula_network", "network"
    TEXT, TIP = (
        "Build network",
        "Build the rods as solids (STEP); no Boolean is needed. Needs a design; select one of several",
    )
    KEYS = "Y, N"


class BuildScaffold(BuildBody):
    """Builds the scaffold."""

    NAME, ICON, KIND = "Trabecula_Scaffold", "Trabecula_scaffold", "scaffold"
    TEXT, TIP = (
        "Build scaffold",
        "Cut the channels out of the envelope: scaffold, channels, porosity. Needs a design; select one of several",
    )
    KEYS = "Y, B"


class SwitchView(Command):
    """Shows the channels in place of the rods, or the other way round."""

    NAME, ICON, NEEDS = "Trabecula_Switch", "Trabecula_switch", ("design",)
    TEXT, TIP = "Rods or channels", "Show rods or channels: two views of one wireframe. Needs a scaffold"
    KEYS = "Y, R"

    def reason(self) -> str:
        """Return why not: channels come with a scaffold."""
        return super().reason() or ("" if _channels(_wireframe()) else translate("Trabecula", "build a scaffold first"))

    def run(self, index: int) -> None:
        """Switch."""
        switch_view(_wireframe())


class Results(PanelCommand):
    """Opens the results of a design."""

    NAME, ICON, NEEDS = "Trabecula_Results", "Trabecula_results", ("no panel", "design")
    TEXT, TIP = (
        "Results",
        "Porosity, volumes, counts, recoveries, pore sizes, checks. Needs a design; select one of several",
    )
    KEYS = "Y, U"

    def run(self, index: int) -> None:
        """Open the panel."""
        open_results(active_document().Name, _wireframe())


class RodInfo(Command):
    """Shows the dock that tells of a clicked rod."""

    NAME, ICON = "Trabecula_RodInfo", "Trabecula_path"
    TEXT, TIP = "Rod at a click", "Show or hide what is known of a rod. Select one in the 3D view"
    KEYS = "Y, I"

    def run(self, index: int) -> None:
        """Show or hide the dock."""
        toggle_dock()


class Export(Command):
    """Writes the bodies of a design into files."""

    NAME, ICON, NEEDS = "Trabecula_Export", "Trabecula_export", ("design",)
    TEXT, KEYS = "Export", "Y, X"
    TIP = (
        "Write scaffold, channels or rods as STL, STEP, BREP, OBJ, PLY, 3MF, sizes first. Needs a scaffold or a network"
    )

    def reason(self) -> str:
        """Return why not: only bodies are written."""
        without = super().reason()
        if not without and not any(exists(one) for one in parts_of(_wireframe())):
            without = translate("Trabecula", "build a scaffold or a network first")
        return without

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        export_design(_wireframe())


class OpenJob(PanelCommand):
    """Opens the design panel with the values of a job file."""

    NAME, ICON = "Trabecula_OpenJob", "Trabecula_open_job"
    TEXT, TIP = "Open job", "Open a job file: all that a design needs. Select nothing: it names its own body"
    KEYS = "Y, O"

    def run(self, index: int) -> None:
        """Ask for a file and open the panel."""
        path, _ = QtGui.QFileDialog.getOpenFileName(
            FreeCADGui.getMainWindow(), translate("Trabecula", "Open job"), "", _job_files()
        )
        if path:
            in_document(lambda document: panels.open_job(document, path))


class SaveJob(Command):
    """Saves a design as a job file."""

    NAME, ICON, NEEDS = "Trabecula_SaveJob", "Trabecula_save_job", ("design",)
    TEXT, TIP = (
        "Save job",
        "Save the design as a job file, which the command line runs too. Needs a design; select one of several",
    )
    KEYS = "Y, J"

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        wireframe = _wireframe()
        path, _ = QtGui.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(), translate("Trabecula", "Save job"), folder_for(wireframe.Document), _job_files()
        )
        if path:
            write_job(wireframe, path)
            say(translate("Trabecula", "{} was written").format(path))


def _job_files() -> str:
    return translate("Trabecula", "Trabecula job") + " (*.json)"


def switch_view(wireframe: Any) -> None:
    """Show the channels of a design and hide its rods and its scaffold, or the other way round.

    Raises
    ------
    ParameterError
        If there are no two views yet.
    """
    parts, channels = parts_of(wireframe), _channels(wireframe)
    rods = [one for one in parts if type_of(one) == "Trabecula::Network"] or [wireframe]
    if not channels:
        raise ParameterError("channels can be shown once a scaffold is built, got none: build the scaffold first")
    to_channels = not any(one.ViewObject.Visibility for one in channels)
    with transaction(wireframe.Document, translate("Trabecula", "Rods or channels")):
        for one in parts:
            one.ViewObject.Visibility = one in (channels if to_channels else rods)
        for one in rods:
            one.ViewObject.Visibility = not to_channels


#: In the order of toolbar and menu.
COMMANDS = (
    *(DesignRods, Presets, FaceSitesCommand, EditSite, BuildScaffold, BuildNetwork, SwitchView, RodInfo, Results),
    *(Export, OpenJob, SaveJob),
)
