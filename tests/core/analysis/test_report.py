# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is checked twice of an analysis, what is wrong with a mesh, and the record of it all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.json_values import values_json
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.report import (
    analysis_checks,
    analysis_faults,
    analysis_notes,
    analysis_record,
    profile_tolerance,
    runs,
    volume_reason,
)
from freecad_trabecula.core.analysis.triangles import Soup

THICK = SliceParameters(thickness=0.5, axes=("x", "z"))


def analysed(soup, parameters=THICK):
    return analyse(soup, parameters, morphometry=False)


def test_the_volume_of_a_cube_with_a_cavity_is_met_along_both_axes(measured):
    x, z, fraction = analysis_checks(measured)
    for check in (x, z):
        assert check.value == pytest.approx(1000 - 216, rel=1e-9)
        assert check.second == pytest.approx(1000 - 216, rel=1e-9)
        assert check.ok and check.difference < 1e-9
    assert fraction.value == pytest.approx(0.784) and fraction.ok


def test_the_tolerance_is_half_a_layer_times_the_variation(measured):
    # 0 -> 100 -> 64 -> 100 -> 0: 272 mm2 up and down, half a layer is 0.25 mm
    assert profile_tolerance(measured.profiles["x"], "middle") == pytest.approx(272 * 0.25)
    assert profile_tolerance(measured.profiles["x"], "bottom") == pytest.approx(272 * 0.5)
    assert analysis_checks(measured)[0].tolerance == pytest.approx(68 / 784)


@pytest.mark.parametrize("thickness", [0.3, 0.7, 1.0, 3.0, 40.0])
@pytest.mark.parametrize("at", ["middle", "bottom"])
def test_no_layer_thickness_makes_a_sound_body_fail(cavity, thickness, at):
    analysis = analysed(cavity, SliceParameters(thickness=thickness, at=at))
    assert all(check.ok for check in analysis_checks(analysis)), analysis_checks(analysis)


def test_slices_that_miss_material_fail_the_check(measured):
    profile = measured.profiles["x"]
    wrong = replace(profile, sliced_area=np.where(np.arange(20) < 5, 0.0, 50.0))
    checks = analysis_checks(replace(measured, profiles={"x": wrong}))
    assert not checks[0].ok
    assert not analysis_record(replace(measured, profiles={"x": wrong}))["ok"]


def test_a_sound_body_has_no_faults_and_no_notes(measured):
    assert analysis_faults(measured) == ()
    assert analysis_notes(measured) == ()
    assert analysis_record(measured)["ok"] is True


def test_an_open_body_is_marked_with_the_layers_that_are_spoilt(box):
    triangles = box((0, 0, 0), (10, 10, 10))
    side = triangles[:, :, 2].max(1) - triangles[:, :, 2].min(1) > 5  # not top, not bottom
    which = np.flatnonzero(side)[0]
    analysis = analysed(Soup(np.delete(triangles, which, 0), "mm", "open.stl"))
    faults = analysis_faults(analysis)
    assert any("3 open edges: the mesh is not watertight" in text for text in faults)
    assert any("along z 20 of 20 slices are spoilt: layers 0-19" in text for text in faults)
    assert volume_reason(analysis) == "the mesh does not enclose a volume" and analysis_checks(analysis) == ()
    record = analysis_record(analysis)
    assert record["ok"] is False and record["watertight"] is False
    assert record["axes"]["z"]["spoilt_layers"] == list(range(20))


def test_turned_facets_double_facets_and_a_body_inside_out_are_faults(box):
    triangles = box((0, 0, 0), (4, 4, 4))
    turned = triangles.copy()
    turned[0] = turned[0, ::-1]
    assert any("turned against" in text for text in analysis_faults(analysed(Soup(turned))))
    twice = analysed(Soup(np.concatenate([triangles, triangles])))
    assert any("there twice" in text for text in analysis_faults(twice))
    outward = analysed(Soup(triangles[:, ::-1]))
    assert any("inside out" in text for text in analysis_faults(outward))


def test_overlapping_bodies_and_guessed_units_are_said(box):
    pair = np.concatenate([box((0, 0, 0), (4, 4, 4)), box((1, 1, 1), (6, 5, 5))])
    notes = analysis_notes(analysed(Soup(pair, "m (guessed: 0.006 mm)")))
    assert any("the unit is m (guessed" in text for text in notes)
    assert any("facets through others" in text and "'winding'" in text for text in notes)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"at": "heights", "heights": (1.0, 5.0)}, "the planes are not those of layers"),
        ({"low": 2.0}, "a range only was sliced"),
        ({"smoothing": "heavy"}, "contours were smoothed"),
        ({"filter_closed": 1.0}, "contours were filtered"),
    ],
)
def test_volumes_that_cannot_be_compared_are_not_and_the_reason_is_said(cavity, change, reason):
    analysis = analysed(cavity, replace(THICK, **change))
    assert volume_reason(analysis) == reason
    assert analysis_checks(analysis) == ()
    assert any(reason in text for text in analysis_notes(analysis))


def test_the_record_is_json_and_holds_what_a_script_looks_for(measured):
    record = analysis_record(measured, files={"a.csv": 10}, versions={"numpy": "1"}, notes=("said",))
    assert "NaN" not in values_json(record)
    assert record["size_mm"] == pytest.approx([10, 10, 10])
    assert record["axes"]["x"]["summary"]["sliced_area"] == pytest.approx([64, 100])
    assert record["axes"]["x"]["summary"]["volume"] == pytest.approx(784)
    assert record["parameters"]["low"] is None
    assert record["mesh"]["triangles"] == 24
    assert record["files"] == {"a.csv": 10} and record["notes"] == ["said"]


@pytest.mark.parametrize(
    ("numbers", "words"),
    [([], ""), ([4], "4"), ([1, 2, 3], "1-3"), ([0, 2, 3, 9], "0, 2-3, 9"), (range(0, 40, 2), None)],
)
def test_numbers_are_named_as_stretches(numbers, words):
    found = runs(np.array(list(numbers), int))
    assert found == words if words is not None else found.endswith("22 and 8 more stretches")
