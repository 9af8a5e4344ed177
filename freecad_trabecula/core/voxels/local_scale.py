# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields whose wavelength varies smoothly from layer to layer, until layers have about their numbers of trabeculae.

log wavelength = constant + p[z] + q[y] + r[x]: where a layer has too many trabeculae its waves become longer. A field
of varying wavelength is mixed, place by place, from fields of neighbouring wavelengths.
"""

from __future__ import annotations

import math
from typing import Callable, List, Optional, Sequence, Tuple

import numpy as np

from ...errors import ExactnessError
from ..progress import Progress, silent
from ..streams import Stream
from .texture import QUANTUM, Texture, gaussian_slabs, trabecular_field

_FACTORS = tuple(1.16**i for i in range(-6, 7))  # of the wavelength: 0.41 .. 2.4
_GAIN = 0.35  # share of log(count / wanted) that a layer's log wavelength moves by: three axes act together
_STEPS = 8
_MOST_VOXELS = 1 << 24  # of a field that is fitted: a wave takes 4 bytes a voxel, of which there are 26
_SHORTEST, _LONGEST = -0.25, 0.9  # log factors of layers; finer waves fall apart where layers are sparse
_SMOOTHING = np.array([0.06, 0.24, 0.4, 0.24, 0.06])  # over neighbouring layers
_SMOOTH_WAVE = 15.0  # voxels of wavelength that one smoothing suits: waves must not jump from layer to layer

#: Makes a solid of a field, for counting.
Solidify = Callable[[np.ndarray], np.ndarray]
#: Counts trabeculae of a solid: three arrays along z, y, x.
Count = Callable[[np.ndarray], Sequence[np.ndarray]]


class VaryingField:
    """A trabecular field whose wavelength may differ from place to place.

    Parameters
    ----------
    texture : Texture
        With factor 1.
    shape : tuple (P, M, N)
    seed : int
    identity : tuple
        As in ``trabecular_field``.
    """

    def __init__(self, texture: Texture, shape: tuple, seed: int, identity: tuple = ()) -> None:
        self.mix = np.float32(texture.mix)
        # neighbouring bands share waves: so much do their fields agree
        overlap = math.exp(-0.25 * (math.log(_FACTORS[1] / _FACTORS[0]) / texture.width) ** 2)
        self.agreement = np.float32(round(overlap * 64) / 64)
        self.waves = np.empty((len(_FACTORS), 2, math.prod(shape)), np.float32)
        self.shape = shape
        for number, factor in enumerate(_FACTORS):
            scaled = texture.scaled((max(factor, 2.5 / min(texture.wavelengths)),) * 3)
            wave = self.waves[number].reshape(2, *shape)
            for first, g, h in gaussian_slabs(scaled, shape, Stream(seed, "texture", *identity), texture):
                wave[0, first : first + len(g)], wave[1, first : first + len(g)] = g, h

    def field(self, logs: Sequence[np.ndarray]) -> np.ndarray:
        """Return the field with log factors p[z] + q[y] + r[x] of the wavelength, (P, M, N) float32.

        Parameters
        ----------
        logs : sequence of 3 arrays, (P,), (M,), (N,)
        """
        top = len(_FACTORS) - 1
        p, q, r = (np.asarray(values, np.float32) for values in logs)
        steps = np.float32(1.0 / math.log(_FACTORS[1] / _FACTORS[0]))
        field = np.empty(self.shape, np.float32)
        waves = self.waves.reshape(len(_FACTORS), 2, *self.shape)
        for layer in range(self.shape[0]):
            place = np.clip((p[layer] + (q[:, None] + r)) * steps + np.float32(top / 2), 0, np.float32(top - 1e-3))
            lower = place.astype(np.int64)
            upper_share = np.rint((place - lower) * 256) / np.float32(256)
            shares = np.sqrt(1 - upper_share), np.sqrt(upper_share)
            strength = np.sqrt(1 + 2 * self.agreement * shares[0] * shares[1])
            y, x = np.ogrid[: self.shape[1], : self.shape[2]]
            g, h = (
                waves[lower, kind, layer, y, x] * shares[0] + waves[lower + 1, kind, layer, y, x] * shares[1]
                for kind in (0, 1)
            )
            depth = np.sqrt(g * g + self.mix * (h * h)) / strength
            field[layer] = np.rint(depth * np.float32(-1.0 / QUANTUM)) * np.float32(QUANTUM)
        return field


def _smoothed(values: np.ndarray, times: int = 1) -> np.ndarray:
    for _ in range(times):
        values = np.convolve(np.pad(values, 2, mode="edge"), _SMOOTHING, "valid")
    return values


def _log_ratio(counts: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    return np.log((_smoothed(counts) + 0.5) / (_smoothed(wanted) + 0.5))


def _rounded(values: np.ndarray) -> np.ndarray:
    return np.rint(np.asarray(values) * 1024) / 1024  # far above the bits in which logarithms differ


def _deviation(counts: Sequence[np.ndarray], wanted: Sequence[Optional[np.ndarray]]) -> float:
    deviations = [np.mean(np.abs(c - w) / np.maximum(w, 1)) for c, w in zip(counts, wanted) if w is not None]
    return float(np.mean(deviations))


def locally_fitted(
    texture: Texture,
    shape: tuple,
    seed: int,
    identity: tuple,
    wanted: Sequence[Optional[np.ndarray]],
    solidify: Solidify,
    count: Count,
    progress: Progress = silent,
) -> np.ndarray:
    """Return the field, of those tried, whose layers come nearest to their numbers of trabeculae.

    Parameters
    ----------
    texture, shape, seed, identity
        As ``VaryingField``.
    wanted : sequence of 3 arrays or None, along z, y, x
    solidify, count : callable
    progress : callable
    """
    if math.prod(shape) > _MOST_VOXELS:
        return trabecular_field(texture, shape, seed, identity, progress)
    varying = VaryingField(texture, shape, seed, identity)
    logs: List[np.ndarray] = [np.zeros(n) for n in shape]
    best: Tuple[float, Optional[np.ndarray]] = (math.inf, None)
    times = max(1, round((max(texture.wavelengths) / _SMOOTH_WAVE) ** 2))
    for step in range(_STEPS):
        field = varying.field(logs)
        counts = count(solidify(field.copy()))
        deviation = _deviation(counts, wanted)
        if deviation < best[0]:
            best = (deviation, field)
        progress(step + 1, _STEPS, "wavelengths")
        for axis, (found, goal) in enumerate(zip(counts, wanted)):
            if goal is not None:
                moved = logs[axis] + _GAIN * _smoothed(_log_ratio(found, goal), times - 1)
                logs[axis] = _rounded(np.clip(moved, _SHORTEST, _LONGEST))
    if best[1] is None:
        raise ExactnessError("no wavelengths were found that bring the numbers of trabeculae near to those asked for")
    return best[1]
