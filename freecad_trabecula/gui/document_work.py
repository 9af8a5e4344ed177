# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work for a document object: done in another process, then one step in the document, untouched until then."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Callable, Dict, NamedTuple, Optional, Sequence, Tuple

import FreeCAD

from .. import make
from ..errors import Cancelled, ParameterError, TrabeculaError
from ..features import results
from ..features.relations import type_of
from .child_work import ChildWork, start_task
from .notice import tell_of
from .qt import invoke_later
from .recomputing import WorkBar, document_label
from .transactions import record, told, transaction

translate = FreeCAD.Qt.translate


class Order(NamedTuple):
    """What is to be done and where it comes to.

    Attributes
    ----------
    document : str
    kind, key : str
        Of the result, as ``features.results`` has them.
    write_task : callable
        Takes the folder in which the other process finds its work.
    write : callable
        Writes the result, once it is at hand, into the document; returns the object.
    needed : tuple of str
        Names of the objects that ``write`` takes; empty ones count for none.
    """

    document: str
    kind: str
    key: str
    write_task: Callable[[str], None]
    write: Callable[[], Any]
    needed: Tuple[str, ...] = ()


def check_present(document: str, needed: Sequence[str]) -> None:
    """Check that a document is open and has objects of some names; empty ones count for none.

    Raises
    ------
    Cancelled
        If the document was closed.
    ParameterError
        If an object was deleted.
    """
    if document not in FreeCAD.listDocuments():
        raise Cancelled("the document was closed")
    for name in filter(None, needed):
        if FreeCAD.getDocument(document).getObject(name) is None:
            raise ParameterError(translate("Trabecula", "{} was deleted meanwhile").format(name))


class DocumentWork:
    """One result on its way into a document.

    Parameters
    ----------
    order : Order
    progressed : callable
        Takes a ``child_work.Progress``.
    done : callable
        Takes the object.
    failed : callable
        Takes the error.
    """

    def __init__(
        self,
        order: Order,
        progressed: Callable[[Any], None],
        done: Callable[[Any], None],
        failed: Callable[[TrabeculaError], None],
    ) -> None:
        self._order, self._progressed, self._done, self._failed = order, progressed, done, failed
        self._work: Optional[ChildWork] = None
        self._is_taken = False  # the result has been read and not written yet

    def start(self) -> None:
        """Start the work; what is at hand already is written at once.

        Raises
        ------
        TrabeculaError
            If an object is not there any more, or the work cannot be started.
        """
        check_present(self._order.document, self._order.needed)
        if results.find(self._order.kind, self._order.key) is not None:
            self._done(self._order.write())
            return
        self._work = start_task(self._order.write_task, self._progressed, self._take, self._fail)

    def cancel(self) -> None:
        """End the work; nothing has changed and nothing is heard of it any more."""
        self._is_taken = False
        if self._work is not None:
            self._work.cancel()
            self._work = None

    def _take(self, folder: str) -> None:
        self._work = None
        try:
            make.take_results(folder)
        except TrabeculaError as error:
            self._failed(error)
            return
        self._is_taken = True
        invoke_later(lambda: self._write())  # between reading and showing the window has its turn

    def _write(self) -> None:
        if not self._is_taken:
            return  # cancelled meanwhile
        self._is_taken = False
        try:
            check_present(self._order.document, self._order.needed)
            self._done(self._order.write())
        except TrabeculaError as error:
            self._failed(error)

    def _fail(self, text: str) -> None:
        self._work = None
        self._failed(TrabeculaError(text))


_current: Dict[str, DocumentWork] = {}  # by the document's name: each has its own


def work_at_once(order: Order, done: Callable[[Any], None], estimate: str = "") -> None:
    """Do what was asked for with one click; the status bar shows what it will take, how far it is, and can end it.

    Raises
    ------
    TrabeculaError
        If the work cannot be started.
    """

    def finish(obj: Any = None) -> None:
        bar.close_bar()
        _current.pop(order.document, None)
        if obj is not None:
            tell_of(order.document, obj.Name, True)
            done(obj)

    def fail(error: TrabeculaError) -> None:
        finish()
        tell_of(order.document, "", False)
        with told():
            raise error

    def cancel() -> None:
        work.cancel()
        finish()

    bar = WorkBar(cancel, document_label(order.document))
    work = DocumentWork(order, bar.show_progress, finish, fail)
    _current[order.document] = work
    bar.show_start(estimate)
    try:
        work.start()
    except TrabeculaError:
        finish()
        raise


def is_busy(document: str = "") -> bool:
    """Return whether something that was asked for with one click is on its way, in one document or in any."""
    return document in _current if document else bool(_current)


def write_step(document: str, step: str, parameters: Any, lines: Sequence[str], kind: str, changed: str = "") -> Any:
    """Run lines of Python as one step to undo, as if typed; return the object that was made or changed.

    Parameters
    ----------
    document : str
    step : str
        What the step is called.
    parameters : object
        A parameter object, which the lines know as ``parameters``; the document as ``document``.
    lines : sequence of str
    kind : str
        ``Type`` of the object.
    changed : str
        Name of the object that is changed; none: a new one is made.

    Raises
    ------
    TrabeculaError
        What the lines raise; the document is as it was.
    """
    target, module = FreeCAD.getDocument(document), type(parameters).__module__
    before = {obj.Name for obj in target.Objects}
    with transaction(target, step):
        for line in (
            "import FreeCAD",
            "from freecad_trabecula import make",
            f"from {module} import {type(parameters).__name__}",
            f"document = FreeCAD.getDocument({document!r})",
            f"parameters = {parameters_text(parameters)}",
            *lines,
        ):
            record(line)
    new = [obj for obj in target.Objects if obj.Name not in before and type_of(obj) == kind]
    return target.getObject(changed) if changed else new[-1]


def parameters_text(parameters: Any) -> str:
    """Return the Python text that makes parameters; what is as by default is left out.

    Examples
    --------
    >>> from freecad_trabecula.core.analysis.parameters import SliceParameters
    >>> parameters_text(SliceParameters(thickness=0.2, axes=("z",)))
    "SliceParameters(thickness=0.2, axes=('z',))"
    """
    named = []
    for field in dataclasses.fields(parameters):
        value = getattr(parameters, field.name)
        is_nan = isinstance(value, float) and math.isnan(value)
        if value != field.default and not is_nan:
            named.append(f"{field.name}={value!r}")
    return f"{type(parameters).__name__}({', '.join(named)})"
