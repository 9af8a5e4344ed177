# SPDX-License-Identifier: LGPL-2.1-or-later
"""Overlap of designs."""

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.variants import chance_overlap, overlaps
from freecad_trabecula.errors import ParameterError


def test_overlaps_are_common_voxels_over_the_mean_of_both():
    first, second = np.zeros((2, 2, 2), bool), np.zeros((2, 2, 2), bool)
    first[0] = second[:, 0] = True
    third = np.ones((2, 2, 2), bool)
    assert overlaps([first, second, third]).tolist() == [[1, 0.5, 2 / 3], [0.5, 1, 2 / 3], [2 / 3, 2 / 3, 1]]


def test_unrelated_designs_share_what_chance_says():
    draws = Stream(1, "test").many(2 * 30**3).reshape(2, 30, 30, 30)
    share = np.linspace(0.1, 0.5, 30)
    first, second = draws < share
    assert overlaps([first, second])[0, 1] == pytest.approx(chance_overlap(first), rel=0.05)


def test_designs_of_other_shapes_are_refused():
    with pytest.raises(ParameterError, match="one shape"):
        overlaps([np.ones((2, 2, 2), bool), np.ones((2, 2, 3), bool)])


@pytest.mark.parametrize("call", [chance_overlap, lambda design: overlaps([design])])
def test_empty_designs_are_refused(call):
    with pytest.raises(ParameterError, match="solid voxels"):
        call(np.zeros((2, 2, 2), bool))
