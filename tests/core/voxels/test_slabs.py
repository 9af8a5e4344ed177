# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volumes between planes: boxes, pyramids, and the whole of a mesh."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.meshes import mesh_volume
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.core.voxels.slabs import slab_volumes
from freecad_trabecula.errors import MeshError, ParameterError

VOXELS = Stream(2, "slabs").many(6 * 5 * 4).reshape(6, 5, 4) < 0.4
BLOCKS = block_mesh(VOXELS, (0.5, 0.4, 0.3))
#: A pyramid over the square 0..2, its apex at height 3.
BASE = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]
SIDES = [[BASE[k], BASE[(k + 1) % 4], [1, 1, 3]] for k in range(4)]
PYRAMID = np.array([[BASE[0], BASE[2], BASE[1]], [BASE[0], BASE[3], BASE[2]], *SIDES], float)


@pytest.mark.parametrize(("axis", "edge", "across"), [(0, 0.5, (0, 1)), (1, 0.4, (0, 2)), (2, 0.3, (1, 2))])
def test_slabs_between_layers_of_blocks_hold_their_voxels(axis, edge, across):
    planes = np.arange(VOXELS.shape[2 - axis] + 1) * edge
    assert slab_volumes(BLOCKS.corners, axis, planes) == pytest.approx(VOXELS.sum(across) * 0.06)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_slabs_that_cover_a_mesh_add_up_to_its_volume_however_thin(axis):
    planes = np.linspace(-0.1, 3.1, 1000)
    assert slab_volumes(BLOCKS.corners, axis, planes).sum() == pytest.approx(mesh_volume(BLOCKS))


def test_a_pyramid_has_its_closed_form_at_every_height():
    planes = np.linspace(0, 3, 31)
    above = 4.0 * (3 - planes) ** 3 / 27  # (2/3 of the height left) squared, times a third of it
    assert slab_volumes(PYRAMID, 2, planes) == pytest.approx(-np.diff(above))


def test_a_pyramid_is_symmetric_across_its_axis():
    volumes = slab_volumes(PYRAMID, 0, np.linspace(0, 2, 11))
    assert volumes == pytest.approx(volumes[::-1]) and volumes.sum() == pytest.approx(4)


def test_planes_that_do_not_rise_and_a_mesh_without_triangles_are_refused():
    with pytest.raises(ParameterError, match="planes must rise"):
        slab_volumes(PYRAMID, 2, np.array([0.0, 1.0, 1.0]))
    with pytest.raises(MeshError, match="at least one triangle"):
        slab_volumes(PYRAMID[:0], 2, np.array([0.0, 1.0]))
