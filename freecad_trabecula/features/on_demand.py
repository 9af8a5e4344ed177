# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects whose result takes long: taken where it is at hand, computed at once only if the user wants that."""

from __future__ import annotations

from typing import Any, ClassVar, Tuple

from ..core.progress import Progress, silent
from . import results
from .feature import Feature, Property, result

OUT_OF_DATE = "out of date: update it"


def on_demand(auto: bool) -> Tuple[Property, ...]:
    """Return the properties of such an object; ``auto`` is the default of ``AutoUpdate``."""
    doc = "On: computed with every recompute; off: shown as out of date until it is updated"
    return (
        Property("App::PropertyLink", "Wireframe", "Base", "The wireframe whose rods these are"),
        Property("App::PropertyBool", "AutoUpdate", "Base", doc, 0, auto),
        result("Bool", "UpToDate", "Whether the result belongs to the present inputs"),
        result("String", "ResultKey", "Key of the inputs of the result", hidden=True),
    )


class OnDemand(Feature):
    """Base of such objects: subclasses fill in ``key``, ``make``, ``show`` and ``said``."""

    #: Kind of its results, one of ``results.KINDS``.
    KIND: ClassVar[str] = ""

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs."""
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

    def prepare(self, obj: Any, progress: Progress = silent) -> None:
        """Compute beforehand; errors go to the caller."""
        results.found_or_made(self.KIND, self.key(obj), lambda: self.make(obj, progress))

    def compute(self, obj: Any) -> str:
        """Take the result that is at hand, or compute it if that is wanted, or say that it is out of date."""
        key = self.key(obj)
        value = results.find(self.KIND, key)
        if value is None and obj.ResultKey != key:
            obj.UpToDate = False
            if not obj.AutoUpdate:
                return OUT_OF_DATE
            value = results.keep(self.KIND, key, self.make(obj, silent))
        if value is not None:
            self.show(obj, value)
        obj.ResultKey, obj.UpToDate = key, True
        return self.said(obj)
