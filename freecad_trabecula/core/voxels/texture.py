# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random fields that look like trabeculae: high on sheets and rods a wavelength apart, the same on every machine.

Two Gaussian fields g, h whose waves all have about one length (which may differ by direction); the field is
-sqrt(g^2 + w h^2): its heights are the sheets where g = 0 (w = 0), or the lines where g = h = 0 (w = 1), and what lies
between. The waves are summed in whole numbers below 2^53, so that no order of summation, no library and no processor
changes a bit; values are multiples of ``QUANTUM``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Iterator, Optional

import numpy as np

from ...errors import ParameterError
from ..progress import Progress, silent
from ..streams import Stream, mix

#: Field values are multiples of it: sums with offsets below 2^6 are exact in float32.
QUANTUM = 2.0**-18
#: Waves whose strength is below exp(-REACH^2 / 2) are left out.
REACH = 2.5
#: Cosines are whole multiples of 2^-_ANGLE_BITS; with amplitudes below 2^18 every sum stays below 2^53.
_ANGLE_BITS = 14
_SLAB_VALUES = 1 << 21  # values of the field made at once
_DEVIATION = 2.0**13  # of the amplitudes of one wave, as whole numbers


@dataclass(frozen=True)
class Texture:
    """What a trabecular field looks like.

    Attributes
    ----------
    wavelengths : tuple of 3 floats, voxels
        Length of the waves along the three directions of ``axes``: about the distance from one trabecula to the next
        but one.
    axes : tuple of 3 unit vectors (x, y, z)
        Directions of the wavelengths; at right angles to each other.
    width : float
        Spread of the wave numbers, relative: 0.1 is as regular as a lattice, 0.5 has all sizes side by side.
    mix : float
        w: 0 makes sheets, 1 rods.
    """

    wavelengths: tuple = (24.0, 24.0, 24.0)
    axes: tuple = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    width: float = 0.18
    mix: float = 0.3

    def __post_init__(self) -> None:
        if len(self.wavelengths) != 3 or not all(2.0 < w < 1e5 for w in self.wavelengths):
            raise ParameterError(f"wavelengths must be three lengths above 2 voxels, got {self.wavelengths}")
        axes = np.asarray(self.axes, float)
        # a fit rounds them to 2^-20, which turns them by up to 1.7e-6
        if axes.shape != (3, 3) or not np.allclose(axes @ axes.T, np.eye(3), atol=2e-6):
            raise ParameterError(f"axes of a texture must be three unit vectors at right angles, got {self.axes}")
        if not 0.02 <= self.width <= 1.0:
            raise ParameterError(f"width of a texture must be 0.02 to 1, got {self.width:g}")
        if not 0.0 <= self.mix <= 4.0:
            raise ParameterError(f"mix of sheets and rods must be 0 to 4, got {self.mix:g}")

    def wave_matrix(self) -> np.ndarray:
        """Return A (3, 3): a wave with k (x, y, z) cycles per voxel is in the middle of the band if |A k| = 1."""
        axes = np.asarray(self.axes, float)
        return axes.T @ np.diag(self.wavelengths) @ axes

    def scaled(self, factors: tuple) -> Texture:
        """Return the texture with its wavelengths multiplied by one factor per direction."""
        return replace(self, wavelengths=tuple(float(w * f) for w, f in zip(self.wavelengths, factors)))


def _wave_numbers(texture: Texture, shape: tuple, periods: Texture) -> list:
    """Return per array axis (z, y, x) the length of one period, voxels, and the highest number of waves in it."""
    reach = 1.0 + REACH * texture.width
    waves = []
    for size, middle, lowest in zip(shape, _middle_numbers(texture), _middle_numbers(periods)):
        # a period longer than the box keeps opposite faces from fitting each other; no wave shorter than two voxels
        period = size + max(8, min(int(round(1.0 / lowest)), 2 * size))
        waves.append((period, max(1, int(min(reach * middle, 0.5) * period))))
    return waves


def _middle_numbers(texture: Texture) -> np.ndarray:
    """Return the highest wave number in the middle of the band along z, y, x; (3,) cycles per voxel."""
    inverse = np.linalg.inv(texture.wave_matrix())
    return np.sqrt(np.diag(inverse @ inverse.T))[::-1]


def _amplitudes(texture: Texture, waves: list, stream: Stream) -> np.ndarray:
    """Return whole amplitudes (2, Z, Y, X) float64, real and imaginary, of all waves, -highest .. highest per axis.

    Each is a nearly normal number (the sum of four of 16 bits, one 64-bit word) that belongs to its wave.
    """
    numbers = [np.arange(-highest, highest + 1) for _, highest in waves]
    k = np.meshgrid(*[n / period for n, (period, _) in zip(numbers, waves)], indexing="ij", sparse=True)
    matrix = texture.wave_matrix()[:, ::-1]  # acts on (z, y, x)
    ring = np.sqrt(sum((sum(m * f for m, f in zip(row, k))) ** 2 for row in matrix))
    strength = np.exp(-0.5 * np.minimum(((ring - 1.0) / texture.width) ** 2, 200.0))
    strength[np.abs(ring - 1.0) > REACH * texture.width] = 0.0
    z, y, x = np.meshgrid(*[(n + (1 << 20)).astype(np.uint64) for n in numbers], indexing="ij", sparse=True)
    names = ((z << np.uint64(42)) | (y << np.uint64(21)) | x).reshape(-1)
    words = mix(names, stream.integers(2)).T
    words_of_16 = [(words >> np.uint64(16 * i)) & np.uint64(0xFFFF) for i in range(4)]
    parts = np.sum(words_of_16, 0).astype(np.float64)
    normal = (parts - 2.0 * 65535.0) / math.sqrt((65536.0**2 - 1.0) / 3.0)
    return np.rint(normal.reshape((2, *strength.shape)) * (strength * _DEVIATION))


