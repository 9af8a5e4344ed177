# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds a design: long work in another process, then one step in the document, untouched until then."""

from __future__ import annotations

import importlib.util
import json
from typing import Any, Callable, NamedTuple, Optional, Sequence, Set

import FreeCAD
import Part

from .. import make
from ..core.job import Job
from ..core.records import to_record
from ..errors import DependencyError, TrabeculaError
from ..features.tasks import write_job_task
from .child_work import ChildWork, Progress, task_work
from .install import PACKAGE
from .transactions import record, transaction
from .view_providers import products_of, type_of

#: Works that have not ended yet: a cancelled one lives on here until its process is gone.
_works: Set[ChildWork] = set()


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
        work = task_work(lambda folder: write_job_task(folder, self._job, shape, kinds))
        work.progressed.connect(self._listener.progressed)
        work.succeeded.connect(self._take)
        work.failed.connect(self._fail)
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
            put_into_document(self._target, self._job, self._kinds)
        except TrabeculaError as error:
            self._listener.failed(error)
        else:
            self._listener.done()

    def _fail(self, text: str) -> None:
        self._work = None
        missing = PACKAGE in text and importlib.util.find_spec(PACKAGE) is None
        self._listener.failed(DependencyError(text) if missing else TrabeculaError(text))


def put_into_document(target: Target, job: Job, kinds: Sequence[str]) -> None:
    """Make a design in a document, or change one that is there: one step to undo, recorded in macros.

    Raises
    ------
    TrabeculaError
        If a step fails; the document is then as it was.
    """
    document = FreeCAD.getDocument(target.document)
    with transaction(document, "Design rods"):
        record("import FreeCAD")
        record("from freecad_trabecula import make")
        record("from freecad_trabecula.core.job import job_from_json")
        record(f"document = FreeCAD.getDocument({target.document!r})")
        record(f"job = job_from_json({json.dumps(to_record(job))!r})")
        if target.wireframe:
            record(f"wireframe = document.getObject({target.wireframe!r})")
            record("make.change_design(wireframe, job)")
        else:
            envelope = f", envelope=document.getObject({target.envelope!r})" if target.envelope else ""
            record(f"wireframe = make.make_design(document, job{envelope}).wireframe")
        wireframe = _made(document, target)
        _make_bodies(wireframe, kinds)
        _show(wireframe)


def _made(document: Any, target: Target) -> Any:
    if target.wireframe:
        return document.getObject(target.wireframe)
    return [obj for obj in document.Objects if type_of(obj) == "Trabecula::Wireframe"][-1]


def _make_bodies(wireframe: Any, kinds: Sequence[str]) -> None:
    """Bring the bodies that there are up to date, and make those that are wanted and missing."""
    there = {one.Proxy.KIND: one for one in products_of(wireframe)}
    for kind in kinds:
        parameters = "" if kind == "network" else ", job.scaffold"
        if kind not in there:
            record(f"make.{MAKERS[kind]}(wireframe{parameters})")
            continue
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
    scaffolds = [one for one in bodies if one.Proxy.KIND != "network"]
    for one in bodies:
        one.ViewObject.Visibility = one in scaffolds or not scaffolds
