# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies whose slices are known: boxes, and boxes in boxes."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import Soup

_SQUARES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def box_triangles(low, high):
    """Triangles (12, 3, 3) of a box, outside out."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    corners = np.asarray(low, float) + corners * (np.asarray(high, float) - np.asarray(low, float))
    return np.array([[corners[i] for i in t] for a, b, c, d in _SQUARES for t in ((a, b, c), (a, c, d))], np.float32)


@pytest.fixture
def box():
    """Return the function that makes the triangles of a box."""
    return box_triangles


@pytest.fixture
def cavity():
    """A cube of 10 mm with a closed cavity of 6 mm in its middle: volume 784 mm³, slices 100 and 64 mm²."""
    inner = box_triangles((2, 2, 2), (8, 8, 8))[:, ::-1]
    return Soup(np.concatenate([box_triangles((0, 0, 0), (10, 10, 10)), inner]), "mm", "cavity.stl")


@pytest.fixture
def measured(cavity):
    """The analysis of the cube with its cavity in layers of 0.5 mm along x and z."""
    return analyse(cavity, SliceParameters(thickness=0.5, axes=("x", "z")), morphometry=False)
