# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a job to its envelope, sites and wireframe, with the kernel but without a document."""

from __future__ import annotations

from dataclasses import replace
from typing import Dict, List, NamedTuple, Sequence, Tuple

import FreeCAD
import numpy as np
import Part

from ..core.assembly import draft_wireframe
from ..core.history import History, Mended
from ..core.job import Job, check_rods
from ..core.parameters import PrismParameters, SiteEdit
from ..core.progress import Progress, part, silent
from ..core.sites import Sites, edit_sites, overlapping_pairs, prism_sites
from ..core.wireframe import Wireframe, WireframeParameters
from ..errors import ParameterError
from .envelopes import Envelope, box_envelope, load_envelope
from .face_sites import face_sites, pick_site
from .vectors import point_array, vectors

_BORDER_DEFLECTION = 0.01  # mm, far below any pore


class SitedFace(NamedTuple):
    """A face of the envelope with its sites, before changes by hand."""

    sites: Sites
    face: Part.Face


class Design(NamedTuple):
    """What comes before rods: envelope, faces with sites by label, wireframe."""

    envelope: Envelope
    faces: Dict[str, SitedFace]
    wireframe: Wireframe


# -------------------------------------------------------------------------------------------------------- the parts


def job_envelope(job: Job) -> Envelope:
    """Return the envelope of a job: its prism, or the solid in its file.

    Raises
    ------
    EnvelopeError, ExportError
        If the file holds none, or cannot be read.
    """
    if job.prism is not None:
        return box_envelope(job.prism.l, job.prism.w, job.prism.h)
    return load_envelope(job.envelope, job.solid)


def placed_prism_sites(prism: PrismParameters, envelope: Envelope) -> Dict[str, SitedFace]:
    """Return the sites of a prism (Eq. 2.1) where its solid is placed, by face name."""
    turn, shift = _motion(envelope.solid.Placement)
    faces = {}
    for name, sites in prism_sites(prism).items():
        points = sites.points @ turn.T + shift
        placed = replace(sites, points=points, u=sites.u @ turn.T, normals=sites.normals @ turn.T)
        faces[name] = SitedFace(placed, envelope.face(name))
    return faces


def _motion(placement: FreeCAD.Placement) -> Tuple[np.ndarray, np.ndarray]:
    """Rotation matrix (3, 3) and shift (3,), mm."""
    a = np.array(placement.toMatrix().A, float).reshape(4, 4)
    return a[:3, :3], a[:3, 3]


def job_faces(job: Job, envelope: Envelope, progress: Progress = silent) -> Dict[str, SitedFace]:
    """Return the faces of a job's envelope with their sites, by label.

    Raises
    ------
    EnvelopeError
        If a face is not there.
    ParameterError
        As ``face_sites`` says.
    """
    if not job.faces and job.prism is not None:
        return placed_prism_sites(job.prism, envelope)
    found = {}
    for done, one in enumerate(job.faces):
        progress(done, len(job.faces), f"sites on {one.label}")
        face = envelope.face(one.face)
        found[one.label] = SitedFace(face_sites(face, one.label, one), face)
    return found


def edited(faces: Dict[str, SitedFace], edits: Sequence[SiteEdit]) -> Dict[str, Sites]:
    """Return the sites of all faces, by label, with the changes made by hand.

    Raises
    ------
    ParameterError
        If an edit names an unknown face or site, or its point is off the face; all such edits are named.
    """
    placed: Dict[str, Dict[str, tuple]] = {label: {} for label in faces}
    known = {label: list(one.sites.names) for label, one in faces.items()}
    faults = []
    for edit in edits:
        label = edit.site.split(".")[0]
        try:
            if label not in faces:
                raise ParameterError(f"it must name a site of one of the faces {', '.join(faces)}")
            sites, face = faces[label]
            if edit.action == "add":
                known[label].append(f"{label}.hand.{sum('.hand.' in name for name in known[label]) + 1}")
            elif edit.site not in known[label]:
                raise ParameterError(f"it must name a site of face {label}, which has {len(sites)} sites")
            if edit.action in ("move", "add"):
                first = sites.u[0] if len(sites) else None
                placed[label][edit.site] = pick_site(face, edit.point, first)
        except ParameterError as error:
            faults.append(f"{edit.site} ({edit.action}): {error}")
    if faults:
        what = "a change by hand does not" if len(faults) == 1 else f"{len(faults)} changes by hand do not"
        raise ParameterError(f"{what} fit the design: {'; '.join(faults)}")
    return {label: edit_sites(one.sites, edits, placed[label]) for label, one in faces.items()}


