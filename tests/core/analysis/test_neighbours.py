# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every half-edge finds the one that runs the other way between the same points."""

import numpy as np

from freecad_trabecula.core.analysis.neighbours import neighbours, next_corner
from freecad_trabecula.core.analysis.triangles import by_corners


def octant_sphere(steps):
    """Return triangles (T, 3, 3) of a closed body whose corners mirror each other bit by bit in all three planes."""
    corners = {}
    for i in range(steps + 1):
        for j in range(steps + 1 - i):
            point = np.array([i, j, steps - i - j], float)
            corners[i, j] = (point / np.linalg.norm(point)).astype(np.float32)
    octant = [(corners[i, j], corners[i + 1, j], corners[i, j + 1]) for i, j in corners if i + j < steps]
    octant += [(corners[i + 1, j], corners[i + 1, j + 1], corners[i, j + 1]) for i, j in corners if i + j < steps - 1]
    octant, found = np.array(octant), []
    for signs in np.array(np.meshgrid([1, -1], [1, -1], [1, -1])).reshape(3, -1).T.astype(np.float32):
        part = octant * signs
        found.append(part if signs.prod() > 0 else part[:, ::-1])
    return np.concatenate(found)


def test_partners_run_between_the_same_points_the_other_way_also_in_a_body_of_mirrored_corners():
    triangles = octant_sphere(12)
    points, partner = by_corners(triangles).T, neighbours(triangles)
    start, end = np.arange(len(partner)), next_corner(np.arange(len(partner)), len(triangles))
    assert (partner >= 0).all()
    assert (points[start[partner]] == points[end]).all() and (points[end[partner]] == points[start]).all()
    assert (partner[partner] == start).all()


def test_an_open_mesh_has_half_edges_without_a_partner():
    partner = neighbours(octant_sphere(4)[1:])
    assert (partner < 0).sum() == 3
