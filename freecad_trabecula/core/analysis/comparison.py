# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two or more analyses on shared axes (thesis 5.4): resampled profiles, differences, tables 5.11 to 5.13.

Samples differ in length, in layers and in where they lie. Along each axis that all have, they are laid side by side
(by default from their low ends, as the thesis compares cubes of 10.356 and 10 mm), and cut into common layers over the
stretch that all cover. A profile is taken as a step function, one value over the slab of each slice; the value of a
common layer is the mean of that function over the layer, so that area times thickness, the volume, is kept exactly.
Counts are means over the layer too; porosity is made of the areas. Where the layers agree anyway the values are passed
on untouched.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ...errors import ParameterError

if TYPE_CHECKING:
    from .analysis import Analysis

ALIGNMENTS = ("start", "centre", "own")
#: What is resampled of a profile: attribute of a profile, words, unit.
QUANTITIES = (
    ("sliced_area", "sliced area", "mm2"),
    ("porosity", "porosity", "1"),
    ("contours", "contours", "1"),
    ("outer_contours", "outer contours", "1"),
    ("largest_area", "largest trabecular area", "mm2"),
)
_SAME = 1e-6  # of a layer: edges nearer to each other than this are one edge


class Totals(NamedTuple):
    """What tables 5.2 to 5.13 give of one sample along one axis; ranges as (low, high), nan where there is nothing.

    Rods and plates are all contours by the thesis' rule, by which voids, whose area is negative, are plates; trabecular
    areas are signed (Eq. 5.1), so that a negative low end is the largest void. All slices of the sample count, also
    those that the others do not reach; contours of no more than the least area do not.
    """

    rods: int
    plates: int
    trabecular_area: Tuple[float, float]
    sliced_area: Tuple[float, float]
    porosity: Tuple[float, float]


class Difference(NamedTuple):
    """How the profile of one sample differs from the first sample's, along one axis.

    Attributes
    ----------
    values : ndarray of shape (B,)
        Sample less first sample, layer by layer.
    mean, largest : float
        Mean of the values; the value of the largest size, with its sign.
    at : float, mm
        Middle of the layer of the largest.
    middle : float
        The value half way along the shared stretch (thesis 5.4 gives it at 5 mm): linear between layer middles.
    equal_layers : int
        Layers with exactly equal values.
    meetings : int
        Where the two curves meet: equal layers, and pairs of neighbouring layers between which the curves cross. This
        is how the thesis counts its "sections with the same value" (5.4.2: the curves never intersect, "as a
        consequence" no section is the same).
    """

    values: np.ndarray
    mean: float
    largest: float
    at: float
    middle: float
    equal_layers: int
    meetings: int


@dataclass(frozen=True)
class SharedAxis:
    """K samples along one axis, in B common layers.

    Attributes
    ----------
    axis : str
    edges : ndarray of shape (B + 1,), mm
        Borders of the layers, from each sample's origin.
    origins : tuple of K floats, mm
        Where the origin lies in each sample's own co-ordinates.
    left_out : tuple of K pairs of floats, mm
        How much of each sample lies below and above the shared layers.
    resampled : tuple of K bools
        False where a sample's own layers are the shared ones: its values are untouched.
    values : dict of name to ndarray of shape (K, B)
        The names of ``QUANTITIES``. Counts are means too, where a layer is resampled.
    totals : tuple of K ``Totals``
    """

    axis: str
    edges: np.ndarray
    origins: Tuple[float, ...]
    left_out: Tuple[Tuple[float, float], ...]
    resampled: Tuple[bool, ...]
    values: Dict[str, np.ndarray]
    totals: Tuple[Totals, ...]

    @property
    def middles(self) -> np.ndarray:
        """Middles (B,) of the layers, mm from the origin."""
        return (self.edges[1:] + self.edges[:-1]) / 2

    @property
    def thickness(self) -> float:
        """Thickness of the layers, mm."""
        return float(self.edges[1] - self.edges[0])

    def difference(self, quantity: str, sample: int = 1) -> Difference:
        """Return how a sample's profile differs from the first's.

        Raises
        ------
        ParameterError
            If there is no such quantity or sample.
        """
        if quantity not in self.values:
            raise ParameterError(f"a quantity must be one of {', '.join(self.values)}, got {quantity!r}")
        if not 0 <= sample < len(self.totals):
            raise ParameterError(f"a sample must be numbered 0 to {len(self.totals) - 1}, got {sample}")
        first, other = self.values[quantity][0], self.values[quantity][sample]
        values = other - first
        largest = int(np.argmax(np.abs(np.nan_to_num(values))))
        return Difference(
            values=values,
            mean=float(np.mean(values[np.isfinite(values)])) if np.isfinite(values).any() else float("nan"),
            largest=float(values[largest]),
            at=float(self.middles[largest]),
            middle=float(np.interp((self.edges[0] + self.edges[-1]) / 2, self.middles, values)),
            equal_layers=int(np.count_nonzero(values == 0)),
            meetings=meetings(values),
        )


