# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work for a document: done in another process, then one step in the document, untouched until then."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Tuple

import FreeCAD
import FreeCADGui

from .. import make
from ..errors import Cancelled, ParameterError, TrabeculaError
from ..features import results
from ..features.relations import type_of
from .child_work import ChildWork, Progress, start_task
from .qt import invoke_later
from .transactions import record, transaction

translate = FreeCAD.Qt.translate
#: What is written over several turns of the event loop: another step to undo would cut it in two.
open_writings: List[Any] = []
_TURN = 50  # ms until a result that waits looks whether it is its turn


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
    again : callable
        Returns the order for the inputs as they are by then.
    needed : tuple of str
        Names of the objects of which it is made; empty ones count for none.
    changed : str
        Name of the object that is changed; none: a new one is made.
    """

    document: str
    kind: str
    key: str
    write_task: Callable[[str], None]
    write: Callable[[], Any]
    again: Callable[[], Order]
    needed: Tuple[str, ...] = ()
    changed: str = ""


class Listener(NamedTuple):
    """Who is told of a work."""

    progressed: Callable[[Progress], None]
    done: Callable[[Any], None]  # takes the object that was made or changed
    failed: Callable[[TrabeculaError], None]
    begins: Callable[[], None] = lambda: None  # before the first change: what is undone is the look without a panel


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
    """Base of works: another process computes a result, and when it is its turn it is written into a document.

    Parameters
    ----------
    document, kind : str
        Name of the document; of the result, as ``features.results`` has it.
    needed : sequence of str
        Names of the objects of which it is made.
    changed : str
        Name of the object that is changed; none: a new one is made.
    listener : Listener

    Attributes
    ----------
    listener : Listener
        Whoever takes the work over puts another in its place.
    is_left : bool
        Whether it goes on without a panel; then other panels may have a step to undo open.
    """

    def __init__(self, document: str, kind: str, needed: Sequence[str], changed: str, listener: Listener) -> None:
        self.document, self.kind, self.changed, self.listener, self.is_left = document, kind, changed, listener, False
        self._needed = (*needed, changed)
        self._process: Optional[ChildWork] = None
        self._waits = False  # the result has been read and not written yet

    def start(self) -> None:
        """Have the result computed; what is at hand already is written at once.

        Raises
        ------
        TrabeculaError
            If an object is not there any more, or the work cannot be started.
        """
        raise NotImplementedError

    def write(self) -> None:
        """Write the result, which is at hand; if its inputs have changed by now, have it computed anew.

        Raises
        ------
        TrabeculaError
            If it cannot be written; the document is as it was.
        """
        raise NotImplementedError

    @property
    def is_computed(self) -> bool:
        """Whether another process is at work, or what it found waits for its turn."""
        return self._process is not None or self._waits

    def compute(self, write_task: Callable[[str], None]) -> None:
        """Start the other process."""
        check_present(self.document, self._needed)
        self._process = start_task(write_task, self._progress, self._take, self._fail)

    def cancel(self) -> None:
        """End the work; nothing has changed and nothing is heard of it any more."""
        self._waits = False
        if self._process is not None:
            self._process.cancel()
            self._process = None

    def _progress(self, progress: Progress) -> None:
        self.listener.progressed(progress)

    def _take(self, folder: str) -> None:
        self._process = None
        try:
            make.take_results(folder)
        except TrabeculaError as error:
            self.listener.failed(error)
            return
        self._waits = True
        invoke_later(lambda: self._write_in_turn())  # between reading and showing the window has its turn

    def _write_in_turn(self) -> None:
        if not self._waits:
            return  # cancelled meanwhile
        if open_writings or (self.is_left and _has_open_step()):
            invoke_later(lambda: self._write_in_turn(), _TURN)
            return
        self._waits = False
        try:
            check_present(self.document, self._needed)
            self.write()
        except TrabeculaError as error:
            self.listener.failed(error)

    def _fail(self, text: str) -> None:
        self._process = None
        self.listener.failed(self.error(text))

    def error(self, text: str) -> TrabeculaError:
        """Return the error that a sentence of the other process stands for."""
        return TrabeculaError(text)


def _has_open_step() -> bool:
    """Whether a task panel of somebody else's has a step to undo open, which one more would end."""
    return FreeCAD.getActiveTransaction() is not None and bool(FreeCADGui.Control.activeDialog())


class ObjectWork(DocumentWork):
    """Work whose result is one object.

    Parameters
    ----------
    order : Order
    listener : Listener
    """

    def __init__(self, order: Order, listener: Listener) -> None:
        super().__init__(order.document, order.kind, order.needed, order.changed, listener)
        self._order = order

    def start(self) -> None:
        """Have the result computed; what is at hand already is written at once."""
        if results.find(self._order.kind, self._order.key) is None:
            self.compute(self._order.write_task)
        else:
            check_present(self.document, self._needed)
            self.listener.done(self._order.write())

    def write(self) -> None:
        """Write the result, unless its inputs have changed by now."""
        self._order = self._order.again()
        self.start()


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
