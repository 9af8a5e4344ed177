# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pores against closed forms: areas, tangents, mirror images."""

import math

import numpy as np
import pytest

from freecad_trabecula.core import pores as p
from freecad_trabecula.core.laws import Region, constant
from freecad_trabecula.core.parameters import PoreParameters, PrismParameters, SiteEdit
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.errors import ParameterError

CUBE = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))
SITES = prism_sites(PrismParameters(n_x=20, n_y=20, n_z=20))["Face1"]


def curve(pores, points):
    """Points (P, M * points, 2) of the curves, by de Casteljau: not the way in which the module does it."""
    b = p.bezier_poles(pores)[:, :, None]
    t = (np.arange(points) / points)[:, None, None]
    while b.shape[-2] > 1:
        b = b[..., :-1, :] * (1 - t) + b[..., 1:, :] * t
    return b.reshape(len(pores), -1, 2)


def shoelace(polygons):
    after = np.roll(polygons, -1, 1)
    return (polygons[..., 0] * after[..., 1] - polygons[..., 1] * after[..., 0]).sum(1) / 2


SPLINE = PoreParameters()


def draw(parameters=SPLINE, attempt=0, seed=3):
    return p.draw_pores(parameters, seed, SITES, CUBE, attempt)


def test_a_circle_has_the_area_of_its_diameter_and_keeps_its_radius():
    circle = p.circles(np.array([0.2, 0.8]))
    assert circle.areas == pytest.approx(math.pi / 4 * np.array([0.04, 0.64]), rel=1e-12)
    radius = np.linalg.norm(curve(circle, 50), axis=2) / circle.size[:, None]
    assert abs(radius - 0.5).max() < 0.5 * 5e-4


def test_a_square_without_tangents_has_area_size_squared():
    none = np.zeros((1, 4))
    square = p.make_pores(SPLINE, np.array([0.7]), np.full((1, 4), 0.5), none, np.zeros((1, 4, 2)))
    assert square.areas[0] == pytest.approx(0.49)
    assert square.estimated_areas[0] == pytest.approx(0.49)


@pytest.mark.parametrize("corners", [3, 4, 5, 6, 12])
def test_corners_of_every_layout_enclose_the_estimated_area(corners):
    polygon = p.regular_corners(corners)[None]
    assert shoelace(polygon)[0] == pytest.approx(1.0)


def test_exact_area_agrees_with_a_fine_polygon():
    pores = draw()
    assert pores.areas == pytest.approx(shoelace(curve(pores, 400)), rel=2e-5)


def test_mean_area_is_1_46_estimated_areas():
    # measured over ten seeds: 1.46, sd of one pore's ratio 0.02 over the draw
    ratio = draw().areas / draw().estimated_areas
    assert ratio.mean() == pytest.approx(1.46, abs=0.02)


def test_curves_have_one_tangent_in_each_corner():
    b = p.bezier_poles(draw())
    leaving, arriving = b[:, :, 1] - b[:, :, 0], np.roll(b[:, :, 3] - b[:, :, 2], 1, 1)
    assert np.allclose(leaving, arriving)


def test_tangents_lie_between_the_edges_and_have_uniform_components():
    pores = draw()
    tangent = np.stack([np.cos(pores.angles), np.sin(pores.angles)], -1)
    component = np.abs(tangent[..., 0])
    assert component.min() >= 0 and component.max() <= 1
    counts = np.histogram(component, bins=10, range=(0, 1))[0]
    expected = component.size / 10
    assert ((counts - expected) ** 2 / expected).sum() < 27.9  # 99.9 % of chi squared with 9 degrees of freedom
    edge = np.roll(pores.corners, -1, 1) - pores.corners
    assert ((tangent * edge).sum(-1) >= -1e-12).all()


def test_the_mirror_image_is_the_same_curve_seen_from_behind():
    pores = draw(PoreParameters(scatter=0.2))
    mirror = p.mirrored(pores)
    assert mirror.areas == pytest.approx(pores.areas)
    a, b = curve(pores, 10), curve(mirror, 10) * [1, -1]
    # the same points in the other order; the start of the mirrored curve is the last corner
    assert np.allclose(np.roll(b[:, ::-1], 1, 1), np.roll(a, 10, 1)) or np.allclose(np.sort(a, 1), np.sort(b, 1))
    assert np.allclose(p.mirrored(mirror).corners, pores.corners)


@pytest.mark.parametrize("corners", [3, 4, 7])
@pytest.mark.parametrize("quarters", [-5, -1, 0, 1, 2, 9])
def test_turned_pores_are_the_same_curve_in_turned_axes(corners, quarters):
    pores = draw(PoreParameters(corners=corners, scatter=0.1))
    turned = p.turned(pores, np.full(len(pores), quarters))
    angle = 2 * math.pi / corners * quarters
    back = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    points = curve(pores, 8) @ back.T
    assert np.allclose(np.roll(points, 8 * quarters, 1), curve(turned, 8))
    # directions stay near those of the untouched layout, so that averaging two pores makes sense
    assert np.abs(turned.angles - pores.angles.mean(0)).max() < math.pi


def test_polygons_have_exactly_the_area_of_their_curve():
    pores = draw()
    polygon = p.outlines(p.bezier_poles(pores), 16)
    assert polygon.shape[1] == 16
    assert shoelace(polygon) == pytest.approx(pores.areas, rel=1e-12)


def test_no_pore_crosses_itself_up_to_pull_3():
    for pull in (0.5, 1.0, 3.0):
        pores = draw(PoreParameters(pull=constant(pull)))
        assert not p.loops(p.outlines(p.bezier_poles(pores), 64)).any()


def test_a_figure_of_eight_is_seen_as_a_loop():
    eight = np.array([[[-1, -1], [1, 1], [1, -1], [-1, 1]]], float)
    assert p.loops(eight).all()


def test_redrawn_tangents_leave_the_sizes_alone():
    first, second = draw(), draw(attempt=1)
    assert (first.size == second.size).all()
    assert not (first.angles == second.angles).any()


def test_a_pore_depends_on_its_own_site_only():
    few = prism_sites(PrismParameters())["Face1"]
    many = prism_sites(PrismParameters(n_x=9, n_y=8, n_z=9))["Face1"]
    at_random = dict(zip(few.names, p.draw_pores(SPLINE, 3, few, CUBE).size))
    for name, size in zip(many.names, p.draw_pores(PoreParameters(), 3, many, CUBE).size):
        if name in at_random:
            assert size == at_random[name]


def test_size_and_tangents_are_set_by_hand():
    edits = [SiteEdit(SITES.names[2], "pore", size=0.33, turns=(0.0, 0.5, 1.0, 0.5))]
    edited = p.edit_pores(PoreParameters(), draw(), SITES.names, edits)
    assert edited.size[2] == 0.33
    assert edited.angles[2, 0] == pytest.approx(-math.pi / 2)  # component 0 of the leaving edge: along the arriving one
    untouched = np.arange(len(SITES)) != 2
    assert (edited.size[untouched] == draw().size[untouched]).all()


def test_tangents_that_do_not_fit_the_corners_are_refused():
    with pytest.raises(ParameterError, match="takes 4 tangent components, got 3"):
        p.edit_pores(PoreParameters(), draw(), SITES.names, [SiteEdit(SITES.names[0], "pore", turns=(0.1, 0.1, 0.1))])