# ------------------------------------------------------------------------------------------------------- the design


def design_draft(
    parameters: WireframeParameters, envelope: Envelope, faces: Dict[str, SitedFace], progress: Progress = silent
) -> Wireframe:
    """Return the wireframe of an envelope whose faces have sites, before faulty rods are mended.

    Arguments and errors are those of ``design_wireframe``.
    """
    sites = edited(faces, parameters.edits)
    on = {label: int(one.on.sum()) for label, one in sites.items()}
    check_rods(sum(min(on.get(c.first, 0), on.get(c.second, 0)) for c in parameters.couplings if c.on))
    return draft_wireframe(parameters, sites, envelope.region, progress)


def design_wireframe(
    parameters: WireframeParameters,
    envelope: Envelope,
    faces: Dict[str, SitedFace],
    history: History,
    mark: str,
    progress: Progress = silent,
) -> Mended:
    """Return the mended wireframe of an envelope whose faces have sites.

    Parameters
    ----------
    parameters : WireframeParameters
    envelope : Envelope
    faces : dict of SitedFace, by label
    history : History
        Rods that were mended before.
    mark : str
        Fingerprint of the envelope: tells it from others in the history.
    progress : callable

    Raises
    ------
    ParameterError
        If a coupling or a change by hand cannot be made, or the rods are too many.
    """
    raw = design_draft(parameters, envelope, faces, part(progress, 0.0, 0.1))
    progress(0.1, 1, "faults")
    mended = history.mend(raw, parameters, envelope.region, envelope.contains, mark, part(progress, 0.1, 1.0))
    progress(1, 1, "wireframe")
    return mended


def make_design(job: Job, progress: Progress = silent) -> Design:
    """Return the design of a job.

    Raises
    ------
    TrabeculaError
        If a step fails.

    Examples
    --------
    >>> from freecad_trabecula.core.presets import preset
    >>> len(make_design(preset("case6")).wireframe)
    147
    """
    progress(0.0, 1.0, "envelope")
    envelope = job_envelope(job)
    faces = job_faces(job, envelope, part(progress, 0.2, 0.6))
    mended = design_wireframe(job.wireframe, envelope, faces, History(), "", part(progress, 0.6, 1.0))
    return Design(envelope, faces, mended.wireframe)


# ----------------------------------------------------------------------------------------------------- the warnings


def pore_warnings(wireframe: Wireframe, faces: Dict[str, SitedFace]) -> List[str]:
    """Return a sentence for each face whose pores overlap or reach over its border."""
    found = []
    for label, sites in wireframe.sites.items():
        points, sizes = sites.points[sites.on], wireframe.pores[label].size[sites.on]
        pairs = len(overlapping_pairs(points, sizes))
        if pairs:
            found.append(f"{pairs} pairs of pores overlap on face {label}: pores must be smaller than their spacing")
        over = int((border_distances(faces[label].face, points) < sizes / 2).sum())
        if over:
            found.append(
                f"{over} pores reach over the border of face {label}: half their size must not exceed "
                "the distance from it"
            )
    return found


def border_distances(face: Part.Face, points: np.ndarray) -> np.ndarray:
    """Return the distances (P,), mm, of points (P, 3) of a face from its border, the border taken as a polygon.

    A face without border (a sphere) gives infinity.
    """
    least = np.full(len(points), np.inf)
    for edge in face.Edges:
        if edge.isSeam(face) or edge.Degenerated:
            continue
        polygon = point_array(edge.discretize(Deflection=_BORDER_DEFLECTION))
        start, along = polygon[:-1], np.diff(polygon, axis=0)
        square = (along**2).sum(1).clip(1e-30)
        for first in range(0, len(points), 1000):  # blocks: memory stays bounded for large faces
            some = points[first : first + 1000]
            off = some[:, None] - start
            share = ((off * along).sum(2) / square).clip(0, 1)[..., None]
            nearest = np.linalg.norm(off - share * along, axis=2).min(1)
            least[first : first + 1000] = np.minimum(least[first : first + 1000], nearest)
    return least


# ------------------------------------------------------------------------------------------------------- to be seen


def sites_shape(faces: Dict[str, SitedFace]) -> Part.Shape:
    """Return the sites of faces as one compound of vertices."""
    points = [point for one in faces.values() for point in vectors(one.sites.points)]
    return Part.makeCompound([Part.Vertex(point) for point in points])
