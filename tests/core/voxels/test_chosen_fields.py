# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that a design may follow."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.chosen_fields import chosen_field, smooth_noise
from freecad_trabecula.core.voxels.parameters import FIELDS, VoxelParameters

SHAPE = (10, 12, 14)


def field_of(name, **more):
    return chosen_field(VoxelParameters(strategy="by-field", field=name, **more), SHAPE)


@pytest.mark.parametrize("name", FIELDS)
def test_a_field_fills_the_box_with_finite_numbers_that_differ(name):
    field = field_of(name)
    assert field.shape == SHAPE and np.isfinite(field).all() and field.std() > 0


def test_the_centre_is_high_in_the_middle_and_the_border_low_there():
    assert field_of("centre").argmax() in [np.ravel_multi_index(i, SHAPE) for i in np.ndindex(SHAPE) if
                                           i[0] in (4, 5) and i[1] in (5, 6) and i[2] in (6, 7)]  # fmt: skip
    assert (field_of("border") == -field_of("centre")).all()


def test_no_field_is_a_sum_of_functions_of_the_axes():
    # such a field has the same sum on all designs with the same counts
    for name in FIELDS:
        f = field_of(name)
        mixed = f[1:, 1:] - f[:-1, 1:] - f[1:, :-1] + f[:-1, :-1]
        assert np.abs(mixed).max() > 1e-6


def test_the_gyroid_repeats_after_its_wavelength():
    field = field_of("gyroid", size=0.1, wavelength=0.5)
    assert field[:5] == pytest.approx(field[5:])


def test_noise_is_smooth_over_its_wavelength_and_that_of_its_seed():
    def neighbours(length):
        f = smooth_noise((30, 30, 30), (length,) * 3, Stream(1, "n"))
        return float((f[1:] * f[:-1]).mean())

    assert neighbours(1.0) < 0.1 < 0.6 < neighbours(16.0)
    assert (field_of("noise", seed=1) == field_of("noise", seed=1)).all()
    assert (field_of("noise", seed=1) != field_of("noise", seed=2)).any()
