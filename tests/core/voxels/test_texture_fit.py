# SPDX-License-Identifier: LGPL-2.1-or-later
"""Textures fitted to samples that were made with known ones."""

import numpy as np
import pytest
from scipy import ndimage

from freecad_trabecula.core.voxels.plane_offsets import layer_sums
from freecad_trabecula.core.voxels.texture import Texture, trabecular_field
from freecad_trabecula.core.voxels.texture_fit import (
    crossing_rates,
    crossing_tensor,
    fitted_texture,
    has_surface,
    trabecula_area,
)  # fmt: skip
from freecad_trabecula.errors import ParameterError


def sample_of(texture, seed=11, size=64, share=0.75):
    field = trabecular_field(texture, (size,) * 3, seed)
    return field > np.quantile(field, share)


def test_crossings_of_a_stack_of_plates_are_those_along_its_normal():
    plates = np.zeros((30, 30, 30), bool)
    plates[:, :, ::6] = plates[:, :, 1::6] = plates[:, :, 2::6] = True
    # one crossing every 3 voxels along x: 9 in 29 pairs
    assert crossing_tensor(plates)[0, 0] == pytest.approx((9 / 29) ** 2, rel=0.05)
    assert abs(crossing_tensor(plates)[1, 1]) < 0.1 * crossing_tensor(plates)[0, 0]
    assert crossing_rates(plates).min() == 0


@pytest.mark.parametrize("lengths", [(12.0, 12.0, 12.0), (10.0, 14.0, 18.0)])
def test_wavelengths_that_made_a_sample_are_found_again(lengths):
    texture = fitted_texture(sample_of(Texture(lengths, mix=0.3)), 0.3)
    assert np.diag(texture.wave_matrix()) == pytest.approx(lengths, rel=0.15)


def test_turned_waves_are_found_again():
    c, s = np.cos(0.6), np.sin(0.6)
    axes = ((c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0))
    made = Texture((20.0, 10.0, 12.0), axes)
    found = fitted_texture(sample_of(made), 0.3).wave_matrix()
    assert found[0, 1] == pytest.approx(made.wave_matrix()[0, 1], rel=0.35)


def test_sheets_and_rods_are_told_apart():
    sheets, rods = (fitted_texture(sample_of(Texture((10.0,) * 3, mix=mix))).mix for mix in (0.02, 1.0))
    assert sheets < 0.1 < 0.3 < rods


def test_the_area_of_trabeculae_is_weighed_by_area():
    solid = np.zeros((4, 9, 9), bool)
    solid[:, 1:4, 1:4] = solid[:, 7, 7] = True
    across_z = (9 * 9 + 1) / 10
    sizes = [ndimage.label(solid[:, 1])[1], layer_sums(solid)[1][1]]
    assert sizes == [1, 12]
    across_side = (12 * 12 * 3 + 4 * 4) / (12 * 3 + 4)
    assert trabecula_area(solid) == pytest.approx((across_z + 2 * across_side) / 3)


@pytest.mark.parametrize("fill", [False, True])
def test_a_sample_without_surface_is_refused(fill):
    with pytest.raises(ParameterError, match="surface"):
        fitted_texture(np.full((12, 12, 12), fill))


def test_a_surface_is_told_where_a_texture_can_be_fitted():
    solid = np.ones((8, 8, 8), bool)
    assert not has_surface(solid)
    solid[7, 7, 7] = False
    assert not has_surface(solid)  # crossed once in a hundred voxels
    solid[4:] = False
    assert has_surface(solid)
