# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a design as one record of plain values (report.json); ``report_text`` makes pages of it for readers."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import dataclass, field, replace
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np

from .bodies import Bodies, Check
from .job import Job
from .parameters import ScaffoldParameters
from .path_laws import PATH_LAWS
from .pores import join_pores
from .presets import PRESETS, THESIS, preset
from .records import to_record
from .wireframe import Wireframe, WireframeParameters

SCHEMA = 1
_BINS = 10  # of the histogram of pore sizes
#: Estimated seconds of manual design for a rod (thesis 2.3.3), by (curved, sections).
MANUAL_SECONDS = {(False, 1): 30, (False, 2): 45, (True, 1): 60, (True, 2): 75}


#: Steps that make the network; the thesis' times are those, without the scaffold (section 4.3.1).
NETWORK_STEPS = ("envelope, sites, paths", "rods")


@dataclass(frozen=True)
class BodyFigures:
    """What is known of scaffold and channels (``bodies.Bodies``, or a scaffold in a document).

    Attributes
    ----------
    engine, reason : str
        The engine that cut the channels, and why this one.
    envelope, added, channels, scaffold, loose, voids : float, mm³
        Volumes: of the envelope, of layers outside of it, of what is exported, of loose pieces, of closed voids.
    porosity, union_porosity, sum_porosity : float
        Shares of the envelope: that is no exported scaffold; inside the rods; the plain sum of the rods.
    pieces, openings, loose_pieces, closed_voids : int
        Connected pieces of the exported scaffold and channels, pieces cut off all round, voids without opening.
    watertight : bool
        Whether scaffold and channels are closed.
    kept : bool
        Whether loose pieces are exported with the scaffold.
    notes : tuple of str
    """

    engine: str
    reason: str
    envelope: float
    added: float
    channels: float
    scaffold: float
    loose: float
    voids: float
    porosity: float
    union_porosity: float
    sum_porosity: float
    pieces: int
    openings: int
    loose_pieces: int
    closed_voids: int
    watertight: bool
    kept: bool = False
    notes: Tuple[str, ...] = ()


@dataclass(frozen=True)
class Outcome:
    """What is known when a design has been made.

    Attributes
    ----------
    job : Job
    wireframe : Wireframe
    bodies : BodyFigures
    checks : tuple of Check
        All that must hold.
    seconds : dict
        Time of each step, in order; they add up to the whole.
    cpu_seconds : float
        Processor time of all steps together.
    files : dict
        Bytes of each file written.
    versions : dict
        Of the programs that took part.
    warnings : tuple of str
    """

    job: Job
    wireframe: Wireframe
    bodies: BodyFigures
    checks: Tuple[Check, ...] = ()
    seconds: Mapping[str, float] = field(default_factory=dict)
    cpu_seconds: float = 0.0
    files: Mapping[str, int] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=dict)
    warnings: Tuple[str, ...] = ()


def body_figures(bodies: Bodies) -> BodyFigures:
    """Return the figures of bodies."""
    parts = bodies.parts
    return BodyFigures(
        bodies.engine,
        bodies.reason,
        bodies.envelope_volume,
        bodies.added_volume,
        parts.channel_volume,
        parts.scaffold_volume,
        bodies.loose_volume,
        bodies.void_volume,
        bodies.porosity,
        bodies.union_porosity,
        bodies.sum_porosity,
        parts.pieces,
        parts.openings,
        len(parts.loose),
        len(parts.void_volumes),
        bodies.watertight,
        bodies.kept,
        bodies.notes,
    )


# ------------------------------------------------------------------------------------------------------- the record


def report_record(outcome: Outcome) -> Dict[str, Any]:
    """Return the report as plain values for JSON; keys end in their unit where it is not plain.

    ``porosity`` is V_voids / V_envelope (Eq. 2.2, there in %), the voids being all of the envelope that is no exported
    scaffold; ``union_porosity_percent`` counts what the rods fill, ``sum_porosity_percent`` the plain sum of the rods.
    """
    job, wireframe, bodies = outcome.job, outcome.wireframe, outcome.bodies
    return {
        "schema": SCHEMA,
        "name": job.name,
        "seed": job.seed,
        "rods": len(wireframe),
        "porosity": bodies.porosity,
        "porosity_percent": 100 * bodies.porosity,
        "union_porosity_percent": 100 * bodies.union_porosity,
        "sum_porosity_percent": 100 * bodies.sum_porosity,
        "volume_mm3": volumes(bodies),
        "watertight": bodies.watertight,
        "ok": all(check.ok for check in outcome.checks),
        "checks": [dict(check._asdict(), ok=check.ok) for check in outcome.checks],
        "engine": {"asked": job.scaffold.engine, "used": bodies.engine, "why": bodies.reason},
        "pieces": {
            "scaffold": bodies.pieces,
            "channels": bodies.openings,
            "loose": bodies.loose_pieces,
            "closed_voids": bodies.closed_voids,
        },
        "faces": face_table(job, wireframe),
        "couplings": coupling_table(wireframe),
        "pores": pore_figures(wireframe),
        "recoveries": [to_record(one, everything=True) for one in wireframe.recoveries],
        "failed_rods": list(wireframe.failed),
        "outside_rods": list(wireframe.outside),
        "warnings": [*bodies.notes, *outcome.warnings],
        **time_figures(job, wireframe, outcome.seconds),
        "cpu_seconds": outcome.cpu_seconds,
        "files": dict(outcome.files),
        "thesis": thesis_figures(job),
        "versions": dict(outcome.versions),
        "job": to_record(job, everything=True),
    }


