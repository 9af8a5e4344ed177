# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects whose result takes time: computed only where no result of the same inputs is shown, or at hand."""

from __future__ import annotations

import time
from typing import Any, Callable, ClassVar, List, Tuple

from ..core.progress import Progress, silent
from ..errors import Cancelled
from . import results
from .feature import Feature, Property, result

OUT_OF_DATE = "out of date: update it"
COMPUTING = "being computed"
PATIENCE = 0.08  # s of processor time that the window spends on a result before another process computes it
#: The property that every such object has.
RESULT_KEY = result("String", "ResultKey", "Key of the inputs of the result", hidden=True)


#: ``(obj, key) -> bool``: whether another process computes the result and the object will be touched when it is there.
TakeOver = Callable[[Any, str], bool]
_window: List[TakeOver] = []


def hand_long_work_to(take_over: TakeOver) -> None:
    """Have another process compute what would keep a window waiting; without a window nothing is handed over."""
    _window[:] = [take_over]


def patient() -> Progress:
    """Return a callback that raises ``Cancelled`` once ``PATIENCE`` is over."""
    end = time.thread_time() + PATIENCE

    def progress(done: float, total: float, what: str) -> None:
        if time.thread_time() > end:
            raise Cancelled("the window must not wait")

    return progress


class Keyed(Feature):
    """Base of objects that compute only when their inputs have changed: ``key``, ``make``, ``show``, ``said``."""

    #: Kind of its results, one of ``results.KINDS``.
    KIND: ClassVar[str] = ""

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs; quick, whatever the inputs are."""
        raise NotImplementedError

    def make(self, obj: Any, progress: Progress) -> Any:
        """Return the result of the present inputs."""
        raise NotImplementedError

    def make_soon(self, obj: Any, progress: Progress) -> Any:
        """Return the result if that is a matter of a moment, else None; ``progress`` may raise ``Cancelled``."""
        return None

    def show(self, obj: Any, value: Any) -> None:
        """Assign a result to the object's properties, after checks."""
        raise NotImplementedError

    def said(self, obj: Any) -> str:
        """Return the status of an object that is up to date."""
        raise NotImplementedError

    def is_wanted(self, obj: Any) -> bool:
        """Return whether a result that is not at hand is to be computed at once."""
        return True

    def prepare(self, obj: Any, progress: Progress = silent) -> None:
        """Compute beforehand; errors go to the caller."""
        key = self.key(obj)
        if obj.ResultKey != key:
            results.found_or_made(self.KIND, key, lambda: self.make(obj, progress))

    def compute(self, obj: Any) -> str:
        """Show the result of the present inputs if it is not shown already."""
        key = self.key(obj)
        if obj.ResultKey != key:
            value = results.find(self.KIND, key)
            if value is None:
                if not self.is_wanted(obj):
                    return OUT_OF_DATE
                value = self._made(obj, key)
                if value is None:
                    return COMPUTING
            self.show(obj, value)
            obj.ResultKey = key
        return self.said(obj)

    def _made(self, obj: Any, key: str) -> Any:
        """Return the result; None if it comes later."""
        if _window:
            try:
                value = self.make_soon(obj, patient())
            except Cancelled:
                value = None
            if value is not None:
                return results.keep(self.KIND, key, value)
            if _window[0](obj, key):
                return None
        return results.keep(self.KIND, key, self.make(obj, silent))


def waiting(auto: bool) -> Tuple[Property, ...]:
    """Return the properties of an ``OnDemand`` object; ``auto`` is the default of ``AutoUpdate``."""
    doc = "On: computed with every recompute; off: shown as out of date until it is updated"
    return (
        Property("App::PropertyBool", "AutoUpdate", "Base", doc, 0, auto),
        result("Bool", "UpToDate", "Whether the result belongs to the present inputs"),
        RESULT_KEY,
    )


def on_demand(auto: bool) -> Tuple[Property, ...]:
    """Return the properties of an ``OnDemand`` object of a wireframe."""
    return (Property("App::PropertyLink", "Wireframe", "Base", "The wireframe whose rods these are"), *waiting(auto))


class OnDemand(Keyed):
    """Base of objects that may wait until they are updated."""

    def is_wanted(self, obj: Any) -> bool:
        """Return whether the object follows every change."""
        return bool(obj.AutoUpdate)

    def compute(self, obj: Any) -> str:
        """Show the result of the present inputs, or say that the one shown is out of date."""
        obj.UpToDate = False
        status = super().compute(obj)
        obj.UpToDate = status not in (OUT_OF_DATE, COMPUTING)
        return status
