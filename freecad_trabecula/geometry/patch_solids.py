# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of patches: what rods leave of a polyhedron, every face, edge and vertex written at once, none intersected."""

from __future__ import annotations

from typing import Callable, Dict, List, NamedTuple, Optional, Sequence, Set, Tuple

import numpy as np
import Part

from ..core.guides import Guide
from ..core.meshes import Mesh
from ..core.patchwork import LabelledMesh, Patch, Patchwork, patchwork
from ..core.progress import Progress, part, silent
from ..core.seam_curves import SeamCurve
from ..core.seam_settling import Settling
from ..core.seams import Nodes, Surfaces, kind_of
from ..core.strips import Strips, ruled
from ..errors import KernelError, MeshError
from .brep_text import TOLERANCE, BrepText, Use, flat, read_brep
from .rod_solids import spline_poles

_ATTEMPTS = 4  # times that the guide is made finer where surfaces nearly touch
_LOWERINGS = 3  # times that seams of faces which the kernel does not take go back to the triangles'
_DUST = 1e-9  # mm3; pieces that are smaller are none
_PLANE = 9  # digits by which planes are told apart
_SPARE = 1.2  # a tolerance is this many times the distance that was measured between points


_NONE: Tuple[None, Set[int]] = (None, set())


class _Edge(NamedTuple):
    """An edge in the text: its number, and whether it runs against its seam."""

    number: int
    back: bool


