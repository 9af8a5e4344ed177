# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles to voxels: inside is where the centre is inside, on boxes, balls, overlapping and open meshes."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis import voxelise as v
from freecad_trabecula.core.rays import contains
from freecad_trabecula.errors import Cancelled, MeshError, ParameterError


def box(low, high):
    """Triangles of a box, counter-clockwise seen from outside."""
    faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2)]
    faces += [(2, 4, 6), (1, 3, 5), (3, 7, 5)]
    corners = np.array([[(low, high)[n >> k & 1][k] for k in range(3)] for n in range(8)], float)
    return corners[np.array(faces)]


def ball(radius, centre=(0.0, 0.0, 0.0), rings=24, sides=48):
    """Triangles of a polyhedron inscribed in a sphere."""
    theta, phi = np.pi * np.arange(rings + 1) / rings, 2 * np.pi * np.arange(sides) / sides
    grid = np.stack(
        [
            np.outer(np.sin(theta), np.cos(phi)),
            np.outer(np.sin(theta), np.sin(phi)),
            np.outer(np.cos(theta), phi * 0 + 1),
        ],
        2,
    )
    grid[[0, -1], :, :2] = 0
    grid = radius * grid + centre
    ahead = np.roll(grid, -1, 1)
    upper = np.stack([grid[:-1], grid[1:], ahead[1:]], 2).reshape(-1, 3, 3)
    lower = np.stack([grid[:-1], ahead[1:], ahead[:-1]], 2).reshape(-1, 3, 3)
    triangles = np.concatenate([upper, lower])
    return triangles[(np.ptp(triangles, axis=1) > 0).any(1)]


def test_a_box_fills_its_own_box_and_no_more():
    made = v.voxelise(box([0, 0, 0], [2, 3, 4]), 0.5)
    assert made.solid.shape == (8, 6, 4)
    assert made.solid.all()
    assert made.volume == pytest.approx(24)
    assert made.origin == (0.0, 0.0, 0.0)


def test_voxels_come_layer_row_column_and_hold_the_value_at_their_centres():
    made = v.voxelise(box([1, 0, 0], [2, 0.5, 0.25]), 0.25, [[0, 0, 0], [2, 1, 1]])
    expected = np.zeros((4, 4, 8), bool)
    expected[:1, :2, 4:] = True
    assert np.array_equal(made.solid, expected)


def test_voxels_agree_with_points_tested_one_by_one():
    rng = np.random.default_rng(3)
    triangles = np.concatenate([ball(r, c) for r, c in zip(rng.uniform(0.5, 1.5, 6), rng.uniform(-2, 2, (6, 3)))])
    made = v.voxelise(triangles, 0.17, [[-3.1, -3.2, -3.0], [3.1, 3.3, 3.4]])
    z, y, x = np.indices(made.solid.shape)
    centres = (np.stack([x, y, z], -1).reshape(-1, 3) + 0.5) * made.size + made.origin
    assert np.array_equal(made.solid.ravel(), contains(triangles, centres))


def test_overlapping_bodies_are_one_and_a_body_turned_inside_out_is_a_cavity():
    outer, inner = box([0, 0, 0], [4, 4, 4]), box([1, 1, 1], [3, 3, 3])
    assert v.voxelise(np.concatenate([outer, inner]), 0.5).solid_fraction == 1.0
    assert v.voxelise(np.concatenate([outer, inner[:, ::-1]]), 0.5).solid_fraction == 1 - 8 / 64


def test_two_surfaces_in_one_voxel_leave_it_as_it_was():
    thin = box([0.52, 0, 0], [0.54, 1, 1])
    around = box([0, 0, 0], [1, 1, 1])
    assert v.voxelise(np.concatenate([around, thin[:, ::-1]]), 0.1).solid.all()


