# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be analysed, and what the window does for it; the work itself is that of ``document_work``."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple, Optional

import FreeCAD

from ..core.analysis.parameters import SliceParameters
from ..features.analysis import Analysis, Inputs
from ..features.analysis_makers import default_parameters, design_envelope
from ..features.analysis_source import file_source, object_source
from ..features.estimates import work_of_analysis
from ..features.tasks import write_analysis_task
from .background import work_at_once
from .document_work import Order, check_present, write_step
from .preferences import new_slices
from .work_text import work_text

translate = FreeCAD.Qt.translate


class Wish(NamedTuple):
    """What is to be analysed, and how.

    Attributes
    ----------
    document : str
    parameters : SliceParameters
    source : str
        Name of the object; none means the file.
    envelope : str
        Name of the object to whose slices the porosity refers; none means the body's box.
    file, unit : str
    morphometry : bool
    analysis : str
        Name of the object that is to be changed; none means a new one.
    """

    document: str
    parameters: SliceParameters
    source: str = ""
    envelope: str = ""
    file: str = ""
    unit: str = "auto"
    morphometry: bool = False
    analysis: str = ""

    def inputs(self) -> Inputs:
        """Return all that the analysis depends on.

        Raises
        ------
        TrabeculaError
            If there is nothing to slice.
        """
        check_present(self.document, (self.source, self.envelope))
        document = FreeCAD.getDocument(self.document)
        body = object_source(document.getObject(self.source)) if self.source else file_source(self.file)
        envelope = object_source(document.getObject(self.envelope)) if self.envelope else None
        return Inputs(body, envelope, self.parameters, self.unit, 0.0, self.morphometry)

    def order(self, inputs: Optional[Inputs] = None) -> Order:
        """Return what is to be done for it; of inputs that are known already, if they are given.

        Raises
        ------
        TrabeculaError
            If there is nothing to slice.
        """
        inputs = self.inputs() if inputs is None else inputs
        return Order(
            self.document, Analysis.KIND, inputs.key, lambda folder: write_analysis_task(folder, inputs), self.write,
            self.order, (self.source, self.envelope), self.analysis,
        )  # fmt: skip

    def write(self) -> Any:
        """Write the analysis, which is at hand, into the document in one step; return the object."""
        envelope = f"document.getObject({self.envelope!r})" if self.envelope else "None"
        more = f"parameters, morphometry={self.morphometry!r}, envelope={envelope}"
        if self.analysis:
            line = f"make.change_analysis(document.getObject({self.analysis!r}), {more})"
        elif self.source:
            line = f"make.make_analysis(document, document.getObject({self.source!r}), {more})"
        else:
            line = f"make.make_analysis(document, {self.file!r}, {more}, unit={self.unit!r})"
        return write_step(
            self.document, translate("Trabecula", "Analyse"), self.parameters, (line,), Analysis.Type, self.analysis
        )


def analyse_at_once(source: Any, done: Callable[[Any], None]) -> None:
    """Analyse an object as its kind asks for; the status bar shows how far it is and can end it."""
    envelope = design_envelope(source)
    wish = Wish(
        source.Document.Name, new_slices(default_parameters(source)), source.Name, envelope.Name if envelope else ""
    )
    inputs = wish.inputs()
    work_at_once(wish.order(inputs), done, work_text(work_of_analysis(inputs)))
