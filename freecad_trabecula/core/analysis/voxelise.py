# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles -> voxels, by rays: a voxel is solid where the winding number at its centre is above 0."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ...errors import MeshError, ParameterError
from ..progress import Progress, silent
from ..rays import RayGrid, crossings, union_intervals
from ..triples import triple

#: Low and high corner, mm.
Box = Union[np.ndarray, Sequence[Sequence[float]]]

DEFAULT_CELLS = 200  # along the longest edge of the box: the most that are taken unasked
FEWEST_CELLS = 100  # and the fewest
THICKNESS_CELLS = 8  # voxels across a plate of the mean thickness that are enough
MOST_CELLS = 1_000_000_000
_LAYERS = 16  # of voxels at once


@dataclass(frozen=True)
class Voxels:
    """A body in a box as cubic voxels.

    Attributes
    ----------
    solid : ndarray of shape (P, M, N), bool
        Index order [z, y, x]; the value at the voxel's centre.
    size : float, mm
        Edge of a voxel.
    origin : tuple of three floats, mm
        Low corner of the first voxel.

    Raises
    ------
    MeshError
        If the array is no three-dimensional bool array, or empty.
    ParameterError
        If the size is not above 0.
    """

    solid: np.ndarray
    size: float
    origin: Tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        if self.solid.ndim != 3 or self.solid.dtype != bool or not self.solid.size:
            raise MeshError(f"voxels must be a bool array [z, y, x], got {self.solid.dtype} of {self.solid.shape}")
        if not (math.isfinite(self.size) and self.size > 0):
            raise ParameterError(f"the size of voxels must be > 0, got {self.size} mm")

    @property
    def volume(self) -> float:
        """Volume of the box, mm³ (TV)."""
        return self.solid.size * self.size**3

    @property
    def solid_fraction(self) -> float:
        """Share of solid voxels (BV/TV)."""
        return float(np.count_nonzero(self.solid) / self.solid.size)


def default_size(low: ArrayLike, high: ArrayLike) -> float:
    """Return the edge, mm, of voxels of which 200 lie along the longest edge of a box."""
    return float(np.max(np.asarray(high, float) - np.asarray(low, float))) / DEFAULT_CELLS


def mean_thickness(triangles: np.ndarray) -> float:
    """Return the mean thickness 2 V / S of a closed mesh, mm (plate model, Parfitt 1983, doi:10.1172/JCI111096).

    Examples
    --------
    >>> o, x, y, z = np.eye(4, 3, -1)
    >>> faces = np.array([[o, y, x], [o, x, z], [o, z, y], [x, y, z]])
    >>> round(mean_thickness(faces), 6)  # 2 / 6 / (3 / 2 + sqrt(3) / 2)
    0.140883
    """
    a, b, c = (np.asarray(triangles[:, k], float) for k in range(3))
    normals = np.cross(b - a, c - a)
    surface = float(np.sqrt((normals**2).sum(1)).sum()) / 2
    volume = float((a * normals).sum()) / 6
    return 2 * volume / surface if surface > 0 else math.nan


def fitting_size(triangles: np.ndarray, box: Box) -> float:
    """Return the edge, mm, of voxels that resolve a closed mesh: eight across its mean thickness, 100 to 200 in all.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
    box : two points (low, high), mm

    Notes
    -----
    Thick bodies get larger voxels: the time of the largest spheres grows with the sixth power of their radius in
    voxels.
    """
    return size_for(abs(mean_thickness(triangles)), box)


def size_for(thickness: float, box: Box) -> float:
    """Return the edge, mm, of voxels for a body of a mean thickness, mm, in a box; nan: it is not known."""
    finest = default_size(*box)
    if math.isnan(thickness):
        return finest
    return min(max(thickness / THICKNESS_CELLS, finest), finest * DEFAULT_CELLS / FEWEST_CELLS)


def voxelise(
    triangles: np.ndarray,
    size: float,
    box: Optional[Box] = None,
    progress: Progress = silent,
) -> Voxels:
    """Return the voxels of closed meshes in a box.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
        Of closed meshes, which may overlap.
    size : float, mm
        Edge of a voxel.
    box : two points (low, high), mm, optional
        By default the triangles' own bounding box. Each direction gets the nearest whole number of voxels, laid about
        the box's middle, so that the grid is up to a quarter of a voxel larger or smaller at each end than the box,
        and no centre lies outside of it.
    progress : callable

    Raises
    ------
    MeshError
        If there are no triangles, a mesh is open, or a co-ordinate is not finite.
    ParameterError
        If the size is not above 0, the box is empty, or there would be more than 10^9 voxels.
    """
    if not len(triangles):
        raise MeshError("a mesh to be voxelised must have at least one triangle, got 0")
    triangles = np.asarray(triangles, np.float64)
    low, high = (triangles.min((0, 1)), triangles.max((0, 1))) if box is None else np.asarray(box, float)
    counts, origin = _grid(low, high, size)
    solid = np.empty(counts[::-1], bool)
    for first in range(0, counts[2], _LAYERS):
        progress(first, counts[2], "voxels")
        layers = min(_LAYERS, counts[2] - first)
        start = (origin[1] + size / 2, origin[2] + size / 2)
        grid = RayGrid(0, start, (size, size), (0, first), (counts[1], layers))
        solid[first : first + layers] = _filled(triangles, grid, origin[0], size, counts[0])
    return Voxels(solid, float(size), triple(float(x) for x in origin))


def _grid(low: np.ndarray, high: np.ndarray, size: float) -> Tuple[np.ndarray, np.ndarray]:
    """Numbers of voxels (3,) and the low corner (3,) of the grid about a box's middle."""
    if not (math.isfinite(size) and size > 0):
        raise ParameterError(f"the size of voxels must be > 0, got {size} mm")
    if not (np.isfinite(low).all() and np.isfinite(high).all() and (high > low).all()):
        raise ParameterError(f"a box must satisfy low < high on every axis, got {low} and {high} mm")
    counts = np.maximum(np.rint((high - low) / size), 1)
    if counts.prod() > MOST_CELLS:
        raise ParameterError(
            f"there may be at most {MOST_CELLS:.0e} voxels, a size of {size:g} mm makes {counts.prod():.2e}"
        )
    return counts.astype(np.int64), (low + high - counts * size) / 2


def _filled(triangles: np.ndarray, grid: RayGrid, low: float, size: float, count: int) -> np.ndarray:
    """Voxels (layers, rows, count) of the rays of a grid along x: solid from entering to leaving."""
    ray, start, end = union_intervals(crossings(triangles, grid))
    toggles = np.zeros((grid.count[0] * grid.count[1], count + 1), np.uint8)
    for at in (start, end):
        index = np.ceil((at - low) / size - 0.5).clip(0, count).astype(np.int64)
        flat = ray * (count + 1) + index
        # several surfaces may lie in one voxel: a pair of them changes nothing
        odd, times = np.unique(flat, return_counts=True)
        toggles.ravel()[odd[times % 2 == 1]] ^= 1
    within = np.bitwise_xor.accumulate(toggles[:, :count], axis=1).astype(bool)
    return within.reshape(grid.count[0], grid.count[1], count).transpose(1, 0, 2)
