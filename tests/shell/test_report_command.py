# SPDX-License-Identifier: LGPL-2.1-or-later
"""``report`` on the command line: folders in, one page out; wrong input refused in one sentence."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from freecad_trabecula.shell import report
from freecad_trabecula.shell.arguments import read_arguments

ROOT = Path(__file__).resolve().parents[2]


def refusal(capsys, *words):
    with pytest.raises(SystemExit) as stop:
        read_arguments(["report", *words])
    assert stop.value.code == 2
    return capsys.readouterr().err


def test_folders_and_page_are_needed_and_the_page_ends_in_html(capsys):
    assert "FOLDER" in refusal(capsys, "--out", "a.html")
    assert "--out" in refusal(capsys, "folder")
    assert "must name a file that ends in .html, got " in refusal(capsys, "folder", "--out", "a.pdf")


def test_names_of_folders_become_absolute():
    command, options = read_arguments(["report", "a", "b", "--out", "c.html"])
    assert command.module == "freecad_trabecula.shell.report"
    assert options["folders"] == [str(Path.cwd() / "a"), str(Path.cwd() / "b")]


def test_a_folder_without_results_is_wrong_input_and_nothing_is_written(tmp_path):
    words = ["report", str(tmp_path), "--out", str(tmp_path / "report.html")]
    done = subprocess.run([sys.executable, "-m", "freecad_trabecula", *words], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 2
    assert "must hold the report.json" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_the_page_of_a_comparison_is_written_and_its_size_said(tmp_path):
    record = {"kind": "slice comparison", "names": ["a", "b"], "notes": [], "table": {"head": ["", "X a"], "rows": []},
              "axes": {}, "passports": [], "files": {}, "versions": {}, "alignment": "start"}  # fmt: skip
    (tmp_path / "report.json").write_text(json.dumps(record))
    said = []
    options = {"folders": [str(tmp_path)], "out": str(tmp_path / "page.html"), "title": "", "quiet": False}
    assert report.run(options, lambda kind, **more: said.append((kind, more))) == 0
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert "<title>Report of a, b</title>" in page
    assert said[-1][0] == "text" and "1 parts" in said[-1][1]["text"]
