# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choices of a slice analysis: planes that follow from them, and what is refused."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis.parameters import (
    MOST_PLANES,
    SliceParameters,
    axis_frame,
    axis_name,
    plane_heights,
)
from freecad_trabecula.core.records import from_record, to_record
from freecad_trabecula.errors import ParameterError


def heights(first, last, **more):
    return plane_heights(SliceParameters(**more), first, last)


def test_defaults_are_the_thesis_choices_of_table_5_1():
    p = SliceParameters()
    assert (p.thickness, p.gap, p.iterations, p.filter_open, p.filter_closed) == (0.1, 0.01, 5, 0, 0)
    assert (p.smoothing, p.compensation, p.rod_ratio, p.axes) == ("off", 0, 0.6, ("x", "y", "z"))


def test_planes_are_at_the_middles_of_layers():
    assert heights(0, 10) == pytest.approx(0.05 + 0.1 * np.arange(100))
    assert heights(-1, 1, thickness=0.8) == pytest.approx([-0.6, 0.2, 1.0][:2])
    assert heights(2.0, 2.13) == pytest.approx([2.05])  # the second layer's middle is beside the body


@pytest.mark.parametrize("high", [10.356, np.float32(9.45), 10.4])
def test_a_layer_belongs_to_the_body_if_its_middle_does(high):
    planes = heights(0.0, float(high))
    assert planes[-1] <= high < planes[-1] + 0.1 + 1e-6


def test_planes_at_the_bottoms_begin_where_the_body_does():
    assert heights(1, 2, at="bottom", thickness=0.25) == pytest.approx([1, 1.25, 1.5, 1.75])
    assert heights(1, 2.1, at="bottom", thickness=0.5) == pytest.approx([1, 1.5, 2])


def test_a_body_thinner_than_a_layer_is_cut_once():
    assert heights(3, 3.02).tolist() == [3.01] and heights(3, 3).tolist() == [3]
    assert heights(3, 3.02, at="bottom").tolist() == [3]


def test_a_range_is_sliced_alone_and_given_heights_are_kept():
    assert heights(0, 10, low=2, high=2.3) == pytest.approx([2.05, 2.15, 2.25])
    assert heights(0, 10, low=9.9) == pytest.approx([9.95])
    assert heights(0, 1, at="heights", heights=(-3, 0.5)).tolist() == [-3, 0.5]


def test_axes_have_one_name_each():
    assert SliceParameters(axes=("X", (0.6, 0.8, 0), " 1, 0 ,0 ")).axes == ("x", "0.6,0.8,0", "1,0,0")
    assert axis_name((1 / 3, 0, 1)) == "0.33333333333333331,0,1"
    assert axis_name(axis_name((1 / 3, 0, 1))) == axis_name((1 / 3, 0, 1))


@pytest.mark.parametrize("axis", ["x", "y", "z", "3,4,0", "-1,2,0.5", "0,0,-1"])
def test_frames_are_right_handed_and_end_in_their_axis(axis):
    frame = axis_frame(axis)
    assert frame @ frame.T == pytest.approx(np.eye(3), abs=1e-15) and np.linalg.det(frame) == pytest.approx(1)
    if "," in axis:
        given = np.array([float(part) for part in axis.split(",")])
        assert frame[2] == pytest.approx(given / np.linalg.norm(given))


def test_the_length_of_a_direction_does_not_count_whatever_it_is():
    for length in ("e-8", "e200", "e300"):
        assert axis_frame(f"3{length},4{length},0") == pytest.approx(axis_frame("3,4,0"), abs=1e-15)


def test_in_plane_directions_of_the_main_axes_go_round():
    assert axis_frame("x").tolist() == [[0, 1, 0], [0, 0, 1], [1, 0, 0]]
    assert axis_frame("y").tolist() == [[0, 0, 1], [1, 0, 0], [0, 1, 0]]
    assert axis_frame("z").tolist() == axis_frame("0,0,2").tolist() == np.eye(3).tolist()


def test_parameters_go_into_records_and_back():
    p = SliceParameters(thickness=0.2, axes=("z", (1, 2, 3)), at="heights", heights=(1, 2))
    assert to_record(from_record(SliceParameters, to_record(p), "parameters")) == to_record(p)


# --------------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    ("chosen", "rule"),
    [
        ({"thickness": 0.0}, "thickness.*greater than 0, got 0 mm"),
        ({"thickness": -0.1}, "got -0.1 mm"),
        ({"thickness": math.nan}, "thickness"),
        ({"axes": ()}, "at least one axis"),
        ({"axes": ("x", "x")}, "named once"),
        ({"axes": ("w",)}, "an axis must be"),
        ({"axes": ((0, 0, 0),)}, "an axis must be"),
        ({"axes": ("1,nan,0",)}, "an axis must be"),
        ({"axes": (7,)}, "an axis must be"),
        ({"at": "top"}, "at must be one of middle, bottom, heights"),
        ({"at": "heights"}, "heights must be given"),
        ({"heights": (1.0,)}, "heights must be given"),
        ({"at": "heights", "heights": (2, 1)}, "heights must rise"),
        ({"at": "heights", "heights": (1, math.nan)}, "finite"),
        ({"at": "heights", "heights": tuple(range(MOST_PLANES + 1))}, "at most 100000 heights"),
        ({"low": 2, "high": 2}, "low < high"),
        ({"low": math.inf}, "low must be finite"),
        ({"gap": -1}, "gap must be at least 0"),
        ({"iterations": -1}, "rounds of gap fill"),
        ({"filter_open": -1}, "filter_open"),
        ({"filter_closed": math.nan}, "filter_closed"),
        ({"smoothing": "some"}, "off, normal, heavy"),
        ({"compensation": math.inf}, "compensation must be finite"),
        ({"fill": "xor"}, "winding, union"),
        ({"rod_ratio": 1.1}, "0..1"),
        ({"least_area": -1e-9}, "least_area"),
    ],
)
def test_what_breaks_a_rule_is_refused(chosen, rule):
    with pytest.raises(ParameterError, match=rule):
        SliceParameters(**chosen)


def test_ten_million_planes_are_refused_with_an_estimate_before_anything_is_cut():
    with pytest.raises(ParameterError, match=r"1e-06 mm are 10000000 planes, which would take.*at least 0\.0001 mm"):
        heights(0, 10, thickness=1e-6)


@pytest.mark.parametrize("chosen", [{"low": 11.0}, {"high": -1.0}, {"low": 12.0, "high": 13.0}])
def test_a_range_beside_the_body_is_refused(chosen):
    with pytest.raises(ParameterError, match=r"must meet the body, 0\.\.10 mm"):
        heights(0, 10, **chosen)
