# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strategies of tables within masks: every target of small masks, a sphere, certificates, caps, given tables."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.design import make_design
from freecad_trabecula.core.voxels.layer_fill import layer_sums
from freecad_trabecula.core.voxels.masked_tables import (
    compatible_beta,
    draw_table,
    masked_layers_exist,
    masked_pair,
)
from freecad_trabecula.core.voxels.masks import targets_within
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.registry import find_strategy, strategy_names
from freecad_trabecula.core.voxels.targets import Targets, targets_of_voxels
from freecad_trabecula.errors import ExactnessError, InfeasibleError, ParameterError

OF_TABLES = [name for name in strategy_names() if "pairing" in find_strategy(name).OPTIONS]


def chosen(strategy="minimum-zeros", **more):
    return VoxelParameters(**{"strategy": strategy, "size": 1.0, **more})


def ball(edge, radius):
    z, y, x = np.indices((edge,) * 3) - (edge - 1) / 2
    return x * x + y * y + z * z <= radius * radius


def assert_exact(voxels, targets, mask):
    assert not (voxels & ~mask).any()
    for counts, axes in zip(targets.counts, ((0, 1), (0, 2), (1, 2))):
        assert (voxels.sum(axes) == counts).all()


# ------------------------------------------------------------------------------------------ every target of small masks


def margins_within(mask):
    """Counts (D, E, C) of every design within a mask."""
    places = np.argwhere(mask)
    bits = (np.arange(2 ** len(places))[:, None] >> np.arange(len(places))) & 1
    sums = [bits @ np.eye(count, dtype=int)[places[:, axis]] for axis, count in enumerate(mask.shape)]
    rows = np.unique(np.hstack([sums[2], sums[1], sums[0]]), axis=0)
    n, m = mask.shape[2], mask.shape[1]
    return {(tuple(r[:n]), tuple(r[n : n + m]), tuple(r[n + m :])) for r in rows.tolist()}


def masks_but_for_symmetry(shape):
    """One of all masks that turn into each other when layers are put in another order."""
    seen, kept = set(), []
    for bits in itertools.product((False, True), repeat=int(np.prod(shape))):
        mask = np.array(bits).reshape(shape)
        if mask.tobytes() in seen or not mask.any():
            continue
        kept.append(mask)
        for orders in itertools.product(*(itertools.permutations(range(k)) for k in shape)):
            seen.add(np.ascontiguousarray(mask[np.ix_(*orders)]).tobytes())
    return kept


def targets_that_layers_hold(mask):
    """All counts (D, E, C) with one total of which no layer asks for more than its cells in a mask."""
    axes = [[range(int(room) + 1) for room in mask.sum(across)] for across in ((0, 1), (0, 2), (1, 2))]
    every = [{} for _ in axes]
    for found, ranges in zip(every, axes):
        for counts in itertools.product(*ranges):
            found.setdefault(sum(counts), []).append(counts)
    for total in set(every[0]) - {0}:
        yield from itertools.product(*(found.get(total, ()) for found in every))


def test_every_target_of_every_mask_of_2_x_2_x_2_is_solved_or_refused():
    solved = refused = 0
    for mask in masks_but_for_symmetry((2, 2, 2)):
        exist = margins_within(mask)
        for counts in targets_that_layers_hold(mask):
            targets = Targets(*map(np.array, counts), (1.0,) * 3)
            if counts in exist:
                assert_exact(make_design(targets, chosen(), mask).voxels, targets, mask)
                solved += 1
            else:
                with pytest.raises(InfeasibleError):
                    make_design(targets, chosen(), mask)
                refused += 1
    assert solved > 500 and refused > 50


@pytest.mark.parametrize("seed", range(25))
def test_random_masks_of_3_x_3_x_2_are_filled_exactly_when_they_can_be(seed):
    mask = Stream(seed, "mask").many(18).reshape(2, 3, 3) < 0.4 + 0.5 * (seed % 5) / 4
    exist, held = margins_within(mask), list(targets_that_layers_hold(mask))
    picks = (Stream(seed, "picks").uniform(20) * len(held)).astype(int)
    own = sorted(exist - {((0, 0, 0), (0, 0, 0), (0, 0))})
    some = [own[int(k * len(own))] for k in Stream(seed, "own").uniform(10)]
    for counts in [*(held[k] for k in picks), *some]:
        targets = Targets(*map(np.array, counts), (1.0,) * 3)
        strategy = chosen(OF_TABLES[sum(counts[0]) % len(OF_TABLES)])
        if counts in exist:
            assert_exact(make_design(targets, strategy, mask).voxels, targets, mask)
        else:
            with pytest.raises(InfeasibleError):
                make_design(targets, strategy, mask)


# --------------------------------------------------------------------------------------------------------- larger masks


@pytest.mark.parametrize("strategy", OF_TABLES)
def test_a_ball_is_filled_exactly_and_nothing_lies_outside(strategy):
    mask = ball(24, 12)
    targets = targets_within(mask, (np.linspace(0.1, 0.6, 24), 0.3, 0.3), (1.0,) * 3)
    voxels = make_design(targets, chosen(strategy, seed=3), mask).voxels
    assert_exact(voxels, targets, mask)
    assert (voxels == make_design(targets, chosen(strategy, seed=3), mask).voxels).all()


