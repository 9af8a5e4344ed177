# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods coloured by what they are: their size, their coupling, how they came through the recovery."""

from __future__ import annotations

from typing import Callable, Dict

import numpy as np

from ..errors import ParameterError
from .colours import BLUE, GREY, ORANGE, VERMILION, Colouring, Entry, by_class, by_value
from .wireframe import Wireframe, rows_of_rods

RECOVERY, FAILED = "recovery", "failed, left out"
#: What became of a rod, and its colour; those that failed are no rods any more: see ``failed_lines``.
OUTCOMES = {"as drawn": BLUE, "mended": ORANGE, "leaves the envelope": VERMILION, FAILED: GREY}


def end_sizes(wireframe: Wireframe) -> np.ndarray:
    """Return the sizes (R, 2) of the rods' two end sections, mm."""
    ends = wireframe.ends
    return np.stack([ends.first.size, ends.second.size if ends.rolls else ends.first.size], 1)


def _by_size(wireframe: Wireframe) -> Colouring:
    sizes = end_sizes(wireframe)
    return by_value(sizes.mean(1), "size", "mm", sizes.ravel())


def _by_coupling(wireframe: Wireframe) -> Colouring:
    numbers, places = np.unique(wireframe.coupling, return_inverse=True)
    rows = rows_of_rods(wireframe)
    names = [str(k + 1) for k in numbers.tolist()]
    if len(rows) and rows[0] >= 0:
        names = [f"{wireframe.rows[k].first} - {wireframe.rows[k].second}" for k in np.unique(rows).tolist()]
    return by_class(places.reshape(-1), names, "coupling")


def _by_recovery(wireframe: Wireframe) -> Colouring:
    mended = {one.rod for one in wireframe.recoveries}
    outside = set(wireframe.outside)
    outcome = [2 if name in outside else 1 if name in mended else 0 for name in wireframe.names]
    names = list(OUTCOMES)
    colouring = by_class(np.array(outcome, int), names, RECOVERY, list(OUTCOMES.values()))
    if not wireframe.failed:
        return colouring
    failed = Entry(FAILED, OUTCOMES[FAILED], len(wireframe.failed))
    return colouring._replace(legend=colouring.legend._replace(entries=(*colouring.legend.entries, failed)))


def failed_lines(wireframe: Wireframe) -> np.ndarray:
    """Return the straight lines (F, 2, 3), mm, between the sites of the rods that failed and were left out.

    Notes
    -----
    A rod is called ``<site>-<site>``, and names of sites may hold hyphens: it is split where both parts are sites.
    """
    sites = wireframe.sites.values()
    places = {name: point for one in sites for name, point in zip(one.names, one.points)}
    lines = []
    for name in wireframe.failed:
        words = name.split("-")
        halves = (("-".join(words[:k]), "-".join(words[k:])) for k in range(1, len(words)))
        lines += [[places[a], places[b]] for a, b in halves if a in places and b in places][:1]
    return np.array(lines, float).reshape(-1, 2, 3)


#: What rods can be coloured by.
ROD_COLOURINGS: Dict[str, Callable[[Wireframe], Colouring]] = {
    "size": _by_size,
    "coupling": _by_coupling,
    RECOVERY: _by_recovery,
}


def rod_colouring(wireframe: Wireframe, by: str) -> Colouring:
    """Return the colours of the rods (R,) of a wireframe.

    Parameters
    ----------
    wireframe : Wireframe
    by : str
        A key of ``ROD_COLOURINGS``; ``size`` is the mean of both end sections, its range that of all.

    Raises
    ------
    ParameterError
        If it is none.
    """
    if by not in ROD_COLOURINGS:
        raise ParameterError(f"rods are coloured by one of {', '.join(ROD_COLOURINGS)}, got {by!r}")
    return ROD_COLOURINGS[by](wireframe)
