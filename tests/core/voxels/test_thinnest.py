# SPDX-License-Identifier: LGPL-2.1-or-later
"""Least thickness of solid and void."""

import numpy as np
import pytest
from scipy import ndimage

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.connectivity import edge_contacts, parts
from freecad_trabecula.core.voxels.plane_offsets import FORBIDDEN, layer_sums
from freecad_trabecula.core.voxels.texture import Texture, trabecular_field
from freecad_trabecula.core.voxels.thinnest import ThickSolid, in_cubes, thick_start, thin_voxels
from freecad_trabecula.errors import ExactnessError


@pytest.mark.parametrize("edge", [1, 2, 3, 4])
def test_voxels_in_cubes_are_those_of_an_opening(edge):
    solid = (Stream(edge, "test").uniform(12**3) < 0.9).reshape(12, 12, 12)
    around = np.pad(solid, edge, constant_values=True)
    expected = ndimage.binary_opening(around, np.ones((edge,) * 3))[(slice(edge, -edge),) * 3]
    assert np.array_equal(in_cubes(solid, edge), expected)


def test_a_wall_of_one_voxel_is_thin_and_one_of_two_is_not():
    wall = np.zeros((8, 8, 8), bool)
    wall[:, :, 3] = True
    assert thin_voxels(wall, 2) == (64, 0)
    wall[:, :, 4] = True
    assert thin_voxels(wall, 2) == (0, 0)


def test_a_gap_of_one_voxel_is_narrow():
    solid = np.ones((8, 8, 8), bool)
    solid[:, :, 3] = False
    assert thin_voxels(solid, 1, 2) == (0, 64)


@pytest.mark.parametrize("thickness, void", [(2, 1), (2, 2), (3, 2)])
def test_flips_that_are_allowed_keep_the_thickness(thickness, void):
    field = trabecular_field(Texture((14.0,) * 3), (22, 22, 22), 2)
    counts = layer_sums(field > np.quantile(field, 0.6))
    voxels, _ = thick_start(field, counts, thickness, void)
    solid = ThickSolid(voxels, None, thickness, void)
    index = solid.index_of(*(a.ravel() for a in np.indices(voxels.shape)))
    allowed = np.flatnonzero(solid.flippable(index))
    assert thin_voxels(voxels, thickness, void) == (0, 0)
    assert len(allowed) > 5
    for place in allowed[:: max(1, len(allowed) // 60)]:
        flipped = voxels.copy()
        flipped.reshape(-1)[place] ^= True
        assert thin_voxels(flipped, thickness, void) == (0, 0)


def test_flips_of_thick_solids_that_are_apart_may_be_made_at_once():
    field = trabecular_field(Texture((14.0,) * 3), (22, 22, 22), 3)
    voxels, _ = thick_start(field, layer_sums(field > np.quantile(field, 0.6)), 2, 2)
    solid = ThickSolid(voxels, None, 2, 2)
    index = solid.index_of(*(a.ravel() for a in np.indices(voxels.shape)))
    index = index[solid.flippable(index)]
    chosen = index[solid.apart(index)]
    solid.flip(chosen)
    assert len(chosen)
    assert thin_voxels(solid.voxels, 2, 2) == (0, 0)
    assert len(parts(solid.voxels)[1]) == 2


def test_a_start_without_contacts_has_none():
    field = trabecular_field(Texture((12.0,) * 3, mix=1.0), (24, 24, 24), 4)
    voxels, _ = thick_start(field, layer_sums(field > np.quantile(field, 0.75)), 2, 1, contacts=False)
    assert edge_contacts(voxels) == 0


def test_a_thickness_that_the_mask_has_nowhere_is_refused():
    field = trabecular_field(Texture((6.0,) * 3), (12, 12, 12), 1)
    field[:4] = field[6:] = FORBIDDEN
    counts = layer_sums(field > np.quantile(field, 0.9))
    with pytest.raises(ExactnessError, match="at least 4 and void 1 voxels thick"):
        thick_start(field, counts, 4, 1)
