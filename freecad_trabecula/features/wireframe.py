# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe in the document: pores, couplings, paths, seed, changes by hand; it shows paths and end sections."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
import Part

from ..core import wireframe as core
from ..core.history import History, Mended
from ..core.parameters import LARGEST_SEED, Coupling, PathParameters, PoreParameters, RodParameters, SiteEdit
from ..core.progress import Progress, silent
from ..core.wireframe import WireframeParameters
from ..errors import EnvelopeError, ExportError, ParameterError
from ..geometry.design import SitedFace, design_draft, design_wireframe, pore_warnings
from ..geometry.envelopes import Envelope
from ..geometry.wires import wireframe_shape
from . import results
from .arguments import given_object
from .base import lines_of, read_parameters, records_of
from .envelope import envelope_of, is_known, mark_of
from .feature import Property, result
from .on_demand import COMPUTING, RESULT_KEY, Keyed
from .packing import from_numbers, to_numbers

SEEN = "seen"  # kind of results
FEW = 60  # rods that are mended while a window waits
_SEEDS = (1, 0, LARGEST_SEED, 1)  # value, least, greatest, step


class Inputs(NamedTuple):
    """All that a wireframe depends on."""

    envelope: Envelope
    faces: Dict[str, SitedFace]
    parameters: WireframeParameters
    mark: str
    key: str


class Seen(NamedTuple):
    """What is seen of a wireframe: two edges a rod in their order, then the pores; what is wrong with these."""

    shape: Part.Shape
    warnings: Tuple[str, ...]


class Wireframe(Keyed):
    """Sites, pores, pairs, paths, end sections of a design: rods and channels are two views of it."""

    Type = "Trabecula::Wireframe"
    KIND = "wireframe"
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
        result("String", "Structure", "The wireframe: names, tables, places of its numbers", hidden=True),
        result("FloatList", "Numbers", "The wireframe: its numbers", hidden=True),
        RESULT_KEY,
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

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs."""
        return wireframe_key(mark_of(obj.Envelope), self.sites_parameters(obj), self.parameters(obj))

    def sites_parameters(self, obj: Any) -> List[Any]:
        """Return the parameters of the linked sites.

        Raises
        ------
        EnvelopeError
            If sites are on another body.
        """
        found = []
        for sites in obj.Sites:
            owner = sites.Proxy.envelope(sites)
            if owner != obj.Envelope:
                raise EnvelopeError(
                    f"the sites {sites.Label} must be on faces of {obj.Envelope.Label}, "
                    f"got {owner.Label if owner else 'none'}"
                )
            found.append(sites.Proxy.parameters(sites))
        return found

    def inputs(self, obj: Any, progress: Progress = silent) -> Inputs:
        """Return all that the wireframe depends on.

        Raises
        ------
        EnvelopeError
            If the envelope is no solid, or sites are on another body.
        ParameterError
            If a value is refused, or two faces have one name.
        """
        key, body = self.key(obj), envelope_of(obj.Envelope)
        faces: Dict[str, SitedFace] = {}
        for sites in obj.Sites:
            for label, one in sites.Proxy.faces(sites, progress).items():
                if label in faces:
                    raise ParameterError(f"every face must be named once, got {label!r} again in {sites.Label}")
                faces[label] = one
        return Inputs(body.envelope, faces, self.parameters(obj), body.mark, key)

    def wireframe(self, obj: Any, progress: Progress = silent) -> core.Wireframe:
        """Return the wireframe, computed if it is neither at hand nor in the document."""
        recall(obj)
        return results.found_or_made(self.KIND, self.key(obj), lambda: self.make(obj, progress)).wireframe

    def make(self, obj: Any, progress: Progress) -> Mended:
        """Make the wireframe; only rods whose numbers changed are mended."""
        recall(obj)
        return mended(self.inputs(obj, progress), progress)

    def make_soon(self, obj: Any, progress: Progress) -> Optional[Mended]:
        """Make the wireframe if few of its rods are new."""
        recall(obj)
        if not is_known(obj.Envelope) or any(one.Status == COMPUTING for one in obj.Sites):
            return None
        inputs = self.inputs(obj, progress)
        raw = design_draft(inputs.parameters, inputs.envelope, inputs.faces, progress)
        if history().count_unknown(raw, inputs.parameters, inputs.mark) > FEW:
            return None
        region, contains = inputs.envelope.region, inputs.envelope.contains
        return history().mend(raw, inputs.parameters, region, contains, inputs.mark, progress)

    def show(self, obj: Any, value: Mended) -> None:
        """Show paths and end sections, and what is known of them."""
        wireframe = value.wireframe
        seen = results.found_or_made(SEEN, self.key(obj), lambda: seen_of(self.inputs(obj), wireframe))
        obj.Structure, obj.Numbers = to_numbers(value)
        obj.Rods = len(wireframe)
        obj.CouplingTable = lines_of(wireframe.rows)
        obj.Recoveries = lines_of(wireframe.recoveries)
        obj.Failed, obj.Outside, obj.Warnings = list(wireframe.failed), list(wireframe.outside), list(seen.warnings)
        obj.PoreSizes, obj.PoreAreas = sections(wireframe)
        obj.Shape = seen.shape

    def said(self, obj: Any) -> str:
        """Return what a user should know, in one line."""
        parts = [f"{obj.Rods} rods"]
        counts = ((obj.Recoveries, "mended"), (obj.Failed, "failed and left out"), (obj.Outside, "leave the envelope"))
        parts += [f"{len(names)} {what}" for names, what in counts if names]
        return "; ".join([", ".join(parts), *obj.Warnings])


def seen_of(inputs: Inputs, wireframe: core.Wireframe) -> Seen:
    """Return what is seen of a wireframe."""
    coupled = of_coupled_faces(wireframe)
    pores, paths, _ = wireframe_shape(coupled).childShapes()
    return Seen(Part.makeCompound([paths, pores]), tuple(pore_warnings(coupled, inputs.faces)))


def of_coupled_faces(wireframe: core.Wireframe) -> core.Wireframe:
    """Return the wireframe without the sites and pores of faces that no coupling joins."""
    faces = {face for row in wireframe.rows for face in (row.first, row.second)}
    sites, pores = ({f: one for f, one in of.items() if f in faces} for of in (wireframe.sites, wireframe.pores))
    return replace(wireframe, sites=sites, pores=pores)


def recall(obj: Any) -> None:
    """Take the wireframe that the document holds into the results and into the history, where it is not yet."""
    if not obj.ResultKey or results.find(Wireframe.KIND, obj.ResultKey) is not None:
        return
    try:
        value = from_numbers(obj.Structure, obj.Numbers)
    except ExportError:
        return  # of another version: it is computed again
    results.keep(Wireframe.KIND, obj.ResultKey, value)
    history().learn(value)


def history() -> History:
    """Return the rods mended so far."""
    return results.found_or_made("history", "rods", History)


def mended(inputs: Inputs, progress: Progress = silent) -> Mended:
    """Return the wireframe of inputs with its history, computed if it is not at hand."""

    def make() -> Mended:
        return design_wireframe(inputs.parameters, inputs.envelope, inputs.faces, history(), inputs.mark, progress)

    return results.found_or_made(Wireframe.KIND, inputs.key, make)


def made(inputs: Inputs, progress: Progress = silent) -> core.Wireframe:
    """Return the wireframe of inputs, computed if it is not at hand."""
    return mended(inputs, progress).wireframe


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
    return given_object(obj, Wireframe).Proxy.wireframe(obj)


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
