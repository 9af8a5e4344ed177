# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites of one face by curvilinear co-ordinates (thesis 4.2.2) in the document."""

from __future__ import annotations

from typing import Any, Dict, Optional

import FreeCAD
import Part

from ..core.parameters import FaceParameters
from ..core.progress import Progress, silent
from ..core.sites import Sites
from ..errors import EnvelopeError
from ..geometry.design import SitedFace, sites_shape
from ..geometry.face_marks import face_mark, found_again
from ..geometry.face_sites import face_sites
from ..views import in_words
from . import results
from .base import read_parameters
from .envelope import envelope_of, is_known, mark_of
from .feature import Property, result
from .on_demand import RESULT_KEY, Keyed


def sites_on(face: Part.Face, envelope: str, parameters: FaceParameters, progress: Progress = silent) -> Sites:
    """Return the sites on a face of the envelope with that fingerprint, computed if they are not at hand."""
    return results.found_or_made(
        FaceSites.KIND,
        sites_key(envelope, parameters),
        lambda: face_sites(face, parameters.label, parameters, progress=progress),
    )


def sites_key(envelope: str, parameters: FaceParameters) -> str:
    """Return the key of the sites on a face of the envelope with that fingerprint."""
    return results.key_of("face sites", envelope, parameters)


def lost(obj: Any, face: str) -> EnvelopeError:
    """Return the error of sites whose face is no more."""
    owner = obj.Face[0]
    return EnvelopeError(
        f"the sites {obj.Label} lost their face {face}: {owner.Label} has Face1..Face{len(owner.Shape.Faces)}; "
        "choose another face"
    )


class FaceSites(Keyed):
    """The sites of one face of any solid."""

    Type = "Trabecula::FaceSites"
    KIND = "sites"
    PARAMETERS = (FaceParameters,)
    PROPERTIES = (
        Property("App::PropertyLinkSub", "Face", "Base", "Face of the envelope"),
        result("Integer", "Count", "Sites on the face"),
        result("String", "MarkedFace", "Body and face of the mark", hidden=True),
        result("FloatList", "FaceMark", "Count of faces; points on the face and normals there", hidden=True),
        RESULT_KEY,
    )

    def parameters(self, obj: Any) -> FaceParameters:
        """Return the checked parameters, the face's name taken from the link."""
        names = obj.Face[1] if obj.Face else ()
        if len(names) != 1:
            raise EnvelopeError(f"{obj.Label} must be linked to 1 face, got {len(names)}")
        # FreeCAD 1.x marks a face that it cannot find any more
        if names[0].startswith("?"):
            raise lost(obj, names[0][1:])
        return read_parameters(obj, FaceParameters, face=names[0])

    def faces(self, obj: Any, progress: Progress = silent) -> Dict[str, SitedFace]:
        """Return the face with its sites, before changes by hand, by label.

        Raises
        ------
        EnvelopeError
            If the face is no more.
        """
        parameters, owner = self.parameters(obj), self.envelope(obj)
        body = envelope_of(owner)
        try:
            face = body.envelope.face(parameters.face)
        except EnvelopeError as error:
            raise lost(obj, parameters.face) from error
        return {parameters.label: SitedFace(sites_on(face, body.mark, parameters, progress), face)}

    def envelope(self, obj: Any) -> Any:
        """Return the object on whose face the sites are."""
        return obj.Face[0] if obj.Face else None

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs."""
        parameters = self.parameters(obj)
        return sites_key(mark_of(self.envelope(obj)), parameters)

    def make(self, obj: Any, progress: Progress) -> Sites:
        """Find the sites."""
        (one,) = self.faces(obj, progress).values()
        return one.sites

    def make_soon(self, obj: Any, progress: Progress) -> Optional[Sites]:
        """Find the sites if the envelope is known."""
        return self.make(obj, progress) if is_known(self.envelope(obj)) else None

    def show(self, obj: Any, value: Sites) -> None:
        """Show the sites as points."""
        obj.Count, obj.Shape = len(value), sites_shape(self.faces(obj))

    def said(self, obj: Any) -> str:
        """Return the number of sites."""
        return f"{obj.Count} sites"

    def onChanged(self, obj: Any, name: str) -> None:
        """Forget the old face when another is linked; FreeCAD 1.x marks one that it lost, which is looked for."""
        if name != "Face" or not obj.Face or not obj.Face[1] or not hasattr(obj, "FaceMark"):
            return
        if not obj.Face[1][0].startswith("?") and _link_text(obj) != obj.MarkedFace:
            obj.FaceMark = []

    def prepare(self, obj: Any, progress: Progress = silent) -> None:
        """Compute beforehand; errors go to the caller."""
        follow_face(obj)
        super().prepare(obj, progress)

    def compute(self, obj: Any) -> str:
        """Find the face again if its body has numbered its faces anew, then show the sites."""
        moved = follow_face(obj)
        status = super().compute(obj)
        owner, (name,) = obj.Face
        shape = _unplaced(owner)
        obj.MarkedFace = _link_text(obj)
        obj.FaceMark = [float(len(shape.Faces)), *face_mark(shape.Faces[int(name[4:]) - 1])]
        return f"{status}; {moved}" if moved else status


def _link_text(obj: Any) -> str:
    owner, (name, *_) = obj.Face
    return f"{owner.Name}.{name}"


def _unplaced(owner: Any) -> Part.Shape:
    """The shape of a body before it was placed: a mark does not change when the body is moved."""
    shape = owner.Shape.copy(False)
    shape.Placement = FreeCAD.Placement()
    return shape


def follow_face(obj: Any) -> str:
    """Link sites to the face that they were on, where their body has given it another number; say so.

    The sites keep the name of their face, so that couplings, changes by hand and random draws stay what they were.

    Raises
    ------
    EnvelopeError
        If the face is no more.
    """
    names, mark = (obj.Face[1] if obj.Face else ()), list(obj.FaceMark)
    if len(names) != 1 or not mark or getattr(obj.Face[0], "Shape", None) is None:
        return ""
    owner, name = obj.Face[0], names[0].lstrip("?")
    shape = _unplaced(owner)
    count = len(shape.Faces)
    number = int(name[4:]) if name[4:].isdigit() and not names[0].startswith("?") else 0
    found = found_again(shape, mark[1:], number, count == int(mark[0]))
    if found is None:
        raise lost(obj, name)
    if found == number:
        return ""
    obj.FaceName = obj.FaceName or name
    obj.Face = (owner, [f"Face{found}"])
    said = f"its face, {name} so far, is now Face{found} of {owner.Label}"
    FreeCAD.Console.PrintWarning(f"{obj.Label}: {in_words(said)}\n")
    return said
