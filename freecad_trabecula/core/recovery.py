# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recovery of faulty rods (thesis 3.3.5, 4.2.4): what is tried, in which order, counted for every rod.

The thesis first redraws tangents. Measured, that never mends a flat rod, nor one whose section planes cross (0 of 79),
so what is tried first follows from the fault: tangents for a section that crosses itself, the middle point where it is
random for the others, then the two-point path along the inner normals with tension 0.1, 0.2, ... mm (thesis 4.2.4), and
last the same path with its section planes carried along it instead of turned from end to end, which serves paths that
turn back or sideways (rods between near sites of one side, or far ones of a thin plate).
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from .laws import Region
from .path_laws import PATH_LAWS, PathEnds, draw_paths
from .paths import tension_paths
from .pores import Pores, draw_pores, mirrored
from .progress import Progress, part, silent
from .rods import CARRIED, RodEnds, Rods, build_rods, rod_faults, sharpest_bends
from .sites import Sites
from .wireframe import Contains, Recovery, Wireframe, WireframeParameters, without

FAULTS = ("loop", "flat", "crossing", "outside")
REMEDIES: Dict[str, Tuple[str, ...]] = {
    "loop": ("tangents", "middle", "tension", "carry"),
    "flat": ("middle", "tension", "carry"),
    "crossing": ("middle", "tangents", "tension", "carry"),
    "outside": ("middle", "tension", "carry"),
}
TENSION_STEP = 0.1  # mm, thesis 4.2.4
#: Stations of the check of two-point paths: a small tension turns a path within less than its width from the end,
#: unseen between stations farther apart.
_CLOSE_STATIONS = 65
_SHARP = 0.7  # of a two-point path's bend: 1 folds, and a channel near it is a kink that nothing flows through
_BLOCK = 8  # attempts worked out at once
_FAULTY = 10**9  # more than any number of points outside
_STATIONS, _POINTS = 17, 16  # of the check: plane crossing then shows every fold there is
#: Sizes from the ends of a rod: nearer, a section in the tangent plane stands out of a curved face by its nature.
_CLEAR = 1.0


def mend(
    raw: Wireframe,
    parameters: WireframeParameters,
    region: Region,
    contains: Optional[Contains],
    progress: Progress = silent,
) -> Wireframe:
    """Return the wireframe with its faulty rods mended, the recoveries listed, the hopeless left out and named.

    Parameters
    ----------
    raw : Wireframe
    parameters : WireframeParameters
    region : Region
    contains : callable or None
        ``contains(points (P, 3)) -> (P,) bool`` of the envelope.
    progress : callable
    """
    faults = find_faults(raw, parameters, contains)
    bad = np.nonzero(faults > 0)[0]
    if not len(bad):
        return raw
    work = _Work(raw, parameters, region, contains)
    recoveries: List[Recovery] = []
    for name in FAULTS:
        group = bad[faults[bad] == 1 + FAULTS.index(name)]
        if len(group):
            start, end = len(recoveries) / len(bad), (len(recoveries) + len(group)) / len(bad)
            recoveries += work.mend_group(group, name, part(progress, start, end))
    still = find_faults(work.wireframe, parameters, contains)
    out = np.nonzero(still == 1 + FAULTS.index("outside"))[0]
    hopeless = (still > 0) & (still != 1 + FAULTS.index("outside"))
    names = np.array(raw.names, dtype=object)
    result = without(work.wireframe, ~hopeless)
    return replace(result, recoveries=tuple(recoveries), failed=tuple(names[hopeless]), outside=tuple(names[out]))


def find_faults(wireframe: Wireframe, parameters: WireframeParameters, contains: Optional[Contains]) -> np.ndarray:
    """Return the first fault of each rod, ndarray (R,) int: 0 none, else 1 + its place in ``FAULTS``."""
    rods = build_rods(wireframe.paths, wireframe.ends, _STATIONS, _POINTS)
    found = np.zeros(len(wireframe), int)
    kinds = rod_faults(rods)
    if contains is not None:
        kinds["outside"] = outside_counts(rods, wireframe, contains) > 0
    for k in reversed(range(len(FAULTS))):
        if FAULTS[k] in kinds:
            found[kinds[FAULTS[k]]] = k + 1
    return found


