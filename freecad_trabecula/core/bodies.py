# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scaffold and channels of a design by the engine chosen, with two independent volumes for everything: double entry."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ..errors import MeshError
from .booleans import combine, cut_bodies, manifold_available, split_body
from .engines import Estimate, choose
from .field import field_bodies, field_union, fills_its_box
from .layers import LayeredBody, Patch, layered_body, reaches
from .meshes import Mesh, bounds, edge_faults, is_closed, mesh_volume, printable, require_closed
from .parameters import Coupling, ScaffoldParameters
from .pieces import SLIVER, Parts, pieces, separate
from .progress import Progress, part, silent
from .rays import RayVolume, union_volume
from .rods import Rods, rod_mesh, rod_volumes
from .wireframe import Wireframe

BALANCE = 1e-6  # of the envelope: scaffold + channels + loose pieces against it (mesh engine, or a box)
FIELD = 2e-3  # of the envelope: what cells may change
RAYS = (100, 250)  # fewest and most rays per direction
RAYS_PER_ROOT = 16  # rays per direction and root of the number of rods: 1e-4 of the volume for case 6
FIELD_RAYS = 100  # per direction, where cells blunt the volume more than so few rays do
RAY_ERRORS = 5.0  # standard errors by which the rays' volume may differ
NOTED = 0.01  # of the envelope: loose pieces or filled voids above this share are pointed out


#: A check as ``str`` writes it.
_CHECK = re.compile(
    r"(?P<name>.+?): (?P<value>\S+) against (?P<second>\S+), (?P<difference>\S+) apart \(at most (?P<tolerance>\S+)\)$"
)


class Check(NamedTuple):
    """One quantity from two independent routes.

    Attributes
    ----------
    name : str
    value, second : float
        By the route that is used, and by another.
    difference : float
        How far they are apart; for volumes relative to the envelope's.
    tolerance : float
        How far they may be apart.
    """

    name: str
    value: float
    second: float
    difference: float
    tolerance: float

    @property
    def ok(self) -> bool:
        """True if they agree; false also where one is not a number."""
        return bool(self.difference <= self.tolerance)

    @classmethod
    def from_text(cls, text: str) -> Optional[Check]:
        """Return the check that ``str`` wrote, with the digits that are there; None if the text is none."""
        found = _CHECK.match(text)
        try:
            return cls(found["name"], *(float(found[key]) for key in cls._fields[1:])) if found else None
        except ValueError:
            return None

    def __str__(self) -> str:
        apart = f"{self.difference:.2g} apart (at most {self.tolerance:.2g})"
        return f"{self.name}: {self.value:.9g} against {self.second:.9g}, {apart}"


@dataclass(frozen=True)
class Bodies:
    """What a design becomes, and what is known of it.

    Attributes
    ----------
    engine : str
        ``mesh`` or ``field``.
    reason : str
        Why this engine, and what it was expected to take.
    envelope_volume, added_volume : float, mm³
        Of the envelope, and of what outward layers add to it; volumes below add to the sum of both.
    parts : Parts
        Scaffold, channels, loose pieces, voids, as meshes and volumes.
    kept : bool
        True if loose pieces are part of the export.
    union_volume : float, mm³
        Of all that the rods fill of the envelope, voids included, before anything is taken away or filled.
    rods_volume : float, mm³
        Plain sum of the rods' volumes, crossings counted twice and more (what the thesis' table 3.1 gives); nan if
        unknown.
    checks : tuple of Check
    notes : tuple of str
        What the user must know.
    """

    engine: str
    reason: str
    envelope_volume: float
    added_volume: float
    parts: Parts
    kept: bool
    union_volume: float
    rods_volume: float
    checks: Tuple[Check, ...]
    notes: Tuple[str, ...]

    @property
    def scaffold(self) -> Mesh:
        """The scaffold as it is exported."""
        return self.parts.scaffold

    @property
    def channels(self) -> Mesh:
        """The channels as they are exported; loose pieces in them stay out of them."""
        return self.parts.channels

    @property
    def loose(self) -> Tuple[Mesh, ...]:
        """Pieces that channels cut off all round."""
        return self.parts.loose

    @property
    def voids(self) -> Tuple[Mesh, ...]:
        """Parts of the channels that no opening reaches."""
        return self.parts.voids

    @property
    def body_volume(self) -> float:
        """Envelope and outward layers, mm³."""
        return self.envelope_volume + self.added_volume

    @property
    def loose_volume(self) -> float:
        """Volume of all loose pieces, mm³."""
        return float(sum(self.parts.loose_volumes))

    @property
    def void_volume(self) -> float:
        """Volume of all closed voids, mm³."""
        return float(sum(self.parts.void_volumes))

    @property
    def porosity(self) -> float:
        """Share of the body that is not exported scaffold (Eq. 2.2): loose pieces that are taken away count as void."""
        return 1.0 - self.parts.scaffold_volume / self.body_volume

    @property
    def union_porosity(self) -> float:
        """Share of the body inside the rods (Eq. 2.2): nothing taken away or filled. What the thesis gives."""
        return self.union_volume / self.body_volume

    @property
    def sum_porosity(self) -> float:
        """Plain sum of the rods over the body: what case 1 of the thesis gives."""
        return self.rods_volume / self.body_volume

    @property
    def ok(self) -> bool:
        """True if all checks hold."""
        return all(check.ok for check in self.checks)

    @property
    def watertight(self) -> bool:
        """True if scaffold and channels are closed: each edge in two triangles that run along it both ways."""
        return all(check.ok for check in self.checks if check.name.startswith("watertight"))


