# SPDX-License-Identifier: LGPL-2.1-or-later
"""Annealing: flips keep one part and no cavity, counts and contacts come right, the same way every time."""

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.annealing import FORCED, Annealing
from freecad_trabecula.core.voxels.connectivity import closed_cavities, corner_contacts, edge_contacts, parts
from freecad_trabecula.core.voxels.plane_offsets import layer_sums

SHAPE = (6, 7, 5)


def tube():
    y, x = np.mgrid[:7, :5]
    return np.broadcast_to((x % 4 == 0) | (y % 6 == 0), SHAPE).copy()


def seedling(shape=SHAPE):
    start = np.zeros(shape, bool)
    start[tuple(n // 2 for n in shape)] = True
    return start


@pytest.mark.parametrize("edges, corners", [(False, False), (True, False), (True, True)])
def test_from_one_voxel_the_counts_of_a_tube_are_reached_in_one_part(edges, corners):
    counts = layer_sums(tube())
    annealing = Annealing(seedling(), np.zeros(SHAPE), counts, None, edges, corners)
    assert annealing.run(Stream(1, "test"), 3, 60_000)
    voxels = annealing.voxels
    assert all(np.array_equal(a, b) for a, b in zip(layer_sums(voxels), counts))
    assert len(parts(voxels)[1]) == 2 and len(closed_cavities(voxels)[1]) == 1
    assert not edges or edge_contacts(voxels) == 0
    assert not corners or corner_contacts(voxels) == 0


def test_what_is_kept_count_of_is_what_is_there_wherever_it_stops():
    # one voxel in each layer along z and y, five along x: never met, so that it runs on to the end
    counts = [np.full(6, 10), np.full(7, 9), np.full(5, 12)]
    annealing = Annealing(seedling(), np.zeros(SHAPE), counts, None, True, True)
    annealing.run(Stream(2, "test"), 1, 5_000)
    voxels = annealing.voxels
    lacking = [a - b for a, b in zip(counts, layer_sums(voxels))]
    assert all(np.array_equal(a, b) for a, b in zip(annealing.lacking, lacking))
    assert annealing.missing == sum(np.abs(lack).sum() for lack in lacking) > 0
    assert annealing.contacts == edge_contacts(voxels) + corner_contacts(voxels)
    assert len(parts(voxels)[1]) == 2 and len(closed_cavities(voxels)[1]) == 1


def test_within_a_mask_nothing_is_outside_and_void_beside_it_is_open():
    mask = np.ones(SHAPE, bool)
    mask[2:4, 2:5, 2] = False
    solid = mask.copy()
    solid[5, :, 4] = False
    counts = layer_sums(solid)
    annealing = Annealing(mask & (np.indices(SHAPE)[0] == 0), np.zeros(SHAPE), counts, mask)
    assert annealing.run(Stream(3, "test"), 3, 60_000)
    assert not (annealing.voxels & ~mask).any()


def test_voxels_that_are_high_are_preferred_and_forced_ones_kept():
    forced = np.full((4, 4, 4), -1.0)
    forced[:, 0, 0] = FORCED
    solid = forced > 0
    solid[0, :3] = solid[:, 2, 2] = True
    annealing = Annealing(forced > 0, forced, layer_sums(solid), None, False)
    assert annealing.run(Stream(4, "test"), 3, 60_000)
    assert annealing.voxels[:, 0, 0].all()


def test_the_same_stream_takes_the_same_way_and_another_another():
    counts = layer_sums(tube())
    found = []
    for seed in (1, 1, 2):
        annealing = Annealing(seedling(), np.random.default_rng(0).normal(size=SHAPE), counts)
        annealing.run(Stream(seed, "test"), 1, 2_000)
        found.append(annealing.voxels)
    assert np.array_equal(found[0], found[1]) and not np.array_equal(found[0], found[2])
