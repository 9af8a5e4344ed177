# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of trabeculae per layer."""

import numpy as np
import pytest
from scipy import ndimage

from freecad_trabecula.core.voxels.connectivity import Solid, parts
from freecad_trabecula.core.voxels.exact_moves import ExactMoves
from freecad_trabecula.core.voxels.joining import joined_solid
from freecad_trabecula.core.voxels.plane_offsets import layer_sums
from freecad_trabecula.core.voxels.targets import targets_of_voxels
from freecad_trabecula.core.voxels.texture import Texture, trabecular_field
from freecad_trabecula.core.voxels.trabeculae import (
    match_trabeculae,
    mean_deviation,
    trabecula_counts,
    wanted_trabeculae,
)  # fmt: skip
from freecad_trabecula.errors import ParameterError


def moves_of(seed, wavelength=9.0, size=36, share=0.8):
    field = trabecular_field(Texture((wavelength,) * 3), (size,) * 3, seed)
    counts = layer_sums(field > np.quantile(field, share))
    solid, offsets = joined_solid(field, counts)
    return ExactMoves(Solid(solid), field, offsets, counts)


def test_counts_are_those_of_labels_layer_by_layer():
    voxels = trabecular_field(Texture((7.0,) * 3), (20, 22, 24), 1) > -0.4
    for axis, counts in zip((2, 1, 0), trabecula_counts(voxels)):
        layers = np.moveaxis(voxels, axis, 0)
        assert counts.tolist() == [ndimage.label(layer)[1] for layer in layers]


def test_deviation_is_the_mean_of_relative_errors():
    assert mean_deviation(np.array([3, 4, 1]), np.array([2, 4, 0])) == pytest.approx((0.5 + 0 + 1) / 3)


@pytest.mark.parametrize("axes", [(0,), (0, 1, 2)])
def test_numbers_of_another_design_are_matched_and_kept_by_exact_moves(axes):
    other = moves_of(7).run()
    goal = trabecula_counts(other)[::-1]
    moves = moves_of(8)
    wanted = [goal[a] if a in axes else None for a in range(3)]
    before = np.mean([mean_deviation(trabecula_counts(moves.solid.voxels)[::-1][a], goal[a]) for a in axes])
    reported = match_trabeculae(moves, wanted)
    voxels = moves.run()
    after = [mean_deviation(trabecula_counts(voxels)[::-1][a], goal[a]) for a in axes]
    assert np.mean(after) < 0.25 * before
    assert [reported[a] for a in axes] == after
    assert len(parts(voxels)[1]) == 2


def test_numbers_that_are_free_are_not_reported():
    moves = moves_of(3)
    goal = trabecula_counts(moves.solid.voxels)[2]
    assert np.isnan(match_trabeculae(moves, [goal, None, None])).tolist() == [False, True, True]


def test_the_sample_is_counted_when_targets_hold_no_numbers():
    sample = np.zeros((3, 4, 5), bool)
    sample[:, 1, 1] = sample[1, 1:3, 3] = True
    targets = targets_of_voxels(sample)
    wanted = wanted_trabeculae(targets, "xz")
    assert wanted[0].tolist() == [1, 2, 1]
    assert wanted[1] is None
    assert wanted[2].tolist() == [0, 1, 0, 1, 0]
    assert wanted_trabeculae(targets, "off") == [None, None, None]


def test_numbers_without_a_sample_are_refused():
    targets = targets_of_voxels(np.eye(4, dtype=bool)[None].repeat(4, 0))
    object.__setattr__(targets, "sample", None)
    with pytest.raises(ParameterError, match="need a sample"):
        wanted_trabeculae(targets, "z")
