# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula design`` as a user runs it: real processes, real FreeCAD, files and exit codes."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from shell_runs import BARE, ROOT, check_a_full_disk, names, report_of, run

from freecad_trabecula.core import mesh_formats, meshes, stl
from freecad_trabecula.core.job import job_from_json, job_to_json, set_values
from freecad_trabecula.core.presets import preset

#: Few rods: 3 x 3 x 3 in a small cube.
SMALL = ["--preset", "case6", *(w for k in "xyz" for w in ("--set", f"prism.n_{k}=3")), "--set", "name=small"]
FILES = ["channels.stl", "design.FCStd", "network.step", "report.json", "report.md", "scaffold.stl"]
#: Long enough to be stopped in the midst.
LONG = ["--preset", "case6", *(w for k in "xyz" for w in ("--set", f"prism.n_{k}=9"))]


def design(*words, **more):
    return run("design", *words, **more)


def figures(report):
    """What must be the same for the same seed: all but times, the files' sizes and the job's name."""
    return {k: v for k, v in report.items() if "seconds" not in k and k not in ("files", "name", "job")}


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    """One design that many tests look at."""
    folder = tmp_path_factory.mktemp("small")
    done = design(*SMALL, "--seed", 5, "--out", folder / "out")
    return done, folder / "out"


# ------------------------------------------------------------------------------------------------ a run that is well


def test_a_python_without_numpy_designs():
    probe = subprocess.run([*BARE[:2], "-c", "import numpy"], capture_output=True, check=False)
    assert probe.returncode != 0  # else the other tests prove nothing


def test_all_files_are_written_and_nothing_else(small):
    done, folder = small
    assert done.returncode == 0, done.stderr
    assert names(folder) == FILES
    assert names(folder.parent) == ["out"]


def test_the_report_holds_what_a_script_looks_for(small):
    report = report_of(small[1])
    assert report["rods"] == 27
    assert report["seed"] == 5
    assert report["watertight"] is True and report["ok"] is True
    volume = report["volume_mm3"]
    assert volume["envelope"] == pytest.approx(1000, rel=1e-9)
    assert volume["scaffold"] + volume["channels"] + volume["loose"] == pytest.approx(1000, rel=1e-6)
    assert report["porosity"] == pytest.approx(1 - volume["scaffold"] / 1000, rel=1e-9)
    assert 0.03 < report["porosity"] < 0.15  # 27 rods of 1.46 x 0.28 mm2 x 10 mm less their crossings: 0.11
    assert report["manual_seconds"] == 27 * 75
    assert set(report["versions"]) >= {"FreeCAD", "Python", "numpy"}
    assert [row["rods"] for row in report["couplings"]] == [9, 9, 9]
    assert report["seconds"] > 0


def test_the_stl_files_hold_the_volumes_of_the_report(small):
    volume = report_of(small[1])["volume_mm3"]
    for name in ("scaffold", "channels"):
        mesh = stl.read_stl(small[1] / f"{name}.stl")
        assert meshes.is_closed(mesh)
        assert meshes.mesh_volume(mesh) == pytest.approx(volume[name], abs=1e-3)


def test_the_sizes_of_the_report_are_those_of_the_files(small):
    sizes = report_of(small[1])["files"]
    assert set(sizes) == set(FILES) - {"report.json", "report.md"}
    assert all((small[1] / name).stat().st_size == size for name, size in sizes.items())


def test_the_step_file_holds_a_solid_for_each_rod(small):
    text = (small[1] / "network.step").read_text(encoding="latin-1")
    assert text.rstrip().endswith("END-ISO-10303-21;")
    assert len(re.findall(r"= MANIFOLD_SOLID_BREP\(", text)) == 27


def test_the_page_for_readers_tells_the_same(small):
    text = (small[1] / "report.md").read_text(encoding="utf-8")
    assert "All checks held." in text
    assert f"| {report_of(small[1])['porosity_percent']:.2f} |" in text
    assert "| Face1 | Face2 | 9 | 9 | 9 | 0 | 0 |" in text


def test_progress_goes_to_standard_error_and_the_summary_to_standard_output(small):
    done = small[0]
    percents = [int(p) for p in re.findall(r"^ *(\d+) %", done.stderr, re.MULTILINE)]
    assert percents == sorted(percents) and len(percents) > 5
    assert "27 rods, porosity" in done.stdout
    assert "%  " not in done.stdout and "FreeCAD" not in done.stdout
    assert done.stdout.count("\n") < 12


