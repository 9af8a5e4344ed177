# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyses a body: slicing and measuring in another process, then one step in the document, untouched until then."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Callable, NamedTuple, Optional, Set

import FreeCAD

from .. import make
from ..core.analysis.parameters import SliceParameters
from ..errors import TrabeculaError
from ..features import results
from ..features.analysis import Analysis, Inputs
from ..features.analysis_source import file_source, object_source
from ..features.tasks import write_analysis_task
from .child_work import ChildWork, task_work
from .recomputing import WorkBar
from .transactions import record, told, transaction
from .view_providers import type_of

translate = FreeCAD.Qt.translate
_works: Set[ChildWork] = set()  # a cancelled one lives on here until its process is gone


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
        document = FreeCAD.getDocument(self.document)
        body = object_source(document.getObject(self.source)) if self.source else file_source(self.file)
        envelope = object_source(document.getObject(self.envelope)) if self.envelope else None
        return Inputs(body, envelope, self.parameters, self.unit, 0.0, self.morphometry)


class Analysing:
    """One analysis on its way into a document.

    Parameters
    ----------
    wish : Wish
    progressed : callable
        Takes a ``child_work.Progress``.
    done : callable
        Takes the analysis object.
    failed : callable
        Takes the error.
    """

    def __init__(
        self,
        wish: Wish,
        progressed: Callable[[Any], None],
        done: Callable[[Any], None],
        failed: Callable[[TrabeculaError], None],
    ) -> None:
        self._wish, self._progressed, self._done, self._failed = wish, progressed, done, failed
        self._work: Optional[ChildWork] = None

    def start(self) -> None:
        """Start the work; what is at hand already is written at once.

        Raises
        ------
        TrabeculaError
            If there is nothing to slice, or the work cannot be started.
        """
        inputs = self._wish.inputs()
        if results.find(Analysis.KIND, inputs.key) is not None:
            self._write()
            return
        work = task_work(lambda folder: write_analysis_task(folder, inputs))
        work.progressed.connect(self._progressed)
        work.succeeded.connect(self._take)
        work.failed.connect(lambda text: self._failed(TrabeculaError(text)))
        work.process.finished.connect(lambda *_: _works.discard(work))
        _works.add(work)
        self._work = work
        work.start()

    def cancel(self) -> None:
        """End the work; nothing has changed and nothing is heard of it any more."""
        if self._work is not None:
            self._work.cancel()
            self._work = None

    def _take(self, folder: str) -> None:
        self._work = None
        try:
            make.take_results(folder)
            if self._wish.document in FreeCAD.listDocuments():
                self._write()
        except TrabeculaError as error:
            self._failed(error)

    def _write(self) -> None:
        wish, document = self._wish, FreeCAD.getDocument(self._wish.document)
        before = {obj.Name for obj in document.Objects}
        with transaction(document, "Analyse"):
            record("import FreeCAD")
            record("from freecad_trabecula import make")
            record("from freecad_trabecula.core.analysis.parameters import SliceParameters")
            record(f"document = FreeCAD.getDocument({wish.document!r})")
            record(f"parameters = {parameters_text(wish.parameters)}")
            envelope = f"document.getObject({wish.envelope!r})" if wish.envelope else "None"
            more = f"parameters, morphometry={wish.morphometry!r}, envelope={envelope}"
            if wish.analysis:
                record(f"make.change_analysis(document.getObject({wish.analysis!r}), {more})")
            elif wish.source:
                record(f"make.make_analysis(document, document.getObject({wish.source!r}), {more})")
            else:
                record(f"make.make_analysis(document, {wish.file!r}, {more}, unit={wish.unit!r})")
        new = [obj for obj in document.Objects if obj.Name not in before and type_of(obj) == Analysis.Type]
        self._done(document.getObject(wish.analysis) if wish.analysis else new[-1])


def parameters_text(parameters: SliceParameters) -> str:
    """Return the Python text that makes parameters; what is as by default is left out.

    Examples
    --------
    >>> parameters_text(SliceParameters(thickness=0.2, axes=("z",)))
    "SliceParameters(thickness=0.2, axes=('z',))"
    """
    named = []
    for field in dataclasses.fields(parameters):
        value = getattr(parameters, field.name)
        is_nan = isinstance(value, float) and math.isnan(value)
        if value != field.default and not is_nan:
            named.append(f"{field.name}={value!r}")
    return f"SliceParameters({', '.join(named)})"


_current: list = []


def analyse_at_once(source: Any, done: Callable[[Any], None]) -> None:
    """Analyse an object as its kind asks for; the status bar shows how far it is and can end it."""
    from ..features.analysis_makers import default_parameters, design_envelope

    envelope = design_envelope(source)
    wish = Wish(source.Document.Name, default_parameters(source), source.Name, envelope.Name if envelope else "")

    def finish(obj: Any = None) -> None:
        bar.hide()
        bar.deleteLater()
        _current.clear()
        if obj is not None:
            done(obj)

    def fail(error: TrabeculaError) -> None:
        finish()
        with told():
            raise error

    def cancel() -> None:
        work.cancel()
        finish()

    bar = WorkBar(cancel)
    work = Analysing(wish, bar.show_progress, finish, fail)
    _current[:] = [work]
    bar.show_start()
    try:
        work.start()
    except TrabeculaError:
        finish()
        raise


def is_busy() -> bool:
    """Return whether an analysis that was asked for with one click is on its way."""
    return bool(_current)
