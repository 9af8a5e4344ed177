# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe in the document: pores, couplings, paths, seed, changes by hand; it shows paths and end sections."""

from __future__ import annotations

from typing import Any, Dict, NamedTuple, Sequence, Tuple

import numpy as np

from ..core import wireframe as core
from ..core.history import History
from ..core.parameters import LARGEST_SEED, Coupling, PathParameters, PoreParameters, RodParameters, SiteEdit
from ..core.progress import Progress, silent
from ..core.wireframe import WireframeParameters
from ..errors import EnvelopeError, ParameterError
from ..geometry.design import SitedFace, design_wireframe, pore_warnings, wires_shape
from ..geometry.envelopes import Envelope
from . import results
from .base import lines_of, read_parameters, records_of
from .envelope import envelope_of
from .feature import Feature, Property, result

_SEEDS = (1, 0, LARGEST_SEED, 1)  # value, least, greatest, step


class Inputs(NamedTuple):
    """All that a wireframe depends on."""

    envelope: Envelope
    faces: Dict[str, SitedFace]
    parameters: WireframeParameters
    mark: str
    key: str


class Wireframe(Feature):
    """Sites, pores, pairs, paths, end sections of a design: rods and channels are two views of it."""

    Type = "Trabecula::Wireframe"
    PARAMETERS = (PoreParameters, PathParameters, RodParameters)
    PROPERTIES = (
        Property("App::PropertyLink", "Envelope", "Base", "The body to be filled"),
        Property("App::PropertyLinkList", "Sites", "Base", "Sites on its faces"),
        Property("App::PropertyIntegerConstraint", "Seed", "Base", "One number reproduces all draws", 0, _SEEDS),
        Property(
            "App::PropertyStringList",
            "Couplings",
            "Couplings",
            "Pairs of faces in order, a JSON record a line: "
            '{"first": "Face1", "second": "Face2", "association": "random"}',
        ),
        Property(
            "App::PropertyStringList",
            "Edits",
            "Sites",
            'Changes of single sites by hand, a JSON record a line: {"site": "Face1.2.3", "action": "off"}',
        ),
        result("Integer", "Rods", "Number of rods"),
        result("StringList", "CouplingTable", "Sites available, rods, sites left, for each coupling (tables 4.2, 4.5)"),
        result("StringList", "Recoveries", "Rods that were mended: fault, remedy, attempts"),
        result("StringList", "Failed", "Rods that no remedy mended; they are left out"),
        result("StringList", "Outside", "Rods that leave the envelope between their ends"),
        result("StringList", "Warnings", "Pores that overlap or reach over a border"),
        result("FloatList", "PoreSizes", "Sizes of the rods' end sections, mm"),
        result("FloatList", "PoreAreas", "True areas of the rods' end sections, mm^2"),
    )

    def parameters(self, obj: Any) -> WireframeParameters:
        """Return the checked parameters."""
        return WireframeParameters(
            read_parameters(obj, PoreParameters),
            read_parameters(obj, PathParameters),
            records_of(obj.Couplings, Coupling, "coupling"),
            read_parameters(obj, RodParameters),
            records_of(obj.Edits, SiteEdit, "edit"),
            int(obj.Seed),
        )

    def inputs(self, obj: Any, progress: Progress = silent) -> Inputs:
        """Return all that the wireframe depends on.

        Raises
        ------
        EnvelopeError
            If the envelope is no solid, or sites are on another body.
        ParameterError
            If a value is refused, or two faces have one name.
        """
        body, parameters = envelope_of(obj.Envelope), self.parameters(obj)
        faces: Dict[str, SitedFace] = {}
        chosen = []
        for sites in obj.Sites:
            owner = sites.Proxy.envelope(sites)
            if owner != obj.Envelope:
                raise EnvelopeError(
                    f"the sites {sites.Label} must be on faces of {obj.Envelope.Label}, "
                    f"got {owner.Label if owner else 'none'}"
                )
            chosen.append(sites.Proxy.parameters(sites))
            for label, one in sites.Proxy.faces(sites, progress).items():
                if label in faces:
                    raise ParameterError(f"every face must be named once, got {label!r} again in {sites.Label}")
                faces[label] = one
        return Inputs(body.envelope, faces, parameters, body.mark, wireframe_key(body.mark, chosen, parameters))

    def wireframe(self, obj: Any, progress: Progress = silent) -> core.Wireframe:
        """Return the wireframe, computed if it is not at hand."""
        return made(self.inputs(obj, progress), progress)

    def prepare(self, obj: Any, progress: Progress = silent) -> None:
        """Compute beforehand; errors go to the caller."""
        self.wireframe(obj, progress)

    def compute(self, obj: Any) -> str:
        """Make the wireframe and show it."""
        inputs = self.inputs(obj)
        wireframe = made(inputs)
        shape = wires_shape(wireframe)
        obj.Rods = len(wireframe)
        obj.CouplingTable = lines_of(wireframe.rows)
        obj.Recoveries = lines_of(wireframe.recoveries)
        obj.Failed, obj.Outside = list(wireframe.failed), list(wireframe.outside)
        obj.Warnings = pore_warnings(wireframe, inputs.faces)
        obj.PoreSizes, obj.PoreAreas = sections(wireframe)
        obj.Shape = shape
        return said(wireframe, obj.Warnings)


def made(inputs: Inputs, progress: Progress = silent) -> core.Wireframe:
    """Return the wireframe of inputs, computed if it is not at hand."""

    def make() -> core.Wireframe:
        history = results.found_or_made("history", "rods", History)
        return design_wireframe(inputs.parameters, inputs.envelope, inputs.faces, progress, history, inputs.mark)

    return results.found_or_made("wireframe", inputs.key, make)


def wireframe_of(obj: Any) -> core.Wireframe:
    """Return the numbers of a wireframe object: sites, pores, paths, end sections, recoveries.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> make.wireframe_of(make.make_design(FreeCAD.newDocument(), preset("case1")).wireframe).paths.shape
    (75, 2, 4, 3)
    """
    return obj.Proxy.wireframe(obj)


def wireframe_key(envelope: str, sites: Sequence[Any], parameters: WireframeParameters) -> str:
    """Return the key of a wireframe.

    Parameters
    ----------
    envelope : str
        Its fingerprint.
    sites : sequence of FaceParameters, or of one PrismParameters
    parameters : WireframeParameters
    """
    return results.key_of("wireframe", envelope, sites, parameters)


def sections(wireframe: core.Wireframe) -> Tuple[list, list]:
    """Return sizes (mm) and true areas (mm2) of the rods' end sections, first and second ends of all rods."""
    ends = (wireframe.ends.first, wireframe.ends.second)
    return tuple(np.concatenate([getattr(p, name) for p in ends]).tolist() for name in ("size", "areas"))


def said(wireframe: core.Wireframe, warnings: list) -> str:
    """Return what a user should know of a wireframe, in one line."""
    parts = [f"{len(wireframe)} rods"]
    counts = ((wireframe.recoveries, "mended"), (wireframe.failed, "failed and left out"),
              (wireframe.outside, "leave the envelope"))  # fmt: skip
    parts += [f"{len(names)} {what}" for names, what in counts if names]
    return "; ".join([", ".join(parts), *warnings])
