# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is right and wrong with triangles: whether they enclose a body, and what would spoil its slices."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Optional, Tuple

import numpy as np

from ..meshes import roots
from ..progress import Progress, part, silent
from .crossings import crossing_triangles
from .neighbours import corner_keys, partners_of
from .triangles import Soup, by_corners

_CHUNK = 1 << 15
_FLAT = 1e-12  # of the square of its longest edge: twice the area of a triangle that is a line


@dataclass(frozen=True)
class MeshFacts:
    """Counts, all 0 from ``open_edges`` on if the mesh is sound.

    Attributes
    ----------
    triangles : int
    parts : int
        Pieces that no edge joins.
    volume : float, mm³
        Signed; it means something for closed meshes only.
    area : float, mm²
        Of the surface.
    open_edges : int
        Half-edges without a partner, whose neighbour is missing or has its corners elsewhere.
    flipped : int
        Triangles that must be turned for their neighbours to agree; of both ways to do so the one that turns fewer.
    duplicates : int
        Triangles with the same corners as another one, however they turn.
    degenerate : int
        Triangles without area.
    self_intersecting : int
        Triangles that run through others; -1 if it was not looked for.
    """

    triangles: int
    parts: int
    volume: float
    area: float
    open_edges: int
    flipped: int
    duplicates: int
    degenerate: int
    self_intersecting: int = -1

    @property
    def is_closed(self) -> bool:
        """Whether every edge joins two triangles that turn the same way."""
        return self.open_edges == 0 and self.flipped == 0

    @property
    def is_sound(self) -> bool:
        """Whether nothing at all is wrong, as far as it was looked for."""
        faults = self.open_edges, self.flipped, self.duplicates, self.degenerate, max(self.self_intersecting, 0)
        return not any(faults)


def mesh_facts(soup: Soup, partners: Optional[np.ndarray] = None, progress: Progress = silent,
               crossings: bool = True) -> MeshFacts:  # fmt: skip
    """Return what is right and wrong with triangles.

    Parameters
    ----------
    partners : ndarray of shape (3 T,), optional
        From ``neighbours``, if known.
    crossings : bool
        Whether to look for triangles that run through others, which takes longer than all the rest.
    """
    partners = partners_of(soup.triangles, partners, part(progress, 0.0, 0.1))
    volume, area, degenerate = _sizes(soup.triangles, part(progress, 0.1, 0.15))
    keys = corner_keys(by_corners(soup.triangles)).reshape(3, -1)
    same = _same_way(keys, partners)
    progress(0.16, 1.0, "finding parts")
    parts, flipped = _parts(partners, same)
    joined = np.zeros(len(partners), bool)
    joined[same.ravel()] = True
    progress(0.18, 1.0, "finding doubles")
    duplicates, crossing = _duplicates(keys), -1
    if crossings:
        crossing = int(crossing_triangles(soup.triangles, keys, part(progress, 0.2, 1.0)).sum())
    return MeshFacts(
        triangles=len(soup.triangles), parts=parts, volume=volume, area=area,
        open_edges=int(((partners < 0) & ~joined & _has_length(keys)).sum()), flipped=flipped,
        duplicates=duplicates, degenerate=degenerate, self_intersecting=crossing,
    )  # fmt: skip


def _sizes(triangles: np.ndarray, progress: Progress) -> Tuple[float, float, int]:
    """Signed volume, area of the surface, number of triangles without area."""
    count = len(triangles)
    points = by_corners(triangles).reshape(3, 3, count)
    middle = (points.min((1, 2)).astype(float) + points.max((1, 2))) / 2
    volume = area = 0.0
    flat = 0
    for start in range(0, count, _CHUNK):
        a, b, c = (points[:, k, start : start + _CHUNK] - middle[:, None] for k in range(3))
        normal = np.cross(b - a, c - a, axis=0)
        double = np.sqrt((normal**2).sum(0))
        longest = np.maximum.reduce([((q - p) ** 2).sum(0) for p, q in ((a, b), (b, c), (c, a))])
        volume += float((a * normal).sum()) / 6
        area += float(double.sum()) / 2
        flat += int((double <= _FLAT * longest).sum())
        progress(start, count, "measuring triangles")
    return volume, area, flat


def _has_length(keys: np.ndarray) -> np.ndarray:
    """Whether each half-edge (3 T,) has two different ends; keys (3, T)."""
    return (keys != np.roll(keys, -1, 0)).ravel()


def _same_way(keys: np.ndarray, partners: np.ndarray) -> np.ndarray:
    """Pairs (2, E) of half-edges without partner that run the same way: neighbours that turn against each other."""
    free = np.flatnonzero((partners < 0) & _has_length(keys))
    start, end = keys.ravel()[free], np.roll(keys, -1, 0).ravel()[free]
    order = np.lexsort((end, start))
    free, start, end = free[order], start[order], end[order]
    pairs = np.flatnonzero((start[1:] == start[:-1]) & (end[1:] == end[:-1]))
    return np.stack([free[pairs], free[pairs + 1]])


def _parts(partners: np.ndarray, same: np.ndarray) -> Tuple[int, int]:
    """Number of pieces, and of triangles to be turned so that all neighbours in a piece agree."""
    count = len(partners) // 3
    half = np.flatnonzero(partners >= 0)
    patch = roots(count, *((ends % count).astype(np.int32) for ends in (half, partners[half])))
    is_root = patch == np.arange(count, dtype=np.int32)
    patch = (np.cumsum(is_root, dtype=np.int32) - 1)[patch]  # numbers without gaps
    names, sizes = range(int(is_root.sum())), np.bincount(patch)
    a, b = patch[same % count]
    links: List[List[int]] = [[] for _ in names]
    for p, q in zip(a.tolist(), b.tolist()):
        links[p].append(q)
        links[q].append(p)
    turned = np.full(len(names), -1)
    pieces = flipped = 0
    for first in range(len(names)):
        if turned[first] >= 0:
            continue
        pieces += 1
        turned[first], group, todo = 0, [first], [first]
        while todo:
            here = todo.pop()
            for other in links[here]:
                if turned[other] < 0:
                    turned[other] = 1 - turned[here]
                    group.append(other)
                    todo.append(other)
        ways = np.bincount(turned[group], sizes[group], 2)
        flipped += int(ways.min())
    return pieces, flipped


def _duplicates(keys: np.ndarray) -> int:
    """Triangles whose three corners another one has too."""
    corners = np.sort(keys, 0)
    names = corners[0] * np.uint64(3) + corners[1] * np.uint64(5) + corners[2] * np.uint64(7)
    names.sort()
    return int((names[1:] == names[:-1]).sum())
