# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods as solids: bicubic strips through every section and planar caps. No Boolean and no loft are involved."""

from __future__ import annotations

from typing import Iterator

import numpy as np
import Part

from ..core.parameters import RodParameters
from ..core.progress import Progress, silent
from ..core.rods import Rods, rod_volumes
from ..core.wireframe import Wireframe, skin
from ..errors import KernelError
from .vectors import vectors

VOLUME_TOLERANCE = 1e-3  # relative, of a solid's volume against that of its triangles
_FINE = 65  # stations of the mesh that is the measure
_MORE_STATIONS = (9, 17)  # tried where the first number gives another volume


def rod_solids(wireframe: Wireframe, parameters: RodParameters, progress: Progress = silent) -> Iterator[Part.Shape]:
    """Yield the solid of each rod of a wireframe.

    Parameters
    ----------
    wireframe : Wireframe
    parameters : RodParameters
        ``stations`` sections are interpolated.
    progress : callable

    Raises
    ------
    KernelError
        If a rod is no valid solid of positive volume.
    """
    if not len(wireframe):
        return
    fine = rod_volumes(skin(wireframe, parameters, _FINE))
    poles = [_surface_poles(skin(wireframe, parameters, n)) for n in (parameters.stations, *_MORE_STATIONS)]
    for k, name in enumerate(wireframe.names):
        progress(k, len(wireframe), "solids of rods")
        for some in poles:
            solid = _solid(some[k], name)
            if abs(solid.Volume / fine[k] - 1) <= VOLUME_TOLERANCE:
                break
        else:
            raise KernelError(
                f"a rod's solid must have its mesh's volume within {VOLUME_TOLERANCE:g}, got {solid.Volume:g} and "
                f"{fine[k]:g} mm3 for rod {name}"
            )
        yield solid


def _surface_poles(rods: Rods) -> np.ndarray:
    """B-spline poles (R, 2K, M, 4, 3) of the strips: natural cubic splines along the rods."""
    flat = np.einsum("rkmpc,rkcx->rkmpx", rods.poles, rods.frames[:, :, :2])
    p = rods.stations.centres[:, :, None, None] + flat
    k = p.shape[1]
    system = np.diag(np.r_[2.0, np.full(k - 2, 4.0), 2.0]) + np.diag(np.ones(k - 1), 1) + np.diag(np.ones(k - 1), -1)
    slopes = 3 * np.concatenate([p[:, 1:2] - p[:, :1], p[:, 2:] - p[:, :-2], p[:, -1:] - p[:, -2:-1]], 1)
    d = np.einsum("ij,rjmpx->rimpx", np.linalg.inv(system), slopes) / 3
    rows = np.stack([p - d, p + d], 2).reshape(p.shape[0], 2 * k, *p.shape[2:])
    rows[:, 0], rows[:, -1] = p[:, 0], p[:, -1]
    return rows


def _solid(rows: np.ndarray, name: str) -> Part.Shape:
    count = len(rows) // 2
    knots, multiplicities = [float(i) for i in range(count)], [4] + [2] * (count - 2) + [4]
    faces, wires = [], ([], [])
    for strip in range(rows.shape[1]):
        surface = Part.BSplineSurface()
        poles = [vectors(column) for column in rows[:, strip].transpose(1, 0, 2)]
        surface.buildFromPolesMultsKnots(poles, [4, 4], multiplicities, [0.0, 1.0], knots, False, False, 3, 3)
        faces.append(surface.toShape())
        for wire, end in zip(wires, (knots[0], knots[-1])):
            wire.append(surface.vIso(end).toShape())
    shell = Part.makeShell(faces + [Part.Face(Part.Wire(w)) for w in wires])
    shell.sewShape()
    solid = Part.Solid(shell if shell.ShapeType == "Shell" else shell.Shells[0])
    if solid.Volume < 0:
        solid.reverse()
    if not solid.isValid() or not solid.Volume > 0:
        raise KernelError(f"a rod must be a valid solid of positive volume, got {solid.Volume:g} mm3 for rod {name}")
    return solid
