# SPDX-License-Identifier: LGPL-2.1-or-later
"""The law exp(tilt x) on 0..cap, against sums over all its values."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.voxels.cell_laws import geometric


@pytest.mark.parametrize("cap", [1, 7, 103])
@pytest.mark.parametrize("tilt", [-3.0, -2e-5, -5e-6, 0.0, 9e-6, 1e-4, 0.4])
def test_sum_mean_and_variance_are_those_of_all_values(cap, tilt):
    values = np.arange(cap + 1)
    weights = np.exp(tilt * values)
    chance = weights / weights.sum()
    mean = (chance * values).sum()
    found = [float(part) for part in geometric(np.array(tilt), cap)]
    assert found == pytest.approx([np.log(weights.sum()), mean, (chance * (values - mean) ** 2).sum()], rel=1e-5)
