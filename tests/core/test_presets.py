# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presets are the thesis' designs: tables 3.1 to 3.6 and section 3.4."""

from __future__ import annotations

import pytest

from freecad_trabecula.core.couplings import couple
from freecad_trabecula.core.job import job_from_json, job_to_json
from freecad_trabecula.core.presets import PRESETS, THESIS, preset
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.errors import ParameterError

CASES = [f"case{k}" for k in range(1, 7)]

#: Rods of the thesis: three directions of 5 x 5 or 7 x 7, and 6 x (39 + 31).
RODS = {"case1": 75, "case2": 75, "case3": 147, "case4": 147, "case5": 147, "case6": 147, "prism420": 420}


@pytest.mark.parametrize("name", sorted(RODS))
def test_a_preset_has_the_rods_of_the_thesis(name):
    job = preset(name)
    _, rows = couple(job.couplings, prism_sites(job.prism), job.seed)
    assert sum(row.rods for row in rows) == RODS[name] == THESIS[name].rods


@pytest.mark.parametrize("name", CASES)
def test_a_case_is_a_cube_of_10_mm_with_a_border_of_1_mm_and_pores_of_02_to_08_mm(name):
    job = preset(name)
    assert [size for _, size, _, _ in job.prism.axes] == [10, 10, 10]
    assert [a for _, _, _, a in job.prism.axes] == [1, 1, 1]
    assert (job.pores.size.kind, job.pores.size.low, job.pores.size.high) == ("uniform", 0.2, 0.8)


def test_cases_differ_in_what_their_tables_say():
    found = {
        name: (job.pores.layout, job.pores.sections, job.couplings[0].association, job.path.kind)
        for name, job in ((name, preset(name)) for name in CASES)
    }
    assert found == {
        "case1": ("circle", 1, "same", "orthogonal"),
        "case2": ("spline", 1, "same", "orthogonal"),
        "case3": ("spline", 1, "random", "straight"),
        "case4": ("spline", 2, "random", "straight"),
        "case5": ("spline", 2, "random", "centre"),
        "case6": ("spline", 2, "random", "box"),
    }


def test_the_middle_points_of_case_6_lie_within_2_mm_of_the_centre():
    assert preset("case6").path.box == (4.0, 4.0, 4.0)


def test_the_sites_of_the_prism_of_420_rods_are_13_mm_apart():
    for axis, size, count, border in preset("prism420").prism.axes:
        assert (size - 2 * border) / (count - 1) == pytest.approx(1.31 if axis == "Z" else 1.289, abs=0.03)


def test_the_seconds_per_rod_of_the_thesis_are_its_seconds_by_its_rods():
    for name, figures in THESIS.items():
        assert figures.seconds / figures.rods == pytest.approx(figures.seconds_per_rod, rel=0.011), name


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_survives_a_job_file(name):
    assert job_from_json(job_to_json(preset(name))) == preset(name)


def test_every_preset_has_figures_of_the_thesis():
    assert set(PRESETS) <= set(THESIS)


@pytest.mark.parametrize("name", ["", "case7", "Case1", "case1 ", "../case1"])
def test_a_preset_that_there_is_none_of_is_refused_with_the_list(name):
    with pytest.raises(ParameterError, match="a preset must be one of case1, case2, .*, got"):
        preset(name)
