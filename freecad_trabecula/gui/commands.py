# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's commands and where they are seen: a toolbar and a submenu for each group, in the order of work."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from ..core.presets import PRESETS
from . import (
    analysis_commands,
    help_commands,
    rod_commands,
    seeing_commands,
    start_commands,
    study_commands,
    voxel_commands,
)
from .command import REGISTERED
from .preferences import add_page

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
#: Modules whose ``COMMANDS`` are registered.
MODULES = (
    start_commands,
    rod_commands,
    analysis_commands,
    voxel_commands,
    seeing_commands,
    study_commands,
    help_commands,
)
#: Title of a toolbar, title of its submenu (none: the menu itself), names of its commands; "" is a gap.
GROUPS = (
    (
        QT_TRANSLATE_NOOP("Workbench", "Trabecula"),
        "",
        ("Trabecula_Start", "Trabecula_Body", "Trabecula_Renew"),
    ),
    (
        QT_TRANSLATE_NOOP("Workbench", "Trabecula rods"),
        QT_TRANSLATE_NOOP("Workbench", "&Rods"),
        (
            *("Trabecula_Design", "Trabecula_Presets", "Trabecula_FaceSites", "Trabecula_EditSite", ""),
            *("Trabecula_Scaffold", "Trabecula_Network", "Trabecula_Switch", "Trabecula_RodInfo", ""),
            *("Trabecula_Results", "Trabecula_Export", "Trabecula_OpenJob", "Trabecula_SaveJob"),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Workbench", "Trabecula slices"),
        QT_TRANSLATE_NOOP("Workbench", "&Slices"),
        (
            *("Trabecula_MeasureFile", "Trabecula_Analysis", "Trabecula_AnalyseNow", ""),
            *("Trabecula_Plots", "Trabecula_Compare", "Trabecula_SaveAnalyses"),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Workbench", "Trabecula voxels"),
        QT_TRANSLATE_NOOP("Workbench", "&Voxels"),
        (
            *("Trabecula_Voxels", "Trabecula_VoxelLayers", "Trabecula_VoxelTables", "Trabecula_WatchLayer", ""),
            *("Trabecula_LayerShapes", "Trabecula_VoxelExport"),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Workbench", "Trabecula seeing"),
        QT_TRANSLATE_NOOP("Workbench", "S&eeing"),
        ("Trabecula_Colours", "Trabecula_Sights", "Trabecula_Section"),
    ),
    (
        QT_TRANSLATE_NOOP("Workbench", "Trabecula study"),
        QT_TRANSLATE_NOOP("Workbench", "S&tudy"),
        ("Trabecula_Variants", "Trabecula_CopyScript", "Trabecula_WriteReport"),
    ),
    (
        QT_TRANSLATE_NOOP("Workbench", "Trabecula help"),
        QT_TRANSLATE_NOOP("Workbench", "&Help"),
        ("Trabecula_Help",),
    ),
)
#: The commands by their names, once they are registered.
COMMANDS = REGISTERED


def register(workbench: Any) -> None:
    """Register all commands and give the workbench its toolbars and its menu."""
    kinds = [kind for module in MODULES for kind in module.COMMANDS]
    for command in (*(kind() for kind in kinds), *map(rod_commands.LoadPreset, PRESETS)):
        COMMANDS[command.NAME] = command
        FreeCADGui.addCommand(command.NAME, command)
    add_page()
    menu = QT_TRANSLATE_NOOP("Workbench", "&Trabecula")
    for bar, submenu, names in GROUPS:
        shown = [name or "Separator" for name in names]
        workbench.appendToolbar(bar, shown)
        workbench.appendMenu([menu, submenu] if submenu else [menu], shown)
