# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites of one face by curvilinear co-ordinates (thesis 4.2.2) in the document."""

from __future__ import annotations

from typing import Any, Dict, Optional

import Part

from ..core.parameters import FaceParameters
from ..core.progress import Progress, silent
from ..core.sites import Sites
from ..errors import EnvelopeError
from ..geometry.design import SitedFace, sites_shape
from ..geometry.face_sites import face_sites
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
