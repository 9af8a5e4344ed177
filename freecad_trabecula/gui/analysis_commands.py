# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of slice analyses."""

from __future__ import annotations

from typing import Any, List

import FreeCAD

from ..features.analysis import Analysis
from ..features.relations import type_of
from . import panels
from .analysing import analyse_at_once
from .analysis_dock import dock_of_window, show_analyses
from .analysis_form import ask_mesh_file, is_sliceable
from .analysis_saving import ask_and_save
from .background import is_busy
from .command import Command, PanelCommand, in_document, objects_of, selected_objects

translate = FreeCAD.Qt.translate
KIND = "Trabecula::Analysis"


class AnalyseSlices(PanelCommand):
    """Opens the panel of slice analyses: for the selected analysis or body, or for a new one."""

    NAME, ICON = "Trabecula_Analysis", "Trabecula_analysis"
    TEXT, KEYS = "Slice analysis", "Y, A"
    TIP = "Slice and measure every slice. Select a mesh, a solid, a design or an analysis, or nothing to choose a file"

    def run(self, index: int) -> None:
        """Open the panel."""
        chosen = selected_objects()
        analysis = next((obj for obj in chosen if type_of(obj) == KIND), None)
        source = next((obj for obj in chosen if is_sliceable(obj)), None)
        in_document(lambda document: panels.open_analysis(document, analysis, source))


class MeasureFile(PanelCommand):
    """Opens the panel of slice analyses for a file."""

    NAME, ICON = "Trabecula_MeasureFile", "Trabecula_measure_file"
    TEXT, KEYS = "Measure a file", "Y, M"
    TIP = "Slice a mesh from a file: STL, OBJ, PLY, 3MF. Needs nothing"

    def run(self, index: int) -> None:
        """Ask for the file and open the panel."""
        path = ask_mesh_file()
        if path:
            in_document(lambda document: panels.open_analysis_of_file(document, path))


class AnalyseNow(Command):
    """Analyses the selected body at once."""

    NAME, ICON, NEEDS = "Trabecula_AnalyseNow", "Trabecula_analyse_now", ("document",)
    TEXT, TIP = (
        "Analyse at once",
        "Slice a body as its kind asks for and show the plots. Select a scaffold, mesh or solid",
    )
    KEYS = "Y, Q"

    def reason(self) -> str:
        """Return why not: a body must be selected, and one analysis is made at a time."""
        without = super().reason()
        if not without and is_busy(FreeCAD.ActiveDocument.Name, Analysis.KIND):
            without = translate("Trabecula", "an analysis is on its way already")
        if not without and not _bodies():
            without = translate("Trabecula", "select a network, a scaffold, a mesh or a solid")
        return without

    def run(self, index: int) -> None:
        """Start the work."""
        analyse_at_once(_bodies()[0], lambda obj: show_analyses([obj]))


class ShowPlots(Command):
    """Shows the dock of slice analyses."""

    NAME, ICON = "Trabecula_Plots", "Trabecula_plots"
    TEXT, KEYS = "Slices and plots", "Y, P"
    TIP = (
        "Show or hide the profiles of analyses and the slice under the cursor. Select the analyses that are to be shown"
    )

    def run(self, index: int) -> None:
        """Show or hide it."""
        dock = dock_of_window()
        if dock.isVisible():
            dock.hide()
        else:
            show_analyses([obj for obj in selected_objects() if type_of(obj) == KIND])


class CompareAnalyses(Command):
    """Shows two or more analyses on shared axes."""

    NAME, ICON, NEEDS = "Trabecula_Compare", "Trabecula_compare", ("analysis",)
    TEXT, TIP = (
        "Compare analyses",
        "Show two or more analyses on shared axes, and how near they are. Select them, or none for all",
    )
    KEYS = "Y, C"

    def reason(self) -> str:
        """Return why not: one alone has nothing beside it."""
        alone = "" if len(objects_of(KIND)) > 1 else translate("Trabecula", "there is only one analysis")
        return super().reason() or alone

    def run(self, index: int) -> None:
        """Show them."""
        chosen = [obj for obj in selected_objects() if type_of(obj) == KIND]
        show_analyses(chosen if len(chosen) > 1 else objects_of(KIND))


class SaveAnalyses(Command):
    """Writes tables, report and plots of analyses."""

    NAME, ICON, NEEDS = "Trabecula_SaveAnalyses", "Trabecula_save_analyses", ("analysis",)
    TEXT, KEYS = "Save tables and plots", "Y, S"
    TIP = "Write tables, report and plots into a folder; of several their comparison. Select analyses, or none for all"

    def run(self, index: int) -> None:
        """Ask for a folder and write them."""
        chosen = [obj for obj in selected_objects() if type_of(obj) == KIND]
        ask_and_save(chosen or objects_of(KIND))


def _bodies() -> List[Any]:
    return [obj for obj in selected_objects() if is_sliceable(obj)]


#: In the order of toolbar and menu.
COMMANDS = (MeasureFile, AnalyseSlices, AnalyseNow, ShowPlots, CompareAnalyses, SaveAnalyses)
