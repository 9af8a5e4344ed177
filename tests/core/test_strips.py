# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strips against cylinders, frusta, the paths themselves, and the volumes of triangles."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.laws import Region
from freecad_trabecula.core.paths import middle_paths, straight_paths, tension_paths
from freecad_trabecula.core.pores import circles
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rods import RodEnds, true_volumes
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.strips import rod_strips, ruled, straight, strip_volumes

CUBE = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))
UPRIGHT = np.eye(3)


def round_ends(first, second):
    frames = np.tile(UPRIGHT, (len(first), 2, 1, 1))
    return RodEnds(frames, circles(np.array(first)), circles(np.array(second)), np.zeros(len(first)))


def upright_paths(count, height=10.0):
    start = np.zeros((count, 3))
    return straight_paths(start, start + [0.0, 0.0, height])


def case(name, seed=1):
    job = preset(name)
    return make_wireframe(job.wireframe, prism_sites(job.prism), CUBE)


def centre_line(strips, steps=9):
    """Means of the corners at even parameters of each patch."""
    t = np.linspace(0, 1, steps)
    weight = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], 1)
    return np.einsum("tb,rmsbx->rstmx", weight, strips.patches[:, :, :, 0]).mean(3)


def test_a_round_rod_has_the_volume_of_a_cylinder():
    strips = rod_strips(upright_paths(2), round_ends([0.5, 0.8], [0.5, 0.8]), 2)
    np.testing.assert_allclose(strip_volumes(strips), 10 * math.pi / 4 * np.array([0.5, 0.8]) ** 2, rtol=1e-12)


def test_a_rod_from_circle_to_circle_has_the_volume_of_a_frustum():
    strips = rod_strips(upright_paths(1), round_ends([0.4], [0.8]), 1)
    r, s = 0.2, 0.4
    np.testing.assert_allclose(strip_volumes(strips), [math.pi * 10 / 3 * (r * r + r * s + s * s)], rtol=1e-12)


@pytest.mark.parametrize("halves", [1, 2, 4])
def test_the_centre_line_is_the_path_whatever_the_number_of_patches(halves):
    path = middle_paths(np.array([[0.0, 0, 0]]), np.array([[2.0, 1, 3]]), np.array([[4.0, 1, 10]]))
    strips = rod_strips(path, round_ends([0.3], [0.3]), halves)
    t = np.linspace(0, 1, halves * 8 + 1)[:, None]
    for piece in (0, 1):
        a, b, c, d = path[0, piece]
        exact = (1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t**2 * (1 - t) * c + t**3 * d
        line = centre_line(strips)[0, piece * halves : (piece + 1) * halves]
        np.testing.assert_allclose(line, [exact[8 * k : 8 * k + 9] for k in range(halves)], atol=1e-12)


def test_a_path_that_bends_between_its_pieces_is_followed_too():
    up, out = np.array([[0.0, 0, 1]]), np.array([[1.0, 0, 0]])
    path = tension_paths(np.zeros((1, 3)), up, np.array([[5.0, 0, 5]]), out, np.array([3.0]), np.array([8.0]))
    strips = rod_strips(path, round_ends([0.3], [0.3]), 2)
    np.testing.assert_allclose(centre_line(strips)[0, 2, 0], path[0, 1, 0], atol=1e-12)
    np.testing.assert_allclose(centre_line(strips)[0, -1, -1], path[0, 1, 3], atol=1e-12)


def test_patches_meet_with_one_tangent():
    wireframe = case("case6")
    strips = rod_strips(wireframe.paths, wireframe.ends, 2)
    p, width = strips.patches, np.diff(strips.knots)[:, None, :, None, None]
    np.testing.assert_allclose(p[:, :, :-1, :, 3], p[:, :, 1:, :, 0], atol=1e-12)
    before, after = (p[:, :, :, :, 3] - p[:, :, :, :, 2]) / width, (p[:, :, :, :, 1] - p[:, :, :, :, 0]) / width
    np.testing.assert_allclose(before[:, :, :-1], after[:, :, 1:], atol=1e-9)


def test_neighbouring_strips_share_their_border():
    wireframe = case("case4")
    p = rod_strips(wireframe.paths, wireframe.ends, 1).patches
    np.testing.assert_array_equal(p[:, :, :, 3], np.roll(p, -1, 1)[:, :, :, 0])


@pytest.mark.parametrize(("name", "halves", "tolerance"), [("case4", 1, 1e-4), ("case5", 2, 5e-4), ("case6", 2, 1e-3),
                                                           ("case6", 4, 1e-4)])  # fmt: skip
def test_volumes_are_those_that_triangles_tend_to(name, halves, tolerance):
    wireframe = case(name)
    volumes = strip_volumes(rod_strips(wireframe.paths, wireframe.ends, halves))
    np.testing.assert_allclose(volumes, true_volumes(wireframe.paths, wireframe.ends), rtol=tolerance)


def test_prolonged_rods_end_in_planes_along_their_end_planes():
    wireframe = case("case6")
    plain = rod_strips(wireframe.paths, wireframe.ends, 2)
    longer = rod_strips(wireframe.paths, wireframe.ends, 2, 0.05)
    np.testing.assert_array_equal(longer.caps[:, :, 1:], plain.caps[:, :, 1:])
    rise = ((longer.caps[:, :, 0] - plain.caps[:, :, 0]) * plain.caps[:, :, 1]).sum(-1)
    np.testing.assert_allclose(rise, np.tile([-0.05, 0.05], (len(rise), 1)), atol=1e-4)
    for end, span in ((0, 0), (1, -1)):
        ring = longer.patches[:, :, span, :, 3 * end] - longer.caps[:, None, None, end, 0]
        np.testing.assert_allclose(np.einsum("rmax,rx->rma", ring, longer.caps[:, end, 1]), 0, atol=1e-12)


def test_each_end_may_reach_out_by_a_distance_of_its_own():
    strips = rod_strips(upright_paths(1), round_ends([0.5], [0.5]), 1, np.array([[0.1, 0.3]]))
    np.testing.assert_allclose(strip_volumes(strips), [math.pi / 4 * 0.25 * 10.4], rtol=1e-12)


def test_straight_rods_of_one_section_are_ruled_and_others_are_not():
    flags = [ruled(rod_strips(w.paths, w.ends, 2)).all() for w in (case("case2"), case("case3"), case("case4"))]
    assert flags == [True, True, False]


def test_straight_paths_are_told_from_bent_ones():
    bent = middle_paths(np.zeros((1, 3)), np.array([[0.1, 0, 5]]), np.array([[0.0, 0, 10]]))
    assert straight(np.concatenate([upright_paths(1), bent])).tolist() == [True, False]
