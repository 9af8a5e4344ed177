# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a mesh without a window: seen from a corner, shaded by its normals, nearer hides farther."""

from __future__ import annotations

import numpy as np

from ..meshes import Mesh

_MOST_SAMPLES = 2_000_000  # at once: 100 MB
_AZIMUTH, _ELEVATION = np.radians(-38.0), np.radians(27.0)
_LIGHT = np.array([0.35, 0.75, 0.55])  # in the picture's frame: right, up, towards the eye
_PAPER, _DARKEST = 255, 45
_DENSITY = 1.6  # samples a pixel along each direction: fewer leave holes
_LEVELS = np.array([1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024, 2048])


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
    corners = _longest_first(corners)
    base = corners[:, 1] - corners[:, 0]
    longest = np.linalg.norm(base[:, :2], axis=1)
    rise = corners[:, 2] - corners[:, 0]
    height = np.abs(base[:, 0] * rise[:, 1] - base[:, 1] * rise[:, 0]) / np.maximum(longest, 1e-12)
    along, across = _level(longest), _level(height)
    for pair in np.unique(np.stack([along, across], 1), axis=0):
        which = np.flatnonzero((along == pair[0]) & (across == pair[1]))
        weights = _weights(*_LEVELS[pair].tolist())
        most = max(1, _MOST_SAMPLES // len(weights))
        for start in range(0, len(which), most):
            rows = which[start : start + most]
            points = np.matmul(weights, corners[rows]).reshape(-1, 3)
            _keep_nearest(picture, depth, points, np.repeat(shade[rows], len(weights)), size)


def _longest_first(corners: np.ndarray) -> np.ndarray:
    """Triangles (T, 3, 3) whose first two corners are the ends of the edge that is longest in the picture."""
    sides = np.linalg.norm((np.roll(corners, -1, axis=1) - corners)[..., :2], axis=2)
    order = (np.argmax(sides, axis=1)[:, None] + np.arange(3)) % 3
    return np.take_along_axis(corners, order[..., None], axis=1)


def _level(lengths: np.ndarray) -> np.ndarray:
    """How many samples a length in pixels gets, as a place in ``_LEVELS``."""
    return np.minimum(np.searchsorted(_LEVELS, _DENSITY * lengths), len(_LEVELS) - 1)


def _weights(along: int, across: int) -> np.ndarray:
    """Barycentric co-ordinates (along x across, 3): rows of samples from the long edge to the corner over it."""
    s, t = (np.arange(along) + 0.5) / along, (np.arange(across) + 0.5) / across
    s, t = (one.ravel() for one in np.meshgrid(s, t))
    return np.stack([(1 - s) * (1 - t), s * (1 - t), t], 1)


def _keep_nearest(picture: np.ndarray, depth: np.ndarray, points: np.ndarray, shade: np.ndarray, size: int) -> None:
    column, row = points[:, 0].astype(int), size - 1 - points[:, 1].astype(int)
    pixel, z = np.clip(row, 0, size - 1) * size + np.clip(column, 0, size - 1), points[:, 2]
    nearer = np.flatnonzero(z > depth[pixel])
    nearer = nearer[np.argsort(z[nearer])]  # of several samples on a pixel the last assigned stays: the nearest
    depth[pixel[nearer]], picture[pixel[nearer]] = z[nearer], shade[nearer]
