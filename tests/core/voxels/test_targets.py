# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layer counts: Eq. 6.1, one common total, what no layer holds."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.targets import (
    Targets,
    common_total,
    layer_counts_of_box,
    targets_from_areas,
    targets_of_voxels,
    to_total,
)
from freecad_trabecula.errors import InfeasibleError, ParameterError


def chosen(**more):
    return VoxelParameters(**{"strategy": "sequential", "size": 1.0, **more})


def areas(scale=1.0):
    """Areas of 4 x 3 x 5 layers whose three real totals agree: 30 of 60."""
    x = np.array([6.4, 7.4, 8.7, 7.5]) * scale
    y = np.array([9.9, 10.3, 9.8]) * scale
    z = np.array([6.2, 5.6, 6.6, 5.2, 6.4]) * scale
    return x, y, z


@pytest.mark.parametrize("correction", ["remainders", "random"])
def test_all_axes_get_one_total_and_the_deltas_are_the_thesis(correction):
    targets = targets_from_areas(areas(), chosen(correction=correction))
    assert [int(c.sum()) for c in targets.counts] == [30, 30, 30]
    # Eq. 6.1: 6 + 7 + 9 + 8, 10 + 10 + 10, 6 + 6 + 7 + 5 + 6
    assert targets.deltas == (0, 0, 0)
    shifted = [a + 0.4 / len(a) for a in areas()]
    shifted[0] = areas()[0] + 0.1  # 6.5 and 7.5 round up: 7 + 8 + 9 + 8
    assert targets_from_areas(shifted, chosen(correction=correction)).deltas[0] == 30 - 32


def test_each_count_is_within_one_of_the_real_area_by_largest_remainders():
    targets = targets_from_areas(areas(), chosen())
    for real, counts in zip(areas(), targets.counts):
        assert np.abs(counts - real).max() < 1


def test_the_random_correction_is_that_of_its_seed():
    big = [a * 4 for a in (np.full(40, 9.5), np.full(20, 19.0), np.full(10, 38.0))]
    first, again, other = (targets_from_areas(big, chosen(correction="random", total="z", seed=s)).d for s in (1, 1, 2))
    assert (first == again).all()
    rounded = to_total(np.full(5, 2.5), 13, 9, "random", Stream(1, "a"))
    assert rounded.sum() == 13 and set(rounded.tolist()) <= {1, 2, 3}
    assert other.sum() == first.sum()


def test_cells_that_are_no_cubes_take_each_axis_own_cross_section():
    x, y, z = areas()
    flat = targets_from_areas((x * 6, y * 3, z * 2), chosen(size=(1.0, 2.0, 3.0)))
    cube = targets_from_areas((x, y, z), chosen())
    assert [c.tolist() for c in flat.counts] == [c.tolist() for c in cube.counts]
    assert flat.volume == pytest.approx(30 * 6)


def test_the_total_is_the_mean_of_the_axes_or_one_axis_own():
    real = [np.full(2, 5.2), np.full(2, 5.4), np.full(2, 6.0)]
    assert common_total(real, "mean") == 11  # 33.2 / 3 = 11.07
    assert common_total(real, "x") == 10
    assert common_total(real, "z") == 12


def test_full_layers_pass_on_what_they_cannot_hold():
    counts = to_total(np.array([9.9, 5.0, 5.0]), 22, 10, "remainders", Stream(1, "a"))
    assert counts.sum() == 22 and counts.max() == 10


def test_empty_layers_stay_empty():
    counts = to_total(np.array([0.0, 5.3, 0.0, 4.2]), 12, 10, "remainders", Stream(1, "a"))
    assert counts.sum() == 12 and counts[0] == counts[2] == 0


