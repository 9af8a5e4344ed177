# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of an analysis: profiles and contours as CSV, all other numbers in ``report.json``, out and in again."""

from __future__ import annotations

import json
import typing
from pathlib import Path
from typing import Any, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Union

import numpy as np

from ...errors import ExportError, ParameterError
from ..bodies import Check
from ..progress import Progress, part, silent
from ..stl import whole_file
from .analysis import Analysis
from .branches import Branches
from .json_values import from_values, values_json
from .parameters import SliceParameters, axis_name
from .profiles import Profile
from .repair import Repairs
from .report import KIND, SCHEMA, analysis_record
from .report_text import analysis_markdown
from .soundness import MeshFacts
from .tables import branches_csv, contour_columns, csv_blocks, profile_columns, profile_csv, read_contours

REPORT, PAGE = "report.json", "report.md"


def save_analysis(
    analysis: Analysis,
    folder: Union[str, Path],
    checks: Optional[Sequence[Check]] = None,
    also: Sequence[str] = (),
    versions: Optional[Mapping[str, str]] = None,
    notes: Sequence[str] = (),
    branches: Optional[Mapping[str, Branches]] = None,
    progress: Progress = silent,
) -> Dict[str, Any]:
    """Write an analysis into a folder that is there, the report last; return its record.

    Parameters
    ----------
    analysis : Analysis
    folder : str or Path
    checks, versions, notes, branches
        As ``report.analysis_record`` takes them.
    also : sequence of str
        Further files in the folder that the report is to name: plots, layers, a workbook.

    Raises
    ------
    ExportError
        If a file cannot be written; each is written whole or not at all.
    """
    folder = Path(folder)
    names: List[str] = []
    for number, (axis, profile) in enumerate(analysis.profiles.items()):
        step = part(progress, number / len(analysis.profiles), (number + 1) / len(analysis.profiles))
        columns = contour_columns(analysis.measures[axis], profile.coordinate)
        texts = {f"profile_{axis}.csv": [profile_csv(profile)], f"contours_{axis}.csv": csv_blocks(columns)}
        for name, blocks in texts.items():
            _write(folder / name, _reported(blocks, len(profile) + len(columns["layer"]), axis, step))
        names += texts
    for axis, own in (branches or {}).items():
        _write(folder / f"branches_{axis}.csv", [branches_csv(own)])
        names.append(f"branches_{axis}.csv")
    sizes = {name: _size(folder / name) for name in (*names, *also)}
    record = analysis_record(analysis, checks, sizes, versions, notes, branches)
    _write(folder / PAGE, [analysis_markdown(record)])
    _write(folder / REPORT, [values_json(record)])
    return record


def _write(path: Path, blocks: Iterable[str]) -> None:
    with whole_file(path) as file:
        for text in blocks:
            file.write(text.encode())


def _reported(blocks: Iterable[str], lines: int, axis: str, progress: Progress) -> Iterator[str]:
    """Yield blocks of lines, and report each."""
    done = 0
    for text in blocks:
        progress(min(done, lines), max(lines, 1), f"writing the tables of {axis}")
        done += text.count("\n")
        yield text


def _size(path: Path) -> int:
    try:
        return path.stat().st_size
    except OSError as error:
        raise ExportError(f"{path} could not be read: {error.strerror or error}") from error


def load_analysis(folder: Union[str, Path]) -> Analysis:
    """Return the analysis that ``save_analysis`` wrote into a folder.

    Raises
    ------
    ParameterError
        If a file is missing, or is not what was written (it is named).
    """
    folder = Path(folder)
    record = read_record(folder)
    where = str(folder / REPORT)
    for key in ("name", "unit", "parameters", "box_mm", "axes"):
        if key not in record:
            raise ParameterError(f"{where} must hold {key!r}")
    try:
        profiles = {
            axis_name(axis): _profile(folder, axis_name(axis), own, where) for axis, own in record["axes"].items()
        }
        measures = {axis: read_contours(folder / f"contours_{axis}.csv") for axis in profiles}
    except ExportError as error:
        raise ParameterError(f"{folder} is not a whole analysis: {error}") from error
    for axis, own in measures.items():
        if len(own.plane) and not (own.plane[0] >= 0 and own.plane[-1] < len(profiles[axis])):
            raise ParameterError(f"{folder / f'contours_{axis}.csv'}: layers must be those of the profile")
    facts, whole = record.get("mesh"), record.get("morphometry")
    return Analysis(
        name=str(record["name"]),
        unit=str(record["unit"]),
        parameters=from_values(SliceParameters, record["parameters"], f"{where}: parameters"),
        box=np.array(record["box_mm"], float),
        facts=None if facts is None else from_values(MeshFacts, facts, f"{where}: mesh"),
        profiles=profiles,
        measures=measures,
        morphometry=None if whole is None else _morphometry(whole, f"{where}: morphometry"),
        seconds=float(record.get("seconds") or 0.0),
        repairs={axis: r for axis in profiles for r in [_repairs(record["axes"][axis], len(profiles[axis]))] if r},
    )


def read_record(folder: Union[str, Path]) -> Dict[str, Any]:
    """Return what ``report.json`` of an analysis folder says.

    Raises
    ------
    ParameterError
        If there is none, or it is that of something else.
    """
    path = Path(folder) / REPORT
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ParameterError(f"{folder} is no folder of an analysis: {REPORT} {error.strerror or error}") from error
    except ValueError as error:  # JSON and UTF-8
        raise ParameterError(f"{path} must be JSON: {error}") from error
    if not isinstance(record, dict) or record.get("kind") != KIND:
        raise ParameterError(f"{path} must be the report of a {KIND}")
    if record.get("schema") != SCHEMA:
        raise ParameterError(f"{path} must have the schema {SCHEMA}, got {record.get('schema')!r}")
    return record


def _profile(folder: Path, axis: str, record: Mapping[str, Any], where: str) -> Profile:
    columns = profile_columns(folder / f"profile_{axis}.csv")
    count = len(columns["layer"])
    try:
        area = np.broadcast_to(np.array(record["envelope_area_mm2"], float), count).copy()
        spoilt = np.zeros(count, bool)
        spoilt[np.array(record["spoilt_layers"], int)] = True
        thickness, envelope = float(record["thickness_mm"]), str(record["envelope"])
    except (KeyError, ValueError, IndexError, TypeError) as error:
        raise ParameterError(f"{where}: axes.{axis} does not fit its profile of {count} slices: {error}") from error
    return Profile(
        axis=axis,
        thickness=thickness,
        coordinate=columns["coordinate_mm"],
        sliced_area=columns["sliced_area_mm2"],
        contours=columns["contours"],
        outer_contours=columns["outer_contours"],
        holes=columns["contours"] - columns["outer_contours"],
        envelope_area=area,
        porosity=columns["porosity"],
        spoilt=spoilt,
        envelope=envelope,
    )


def _repairs(record: Mapping[str, Any], count: int) -> Optional[Repairs]:
    """Return the repairs of an axis; what was left out of the report is 0 everywhere."""
    own = record.get("repairs")
    if own is None:
        return None
    names = list(typing.get_type_hints(Repairs))
    columns = {name: np.array(own[name]) if name in own else np.zeros(count, int) for name in names}
    return Repairs(**columns)


def _morphometry(values: Any, where: str) -> Any:
    from .morphometry import Morphometry

    return from_values(Morphometry, values, where)
