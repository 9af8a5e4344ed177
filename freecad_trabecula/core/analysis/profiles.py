# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles: the numbers of every slice along an axis, their ranges and totals (thesis 5.2.3, Tables 5.2 to 5.10)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional, Tuple

import numpy as np

from ...errors import ParameterError
from .contours import ContourMeasures, Contours
from .parameters import SliceParameters

Range = Tuple[float, float]


@dataclass(frozen=True)
class Profile:
    """One row for each slice (S,) along an axis.

    Attributes
    ----------
    axis : str
    thickness : float, mm
        Of a layer.
    coordinate : ndarray, mm
        Of the planes along the axis.
    sliced_area : ndarray, mm²
        Sum of the contours' areas, voids negative (thesis column D).
    contours : ndarray of int
        Closed contours of more than the least area, voids too: the thesis' number of trabeculae (column E).
    outer_contours : ndarray of int
        Those round material: trabeculae.
    holes : ndarray of int
        Those round voids.
    envelope_area : ndarray, mm²
        What the porosity refers to: the rectangle of the body's box, or the slice of its envelope.
    porosity : ndarray
        1 - sliced area / envelope area; nan where the envelope has no area.
    spoilt : ndarray of bool
        The mesh was not closed on this plane: its numbers are not to be trusted.
    envelope : str
        ``box``, or what else the porosity refers to.
    """

    axis: str
    thickness: float
    coordinate: np.ndarray
    sliced_area: np.ndarray
    contours: np.ndarray
    outer_contours: np.ndarray
    holes: np.ndarray
    envelope_area: np.ndarray
    porosity: np.ndarray
    spoilt: np.ndarray
    envelope: str = "box"

    def __len__(self) -> int:
        return len(self.coordinate)


@dataclass(frozen=True)
class ProfileSummary:
    """Ranges and totals of one axis: a column of Tables 5.2, 5.5, 5.7, 5.10. Ranges are (lowest, highest).

    Attributes
    ----------
    slices, spoilt_slices : int
    rods, plates : int
        Outer contours by the thesis' rule; holes are neither. Under that rule holes, whose area is negative, would all
        be plates: ``plates_with_holes`` counts them so.
    plates_with_holes : int
    rods_invariant, plates_invariant : int
        By the rule that does not change when the part is turned.
    trabecular_area : (float, float), mm²
        Of all contours, voids negative (Eq. 5.1).
    net_trabecular_area : (float, float), mm²
        Of outer contours less their holes.
    sliced_area, porosity, contours, outer_contours : (float, float)
    mean_sliced_area : float, mm²
    volume : float, mm³
        Sum of sliced area times layer thickness; nan where planes are not the layers' own.
    mean_bone_fraction : float
        Mean sliced area over mean envelope area.
    """

    slices: int
    spoilt_slices: int
    rods: int
    plates: int
    plates_with_holes: int
    rods_invariant: int
    plates_invariant: int
    trabecular_area: Range
    net_trabecular_area: Range
    sliced_area: Range
    porosity: Range
    contours: Range
    outer_contours: Range
    mean_sliced_area: float
    volume: float
    mean_bone_fraction: float


def make_profile(contours: Contours, measures: ContourMeasures, parameters: SliceParameters, envelope_area: np.ndarray,
                 spoilt: Optional[np.ndarray] = None, envelope: str = "box") -> Profile:  # fmt: skip
    """Return the profile of contours.

    Parameters
    ----------
    envelope_area : float or ndarray of shape (S,), mm²
        What the porosity refers to.
    spoilt : ndarray of shape (S,), optional
        Planes that were spoilt before any repair; by default those with an open chain.

    Raises
    ------
    ParameterError
        If the contours and their measures are not of the same slices.
    """
    if len(contours) != len(measures):
        raise ParameterError(f"each contour must have one row of measures, got {len(contours)} and {len(measures)}")
    slices = len(contours.heights)
    if spoilt is None:
        spoilt = np.bincount(contours.plane[~contours.closed], minlength=slices) > 0
    area = np.bincount(contours.plane, measures.area, slices) + 0.0
    outer, holes = (
        np.bincount(contours.plane[which], minlength=slices)
        for which in (measures.area > parameters.least_area, measures.area < -parameters.least_area)
    )
    envelope_area = np.broadcast_to(np.asarray(envelope_area, float), slices).copy()
    with np.errstate(divide="ignore", invalid="ignore"):
        porosity = np.where(envelope_area > 0, 1 - area / envelope_area, np.nan)
    return Profile(contours.axis, parameters.thickness, contours.heights, area, outer + holes, outer, holes,
                   envelope_area, porosity, np.asarray(spoilt, bool), envelope)  # fmt: skip


def summarise(profile: Profile, measures: ContourMeasures, parameters: SliceParameters) -> ProfileSummary:
    """Return ranges and totals of an axis; contours of no more than the least area are left out of all counts."""
    counted = np.abs(measures.area) > parameters.least_area
    outer = counted & (measures.area > 0)
    rods, rods_invariant = (int((outer & which).sum()) for which in (measures.is_rod, measures.is_rod_invariant))
    area, envelope = profile.sliced_area, profile.envelope_area
    evenly = parameters.at != "heights"
    return ProfileSummary(
        slices=len(profile), spoilt_slices=int(profile.spoilt.sum()),
        rods=rods, plates=int(outer.sum()) - rods, plates_with_holes=int(counted.sum()) - rods,
        rods_invariant=rods_invariant, plates_invariant=int(outer.sum()) - rods_invariant,
        trabecular_area=_range(measures.area[counted]), net_trabecular_area=_range(measures.net_area[outer]),
        sliced_area=_range(area), porosity=_range(profile.porosity), contours=_range(profile.contours),
        outer_contours=_range(profile.outer_contours), mean_sliced_area=float(area.mean()) if len(area) else math.nan,
        volume=float(area.sum() * profile.thickness) if evenly else math.nan,
        mean_bone_fraction=float(area.sum() / envelope.sum()) if envelope.sum() > 0 else math.nan,
    )  # fmt: skip


def _range(values: np.ndarray) -> Range:
    """Lowest and highest of the values that are numbers; nan if there is none."""
    values = values[np.isfinite(values)]
    return (float(values.min()), float(values.max())) if len(values) else (math.nan, math.nan)
