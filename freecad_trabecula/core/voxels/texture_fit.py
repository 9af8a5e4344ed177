# SPDX-License-Identifier: LGPL-2.1-or-later
"""A texture fitted to a sample: how often lines of every direction cross its surface, how large its trabeculae are.

Lines along n cross the surface of a field with waves |A k| = 1 in proportion to |A^-1 n| (all directions of an
isotropic field are alike), so that crossings along 13 directions of the grid give axes and lengths of the waves: the
mean intercept ellipsoid (Harrigan, Mann 1984, doi:10.1007/BF00539414). Layers cut sheets into long trabeculae and rods
into small ones: the mix is the one whose trabeculae, weighed by area, are as large as the sample's. Both are compared
with fields cut to the sample's own layer counts.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from itertools import product
from typing import List, Optional

import numpy as np

from ...errors import ParameterError
from ..labelling import scipy_ndimage
from .plane_offsets import layer_sums, newton_offsets, solid_of
from .texture import Texture, trabecular_field

#: The mix without a sample.
DEFAULT_MIX = 0.3
_MIXES = (1.0, 0.15, 1 / 64)
_LARGEST_WINDOW = 104  # voxels along an edge; a larger sample is judged by its middle
_COARSE = 0.05  # crossings per voxel below which every other voxel is enough
_START = 1.7  # crossings per wavelength along a line, about
_LONGEST = 4.0  # longest waves that are looked for, over the window's edge
_LAYERS = 32  # along one axis that trabeculae are measured in, at least
_SIMULATIONS = 3  # of a sample that holds few waves; one of a finer sample
_STEPS = 3
_STEPS_ZYX = tuple(d for d in product((-1, 0, 1), repeat=3) if d > (0, 0, 0))  # 13 directions


def crossing_rates(solid: np.ndarray) -> np.ndarray:
    """Return the share of voxel pairs that differ along the 13 directions of the grid, (13,) float64."""
    rates = []
    for steps in _STEPS_ZYX:
        near = tuple(slice(max(0, -s), n - max(0, s)) for s, n in zip(steps, solid.shape))
        far = tuple(slice(max(0, s), n - max(0, -s)) for s, n in zip(steps, solid.shape))
        rates.append(np.count_nonzero(solid[near] != solid[far]) / max(1, solid[near].size))
    return np.array(rates)


def crossing_tensor(solid: np.ndarray) -> np.ndarray:
    """Return Q (3, 3), axes x, y, z: lines along n cross the surface sqrt(n Q n) times per voxel (least squares)."""
    n = np.array(_STEPS_ZYX, float)[:, ::-1]
    terms = np.stack([n[:, i] * n[:, j] * (1 if i == j else 2) for i in range(3) for j in range(i, 3)], 1)
    xx, xy, xz, yy, yz, zz = np.linalg.lstsq(terms, crossing_rates(solid) ** 2, rcond=None)[0]
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def trabecula_area(solid: np.ndarray) -> float:
    """Return the area in voxels of the trabecula that a solid voxel lies in, on average over voxels and three axes.

    Layers next to each other are alike: of many, every second or third is judged.
    """
    ndimage = scipy_ndimage()

    structure = ndimage.generate_binary_structure(3, 1)
    structure[[0, 2]] = False
    means = []
    for axis in range(3):
        layers = np.moveaxis(solid, axis, 0)[:: max(1, solid.shape[axis] // _LAYERS)]
        areas = np.bincount(ndimage.label(layers, structure)[0].reshape(-1))[1:].astype(float)
        means.append((areas**2).sum() / max(1.0, areas.sum()))
    return float(np.mean(means))


def fitted_texture(sample: np.ndarray, mix: Optional[float] = None) -> Texture:
    """Return the texture whose designs have the sample's crossings along every direction.

    Parameters
    ----------
    sample : ndarray of shape (P, M, N), bool
    mix : float, optional
        Sheets (0) to rods (1); None: fitted to the areas of the sample's trabeculae.

    Raises
    ------
    ParameterError
        If the sample is empty or full.
    """
    sample = np.asarray(sample, bool)
    return _fitted(np.packbits(sample).tobytes(), sample.shape, mix)


@lru_cache(maxsize=8)
def _fitted(packed: bytes, shape: tuple, mix: Optional[float]) -> Texture:
    bits = np.unpackbits(np.frombuffer(packed, np.uint8), count=int(np.prod(shape)))
    window, step = _window(bits.reshape(shape).astype(bool))
    wanted = crossing_tensor(window)
    rates, axes = np.linalg.eigh(wanted)
    # along a prism's axis nothing is crossed, and the waves are as long as they can be told from none
    least = _least_rate(window)
    if rates[-1] < least:
        raise ParameterError("a sample must have a surface to fit a texture to, got one that is empty or full")
    if rates[0] < least:
        rates = np.maximum(rates, least)
        wanted = (axes * rates) @ axes.T
    # rounded far above the last bits, in which libraries differ
    axes = tuple(tuple(float(a) for a in np.rint(axis * 2.0**20) / 2.0**20) for axis in axes.T)
    texture = Texture(tuple(_length(_START / np.sqrt(rates))), axes, mix=DEFAULT_MIX if mix is None else mix)
    if mix is None:
        mix, texture = _fitted_mix(window, wanted, texture)
    texture = _scaled_to(window, wanted, replace(texture, mix=mix))[0]
    return replace(texture, wavelengths=tuple(_length(np.array(texture.wavelengths) * step)))


def _least_rate(window: np.ndarray) -> float:
    """Return the square of the crossings per voxel of the longest waves that are looked for."""
    return (_START / (_LONGEST * max(window.shape))) ** 2


def has_surface(sample: np.ndarray) -> bool:
    """Return whether a sample is crossed often enough for a texture to be fitted to it."""
    window, _ = _window(np.asarray(sample, bool))
    return bool(np.linalg.eigvalsh(crossing_tensor(window))[-1] >= _least_rate(window))


def _length(lengths: np.ndarray) -> List[float]:
    return [float(w) for w in np.rint(np.clip(lengths, 2.5, 9e4) * 64) / 64]


def _window(sample: np.ndarray) -> tuple:
    """Return the part of the sample that is judged, and the step between its voxels."""
    step = 2 if crossing_rates(sample).mean() < _COARSE and min(sample.shape) > 40 else 1
    sample = sample[::step, ::step, ::step]
    starts = [max(0, (n - _LARGEST_WINDOW) // 2) for n in sample.shape]
    return np.ascontiguousarray(sample[tuple(slice(s, s + _LARGEST_WINDOW) for s in starts)]), step


def _simulated(window: np.ndarray, texture: Texture, number: int) -> np.ndarray:
    """Return a field's solid with the layer counts of the window."""
    field = trabecular_field(texture, window.shape, number, ("fit",))
    counts = layer_sums(window)
    return solid_of(field, newton_offsets(field, counts, narrowest=2.0**-4))


