# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of 0/1 matrices, estimated, against lists of all of them and the literature."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.sampled_layers import count_layer, count_layers

MATRICES = np.array(list(itertools.product((0, 1), repeat=16))).reshape(-1, 4, 4)
#: Darwin's finches: 17 islands, 13 species (Chen, Diaconis, Holmes, Liu 2005, table 2; counted exactly there).
ISLANDS = [14, 13, 14, 10, 12, 2, 10, 1, 10, 11, 6, 2, 17]
SPECIES = [4, 4, 11, 10, 10, 8, 9, 10, 8, 9, 3, 10, 4, 7, 9, 3, 3]


@pytest.mark.parametrize(
    ("alpha", "beta"), [([2, 2, 2, 2], [2, 2, 2, 2]), ([1, 3, 2, 2], [3, 1, 2, 2]), ([4, 0, 2, 1], [2, 2, 1, 2])]
)
def test_the_estimate_is_within_four_standard_errors_of_the_number(alpha, beta):
    exact = int(((MATRICES.sum(1) == alpha).all(1) & (MATRICES.sum(2) == beta).all(1)).sum())
    found = count_layer(np.array(alpha), np.array(beta), 2000, Stream(1, "layers"))
    assert found.log10 == pytest.approx(math.log10(exact), abs=4 * found.standard_error + 1e-9)


def test_darwin_s_finches():
    found = count_layer(np.array(ISLANDS), np.array(SPECIES), 3000, Stream(1, "finches"))
    assert found.log10 == pytest.approx(math.log10(67_149_106_137_567_626), abs=4 * found.standard_error)
    assert found.standard_error < 0.05


def test_the_layers_of_a_design_multiply():
    alpha, beta = np.array([[2, 1], [2, 3], [2, 2], [2, 2]]), np.array([[2, 3], [2, 1], [2, 2], [2, 2]])
    both = count_layers(alpha, beta, 2000, Stream(1, "a"))
    single = [count_layer(alpha[:, k], beta[:, k], 2000, Stream(k, "b")) for k in range(2)]
    assert both.log10 == pytest.approx(sum(s.log10 for s in single), abs=4 * both.standard_error + 0.02)


def test_sums_that_no_matrix_has_count_nothing():
    assert count_layer(np.array([2, 0]), np.array([2, 0]), 20, Stream(1, "a")).log10 == -math.inf
    assert count_layer(np.array([1, 1]), np.array([2, 1]), 20, Stream(1, "a")).log10 == -math.inf
