# SPDX-License-Identifier: LGPL-2.1-or-later
"""The record of an analysis: what was measured, what was checked twice, what is to be said of it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from ..bodies import Check
from .json_values import to_values
from .parameters import AXES

if TYPE_CHECKING:
    from .analysis import Analysis
    from .branches import Branches
    from .profiles import Profile

KIND, SCHEMA = "slice analysis", 1
_NAMED = 12  # stretches of layers that are named; more are counted


# -------------------------------------------------------------------------------------------------------------- checks


def analysis_checks(analysis: Analysis) -> Tuple[Check, ...]:
    """Return what two routes must agree on: the body's volume, by slices along each axis and by its triangles.

    Notes
    -----
    Sum of area x thickness is a quadrature of the sliced area with planes at the layers' middles or bottoms. Its
    error is at most half a layer (a whole one) times the total variation of the sliced area, the jumps from and to
    nothing at both ends included (Koksma's inequality in one dimension: Niederreiter 1992,
    doi:10.1137/1.9781611970081): this is the tolerance. Mean bone fractions of axes may differ by the sum of two
    axes' tolerances and of the parts of a layer by which their stacks miss the box.
    """
    if analysis.facts is None or volume_reason(analysis):
        return ()
    volume = analysis.facts.volume
    found: List[Check] = []
    for axis, profile in analysis.profiles.items():
        total = float(profile.sliced_area.sum() * profile.thickness)
        size = max(abs(volume), abs(total), 1e-300)
        share = profile_tolerance(profile, analysis.parameters.at) / size
        name = f"volume along {axis}, sum of area x thickness against the mesh, mm3"
        found.append(Check(name, total, volume, abs(total - volume) / size, share))
    boxed = [axis for axis in analysis.profiles if axis in AXES and analysis.profiles[axis].envelope == "box"]
    if len(boxed) > 1:
        found.append(_fraction_check(analysis, boxed, dict(zip(analysis.profiles, found))))
    return tuple(found)


def _fraction_check(analysis: Analysis, axes: Sequence[str], volumes: Mapping[str, Check]) -> Check:
    fractions = {axis: analysis.summary(axis).mean_bone_fraction for axis in axes}
    low, high = min(axes, key=fractions.__getitem__), max(axes, key=fractions.__getitem__)
    allowed = 0.0
    for axis in (low, high):
        length = float(np.ptp(np.asarray(analysis.box)[:, AXES.index(axis)]))
        stack = len(analysis.profiles[axis]) * analysis.profiles[axis].thickness
        allowed += volumes[axis].tolerance + abs(stack / length - 1 if length > 0 else math.inf)
    apart = (fractions[high] - fractions[low]) / max(abs(fractions[high]), 1e-300)
    return Check(f"mean bone fraction, along {high} against {low}", fractions[high], fractions[low], apart, allowed)


def profile_tolerance(profile: Profile, at: str) -> float:
    """Return by how much the sum of area x thickness may miss the volume, mm³ (see ``analysis_checks``)."""
    steps = np.abs(np.diff(np.concatenate([[0.0], profile.sliced_area, [0.0]])))
    return float(steps.sum() * profile.thickness * (1.0 if at == "bottom" else 0.5))


def volume_reason(analysis: Analysis) -> str:
    """Return why the slices' volume cannot be held against the mesh's, or nothing."""
    chosen = analysis.parameters
    if analysis.facts is None:
        return "there is no mesh"
    if not analysis.facts.is_closed:
        return "the mesh does not enclose a volume"
    reasons = {
        "the planes are not those of layers": chosen.at == "heights",
        "a range only was sliced": not (math.isnan(chosen.low) and math.isnan(chosen.high)),
        "contours were offset": chosen.compensation != 0,
        "contours were smoothed": chosen.smoothing != "off",
        "contours were filtered": chosen.filter_closed > 0,
        "what overlaps was united": chosen.fill == "union" and analysis.facts.self_intersecting != 0,
    }
    return next((reason for reason, holds in reasons.items() if holds), "")


# --------------------------------------------------------------------------------------------------------------- notes


def analysis_faults(analysis: Analysis) -> Tuple[str, ...]:
    """Return, one sentence each, why the numbers are not to be trusted: the mesh is open, turned or there twice."""
    facts, faults = analysis.facts, []
    if facts is not None:
        counts = (
            (facts.open_edges, "open edge", ": the mesh is not watertight"),
            (facts.flipped, "facet", " turned against the neighbours"),
            (facts.duplicates, "facet", " there twice: the material counts twice"),
        )
        faults += [counted(count, one) + words for count, one, words in counts if count]
        if facts.is_closed and facts.volume <= 0:
            faults.append(f"the mesh is inside out, or flat: its volume is {facts.volume:.6g} mm3")
    for axis, profile in analysis.profiles.items():
        spoilt = np.flatnonzero(profile.spoilt)
        if len(spoilt):
            faults.append(f"along {axis} {len(spoilt)} of {len(profile)} slices are spoilt: layers {runs(spoilt)}")
    return tuple(faults)


def analysis_notes(analysis: Analysis) -> Tuple[str, ...]:
    """Return what else is to be said of an analysis, one sentence each."""
    facts, notes = analysis.facts, []
    if "guessed" in analysis.unit:
        notes.append(f"the unit is {analysis.unit}; name it if this is wrong")
    if facts is not None:
        if facts.self_intersecting > 0:
            rule = {"winding": "counts as often as it overlaps", "union": "counts once"}[analysis.parameters.fill]
            notes.append(
                f"{counted(facts.self_intersecting, 'facet')} through others: what overlaps {rule} (fill rule "
                f"'{analysis.parameters.fill}')"
            )
        if facts.degenerate:
            notes.append(f"{counted(facts.degenerate, 'facet')} without area: no slice is spoilt by that")
    for axis, profile in analysis.profiles.items():
        notes += _axis_notes(analysis, axis, profile)
    notes += list(getattr(analysis.morphometry, "notes", ()))
    reason = volume_reason(analysis)
    if reason:
        notes.append(f"the slices' volume was not held against the mesh's: {reason}")
    return tuple(notes)


def _axis_notes(analysis: Analysis, axis: str, profile: Profile) -> List[str]:
    notes, repairs = [], analysis.repairs.get(axis)
    least = analysis.parameters.least_area
    small = int((np.abs(analysis.measures[axis].area) <= least).sum())
    if small:
        notes.append(f"along {axis} {counted(small, 'contour')} of at most {least:g} mm2 left out of all counts")
    if not profile.sliced_area.any():
        notes.append(f"along {axis} no slice has any area")
    if repairs is not None:
        words = {
            "gaps_filled": ("gap", "filled"),
            "gaps_bridged": ("gap", f"wider than {analysis.parameters.gap:g} mm bridged"),
            "removed_open": ("open contour", "left out by the filter"),
            "removed_closed": ("closed contour", "left out by the filter"),
            "points_smoothed": ("point", "left out by smoothing"),
            "offset": ("contour", "offset"),
            "united": ("contour", "united"),
        }
        totals = {name: int(np.sum(getattr(repairs, name))) for name in words}
        said = [f"{counted(totals[name], one)} {text}" for name, (one, text) in words.items() if totals[name]]
        if said:
            longest = float(np.max(repairs.longest_gap, initial=0.0))
            gaps = f" (the widest gap: {longest:.3g} mm)" if longest > 0 else ""
            notes.append(f"along {axis} {', '.join(said)}{gaps}")
    return notes


def counted(count: int, what: str) -> str:
    """Return "1 facet", "2 facets"."""
    return f"{count} {what}{'' if count == 1 else 's'}"


def runs(numbers: np.ndarray) -> str:
    """Return ascending whole numbers as stretches: 3-5, 8, 10-12."""
    if not len(numbers):
        return ""
    starts = np.flatnonzero(np.diff(numbers, prepend=numbers[0] - 2) > 1)
    ends = np.append(starts[1:], len(numbers)) - 1
    words = [f"{numbers[a]}-{numbers[b]}" if b > a else f"{numbers[a]}" for a, b in zip(starts, ends)]
    more = f" and {len(words) - _NAMED} more stretches" if len(words) > _NAMED else ""
    return ", ".join(words[:_NAMED]) + more


# -------------------------------------------------------------------------------------------------------------- record


def analysis_record(
    analysis: Analysis,
    checks: Optional[Sequence[Check]] = None,
    files: Optional[Mapping[str, int]] = None,
    versions: Optional[Mapping[str, str]] = None,
    notes: Sequence[str] = (),
    branches: Optional[Mapping[str, Branches]] = None,
) -> Dict[str, Any]:
    """Return all numbers of an analysis but those of single contours, as ``report.json`` holds them.

    Parameters
    ----------
    analysis : Analysis
    checks : sequence of Check, optional
        By default ``analysis_checks``.
    files : mapping of name to bytes, optional
        Files beside the report.
    versions : mapping of name to version, optional
        Programs that took part.
    notes : sequence of str
        Further things to be said.
    branches : mapping of axis to Branches, optional
        How trabeculae hang together from slice to slice, if it was traced.
    """
    checks = analysis_checks(analysis) if checks is None else checks
    faults = analysis_faults(analysis)
    facts = analysis.facts
    return {
        "kind": KIND,
        "schema": SCHEMA,
        "name": analysis.name,
        "unit": analysis.unit,
        "ok": not faults and all(check.ok for check in checks),
        "watertight": None if facts is None else facts.is_closed,
        "faults": list(faults),
        "notes": [*notes, *analysis_notes(analysis)],
        "fill_rule": analysis.parameters.fill,
        "parameters": to_values(analysis.parameters),
        "box_mm": to_values(np.asarray(analysis.box)),
        "size_mm": to_values(np.ptp(np.asarray(analysis.box), axis=0)),
        "mesh": to_values(facts),
        "checks": [dict(to_values(check), ok=check.ok) for check in checks],
        "axes": {axis: _axis_record(analysis, axis) for axis in analysis.profiles},
        "interconnectivity": {axis: branches_record(own) for axis, own in (branches or {}).items()},
        "morphometry": to_values(analysis.morphometry),
        "seconds": analysis.seconds,
        "files": dict(files or {}),
        "versions": dict(versions or {}),
    }


def branches_record(branches: Branches) -> Dict[str, Any]:
    """Return what is counted on the graph of trabeculae along one axis (thesis ch. 9)."""
    names = ("branches", "branches_per_mm", "junctions", "junctions_per_mm", "parts", "loops", "unresolved")
    events = {name: int(getattr(branches, name).sum()) for name in ("appear", "end", "split", "join")}
    return {**{name: to_values(getattr(branches, name)) for name in names}, **events, "rows_mm": branches.spacing}


def _axis_record(analysis: Analysis, axis: str) -> Dict[str, Any]:
    profile, repairs = analysis.profiles[axis], analysis.repairs.get(axis)
    area = profile.envelope_area
    return {
        "slices": len(profile),
        "thickness_mm": profile.thickness,
        "summary": to_values(analysis.summary(axis)),
        "envelope": profile.envelope,
        "envelope_area_mm2": to_values(area[:1] if (area == area[:1]).all() else area),
        "spoilt_layers": np.flatnonzero(profile.spoilt).tolist(),
        "repairs": None if repairs is None else {k: v for k, v in to_values(repairs).items() if any(v)},
    }
