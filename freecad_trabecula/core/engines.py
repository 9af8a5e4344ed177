# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which engine cuts the channels: an estimate of time and memory for each, and a choice that can be overruled."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ParameterError
from .booleans import manifold_available
from .field import field_estimate
from .optional_packages import INSTALL
from .parameters import ScaffoldParameters

#: Mesh engine: CPU seconds per triangle and halving of the rods, and per pair of rods that come near each other;
#: bytes per triangle. Fitted to 15 designs of 75 to 1,200 rods (2 cores, manifold3d 3.5.4, 0.4 to 68 s): right within
#: a factor of 2.
SECONDS_PER_TRIANGLE, SECONDS_PER_PAIR, BYTES_PER_TRIANGLE = 2.65e-6, 6.8e-5, 1.1e3
#: Times the field engine's own seconds and bytes that its bodies take with pieces, volumes and checks.
ACCOUNTS = (2.2, 1.3)
#: Beyond this many seconds of the mesh engine the field engine is taken; some 700 rods like case 6.
LONGEST = 30.0
_PIECES = 8  # boxes along a rod; finer ones cost more and tell no more about the time
_SAMPLE = 64  # rods whose neighbours are counted for all


class Estimate(NamedTuple):
    """What an engine will take.

    Attributes
    ----------
    engine : str
        ``mesh`` or ``field``.
    seconds : float
        CPU seconds.
    bytes : float
        Memory at the peak, beside the rods themselves.
    reason : str
        A sentence for the user.
    """

    engine: str
    seconds: float
    bytes: float
    reason: str


def near_pairs(vertices: np.ndarray) -> float:
    """Return about how many pairs of rods come near each other, from boxes around pieces of each.

    Parameters
    ----------
    vertices : ndarray of shape (R, V, 3), mm
        In the order of the rods' sections (``rods.rod_mesh``).

    Notes
    -----
    Up to 64 rods, evenly spread over the list, are held against all.
    """
    count, points = vertices.shape[:2]
    if count < 2 or not points:
        return 0.0
    cuts = np.linspace(0, points, min(_PIECES, points) + 1).astype(int)
    overlap = points // _PIECES // 2  # pieces share points, or triangles between them would lie in no box
    pieces = [vertices[:, max(a - overlap, 0) : b] for a, b in zip(cuts, cuts[1:])]
    low, high = (np.stack([f(p, axis=1) for p in pieces], 1) for f in (np.min, np.max))
    chosen = np.unique(np.linspace(0, count - 1, min(count, _SAMPLE)).astype(int))
    near = 0
    for k in chosen:  # one by one: memory stays linear
        meet = ((low[k][None, :, None] <= high[:, None]) & (low[:, None] <= high[k][None, :, None])).all(3)
        near += int(meet.any((1, 2)).sum()) - 1
    return near / len(chosen) * count / 2


def estimate(
    vertices: np.ndarray, triangles: np.ndarray, low: ArrayLike, high: ArrayLike, cell: float, engine: str
) -> Estimate:
    """Return what an engine will take for these rods.

    Parameters
    ----------
    vertices : ndarray of shape (R, V, 3), mm
    triangles : ndarray of shape (T, 3), int
        From ``rods.rod_mesh``.
    low, high : sequence of three floats, mm
        Bounds of the envelope.
    cell : float, mm
        Cell of the field engine.
    engine : str
        ``mesh`` or ``field``.

    Raises
    ------
    ParameterError
        If the engine is another one, or the cell is not above 0.
    """
    count = len(vertices) * len(triangles)
    if engine == "field":
        seconds, size = (a * b for a, b in zip(field_estimate(low, high, cell, count), ACCOUNTS))
        what = f"cells of {cell:g} mm"
    elif engine == "mesh":
        pairs = near_pairs(np.asarray(vertices, float))
        seconds = SECONDS_PER_TRIANGLE * count * math.log2(max(len(vertices), 2)) + SECONDS_PER_PAIR * pairs
        size = BYTES_PER_TRIANGLE * count
        what = f"{pairs:,.0f} pairs that come near"
    else:
        raise ParameterError(f"an estimate can be made for the mesh or the field engine, got {engine!r}")
    reason = (
        f"{engine} engine, {len(vertices):,} rods, {count:,} triangles, {what}: "
        f"about {seconds:,.1f} s and {size / 1e9:,.2f} GB"
    )
    return Estimate(engine, seconds, size, reason)


def choose(
    parameters: ScaffoldParameters,
    vertices: np.ndarray,
    triangles: np.ndarray,
    low: ArrayLike,
    high: ArrayLike,
) -> Estimate:
    """Return the engine to take, with its estimate and why (arguments as for ``estimate``).

    A named engine is taken as it is; the B-Rep engine is checked against the mesh engine, so that is what runs here.
    ``auto`` takes the mesh engine, which is exact, unless that would last longer than ``LONGEST`` or manifold3d is
    not installed.

    Raises
    ------
    ParameterError
        If the field engine is named, closed layers need a Boolean, and manifold3d is not installed.
    """
    layers = parameters.layers
    closed = bool(layers.faces) and layers.closed
    install = INSTALL["manifold3d"]
    if parameters.engine == "field" and closed and not manifold_available():
        raise ParameterError(
            f"closed layers need a Boolean, which takes them out of the rods, and that needs manifold3d: {install}; "
            "or choose layers that are not closed"
        )
    sizes = [estimate(vertices, triangles, low, high, parameters.cell, engine) for engine in ("mesh", "field")]
    mesh, field = sizes
    if parameters.engine != "auto":
        return field if parameters.engine == "field" else mesh
    if closed and not manifold_available():
        return mesh._replace(reason=mesh.reason + "; closed layers need a Boolean")
    if not manifold_available():
        return field._replace(reason=f"{field.reason}; the exact mesh engine needs manifold3d: {install}")
    if mesh.seconds > LONGEST:
        return field._replace(reason=f"{field.reason}; the exact mesh engine would take about {mesh.seconds:,.0f} s")
    return mesh._replace(reason=mesh.reason + "; exact")
