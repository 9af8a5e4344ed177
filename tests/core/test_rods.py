# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods against cylinders, prisms, frusta and tori; their faults against constructed ones."""

import math

import numpy as np
import pytest

from freecad_trabecula.core import rods as r
from freecad_trabecula.core.laws import Region
from freecad_trabecula.core.parameters import PoreParameters, PrismParameters
from freecad_trabecula.core.paths import middle_paths, straight_paths
from freecad_trabecula.core.pores import Pores, circles, draw_pores, make_pores, mirrored
from freecad_trabecula.core.sites import prism_sites

CUBE = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))
UPRIGHT = np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1]])


def squares(sizes):
    count = len(sizes)
    return make_pores(PoreParameters(), np.array(sizes, float), np.full((count, 4), 0.5), np.zeros((count, 4)),
                      np.zeros((count, 4, 2)))  # fmt: skip


def ends(first, second, frame0=UPRIGHT, frame1=UPRIGHT, rolls=True):
    frames = np.stack([frame0, frame1])[None].repeat(len(first), 0)
    return r.RodEnds(frames, first, second, np.zeros(len(first)), rolls)


def upright(first, second, height=10.0, shift=(0.0, 0.0), count=9, points=16, **more):
    p0 = np.zeros((len(first), 3))
    return r.build_rods(
        straight_paths(p0, p0 + [shift[0], shift[1], height]), ends(first, second, **more), count, points
    )


def about_z(angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])


