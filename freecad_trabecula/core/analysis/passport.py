# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slice passport: how near one sample is to another, in scores that are each defined here.

The first sample is the reference (the bone), the second is held against it. Distances are 0 and correlations 1 for
identical analyses, exactly: every score is computed by operations that leave no rounding behind when both sides are
equal.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from .comparison import QUANTITIES, Comparison, SharedAxis, compare

if TYPE_CHECKING:
    from .analysis import Analysis

#: Bins of area per decade for the Hellinger distance; borders at whole powers of 10^(1/5) mm² for every sample.
BINS_PER_DECADE = 5
_PROFILES = tuple(entry for entry in QUANTITIES if entry[0] != "largest_area")

#: Definition of each score by its symbol; a and b are the first and the second sample.
DEFINITIONS: Dict[str, str] = {
    "L1": "relative L1 distance of the profiles: sum |b - a| / sum |a| over the shared layers; 0 = equal",
    "L2": "relative L2 distance of the profiles: sqrt(sum (b - a)^2 / sum a^2) over the shared layers; 0 = equal",
    "r": "Pearson's correlation of the profiles over the shared layers; 1 = same shape; none if a profile is constant",
    "dmean": "mean of b less mean of a over the shared layers",
    "dlow": "smallest value of b less smallest of a over the shared layers",
    "dhigh": "largest value of b less largest of a over the shared layers",
    "KS": "Kolmogorov-Smirnov distance of the distributions of trabecular area (net of holes, each trabecula of each "
    "slice once): largest difference of the two shares of trabeculae up to an area; not binned; 0 = equal, 1 = apart",
    "H": "Hellinger distance of the distributions of trabecular area over logarithmic bins, five per decade with "
    "borders at 10^(k/5) mm2: sqrt(sum (sqrt p - sqrt q)^2 / 2); 0 = equal, 1 = no bin shared",
    "dmean area": "mean trabecular area of b less that of a",
    "drods": "share of contours that are rods (thesis' rule), b less a",
    "ratio": "value of b over value of a, less 1; 0 = equal",
}


class Score(NamedTuple):
    """One number of a passport.

    Attributes
    ----------
    of : str
        What is scored: "sliced area", "trabecular area", "Tb.Th" ...
    symbol : str
        A key of ``DEFINITIONS``.
    value : float
        nan where the score is not defined for these samples.
    unit : str
        "1" for numbers without one.
    """

    of: str
    symbol: str
    value: float
    unit: str

    @property
    def definition(self) -> str:
        """What the score is, in words."""
        return DEFINITIONS[self.symbol]


@dataclass(frozen=True)
class Passport:
    """The scores of one comparison of two samples.

    Attributes
    ----------
    names : tuple of two strings
        Reference, and what is held against it.
    axes : dict of axis to tuple of ``Score``
    whole : tuple of ``Score``
        Means of the axes' L1, L2 and r; KS and H over the trabeculae of all axes; morphometry where both have it.
    comparison : Comparison
        The shared axes on which the scores were computed.
    """

    names: Tuple[str, str]
    axes: Dict[str, Tuple[Score, ...]]
    whole: Tuple[Score, ...]
    comparison: Comparison

    def rows(self) -> List[Tuple[str, str, str, float, str]]:
        """Return all scores as (axis or "whole", of, symbol, value, unit), axis by axis and the whole last."""
        parts = [*self.axes.items(), ("whole", self.whole)]
        return [(where, *score) for where, scores in parts for score in scores]


def passport(
    first: Analysis, second: Analysis, thickness: Optional[float] = None, alignment: str = "start"
) -> Passport:
    """Score one analysis against another.

    Parameters
    ----------
    first, second : Analysis
        The reference, and what is held against it.
    thickness : float, mm, optional
        Of the common layers, as in ``comparison.compare``.
    alignment : str
        As in ``comparison.compare``.

    Raises
    ------
    ParameterError
        If the two have nothing in common, as ``comparison.compare``.
    """
    comparison = compare([first, second], thickness, alignment)
    axes = {axis: _axis_scores(shared, first, second) for axis, shared in comparison.axes.items()}
    areas = [
        np.concatenate([trabecular_areas(analysis, axis) for axis in comparison.axes]) for analysis in (first, second)
    ]
    whole = [*_means(axes), *_distribution_scores(*areas), *_morphometry_scores(first, second)]
    return Passport((first.name, second.name), axes, tuple(whole), comparison)


def profile_distance(first: np.ndarray, second: np.ndarray, order: int) -> float:
    """Return the relative L1 or L2 distance (``order`` 1 or 2) of two profiles (B,); nan if only the first is all 0."""
    if not len(first):
        return float("nan")
    size = float((np.abs(first) ** order).sum())
    apart = float((np.abs(second - first) ** order).sum())
    if apart == 0:
        return 0.0
    return (apart / size) ** (1 / order) if size > 0 else float("nan")


