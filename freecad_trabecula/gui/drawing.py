# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the preview shows, as plain arrays: rods as strips of triangles, sites, pairs, edges. No window, any thread."""

from __future__ import annotations

from typing import Dict, NamedTuple, Sequence, Tuple

import numpy as np

from ..core.colours import Legend, scale_colours
from ..core.rod_colours import ROD_COLOURINGS, end_sizes, failed_lines, rod_colouring
from ..core.rods import Rods, build_rods
from ..core.sites import Sites
from ..core.wireframe import Wireframe

#: Stations and ring points of previewed rods; a design of many rods takes the coarser ones.
_FINE, _COARSE, _COARSEST = (13, 12), (9, 8), (7, 6)
_MANY, _VERY_MANY = 200, 800


class Drawing(NamedTuple):
    """A preview.

    Attributes
    ----------
    vertices, normals : ndarray (V, 3), float32
        Of the rods.
    colours : dict of ndarray (V,), uint32
        0xRRGGBBAA of each vertex, by what the colours mean.
    legends : dict of Legend
        What they mean.
    strips : ndarray (I,), int32
        Strips of triangles, each closed by -1.
    sites, idle_sites : ndarray (P, 3), float32
        Sites in use, and those switched off or left over.
    pairs : ndarray (2 R, 3), float32
        Ends of the lines that join coupled sites.
    lost : ndarray (F, 2, 3), mm
        Ends of the rods that failed.
    low, high : tuple of 3 floats, mm
        The envelope's box.
    """

    vertices: np.ndarray
    normals: np.ndarray
    colours: Dict[str, np.ndarray]
    legends: Dict[str, Legend]
    strips: np.ndarray
    sites: np.ndarray
    idle_sites: np.ndarray
    pairs: np.ndarray
    lost: np.ndarray
    low: Tuple[float, float, float]
    high: Tuple[float, float, float]


def draw_wireframe(wireframe: Wireframe, low: Sequence[float], high: Sequence[float]) -> Drawing:
    """Return the preview of a wireframe in an envelope with the box ``low``..``high`` (3,), mm."""
    count = len(wireframe)
    stations, points = _FINE if count <= _MANY else _COARSE if count <= _VERY_MANY else _COARSEST
    rods = build_rods(wireframe.paths, wireframe.ends, stations, points)
    stations, points = rods.rings.shape[1:3]
    vertices, normals = _surface(rods)
    found = {by: rod_colouring(wireframe, by) for by in ROD_COLOURINGS}
    colours = {by: np.repeat(_packed(one.colours), (stations + 2) * points) for by, one in found.items()}
    along = _size_colours(end_sizes(wireframe), found["size"].legend, stations)  # rods may taper
    colours["size"] = np.repeat(along, points, 1).reshape(-1)
    used, idle = _sites(wireframe.sites, wireframe)
    return Drawing(
        vertices,
        normals,
        colours,
        {by: one.legend for by, one in found.items()},
        _strips(count, stations, points),
        used,
        idle,
        wireframe.paths[:, [0, 1], [0, 3]].reshape(-1, 3).astype(np.float32),
        failed_lines(wireframe),
        tuple(low),
        tuple(high),
    )


def _surface(rods: Rods) -> Tuple[np.ndarray, np.ndarray]:
    """Vertices and normals of all rings and then, per rod, of its two caps."""
    rings, on_path = rods.rings, rods.stations
    outwards = rings - on_path.centres[:, :, None]
    tangent = on_path.tangents[:, :, None]
    outwards = outwards - (outwards * tangent).sum(-1, keepdims=True) * tangent
    outwards /= np.linalg.norm(outwards, axis=-1, keepdims=True).clip(1e-12)
    caps = rods.frames[:, [0, -1], 2] * np.array([-1.0, 1.0])[:, None]
    normals = np.concatenate([outwards, np.broadcast_to(caps[:, :, None], rings[:, [0, -1]].shape)], 1)
    vertices = np.concatenate([rings, rings[:, [0, -1]]], 1)
    return vertices.reshape(-1, 3).astype(np.float32), normals.reshape(-1, 3).astype(np.float32)


def _strips(count: int, k: int, m: int) -> np.ndarray:
    """Indices of the strips: one between each two rings, one zigzag over each cap."""
    ring = np.arange(k * m).reshape(k, m)
    ring = np.concatenate([ring, ring[:, :1]], 1)
    sides = np.stack([ring[1:], ring[:-1]], 2).reshape(k - 1, -1)
    sides = np.concatenate([sides, np.full((k - 1, 1), -1)], 1).ravel()
    zigzag = np.stack([np.arange(m), np.arange(m)[::-1]], 1).ravel()[:m]
    near, far = k * m + zigzag, (k + 1) * m + (m - zigzag) % m
    one = np.concatenate([sides, near[::-1] if m % 2 else near, [-1], far, [-1]])
    strips = one[None] + (k + 2) * m * np.arange(count)[:, None]
    strips[:, one == -1] = -1
    return strips.ravel().astype(np.int32)


def _sites(sites: Dict[str, Sites], wireframe: Wireframe) -> Tuple[np.ndarray, np.ndarray]:
    """Places of the sites with and without a rod."""
    ends = wireframe.paths[:, [0, 1], [0, 3]].reshape(-1, 3).astype(np.float32)
    every = [one.points for one in sites.values()]
    every = np.concatenate(every).astype(np.float32) if every else np.zeros((0, 3), np.float32)
    taken = {row.tobytes() for row in np.round(ends, 4)}
    free = np.array([row.tobytes() not in taken for row in np.round(every, 4)], bool)
    return every[~free], every[free]


def _packed(colours: np.ndarray) -> np.ndarray:
    """Colours (..., 3) of 0..255 as 0xRRGGBBAA."""
    c = np.asarray(colours).astype(np.uint32)
    return (c[..., 0] << 24) | (c[..., 1] << 16) | (c[..., 2] << 8) | np.uint32(255)


def _size_colours(sizes: np.ndarray, legend: Legend, stations: int) -> np.ndarray:
    """Colours (R, K + 2) along rods with end sizes (R, 2), caps last."""
    share = np.linspace(0, 1, stations)
    along = sizes[:, :1] + (sizes[:, 1:] - sizes[:, :1]) * share
    along = np.concatenate([along, sizes], 1)
    return _packed(scale_colours((along - legend.low) / max(legend.high - legend.low, 1e-12)))