def scaffold_bodies(
    rod_vertices: np.ndarray,
    rod_triangles: np.ndarray,
    envelope: Mesh,
    parameters: ScaffoldParameters,
    patches: Sequence[Patch] = (),
    rods_volume: float = math.nan,
    progress: Progress = silent,
) -> Bodies:
    """Return scaffold and channels with their checks.

    Parameters
    ----------
    rod_vertices : ndarray of shape (R, V, 3), mm
        Rods prolonged beyond the envelope (``rods.rod_mesh`` with ``beyond``, ``layers.reaches``).
    rod_triangles : ndarray of shape (T, 3), int
        The same for all.
    envelope : Mesh
        Closed.
    parameters : ScaffoldParameters
    patches : sequence of Patch
        The faces of ``parameters.layers``.
    rods_volume : float, mm³
        Plain sum of the rods' volumes, not prolonged (``rods.rod_volumes``).
    progress : Progress

    Raises
    ------
    MeshError
        If the envelope or a rod is not closed, or nothing is left of the envelope.
    DependencyError
        If the mesh engine is named and manifold3d is not installed.
    ParameterError
        If the engine cannot make what is asked for.

    Notes
    -----
    A failed check raises nothing: the caller shows it, and must not export as if it held.
    """
    require_closed(envelope, "the envelope")
    if mesh_volume(envelope) <= 0:
        raise MeshError(
            f"the envelope must enclose a volume above 0, got {mesh_volume(envelope):g} mm3: it is inside out"
        )
    chosen = choose(parameters, rod_vertices, rod_triangles, *bounds(envelope))
    layered = layered_body(envelope, patches, parameters.layers)
    cut = _cut(chosen, rod_vertices, rod_triangles, layered, parameters.cell, part(progress, 0, 0.85))
    progress(0.85, 1.0, "pieces")
    solid, holes = (pieces(cut.pop(0)) for _ in range(2))  # of millions of triangles only one copy
    union = float(sum(hole.volume for hole in holes.found))
    # closed layers are there to close: what they seal off is what was asked for
    parts = separate(solid, holes, parameters.keep_loose, parameters.keep_loose or bool(layered.closed_by))
    progress(0.9, 1.0, "volumes by rays")
    rays = _ray_volume(rod_vertices, rod_triangles, layered, chosen.engine)
    progress(0.95, 1.0, "checks")
    bodies = Bodies(
        engine=chosen.engine,
        reason=chosen.reason,
        envelope_volume=mesh_volume(envelope),
        added_volume=layered.added,
        parts=parts,
        kept=parameters.keep_loose,
        union_volume=union,
        rods_volume=rods_volume,
        checks=(),
        notes=(layered.note,) if layered.note else (),
    )
    return _checked(bodies, rays)


def wireframe_bodies(
    wireframe: Wireframe,
    rods: Rods,
    couplings: Sequence[Coupling],
    envelope: Mesh,
    parameters: ScaffoldParameters,
    patches: Sequence[Patch] = (),
    progress: Progress = silent,
) -> Bodies:
    """Return scaffold and channels of a wireframe's ``rods`` (``wireframe.skin``), as ``scaffold_bodies`` does.

    Rods are prolonged beyond the envelope first, and through outward layers that the channels go through.
    """
    reach = reaches(wireframe, couplings, parameters.layers, prolongation(rods))
    vertices, triangles = rod_mesh(rods, reach)
    plain_sum = float(rod_volumes(rods).sum())
    return scaffold_bodies(vertices, triangles, envelope, parameters, patches, plain_sum, progress)


def prolongation(rods: Rods) -> float:
    """Return how far rods are prolonged so that no cap lies in or under a face, mm: a third of the widest end's radius.

    A cap of radius r on the tangent plane of a hollow face of radius R lies r^2 / (2 R) under it: enough for R > 1.5 r.
    """
    ends = rods.rings[:, [0, -1]] - rods.stations.centres[:, [0, -1], None]
    return float(np.linalg.norm(ends, axis=-1).max(initial=0.0)) / 3


