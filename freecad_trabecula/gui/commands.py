# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's commands: each a small class; toolbar and menu are made of their list."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..core.job import job_to_json
from ..core.presets import PRESETS, preset
from ..errors import ParameterError
from ..features.jobs import job_of
from ..features.relations import parts_of, products_of, type_of, wireframe_of
from ..geometry.files import replacing
from . import panels
from .analysis_commands import COMMANDS as ANALYSIS_COMMANDS
from .command import Command, PanelCommand, active_document, document_or_new, selected_objects
from .design_form import preset_text
from .export_dialog import export_design
from .picking import is_solid
from .qt import icon_path
from .results_panel import open_results
from .rod_dock import toggle_dock
from .site_panel import open_site_panel
from .study_commands import COMMANDS as STUDY_COMMANDS
from .task_panels import wireframes
from .transactions import say, transaction
from .voxel_commands import COMMANDS as VOXEL_COMMANDS

translate = FreeCAD.Qt.translate
_JOB_FILES = "Trabecula job (*.json)"


def _wireframe() -> Any:
    """The design of the selection, else the document's only or latest; None if there is none."""
    chosen = [wireframe_of(obj) for obj in selected_objects() if type_of(obj)]
    found = [one for one in chosen if one is not None] or wireframes(active_document())[-1:]
    return found[0] if found else None


class DesignRods(PanelCommand):
    """Opens the design panel: for the selected design, or for a new one in the selected solid or in a prism."""

    NAME, ICON = "Trabecula_Design", "Trabecula_design"
    TEXT, TIP = "Design rods", "Design a network of rods in a prism or in the selected solid"

    def run(self, index: int) -> None:
        """Open the panel."""
        document = document_or_new()
        chosen = selected_objects()
        design = next((wireframe_of(obj) for obj in chosen if type_of(obj)), None)
        if design is not None:
            panels.open_change(design)
        else:
            panels.open_new(document, envelope=next((obj for obj in chosen if is_solid(obj)), None))


class LoadPreset(PanelCommand):
    """Opens the design panel with one of the thesis' designs."""

    ICON = "Trabecula_preset"

    def __init__(self, preset_name: str) -> None:
        self._preset = preset_name
        self.NAME = "Trabecula_Preset_" + preset_name
        self.TEXT = preset_text(preset_name)
        self.TIP = "Start from this design of the thesis"

    def run(self, index: int) -> None:
        """Open the panel."""
        panels.open_new(document_or_new(), preset(self._preset))


class Presets:
    """The group of the designs of the thesis: one button with a menu."""

    NAME = "Trabecula_Presets"

    def GetResources(self) -> Dict[str, str]:
        """Return text and tooltip."""
        return {
            "Pixmap": icon_path("Trabecula_preset"),
            "MenuText": translate(self.NAME, "Designs of the thesis"),
            "ToolTip": translate(self.NAME, "Start from a design of the thesis"),
        }

    def GetCommands(self) -> Tuple[str, ...]:
        """Return the commands of the group."""
        return tuple("Trabecula_Preset_" + name for name in PRESETS)

    def GetDefaultCommand(self) -> int:
        """Return which of them the button itself means."""
        return PRESETS.index("case6")

    def IsActive(self) -> bool:
        """Return whether the commands can be used now."""
        return not FreeCADGui.Control.activeDialog()


class FaceSitesCommand(PanelCommand):
    """Opens the design panel with the selected faces."""

    NAME, ICON, NEEDS = "Trabecula_FaceSites", "Trabecula_face_sites", "document"
    TEXT, TIP = "Sites on faces", "Sites on the selected faces of a solid, or on faces that you pick next"

    def run(self, index: int) -> None:
        """Open the panel."""
        chosen = [one for one in FreeCADGui.Selection.getSelectionEx(active_document().Name) if is_solid(one.Object)]
        if not chosen:
            say(translate("Trabecula", "Select a solid, or faces of one, first"))
            return
        faces = [name for name in chosen[0].SubElementNames if name.startswith("Face")]
        panels.open_on_faces(active_document(), chosen[0].Object, faces)


class EditSite(PanelCommand):
    """Opens the panel that changes single sites and pores."""

    NAME, ICON, NEEDS = "Trabecula_EditSite", "Trabecula_edit_pore", "design"
    TEXT, TIP = "Edit site and pore", "Change, move or switch off one site or its pore"

    def run(self, index: int) -> None:
        """Open the panel."""
        open_site_panel(_wireframe())


class BuildBody(PanelCommand):
    """Builds one kind of body of a design in another process."""

    NEEDS, KIND = "design", ""

    def run(self, index: int) -> None:
        """Open the design panel, which builds at once."""
        panels.open_and_build(_wireframe(), self.KIND)


class BuildNetwork(BuildBody):
    """Builds the rods as solids."""

    NAME, ICON, KIND = "Trabecula_Network", "Trabecula_network", "network"
    TEXT, TIP = "Build network", "Build the rods as solids (STEP); no Boolean is needed"


class BuildScaffold(BuildBody):
    """Builds the scaffold."""

    NAME, ICON, KIND = "Trabecula_Scaffold", "Trabecula_scaffold", "scaffold"
    TEXT, TIP = "Build scaffold", "Cut the channels out of the envelope: scaffold, channels, porosity"


