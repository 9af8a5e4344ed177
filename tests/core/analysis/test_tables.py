# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables as CSV: nothing is lost on the way out and in, and what is no table is refused with its line."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest

from freecad_trabecula.core.analysis.tables import (
    CONTOUR_COLUMNS,
    PROFILE_COLUMNS,
    contours_csv,
    csv_text,
    profile_columns,
    profile_csv,
    read_columns,
    read_contours,
)
from freecad_trabecula.errors import ExportError, ParameterError


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text)))


def test_the_profile_has_exactly_the_columns_that_were_promised(measured):
    text = profile_csv(measured.profiles["x"])
    assert text.splitlines()[0] == "layer,coordinate_mm,sliced_area_mm2,contours,outer_contours,porosity"


def test_the_profile_of_a_cube_with_a_cavity_has_its_areas_and_counts(measured):
    rows = rows_of(profile_csv(measured.profiles["z"]))
    assert len(rows) == 20
    assert [int(row["layer"]) for row in rows] == list(range(20))
    for row in rows:
        coordinate = float(row["coordinate_mm"])
        inside = 2 < coordinate < 8
        assert float(row["sliced_area_mm2"]) == pytest.approx(64 if inside else 100, rel=1e-12)
        assert (row["contours"], row["outer_contours"]) == (("2", "1") if inside else ("1", "1"))
        assert float(row["porosity"]) == pytest.approx(0.36 if inside else 0, abs=1e-12)


def test_each_contour_has_a_row_and_the_void_its_parent(measured):
    rows = rows_of(contours_csv(measured.measures["x"], measured.profiles["x"].coordinate))
    assert len(rows) == 20 + 12
    voids = [row for row in rows if float(row["area_mm2"]) < 0]
    assert len(voids) == 12
    for row in voids:
        assert float(row["area_mm2"]) == pytest.approx(-36, rel=1e-12)
        assert row["net_area_mm2"] == ""
        parent = rows[int(row["parent"])]
        assert float(parent["area_mm2"]) == pytest.approx(100, rel=1e-12)
        assert float(parent["net_area_mm2"]) == pytest.approx(64, rel=1e-12)
        assert parent["coordinate_mm"] == row["coordinate_mm"]


def test_profiles_and_contours_come_back_bit_by_bit(measured, tmp_path):
    for axis, profile in measured.profiles.items():
        (tmp_path / "p.csv").write_text(profile_csv(profile))
        (tmp_path / "c.csv").write_text(contours_csv(measured.measures[axis], profile.coordinate))
        columns = profile_columns(tmp_path / "p.csv")
        assert np.array_equal(columns["sliced_area_mm2"], profile.sliced_area)
        assert np.array_equal(columns["porosity"], profile.porosity)
        assert columns["contours"].dtype.kind == "i"
        found = read_contours(tmp_path / "c.csv")
        for name, values in vars(measured.measures[axis]).items():
            assert np.array_equal(getattr(found, name), values, equal_nan=True), name
            assert getattr(found, name).dtype.kind == values.dtype.kind, name


def test_numbers_keep_all_their_digits_and_what_is_none_is_empty():
    values = np.array([0.1, 1 / 3, 1e-300, np.nan, -0.0])
    lines = csv_text({"a": values, "b": np.array([True, False, True, False, True])}).splitlines()
    assert lines[0] == "a,b"
    assert lines[4] == ",0"
    back = [float(line.split(",")[0]) for line in lines[1:4]]
    assert back == values[:3].tolist()


def test_names_with_commas_and_quotes_are_quoted():
    text = csv_text({'a,"b"': [1.5], "c": ["x\ny"]})
    assert next(csv.reader(io.StringIO(text))) == ['a,"b"', "c"]
    assert list(csv.reader(io.StringIO(text)))[1] == ["1.5", "x\ny"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "line 1: the columns must be layer,coordinate_mm"),
        ("layer,area\n0,1\n", "line 1: the columns must be .* got 'layer,area'"),
        ("{head}\n0,0.5,1,1,1\n", "line 2: it must hold 6 numbers, got '0,0.5,1,1,1'"),
        ("{head}\n0,0.5,1,1,1,0\n1,one,1,1,1,0\n", "line 3: it must hold 6 numbers"),
        ("{head}\n0,0.5,1,1.5,1,0\n", "the column contours must hold whole numbers"),
        ("{head}\n0,0.5,1,,1,0\n", "the column contours must hold whole numbers"),
        ("{head}\n3,0.5,1,1,1,0\n", "the layers must be counted 0, 1, 2"),
    ],
)
def test_what_is_no_profile_is_refused_with_its_line(text, message, tmp_path):
    (tmp_path / "p.csv").write_text(text.replace("{head}", ",".join(PROFILE_COLUMNS)))
    with pytest.raises(ParameterError, match=message):
        profile_columns(tmp_path / "p.csv")


def test_a_table_that_is_not_there_or_no_text_is_refused(tmp_path):
    with pytest.raises(ExportError, match="could not be read"):
        read_columns(tmp_path / "none.csv", CONTOUR_COLUMNS)
    (tmp_path / "b.csv").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ParameterError, match="must be UTF-8 text"):
        read_columns(tmp_path / "b.csv", CONTOUR_COLUMNS)
