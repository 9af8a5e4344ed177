# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of slice analyses."""

from __future__ import annotations

from typing import Any, List

import FreeCAD

from ..features.relations import type_of
from . import panels
from .analysing import analyse_at_once
from .analysis_dock import dock_of_window, show_analyses
from .analysis_form import is_sliceable
from .command import Command, PanelCommand, document_or_new, objects_of, selected_objects
from .document_work import is_busy

translate = FreeCAD.Qt.translate
KIND = "Trabecula::Analysis"


class AnalyseSlices(PanelCommand):
    """Opens the panel of slice analyses: for the selected analysis or body, or for a new one."""

    NAME, ICON = "Trabecula_Analysis", "Trabecula_analysis"
    TEXT, KEYS = "Slice analysis", "T, A"
    TIP = "Slice and measure every slice. Select a mesh, a solid, a design or an analysis, or nothing to choose a file"

    def run(self, index: int) -> None:
        """Open the panel."""
        document, chosen = document_or_new(), selected_objects()
        analysis = next((obj for obj in chosen if type_of(obj) == KIND), None)
        panels.open_analysis(document, analysis, next((obj for obj in chosen if is_sliceable(obj)), None))


class AnalyseNow(Command):
    """Analyses the selected body at once."""

    NAME, ICON, NEEDS = "Trabecula_AnalyseNow", "Trabecula_analyse_now", ("document",)
    TEXT, TIP = (
        "Analyse at once",
        "Slice a body as its kind asks for and show the plots. Select a scaffold, mesh or solid",
    )
    KEYS = "T, Q"

    def reason(self) -> str:
        """Return why not: a body must be selected, and one analysis is made at a time."""
        without = super().reason()
        if not without and is_busy():
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
    TEXT, KEYS = "Slices and plots", "T, P"
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
    KEYS = "T, C"

    def reason(self) -> str:
        """Return why not: one alone has nothing beside it."""
        alone = "" if len(objects_of(KIND)) > 1 else translate("Trabecula", "there is only one analysis")
        return super().reason() or alone

    def run(self, index: int) -> None:
        """Show them."""
        chosen = [obj for obj in selected_objects() if type_of(obj) == KIND]
        show_analyses(chosen if len(chosen) > 1 else objects_of(KIND))


def _bodies() -> List[Any]:
    return [obj for obj in selected_objects() if is_sliceable(obj)]


#: In the order of toolbar and menu.
COMMANDS = (AnalyseSlices, AnalyseNow, ShowPlots, CompareAnalyses)