def closed(vertices, triangles):
    """True if every directed edge has its opposite, once."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return len(np.unique(edges, axis=0)) == len(edges) and {tuple(e) for e in edges} == {tuple(e[::-1]) for e in edges}


@pytest.mark.parametrize("shift", [(0.0, 0.0), (3.0, -2.0)])
def test_a_rod_of_one_section_has_area_times_height_at_any_slant(shift):
    circle = circles(np.array([0.5]))
    assert r.rod_volumes(upright(circle, circle, shift=shift)) == pytest.approx(math.pi / 16 * 10)


def test_a_rod_from_square_to_square_is_a_frustum():
    volume = r.rod_volumes(upright(squares([1.0]), squares([0.5]), count=33))[0]
    assert volume == pytest.approx(10 / 3 * (1 + 0.5 + 0.25), rel=2e-4)


def test_quarter_turns_of_the_second_section_are_taken_off():
    rods = upright(squares([1.0]), squares([1.0]), frame1=about_z(math.pi / 2))
    assert r.rod_volumes(rods)[0] == pytest.approx(10.0)
    rods = upright(squares([1.0]), squares([1.0]), frame1=about_z(math.pi / 2 + 0.3), count=65, points=64)
    # what is left, 0.3, is spread: a twisted prism keeps its section area
    assert r.rod_volumes(rods)[0] == pytest.approx(10.0, rel=2e-4)


def test_one_section_is_carried_along_without_a_roll():
    rods = upright(squares([1.0]), squares([0.2]), frame1=about_z(0.7), rolls=False)
    assert r.rod_volumes(rods)[0] == pytest.approx(10.0)


def test_planes_turn_evenly_from_end_to_end():
    down = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])  # n = -y
    circle = circles(np.array([0.4]))
    p0, p1 = np.array([[0.0, 0, 0]]), np.array([[0.0, -5.0, 5.0]])
    rods = r.build_rods(middle_paths(p0, np.array([[0, -1.5, 3.5]]), p1), ends(circle, circle, UPRIGHT, down), 9, 16)
    normals = rods.frames[0, :, 2]
    steps = np.arccos((normals[1:] * normals[:-1]).sum(1))
    assert steps == pytest.approx(np.full(8, math.pi / 16))
    assert np.allclose(rods.frames[0, -1, 2], [0, -1, 0])
    assert np.allclose(rods.frames @ rods.frames.transpose(0, 1, 3, 2), np.eye(3))


def test_a_bent_rod_of_constant_section_has_pappus_volume():
    # planes normal to a quarter circle of radius 5: area times arc length of the centroid
    c = 4 / 3 * math.tan(math.pi / 16) * 5
    angle = [0, math.pi / 8, math.pi / 4, 3 * math.pi / 8, math.pi / 2]
    point = [np.array([5 * math.cos(a), 0, 5 * math.sin(a)]) for a in angle]
    along = [np.array([-math.sin(a), 0, math.cos(a)]) for a in angle]
    c = 4 / 3 * math.tan(math.pi / 16) * 5
    path = np.array(
        [[[point[i], point[i] + c * along[i], point[i + 2] - c * along[i + 2], point[i + 2]] for i in (0, 2)]]
    )
    frames = np.array([[[1.0, 0, 0], [0, 1, 0], [0, 0, 1]], [[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]]])
    circle = circles(np.array([1.0]))
    rods = r.build_rods(path, r.RodEnds(frames[None], circle, circle, np.zeros(1)), 65, 64)
    assert r.rod_volumes(rods)[0] == pytest.approx(math.pi / 4 * 5 * math.pi / 2, rel=1e-3)
    assert not any(v.any() for v in r.rod_faults(rods).values())


def test_meshes_are_closed_and_outward_with_and_without_prolongation():
    circle = circles(np.array([0.5, 0.7]))
    rods = upright(circle, circle)
    for beyond in (0.0, 0.3):
        vertices, triangles = r.rod_mesh(rods, beyond)
        assert closed(vertices, triangles)
        a, b, c = (vertices[:, triangles[:, i]] for i in range(3))
        volume = np.einsum("rti,rti->r", a, np.cross(b, c)) / 6
        assert volume == pytest.approx(math.pi / 4 * circle.size**2 * (10 + 2 * beyond))


def test_prolongation_is_measured_across_the_end_planes():
    circle = circles(np.array([0.5]))
    vertices, _ = r.rod_mesh(upright(circle, circle, shift=(6.0, 0.0)), 0.2)
    assert vertices[..., 2].min() == pytest.approx(-0.2) and vertices[..., 2].max() == pytest.approx(10.2)


def test_random_pores_give_a_rod_with_the_mean_of_their_areas_to_first_order():
    sites = prism_sites(PrismParameters())["Face5"]
    pores = draw_pores(PoreParameters(), 1, sites, CUBE)
    volumes = r.rod_volumes(upright(pores, pores, count=17, points=32))
    assert volumes == pytest.approx(pores.areas * 10, rel=1e-9)
    assert r.rod_volumes(upright(mirrored(pores), pores)).sum() < pores.areas.sum() * 10 * 1.02


def test_a_flat_rod_is_found():
    circle = circles(np.array([0.2, 0.2]))
    p0, p1 = np.zeros((2, 3)), np.array([[10.0, 0, 3.0], [10.0, 0, 3.3]])
    faults = r.rod_faults(r.build_rods(straight_paths(p0, p1), ends(circle, circle), 9, 16))
    slope = [3 / math.hypot(10, 3), 3.3 / math.hypot(10, 3.3)]
    assert slope[0] < r.FLAT < slope[1]
    assert faults["flat"].tolist() == [True, False]


def test_crossing_section_planes_are_found():
    # planes 90 degrees apart over a chord shorter than the section is wide cross inside the rod
    down = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    circle = circles(np.array([2.0, 0.2]))
    p0, p1 = np.zeros((2, 3)), np.array([[0.0, -1.0, 1.0]] * 2)
    paths = middle_paths(p0, np.array([[0.0, -0.3, 0.7]] * 2), p1)
    frames = np.stack([UPRIGHT, down])[None].repeat(2, 0)
    faults = r.rod_faults(r.build_rods(paths, r.RodEnds(frames, circle, circle, np.zeros(2)), 17, 16))
    assert faults["crossing"].tolist() == [True, False]


def test_a_section_that_crosses_itself_is_found():
    eight = Pores(np.ones(1), np.array([[[-1.0, -1], [1, 1], [1, -1], [-1, 1]]]), np.zeros((1, 4)), np.zeros((1, 4)))
    assert r.rod_faults(upright(eight, eight))["loop"].all()


@pytest.mark.parametrize("deflection", [0.05, 0.01, 0.002])
def test_triangles_stay_within_the_deflection(deflection):
    _, m = r.tessellation(0.5, deflection, 5.0)
    radius = 0.68 * 0.5
    assert radius * (1 - math.cos(math.pi / m)) <= deflection * 1.0001


def test_finer_deflection_gives_more_triangles_within_bounds():
    coarse, fine = r.tessellation(0.5, 0.05, 5.0), r.tessellation(0.5, 1e-6, 5.0)
    assert coarse < fine <= (65, 64)


def test_no_rod_gives_no_triangle():
    none = circles(np.zeros(0))
    rods = r.build_rods(np.zeros((0, 2, 4, 3)), r.RodEnds(np.zeros((0, 2, 3, 3)), none, none, np.zeros(0)), 5, 16)
    assert r.rod_triangles(rods).shape == (0, 3, 3)
