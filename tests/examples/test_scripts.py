# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts in resources/examples, and the README's, run under FreeCAD and leave or say what they promise."""

import os
import re
import subprocess
from pathlib import Path

import pytest

from freecad_trabecula.core.meshes import is_closed
from freecad_trabecula.core.stl import read_stl
from freecad_trabecula.errors import DependencyError
from freecad_trabecula.shell.launch import freecad_program

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "examples"
SCRIPTS = sorted(path.name for path in FOLDER.glob("*.py"))


def run(path, out):
    """Run a script; return its exit code and what it said."""
    try:
        program = freecad_program()
    except DependencyError as error:
        pytest.skip(str(error))
    done = subprocess.run(
        [*program, str(path)],
        env=dict(os.environ, TRABECULA_OUT=str(out)),
        cwd=str(out.parent),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=300,
        check=False,
    )
    return done.returncode, done.stdout.decode("utf-8", "replace")


@pytest.fixture(scope="module")
def outputs(tmp_path_factory):
    """Folder, exit code and words of each script, each run once."""
    found = {}

    def output(name):
        if name not in found:
            folder = tmp_path_factory.mktemp(name.replace(".", "_"))
            found[name] = (folder, *run(FOLDER / name, folder))
        return found[name]

    return output


def test_there_are_examples():
    assert {"case6.py", "step_by_step.py", "by_hand.py"} <= set(SCRIPTS)


@pytest.mark.parametrize("name", SCRIPTS)
def test_an_example_ends_well_and_without_a_traceback(outputs, name):
    _, code, said = outputs(name)
    assert (code, "Traceback" in said) == (0, False), said[-3000:]


@pytest.mark.parametrize("name", SCRIPTS)
def test_the_files_that_an_example_promises_are_there_and_no_others(outputs, name):
    folder, _, _ = outputs(name)
    text = (FOLDER / name).read_text(encoding="utf-8").split('"""')[1]
    promised = re.findall(r"\b[\w-]+\.(?:stl|step|FCStd)\b", text)
    assert sorted(path.name for path in folder.iterdir()) == sorted(promised)


def test_case_6_says_147_rods_and_leaves_closed_meshes_that_add_up(outputs):
    folder, _, said = outputs("case6.py")
    assert "rods: 147" in said
    meshes = [read_stl(folder / name) for name in ("scaffold.stl", "channels.stl")]
    assert all(is_closed(mesh) for mesh in meshes)


def test_a_design_follows_its_spreadsheet(outputs):
    _, _, said = outputs("spreadsheet.py")
    rows = re.findall(r"(\d+) rods, pores up to ([\d.]+) mm, (\d+) mm3, ([\d.]+) %", said)
    assert [int(row[0]) for row in rows] == [75, 75, 48]
    # 0.4 of the step between two sites, (edge - 2 borders) / (rods across - 1)
    assert [float(row[1]) for row in rows] == pytest.approx([0.8, 1.6, 0.4 * 16 / 3], rel=5e-3)
    assert [int(row[2]) for row in rows] == [1000, 8000, 8000]
    # twice as large in every direction is as porous
    assert float(rows[0][3]) == pytest.approx(float(rows[1][3]), abs=0.02)


def test_by_hand_each_change_rebuilds_one_rod_at_most(outputs):
    _, _, said = outputs("by_hand.py")
    steps = dict(re.findall(r"([^\t\r\n]*): \d+ rods, (\d+) built again", said))
    assert {step: int(count) for step, count in steps.items() if step.startswith(("one", "a site"))} == {
        "one pore larger": 1,
        "one site moved": 1,
        "one site switched off": 0,
        "a site added on two faces": 1,
        "one move taken back": 1,
    }


def test_an_example_that_cannot_write_its_files_ends_with_1(tmp_path):
    code, said = run(FOLDER / "step_by_step.py", tmp_path / "none")
    assert code == 1
    assert "could not be written" in said


def test_the_script_in_the_readme_does_what_it_says(tmp_path):
    readme = (FOLDER.parents[1] / "README.md").read_text(encoding="utf-8")
    (script,) = re.findall(r"```python\n(.*?)```", readme, re.DOTALL)
    path = tmp_path / "readme.py"
    # as in FreeCAD's console, which the workbench is in reach of; then FreeCAD ends
    path.write_text(
        f"import sys\nsys.path.insert(0, {str(FOLDER.parents[1])!r})\n{script}\nsys.stdout.flush()\nsys.exit(0)\n",
        "utf-8",
    )
    code, said = run(path, tmp_path / "out")
    assert (code, "Traceback" in said) == (0, False), said[-3000:]
    assert "147 rods" in said
