# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a slice analysis: its form; the dock shows what comes of it."""

from __future__ import annotations

from typing import Any

import FreeCAD

from ..core.analysis.parameters import SliceParameters, axis_frame, plane_heights
from ..errors import ParameterError, TrabeculaError
from ..features.analysis_makers import default_parameters, design_envelope
from .analysing import Wish
from .analysis_dock import show_analyses
from .analysis_form import AnalysisForm, is_sliceable, sliceable
from .analysis_plots import title
from .document_work import Order
from .preferences import new_slices
from .work_panel import WorkPanel

translate = FreeCAD.Qt.translate


class AnalysisPanel(WorkPanel):
    """A task panel on one document.

    Parameters
    ----------
    document : App.Document
    obj : document object or None
        The analysis that is to be changed; None means a new one.
    source : document object or None
        What a new one slices at first.
    """

    def __init__(self, document: Any, obj: Any = None, source: Any = None) -> None:
        words = (
            *(translate("Trabecula", "Slice analysis"), translate("Trabecula", "Analyse")),
            *("Trabecula_analysis", "commands/Analysis.md"),
        )
        super().__init__(document, obj, source, AnalysisForm(self._changed), words, lambda one: show_analyses([one]))

    def fill(self, source: Any) -> None:
        """Show the values of the analysis, or those that a new one of a source has by default."""
        obj = self.obj
        if obj is not None:
            self.fields.offer(sliceable(self.document), obj.Source, obj.Envelope)
            self.fields.set_value(obj.Proxy.parameters(obj), bool(obj.Morphometry))
            if obj.Source is None:
                self.fields.unit.setCurrentText(obj.Unit)
                self.fields.set_file(obj.File)
            self.lock_source(True)
        else:
            offered = sliceable(self.document)
            source = source if source is not None else (offered[-1] if offered else None)
            self.fields.offer(offered, source, design_envelope(source) if source is not None else None)
            self.fields.set_value(new_slices(default_parameters(source) if source is not None else SliceParameters()))
            self.fields.source.currentIndexChanged.connect(self._take_source)
        self._changed()

    def _take_source(self, *_: Any) -> None:
        """Another body: its own envelope, and rods united."""
        source = self.document.getObject(self.fields.source_name()) if self.fields.source_name() else None
        self.fields.choose(None, design_envelope(source) if source is not None else None)
        self.fields.measures.fields["fill"].set_value(default_parameters(source).fill)

    def _changed(self) -> None:
        """Say how many slices there will be, or what is wrong."""
        try:
            self.message.setText(self._planes(self.fields.value()))
        except TrabeculaError as error:
            self.refuse(error)

    def _planes(self, parameters: SliceParameters) -> str:
        source = self.document.getObject(self.fields.source_name()) if self.fields.source_name() else None
        if source is None or not is_sliceable(source):
            return "" if self.fields.file() else translate("Trabecula", "Choose a body or a file")
        own = (source.Mesh if hasattr(source, "Mesh") else source.Shape).BoundBox
        box = ((own.XMin, own.YMin, own.ZMin), (own.XMax, own.YMax, own.ZMax))
        counts = []
        for axis in parameters.axes:
            low, high = axis_extent(axis, box)
            counts.append(f"{title(axis)} {len(plane_heights(parameters, low, high))}")
        return translate("Trabecula", "Slices: {}").format(", ".join(counts))

    def lock_source(self, locked: bool) -> None:
        """Forbid to choose another body while there is an analysis."""
        for box in (self.fields.source, self.fields.unit):
            box.setEnabled(not locked)

    def order(self) -> Order:
        """Return what is to be analysed.

        Raises
        ------
        ParameterError
            If there is nothing to slice, or a rule is broken.
        """
        source, file = self.fields.source_name(), self.fields.file()
        if not source and not file:
            raise ParameterError("a body to be sliced must be chosen, got none: choose an object or a file")
        wish = Wish(
            self.document.Name, self.fields.value(), source, self.fields.envelope_name(), file,
            self.fields.unit.currentData(), self.fields.morphometry.isChecked(), self.obj.Name if self.obj else "",
        )  # fmt: skip
        return wish.order()


def axis_extent(axis: str, box: Any) -> Any:
    """Return lowest and highest co-ordinate along an axis of a box, given as its two corners.

    Examples
    --------
    >>> axis_extent("y", ((0, 0, 0), (1, 2, 3)))
    (0.0, 2.0)
    """
    corners = [[box[i][0], box[j][1], box[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    along = [float(axis_frame(axis)[2] @ corner) for corner in corners]
    return min(along), max(along)
