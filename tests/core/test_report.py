# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report: figures from closed forms and from the thesis, the same in JSON and in the tables."""

from __future__ import annotations

import dataclasses
import json
import math
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.bodies import Check
from freecad_trabecula.core.job import Job, opposite_couplings, set_values, with_seed
from freecad_trabecula.core.laws import Region, constant
from freecad_trabecula.core.parameters import Coupling, PathParameters, PoreParameters, PrismParameters
from freecad_trabecula.core.presets import THESIS, preset
from freecad_trabecula.core.report import (
    BodyFigures,
    Outcome,
    manual_seconds,
    report_json,
    report_record,
    thesis_figures,
)
from freecad_trabecula.core.report_text import digits, report_markdown, report_summary, size_words
from freecad_trabecula.core.sites import prism_sites

REGION = Region((0, 0, 0), (10, 10, 10), (5, 5, 5))
GOOD = Check("sum of the volumes", 1000.0, 1000.0, 1e-12, 1e-6)
BAD = Check("sum of the volumes", 1000.0, 990.0, 1e-2, 1e-6)
#: 1,000 mm3 of which 639 are scaffold, 360 channels, 1 loose; the rods fill 360.5 of it and have 500 in all.
BODIES = BodyFigures(
    engine="mesh",
    reason="147 rods are few",
    envelope=1000.0,
    added=0.0,
    channels=360.0,
    scaffold=639.0,
    loose=1.0,
    voids=0.0,
    porosity=0.361,
    union_porosity=0.3605,
    sum_porosity=0.5,
    pieces=1,
    openings=1,
    loose_pieces=2,
    closed_voids=0,
    watertight=True,
)


def wireframe_of(job):
    return make_wireframe(job.wireframe, prism_sites(job.prism), REGION)


def outcome_of(job, **more):
    usual = Outcome(
        job,
        wireframe_of(job),
        BODIES,
        (GOOD,),
        seconds={"envelope, sites, paths": 0.5, "rods": 1.5, "scaffold": 4.0},
        cpu_seconds=5.5,
        files={"scaffold.stl": 84, "network.step": 5_400_000},
        versions={"FreeCAD": "0.20.2"},
    )
    return dataclasses.replace(usual, **more)


CASE1 = preset("case1")
CASE6 = report_record(outcome_of(preset("case6")))


# ----------------------------------------------------------------------------------------------------- the record


def test_the_record_survives_json():
    assert json.loads(report_json(CASE6)) == CASE6


def test_the_figures_that_a_script_looks_for_are_there():
    assert CASE6["rods"] == 147
    assert CASE6["seed"] == 1
    assert CASE6["watertight"] is True
    assert CASE6["ok"] is True
    assert {"envelope", "channels", "scaffold", "loose"} <= set(CASE6["volume_mm3"])
    assert {"couplings", "recoveries", "versions", "files", "seconds"} <= set(CASE6)


def test_every_key_is_on_the_page_of_the_job_file():
    page = (Path(__file__).resolve().parents[2] / "docs" / "job.md").read_text(encoding="utf-8")
    section = page[page.index("## What the command writes") :]
    missing = [key for key in (*CASE6, *CASE6["volume_mm3"]) if f"`{key}`" not in section]
    assert missing == ["schema"]


def test_porosity_is_the_share_of_the_envelope_that_is_not_exported():
    assert CASE6["porosity"] == pytest.approx(1 - 639.0 / 1000.0)
    assert CASE6["porosity_percent"] == pytest.approx(36.1)
    assert CASE6["union_porosity_percent"] == pytest.approx(36.05)
    assert CASE6["sum_porosity_percent"] == pytest.approx(50.0)


def test_scaffold_channels_and_loose_pieces_make_up_the_envelope_and_its_layers():
    kept = dataclasses.replace(BODIES, kept=True, scaffold=640.0)
    layered = dataclasses.replace(BODIES, added=50.0, scaffold=689.0)
    for bodies in (BODIES, kept, layered):
        volume = report_record(outcome_of(CASE1, bodies=bodies))["volume_mm3"]
        parts = volume["scaffold"] + volume["channels"] + volume["loose"]
        assert parts == pytest.approx(volume["envelope"] + volume["layers"])


