# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a mesh without a window: seen from a corner, shaded by its normals, nearer hides farther."""

from __future__ import annotations

import numpy as np

from ..meshes import Mesh

_MOST_SAMPLES = 2_000_000  # at once: 100 MB
_AZIMUTH, _ELEVATION = np.radians(-38.0), np.radians(27.0)
_LIGHT = np.array([0.35, 0.75, 0.55])  # in the picture's frame: right, up, towards the eye
_PAPER, _DARKEST = 255, 45


def shaded_view(mesh: Mesh, size: int = 520) -> np.ndarray:
    """Return a grey picture (size, size) uint8 of a mesh, white where there is nothing.

    Parameters
    ----------
    mesh : Mesh
        Triangles counter-clockwise seen from outside.
    size : int, pixels

    Notes
    -----
    Each triangle is sampled as densely as pixels lie; of the samples on a pixel the nearest to the eye stays.
    """
    picture = np.full(size * size, _PAPER, np.uint8)
    if not len(mesh.triangles):
        return picture.reshape(size, size)
    seen = _turned(np.asarray(mesh.vertices, float))
    low, high = seen.min(0), seen.max(0)
    scale = 0.94 * size / max(float((high - low)[:2].max()), 1e-300)
    seen = (seen - (low + high) / 2) * scale + size / 2  # the third co-ordinate grows towards the eye
    corners = seen[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normals, axis=1)
    front = (normals[:, 2] > 0) & (length > 0)
    corners, unit = corners[front], normals[front] / length[front, None]
    lit = np.clip(unit @ (_LIGHT / np.linalg.norm(_LIGHT)), 0.0, 1.0)
    shade = (_DARKEST + (235 - _DARKEST) * (0.25 + 0.75 * lit)).astype(np.uint8)
    _draw(picture, np.full(size * size, -np.inf), corners, shade, size)
    return picture.reshape(size, size)


def _turned(points: np.ndarray) -> np.ndarray:
    """Points (N, 3) as the eye sees them: right, up, towards the eye."""
    c, s = np.cos(_AZIMUTH), np.sin(_AZIMUTH)
    right = np.array([c, s, 0.0])
    away = np.array([-s * np.cos(_ELEVATION), c * np.cos(_ELEVATION), -np.sin(_ELEVATION)])
    up = np.cross(right, away)
    return points @ np.stack([right, up, -away]).T


def _draw(picture: np.ndarray, depth: np.ndarray, corners: np.ndarray, shade: np.ndarray, size: int) -> None:
    sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).max(1)
    steps = 2 ** np.clip(np.ceil(np.log2(np.maximum(1.5 * sides, 1.0))), 0, 11).astype(int)
    for count in np.unique(steps):
        weights = _weights(int(count))
        which = np.flatnonzero(steps == count)
        most = max(1, _MOST_SAMPLES // len(weights))
        for start in range(0, len(which), most):
            rows = which[start : start + most]
            points = np.einsum("wk,tkc->twc", weights, corners[rows]).reshape(-1, 3)
            _keep_nearest(picture, depth, points, np.repeat(shade[rows], len(weights)), size)


def _weights(count: int) -> np.ndarray:
    """Barycentric co-ordinates (W, 3) of the middles of count^2 small triangles."""
    i, j = np.divmod(np.arange(count * count), count)
    flip = i + j >= count
    a, b = np.where(flip, count - 1 - i + 1 / 3, i + 1 / 3), np.where(flip, count - 1 - j + 1 / 3, j + 1 / 3)
    return np.stack([a, b, count - a - b], 1) / count


def _keep_nearest(picture: np.ndarray, depth: np.ndarray, points: np.ndarray, shade: np.ndarray, size: int) -> None:
    column, row = points[:, 0].astype(int), size - 1 - points[:, 1].astype(int)
    inside = (column >= 0) & (column < size) & (row >= 0) & (row < size)
    pixel, z, shade = (row * size + column)[inside], points[inside, 2], shade[inside]
    order = np.lexsort((z, pixel))
    pixel, z, shade = pixel[order], z[order], shade[order]
    last = np.append(pixel[1:] != pixel[:-1], True)
    pixel, z, shade = pixel[last], z[last], shade[last]
    nearer = z > depth[pixel]
    depth[pixel[nearer]], picture[pixel[nearer]] = z[nearer], shade[nearer]
