# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours of slices: what each measures, what lies in what, which is a rod and which a plate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Iterator, Sequence, Tuple

import numpy as np

from ...errors import ContourError
from ..progress import Progress, silent
from .nesting import Polygons, contour_parents
from .parameters import SliceParameters

_POINTS = 50_000  # worked on at once: temporary arrays stay in the processor's cache


@dataclass(frozen=True)
class Contours:
    """All contours along one axis, in the order of the planes.

    Attributes
    ----------
    axis : str
        ``x``, ``y``, ``z`` or ``0.6,0.8,0``.
    heights : ndarray of shape (S,), mm
        Co-ordinate of each plane along the axis.
    points : ndarray of shape (N, 2), float64, mm
        In-plane co-ordinates: axis x -> (y, z), y -> (z, x), z -> (x, y); others as in ``parameters.axis_frame``.
    starts : ndarray of shape (C + 1,), int
        Contour c is ``points[starts[c]:starts[c + 1]]``; its first point is not repeated.
    plane : ndarray of shape (C,), int
        Number of each contour's plane, ascending.
    closed : ndarray of shape (C,), bool
        False: an open chain, which counts for nothing.

    Raises
    ------
    ContourError
        If the arrays do not fit together.
    """

    axis: str
    heights: np.ndarray
    points: np.ndarray
    starts: np.ndarray
    plane: np.ndarray
    closed: np.ndarray

    def __post_init__(self) -> None:
        count, starts = len(self.plane), self.starts
        if len(starts) != count + 1 or len(self.closed) != count or self.points.shape != (starts[-1], 2):
            raise ContourError(
                f"contours must have one start more than planes, and as many points as the last start says, got "
                f"{len(starts)} starts, {count} planes, {len(self.closed)} marks, points {self.points.shape}"
            )
        if count and not ((self.plane[1:] >= self.plane[:-1]).all() and self.plane[0] >= 0
                          and self.plane[-1] < len(self.heights)):  # fmt: skip
            raise ContourError(f"contours must lie in the order of their planes, 0..{len(self.heights) - 1}")

    def __len__(self) -> int:
        return len(self.plane)

    def of_plane(self, plane: int) -> Iterator[np.ndarray]:
        """Yield the points (K, 2) of each contour of one plane."""
        for c in range(*np.searchsorted(self.plane, [plane, plane + 1])):
            yield self.points[self.starts[c] : self.starts[c + 1]]

    def replaced(self, keep: np.ndarray, planes: Sequence[int], polylines: Sequence[np.ndarray],
                 closed: bool = True) -> Contours:  # fmt: skip
        """Return the contours marked in ``keep`` (C,) and new ones: a plane and points (K, 2) each."""
        sizes = np.diff(self.starts)
        points = np.concatenate([self.points[np.repeat(keep, sizes)], *polylines])
        plane = np.append(self.plane[keep], np.array(planes, self.plane.dtype))
        sizes = np.append(sizes[keep], np.array([len(polyline) for polyline in polylines], sizes.dtype))
        order = np.argsort(plane, kind="stable")
        old, sizes = np.append(0, np.cumsum(sizes))[:-1][order], sizes[order]
        starts = np.append(0, np.cumsum(sizes))
        source = np.arange(starts[-1]) + np.repeat(old - starts[:-1], sizes)
        marks = np.append(self.closed[keep], np.full(len(planes), closed))[order]
        moved = np.ascontiguousarray(points[source].T).T
        return Contours(self.axis, self.heights, moved, starts, plane[order], marks)

    def next_points(self) -> np.ndarray:
        """Number (N,) of the point after each, round its contour."""
        after = np.arange(1, len(self.points) + 1)
        after[self.starts[1:] - 1] = self.starts[:-1]
        return after

    def lengths(self) -> np.ndarray:
        """Length (C,), mm: of open chains without a line from end to start."""
        if not len(self):
            return np.zeros(0)
        steps = np.sqrt(((self.points[self.next_points()] - self.points) ** 2).sum(1))
        steps[self.starts[1:][~self.closed] - 1] = 0.0
        return np.add.reduceat(steps, self.starts[:-1])


@dataclass(frozen=True)
class ContourMeasures:
    """One row for each contour (C,); open chains have the area 0 and nan in everything else but plane and parent.

    Attributes
    ----------
    plane : ndarray of int
    area : ndarray, mm²
        Eq. 5.1: positive round material, negative round voids.
    net_area : ndarray, mm²
        Area of a trabecula: of an outer contour less its own holes; nan for holes.
    perimeter, width, height : ndarray, mm
        Width and height are those of the box along the in-plane axes.
    centroid : ndarray (C, 2), mm
    moments : ndarray (C, 3), mm⁴
        Second moments of area about the centroid: of u u, u v and v v.
    ratio : ndarray
        Area (without sign) over area of the box.
    is_rod : ndarray of bool
        Outer and ratio >= ``rod_ratio``: thesis 5.2.3.1. It changes when the part is turned about the axis.
    circularity : ndarray
        A² / (2 pi (moment of u u + of v v)): 1 for a disc, 3/pi = 0.955 for a square, 2 k / (1 + k²) for an ellipse of
        aspect k, small for strips, rings' arcs and stars; it does not change when the part is turned (first invariant
        of Hu 1962, doi:10.1109/TIT.1962.1057692; as a measure of shape Zunic, Hirota, Rosin 2010,
        doi:10.1016/j.patcog.2009.06.017).
    is_rod_invariant : ndarray of bool
        Outer and circularity >= ``rod_ratio``; 0.6 is an ellipse three times as long as wide.
    aspect : ndarray
        Ratio >= 1 of the axes of the ellipse of the same second moments.
    equivalent_diameter : ndarray, mm
        Of the disc of the same area.
    parent : ndarray of int
        The smallest contour of the plane that this one lies in, -1 for none.
    """

    plane: np.ndarray
    area: np.ndarray
    net_area: np.ndarray
    perimeter: np.ndarray
    width: np.ndarray
    height: np.ndarray
    centroid: np.ndarray
    moments: np.ndarray
    ratio: np.ndarray
    is_rod: np.ndarray
    circularity: np.ndarray
    is_rod_invariant: np.ndarray
    aspect: np.ndarray
    equivalent_diameter: np.ndarray
    parent: np.ndarray

    def __len__(self) -> int:
        return len(self.plane)


