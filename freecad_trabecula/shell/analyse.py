# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula analyse``, under FreeCAD: a body in, a folder of its slices' numbers out."""

from __future__ import annotations

import importlib.metadata
import platform
from pathlib import Path
from typing import Any, Callable, Dict, Iterable, List, Mapping, Tuple

import FreeCAD
import numpy as np

from ..core.analysis.cli_layers import write_cli
from ..core.analysis.folder import PAGE, REPORT, save_analysis
from ..core.analysis.plots import analysis_figures, require_matplotlib, save_figure
from ..core.analysis.report_text import analysis_summary
from ..core.analysis.ssl import write_ssl
from ..core.analysis.svg_layers import write_svg
from ..core.analysis.workbook import require_openpyxl, write_workbook
from ..core.progress import Progress, part
from ..errors import DependencyError, ParameterError
from .folder import ResultFolder
from .samples import Sample, read_sample

Report = Callable[..., None]
WORKBOOK = "slices.xlsx"
_ABOVE = {"middle": 0.5, "bottom": 1.0, "heights": 0.5}  # of a layer, over its plane
#: Files that an analysis may leave in its folder.
_OURS = ("profile_*.csv", "contours_*.csv", "slices*.*", *(f"*.{kind}" for kind in ("png", "svg", "pdf")))


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
    kind = plots_kind(options["plots"], report)
    progress = progress_of(report)
    with ResultFolder(options["out"]) as folder:
        report("temporary", path=str(folder.aside))
        sample = read_sample(options["file"], options, part(progress, 0.0, 0.7))
        names = _write_more(sample, options, kind, folder, part(progress, 0.7, 0.97))
        record = save_analysis(
            *(sample.analysis, folder.aside),
            **{"also": names, "versions": versions(), "notes": sample.notes},
            progress=part(progress, 0.97, 1.0),
        )
        folder.keep(*record["files"], PAGE, REPORT)  # the report last: it tells of files that are there
        warn_of_old_files(folder, record["files"], _OURS, report)
    for text in record["faults"]:
        report("warning", text=text)
    report("text", text=analysis_summary(record) + f"\nwritten to {folder.target}")
    return 0 if record["ok"] else 1


def _write_more(
    sample: Sample, options: Mapping[str, Any], kind: str, folder: ResultFolder, progress: Progress
) -> List[str]:
    """Write layers, workbook and plots; return the files' names."""
    analysis, names = sample.analysis, []
    wanted = [suffix for suffix in ("ssl", "cli", "svg") if options[suffix]]
    for number, axis in enumerate(analysis.profiles if wanted else ()):
        step = part(progress, 0.4 * number / len(analysis.profiles), 0.4 * (number + 1) / len(analysis.profiles))
        names += _write_layers(sample, axis, wanted, folder, step)
    if options["xlsx"]:
        path = folder.path(WORKBOOK)
        write_workbook(path, analysis.profiles, analysis.measures, part(progress, 0.4, 0.6))
        names.append(WORKBOOK)
    if kind != "none":
        names += write_figures(analysis_figures(analysis), kind, folder, part(progress, 0.6, 1.0))
    return names


def _write_layers(
    sample: Sample, axis: str, suffixes: List[str], folder: ResultFolder, progress: Progress
) -> List[str]:
    contours, chosen = sample.contours(axis, part(progress, 0.0, 0.5)), sample.analysis.parameters
    step, names = part(progress, 0.5, 1.0), []
    for suffix in suffixes:
        name = f"slices_{axis}.{suffix}"
        if suffix == "ssl":
            write_ssl(folder.path(name), contours, chosen.thickness, name, progress=step)
        elif suffix == "cli":
            write_cli(folder.path(name), contours, chosen.thickness, _ABOVE[chosen.at], progress=step)
        else:
            write_svg(folder.path(name), contours, f"{sample.analysis.name} along {axis}", progress=step)
        names.append(name)
    return names


# --------------------------------------------------------------------------------------- what compare does the same way


def progress_of(report: Report) -> Progress:
    """Return the callback that hands progress on as messages."""
    return lambda done, total, what: report("progress", share=done / max(total, 1e-12), what=what)


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


def versions() -> Dict[str, str]:
    """Return the versions of the programs that take part."""
    found = {"FreeCAD": ".".join(FreeCAD.Version()[:3]), "Python": platform.python_version(), "numpy": np.__version__}
    for name in ("scipy", "matplotlib", "openpyxl"):
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found
