# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slices as SVG, read again as XML: corners, groups, places in the sheet."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import Contours
from freecad_trabecula.core.analysis.svg_layers import write_svg
from freecad_trabecula.errors import ExportError

NAMES = {"svg": "http://www.w3.org/2000/svg"}
SQUARE = np.array([[10.0, 20], [15, 20], [15, 25], [10, 25]])
HOLE = np.array([[11.0, 21], [11, 24], [14, 24], [14, 21]])
LINE = np.array([[12.0, 22], [13, 23]])


def four_layers():
    """A square with a hole, nothing, a square, a square and an open line."""
    polygons = [SQUARE, HOLE, SQUARE, SQUARE, LINE]
    return Contours(
        axis="x",
        heights=np.array([0.5, 1.5, 2.5, 3.5]),
        points=np.concatenate(polygons),
        starts=np.concatenate([[0], np.cumsum([len(p) for p in polygons])]).astype(int),
        plane=np.array([0, 0, 2, 3, 3]),
        closed=np.array([True, True, True, True, False]),
    )


def drawing_of(path):
    return ElementTree.parse(str(path)).getroot()


def polygons_of(element):
    """Corners of each part of a path, and whether it is closed."""
    found = []
    for text in re.findall("M[^M]*", element.get("d")):
        numbers = re.findall(r"-?\d+\.\d+", text)
        found.append((np.array(numbers, float).reshape(-1, 2), text.rstrip().endswith("Z")))
    return found


@pytest.fixture
def drawn(tmp_path):
    write_svg(tmp_path / "a.svg", four_layers(), name="bone & <more>")
    return drawing_of(tmp_path / "a.svg")


def test_each_layer_is_a_group_with_its_height_and_its_corners(drawn):
    groups = drawn.findall("svg:g", NAMES)
    assert [float(g.get("data-height")) for g in groups] == [0.5, 1.5, 2.5, 3.5]
    outer, inner = polygons_of(groups[0].find("svg:path", NAMES))
    assert outer[0].tolist() == SQUARE.tolist() and outer[1]
    assert inner[0].tolist() == HOLE.tolist() and inner[1]
    assert polygons_of(groups[1].find("svg:path", NAMES)) == []
    material, line = groups[3].findall("svg:path", NAMES)
    assert len(polygons_of(material)) == 1
    assert polygons_of(line)[0][0].tolist() == LINE.tolist() and not polygons_of(line)[0][1]


def test_the_layers_lie_side_by_side_inside_the_sheet_and_upright(drawn):
    width, height = (float(v) for v in drawn.get("viewBox").split()[2:])
    boxes = []
    for group in drawn.findall("svg:g", NAMES):
        across, down = re.match(r"translate\((\S+) (\S+)\) scale\(1 -1\)$", group.get("transform")).groups()
        corners = SQUARE * [1, -1] + [float(across), float(down)]
        boxes.append((corners.min(0), corners.max(0)))
    for low, high in boxes:
        assert (low > 0).all() and (high < [width, height]).all()
    for i, (low, high) in enumerate(boxes):
        assert all((low >= b).any() or (high <= a).any() for k, (a, b) in enumerate(boxes) if k != i)


def test_the_sheet_is_in_millimetres_and_has_its_title(drawn):
    assert drawn.get("width").endswith("mm") and drawn.get("height").endswith("mm")
    assert float(drawn.get("width")[:-2]) == float(drawn.get("viewBox").split()[2])
    assert drawn.find("svg:title", NAMES).text == "bone & <more>"
    assert drawn.get("data-axis") == "x"


def test_heights_are_written_under_the_slices(drawn):
    assert [text.text for text in drawn.findall("svg:text", NAMES)] == ["0.5 mm", "1.5 mm", "2.5 mm", "3.5 mm"]


def test_no_contours_make_an_empty_sheet(tmp_path):
    nothing = Contours("z", np.zeros(0), np.zeros((0, 2)), np.zeros(1, int), np.zeros(0, int), np.zeros(0, bool))
    write_svg(tmp_path / "a.svg", nothing)
    assert drawing_of(tmp_path / "a.svg").findall("svg:g", NAMES) == []


def test_a_folder_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ExportError, match="could not be written"):
        write_svg(tmp_path / "none" / "a.svg", four_layers())
