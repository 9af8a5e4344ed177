# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers with given sums: propagation against every 0/1 matrix, random layers against their law."""

from __future__ import annotations

import itertools
from collections import Counter

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.layer_fill import layer_sums, propagated_layers, shuffled_layers
from freecad_trabecula.errors import InfeasibleError, ParameterError

MATRICES = [np.array(bits).reshape(3, 4) for bits in itertools.product((0, 1), repeat=12)]


@pytest.mark.parametrize("direction", ["rows", "columns"])
@pytest.mark.parametrize("order", ["minimum", "sequential"])
def test_a_layer_is_found_wherever_there_is_one(direction, order):
    sums = sorted({(tuple(m.sum(0)), tuple(m.sum(1))) for m in MATRICES})
    alpha, beta = np.array([a for a, _ in sums]).T, np.array([b for _, b in sums]).T
    voxels = propagated_layers(alpha, beta, direction, order)
    assert (layer_sums(voxels)[0] == alpha).all() and (layer_sums(voxels)[1] == beta).all()


@pytest.mark.parametrize("direction", ["rows", "columns"])
def test_a_layer_that_no_matrix_has_is_refused(direction):
    exist = {(tuple(m.sum(0)), tuple(m.sum(1))) for m in MATRICES}
    refused = 0
    for alpha in itertools.combinations_with_replacement(range(4), 4):
        for beta in itertools.combinations_with_replacement(range(5), 3):
            if sum(alpha) == sum(beta) and (alpha, beta) not in exist:
                with pytest.raises(InfeasibleError, match="not compatible: no layer 0 along Z"):
                    propagated_layers(np.array([alpha]).T, np.array([beta]).T, direction)
                refused += 1
    assert refused > 5


def test_random_layers_keep_their_sums():
    start = Stream(1, "a").many(5 * 9 * 8).reshape(5, 9, 8) < 0.4
    voxels = shuffled_layers(start, Stream(2, "b"))
    assert (voxels.sum(1) == start.sum(1)).all() and (voxels.sum(2) == start.sum(2)).all()
    assert (voxels != start).any()


def test_random_layers_are_nearly_uniform_over_all_with_their_sums():
    alpha, beta = (2, 1, 1, 1), (2, 2, 1)
    every = [m for m in MATRICES if tuple(m.sum(0)) == alpha and tuple(m.sum(1)) == beta]
    start = np.tile(every[0].astype(bool), (2000, 1, 1))
    drawn = Counter(layer.tobytes() for layer in shuffled_layers(start, Stream(3, "u"), rounds=12))
    expected = 2000 / len(every)
    assert len(drawn) == len(every)
    chi2 = sum((drawn[m.astype(bool).tobytes()] - expected) ** 2 / expected for m in every)
    assert chi2 < len(every) - 1 + 5 * np.sqrt(2 * (len(every) - 1))


def test_an_order_that_is_not_known_is_refused():
    with pytest.raises(ParameterError, match="order must be one of minimum, sequential"):
        propagated_layers(np.ones((2, 1), int), np.ones((2, 1), int), "rows", "maximum")


# ------------------------------------------------------------------------------------------------------ within a mask


def masked_sums(mask):
    """Column and row sums of every 0/1 matrix within a mask."""
    places = np.argwhere(mask)
    bits = (np.arange(2 ** len(places))[:, None] >> np.arange(len(places))) & 1
    columns = bits @ np.eye(mask.shape[1], dtype=int)[places[:, 1]]
    rows = bits @ np.eye(mask.shape[0], dtype=int)[places[:, 0]]
    return {(tuple(c), tuple(r)) for c, r in zip(columns.tolist(), rows.tolist())}


@pytest.mark.parametrize("direction", ["rows", "columns"])
@pytest.mark.parametrize("order", ["minimum", "sequential"])
def test_a_layer_within_a_mask_is_found_wherever_there_is_one(direction, order):
    for seed in range(40):
        mask = Stream(seed, "mask").many(12).reshape(3, 4) < 0.6
        sums = sorted(masked_sums(mask))
        alpha, beta = np.array([a for a, _ in sums]).T, np.array([b for _, b in sums]).T
        masks = np.repeat(mask[None], len(sums), axis=0)
        voxels = propagated_layers(alpha, beta, direction, order, mask=masks)
        assert not (voxels & ~masks).any()
        assert (layer_sums(voxels)[0] == alpha).all() and (layer_sums(voxels)[1] == beta).all()


def test_a_layer_that_no_matrix_within_the_mask_has_is_refused():
    refused = 0
    for seed in range(15):
        mask = Stream(seed, "mask").many(9).reshape(3, 3) < 0.6
        exist = masked_sums(mask)
        for alpha in itertools.product(range(3), repeat=3):
            for beta in itertools.product(range(3), repeat=3):
                if sum(alpha) == sum(beta) and (alpha, beta) not in exist:
                    with pytest.raises(InfeasibleError, match="not compatible: no layer 0 along Z"):
                        propagated_layers(np.array([alpha]).T, np.array([beta]).T, mask=mask[None])
                    refused += 1
    assert refused > 100


def test_a_mask_of_all_cells_changes_nothing():
    bits = Stream(4, "bits").many(5 * 7 * 6).reshape(5, 7, 6) < 0.4
    alpha, beta = layer_sums(bits)
    for direction, order in itertools.product(("rows", "columns"), ("minimum", "sequential")):
        plain = propagated_layers(alpha, beta, direction, order)
        assert (propagated_layers(alpha, beta, direction, order, mask=np.ones(bits.shape, bool)) == plain).all()


def test_trades_within_a_mask_keep_sums_and_mask_and_reach_every_layer_that_trades_join():
    # a ring of cells without corners' neighbours would be stuck; a full block beside one forbidden cell is not
    mask = np.ones((3, 3), bool)
    mask[0, 0] = False
    start = np.repeat((np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1]]) > 0)[None], 4000, axis=0)
    drawn = Counter(x.tobytes() for x in shuffled_layers(start, Stream(5, "t"), mask=np.repeat(mask[None], 4000, 0)))
    every = [np.eye(3, dtype=bool)[list(p)] for p in itertools.permutations(range(3)) if p[0] != 0]
    assert set(drawn) == {layer.tobytes() for layer in every}
    assert max(abs(count - 1000) for count in drawn.values()) < 5 * 1000**0.5
