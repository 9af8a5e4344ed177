# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said before the work: sizes are those of the files, times those that were measured, more work takes longer.

The measured seconds were taken by ``tools/estimates.py``; no test here looks at a clock.
"""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest

from freecad_trabecula.core import engines, estimates
from freecad_trabecula.core.analysis.analysis import analyse, contours_of
from freecad_trabecula.core.analysis.branches import trace_branches
from freecad_trabecula.core.analysis.cli_layers import write_cli
from freecad_trabecula.core.analysis.folder import save_analysis
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.ssl import write_ssl
from freecad_trabecula.core.analysis.svg_layers import write_svg
from freecad_trabecula.core.analysis.triangles import soup_of
from freecad_trabecula.core.analysis.workbook import write_workbook
from freecad_trabecula.core.estimates import Body, Work
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.design import Estimate
from freecad_trabecula.core.voxels.smooth_surface import smooth_surface

THICKNESS = 0.1
#: Of bones: triangles, box, volume, surface; planes an axis; morphometry; CPU seconds that the analysis took.
MEASURED = (
    (11620, 1.17, 0.671, 8.25, 30, False, 0.10),
    (258470, 10.07, 193.3, 2607.0, 100, False, 1.89),
    (258470, 10.07, 193.3, 2607.0, 1000, False, 4.14),
    (2067760, 10.07, 193.3, 2607.0, 100, False, 15.6),
    (154298, 10.0, 289.3, 808.0, 100, True, 4.64),
    (258470, 10.07, 193.3, 2607.0, 100, True, 13.6),
)
#: Planes an axis, contours an axis, share of the box; CPU seconds that their branches took, all three axes.
BRANCHES = ((30, 59, 0.42, 0.021), (100, 508, 0.29, 0.385), (97, 8436, 0.19, 1.52), (968, 83260, 0.19, 257.0))


#: Of designs: rods, faulty ones, triangles of the rods, seconds that the mesh engine says; CPU seconds that rods,
#: solids and scaffold took.
DESIGNS = (
    (75, 0, 19800, 0.35, 1.60),
    (147, 0, 38808, 1.23, 4.33),
    (147, 2, 67032, 1.97, 5.58),
    (188, 96, 121824, 3.63, 19.4),
    (399, 141, 306432, 11.76, 45.3),
)


@pytest.fixture(scope="module")
def sponge():
    """A smooth sponge of 6 x 5 x 4 mm, half of it solid."""
    noise = Stream(5, "sponge").uniform(60 * 50 * 40).reshape(40, 50, 60)
    for axis in (0, 1, 2):
        for _ in range(3):
            noise = sum(np.roll(noise, k, axis) for k in (-2, -1, 0, 1, 2))
    return smooth_surface(noise > np.median(noise), (0.1, 0.1, 0.1), (-3.0, 8.0, 0.0)).mesh


@pytest.fixture(scope="module")
def sliced(sponge):
    """Body, analysis, contours and branches by axis."""
    soup, parameters = soup_of(sponge, "sponge"), SliceParameters(thickness=THICKNESS)
    analysis = analyse(soup, parameters, morphometry=False)
    contours = {axis: contours_of(soup, parameters, axis)[0] for axis in "xyz"}
    branches = {axis: trace_branches(contours[axis], analysis.measures[axis]) for axis in "xyz"}
    return estimates.body_of(soup.triangles), analysis, contours, branches


def planes(body):
    return list(estimates.planes_of(SliceParameters(thickness=THICKNESS), body.box).values())


def counts(analysis):
    return [(len(one), int(one.contours.sum())) for one in analysis.profiles.values()]


# ------------------------------------------------------------------------------------------------------- the bodies


def test_volume_and_surface_of_a_box_are_known_wherever_it_lies(box):
    body = estimates.body_of(box((7, 8, 9), (8, 10, 12)))
    assert (body.triangles, body.volume, body.surface) == (12, pytest.approx(6), pytest.approx(22))
    assert body.thickness == pytest.approx(12 / 22) and body.room == pytest.approx(6)
    assert body.box.tolist() == [[7, 8, 9], [8, 10, 12]]


def test_a_body_in_another_unit_is_the_same_body():
    body = Body(10, np.array([[0.0, 0, 0], [1, 2, 3]]), 6.0, 22.0).scaled(10.0)
    assert (body.size, body.volume, body.surface) == (30.0, 6000.0, 2200.0)


def test_planes_are_those_that_the_analysis_has(sponge):
    soup = soup_of(sponge)
    for parameters in (
        SliceParameters(thickness=0.3),
        SliceParameters(thickness=0.25, axes=("y", "0.6,0,0.8"), at="bottom"),
        SliceParameters(thickness=0.2, axes=("z",), low=1.0, high=2.5),
        SliceParameters(at="heights", heights=(0.5, 1.0, 1.2), axes=("z",)),
    ):
        found = analyse(soup, parameters, morphometry=False).profiles
        said = estimates.planes_of(parameters, soup.box)
        for axis, profile in found.items():
            # along a direction the body's box is larger than the body
            assert len(profile) == said[axis][0] if axis in "xyz" else len(profile) <= said[axis][0]


def test_a_ball_and_a_torus_get_the_triangles_that_were_counted():
    ball = estimates.triangles_of_solid(4 / 3 * np.pi * 125, 100 * np.pi, 100 * np.pi, 1)
    torus = estimates.triangles_of_solid(2 * np.pi**2 * 5 * 4, 4 * np.pi**2 * 10, 4 * np.pi**2 * 10, 1)
    assert ball == pytest.approx(3518, rel=0.15) and torus == pytest.approx(8060, rel=0.15)
    assert estimates.triangles_of_solid(6.0, 22.0, 0.0, 6) < 200  # a box has 12


# -------------------------------------------------------------------------------------------- slices, sizes of files


def test_segments_and_contours_are_nearly_those_that_are_cut(sliced):
    body, analysis, contours, _ = sliced
    points = sum(len(one.points) for one in contours.values())
    assert estimates.segments(body, planes(body)) == pytest.approx(points, rel=0.15)
    assert 0.5 < estimates.contours(body, planes(body)) / sum(count for _, count in counts(analysis)) < 2


@pytest.mark.parametrize("kind", ["ssl", "cli", "svg"])
def test_layer_files_are_as_large_as_said_to_a_few_per_cent(kind, tmp_path, sliced):
    body, analysis, contours, _ = sliced
    size = 0
    for axis, one in contours.items():
        path = tmp_path / f"{axis}.{kind}"
        if kind == "svg":
            write_svg(path, one)
        else:
            {"ssl": write_ssl, "cli": write_cli}[kind](path, one, THICKNESS)
        size += path.stat().st_size
    points, count = sum(len(one.points) for one in contours.values()), sum(c for _, c in counts(analysis))
    number = sum(n for n, _ in counts(analysis))
    assert estimates.layers_work(kind, points, count, number, body.box).files == pytest.approx(size, rel=0.04)
    early = estimates.segments(body, planes(body)), estimates.contours(body, planes(body))
    assert estimates.layers_work(kind, *early, number, body.box).files == pytest.approx(size, rel=0.2)


def test_the_folder_of_an_analysis_is_as_large_as_said_to_a_few_per_cent(tmp_path, sliced):
    _, analysis, _, branches = sliced
    save_analysis(analysis, tmp_path, branches=branches)
    size = sum(path.stat().st_size for path in tmp_path.iterdir())
    assert estimates.saving_work(counts(analysis), 0.5, plots=False).files == pytest.approx(size, rel=0.06)


@pytest.mark.skipif(importlib.util.find_spec("openpyxl") is None, reason="openpyxl is not installed")
def test_the_workbook_is_as_large_as_said_to_a_few_per_cent(tmp_path, sliced):
    _, analysis, _, _ = sliced
    write_workbook(tmp_path / "a.xlsx", analysis.profiles, analysis.measures)
    said = estimates.workbook_work(counts(analysis)).files
    assert said == pytest.approx((tmp_path / "a.xlsx").stat().st_size, rel=0.15)


# --------------------------------------------------------------------------------------------------------- the times


@pytest.mark.parametrize("count, side, volume, surface, number, morphometry, seconds", MEASURED)
def test_the_times_that_were_measured_are_said_within_a_half(
    count, side, volume, surface, number, morphometry, seconds
):
    body = Body(count, np.array([[0.0] * 3, [side] * 3]), volume, surface)
    said = estimates.analysis_work(body, [(number, side)] * 3, morphometry).seconds
    assert 1 / 1.5 < said / seconds < 1.5


@pytest.mark.parametrize("number, count, share, seconds", BRANCHES)
def test_branches_take_what_they_were_measured_to(number, count, share, seconds):
    assert 1 / 1.5 < 3 * estimates.branches_seconds(number, count, share) / seconds < 1.5


@pytest.mark.parametrize("rods, faulty, triangles, engine, seconds", DESIGNS)
def test_designs_take_what_they_were_measured_to(rods, faulty, triangles, engine, seconds):
    scaffold = estimates.scaffold_work(engines.Estimate("mesh", engine, 0.0, ""))
    parts = (estimates.design_work(rods, faulty), estimates.network_work(triangles), scaffold)
    assert 1 / 1.5 < sum(part.seconds for part in parts) / seconds < 1.5


def test_memory_is_that_of_the_engine_and_of_the_voxels_and_what_any_such_work_needs():
    engine = engines.Estimate("field", 1.0, 3e8, "")
    assert 3e8 < estimates.scaffold_work(engine).memory < 4e8
    design = Estimate((100, 100, 100), 10**6, 0.134, 1.0)
    for work in (estimates.voxel_work(design), estimates.voxel_variant_work(design)):
        assert work.memory == pytest.approx(1.34e8)
    assert estimates.network_work(2000).memory - estimates.network_work(1000).memory == pytest.approx(
        estimates.network_work(1000).memory - estimates.network_work(0).memory
    )
    assert 0 < estimates.analysis_work(Body(12, np.zeros((2, 3)), 1.0, 6.0), [(1, 1.0)]).memory < estimates.HEAVY[1]


def test_more_triangles_planes_and_measures_take_longer_and_never_less_memory():
    box, one = np.array([[0.0] * 3, [10.0] * 3]), [(100, 10.0)] * 3
    works = [
        estimates.analysis_work(Body(100_000, box, 200.0, 2000.0), one),
        estimates.analysis_work(Body(200_000, box, 200.0, 2000.0), one),
        estimates.analysis_work(Body(200_000, box, 200.0, 2000.0), [(300, 10.0)] * 3),
        estimates.analysis_work(Body(200_000, box, 200.0, 2000.0), [(300, 10.0)] * 3, True),
    ]
    assert all(a.seconds < b.seconds and a.memory <= b.memory for a, b in zip(works, works[1:]))
    few, many = (estimates.saving_work([(100, count)] * 3, 0.2) for count in (1000, 10_000))
    assert few.seconds < many.seconds and few.files < many.files
    assert estimates.saving_work([(100, 1000)] * 3, 0.2, plots=False).seconds < few.seconds
    assert estimates.comparison_work(1000, 3).seconds < estimates.comparison_work(1000, 3, plots=True).seconds
    assert estimates.rod_variant_work(100, 0).seconds < estimates.rod_variant_work(100, 20).seconds
    designs = [Estimate((n, n, n), n**3, 0.1, n**3 / 1e6) for n in (50, 100)]
    assert estimates.voxel_variant_work(designs[0]).seconds < estimates.voxel_variant_work(designs[1]).seconds


def test_only_heavy_work_must_be_said_and_two_digits_are_enough():
    assert [Work(*one).is_heavy for one in ((4.9, 4e7, 4e7), (5.1,), (0.1, 6e7), (0.1, 0.0, 6e7))] == [
        False, True, True, True
    ]  # fmt: skip
    assert Work(0.4, 0.0, 1.234e8).words == "less than 1 s, 120 MB of files"
    assert Work(10.0, 5e8).times(3) == Work(30.0, 5e8)
    both = Work(10.0, 5e8, 1e6).and_then(Work(20.0, 1e8, 2e6))
    assert both == Work(30.0, 5e8, 3e6)
