# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volumes of a closed mesh between parallel planes, exactly: the alternative to sections through the layers' middles.

By the divergence theorem the volume between two planes is the flux of (u, 0, 0), u being across the planes, through the
triangles' parts between them: no caps are needed. Slabs that cover the mesh add up to its volume along every axis.
"""

from __future__ import annotations

import numpy as np

from ...errors import MeshError
from ..parameters import require

_BLOCK = 100_000  # pairs of triangle and plane worked on at once


def slab_volumes(triangles: np.ndarray, axis: int, planes: np.ndarray) -> np.ndarray:
    """Return the volume between each two neighbouring planes, ndarray of shape (S - 1,), mm³.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
        Of closed meshes, counter-clockwise seen from outside.
    axis : int
        0, 1, 2 for X, Y, Z.
    planes : ndarray of shape (S,), mm
        Co-ordinates, rising.

    Raises
    ------
    MeshError
        If there are no triangles.
    ParameterError
        If the planes do not rise.

    Examples
    --------
    A tetrahedron of volume 1/6, of which 7/8 lie below half its height:

    >>> o, x, y, z = np.eye(4, 3, -1)
    >>> faces = np.array([[o, y, x], [o, x, z], [o, z, y], [x, y, z]])
    >>> (slab_volumes(faces, 2, np.array([0, 0.5, 1])) * 48).round(9).tolist()
    [7.0, 1.0]
    """
    if not len(triangles):
        raise MeshError("a mesh must have at least one triangle, got 0")
    planes = np.asarray(planes, float)
    require(len(planes) > 1 and bool((np.diff(planes) > 0).all()), "planes must rise", planes[:4])
    corners = np.asarray(triangles, float)
    order = np.argsort(corners[:, :, axis], axis=1, kind="stable")
    height = np.take_along_axis(corners[:, :, axis], order, 1)
    across, other = (axis + 1) % 3, (axis + 2) % 3
    u = np.take_along_axis(corners[:, :, across], order, 1)
    # twice the area seen along u, with the sign of the outer normal
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = (first[:, other] * second[:, axis] - first[:, axis] * second[:, other]) / 2
    # planes below, through, and above each triangle
    low, high = np.searchsorted(planes, height[:, 0], "right"), np.searchsorted(planes, height[:, 2], "left")
    below = np.zeros(len(planes) + 1)
    np.add.at(below, high, area * u.mean(1))
    below = below.cumsum()[: len(planes)]
    crossings = np.maximum(high - low, 0)
    ends = crossings.cumsum()
    start = 0
    while start < len(crossings):
        stop = max(int(np.searchsorted(ends, (ends[start - 1] if start else 0) + _BLOCK, "right")), start + 1)
        tri = np.repeat(np.arange(start, stop), crossings[start:stop])
        if len(tri):
            rank = np.arange(len(tri)) - np.repeat(
                ends[start:stop] - crossings[start:stop] - ends[start] + crossings[start], crossings[start:stop]
            )
            plane = low[tri] + rank
            below += np.bincount(plane, _part_below(planes[plane], height[tri], u[tri], area[tri]), len(planes))
        start = stop
    return np.diff(below)


def _part_below(plane: np.ndarray, height: np.ndarray, u: np.ndarray, area: np.ndarray) -> np.ndarray:
    """Integral of u over the parts of triangles below planes that pass through them; corners by height (C, 3)."""
    h0, h1, h2 = height.T
    u0, u1, u2 = u.T
    lower = plane <= h1
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = (plane - h0) / (h1 - h0), (plane - h0) / (h2 - h0)
        tip = area * s * t * (3 * u0 + s * (u1 - u0) + t * (u2 - u0)) / 3
        s, t = (h2 - plane) / (h2 - h1), (h2 - plane) / (h2 - h0)
        rest = area * ((u0 + u1 + u2) / 3 - s * t * (3 * u2 + s * (u1 - u2) + t * (u0 - u2)) / 3)
    return np.where(lower, tip, rest)
