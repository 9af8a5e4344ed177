# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the profiles that a voxel design is to have along X, Y and Z, anew or from those of an analysis."""

from __future__ import annotations

import math
from typing import Any, Optional, Sequence

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtGui

from .. import make
from ..core.voxels.drawn_curves import DrawnCurves, curve_volumes, curves_of_areas, reconciled
from ..core.voxels.targets import AXES
from ..errors import TrabeculaError
from .curve_view import CurveView
from .fields import NumberField, row_widget
from .language import in_words, local_number
from .object_choice import ObjectChoice
from .qt import Buttons, run_dialog, word_colour
from .transactions import told

translate = FreeCAD.Qt.translate
_SAME = 5e-3  # relative: totals that far apart are told
_BAD = "#c62828"


class CurveDialog(QtGui.QDialog):
    """Three curves in a box, and the volume that each asks for.

    Parameters
    ----------
    parent : widget
    curves : DrawnCurves or None
        To begin with.
    analyses : sequence of document objects
        Whose profiles can be taken.
    """

    def __init__(self, parent: Any, curves: Optional[DrawnCurves] = None, analyses: Sequence[Any] = ()) -> None:
        super().__init__(parent)
        self.setWindowTitle(translate("Trabecula", "Draw sliced areas"))
        self.edges = [NumberField("mm", 0.5, self.refresh, axis) for axis in "XYZ"]
        self.analysis, self._analyses = ObjectChoice(), {one.Name: one for one in analyses}
        self.in_areas = QtGui.QCheckBox(translate("Trabecula", "areas in mm²"))
        self.in_areas.setToolTip(translate("Trabecula", "Off: share of the layer in %"))
        self.views = [CurveView(axis, self.refresh, self._refuse) for axis in AXES]
        self.totals, self.message = [QtGui.QLabel() for _ in AXES], QtGui.QLabel()
        self.message.setWordWrap(True)
        self.buttons = Buttons(Buttons.Ok | Buttons.Cancel)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        self.one_total = self.buttons.addButton(translate("Trabecula", "One total"), Buttons.ActionRole)
        self.one_total.setToolTip(translate("Trabecula", "Raise or lower the curves until all ask for the mean volume"))
        self.one_total.clicked.connect(lambda *_: self.reconcile())
        self._lay_out(analyses)
        self._showing = False
        self.show_curves(curves or DrawnCurves())
        self.analysis.currentIndexChanged.connect(lambda *_: self._take_analysis())
        self.in_areas.toggled.connect(lambda *_: self.refresh())

    def _lay_out(self, analyses: Sequence[Any]) -> None:
        box, start = row_widget(), row_widget()
        for field in self.edges:
            box.layout().addWidget(field.widget, 1)
        box.layout().addWidget(self.in_areas)
        self.analysis.offer(list(analyses), translate("Trabecula", "nothing: drawn anew"))
        self.analysis.setEnabled(bool(analyses))
        start.layout().addWidget(self.analysis, 1)
        top = QtGui.QFormLayout()
        top.addRow(translate("Trabecula", "Edges X, Y, Z"), box)
        top.addRow(translate("Trabecula", "Begin with"), start)
        column = QtGui.QVBoxLayout(self)
        column.addLayout(top)
        for view, label in zip(self.views, self.totals):
            column.addWidget(view, 1)
            column.addWidget(label)
        column.addWidget(self.message)
        column.addWidget(self.buttons)
        self.resize(620, 700)

    # ---------------------------------------------------------------------------------------------------- the curves

    def show_curves(self, curves: DrawnCurves, profiles: Sequence[Optional[np.ndarray]] = (None, None, None)) -> None:
        """Show curves, and profiles behind them."""
        self._showing = True
        for field, edge in zip(self.edges, curves.edges):
            field.set_value(edge)
        for view, points, profile in zip(self.views, curves.curves, profiles):
            view.show_points(points, profile)
        self._showing = False
        self.refresh()

    def curves(self) -> DrawnCurves:
        """Return what is drawn.

        Raises
        ------
        ParameterError
            If an edge is not above 0.
        """
        return DrawnCurves(tuple(field.value() for field in self.edges), *(view.points for view in self.views))

    def _take_analysis(self) -> None:
        """Begin with the profiles of the chosen analysis."""
        chosen = self._analyses.get(self.analysis.object_name())
        if chosen is None:
            return
        with told():
            areas, thickness = make.layer_areas_of(chosen)
            curves = curves_of_areas(areas, thickness)
            layer = math.prod(curves.edges)
            self.show_curves(curves, [own * edge / layer for own, edge in zip(areas, curves.edges)])

    def reconcile(self) -> None:
        """Give all curves one volume."""
        with told():
            curves = reconciled(self.curves())
            self.show_curves(curves, [view.profile for view in self.views])

    def refresh(self) -> None:
        """Tell what the curves ask for."""
        if getattr(self, "_showing", True):
            return
        self.message.setText("")
        try:
            curves = self.curves()
        except TrabeculaError as error:
            self._refuse(str(error))
            self.buttons.button(Buttons.Ok).setEnabled(False)
            return
        self.buttons.button(Buttons.Ok).setEnabled(True)
        box, volumes = math.prod(curves.edges), curve_volumes(curves)
        for view, label, edge, volume in zip(self.views, self.totals, curves.edges, volumes):
            view.show_scale(edge, box / edge if self.in_areas.isChecked() else 0.0)
            label.setText(
                translate("Trabecula", "total along {}: {} mm³, {} % of the box").format(
                    view.axis.upper(), local_number(volume, ".4g"), local_number(100 * volume / box, ".2f")
                )
            )
        mean = sum(volumes) / 3
        apart = max(volumes) - min(volumes) > _SAME * mean
        self.one_total.setEnabled(apart and min(volumes) > 0)
        if apart:
            self.message.setText(
                translate("Trabecula", "The totals differ; a design scales all curves to their mean, {} mm³").format(
                    local_number(mean, ".4g")
                )
            )

    def _refuse(self, text: str) -> None:
        """Say why a change was not made."""
        self.message.setText(f'<span style="color:{word_colour(_BAD)}">{in_words(text)}</span>')


def ask_for_curves(curves: Optional[DrawnCurves], analyses: Sequence[Any]) -> Optional[DrawnCurves]:
    """Let the user draw curves; return them, None if none were wanted."""
    dialog = CurveDialog(FreeCADGui.getMainWindow(), curves, analyses)
    return dialog.curves() if run_dialog(dialog) else None
