# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fill rules and offsets of contours.

*Winding* takes contours as the slicer gives them: the signed sum of their areas counts material that overlaps as often
as it overlaps. *Union* counts it once: what has a winding number of at least 1 is material. The two differ only where
bodies overlap or a surface runs through itself. Unions and offsets are made by manifold3d's CrossSection (Clipper2),
on a grid of 1e-8 mm; imported where it is used.
"""

from __future__ import annotations

from typing import Any, List, Tuple

import numpy as np

from ..optional_packages import optional_module
from ..progress import Progress, silent
from .contours import Contours

_ARC = 32  # segments of a circle in the rounded corners of an offset


def united(contours: Contours, progress: Progress = silent) -> Tuple[Contours, np.ndarray]:
    """Return the contours with all that overlaps on a plane united, and how many of each plane (S,) were replaced.

    Planes that the union does not change (same area, same number of contours) keep their contours as they are.

    Raises
    ------
    DependencyError
        If manifold3d is missing.
    """
    return _changed(contours, lambda section: section, progress, "uniting contours")


def offset_contours(contours: Contours, distance: float, progress: Progress = silent) -> Tuple[Contours, np.ndarray]:
    """Return the contours moved by a distance (mm, positive into the material), corners round, and how many (S,).

    Raises
    ------
    DependencyError
        If manifold3d is missing.
    """
    library = _library()

    def moved(section: Any) -> Any:
        return section.offset(-distance, library.JoinType.Round, 2.0, _ARC)

    return _changed(contours, moved, progress, "offsetting contours", always=True)


def _library() -> Any:
    return optional_module("manifold3d", "union and compensation need the package manifold3d")


def _changed(contours: Contours, change: Any, progress: Progress, what: str,
             always: bool = False) -> Tuple[Contours, np.ndarray]:  # fmt: skip
    library = _library()
    keep = np.ones(len(contours), bool)
    counts = np.zeros(len(contours.heights), np.int64)
    planes: List[int] = []
    polylines: List[np.ndarray] = []
    bounds = np.searchsorted(contours.plane, np.arange(len(contours.heights) + 1))
    for plane, (low, high) in enumerate(zip(bounds[:-1], bounds[1:])):
        closed = [c for c in range(low, high) if contours.closed[c]]
        if not closed:
            continue
        old = [contours.points[contours.starts[c] : contours.starts[c + 1]] for c in closed]
        section = library.CrossSection([np.ascontiguousarray(p) for p in old if len(p) > 2], library.FillRule.Positive)
        new = [np.asarray(p, float) for p in change(section).to_polygons()]
        if always or _differ(old, new):
            keep[closed] = False
            counts[plane] = len(closed)
            planes += [plane] * len(new)
            polylines += new
        progress(plane, len(contours.heights), what)
    return (contours if keep.all() else contours.replaced(keep, planes, polylines)), counts


def _differ(old: List[np.ndarray], new: List[np.ndarray]) -> bool:
    """Whether polygons have another area than others, or other numbers of outer contours and holes, above rounding."""
    before, after = (np.array([_area(polygon) for polygon in polygons]) for polygons in (old, new))
    rounding = 1e-9 * sum(np.abs(np.diff(polygon, axis=0)).sum() for polygon in old)  # steps of 1e-8 mm, either way
    same = all((sign * before > rounding).sum() == (sign * after > rounding).sum() for sign in (1, -1))
    return not same or abs(before.sum() - after.sum()) > rounding


def _area(polygon: np.ndarray) -> float:
    u, v = (polygon - polygon[:1]).T
    return float((u * np.roll(v, -1) - np.roll(u, -1) * v).sum() / 2)
