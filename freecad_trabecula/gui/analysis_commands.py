# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of slice analyses."""

from __future__ import annotations

from typing import Any, List

import FreeCAD

from ..errors import ParameterError
from ..features.relations import type_of
from . import panels
from .analysing import analyse_at_once
from .analysis_dock import dock_of_window, show_analyses
from .analysis_form import is_sliceable
from .command import Command, PanelCommand, active_document, document_or_new, selected_objects
from .document_work import is_busy
from .transactions import say

translate = FreeCAD.Qt.translate
KIND = "Trabecula::Analysis"


class AnalyseSlices(PanelCommand):
    """Opens the panel of slice analyses: for the selected analysis or body, or for a new one."""

    NAME, ICON, NEEDS = "Trabecula_Analysis", "Trabecula_analysis", ""
    TEXT, TIP = "Slice analysis", "Slice a mesh, a solid, a design or a file, and measure every slice"

    def run(self, index: int) -> None:
        """Open the panel."""
        document, chosen = document_or_new(), selected_objects()
        analysis = next((obj for obj in chosen if type_of(obj) == KIND), None)
        panels.open_analysis(document, analysis, next((obj for obj in chosen if is_sliceable(obj)), None))


class AnalyseNow(Command):
    """Analyses the selected body at once."""

    NAME, ICON, NEEDS = "Trabecula_AnalyseNow", "Trabecula_analyse_now", "document"
    TEXT, TIP = "Analyse at once", "Slice the selected network, scaffold, mesh or solid, and show the plots"

    def IsActive(self) -> bool:
        """Return whether something is selected."""
        return super().IsActive() and bool(selected_objects())

    def run(self, index: int) -> None:
        """Start the work."""
        bodies = [obj for obj in selected_objects() if is_sliceable(obj)]
        if not bodies:
            raise ParameterError("what is sliced must be a mesh or a solid, got none: select one")
        if is_busy():
            say(translate("Trabecula", "An analysis is on its way already"))
            return
        analyse_at_once(bodies[0], lambda obj: show_analyses([obj]))


class ShowPlots(Command):
    """Shows the dock of slice analyses."""

    NAME, ICON, NEEDS = "Trabecula_Plots", "Trabecula_plots", ""
    TEXT, TIP = "Slices and plots", "Show or hide the profiles of slice analyses and the slice under the cursor"

    def run(self, index: int) -> None:
        """Show or hide it."""
        dock = dock_of_window()
        if dock.isVisible():
            dock.hide()
        else:
            show_analyses([obj for obj in selected_objects() if type_of(obj) == KIND])


class CompareAnalyses(Command):
    """Shows two or more analyses on shared axes."""

    NAME, ICON, NEEDS = "Trabecula_Compare", "Trabecula_compare", "document"
    TEXT, TIP = "Compare analyses", "Show the selected analyses, or all, on shared axes, and how near they are"

    def IsActive(self) -> bool:
        """Return whether there are two analyses."""
        return super().IsActive() and len(_analyses()) > 1

    def run(self, index: int) -> None:
        """Show them."""
        chosen = [obj for obj in selected_objects() if type_of(obj) == KIND]
        show_analyses(chosen if len(chosen) > 1 else _analyses())


def _analyses() -> List[Any]:
    return [obj for obj in active_document().Objects if type_of(obj) == KIND]


#: In the order of toolbar and menu.
COMMANDS = (AnalyseSlices, AnalyseNow, ShowPlots, CompareAnalyses)
