# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparison: resampling by area, differences as the thesis counts them, tables 5.11 to 5.13."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_trabecula.core.analysis import comparison as c
from freecad_trabecula.errors import ParameterError


def sample(name, sliced, thickness=0.1, low=0.0, at="middle", axes="x", areas=((0, 1.0, True),), contours=None):
    """Return what a comparison reads of an analysis: profiles along ``axes``, all alike."""
    sliced = np.asarray(sliced, float)
    shift = thickness / 2 if at == "middle" else 0.0
    coordinate = low + shift + thickness * np.arange(len(sliced))
    counts = np.asarray(np.ones(len(sliced)) if contours is None else contours)
    profile = SimpleNamespace(
        thickness=thickness, coordinate=coordinate, sliced_area=sliced, porosity=1 - sliced / 100,
        contours=counts, outer_contours=counts, holes=0 * counts, envelope_area=np.full(len(sliced), 100.0),
    )  # fmt: skip
    plane, area, is_rod = (np.array(column) for column in zip(*areas))
    measures = SimpleNamespace(plane=plane, area=area, net_area=np.where(area > 0, area, np.nan), is_rod=is_rod)
    high = low + thickness * len(sliced)
    return SimpleNamespace(
        name=name, box=np.array([[low] * 3, [high] * 3]),
        parameters=SimpleNamespace(at=at, least_area=1e-6), morphometry=None,
        profiles=dict.fromkeys(axes, profile), measures=dict.fromkeys(axes, measures),
    )  # fmt: skip


def test_resampling_keeps_the_area_under_a_profile():
    rng = np.random.default_rng(1)
    edges = np.concatenate([[0.0], np.cumsum(rng.uniform(0.1, 1, 30))])
    values = rng.uniform(0, 5, 30)
    onto = np.linspace(0, edges[-1], 8)
    means = c.resampled(edges, values, onto)
    assert (means * np.diff(onto)).sum() == pytest.approx((values * np.diff(edges)).sum(), rel=1e-14)
    # each layer by brute force: overlaps of every old with every new step
    overlap = np.minimum(onto[1:, None], edges[1:]) - np.maximum(onto[:-1, None], edges[:-1])
    assert means == pytest.approx((overlap.clip(0) * values).sum(1) / np.diff(onto), rel=1e-12)


def test_three_layers_become_two_by_halves():
    found = c.compare([sample("a", [1, 2], 0.3), sample("b", [3, 6, 9], 0.2)]).axes["x"]
    assert found.thickness == pytest.approx(0.3)
    assert found.values["sliced_area"][1] == pytest.approx([(2 * 3 + 6) / 3, (6 + 2 * 9) / 3])
    assert found.resampled == (False, True)


def test_porosity_of_a_common_layer_is_made_of_its_areas():
    a, b = sample("a", [1, 2], 0.3), sample("b", [3, 6, 9], 0.2)
    # the envelope grows: a mean of porosities would be another number; the first slice has none
    b.profiles["x"].envelope_area = np.array([0.0, 60.0, 10.0])
    b.profiles["x"].porosity = np.array([np.nan, 0.9, 0.1])
    found = c.compare([a, b]).axes["x"].values["porosity"][1]
    assert found == pytest.approx([1 - (2 * 3 + 6) / 60, 1 - (6 + 2 * 9) / (60 + 2 * 10)])


def test_equal_layers_are_passed_on_bit_by_bit():
    values = np.random.default_rng(2).uniform(10, 25, 103)
    found = c.compare([sample("a", values, low=0.3), sample("b", values, low=-7.77)]).axes["x"]
    assert np.array_equal(found.values["sliced_area"], [values, values])
    assert found.resampled == (False, False)


def test_samples_of_the_thesis_lengths_are_compared_from_their_low_ends_and_the_rest_is_stated():
    found = c.compare([sample("bone", np.ones(104)), sample("case 5", np.ones(100), low=-5.0)])
    shared = found.axes["x"]
    assert len(shared.middles) == 100
    assert shared.origins == (0.0, -5.0)
    assert shared.left_out[0] == pytest.approx((0, 0.4))
    assert any("bone reaches 0 mm below and 0.4 mm above" in note for note in found.notes)


def test_samples_are_aligned_by_their_middles_or_left_where_they_are():
    a, b = sample("a", [1, 2, 3, 4]), sample("b", [2, 3], low=0.1)
    assert np.array_equal(c.compare([a, b], alignment="centre").axes["x"].values["sliced_area"], [[2, 3], [2, 3]])
    own = c.compare([a, b], alignment="own").axes["x"]
    assert np.array_equal(own.values["sliced_area"], [[2, 3], [2, 3]])
    assert own.edges == pytest.approx([0.1, 0.2, 0.3])
    start = c.compare([a, b]).axes["x"]
    assert np.array_equal(start.values["sliced_area"], [[1, 2], [2, 3]])


