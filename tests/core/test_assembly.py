# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe of whole designs: rods of the presets, local randomness, laws, orthogonal feet."""

import dataclasses

import numpy as np
import pytest

from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.job import opposite_couplings, with_seed
from freecad_trabecula.core.laws import Law, Region
from freecad_trabecula.core.parameters import Coupling, PathParameters, PrismParameters, SiteEdit
from freecad_trabecula.core.presets import PRESETS, THESIS, preset
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.wireframe import WireframeParameters, rows_of_rods, skin, without
from freecad_trabecula.errors import ParameterError

PRISMS = [name for name in PRESETS if preset(name).prism is not None]


def region(prism):
    high = (prism.l, prism.w, prism.h)
    return Region((0.0, 0.0, 0.0), high, tuple(v / 2 for v in high))


def wireframe(job):
    return make_wireframe(job.wireframe, prism_sites(job.prism), region(job.prism))


@pytest.mark.parametrize("name", PRISMS)
def test_presets_have_the_thesis_number_of_rods_and_none_fails(name):
    for seed in (1, 2, 3):
        made = wireframe(with_seed(preset(name), seed))
        assert len(made) == THESIS[name].rods
        assert made.failed == () and made.outside == ()


def test_same_seed_same_rods_and_another_seed_others():
    first, again, other = (wireframe(with_seed(preset("case6"), s)) for s in (5, 5, 6))
    assert first.keys() == again.keys()
    assert not set(first.keys()) & set(other.keys())


def test_another_coupling_never_reshuffles_the_rods_of_the_first():
    job = preset("case6")
    alone = wireframe(dataclasses.replace(job, couplings=job.couplings[:1]))
    assert set(alone.keys()) <= set(wireframe(job).keys())


def test_a_changed_pore_touches_its_own_rods_only():
    job = preset("case6")
    before = wireframe(job)
    site = before.names[10].split("-")[0]
    after = wireframe(dataclasses.replace(job, edits=(SiteEdit(site, "pore", size=0.31),)))
    changed = [a for a, x, y in zip(before.names, before.keys(), after.keys()) if x != y]
    assert changed == [before.names[10]]


def test_orthogonal_paths_are_normal_to_their_faces():
    made = wireframe(preset("case1"))
    along = made.paths[:, 1, 3] - made.paths[:, 0, 0]
    assert np.allclose(np.abs(along).max(1), 10) and np.allclose(np.sort(np.abs(along), 1)[:, :2], 0)


def test_centre_paths_meet_in_the_centre():
    assert np.allclose(wireframe(preset("case5")).paths[:, 0, 3], 5.0)


def test_middle_points_fill_their_box_and_no_more():
    middle = wireframe(preset("case6")).paths[:, 0, 3] - 5
    assert np.abs(middle).max() <= 2
    assert (middle.min(0) < -1.8).all() and (middle.max(0) > 1.8).all()


def test_each_rod_takes_one_of_several_convergence_points():
    points = ((3.0, 3.0, 3.0), (7.0, 7.0, 7.0))
    job = preset("case5")
    made = wireframe(dataclasses.replace(job, path=PathParameters("centre", points=points)))
    counts = [int(np.isclose(made.paths[:, 0, 3], p).all(1).sum()) for p in points]
    on_normals = sum(x.remedy in ("tension", "carry") for x in made.recoveries)
    assert sum(counts) == 147 - on_normals and min(counts) > 45
    made = wireframe(dataclasses.replace(job, path=PathParameters("centre", points=points, choice="nearest")))
    half_way = (made.paths[:, 0, 0] + made.paths[:, 1, 3]) / 2
    nearest = np.linalg.norm(half_way[:, None] - np.array(points), axis=2).argmin(1)
    as_drawn = ~np.isin(made.names, [x.rod for x in made.recoveries])
    assert np.allclose(made.paths[as_drawn, 0, 3], np.array(points)[nearest][as_drawn])


