# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks of voxels as a mesh: exact volume and area, closed and manifold whatever touches."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from freecad_trabecula.core.meshes import components, edge_faults, is_closed, mesh_area, mesh_volume, printable
from freecad_trabecula.core.stl import read_stl, write_stl
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.errors import MeshError


def test_one_voxel_is_a_box_in_its_place():
    mesh = block_mesh(np.ones((1, 1, 1), bool), (1.0, 2.0, 3.0), (10.0, 20.0, 30.0))
    assert len(mesh.vertices) == 8 and len(mesh.triangles) == 12
    assert mesh.vertices.min(0).tolist() == [10, 20, 30] and mesh.vertices.max(0).tolist() == [11, 22, 33]
    assert mesh_volume(mesh) == pytest.approx(6) and mesh_area(mesh) == pytest.approx(22)


@pytest.mark.parametrize("density", [0.05, 0.3, 0.5, 0.8])
def test_random_voxels_are_closed_with_their_exact_volume_and_area(density):
    voxels = Stream(1, "blocks", int(100 * density)).many(9 * 8 * 7).reshape(9, 8, 7) < density
    mesh = block_mesh(voxels, (1.0, 2.0, 3.0))
    assert edge_faults(mesh) == (0, 0, 0, 0) and is_closed(mesh)
    assert mesh_volume(mesh) == pytest.approx(6 * voxels.sum())
    padded = np.pad(voxels, 1)
    faces = [int((np.diff(padded.astype(int), axis=k) != 0).sum()) for k in range(3)]
    assert mesh_area(mesh) == pytest.approx(2 * faces[0] + 3 * faces[1] + 6 * faces[2])


def test_every_two_by_two_by_two_block_is_manifold():
    for bits in itertools.product((False, True), repeat=8):
        if any(bits):
            mesh = block_mesh(np.array(bits).reshape(2, 2, 2), (1, 1, 1))
            assert edge_faults(mesh) == (0, 0, 0, 0)
            assert mesh_volume(mesh) == pytest.approx(sum(bits))


def test_voxels_that_touch_by_an_edge_or_a_corner_alone_are_bodies_of_their_own():
    by_edge, by_corner = np.zeros((1, 2, 2), bool), np.zeros((2, 2, 2), bool)
    by_edge[0, 0, 0] = by_edge[0, 1, 1] = True
    by_corner[0, 0, 0] = by_corner[1, 1, 1] = True
    for voxels in (by_edge, by_corner):
        assert components(block_mesh(voxels, (1, 1, 1))).max() == 1


def test_two_voxels_that_touch_by_an_edge_and_are_joined_round_both_its_ends_are_manifold():
    voxels = np.zeros((3, 2, 2), bool)
    voxels[1, 0, 0] = voxels[1, 1, 1] = True
    voxels[[0, 2]] = True
    mesh = block_mesh(voxels, (1, 1, 1))
    assert edge_faults(mesh) == (0, 0, 0, 0) and mesh_volume(mesh) == pytest.approx(10)


def test_a_file_of_it_read_again_is_closed(tmp_path):
    voxels = Stream(5, "blocks").many(1000).reshape(10, 10, 10) < 0.4
    write_stl(tmp_path / "x.stl", printable(block_mesh(voxels, (0.1, 0.1, 0.1), (3.0, 4.0, 5.0))))
    mesh = read_stl(tmp_path / "x.stl")
    assert is_closed(mesh)
    assert mesh_volume(mesh) == pytest.approx(voxels.sum() * 1e-3, rel=1e-5)


def test_a_design_without_voxels_is_refused():
    with pytest.raises(MeshError, match="at least one voxel"):
        block_mesh(np.zeros((2, 2, 2), bool), (1, 1, 1))
