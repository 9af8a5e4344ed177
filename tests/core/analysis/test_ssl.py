# SPDX-License-Identifier: LGPL-2.1-or-later
"""SSL in and out: what other programs wrote is read, what is wrong is named with its line."""

from __future__ import annotations

import os
import time
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import Contours
from freecad_trabecula.core.analysis.ssl import read_ssl, write_ssl
from freecad_trabecula.errors import Cancelled, ContourError, ExportError, ParameterError

DATA = Path(os.environ.get("TRABECULA_DATA") or Path(__file__).resolve().parents[4] / "shared" / "data")
SAMPLE = DATA / "trab_ior_1p17mm_tiny_z0.1.ssl"

#: Thesis Fig. 5.2: the first layer of a box of 5 mm with a square hole of 3 mm.
BOX = """Slice V0
FILE(C:\\parts\\SLICES() Z\\box.ssl)
UNITS(MM)
SLICES()
Z 0.1 0.1
0 0
5 0
5 5
0 5
C
1 1
1 4
4 4
4 1
C
END
"""


def read(tmp_path, text, **more):
    path = tmp_path / "file.ssl"
    path.write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))
    return read_ssl(path, **more)


def contours_of(layers, closed=None):
    """Contours from {height: [polygons]}."""
    polygons = [np.array(p, float) for contours in layers.values() for p in contours]
    return Contours(
        axis="z",
        heights=np.array(list(layers), float),
        points=np.concatenate(polygons) if polygons else np.zeros((0, 2)),
        starts=np.concatenate([[0], np.cumsum([len(p) for p in polygons])]).astype(int),
        plane=np.repeat(np.arange(len(layers)), [len(c) for c in layers.values()]),
        closed=np.ones(len(polygons), bool) if closed is None else np.array(closed),
    )


def areas(contours):
    """Signed shoelace area of each contour."""
    result = []
    for start, end in zip(contours.starts[:-1], contours.starts[1:]):
        x, y = contours.points[start:end].T
        result.append(float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2))
    return np.array(result)


def regular(corners, radius, middle=(0.0, 0.0)):
    angle = 2 * np.pi * np.arange(corners) / corners
    return np.stack([np.cos(angle), np.sin(angle)], 1) * radius + middle


# ------------------------------------------------------------------------------------------------------------- reading


def test_the_box_of_the_thesis_has_its_material_and_its_void(tmp_path):
    found = read(tmp_path, BOX)
    assert areas(found.contours).tolist() == [25.0, -9.0]
    assert found.contours.heights.tolist() == [0.1]
    assert found.thickness == 0.1
    assert found.contours.closed.all() and found.contours.axis == "z"
    assert found.name == "C:\\parts\\SLICES() Z\\box.ssl"
    assert found.unit == "mm" and found.notes == ()


@pytest.mark.parametrize(
    "change",
    [
        lambda t: t.replace("\n", "\r\n"),
        lambda t: t.replace("\n", "\r"),
        lambda t: t.replace("\n", "\n\n"),
        lambda t: t.replace("\n", " \t\n  "),
        lambda t: t.replace("5 5", " 5.000   5.0e0 "),
        lambda t: t.lower(),
        lambda t: t.upper(),
        lambda t: t.replace("Z 0.1", "# C:\\old\\path Z C\nZ 0.1").replace("5 5", "5 5 # corner"),
        lambda t: t.replace("SLICES()\n", "SLICES()\n(D:\\bone)\n; 1 2\n// C\n"),
        lambda t: t + "Z garbage that nobody reads\n",
        lambda t: "\ufeff" + t,
        lambda t: t.rstrip("\n"),
    ],
)
def test_line_ends_blanks_case_and_comments_do_not_matter(change, tmp_path):
    found = read(tmp_path, change(BOX))
    assert areas(found.contours).tolist() == [25.0, -9.0]
    assert found.contours.heights.tolist() == [0.1]
    assert found.notes == ()


