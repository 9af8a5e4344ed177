# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mean intercept length and fabric, on plates, rods, balls and ellipsoids with closed forms."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis import anisotropy as a
from freecad_trabecula.core.analysis.voxelise import Voxels
from freecad_trabecula.errors import Cancelled, MeshError, ParameterError


def bodies(half_axes, n=96, seed=1):
    """Voxels of ellipsoids with half axes (x, y, z), one somewhere in each cell of a grid, and how many there are."""
    rng = np.random.default_rng(seed)
    half_axes = np.array(half_axes, float)
    cells = (n / (2 * half_axes + 4)).astype(int)
    z, y, x = np.indices((n, n, n)) + 0.5
    solid = np.zeros((n, n, n), bool)
    for cell in np.ndindex(*cells):
        centre = (np.array(cell) + rng.uniform(0.45, 0.55, 3)) * n / cells
        solid |= sum(((p - m) / h) ** 2 for p, m, h in zip((x, y, z), centre, half_axes)) <= 1
    return Voxels(solid, 1.0), int(cells.prod())


def turned_plates(normal, period=16.0, n=96):
    z, y, x = np.indices((n, n, n)) + 0.5
    across = sum(k * p for k, p in zip(np.array(normal) / np.linalg.norm(normal), (x, y, z)))
    return Voxels(across % period < period / 2, 1.0)


def test_directions_are_unit_vectors_spread_evenly():
    directions = a.half_sphere(500)
    assert np.linalg.norm(directions, axis=1) == pytest.approx(np.ones(500))
    # second moments of the uniform sphere: 1/3 along each axis, none mixed
    assert directions.T @ directions / 500 == pytest.approx(np.eye(3) / 3, abs=2e-3)


def test_plates_along_the_grid_are_crossed_twice_a_period_along_their_normal_and_never_along_themselves():
    solid = np.zeros((64, 64, 64), bool)
    solid[np.arange(64) % 16 < 8] = True
    found = a.fabric_of_voxels(Voxels(solid, 0.5))
    # crossings = 2 / (8 mm) |cos| at every angle; here 7 surfaces lie inside 32 mm
    assert found.crossings == pytest.approx(7 / 32 * np.abs(found.directions[:, 2]), abs=0.02)
    assert found.lengths[2] == pytest.approx(32 / 7, rel=0.03)
    assert np.abs(found.axes[2]) == pytest.approx([0, 0, 1], abs=0.03)
    assert found.anisotropy > 8


@pytest.mark.parametrize("normal", [(1, 2, 3), (1, 1, 0), (3, -1, 1)])
def test_plates_at_any_angle_show_their_normal_and_their_distance(normal):
    found = a.fabric_of_voxels(turned_plates(normal), 48)
    unit = np.array(normal) / np.linalg.norm(normal)
    assert abs(found.axes[2] @ unit) > 0.999
    assert found.lengths[2] == pytest.approx(8.0, rel=0.08)
    assert found.anisotropy > 5


def test_balls_are_isotropic_and_have_their_surface():
    voxels, count = bodies((9, 9, 9))
    found = a.fabric_of_voxels(voxels, 48)
    assert found.anisotropy == pytest.approx(1.0, abs=0.05)
    surface = count * 4 * math.pi * 81 / voxels.volume
    assert found.surface_density == pytest.approx(surface, rel=0.05)


@pytest.mark.parametrize("half_axes", [(6, 6, 12), (14, 7, 7), (6, 12, 6)])
def test_ellipsoids_have_the_anisotropy_of_their_axes(half_axes):
    # seen from w an ellipsoid's shadow is pi sqrt(b2 c2 wx2 + ...): the fabric is that very ellipsoid
    # the steps of voxels are still crossed here and there: 9 % too little at half axes of 6 voxels
    found = a.fabric_of_voxels(bodies(half_axes)[0], 48)
    assert found.anisotropy == pytest.approx(2.0, rel=0.1)
    assert abs(found.axes[0][int(np.argmax(half_axes))]) > 0.99


def test_the_fabric_does_not_depend_on_solid_and_void_being_exchanged():
    voxels = bodies((6, 6, 12))[0]
    other = Voxels(~voxels.solid, 1.0)
    assert a.fabric_of_voxels(voxels, 24).anisotropy == pytest.approx(
        a.fabric_of_voxels(other, 24).anisotropy, rel=1e-12
    )


