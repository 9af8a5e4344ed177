# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds a design: long work in another process, then one step in the document, untouched until then."""

from __future__ import annotations

import importlib.util
import json
from typing import Any, Callable, List, NamedTuple, Optional, Sequence

import FreeCAD
import Part

from .. import make
from ..core.job import Job
from ..core.records import to_record
from ..errors import Cancelled, DependencyError, KernelError, TrabeculaError
from ..features.relations import products_of, type_of
from ..features.tasks import write_job_task
from . import transactions
from .child_work import ChildWork, Progress, start_task
from .document_work import check_present
from .install import PACKAGE
from .notice import tell_of
from .qt import invoke_later
from .recomputing import WorkBar, document_label
from .transactions import record, told

#: The design that is being written: a step to undo that another document opens meanwhile would cut this one in two.
_open_writings: List[Any] = []
_TURN = 50  # ms until a design that waits looks whether it is its turn


_left: List[Building] = []  # those that go on without a panel


def is_being_built(wireframe: Any) -> bool:
    """Return whether a design is built for which no panel is open."""
    return any(one.is_for(wireframe.Document.Name, wireframe.Name) for one in _left)


class Target(NamedTuple):
    """Where a design goes: names of document, envelope ("": a new prism) and wireframe ("": a new one)."""

    document: str
    envelope: str = ""
    wireframe: str = ""


class Listener(NamedTuple):
    """Who is told of the work."""

    progressed: Callable[[Progress], None]
    done: Callable[[], None]
    failed: Callable[[TrabeculaError], None]
    begins: Callable[[], None] = lambda: None  # before the first change: what is undone is the look without a panel


class Building:
    """One design being built.

    Parameters
    ----------
    target : Target
    job : Job
    kinds : sequence of str
        Bodies to be built, as ``features.results`` names them.
    listener : Listener
    """

    def __init__(self, target: Target, job: Job, kinds: Sequence[str], listener: Listener) -> None:
        self._target, self._job, self._kinds, self._listener = target, job, tuple(kinds), listener
        self._work: Optional[ChildWork] = None
        self._writing: Optional[Writing] = None

    def start(self, solid: Optional[Part.Shape]) -> None:
        """Start the work on the envelope's solid; None for the job's prism.

        Raises
        ------
        TrabeculaError
            If it cannot be started.
        """
        prism = self._job.prism
        shape = solid if solid is not None else Part.makeBox(prism.l, prism.w, prism.h)
        kinds = self._kinds or ("wireframe",)
        self._work = start_task(
            lambda folder: write_job_task(folder, self._job, shape, kinds),
            self._progress,
            self._take,
            self._fail,
        )

    def cancel(self) -> None:
        """End the work; nothing has changed and nothing is heard of it any more."""
        if self._work is not None:
            self._work.cancel()
            self._work = None
        if self._writing is not None:
            self._writing.cancel()
            self._writing = None

    def leave_to_status_bar(self) -> bool:
        """Go on without a panel: the status bar shows how far it is and can end it.

        Returns
        -------
        bool
            False if the design is being written already, which takes a moment.
        """
        if self._work is None:
            return False
        document = self._target.document

        def end(is_good: bool) -> None:
            bar.close_bar()
            _left.remove(self)
            tell_of(document, "", is_good)

        def fail(error: TrabeculaError) -> None:
            end(False)
            with told():
                raise error

        def cancel() -> None:
            self.cancel()
            bar.close_bar()
            _left.remove(self)

        bar = WorkBar(cancel, document_label(document))
        self._listener = Listener(bar.show_progress, lambda: end(True), fail)
        _left.append(self)
        bar.show_start()
        return True

    def is_for(self, document: str, wireframe: str) -> bool:
        """Return whether it changes a design."""
        return (self._target.document, self._target.wireframe) == (document, wireframe)

    def _progress(self, progress: Progress) -> None:
        self._listener.progressed(progress)

    def _take(self, folder: str) -> None:
        self._work = None
        try:
            make.take_results(folder)
            check_present(self._target.document, (self._target.envelope, self._target.wireframe))
        except TrabeculaError as error:
            self._listener.failed(error)
            return
        self._writing = Writing(self._target, self._job, self._kinds, self._listener)
        self._writing.start()

    def _fail(self, text: str) -> None:
        self._work = None
        missing = PACKAGE in text and importlib.util.find_spec(PACKAGE) is None
        self._listener.failed(DependencyError(text) if missing else TrabeculaError(text))