@pytest.mark.parametrize(
    "at, edges", [("middle", [0.9, 1.1, 1.3]), ("bottom", [1.0, 1.2, 1.4]), ("heights", [0.9, 1.1, 1.3])]
)
def test_slabs_lie_about_middles_and_above_bottoms(at, edges):
    assert c.slab_edges(np.array([1.0, 1.2]), 0.2, at) == pytest.approx(edges)


def test_slabs_of_given_heights_meet_half_way():
    assert c.slab_edges(np.array([0.0, 1.0, 3.0]), 0.2, "heights") == pytest.approx([-0.1, 0.5, 2.0, 3.1])


def test_curves_meet_where_they_are_equal_and_where_they_cross():
    # equal once, crossing twice, touching once
    assert c.meetings(np.array([1.0, 2, 0, 1, -1, -1, 2, 0, 3])) == 4
    # the thesis on case 6 along z: "the two curves never intersect ... as a consequence ... none"
    assert c.meetings(np.array([3.0, 1, 2])) == 0


def test_the_difference_of_two_profiles_has_its_mean_its_peak_and_its_middle():
    a, b = sample("a", [1, 1, 1, 1]), sample("b", [1, 4, 3, 0])
    found = c.compare([a, b]).axes["x"].difference("sliced_area")
    assert found.values.tolist() == [0, 3, 2, -1]
    assert (found.mean, found.largest, found.equal_layers, found.meetings) == (1.0, 3.0, 1, 2)
    assert found.at == pytest.approx(0.15)
    assert found.middle == pytest.approx(2.5)


def test_the_largest_trabecula_of_a_slice_is_its_largest_contour():
    a = sample("a", [5, 6, 0], areas=((0, 2.0, True), (0, 3.0, True), (1, 7.0, False), (1, -1.0, False)))
    assert c.largest_areas(a, "x").tolist() == [3.0, 7.0, 0.0]


def test_the_table_has_the_thesis_rows_and_a_column_for_each_axis_and_sample():
    # table 5.11, first two columns
    bone = sample("bone", [10.1, 25.08], areas=((0, -1.967, False), (1, 17.56, True)), axes="xy")
    design = sample("case 5", [20.81, 60.589], areas=((0, 0.00018, True), (1, 56.96, True)), axes="xy")
    head, rows = c.compare([bone, design]).table()
    assert head == ["", "X bone", "X case 5", "Y bone", "Y case 5"]
    assert [row[:3] for row in rows] == [
        ["Total number of rods", "1", "2"],
        ["Total number of plates", "1", "0"],
        ["Trabecular area range (mm2)", "-1.967 to 17.56", "0.00018 to 56.96"],
        ["Sliced area (mm2)", "10.1 to 25.08", "20.81 to 60.59"],
    ]


def test_three_samples_share_the_stretch_that_all_cover():
    samples = [sample("a", np.ones(9)), sample("b", np.ones(5)), sample("c", np.ones(7), at="bottom")]
    shared = c.compare(samples).axes["x"]
    assert shared.values["sliced_area"].shape == (3, 5)
    assert shared.difference("contours", 2).meetings == 5


def test_analyses_without_a_common_axis_are_refused_by_name():
    with pytest.raises(ParameterError, match="axis in common, got a: x; b: y, z"):
        c.compare([sample("a", [1]), sample("b", [1], axes="yz")])


def test_samples_that_lie_apart_are_refused_with_their_stretches():
    with pytest.raises(
        ParameterError, match=r"share at least one layer of 0.1 mm along x, got a: 0 to 0.2 mm; b: 5 to"
    ):
        c.compare([sample("a", [1, 2]), sample("b", [1, 2], low=5.0)], alignment="own")


def test_a_layer_thicker_than_the_samples_is_refused():
    with pytest.raises(ParameterError, match="at least one layer of 3 mm"):
        c.compare([sample("a", [1, 2]), sample("b", [1, 2])], thickness=3.0)


@pytest.mark.parametrize("thickness", [0.0, -0.1, math.nan, math.inf])
def test_a_thickness_that_is_none_is_refused(thickness):
    with pytest.raises(ParameterError, match="thickness of common layers must be > 0"):
        c.compare([sample("a", [1]), sample("b", [1])], thickness=thickness)


def test_one_analysis_an_unknown_alignment_and_an_empty_profile_are_refused():
    with pytest.raises(ParameterError, match="at least two analyses, got 1"):
        c.compare([sample("a", [1])])
    with pytest.raises(ParameterError, match="alignment must be one of start, centre, own, got 'end'"):
        c.compare([sample("a", [1]), sample("b", [1])], alignment="end")
    with pytest.raises(ParameterError, match="b has none along x"):
        c.compare([sample("a", [1]), sample("b", [])])


def test_an_unknown_quantity_or_sample_is_refused():
    shared = c.compare([sample("a", [1]), sample("b", [1])]).axes["x"]
    with pytest.raises(ParameterError, match="quantity must be one of sliced_area"):
        shared.difference("volume")
    with pytest.raises(ParameterError, match="numbered 0 to 1, got 2"):
        shared.difference("contours", 2)