def _cut(
    chosen: Estimate, vertices: np.ndarray, triangles: np.ndarray, layered: LayeredBody, cell: float, progress: Progress
) -> List[Mesh]:
    """The body outside and inside the rods."""
    if chosen.engine == "mesh":
        cut = cut_bodies(vertices, triangles, layered.body, layered.closed_by, progress)
        return [cut.scaffold, cut.channels]
    corners, body = vertices[:, triangles].reshape(-1, 3, 3), layered.body
    if manifold_available() and (layered.closed_by or not fills_its_box(body, cell)):
        # One Boolean of two meshes keeps the rims exact; of a box cells keep them by themselves.
        low, high = bounds(body)
        rods = field_union(corners, low - cell, high + cell, cell, part(progress, 0.0, 0.8))
        cut = split_body(body, rods, layered.closed_by, part(progress, 0.8, 1.0))
        return [cut.scaffold, cut.channels]
    meshes = field_bodies(corners, body, cell, progress).meshes
    return [meshes["scaffold"], meshes["channels"]]


def _ray_volume(vertices: np.ndarray, triangles: np.ndarray, layered: LayeredBody, engine: str) -> RayVolume:
    """What the rods fill of the body, closed layers excepted, by rays through the rods' own triangles."""
    corners, body = np.asarray(vertices)[:, triangles].reshape(-1, 3, 3), layered.body
    low, high = bounds(body)
    axis = int(np.argmin(high - low))
    cells = int(np.clip(RAYS_PER_ROOT * math.sqrt(len(vertices)), *RAYS)) if engine == "mesh" else FIELD_RAYS
    filled = union_volume(corners, low, high, cells, axis, body.corners)
    if not layered.closed_by:
        return filled
    layer = combine([combine(layered.closed_by, "union"), body], "intersection")
    closed = union_volume(corners, low, high, cells, axis, layer.corners)
    return RayVolume(filled.volume - closed.volume, math.hypot(filled.error, closed.error))


def _volume_check(name: str, value: float, second: float, whole: float, tolerance: float) -> Check:
    return Check(name, value, second, abs(value - second) / whole, tolerance)


def _count_check(name: str, value: int, second: int) -> Check:
    return Check(name, float(value), float(second), float(abs(value - second)), 0.0)


def _checked(bodies: Bodies, rays: RayVolume) -> Bodies:
    parts, whole = bodies.parts, bodies.body_volume
    sum_volume = parts.scaffold_volume + parts.channel_volume + (0.0 if bodies.kept else bodies.loose_volume)
    cells = FIELD if bodies.engine == "field" else BALANCE  # cells blunt the edges of all envelopes but boxes
    balance = "scaffold + channels = envelope" if bodies.kept else "scaffold + channels + loose pieces = envelope"
    checks = [
        _volume_check(f"{balance}, mm3", sum_volume, whole, whole, cells),
        _volume_check(
            "channels by triangles and by rays, mm3",
            bodies.union_volume,
            rays.volume,
            whole,
            cells + RAY_ERRORS * rays.error / whole,
        ),
        _count_check("cavities seen from inside and from outside", parts.cavities, parts.matched),
    ]
    for name, mesh in (("scaffold", parts.scaffold), ("channels", parts.channels)):
        faults = 0 if not len(mesh.triangles) or is_closed(mesh) else max(sum(edge_faults(mesh)), 1)
        checks.append(_count_check(f"watertight {name}: faulty edges", faults, 0))
    in_file = mesh_volume(printable(parts.scaffold))
    checks.append(
        _volume_check("scaffold in double and in single precision, mm3", parts.scaffold_volume, in_file, whole, BALANCE)
    )
    bodies = replace(bodies, checks=tuple(checks))
    return replace(bodies, notes=bodies.notes + tuple(_notes(bodies)))


def _notes(bodies: Bodies) -> Iterator[str]:
    parts, whole = bodies.parts, bodies.body_volume
    did = "kept" if bodies.kept else "taken away", "filled" if parts.filled else "kept"
    if parts.loose:
        yield (
            f"{_counted(len(parts.loose), 'loose piece')}, cut off all round, {bodies.loose_volume:.4g} mm3 together, "
            f"the largest {parts.loose_volumes[0]:.4g} mm3: {did[0]}"
        )
        if bodies.loose_volume > NOTED * whole:
            share = f"{bodies.loose_volume / whole:.1%} of the envelope"
            yield f"loose pieces are {share}: the channels cut the scaffold apart"
    if parts.void_volumes:
        volume = f"{bodies.void_volume:.4g} mm3 together"
        yield f"{_counted(len(parts.void_volumes), 'void')} that no opening reaches, {volume}: {did[1]}"
        if bodies.void_volume > NOTED * whole:
            share = f"{bodies.void_volume / whole:.1%} of the envelope"
            yield f"closed voids are {share}: many channels have no way out"
    if parts.slivers:
        yield f"{_counted(parts.slivers, 'shell')} below {SLIVER:g} mm3 left out"
    if bodies.engine == "field" and not bodies.ok:
        yield "the cells of the field engine are too coarse for these rods: make them smaller, or take the mesh engine"


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
