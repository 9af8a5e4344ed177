# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe of a design: sites, pores, pairs, paths, end sections. Rods and channels are views of it."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, replace
from typing import Callable, Dict, List, Tuple

import numpy as np

from .couplings import CouplingRow
from .parameters import Coupling, PathParameters, PoreParameters, RodParameters, SiteEdit, check_seed
from .paths import path_bends
from .pores import Pores
from .rods import RodEnds, Rods, build_rods, default_deflection, tessellation
from .sites import Sites

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
        arrays = [self.paths, self.ends.frames, self.ends.leans]
        arrays += [getattr(p, n) for p in (self.ends.first, self.ends.second) for n in Pores.__dataclass_fields__]
        flat = np.concatenate([a.reshape(len(self), -1) for a in arrays], 1) if len(self) else np.zeros((0, 1))
        return [hashlib.blake2b(np.ascontiguousarray(row).tobytes(), digest_size=12).hexdigest() for row in flat]


def skin(wireframe: Wireframe, parameters: RodParameters, stations: int = 0) -> Rods:
    """Return the rods of a wireframe, stations where paths bend; ``stations`` > 0 asks for so many, evenly spaced."""
    size = wireframe.mean_size
    bend = float(path_bends(wireframe.paths).max(initial=0.0))
    count, points = tessellation(size, parameters.deflection or default_deflection(size), bend)
    return build_rods(wireframe.paths, wireframe.ends, stations or count, points, to_bends=not stations)


def end_frames(a: Sites, first: np.ndarray, b: Sites, second: np.ndarray) -> np.ndarray:
    """Return the section planes (C, 2, 3, 3) of pairs, in the direction of travel: rows u, n x u, n."""
    n0, n1 = -a.normals[first], b.normals[second]
    frames = [np.stack([u, np.cross(n, u), n], 1) for u, n in ((a.u[first], n0), (b.u[second], n1))]
    return np.stack(frames, 1)


def rows_of_rods(wireframe: Wireframe) -> np.ndarray:
    """Return the row (R,) of the table of couplings to which each rod belongs; -1 where that cannot be told.

    Couplings that are off have no row, those without a pair of sites no rod; once all rods of a coupling have failed,
    rows and rods no longer follow each other.
    """
    numbers, places = np.unique(wireframe.coupling, return_inverse=True)
    made = np.array([k for k, row in enumerate(wireframe.rows) if row.rods], int)
    return made[places.reshape(-1)] if len(made) == len(numbers) else np.full(len(wireframe.coupling), -1)


def without(wireframe: Wireframe, keep: np.ndarray) -> Wireframe:
    """Return the wireframe with only the rods of mask or indices ``keep``."""
    ends = wireframe.ends
    return replace(
        wireframe,
        names=tuple(np.array(wireframe.names, dtype=object)[keep]),
        coupling=wireframe.coupling[keep],
        site_numbers=wireframe.site_numbers[keep],
        paths=wireframe.paths[keep],
        ends=replace(
            ends,
            frames=ends.frames[keep],
            first=ends.first.take(keep),
            second=ends.second.take(keep),
            leans=ends.leans[keep],
        ),
    )
