# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recovery: faults are found, mended by the remedy that fits, counted; rods outside are steered or named."""

import dataclasses

import numpy as np
import pytest

from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.job import with_seed
from freecad_trabecula.core.laws import Region, uniform
from freecad_trabecula.core.parameters import Coupling, PathParameters, PoreParameters, PrismParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.recovery import REMEDIES, find_faults
from freecad_trabecula.core.rods import rod_faults
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.wireframe import WireframeParameters, skin

CUBE = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))
SITES = prism_sites(PrismParameters())


def case6(seed, **changes):
    return with_seed(dataclasses.replace(preset("case6"), **changes), seed).wireframe


def test_flat_rods_of_case_6_are_mended_by_another_middle_point():
    mended = 0
    for seed in range(1, 6):
        made = make_wireframe(case6(seed), SITES, CUBE)
        assert made.failed == ()
        assert {(x.fault, x.remedy) for x in made.recoveries} <= {("flat", "middle")}
        assert all(1 <= x.attempts <= 10 for x in made.recoveries)
        assert not (find_faults(made, case6(seed), None) > 0).any()
        mended += len(made.recoveries)
    assert 5 <= mended <= 20  # 30 in ten seeds of an independent prototype


def test_sound_rods_are_left_as_they_were():
    job = case6(1)
    raw = dataclasses.replace(job, rods=dataclasses.replace(job.rods, redraws=0))
    with_middle, with_tension = (make_wireframe(p, SITES, CUBE) for p in (job, raw))
    touched = {x.rod for x in with_middle.recoveries}
    assert touched and touched == {x.rod for x in with_tension.recoveries}
    for name, a, b in zip(with_middle.names, with_middle.keys(), with_tension.keys()):
        assert (a != b) == (name in touched)


def test_without_redraws_the_path_along_the_normals_mends():
    job = case6(1)
    made = make_wireframe(dataclasses.replace(job, rods=dataclasses.replace(job.rods, redraws=0)), SITES, CUBE)
    assert {x.remedy for x in made.recoveries} == {"tension"} and made.failed == ()
    assert not any(v.any() for v in rod_faults(skin(made, job.rods)).values())


def test_faces_at_right_angles_are_joined_without_a_fault():
    # in an independent prototype 49 of 196 such rods are faulty before mending; tension mends 45, the middle point 44
    couplings = (Coupling("Face1", "Face3"), Coupling("Face2", "Face5"), Coupling("Face4", "Face6"))
    job = WireframeParameters(couplings=couplings, seed=1)
    made = make_wireframe(job, SITES, CUBE)
    assert len(made) + len(made.failed) == 147
    assert made.failed == ()
    assert not any(v.any() for v in rod_faults(skin(made, job.rods, stations=17)).values())


def test_flat_straight_rods_that_nothing_mends_are_named_and_left_out():
    # a 1 mm thin plate: straight rods between far sites are flat, and a straight path has no remedy
    prism = PrismParameters(l=20, w=20, h=1, n_x=5, n_y=5, n_z=2, a_z=0.2)
    region = Region((0, 0, 0), (20, 20, 1), (10, 10, 0.5))
    job = WireframeParameters(path=PathParameters("straight"), couplings=(Coupling("Face5", "Face6"),), seed=1)
    made = make_wireframe(job, prism_sites(prism), region)
    assert len(made.failed) > 10 and len(made) + len(made.failed) == 25
    assert {x.rod for x in made.recoveries if x.remedy == "none"} == set(made.failed)
    assert not set(made.failed) & set(made.names)


def test_rods_that_leave_the_envelope_are_steered_back():
    # an envelope with a bite: the box but for the part beyond x + y > 14 in the middle half of its height
    def contains(points):
        box = ((points >= 0) & (points <= 10)).all(1)
        bite = (points[:, 0] + points[:, 1] > 14) & (np.abs(points[:, 2] - 5) < 2.5)
        return box & ~bite

    path = PathParameters("box", points=((7.0, 7.0, 5.0),), box=(4.0, 4.0, 4.0))
    job = WireframeParameters(
        pores=PoreParameters(size=uniform(0.2, 0.4)), path=path, couplings=(Coupling("Face5", "Face6"),), seed=1
    )
    free, made = make_wireframe(job, SITES, CUBE), make_wireframe(job, SITES, CUBE, contains)
    bad_before = int((find_faults(free, job, contains) == 4).sum())
    still = np.nonzero(find_faults(made, job, contains) == 4)[0]
    assert bad_before > 10
    assert len(still) < bad_before / 2
    assert tuple(made.names[k] for k in still) == made.outside
    assert len(made) == 49  # a rod that stays outside is reported, not lost


def test_nothing_is_steered_where_nothing_leaves():
    inside = make_wireframe(case6(3), SITES, CUBE, lambda p: ((p >= 0) & (p <= 10)).all(1))
    assert inside.keys() == make_wireframe(case6(3), SITES, CUBE).keys()


@pytest.mark.parametrize("fault", sorted(REMEDIES))
def test_the_last_remedies_are_always_the_path_along_the_normals(fault):
    assert REMEDIES[fault][-2:] == ("tension", "carry")
    assert fault == "loop" or REMEDIES[fault][0] != "tangents"
