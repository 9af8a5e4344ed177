# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables as CSV and XLSX: Fig. 6.6's layout, out and in, damaged files."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.voxels.table_files import (
    read_table_csv,
    read_tables,
    table_grid,
    targets_of_tables,
    write_table_csv,
    write_tables_xlsx,
)
from freecad_trabecula.errors import InfeasibleError, ParameterError

ALPHA = np.array([[1, 0, 2], [2, 1, 0]])  # (N, P)
BETA = np.array([[1, 1, 0], [1, 0, 1], [1, 0, 1]])  # (M, P)


def test_the_layout_is_that_of_figure_6_6():
    # D in the first row; C_(P-1) in the second, C_0 in the last
    assert table_grid(ALPHA) == [[None, 3, 3], [2, 2, 0], [1, 0, 1], [3, 1, 2]]


def test_a_csv_file_is_read_as_it_was_written(tmp_path):
    write_table_csv(tmp_path / "alpha.csv", ALPHA)
    table = read_table_csv(tmp_path / "alpha.csv")
    assert (table.cells == ALPHA).all()
    assert table.columns.tolist() == [3, 3] and table.rows.tolist() == [3, 1, 2]


def test_a_workbook_is_read_as_it_was_written(tmp_path):
    pytest.importorskip("openpyxl", reason="openpyxl IS NOT INSTALLED: workbooks are NOT tested")
    write_tables_xlsx(tmp_path / "t.xlsx", ALPHA, BETA)
    alpha, beta = read_tables(tmp_path / "t.xlsx")
    assert (alpha.cells == ALPHA).all() and (beta.cells == BETA).all()
    targets = targets_of_tables(tmp_path / "t.xlsx", (0.1, 0.1, 0.1))
    assert [c.tolist() for c in targets.counts] == [[3, 3], [2, 2, 2], [3, 1, 2]]
    assert (targets.tables[0] == ALPHA).all()


def test_a_folder_of_two_csv_files_is_a_pair(tmp_path):
    write_table_csv(tmp_path / "alpha.csv", ALPHA)
    write_table_csv(tmp_path / "beta.csv", BETA)
    assert (targets_of_tables(tmp_path, (1, 1, 1)).tables[1] == BETA).all()


def test_sums_edited_by_hand_are_the_ones_asked_for(tmp_path):
    write_table_csv(tmp_path / "alpha.csv", ALPHA)
    text = (tmp_path / "alpha.csv").read_text().replace(",3,3", ",4,3")
    (tmp_path / "alpha.csv").write_text(text)
    write_table_csv(tmp_path / "beta.csv", BETA)
    with pytest.raises(InfeasibleError, match="must ask for the same total, got 7, 6 and 6"):
        targets_of_tables(tmp_path, (1, 1, 1))


def test_tables_with_other_layers_along_z_are_refused(tmp_path):
    write_table_csv(tmp_path / "alpha.csv", ALPHA)
    write_table_csv(tmp_path / "beta.csv", BETA[:, :2])
    with pytest.raises(ParameterError, match="same counts in the layers along Z, got 3 and 2 layers"):
        targets_of_tables(tmp_path, (1, 1, 1))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (",3,3\n2,2\n", "all rows must have the same length"),
        (",3,3\n2,2,half\n", "must be a whole number, got 'half'"),
        (",3,3\n2,2,0.5\n", "must be a whole number, got '0.5'"),
        (",3,3\n2,2,nan\n", "must be a whole number, got 'nan'"),
        ("", "a table must have sums and cells"),
    ],
)
def test_a_csv_file_that_is_no_table_is_refused(tmp_path, text, words):
    (tmp_path / "t.csv").write_text(text)
    with pytest.raises(ParameterError, match=words):
        read_table_csv(tmp_path / "t.csv")


@pytest.mark.parametrize("damage", [b"", b"PK\x03\x04 cut", b"no workbook at all"])
def test_a_damaged_workbook_is_refused(tmp_path, damage):
    pytest.importorskip("openpyxl", reason="openpyxl IS NOT INSTALLED: workbooks are NOT tested")
    (tmp_path / "t.xlsx").write_bytes(damage)
    with pytest.raises(ParameterError, match="could not be read as XLSX"):
        read_tables(tmp_path / "t.xlsx")


def test_a_workbook_cut_in_its_midst_or_without_a_sheet_is_refused(tmp_path):
    openpyxl = pytest.importorskip("openpyxl", reason="openpyxl IS NOT INSTALLED: workbooks are NOT tested")
    write_tables_xlsx(tmp_path / "t.xlsx", ALPHA, BETA)
    whole = (tmp_path / "t.xlsx").read_bytes()
    (tmp_path / "t.xlsx").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(ParameterError, match="could not be read as XLSX"):
        read_tables(tmp_path / "t.xlsx")
    openpyxl.Workbook().save(tmp_path / "u.xlsx")
    with pytest.raises(ParameterError, match="must have the sheets alpha and beta"):
        read_tables(tmp_path / "u.xlsx")
