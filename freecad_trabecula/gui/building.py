# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds a design: long work in another process, then one step in the document, untouched until then."""

from __future__ import annotations

import importlib.util
import json
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Set

import FreeCAD
import Part

from ..core.job import Job
from ..core.records import to_record
from ..errors import Cancelled, DependencyError, KernelError, TrabeculaError
from ..features.relations import products_of, type_of
from ..features.tasks import write_job_task
from ..features.wireframe import Wireframe
from ..geometry.fingerprints import fingerprint
from . import transactions
from .document_work import DocumentWork, Listener, open_writings
from .install import PACKAGE
from .labels import label_new, names_in
from .language import in_words
from .qt import invoke_later
from .transactions import record

translate = FreeCAD.Qt.translate
_TURN = 50  # ms until a design that waits looks whether it is its turn
Solid = Callable[[], Optional[Part.Shape]]


class Target(NamedTuple):
    """Where a design goes: names of document, envelope ("": a new prism) and wireframe ("": a new one)."""

    document: str
    envelope: str = ""
    wireframe: str = ""


class Building(DocumentWork):
    """One design being built.

    Parameters
    ----------
    target : Target
    job : Job
    kinds : sequence of str
        Bodies to be built, as ``features.results`` names them.
    solid : callable
        Returns the envelope's solid as it is by then; None for the job's prism.
    listener : Listener
    """

    def __init__(self, target: Target, job: Job, kinds: Sequence[str], solid: Solid, listener: Listener) -> None:
        super().__init__(target.document, Wireframe.KIND, (target.envelope,), target.wireframe, listener)
        self._target, self._job, self._kinds, self._solid = target, job, tuple(kinds), solid
        self._filled: Optional[Part.Shape] = None  # what the other process fills
        self._writing: Optional[Writing] = None

    def start(self) -> None:
        """Start the work.

        Raises
        ------
        TrabeculaError
            If it cannot be started.
        """
        shape = self._filled = self._shape()
        kinds = self._kinds or (Wireframe.KIND,)
        self.compute(lambda folder: write_job_task(folder, self._job, shape, kinds))

    def _shape(self) -> Part.Shape:
        prism, solid = self._job.prism, self._solid()
        return solid if solid is not None else Part.makeBox(prism.l, prism.w, prism.h)

    def cancel(self) -> None:
        """End the work; nothing has changed and nothing is heard of it any more."""
        super().cancel()
        if self._writing is not None:
            self._writing.cancel()
            self._writing = None

    def write(self) -> None:
        """Write the design, unless its envelope has changed by now."""
        shape = self._shape()
        if shape is not self._filled and fingerprint(shape) != fingerprint(self._filled):
            self.start()
            return
        self._writing = Writing(self._target, self._job, self._kinds, self.listener)
        self._writing.start()

    def error(self, text: str) -> TrabeculaError:
        """Return the error of a sentence; of a package that is missing, one that offers to install it."""
        missing = PACKAGE in text and importlib.util.find_spec(PACKAGE) is None
        return DependencyError(text) if missing else super().error(text)


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
        self._before: Set[str] = set()
        self._unfinished = ""

    def start(self) -> None:
        """Open the step to undo and begin; while another design is written, wait for it."""
        if open_writings:
            invoke_later(lambda: self._start_if_wanted(), _TURN)  # Qt 6 holds no object for its method
            return
        self._document = FreeCAD.getDocument(self._target.document)
        self._listener.begins()
        self._before = names_in(self._document)
        self._document.openTransaction(translate("Trabecula", "Design rods"))
        open_writings.append(self)
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
        if self in open_writings:
            open_writings.remove(self)

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
                label_new(self._document, self._before)
                self._document.commitTransaction()
                wireframe = self._wireframe()
                self._close()
                self._listener.done(wireframe)
                if self._unfinished:
                    transactions.show_error(in_words(self._unfinished))

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
