# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a slice analysis: its form, the work in another process, and the dock that shows what comes of it."""

from __future__ import annotations

from typing import Any, Optional

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..core.analysis.parameters import SliceParameters, axis_frame, plane_heights
from ..errors import ParameterError, TrabeculaError
from ..features.analysis_makers import default_parameters, design_envelope
from .analysing import Analysing, Wish
from .analysis_dock import show_analyses
from .analysis_form import AnalysisForm, is_sliceable, sliceable
from .analysis_plots import title
from .build_bar import BuildBar
from .outcome import RED
from .qt import Buttons, PanelForm, flags_of, invoke_later, widen_dock
from .transactions import told

translate = FreeCAD.Qt.translate
WIDTH = 400  # pixels that the form needs


class AnalysisPanel:
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
        self.document, self.obj = document, obj
        self._name, self._open, self._closes = document.Name, True, False
        self._work: Optional[Analysing] = None
        self.message = QtGui.QLabel()
        self.message.setWordWrap(True)
        self.fields = AnalysisForm(self._changed)
        words = translate("Trabecula", "Analyse")
        self.build_bar = BuildBar((), self.analyse, self.cancel, words, "Trabecula_analysis")
        self.form = self._make_form()
        self._fill(source)
        FreeCAD.addDocumentObserver(self)
        invoke_later(lambda: widen_dock(self.form, WIDTH))

    def _make_form(self) -> Any:
        form = PanelForm(translate("Trabecula", "Slice analysis"), "Trabecula_analysis")
        column = QtGui.QVBoxLayout(form)
        column.setContentsMargins(6, 4, 6, 4)
        column.setSpacing(4)
        for widget in (self.fields, self.message, self.build_bar):
            column.addWidget(widget)
        return form

    def _fill(self, source: Any) -> None:
        obj = self.obj
        if obj is not None:
            self.fields.offer(sliceable(self.document), obj.Source, obj.Envelope)
            self.fields.set_value(obj.Proxy.parameters(obj), bool(obj.Morphometry))
            if obj.Source is None:
                self.fields.unit.setCurrentText(obj.Unit)
                self.fields.set_file(obj.File)
            for box in (self.fields.source, self.fields.unit):
                box.setEnabled(False)
        else:
            offered = sliceable(self.document)
            source = source if source is not None else (offered[-1] if offered else None)
            self.fields.offer(offered, source, design_envelope(source) if source is not None else None)
            self.fields.set_value(default_parameters(source) if source is not None else SliceParameters())
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
            self.message.setText(f'<span style="color:{RED}">{error}</span>')

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

    # ------------------------------------------------------------------------------------------------------ the work

    def wish(self) -> Wish:
        """Return what is to be analysed.

        Raises
        ------
        ParameterError
            If there is nothing to slice, or a rule is broken.
        """
        source, file = self.fields.source_name(), self.fields.file()
        if not source and not file:
            raise ParameterError("a body to be sliced must be chosen, got none: choose an object or a file")
        return Wish(
            self.document.Name, self.fields.value(), source, self.fields.envelope_name(), file,
            self.fields.unit.currentText(), self.fields.morphometry.isChecked(), self.obj.Name if self.obj else "",
        )  # fmt: skip

    def analyse(self) -> None:
        """Slice and measure in another process; the panel stays open."""
        with told():
            self._start(False)

    def _start(self, closes: bool) -> None:
        if self._work is not None:
            return
        self._closes = closes
        work = Analysing(self.wish(), self.build_bar.show_progress, self._analysed, self._refused)
        self._work = work
        self._set_working(True)
        try:
            work.start()
        except TrabeculaError:
            self._end_work()
            raise

    def cancel(self) -> None:
        """Stop the work; the document is as it was."""
        if self._work is not None:
            self._work.cancel()
            self._end_work()

    def _end_work(self) -> None:
        self._work = None
        if self._open:
            self._set_working(False)

    def _set_working(self, working: bool) -> None:
        (self.build_bar.show_working if working else self.build_bar.show_idle)()
        self.fields.setEnabled(not working)

    def _analysed(self, obj: Any) -> None:
        self._end_work()
        self.obj = obj
        if self._open:
            for box in (self.fields.source, self.fields.unit):
                box.setEnabled(False)
            self.message.setText(obj.Status)
        show_analyses([obj])
        if self._closes and self._open:
            self._leave()
            FreeCADGui.Control.closeDialog()

    def _refused(self, error: TrabeculaError) -> None:
        self._end_work()
        if self._open:
            self.message.setText(f'<span style="color:{RED}">{error}</span>')
        with told():
            raise error

    # ---------------------------------------------------------------------------------------------------- task panel

    def getStandardButtons(self) -> Any:
        """Return the buttons above the form."""
        return flags_of(Buttons.Ok, Buttons.Cancel)

    def accept(self) -> bool:
        """Analyse, then close."""
        with told():
            self._start(True)
        return False

    def reject(self) -> bool:
        """Close the panel; an analysis that was made stays."""
        self.cancel()
        self._leave()
        FreeCADGui.Control.closeDialog()
        return True

    def slotDeletedDocument(self, document: Any) -> None:
        """Close the panel when its document is closed (FreeCAD's observer protocol)."""
        if self._open and document.Name == self._name:
            self._leave()
            self.cancel()
            invoke_later(FreeCADGui.Control.closeDialog)

    def slotDeletedObject(self, obj: Any) -> None:
        """Begin anew when the analysis goes, by undo for instance (FreeCAD's observer protocol)."""
        if self._open and self.obj is not None and obj == self.obj:
            self.obj = None

    def _leave(self) -> None:
        if self._open:
            self._open = False
            FreeCAD.removeDocumentObserver(self)


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