@dataclass(frozen=True)
class Comparison:
    """Two or more analyses side by side.

    Attributes
    ----------
    names : tuple of K strings
        The first is the reference of the differences.
    axes : dict of axis to SharedAxis
    alignment : str
        Where the origins lie: "start" (low end of the box), "centre" (its middle), "own" (the sample's own zero).
    notes : tuple of strings
        What was resampled and left out, in words.
    """

    names: Tuple[str, ...]
    axes: Dict[str, SharedAxis]
    alignment: str
    notes: Tuple[str, ...]

    def table(self) -> Tuple[List[str], List[List[str]]]:
        """Return head and rows of tables 5.11 to 5.13: for each axis a column for each sample, in the thesis' order."""
        columns = [(axis, k) for axis in self.axes for k in range(len(self.names))]
        totals = [self.axes[axis].totals[k] for axis, k in columns]
        head = ["", *(f"{axis.upper()} {self.names[k]}" for axis, k in columns)]
        rows = [
            ["Total number of rods", *(str(t.rods) for t in totals)],
            ["Total number of plates", *(str(t.plates) for t in totals)],
            ["Trabecular area range (mm2)", *(range_text(t.trabecular_area) for t in totals)],
            ["Sliced area (mm2)", *(range_text(t.sliced_area) for t in totals)],
        ]
        return head, rows


def compare(analyses: Sequence[Analysis], thickness: Optional[float] = None, alignment: str = "start") -> Comparison:
    """Lay analyses side by side on the axes that all have.

    Parameters
    ----------
    analyses : sequence of Analysis
        Two or more; the first is the reference.
    thickness : float, mm, optional
        Of the common layers; by default the largest of the samples' own, along each axis.
    alignment : str
        One of ``ALIGNMENTS``.

    Raises
    ------
    ParameterError
        If there are fewer than two analyses, none of their axes is common to all, or they share no whole layer.
    """
    if len(analyses) < 2:
        raise ParameterError(f"a comparison needs at least two analyses, got {len(analyses)}")
    if alignment not in ALIGNMENTS:
        raise ParameterError(f"alignment must be one of {', '.join(ALIGNMENTS)}, got {alignment!r}")
    if thickness is not None and not (np.isfinite(thickness) and thickness > 0):
        raise ParameterError(f"the thickness of common layers must be > 0, got {thickness} mm")
    common = [axis for axis in analyses[0].profiles if all(axis in a.profiles for a in analyses)]
    if not common:
        listed = "; ".join(f"{a.name}: {', '.join(a.profiles) or 'none'}" for a in analyses)
        raise ParameterError(f"analyses to be compared must have an axis in common, got {listed}")
    axes = {axis: _shared_axis(axis, analyses, thickness, alignment) for axis in common}
    names = tuple(a.name for a in analyses)
    return Comparison(names, axes, alignment, _notes(names, axes, analyses, alignment))