def volumes(bodies: BodyFigures) -> Dict[str, float]:
    """Return the volumes, mm³: scaffold + channels + loose = envelope + layers.

    ``loose`` is what is exported neither with the one nor with the other: 0 where loose pieces are kept in the
    scaffold. ``rods`` is the plain sum of the rods, crossings counted as often as they come.
    """
    return {
        "envelope": bodies.envelope,
        "layers": bodies.added,
        "channels": bodies.channels,
        "scaffold": bodies.scaffold,
        "loose": 0.0 if bodies.kept else bodies.loose,
        "closed_voids": bodies.voids,
        "rods": bodies.sum_porosity * (bodies.envelope + bodies.added),
    }


def face_table(job: Job, wireframe: Wireframe) -> List[Dict[str, Any]]:
    """Return one row per face with its input and its number of sites (tables 4.1, 4.4)."""
    given = {one.label: to_record(one, everything=True) for one in job.faces}
    rows = []
    for label, sites in wireframe.sites.items():
        row: Dict[str, Any] = {"label": label, "face": label, **given.get(label, {})}
        row.pop("name", None)
        row.update(sites=int(sites.on.sum()), switched_off=int((~sites.on).sum()))
        rows.append(row)
    return rows


def coupling_table(wireframe: Wireframe) -> List[Dict[str, Any]]:
    """Return one row per coupling: available, rods, left (tables 4.2, 4.5)."""
    return [to_record(row, everything=True) for row in wireframe.rows]


def pore_figures(wireframe: Wireframe) -> Dict[str, Any]:
    """Return sizes and areas of the rods' end sections: estimated area s² and true area of the curve (thesis 2.4.1)."""
    ends = wireframe.ends
    sections = join_pores([ends.first, ends.second]) if ends.rolls else ends.first
    if not len(sections):
        return {"count": 0}
    counts, edges = np.histogram(sections.size, bins=_BINS)
    return {
        "count": len(sections),
        "size_mm": _spread(sections.size),
        "estimated_area_mm2": _spread(sections.estimated_areas),
        "true_area_mm2": _spread(sections.areas),
        "true_by_estimated_area": float(sections.areas.sum() / sections.estimated_areas.sum()),
        "size_histogram": {"edges_mm": edges.tolist(), "counts": counts.tolist()},
    }


def _spread(values: np.ndarray) -> Dict[str, float]:
    sd = float(values.std(ddof=1)) if len(values) > 1 else 0.0
    return {"mean": float(values.mean()), "sd": sd, "least": float(values.min()), "greatest": float(values.max())}


def time_figures(job: Job, wireframe: Wireframe, seconds: Mapping[str, float]) -> Dict[str, Any]:
    """Return times, s: of the steps, of all, of the network per rod, and of manual design (thesis 2.3.3, 2.4.7)."""
    total, manual = sum(seconds.values()), manual_seconds(job, wireframe)
    network = sum(seconds.get(step, 0.0) for step in NETWORK_STEPS)
    rods = max(len(wireframe), 1)
    return {
        "seconds": total,
        "seconds_by_step": dict(seconds),
        "seconds_of_network": network,
        "seconds_per_rod": network / rods,
        "manual_seconds": manual,
        "manual_seconds_per_rod": manual / rods,
    }


def manual_seconds(design: Union[Job, WireframeParameters], wireframe: Wireframe) -> float:
    """Return the estimated time of manual design, s: 30 to 75 a rod, by curvature and sections (thesis 2.3.3)."""
    total = 0
    for number, count in Counter(wireframe.coupling.tolist()).items():
        path = design.couplings[number].path or design.path
        total += count * MANUAL_SECONDS[PATH_LAWS[path.kind].is_curved, design.pores.sections]
    return float(total)


def thesis_figures(job: Job) -> Optional[Dict[str, Any]]:
    """Return what the thesis gives for this design; None if the job is no preset, whatever its seed and engine."""
    if job.name not in PRESETS:
        return None
    own = replace(job, seed=1, scaffold=ScaffoldParameters())
    original = preset(job.name)
    if own != replace(original, seed=1, scaffold=ScaffoldParameters(), envelope=own.envelope):
        return None
    return {"porosity_percent" if k == "porosity" else k: v for k, v in THESIS[job.name]._asdict().items()}


def report_json(record: Mapping[str, Any]) -> str:
    """Return the record as JSON text."""
    return json.dumps(record, indent=2, allow_nan=False) + "\n"
