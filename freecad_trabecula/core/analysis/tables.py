# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of an analysis as CSV, out and in again: comma, point, one line of names, numbers that lose nothing.

A cell is empty where there is no number. Layers and contours are counted from 0, as the thesis counts its sums.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Sequence, Tuple, Union

import numpy as np

from ...errors import ExportError, ParameterError
from .branches import Branches
from .contours import ContourMeasures
from .profiles import Profile

#: Values of one column, one a row.
Column = Union[np.ndarray, Sequence[Any]]
PROFILE_COLUMNS = ("layer", "coordinate_mm", "sliced_area_mm2", "contours", "outer_contours", "porosity")
#: Of one row per contour: ``u`` and ``v`` are the axes in the plane (axis x: y and z, y: z and x, z: x and y);
#: ``parent`` is the row of the contour in which a hole or an island lies, -1 for none.
CONTOUR_COLUMNS = (
    *("layer", "coordinate_mm", "area_mm2", "net_area_mm2", "perimeter_mm", "width_mm", "height_mm"),
    *("centroid_u_mm", "centroid_v_mm", "moment_uu_mm4", "moment_uv_mm4", "moment_vv_mm4"),
    *("area_by_box", "rod", "circularity", "rod_invariant", "aspect", "equivalent_diameter_mm", "parent"),
)
BRANCH_COLUMNS = ("layer", "coordinate_mm", "trabeculae", "appear", "end", "split", "join")
_BLOCK = 10_000  # lines made at once: a tenth of a second
_WHOLE = ("layer", "contours", "outer_contours", "rod", "rod_invariant", "parent")


def profile_csv(profile: Profile) -> str:
    """Return a profile as CSV text, one row per slice (``PROFILE_COLUMNS``)."""
    columns: Tuple[Column, ...] = (
        *(np.arange(len(profile.coordinate)), profile.coordinate, profile.sliced_area),
        *(profile.contours, profile.outer_contours, profile.porosity),
    )
    return csv_text(dict(zip(PROFILE_COLUMNS, columns)))


def contours_csv(measures: ContourMeasures, coordinate: np.ndarray) -> str:
    """Return the measures of all contours along one axis as CSV text, one row per contour (``CONTOUR_COLUMNS``).

    Parameters
    ----------
    measures : ContourMeasures
    coordinate : ndarray of shape (S,), mm
        Of the slices.
    """
    return csv_text(contour_columns(measures, coordinate))


def contour_columns(measures: ContourMeasures, coordinate: np.ndarray) -> Dict[str, np.ndarray]:
    """Return the columns of ``contours_csv``, each ndarray of shape (C,)."""
    one = measures
    columns = (
        *(one.plane, coordinate[one.plane], one.area, one.net_area, one.perimeter, one.width, one.height),
        *(*one.centroid.T, *one.moments.T),
        *(one.ratio, one.is_rod, one.circularity, one.is_rod_invariant, one.aspect),
        *(one.equivalent_diameter, one.parent),
    )
    return dict(zip(CONTOUR_COLUMNS, columns))


def branches_csv(branches: Branches) -> str:
    """Return what becomes of the trabeculae from slice to slice as CSV text, one row per slice (``BRANCH_COLUMNS``)."""
    count = len(branches.heights)
    columns: Tuple[Column, ...] = (
        *(np.arange(count), branches.heights, np.bincount(branches.plane, minlength=count)),
        *(branches.appear, branches.end, branches.split, branches.join),
    )
    return csv_text(dict(zip(BRANCH_COLUMNS, columns)))


def csv_text(columns: Mapping[str, Column]) -> str:
    """Return columns of equal length as CSV text; floats with the digits that make them again, nan as nothing."""
    return "".join(csv_blocks(columns))


def csv_blocks(columns: Mapping[str, Column]) -> Iterator[str]:
    """Yield what ``csv_text`` returns, the line of names first, then blocks of lines."""
    yield ",".join(_quoted(name) for name in columns) + "\n"
    count = len(next(iter(columns.values()), ()))
    for start in range(0, count, _BLOCK):
        cells = [_cells(values[start : start + _BLOCK]) for values in columns.values()]
        yield "\n".join(map(",".join, zip(*cells))) + "\n"


