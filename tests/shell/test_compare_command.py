# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula compare`` as a user runs it."""

from __future__ import annotations

import csv
import json
import re

import numpy as np
import pytest
from shell_runs import names, run

from freecad_trabecula.core import meshes, stl

FEW = ["--no-morphometry", "--plots", "none"]
TABLES = ["comparison.csv", *(f"comparison_{axis}.csv" for axis in "xyz"), "passport.json", "passport.md"]
REPORTS = ["report.json", "report.md"]
SQUARES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def write_box(path, size, less=0):
    """A box from the origin; ``less`` facets are missing."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) * size
    triangles = np.array([t for a, b, c, d in SQUARES for t in ((a, b, c), (a, c, d))])
    stl.write_stl(path, meshes.Mesh(corners, triangles[less:]))


@pytest.fixture(scope="module")
def samples(tmp_path_factory):
    """Boxes of 10 x 10 x 10 and 10 x 10 x 8 mm, and a folder of the first one's analysis."""
    folder = tmp_path_factory.mktemp("samples")
    write_box(folder / "cube.stl", (10, 10, 10))
    write_box(folder / "slab.stl", (10, 10, 8))
    assert run("analyse", folder / "cube.stl", "--thickness", 0.5, *FEW, "--out", folder / "earlier").returncode == 0
    return folder


@pytest.fixture(scope="module")
def compared(samples):
    words = (
        samples / "earlier",
        samples / "slab.stl",
        "--thickness",
        0.5,
        "--no-morphometry",
        "--out",
        samples / "out",
    )
    return run("compare", *words), samples / "out"


def test_files_and_folders_are_compared_and_all_files_are_there(compared):
    done, folder = compared
    assert done.returncode == 0, done.stderr
    plots = ["sliced_area", "porosity", "contours", "outer_contours", "largest_area", "trabecular_area"]
    assert names(folder) == sorted([*TABLES, *REPORTS, *(f"{n}.png" for n in (*plots, "area_distribution"))])
    assert "slab.stl against cube.stl: sliced area L1" in done.stdout


def test_the_difference_of_two_boxes_is_what_the_one_has_less(compared):
    rows = list(csv.DictReader((compared[1] / "comparison_x.csv").read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 20
    assert [float(row["sliced_area_mm2 difference 2 - 1"]) for row in rows] == pytest.approx([-20] * 20)
    assert len((compared[1] / "comparison_z.csv").read_text(encoding="utf-8").splitlines()) == 1 + 16


def test_the_passport_has_the_closed_forms(compared):
    record = json.loads((compared[1] / "passport.json").read_text(encoding="utf-8"))
    (one,) = record["passports"]
    assert (one["reference"], one["sample"]) == ("cube.stl", "slab.stl")
    scores = {(s["where"], s["of"], s["symbol"]): s["value"] for s in one["scores"]}
    assert scores["x", "sliced area", "L1"] == pytest.approx(0.2)
    assert scores["z", "sliced area", "L1"] == pytest.approx(0, abs=1e-9)
    assert scores["x", "trabecular area", "KS"] == pytest.approx(1)
    assert {s["symbol"] for s in one["scores"]} <= set(record["definitions"])


def test_the_report_says_what_was_left_out(compared):
    record = json.loads((compared[1] / "report.json").read_text(encoding="utf-8"))
    assert record["names"] == ["cube.stl", "slab.stl"]
    assert any("cube.stl reaches 0 mm below and 2 mm above" in text for text in record["notes"])
    assert record["axes"]["z"]["layers"] == 16
    assert all((compared[1] / name).stat().st_size == size for name, size in record["files"].items())


def test_a_sample_against_itself_is_equal(samples, tmp_path):
    done = run("compare", samples / "earlier", samples / "earlier", *FEW, "--quiet", "--out", tmp_path / "out")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert names(tmp_path / "out") == sorted([*TABLES, *REPORTS])
    record = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    assert record["names"] == ["cube.stl (1)", "cube.stl (2)"]
    assert all(one["largest"] == 0 for axis in "xyz" for one in record["axes"][axis]["differences"])


def test_an_unsound_sample_is_named_and_exit_code_1(samples, tmp_path):
    write_box(tmp_path / "open.stl", (10, 10, 10), less=1)
    words = (samples / "earlier", tmp_path / "open.stl", "--thickness", 0.5, *FEW, "--out", tmp_path / "out")
    done = run("compare", *words)
    assert done.returncode == 1
    assert "open.stl: 3 open edges" in done.stderr
    assert names(tmp_path / "out") == sorted([*TABLES, *REPORTS])


@pytest.mark.parametrize(
    ("others", "words", "message"),
    [
        (["none.stl"], [], "none.stl could not be read: No such file"),
        (["."], [], "is no folder of an analysis: report.json"),
        (
            ["slab.stl"],
            ["--axes", "0,0.6,0.8"],
            "must have an axis in common, got cube.stl: x, y, z; slab.stl: 0,0.6,0.8",
        ),
        (["slab.stl"], ["--thickness", "0"], "thickness of a layer must be greater than 0"),
        (["slab.stl"], ["--layer", "-1"], "thickness of common layers must be > 0, got -1"),
        (["slab.stl"], ["--layer", "50"], "must share at least one layer of 50 mm"),
    ],
)
def test_wrong_input_is_exit_code_2_one_sentence_and_no_folder(samples, others, words, message, tmp_path):
    before = names(samples)
    paths = [samples / "earlier", *(samples / other for other in others)]
    done = run("compare", *paths, *words, *FEW, "--quiet", "--out", tmp_path / "out")
    assert done.returncode == 2, done.stderr
    assert re.search(message, done.stderr), done.stderr
    assert len(done.stderr.splitlines()) == 1 and done.stdout == ""
    assert names(tmp_path) == [] and names(samples) == before


def test_the_folder_of_a_sample_is_not_overwritten(samples):
    before = (samples / "earlier" / "report.json").read_bytes()
    done = run("compare", samples / "earlier", samples / "slab.stl", *FEW, "--out", samples / "earlier")
    assert done.returncode == 2
    assert "must not be that of something else" in done.stderr and "of a slice analysis" in done.stderr
    assert (samples / "earlier" / "report.json").read_bytes() == before
