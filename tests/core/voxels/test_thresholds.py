# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thresholds: Otsu's against its definition by trial of every value; what cannot be parted is refused."""

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.thresholds import material, otsu_threshold
from freecad_trabecula.errors import ParameterError


def between_variance(values, threshold):
    low, high = values[values <= threshold], values[values > threshold]
    return len(low) * len(high) * (low.mean() - high.mean()) ** 2


def test_otsu_is_the_best_of_all_thresholds():
    u = Stream(1, "grey").uniform(4000)
    values = np.where(u < 0.7, 60 + 80 * u, 150 + 90 * u).astype(int)
    every = [between_variance(values, t) for t in range(values.min(), values.max())]
    # 256 bins over fewer than 256 grey values: no two of them share a bin
    assert between_variance(values, otsu_threshold(values)) == pytest.approx(max(every), rel=1e-12)


def test_masks_need_no_threshold():
    mask = np.array([[[0, 1, 1]]])
    assert material(mask).tolist() == [[[False, True, True]]]
    assert material(mask * 255).tolist() == material(mask > 0).tolist()


def test_a_given_threshold_is_taken_and_values_above_it_are_material():
    assert material(np.array([[[1, 2, 3]]]), 2).tolist() == [[[False, False, True]]]


@pytest.mark.parametrize("values", [np.full((1, 1, 4), 7), np.zeros((1, 2, 2), bool), np.ones((1, 2, 2), bool)])
def test_a_sample_of_one_kind_is_refused(values):
    with pytest.raises(ParameterError, match="material and voids|more than one grey value"):
        material(values)


def test_a_threshold_above_all_values_is_refused_with_the_count():
    with pytest.raises(ParameterError, match="above 9 are solid, got 0"):
        material(np.array([[[1, 2]]]), 9)