@pytest.mark.parametrize("solver", ["proportional", "thesis"])
def test_random_designs_within_random_masks_are_matched(solver):
    for seed in range(10):
        mask = Stream(seed, "mask").many(1100).reshape(11, 10, 10) < 0.55
        bits = mask & (Stream(seed, "bits").many(1100).reshape(11, 10, 10) < 0.15 + 0.08 * seed)
        targets = targets_of_voxels(bits, (1.0,) * 3)
        alpha, beta, *_ = masked_pair(targets, chosen(solver=solver, seed=seed), mask)
        assert (alpha.sum(1) == targets.d).all() and (beta.sum(1) == targets.e).all()
        assert (alpha.sum(0) == targets.c).all() and (alpha <= layer_sums(mask)[0]).all()
        assert masked_layers_exist(alpha, beta, mask).all()


def test_caps_hold_within_a_mask():
    mask = ball(16, 8)
    targets = targets_within(mask, (0.25,) * 3, (1.0,) * 3)
    design = make_design(targets, chosen(cap_alpha=6, cap_beta=5), mask)
    assert_exact(design.voxels, targets, mask)
    assert design.alpha.max() <= 6 and design.beta.max() <= 5


def test_the_first_row_of_a_table_is_drawn_in_proportion_to_need_and_cells():
    # two columns that need 40 each; the first row has a third of the first one's cells, three sevenths of the other's
    caps = np.array([[20, 30], [40, 40]])
    rows, columns = np.array([34, 46]), np.array([40, 40])
    cells = [draw_table(rows, columns, caps, "proportional", Stream(k, "t")).cells for k in range(400)]
    assert all((c.sum(1) == rows).all() and (c.sum(0) == columns).all() and (c <= caps).all() for c in cells)
    assert abs(np.mean([c[0, 0] for c in cells]) - 34 * (1 / 3) / (1 / 3 + 3 / 7)) < 0.6


def test_a_beta_that_is_possible_already_stays():
    mask = ball(10, 5)
    bits = mask & (Stream(1, "bits").many(1000).reshape(10, 10, 10) < 0.4)
    alpha, beta = layer_sums(bits)
    assert (compatible_beta(bits.sum((0, 2)), alpha.T, beta.T, mask.sum(2), mask) == beta.T).all()


# ------------------------------------------------------------------------------------------------------ what is refused


def test_layers_that_contradict_each_other_in_the_mask_are_named():
    # layers 0 and 1 along X have cells in layer 0 along Z only, which is asked for 1
    mask = np.zeros((2, 2, 3), bool)
    mask[0], mask[1, :, 2] = True, True
    targets = Targets(np.array([1, 1, 1]), np.array([2, 1]), np.array([1, 2]), (1.0,) * 3)
    words = "within the mask layers 0, 1 along X ask for 2 voxels together, but layer 1 along Z have 0 cells for them"
    with pytest.raises(InfeasibleError, match=words):
        make_design(targets, chosen(), mask)


def test_a_cap_that_the_mask_does_not_allow_is_named():
    mask = ball(12, 6)
    targets = targets_within(mask, (0.9,) * 3, (1.0,) * 3)
    with pytest.raises(InfeasibleError, match="within the mask and with a cap of 5 on alpha layer"):
        masked_pair(targets, chosen(cap_alpha=5), mask)


def test_try_and_repeat_is_refused_within_a_mask():
    mask = ball(8, 4)
    with pytest.raises(ParameterError, match="pairing 'repeat' fills boxes only"):
        make_design(targets_within(mask, (0.3,) * 3), chosen(pairing="repeat"), mask)


def test_given_tables_are_filled_within_the_mask_or_the_layer_is_named():
    mask = ball(10, 5)
    bits = mask & (Stream(2, "bits").many(1000).reshape(10, 10, 10) < 0.4)
    alpha, beta = layer_sums(bits)
    targets = Targets(*targets_of_voxels(bits).counts, (1.0,) * 3, tables=(alpha, beta))
    design = make_design(targets, chosen(), mask)
    assert_exact(design.voxels, targets, mask)
    assert (design.alpha == alpha).all() and (design.beta == beta).all()
    square = np.ones((1, 3, 3), bool)
    square[0, 0, 0] = False
    ones = np.array([[1], [1], [0]])
    given = Targets(*(np.array(c) for c in ([1, 1, 0], [1, 1, 0], [2])), (1.0,) * 3, tables=(ones, ones))
    square[0, 1, 1] = square[0, 1, 0] = False
    with pytest.raises(InfeasibleError, match="not compatible in layer 0 along Z.*no voxels within the mask"):
        make_design(given, chosen(), square)
    over = np.array([[2], [0], [0]])
    given = Targets(*(np.array(c) for c in ([2, 0, 0], [1, 1, 0], [2])), (1.0,) * 3, tables=(over, ones))
    with pytest.raises(ParameterError, match=r"table alpha: cell \(0, 0\) is 2, beyond its bound 1"):
        masked = np.ones((1, 3, 3), bool)
        masked[0, 0, 0] = masked[0, 2, 1] = False
        masked[0, 2, 0] = False
        find_strategy("minimum-zeros").design(given, chosen(), masked, lambda *_: None)


def test_a_search_that_gives_up_says_so(monkeypatch):
    mask = ball(26, 13)
    targets = targets_within(mask, (0.3,) * 3, (1.0,) * 3)
    module = "freecad_trabecula.core.voxels.masked_tables.compatible_beta"
    monkeypatch.setattr(module, lambda *_: None)
    with pytest.raises(ExactnessError, match="no pair of tables was found within the mask in 5 tries"):
        masked_pair(targets, chosen(tries=5), mask)
