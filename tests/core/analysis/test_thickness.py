# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness by spheres: exact against brute force; plates, rods and balls of known thickness at any angle."""

import numpy as np
import pytest

from freecad_trabecula.core.analysis import thickness as t
from freecad_trabecula.errors import Cancelled, MeshError


def grid(n):
    """Centres (n, n, n) of voxels from the middle of the array, as z, y, x."""
    return np.meshgrid(*(np.arange(n) - (n - 1) / 2,) * 3, indexing="ij")


def blobs(shape, seed):
    """Irregular bodies: neighbourhood means of noise above their median."""
    noise = np.random.default_rng(seed).uniform(size=shape)
    for axis in range(3):
        for shift in (1, 2, 3):
            noise = noise + np.roll(noise, shift, axis)
    return noise > np.quantile(noise, 0.3)


def distances_by_hand(inside):
    outside = np.argwhere(~inside)
    squared = np.zeros(inside.shape, int)
    for place in np.argwhere(inside):
        squared[tuple(place)] = ((outside - place) ** 2).sum(1).min()
    return squared


@pytest.mark.parametrize("seed", range(3))
def test_squared_distances_agree_with_brute_force(seed):
    inside = blobs((9, 12, 14), seed)
    assert np.array_equal(t.squared_distances(inside), distances_by_hand(inside))


@pytest.mark.parametrize("seed", range(3))
def test_distances_agree_with_another_program(seed):
    ndimage = pytest.importorskip("scipy.ndimage")
    inside = blobs((31, 24, 37), seed)
    assert np.array_equal(t.squared_distances(inside), np.rint(ndimage.distance_transform_edt(inside) ** 2))


@pytest.mark.parametrize("seed", range(6))
def test_the_largest_ball_over_each_voxel_agrees_with_brute_force(seed):
    inside = blobs((15, 18, 13), seed)
    squared = t.squared_distances(inside).astype(int)
    expected = np.zeros(inside.shape, int)
    places = np.argwhere(inside)
    for centre in places:
        covered = tuple(places[((places - centre) ** 2).sum(1) < squared[tuple(centre)]].T)
        expected[covered] = np.maximum(expected[covered], squared[tuple(centre)])
    assert np.array_equal(t.squared_radii(inside), expected)


@pytest.mark.parametrize("voxels", [3, 4, 5, 10, 11])
def test_a_plate_along_the_grid_is_right_if_even_and_a_voxel_too_thick_if_odd(voxels):
    inside = np.zeros((40, 30, 30), bool)
    inside[12 : 12 + voxels] = True
    found = t.local_thickness(inside, 0.1)
    assert np.ptp(found[inside]) == 0
    assert found[inside][0] == pytest.approx(0.1 * (voxels + voxels % 2))
    assert not found[~inside].any()


def mean_error(body, thickness, of=np.mean):
    """Mean error in voxels over ten directions and places of a body, given as a squared distance from its middle."""
    rng = np.random.default_rng(7)
    axes = np.stack(grid(44), -1)
    errors = []
    for _ in range(10):
        unit = rng.normal(size=3)
        place = axes - rng.uniform(-0.5, 0.5, 3)
        inside = body(place, unit / np.linalg.norm(unit)) <= thickness**2 / 4
        found = t.local_thickness(inside, 1.0)[8:36, 8:36, 8:36]  # clear of the array's ends
        errors.append(of(found[found > 0]) - thickness)
    return np.mean(errors)


@pytest.mark.parametrize("thickness", [4.0, 7.0, 10.3, 15.6])
def test_plates_at_any_angle_and_place_are_right_to_six_tenths_of_a_voxel(thickness):
    assert mean_error(lambda place, unit: (place @ unit) ** 2, thickness) == pytest.approx(0.4, abs=0.2)


@pytest.mark.parametrize("thickness", [4.0, 7.0, 10.3, 15.6])
def test_rods_at_any_angle_and_place_are_right_to_four_tenths_of_a_voxel(thickness):
    error = mean_error(lambda place, unit: ((place - (place @ unit)[..., None] * unit) ** 2).sum(-1), thickness)
    assert error == pytest.approx(-0.2, abs=0.2)


@pytest.mark.parametrize("thickness", [7.0, 10.3, 15.6])
def test_balls_at_any_place_are_right_to_one_voxel_at_their_largest(thickness):
    error = mean_error(lambda place, unit: (place**2).sum(-1), thickness, np.max)
    assert error == pytest.approx(-0.8, abs=0.3)


def test_spaces_between_plates_are_their_distance():
    inside = np.zeros((60, 20, 20), bool)
    inside[::16] = inside[1::16] = True  # plates 2 thick, 14 apart
    found = t.local_thickness(~inside, 0.2)
    between = found[20:30]
    assert between.min() == between.max() == pytest.approx(0.2 * 14)


def test_thickness_does_not_depend_on_how_the_body_lies():
    inside = blobs((14, 17, 20), 4)
    found = t.local_thickness(inside, 1.0)
    turned = t.local_thickness(inside.transpose(2, 0, 1)[::-1], 1.0)
    assert np.array_equal(turned, found.transpose(2, 0, 1)[::-1])


def test_a_distribution_has_its_mean_spread_and_quantiles():
    found = t.size_distribution(np.array([[[0.25, 0.25, 0.85, 0.0]]]), 0.1)
    assert found.mean == pytest.approx(0.45)
    assert found.deviation == pytest.approx(np.std([0.25, 0.25, 0.85]))
    assert found.shares == pytest.approx([0, 0, 2 / 3, 0, 0, 0, 0, 0, 1 / 3])
    assert found.quantile(1 / 3) == pytest.approx(0.25)
    assert found.quantile(1.0) == pytest.approx(0.9)


def test_a_distribution_counts_only_what_lies_within_and_may_be_empty():
    values = np.array([[[0.25, 0.85]]])
    assert t.size_distribution(values, 0.1, np.array([[[False, True]]])).mean == pytest.approx(0.85)
    nothing = t.size_distribution(np.zeros((2, 2, 2)), 0.1)
    assert (nothing.mean, nothing.largest, nothing.shares.sum()) == (0, 0, 0)


def test_an_array_without_a_surface_has_no_thickness():
    with pytest.raises(MeshError, match="a thickness needs a surface"):
        t.local_thickness(np.ones((4, 4, 4), bool), 0.1)
    assert not t.local_thickness(np.zeros((4, 4, 4), bool), 0.1).any()


@pytest.mark.parametrize("word", ["distances", "largest balls", "painting balls"])
def test_cancelling_stops_every_part_of_the_work(word):
    def cancel(done, total, what):
        if what == word:
            raise Cancelled("stop")

    with pytest.raises(Cancelled):
        t.local_thickness(blobs((12, 12, 12), 0), 1.0, cancel)