def test_a_coupling_may_have_a_path_of_its_own():
    job = preset("case5")
    own = dataclasses.replace(job.couplings[1], path=PathParameters("straight"))
    made = wireframe(dataclasses.replace(job, couplings=(job.couplings[0], own, job.couplings[2])))
    straight = np.abs(
        np.cross(made.paths[:, 1, 3] - made.paths[:, 0, 0], made.paths[:, 0, 3] - made.paths[:, 0, 0])
    ).max(1)
    assert (straight[made.coupling == 1] < 1e-9).all()
    assert np.allclose(made.paths[made.coupling != 1, 0, 3], 5.0)


def test_tension_paths_leave_along_the_normals():
    job = dataclasses.replace(preset("case6"), path=PathParameters("tension"))
    made = wireframe(job)
    leaving = made.paths[:, 0, 1] - made.paths[:, 0, 0]
    assert np.allclose(np.cross(leaving, made.ends.frames[:, 0, 2]), 0)


def test_a_linear_law_makes_pores_grow_along_z():
    job = preset("case1")
    graded = dataclasses.replace(job.pores, size=Law("linear", 0.2, 0.8))
    made = wireframe(dataclasses.replace(job, pores=graded))
    for face in ("Face1", "Face3"):
        sizes, z = made.pores[face].size, made.sites[face].points[:, 2]
        assert sizes == pytest.approx(0.2 + 0.06 * z)


def test_rods_of_one_section_have_the_first_pore_at_both_ends():
    made = wireframe(preset("case3"))
    rods = skin(made, preset("case3").rods)
    local = [rods.rings[:, k] - rods.stations.centres[:, k, None] for k in (0, -1)]
    assert np.allclose(local[0], local[1])


def test_rods_begin_and_end_in_the_pores_of_their_sites():
    made = wireframe(preset("case4"))
    rods = skin(made, preset("case4").rods, stations=9)
    for end, k in ((0, 0), (1, -1)):
        size = (made.ends.first, made.ends.second)[end].size
        for rod in (0, 60, 146):
            face = made.names[rod].split("-")[end].split(".")[0]
            site = made.sites[face].points[made.site_numbers[rod, end]]
            assert np.allclose(rods.stations.centres[rod, k], site)
            assert made.pores[face].size[made.site_numbers[rod, end]] == size[rod]


def test_no_coupling_gives_an_empty_wireframe():
    made = make_wireframe(WireframeParameters(), prism_sites(PrismParameters()), region(PrismParameters()))
    assert len(made) == 0 and made.keys() == []


def test_a_coupling_of_a_face_that_is_not_there_is_refused():
    with pytest.raises(ParameterError, match="got 'Face9'"):
        make_wireframe(
            WireframeParameters(couplings=(Coupling("Face1", "Face9"),)), prism_sites(PrismParameters()),
            region(PrismParameters()),
        )  # fmt: skip
    with pytest.raises(ParameterError, match="seed"):
        WireframeParameters(couplings=opposite_couplings("random"), seed=-3)


def test_each_rod_finds_its_row_also_beside_couplings_that_are_off_or_made_no_rod():
    prism = PrismParameters()
    pairs = (Coupling("Face1", "Face2", on=False), Coupling("Face3", "Face4"), Coupling("Face3", "Face4"),
             Coupling("Face5", "Face6"))  # fmt: skip
    made = make_wireframe(WireframeParameters(couplings=pairs), prism_sites(prism), region(prism))
    assert [row.rods > 0 for row in made.rows] == [True, False, True]  # the second has used up the third's sites
    rows = rows_of_rods(made)
    faces = [{name.split(".")[0] for name in one.split("-")} for one in made.names]
    assert [{made.rows[k].first, made.rows[k].second} for k in rows.tolist()] == faces
    lost = without(made, np.flatnonzero(rows == 0))  # no rod of the last coupling is left
    assert set(rows_of_rods(lost).tolist()) == {-1}
