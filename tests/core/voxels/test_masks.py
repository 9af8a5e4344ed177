# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs in an envelope."""

import numpy as np
import pytest

from freecad_trabecula.core.voxels.masks import main_part, targets_within
from freecad_trabecula.errors import InfeasibleError, ParameterError


def ball(size):
    z, y, x = np.ogrid[:size, :size, :size]
    return (z - size / 2 + 0.5) ** 2 + (y - size / 2 + 0.5) ** 2 + (x - size / 2 + 0.5) ** 2 <= (size / 2) ** 2


def test_strays_of_the_boundary_are_left_out():
    mask = np.zeros((30, 30, 30), bool)
    mask[2:28, 2:28, 2:28] = True
    stray = mask.copy()
    stray[29, 29, 29] = True
    assert np.array_equal(main_part(stray), mask)


def test_targets_are_shares_of_the_cells_of_each_layer():
    mask = ball(24)
    targets = targets_within(mask, (0.25,) * 3)
    cells = mask.sum((0, 1))
    assert targets.total == round(mask.sum() / 4)
    assert np.abs(targets.d - cells / 4).max() <= 1
    assert targets.d.tolist() == targets.e.tolist() == targets.c.tolist()


def test_profiles_keep_their_shape_when_totals_differ():
    mask = ball(24)
    low, high = np.linspace(0.1, 0.3, 24), np.full(24, 0.4)
    targets = targets_within(mask, (low, high, high))
    cells = mask.sum((0, 1))
    totals = [(low * cells).sum(), (high * cells).sum(), (high * cells).sum()]
    assert targets.total == round(sum(totals) / 3)
    assert np.abs(targets.d - low * cells * targets.total / totals[0]).max() <= 1


def test_layers_without_cells_ask_for_nothing_and_full_ones_for_no_more_than_they_hold():
    mask = np.zeros((10, 10, 10), bool)
    mask[2:8, 2:8, 2:8] = True
    density = np.full(10, 0.5)
    density[4] = 1.0
    targets = targets_within(mask, (density, 0.9, 0.9))
    assert targets.d[[0, 1, 8, 9]].tolist() == [0, 0, 0, 0]
    assert targets.d[4] == 36


@pytest.mark.parametrize("density", [-0.1, 1.5, np.nan])
def test_densities_outside_0_to_1_are_refused(density):
    with pytest.raises(ParameterError, match="densities must be 0 to 1"):
        targets_within(ball(8), (density, 0.3, 0.3))


def test_an_empty_mask_is_refused():
    with pytest.raises(ParameterError, match="at least one cell"):
        main_part(np.zeros((4, 4, 4), bool))


def test_a_mask_in_two_parts_is_refused_with_their_sizes():
    mask = np.zeros((10, 4, 4), bool)
    mask[:4] = mask[6:] = True
    with pytest.raises(ParameterError, match="parts of 64 and 64 cells"):
        main_part(mask)


def test_layers_that_cannot_hold_the_common_total_are_refused():
    mask = np.ones((6, 6, 6), bool)
    one_layer = np.zeros(6)
    one_layer[2] = 1.0
    with pytest.raises(InfeasibleError, match="along X have 36 cells"):
        targets_within(mask, (one_layer, 0.9, 0.9))
