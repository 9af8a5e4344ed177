# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes filled to a share: the same share in every layer, within the mask."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.core.voxels.envelope_sources import targets_of_envelope
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ParameterError

CHOICE = VoxelParameters(strategy="sequential", size=0.1)
Z, Y, X = np.ogrid[-6:7, -6:7, -6:7]
BALL = X * X + Y * Y + Z * Z <= 36
MESH = block_mesh(BALL, (0.1, 0.1, 0.1), (5.0, 6.0, 7.0))


def test_every_layer_gets_its_share_of_the_envelope_s_cells():
    targets, mask = targets_of_envelope(MESH.corners, 0.4, CHOICE)
    assert (mask == BALL).all()
    assert targets.origin == pytest.approx((5, 6, 7))
    assert targets.total == round(0.4 * BALL.sum())
    for counts, across in zip(targets.counts, ((0, 1), (0, 2), (1, 2))):
        assert np.abs(counts - 0.4 * BALL.sum(across)).max() <= 1


def test_a_grid_that_does_not_fit_is_laid_about_the_middle():
    targets, mask = targets_of_envelope(MESH.corners, 0.4, VoxelParameters(strategy="sequential", size=0.17))
    middle = np.asarray(targets.origin) + 0.5 * 0.17 * np.asarray(targets.layers)
    assert middle == pytest.approx((5.65, 6.65, 7.65))
    assert (mask == mask[::-1, ::-1, ::-1]).all()


@pytest.mark.parametrize("density", [0.0, 1.0, -0.1, float("nan")])
def test_a_share_that_is_none_is_refused(density):
    with pytest.raises(ParameterError, match="must lie between 0 and 1"):
        targets_of_envelope(MESH.corners, density, CHOICE)


def test_an_envelope_of_two_bodies_is_refused():
    two = np.zeros((4, 4, 9), bool)
    two[:, :, :4] = two[:, :, 5:] = True
    with pytest.raises(ParameterError, match="must be in one part, got parts of 64 and 64 cells"):
        targets_of_envelope(block_mesh(two, (0.1, 0.1, 0.1)).corners, 0.4, CHOICE)
