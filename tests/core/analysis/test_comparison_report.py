# SPDX-License-Identifier: LGPL-2.1-or-later
"""A comparison as files: tables, scores, pages."""

from __future__ import annotations

import csv
import json

import pytest

from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.comparison import compare
from freecad_trabecula.core.analysis.comparison_report import (
    comparison_markdown,
    comparison_record,
    comparison_summary,
    passport_markdown,
    passport_record,
    save_comparison,
    shared_csv,
)
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.passport import DEFINITIONS, passport
from freecad_trabecula.core.analysis.triangles import Soup
from freecad_trabecula.errors import ExportError


@pytest.fixture
def solid(box):
    """A full cube beside the one with a cavity."""
    soup = Soup(box((0, 0, 0), (10, 10, 10)), "mm", "solid, full")
    return analyse(soup, SliceParameters(thickness=0.5, axes=("x", "z")), morphometry=False)


@pytest.fixture
def compared(measured, solid):
    return compare([measured, solid]), [passport(measured, solid)]


def test_all_files_are_written_and_named_in_the_report(compared, tmp_path):
    (tmp_path / "plot.png").write_bytes(b"123")
    record = save_comparison(*compared, tmp_path, also=("plot.png",), versions={"numpy": "1"}, notes=("said",))
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([*record["files"], "report.json", "report.md"])
    assert {"comparison.csv", "comparison_x.csv", "comparison_z.csv", "passport.md", "passport.json"} < set(
        record["files"]
    )
    assert json.loads((tmp_path / "report.json").read_text()) == record
    assert record["notes"][0] == "said" and record["names"] == ["cavity.stl", "solid, full"]


def test_the_table_of_totals_has_a_column_for_each_axis_and_sample(compared, tmp_path):
    save_comparison(*compared, tmp_path)
    rows = list(csv.reader((tmp_path / "comparison.csv").read_text(encoding="utf-8").splitlines()))
    assert rows[0] == ["", "X cavity.stl", "X solid, full", "Z cavity.stl", "Z solid, full"]
    found = {row[0]: row[1:] for row in rows[1:]}
    assert found["Sliced area (mm2)"] == ["64 to 100", "100 to 100"] * 2
    assert found["Trabecular area range (mm2)"] == ["-36 to 100", "100 to 100"] * 2


def test_profiles_on_shared_layers_have_all_samples_and_their_differences(compared):
    rows = list(csv.DictReader(shared_csv(compared[0].axes["x"], compared[0].names).splitlines()))
    assert len(rows) == 20
    for row in rows:
        inside = 2 < float(row["middle_mm"]) < 8
        assert float(row["sliced_area_mm2 difference 2 - 1"]) == pytest.approx(36 if inside else 0, abs=1e-9)
        assert float(row["porosity 1 cavity.stl"]) == pytest.approx(0.36 if inside else 0, abs=1e-12)
        assert float(row["top_mm"]) - float(row["bottom_mm"]) == pytest.approx(0.5)


def test_the_record_counts_sections_with_the_same_value(compared):
    record = comparison_record(compared[0], passport_record(compared[1]))
    area = next(one for one in record["axes"]["x"]["differences"] if one["of"] == "sliced area")
    assert area["mean"] == pytest.approx(36 * 0.6)
    assert area["largest"] == pytest.approx(36) and area["middle"] == pytest.approx(36)
    assert "values" not in area


def test_a_sample_against_itself_has_distances_of_nothing(measured):
    scores = passport_record([passport(measured, measured)])["passports"][0]["scores"]
    for one in scores:
        if one["symbol"] in ("L1", "L2", "KS", "H"):
            assert one["value"] == 0.0
        if one["symbol"] == "r":
            assert one["value"] in (1.0, None)


def test_the_passport_is_a_page_with_every_score_and_its_definition(compared):
    text = passport_markdown(passport_record(compared[1]))
    assert text.startswith("# Slice passport\n\n## solid, full against cavity.stl\n")
    # |b - a| = 36 in 12 of 20 slices, |a| = 100 in 8 and 64 in 12
    first = 12 * 36 / (8 * 100 + 12 * 64)
    assert f"| sliced area | L1 |  | {first:.4g} | {first:.4g} | {first:.4g} |" in text
    used = [
        line.split("|")[1].strip() for line in text.split("## Definitions")[1].splitlines() if line.startswith("| ")
    ]
    assert len(used) == len(set(used)) and set(used) - {"score", "---"} <= set(DEFINITIONS)


def test_three_samples_have_two_passports_against_the_first(measured, solid, tmp_path):
    both = [passport(measured, solid), passport(measured, measured)]
    record = save_comparison(compare([measured, solid, measured]), both, tmp_path)
    assert [one["sample"] for one in record["passports"]] == ["solid, full", "cavity.stl"]
    assert (tmp_path / "passport.md").read_text().count("against cavity.stl") == 2
    assert comparison_summary(record).count("against cavity.stl:") == 2


def test_the_page_has_the_tables_and_says_what_counts(compared):
    text = comparison_markdown(comparison_record(compared[0], passport_record(compared[1])))
    assert text.startswith("# solid, full against cavity.stl\n")
    assert "| Sliced area (mm2) | 64 to 100 | 100 to 100 |" in text
    assert "| X | solid, full | sliced area | mm2 | 21.6000 | 36.0000 |" in text
    blocks = [block for block in text.split("\n\n") if block.startswith("|")]
    assert all(len({line.count("|") for line in block.splitlines()}) == 1 for block in blocks)


def test_the_summary_is_a_line_for_each_sample(compared):
    text = comparison_summary(comparison_record(compared[0], passport_record(compared[1])))
    assert text.startswith("solid, full against cavity.stl: sliced area L1 0.2755, correlation -; trabecular area KS")


def test_a_folder_that_is_not_there_is_refused(compared, tmp_path):
    with pytest.raises(ExportError, match="could not be written"):
        save_comparison(*compared, tmp_path / "none")
