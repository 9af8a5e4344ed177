# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawn curves: smooth, within their points, against scipy's and closed forms; one volume; targets; refusals."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.design import make_design
from freecad_trabecula.core.voxels.drawn_curves import (
    DrawnCurves,
    curve_values,
    curve_volumes,
    curves_of_areas,
    reconciled,
    targets_of_curves,
)
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ParameterError

PLACES = np.linspace(0, 1, 401)


@pytest.mark.parametrize("seed", range(20))
def test_a_curve_is_the_monotone_cubic_through_its_points(seed):
    count = 2 + seed % 7
    x = np.sort(Stream(seed, "x").uniform(count)) * 0.9 + 0.05 + np.arange(count) * 1e-3
    y = Stream(seed, "y").uniform(count)
    inside = PLACES[(x[0] <= PLACES) & (x[-1] >= PLACES)]
    points = np.stack([x, y], 1)
    assert np.abs(curve_values(points, inside) - PchipInterpolator(x, y)(inside)).max() < 1e-12
    values = curve_values(points, PLACES)
    assert values.min() >= y.min() - 1e-12 and values.max() <= y.max() + 1e-12
    assert (values[x[0] >= PLACES] == y[0]).all() and (values[x[-1] <= PLACES] == y[-1]).all()


def test_volumes_of_straight_curves_have_their_closed_form():
    curves = DrawnCurves((2, 3, 4), ((0, 0.0), (1, 1.0)), ((0.5, 0.25),), ((0, 0.2), (0.5, 0.2), (1, 0.2)))
    assert np.allclose(curve_volumes(curves), [12, 6, 4.8], rtol=1e-9)


def test_reconciled_curves_ask_for_the_mean_volume_and_keep_their_shape():
    curves = DrawnCurves((5, 5, 5), ((0, 0.1), (1, 0.3)), ((0, 0.4), (0.5, 0.2), (1, 0.4)), ((0.2, 0.3),))
    mean = sum(curve_volumes(curves)) / 3
    same = reconciled(curves)
    assert np.allclose(curve_volumes(same), mean, rtol=1e-6)
    for before, after in zip(curves.curves, same.curves):
        ratios = [b[1] / a[1] for a, b in zip(before, after)]
        assert np.allclose(ratios, ratios[0])
    full = reconciled(DrawnCurves((1, 1, 1), ((0, 1.0), (0.5, 0.1), (1, 1.0)), ((0, 0.9),), ((0, 0.9),)))
    assert np.allclose(curve_volumes(full), curve_volumes(full)[1], rtol=1e-4)
    assert max(share for _, share in full.x) == 1.0


def test_a_profile_becomes_a_curve_with_few_points_near_it():
    z = (np.arange(50) + 0.5) / 50
    areas = [4 * (0.3 + 0.2 * np.sin(3 * z)), 4 * np.full(50, 0.25), 4 * (0.5 - 0.4 * z)]
    curves = curves_of_areas(areas, 2 / 50)
    assert curves.edges == pytest.approx((2, 2, 2))
    assert [len(points) for points in curves.curves][1:] == [2, 2] and len(curves.x) < 12
    for points, own in zip(curves.curves, areas):
        assert np.abs(curve_values(points, z) - own / 4).max() <= 0.011 * (own / 4).max()


def test_a_design_has_the_shares_that_were_drawn():
    curves = reconciled(DrawnCurves((4, 4, 4), ((0, 0.2), (1, 0.6)), ((0, 0.4),), ((0, 0.6), (0.5, 0.2), (1, 0.6))))
    parameters = VoxelParameters(size=0.2, strategy="minimum-zeros")
    targets = targets_of_curves(curves, parameters)
    assert targets.layers == (20, 20, 20) and max(np.abs(targets.deltas)) <= 20
    voxels = make_design(targets, parameters).voxels
    middles = (np.arange(20) + 0.5) / 20
    for points, axes in zip(curves.curves, ((0, 1), (0, 2), (1, 2))):
        assert np.abs(voxels.mean(axes) - curve_values(points, middles)).max() < 2.5 / 400


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"x": ((0.0, -0.1),)}, "sliced area along X must not be negative, got -0.1 of it at 0"),
        ({"y": ((0.5, 1.2),)}, "sliced area along Y must not be larger than its layer, got 1.2 of it at 0.5"),
        ({"z": ((1.5, 0.2),)}, "places along Z must lie in 0..1 of the edge, got 1.5"),
        ({"z": ((float("nan"), 0.2),)}, "must lie in 0..1"),
        ({"x": ()}, "along X must have at least one point, got 0"),
        ({"x": ((0.3, 0.1), (0.3, 0.2))}, "must lie apart by at least 0.001, got 0.3 and 0.3"),
        ({"edges": (1.0, 0.0, 1.0)}, "edges of a drawn box must be above 0, got 0 mm"),
        ({"edges": (1.0, 1.0)}, "must have three edges, got 2"),
    ],
)
def test_bad_curves_are_refused(change, words):
    with pytest.raises(ParameterError, match=words):
        DrawnCurves(**change)


def test_curves_that_leave_the_box_empty_or_full_are_refused():
    empty = DrawnCurves(x=((0, 0.0),), y=((0, 0.0),), z=((0, 0.0),))
    with pytest.raises(ParameterError, match="must have material"):
        targets_of_curves(empty, VoxelParameters(size=1.0))
    with pytest.raises(ParameterError, match="must ask for some material"):
        reconciled(empty)
    full = DrawnCurves(x=((0, 1.0),), y=((0, 1.0),), z=((0, 1.0),))
    with pytest.raises(ParameterError, match="must have voids"):
        targets_of_curves(full, VoxelParameters(size=1.0))
