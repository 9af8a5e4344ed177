# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs decided for certain, by weights of layers and by branch and bound."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.voxels.exact_search import is_small, searched_design
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.targets import Targets
from freecad_trabecula.core.voxels.verification import layer_errors
from freecad_trabecula.errors import ExactnessError, InfeasibleError

CHOICE = VoxelParameters(strategy="sequential", size=1.0)


def targets(d, e, c):
    return Targets(np.array(d), np.array(e), np.array(c))


@pytest.mark.parametrize(
    "counts", [((6, 2), (4, 4, 0), (4, 2, 2)), ((5, 2, 2), (7, 1, 1), (5, 3, 1)), ((7, 3, 3), (9, 2, 2), (5, 5, 3))]
)
def test_targets_that_random_tables_miss_have_a_design(counts):
    # all three are counts of designs: found by listing every design of these boxes
    assert layer_errors(searched_design(targets(*counts), CHOICE), targets(*counts)) == []


def test_caps_and_mask_are_kept():
    asked = targets((4, 4), (4, 4), (4, 4))
    voxels = searched_design(
        Targets(np.array([2, 2]), np.array([2, 2]), np.array([2, 2])),
        VoxelParameters(strategy="sequential", cap_alpha=1, cap_beta=1),
    )
    assert voxels.sum(1).max() == 1 and voxels.sum(2).max() == 1
    mask = np.ones((2, 2, 3), bool)
    mask[:, :, 2] = False
    voxels = searched_design(Targets(np.array([2, 2, 0]), np.array([2, 2]), np.array([2, 2])), CHOICE, mask)
    assert not voxels[~mask].any()
    assert asked.total == 8


def test_weights_of_layers_prove_that_there_is_none():
    # no set of layers contradicts by itself; the weights in the message can be checked by hand:
    # a design's voxels weigh at most what its cells of positive weight do
    with pytest.raises(InfeasibleError, match=r"layer 0 along X 1 times, .*: the counts weigh 6, no design above 5"):
        searched_design(targets((4, 2), (4, 2), (4, 2, 0)), CHOICE)


def test_a_mask_too_narrow_is_proved_so():
    mask = np.zeros((2, 2, 2), bool)
    mask[0, 0, 0] = mask[1, 1, 1] = True
    with pytest.raises(InfeasibleError, match="the layers contradict each other"):
        searched_design(targets((1, 1), (1, 1), (2, 0)), CHOICE, mask)


def test_large_boxes_are_not_searched():
    asked = targets([40] * 25, [40] * 25, [40] * 25)
    assert not is_small(asked)
    with pytest.raises(ExactnessError, match="up to 8000 cells, got 15625"):
        searched_design(asked, CHOICE)