class Writing:
    """Puts a design into a document, or changes one that is there: one step to undo, recorded in macros.

    Between its steps the window gets its turn; what they need has been computed before.
    """

    def __init__(self, target: Target, job: Job, kinds: Sequence[str], listener: Listener) -> None:
        self._target, self._job, self._listener = target, job, listener
        self._steps: List[Callable[[], None]] = [self._write_design]
        self._steps += [lambda kind=kind: self._write_body(kind) for kind in kinds]
        self._steps += [lambda: _show(self._wireframe()), self._let_follow]
        self._document: Any = None
        self._unfinished = ""

    def start(self) -> None:
        """Open the step to undo and begin; while another design is written, wait for it."""
        if _open_writings:
            invoke_later(lambda: self._start_if_wanted(), _TURN)  # Qt 6 holds no object for its method
            return
        self._document = FreeCAD.getDocument(self._target.document)
        self._listener.begins()
        self._document.openTransaction("Design rods")
        _open_writings.append(self)
        self._go_on()

    def _start_if_wanted(self) -> None:
        if not self._steps:
            return  # cancelled meanwhile
        if self._target.document in FreeCAD.listDocuments():
            self.start()
        else:
            self._listener.failed(Cancelled("the document was closed"))

    def cancel(self) -> None:
        """Take back what was written."""
        self._steps = []
        if self._document is not None and self._target.document in FreeCAD.listDocuments():
            self._document.abortTransaction()
        self._close()

    def _close(self) -> None:
        self._document = None
        if self in _open_writings:
            _open_writings.remove(self)

    def _go_on(self) -> None:
        if self._document is None:
            return
        try:
            if self._steps:
                self._steps.pop(0)()
        except TrabeculaError as error:
            self.cancel()
            self._listener.failed(error)
        except BaseException:
            self.cancel()
            self._listener.failed(KernelError("the design could not be written; the report view says why"))
            raise
        else:
            if self._steps:
                invoke_later(self._go_on)
            else:
                self._document.commitTransaction()
                self._close()
                self._listener.done()
                if self._unfinished:
                    transactions.show_error(self._unfinished)

    def _write_design(self) -> None:
        target = self._target
        record("import FreeCAD")
        record("from freecad_trabecula import make")
        record("from freecad_trabecula.core.job import job_from_json")
        record(f"document = FreeCAD.getDocument({target.document!r})")
        record(f"job = job_from_json({json.dumps(to_record(self._job))!r})")
        if target.wireframe:
            record(f"wireframe = document.getObject({target.wireframe!r})")
            record("make.change_design(wireframe, job)")
        else:
            envelope = f", envelope=document.getObject({target.envelope!r})" if target.envelope else ""
            record(f"wireframe = make.make_design(document, job{envelope}).wireframe")

    def _let_follow(self) -> None:
        """Have analyses of the bodies computed anew, and what else is made of them."""
        self._document.recompute()

    def _wireframe(self) -> Any:
        if self._target.wireframe:
            return self._document.getObject(self._target.wireframe)
        return [obj for obj in self._document.Objects if type_of(obj) == "Trabecula::Wireframe"][-1]

    def _write_body(self, kind: str) -> None:
        """Bring a body that there is up to date, or make it."""
        wireframe = self._wireframe()
        # said anew: between two steps another document's design may have been written with the same words
        record(f"document = FreeCAD.getDocument({self._target.document!r})")
        record(f"wireframe = document.getObject({wireframe.Name!r})")
        record(f"job = job_from_json({json.dumps(to_record(self._job))!r})")
        there = {one.Proxy.KIND: one for one in products_of(wireframe)}
        parameters = "" if kind == "network" else ", job.scaffold"
        if kind not in there:
            try:
                record(f"make.{MAKERS[kind]}(wireframe{parameters})")
            except KernelError as error:
                if kind != "solid":
                    raise
                self._unfinished = str(error)  # it says how far it came; the mesh stands
            return
        record(f"body = document.getObject({there[kind].Name!r})")
        if parameters:
            record("from freecad_trabecula.features.base import write_parameters")
            record("write_parameters(body, job.scaffold)")
        record("make.update(body)")


#: The function that makes a body of each kind.
MAKERS = {"network": "make_network", "scaffold": "make_scaffold", "solid": "make_solid_scaffold"}


def _show(wireframe: Any) -> None:
    """Show what is solid in place of what it was made from."""
    bodies = products_of(wireframe)
    for obj in (wireframe.Envelope, *wireframe.Sites, wireframe):
        obj.ViewObject.Visibility = not bodies
    if not bodies:
        wireframe.Envelope.ViewObject.Transparency = max(wireframe.Envelope.ViewObject.Transparency, 85)
    # one at a time: the scaffold as a mesh and as a solid lie in the same place
    seen = min(bodies, key=lambda one: ("scaffold", "solid", "network").index(one.Proxy.KIND), default=None)
    for one in bodies:
        one.ViewObject.Visibility = one is seen
