# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula report``: folders of results in, one HTML page out."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict, Sequence

from ..core.html_report.page import report_page
from ..core.html_report.sections import Section, read_section
from ..core.report_text import size_words
from ..core.stl import whole_file

Report = Callable[..., None]


def run(options: Dict[str, Any], report: Report) -> int:
    """Write the report of the folders that the options name; return the exit code.

    Parameters
    ----------
    options : dict
        ``folders``, ``out``, ``title``, ``quiet``.
    report : callable
        As in ``analyse.run``.

    Raises
    ------
    TrabeculaError
        If a folder holds no results, or the page cannot be written; nothing is then written.
    """
    sections = []
    for done, folder in enumerate(options["folders"]):
        report("progress", share=done / len(options["folders"]), what=f"reading {folder}")
        sections.append(read_section(folder))
    page = report_page(sections, options["title"] or _title(sections)).encode("utf-8")
    with whole_file(options["out"]) as file:
        file.write(page)
    if not options["quiet"]:
        report("text", text=f"{Path(options['out'])}: {len(sections)} parts, {size_words(len(page))}")
    return 0


def _title(sections: Sequence[Section]) -> str:
    more = f" and {len(sections) - 1} more" if len(sections) > 1 else ""
    return f"Report of {sections[0].name}{more}"