def correlation(first: np.ndarray, second: np.ndarray) -> float:
    """Return Pearson's correlation of two profiles (B,); 1 if they are equal, else nan if one of them is constant."""
    if np.array_equal(first, second):
        return 1.0 if len(first) else float("nan")
    if np.ptp(first) == 0 or np.ptp(second) == 0:
        return float("nan")
    a, b = first - first.mean(), second - second.mean()
    return float((a * b).sum() / np.sqrt((a * a).sum() * (b * b).sum()))


def kolmogorov_smirnov(first: np.ndarray, second: np.ndarray) -> float:
    """Return the largest difference of two empirical distributions of areas (A,) and (B,); nan if one is empty."""
    if not len(first) or not len(second):
        return 0.0 if len(first) == len(second) else float("nan")
    at = np.concatenate([first, second])
    shares = [np.searchsorted(np.sort(areas), at, side="right") / len(areas) for areas in (first, second)]
    return float(np.abs(shares[0] - shares[1]).max())


def hellinger(first: np.ndarray, second: np.ndarray) -> float:
    """Return the Hellinger distance of two distributions of areas (A,) and (B,), mm², over logarithmic bins.

    Source: Hellinger, J. reine angew. Math. 136 (1909) 210, DOI 10.1515/crll.1909.136.210.
    """
    if not len(first) or not len(second):
        return 0.0 if len(first) == len(second) else float("nan")
    bins = [np.floor(np.log10(areas) * BINS_PER_DECADE).astype(np.int64) for areas in (first, second)]
    lowest = min(b.min() for b in bins)
    count = max(b.max() for b in bins) - lowest + 1
    p, q = (np.bincount(b - lowest, minlength=count) / len(b) for b in bins)
    return float(np.sqrt(((np.sqrt(p) - np.sqrt(q)) ** 2).sum() / 2))


def trabecular_areas(analysis: Analysis, axis: str) -> np.ndarray:
    """Return the areas, mm², of all trabeculae along one axis: outer contours, net of their holes."""
    areas = np.asarray(analysis.measures[axis].net_area, float)
    return areas[areas > analysis.parameters.least_area]  # not where nan: a hole


def _axis_scores(shared: SharedAxis, first: Analysis, second: Analysis) -> Tuple[Score, ...]:
    scores = []
    for name, words, unit in _PROFILES:
        a, b = shared.values[name]
        both = np.isfinite(a) & np.isfinite(b)  # porosity is none where the envelope is not
        a, b = a[both], b[both]
        scores += [
            Score(words, "L1", profile_distance(a, b, 1), "1"),
            Score(words, "L2", profile_distance(a, b, 2), "1"),
            Score(words, "r", correlation(a, b), "1"),
            *(Score(words, symbol, _apart(a, b, of), unit) for symbol, of in _STATISTICS),
        ]
    areas = [trabecular_areas(analysis, shared.axis) for analysis in (first, second)]
    a, b = (t.rods / max(t.rods + t.plates, 1) for t in shared.totals)
    return (*scores, *_distribution_scores(*areas), Score("contours", "drods", b - a, "1"))


_STATISTICS = (("dmean", np.mean), ("dlow", np.min), ("dhigh", np.max))


def _apart(first: np.ndarray, second: np.ndarray, of: Callable[[np.ndarray], float]) -> float:
    return float(of(second) - of(first)) if len(first) else float("nan")


def _distribution_scores(first: np.ndarray, second: np.ndarray) -> Tuple[Score, ...]:
    means = [float(areas.mean()) if len(areas) else float("nan") for areas in (first, second)]
    return (
        Score("trabecular area", "KS", kolmogorov_smirnov(first, second), "1"),
        Score("trabecular area", "H", hellinger(first, second), "1"),
        Score("trabecular area", "dmean area", means[1] - means[0], "mm2"),
    )


def _means(axes: Dict[str, Tuple[Score, ...]]) -> List[Score]:
    """Means over the axes of each profile's L1, L2 and r; nan where an axis has none."""
    scores = []
    for _, words, _ in _PROFILES:
        for symbol in ("L1", "L2", "r"):
            values = [s.value for of_axis in axes.values() for s in of_axis if (s.of, s.symbol) == (words, symbol)]
            scores.append(Score(words, symbol, float(np.mean(values)), "1"))
    return scores


def _morphometry_scores(first: Analysis, second: Analysis) -> List[Score]:
    """Ratio of every measure that both have."""
    if first.morphometry is None or second.morphometry is None:
        return []
    a = {m.symbol: m.value for m in first.morphometry.measures}
    b = {m.symbol: m.value for m in second.morphometry.measures}
    return [Score(symbol, "ratio", _ratio(a[symbol], b[symbol]), "1") for symbol in a if symbol in b]


def _ratio(first: float, second: float) -> float:
    if first == second:
        return 0.0
    return second / first - 1 if first else float("nan")