class _Writer:
    """Writes the faces of one patchwork."""

    def __init__(self, surfaces: Surfaces, work: Patchwork, nodes: Nodes, curves: Dict[int, SeamCurve]) -> None:
        self.surfaces, self.work, self.nodes, self.curves = surfaces, work, nodes, curves
        self.text = BrepText()
        self._poles = spline_poles(surfaces.strips.patches)
        self._ruled = ruled(surfaces.strips)
        self._surfaces: Dict[int, int] = {}
        self._lines: Dict[Tuple[object, ...], int] = {}
        self._tolerances = self._vertex_tolerances()
        self._vertices: Dict[int, int] = {}
        self._edges: Dict[int, _Edge] = {}

    def _vertex_tolerances(self) -> Dict[int, float]:
        """A vertex is as wide as its surfaces are away, and no narrower than its edges."""
        wide = {vertex: max(TOLERANCE, _SPARE * d) for vertex, d in self.nodes.distances.items()}
        for number, curve in self.curves.items():
            for vertex in self.work.seams[number].vertices[[0, -1]].tolist():
                wide[vertex] = max(wide[vertex], _SPARE * curve.distance)
        return wide

    def solid(self, shells: Sequence[Sequence[Patch]]) -> Part.Shape:
        """Return one solid of the given closed shells."""
        faces: List[List[Use]] = [[self._face(patch) for patch in shell] for shell in shells]
        return read_brep(self.text.text(self.text.add_solid(faces)))

    def _face(self, patch: Patch) -> Use:
        wires = []
        for border in patch.borders:
            uses = []
            for seam, back in border:
                edge = self._edge(seam)
                uses.append((edge.number, edge.back != back))
            if not patch.forward:  # a face's wires run about its surface's own normal
                uses = [(number, not back) for number, back in reversed(uses)]
            wires.append(self.text.add_wire(uses))
        return self.text.add_face(self._surface(patch.surface), wires), not patch.forward

    def _surface(self, surface: int) -> int:
        if surface not in self._surfaces:
            rod, strip = self.surfaces.rod(surface), self.surfaces.strip(surface)
            if strip < 0:
                self._surfaces[surface] = self.text.add_plane(*self.surfaces.plane(surface).tolist())
            else:
                poles, knots = self._poles[rod, strip], self.surfaces.strips.knots[rod]
                if self._ruled[rod]:
                    self._surfaces[surface] = self.text.add_strip(flat(poles[:, [0, -1]]), (0, 1), 1)
                else:
                    self._surfaces[surface] = self.text.add_strip(flat(poles), flat(knots))
        return self._surfaces[surface]

    def _vertex(self, vertex: int) -> int:
        if vertex not in self._vertices:
            point = self.nodes.points[vertex].tolist()
            self._vertices[vertex] = self.text.add_vertex(point, self._tolerances[vertex])
        return self._vertices[vertex]

    def _edge(self, number: int) -> _Edge:
        if number not in self._edges:
            kind = kind_of(self.surfaces, self.work.seams[number])
            self._edges[number] = getattr(self, f"_{kind}")(number)
        return self._edges[number]

    def _free(self, number: int) -> _Edge:
        seam, curve = self.work.seams[number], self.curves[number]
        knots = flat(curve.knots)
        degree = 3 if len(curve.slopes) else 1
        line = self.text.add_spline(flat(_poles(curve.knots, curve.points, curve.slopes)), knots, degree)
        images = []
        for surface, uv, change in zip(seam.surfaces, curve.images, curve.image_slopes):
            if len(uv):
                image = self.text.add_spline_2d(flat(_poles(curve.knots, uv, change)), knots, degree)
                images.append((image, self._surface(surface)))
        ends = (self._vertex(int(seam.vertices[0])), self._vertex(int(seam.vertices[-1])))
        tolerance = max(TOLERANCE, _SPARE * curve.distance)
        return _Edge(self.text.add_edge(line, (knots[0], knots[-1]), images, ends, tolerance), False)

    def _line(self, number: int) -> _Edge:
        first, last = (int(v) for v in self.work.seams[number].vertices[[0, -1]])
        p, q = self.nodes.points[first], self.nodes.points[last]
        length = float(np.linalg.norm(q - p))
        line = self.text.add_line(p.tolist(), ((q - p) / length).tolist())
        return _Edge(self.text.add_edge(line, (0.0, length), [], (self._vertex(first), self._vertex(last))), False)

    def _border(self, number: int) -> _Edge:
        """A stretch of the line between two strips of a rod."""
        a, b = self.work.seams[number].surfaces
        corners = self.surfaces.corners
        before, after = (a, b) if self.surfaces.strip(b) == (self.surfaces.strip(a) + 1) % corners else (b, a)
        rod, strip = self.surfaces.rod(after), self.surfaces.strip(after)
        if self._ruled[rod]:
            poles, knots, degree = self._poles[rod, strip, 0][[0, -1]], (0, 1), 1
        else:
            poles, knots, degree = self._poles[rod, strip, 0], flat(self.surfaces.strips.knots[rod]), 3
        line = self._shared(("border", after), lambda: self.text.add_spline(flat(poles), knots, degree))
        images = [(before, (1.0, 0.0)), (after, (0.0, 0.0))]
        return self._stretch(number, line, images, (0.0, 1.0), 1)

    def _ring(self, number: int) -> _Edge:
        """A stretch of the section at a rod's end."""
        a, b = self.work.seams[number].surfaces
        strip, cap = (a, b) if self.surfaces.strip(a) >= 0 else (b, a)
        end = self.surfaces.cap(cap)
        poles = self._poles[self.surfaces.rod(strip), self.surfaces.strip(strip)][:, -end]
        line = self._shared(("ring", strip, end), lambda: self.text.add_spline(flat(poles), (0, 1)))
        return self._stretch(number, line, [(strip, (0.0, float(end)))], (1.0, 0.0), 0)

    def _stretch(
        self,
        number: int,
        line: int,
        images: Sequence[Tuple[int, Tuple[float, float]]],
        direction: Tuple[float, float],
        running: int,
    ) -> _Edge:
        """An edge along a line of constant u or v; parameter ``running`` of the strips is the line's."""
        first, last = (int(v) for v in self.work.seams[number].vertices[[0, -1]])
        strip = images[-1][0]
        start, end = (float(self.nodes.uv[v, strip][running]) for v in (first, last))
        if start > end:
            first, last, start, end, back = last, first, end, start, True
        else:
            back = False
        on = [
            (self._shared(("image", point, direction), lambda p=point: self.text.add_line_2d(p, direction)), s)
            for s, point in ((self._surface(surface), point) for surface, point in images)
        ]
        return _Edge(self.text.add_edge(line, (start, end), on, (self._vertex(first), self._vertex(last))), back)

    def _shared(self, key: Tuple[object, ...], make: Callable[[], int]) -> int:
        if key not in self._lines:
            self._lines[key] = make()
        return self._lines[key]


