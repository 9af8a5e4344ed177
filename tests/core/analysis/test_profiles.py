# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles and their summaries from polygons of known area."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import Contours, contour_measures
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.profiles import make_profile, summarise
from freecad_trabecula.errors import ParameterError

SQUARE = np.array([[-1.0, -1], [1, -1], [1, 1], [-1, 1]]) / 2
DIAMOND = np.array([[-1.0, 0], [0, -1], [1, 0], [0, 1]])  # fills half of its box, as round as a square


def stack(*slices):
    polygons = [np.asarray(p, float) for contours in slices for p in contours]
    return Contours(
        "y", np.arange(len(slices)) * 0.1 + 0.05, np.concatenate([np.zeros((0, 2)), *polygons]),
        np.cumsum([0] + [len(p) for p in polygons]), np.repeat(np.arange(len(slices)), [len(c) for c in slices]),
        np.ones(len(polygons), bool),
    )  # fmt: skip


#: A square ring with an island; a square, a diamond and a speck; nothing.
SLICES = ([4 * SQUARE, 2 * SQUARE[::-1], SQUARE], [3 * SQUARE, DIAMOND + 9, 1e-4 * SQUARE - 5], [])


def profile_of(slices=SLICES, envelope=20.0, **chosen):
    contours, parameters = stack(*slices), SliceParameters(**chosen)
    measures = contour_measures(contours, parameters)
    return make_profile(contours, measures, parameters, envelope), measures, parameters


def test_a_profile_has_areas_and_both_counts_of_every_slice():
    profile, _, _ = profile_of()
    assert profile.axis == "y" and profile.thickness == 0.1 and len(profile) == 3
    assert profile.coordinate == pytest.approx([0.05, 0.15, 0.25])
    assert profile.sliced_area == pytest.approx([13, 11, 0])
    assert profile.contours.tolist() == [3, 2, 0]  # the speck is below 1e-6 mm2
    assert profile.outer_contours.tolist() == [2, 2, 0] and profile.holes.tolist() == [1, 0, 0]
    assert profile.porosity == pytest.approx([7 / 20, 9 / 20, 1]) and profile.envelope == "box"
    assert not profile.spoilt.any()


def test_what_is_counted_is_the_user_s_choice():
    assert profile_of(least_area=0.0)[0].contours.tolist() == [3, 3, 0]
    assert profile_of(least_area=1.5)[0].contours.tolist() == [2, 2, 0]


def test_porosity_may_refer_to_slices_of_an_envelope_and_is_nan_beside_it():
    profile, _, _ = profile_of(envelope=np.array([26.0, 11.0, 0.0]))
    assert profile.porosity[:2] == pytest.approx([0.5, 0.0], abs=1e-8) and math.isnan(profile.porosity[2])


def test_a_summary_has_the_thesis_ranges_and_totals():
    s = summarise(*profile_of())
    assert s.trabecular_area == pytest.approx((-4, 16)) and s.net_trabecular_area == pytest.approx((1, 12))
    assert s.sliced_area == pytest.approx((0, 13)) and s.porosity == pytest.approx((0.35, 1.0))
    assert (s.rods, s.plates, s.plates_with_holes) == (3, 1, 2)  # the diamond fills half of its box
    assert (s.rods_invariant, s.plates_invariant) == (4, 0)
    assert s.contours == (0, 3) and s.outer_contours == (0, 2)
    assert s.volume == pytest.approx(2.4) and s.mean_sliced_area == pytest.approx(8)
    assert s.mean_bone_fraction == pytest.approx(24 / 60) and s.slices == 3 and s.spoilt_slices == 0


def test_slices_at_given_heights_have_no_volume():
    contours, parameters = stack(*SLICES), SliceParameters(at="heights", heights=(0.05, 0.15, 0.25))
    measures = contour_measures(contours, parameters)
    assert math.isnan(summarise(make_profile(contours, measures, parameters, 20.0), measures, parameters).volume)


def test_empty_slices_have_no_ranges_of_contours():
    s = summarise(*profile_of(([], [])))
    assert s.rods == s.plates == 0 and math.isnan(s.trabecular_area[0]) and s.sliced_area == (0, 0)


def test_planes_with_open_chains_are_spoilt():
    contours = stack(*SLICES)
    closed = np.array([True, True, False, True, True, True])
    opened = Contours("y", contours.heights, contours.points, contours.starts, contours.plane, closed)
    measures = contour_measures(opened, SliceParameters())
    profile = make_profile(opened, measures, SliceParameters(), 20.0)
    assert profile.spoilt.tolist() == [True, False, False] and profile.sliced_area[0] == 12
    assert summarise(profile, measures, SliceParameters()).spoilt_slices == 1


def test_measures_of_other_contours_are_refused():
    contours = stack(*SLICES)
    with pytest.raises(ParameterError, match="one row of measures, got 6 and 2"):
        make_profile(contours, contour_measures(stack([SQUARE, DIAMOND]), SliceParameters()), SliceParameters(), 1.0)