def test_the_same_seed_gives_the_same_figures_and_meshes(small, tmp_path):
    done = design(*SMALL, "--seed", 5, "--out", tmp_path / "again", "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert figures(report_of(tmp_path / "again")) == figures(report_of(small[1]))
    for name in ("scaffold.stl", "channels.stl"):
        assert (tmp_path / "again" / name).read_bytes() == (small[1] / name).read_bytes()


def test_a_saved_job_gives_the_same_design(small, tmp_path):
    job = tmp_path / "job.json"
    assert design(*SMALL, "--seed", 5, "--save-job", job).returncode == 0
    assert names(tmp_path) == ["job.json"]
    assert job_from_json(job.read_text(encoding="utf-8")).seed == 5
    assert design("--job", job, "--out", tmp_path / "out").returncode == 0
    assert figures(report_of(tmp_path / "out")) == figures(report_of(small[1]))


def test_any_python_from_38_on_will_do(tmp_path):
    others = [Path(p) for p in (Path.home() / ".pyenv" / "versions").glob("3.[89].*/bin/python3")]
    if not others:
        pytest.skip("no Python 3.8 or 3.9 on this machine")
    for number, python in enumerate(others):
        done = design(*SMALL, "--out", tmp_path / str(number), python=[str(python), "-m", "freecad_trabecula"])
        assert done.returncode == 0, (python, done.stderr)


def test_further_formats_hold_the_same_bodies(tmp_path):
    done = design(*SMALL, "--out", tmp_path, *(w for kind in ("ply", "obj", "3mf", "brep") for w in ("--also", kind)))
    assert done.returncode == 0, done.stderr
    more = [f"{name}.{kind}" for name in ("scaffold", "channels") for kind in ("ply", "obj", "3mf")]
    assert names(tmp_path) == sorted([*FILES, *more, "network.brep"])
    found = mesh_formats.mesh_from_ply((tmp_path / "scaffold.ply").read_bytes())
    assert meshes.mesh_volume(found) == pytest.approx(report_of(tmp_path)["volume_mm3"]["scaffold"], rel=1e-12)


def test_the_list_of_presets_is_printed():
    done = design("--preset", "list")
    assert done.returncode == 0
    assert [line.split()[0] for line in done.stdout.splitlines()][:6] == [f"case{k}" for k in range(1, 7)]


# ------------------------------------------------------------------------------------------------ an envelope's file


def cube(path, size):
    corners = np.array([[x, y, z] for x in (0, size) for y in (0, size) for z in (0, size)], float)
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))]
    stl.write_stl(path, meshes.Mesh(corners, np.array(triangles)))


def test_an_envelope_gets_its_opposite_faces_coupled(tmp_path):
    cube(tmp_path / "cube.stl", 8.0)
    done = design("--envelope", tmp_path / "cube.stl", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    report = report_of(tmp_path / "out")
    assert len(report["couplings"]) == 3
    assert report["volume_mm3"]["envelope"] == pytest.approx(512, rel=1e-6)
    assert report["name"] == "cube"


def test_the_faces_to_be_coupled_can_be_named(tmp_path):
    cube(tmp_path / "cube.stl", 8.0)
    words = ("--couple", "Face5:Face6", "--set", "faces.0.c_u=2", "--set", "faces.1.c_u=2")
    done = design("--envelope", tmp_path / "cube.stl", *words, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert [(row["first"], row["second"]) for row in report_of(tmp_path / "out")["couplings"]] == [("Face5", "Face6")]


def test_a_job_finds_its_envelope_beside_it(tmp_path):
    cube(tmp_path / "cube.stl", 8.0)
    job = {
        "envelope": "cube.stl",
        "faces": [{"face": "Face5", "name": "A"}, {"face": "Face6", "name": "B"}],
        "couplings": [{"first": "A", "second": "B"}],
    }
    (tmp_path / "job.json").write_text(json.dumps(job))
    done = design("--job", tmp_path / "job.json", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert report_of(tmp_path / "out")["faces"][0]["label"] == "A"


# ------------------------------------------------------------------------------------------------------ wrong input

CASE6 = job_to_json(preset("case6"))


def job_text(*settings):
    return job_to_json(set_values(preset("case6"), list(settings)))


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--preset", "case7"], "a preset must be one of case1, case2, .* got 'case7'"),
        (["--preset", "case6", "--set", "pores.sise.low=1"], "known here are layout, size"),
        (["--preset", "case6", "--set", "pores.size.low=0.9"], "low <= high, got 0.9 and 0.8"),
        (["--preset", "case6", "--seed", "-1"], "the seed must lie in 0"),
        (["--preset", "case6", "--set", "prism.n_x=1"], "sites along X must be at least 2"),
        (["--preset", "case6", *(w for k in "xyz" for w in ("--set", f"prism.n_{k}=40000"))], "hours and .* GB, got"),
        (["--job", "missing.json"], "the job file .*missing.json cannot be read: No such file"),
        (["--envelope", "missing.step"], "must be readable, got .*missing.step"),
    ],
)
def test_wrong_input_is_exit_code_2_one_sentence_and_no_folder(words, message, tmp_path):
    done = design(*words, "--out", tmp_path / "out")
    assert done.returncode == 2, done.stderr
    assert re.search(message, done.stderr), done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert done.stdout == ""
    assert names(tmp_path) == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "must be JSON"),
        (CASE6.replace('"seed": 1', '"seed": NaN'), "finite, got NaN"),
        (CASE6.replace('"seed": 1', '"seed": "1"'), "job.seed must be a whole number, got '1'"),
        (CASE6.replace('"seed"', '"sead"'), "has no key 'sead'"),
        ("\udcff", "UTF-8"),
    ],
)
def test_a_wrong_job_file_is_named_with_what_is_wrong(text, message, tmp_path):
    path = tmp_path / "job.json"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    done = design("--job", path, "--out", tmp_path / "out")
    assert done.returncode == 2
    assert "job.json" in done.stderr and re.search(message, done.stderr), done.stderr
    assert names(tmp_path) == ["job.json"]