def _turns(size: int, period: int, highest: int) -> tuple:
    """Return whole cosines and sines, each (highest + 1, size), of the waves 0 .. highest at the voxels of one axis."""
    # the angle is reduced in whole numbers: k x mod period, so that the tables are exact to the last bit
    steps = np.outer(np.arange(highest + 1), np.arange(size)) % period
    angles = 2.0 * np.pi * np.arange(period) / period
    scale = float(1 << _ANGLE_BITS)
    return np.rint(np.cos(angles) * scale)[steps], np.rint(np.sin(angles) * scale)[steps]


def _folded(real: np.ndarray, imaginary: np.ndarray) -> tuple:
    """Return what cosines and sines of the waves 0 .. highest are multiplied by, for the real and the imaginary sum.

    A cosine is the same for k and -k, a sine the opposite: what the two share is added up first, which halves the
    work. Waves lie along the last axis, -highest .. highest; results are two arrays (..., 2 highest + 2).
    """
    highest = real.shape[-1] // 2
    both = []
    for even, odd, sign in ((real, imaginary, -1.0), (imaginary, real, 1.0)):
        sums, differences = even[..., highest:].copy(), odd[..., highest:] - odd[..., highest::-1]
        sums[..., 1:] += even[..., highest - 1 :: -1]
        both.append(np.concatenate((sums, sign * differences), -1))
    return tuple(both)


def _summed(real: np.ndarray, imaginary: np.ndarray, turns: tuple) -> tuple:
    """Return sums over the last axis of (real + i imaginary) exp(i angle), shortened to whole numbers again."""
    turn, shorten = np.concatenate(turns), 1.0 / (1 << _ANGLE_BITS)
    return tuple(np.rint((part @ turn) * shorten) for part in _folded(real, imaginary))


def gaussian_slabs(
    texture: Texture, shape: tuple, stream: Stream, periods: Optional[Texture] = None
) -> Iterator[tuple]:
    """Yield slabs along z of two independent Gaussian fields with the texture's waves.

    Parameters
    ----------
    texture : Texture
    shape : tuple (P, M, N)
    stream : Stream
        Its next two numbers decide the fields.
    periods : Texture, optional
        The texture whose periods the waves have: fields of one stream with the same periods share their waves.

    Yields
    ------
    first : int
        The slab's first layer.
    g, h : ndarray of shape (layers, M, N), float64
        Means near 0, deviations near 1.
    """
    waves = _wave_numbers(texture, shape, texture if periods is None else periods)
    real, imaginary = _amplitudes(texture, waves, stream)
    deviation = max(1.0, math.sqrt(float((real**2 + imaginary**2).sum()) / 2.0))
    (period_z, high_z), (period_y, high_y), (period_x, high_x) = waves
    real, imaginary = _summed(real, imaginary, _turns(shape[2], period_x, high_x))
    real, imaginary = (np.ascontiguousarray(np.swapaxes(a, 1, 2)) for a in (real, imaginary))
    real, imaginary = _summed(real, imaginary, _turns(shape[1], period_y, high_y))
    real, imaginary = (np.swapaxes(a, 1, 2).reshape(len(a), -1).T for a in (real, imaginary))
    for_g, for_h = (part.T for part in _folded(real, imaginary))
    del real, imaginary
    turn = np.concatenate(_turns(shape[0], period_z, high_z))
    layers = max(1, _SLAB_VALUES // (shape[1] * shape[2]))
    scale = 1.0 / ((1 << _ANGLE_BITS) * deviation)
    for first in range(0, shape[0], layers):
        here = turn[:, first : first + layers].T
        size = (len(here), *shape[1:])
        yield first, (here @ for_g).reshape(size) * scale, (here @ for_h).reshape(size) * scale


def trabecular_field(
    texture: Texture, shape: tuple, seed: int, identity: tuple = (), progress: Progress = silent
) -> np.ndarray:
    """Return a field that is high where trabeculae may be.

    Parameters
    ----------
    texture : Texture
    shape : tuple (P, M, N)
    seed : int
    identity : tuple of str or int
        What the field is for: other words, another field.
    progress : callable

    Returns
    -------
    ndarray of shape (P, M, N), float32
        Multiples of ``QUANTUM``, 0 at most; about 1 deep.
    """
    field = np.empty(shape, np.float32)
    mix_of_both = np.float32(texture.mix)
    for first, g, h in gaussian_slabs(texture, shape, Stream(seed, "texture", *identity)):
        g, h = g.astype(np.float32), h.astype(np.float32)
        depth = np.sqrt(g * g + mix_of_both * (h * h))
        field[first : first + len(g)] = np.rint(depth * np.float32(-1.0 / QUANTUM)) * np.float32(QUANTUM)
        progress(first + len(g), shape[0], "field")
    return field
