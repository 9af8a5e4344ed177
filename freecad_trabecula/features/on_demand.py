# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects whose result takes time: computed only where no result of the same inputs is shown, or at hand."""

from __future__ import annotations

from typing import Any, ClassVar, Tuple

from ..core.progress import Progress, silent
from . import results
from .feature import Feature, Property, result

OUT_OF_DATE = "out of date: update it"
#: The property that every such object has.
RESULT_KEY = result("String", "ResultKey", "Key of the inputs of the result", hidden=True)


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
                value = results.keep(self.KIND, key, self.make(obj, silent))
            self.show(obj, value)
            obj.ResultKey = key
        return self.said(obj)


def on_demand(auto: bool) -> Tuple[Property, ...]:
    """Return the properties of an ``OnDemand`` object; ``auto`` is the default of ``AutoUpdate``."""
    doc = "On: computed with every recompute; off: shown as out of date until it is updated"
    return (
        Property("App::PropertyLink", "Wireframe", "Base", "The wireframe whose rods these are"),
        Property("App::PropertyBool", "AutoUpdate", "Base", doc, 0, auto),
        result("Bool", "UpToDate", "Whether the result belongs to the present inputs"),
        RESULT_KEY,
    )


class OnDemand(Keyed):
    """Base of objects of a wireframe that may wait until they are updated."""

    def is_wanted(self, obj: Any) -> bool:
        """Return whether the object follows every change."""
        return bool(obj.AutoUpdate)

    def compute(self, obj: Any) -> str:
        """Show the result of the present inputs, or say that the one shown is out of date."""
        obj.UpToDate = False
        status = super().compute(obj)
        obj.UpToDate = status != OUT_OF_DATE
        return status
