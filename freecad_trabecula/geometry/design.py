# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a job to its envelope, sites and wireframe, with the kernel but without a document."""

from __future__ import annotations

from dataclasses import replace
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

import FreeCAD
import numpy as np
import Part

from ..core.assembly import make_wireframe
from ..core.job import Job, check_rods
from ..core.laws import Region
from ..core.parameters import PrismParameters, SiteEdit
from ..core.progress import Progress, part, silent
from ..core.sites import Sites, edit_sites, overlapping_pairs, prism_sites
from ..core.wireframe import Contains, Wireframe, WireframeParameters
from ..errors import EnvelopeError, KernelError, ParameterError
from .face_sites import face_sites, pick_site
from .vectors import point_array, vectors


class SitedFace(NamedTuple):
    """A face of the envelope with its sites, before changes by hand."""

    sites: Sites
    face: Part.Face


class Design(NamedTuple):
    """What comes before rods: envelope, its region, faces with sites by label, wireframe."""

    envelope: Part.Shape
    region: Region
    faces: Dict[str, SitedFace]
    wireframe: Wireframe


# -------------------------------------------------------------------------------------------------------- the parts


def prism_solid(prism: PrismParameters, placement: Optional[FreeCAD.Placement] = None) -> Part.Shape:
    """Return a prism as a solid, its faces in the order of ``PRISM_FACES``."""
    try:
        solid = Part.makeBox(prism.l, prism.w, prism.h)
    except (Part.OCCError, ValueError) as error:
        raise KernelError(f"the kernel made no prism of {prism.l:g} x {prism.w:g} x {prism.h:g} mm: {error}") from error
    if placement is not None:
        solid.Placement = placement
    return solid


def placed_prism_sites(prism: PrismParameters, solid: Part.Shape) -> Dict[str, SitedFace]:
    """Return the sites of a prism (Eq. 2.1) where its solid is placed, by face name."""
    turn, shift = _motion(solid.Placement)
    faces = {}
    for name, sites in prism_sites(prism).items():
        points = sites.points @ turn.T + shift
        placed = replace(sites, points=points, u=sites.u @ turn.T, normals=sites.normals @ turn.T)
        faces[name] = SitedFace(placed, face_named(solid, name, "the prism"))
    return faces


def _motion(placement: FreeCAD.Placement) -> Tuple[np.ndarray, np.ndarray]:
    """Rotation matrix (3, 3) and shift (3,), mm."""
    a = np.array(placement.toMatrix().A, float).reshape(4, 4)
    return a[:3, :3], a[:3, 3]


def face_named(shape: Part.Shape, name: str, owner: str = "the envelope") -> Part.Face:
    """Return a face of a shape by FreeCAD's name of it.

    Raises
    ------
    EnvelopeError
        If there is no such face.
    """
    count = len(shape.Faces)
    number = name[4:] if name.startswith("Face") else ""
    if not number.isdigit() or not 1 <= int(number) <= count:
        raise EnvelopeError(f"a face must be one of Face1..Face{count} of {owner}, got {name!r}")
    return shape.Faces[int(number) - 1]


def faces_with_edits(faces: Dict[str, SitedFace], edits: Sequence[SiteEdit]) -> Dict[str, Sites]:
    """Return the sites of all faces, by label, with the changes made by hand.

    Raises
    ------
    ParameterError
        If an edit names an unknown face or site, or its point is off the face.
    """
    placed: Dict[str, Dict[str, tuple]] = {label: {} for label in faces}
    for edit in edits:
        label = edit.site.split(".")[0]
        if label not in faces:
            raise ParameterError(
                f"a change by hand must name a site of one of the faces {', '.join(faces)}, got {edit.site!r}"
            )
        if edit.action in ("move", "add"):
            sites, face = faces[label]
            first = sites.u[0] if len(sites) else None
            placed[label][edit.site] = pick_site(face, edit.point, first)
    return {label: edit_sites(one.sites, edits, placed[label]) for label, one in faces.items()}