def slab_edges(coordinates: np.ndarray, thickness: float, at: str) -> np.ndarray:
    """Return the borders (S + 1,), mm, of the slabs that slices stand for.

    Slices at layer middles and bottoms stand for their layers; slices at given heights reach half way to the next, and
    half a thickness beyond the first and the last.
    """
    coordinates = np.asarray(coordinates, float)
    if at == "heights":
        between = (coordinates[1:] + coordinates[:-1]) / 2
        return np.concatenate([[coordinates[0] - thickness / 2], between, [coordinates[-1] + thickness / 2]])
    below = 0.0 if at == "bottom" else thickness / 2
    return np.append(coordinates - below, coordinates[-1] - below + thickness)


def resampled(edges: np.ndarray, values: np.ndarray, onto: np.ndarray) -> np.ndarray:
    """Return the means of a step function over new layers: the integral over any of them is kept exactly.

    Parameters
    ----------
    edges : ndarray of shape (S + 1,), mm
        Borders of the steps.
    values : ndarray of shape (S,)
    onto : ndarray of shape (B + 1,), mm
        Borders of the new layers, inside the old ones.
    """
    total = np.concatenate([[0.0], np.cumsum(values * np.diff(edges))])
    return np.diff(np.interp(onto, edges, total)) / np.diff(onto)


def meetings(difference: np.ndarray) -> int:
    """Return how often two curves meet, given their difference (B,): zeros, and changes of sign between neighbours."""
    sign = np.sign(np.nan_to_num(difference))
    return int(np.count_nonzero(sign == 0) + np.count_nonzero(sign[1:] * sign[:-1] < 0))


def range_text(limits: Tuple[float, float]) -> str:
    """Return a range as the thesis writes it, "10.1 to 25.08"; a dash where there is nothing."""
    return f"{limits[0]:.4g} to {limits[1]:.4g}" if np.isfinite(limits).all() else "-"


def _limits(values: np.ndarray) -> Tuple[float, float]:
    values = np.asarray(values, float)
    values = values[np.isfinite(values)]
    return (float(values.min()), float(values.max())) if len(values) else (float("nan"), float("nan"))


def totals_of(analysis: Analysis, axis: str) -> Totals:
    """Return the totals and ranges of one analysis along one axis."""
    profile, measures = analysis.profiles[axis], analysis.measures[axis]
    counted = np.abs(measures.area) > analysis.parameters.least_area
    rods = int(np.count_nonzero(counted & measures.is_rod))
    return Totals(
        rods=rods,
        plates=int(np.count_nonzero(counted)) - rods,
        trabecular_area=_limits(measures.area[counted]),
        sliced_area=_limits(profile.sliced_area),
        porosity=_limits(profile.porosity),
    )


def largest_areas(analysis: Analysis, axis: str) -> np.ndarray:
    """Return the area (S,), mm², of the largest contour of each slice; 0 where there is none."""
    measures = analysis.measures[axis]
    largest = np.zeros(len(analysis.profiles[axis].coordinate))
    np.maximum.at(largest, measures.plane, measures.area)
    return largest


def _origin(analysis: Analysis, axis: str, edges: np.ndarray, alignment: str) -> float:
    if alignment == "own":
        return 0.0
    low, high = edges[0], edges[-1]
    if axis in ("x", "y", "z"):  # the box knows the low end, also where only a range was sliced
        low, high = np.asarray(analysis.box, float)[:, "xyz".index(axis)]
    return float(low if alignment == "start" else (low + high) / 2)


