# SPDX-License-Identifier: LGPL-2.1-or-later
"""Merged faces cover the outside of blocks once, face outwards, and are few."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.core.voxels.merged_faces import coarse_faces, layers_of, merged_faces, sampled_faces

STEPS = ((0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (-1, 0, 0), (1, 0, 0))  # z, y, x of -X, +X, -Y ...


def outside(voxels, step):
    """Solid voxels whose neighbour in a direction is void, one by one."""
    padded = np.pad(voxels, 1)
    found = set()
    for z, y, x in np.argwhere(voxels):
        if not padded[z + 1 + step[0], y + 1 + step[1], x + 1 + step[2]]:
            found.add((int(x), int(y), int(z)))
    return found


@pytest.mark.parametrize("apart", (None, 0, 1, 2))
@pytest.mark.parametrize("seed", range(8))
def test_every_face_is_covered_once_by_a_rectangle_that_looks_outwards(seed, apart):
    shape = (4, 5, 6)
    voxels = Stream(seed, "bits").many(120).reshape(shape) < 0.2 + 0.1 * seed
    rectangles = merged_faces(voxels, apart)
    place = 0
    for way, count in enumerate(rectangles.counts):
        axis, side = way // 2, way % 2
        covered = []
        for corners in rectangles.corners[place : place + count]:
            low, high = corners.min(0), corners.max(0)
            assert low[axis] == high[axis]
            normal = np.cross(corners[1] - corners[0], corners[2] - corners[1])
            assert np.sign(normal[axis]) == (1 if side else -1)
            spans = [[int(low[k]) - side] if k == axis else range(low[k], high[k]) for k in range(3)]
            covered += [(x, y, z) for x in spans[0] for y in spans[1] for z in spans[2]]
            if apart is not None:
                assert [layers_of(rectangles, apart)[place]] == list(spans[apart])
            place += 1
        assert len(covered) == len(set(covered))
        assert set(covered) == outside(voxels, STEPS[way])
    assert place == len(rectangles.corners)


def test_thick_blocks_take_far_fewer_triangles_than_their_mesh():
    z, y, x = np.indices((40, 40, 40))
    voxels = (x // 8 + y // 8 + z // 8) % 2 == 0  # blocks of 8 x 8 x 8 touching by their edges
    blocks = int(voxels.sum()) // 512
    assert len(merged_faces(voxels).corners) == 6 * blocks
    assert len(block_mesh(voxels, (1, 1, 1)).triangles) > 50 * 2 * 6 * blocks


def test_nothing_solid_has_no_faces():
    assert merged_faces(np.zeros((2, 3, 4), bool)).counts == (0,) * 6


def test_coarse_faces_keep_thick_blocks_and_the_box_and_are_no_more_than_asked_for():
    voxels = np.zeros((9, 9, 9), bool)
    voxels[2:6, 2:6, 2:6] = True
    found = coarse_faces(voxels, 6)
    assert found.counts == (1,) * 6
    assert found.corners.min() == 2 and found.corners.max() == 6
    assert coarse_faces(np.ones((9, 9, 9), bool), 10).corners.max() == 9
    noise = Stream(3, "bits").many(30**3).reshape(30, 30, 30) < 0.5
    assert len(coarse_faces(noise, 200).corners) <= 200 < len(merged_faces(noise).corners)


def test_sampled_faces_stand_for_the_voxels_within_the_same_box():
    voxels = np.zeros((90, 60, 31), bool)
    voxels[10:50, 20:40, 3:31] = True
    found = sampled_faces(voxels, 30)
    assert found.counts == (1,) * 6
    low, high = found.corners.min((0, 1)), found.corners.max((0, 1))
    assert (abs(low - (3, 20, 10)) < 3).all() and (abs(high - (31, 40, 50)) < 3).all()
    assert sampled_faces(voxels, 90).corners.max(0).max(0).tolist() == [31, 40, 50]
