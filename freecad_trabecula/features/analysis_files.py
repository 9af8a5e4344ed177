# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders of results of analysis objects: tables, report, plots; of one, or of a comparison."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, Iterable, List, Sequence, Tuple

import FreeCAD

from ..core.analysis import analysis as core
from ..core.analysis import comparison_report
from ..core.analysis import folder as core_folder
from ..core.analysis.branches import trace_branches
from ..core.analysis.comparison import compare
from ..core.analysis.passport import passport
from ..core.analysis.plots import FORMATS, analysis_figures, comparison_figures, save_figure
from ..core.estimates import Work, comparison_work, saving_work
from ..core.progress import Progress, part, silent
from ..errors import ExportError, ParameterError
from . import results
from .analysis import Analysis, analysis_of, contours_of, run_inputs, write_inputs
from .arguments import given_object, given_objects

NO_PLOTS = "none"


def save_analysis(obj: Any, folder: str, plots: str = "png", progress: Progress = silent) -> List[str]:
    """Write all numbers of an analysis object into a folder, with plots; return the files' names.

    Parameters
    ----------
    obj : document object
        An analysis that is up to date.
    folder : str
        It is made if it is not there.
    plots : str
        ``png``, ``svg``, ``pdf`` or ``none``; plots need matplotlib.
    progress : callable

    Raises
    ------
    ExportError
        If a file cannot be written; each is written whole or not at all, the report last.
    ParameterError
        If the object is out of date, or the kind of the plots is unknown.
    DependencyError
        If there is no matplotlib.

    Examples
    --------
    >>> import tempfile
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> analysis = make.make_analysis(box.Document, box)
    >>> "profile_x.csv" in make.save_analysis(analysis, tempfile.mkdtemp(), plots="none")
    True
    """
    analysis = whole_analysis(obj, part(progress, 0.0, 0.5))
    contours = {axis: contours_of(obj, axis, part(progress, 0.5, 0.6)) for axis in analysis.profiles}
    return write_analysis(analysis, contours, folder, plots, part(progress, 0.6, 1.0))


def save_comparison(
    analyses: Sequence[Any], folder: str, plots: str = "png", alignment: str = "start", progress: Progress = silent
) -> List[str]:
    """Write the comparison of two or more analysis objects, the reference first, into a folder; return the names.

    Arguments and errors are those of ``save_analysis`` and ``compare_analyses``.

    Examples
    --------
    >>> import tempfile
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> boxes = [make.make_box(FreeCAD.newDocument(), 2, 3, h) for h in (3, 4)]
    >>> analyses = [make.make_analysis(box.Document, box) for box in boxes]
    >>> "report.md" in make.save_comparison(analyses, tempfile.mkdtemp(), plots="none")
    True
    """
    whole = [whole_analysis(obj, part(progress, 0.0, 0.5)) for obj in given_objects(analyses, Analysis)]
    return write_comparison(whole, folder, plots, alignment, part(progress, 0.5, 1.0))


def whole_analysis(obj: Any, progress: Progress = silent) -> core.Analysis:
    """Return the analysis of an object with all that was measured of its contours, computed if it is not at hand.

    Raises
    ------
    ParameterError
        If the object is out of date.
    """
    key = given_object(obj, Analysis).Proxy.key(obj)
    if key != obj.ResultKey:
        raise ParameterError(f"{obj.Label} must be up to date to be saved, got: {obj.Status}")
    return results.found_or_made(Analysis.KIND, key, lambda: obj.Proxy.make(obj, progress))


# ------------------------------------------------------------------------------------------------------ the folders


def write_analysis(
    analysis: core.Analysis, contours: Dict[str, Any], folder: str, plots: str, progress: Progress = silent
) -> List[str]:
    """Write an analysis with its contours by axis into a folder; return the files' names."""
    place, least = _made(folder, plots), analysis.parameters.least_area
    branches = {axis: trace_branches(one, analysis.measures[axis], least) for axis, one in contours.items()}
    figures = analysis_figures(analysis) if plots != NO_PLOTS else ()
    names = _draw(figures, place, plots, part(progress, 0.1, 0.8))
    record = core_folder.save_analysis(
        analysis, place, also=names, versions=_versions(), branches=branches, progress=part(progress, 0.8, 1.0)
    )
    return [*record["files"], core_folder.PAGE, core_folder.REPORT]