def test_the_share_of_solid_tends_to_the_volume_of_a_ball():
    triangles = ball(1.0)
    a, b, c = triangles.transpose(1, 0, 2)
    volume = (a * np.cross(b, c)).sum() / 6
    for size, error in ((0.1, 2e-2), (0.02, 1e-3)):
        made = v.voxelise(triangles, size)
        assert made.solid_fraction * made.volume == pytest.approx(volume, rel=error)


def test_the_grid_lies_about_the_middle_of_a_box_that_is_no_multiple_of_the_voxel():
    made = v.voxelise(box([0, 0, 0], [1.0, 1.06, 0.94]), 0.1)
    assert made.solid.shape == (9, 11, 10)
    assert made.solid.all()
    assert made.origin == pytest.approx((0, -0.02, 0.02))


def test_two_hundred_voxels_lie_along_the_longest_edge_by_default():
    assert v.default_size([0, 0, -1], [10, 8, 3]) == pytest.approx(0.05)


@pytest.mark.parametrize(("thickness", "size"), [(4.0, 0.1), (0.56, 0.07), (0.1, 0.05)])
def test_a_plate_gets_eight_voxels_across_but_100_to_200_along_the_longest_edge(thickness, size):
    # a plate of 10 x 10 x t has 2 V / S = 10 t / (10 + 2 t)
    low = 10 * thickness / (10 + 2 * thickness) / 8
    assert v.fitting_size(box([0, 0, 0], [10, 10, thickness]), ([0, 0, 0], [10, 10, thickness])) == pytest.approx(
        min(max(low, 0.05), 0.1)
    )
    assert min(max(low, 0.05), 0.1) == pytest.approx(size, rel=0.12)


@pytest.mark.parametrize("size", [0.0, -0.1, math.nan, math.inf])
def test_a_size_that_is_none_is_refused(size):
    with pytest.raises(ParameterError, match="size of voxels must be > 0"):
        v.voxelise(box([0, 0, 0], [1, 1, 1]), size)


def test_more_voxels_than_memory_holds_are_refused_with_their_number():
    with pytest.raises(ParameterError, match=r"at most 1e\+09 voxels, a size of 0.0001 mm makes 1.00e\+12"):
        v.voxelise(box([0, 0, 0], [1, 1, 1]), 1e-4)


def test_open_meshes_no_triangles_flat_boxes_and_numbers_that_are_none_are_refused():
    with pytest.raises(MeshError, match="closed meshes"):
        v.voxelise(box([0, 0, 0], [1, 1, 1])[:-1], 0.1)
    with pytest.raises(MeshError, match="at least one triangle, got 0"):
        v.voxelise(np.zeros((0, 3, 3)), 0.1)
    with pytest.raises(ParameterError, match="low < high"):
        v.voxelise(box([0, 0, 0], [1, 1, 0]), 0.1)
    bad = box([0, 0, 0], [1, 1, 1])
    bad[0, 0, 0] = np.nan
    with pytest.raises(MeshError, match="finite"):
        v.voxelise(bad, 0.1, [[0, 0, 0], [1, 1, 1]])


def test_an_array_that_holds_no_voxels_is_refused():
    with pytest.raises(MeshError, match=r"bool array \[z, y, x\], got float64"):
        v.Voxels(np.zeros((2, 2, 2)), 0.1)
    with pytest.raises(ParameterError, match="size of voxels must be > 0"):
        v.Voxels(np.zeros((2, 2, 2), bool), 0.0)


def test_cancelling_stops_between_layers():
    def cancel(done, total, what):
        if done:
            raise Cancelled("stop")

    with pytest.raises(Cancelled):
        v.voxelise(box([0, 0, 0], [1, 1, 1]), 0.02, progress=cancel)


def test_the_mean_thickness_of_a_plate_is_nearly_its_own():
    plate = box([0, 0, 0], [50, 50, 0.2])
    assert v.mean_thickness(plate) == pytest.approx(2 * 500 / (5000 + 4 * 50 * 0.2))
