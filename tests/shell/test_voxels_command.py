# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula voxels`` as a user runs it: real processes, files and exit codes."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import time

import numpy as np
import pytest
from shell_runs import BARE, ROOT, report_of, run

from freecad_trabecula.core.meshes import is_closed, mesh_volume
from freecad_trabecula.core.stl import read_stl, write_stl
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.core.voxels.chosen_fields import smooth_noise
from freecad_trabecula.core.voxels.table_files import read_tables

FILES = {
    *("alpha.csv", "beta.csv", "design.npy", "design.stl", "layers", "report.json", "report.md", "targets.json"),
    *("layer_counts.png", "layers.png", "tables.png", "trabeculae.png"),
}
#: A sample of smooth blobs, 18 x 16 x 14 voxels of 0.1 mm.
SAMPLE = smooth_noise((14, 16, 18), (12.0,) * 3, Stream(1, "sample")) > 0.4


def voxels(*words, timeout=300):
    return run("voxels", *words, timeout=timeout)


def margins(array):
    return [array.sum(axes).tolist() for axes in ((0, 1), (0, 2), (1, 2))]


@pytest.fixture(scope="module")
def bone(tmp_path_factory):
    path = tmp_path_factory.mktemp("bone") / "bone.stl"
    write_stl(path, block_mesh(SAMPLE, (0.1, 0.1, 0.1)))
    return path


@pytest.fixture(scope="module")
def made(bone, tmp_path_factory):
    """One design by the thesis' strategy that many tests look at."""
    folder = tmp_path_factory.mktemp("made")
    words = ("--strategy", "minimum-zeros", "--seed", 4, "--count", "--rates", 3)
    return voxels(bone, "--size", 0.1, *words, "--out", folder / "out"), folder / "out"


# ------------------------------------------------------------------------------------------------ a run that is well


def test_all_files_are_written_and_nothing_else(made):
    done, folder = made
    assert done.returncode == 0, done.stderr
    assert {path.name for path in folder.iterdir()} == FILES
    assert len(list((folder / "layers").iterdir())) == 14


def test_the_design_has_in_every_layer_what_the_targets_ask_for(made):
    design = np.load(made[1] / "design.npy")
    targets = json.loads((made[1] / "targets.json").read_text())
    assert design.dtype == bool and design.shape == (14, 16, 18)
    assert margins(design) == [targets[k] for k in "DEC"] == margins(SAMPLE)
    assert targets["voxel_mm"] == [0.1, 0.1, 0.1]
    assert targets["deltas"] == {"delta_X": 0, "delta_Y": 0, "delta_Z": 0}


def test_the_mesh_is_closed_with_the_volume_of_the_voxels(made):
    mesh = read_stl(made[1] / "design.stl")
    assert is_closed(mesh)
    assert mesh_volume(mesh) == pytest.approx(SAMPLE.sum() * 1e-3, rel=1e-5)


def test_the_report_holds_what_a_script_looks_for(made):
    report = report_of(made[1])
    assert report["exact"] is True and report["ok"] is True
    assert (report["seed"], report["voxels"]) == (4, int(SAMPLE.sum()))
    assert report["components"] >= 1 and 0 < report["largest_fraction"] <= 1 and report["seconds"] > 0
    assert set(report["trabeculae"]) == {"x", "y", "z"}
    assert set(report["versions"]) >= {"FreeCAD", "Python", "numpy"}
    assert len(report["counting"]) == 4 and report["rates"]["pairs"] == 3
    assert all((made[1] / name).stat().st_size == size for name, size in report["files"].items())
    assert "How many designs" in (made[1] / "report.md").read_text(encoding="utf-8")


def test_the_tables_are_those_of_the_design(made):
    design = np.load(made[1] / "design.npy")
    alpha, beta = read_tables(made[1])
    assert (alpha.cells == design.sum(1).T).all() and (beta.cells == design.sum(2).T).all()