def test_a_file_of_an_old_windows_may_have_a_path_that_is_no_utf8(tmp_path):
    found = read(tmp_path, BOX.replace("parts", "pi\xe8ces").encode("latin-1"))
    assert "pi\xe8ces" in found.name


def test_inches_become_millimetres(tmp_path):
    for word in ("INCH", "inches", "In"):
        found = read(tmp_path, BOX.replace("MM", word))
        assert found.unit == "inch"
        assert areas(found.contours) == pytest.approx([25 * 25.4**2, -9 * 25.4**2], rel=1e-14)
        assert found.contours.heights[0] == found.thickness == pytest.approx(2.54)


def test_without_units_millimetres_are_taken_and_said(tmp_path):
    text = BOX.replace("UNITS(MM)\n", "")
    assert read(tmp_path, text).notes == ("UNITS is missing: mm taken",)
    asked = read(tmp_path, text, unit="inch")
    assert asked.contours.heights[0] == pytest.approx(2.54)
    assert "inch" in asked.notes[0]


def test_open_polylines_are_kept_apart_and_said(tmp_path):
    found = read(tmp_path, BOX.replace("4 1\nC", "4 1\nO"))
    assert found.contours.closed.tolist() == [True, False]
    assert any("open (O)" in note for note in found.notes)


def test_a_first_corner_that_comes_again_at_the_end_is_left_out(tmp_path):
    found = read(tmp_path, BOX.replace("0 5\nC", "0 5\n0 0\nC"))
    assert np.diff(found.contours.starts).tolist() == [4, 4]
    assert any("repeat" in note for note in found.notes)


def test_layers_in_descending_order_are_sorted_and_said(tmp_path):
    text = "Slice V0\nFILE(a)\nUNITS(MM)\nSLICES()\n"
    for z, side in ((0.3, 3), (0.1, 1), (0.2, 2)):
        text += f"Z {z} 0.1\n0 0\n{side} 0\n{side} {side}\n0 {side}\nC\n"
    found = read(tmp_path, text + "END\n")
    assert found.contours.heights.tolist() == [0.1, 0.2, 0.3]
    assert areas(found.contours).tolist() == [1.0, 4.0, 9.0]
    assert found.contours.plane.tolist() == [0, 1, 2]
    assert any("sorted" in note for note in found.notes)


def test_a_missing_end_is_said_and_the_layers_are_read(tmp_path):
    found = read(tmp_path, BOX.replace("END\n", ""))
    assert areas(found.contours).tolist() == [25.0, -9.0]
    assert found.notes == ("END is missing",)


def test_layers_without_contours_and_a_header_without_slices_are_read(tmp_path):
    found = read(tmp_path, BOX.replace("SLICES()\nZ", "Z 0 0.1\nZ").replace("box\\", ""))
    assert found.contours.heights.tolist() == [0.0, 0.1]
    assert found.contours.plane.tolist() == [1, 1]
    empty = read(tmp_path, "Slice V0\nSLICES()\nZ 1 1\nEND\n")
    assert len(empty.contours.plane) == 0 and len(empty.contours.points) == 0


