# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields over the box whose high places become solid: simple shapes, a gyroid, smooth noise."""

from __future__ import annotations

import math
from typing import Sequence, Tuple

import numpy as np

from ..parameters import require
from ..streams import Stream
from .parameters import FIELDS, VoxelParameters

_WAVELENGTH = 8.0  # voxels, of noise and gyroid when none is chosen
_PASSES = 3  # of box smoothing: three make nearly a Gaussian


def chosen_field(parameters: VoxelParameters, shape: Tuple[int, int, int]) -> np.ndarray:
    """Return the field of a design's choice, ndarray of shape (P, M, N), float64.

    ``noise`` is smooth and random; ``gyroid`` is high on the surface of that name; ``sheets`` lie across the diagonal;
    ``centre`` is high in the middle, ``border`` away from it. A sum of functions of x, y and z alone would be no
    choice: every design with the same counts has the same sum of it.

    Parameters
    ----------
    parameters : VoxelParameters
        field, wavelength, size, seed.
    shape : tuple of int
    """
    require(parameters.field in FIELDS, f"the field must be one of {', '.join(FIELDS)}", repr(parameters.field))
    z, y, x = (
        ((np.arange(count) + 0.5) / count - 0.5).reshape([-1 if k == axis else 1 for k in range(3)])
        for axis, count in enumerate(shape)
    )
    lengths = [
        (length / edge if length else _WAVELENGTH) for length, edge in zip(parameters.wavelength, parameters.size)
    ]
    if parameters.field == "noise":
        return smooth_noise(shape, lengths[::-1], Stream(parameters.seed, "voxels", "noise"))
    if parameters.field == "gyroid":
        a, b, c = (2 * math.pi * t * n / w for t, n, w in zip((x, y, z), shape[::-1], lengths))
        return -np.abs(np.sin(a) * np.cos(b) + np.sin(b) * np.cos(c) + np.sin(c) * np.cos(a))
    if parameters.field == "sheets":
        a, b, c = (t * n / w for t, n, w in zip((x, y, z), shape[::-1], lengths))
        return np.cos(2 * math.pi * (a + b + c))
    blob = np.exp(-8.0 * (x**2 + y**2 + z**2))
    return blob if parameters.field == "centre" else -blob


def smooth_noise(shape: Tuple[int, int, int], lengths: Sequence[float], stream: Stream) -> np.ndarray:
    """Return white noise smoothed by boxes of half a wavelength along each axis, (P, M, N) float64.

    Parameters
    ----------
    shape : tuple of int
    lengths : sequence of float, voxels
        Wavelengths along the array's axes.
    stream : Stream
    """
    noise = stream.many(math.prod(shape)).reshape(shape) - 0.5
    for axis, length in enumerate(lengths):
        half = max(int(round(length / 8)), 0)
        for _ in range(_PASSES if half else 0):
            noise = _box_mean(noise, axis, half)
    return noise / max(float(noise.std()), 1e-300)


def _box_mean(values: np.ndarray, axis: int, half: int) -> np.ndarray:
    """Sum over 2 half + 1 neighbours along an axis, ends repeated."""
    pads = [(0, 0)] * values.ndim
    pads[axis] = (half + 1, half)
    sums = np.cumsum(np.pad(values, pads, mode="edge"), axis=axis)
    count = values.shape[axis]
    width = 2 * half + 1
    high = np.take(sums, np.arange(width, width + count), axis)
    return (high - np.take(sums, np.arange(count), axis)) / width
