# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document's designs, analyses, comparison and voxel designs as one HTML page, from what its objects hold."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import FreeCAD

from ..core.analysis.comparison import compare
from ..core.analysis.comparison_report import comparison_record, passport_record
from ..core.analysis.passport import passport
from ..core.analysis.report import analysis_record
from ..core.html_report.page import report_page
from ..core.html_report.sections import (
    ANALYSIS,
    COMPARISON,
    DESIGN,
    VOXELS,
    Picture,
    Section,
    analysis_charts,
    design_charts,
)
from ..core.job import Job
from ..core.language import ENGLISH, Language, Words
from ..core.progress import Progress, silent
from ..core.report import BodyFigures, Outcome, report_record
from ..core.stl import whole_file
from ..core.voxels.report import design_record
from ..errors import ParameterError, TrabeculaError
from ..geometry.versions import versions
from .analysis import Analysis, analysis_of
from .arguments import given_document, given_value
from .feature import is_a
from .jobs import job_of
from .packing import read_value, write_value
from .relations import products_of
from .scaffold import Scaffold
from .second_routes import checks_of
from .voxel_design import VoxelDesign, voxel_design_of
from .wireframe import Wireframe, wireframe_of

_PACKAGES = ("scipy", "manifold3d", "matplotlib")
Pictures = Mapping[str, Sequence[Picture]]


_FACTS, _RECORDS = "report.facts", "report.records"


class Fact(NamedTuple):
    """What one object holds: kind of its section, its label, an ``Outcome``, an analysis or a voxel design, numbers."""

    kind: str
    name: str
    value: Any
    more: Mapping[str, Any] = {}


class Facts(NamedTuple):
    """What a document holds to be told of, what cannot be told, and the report's title.

    Attributes
    ----------
    facts : tuple of Fact
    objects : tuple of str
        Names of the objects that hold them.
    notes : tuple of str
    title : str
    """

    facts: Tuple[Fact, ...]
    objects: Tuple[str, ...]
    notes: Tuple[str, ...]
    title: str


def write_report(
    document: FreeCAD.Document,
    path: Union[str, Path],
    title: str = "",
    pictures: Optional[Pictures] = None,
    language: Language = ENGLISH,
) -> Sequence[str]:
    """Write a report of all in a document into one HTML file; return what could not be told.

    Parameters
    ----------
    document : App.Document
    path : str or Path
    title : str
        None means the document's label.
    pictures : mapping of object name to Pictures
        Views that the window took.
    language : Language
        The window hands over its own.

    Raises
    ------
    ParameterError
        If the document holds nothing that can be told.
    ExportError
        If the file cannot be written; it is written whole or not at all.

    Examples
    --------
    >>> import os, tempfile
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> analysis = make.make_analysis(box.Document, box)
    >>> path = os.path.join(tempfile.mkdtemp(), "report.html")
    >>> make.write_report(box.Document, path)
    ()
    >>> "Analysis Envelope" in open(path, encoding="utf-8").read()
    True
    """
    given_value(path, str, Path)
    found = facts_of(document, title)
    return write_page(found, records_of(found), path, pictures, language)


def facts_of(document: FreeCAD.Document, title: str = "") -> Facts:
    """Return what a document's report is made of, quick to gather; objects in error and designs not built are noted.

    Raises
    ------
    ParameterError
        If there is nothing to tell.
    """
    facts: List[Fact] = []
    names: List[str] = []
    notes: List[str] = []
    for obj in given_document(document).Objects:
        for cls, gather in _GATHERERS.items():
            if is_a(obj, cls):
                try:
                    facts.append(gather(obj))
                    names.append(obj.Name)
                except TrabeculaError as error:
                    notes.append(f"{obj.Label}: {error}")
    if not facts:
        reason = "; ".join(notes) or "a design with its scaffold, an analysis or voxels are needed"
        raise ParameterError(f"a report must have something to tell, got nothing in {document.Label}: {reason}")
    return Facts(tuple(facts), tuple(names), tuple(notes), title or document.Label)


def records_of(found: Facts, progress: Progress = silent) -> List[Dict[str, Any]]:
    """Return the records of the sections: of each fact, then of the analyses' comparison, if they have one."""
    records = []
    for done, fact in enumerate(found.facts):
        progress(done, len(found.facts) + 1, "writing the report")
        records.append(_RECORD_MAKERS[fact.kind](fact))
    progress(len(found.facts), len(found.facts) + 1, "writing the report")
    return records + _comparison([fact for fact in found.facts if fact.kind == ANALYSIS])


def write_page(
    found: Facts,
    records: Sequence[Mapping[str, Any]],
    path: Union[str, Path],
    pictures: Optional[Pictures] = None,
    language: Language = ENGLISH,
) -> Sequence[str]:
    """Write the report of what a document holds, and of the records of that; arguments are those of ``write_report``.

    Raises
    ------
    ExportError
        If the file cannot be written.
    """
    sections = []
    for fact, name, record in zip(found.facts, found.objects, records):
        shown = tuple((pictures or {}).get(name, ()))
        sections.append(Section(fact.kind, record, shown, _charts(fact, record, language.words)))
    sections += [Section(COMPARISON, record) for record in records[len(found.facts) :]]
    page = report_page(sections, found.title, found.notes, language)
    with whole_file(path) as file:
        file.write(page.encode("utf-8"))
    return found.notes


