# SPDX-License-Identifier: LGPL-2.1-or-later
"""The envelope of a design that is being made: a solid or a mesh of the document, or read from a file."""

from __future__ import annotations

import os
from typing import Any, Callable, List, Optional, Sequence, Tuple

import FreeCAD
import Part

from ..core.job import Job
from ..errors import EnvelopeError
from ..features.bodies import has_solid, is_body
from ..features.containers import place_beside
from ..features.envelope import fill
from .design_form import Envelope
from .envelope_source import EnvelopeSource, is_known
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
        self.document, self.is_fixed = document, is_fixed
        self.obj, self._mesh = _split(obj)
        self._ready, self._refused = ready, refused
        self._pending: Optional[Tuple[str, str]] = None
        self.is_ready, self._refusal = self._needs_no_look(), ""
        self._opened = ""
        self._copy: Tuple[Any, Optional[Part.Shape]] = (None, None)
        self.source = EnvelopeSource()
        self.source.ready.connect(self._take)
        self.source.refused.connect(self._refuse)

    def _needs_no_look(self) -> bool:
        """Whether nothing long is left to do: boxes are checked at once, others in another process."""
        if self.obj is None:
            return self._mesh is None
        return self.obj.TypeId == "Part::Box" or is_known(self.obj.Shape)

    def _refuse(self, text: str) -> None:
        self._refusal = text
        self._refused(text)

    def check_ready(self) -> None:
        """Check that there is a body to be filled; one that is still being checked here is checked where it is filled.

        Raises
        ------
        EnvelopeError
            What is wrong with it, or that it is still being read.
        """
        if self._refusal or (self.obj is None and not self.is_ready):
            raise EnvelopeError(
                self._refusal if self._refusal else "the envelope must be checked before rods are built: wait a moment"
            )

    def offered(self) -> Sequence[Envelope]:
        """Return the bodies that can be chosen."""
        if self.is_fixed:
            objects: List[Any] = [self.obj]
            found = []
        else:
            objects = [obj for obj in self.document.Objects if is_body(obj)]
            found = [Envelope("", translate("Trabecula", "new prism"), True)]
        return found + [Envelope(obj.Name, obj.Label, obj.TypeId == "Part::Box") for obj in objects]

    def choose(self, name: str) -> None:
        """Take an object of the document, or a new prism for the empty name."""
        self.source.cancel()
        self._pending, self._refusal = None, ""
        self.obj, self._mesh = _split(self.document.getObject(name) if name else None)
        self.begin()

    def begin(self) -> None:
        """Have the chosen object checked if it was not; ``ready`` is called at once or then."""
        self.is_ready, self._refusal = self._needs_no_look(), ""
        if self.is_ready:
            self._ready()
        elif self._mesh is not None:
            self._pending = "", ""
            self.source.convert(self._mesh.Mesh)
        else:
            self.source.check(self.obj.Shape)

    def load(self, file: str, solid: str) -> None:
        """Read an envelope from a file; it becomes an object of the document."""
        self._pending, self._mesh, self._refusal = (file, solid), None, ""
        self.is_ready = False
        self.source.load(file, solid)

    def _take(self, envelope: Any) -> None:
        if self._pending is not None:
            file, solid = self._pending
            self._pending = None
            with transaction(self.document, _STEP):
                obj = self.document.addObject("Part::Feature", "Envelope")
                fill(obj, envelope, file, solid)
                obj.Label = os.path.splitext(os.path.basename(file))[0] if file else f"{self._mesh.Label} (solid)"
                if self._mesh is not None:
                    place_beside(obj, self._mesh)
                    self._mesh.Visibility = False  # both fill the same place
            self.obj, self._mesh, self._opened = obj, None, obj.Name
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
        self.obj, self._mesh, self._pending, self._opened, self._copy = None, None, None, "", (None, None)

    def cancel(self, is_kept: bool) -> None:
        """Stop reading; unless it is kept, what was read goes from the document again."""
        self.source.cancel()
        if self._opened and not is_kept and self.document.UndoNames[:1] == [_STEP]:
            self.document.undo()
        self._opened = ""


def _split(body: Any) -> Tuple[Any, Any]:
    """Return a body as a solid or as a mesh; the other is None."""
    return (body, None) if body is None or has_solid(body) else (None, body)
