# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula analyse`` as a user runs it: real processes, real FreeCAD, files and exit codes."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import struct
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from shell_runs import BARE, ROOT, check_a_full_disk, names, report_of, run

from freecad_trabecula.core import mesh_formats, meshes, stl
from freecad_trabecula.core.analysis.ssl import read_ssl

DATA = Path(os.environ.get("TRABECULA_DATA") or ROOT.parent / "shared" / "data")
FEW = ["--no-morphometry", "--plots", "none"]
TABLES = [f"{kind}_{axis}.csv" for kind in ("contours", "profile") for axis in "xyz"]
REPORTS = ["report.json", "report.md"]
SQUARES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
SSL = "Slice V0\nFILE(a)\nUNITS(MM)\nSLICES()\nZ 0.5 1\n0 0\n5 0\n5 5\n0 5\nC\nZ 1.5 1\n0 0\n4 0\n4 4\n0 4\nC\nEND\n"


def analyse(*words, **more):
    return run("analyse", *words, **more)


def rows_of(path):
    return list(csv.DictReader(path.read_text(encoding="utf-8").splitlines()))


def box(low, high):
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    triangles = np.array([t for a, b, c, d in SQUARES for t in ((a, b, c), (a, c, d))])
    return meshes.Mesh(np.array(low) + corners * (np.array(high) - np.array(low)), triangles)


def cavity():
    """A cube of 10 mm with a closed cavity of 6 mm: 784 mm³, slices of 100 and 64 mm²."""
    outer, inner = box((0, 0, 0), (10, 10, 10)), box((2, 2, 2), (8, 8, 8))
    return meshes.Mesh(
        np.concatenate([outer.vertices, inner.vertices]),
        np.concatenate([outer.triangles, inner.triangles[:, ::-1] + len(outer.vertices)]),
    )


def binary_stl(triangles, header=b"a file", count=None):
    """A binary STL of corners (T, 3, 3), as they are."""
    data = header.ljust(80) + struct.pack("<I", len(triangles) if count is None else count)
    for corners in np.asarray(triangles, "<f4"):
        data += bytes(12) + corners.tobytes() + bytes(2)
    return data


def corners_of(mesh):
    return mesh.vertices[mesh.triangles]


@pytest.fixture(scope="module")
def cube(tmp_path_factory):
    """One analysis that many tests look at: everything is written."""
    folder = tmp_path_factory.mktemp("cube")
    stl.write_stl(folder / "cavity.stl", cavity())
    words = ("--thickness", 0.5, "--no-morphometry", "--ssl", "--cli", "--svg", "--xlsx")
    return analyse(folder / "cavity.stl", *words, "--out", folder / "out"), folder / "out"


# ------------------------------------------------------------------------------------------------ a run that is well


def test_a_sound_body_is_exit_code_0_and_all_files_are_there(cube):
    done, folder = cube
    assert done.returncode == 0, done.stderr
    layers = [f"slices_{axis}.{kind}" for kind in ("cli", "ssl", "svg") for axis in "xyz"]
    plots = ["sliced_area.png", "porosity.png", "number_of_trabeculae.png"]
    plots += [f"trabecular_area_{axis}.png" for axis in "xyz"]
    assert names(folder) == sorted([*TABLES, *REPORTS, *layers, *plots, "slices.xlsx"])
    assert names(folder.parent) == ["cavity.stl", "out"]


def test_the_profiles_are_those_of_the_cube(cube):
    for axis in "xyz":
        rows = rows_of(cube[1] / f"profile_{axis}.csv")
        assert list(rows[0]) == ["layer", "coordinate_mm", "sliced_area_mm2", "contours", "outer_contours", "porosity"]
        assert [float(row["coordinate_mm"]) for row in rows] == pytest.approx([0.25 + 0.5 * k for k in range(20)])
        for row in rows:
            inside = 2 < float(row["coordinate_mm"]) < 8
            assert float(row["sliced_area_mm2"]) == pytest.approx(64 if inside else 100)
            assert (row["contours"], row["outer_contours"]) == (("2", "1") if inside else ("1", "1"))
            assert float(row["porosity"]) == pytest.approx(0.36 if inside else 0, abs=1e-9)
        assert len(rows_of(cube[1] / f"contours_{axis}.csv")) == 32


