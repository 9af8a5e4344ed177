# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules decided for certain: against all voxels of small boxes, listed one by one."""

from itertools import product

import numpy as np
import pytest

from freecad_trabecula.core.voxels.connectivity import closed_cavities, corner_contacts, edge_contacts, parts
from freecad_trabecula.core.voxels.exact_rules import decided
from freecad_trabecula.core.voxels.plane_offsets import layer_sums


def kept(solid, edges, corners):
    return (
        len(parts(solid)[1]) == 2
        and len(closed_cavities(solid)[1]) == 1
        and not (edges and edge_contacts(solid))
        and not (corners and corner_contacts(solid))
    )


def all_of(shape):
    """Return {counts: [voxels]} of all ways to fill a box."""
    found = {}
    for bits in product((False, True), repeat=int(np.prod(shape))):
        solid = np.array(bits).reshape(shape)
        found.setdefault(tuple(map(tuple, layer_sums(solid))), []).append(solid)
    return found


BOX = all_of((2, 2, 3))


@pytest.mark.parametrize("edges, corners", [(False, False), (True, False), (True, True)])
def test_every_target_of_a_box_of_twelve_cells_is_decided_as_the_list_of_all_designs_does(edges, corners):
    whole = np.ones((2, 2, 3), bool)
    disagree = []
    for counts, solids in list(BOX.items())[1::5]:
        there = any(kept(solid, edges, corners) for solid in solids)
        verdict = decided([np.array(c) for c in counts], whole, edges, corners, 30.0)
        right = verdict.decided and (verdict.voxels is not None) == there
        if there and right:
            right = kept(verdict.voxels, edges, corners)
            right &= tuple(map(tuple, layer_sums(verdict.voxels))) == counts
        disagree += [] if right else [counts]
    assert disagree == []


def test_the_rule_that_cannot_be_kept_is_named():
    diagonal = [np.ones(2, int)] * 2 + [np.full(1, 2)]  # two voxels of a square of four: across
    assert decided(diagonal, np.ones((2, 2, 1), bool), True, False, 30.0).broken == ("contacts",)
    assert decided(diagonal, np.ones((2, 2, 1), bool), False, False, 30.0).broken == ("one part",)
    # 26 voxels, all layers but the middle ones full: the void one is in the middle
    hollow = [np.array([9, 8, 9])] * 3
    assert decided(hollow, np.ones((3, 3, 3), bool), True, False, 30.0).broken == ("contacts", "no closed cavity")


def test_a_void_beside_the_outside_of_a_mask_is_no_closed_cavity():
    mask = np.ones((3, 3, 5), bool)
    mask[1, 1, 2] = False
    solid = mask.copy()
    solid[1, 1, 1] = False  # in the middle, beside the cell outside the mask
    verdict = decided(layer_sums(solid), mask, True, False, 30.0)
    assert verdict.decided and np.array_equal(verdict.voxels, solid)


def test_counts_that_no_voxels_have_break_no_rule_and_no_time_decides_nothing():
    impossible = [np.array([4, 0]), np.array([2, 2]), np.array([4, 0])]
    verdict = decided(impossible, np.ones((2, 2, 2), bool), False, False, 30.0)
    assert verdict.voxels is None and verdict.decided and verdict.broken == ()
    assert decided([np.full(2, 2)] * 3, np.ones((2, 2, 2), bool), False, False, 0.0) == (None, (), False)