def test_one_failed_check_is_enough():
    record = report_record(outcome_of(CASE1, checks=(GOOD, BAD, GOOD)))
    assert record["ok"] is False
    assert "FAILED: sum of the volumes: 1000 against 990, 0.01 apart, at most 1e-06" in report_summary(record)
    assert "| sum of the volumes | **FAILED** | 1000 | 990 | 0.01 | 1e-06 |" in report_markdown(record)
    assert "Not all checks held" in report_markdown(record)


def test_a_body_with_holes_is_not_called_watertight():
    record = report_record(outcome_of(CASE1, bodies=dataclasses.replace(BODIES, watertight=False)))
    assert record["watertight"] is False
    assert "NOT watertight" in report_summary(record)


def test_pieces_are_counted():
    assert CASE6["pieces"] == {"scaffold": 1, "channels": 1, "loose": 2, "closed_voids": 0}
    assert "loose 2" in report_summary(CASE6)


def test_true_areas_of_circles_are_a_quarter_of_pi_of_the_estimated():
    pores = report_record(outcome_of(CASE1))["pores"]
    assert pores["count"] == 75  # one section a rod
    assert pores["true_by_estimated_area"] == pytest.approx(math.pi / 4, rel=1e-9)
    assert pores["true_area_mm2"]["mean"] == pytest.approx(math.pi / 4 * pores["estimated_area_mm2"]["mean"], rel=1e-9)


def test_pores_of_one_size_have_no_spread():
    job = dataclasses.replace(CASE1, pores=PoreParameters(layout="circle", size=constant(0.5), sections=1))
    pores = report_record(outcome_of(job))["pores"]
    assert pores["size_mm"] == {"mean": 0.5, "sd": pytest.approx(0), "least": 0.5, "greatest": 0.5}
    assert sum(pores["size_histogram"]["counts"]) == 75


def test_two_sections_a_rod_are_both_counted():
    assert CASE6["pores"]["count"] == 294
    sizes = CASE6["pores"]["size_mm"]
    assert 0.2 <= sizes["least"] < sizes["mean"] < sizes["greatest"] <= 0.8
    assert sizes["mean"] == pytest.approx(0.5, abs=4 * 0.6 / math.sqrt(12 * 294))


def test_couplings_are_the_thesis_table_of_initial_and_final_sites():
    job = dataclasses.replace(
        preset("case6"),
        couplings=(
            Coupling("Face1", "Face3"),
            Coupling("Face1", "Face2", limit=9),
            Coupling("Face1", "Face2", on=False),
        ),
        prism=PrismParameters(n_x=3, n_y=7, n_z=7),
    )
    # Face1 has 7 x 7 sites, Face3 3 x 7
    assert [tuple(row.values()) for row in report_record(outcome_of(job))["couplings"]] == [
        ("Face1", "Face3", 49, 21, 21, 28, 0),
        ("Face1", "Face2", 28, 49, 9, 19, 40),
    ]


def test_the_report_of_one_seed_is_always_the_same():
    assert report_record(outcome_of(preset("case6"))) == CASE6
    other = report_record(outcome_of(with_seed(preset("case6"), 2)))
    assert other["pores"]["size_mm"] != CASE6["pores"]["size_mm"]


def test_rods_that_failed_or_leave_are_named():
    outcome = outcome_of(CASE1)
    wireframe = dataclasses.replace(outcome.wireframe, failed=("A.1.1-B.2.2",), outside=("A.3.3-B.4.4",))
    record = report_record(dataclasses.replace(outcome, wireframe=wireframe))
    assert (record["failed_rods"], record["outside_rods"]) == (["A.1.1-B.2.2"], ["A.3.3-B.4.4"])
    text = report_markdown(record)
    assert "nothing mended them: A.1.1-B.2.2." in text
    assert "Leave the envelope: A.3.3-B.4.4." in text


def test_an_empty_design_has_a_report():
    job = dataclasses.replace(CASE1, couplings=(Coupling("Face1", "Face2", on=False),))
    record = report_record(outcome_of(job))
    assert (record["rods"], record["pores"]) == (0, {"count": 0})
    assert record["seconds_per_rod"] == 2.0  # per rod that might have been
    assert "# case1" in report_markdown(record)


# ------------------------------------------------------------------------------------------- times and the thesis