def _charts(fact: Fact, record: Mapping[str, Any], words: Words) -> Tuple[str, ...]:
    if fact.kind == DESIGN:
        return tuple(design_charts(record, words))
    return tuple(analysis_charts(fact.value, words)) if fact.kind == ANALYSIS else ()


# -------------------------------------------------------------------------------------------- for another process


def write_facts(folder: Path, found: Facts) -> None:
    """Write what another process needs to make the records of a report."""
    write_value(found, folder / _FACTS)


def run_records(folder: Path, progress: Progress = silent) -> None:
    """Make the records of the facts that ``write_facts`` wrote."""
    write_value(records_of(read_value(folder / _FACTS), progress), folder / _RECORDS)


def read_records(folder: str) -> List[Dict[str, Any]]:
    """Return the records that ``run_records`` made."""
    return read_value(Path(folder) / _RECORDS)


# ---------------------------------------------------------------------------------------------------- the sections


def _design(wireframe: Any) -> Fact:
    scaffold = next((one for one in products_of(wireframe) if is_a(one, Scaffold) and one.EngineUsed), None)
    if scaffold is None:
        raise ParameterError("a design must have its scaffold to be told of: build it first")
    outcome = Outcome(
        _job(wireframe, scaffold),
        wireframe_of(wireframe),
        _body_figures(scaffold),
        tuple(checks_of(wireframe)),
        {"scaffold": scaffold.Seconds},
        0.0,
        {},
        versions(*_PACKAGES),
        tuple(wireframe.Warnings),
    )
    return Fact(DESIGN, wireframe.Label, outcome)


def _design_record(fact: Fact) -> Dict[str, Any]:
    return dict(report_record(fact.value), name=fact.name)


def _job(wireframe: Any, scaffold: Any) -> Job:
    """The design's job; a body that no job can make goes by its label."""
    try:
        return job_of(wireframe, scaffold)
    except TrabeculaError:
        return job_of(wireframe, scaffold, wireframe.Envelope.Label)


def _body_figures(scaffold: Any) -> BodyFigures:
    return BodyFigures(
        scaffold.EngineUsed,
        scaffold.Reason,
        scaffold.EnvelopeVolume.Value,
        scaffold.AddedVolume.Value,
        scaffold.ChannelVolume.Value,
        scaffold.ScaffoldVolume.Value,
        scaffold.LooseVolume.Value,
        scaffold.VoidVolume.Value,
        scaffold.Porosity / 100,
        scaffold.UnionPorosity / 100,
        scaffold.SumPorosity / 100,
        scaffold.Pieces,
        scaffold.Openings,
        scaffold.LoosePieces,
        scaffold.Voids,
        scaffold.Watertight,
        scaffold.KeepLoose,
        tuple(scaffold.Notes),
    )


def _analysis(obj: Any) -> Fact:
    return Fact(ANALYSIS, obj.Label, analysis_of(obj))


def _analysis_record(fact: Fact) -> Dict[str, Any]:
    return dict(analysis_record(fact.value, versions=versions(*_PACKAGES)), name=fact.name)


def _voxels(obj: Any) -> Fact:
    design, volume = voxel_design_of(obj), obj.MeshVolume.Value
    mesh = {
        "triangles": obj.Mesh.CountFacets,
        "volume_mm3": volume,
        "volume_error": volume / design.targets.volume - 1,
        "watertight": bool(obj.Watertight),
    }
    return Fact(VOXELS, obj.Label, design, {"seconds": obj.Seconds, "mesh": mesh})


def _voxel_record(fact: Fact) -> Dict[str, Any]:
    record = design_record(fact.value, fact.name, fact.more["seconds"], versions=versions(*_PACKAGES))
    return dict(record, mesh=fact.more["mesh"])


def _comparison(facts: Sequence[Fact]) -> List[Dict[str, Any]]:
    """The analyses that share an axis with the first, side by side."""
    named = [replace(one.value, name=one.name) for one in facts]
    named = [one for one in named if set(one.profiles) & set(named[0].profiles)]
    if len(named) < 2:
        return []
    try:
        comparison = compare(named)
        scores = passport_record([passport(named[0], other) for other in named[1:]])
    except ParameterError:  # they share no whole layer
        return []
    return [dict(comparison_record(comparison, scores, versions=versions(*_PACKAGES)))]


_GATHERERS: Dict[type, Any] = {Wireframe: _design, Analysis: _analysis, VoxelDesign: _voxels}
_RECORD_MAKERS = {DESIGN: _design_record, ANALYSIS: _analysis_record, VOXELS: _voxel_record}