def box_triangles(edges):
    """Triangles of the surface of a box with these edges."""
    e = np.array(edges, float)
    triangles = []
    for axis in range(3):
        u, v = np.eye(3)[(axis + 1) % 3] * e, np.eye(3)[(axis + 2) % 3] * e
        for at in (0, 1):
            o = np.eye(3)[axis] * e * at
            triangles += [[o, o + u, o + u + v], [o, o + u + v, o + v]]
    return np.array(triangles)


def test_triangles_are_crossed_as_often_as_their_projections_are_large():
    directions = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1.0], [0.6, 0.8, 0], [0, 0.6, 0.8], [0.8, 0, 0.6]])
    found = a.fabric_of_triangles(box_triangles([2, 3, 5]), 100.0, directions)
    # a convex body is crossed twice by each line that meets it: twice its shadow
    shadows = directions @ [15, 10, 6]
    assert found.crossings == pytest.approx(2 * shadows / 100)


def test_a_cube_of_triangles_is_isotropic_along_its_edges_by_symmetry():
    assert a.fabric_of_triangles(box_triangles([1, 1, 1]), 8.0).anisotropy == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize("half_axes", [(1, 1, 2), (3, 1, 1), (2, 1.5, 1)])
def test_an_ellipsoid_of_triangles_has_the_anisotropy_of_its_axes(half_axes):
    theta, phi = np.pi * (np.arange(80) + 0.5) / 80, 2 * np.pi * np.arange(160) / 160
    ring = np.sin(theta)[:, None]
    points = np.stack([ring * np.cos(phi), ring * np.sin(phi), np.cos(theta)[:, None] + 0 * phi], 2) * half_axes
    ahead = np.roll(points, -1, 1)
    quads = [np.stack(t, 2).reshape(-1, 3, 3) for t in (
        (points[:-1], points[1:], ahead[1:]), (points[:-1], ahead[1:], ahead[:-1])
    )]  # fmt: skip
    found = a.fabric_of_triangles(np.concatenate(quads), 100.0)
    assert found.anisotropy == pytest.approx(max(half_axes) / min(half_axes), rel=2e-3)
    assert found.lengths / found.lengths[2] == pytest.approx(sorted(half_axes, reverse=True), rel=2e-3)


def test_plates_of_triangles_have_an_endless_fabric():
    plate = box_triangles([4, 4, 1])
    sides = plate[(np.ptp(plate, axis=1)[:, 2] == 0)]
    found = a.fabric_of_triangles(sides, 64.0)
    assert found.anisotropy == math.inf
    assert found.lengths[2] == pytest.approx(2.0)  # 2 x 16 mm2 of surface in 64 mm3
    assert found.surface_density == pytest.approx(0.5, rel=1e-3)


def test_an_ellipsoid_is_found_again_from_its_own_intercepts():
    rng = np.random.default_rng(2)
    frame = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    lengths = np.array([3.0, 2.0, 0.5])
    directions = a.half_sphere(30)
    crossings = np.sqrt(((directions @ frame.T / lengths) ** 2).sum(1))
    found = a.fabric(directions, crossings)
    assert found.lengths == pytest.approx(lengths)
    assert found.anisotropy == pytest.approx(6.0)
    assert np.abs((found.axes * frame).sum(1)) == pytest.approx(np.ones(3))


def test_a_structure_without_surface_has_no_fabric():
    with pytest.raises(MeshError, match="a fabric needs a surface that lines cross, got none"):
        a.fabric_of_voxels(Voxels(np.ones((8, 8, 8), bool), 1.0))
    with pytest.raises(MeshError, match="got none"):
        a.fabric_of_triangles(np.zeros((0, 3, 3)), 1.0)


def test_fewer_directions_than_unknowns_are_refused():
    with pytest.raises(ParameterError, match="at least 6 directions, got 5"):
        a.half_sphere(5)


def test_cancelling_stops_between_directions():
    def cancel(done, total, what):
        raise Cancelled("stop")

    with pytest.raises(Cancelled):
        a.fabric_of_voxels(turned_plates((1, 0, 0), n=16), progress=cancel)
