# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables alpha and beta as CSV and XLSX, in the layout of the thesis' Fig. 6.6, out and in again.

The first row holds the column sums D (or E) from the second cell on; the first column the row sums C, the last layer
C_(P-1) in the second row and C_0 at the bottom; cell (i, j) between them.
"""

from __future__ import annotations

import csv
import io
import zipfile
from pathlib import Path
from typing import Any, List, NamedTuple, Sequence, Tuple, Union
from xml.etree.ElementTree import ParseError

import numpy as np

from ...errors import ParameterError
from ..analysis.workbook import require_openpyxl
from ..parameters import require
from ..stl import whole_file
from ..triples import triple
from .targets import Targets

SHEETS = ("alpha", "beta")


class ReadTable(NamedTuple):
    """A table from a file.

    Attributes
    ----------
    cells : ndarray of shape (K, P), int64
        As alpha (N, P) or beta (M, P).
    columns : ndarray of shape (K,), int64
        The sums in the first row: D or E.
    rows : ndarray of shape (P,), int64
        The sums in the first column: C.
    """

    cells: np.ndarray
    columns: np.ndarray
    rows: np.ndarray


def table_grid(table: np.ndarray) -> List[List[Any]]:
    """Return the rows of Fig. 6.6, sums of the table itself in the first row and column, None in the corner.

    Parameters
    ----------
    table : ndarray of shape (K, P), int

    Examples
    --------
    >>> table_grid(np.array([[1, 2], [3, 4]]))
    [[None, 3, 7], [6, 2, 4], [4, 1, 3]]
    """
    grid: List[List[Any]] = [[None, *table.sum(1).tolist()]]
    return grid + [[int(table[:, i].sum()), *table[:, i].tolist()] for i in reversed(range(table.shape[1]))]


def write_table_csv(path: Union[str, Path], table: np.ndarray) -> None:
    """Write a table (K, P) as CSV.

    Raises
    ------
    ExportError
        If the file cannot be written.
    """
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(
        [["" if v is None else v for v in row] for row in table_grid(table)]
    )
    with whole_file(path) as file:
        file.write(text.getvalue().encode("ascii"))


def write_tables_xlsx(path: Union[str, Path], alpha: np.ndarray, beta: np.ndarray) -> None:
    """Write both tables as one workbook with the sheets ``alpha`` and ``beta``.

    Raises
    ------
    DependencyError
        If openpyxl is missing.
    ExportError
        If the file cannot be written.
    """
    book = require_openpyxl().Workbook(write_only=True)
    for name, table in zip(SHEETS, (alpha, beta)):
        sheet = book.create_sheet(name)
        for row in table_grid(table):
            sheet.append(row)
    with whole_file(path) as file:
        book.save(file)


def read_table_csv(path: Union[str, Path]) -> ReadTable:
    """Return the table of a CSV file.

    Raises
    ------
    ParameterError
        If the file cannot be read, its rows differ in length, or a cell is no whole number.
    """
    try:
        with Path(path).open(newline="", encoding="utf-8-sig") as file:
            rows = [row for row in csv.reader(file) if row]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise ParameterError(f"{path} could not be read as CSV: {error}") from error
    return _table_of(rows, str(path))


def read_tables_xlsx(path: Union[str, Path]) -> Tuple[ReadTable, ReadTable]:
    """Return alpha and beta of a workbook.

    Raises
    ------
    ParameterError
        If the file is damaged, a sheet is missing, or a cell is no whole number.
    DependencyError
        If openpyxl is missing.
    """
    openpyxl = require_openpyxl()
    try:
        book = openpyxl.load_workbook(path, read_only=True, data_only=True)
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile, ParseError,
            openpyxl.utils.exceptions.InvalidFileException) as error:  # fmt: skip
        raise ParameterError(f"{path} could not be read as XLSX: {error}") from error
    try:
        tables = []
        for name in SHEETS:
            require(name in book.sheetnames, f"{path} must have the sheets alpha and beta; it has", book.sheetnames)
            tables.append(_table_of([list(row) for row in book[name].iter_rows(values_only=True)], f"{path}, {name}"))
    finally:
        book.close()
    return tables[0], tables[1]


def read_tables(path: Union[str, Path]) -> Tuple[ReadTable, ReadTable]:
    """Return alpha and beta of a workbook, or of two CSV files ``alpha.csv`` and ``beta.csv`` in a folder."""
    path = Path(path)
    if path.is_dir():
        return read_table_csv(path / "alpha.csv"), read_table_csv(path / "beta.csv")
    return read_tables_xlsx(path)


def targets_of_tables(path: Union[str, Path], voxel: Sequence[float]) -> Targets:
    """Return the targets that two tables ask for by the sums in their first rows and columns, with the tables.

    Parameters
    ----------
    path : str or Path
        As ``read_tables`` takes it.
    voxel : sequence of float, mm

    Raises
    ------
    ParameterError
        If the two tables have other layers along Z or other counts in them.
    InfeasibleError
        If the sums' totals differ.
    """
    alpha, beta = read_tables(path)
    same = len(alpha.rows) == len(beta.rows) and bool((alpha.rows == beta.rows).all())
    got = f"{len(alpha.rows)} and {len(beta.rows)} layers of {alpha.rows.sum()} and {beta.rows.sum()} voxels"
    require(same, "alpha and beta must have the same counts in the layers along Z", got)
    return Targets(alpha.columns, beta.columns, alpha.rows, triple(voxel), tables=(alpha.cells, beta.cells))


def _table_of(rows: Sequence[Sequence[Any]], where: str) -> ReadTable:
    require(len(rows) > 1 and len(rows[0]) > 1, f"{where}: a table must have sums and cells, got rows", len(rows))
    widths = {len(row) for row in rows}
    require(len(widths) == 1, f"{where}: all rows must have the same length", sorted(widths))
    columns = np.array([_whole(v, where) for v in rows[0][1:]], np.int64)
    body = np.array([[_whole(v, where) for v in row] for row in rows[:0:-1]], np.int64)
    return ReadTable(body[:, 1:].T.copy(), columns, body[:, 0].copy())


def _whole(value: Any, where: str) -> int:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ParameterError(f"{where}: every sum and cell must be a whole number, got {value!r}") from None
    require(number == int(number) if np.isfinite(number) else False,
            f"{where}: every sum and cell must be a whole number", repr(value))  # fmt: skip
    return int(number)