def test_a_design_fulfils_its_own_targets():
    voxels = np.zeros((4, 3, 2), bool)
    voxels[1, 2, 0] = voxels[3, 2, 1] = True
    targets = targets_of_voxels(voxels, (0.1, 0.1, 0.2))
    assert targets.d.tolist() == [1, 1]
    assert targets.e.tolist() == [0, 0, 2]
    assert targets.c.tolist() == [0, 1, 0, 1]
    assert (targets.layers, targets.shape, targets.layer_sizes) == ((2, 3, 4), (4, 3, 2), (12, 8, 6))


def test_layers_count_when_their_middles_lie_in_the_sample():
    assert layer_counts_of_box((1.0, 0.94, 0.96), (0.1, 0.1, 0.1)) == (10, 9, 10)
    assert layer_counts_of_box((1.0, 0.94, 0.96), (0.1, 0.1, 0.1), "slab") == (10, 10, 10)
    assert layer_counts_of_box((1.0, 1.0, 1.2), (0.5, 0.25, 0.1)) == (2, 4, 12)


# ------------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    ("d", "words"),
    [
        ([1, np.nan], "must be finite, got nan in layer 1 along X"),
        ([3, -1], "must not be negative, got -1 in layer 1 along X"),
        ([0.5, 1.5], "must be whole numbers, got 0.5 in layer 0 along X"),
        ([], "must be a list"),
        (["a", "b"], "must be numbers"),
    ],
)
def test_counts_that_are_no_counts_are_refused(d, words):
    with pytest.raises(ParameterError, match=words):
        Targets(np.array(d), np.array([1, 1]), np.array([1, 1]))


def test_unequal_totals_are_refused_with_their_differences():
    with pytest.raises(InfeasibleError, match=r"got 3, 2 and 4 voxels: X - Z = -1, Y - Z = -2"):
        Targets(np.array([3, 0]), np.array([1, 1]), np.array([2, 2]))


def test_a_layer_over_full_is_refused_by_its_name():
    with pytest.raises(InfeasibleError, match="a layer along X holds 4 voxels, but layer 1 is asked for 5"):
        Targets(np.array([1, 5]), np.array([3, 3]), np.array([3, 3]))


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        (lambda x: x * np.nan, ParameterError, "sliced areas must be finite"),
        (lambda x: x - 7, ParameterError, "must not be negative, got -0.6 mm² in layer 0 along X"),
        (lambda x: x + 12, InfeasibleError, "a layer along X holds 15 voxels"),
    ],
)
def test_areas_that_cannot_be_are_refused(change, error, words):
    x, y, z = areas()
    with pytest.raises(error, match=words):
        targets_from_areas((change(x), y, z), chosen())


def test_an_empty_and_a_full_sample_are_refused():
    with pytest.raises(ParameterError, match="must have material"):
        targets_from_areas([a * 0 for a in areas()], chosen())
    with pytest.raises(ParameterError, match="must have voids"):
        targets_from_areas((np.full(4, 15.0), np.full(3, 20.0), np.full(5, 12.0)), chosen())
    for voxels in (np.zeros((2, 2, 2), bool), np.ones((2, 2, 2), bool)):
        with pytest.raises(ParameterError, match="must have material and voids"):
            targets_of_voxels(voxels)


def test_a_voxel_larger_than_the_sample_is_refused():
    with pytest.raises(ParameterError, match="must not be larger than the sample, 0.9 mm along Y, got 1 mm"):
        layer_counts_of_box((5.0, 0.9, 5.0), (1.0, 1.0, 1.0))


def test_voxels_so_small_that_there_are_too_many_are_refused():
    with pytest.raises(ParameterError, match="GB of memory"):
        layer_counts_of_box((10.0, 10.0, 10.0), (0.001, 0.01, 0.01))


def test_a_sample_of_another_shape_is_refused():
    with pytest.raises(ParameterError, match=r"must have the shape \(1, 2, 2\), got \(2, 2, 1\)"):
        Targets(np.array([1, 1]), np.array([1, 1]), np.array([2]), sample=np.zeros((2, 2, 1), bool))
