# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots: what is drawn is what was measured, every axis says what it shows and in which unit."""

from __future__ import annotations

import sys
import warnings
from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core.analysis import plots
from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.comparison import compare
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import Soup
from freecad_trabecula.errors import DependencyError, ExportError

with warnings.catch_warnings():  # of its own imports, on some Pythons
    warnings.simplefilter("ignore")
    pytest.importorskip("matplotlib.figure")


@pytest.fixture
def compared(measured, box):
    solid = analyse(
        Soup(box((0, 0, 0), (9, 10, 8)), "mm", "solid.stl"), SliceParameters(thickness=0.5, axes=("x", "z")), False
    )
    return compare([measured, solid]), [measured, solid]


def lines_of(axes):
    """Label: (across, up) of the curves that have one."""
    return {line.get_label(): line.get_data() for line in axes.get_lines() if not line.get_label().startswith("_")}


def test_an_analysis_has_the_figures_of_the_thesis(measured):
    names = [name for name, _ in plots.analysis_figures(measured)]
    assert names == ["sliced_area", "porosity", "number_of_trabeculae", "trabecular_area_x", "trabecular_area_z"]


def test_curves_are_the_profiles(measured):
    figures = dict(plots.analysis_figures(measured))
    curves = lines_of(figures["sliced_area"].axes[0])
    assert set(curves) == {"along X", "along Z"}
    assert np.array_equal(curves["along X"], [measured.profiles["x"].coordinate, measured.profiles["x"].sliced_area])
    assert lines_of(figures["porosity"].axes[0])["along Z"][1].max() == pytest.approx(36)
    counts = lines_of(figures["number_of_trabeculae"].axes[1])
    assert counts["outer contours"][1].tolist() == [1] * 20
    assert sum(counts["contours (as the thesis counts)"][1]) == 32


def test_rods_plates_and_voids_are_drawn_apart(measured):
    found = lines_of(dict(plots.analysis_figures(measured))["trabecular_area_x"].axes[0])
    assert {label: len(data[1]) for label, data in found.items()} == {"plates": 0, "rods": 20, "voids": 12}
    assert found["voids"][1] == pytest.approx(-36)


def test_every_axis_is_labelled_and_lengths_and_areas_have_their_unit(measured, compared):
    for name, figure in [*plots.analysis_figures(measured), *plots.comparison_figures(*compared)]:
        figure.draw_without_rendering()
        for axes in figure.axes:
            across, up = axes.get_xlabel(), axes.get_ylabel()
            shown = [tick.get_text() for tick in axes.get_xticklabels() if tick.get_visible() and tick.get_text()]
            assert across or up or not shown, name
            assert not across or "," in across or across == "contours a bin", (name, across)
        words = " ".join(axes.get_xlabel() + axes.get_ylabel() for axes in figure.axes)
        assert "mm" in words, name


def test_curves_differ_by_colour_and_by_dashes(compared):
    figure = dict(plots.comparison_figures(*compared))["sliced_area"]
    first, second = figure.axes[0].get_lines()
    assert first.get_color() != second.get_color()
    assert first.get_linestyle() != second.get_linestyle()


def test_a_comparison_has_curves_differences_heat_maps_and_distributions(compared):
    comparison, analyses = compared
    figures = dict(plots.comparison_figures(comparison, analyses))
    assert set(figures) == {
        *("sliced_area", "porosity", "contours", "outer_contours", "largest_area"),
        *("trabecular_area", "area_distribution"),
    }
    below = figures["sliced_area"].axes[2:4]
    for axes, axis in zip(below, ("x", "z")):
        shown = lines_of(axes)["solid.stl"][1]
        assert np.array_equal(shown, comparison.axes[axis].difference("sliced_area").values)
    share = lines_of(figures["area_distribution"].axes[0])
    assert all(data[1][-1] == pytest.approx(100) for data in share.values())


def test_a_heat_map_counts_every_contour(measured):
    profile, measures = measured.profiles["x"], measured.measures["x"]
    rows = measures.area > 0
    edges = plots.coordinate_edges(profile), plots.area_edges(measures.area[rows])
    figure = plots.new_figure(4, 4)
    mesh = plots.draw_heat_map(
        figure.subplots(), profile.coordinate[measures.plane[rows]], measures.area[rows], edges, 2
    )
    assert mesh.get_array().sum() == 20


@pytest.mark.parametrize("count", [1, 2, 199, 200, 201, 1000, 1001])
def test_bins_of_the_co_ordinate_are_whole_layers_and_at_most_200(measured, count):
    profile = replace(measured.profiles["x"], coordinate=0.25 + 0.5 * np.arange(count))
    edges = plots.coordinate_edges(profile, origin=1.0)
    assert len(edges) <= 201 and (np.diff(edges) > 0).all()
    assert edges[0] == pytest.approx(-1.0) and edges[-1] == pytest.approx(0.5 * count - 1)
    assert np.allclose(edges * 2, np.round(edges * 2))


@pytest.mark.parametrize(("kind", "start"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")])
def test_figures_are_written_in_three_formats_and_the_same_twice(measured, tmp_path, kind, start):
    for name in ("a", "b"):
        figure = dict(plots.analysis_figures(measured))["sliced_area"]
        plots.save_figure(figure, tmp_path / name, kind)
    data = (tmp_path / "a").read_bytes()
    assert data.startswith(start) and len(data) > 5000
    assert data == (tmp_path / "b").read_bytes()


def test_a_body_without_contours_is_drawn_too(measured):
    nothing = SliceParameters(at="heights", heights=(20.0,), axes=("x",))
    triangles = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]]], np.float32)
    flat = analyse(Soup(triangles), nothing, morphometry=False)
    for _, figure in plots.analysis_figures(flat):
        figure.draw_without_rendering()
    assert len(flat.measures["x"]) == 0


def test_spoilt_slices_are_marked(measured):
    spoilt = replace(measured.profiles["x"], spoilt=np.arange(20) == 3)
    figure = plots.new_figure(4, 4)
    axes = figure.subplots()
    plots.draw_profiles(axes, {"x": spoilt}, "sliced_area")
    assert lines_of(axes)["spoilt"][0].tolist() == [1.75]


def test_without_matplotlib_the_message_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(DependencyError, match="pip install matplotlib"):
        plots.new_figure(1, 1)


def test_a_folder_that_is_not_there_is_refused(measured, tmp_path):
    figure = plots.new_figure(1, 1)
    with pytest.raises(ExportError, match="could not be written"):
        plots.save_figure(figure, tmp_path / "none" / "a.png", "png")


def test_the_equal_slices_of_a_box_are_a_level_line(box):
    solid = analyse(Soup(box((0.1, 0.2, 0.3), (3.4, 2.9, 4.4)), "mm", "box"), SliceParameters(axes=("x", "y")), False)
    assert len({*solid.profiles["x"].sliced_area}) > 1  # rounding, of single precision
    alone = dict(plots.analysis_figures(replace(solid, profiles={"x": solid.profiles["x"]})))
    both = dict(plots.comparison_figures(compare([solid, solid]), [solid, solid]))["sliced_area"]
    for axes in (alone["sliced_area"].axes[0], alone["porosity"].axes[0], both.axes[1], both.axes[3]):
        (low, high), values = axes.get_ylim(), [line.get_ydata() for line in axes.get_lines()]
        assert 0 <= np.max([np.ptp(one) for one in values]) < 1e-3 * (high - low)
    x, z = both.axes[0].get_ylim()
    assert x < 2.7 * 4.1 < z and x < 3.3 * 4.1 < z  # along x and y: one scale for both