def contour_measures(contours: Contours, parameters: SliceParameters, progress: Progress = silent) -> ContourMeasures:
    """Return what every contour measures.

    Notes
    -----
    Areas by Eq. 5.1, centroids and second moments by Green's theorem, about the first point of each contour, so that
    little cancels.
    """
    sums = _sums(contours, progress)
    area = np.where(contours.closed, sums["area"], 0.0)
    low, high = (np.stack([sums[side + "u"], sums[side + "v"]]) for side in ("low_", "high_"))
    width, height = high - low
    parent = contour_parents(Polygons(contours.points, contours.starts, contours.plane, area, low, high))
    outer = area > 0
    is_own_hole = (area < 0) & (parent >= 0) & outer[parent]
    net = area + np.bincount(parent[is_own_hole], area[is_own_hole], len(area))
    with np.errstate(divide="ignore", invalid="ignore"):
        moments = _central_moments(sums)
        ratio = np.abs(area) / (width * height)
        trace = moments[:, 0] + moments[:, 2]
        circularity = area**2 / (2 * np.pi * trace)
        spread = np.hypot(moments[:, 0] - moments[:, 2], 2 * moments[:, 1])
        aspect = np.sqrt((trace + spread) / np.maximum(trace - spread, 0.0))
        centroid = np.stack([sums["first_u"] + sums["u"] / area, sums["first_v"] + sums["v"] / area], 1)
    measures = ContourMeasures(
        plane=contours.plane, area=area, net_area=np.where(outer, net, np.nan), perimeter=sums["perimeter"],
        width=width, height=height, centroid=centroid, moments=moments, ratio=ratio,
        is_rod=outer & (ratio >= parameters.rod_ratio), circularity=circularity,
        is_rod_invariant=outer & (circularity >= parameters.rod_ratio), aspect=aspect,
        equivalent_diameter=np.sqrt(4 / np.pi * np.abs(area)), parent=parent,
    )  # fmt: skip
    for name in ("perimeter", "width", "height", "centroid", "moments", "ratio", "circularity", "aspect",
                 "equivalent_diameter"):  # fmt: skip
        getattr(measures, name)[~contours.closed] = np.nan
    return measures


def _central_moments(sums: Dict[str, np.ndarray]) -> np.ndarray:
    """Second moments (C, 3) about the centroid, positive for voids too."""
    area, u, v = sums["area"], sums["u"], sums["v"]
    about = (sums["uu"] - u * u / area, sums["uv"] - u * v / area, sums["vv"] - v * v / area)
    return np.stack(about, 1) * np.sign(area)[:, None]


_SUMS = (
    *("area", "u", "v", "uu", "uv", "vv", "perimeter"),
    *("low_u", "high_u", "low_v", "high_v", "first_u", "first_v"),
)


def _sums(contours: Contours, progress: Progress) -> Dict[str, np.ndarray]:
    """Sums over the edges of each contour (C,), the first six about its first point."""
    result = {name: np.zeros(len(contours)) for name in _SUMS}
    starts = contours.starts
    begin = 0
    while begin < len(contours):
        end = max(begin + 1, int(np.searchsorted(starts, starts[begin] + _POINTS, "right")) - 1)
        u, v = (contours.points[starts[begin] : starts[end], k] for k in (0, 1))
        for name, values in zip(_SUMS, _sums_of(u, v, starts[begin : end + 1] - starts[begin])):
            result[name][begin:end] = values
        progress(end, len(contours), "measuring contours")
        begin = end
    return result


def _sums_of(u: np.ndarray, v: np.ndarray, starts: np.ndarray) -> Tuple[np.ndarray, ...]:
    """The sums of some contours, in the order of ``_SUMS``."""
    begin, last, sizes = starts[:-1], starts[1:] - 1, np.diff(starts)
    box = [side.reduceat(x, begin) for x in (u, v) for side in (np.minimum, np.maximum)]
    first_u, first_v = u[begin], v[begin]
    u, v = u - np.repeat(first_u, sizes), v - np.repeat(first_v, sizes)
    p, q = np.append(u[1:], 0.0), np.append(v[1:], 0.0)
    p[last] = q[last] = 0.0  # the first point
    cross = u * q - p * v
    su, sv = u + p, v + q
    uu, vv = su * su - u * p, sv * sv - v * q
    uv = su * sv + u * v + p * q
    area = np.add.reduceat(cross, begin) / 2
    first = (np.add.reduceat(s * cross, begin) / 6 for s in (su, sv))
    second = (np.add.reduceat(s * cross, begin) / n for s, n in ((uu, 12), (uv, 24), (vv, 12)))
    p -= u
    q -= v
    perimeter = np.add.reduceat(np.sqrt(p * p + q * q), begin)
    return (area, *first, *second, perimeter, *box, first_u, first_v)
