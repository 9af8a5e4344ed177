# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known beforehand: held against every table and every design there is, on small boxes."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from freecad_trabecula.core.voxels.feasibility import (
    check_caps,
    check_feasible,
    forced_cells,
    smallest_cap,
    table_shortfall,
)  # fmt: skip
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.plane_offsets import layer_sums
from freecad_trabecula.core.voxels.targets import Targets, targets_of_voxels
from freecad_trabecula.errors import InfeasibleError

CHOICE = VoxelParameters(strategy="sequential", size=1.0)


def tables_there_are(shape, cap):
    """Row and column sums of every table of this shape with cells 0..cap."""
    cells = np.array(list(itertools.product(range(cap + 1), repeat=shape[0] * shape[1]))).reshape(-1, *shape)
    return {(tuple(t.sum(1)), tuple(t.sum(0))) for t in cells}


@pytest.mark.parametrize(("shape", "cap"), [((2, 2), 3), ((3, 2), 2), ((3, 3), 1)])
def test_a_shortfall_is_found_just_where_there_is_no_table(shape, cap):
    there_are = tables_there_are(shape, cap)
    sums = [range(cap * n + 1) for n in (shape[1],) * shape[0]], [range(cap * n + 1) for n in (shape[0],) * shape[1]]
    for rows in itertools.product(*sums[0]):
        for columns in itertools.product(*sums[1]):
            if sum(rows) == sum(columns):
                lack = table_shortfall(np.array(rows), np.array(columns), cap)
                assert (lack is None) == ((rows, columns) in there_are)


def test_the_certificate_names_columns_that_ask_for_more_than_rows_can_give():
    rows, columns, cap = np.array([4, 4, 1]), np.array([6, 2, 1]), 2
    lack = table_shortfall(rows, columns, cap)
    assert lack.columns.tolist() == [0]
    assert lack.asked == 6 and lack.given == 2 + 2 + 1


def test_the_smallest_cap_allows_a_table_and_one_less_does_not():
    rows, columns = np.array([9, 7, 5, 3]), np.array([8, 8, 8])
    cap = smallest_cap(rows, columns)
    assert cap == 3  # 9 voxels in three cells
    assert table_shortfall(rows, columns, cap) is None and table_shortfall(rows, columns, cap - 1)


def test_no_design_that_there_is_gets_refused():
    for number in range(200):
        bits = np.array([(number * 2654435761 + 97 * k * k) >> 7 & 1 for k in range(2 * 3 * 4)], bool)
        voxels = bits.reshape(2, 3, 4)
        if 0 < voxels.sum() < voxels.size:
            check_feasible(targets_of_voxels(voxels), CHOICE)


def test_caps_below_what_the_sums_need_are_refused_with_the_smallest_possible():
    with pytest.raises(InfeasibleError, match="the cap on beta must be at least 2, got 1: layers? 0.* along Y"):
        check_caps(Targets(np.array([3, 3]), np.array([4, 2]), np.array([3, 3])),
                   VoxelParameters(strategy="sequential", cap_beta=1))  # fmt: skip


def test_layers_along_two_axes_that_contradict_each_other_are_named():
    # four voxels in the two layers along X of which only one has room for them with one layer along Z
    targets = Targets(np.array([4, 0]), np.array([2, 2]), np.array([4, 0]))
    with pytest.raises(InfeasibleError, match="layer 0 along X ask.* 4 voxels.* along Z leave them at most 2"):
        check_feasible(targets, CHOICE)


def test_layers_along_three_axes_that_contradict_each_other_are_named():
    # 7 voxels in the box of the two fullest layers each way, which holds 8, but 5 + 5 + 5 - 2 * 7 = 1 is fine;
    # 6 + 6 + 6 - 2 * 6: one cell (0, 0, 0) for 6 voxels is not
    targets = Targets(np.array([5, 1, 0]), np.array([5, 1, 0]), np.array([5, 1, 0]))
    with pytest.raises(InfeasibleError, match="along X and layer.* along Y and layer.* along Z|along Z leave them"):
        check_feasible(targets, CHOICE)


def test_a_layer_with_less_room_in_the_mask_than_asked_for_is_named():
    mask = np.ones((2, 2, 2), bool)
    mask[:, :, 1] = False
    targets = Targets(np.array([2, 1]), np.array([2, 1]), np.array([2, 1]))
    with pytest.raises(InfeasibleError, match="within the mask layer 1 along X holds 0 voxels, but is asked for 1"):
        check_feasible(targets, CHOICE, mask)


def test_forced_cells_are_the_same_in_every_design_there_is():
    shared = {}
    for bits in itertools.product((False, True), repeat=12):
        solid = np.array(bits).reshape(2, 2, 3)
        key = tuple(map(tuple, layer_sums(solid)))
        always, ever = shared.get(key, (solid, solid))
        shared[key] = always & solid, ever | solid
    found = 0
    for counts, (always, ever) in shared.items():
        solid, void = forced_cells([np.array(count) for count in counts])
        assert not (solid & ~always).any() and not (void & ever).any(), counts
        found += np.count_nonzero(solid) + np.count_nonzero(void)
    # not all that all designs share is seen, but nearly
    assert found > 0.9 * sum(np.count_nonzero(always) + np.count_nonzero(~ever) for always, ever in shared.values())
