# SPDX-License-Identifier: LGPL-2.1-or-later
"""Couplings: which sites are joined (thesis 2.4.5, 3.2.3, 4.2.3)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Sequence, Tuple

import numpy as np

from ..errors import ParameterError
from .parameters import Coupling
from .sites import Sites
from .streams import Stream, mix


@dataclass(frozen=True)
class CouplingRow:
    """One row of the thesis' tables 4.2 and 4.5.

    Attributes
    ----------
    first, second : str
        Names of the two faces.
    available_first, available_second : int
        Sites not used by earlier couplings.
    rods : int
        Rods made.
    left_first, left_second : int
        Sites not used after this coupling.
    """

    first: str
    second: str
    available_first: int
    available_second: int
    rods: int
    left_first: int
    left_second: int


@dataclass(frozen=True)
class Pairs:
    """The pairs of one coupling: site ``first[c]`` of its first face with ``second[c]`` of its second; (C,) int64."""

    coupling: int
    first: np.ndarray
    second: np.ndarray


def couple(couplings: Sequence[Coupling], sites: Dict[str, Sites], seed: int) -> Tuple[List[Pairs], List[CouplingRow]]:
    """Return the pairs of sites and the table "available, rods, left", in the order of the couplings.

    The face with fewer free sites is used fully. A random pair depends on the seed and on the names of the two sites
    only: each possible pair has a random number, and the pairs are taken by falling number. All associations are
    equally likely, and a site that is added or switched off disturbs only its neighbours in that order.

    Raises
    ------
    ParameterError
        If a face is unknown or has no site, or a flat face is coupled with itself.
    """
    used = {name: ~s.on for name, s in sites.items()}
    pairs, rows = [], []
    for k, coupling in enumerate(couplings):
        if not coupling.on:
            continue
        _check(coupling, sites)
        free = {name: _free(coupling, sites, used, name) for name in {coupling.first, coupling.second}}
        a, b = _associate(coupling, sites, free, seed)
        if coupling.limit:
            a, b = a[: coupling.limit], b[: coupling.limit]
        available = len(free[coupling.first]), len(free[coupling.second])
        used[coupling.first][a] = True
        used[coupling.second][b] = True
        pairs.append(Pairs(k, a, b))
        same = coupling.first == coupling.second
        left = [n - (2 * len(a) if same else len(a)) for n in available]
        rows.append(CouplingRow(coupling.first, coupling.second, *available, len(a), *left))
    return pairs, rows


def _check(coupling: Coupling, sites: Dict[str, Sites]) -> None:
    for name in (coupling.first, coupling.second):
        if name not in sites:
            raise ParameterError(f"a coupling must join faces that have sites ({', '.join(sites)}), got {name!r}")
        if not sites[name].on.any():
            raise ParameterError(
                f"a coupled face must have at least 1 site, got 0 on face {name}: less spacing or border"
            )
    if coupling.first == coupling.second and sites[coupling.first].flat:
        raise ParameterError(
            f"a face can be coupled with itself only if it is curved: rods of the flat face {coupling.first} "
            "would lie in its plane"
        )


def _free(coupling: Coupling, sites: Dict[str, Sites], used: Dict[str, np.ndarray], name: str) -> np.ndarray:
    return np.nonzero(sites[name].on if coupling.reuse else ~used[name])[0]


def _associate(
    coupling: Coupling, sites: Dict[str, Sites], free: Dict[str, np.ndarray], seed: int
) -> Tuple[np.ndarray, np.ndarray]:
    first, second = sites[coupling.first], sites[coupling.second]
    a, b = free[coupling.first], free[coupling.second]
    if coupling.association == "same":
        places = {tuple(second.index[k].tolist()): int(k) for k in b}
        found = [
            (int(k), places[tuple(first.index[k].tolist())]) for k in a if tuple(first.index[k].tolist()) in places
        ]
        found = [(p, q) for p, q in found if coupling.first != coupling.second or p < q]
        return tuple(np.array(found, np.int64).reshape(-1, 2).T)  # type: ignore[return-value]
    same = coupling.first == coupling.second
    values = mix(_keys(seed, coupling, 0, first, a), _keys(seed, coupling, 0 if same else 1, second, b))
    return _greedy(values, a, b, same)


def _keys(seed: int, coupling: Coupling, end: int, sites: Sites, which: np.ndarray) -> np.ndarray:
    names = sites.names
    return np.concatenate(
        [Stream(seed, "pair", coupling.first, coupling.second, end, names[k]).integers(1) for k in which.tolist()]
        or [np.zeros(0, np.uint64)]
    )


def _greedy(values: np.ndarray, a: np.ndarray, b: np.ndarray, same: bool) -> Tuple[np.ndarray, np.ndarray]:
    """Take pairs by falling random number until the smaller side is used up; in the order of the first sites."""
    order = np.argsort(values, axis=None, kind="stable")[::-1]
    taken_a, taken_b = np.zeros(len(a), bool), np.zeros(len(b), bool)
    wanted = len(a) // 2 if same else min(len(a), len(b))
    found: List[Tuple[int, int]] = []
    for p, q in zip((order // max(len(b), 1)).tolist(), (order % max(len(b), 1)).tolist()):
        if len(found) == wanted:
            break
        if taken_a[p] or taken_b[q] or (same and (p == q or taken_a[q] or taken_b[p])):
            continue
        taken_a[p] = taken_b[q] = True
        found.append((int(a[p]), int(b[q])))
    found.sort()
    return tuple(np.array(found, np.int64).reshape(-1, 2).T)  # type: ignore[return-value]
