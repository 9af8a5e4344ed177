# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job: all that a design needs, in one frozen, checked record; read from and written to JSON (docs/job.md)."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Dict, Optional, Sequence, Tuple

from ..errors import ParameterError
from .parameters import (
    Coupling,
    FaceParameters,
    PathParameters,
    PoreParameters,
    PrismParameters,
    RodParameters,
    ScaffoldParameters,
    SiteEdit,
    _f,
    require,
)
from .records import from_record, to_record
from .sites import OPPOSITE_FACES, PRISM_FACES
from .wireframe import WireframeParameters

SCHEMA = 1
MOST_RODS = 20_000
#: Measured with the field engine at 0.1 mm cells, 2 cores: seconds and bytes that one rod adds.
SECONDS_PER_ROD, BYTES_PER_ROD = 0.01, 600_000


@dataclass(frozen=True)
class Job:
    """A design: envelope, sites, pores, couplings, paths, seed, scaffold.

    Attributes
    ----------
    schema : int
        Version of this format.
    name : str
    envelope : str
        STEP, IGES, BREP or STL file; empty for a prism.
    solid : str
        Name or number of the solid, where the file holds several.
    prism : PrismParameters or None
        The prism and its sites by Eq. 2.1.
    faces : tuple of FaceParameters
        Faces with sites by curvilinear co-ordinates; with a prism they replace its sites by Eq. 2.1.
    """

    schema: int = _f(SCHEMA, "", "Version of the format")
    name: str = _f("design", "", "Name of the design")
    envelope: str = _f("", "", "File of the envelope; none means a prism")
    solid: str = _f("", "", "Name or number of the solid in that file")
    prism: Optional[PrismParameters] = _f(None, "", "Prism and its sites (Eq. 2.1)")
    faces: Tuple[FaceParameters, ...] = _f((), "", "Sites on faces by curvilinear co-ordinates")
    pores: PoreParameters = _f(PoreParameters(), "", "Pores")
    path: PathParameters = _f(PathParameters(), "", "Paths of the rods")
    couplings: Tuple[Coupling, ...] = _f((), "", "Pairs of faces, in order")
    rods: RodParameters = _f(RodParameters(), "", "Surface and recovery of the rods")
    scaffold: ScaffoldParameters = _f(ScaffoldParameters(), "", "Engine, layers, loose pieces")
    edits: Tuple[SiteEdit, ...] = _f((), "", "Changes of single sites by hand")
    seed: int = _f(1, "", "One number reproduces all draws")

    def __post_init__(self) -> None:
        require(self.schema == SCHEMA, f"the job's schema must be {SCHEMA}", self.schema)
        require(bool(self.envelope) != (self.prism is not None), "a job needs either an envelope file or a prism",
                "both" if self.envelope else "neither")  # fmt: skip
        require(self.prism is not None or bool(self.faces), "an envelope file needs faces with sites", "none")
        labels = [f.label for f in self.faces] or list(PRISM_FACES)
        require(len(set(labels)) == len(labels), "every face must be named once", labels)
        for coupling in self.couplings:
            for face in (coupling.first, coupling.second):
                require(face in labels, f"a coupling must join faces of the job ({', '.join(labels)})", repr(face))
        require(len(self.couplings) > 0, "a job needs at least one coupling", len(self.couplings))
        self.wireframe  # noqa: B018  checks the seed
        self._check_size()

    def _check_size(self) -> None:
        if self.prism is None or self.faces:
            return
        counts = [n for _, _, n, _ in self.prism.axes]
        sites = [counts[1] * counts[2], counts[2] * counts[0], counts[0] * counts[1]]
        per_face = {face: sites[k // 2] for k, face in enumerate(PRISM_FACES)}
        check_rods(sum(min(per_face[c.first], per_face[c.second]) for c in self.couplings if c.on))

    @property
    def wireframe(self) -> WireframeParameters:
        """The part that the wireframe depends on."""
        return WireframeParameters(self.pores, self.path, self.couplings, self.rods, self.edits, self.seed)


def check_rods(count: int) -> None:
    """Refuse a design of too many rods, with an estimate of what it would take.

    Raises
    ------
    ParameterError
        If ``count`` exceeds ``MOST_RODS``.
    """
    hours, gigabytes = count * SECONDS_PER_ROD / 3600, count * BYTES_PER_ROD / 1e9
    require(
        count <= MOST_RODS,
        f"a design must have at most {MOST_RODS:,} rods; this one would take about {hours:,.1f} hours and "
        f"{gigabytes:,.1f} GB",
        f"{count:,}",
        "rods",
    )


def opposite_couplings(association: str) -> Tuple[Coupling, ...]:
    """Return the couplings of a prism's opposite faces."""
    return tuple(Coupling(a, b, association) for a, b in OPPOSITE_FACES)


def job_from_json(text: str) -> Job:
    """Return the job in a JSON text.

    Raises
    ------
    ParameterError
        If it is no JSON, or a key, type or value is wrong; the message says where.
    """
    try:
        record = json.loads(text, parse_constant=_refuse_constant, object_pairs_hook=_without_doubles)
    except (ValueError, RecursionError) as error:
        raise ParameterError(f"a job must be JSON: {error}") from error
    return from_record(Job, record, "job")


def _without_doubles(pairs: Sequence[Tuple[str, Any]]) -> Dict[str, Any]:
    """Return the object of these keys; JSON would let the last of two values of one key win without a word."""
    found: Dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise ParameterError(f"a key of a job may stand once in its object, got {key!r} twice")
        found[key] = value
    return found


def _refuse_constant(name: str) -> None:
    raise ParameterError(f"a job's numbers must be finite, got {name}")


def job_to_json(job: Job) -> str:
    """Return the job as JSON text with every field, so that a saved job shows what can be changed."""
    return json.dumps(to_record(job, everything=True), indent=2) + "\n"


def set_values(job: Job, settings: Sequence[str]) -> Job:
    """Return the job with fields set by ``name=value`` texts, e.g. ``pores.size.high=0.6`` or ``couplings.0.on=false``.

    Raises
    ------
    ParameterError
        If a name is unknown or a value is refused.
    """
    for setting in settings:
        name, equals, text = setting.partition("=")
        require(bool(equals) and bool(name.strip()), "a setting must read name=value", repr(setting))
        try:
            value: Any = json.loads(text)
        except ValueError:
            value = text  # a bare word is a text
        job = _set(job, name.strip().split("."), value, name.strip())
    return job


def _set(job: Job, keys: Sequence[str], value: Any, name: str) -> Job:
    changed = _changed(job, keys, value, name)
    return from_record(Job, to_record(changed) if not isinstance(changed, dict) else changed, "job")


def _changed(owner: Any, keys: Sequence[str], value: Any, name: str) -> Any:
    """Return the record of ``owner`` with the value at ``keys`` replaced."""
    if not keys:
        return value
    key = keys[0]
    if isinstance(owner, tuple):
        require(key.isdigit() and int(key) < len(owner), f"{name} must number one of {len(owner)} entries", repr(key))
        return [_changed(o, keys[1:], value, name) if i == int(key) else to_record(o) for i, o in enumerate(owner)]
    fields: Dict[str, Any] = getattr(owner, "__dataclass_fields__", {})
    require(
        key in fields, f"{name} must name a field of the job; known here are {', '.join(fields) or 'none'}", repr(key)
    )
    record = {f: to_record(getattr(owner, f)) for f in fields}
    record[key] = _changed(getattr(owner, key), keys[1:], value, name)
    return record


def with_seed(job: Job, seed: int) -> Job:
    """Return the job with another seed."""
    return replace(job, seed=seed)


def read_job(path: str) -> Job:
    """Return the job in a file; its envelope's file is looked for beside it first.

    Raises
    ------
    ParameterError
        If the file cannot be read, or is no job.
    """
    try:
        text = Path(path).read_text(encoding="utf-8-sig")  # editors on Windows put a mark in front
    except OSError as error:
        raise ParameterError(f"the job file {path} cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise ParameterError(f"the job file {path} must be a text in UTF-8: {error}") from error
    try:
        job = job_from_json(text)
    except ParameterError as error:
        raise ParameterError(f"{path}: {error}") from error
    beside = Path(path).parent / job.envelope
    return replace(job, envelope=str(beside)) if job.envelope and beside.is_file() else job
