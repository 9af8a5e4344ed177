# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of path (thesis 2.4.4, 3.2.4, 4.2.4, 7.1), in one table: parameters, recovery, panel and pages read it.

A new kind is a function ``(parameters, ends, region, seed, attempt) -> paths`` and a line in ``PATH_LAWS``; numbers
that it needs and that are not there yet are fields of ``parameters.PathParameters``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Dict, Sequence, Tuple

import numpy as np

from .laws import Region
from .paths import middle_paths, straight_paths, tension_paths
from .streams import Stream

if TYPE_CHECKING:
    from .parameters import PathParameters


@dataclass(frozen=True)
class PathEnds:
    """Where the paths of R rods begin and end.

    Attributes
    ----------
    names : sequence of str
        Of the rods: each draws from a stream of its own name.
    p0, p1 : ndarray (R, 3), mm
    n0, n1 : ndarray (R, 3)
        Unit directions of travel: the inner normal at p0, the outer normal at p1.
    """

    names: Sequence[str]
    p0: np.ndarray
    n0: np.ndarray
    p1: np.ndarray
    n1: np.ndarray


def _straight(path: PathParameters, ends: PathEnds, region: Region, seed: int, attempt: int) -> np.ndarray:
    return straight_paths(ends.p0, ends.p1)


def _through_middle(path: PathParameters, ends: PathEnds, region: Region, seed: int, attempt: int) -> np.ndarray:
    return middle_paths(ends.p0, _middle_points(path, ends, region, _drawn(ends, seed, attempt)), ends.p1)


def _through_box(path: PathParameters, ends: PathEnds, region: Region, seed: int, attempt: int) -> np.ndarray:
    """Through a convergence point plus a random offset in the box (Eq. 3.1)."""
    drawn = _drawn(ends, seed, attempt)
    offset = (drawn[:, 1:] - 0.5) * np.array(path.box)
    return middle_paths(ends.p0, _middle_points(path, ends, region, drawn) + offset, ends.p1)


def _by_tension(path: PathParameters, ends: PathEnds, region: Region, seed: int, attempt: int) -> np.ndarray:
    tensions = [
        np.array([law.draw(Stream(seed, "tension", end, name), 1, p, region)[0] for name, p in zip(ends.names, points)])
        for end, (law, points) in enumerate(((path.tension_first, ends.p0), (path.tension_second, ends.p1)))
    ]
    return tension_paths(ends.p0, ends.n0, ends.p1, ends.n1, tensions[0].reshape(-1), tensions[1].reshape(-1))


def _drawn(ends: PathEnds, seed: int, attempt: int) -> np.ndarray:
    """Random numbers (R, 4) in 0..1: which convergence point, where in the box."""
    return np.array([Stream(seed, "middle", name, attempt).uniform(4) for name in ends.names]).reshape(-1, 4)


def _middle_points(path: PathParameters, ends: PathEnds, region: Region, drawn: np.ndarray) -> np.ndarray:
    """Convergence points (R, 3), mm."""
    targets = np.array(path.points or (region.centre,), float)
    if path.choice == "nearest":
        chord = (ends.p0 + ends.p1) / 2
        return targets[np.linalg.norm(chord[:, None] - targets[None], axis=2).argmin(1)]
    return targets[(drawn[:, 0] * len(targets)).astype(int)]


@dataclass(frozen=True)
class PathLaw:
    """One kind of path.

    Attributes
    ----------
    summary : str
        For tooltips and pages.
    draw : callable
        ``(parameters, ends, region, seed, attempt) -> paths (R, 2, 4, 3)``, mm; ``attempt`` > 0 draws others.
    fields : tuple of str
        Fields of ``PathParameters`` that count, in the order of the panel.
    is_curved : bool
        Curves can be mended by other tangents at their ends.
    to_feet : bool
        Paths end at the foot of the first site's normal on the second face, not at a site.
    redraws : callable
        ``(parameters) -> bool``: whether another attempt gives another path.
    """

    summary: str
    draw: Callable[..., np.ndarray]
    fields: Tuple[str, ...] = ()
    is_curved: bool = True
    to_feet: bool = False
    redraws: Callable[[PathParameters], bool] = lambda path: False


PATH_LAWS: Dict[str, PathLaw] = {
    "orthogonal": PathLaw("along the normal", _straight, is_curved=False, to_feet=True),
    "straight": PathLaw("joins the sites", _straight, is_curved=False),
    "centre": PathLaw(
        "3-point curve through a convergence point",
        _through_middle,
        ("choice", "points"),
        redraws=lambda path: len(path.points) > 1,
    ),
    "box": PathLaw(
        "through a random point of a box about it (Eq. 3.1)",
        _through_box,
        ("box", "choice", "points"),
        redraws=lambda path: True,
    ),
    "tension": PathLaw("2-point curve along the inner normals", _by_tension, ("tension_first", "tension_second")),
}


def draw_paths(path: PathParameters, ends: PathEnds, region: Region, seed: int, attempt: int = 0) -> np.ndarray:
    """Return the paths (R, 2, 4, 3) of rods, mm; ``attempt`` > 0 draws other middle points."""
    return PATH_LAWS[path.kind].draw(path, ends, region, seed, attempt)
