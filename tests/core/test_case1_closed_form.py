# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 1 against the volumes of crossing cylinders, worked out without a mesh (tools/closed_forms.py)."""

import dataclasses
import importlib.util
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.job import with_seed
from freecad_trabecula.core.laws import Region
from freecad_trabecula.core.parameters import RodParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rays import union_volume
from freecad_trabecula.core.rods import rod_triangles, rod_volumes
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.wireframe import skin

ROOT = Path(__file__).resolve().parents[2]
SPECIFICATION = importlib.util.spec_from_file_location("closed_forms", ROOT / "tools" / "closed_forms.py")
closed_forms = importlib.util.module_from_spec(SPECIFICATION)
SPECIFICATION.loader.exec_module(closed_forms)
CUBE = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))


def test_two_equal_cylinders_have_the_volume_of_archimedes():
    assert closed_forms.two_cylinders(1.5, 1.5) == pytest.approx(16 / 3 * 1.5**3, rel=1e-9)


def test_three_equal_cylinders_have_the_known_volume():
    assert closed_forms.three_cylinders(1.0, 1.0, 1.0) == pytest.approx(8 * (2 - 2**0.5), rel=1e-9)


def test_a_thin_cylinder_through_a_thick_one_is_cut_to_a_rod():
    # a -> 0: the common part is the thin cylinder between the thick one's walls, 2 b long
    assert closed_forms.two_cylinders(0.01, 1.0) == pytest.approx(np.pi * 1e-4 * 2, rel=1e-4)
    assert closed_forms.three_cylinders(0.01, 1.0, 5.0) == pytest.approx(np.pi * 1e-4 * 2, rel=1e-4)


def test_three_cylinders_agree_with_chance():
    points = np.random.default_rng(1).uniform(-0.4, 0.4, (400_000, 3)) ** 2
    x, y, z = points.T
    a, b, c = 0.4, 0.25, 0.31
    share = ((y + z <= a * a) & (x + z <= b * b) & (x + y <= c * c)).mean()
    error = 0.8**3 * (share * (1 - share) / len(points)) ** 0.5
    assert closed_forms.three_cylinders(a, b, c) == pytest.approx(share * 0.8**3, abs=4 * error)


def test_expected_sum_of_case_1_is_75_circles_of_mean_square_0_28():
    total, union = closed_forms.expected_case1_volumes()
    assert total == pytest.approx(75 * np.pi / 4 * 0.28 * 10)
    assert union < total


def test_rods_of_case_1_have_the_closed_forms_volumes():
    job = with_seed(dataclasses.replace(preset("case1"), rods=RodParameters(deflection=0.002)), 4)
    made = make_wireframe(job.wireframe, prism_sites(job.prism), CUBE)
    rods = skin(made, job.rods)
    sizes = [made.pores[face].size.reshape(5, 5) for face in ("Face1", "Face3", "Face5")]
    total, union = closed_forms.case1_volumes(sizes[0], sizes[1].T, sizes[2])
    assert rod_volumes(rods).sum() == pytest.approx(total, rel=1e-9)
    # rays along the rods' own axes are the worst case: every ray along a wall counts whole or not at all
    measured = union_volume(rod_triangles(rods, 0.05), (0.0,) * 3, (10.0,) * 3, 400, 0)
    assert measured.error < 0.002 * union
    assert measured.volume == pytest.approx(union, abs=4 * measured.error)