def _cells(values: Column) -> List[str]:
    array = np.asarray(values)
    if array.dtype.kind == "f":
        texts = list(map(repr, array.tolist()))
        return ["" if text == "nan" else text for text in texts] if np.isnan(array).any() else texts
    if array.dtype.kind == "b":
        array = array.astype(int)
    return [_quoted(str(value)) for value in array.tolist()]


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\n\r') else text


def read_columns(path: Union[str, Path], names: Sequence[str]) -> Dict[str, np.ndarray]:
    """Return the columns of a CSV file of numbers, each ndarray of shape (rows,); nan where a cell is empty.

    Parameters
    ----------
    path : str or Path
    names : sequence of str
        What the first line must say.

    Raises
    ------
    ParameterError
        If it says something else, or a line holds something else (it is named).
    ExportError
        If the file cannot be read.
    """
    try:
        lines = Path(path).read_text(encoding="utf-8").splitlines()
    except OSError as error:
        raise ExportError(f"{path} could not be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise ParameterError(f"{path} must be UTF-8 text: {error}") from error
    if not lines or [word.strip() for word in lines[0].split(",")] != list(names):
        raise ParameterError(f"{path}, line 1: the columns must be {','.join(names)}, got {(lines or [''])[0][:200]!r}")
    rows = [_numbers(path, number, line, len(names)) for number, line in enumerate(lines[1:], 2) if line.strip()]
    table = np.array(rows, float).reshape(-1, len(names))
    return {name: _column(path, name, table[:, i]) for i, name in enumerate(names)}


def _numbers(path: Union[str, Path], number: int, line: str, count: int) -> List[float]:
    cells = line.split(",")
    try:
        values = [float(cell) if cell else np.nan for cell in cells]
    except ValueError:
        values = []
    if len(values) != count:
        raise ParameterError(f"{path}, line {number}: it must hold {count} numbers, got {line[:80]!r}")
    return values


def _column(path: Union[str, Path], name: str, values: np.ndarray) -> np.ndarray:
    if name not in _WHOLE:
        return values
    if not (np.isfinite(values).all() and (values == np.round(values)).all()):
        raise ParameterError(f"{path}: the column {name} must hold whole numbers")
    return values.astype(bool) if name.startswith("rod") else values.astype(int)


def profile_columns(path: Union[str, Path]) -> Dict[str, np.ndarray]:
    """Return the columns of a profile's file (``PROFILE_COLUMNS``).

    Raises
    ------
    ParameterError, ExportError
        As ``read_columns``; also if the layers are not counted from 0.
    """
    columns = read_columns(path, PROFILE_COLUMNS)
    if not np.array_equal(columns["layer"], np.arange(len(columns["layer"]))):
        raise ParameterError(f"{path}: the layers must be counted 0, 1, 2, ...")
    return columns


def read_contours(path: Union[str, Path]) -> ContourMeasures:
    """Return the measures of contours that ``contours_csv`` wrote.

    Raises
    ------
    ParameterError, ExportError
        As ``read_columns``.
    """
    columns = read_columns(path, CONTOUR_COLUMNS)
    pairs: Tuple[Tuple[str, str], ...] = (
        *(("plane", "layer"), ("area", "area_mm2"), ("net_area", "net_area_mm2"), ("perimeter", "perimeter_mm")),
        *(("width", "width_mm"), ("height", "height_mm"), ("ratio", "area_by_box"), ("is_rod", "rod")),
        *(("is_rod_invariant", "rod_invariant"), ("aspect", "aspect"), ("parent", "parent")),
        *(("circularity", "circularity"), ("equivalent_diameter", "equivalent_diameter_mm")),
    )
    return ContourMeasures(
        centroid=np.stack([columns["centroid_u_mm"], columns["centroid_v_mm"]], 1),
        moments=np.stack([columns[f"moment_{k}_mm4"] for k in ("uu", "uv", "vv")], 1),
        **{own: columns[name] for own, name in pairs},
    )
