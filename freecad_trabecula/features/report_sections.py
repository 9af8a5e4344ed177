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
from ..core.report import BodyFigures, Outcome, report_record
from ..core.stl import whole_file
from ..core.voxels.report import design_record
from ..errors import ParameterError, TrabeculaError
from ..geometry.versions import versions
from .analysis import Analysis, analysis_of
from .feature import is_a
from .jobs import job_of
from .relations import products_of
from .scaffold import Scaffold
from .second_routes import checks_of
from .voxel_design import VoxelDesign, voxel_design_of
from .wireframe import Wireframe, wireframe_of

_PACKAGES = ("scipy", "manifold3d", "matplotlib")
Pictures = Mapping[str, Sequence[Picture]]


class Told(NamedTuple):
    """Sections of a report, and what could not be told."""

    sections: Tuple[Section, ...]
    notes: Tuple[str, ...]


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
    told = sections_of(document, pictures, language.words)
    page = report_page(told.sections, title or document.Label, told.notes, language)
    with whole_file(path) as file:
        file.write(page.encode("utf-8"))
    return told.notes


def sections_of(document: FreeCAD.Document, pictures: Optional[Pictures] = None, words: Words = str) -> Told:
    """Return the sections of a document's report, and what could not be told: objects in error, designs not built.

    Raises
    ------
    ParameterError
        If there is none.
    """
    sections: List[Section] = []
    notes: List[str] = []
    for obj in document.Objects:
        for cls, make in _MAKERS.items():
            if is_a(obj, cls):
                try:
                    sections.append(make(obj, tuple((pictures or {}).get(obj.Name, ())), words))
                except TrabeculaError as error:
                    notes.append(f"{obj.Label}: {error}")
    sections += _comparison(document)
    if not sections:
        reason = "; ".join(notes) or "a design with its scaffold, an analysis or voxels are needed"
        raise ParameterError(f"a report must have something to tell, got nothing in {document.Label}: {reason}")
    return Told(tuple(sections), tuple(notes))


# ---------------------------------------------------------------------------------------------------- the sections


def _design(wireframe: Any, pictures: Tuple[Picture, ...], words: Words) -> Section:
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
    record = dict(report_record(outcome), name=wireframe.Label)
    return Section(DESIGN, record, pictures, tuple(design_charts(record, words)))


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


def _analysis(obj: Any, pictures: Tuple[Picture, ...], words: Words) -> Section:
    analysis = analysis_of(obj)
    record = dict(analysis_record(analysis, versions=versions(*_PACKAGES)), name=obj.Label)
    return Section(ANALYSIS, record, pictures, tuple(analysis_charts(analysis, words)))


def _voxels(obj: Any, pictures: Tuple[Picture, ...], words: Words) -> Section:
    design = voxel_design_of(obj)
    record = design_record(design, obj.Label, obj.Seconds, versions=versions(*_PACKAGES))
    volume = obj.MeshVolume.Value
    record["mesh"] = {
        "triangles": obj.Mesh.CountFacets,
        "volume_mm3": volume,
        "volume_error": volume / design.targets.volume - 1,
        "watertight": bool(obj.Watertight),
    }
    return Section(VOXELS, record, pictures)


def _comparison(document: FreeCAD.Document) -> Sequence[Section]:
    """The analyses that share an axis with the first, side by side."""
    objects = [obj for obj in document.Objects if is_a(obj, Analysis) and obj.ResultKey]
    analyses = [(obj.Label, analysis_of(obj)) for obj in objects]
    shared = [(name, one) for name, one in analyses if set(one.profiles) & set(analyses[0][1].profiles)]
    if len(shared) < 2:
        return ()
    named = [replace(one, name=name) for name, one in shared]
    try:
        comparison = compare(named)
        scores = passport_record([passport(named[0], other) for other in named[1:]])
    except ParameterError:  # they share no whole layer
        return ()
    return [Section(COMPARISON, comparison_record(comparison, scores, versions=versions(*_PACKAGES)))]


_MAKERS: Dict[type, Any] = {Wireframe: _design, Analysis: _analysis, VoxelDesign: _voxels}
