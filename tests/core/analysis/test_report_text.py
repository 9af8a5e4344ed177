# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of an analysis for readers, and the lines that the command line prints."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core.analysis.analysis import analyse, contours_of
from freecad_trabecula.core.analysis.branches import trace_branches
from freecad_trabecula.core.analysis.morphometry import measure
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.report import analysis_record
from freecad_trabecula.core.analysis.report_text import (
    analysis_markdown,
    analysis_summary,
    number_words,
    percent_words,
    range_words,
    table,
)
from freecad_trabecula.core.analysis.tables import branches_csv
from freecad_trabecula.core.analysis.triangles import Soup


@pytest.fixture
def page(measured):
    return analysis_markdown(analysis_record(measured, files={"profile_x.csv": 1234}, versions={"numpy": "2.0"}))


def test_the_page_has_the_thesis_rows_with_the_cube_s_figures(page):
    lines = page.splitlines()
    assert "|  | X | Z |" in lines
    assert "| total number of rods | 20 | 20 |" in lines
    assert "| trabecular area range, mm2 | -36 to 100 | -36 to 100 |" in lines
    assert "| porosity range, % | 0 to 36 | 0 to 36 |" in lines
    assert "| sliced area, mm2 | 64 to 100 | 64 to 100 |" in lines
    assert "| mean bone fraction, % | 78.4 | 78.4 |" in lines
    assert "| gap fill, maximum, mm | 0.01 |" in lines
    assert "| sample size, bounding box, mm | 10 x 10 x 10 |" in lines


def test_the_page_tells_of_checks_mesh_files_and_versions(page):
    assert "All checks held." in page
    assert "| open edges | 0 |" in page
    assert "| profile_x.csv | 1.234 kB |" in page
    assert "Made with numpy 2.0." in page
    assert "Morphometry" not in page


def test_every_table_of_the_page_is_whole(page):
    widths = [line.count("|") for line in page.splitlines() if line.startswith("|")]
    blocks = [block for block in page.split("\n\n") if block.startswith("|")]
    assert len(blocks) >= 5 and min(widths) >= 3
    assert all(len({line.count("|") for line in block.splitlines()}) == 1 for block in blocks)


def test_morphometry_is_a_table_with_definition_and_source(cavity):
    analysis = analyse(cavity, SliceParameters(thickness=1.0, axes=("z",)), morphometry=False)
    whole = measure(cavity, voxel=0.5)
    text = analysis_markdown(analysis_record(replace(analysis, morphometry=whole)))
    assert "## Morphometry" in text and "| symbol | name | value | unit | definition | source |" in text
    assert "| BV/TV | bone volume fraction | 0.784000 |" in text


def test_interconnectivity_is_a_table_with_a_column_for_each_axis(measured, cavity):
    found = {}
    for axis in ("x", "z"):
        contours, _ = contours_of(cavity, measured.parameters, axis)
        found[axis] = trace_branches(contours, measured.measures[axis])
    record = analysis_record(measured, branches=found)
    text = analysis_markdown(record)
    # one trabecula from the first slice to the last, its hole notwithstanding
    assert "| branches: chains of trabeculae that go on without an event | 1 | 1 |" in text
    assert "| trabeculae that split | 0 | 0 |" in text
    assert record["interconnectivity"]["x"]["branches_per_mm"] == pytest.approx(1 / 9.5)
    lines = branches_csv(found["x"]).splitlines()
    assert lines[0] == "layer,coordinate_mm,trabeculae,appear,end,split,join"
    assert lines[1] == "0,0.25,1,0,0,0,0" and len(lines) == 21


def test_a_faulty_mesh_is_said_at_the_top_of_the_page_and_in_the_summary(box):
    soup = Soup(np.delete(box((0, 0, 0), (10, 10, 10)), 0, 0), "mm", "open.stl")
    record = analysis_record(analyse(soup, SliceParameters(thickness=1.0), morphometry=False))
    assert "**The mesh is faulty" in "\n".join(analysis_markdown(record).splitlines()[:4])
    assert "FAULT: 3 open edges" in analysis_summary(record)


def test_the_summary_has_a_line_for_each_axis_and_says_whether_checks_held(measured):
    lines = analysis_summary(analysis_record(measured)).splitlines()
    assert lines[0] == "cavity.stl, 10 x 10 x 10 mm (unit: mm), fill rule winding"
    assert lines[1].startswith("x: 20 slices, sliced area 64 to 100 mm2, porosity 0 to 36 %, 20 rods, 0 plates")
    assert lines[-1] == "all 3 checks held"


def test_a_check_that_failed_is_named_in_the_summary(measured):
    wrong = replace(measured.profiles["x"], sliced_area=np.full(20, 10.0))
    record = analysis_record(replace(measured, profiles={"x": wrong}))
    assert "FAILED: volume along x" in analysis_summary(record)
    assert "**FAILED**" in analysis_markdown(record) and "Not all checks held" in analysis_markdown(record)


def test_what_is_no_number_is_a_dash():
    assert (number_words(None), range_words([None, 1.0]), percent_words(None)) == ("-", "-", "-")
    assert (number_words(1234.5), range_words([10.1, 25.08]), percent_words(0.1234)) == (
        *("1234.50", "10.1 to 25.08", "12.34"),
    )


def test_cells_do_not_break_a_table():
    assert table(("a",), [("x|y\nz",)]).splitlines()[2] == "| x\\|y z |"
    assert table(("a",), []) == "None."
