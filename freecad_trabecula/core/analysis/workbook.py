# SPDX-License-Identifier: LGPL-2.1-or-later
"""The template of the thesis (5.2.3.1, Fig. 5.3) as an XLSX workbook: one sheet for each axis, columns A to H.

A, B, F, G, H have one row per contour, C, D, E one per slice, as in the template. The template's "[mm2]" over the
sides of the bounding box is mm here.
"""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any, List, Mapping, Tuple, Union

import numpy as np

from ...errors import ParameterError
from ..optional_packages import optional_module
from ..progress import Progress, silent
from ..stl import whole_file
from .contours import ContourMeasures
from .profiles import Profile

_MOST_ROWS = 1_048_576  # of a sheet of XLSX, the titles among them
_BLOCK = 2000  # rows between two reports of progress
_WIDTH = 20  # of a column, letters


def template_head(axis: str) -> Tuple[str, ...]:
    """Return the titles of columns A to H."""
    name = axis.upper() if len(axis) == 1 else axis
    return (
        *(f"{name} [mm]", "Trabecular area [mm2]", f"{name} progressive [mm]", "Sliced area [mm2]"),
        *("Number of trabeculae", "H bound box [mm]", "V bound box [mm]", "Rod/Plate"),
    )


def template_rows(profile: Profile, measures: ContourMeasures) -> List[Tuple[Any, ...]]:
    """Return the rows of columns A to H; None where a column has ended."""
    words = np.where(measures.is_rod, "rod", "plate")
    contour = (profile.coordinate[measures.plane], measures.area, measures.width, measures.height, words)
    a, b, f, g, h = (values.tolist() for values in contour)
    c, d, e = (values.tolist() for values in (profile.coordinate, profile.sliced_area, profile.contours))
    return list(itertools.zip_longest(a, b, c, d, e, f, g, h))


def require_openpyxl() -> Any:
    """Return the module openpyxl.

    Raises
    ------
    DependencyError
        If it is missing; the message says how to install it.
    """
    return optional_module("openpyxl", "a workbook needs openpyxl")


def write_workbook(
    path: Union[str, Path],
    profiles: Mapping[str, Profile],
    measures: Mapping[str, ContourMeasures],
    progress: Progress = silent,
) -> None:
    """Write the template, filled in, one sheet for each axis.

    Parameters
    ----------
    path : str or Path
    profiles, measures : mapping of axis to Profile, ContourMeasures

    Raises
    ------
    DependencyError
        If openpyxl is missing.
    ParameterError
        If there are more contours along an axis than a sheet has rows.
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    openpyxl = require_openpyxl()
    for axis, own in measures.items():
        if max(len(own), len(profiles[axis])) >= _MOST_ROWS:
            raise ParameterError(
                f"a sheet of a workbook holds at most {_MOST_ROWS - 1} contours, got {len(own)} along {axis}; thicker "
                "layers have fewer"
            )
    book = openpyxl.Workbook()  # one that writes as it goes leaves its files behind when it is stopped
    book.remove(book.active)
    bold = openpyxl.styles.Font(bold=True)
    tables = {axis: template_rows(profiles[axis], measures[axis]) for axis in profiles}
    done, total = 0, sum(map(len, tables.values()))
    for axis, rows in tables.items():
        sheet = book.create_sheet(axis.upper()[:31])
        sheet.freeze_panes = "A2"
        for letter in "ABCDEFGH":
            sheet.column_dimensions[letter].width = _WIDTH
        sheet.append(template_head(axis))
        for cell in sheet[1]:
            cell.font = bold
        for row in rows:
            if done % _BLOCK == 0:
                progress(done, max(total, 1), f"writing the workbook's sheet {axis.upper()}")
            sheet.append(row)
            done += 1
    with whole_file(path) as file:
        book.save(file)
