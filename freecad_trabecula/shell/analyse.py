# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula analyse``, under FreeCAD: a body in, a folder of its slices' numbers out."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict, Iterable, List, Mapping, Tuple

from ..core.analysis.analysis import Analysis
from ..core.analysis.branches import Branches, trace_branches
from ..core.analysis.cli_layers import write_cli
from ..core.analysis.contours import Contours
from ..core.analysis.folder import PAGE, REPORT, save_analysis
from ..core.analysis.plots import analysis_figures, require_matplotlib, save_figure
from ..core.analysis.report import KIND
from ..core.analysis.report_text import analysis_summary
from ..core.analysis.ssl import write_ssl
from ..core.analysis.svg_layers import write_svg
from ..core.analysis.workbook import require_openpyxl, write_workbook
from ..core.estimates import Work
from ..core.progress import Progress, part
from ..errors import DependencyError, ParameterError
from ..geometry.versions import versions
from .folder import ResultFolder, require_own_folder
from .samples import Sample, read_sample

Report = Callable[..., None]
WORKBOOK = "slices.xlsx"
PACKAGES = ("scipy", "matplotlib", "openpyxl")  # beside numpy, whose versions are told
_ABOVE = {"middle": 0.5, "bottom": 1.0, "heights": 0.5}  # of a layer, over its plane
#: Files that an analysis may leave in its folder.
_OURS = (
    "profile_*.csv",
    "contours_*.csv",
    "branches_*.csv",
    "slices*.*",
    *(f"*.{kind}" for kind in ("png", "svg", "pdf")),
)


def run(options: Dict[str, Any], report: Report) -> int:
    """Analyse what the options say; return the exit code.

    Parameters
    ----------
    options : dict
        As ``arguments.read_arguments`` returns them.
    report : callable
        Takes messages (``launch.Child``).

    Raises
    ------
    TrabeculaError
        For wrong input and whatever else goes wrong; nothing is then written.
    """
    if options["xlsx"]:
        require_openpyxl()
    if Path(options["file"]).is_dir():
        raise ParameterError(f"a file must be analysed, got the folder {options['file']}")
    require_own_folder(options["out"], KIND)
    kind = plots_kind(options["plots"], report)
    progress = progress_of(report)
    with ResultFolder(options["out"]) as folder:
        report("temporary", path=str(folder.aside))
        sample = read_sample(options["file"], options, part(progress, 0.0, 0.7), teller(options["file"], report))
        names, branches = _write_layers(sample, options, folder, part(progress, 0.7, 0.85))
        names += _write_more(sample.analysis, options["xlsx"], kind, folder, part(progress, 0.85, 0.97))
        record = save_analysis(
            sample.analysis,
            folder.aside,
            also=names,
            versions=versions(*PACKAGES),
            notes=sample.notes,
            branches=branches,
            progress=part(progress, 0.97, 1.0),
        )
        folder.keep(*record["files"], PAGE, REPORT)  # the report last: it tells of files that are there
        warn_of_old_files(folder, record["files"], _OURS, report)
    for text in record["faults"]:
        report("warning", text=text)
    report("text", text=analysis_summary(record) + f"\nwritten to {folder.target}")
    return 0 if record["ok"] else 1


def _write_layers(
    sample: Sample, options: Mapping[str, Any], folder: ResultFolder, progress: Progress
) -> Tuple[List[str], Dict[str, Branches]]:
    """Write the contours in the formats that were asked for, and follow the trabeculae; return files and branches."""
    analysis, names, branches = sample.analysis, [], {}
    chosen = analysis.parameters
    suffixes = [suffix for suffix in ("ssl", "cli", "svg") if options[suffix]]
    if not suffixes and options["no_morphometry"]:
        return [], {}
    for number, axis in enumerate(analysis.profiles):
        step = part(progress, number / len(analysis.profiles), (number + 1) / len(analysis.profiles))
        contours = sample.contours(axis, part(step, 0.0, 0.3))
        if not options["no_morphometry"]:
            own = analysis.measures[axis]
            branches[axis] = trace_branches(contours, own, chosen.least_area, progress=part(step, 0.3, 0.6))
        for suffix in suffixes:
            path = folder.path(f"slices_{axis}.{suffix}")
            _write_contours(path, contours, analysis, part(step, 0.6, 1.0))
            names.append(path.name)
    return names, branches


def _write_contours(path: Path, contours: Contours, analysis: Analysis, progress: Progress) -> None:
    chosen = analysis.parameters
    if path.suffix == ".ssl":
        write_ssl(path, contours, chosen.thickness, path.name, progress=progress)
    elif path.suffix == ".cli":
        write_cli(path, contours, chosen.thickness, _ABOVE[chosen.at], progress=progress)
    else:
        write_svg(path, contours, f"{analysis.name} along {contours.axis}", progress=progress)


def _write_more(analysis: Analysis, workbook: bool, kind: str, folder: ResultFolder, progress: Progress) -> List[str]:
    """Write workbook and plots; return the files' names."""
    names = []
    if workbook:
        write_workbook(folder.path(WORKBOOK), analysis.profiles, analysis.measures, part(progress, 0.0, 0.5))
        names.append(WORKBOOK)
    if kind != "none":
        names += write_figures(analysis_figures(analysis), kind, folder, part(progress, 0.5, 1.0))
    return names


# --------------------------------------------------------------------------------------- what compare does the same way


def progress_of(report: Report) -> Progress:
    """Return the callback that hands progress on as messages."""
    return lambda done, total, what: report("progress", share=done / max(total, 1e-12), what=what)


def teller(path: str, report: Report) -> Callable[[Work], None]:
    """Return what says beforehand that the work on a file will be heavy; of little work it says nothing."""
    return lambda work: report("text", text=f"{Path(path).name}: {work.words}") if work.is_heavy else None


def plots_kind(asked: str, report: Report) -> str:
    """Return the kind of the plots, ``none`` with a warning where matplotlib is missing."""
    if asked != "none":
        try:
            require_matplotlib()
        except DependencyError as error:
            report("warning", text=f"there will be no plots: {error}")
            return "none"
    return asked


def write_figures(figures: Iterable[Tuple[str, Any]], kind: str, folder: ResultFolder, progress: Progress) -> List[str]:
    """Write figures as they come; return the files' names.

    Raises
    ------
    ExportError
        If one cannot be written.
    """
    names: List[str] = []
    for name, figure in figures:
        progress(len(names), len(names) + 4, f"drawing {name}")
        save_figure(figure, folder.path(f"{name}.{kind}"), kind)
        names.append(f"{name}.{kind}")
    return names


def warn_of_old_files(folder: ResultFolder, files: Iterable[str], patterns: Iterable[str], report: Report) -> None:
    """Point out result files of an earlier run: they do not belong to this report."""
    old = {path.name for pattern in patterns for path in folder.target.glob(pattern)} - set(files)
    if old:
        report("warning", text=f"{', '.join(sorted(old))} in {folder.target} belong to an earlier run")
