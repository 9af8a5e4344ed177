# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts of layers, by a way of their own."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.targets import targets_of_voxels
from freecad_trabecula.core.voxels.verification import check_exact, layer_counts, layer_errors
from freecad_trabecula.errors import ExactnessError

VOXELS = Stream(1, "v").many(5 * 6 * 7).reshape(5, 6, 7) < 0.4


def test_counts_are_the_sums_of_the_planes():
    x, y, z = layer_counts(VOXELS)
    assert x.tolist() == [int(VOXELS[:, :, k].sum()) for k in range(7)]
    assert y.tolist() == [int(VOXELS[:, k].sum()) for k in range(6)]
    assert z.tolist() == [int(VOXELS[k].sum()) for k in range(5)]


def test_a_design_is_exact_for_its_own_targets():
    assert layer_errors(VOXELS, targets_of_voxels(VOXELS)) == []
    check_exact(VOXELS, targets_of_voxels(VOXELS))


def test_one_voxel_more_is_found_on_all_three_axes():
    more = VOXELS.copy()
    z, y, x = np.argwhere(~VOXELS)[3]
    more[z, y, x] = True
    errors = layer_errors(more, targets_of_voxels(VOXELS))
    assert [(e.axis, e.layer, e.got - e.asked) for e in errors] == [("x", x, 1), ("y", y, 1), ("z", z, 1)]
    with pytest.raises(ExactnessError, match=rf"3 layers differ: layer {x} along X: \d+ for \d+"):
        check_exact(more, targets_of_voxels(VOXELS))


def test_a_voxel_moved_along_x_is_found_on_x_alone():
    moved = VOXELS.copy()
    z, y = next((z, y) for z, y in np.ndindex(5, 6) if 0 < VOXELS[z, y].sum() < 7)
    solid, void = np.flatnonzero(VOXELS[z, y])[0], np.flatnonzero(~VOXELS[z, y])[0]
    moved[z, y, [solid, void]] = [False, True]
    assert {e.axis for e in layer_errors(moved, targets_of_voxels(VOXELS))} == {"x"}


def test_a_design_of_another_shape_is_refused():
    with pytest.raises(ExactnessError, match=r"must have the shape \(5, 6, 7\), got \(7, 6, 5\)"):
        layer_errors(VOXELS.T, targets_of_voxels(VOXELS))