def test_an_open_mesh_is_no_envelope(tmp_path):
    cube(tmp_path / "cube.stl", 8.0)
    closed = stl.read_stl(tmp_path / "cube.stl")
    stl.write_stl(tmp_path / "open.stl", meshes.Mesh(closed.vertices, closed.triangles[1:]))
    done = design("--envelope", tmp_path / "open.stl", "--out", tmp_path / "out")
    assert done.returncode == 2, done.stderr
    assert "closed" in done.stderr
    assert names(tmp_path) == ["cube.stl", "open.stl"]


def test_without_freecad_the_exit_code_is_2(tmp_path):
    done = design(*SMALL, "--out", tmp_path / "out", PATH=str(tmp_path), FREECADCMD="")
    assert done.returncode == 2
    assert "FreeCAD is needed" in done.stderr and len(done.stderr.splitlines()) == 1
    done = design(*SMALL, "--out", tmp_path / "out", FREECADCMD=str(tmp_path / "none"))
    assert done.returncode == 2
    assert "FREECADCMD must name a program" in done.stderr


def test_a_file_in_the_place_of_the_folder_is_wrong_input(tmp_path):
    (tmp_path / "file").write_text("mine")
    done = design(*SMALL, "--out", tmp_path / "file")
    assert done.returncode == 2
    assert "cannot be written" in done.stderr
    assert (tmp_path / "file").read_text() == "mine"


# ------------------------------------------------------------------------------------------ runs that do not get there


def started(folder, *words):
    """A run that has begun to compute."""
    command = [*BARE, "design", *LONG, *words, "--out", str(folder)]
    process = subprocess.Popen(command, cwd=str(ROOT), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    said = []
    for line in process.stderr:
        said.append(line)
        if re.match(r" 1\d %", line):
            return process
    process.communicate()
    raise AssertionError("it ended before it could be stopped:\n" + "".join(said))


def wait_until(condition, seconds=30.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.1)
    return condition()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_stopped_run_leaves_the_folder_as_it_was(number, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    (out / "scaffold.stl").write_text("the old one")
    process = started(out)
    assert names(out) == ["scaffold.stl"]
    start = time.monotonic()
    process.send_signal(number)
    _, said = process.communicate(timeout=20)
    assert time.monotonic() - start < 8
    assert process.returncode == 130
    assert "stopped; nothing was written" in said
    assert (out / "scaffold.stl").read_text() == "the old one"
    assert names(tmp_path) == ["out"] and names(out) == ["scaffold.stl"]


def test_a_killed_run_leaves_nothing_half_written(tmp_path):
    process = started(tmp_path / "out")
    process.kill()
    process.communicate()
    assert not (tmp_path / "out").exists()
    # its FreeCAD notices that nobody listens, and tidies up
    assert wait_until(lambda: names(tmp_path) == [])
    assert design(*SMALL, "--out", tmp_path / "out").returncode == 0
    assert names(tmp_path) == ["out"]


def test_a_full_disk_is_exit_code_1_and_nothing_is_written(tmp_path):
    check_a_full_disk("design", *SMALL, "--out", tmp_path / "out")
    assert names(tmp_path) == []


def test_files_of_an_earlier_run_are_replaced_or_pointed_out(tmp_path):
    for name in ("scaffold.stl", "scaffold.step", "mine.txt"):
        (tmp_path / name).write_text("old")
    done = design(*SMALL, "--out", tmp_path)
    assert done.returncode == 0
    assert "warning: scaffold.step in" in done.stderr and "belong to an earlier run" in done.stderr
    assert (tmp_path / "scaffold.stl").stat().st_size > 1000
    assert (tmp_path / "mine.txt").read_text() == "old"


def test_the_report_of_an_analysis_is_not_overwritten(tmp_path):
    (tmp_path / "report.json").write_text('{"kind": "slice analysis"}')
    done = design(*SMALL, "--out", tmp_path)
    assert done.returncode == 2 and "holds the report.json of a slice analysis" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["report.json"]
