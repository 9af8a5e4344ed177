# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes previews in a thread of its own: the newest request counts, older ones are dropped on the way.

numpy and the kernel are called in small steps, between which the window's thread gets its turn: it never waits for
long, and computes nothing itself.
"""

from __future__ import annotations

import threading
import time
import traceback
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Dict, NamedTuple, Optional, Sequence, Tuple

import FreeCAD
import Part
from PySide import QtCore

from ..core import engines
from ..core.assembly import draft_wireframe
from ..core.couplings import CouplingRow
from ..core.job import Job
from ..core.parameters import PrismParameters
from ..core.porosity_estimate import estimate_porosity
from ..core.wireframe import Wireframe
from ..errors import Cancelled, TrabeculaError
from ..features.tasks import job_inputs
from ..features.wireframe import Inputs, made
from ..geometry.design import edited, pore_warnings
from .drawing import Drawing, draw_wireframe

#: Seconds without a change after which the porosity is estimated.
CALM = 0.15
#: Seconds for which a drawing is finished though a newer one is wanted: else a dragged value would show nothing.
PATIENCE = 0.5
#: Seconds between two changes below which a value is being dragged: rods are then shown before faulty ones are mended.
HURRY = 0.3
FEW = 1000  # rods; drafts of more are not made, since their count has not been checked


class Request(NamedTuple):
    """What is to be previewed: a job, and the envelope's solid unless the job's prism is meant."""

    job: Job
    solid: Optional[Part.Shape] = None


class Outline(NamedTuple):
    """A preview and what is known of it at once; ``job`` is None while faulty rods are not mended yet."""

    job: Optional[Job]
    drawing: Drawing
    rods: int
    rows: Tuple[CouplingRow, ...]
    counts: Dict[str, int]
    mended: int
    failed: int
    outside: int


class Estimate(NamedTuple):
    """Porosity of the rods' union and its error, plain sum of the rods, shares of 1; warnings; whether it is final.

    ``work`` is what the engine that would be taken needs for the scaffold; None if there are no rods.
    """

    porosity: float
    error: float
    plain_sum: float
    warnings: Sequence[str]
    is_mended: bool = True
    work: Optional[engines.Estimate] = None


class PreviewWorker(QtCore.QObject):
    """The thread: ``request`` wakes it, its signals arrive in the window's thread."""

    drawn = QtCore.Signal(object)
    estimated = QtCore.Signal(object)
    refused = QtCore.Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._condition = threading.Condition()
        self._waiting: Optional[Request] = None
        self._closed = self._busy = False
        self._patience = self._asked = 0.0
        self._hurried = False
        self._prism: Tuple[Optional[PrismParameters], Optional[Part.Shape]] = (None, None)
        self._thread = ThreadPoolExecutor(1, "trabecula-preview")

    def request(self, request: Request) -> None:
        """Ask for a preview in place of all earlier ones."""
        now = time.monotonic()
        with self._condition:
            self._hurried = self._busy or now - self._asked < HURRY
            self._asked = now
            self._waiting = request
            self._condition.notify()
            self._submit()

    def close(self) -> None:
        """End the thread; it sends nothing more."""
        with self._condition:
            self._closed, self._waiting = True, None
            self._condition.notify()
        self._thread.shutdown(wait=False)

    # ------------------------------------------------------------------------------------------------- the thread

    def _submit(self) -> None:
        """Give the newest request to the thread, if it is free."""
        if self._waiting is not None and not self._busy and not self._closed:
            request, self._waiting, self._busy = self._waiting, None, True
            self._thread.submit(self._serve, request).add_done_callback(self._served)

    def _served(self, work: Future) -> None:
        """Tell what went wrong, whatever it was, and go on."""
        error = work.exception()
        if isinstance(error, TrabeculaError) and not isinstance(error, Cancelled):
            self._send(self.refused, str(error))
        elif error is not None and not isinstance(error, Cancelled):
            trace = traceback.format_exception(type(error), error, error.__traceback__)
            FreeCAD.Console.PrintLog("".join(trace))
            self._send(self.refused, f"the preview failed: {type(error).__name__}: {error}")
        with self._condition:
            self._busy = False
            self._submit()

    def _serve(self, request: Request) -> None:
        self._patience = time.monotonic() + PATIENCE
        solid = request.solid if request.solid is not None else self._prism_solid(request.job.prism)
        inputs = job_inputs(request.job, solid, self._progress)
        is_slow = request.solid is not None  # rods are then looked for outside the envelope, point by point
        if (self._hurried or is_slow) and _most_rods(inputs) <= FEW:
            sites = edited(inputs.faces, inputs.parameters.edits)
            draft = draft_wireframe(inputs.parameters, sites, inputs.envelope.region, self._progress)
            self._draw(request, inputs, draft, False)
            self._rest()
            if is_slow:
                self._send(self.estimated, self._estimate(request, inputs, draft, ())._replace(is_mended=False))
        wireframe = made(inputs, self._progress)
        self._draw(request, inputs, wireframe, True)
        self._rest()
        warnings = pore_warnings(wireframe, inputs.faces)
        self._progress(0, 1, "")
        self._send(self.estimated, self._estimate(request, inputs, wireframe, warnings))

    def _draw(self, request: Request, inputs: Inputs, wireframe: Wireframe, final: bool) -> None:
        drawing = draw_wireframe(wireframe, inputs.envelope.low, inputs.envelope.high)
        counts = {label: int(one.on.sum()) for label, one in wireframe.sites.items()}
        outcome = (len(wireframe.recoveries), len(wireframe.failed), len(wireframe.outside))
        job = request.job if final else None
        self._send(self.drawn, Outline(job, drawing, len(wireframe), wireframe.rows, counts, *outcome))

    def _rest(self) -> None:
        """Wait until values have been calm for a while; give up when a newer one comes."""
        self._patience = 0.0
        with self._condition:
            if self._waiting is None and not self._closed:
                self._condition.wait(CALM)
        self._progress(0, 1, "")
        self._hurried = False

    def _progress(self, done: float, total: float, what: str) -> None:
        """Give up when there is something newer to do; but a drawing that is soon done is shown while values change."""
        stale = self._waiting is not None and time.monotonic() > self._patience
        if stale or self._closed:
            raise Cancelled("a newer preview is wanted")

    def _send(self, signal: Any, value: Any) -> None:
        if not self._closed:
            try:
                signal.emit(value)
            except RuntimeError:  # the window is gone
                self._closed = True

    def _prism_solid(self, prism: PrismParameters) -> Part.Shape:
        if self._prism[0] != prism:
            self._prism = prism, Part.makeBox(prism.l, prism.w, prism.h)
        return self._prism[1]

    # ----------------------------------------------------------------------------------------------- the estimate

    def _estimate(self, request: Request, inputs: Inputs, wireframe: Wireframe, warnings: Sequence[str]) -> Estimate:
        envelope = inputs.envelope
        if not len(wireframe):
            return Estimate(0.0, 0.0, 0.0, warnings)
        # the ends of rods lie in a prism's faces
        body = None if request.solid is None else envelope.mesh
        low, high = envelope.low, envelope.high
        found = estimate_porosity(wireframe, request.job.rods, low, high, envelope.volume, body, self._progress)
        work = engines.choose(request.job.scaffold, found.vertices, found.triangles, low, high)
        return Estimate(found.porosity, found.error, found.plain_sum, warnings, work=work)


def _most_rods(inputs: Inputs) -> int:
    """Return how many rods the couplings of a design can give at most."""
    counts = {label: len(one.sites) for label, one in inputs.faces.items()}
    return sum(min(counts.get(c.first, 0), counts.get(c.second, 0)) for c in inputs.parameters.couplings if c.on)
