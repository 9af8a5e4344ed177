# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers of a voxel design as shapes (thesis Fig. 6.12): merged outlines as wires, or layers as solids."""

from __future__ import annotations

from typing import List, NamedTuple, Sequence, Tuple

import numpy as np
import Part
from FreeCAD import Vector

from ..core.parameters import require
from ..core.progress import Progress, silent
from ..core.voxels.layer_outlines import corner_count, layer_outlines
from ..errors import KernelError
from .vectors import vectors

#: Per corner of an outline, measured; for wires and for solids: CPU seconds to make, bytes in memory, and in STEP.
SECONDS_PER_CORNER = (1e-5, 9e-5)
MEMORY_PER_CORNER = (650.0, 1900.0)
STEP_PER_CORNER = (360.0, 4000.0)
_SAME_VOLUME = 1e-9  # relative


class ShapeEstimate(NamedTuple):
    """What shapes of some layers will take."""

    corners: int
    seconds: float
    memory: float
    step: float


def shape_estimate(voxels: np.ndarray, layers: Sequence[int], solid: bool) -> ShapeEstimate:
    """Return corners, CPU seconds, bytes in memory and bytes as STEP, before anything is made.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    layers : sequence of int
        Numbers of layers along Z.
    solid : bool
        Solids instead of wires.

    Raises
    ------
    ParameterError
        If a layer is none of the design's.
    """
    corners = corner_count(voxels[_checked(layers, len(voxels))])
    kind = int(solid)
    return ShapeEstimate(
        corners,
        corners * SECONDS_PER_CORNER[kind],
        corners * MEMORY_PER_CORNER[kind],
        corners * STEP_PER_CORNER[kind],
    )


def layer_wires(
    voxels: np.ndarray,
    voxel: Sequence[float],
    origin: Sequence[float],
    layers: Sequence[int],
    progress: Progress = silent,
) -> Part.Compound:
    """Return the outlines of layers along Z as closed wires at the layers' low sides: a compound a layer.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    voxel, origin : sequence of three floats, mm
        dx, dy, dz; low corner of the first voxel.
    layers : sequence of int
    progress : Progress

    Raises
    ------
    ParameterError
        If a layer is none of the design's.
    """
    compounds = []
    for done, k in enumerate(_checked(layers, len(voxels))):
        progress(done, len(layers), "outlines of layers")
        outlines = layer_outlines(voxels[k])
        compounds.append(Part.makeCompound([_wire(o, k, voxel, origin) for o in outlines]))
    return Part.makeCompound(compounds)


def layer_solids(
    voxels: np.ndarray,
    voxel: Sequence[float],
    origin: Sequence[float],
    layers: Sequence[int],
    progress: Progress = silent,
) -> Part.Compound:
    """Return layers along Z as solids, one for each part of a layer; arguments as for ``layer_wires``.

    Raises
    ------
    ParameterError
        If a layer is none of the design's.
    KernelError
        If a layer's solids have another volume than its voxels.
    """
    compounds = []
    for done, k in enumerate(_checked(layers, len(voxels))):
        progress(done, len(layers), "layers as solids")
        solids = [
            Part.Face([_wire(o, k, voxel, origin) for o in group]).extrude(Vector(0, 0, float(voxel[2])))
            for group in _parts(layer_outlines(voxels[k]))
        ]
        volume = sum(solid.Volume for solid in solids)
        wanted = float(voxels[k].sum()) * float(np.prod(voxel))
        if abs(volume - wanted) > _SAME_VOLUME * max(wanted, 1e-300):
            raise KernelError(
                f"layer {k} as solids must hold the {wanted:.9g} mm3 of its voxels, the kernel gives {volume:.9g} mm3"
            )
        compounds.append(Part.makeCompound(solids))
    return Part.makeCompound(compounds)


def _checked(layers: Sequence[int], count: int) -> List[int]:
    numbers = [int(k) for k in layers]
    for k in numbers:
        require(0 <= k < count, f"a layer must be one of 0..{count - 1}", k)
    return numbers


def _wire(corners: np.ndarray, layer: int, voxel: Sequence[float], origin: Sequence[float]) -> Part.Wire:
    points = np.column_stack([corners, np.full(len(corners), layer)]) * np.asarray(voxel) + np.asarray(origin)
    return Part.makePolygon(vectors(np.concatenate([points, points[:1]])))


def _parts(outlines: Sequence[np.ndarray]) -> List[List[np.ndarray]]:
    """Outlines in groups: an outer one first, the holes in it after it."""
    areas = [_area(o) for o in outlines]
    groups = [[o] for o, area in zip(outlines, areas) if area > 0]
    sizes = [area for area in areas if area > 0]
    for outline, area in zip(outlines, areas):
        if area < 0:
            x, y = outline[0]  # the lowest, then leftmost corner: the square below it is solid
            around = [k for k, group in enumerate(groups) if _encloses(group[0], (x + 0.5, y - 0.5))]
            groups[min(around, key=sizes.__getitem__)].append(outline)
    return groups


def _area(corners: np.ndarray) -> float:
    x, y = corners.T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()) / 2


def _encloses(corners: np.ndarray, point: Tuple[float, float]) -> bool:
    """Whether a polygon along the axes has a point, which lies on none of its sides, inside."""
    following = np.roll(corners, -1, axis=0)
    upright = corners[:, 0] == following[:, 0]
    low, high = np.sort(np.stack([corners[upright, 1], following[upright, 1]]), axis=0)
    right = corners[upright, 0] > point[0]
    return bool(((low < point[1]) & (point[1] < high) & right).sum() % 2)