def test_the_report_holds_figures_checks_and_versions(cube):
    report = report_of(cube[1])
    assert report["ok"] is True and report["watertight"] is True and report["fill_rule"] == "winding"
    assert report["mesh"]["volume"] == pytest.approx(784)
    assert [round(check["value"], 6) for check in report["checks"][:3]] == [784, 784, 784]
    assert report["parameters"]["thickness"] == 0.5 and report["parameters"]["at"] == "middle"
    assert set(report["versions"]) >= {"FreeCAD", "Python", "numpy"}
    assert all((cube[1] / name).stat().st_size == size for name, size in report["files"].items())
    assert set(report["files"]) == set(names(cube[1])) - set(REPORTS)


def test_the_page_and_the_summary_tell_the_same(cube):
    done, folder = cube
    assert "All checks held." in (folder / "report.md").read_text(encoding="utf-8")
    assert "x: 20 slices, sliced area 64 to 100 mm2, porosity 0 to 36 %" in done.stdout
    assert "all 4 checks held" in done.stdout and done.stdout.count("\n") < 12


def test_progress_rises_and_goes_to_standard_error(cube):
    percents = [int(p) for p in re.findall(r"^ *(\d+) %", cube[0].stderr, re.MULTILINE)]
    assert percents == sorted(percents) and len(percents) > 5


def test_layers_that_were_written_can_be_analysed(cube, tmp_path):
    done = analyse(cube[1] / "slices_y.ssl", "--axes", "y", *FEW, "--quiet", "--out", tmp_path / "out")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert names(tmp_path / "out") == ["contours_y.csv", "profile_y.csv", *REPORTS]
    first, second = (rows_of(folder / "profile_y.csv") for folder in (cube[1], tmp_path / "out"))
    for one, two in zip(first, second):
        assert float(one["sliced_area_mm2"]) == pytest.approx(float(two["sliced_area_mm2"]), rel=1e-6)
        assert one["contours"] == two["contours"]