def test_contours_without_extent_are_left_out_and_said(tmp_path):
    found = read(tmp_path, BOX.replace("1 1\n1 4\n4 4\n4 1\nC", "1 1\n2 2\nC"))
    assert areas(found.contours).tolist() == [25.0]
    assert any("fewer than three" in note for note in found.notes)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda t: "", "must begin with 'Slice V0'"),
        (lambda t: t.replace("Slice V0", "solid bone"), "line 1: an SSL file must .*, got 'solid bone'"),
        (lambda t: t.replace("Slice V0", "Slice V1"), "line 1: .*'Slice V0'"),
        (lambda t: t.replace("UNITS(MM)", "UNITS(PARSEC)"), r"line 3: the units must be MM or INCH"),
        (lambda t: t.replace("UNITS(MM)", "UNITS MM"), "line 3: .* brackets"),
        (lambda t: t.replace("UNITS(MM)", "rm -rf"), "line 3: a header must hold"),
        (lambda t: t.replace("5 0\n", "5 zero\n"), "line 7: a corner must be two finite numbers, got '5 zero'"),
        (lambda t: t.replace("5 0\n", "5 0 1\n"), "line 7: a corner"),
        (lambda t: t.replace("5 0\n5 5\n", "5 0 5\n5\n"), "line 7: a corner"),
        (lambda t: t.replace("5 0\n", "5 1e999\n"), "line 7: a corner must be two finite numbers"),
        (lambda t: t.replace("5 0\n", "5 1e30\n"), r"line 7: co-ordinates must be at most 1e\+06 mm"),
        (lambda t: t.replace("Z 0.1 0.1", "Z 1e9 0.1"), "line 5: co-ordinates must be at most"),
        (lambda t: t.replace("5 0\n", "5 1_0\n"), "line 7: a corner"),
        (lambda t: t.replace("5 0\n", "nan 0\n"), "line 7: a line must be"),
        (lambda t: t.replace("5 0\n", "__import__('os')\n"), "line 7: a line must be .* got \"__import__"),
        (lambda t: t.replace("5 0\n", "\x00\x01\n"), "line 7: a line must be"),
        (lambda t: t.replace("Z 0.1 0.1", "Z 0.1"), "line 5: a layer must be 'Z height thickness'"),
        (lambda t: t.replace("Z 0.1 0.1", "Z 0.1 0"), "line 5: a layer .* above 0"),
        (lambda t: t.replace("Z 0.1 0.1", "Z inf 0.1"), "line 5: a layer"),
        (lambda t: t.replace("Z 0.1 0.1\n", ""), "line 9: a polyline must belong to a layer"),
        (lambda t: t.replace("C\n1 1", "C\nC\n1 1"), "line 11: a polyline must have corners"),
        (lambda t: t.replace("C\nEND", "Z 0.2 0.1\nEND"), "line 15: a polyline must end with C or O before"),
        (lambda t: t.replace("C\nEND", "END"), "line 11 is cut off"),
        (lambda t: t[: t.index("4 1")], "line 11 is cut off"),
        (lambda t: t.replace("END", "Z 0.1 0.1\nEND"), "line 16: each layer must come once; Z 0.1"),
    ],
)  # fmt: skip
def test_what_is_no_ssl_is_refused_with_the_line(change, message, tmp_path):
    with pytest.raises(ContourError, match=message):
        read(tmp_path, change(BOX))


def test_layers_of_different_thickness_have_no_common_one(tmp_path):
    found = read(tmp_path, "Slice V0\nSLICES()\nZ 1 0.1\nZ 2 0.2\nEND\n")
    assert found.thicknesses.tolist() == [0.1, 0.2]
    with pytest.raises(ContourError, match="one thickness, got 0.1 to 0.2 mm in 2 layers"):
        _ = found.thickness


def test_a_file_that_is_not_there_and_a_unit_that_is_none_are_refused(tmp_path):
    with pytest.raises(ExportError, match="could not be read"):
        read_ssl(tmp_path / "none.ssl")
    with pytest.raises(ParameterError, match="one of auto, mm, inch, got 'ell'"):
        read(tmp_path, BOX, unit="ell")


def test_a_file_that_vanishes_while_it_is_read_is_refused(tmp_path, monkeypatch):
    def vanished(self):
        raise OSError(5, "Input/output error")

    monkeypatch.setattr(Path, "read_bytes", vanished)
    with pytest.raises(ExportError, match="file.ssl could not be read: Input/output error"):
        read(tmp_path, BOX)


def test_reading_can_be_stopped(tmp_path):
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        read(tmp_path, BOX, progress=stop)


# ------------------------------------------------------------------------------------------------------------- writing


