# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a mesh: its outline, its tones, what hides what."""

import numpy as np

from freecad_trabecula.core.html_report.shaded_view import shaded_view
from freecad_trabecula.core.meshes import Mesh, join

_FACES = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6),
          (3, 0, 4), (3, 4, 7)]  # fmt: skip


def box(low, high):
    x, y, z = zip(low, high)
    corners = [(x[i], y[j], z[k]) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return Mesh(np.array(corners, float), np.array(_FACES))


def test_a_cube_is_a_hexagon_of_three_tones():
    picture = shaded_view(box((0, 0, 0), (1, 1, 1)), 200)
    assert picture[0, 0] == picture[-1, -1] == 255
    tones, counts = np.unique(picture[picture < 255], return_counts=True)
    assert len(tones) == 3
    # area of the outline over that of its square, from the directions of the axes in the picture
    azimuth, elevation = np.radians(38), np.radians(27)
    across = np.cos(azimuth) + np.sin(azimuth)
    up = np.cos(elevation) + np.sin(elevation) * across
    seen = np.sin(elevation) + np.cos(elevation) * across  # sum of the faces' areas, seen aslant
    share = seen / max(across, up) ** 2 * 0.94**2
    assert abs(counts.sum() / picture.size - share) < 0.01


def test_what_is_nearer_hides_what_is_farther():
    far = box((0, 0, 0), (1, 1, 1))
    # a plate over the top of the cube, as wide: of the cube's own top nothing is left to be seen
    plate = box((-0.5, -0.5, 1.2), (1.5, 1.5, 1.3))
    both, alone = shaded_view(join([far, plate]), 200), shaded_view(plate, 200)
    top = np.unique(alone[alone < 255]).max()
    assert (both == top).sum() > 0.4 * (both < 255).sum()


def test_nothing_is_white():
    assert (shaded_view(Mesh(np.zeros((0, 3)), np.zeros((0, 3), int)), 50) == 255).all()