def test_the_same_body_gives_the_same_tables(cube, tmp_path):
    stl.write_stl(tmp_path / "cavity.stl", cavity())
    done = analyse(tmp_path / "cavity.stl", "--thickness", 0.5, *FEW, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    for name in TABLES:
        assert (tmp_path / "out" / name).read_bytes() == (cube[1] / name).read_bytes()


@pytest.mark.parametrize("suffix", ["obj", "ply", "3mf"])
def test_other_meshes_give_the_same_profile(suffix, tmp_path):
    write = {"obj": mesh_formats.write_obj, "ply": mesh_formats.write_ply, "3mf": mesh_formats.write_3mf}[suffix]
    write(tmp_path / f"a.{suffix}", cavity())
    done = analyse(tmp_path / f"a.{suffix}", "--thickness", 1, "--axes", "z", *FEW, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    areas = [float(row["sliced_area_mm2"]) for row in rows_of(tmp_path / "out" / "profile_z.csv")]
    assert areas == pytest.approx([100, 100, 64, 64, 64, 64, 64, 64, 100, 100])


def test_a_solid_is_sliced_through_its_mesh(tmp_path):
    step = ROOT / "resources" / "examples"
    files = sorted(step.glob("*.step"))
    if not files:
        pytest.skip("no STEP file among the examples")
    done = analyse(files[0], "--thickness", 2, *FEW, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert "the solid was sliced through" in done.stdout


def test_flags_reach_the_parameters(tmp_path):
    stl.write_stl(tmp_path / "a.stl", cavity())
    words = ["--thickness", 0.25, "--axes", "zx", "--at", "bottom", "--range=1:9", "--gap", 0.02, "--iterations", 3]
    words += ["--filter-open", 0.1, "--filter-closed", 0.2, "--smoothing", "normal", "--rod-ratio", 0.5]
    done = analyse(tmp_path / "a.stl", *words, *FEW, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    chosen = report_of(tmp_path / "out")["parameters"]
    assert chosen["axes"] == ["z", "x"] and chosen["at"] == "bottom" and (chosen["low"], chosen["high"]) == (1, 9)
    assert (chosen["gap"], chosen["iterations"], chosen["smoothing"], chosen["rod_ratio"]) == (0.02, 3, "normal", 0.5)
    assert (chosen["filter_open"], chosen["filter_closed"]) == (0.1, 0.2)
    rows = rows_of(tmp_path / "out" / "profile_z.csv")
    assert float(rows[0]["coordinate_mm"]) == 1 and len(rows) == 32


def test_planes_at_heights_and_along_a_direction(tmp_path):
    stl.write_stl(tmp_path / "a.stl", cavity())
    words = ("--axes", "0,0.6,0.8", "--axes", "y", "--heights", "1,5,9")
    done = analyse(tmp_path / "a.stl", *words, *FEW, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert [float(row["sliced_area_mm2"]) for row in rows_of(tmp_path / "out" / "profile_y.csv")] == [100, 64, 100]
    assert len(rows_of(tmp_path / "out" / "profile_0,0.6,0.8.csv")) == 3


def test_morphometry_is_in_the_report_unless_it_is_left_out(tmp_path):
    mesh = box((0, 0, 0), (1, 1, 8))  # few voxels: 25 x 25 x 200
    stl.write_stl(tmp_path / "a.stl", mesh)
    done = analyse(tmp_path / "a.stl", "--thickness", 1, "--plots", "none", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    measures = {one["symbol"]: one["value"] for one in report_of(tmp_path / "out")["morphometry"]["measures"]}
    assert {f"branches_{axis}.csv" for axis in "xyz"} < set(names(tmp_path / "out"))
    assert report_of(tmp_path / "out")["interconnectivity"]["z"]["branches"] == 1
    assert measures["BV/TV"] == pytest.approx(1, rel=1e-6) and measures["BV"] == pytest.approx(8, rel=1e-6)


def test_plots_in_another_format(tmp_path):
    stl.write_stl(tmp_path / "a.stl", cavity())
    done = analyse(tmp_path / "a.stl", "--thickness", 1, "--axes", "x", "--no-morphometry", "--plots", "svg", "--out",
                   tmp_path / "out")  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert sorted(n for n in names(tmp_path / "out") if n.endswith(".svg")) == [
        *("number_of_trabeculae.svg", "porosity.svg", "sliced_area.svg", "trabecular_area_x.svg"),
    ]


def test_any_python_from_38_on_will_do(tmp_path):
    others = [Path(p) for p in (Path.home() / ".pyenv" / "versions").glob("3.[89].*/bin/python3")]
    if not others:
        pytest.skip("no Python 3.8 or 3.9 on this machine")
    stl.write_stl(tmp_path / "a.stl", cavity())
    for number, python in enumerate(others):
        command = [str(python), "-m", "freecad_trabecula"]
        done = analyse(tmp_path / "a.stl", *FEW, "--out", tmp_path / str(number), python=command)
        assert done.returncode == 0, (python, done.stderr)


@pytest.mark.skipif(not (DATA / "trab_ior_10mm_13MB.stl").is_file(), reason=f"no bone of 13 MB in {DATA}")
def test_real_bone_is_analysed_and_its_crossing_facets_are_said(tmp_path):
    done = analyse(DATA / "trab_ior_10mm_13MB.stl", "--thickness", 0.1, *FEW, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    reference = json.loads((DATA / "properties.json").read_text())
    text = json.dumps(reference)
    assert "trab_ior_10mm_13MB" in text
    report = report_of(tmp_path / "out")
    assert report["mesh"]["volume"] == pytest.approx(193.3, abs=0.1)
    assert "225 facets through others" in done.stdout
    for axis in "xyz":
        assert report["axes"][axis]["summary"]["mean_bone_fraction"] == pytest.approx(0.19, abs=0.002)


@pytest.mark.skipif(not (DATA / "trab_ior_1p17mm_tiny.stl").is_file(), reason=f"no bone of 0.6 MB in {DATA}")
def test_heavy_work_is_said_beforehand_and_of_little_work_nothing(tmp_path, cube):
    many = ("--thickness", 0.0004, "--ssl", *FEW, "--out", tmp_path / "out")  # 8,775 planes
    done = analyse(DATA / "trab_ior_1p17mm_tiny.stl", *many)
    assert done.returncode == 0, done.stderr
    said = re.match(r"trab_ior_1p17mm_tiny.stl: about \d+ s, [\d.]+ MB of memory, ([\d.]+) MB of files\n", done.stdout)
    size = sum(path.stat().st_size for path in (tmp_path / "out").iterdir())
    assert float(said.group(1)) == pytest.approx(size / 1e6, rel=0.15)
    assert "of memory" not in cube[0].stdout


@pytest.mark.skipif(not (DATA / "slice_reference.json").is_file(), reason=f"no slice_reference.json in {DATA}")
@pytest.mark.parametrize("axis", ["x", "y", "z"])
@pytest.mark.parametrize("name", ["trab_ior_1p17mm_tiny", "shrew_cube_10mm"])
def test_tables_and_layers_hold_the_areas_that_another_program_found(name, axis, tmp_path):
    known = json.loads((DATA / "slice_reference.json").read_text())[name]["axes"][axis]
    heights = ",".join(map(repr, known["plane"]))
    words = ("--axes", axis, f"--heights={heights}", "--ssl", "--thickness", 0.1, *FEW, "--out", tmp_path / "out")
    done = analyse(DATA / f"{name}.stl", *words)
    assert done.returncode == 0, done.stderr
    rows = rows_of(tmp_path / "out" / f"profile_{axis}.csv")
    assert [float(row["sliced_area_mm2"]) for row in rows] == pytest.approx(known["area_mm2"], rel=1e-12)
    assert [int(row["outer_contours"]) for row in rows] == known["outer_contours"]
    holes = [int(row["contours"]) - int(row["outer_contours"]) for row in rows]
    assert holes == known["holes"]
    layers = read_ssl(tmp_path / "out" / f"slices_{axis}.ssl", axis).contours
    assert layers.closed.all()
    x, y = layers.points.T
    after = np.arange(1, len(x) + 1)
    after[layers.starts[1:] - 1] = layers.starts[:-1]
    areas = np.bincount(np.repeat(layers.plane, np.diff(layers.starts)), (x * y[after] - x[after] * y) / 2)
    assert areas == pytest.approx(known["area_mm2"], rel=2e-6)  # six decimals


# --------------------------------------------------------------------------------- meshes that cannot be trusted: 1


def marked(path, *words):
    """Run, and return the report of a body whose numbers are written but marked."""
    done = analyse(path, *(words or ("--thickness", 1)), *FEW, "--out", path.parent / "out")
    assert done.returncode == 1, done.stderr
    assert "Traceback" not in done.stderr
    report = report_of(path.parent / "out")
    assert report["ok"] is False
    assert names(path.parent / "out") == sorted([*TABLES, *REPORTS])
    return done, report


def test_an_open_mesh_is_written_marked_and_exit_code_1(tmp_path):
    (tmp_path / "a.stl").write_bytes(binary_stl(corners_of(cavity())[1:]))
    done, report = marked(tmp_path / "a.stl")
    assert "not watertight" in done.stderr and "FAULT" in done.stdout
    assert any("spoilt" in text for text in report["faults"])
    assert any(report["axes"][axis]["spoilt_layers"] for axis in "xyz")


def test_one_facet_is_an_open_mesh(tmp_path):
    (tmp_path / "a.stl").write_bytes(binary_stl([[[0, 0, 0], [10, 0, 1], [0, 10, 2]]]))
    _, report = marked(tmp_path / "a.stl")
    assert report["mesh"]["triangles"] == 1 and report["watertight"] is False


def test_a_mesh_inside_out_is_marked(tmp_path):
    (tmp_path / "a.stl").write_bytes(binary_stl(corners_of(box((0, 0, 0), (5, 5, 5)))[:, ::-1]))
    assert any("inside out" in text for text in marked(tmp_path / "a.stl")[1]["faults"])


def test_facets_that_are_there_twice_are_marked(tmp_path):
    (tmp_path / "a.stl").write_bytes(binary_stl(np.concatenate([corners_of(box((0, 0, 0), (5, 5, 5)))] * 2)))
    assert any("there twice" in text for text in marked(tmp_path / "a.stl")[1]["faults"])


def test_open_polylines_of_an_ssl_are_marked(tmp_path):
    (tmp_path / "a.ssl").write_text(SSL.replace("0 4\nC", "0 4\nO"))
    done = analyse(tmp_path / "a.ssl", *FEW, "--out", tmp_path / "out")
    assert done.returncode == 1
    assert "along z 1 of 2 slices are spoilt: layers 1" in done.stderr


# ---------------------------------------------------------------------------- odd meshes that are measured all the same


def measured_areas(path, *words, axis="z"):
    done = analyse(path, *words, *FEW, "--out", path.parent / "out")
    assert done.returncode == 0, done.stderr
    return [float(row["sliced_area_mm2"]) for row in rows_of(path.parent / "out" / f"profile_{axis}.csv")]


def test_a_binary_file_whose_header_says_solid_is_read(tmp_path):
    (tmp_path / "a.stl").write_bytes(binary_stl(corners_of(box((0, 0, 0), (5, 5, 5))), b"solid part"))
    assert measured_areas(tmp_path / "a.stl", "--thickness", 1) == pytest.approx([25] * 5)


def test_facets_without_area_spoil_nothing_and_are_said(tmp_path):
    # a cube whose top has an edge split at a corner of its neighbour's: a facet of no area closes the gap
    cube_corners = corners_of(box((0, 0, 0), (4, 4, 4)))
    needle = [[0, 0, 4], [0, 0, 4], [4, 0, 4]]
    (tmp_path / "a.stl").write_bytes(binary_stl(np.concatenate([cube_corners, [needle]])))
    done = analyse(tmp_path / "a.stl", "--thickness", 1, *FEW, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert "1 facet without area" in done.stdout


def test_a_mesh_thinner_than_a_layer_is_cut_once(tmp_path):
    (tmp_path / "a.stl").write_bytes(binary_stl(corners_of(box((0, 0, 0), (5, 5, 0.01)))))
    assert measured_areas(tmp_path / "a.stl", "--thickness", 1) == pytest.approx([25])


def test_layers_in_inches_and_in_the_wrong_order_are_read(tmp_path):
    first, second = SSL.index("Z 0.5"), SSL.index("Z 1.5")
    turned = SSL[:first] + SSL[second : SSL.index("END")] + SSL[first:second] + "END\n"
    (tmp_path / "a.ssl").write_text(turned.replace("MM", "INCH"))
    assert measured_areas(tmp_path / "a.ssl") == pytest.approx([25 * 25.4**2, 16 * 25.4**2])
    assert any("sorted" in text for text in report_of(tmp_path / "out")["notes"])


# ------------------------------------------------------------------------------------------------------ wrong input: 2

CUBE = binary_stl(corners_of(box((0, 0, 0), (5, 5, 5))))
HUGE = np.array([[[0, 0, 0], [1e30, 0, 0], [0, 1, 0]]])


@pytest.mark.parametrize(
    ("name", "data", "words", "message"),
    [
        ("a.stl", None, [], "a.stl could not be read: No such file"),
        ("a.stl", b"", [], "at least 84 bytes, got 0"),
        ("a.stl", CUBE[:-20], [], "its header says 12 triangles"),
        ("a.stl", binary_stl(corners_of(box((0, 0, 0), (5, 5, 5))), count=11), [], "its header says 11 triangles"),
        ("a.stl", b"solid a\nfacet\n", [], "must end with 'endsolid'"),
        ("a.stl", binary_stl(np.full((1, 3, 3), np.nan)), [], "co-ordinates must be finite"),
        ("a.stl", binary_stl(np.full((1, 3, 3), np.inf)), [], "co-ordinates must be finite"),
        ("a.stl", binary_stl(HUGE), ["--unit", "mm"], "at most 1e\\+06 mm"),
        ("a.xyz", b"1 2 3", [], r"ends in \.stl, .*\.step, .*\.ssl, got '\.xyz'"),
        ("a.step", b"no step", [], "cannot be sliced"),
        ("a.step", None, [], "could not be read: there is no such file"),
        ("a.stl", CUBE, ["--thickness", "0"], "thickness of a layer must be greater than 0, got 0 mm"),
        ("a.stl", CUBE, ["--thickness", "-0.1"], "thickness of a layer must be greater than 0, got -0.1 mm"),
        ("a.stl", CUBE, ["--thickness", "5e-7"], "at most 100000 planes .* 10000000 planes, which would take"),
        ("a.stl", CUBE, ["--range=7:9"], "range of layers must meet the body"),
        ("a.stl", CUBE, ["--range=3:2"], "low < high, got 3 and 2 mm"),
        ("a.stl", CUBE, ["--heights", "2,1"], "heights must rise"),
        ("a.stl", CUBE, ["--axes", "xx"], "every axis may be named once"),
        ("a.stl", CUBE, ["--axes", "0,0,0"], "an axis must be x, y, z or a direction"),
        ("a.stl", CUBE, ["--rod-ratio", "2"], "must lie in 0..1, got 2"),
        ("a.ssl", b"", [], "must begin with 'Slice V0'"),
        ("a.ssl", SSL.replace("5 5", "5 five").encode(), [], "a.ssl, line 8: a corner must be two finite numbers"),
        ("a.ssl", SSL.encode(), ["--thickness", "1"], "have their own thickness"),
        ("a.ssl", SSL.encode(), ["--axes", "xy"], "the layers along one axis, got x, y"),
        ("a.ssl", SSL.encode(), ["--unit", "m"], "one of auto, mm, inch, got m"),
        ("a.ssl", SSL.encode(), ["--heights", "1"], "heights and a range cannot be chosen"),
        ("a.ssl", None, [], "a.ssl could not be read: No such file"),
    ],
)
def test_wrong_input_is_exit_code_2_one_sentence_and_no_folder(name, data, words, message, tmp_path):
    if data is not None:
        (tmp_path / name).write_bytes(data)
    before = names(tmp_path)
    done = analyse(tmp_path / name, *words, *FEW, "--quiet", "--out", tmp_path / "out")
    assert done.returncode == 2, done.stderr
    assert re.search(message, done.stderr), done.stderr
    assert len(done.stderr.splitlines()) == 1 and done.stdout == ""
    assert names(tmp_path) == before


def test_a_folder_is_no_file_to_analyse(cube, tmp_path):
    done = analyse(cube[1], *FEW, "--out", tmp_path / "out")
    assert done.returncode == 2 and "a file must be analysed, got the folder" in done.stderr
    assert names(tmp_path) == []


def test_a_file_that_may_not_be_read_is_wrong_input(tmp_path):
    (tmp_path / "a.stl").mkdir()
    done = analyse(tmp_path / "a.stl", *FEW, "--out", tmp_path / "out")
    assert done.returncode == 2 and names(tmp_path) == ["a.stl"]


# ------------------------------------------------------------------------------------------ runs that do not get there


def started(folder):
    """A run that has begun to compute: the morphometry of a cube takes its time."""
    stl.write_stl(folder / "a.stl", cavity())
    command = [*BARE, "analyse", str(folder / "a.stl"), "--thickness", "1", "--out", str(folder / "out")]
    process = subprocess.Popen(command, cwd=str(ROOT), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    said = []
    for line in process.stderr:
        said.append(line)
        if re.match(r" [3-6]\d %", line):
            return process
    process.communicate()
    raise AssertionError("it ended before it could be stopped:\n" + "".join(said))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_stopped_run_leaves_the_folder_as_it_was(number, tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "report.json").write_text("the old one")
    process = started(tmp_path)
    process.send_signal(number)
    _, said = process.communicate(timeout=30)
    assert process.returncode == 130 and "stopped; nothing was written" in said
    assert (tmp_path / "out" / "report.json").read_text() == "the old one"
    assert names(tmp_path) == ["a.stl", "out"] and names(tmp_path / "out") == ["report.json"]


def test_a_killed_run_leaves_nothing_half_written(tmp_path):
    process = started(tmp_path)
    process.kill()
    process.communicate()
    end = time.monotonic() + 40
    while names(tmp_path) != ["a.stl"] and time.monotonic() < end:
        time.sleep(0.1)  # its FreeCAD notices that nobody listens, and tidies up
    assert names(tmp_path) == ["a.stl"]


def test_a_full_disk_is_exit_code_1_and_nothing_is_written(tmp_path):
    stl.write_stl(tmp_path / "a.stl", cavity())
    check_a_full_disk("analyse", tmp_path / "a.stl", "--thickness", "0.01", *FEW, "--out", tmp_path / "out")
    assert names(tmp_path) == ["a.stl"]


def test_files_of_an_earlier_run_are_replaced_or_pointed_out(tmp_path):
    stl.write_stl(tmp_path / "a.stl", cavity())
    out = tmp_path / "out"
    out.mkdir()
    for name in ("profile_x.csv", "profile_y.csv", "slices_x.ssl", "mine.txt"):
        (out / name).write_text("old")
    done = analyse(tmp_path / "a.stl", "--axes", "x", *FEW, "--out", out)
    assert done.returncode == 0
    assert "profile_y.csv, slices_x.ssl in" in done.stderr and "belong to an earlier run" in done.stderr
    assert (out / "profile_x.csv").read_text() != "old" and (out / "mine.txt").read_text() == "old"


def test_the_report_of_a_design_is_not_overwritten(tmp_path):
    stl.write_stl(tmp_path / "scaffold.stl", cavity())
    (tmp_path / "report.json").write_text('{"rods": 27}')
    done = analyse(tmp_path / "scaffold.stl", *FEW, "--out", tmp_path)
    assert done.returncode == 2 and "holds the report.json of a design" in done.stderr
    assert names(tmp_path) == ["report.json", "scaffold.stl"]