@pytest.mark.parametrize("unit", ["mm", "inch"])
def test_what_is_written_comes_back_within_half_a_nanometre(unit, tmp_path):
    layers = {0.05: [regular(17, 4.0), regular(9, 1.0)[::-1]], 0.15: [], 0.25: [regular(5, 2.0, (-3, 1e3))]}
    contours = contours_of(layers)
    write_ssl(tmp_path / "a.ssl", contours, 0.1, unit=unit)
    found = read_ssl(tmp_path / "a.ssl", axis="x")
    assert found.notes == () and found.unit == unit and found.contours.axis == "x"
    assert found.name == "a.ssl"
    assert found.thickness == pytest.approx(0.1, abs=1.3e-7)
    assert np.abs(found.contours.points - contours.points).max() <= 5.1e-7
    assert np.abs(found.contours.heights - contours.heights).max() <= 5.1e-7
    for name in ("starts", "plane", "closed"):
        assert getattr(found.contours, name).tolist() == getattr(contours, name).tolist()


def test_open_polylines_stay_open(tmp_path):
    contours = contours_of({1.0: [regular(4, 1.0), [[0, 0], [1, 0], [0, 0]]]}, closed=[True, False])
    write_ssl(tmp_path / "a.ssl", contours, 1.0)
    found = read_ssl(tmp_path / "a.ssl").contours
    assert found.closed.tolist() == [True, False]
    assert np.diff(found.starts).tolist() == [4, 3]  # the open one may end where it began


def test_corners_that_fall_together_are_written_once_and_dust_not_at_all(tmp_path):
    square = [[0, 0], [0, 0], [1, 0], [1, 1e-9], [1, 1], [0, 1], [1e-9, 0]]
    contours = contours_of({1.0: [square, regular(5, 1e-8)]})
    write_ssl(tmp_path / "a.ssl", contours, 1.0)
    found = read_ssl(tmp_path / "a.ssl")
    assert areas(found.contours).tolist() == [1.0]
    assert np.diff(found.contours.starts).tolist() == [4]
    assert found.notes == ()
    assert "-0.000000" not in (tmp_path / "a.ssl").read_text()


def test_a_name_with_a_line_end_stays_in_its_line(tmp_path):
    write_ssl(tmp_path / "a.ssl", contours_of({1.0: [regular(3, 1.0)]}), 1.0, name="a\nEND\nb (c)")
    assert read_ssl(tmp_path / "a.ssl").name == "a END b (c)"


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"thickness": 0.0}, "above 0 mm, got 0"),
        ({"thickness": float("nan")}, "above 0 mm, got nan"),
        ({"thickness": 1.0, "unit": "m"}, "one of mm, inch, got 'm'"),
    ],
)
def test_wrong_thickness_and_unit_are_refused_and_nothing_is_written(more, message, tmp_path):
    with pytest.raises(ParameterError, match=message):
        write_ssl(tmp_path / "a.ssl", contours_of({1.0: [regular(3, 1.0)]}), **more)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_leaves_nothing(tmp_path):
    with pytest.raises(ExportError, match="could not be written"):
        write_ssl(tmp_path / "none" / "a.ssl", contours_of({1.0: [regular(3, 1.0)]}), 1.0)


def test_a_hundred_layers_of_3000_corners_are_written_and_read_in_a_second_each(tmp_path):
    contours = contours_of({0.1 * k: [regular(30, 1.0, (3 * i, 0)) for i in range(100)] for k in range(100)})
    start = time.process_time()
    write_ssl(tmp_path / "a.ssl", contours, 0.1)
    written = time.process_time()
    found = read_ssl(tmp_path / "a.ssl")
    end = time.process_time()
    assert len(found.contours.plane) == 10_000 and len(found.contours.points) == 300_000
    assert written - start < 1.0 and end - written < 1.0


@pytest.mark.skipif(not SAMPLE.is_file(), reason=f"{SAMPLE} is not there")
def test_a_file_of_another_program_is_read():
    found = read_ssl(SAMPLE)
    assert found.contours.heights == pytest.approx(0.05 + 0.1 * np.arange(len(found.contours.heights)))
    assert found.thickness == pytest.approx(0.1)
    assert found.contours.closed.all()
    assert found.notes == ("UNITS is missing: mm taken",)