# ------------------------------------------------------------------------------------------------------- the design


def design_faces(job: Job, envelope: Part.Shape, progress: Progress = silent) -> Dict[str, SitedFace]:
    """Return the faces of a job's envelope with their sites, by label.

    Raises
    ------
    EnvelopeError
        If a face is not there.
    ParameterError
        As ``face_sites`` says.
    """
    if not job.faces:
        return placed_prism_sites(job.prism, envelope)
    found = {}
    for done, one in enumerate(job.faces):
        progress(done, len(job.faces), f"sites on {one.label}")
        face = face_named(envelope, one.face)
        found[one.label] = SitedFace(face_sites(face, one.label, one), face)
    return found


def design_wireframe(
    parameters: WireframeParameters,
    faces: Dict[str, SitedFace],
    region: Region,
    contains: Optional[Contains],
    progress: Progress = silent,
) -> Wireframe:
    """Return the mended wireframe of faces with sites.

    Raises
    ------
    ParameterError
        If a coupling or a change by hand cannot be made, or the rods are too many.
    """
    sites = faces_with_edits(faces, parameters.edits)
    most = [min(int(sites[c.first].on.sum()), int(sites[c.second].on.sum())) for c in parameters.couplings
            if c.on and c.first in sites and c.second in sites]  # fmt: skip
    check_rods(sum(most))
    return make_wireframe(parameters, sites, region, contains, progress)


def make_design(job: Job, envelope: Part.Shape, progress: Progress = silent) -> Design:
    """Return the design of a job in an envelope that was made or loaded before."""
    faces = design_faces(job, envelope, part(progress, 0.0, 0.5))
    region = region_of(envelope)
    wireframe = design_wireframe(job.wireframe, faces, region, container(envelope), part(progress, 0.5, 1.0))
    return Design(envelope, region, faces, wireframe)


def region_of(shape: Part.Shape) -> Region:
    """Return the box and the centre of a solid."""
    box, centre = shape.BoundBox, shape.CenterOfMass
    return Region((box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax), tuple(centre))


def container(shape: Part.Shape) -> Contains:
    """Return the function that tells which points (P, 3), mm, lie in a solid."""
    box = _as_box(shape)
    if box is not None:
        return box
    raise NotImplementedError


_ROUNDING = 1e-9  # mm; points of a prism's own faces are inside


def _as_box(shape: Part.Shape) -> Optional[Contains]:
    """The test of a rectangular solid, if the shape is one: six plane faces, all right angles."""
    faces = shape.Faces
    if len(faces) != 6 or len(shape.Vertexes) != 8 or not all(isinstance(f.Surface, Part.Plane) for f in faces):
        return None
    normals = point_array([f.Surface.Axis for f in faces])
    cosines = np.abs(normals @ normals.T)
    if not ((cosines < 1e-9) | (cosines > 1 - 1e-9)).all():
        return None
    corners = point_array([f.Vertexes[0].Point for f in faces])
    normals *= np.sign((normals * (corners - np.array(shape.CenterOfMass))).sum(1))[:, None]
    heights = (normals * corners).sum(1)
    return lambda points: (points @ normals.T <= heights + _ROUNDING).all(1)


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


_BORDER_DEFLECTION = 0.01  # mm, far below any pore


def sites_shape(faces: Dict[str, SitedFace]) -> Part.Shape:
    """Return the sites of faces as one compound of vertices."""
    points = [point for one in faces.values() for point in vectors(one.sites.points)]
    return Part.makeCompound([Part.Vertex(point) for point in points])


def wires_shape(wireframe: Wireframe) -> Part.Shape:
    """Return the paths of a wireframe."""
    wires = []
    for path in wireframe.paths:
        edges = []
        for piece in path:
            curve = Part.BezierCurve()
            curve.setPoles(vectors(piece))
            edges.append(curve.toShape())
        wires.append(Part.Wire(edges))
    return Part.makeCompound(wires)
