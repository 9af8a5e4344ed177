# SPDX-License-Identifier: LGPL-2.1-or-later
"""Islands joined or dropped, cavities filled."""

import numpy as np
import pytest

from freecad_trabecula.core.voxels import joining
from freecad_trabecula.core.voxels.connectivity import closed_cavities, parts
from freecad_trabecula.core.voxels.joining import depth_below_level, joined_solid, one_part
from freecad_trabecula.core.voxels.plane_offsets import FORBIDDEN, layer_sums, on_field
from freecad_trabecula.core.voxels.texture import Texture, trabecular_field
from freecad_trabecula.errors import ExactnessError


def two_blocks():
    solid = np.zeros((20, 20, 20), bool)
    solid[2:6, 2:6, 2:6] = True
    solid[13:18, 13:18, 13:18] = True
    return solid


def test_large_islands_are_joined_by_a_bar_that_adds_little():
    solid = two_blocks()
    joined = one_part(solid, np.ones(solid.shape, bool))
    assert len(parts(joined)[1]) == 2
    assert (joined & solid).sum() == solid.sum()
    assert joined.sum() - solid.sum() < 120


def test_many_islands_become_one_part():
    solid = np.zeros((24, 24, 24), bool)
    for z in (1, 9, 17):
        for y in (1, 9, 17):
            for x in (1, 9, 17):
                solid[z : z + 4, y : y + 4, x : x + 4] = True
    joined = one_part(solid, np.ones(solid.shape, bool))
    assert len(parts(joined)[1]) == 2
    assert (joined & solid).sum() == solid.sum()


def test_islands_of_two_hundred_voxels_are_joined_however_large_the_box_is():
    solid = np.ones((100, 100, 100), bool)  # a share of 5e-4 would be 500 voxels
    solid[:, :, 80:] = False
    solid[40:46, 40:46, 90:96] = True
    joined = one_part(solid, np.ones(solid.shape, bool))
    assert len(parts(joined)[1]) == 2 and joined[42, 42, 92]


def test_small_islands_are_dropped_and_cavities_filled():
    solid = np.zeros((12, 12, 12), bool)
    solid[1:8, 1:8, 1:8] = True
    solid[4, 4, 4] = False
    solid[10, 10, 10] = True
    expected = np.zeros((12, 12, 12), bool)
    expected[1:8, 1:8, 1:8] = True
    assert np.array_equal(one_part(solid, np.ones(solid.shape, bool)), expected)


def test_bars_stay_in_the_mask():
    solid = two_blocks()
    mask = np.ones(solid.shape, bool)
    mask[9:11] = False
    joined = one_part(solid, mask)
    assert not (joined & ~mask).any()
    assert len(parts(joined)[1]) == 2  # the smaller one is dropped


def test_a_field_becomes_one_part_with_nearly_its_counts():
    field = trabecular_field(Texture((8.0,) * 3, mix=1.0), (40, 40, 40), 3)
    counts = [np.full(40, 240)] * 3
    solid, _ = joined_solid(field, counts)
    assert len(parts(solid)[1]) == 2
    assert len(closed_cavities(solid)[1]) == 1
    assert max(np.abs(s - 240).max() for s in layer_sums(solid)) < 60


def test_short_waves_take_two_fits_and_one_for_what_little_is_left(monkeypatch):
    # dropping only the islands of the level brings up their shells, again and again: five fits did not do
    fits = []
    fit = joining.newton_offsets
    monkeypatch.setattr(joining, "newton_offsets", lambda *a, **k: (fits.append(1), fit(*a, **k))[1])
    field = trabecular_field(Texture((7.0,) * 3), (72, 72, 72), 5)
    joined_solid(field, [np.full(72, 936)] * 3)
    assert len(fits) <= 3


def test_the_lower_level_holds_about_so_many_voxels_and_is_never_higher():
    field = trabecular_field(Texture((7.0,) * 3), (60, 50, 40), 5)
    offsets = [np.linspace(0.2, 0.3, 60), np.zeros(50), np.linspace(0.0, 0.1, 40)]
    heights = on_field(field, offsets)
    solid = np.count_nonzero(heights > 0)
    depth = depth_below_level(field, offsets, 1.4 * solid)
    assert np.count_nonzero(heights > -depth) == pytest.approx(1.4 * solid, rel=0.1)
    assert depth_below_level(field, offsets, 0.5 * solid) == 0
    field[20:] = FORBIDDEN  # not so many voxels may be solid
    assert depth_below_level(field, offsets, 0.9 * field.size) == 0


def test_counts_of_nothing_are_refused():
    field = trabecular_field(Texture((8.0,) * 3), (8, 8, 8), 1)
    with pytest.raises(ExactnessError, match="no part"):
        joined_solid(field, [np.zeros(8, int)] * 3)
