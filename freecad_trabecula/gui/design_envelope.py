# SPDX-License-Identifier: LGPL-2.1-or-later
"""The envelope of a design that is being made: chosen in the document, or read from a file."""

from __future__ import annotations

import os
from typing import Any, Callable, List, Optional, Sequence, Tuple

import FreeCAD
import Part

from ..core.job import Job
from ..features.envelope import fill
from .design_form import Envelope
from .envelope_source import EnvelopeSource, is_known
from .picking import is_solid
from .transactions import transaction

translate = FreeCAD.Qt.translate
_STEP = translate("Trabecula", "Open envelope")  # name of the step to undo


class DesignEnvelope:
    """What the design panel fills.

    Parameters
    ----------
    document : App.Document
    obj : document object or None
        None means a new prism.
    is_fixed : bool
        Whether it belongs to a design and no other can be chosen.
    ready, refused : callable
        Called when the envelope can be used, and with a sentence when it cannot.
    """

    def __init__(
        self,
        document: Any,
        obj: Any,
        is_fixed: bool,
        ready: Callable[[], None],
        refused: Callable[[str], None],
    ) -> None:
        self.document, self.obj, self.is_fixed = document, obj, is_fixed
        self._ready, self._refused = ready, refused
        self._pending: Optional[Tuple[str, str]] = None
        self.is_ready = obj is None or self._is_usable(obj)
        self._opened = ""
        self._copy: Tuple[Any, Optional[Part.Shape]] = (None, None)
        self.source = EnvelopeSource()
        self.source.ready.connect(self._take)
        self.source.refused.connect(refused)

    @staticmethod
    def _is_usable(obj: Any) -> bool:
        """Whether nothing long is left to do: boxes are checked at once, others in another process."""
        return obj.TypeId == "Part::Box" or is_known(obj.Shape)

    def offered(self) -> Sequence[Envelope]:
        """Return the bodies that can be chosen."""
        if self.is_fixed:
            objects: List[Any] = [self.obj]
            found = []
        else:
            objects = [obj for obj in self.document.Objects if is_solid(obj)]
            found = [Envelope("", translate("Trabecula", "new prism"), True)]
        return found + [Envelope(obj.Name, obj.Label, obj.TypeId == "Part::Box") for obj in objects]

    def choose(self, name: str) -> None:
        """Take an object of the document, or a new prism for the empty name."""
        self.source.cancel()
        self._pending = None
        self.obj = self.document.getObject(name) if name else None
        self.begin()

    def begin(self) -> None:
        """Have the chosen object checked if it was not; ``ready`` is called at once or then."""
        self.is_ready = self.obj is None or self._is_usable(self.obj)
        if self.is_ready:
            self._ready()
        else:
            self.source.check(self.obj.Shape)

    def load(self, file: str, solid: str) -> None:
        """Read an envelope from a file; it becomes an object of the document."""
        self._pending = file, solid
        self.is_ready = False
        self.source.load(file, solid)

    def _take(self, envelope: Any) -> None:
        if self._pending is not None:
            file, solid = self._pending
            self._pending = None
            with transaction(self.document, _STEP):
                obj = self.document.addObject("Part::Feature", "Envelope")
                fill(obj, envelope, file, solid)
                obj.Label = os.path.splitext(os.path.basename(file))[0]
            self.obj, self._opened = obj, obj.Name
        self.is_ready = True
        self._ready()

    def solid(self, job: Job) -> Optional[Part.Shape]:
        """Return the solid to be filled, for another thread; None for a prism with a corner at the origin."""
        if self.obj is None:
            return None
        if job.prism is not None:  # its edges are being changed, those of the object are not yet
            if self.obj.Placement.isIdentity():
                return None
            box = Part.makeBox(job.prism.l, job.prism.w, job.prism.h)
            box.Placement = self.obj.Placement
            return box
        shape = self.obj.Shape
        if self._copy[0] != shape.hashCode():
            self._copy = shape.hashCode(), shape.copy()
        return self._copy[1]

    def forget(self) -> None:
        """Take a new prism in the place of the object, which is being deleted."""
        self.source.cancel()
        self.obj, self._pending, self._opened, self._copy = None, None, "", (None, None)

    def cancel(self, is_kept: bool) -> None:
        """Stop reading; unless it is kept, what was read goes from the document again."""
        self.source.cancel()
        if self._opened and not is_kept and self.document.UndoNames[:1] == [_STEP]:
            self.document.undo()
        self._opened = ""