def outside_counts(rods: Rods, wireframe: Wireframe, contains: Contains) -> np.ndarray:
    """Return how many ring points of each rod's inner part lie outside the envelope, ndarray (R,) int."""
    if not len(rods):
        return np.zeros(0, int)
    size = np.maximum(wireframe.ends.first.size, wireframe.ends.second.size)
    along = rods.stations.lengths[:, None] * rods.stations.shares
    inner = (along > _CLEAR * size[:, None]) & (along < (rods.stations.lengths - _CLEAR * size)[:, None])
    points = rods.rings[inner]
    counts = np.zeros(inner.shape, int)
    counts[inner] = (~contains(points.reshape(-1, 3))).reshape(points.shape[:2]).sum(1)
    return counts.sum(1)


def _is_faulty(wireframe: Wireframe, close: bool) -> np.ndarray:
    if not close:
        rods = build_rods(wireframe.paths, wireframe.ends, _STATIONS, _POINTS)
        return np.any(list(rod_faults(rods).values()), 0)
    rods = build_rods(wireframe.paths, wireframe.ends, _CLOSE_STATIONS, _POINTS, to_bends=True)
    return np.any(list(rod_faults(rods).values()), 0) | (sharpest_bends(rods) > _SHARP)


class _Work:
    """The wireframe under repair."""

    def __init__(
        self, raw: Wireframe, parameters: WireframeParameters, region: Region, contains: Optional[Contains]
    ) -> None:
        self.wireframe, self.parameters, self.region, self.contains = raw, parameters, region, contains
        couplings = parameters.couplings
        chord = np.linalg.norm(raw.paths[:, 1, 3] - raw.paths[:, 0, 0], axis=1)
        along = (
            np.einsum("rx,rex->re", raw.paths[:, 1, 3] - raw.paths[:, 0, 0], raw.ends.frames[:, :, 2])
            / np.maximum(chord, 1e-9)[:, None]
        )
        #: Between opposite faces a tension beyond the chord makes loops; a path that turns back needs twice the chord
        #: (a half circle's Hermite tangents), one that turns at both ends thrice.
        self._most_tension = chord * (2 - along.sum(1) / 2)
        self.paths_of = [couplings[k].path or parameters.path for k in raw.coupling.tolist()]

    def mend_group(self, group: np.ndarray, fault: str, progress: Progress = silent) -> List[Recovery]:
        """Try the remedies for one fault on rods ``group`` (indices), all at once; return one Recovery a rod."""
        rods = group.tolist()
        attempts, remedy = dict.fromkeys(rods, 0), dict.fromkeys(rods, "none")
        best = dict(zip(rods, self._badness(without(self.wireframe, group), False).tolist()))
        for name in REMEDIES[fault]:
            close = name in ("tension", "carry")
            for first in range(1, self._steps(name, rods) + 1, _BLOCK):
                progress(sum(badness == 0 for badness in best.values()), len(rods), f"mending: {fault}, {name}")
                steps = range(first, first + _BLOCK)
                left = [(k, step) for k in rods if best[k] > 0 for step in steps if self._applies(name, k, step)]
                if not left:
                    break
                which, at_step = np.array(left, int).T
                trial = self._apply(name, which, at_step)
                for at, (k, badness) in enumerate(zip(which.tolist(), self._badness(trial, close).tolist())):
                    attempts[k] += best[k] > 0  # those of the block that come after the first success do not count
                    if badness < best[k]:
                        best[k], remedy[k] = badness, name
                        self._keep(trial, at, k)
        names = self.wireframe.names
        return [Recovery(names[k], fault, remedy[k], attempts[k]) for k in rods]

    def _steps(self, remedy: str, rods: List[int]) -> int:
        if remedy not in ("tension", "carry"):
            return self.parameters.rods.redraws
        return int(np.ceil(self._most_tension[rods].max() / TENSION_STEP))

    def _applies(self, remedy: str, rod: int, step: int) -> bool:
        path = self.paths_of[rod]
        if remedy == "middle":
            return PATH_LAWS[path.kind].redraws(path)
        if remedy == "tangents":
            return self.parameters.pores.layout == "spline"
        return PATH_LAWS[path.kind].is_curved and step * TENSION_STEP <= self._most_tension[rod]

    def _badness(self, trial: Wireframe, close: bool) -> np.ndarray:
        """Return 0 for a sound rod; else the points outside, or a large number for a fault of the rod itself."""
        badness = np.where(_is_faulty(trial, False), _FAULTY, 0)
        sound = np.nonzero(badness == 0)[0]
        if close and len(sound):
            sharp = _is_faulty(without(trial, sound), True)
            badness[sound[sharp]] = _FAULTY
            sound = sound[~sharp]
        if self.contains is not None and len(sound):
            some = without(trial, sound)
            badness[sound] = outside_counts(build_rods(some.paths, some.ends, _STATIONS, _POINTS), some, self.contains)
        return badness

    def _apply(self, remedy: str, which: np.ndarray, steps: np.ndarray) -> Wireframe:
        some = without(self.wireframe, which)
        ends = some.ends
        p0, p1 = some.paths[:, 0, 0], some.paths[:, 1, 3]
        if remedy in ("tension", "carry"):
            leaning = np.full(len(which), CARRIED) if remedy == "carry" else ends.leans
            tension = steps * TENSION_STEP
            paths = tension_paths(p0, ends.frames[:, 0, 2], p1, ends.frames[:, 1, 2], tension, tension)
            return replace(some, paths=paths, ends=replace(ends, leans=leaning))
        if remedy == "middle":
            paths = some.paths.copy()
            for at, (k, step) in enumerate(zip(which.tolist(), steps.tolist())):
                one = slice(at, at + 1)
                between = PathEnds(some.names[one], p0[one], ends.frames[one, 0, 2], p1[one], ends.frames[one, 1, 2])
                paths[at] = draw_paths(self.paths_of[k], between, self.region, self.parameters.seed, step)[0]
            return replace(some, paths=paths)
        return replace(some, ends=self._redrawn_ends(some, steps))

    def _redrawn_ends(self, some: Wireframe, steps: np.ndarray) -> RodEnds:
        """New tangents for both end sections (sizes stay)."""
        first: List[Pores] = []
        second: List[Pores] = []
        for at in range(len(some)):
            coupling = self.parameters.couplings[some.coupling[at]]
            for end, (face, column) in enumerate(((coupling.first, first), (coupling.second, second))):
                sites = some.sites[face]
                one = int(some.site_numbers[at, end])
                column.append(self._redraw(sites, one, int(steps[at])))
        ends = some.ends
        return replace(
            ends,
            first=_with_shape(ends.first, [mirrored(p) for p in first]),
            second=_with_shape(ends.second, second),
        )

    def _redraw(self, sites: Sites, number: int, step: int) -> Pores:
        one = replace(
            sites, **{n: getattr(sites, n)[number : number + 1] for n in ("index", "points", "u", "normals", "on")}
        )
        return draw_pores(self.parameters.pores, self.parameters.seed, one, self.region, step)

    def _keep(self, trial: Wireframe, at: int, rod: int) -> None:
        whole = self.wireframe
        paths = whole.paths.copy()
        paths[rod] = trial.paths[at]
        ends = whole.ends
        leans = ends.leans.copy()
        leans[rod] = trial.ends.leans[at]
        columns: Dict[str, Any] = {"leans": leans}
        for name in ("first", "second"):
            old, new = getattr(ends, name), getattr(trial.ends, name)
            arrays = {n: getattr(old, n).copy() for n in Pores.__dataclass_fields__}
            for n, array in arrays.items():
                array[rod] = getattr(new, n)[at]
            columns[name] = Pores(**arrays)
        self.wireframe = replace(whole, paths=paths, ends=replace(ends, **columns))


def _with_shape(old: Pores, new: List[Pores]) -> Pores:
    """Return pores of the old sizes with the new shapes."""
    return Pores(old.size, *(np.concatenate([getattr(p, n) for p in new]) for n in ("corners", "angles", "lengths")))
