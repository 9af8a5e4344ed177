# SPDX-License-Identifier: LGPL-2.1-or-later
"""Diagrams as SVG: well formed, in the right places, thinned, with gaps."""

import re
import xml.etree.ElementTree as ElementTree

import numpy as np

from freecad_trabecula.core.html_report.charts import Line, bar_chart, line_chart


def test_a_straight_line_is_a_straight_line_from_corner_to_corner():
    svg = line_chart("t", "x", [Line("a", np.array([0.0, 5.0, 10.0]), np.array([0.0, 50.0, 100.0]))])
    tree = ElementTree.fromstring(svg)
    curve = next(one for one in tree.iter("path") if one.get("fill") == "none")
    points = [tuple(map(float, pair.split())) for pair in re.findall(r"[ML]([\d.]+ [\d.]+)", curve.get("d"))]
    assert points[1] == tuple((a + b) / 2 for a, b in zip(points[0], points[2]))
    assert points[0][0] < points[2][0] and points[0][1] > points[2][1]  # up is less in SVG


def test_a_gap_lifts_the_pen_and_nothing_is_drawn_of_nothing():
    y = np.array([1.0, np.nan, 2.0, 3.0])
    svg = line_chart("t", "x", [Line("a", np.arange(4.0), y)])
    curve = next(one for one in ElementTree.fromstring(svg).iter("path") if one.get("fill") == "none")
    assert [letter for letter in curve.get("d") if letter in "ML"] == ["M", "M", "L"]
    assert line_chart("t", "x", [Line("a", np.arange(2.0), np.full(2, np.nan))]) == ""


def test_long_curves_are_thinned_and_names_escaped():
    lines = [Line(f"<{k}>", np.arange(1e4), np.arange(1e4)) for k in range(2)]
    svg = line_chart('a "b" <c>', "x & y", lines)
    ElementTree.fromstring(svg)
    assert svg.count("L") < 1300 and "&lt;c&gt;" in svg


def test_bars_are_as_high_as_their_counts():
    svg = bar_chart("t", "x", [0.0, 1.0, 2.0], [2, 4])
    heights = [float(one.get("height")) for one in ElementTree.fromstring(svg).iter("rect")]
    assert len(heights) == 2 and abs(heights[1] / heights[0] - 2) < 0.01
    assert bar_chart("t", "x", [0.0, 1.0], [0]) == ""
