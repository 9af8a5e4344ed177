# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth surfaces of voxels: closed, manifold, volume kept or its change said, against closed forms."""

import numpy as np
import pytest

from freecad_trabecula.core.meshes import components, is_closed, mesh_volume
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.smooth_surface import cubes_surface, smooth_surface
from freecad_trabecula.errors import Cancelled, ParameterError

VOXEL, ORIGIN = (0.1, 0.2, 0.3), (1.0, 2.0, 3.0)


def ball(radius=20):
    at = np.indices((2 * radius + 6,) * 3) - radius - 2.5
    return (at**2).sum(0) < radius**2


def test_one_voxel_becomes_an_octahedron_between_the_centres_of_its_neighbours():
    voxels = np.zeros((3, 3, 3), bool)
    voxels[1, 1, 1] = True
    mesh = cubes_surface(voxels, VOXEL, ORIGIN)
    assert is_closed(mesh)
    assert mesh_volume(mesh) == pytest.approx(np.prod(VOXEL) / 6)
    # the faces of the voxel itself
    assert mesh.vertices.min(0) == pytest.approx((1.1, 2.2, 3.3))
    assert mesh.vertices.max(0) == pytest.approx((1.2, 2.4, 3.6))


def test_a_block_that_fills_its_box_reaches_all_its_faces():
    mesh = cubes_surface(np.ones((40, 2, 2), bool), (1, 1, 1))
    assert is_closed(mesh)
    assert (mesh.vertices.min(0).tolist(), mesh.vertices.max(0).tolist()) == ([0, 0, 0], [2, 2, 40])


def test_any_voxels_give_a_closed_surface_and_parts_that_touch_by_an_edge_stay_apart():
    voxels = Stream(3, "voxels").uniform(20**3).reshape(20, 20, 20) < 0.4
    assert is_closed(smooth_surface(voxels, VOXEL).mesh)
    edge = np.zeros((2, 2, 1), bool)
    edge[0, 0, 0] = edge[1, 1, 0] = True
    assert components(cubes_surface(edge, (1, 1, 1))).max() == 1


def test_a_ball_gets_rounder_and_keeps_the_volume_of_its_voxels():
    voxels = ball()
    rough, smooth = cubes_surface(voxels, (1, 1, 1)), smooth_surface(voxels, (1, 1, 1))
    radii = [np.linalg.norm(mesh.vertices - 23, axis=1) for mesh in (rough, smooth.mesh)]
    assert radii[1].std() < 0.6 * radii[0].std()
    assert smooth.voxel_volume == voxels.sum()
    assert mesh_volume(smooth.mesh) == pytest.approx(voxels.sum(), rel=1e-8)
    assert abs(smooth.change) < 1e-8


def test_without_keeping_the_volume_the_change_is_said():
    voxels = ball(6)
    found = smooth_surface(voxels, VOXEL, keep_volume=False)
    assert found.change == pytest.approx(mesh_volume(found.mesh) / (voxels.sum() * np.prod(VOXEL)) - 1)
    assert found.change != 0


def test_no_vertex_moves_farther_than_half_a_voxel():
    voxels = Stream(5, "voxels").uniform(12**3).reshape(12, 12, 12) < 0.5
    moved = np.abs(smooth_surface(voxels, VOXEL).mesh.vertices - cubes_surface(voxels, VOXEL).vertices)
    assert (moved <= np.array(VOXEL) / 2 + 1e-12).all()


def test_no_solid_voxel_and_negative_rounds_are_refused():
    with pytest.raises(ParameterError, match="at least one solid voxel"):
        cubes_surface(np.zeros((2, 2, 2), bool), VOXEL)
    with pytest.raises(ParameterError, match="rounds of smoothing must be 0 or more, got -1"):
        smooth_surface(ball(3), VOXEL, rounds=-1)


def test_it_can_be_stopped():
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        smooth_surface(ball(3), VOXEL, progress=stop)
