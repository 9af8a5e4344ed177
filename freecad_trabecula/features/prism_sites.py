# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites of a prism (Eq. 2.1) in the document."""

from __future__ import annotations

from typing import Any, Dict

from ..core.parameters import PrismParameters
from ..core.progress import Progress, silent
from ..errors import EnvelopeError
from ..geometry.design import SitedFace, placed_prism_sites, sites_shape
from .base import read_parameters
from .envelope import envelope_of
from .feature import Feature, Property, result


class PrismSites(Feature):
    """The sites of the six faces of a ``Part::Box``; its edges and its placement are the box's."""

    Type = "Trabecula::PrismSites"
    PARAMETERS = (PrismParameters,)
    PROPERTIES = (
        Property("App::PropertyLink", "Box", "Base", "The prism, a box"),
        result("Integer", "Count", "Sites on all faces"),
    )

    def parameters(self, obj: Any) -> PrismParameters:
        """Return the checked parameters, edges taken from the box."""
        box = obj.Box
        if box is None or box.TypeId != "Part::Box":
            raise EnvelopeError(f"{obj.Label} must be linked to a box, got {box.Label if box else 'nothing'}")
        edges = (box.Length.Value, box.Width.Value, box.Height.Value)
        return read_parameters(obj, PrismParameters, **dict(zip("lwh", edges)))

    def faces(self, obj: Any, progress: Progress = silent) -> Dict[str, SitedFace]:
        """Return the faces with their sites, before changes by hand."""
        return placed_prism_sites(self.parameters(obj), envelope_of(obj.Box).envelope)

    def envelope(self, obj: Any) -> Any:
        """Return the object on whose faces the sites are."""
        return obj.Box

    def prepare(self, obj: Any, progress: Progress = silent) -> None:
        """Compute beforehand; errors go to the caller."""
        self.faces(obj, progress)

    def compute(self, obj: Any) -> str:
        """Show the sites as points."""
        faces = self.faces(obj)
        obj.Count = sum(len(one.sites) for one in faces.values())
        obj.Shape = sites_shape(faces)
        return ""
