# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slice analysis in the document: what is sliced and how, profiles along its axes; live when its source changes.

The document holds the profiles and, of each contour, plane, area and class: what plots, tables and comparisons need.
Contours themselves are worked out when they are looked at.
"""

from __future__ import annotations

import json
import math
from dataclasses import fields, replace
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from ..core.analysis import analysis as core
from ..core.analysis.contours import ContourMeasures, Contours
from ..core.analysis.parameters import SliceParameters
from ..core.analysis.report import analysis_checks, analysis_faults, analysis_notes
from ..core.analysis.triangles import UNITS, Soup
from ..core.progress import Progress, part, silent
from ..core.records import from_record, to_record
from ..errors import ExportError, ParameterError
from . import results
from .analysis_source import Source, file_source, object_source, read_source_soup, soup_of_source, write_source
from .arguments import given_object
from .base import read_parameters, write_parameters
from .feature import Property, result
from .on_demand import OnDemand, waiting
from .packing import from_numbers, to_numbers

CONTOURS = "contours"  # kind of results: contours along one axis
PROFILES = "profiles"  # kind of results: an analysis without what the document does not keep
_BODY, _ENVELOPE = "body", "envelope"  # names of what another process slices
_UNITS = ["auto", *UNITS]


class Told(NamedTuple):
    """What a document keeps of the contours (C,) along one axis; see ``ContourMeasures``."""

    plane: np.ndarray
    area: np.ndarray
    net_area: np.ndarray
    is_rod: np.ndarray
    is_rod_invariant: np.ndarray


class Inputs(NamedTuple):
    """All that an analysis depends on."""

    body: Source
    envelope: Optional[Source]
    parameters: SliceParameters
    unit: str
    deflection: float
    morphometry: bool

    @property
    def key(self) -> str:
        """Changes when one of them does."""
        envelope = self.envelope.key if self.envelope else ""
        chosen = to_record(self.parameters, everything=True)
        more = (self.unit, self.deflection, self.morphometry)
        return results.key_of("analysis", self.body.key, envelope, json.dumps(chosen), *more)


class Analysis(OnDemand):
    """Profiles of a body's slices along its axes."""

    Type = "Trabecula::Analysis"
    KIND = "analysis"
    PARAMETERS = (SliceParameters,)
    PROPERTIES = (
        Property("App::PropertyLink", "Source", "Base", "The body that is sliced; none: the file"),
        Property("App::PropertyFile", "File", "Base", "STL, OBJ, PLY or 3MF that is sliced if there is no source"),
        Property("App::PropertyEnumeration", "Unit", "Base", "Unit of the file; auto: guessed, and said", 0, _UNITS),
        Property("App::PropertyLink", "Envelope", "Base", "To whose slices the porosity refers; none: the body's box"),
        Property("App::PropertyLength", "Deflection", "Base", "Distance of triangles from a solid; 0: chosen"),
        Property("App::PropertyBool", "Morphometry", "Base", "On: also Tb.Th, Tb.Sp, Conn.D, DA ... on voxels; slow"),
        Property("App::PropertyBool", "SliceRange", "Slices", "On: only from SliceLow to SliceHigh is sliced"),
        Property("App::PropertyDistance", "SliceLow", "Slices", "Where the layers begin"),
        Property("App::PropertyDistance", "SliceHigh", "Slices", "Where the layers end"),
        Property("App::PropertyFloatList", "SliceHeights", "Slices", "Co-ordinates of planes, mm; with at = heights"),
        Property("App::PropertyDistance", "SliceCompensation", "Slices", "Offset of the contours into the material"),
        *waiting(True),
        result("Integer", "Triangles", "Triangles that were sliced"),
        result("Integer", "Slices", "Slices along all axes"),
        result("Integer", "Contours", "Contours of all slices that are counted"),
        result("Integer", "SpoiltSlices", "Slices on which the mesh is not closed: their numbers may be wrong"),
        result("Float", "BoneFraction", "Mean of sliced area over envelope area, over the axes, %"),
        result("Volume", "SliceVolume", "Sum of sliced area x thickness, mean of the axes"),
        result("Volume", "MeshVolume", "Volume of the triangles: the independent route"),
        result("String", "UnitFound", "Unit of the numbers before they became mm"),
        result("StringList", "Checks", "What was worked out twice, by independent routes, and how far the two differ"),
        result("StringList", "Notes", "What is to be known"),
        result("Float", "Seconds", "Processor time that it took, s"),
        result("String", "Structure", "The analysis: names, tables, places of its numbers", hidden=True),
        result("FloatList", "Numbers", "The analysis: its numbers", hidden=True),
    )

    def parameters(self, obj: Any) -> SliceParameters:
        """Return the checked parameters."""
        low, high = (obj.SliceLow.Value, obj.SliceHigh.Value) if obj.SliceRange else (math.nan, math.nan)
        heights, compensation = tuple(obj.SliceHeights), obj.SliceCompensation.Value
        more = {"low": low, "high": high, "heights": heights, "compensation": compensation}
        return read_parameters(obj, SliceParameters, **more)

    def inputs(self, obj: Any) -> Inputs:
        """Return all that the analysis depends on.

        Raises
        ------
        ParameterError
            If there is nothing to slice, or a value is refused.
        ExportError
            If the file is not there.
        """
        if obj.Source is None and not obj.File:
            raise ParameterError(f"{obj.Label} must have a source or a file to be sliced, got neither")
        body = object_source(obj.Source) if obj.Source is not None else file_source(obj.File)
        envelope = object_source(obj.Envelope) if obj.Envelope is not None else None
        chosen = self.parameters(obj)
        return Inputs(body, envelope, chosen, obj.Unit, obj.Deflection.Value, bool(obj.Morphometry))

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs."""
        return self.inputs(obj).key

    def make(self, obj: Any, progress: Progress) -> core.Analysis:
        """Slice and measure."""
        inputs = self.inputs(obj)
        soups = [
            soup_of_source(one, inputs.unit, inputs.deflection, part(progress, 0.0, 0.1)) if one else None
            for one in (inputs.body, inputs.envelope)
        ]
        return core.analyse(soups[0], inputs.parameters, inputs.morphometry, part(progress, 0.1, 1.0), soups[1])

    def show(self, obj: Any, value: core.Analysis) -> None:
        """Assign profiles, sums, checks."""
        obj.Structure, obj.Numbers = to_numbers(_kept(value))
        summaries = [value.summary(axis) for axis in value.profiles]
        volumes = [one.volume for one in summaries if math.isfinite(one.volume)]
        fractions = [one.mean_bone_fraction for one in summaries if math.isfinite(one.mean_bone_fraction)]
        obj.Triangles = value.facts.triangles if value.facts else 0
        obj.Slices = sum(one.slices for one in summaries)
        obj.SpoiltSlices = sum(one.spoilt_slices for one in summaries)
        obj.Contours = int(sum(profile.contours.sum() for profile in value.profiles.values()))
        obj.BoneFraction = 100 * sum(fractions) / len(fractions) if fractions else 0.0
        obj.SliceVolume = sum(volumes) / len(volumes) if volumes else 0.0
        obj.MeshVolume = value.facts.volume if value.facts else 0.0
        obj.UnitFound, obj.Seconds = value.unit, float(value.seconds)
        obj.Checks = [str(check) for check in analysis_checks(value)]
        obj.Notes = [*analysis_faults(value), *analysis_notes(value)]

    def said(self, obj: Any) -> str:
        """Return slices, bone fraction and what spoils them."""
        spoilt = f", {obj.SpoiltSlices} of them spoilt" if obj.SpoiltSlices else ""
        return f"{obj.Slices} slices{spoilt}, bone fraction {obj.BoneFraction:.2f} %"


# -------------------------------------------------------------------------------------------- what a document keeps


def _kept(analysis: core.Analysis) -> core.Analysis:
    measures = {axis: Told(*(getattr(one, name) for name in Told._fields)) for axis, one in analysis.measures.items()}
    return replace(analysis, measures=measures)


def _measures(told: Told) -> ContourMeasures:
    """Rows as they were; what the document does not keep is nan, no contour has a parent."""
    count = len(told.plane)
    columns: Dict[str, np.ndarray] = {f.name: np.full(count, np.nan) for f in fields(ContourMeasures)}
    columns["centroid"], columns["moments"] = np.full((count, 2), np.nan), np.full((count, 3), np.nan)
    columns["parent"] = np.full(count, -1)
    return ContourMeasures(**dict(columns, **told._asdict()))


def analysis_of(obj: Any) -> core.Analysis:
    """Return the analysis that a document object shows.

    Raises
    ------
    ParameterError
        If it shows none yet.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> make.analysis_of(make.make_analysis(box.Document, box)).profiles["x"].sliced_area.round(9)[:3].tolist()
    [12.0, 12.0, 12.0]
    """
    if not given_object(obj, Analysis).ResultKey:
        raise ParameterError(f"{obj.Label} must have been computed, got: {obj.Status or 'nothing yet'}")
    found = results.find(Analysis.KIND, obj.ResultKey) or results.find(PROFILES, obj.ResultKey)
    if found is None:
        try:
            value = from_numbers(obj.Structure, obj.Numbers)
        except ExportError as error:
            raise ParameterError(f"{obj.Label} must be computed anew: {error}") from error
        measures = {axis: _measures(told) for axis, told in value.measures.items()}
        found = results.keep(PROFILES, obj.ResultKey, replace(value, measures=measures))
    name = obj.Source.Label if obj.Source is not None else found.name  # it may have got another since
    return found if name == found.name else replace(found, name=name)


def contours_at_hand(obj: Any, axis: str) -> Optional[Contours]:
    """Return the contours along one axis of what a document object shows; None if they are not at hand."""
    return results.find(CONTOURS, f"{obj.ResultKey} {axis}")


def contours_of(obj: Any, axis: str, progress: Progress = silent) -> Contours:
    """Return the contours along one axis of an analysis object's source, worked out if they are not at hand.

    Parameters
    ----------
    obj : document object
        An analysis that is up to date.
    axis : str
        One of its axes.
    progress : callable

    Raises
    ------
    ParameterError
        If the object is out of date, or has no such axis.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> len(make.contours_of(make.make_analysis(box.Document, box), "z"))
    40
    """
    inputs = given_object(obj, Analysis).Proxy.inputs(obj)
    if inputs.key != obj.ResultKey:
        raise ParameterError(f"{obj.Label} must be up to date for its contours, got: {obj.Status}")
    if axis not in inputs.parameters.axes:
        raise ParameterError(f"the axis must be one of {', '.join(inputs.parameters.axes)}, got {axis!r}")

    def make() -> Contours:
        soup = soup_of_source(inputs.body, inputs.unit, inputs.deflection, progress)
        return core.contours_of(soup, inputs.parameters, axis, progress)[0]

    return results.found_or_made(CONTOURS, f"{inputs.key} {axis}", make)


# -------------------------------------------------------------------------------------------- for another process


def write_inputs(folder: Path, inputs: Inputs) -> Dict[str, Any]:
    """Write what another process needs to compute an analysis; return the record of its task."""
    write_source(inputs.body, folder, _BODY)
    if inputs.envelope is not None:
        write_source(inputs.envelope, folder, _ENVELOPE)
    return {
        "key": inputs.key,
        "parameters": to_record(inputs.parameters),
        "unit": inputs.unit,
        "deflection": inputs.deflection,
        "morphometry": inputs.morphometry,
        "envelope": inputs.envelope is not None,
    }


def run_inputs(folder: Path, record: Dict[str, Any], progress: Progress = silent) -> List[Tuple[str, str]]:
    """Compute what ``write_inputs`` wrote, the contours too; return where the results are kept."""
    parameters = from_record(SliceParameters, record["parameters"], "parameters")

    def soup(name: str) -> Soup:
        return read_source_soup(folder, name, record["unit"], record["deflection"], part(progress, 0.0, 0.1))

    body, key = soup(_BODY), record["key"]
    envelope = soup(_ENVELOPE) if record["envelope"] else None
    value = core.analyse(body, parameters, record["morphometry"], part(progress, 0.1, 0.9), envelope)
    results.keep(Analysis.KIND, key, value)
    found = [(Analysis.KIND, key)]
    for k, axis in enumerate(parameters.axes):
        step = part(progress, 0.9 + 0.1 * k / len(parameters.axes), 0.9 + 0.1 * (k + 1) / len(parameters.axes))
        results.keep(CONTOURS, f"{key} {axis}", core.contours_of(body, parameters, axis, step)[0])
        found.append((CONTOURS, f"{key} {axis}"))
    return found


def write_slice_parameters(obj: Any, parameters: SliceParameters) -> None:
    """Set all properties of an analysis object that its parameters have; it is not computed yet."""
    write_parameters(obj, parameters)
    given = not (math.isnan(parameters.low) and math.isnan(parameters.high))
    obj.SliceRange = given
    obj.SliceLow = 0.0 if math.isnan(parameters.low) else parameters.low
    obj.SliceHigh = 0.0 if math.isnan(parameters.high) else parameters.high
    obj.SliceHeights, obj.SliceCompensation = list(parameters.heights), parameters.compensation