class SwitchView(Command):
    """Shows the channels in place of the rods, or the other way round."""

    NAME, ICON, NEEDS = "Trabecula_Switch", "Trabecula_switch", "design"
    TEXT, TIP = "Rods or channels", "Show rods or channels: two views of one wireframe"

    def run(self, index: int) -> None:
        """Switch."""
        switch_view(_wireframe())


class Results(PanelCommand):
    """Opens the results of a design."""

    NAME, ICON, NEEDS = "Trabecula_Results", "Trabecula_results", "design"
    TEXT, TIP = "Results", "Porosity, volumes, counts, recoveries, pore sizes, checks"

    def run(self, index: int) -> None:
        """Open the panel."""
        open_results(active_document().Name, _wireframe())


class RodInfo(Command):
    """Shows the dock that tells of a clicked rod."""

    NAME, ICON, NEEDS = "Trabecula_RodInfo", "Trabecula_path", ""
    TEXT, TIP = "Rod at a click", "Click a rod in the 3D view to see its sites and sections"

    def run(self, index: int) -> None:
        """Show or hide the dock."""
        toggle_dock()


class Export(Command):
    """Writes the bodies of a design into files."""

    NAME, ICON, NEEDS = "Trabecula_Export", "Trabecula_export", "design"
    TEXT, TIP = "Export", "Write scaffold, channels or rods as STL, STEP, BREP, OBJ, PLY, 3MF; sizes are shown first"

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        export_design(_wireframe())


class OpenJob(PanelCommand):
    """Opens the design panel with the values of a job file."""

    NAME, ICON = "Trabecula_OpenJob", "Trabecula_open_job"
    TEXT, TIP = "Open job", "Open a job file: all that a design needs"

    def run(self, index: int) -> None:
        """Ask for a file and open the panel."""
        path, _ = QtGui.QFileDialog.getOpenFileName(
            FreeCADGui.getMainWindow(), translate("Trabecula", "Open job"), "", _JOB_FILES
        )
        if path:
            panels.open_job(document_or_new(), path)


class SaveJob(Command):
    """Saves a design as a job file."""

    NAME, ICON, NEEDS = "Trabecula_SaveJob", "Trabecula_save_job", "design"
    TEXT, TIP = "Save job", "Save the design as a job file, which the command line runs too"

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        wireframe = _wireframe()
        scaffold = next((one for one in products_of(wireframe) if type_of(one).endswith("Scaffold")), None)
        text = job_to_json(job_of(wireframe, scaffold))
        path, _ = QtGui.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(), translate("Trabecula", "Save job"), "", _JOB_FILES
        )
        if path:
            with replacing(path) as part:
                Path(part).write_text(text, encoding="utf-8")
            say(translate("Trabecula", "{} was written").format(path))


def switch_view(wireframe: Any) -> None:
    """Show the channels of a design and hide its rods and its scaffold, or the other way round.

    Raises
    ------
    ParameterError
        If there are no two views yet.
    """
    parts = parts_of(wireframe)
    channels = [one for one in parts if getattr(one, "Role", "") == "channels"]
    rods = [one for one in parts if type_of(one) == "Trabecula::Network"] or [wireframe]
    if not channels:
        raise ParameterError("channels can be shown once a scaffold is built, got none: build the scaffold first")
    to_channels = not any(one.ViewObject.Visibility for one in channels)
    with transaction(wireframe.Document, "Rods or channels"):
        for one in parts:
            one.ViewObject.Visibility = one in (channels if to_channels else rods)
        for one in rods:
            one.ViewObject.Visibility = not to_channels


#: Names of the commands, in the order of toolbar and menu; "" is a gap.
TOOLBAR = (
    *("Trabecula_Design", "Trabecula_Presets", "Trabecula_FaceSites", "Trabecula_EditSite", ""),
    *("Trabecula_Network", "Trabecula_Scaffold", "Trabecula_Switch", "Trabecula_RodInfo", ""),
    *("Trabecula_Results", "Trabecula_Export", "Trabecula_OpenJob", "Trabecula_SaveJob", ""),
    *("Trabecula_Analysis", "Trabecula_AnalyseNow", "Trabecula_Plots", "Trabecula_Compare", ""),
    *("Trabecula_Voxels", "Trabecula_VoxelLayers", "Trabecula_LayerShapes", "Trabecula_VoxelExport", ""),
    *("Trabecula_CopyScript",),
)


def register(workbench: Any) -> None:
    """Register all commands and give the workbench its toolbar and its menu."""
    kinds = (DesignRods, FaceSitesCommand, EditSite, BuildNetwork, BuildScaffold, SwitchView)
    commands = [kind() for kind in (*kinds, RodInfo, Results, Export, OpenJob, SaveJob)]
    commands += [kind() for kind in (*ANALYSIS_COMMANDS, *VOXEL_COMMANDS, *STUDY_COMMANDS)]
    commands += [LoadPreset(name) for name in PRESETS] + [Presets()]
    for command in commands:
        FreeCADGui.addCommand(command.NAME, command)
    names = [name or "Separator" for name in TOOLBAR]
    workbench.appendToolbar("Trabecula", names)
    workbench.appendMenu("&Trabecula", names)
