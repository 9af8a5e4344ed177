# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis' template as a workbook, read again by openpyxl."""

from __future__ import annotations

import sys

import pytest

from freecad_trabecula.core.analysis import workbook
from freecad_trabecula.core.analysis.workbook import template_head, write_workbook
from freecad_trabecula.errors import Cancelled, DependencyError, ExportError, ParameterError

openpyxl = pytest.importorskip("openpyxl")


def columns_of(path, sheet):
    """Columns A to H below the titles, empty cells left out, and the titles."""
    rows = list(openpyxl.load_workbook(str(path))[sheet].iter_rows(values_only=True))
    return rows[0], [[value for value in column if value is not None] for column in zip(*rows[1:])]


def test_each_axis_has_its_sheet_with_the_columns_of_the_template(measured, tmp_path):
    write_workbook(tmp_path / "a.xlsx", measured.profiles, measured.measures)
    assert openpyxl.load_workbook(str(tmp_path / "a.xlsx")).sheetnames == ["X", "Z"]
    titles, columns = columns_of(tmp_path / "a.xlsx", "X")
    assert titles == template_head("x")
    assert titles[0] == "X [mm]" and titles[7] == "Rod/Plate" and len(titles) == 8
    assert [len(column) for column in columns] == [32, 32, 20, 20, 20, 32, 32, 32]


def test_the_columns_hold_what_the_thesis_says(measured, tmp_path):
    write_workbook(tmp_path / "a.xlsx", measured.profiles, measured.measures)
    a, b, c, d, e, f, g, h = columns_of(tmp_path / "a.xlsx", "Z")[1]
    assert c == pytest.approx([0.25 + 0.5 * k for k in range(20)])
    assert sorted(set(a)) == pytest.approx(c)  # repeated for each contour of a layer
    for coordinate, total, count in zip(c, d, e):
        own = [area for where, area in zip(a, b) if where == coordinate]
        assert sum(own) == pytest.approx(total) and len(own) == count
    assert sorted(round(area) for area in set(b)) == [-36, 100]
    for area, width, height, word in zip(b, f, g, h):
        assert width == pytest.approx(6 if area < 0 else 10) and height == pytest.approx(width)
        assert word == ("rod" if area > 0 else "plate")  # a void's ratio is below the threshold


def test_without_openpyxl_the_message_says_how_to_get_it(measured, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "openpyxl", None)
    with pytest.raises(DependencyError, match="pip install openpyxl"):
        write_workbook(tmp_path / "a.xlsx", measured.profiles, measured.measures)
    assert list(tmp_path.iterdir()) == []


def test_more_contours_than_a_sheet_has_rows_are_refused(measured, tmp_path, monkeypatch):
    monkeypatch.setattr(workbook, "_MOST_ROWS", 32)
    with pytest.raises(ParameterError, match="at most 31 contours, got 32 along x"):
        write_workbook(tmp_path / "a.xlsx", measured.profiles, measured.measures)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_is_refused(measured, tmp_path):
    with pytest.raises(ExportError, match="could not be written"):
        write_workbook(tmp_path / "none" / "a.xlsx", measured.profiles, measured.measures)


def test_writing_can_be_stopped_and_leaves_nothing(measured, tmp_path):
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        write_workbook(tmp_path / "a.xlsx", measured.profiles, measured.measures, stop)
    assert list(tmp_path.iterdir()) == []
