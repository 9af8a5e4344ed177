# SPDX-License-Identifier: LGPL-2.1-or-later
"""The best layer of given tables, against every layer that there is."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.best_layer import best_layer, best_layers
from freecad_trabecula.errors import InfeasibleError

MATRICES = [np.array(bits).reshape(3, 4) for bits in itertools.product((0, 1), repeat=12)]


@pytest.mark.parametrize("seed", range(5))
def test_no_layer_with_the_same_sums_is_higher_on_the_field(seed):
    field = Stream(seed, "f").many(12).reshape(3, 4)
    alpha, beta = np.array([2, 1, 2, 1]), np.array([3, 1, 2])
    found = best_layer(field, alpha, beta)
    there_are = [m for m in MATRICES if (m.sum(0) == alpha).all() and (m.sum(1) == beta).all()]
    assert (found.sum(0) == alpha).all() and (found.sum(1) == beta).all()
    assert (field * found).sum() == pytest.approx(max((field * m).sum() for m in there_are))


def test_layers_are_each_their_own():
    field = Stream(1, "f").many(24).reshape(2, 3, 4)
    alpha, beta = np.array([[2, 1], [1, 1], [2, 1], [1, 0]]), np.array([[3, 1], [1, 1], [2, 1]])
    layers = best_layers(field, alpha, beta)
    assert all((layers[k] == best_layer(field[k], alpha[:, k], beta[:, k])).all() for k in range(2))


def test_tables_without_a_layer_are_refused():
    with pytest.raises(InfeasibleError, match="no layer has these 4 voxels in columns and 4 in rows"):
        best_layer(np.zeros((2, 3)), np.array([2, 2, 0]), np.array([3, 1]))
