# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rod as splines through many sections where its path bends: slower, for rods too sharp for ``rod_solids``."""

from __future__ import annotations

from typing import List, Optional, Tuple

import numpy as np
import Part

from ..core.rods import build_rods
from ..core.wireframe import Wireframe
from ..errors import KernelError
from .vectors import vectors

_RING = 16  # points of rings, which are not used
_STATIONS = (9, 17, 33, 65)


def spline_solid(rod: Wireframe, expected: float, tolerance: float) -> Optional[Part.Shape]:
    """Return the solid of a wireframe's only rod if its volume is ``expected`` within ``tolerance``, else None.

    Raises
    ------
    KernelError
        If the kernel makes no valid solid.
    """
    for stations in _STATIONS:
        poles, knots = _surfaces(rod, stations)
        solid = _solid(poles[0], knots[0].tolist(), rod.names[0])
        if abs(solid.Volume / expected - 1) <= tolerance:
            return solid
    return None


def _surfaces(wireframe: Wireframe, stations: int) -> Tuple[np.ndarray, np.ndarray]:
    """B-spline poles (R, 2K - 2 + 2, M, 4, 3) of the strips and their knots (R, K) along the rods.

    Natural cubic splines through the poles of the sections, over the share of the arc length.
    """
    rods = build_rods(wireframe.paths, wireframe.ends, stations, _RING, to_bends=True)
    p = rods.stations.centres[:, :, None, None] + np.einsum("rkmpc,rkcx->rkmpx", rods.poles, rods.frames[:, :, :2])
    knots = rods.stations.shares
    h = np.diff(knots, axis=1)
    slopes = np.diff(p, axis=1) / h[:, :, None, None, None]
    system, right = np.zeros((len(p), stations, stations)), np.zeros_like(p)
    at, wide = np.arange(stations), lambda a: a[:, :, None, None, None]
    system[:, at, at] = 2.0 * (np.pad(h, ((0, 0), (1, 0))) + np.pad(h, ((0, 0), (0, 1))))
    system[:, at[1:-1], at[:-2]], system[:, at[1:-1], at[2:]] = h[:, 1:], h[:, :-1]
    system[:, 0, 1], system[:, -1, -2] = h[:, 0], h[:, -1]
    right[:, 1:-1] = 3 * (wide(h[:, 1:]) * slopes[:, :-1] + wide(h[:, :-1]) * slopes[:, 1:])
    right[:, 0], right[:, -1] = (
        3 * (h[:, 0, None, None, None] * slopes[:, 0]),
        3 * (h[:, -1, None, None, None] * slopes[:, -1]),
    )
    d = np.linalg.solve(system, right.reshape(len(p), stations, -1)).reshape(p.shape)
    after, before = p[:, :-1] + d[:, :-1] * wide(h) / 3, p[:, 1:] - d[:, 1:] * wide(h) / 3
    inner = np.stack([after, before], 2).reshape(len(p), -1, *p.shape[2:])
    return np.concatenate([p[:, :1], inner, p[:, -1:]], 1), knots


def _solid(rows: np.ndarray, knots: List[float], name: str) -> Part.Shape:
    multiplicities = [4] + [2] * (len(knots) - 2) + [4]
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
