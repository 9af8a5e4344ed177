# SPDX-License-Identifier: LGPL-2.1-or-later
"""Partners of half-edges: on closed meshes, and on meshes with every kind of damage."""

import numpy as np
import pytest

from freecad_trabecula.core.analysis.neighbours import corner_keys, neighbours, next_corner, partners_of
from freecad_trabecula.core.analysis.triangles import by_corners
from freecad_trabecula.errors import Cancelled


def sphere(n):
    """A closed ball of triangles: an octahedron whose faces are split n times."""
    triangles = np.array([[[x, 0, 0], [0, y, 0], [0, 0, z]][:: x * y * z] for x in (1, -1) for y in (1, -1)
                          for z in (1, -1)], np.float32)  # fmt: skip
    for _ in range(n):
        a, b, c = triangles.transpose(1, 0, 2)
        d, e, f = ((p + q) / np.float32(2) for p, q in ((a, b), (b, c), (c, a)))
        triangles = np.concatenate([np.stack(t, 1) for t in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))])
    return triangles


def picked(count, one_in):
    return (np.arange(count) * 2654435761 % 2**32) % one_in == 0


def ends(triangles):
    """Start and end point of each half-edge."""
    points = by_corners(triangles).T
    return points, points[next_corner(np.arange(len(points)), len(triangles))]


def test_every_edge_of_a_closed_mesh_has_its_partner_the_other_way_round():
    triangles = sphere(5)
    partner = neighbours(triangles)
    start, end = ends(triangles)
    assert (partner >= 0).all() and (partner[partner] == np.arange(len(partner))).all()
    assert (start[partner] == end).all() and (end[partner] == start).all()


def test_minus_zero_is_zero():
    triangles = sphere(2)
    triangles[::3][triangles[::3] == 0] = -0.0
    assert (neighbours(triangles) >= 0).all()
    assert corner_keys(np.zeros((3, 1), np.float32)) == corner_keys(-np.zeros((3, 1), np.float32))


def test_edges_of_missing_triangles_are_all_that_is_left_alone():
    triangles = sphere(6)
    gone = picked(len(triangles), 50)
    partner = neighbours(triangles)
    count, beside_gone = len(triangles), gone[partner % len(triangles)]
    expected = int((beside_gone & ~np.tile(gone, 3)).sum())
    assert int((neighbours(triangles[~gone]) < 0).sum()) == expected > count // 50


@pytest.mark.parametrize("one_in", [2, 10, 300])
def test_turned_triangles_lose_exactly_the_partners_that_are_not_turned(one_in):
    triangles = sphere(6)
    turned = picked(len(triangles), one_in)
    partner = neighbours(triangles)
    apart = np.tile(turned, 3) != turned[partner % len(triangles)]
    other = np.where(turned[:, None, None], triangles[:, ::-1], triangles)
    assert int((neighbours(other) < 0).sum()) == int(apart.sum()) > 0


def test_a_mesh_given_twice_joins_one_to_one():
    triangles = np.concatenate([sphere(3)] * 2)
    partner = neighbours(triangles)
    assert (partner >= 0).all() and (partner[partner] == np.arange(len(partner))).all()


def test_triangles_without_length_have_no_partners_and_known_partners_are_not_sought_again():
    point = np.zeros((1, 3, 3), np.float32)
    assert neighbours(point).tolist() == [-1, -1, -1]
    known = np.array([7])
    assert partners_of(point, known) is known


def test_joining_can_be_cancelled():
    def stop(done, total, what):
        raise Cancelled

    with pytest.raises(Cancelled):
        neighbours(sphere(5), stop)
