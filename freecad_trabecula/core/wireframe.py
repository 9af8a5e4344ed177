# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe of a design: sites, pores, pairs, paths, end sections, mended where needed. Rods and channels are views of it."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, replace
from typing import Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np

from .couplings import CouplingRow, Pairs, couple
from .laws import Region
from .parameters import Coupling, PathParameters, PoreParameters, RodParameters, SiteEdit, check_seed
from .paths import middle_paths, straight_paths, tension_paths
from .pores import Pores, draw_pores, edit_pores, join_pores, mirrored
from .progress import Progress, silent
from .rods import RodEnds, Rods, build_rods, default_deflection, tessellation
from .sites import Sites
from .streams import Stream

#: ``contains(points (P, 3)) -> (P,) bool``: whether points lie in the envelope.
Contains = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class WireframeParameters:
    """What a wireframe depends on besides the sites."""

    pores: PoreParameters = PoreParameters()
    path: PathParameters = PathParameters()
    couplings: Tuple[Coupling, ...] = ()
    rods: RodParameters = RodParameters()
    edits: Tuple[SiteEdit, ...] = ()
    seed: int = 1

    def __post_init__(self) -> None:
        check_seed(self.seed)


@dataclass(frozen=True)
class Recovery:
    """How one faulty rod was mended: the fault, the remedy that served (or "none") and the number of attempts."""

    rod: str
    fault: str
    remedy: str
    attempts: int


@dataclass(frozen=True)
class Wireframe:
    """R rods before they are skinned.

    Attributes
    ----------
    sites : dict of Sites, by face
    pores : dict of Pores, by face; in the sites' own axes
    rows : tuple of CouplingRow
    names : tuple of str
        ``<site>-<site>``, one a rod.
    coupling : ndarray (R,), int
        Index of each rod's coupling.
    site_numbers : ndarray (R, 2), int
        Indices of its two sites in their faces.
    paths : ndarray (R, 2, 4, 3), mm
    ends : RodEnds
    recoveries : tuple of Recovery
    failed : tuple of str
        Rods that no remedy mended; they are left out of the arrays above.
    outside : tuple of str
        Rods that leave the envelope between their ends, though steered.
    """

    sites: Dict[str, Sites]
    pores: Dict[str, Pores]
    rows: Tuple[CouplingRow, ...]
    names: Tuple[str, ...]
    coupling: np.ndarray
    site_numbers: np.ndarray
    paths: np.ndarray
    ends: RodEnds
    recoveries: Tuple[Recovery, ...] = ()
    failed: Tuple[str, ...] = ()
    outside: Tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.names)

    @property
    def mean_size(self) -> float:
        """Mean size of the rods' end sections, mm."""
        return float(np.concatenate([self.ends.first.size, self.ends.second.size]).mean()) if len(self) else 0.5

    def keys(self) -> List[str]:
        """Return a hash of each rod's numbers: equal keys, equal rods, whatever else changed."""
        arrays = [self.paths, self.ends.frames]
        arrays += [getattr(p, n) for p in (self.ends.first, self.ends.second) for n in Pores.__dataclass_fields__]
        flat = np.concatenate([a.reshape(len(self), -1) for a in arrays], 1) if len(self) else np.zeros((0, 1))
        return [hashlib.blake2b(np.ascontiguousarray(row).tobytes(), digest_size=12).hexdigest() for row in flat]

    def curved(self) -> bool:
        """Return whether any path bends."""
        chord = self.paths[:, 1, 3] - self.paths[:, 0, 0]
        inner = self.paths[:, 0, 3] - self.paths[:, 0, 0]
        return bool(len(self) and np.abs(np.cross(chord, inner)).max() > 1e-9)


def skin(wireframe: Wireframe, parameters: RodParameters, stations: int = 0) -> Rods:
    """Return the rods of a wireframe; ``stations`` > 0 overrides the number that the deflection asks for."""
    size = wireframe.mean_size
    count, points = tessellation(size, parameters.deflection or default_deflection(size), wireframe.curved())
    return build_rods(wireframe.paths, wireframe.ends, stations or count, points, parameters.lean)


def make_wireframe(
    parameters: WireframeParameters,
    sites: Dict[str, Sites],
    region: Region,
    contains: Optional[Contains] = None,
    progress: Progress = silent,
) -> Wireframe:
    """Return the wireframe of a design, faulty rods mended (thesis 2.4, 3.3.5, 4.2.4).

    Parameters
    ----------
    parameters : WireframeParameters
    sites : dict of Sites, by face
        Already edited by hand.
    region : Region
        Box and centre of the envelope.
    contains : callable, optional
        Tells which points lie in the envelope; without it no rod is looked for outside.

    Raises
    ------
    ParameterError
        If a coupling cannot be made.
    """
    from .recovery import mend

    progress(0, 3, "couplings")
    pairs, rows = couple(parameters.couplings, sites, parameters.seed)
    progress(1, 3, "pores and paths")
    drawn = {
        face: edit_pores(parameters.pores, draw_pores(parameters.pores, parameters.seed, s, region), s.names, parameters.edits)
        for face, s in sites.items()
    }
    raw = _assemble(parameters, sites, drawn, pairs, tuple(rows), region)
    progress(2, 3, "faults")
    mended = mend(raw, parameters, region, contains)
    progress(3, 3, "wireframe")
    return mended