def write_comparison(
    analyses: Sequence[core.Analysis], folder: str, plots: str, alignment: str = "start", progress: Progress = silent
) -> List[str]:
    """Write the comparison of analyses into a folder; return the files' names."""
    names = [analysis.name for analysis in analyses]
    named = [
        replace(one, name=f"{one.name} ({k + 1})") if names.count(one.name) > 1 else one
        for k, one in enumerate(analyses)
    ]
    found = compare(named, alignment=alignment)
    passports = [passport(named[0], other, alignment=alignment) for other in named[1:]]
    place = _made(folder, plots)
    figures = comparison_figures(found, named) if plots != NO_PLOTS else ()
    drawn = _draw(figures, place, plots, progress)
    record = comparison_report.save_comparison(found, passports, place, drawn, _versions())
    return [*record["files"], comparison_report.PAGE, comparison_report.REPORT]


def _made(folder: str, plots: str) -> Path:
    if plots not in (*FORMATS, NO_PLOTS):
        raise ParameterError(f"plots must be one of {', '.join(FORMATS)}, {NO_PLOTS}, got {plots!r}")
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ExportError(f"the folder {folder} could not be made: {error.strerror or error}") from error
    return Path(folder)


def _draw(figures: Iterable[Tuple[str, Any]], place: Path, kind: str, progress: Progress) -> List[str]:
    names: List[str] = []
    for name, figure in figures:
        progress(len(names), len(names) + 4, f"drawing {name}")
        save_figure(figure, place / f"{name}.{kind}", kind)
        names.append(f"{name}.{kind}")
    return names


def _versions() -> Dict[str, str]:
    return {"FreeCAD": ".".join(FreeCAD.Version()[:3])}


def work_of_saving(objects: Sequence[Any], plots: bool) -> Work:
    """Return what it takes to analyse bodies again in another process, and to save one analysis or a comparison.

    Raises
    ------
    ParameterError
        If one shows no analysis yet.
    """
    analyses = [analysis_of(obj) for obj in objects]
    again = Work(sum(one.seconds for one in analyses))
    slices = [[(len(one), int(one.contours.sum())) for one in each.profiles.values()] for each in analyses]
    if len(objects) == 1:
        return again.and_then(saving_work(slices[0], objects[0].BoneFraction / 100, plots))
    count = sum(found for each in slices for _, found in each)
    return again.and_then(comparison_work(count, max(map(len, slices)), plots))


# -------------------------------------------------------------------------------------------- for another process


def write_saving(folder: Path, objects: Sequence[Any], target: str, plots: str) -> Dict[str, Any]:
    """Write what another process needs to save one analysis object, or a comparison; return the record of its task."""
    records = []
    for number, obj in enumerate(objects):
        (folder / str(number)).mkdir()
        records.append(write_inputs(folder / str(number), obj.Proxy.inputs(obj)))
    return {"analyses": records, "target": target, "plots": plots}


def run_saving(folder: Path, record: Dict[str, Any], progress: Progress = silent) -> None:
    """Compute what ``write_saving`` wrote, and save it."""
    records, found = record["analyses"], []
    for number, one in enumerate(records):
        share = 0.6 / len(records)
        step = part(progress, number * share, (number + 1) * share)
        found.append([results.find(*place) for place in run_inputs(folder / str(number), one, step)])
    rest = part(progress, 0.6, 1.0)
    if len(found) == 1:
        analysis, *contours = found[0]
        by_axis = {one.axis: one for one in contours}
        write_analysis(analysis, by_axis, record["target"], record["plots"], rest)
    else:
        write_comparison([one[0] for one in found], record["target"], record["plots"], progress=rest)