def _poles(knots: np.ndarray, values: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Poles (2N, d) of the C1 cubic with these values and slopes (N, d) at knots (N,); without slopes a polygon's."""
    if not len(slopes):
        return values
    third = np.diff(knots)[:, None] / 3
    inner = np.stack([values[:-1] + slopes[:-1] * third, values[1:] - slopes[1:] * third], 1)
    return np.concatenate([values[:1], inner.reshape(-1, values.shape[1]), values[-1:]])


# ------------------------------------------------------------------------------------------------------ the whole way


class PatchSolids(NamedTuple):
    """A body made of patches.

    Attributes
    ----------
    solids : list of Part.Shape
        Valid solids, the largest first.
    volume : float, mm3
        Of all its pieces; pieces that were not made count by their triangles.
    exact, rough : int
        Seams that lie on their surfaces within 1e-5 mm, and those that keep the triangles' lines.
    tolerance : float, mm
        The widest of an edge.
    """

    solids: List[Part.Shape]
    volume: float
    exact: int
    rough: int
    tolerance: float


def planes_of(mesh: Mesh) -> Tuple[np.ndarray, np.ndarray]:
    """Return the planes (P, 4, 3) of a polyhedron's triangles (point, normal, two axes), and each triangle's plane."""
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    offset = (normals * a).sum(1, keepdims=True)
    _, first, plane = np.unique(
        np.round(np.concatenate([normals, offset], 1), _PLANE), axis=0, return_index=True, return_inverse=True
    )
    planes = []
    for k in first:
        across = np.cross(normals[k], np.eye(3)[np.abs(normals[k]).argmin()])
        across /= np.linalg.norm(across)
        planes.append([a[k], normals[k], across, np.cross(normals[k], across)])
    return np.array(planes), plane.ravel()


def patch_solids(strips: Strips, envelope: Mesh, all_pieces: bool = False, progress: Progress = silent) -> PatchSolids:
    """Return what rods leave of a polyhedron, as solids whose faces are pieces of the rods' strips and of its planes.

    Parameters
    ----------
    strips : Strips
        The rods, prolonged beyond the envelope.
    envelope : Mesh
        Of a polyhedron.
    all_pieces : bool
        Whether to make loose pieces too.
    progress : callable

    Raises
    ------
    KernelError
        If the kernel does not take the solids as valid, however fine the triangles are that tell what meets what.
    DependencyError, MeshError
        As ``booleans.unite`` does.
    """
    planes, plane = planes_of(envelope)
    surfaces = Surfaces(strips, planes)
    guide = Guide(surfaces, envelope, surfaces.first_plane + plane)
    for attempt in range(_ATTEMPTS):
        own = part(progress, attempt / _ATTEMPTS, (attempt + 1) / _ATTEMPTS)
        mesh = guide.labelled(part(own, 0.0, 0.5))
        own(0.5, 1.0, "what meets what")
        work = patchwork(mesh)
        own(0.55, 1.0, "seams of channels")
        settling = Settling(surfaces, mesh, work)
        settling.settle(part(own, 0.7, 0.8))
        made, bad = _NONE
        if attempt or not settling.lowered:
            made, bad = _settled(settling, mesh, all_pieces, part(own, 0.8, 1.0))
        if made is not None:
            return made
        guide.refine(settling.doubtful(bad))
    raise KernelError(
        f"a solid's faces must be bounded by seams that do not cross, got {len(settling.lowered)} of "
        f"{len(work.seams)} seams of surfaces that nearly touch"
    )


def _settled(
    settling: Settling, mesh: LabelledMesh, all_pieces: bool, progress: Progress
) -> Tuple[Optional[PatchSolids], Set[int]]:
    """The solids, seams lowered until the kernel takes their faces; or None and the seams of faces it does not."""
    for step in range(_LOWERINGS):
        settling.settle(progress)
        progress(step + 0.5, _LOWERINGS, "solid of patches")
        made, bad = _made(settling, mesh, all_pieces)
        if made is not None or not settling.lower(bad):
            break
    return made, bad


def _made(settling: Settling, mesh: LabelledMesh, all_pieces: bool) -> Tuple[Optional[PatchSolids], Set[int]]:
    """The solids, or None and the seams of the faces that the kernel does not take."""
    work, lines = settling.work, settling.lines()
    writer = _Writer(settling.surfaces, work, *lines)
    volumes = work.shell_volumes
    if (volumes < -_DUST).any():
        raise MeshError(f"a solid of patches has no closed voids, got {(volumes < -_DUST).sum()}")
    order = [k for k in np.argsort(-volumes).tolist() if volumes[k] > _DUST]
    kept = order if all_pieces else order[:1]
    solids, bad = [], set()
    for shell in kept:
        patches = [patch for patch in work.patches if patch.shell == shell]
        solid = writer.solid([patches])
        if solid.isValid() and len(solid.Faces) == len(patches):
            solids.append(solid.Solids[0])
            continue
        wrong = [p for p, face in zip(patches, solid.Faces) if not face.isValid()] or patches
        bad |= {number for patch in wrong for border in patch.borders for number, _ in border}
    if bad:
        return None, bad
    volume = sum(s.Volume for s in solids) + float(volumes[[k for k in order if k not in kept]].sum())
    widest = max((curve.distance for curve in lines.curves.values()), default=0.0)
    rough = len(settling.lowered)
    return PatchSolids(solids, volume, len(work.seams) - rough, rough, widest), set()