def _assemble(
    parameters: WireframeParameters,
    sites: Dict[str, Sites],
    drawn: Dict[str, Pores],
    pairs: Sequence[Pairs],
    rows: Tuple[CouplingRow, ...],
    region: Region,
) -> Wireframe:
    names: List[str] = []
    blocks = []
    for pair in pairs:
        coupling = parameters.couplings[pair.coupling]
        a, b = sites[coupling.first], sites[coupling.second]
        own = [f"{p}-{q}" for p, q in zip(np.array(a.names)[pair.first], np.array(b.names)[pair.second])]
        orthogonal = (coupling.path or parameters.path).kind == "orthogonal"
        frames = end_frames(a, pair.first, b, pair.second)
        first, second = mirrored(drawn[coupling.first].take(pair.first)), drawn[coupling.second].take(pair.second)
        goal = _feet(a, pair.first, b, pair.second) if orthogonal else b.points[pair.second]
        paths = draw_paths(
            coupling.path or parameters.path, own, a.points[pair.first], frames[:, 0, 2], goal, frames[:, 1, 2], region, parameters.seed
        )
        numbers = np.stack([pair.first, pair.second], 1)
        blocks.append((np.full(len(own), pair.coupling), numbers, paths, frames, first, second))
        names += own
    if not blocks:
        empty = Pores(np.zeros(0), np.zeros((0, 4, 2)), np.zeros((0, 4)), np.zeros((0, 4)))
        ends = RodEnds(np.zeros((0, 2, 3, 3)), empty, empty)
        return Wireframe(sites, drawn, rows, (), np.zeros(0, int), np.zeros((0, 2), int), np.zeros((0, 2, 4, 3)), ends)
    coupling_numbers, numbers, paths, frames = (np.concatenate([b[i] for b in blocks]) for i in range(4))
    ends = RodEnds(
        frames, join_pores([b[4] for b in blocks]), join_pores([b[5] for b in blocks]), parameters.pores.sections == 2
    )
    return Wireframe(sites, drawn, rows, tuple(names), coupling_numbers, numbers, paths, ends)


def end_frames(a: Sites, first: np.ndarray, b: Sites, second: np.ndarray) -> np.ndarray:
    """Return the section planes (C, 2, 3, 3) of pairs, in the direction of travel: rows u, n x u, n."""
    n0, n1 = -a.normals[first], b.normals[second]
    frames = [np.stack([u, np.cross(n, u), n], 1) for u, n in ((a.u[first], n0), (b.u[second], n1))]
    return np.stack(frames, 1)


def _feet(a: Sites, first: np.ndarray, b: Sites, second: np.ndarray) -> np.ndarray:
    """Ends of orthogonal paths: where the inner normal at the first site meets the plane of the second (3.2.4)."""
    start, along, normal = a.points[first], -a.normals[first], b.normals[second]
    slope = (along * normal).sum(1)
    reach = ((b.points[second] - start) * normal).sum(1) / np.where(np.abs(slope) < 1e-9, 1e-9, slope)
    return start + reach[:, None] * along


def draw_paths(
    path: PathParameters,
    names: Sequence[str],
    p0: np.ndarray,
    n0: np.ndarray,
    p1: np.ndarray,
    n1: np.ndarray,
    region: Region,
    seed: int,
    attempt: int = 0,
) -> np.ndarray:
    """Return the paths (R, 2, 4, 3) of rods between p0 and p1 (R, 3), mm, with directions of travel n0 and n1 (R, 3) there.

    Each rod draws from a stream of its own name; ``attempt`` > 0 draws other middle points.
    """
    if path.kind in ("orthogonal", "straight"):
        return straight_paths(p0, p1)
    if path.kind == "tension":
        tensions = [
            np.array([law.draw(Stream(seed, "tension", end, name), 1, p, region)[0] for name, p in zip(names, points)])
            for end, (law, points) in enumerate(((path.tension_first, p0), (path.tension_second, p1)))
        ]
        return tension_paths(p0, n0, p1, n1, tensions[0].reshape(-1), tensions[1].reshape(-1))
    return middle_paths(p0, middle_points(path, names, p0, p1, region, seed, attempt), p1)


def middle_points(
    path: PathParameters, names: Sequence[str], p0: np.ndarray, p1: np.ndarray, region: Region, seed: int, attempt: int = 0
) -> np.ndarray:
    """Return the middle points (R, 3), mm, of 3-point paths: a convergence point, plus a random offset in the box (Eq. 3.1)."""
    targets = np.array(path.points or (region.centre,), float)
    drawn = np.array([Stream(seed, "middle", name, attempt).uniform(4) for name in names]).reshape(-1, 4)
    if path.choice == "nearest":
        chord = (p0 + p1) / 2
        chosen = np.linalg.norm(chord[:, None] - targets[None], axis=2).argmin(1)
    else:
        # the choice among the points belongs to the rod, not to the attempt
        pick = np.array([Stream(seed, "middle", name, 0).uniform(1)[0] for name in names])
        chosen = (pick * len(targets)).astype(int)
    middle = targets[chosen]
    if path.kind == "box":
        middle = middle + (drawn[:, 1:] - 0.5) * np.array(path.box)
    return middle


def without(wireframe: Wireframe, keep: np.ndarray) -> Wireframe:
    """Return the wireframe with only the rods of mask or indices ``keep``."""
    ends = wireframe.ends
    return replace(
        wireframe,
        names=tuple(np.array(wireframe.names, dtype=object)[keep]),
        coupling=wireframe.coupling[keep],
        site_numbers=wireframe.site_numbers[keep],
        paths=wireframe.paths[keep],
        ends=replace(ends, frames=ends.frames[keep], first=ends.first.take(keep), second=ends.second.take(keep)),
    )
