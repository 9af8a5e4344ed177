# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of minimum zeros propagation: the thesis' own figures."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.voxels.propagation_steps import propagation_steps
from freecad_trabecula.errors import ParameterError

#: Rows of Fig. 6.8 to 6.11 from the bottom, beta_0 first.
BETA = np.array([6, 0, 5, 1, 3, 5, 1, 2, 1, 3, 5])


def test_the_incompatible_layer_of_figure_6_9_stops_at_its_fourth_step():
    steps = propagation_steps(np.array([3, 10, 8, 4, 6, 0, 1]), BETA)
    assert [(s.v, s.u, s.alpha.max(), s.beta.max()) for s in steps] == [
        (1, 1, 10, 6),
        (1, 2, 9, 6),
        (1, 3, 8, 6),
        (1, 4, 8, 6),
    ]
    assert steps[1].alpha.tolist() == [3, 9, 8, 4, 6, 0, 1]
    assert steps[2].alpha.tolist() == [3, 8, 8, 4, 6, 0, 1]
    assert steps[3].alpha.tolist() == [3, 7, 8, 4, 6, 0, 1]
    assert [s.is_impossible for s in steps] == [False, False, False, True]
    assert steps[3].condition_6_22 and not steps[3].condition_6_21  # 8 > 11 - 4


def test_the_layer_of_figure_6_8_comes_to_its_design_in_ten_steps():
    alpha = np.array([3, 7, 8, 4, 6, 3, 1])  # as Fig. 6.10 begins; its rows are those of 6.8
    steps = propagation_steps(alpha, BETA)
    assert len(steps) == 11  # A to K
    assert not any(s.is_impossible for s in steps)
    assert (steps[-1].voxels.sum(0) == alpha).all() and (steps[-1].voxels.sum(1) == BETA).all()
    assert (steps[0].v, steps[0].u) == (0, 1)
    assert [s.u for s in steps] == list(range(1, 12))


def test_columns_are_rows_of_the_turned_layer():
    alpha = np.array([3, 7, 8, 4, 6, 3, 1])
    turned = propagation_steps(BETA, alpha, "rows")
    own = propagation_steps(alpha, BETA, "columns")
    assert (own[-1].voxels == turned[-1].voxels.T).all()
    assert (own[0].v, own[0].u) == (turned[0].u, turned[0].v)


def test_the_sequential_order_takes_the_rows_as_they_stand():
    steps = propagation_steps(np.array([3, 7, 8, 4, 6, 3, 1]), BETA, "rows", "sequential")
    assert [s.line for s in steps] == [0, 2, 3, 4, 5, 6, 7, 8, 9, 10, -1]


def test_a_column_longer_than_the_layer_and_unequal_sums_are_refused():
    with pytest.raises(ParameterError, match="alpha must lie in 0..2"):
        propagation_steps(np.array([3, 0]), np.array([2, 1]))
    with pytest.raises(ParameterError, match="same sum, got 2 and 1"):
        propagation_steps(np.array([1, 1]), np.array([1, 0]))
