# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a slice analysis: its form; the dock shows what comes of it."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import FreeCAD

from ..core.analysis.parameters import SliceParameters
from ..core.estimates import Body, Work, analysis_work, planes_of
from ..errors import ParameterError, TrabeculaError
from ..features.analysis_makers import default_parameters, design_envelope
from ..features.analysis_source import body_of_source, file_source, object_source, reading_of_source
from .analysing import Wish
from .analysis_dock import show_analyses
from .analysis_form import AnalysisForm, is_sliceable, likely, sliceable
from .analysis_plots import title
from .document_work import Order
from .preferences import new_slices
from .work_panel import WorkPanel
from .work_text import work_text

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
        self._looked_at: Tuple[Tuple[str, str, str], Optional[Tuple[Body, Work]]] = (("", "", ""), None)
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
            source = source if source is not None else likely(offered)
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
        """Say how many slices there will be and what they will take, or what is wrong."""
        try:
            self.message.setText(self._estimate(self.fields.value()))
        except TrabeculaError as error:
            self.refuse(error)

    def _estimate(self, parameters: SliceParameters) -> str:
        known = self._known()
        if known is None:
            return translate("Trabecula", "Choose a body or a file")
        body, reading = known
        planes = planes_of(parameters, body.box)
        counts = ", ".join(f"{title(axis)} {number}" for axis, (number, _) in planes.items())
        work = analysis_work(body, list(planes.values()), self.fields.morphometry.isChecked())
        said = work_text(reading.and_then(work))
        slices = translate("Trabecula", "Slices: {}").format(counts) if counts else ""
        return "; ".join(words for words in (slices, said) if words)

    def _known(self) -> Optional[Tuple[Body, Work]]:
        """What is known of what is sliced, and its reading; looked at once, for the form is typed into."""
        name, file, unit = self.fields.source_name(), self.fields.file(), self.fields.unit.currentData()
        if (name, file, unit) != self._looked_at[0]:
            body = self.document.getObject(name) if name else None
            if body is not None:
                source = object_source(body) if is_sliceable(body) else None
            else:
                source = file_source(file) if file else None
            found = body_of_source(source, unit) if source is not None else None
            known = (found, reading_of_source(source, found)) if found is not None else None
            self._looked_at = (name, file, unit), known
        return self._looked_at[1]

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
