# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many voxels each layer along X, Y and Z must have (thesis 6.2.1).

Sliced areas are rounded by Eq. 6.1; the three axes' sums, which then differ, are brought to one total, and what that
changed is kept as the thesis' deltas.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional, Sequence, Tuple

import numpy as np

from ...errors import InfeasibleError, ParameterError
from ..parameters import require
from ..streams import Stream
from ..triples import triple
from .parameters import AREAS, CORRECTIONS, TOTALS, VoxelParameters, check_voxel_count

AXES = ("x", "y", "z")
_NEARLY = 1e-6  # of a layer: a sample of 10 mm has 100 layers of 0.1 mm, whatever single precision made of it
_OVERFULL = 1e-3  # of a layer's size: areas of a block may be above it by rounding, no more


@dataclass(frozen=True, eq=False)
class Targets:
    """Voxel counts asked for, per layer along X, Y and Z; their sums are equal.

    Attributes
    ----------
    d : ndarray of shape (N,), int64
        In each layer along X.
    e : ndarray of shape (M,), int64
        In each layer along Y.
    c : ndarray of shape (P,), int64
        In each layer along Z.
    voxel : tuple
        Edges dx, dy, dz, mm.
    origin : tuple
        Low corner of the sample's box, mm.
    deltas : tuple of int
        The common total less the sum of the rounded counts along X, Y, Z (thesis: delta_X, delta_Y, delta_Z).
    areas : tuple of ndarray, mm², or None
        The real sliced areas (or slab volumes over thickness) along X, Y, Z, when there were any.
    trabeculae : tuple of ndarray, or None
        Numbers of trabeculae asked for, per axis (N,), (M,), (P,).
    sample : ndarray of shape (P, M, N), bool, or None
        The sample itself as voxels: its texture is fitted to it, and it is shown beside the design.
    thickness : float, mm
        Mean thickness of the sample; nan when it is not known.
    tables : pair of ndarrays (N, P), (M, P), or None
        alpha and beta when they are given: edited by hand, or read from a file.

    Raises
    ------
    ParameterError
        If a count is no whole number or negative, an array is empty, or the voxel is no box.
    InfeasibleError
        If the totals differ or a layer is asked for more than it holds; the message names the layer.
    """

    d: np.ndarray
    e: np.ndarray
    c: np.ndarray
    voxel: Tuple[float, float, float] = (0.1, 0.1, 0.1)
    origin: Tuple[float, float, float] = (0.0, 0.0, 0.0)
    deltas: Tuple[int, int, int] = (0, 0, 0)
    areas: Optional[Tuple[np.ndarray, np.ndarray, np.ndarray]] = None
    trabeculae: Optional[Tuple[np.ndarray, np.ndarray, np.ndarray]] = None
    sample: Optional[np.ndarray] = None
    thickness: float = math.nan
    tables: Optional[Tuple[np.ndarray, np.ndarray]] = None

    def __post_init__(self) -> None:
        for name, axis in zip("dec", AXES):
            object.__setattr__(self, name, _whole_counts(getattr(self, name), axis))
        require(len(self.voxel) == 3 and min(self.voxel) > 0, "a voxel must have three edges above 0", self.voxel, "mm")
        check_voxel_count(self.layers)
        totals = [int(counts.sum()) for counts in self.counts]
        if len(set(totals)) > 1:
            raise InfeasibleError(
                "the layers along X, Y and Z must ask for the same total, got "
                f"{totals[0]}, {totals[1]} and {totals[2]} voxels: X - Z = {totals[0] - totals[2]}, "
                f"Y - Z = {totals[1] - totals[2]}"
            )
        for axis, counts, size in zip(AXES, self.counts, self.layer_sizes):
            check_layers_hold(axis, counts, size)
        if self.sample is not None and self.sample.shape != self.shape:
            raise ParameterError(f"the sample's voxels must have the shape {self.shape}, got {self.sample.shape}")

    @property
    def counts(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """D, E, C: counts along X, Y, Z."""
        return self.d, self.e, self.c

    @property
    def layers(self) -> Tuple[int, int, int]:
        """N, M, P: layers along X, Y, Z."""
        return len(self.d), len(self.e), len(self.c)

    @property
    def shape(self) -> Tuple[int, int, int]:
        """Shape of a design, (P, M, N)."""
        return self.layers[::-1]

    @property
    def layer_sizes(self) -> Tuple[int, int, int]:
        """Cells of a layer across X, Y, Z."""
        n, m, p = self.layers
        return m * p, n * p, n * m

    @property
    def total(self) -> int:
        """Voxels of a design."""
        return int(self.c.sum())

    @property
    def volume(self) -> float:
        """Volume of a design, mm³."""
        return self.total * math.prod(self.voxel)


def _whole_counts(counts: Sequence[float], axis: str) -> np.ndarray:
    array = np.asarray(counts)
    require(array.ndim == 1 and len(array) > 0, f"the counts along {axis.upper()} must be a list", array.shape)
    require(array.dtype.kind in "iuf", f"the counts along {axis.upper()} must be numbers", array.dtype)
    for rule, bad in (
        ("must be finite", ~np.isfinite(array)),
        ("must not be negative", array < 0),
        ("must be whole numbers", array != np.floor(array)),
    ):
        if bad.any():
            layer = int(np.argmax(bad))
            raise ParameterError(f"voxel counts {rule}, got {array[layer]:g} in layer {layer} along {axis.upper()}")
    return array.astype(np.int64)


def check_layers_hold(axis: str, counts: np.ndarray, size: int) -> None:
    """Refuse counts above what a layer holds.

    Raises
    ------
    InfeasibleError
        Naming the fullest layer.
    """
    worst = int(np.argmax(counts))
    if counts[worst] > size:
        raise InfeasibleError(
            f"a layer along {axis.upper()} holds {size} voxels, but layer {worst} is asked for {int(counts[worst])}"
        )


# ---------------------------------------------------------------------------------------------------- from real areas


def layer_counts_of_box(edges: Sequence[float], voxel: Sequence[float], areas: str = "middle") -> Tuple[int, int, int]:
    """Return how many layers N, M, P a sample has.

    A layer counts when its middle lies in the sample; for slab volumes, when any of it does.

    Parameters
    ----------
    edges : sequence of float, mm
        Of the sample's box along X, Y, Z.
    voxel : sequence of float, mm
        dx, dy, dz.
    areas : str
        ``middle`` or ``slab``.

    Raises
    ------
    ParameterError
        If a voxel is larger than the sample, or the voxels are too many.

    Examples
    --------
    >>> layer_counts_of_box((10.3, 9.43, 10.36), (0.1, 0.1, 0.1))
    (103, 94, 104)
    """
    require(areas in AREAS, f"areas must be one of {', '.join(AREAS)}", repr(areas))
    layers = []
    for axis, edge, size in zip(AXES, edges, voxel):
        count = edge / size
        whole = math.floor(count + 0.5 + _NEARLY) if areas == "middle" else math.ceil(count - _NEARLY)
        require(
            count >= 1 - _NEARLY, f"a voxel must not be larger than the sample, {edge:g} mm along {axis.upper()}",
            f"{size:g}", "mm",
        )  # fmt: skip
        layers.append(whole)
    found = triple(layers)
    check_voxel_count(found)
    return found


def targets_from_areas(
    areas: Sequence[np.ndarray],
    parameters: VoxelParameters,
    origin: Tuple[float, float, float] = (0.0, 0.0, 0.0),
    sample: Optional[np.ndarray] = None,
    trabeculae: Optional[Tuple[np.ndarray, np.ndarray, np.ndarray]] = None,
    thickness: float = math.nan,
) -> Targets:
    """Return targets from real sliced areas by Eq. 6.1 and the correction to one total.

    Parameters
    ----------
    areas : sequence of three ndarrays, (N,), (M,), (P,), mm²
        Sliced areas along X, Y, Z: one for each layer (slab volumes over the layer's thickness, for that).
    parameters : VoxelParameters
        Voxel size, correction, total, seed.
    origin, sample, trabeculae, thickness
        As in ``Targets``.

    Raises
    ------
    ParameterError
        If an area is not finite or is negative, or the sample is empty or full.
    InfeasibleError
        If a layer's area is larger than the layer.
    """
    given = [np.asarray(a, float) for a in areas]
    counted = tuple(len(a) for a in given)
    require(len(given) == 3 and min(counted) > 0, "areas must be given along X, Y and Z", counted, "layers")
    layers = triple(counted)
    check_voxel_count(layers)
    real = [_real_counts(axis, a, layers, parameters.size) for axis, a in zip(AXES, given)]
    total = common_total(real, parameters.total)
    cells = math.prod(layers)
    require(total > 0, "a sample must have material: its sliced areas make", total, "voxels")
    require(total < cells, f"a sample must have voids: of {cells} cells its sliced areas fill", total)
    rounded = [np.floor(r + 0.5).astype(np.int64) for r in real]  # Eq. 6.1; Excel's Round goes up at a half
    sizes = [cells // n for n in layers]
    counts = triple(
        to_total(r, total, size, parameters.correction, Stream(parameters.seed, "voxels", "total", axis))
        for axis, r, size in zip(AXES, real, sizes)
    )
    deltas = triple(total - int(r.sum()) for r in rounded)
    return Targets(*counts, parameters.size, triple(origin), deltas, triple(given), trabeculae, sample, thickness)


def _real_counts(axis: str, areas: np.ndarray, layers: Tuple[int, ...], size: Tuple[float, float, float]) -> np.ndarray:
    """Areas in voxels, (count,) float; of layers full but for rounding, no more than full."""
    for rule, bad in (("must be finite", ~np.isfinite(areas)), ("must not be negative", areas < -1e-9)):
        if bad.any():
            layer = int(np.argmax(bad))
            raise ParameterError(f"sliced areas {rule}, got {areas[layer]:g} mm² in layer {layer} along {axis.upper()}")
    across = [k for k in range(3) if AXES[k] != axis]
    real = np.maximum(areas, 0.0) / math.prod(size[k] for k in across)
    most = math.prod(layers[k] for k in across)
    worst = int(np.argmax(real))
    # a sample may reach half a voxel beyond its last layer's border
    rim = sum(0.5 * most / layers[k] for k in across)
    if real[worst] > most * (1 + _OVERFULL) + rim:
        raise InfeasibleError(
            f"a layer along {axis.upper()} holds {most} voxels, but the area {areas[worst]:g} mm² of layer {worst} "
            f"asks for {real[worst]:.0f}"
        )
    return np.minimum(real, most)


def common_total(real: Sequence[np.ndarray], which: str = "mean") -> int:
    """Return the total that all three axes get: the rounded mean of the real totals, or one axis' own (thesis: z).

    Parameters
    ----------
    real : sequence of three ndarrays
        Areas in voxels along X, Y, Z.
    which : str
        ``mean``, ``x``, ``y`` or ``z``.
    """
    require(which in TOTALS, f"the total must be one of {', '.join(TOTALS)}", repr(which))
    sums = [float(np.sum(r)) for r in real]
    return math.floor((sum(sums) / 3 if which == "mean" else sums[AXES.index(which)]) + 0.5)


def to_total(real: np.ndarray, total: int, size: int, correction: str, stream: Stream) -> np.ndarray:
    """Return whole counts with the given total, (count,) int64, each in 0..size.

    Parameters
    ----------
    real : ndarray of shape (count,)
        Areas in voxels.
    total : int
    size : int
        Most that a layer holds.
    correction : str
        ``remainders``: all layers are scaled to the total and rounded by largest remainders, so that profiles stay
        smooth. ``random``: Eq. 6.1, then one voxel more or less in random layers (thesis 6.2.1).
    stream : Stream
        Of the random layers.

    Raises
    ------
    InfeasibleError
        If the layers cannot hold the total.
    """
    require(correction in CORRECTIONS, f"the correction must be one of {', '.join(CORRECTIONS)}", repr(correction))
    if total > size * len(real):
        raise InfeasibleError(f"{len(real)} layers of {size} voxels cannot hold {total}")
    if correction == "random":
        return _randomly_corrected(np.floor(real + 0.5).astype(np.int64), total, size, stream)
    scaled = real * (total / max(float(real.sum()), 1e-300))
    while (scaled > size).any():  # full layers pass on what they cannot take
        free = scaled < size
        over = float((scaled - size)[~free].sum())
        scaled = np.minimum(scaled, size)
        weight = np.where(free, np.maximum(scaled, 1e-12), 0.0)
        scaled = scaled + over * weight / weight.sum()
    counts = np.minimum(np.floor(scaled + 1e-9), size).astype(np.int64)
    return _by_remainders(counts, scaled - counts, total, size)


def _by_remainders(counts: np.ndarray, remainders: np.ndarray, total: int, size: int) -> np.ndarray:
    while True:
        missing = total - int(counts.sum())
        if missing == 0:
            return counts
        step = 1 if missing > 0 else -1
        room = counts < size if step > 0 else counts > 0
        order = np.argsort(-step * np.where(room, remainders, -step * np.inf), kind="stable")
        chosen = order[: min(abs(missing), int(room.sum()))]
        counts[chosen] += step
        remainders[chosen] -= step


def _randomly_corrected(counts: np.ndarray, total: int, size: int, stream: Stream) -> np.ndarray:
    counts = np.minimum(counts, size)
    while True:
        missing = total - int(counts.sum())
        if missing == 0:
            return counts
        step = 1 if missing > 0 else -1
        for layer in (stream.uniform(abs(missing)) * len(counts)).astype(int):
            if 0 <= counts[layer] + step <= size:
                counts[layer] += step


# --------------------------------------------------------------------------------------------- from designs and curves


def targets_of_voxels(voxels: np.ndarray, voxel: Tuple[float, float, float] = (0.1, 0.1, 0.1)) -> Targets:
    """Return the targets that a design, or a sample given as voxels, fulfils.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    voxel : tuple
        Edges dx, dy, dz, mm.

    Raises
    ------
    ParameterError
        If the array has not three axes, or is empty or full.
    """
    voxels = np.asarray(voxels)
    require(voxels.ndim == 3 and voxels.size > 0, "a design must be an array with three axes", voxels.shape)
    solid = voxels.astype(bool)
    count = int(solid.sum())
    require(0 < count < solid.size, f"a sample must have material and voids: of {solid.size} cells are solid", count)
    counts = triple(solid.sum(axes, dtype=np.int64) for axes in ((0, 1), (0, 2), (1, 2)))
    return Targets(*counts, triple(voxel), sample=solid)
