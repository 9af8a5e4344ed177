# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula compare``, under FreeCAD: bodies or analyses in, tables, scores and plots out."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, Tuple

from ..core.analysis.analysis import Analysis
from ..core.analysis.comparison import compare
from ..core.analysis.comparison_report import KIND, PAGE, REPORT, comparison_summary, save_comparison
from ..core.analysis.passport import passport
from ..core.analysis.plots import comparison_figures
from ..core.analysis.report import analysis_checks, analysis_faults
from ..core.progress import part
from ..geometry.versions import versions
from .analyse import (
    PACKAGES,
    Report,
    plots_kind,
    progress_of,
    teller,
    warn_of_old_files,
    write_figures,
)
from .folder import ResultFolder, require_own_folder
from .samples import Sample, read_sample

_OURS = ("comparison*.csv", *(f"*.{kind}" for kind in ("png", "svg", "pdf")))


def run(options: Dict[str, Any], report: Report) -> int:
    """Compare what the options say; return the exit code.

    Parameters
    ----------
    options, report
        As in ``analyse.run``.

    Raises
    ------
    TrabeculaError
        For wrong input and whatever else goes wrong; nothing is then written.
    """
    require_own_folder(options["out"], KIND)
    kind = plots_kind(options["plots"], report)
    progress = progress_of(report)
    paths = options["samples"]
    with ResultFolder(options["out"]) as folder:
        report("temporary", path=str(folder.aside))
        steps = [part(progress, 0.8 * k / len(paths), 0.8 * (k + 1) / len(paths)) for k in range(len(paths))]
        samples = [read_sample(path, options, step, teller(path, report)) for path, step in zip(paths, steps)]
        analyses = distinctly_named([sample.analysis for sample in samples])
        progress(0.8, 1.0, "comparing")
        comparison = compare(analyses, options["layer"], options["align"])
        passports = [passport(analyses[0], other, options["layer"], options["align"]) for other in analyses[1:]]
        figures = comparison_figures(comparison, analyses) if kind != "none" else ()
        names = write_figures(figures, kind, folder, part(progress, 0.85, 1.0))
        faults, notes = _told(analyses, samples)
        record = save_comparison(comparison, passports, folder.aside, names, versions(*PACKAGES), (*faults, *notes))
        folder.keep(*record["files"], PAGE, REPORT)
        warn_of_old_files(folder, record["files"], _OURS, report)
    for text in faults:
        report("warning", text=text)
    report("text", text=comparison_summary(record) + f"\nwritten to {folder.target}")
    return 1 if faults else 0


def distinctly_named(analyses: List[Analysis]) -> List[Analysis]:
    """Return the analyses, numbered where two have one name."""
    names = [analysis.name for analysis in analyses]
    return [
        replace(analysis, name=f"{analysis.name} ({k + 1})") if names.count(analysis.name) > 1 else analysis
        for k, analysis in enumerate(analyses)
    ]


def _told(analyses: List[Analysis], samples: List[Sample]) -> Tuple[List[str], List[str]]:
    """Return what is wrong with the samples, and what else is to be said of them."""
    faults, notes = [], []
    for analysis, sample in zip(analyses, samples):
        failed = [f"a check failed: {check}" for check in analysis_checks(analysis) if not check.ok]
        faults += [f"{analysis.name}: {text}" for text in (*analysis_faults(analysis), *failed)]
        notes += [f"{analysis.name}: {text}" for text in sample.notes]
    return faults, notes