@pytest.mark.parametrize(
    ("path", "sections", "seconds"),
    [("orthogonal", 1, 30), ("straight", 2, 45), ("centre", 1, 60), ("box", 2, 75), ("tension", 2, 75)],
)
def test_manual_design_takes_what_the_thesis_estimates(path, sections, seconds):
    job = Job(
        prism=PrismParameters(n_x=3, n_y=3, n_z=3),
        pores=PoreParameters(sections=sections),
        path=PathParameters(path),
        couplings=opposite_couplings("same"),
    )
    assert manual_seconds(job, wireframe_of(job)) == 27 * seconds


def test_a_coupling_with_a_path_of_its_own_takes_its_own_time():
    own = Coupling("Face1", "Face2", "same", path=PathParameters("straight"))
    job = dataclasses.replace(preset("case6"), couplings=(own, Coupling("Face3", "Face4")))
    assert manual_seconds(job, wireframe_of(job)) == 49 * 45 + 49 * 75


@pytest.mark.parametrize("name", ["case1", "case2", "case4", "case5", "case6"])
def test_the_estimate_of_a_preset_is_the_thesis_own(name):
    job = preset(name)
    wireframe = wireframe_of(job)
    assert manual_seconds(job, wireframe) / len(wireframe) == THESIS[name].manual_seconds_per_rod


def test_times_add_up():
    assert CASE6["seconds"] == 6.0
    assert CASE6["cpu_seconds"] == 5.5


def test_the_time_a_rod_is_that_of_the_network_as_in_the_thesis():
    assert CASE6["seconds_of_network"] == 2.0
    assert CASE6["seconds_per_rod"] == pytest.approx(2.0 / 147)


def test_the_thesis_stands_beside_its_own_design_only():
    case6 = preset("case6")
    assert thesis_figures(case6)["porosity_percent"] == 36.77
    assert thesis_figures(with_seed(case6, 9)) == thesis_figures(case6)
    assert thesis_figures(set_values(case6, ["scaffold.engine=field"])) == thesis_figures(case6)
    assert thesis_figures(set_values(case6, ["pores.size.high=0.7"])) is None
    assert thesis_figures(set_values(case6, ["name=mine"])) is None
    assert thesis_figures(preset("prism420"))["porosity_percent"] is None


# ---------------------------------------------------------------------------------------------------- for readers


def test_tables_show_what_the_record_holds():
    text = report_markdown(CASE6)
    assert "| rods | 147 | 147 |" in text
    assert "| porosity, % (Eq. 2.2) | 36.10 | 36.77 |" in text
    assert "| Face1 | Face2 | 49 | 49 | 49 | 0 | 0 |" in text
    assert "| network.step | 5.4 MB |" in text
    assert "All checks held." in text
    assert "Made with FreeCAD 0.20.2." in text


def test_every_line_of_a_table_has_as_many_columns_as_its_head():
    text = report_markdown(report_record(outcome_of(CASE1, warnings=("a | b",))))
    blocks = [block.splitlines() for block in text.split("\n\n") if block.startswith("|")]
    assert len(blocks) >= 7
    for lines in blocks:
        assert {line.replace("\\|", "").count("|") for line in lines} == {lines[0].count("|")}


def test_warnings_come_first():
    bodies = dataclasses.replace(BODIES, notes=("loose pieces are 2 % of the envelope",))
    outcome = outcome_of(CASE1, bodies=bodies, warnings=("3 pairs of pores overlap on face A",))
    text = report_markdown(report_record(outcome))
    assert "loose pieces are 2 %" in text
    assert text.index("3 pairs of pores") < text.index("| output |")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (0.0, "0.00000"),
        (1000.0, "1000.00"),
        (365.0141592, "365.014"),
        (0.0123456789, "0.0123457"),
        (-12.3456789, "-12.3457"),
        (1234567.89, "1234568"),
        (1.5e12, "1.50000e+12"),
        (1e-9, "1.00000e-09"),
    ],
)
def test_numbers_have_six_significant_digits(value, words):
    assert digits(value) == words
    assert float(words) == pytest.approx(value, rel=1e-5)


@pytest.mark.parametrize(
    ("size", "words"),
    [
        (0, "0 B"),
        (999, "999 B"),
        (1000, "1 kB"),
        (25_000_084, "25 MB"),
        (1_234_567, "1.235 MB"),
        (3 * 10**12, "3000 GB"),
    ],
)
def test_sizes_are_in_decimal_units(size, words):
    assert size_words(size) == words


def test_a_number_that_is_none_does_not_get_into_the_file():
    with pytest.raises(ValueError, match="JSON compliant"):
        report_json({"porosity": np.nan})