def test_the_same_seed_makes_the_same_design_from_its_targets(made, tmp_path):
    words = ("--strategy", "minimum-zeros", "--seed", 4, "--plots", "none", "--images", "none", "--no-mesh")
    done = voxels(made[1] / "targets.json", *words, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert (np.load(tmp_path / "out" / "design.npy") == np.load(made[1] / "design.npy")).all()
    assert not (tmp_path / "out" / "design.stl").exists()


def test_trabecular_is_the_default_and_makes_one_part(bone, tmp_path):
    done = voxels(bone, "--size", 0.1, "--plots", "none", "--images", "none", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    report = report_of(tmp_path / "out")
    assert report["strategy"] == "trabecular" and report["exact"] is True
    assert (report["components"], report["closed_cavities"], report["edge_contacts"]) == (1, 0, 0)


def test_given_tables_are_filled_as_they_are(made, tmp_path):
    words = ("--tables", made[1], "--strategy", "sequential", "--plots", "none", "--images", "none")
    done = voxels(made[1] / "targets.json", *words, "--xlsx", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    for name in ("alpha.csv", "beta.csv"):
        assert (tmp_path / "out" / name).read_bytes() == (made[1] / name).read_bytes()
    assert (tmp_path / "out" / "tables.xlsx").exists()


def test_an_envelope_is_filled_to_its_share(tmp_path):
    z, y, x = np.ogrid[-10:11, -10:11, -10:11]
    ball = x * x + y * y + z * z <= 100
    write_stl(tmp_path / "ball.stl", block_mesh(ball, (0.1, 0.1, 0.1)))
    words = ("--size", 0.1, "--density", 0.35, "--plots", "none", "--images", "none", "--out", tmp_path / "out")
    done = voxels(tmp_path / "ball.stl", *words)
    assert done.returncode == 0, done.stderr
    design = np.load(tmp_path / "out" / "design.npy")
    assert not (design & ~ball).any() and design.sum() == round(0.35 * ball.sum())
    assert report_of(tmp_path / "out")["components"] == 1


def test_an_estimate_writes_nothing(bone, tmp_path):
    done = voxels(bone, "--size", "0.05", "--estimate")
    assert done.returncode == 0 and "36 x 32 x 28 layers, 32,256 cells: about" in done.stdout


# ------------------------------------------------------------------------------------------------------- refusals


def refused(*words, folder):
    done = voxels(*words, "--out", folder / "out")
    assert done.returncode == 2, done.stderr
    assert not (folder / "out").exists() and not any(p.name.startswith(".out") for p in folder.iterdir())
    assert "Traceback" not in done.stderr
    return done.stderr


def test_voxels_that_are_too_many_are_refused_with_an_estimate(bone, tmp_path):
    assert "GB of memory" in refused(bone, "--size", "0.0005", folder=tmp_path)


def test_targets_that_contradict_are_refused_with_their_layers(tmp_path):
    (tmp_path / "t.csv").write_text("axis,layer,voxels\nx,0,4\nx,1,0\ny,0,2\ny,1,2\nz,0,4\nz,1,0\n")
    text = refused(tmp_path / "t.csv", "--strategy", "sequential", folder=tmp_path)
    assert "layer 0 along X ask for 4 voxels together" in text


def test_caps_too_low_and_a_damaged_file_are_refused(bone, tmp_path):
    assert "must be at least" in refused(bone, "--strategy", "sequential", "--cap-alpha", 1, folder=tmp_path)
    (tmp_path / "bad.stl").write_bytes(b"solid nothing")
    assert "bad.stl" in refused(tmp_path / "bad.stl", folder=tmp_path)


def test_a_run_that_is_stopped_leaves_nothing(bone, tmp_path):
    words = [*BARE, "voxels", str(bone), "--size", "0.01", "--out", str(tmp_path / "out")]
    with subprocess.Popen(words, cwd=str(ROOT), stderr=subprocess.PIPE, text=True) as process:
        for line in process.stderr:
            if "%" in line:
                break
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.stderr.read()
        assert process.wait(60) == 130
    assert os.listdir(tmp_path) == []


def test_the_folder_of_something_else_is_refused_and_left_as_it_was(bone, tmp_path):
    (tmp_path / "report.json").write_text('{"kind": "slice analysis"}')
    done = voxels(bone, "--size", 0.1, "--strategy", "minimum-zeros", "--out", tmp_path)
    assert done.returncode == 2
    assert "must not be that of something else" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["report.json"]
