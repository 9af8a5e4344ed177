# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of an analysis: what is saved is loaded bit by bit, what was tampered with is refused."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.folder import load_analysis, save_analysis
from freecad_trabecula.core.analysis.morphometry import measure
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import Soup
from freecad_trabecula.errors import Cancelled, ExportError, ParameterError


def same(first, second):
    """Whether two dataclasses with arrays are equal, nan and all."""
    for name, value in vars(first).items():
        other = getattr(second, name)
        assert np.array_equal(np.asarray(value), np.asarray(other), equal_nan=np.asarray(value).dtype.kind == "f"), name
    return True


def test_what_is_saved_comes_back_bit_by_bit(measured, tmp_path):
    save_analysis(measured, tmp_path)
    found = load_analysis(tmp_path)
    assert (found.name, found.unit, found.seconds) == (measured.name, measured.unit, measured.seconds)
    assert found.facts == measured.facts and found.morphometry is None
    assert repr(found.parameters) == repr(measured.parameters)
    assert np.array_equal(found.box, measured.box)
    for axis in ("x", "z"):
        assert same(measured.profiles[axis], found.profiles[axis])
        assert same(measured.measures[axis], found.measures[axis])
        assert same(measured.repairs[axis], found.repairs[axis])
        assert repr(found.summary(axis)) == repr(measured.summary(axis))


def test_spoilt_slices_and_repairs_come_back(box, tmp_path):
    soup = Soup(np.delete(box((0, 0, 0), (10, 10, 10)), 3, 0), "mm", "open.stl")
    analysis = analyse(soup, SliceParameters(thickness=1.0), morphometry=False)
    assert any(analysis.profiles[axis].spoilt.any() for axis in "xyz")
    save_analysis(analysis, tmp_path)
    found = load_analysis(tmp_path)
    for axis in "xyz":
        assert same(analysis.profiles[axis], found.profiles[axis])
        assert same(analysis.repairs[axis], found.repairs[axis])


def test_morphometry_and_an_oblique_axis_come_back(cavity, tmp_path):
    analysis = analyse(cavity, SliceParameters(thickness=2.0, axes=("0.6,0.8,0",)), morphometry=False)
    analysis = replace(analysis, morphometry=measure(cavity, voxel=1.0))
    save_analysis(analysis, tmp_path)
    assert (tmp_path / "profile_0.6,0.8,0.csv").is_file()
    found = load_analysis(tmp_path)
    assert same(analysis.profiles["0.6,0.8,0"], found.profiles["0.6,0.8,0"])
    assert found.morphometry["BV/TV"] == analysis.morphometry["BV/TV"]
    assert np.array_equal(found.morphometry.spacing_shares, analysis.morphometry.spacing_shares)


def test_the_folder_holds_the_files_of_the_record_and_nothing_else(measured, tmp_path):
    (tmp_path / "plot.png").write_bytes(b"12345")
    record = save_analysis(measured, tmp_path, also=("plot.png",), versions={"numpy": "1"}, notes=("said",))
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([*record["files"], "report.json", "report.md"])
    assert record["files"]["plot.png"] == 5
    assert json.loads((tmp_path / "report.json").read_text())["notes"] == ["said"]
    assert record["files"]["profile_x.csv"] == (tmp_path / "profile_x.csv").stat().st_size


def test_a_folder_that_is_not_there_is_refused(measured, tmp_path):
    with pytest.raises(ExportError, match="could not be written"):
        save_analysis(measured, tmp_path / "none")
    with pytest.raises(ParameterError, match=r"is no folder of an analysis: report.json"):
        load_analysis(tmp_path)


def changed(folder, **values):
    path = folder / "report.json"
    record = json.loads(path.read_text())
    record.update(values)
    path.write_text(json.dumps({k: v for k, v in record.items() if v is not ...}))


@pytest.mark.parametrize(
    ("tamper", "message"),
    [
        (lambda f: (f / "report.json").write_text("{"), "report.json must be JSON"),
        (lambda f: (f / "report.json").write_bytes(b"\xff\xfe"), "report.json must be JSON"),
        (lambda f: (f / "report.json").write_text("[]"), "must be the report of a slice analysis"),
        (lambda f: changed(f, kind="design"), "must be the report of a slice analysis"),
        (lambda f: changed(f, schema=99), "must have the schema 1, got 99"),
        (lambda f: changed(f, parameters=...), "must hold 'parameters'"),
        (lambda f: changed(f, parameters={"thickness": "thin"}), "parameters.thickness must be a number"),
        (lambda f: changed(f, parameters={"thickness": -1.0}), "thickness of a layer must be greater than 0"),
        (lambda f: changed(f, axes={"../../x": {}}), "an axis must be x, y, z"),
        (lambda f: changed(f, axes={"x": {}}), "does not fit its profile of 20 slices"),
        (lambda f: (f / "profile_x.csv").unlink(), "is not a whole analysis: .*profile_x.csv could not be read"),
        (lambda f: (f / "contours_z.csv").write_text("layer\n"), "contours_z.csv, line 1"),
        (lambda f: cut(f / "profile_z.csv", 5), "contours_z.csv: layers must be those of the profile|does not fit"),
    ],
)
def test_a_folder_that_was_tampered_with_is_refused(measured, tmp_path, tamper, message):
    save_analysis(measured, tmp_path)
    tamper(tmp_path)
    with pytest.raises(ParameterError, match=message):
        load_analysis(tmp_path)


def cut(path, lines):
    path.write_text("\n".join(path.read_text().splitlines()[:lines]) + "\n")


def test_saving_reports_its_progress_and_can_be_stopped(measured, tmp_path):
    shares = []
    save_analysis(measured, tmp_path, progress=lambda done, total, what: shares.append(done / total))
    assert shares == sorted(shares) and shares[0] >= 0 and shares[-1] <= 1

    def stop(done, total, what):
        raise Cancelled("stopped")

    (tmp_path / "new").mkdir()
    with pytest.raises(Cancelled):
        save_analysis(measured, tmp_path / "new", progress=stop)
    assert list((tmp_path / "new").iterdir()) == []