def _shared_axis(axis: str, analyses: Sequence[Analysis], thickness: Optional[float], alignment: str) -> SharedAxis:
    own, origins = [], []
    for analysis in analyses:
        profile = analysis.profiles[axis]
        if not len(profile.coordinate):
            raise ParameterError(f"a profile to be compared must have slices, {analysis.name} has none along {axis}")
        edges = slab_edges(profile.coordinate, profile.thickness, analysis.parameters.at)
        origins.append(_origin(analysis, axis, edges, alignment))
        own.append(edges - origins[-1])
    layer = max(a.profiles[axis].thickness for a in analyses) if thickness is None else thickness
    edges = _common_edges(axis, [a.name for a in analyses], own, layer)
    columns = [_on_layers(analysis, axis, mine, edges, layer) for analysis, mine in zip(analyses, own)]
    return SharedAxis(
        axis=axis,
        edges=edges,
        origins=tuple(origins),
        left_out=tuple((float(edges[0] - mine[0]), float(mine[-1] - edges[-1])) for mine in own),
        resampled=tuple(was for _, was in columns),
        values={name: np.stack([values[name] for values, _ in columns]) for name, _, _ in QUANTITIES},
        totals=tuple(totals_of(analysis, axis) for analysis in analyses),
    )


def _common_edges(axis: str, names: Sequence[str], own: Sequence[np.ndarray], layer: float) -> np.ndarray:
    """Borders of whole layers over the stretch that all samples cover, laid from its low end."""
    low, high = max(edges[0] for edges in own), min(edges[-1] for edges in own)
    count = int(np.floor((high - low) / layer + _SAME))
    if count < 1:
        listed = "; ".join(f"{name}: {edges[0]:.6g} to {edges[-1]:.6g} mm" for name, edges in zip(names, own))
        raise ParameterError(
            f"analyses to be compared must share at least one layer of {layer:g} mm along {axis}, got {listed}"
        )
    return np.minimum(low + layer * np.arange(count + 1), high)


def _on_layers(
    analysis: Analysis, axis: str, own: np.ndarray, edges: np.ndarray, layer: float
) -> Tuple[Dict[str, np.ndarray], bool]:
    """All quantities of one sample on the common layers, and whether they had to be resampled."""
    profile = analysis.profiles[axis]
    start = int(np.argmin(np.abs(own - edges[0])))
    mine = own[start : start + len(edges)]
    is_same = len(mine) == len(edges) and np.abs(mine - edges).max() <= _SAME * layer
    columns = {name: np.asarray(getattr(profile, name, ()), float) for name, _, _ in QUANTITIES}
    columns["largest_area"] = largest_areas(analysis, axis)
    if is_same:
        return {name: column[start : start + len(edges) - 1] for name, column in columns.items()}, False
    values = {name: resampled(own, column, edges) for name, column in columns.items() if name != "porosity"}
    envelope = resampled(own, profile.envelope_area, edges)
    with np.errstate(divide="ignore", invalid="ignore"):
        values["porosity"] = np.where(envelope > 0, 1 - values["sliced_area"] / envelope, np.nan)
    return values, True


def _notes(
    names: Sequence[str], axes: Dict[str, SharedAxis], analyses: Sequence[Analysis], alignment: str
) -> Tuple[str, ...]:
    place = {"start": "the low ends of their boxes", "centre": "the middles of their boxes", "own": "their own zeros"}
    notes = [f"Samples are laid side by side by {place[alignment]}; differences are against {names[0]}."]
    for axis, shared in axes.items():
        notes.append(
            f"{axis}: {len(shared.edges) - 1} layers of {shared.thickness:.6g} mm, "
            f"{shared.edges[0]:.6g} to {shared.edges[-1]:.6g} mm."
        )
        for k, name in enumerate(names):
            if shared.resampled[k]:
                own = analyses[k].profiles[axis].thickness
                notes.append(f"{axis}: {name} is resampled by area from layers of {own:.6g} mm.")
            below, above = shared.left_out[k]
            if max(below, above) > _SAME * shared.thickness:
                notes.append(f"{axis}: {name} reaches {max(below, 0):.4g} mm below and {max(above, 0):.4g} mm above.")
    return tuple(notes)