def _scaled_to(window: np.ndarray, wanted: np.ndarray, texture: Texture, steps: int = _STEPS) -> tuple:
    """Return the texture with wavelengths that make the crossings along its axes right, and the last solids."""
    axes = np.asarray(texture.axes)
    solids = []
    for _ in range(steps):
        few_waves = min(window.shape) < 5 * max(texture.wavelengths)
        solids = [_simulated(window, texture, i) for i in range(_SIMULATIONS if few_waves else 1)]
        got = np.mean([crossing_tensor(solid) for solid in solids], 0)
        ratio = np.sqrt(np.maximum(np.diag(axes @ got @ axes.T), 1e-12) / np.diag(axes @ wanted @ axes.T))
        factors = np.clip(ratio, 0.5, 2.0)
        # a window of few waves is crossed by what its layers' counts ask for, however long the waves are
        lengths = np.minimum(np.array(texture.wavelengths) * factors, _LONGEST * max(window.shape))
        texture = replace(texture, wavelengths=tuple(_length(lengths)))
    return texture, solids


def _fitted_mix(window: np.ndarray, wanted: np.ndarray, texture: Texture) -> tuple:
    """Return the mix whose trabeculae are as large as the window's, and a texture near it."""
    goal = trabecula_area(window)
    areas = []
    for mix in _MIXES:
        texture, solids = _scaled_to(window, wanted, replace(texture, mix=mix), 2)
        areas.append(float(np.mean([trabecula_area(solid) for solid in solids])))
    order = np.argsort(areas)
    logs = np.interp(np.log(goal), np.log(np.array(areas)[order]), np.log(_MIXES)[order])
    return float(np.rint(np.exp(logs) * 64) / 64), texture
