# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common Layer Interface out, read again by the few rules of its description."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.analysis.cli_layers import write_cli
from freecad_trabecula.core.analysis.contours import Contours
from freecad_trabecula.errors import Cancelled, ExportError, ParameterError

SQUARE = [[0, 0], [5, 0], [5, 5], [0, 5]]
HOLE = [[1, 1], [1, 4], [4, 4], [4, 1]]
LINE = [[2, 2], [3, 3]]


def layers_of(*planes, open_last=False):
    polygons = [np.array(p, float) for contours in planes for p in contours]
    closed = np.ones(len(polygons), bool)
    if open_last:
        closed[-1] = False
    return Contours(
        axis="z",
        heights=0.05 + 0.1 * np.arange(len(planes)),
        points=np.concatenate(polygons) if polygons else np.zeros((0, 2)),
        starts=np.concatenate([[0], np.cumsum([len(p) for p in polygons])]).astype(int),
        plane=np.repeat(np.arange(len(planes)), [len(c) for c in planes]),
        closed=closed,
    )


def read_cli(path):
    """Return header {word: text} and layers [(height, [(direction, points)])], by the format's own rules."""
    header, layers, in_body = {}, [], False
    for line in path.read_text(encoding="ascii").splitlines():
        word, _, rest = line[2:].partition("/")
        assert line.startswith("$$")
        if word == "GEOMETRYSTART":
            in_body = True
        elif not in_body:
            header[word] = rest
        elif word == "LAYER":
            layers.append((float(rest), []))
        elif word == "POLYLINE":
            part, direction, count, *values = rest.split(",")
            points = np.array(values, float).reshape(-1, 2)
            assert part == "1" and len(points) == int(count)
            layers[-1][1].append((int(direction), points))
        else:
            assert word == "GEOMETRYEND"
    return header, layers


def test_layers_directions_and_corners_come_back(tmp_path):
    write_cli(tmp_path / "a.cli", layers_of([SQUARE, HOLE], [], [SQUARE, LINE], open_last=True), 0.1)
    header, layers = read_cli(tmp_path / "a.cli")
    assert "ASCII" in header and header["VERSION"] == "200" and float(header["UNITS"]) == 1
    assert header["LABEL"] == "1,a" and int(header["LAYERS"]) == len(layers)
    assert [height for height, _ in layers] == pytest.approx([0, 0.1, 0.2, 0.3])
    assert [[direction for direction, _ in found] for _, found in layers] == [[], [1, 0], [], [1, 2]]
    outer, inner = (points for _, points in layers[1][1])
    assert outer.tolist() == [*SQUARE, SQUARE[0]]
    assert inner.tolist() == [*HOLE, HOLE[0]]
    assert layers[3][1][1][1].tolist() == LINE


def test_a_layer_is_named_by_its_upper_surface_wherever_its_plane_lies(tmp_path):
    write_cli(tmp_path / "a.cli", layers_of([SQUARE]), 0.1, above=1.0)
    assert [height for height, _ in read_cli(tmp_path / "a.cli")[1]] == pytest.approx([0.05, 0.15])


def test_the_dimension_is_the_box_of_the_layers(tmp_path):
    write_cli(tmp_path / "a.cli", layers_of([SQUARE], [HOLE]), 0.1)
    box = [float(v) for v in read_cli(tmp_path / "a.cli")[0]["DIMENSION"].split(",")]
    assert box == pytest.approx([0, 0, 0, 5, 5, 0.2])


def test_no_layers_make_a_file_of_none(tmp_path):
    write_cli(tmp_path / "a.cli", layers_of(), 0.1)
    header, layers = read_cli(tmp_path / "a.cli")
    assert [found for _, found in layers] == [[]] and "DIMENSION" not in header


def test_a_label_holds_no_line_end_and_no_dollar(tmp_path):
    write_cli(tmp_path / "a.cli", layers_of([SQUARE]), 0.1, name="bone\n$$LAYER/9 µm")
    assert read_cli(tmp_path / "a.cli")[0]["LABEL"] == "1,bone___LAYER/9 ?m"


def test_a_thickness_of_nothing_is_refused_and_nothing_is_written(tmp_path):
    with pytest.raises(ParameterError, match="above 0 mm, got -1"):
        write_cli(tmp_path / "a.cli", layers_of([SQUARE]), -1)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ExportError, match="could not be written"):
        write_cli(tmp_path / "none" / "a.cli", layers_of([SQUARE]), 0.1)


def test_writing_can_be_stopped_and_leaves_nothing(tmp_path):
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        write_cli(tmp_path / "a.cli", layers_of([SQUARE]), 0.1, progress=stop)
    assert list(tmp_path.iterdir()) == []
