# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flips until every count is exact."""

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.connectivity import Solid, closed_cavities, parts
from freecad_trabecula.core.voxels.exact_moves import ExactMoves, ascending
from freecad_trabecula.core.voxels.plane_offsets import FORBIDDEN, layer_sums
from freecad_trabecula.errors import ExactnessError

SHAPE = (16, 18, 20)


def block(low, high):
    solid = np.zeros(SHAPE, bool)
    solid[low:high, low:high, low:high] = True
    return solid


def moves_to(solid, targets, mask=None):
    field = -np.abs(np.indices(SHAPE) - 8).sum(0).astype(np.float32) / 16
    if mask is not None:
        field[~mask] = FORBIDDEN
    return ExactMoves(Solid(solid, mask), field, [np.zeros(n) for n in SHAPE], targets)


def disturbed(solid, share, seed):
    """Return the solid after legal flips at random: targets that one part has."""
    inner = Solid(solid)
    index = inner.index_of(*(a.ravel() for a in np.indices(SHAPE)))
    draws = Stream(seed, "test").uniform(len(index))
    for one in index[np.argsort(draws)][: int(share * len(index))]:
        if inner.flippable(np.array([one]))[0]:
            inner.flip(np.array([one]))
    return inner.voxels.copy()


@pytest.mark.parametrize("seed", [1, 2, 3, 4])
def test_counts_of_another_part_are_reached_exactly_in_one_part(seed):
    targets = layer_sums(disturbed(block(4, 13), 0.5, seed))
    voxels = moves_to(block(5, 13), targets).run()
    assert [s.tolist() for s in layer_sums(voxels)] == [t.tolist() for t in targets]
    assert len(parts(voxels)[1]) == 2
    assert len(closed_cavities(voxels)[1]) == 1


def test_a_layer_without_solid_beside_it_is_reached():
    goal = block(5, 12)
    goal[12:16, 8, 8] = True
    goal[5, 5, 5:9] = False
    voxels = moves_to(block(5, 12), layer_sums(goal)).run()
    assert layer_sums(voxels)[0].tolist() == layer_sums(goal)[0].tolist()
    assert len(parts(voxels)[1]) == 2


def test_nothing_leaves_the_mask():
    mask = block(3, 14)
    targets = layer_sums(disturbed(block(5, 12), 0.1, 7) & mask)
    voxels = moves_to(block(5, 12), targets, mask).run()
    assert not (voxels & ~mask).any()


def test_batches_bring_the_counts_nearer_without_splitting():
    moves = moves_to(block(4, 12), layer_sums(disturbed(block(4, 14), 0.6, 5)))
    before = moves.missing
    moves.spread()
    assert moves.missing < before
    assert len(parts(moves.solid.voxels)[1]) == 2
    assert [s.tolist() for s in moves.lacking] == [
        (t - s).tolist() for t, s in zip(layer_sums(disturbed(block(4, 14), 0.6, 5)), layer_sums(moves.solid.voxels))
    ]


def test_what_cannot_be_is_refused_with_the_layer_that_is_furthest_off():
    # two single voxels in opposite corners' layers: no one part has them
    targets = [np.zeros(n, int) for n in SHAPE]
    for target in targets:
        target[0] = target[-1] = 1
    with pytest.raises(ExactnessError, match="layer .* along"):
        moves_to(block(0, 1), targets).run()


def test_a_box_of_fewer_layers_than_are_tried_in_turn_ends_in_a_refusal():
    # 27 voxels of 27, and every layer is to have 10 instead of 9
    shape = (3, 3, 3)
    full = np.ones(shape, bool)
    moves = ExactMoves(Solid(full), np.zeros(shape, np.float32), [np.zeros(3)] * 3, [np.full(3, 10)] * 3)
    with pytest.raises(ExactnessError, match="off by"):
        moves.run()


@pytest.mark.parametrize("count", [0, 1, 1023, 5000, 16385, 40_000])
def test_costs_are_gone_through_from_the_least_on_and_ties_in_their_order(count):
    # many ties: 300 values; numpy's stable sort is the independent route
    cost = np.floor(300 * Stream(count, "costs").many(count)).astype(np.float32)
    chunks = list(ascending(cost))
    assert np.array_equal(np.concatenate([np.arange(0), *chunks]), np.argsort(cost, kind="stable"))
    assert all(len(chunk) == 1024 for chunk in chunks[:-1])
