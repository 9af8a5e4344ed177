# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compatible pairs of tables: every target up to 3 x 3 x 3, caps, rates, tables that are given."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.feasibility import check_feasible, smallest_cap
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.table_pairs import (
    compatible_layers,
    draw_pair,
    given_pair,
    levelled_table,
    pair_rates,
)
from freecad_trabecula.core.voxels.targets import Targets, targets_of_voxels
from freecad_trabecula.errors import ExactnessError, InfeasibleError, ParameterError


def chosen(**more):
    return VoxelParameters(**{"strategy": "minimum-zeros", "size": 1.0, **more})


def random_targets(seed, shape=(8, 7, 6), density=0.3):
    bits = Stream(seed, "test").many(int(np.prod(shape))).reshape(shape)
    slope = np.linspace(0.3, 1.7, shape[0])[:, None, None]
    return targets_of_voxels(bits < density * slope)


def is_right(pair, targets):
    return (
        (pair.alpha.sum(1) == targets.d).all()
        and (pair.beta.sum(1) == targets.e).all()
        and (pair.alpha.sum(0) == targets.c).all()
        and compatible_layers(pair.alpha, pair.beta).all()
    )


# ------------------------------------------------------------------------------------------- all targets of small boxes


def margins_there_are(n, m, p):
    """Counts (D, E, C), each falling, of every design of n x m x p voxels."""
    layers = {}
    for bits in itertools.product((0, 1), repeat=n * m):
        layer = np.array(bits).reshape(m, n)
        layers.setdefault(int(layer.sum()), set()).add((*layer.sum(0), *layer.sum(1)))
    found = set()
    for c in itertools.combinations_with_replacement(range(n * m, -1, -1), p):
        sums = np.zeros((1, n + m), int)
        for count in c:
            sums = np.unique((sums[:, None] + np.array(sorted(layers[count]))[None]).reshape(-1, n + m), axis=0)
        d, e = -np.sort(-sums[:, :n], axis=1), -np.sort(-sums[:, n:], axis=1)
        found |= {(tuple(row[:n]), tuple(row[n:]), c) for row in np.unique(np.hstack([d, e]), axis=0)}
    return found


def falling(total, parts, most):
    """All falling lists of whole numbers up to ``most`` with a given sum."""
    if parts == 0:
        return [()] if total == 0 else []
    return [(a, *rest) for a in range(min(total, most), -1, -1) for rest in falling(total - a, parts - 1, a)]


@pytest.mark.parametrize("layers", [(1, 2, 3), (2, 2, 2), (3, 2, 2), (2, 3, 3), (3, 2, 3), (3, 3, 2), (3, 3, 3)])
def test_every_target_that_a_design_has_is_solved_and_every_other_refused(layers):
    n, m, p = layers
    there_are, refused, solved = margins_there_are(n, m, p), 0, 0
    for total in range(1, n * m * p):
        axes = (falling(total, n, m * p), falling(total, m, n * p), falling(total, p, n * m))
        for d, e, c in itertools.product(*axes):
            targets = Targets(np.array(d), np.array(e), np.array(c))
            try:
                check_feasible(targets, chosen())
                assert is_right(draw_pair(targets, chosen()), targets)
                assert (d, e, c) in there_are
                solved += 1
            except InfeasibleError:
                assert (d, e, c) not in there_are
                refused += 1
    assert solved == len(there_are) - 2  # but for the empty and the full box
    assert refused > 0


# ------------------------------------------------------------------------------------------------------- larger boxes


@pytest.mark.parametrize("seed", range(100))
def test_targets_of_random_designs_are_solved(seed):
    targets = random_targets(seed, (4 + seed % 5, 9 - seed % 4, 5 + seed % 3), 0.1 + 0.008 * seed)
    for solver in ("thesis", "proportional"):
        assert is_right(draw_pair(targets, chosen(solver=solver, seed=seed)), targets)


def test_pairs_are_found_down_to_the_smallest_caps():
    targets = random_targets(5, (12, 11, 10))
    alpha, beta = smallest_cap(targets.c, targets.d), smallest_cap(targets.c, targets.e)
    pair = draw_pair(targets, chosen(cap_alpha=alpha, cap_beta=beta))
    assert is_right(pair, targets)
    assert pair.alpha.max() <= alpha and pair.beta.max() <= beta


def test_compatible_layers_are_just_those_that_a_matrix_has():
    matrices = [np.array(bits).reshape(2, 3) for bits in itertools.product((0, 1), repeat=6)]
    exist = {(tuple(m.sum(0)), tuple(m.sum(1))) for m in matrices}
    for alpha in itertools.product(range(3), repeat=3):
        for beta in itertools.product(range(4), repeat=2):
            found = compatible_layers(np.array([alpha]).T, np.array([beta]).T)
            assert found.tolist() == [(alpha, beta) in exist]


def test_try_and_repeat_tells_how_many_pairs_it_took():
    targets = random_targets(3, (3, 6, 6))
    pair = draw_pair(targets, chosen(pairing="repeat"))
    assert is_right(pair, targets) and pair.tries >= 1


def test_rates_count_what_they_say():
    rates = pair_rates(random_targets(3), chosen(solver="thesis"), 25)
    assert rates.pairs == 25 and 0 <= rates.compatible <= rates.solved <= 25 and 0 <= rates.layers <= 1
    proportional = pair_rates(random_targets(3), chosen(), 25)
    assert proportional.solved == 25 and proportional.layers >= rates.layers


def test_levelling_keeps_the_sums_and_the_cap_and_lowers_the_squares():
    cells = np.array([[5, 0, 1], [0, 4, 2], [3, 3, 0]])
    level = levelled_table(cells, 5)
    assert (level.sum(0) == cells.sum(0)).all() and (level.sum(1) == cells.sum(1)).all()
    assert (level**2).sum() < (cells**2).sum() and level.min() >= 0


def test_the_same_seed_gives_the_same_pair():
    targets = random_targets(1)
    first, again, other = (draw_pair(targets, chosen(seed=s)) for s in (1, 1, 2))
    assert (first.alpha == again.alpha).all() and (first.beta == again.beta).all()
    assert (first.alpha != other.alpha).any()


def test_given_tables_are_taken_as_they_are():
    targets = random_targets(1)
    pair = draw_pair(targets, chosen())
    given = Targets(*targets.counts, tables=(pair.alpha, pair.beta))
    assert (draw_pair(given, chosen(seed=9)).alpha == pair.alpha).all()


# ------------------------------------------------------------------------------------------------------- refusals


def test_given_tables_whose_sums_do_not_fit_are_refused_by_the_sum():
    targets = random_targets(1)
    pair = draw_pair(targets, chosen())
    wrong = pair.alpha.copy()
    wrong[0, 0] += 1
    with pytest.raises(ParameterError, match=r"table alpha: row 0 sums to \d+, asked for \d+; 2 sums or cells"):
        given_pair(Targets(*targets.counts, tables=(wrong, pair.beta)), chosen())
    with pytest.raises(ParameterError, match="beyond its bound 1"):
        given_pair(Targets(*targets.counts, tables=(pair.alpha, pair.beta)), chosen(cap_beta=1))


def test_given_tables_that_are_not_compatible_are_refused_by_the_layer():
    targets = Targets(np.array([2, 2]), np.array([2, 2]), np.array([2, 2]))
    alpha, beta = np.array([[2, 0], [0, 2]]), np.array([[2, 0], [0, 2]])
    with pytest.raises(InfeasibleError, match="not compatible in layer 0 along Z, and 2 layers in all"):
        given_pair(Targets(*targets.counts, tables=(alpha, beta)), chosen())


def test_try_and_repeat_that_finds_none_gives_up_and_says_so():
    with pytest.raises(ExactnessError, match="none of 3 pairs of tables was compatible; pairing 'constraint'"):
        draw_pair(random_targets(3), chosen(pairing="repeat", solver="thesis", cap_alpha=4, cap_beta=4, tries=3))
