# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a solid's faces between shared borders, by points and derivatives of their surfaces alone.

The kernels' meshers differ from version to version; their points and derivatives agree to rounding. Flat faces are
triangulated between their borders; faces that fill a rectangle of their parameters (closed or with poles, too) get a
grid; other faces points inside their border and a Delaunay triangulation, in the plane of the parameters, or, where
those have a seam or a pole, in a plane along the face. What does not come out right is refused: the whole body is then
left to the kernel's mesher.
"""

from __future__ import annotations

from typing import List, NamedTuple, Optional, Tuple

import numpy as np
import Part

from ..core import meshes
from ..core.face_meshes import (
    Bends,
    Side,
    even_steps,
    facing,
    four_sided,
    grid_densities,
    reached,
    sagittas,
    spread,
)
from ..core.plane_triangles import distances, inside, triangulate
from ..errors import KernelError
from .border_samples import BESIDE, SMOOTH, BorderSamples, between_knots
from .vectors import point_array

_FLAT = 1e-7  # mm; distance from a plane within which a surface is one
_ON_SIDE = 1e-6  # of the range of a parameter
_INTERVALS = 24  # over which a surface without knots is looked at, each way
_PER_SPAN = 2  # the same of each span between knots
_SAME_PLACE, _OFF_TIES = 0.1, 0.3217  # of a step, within which one vertex is in one place; no place is on the limit
_MOST = 60_000  # places at which one surface is looked at
_CLEARANCE = 0.5173  # of a step, from the border to the nearest inner point; no grid has a tie there
_SLENDER = 4.0  # greatest ratio of steps of a trimmed face in the plane of its parameters
_LEAST_FACING = 0.3  # cosine of triangle and surface; less is a fold
_TRIMMED = 0.75  # of the deflection, for edges of equal triangles: their middle is 4/3 as far off a sphere
_EXCESS = 4 / 3  # of that; an edge of a few may be so far off
_ROUNDS = 3  # of finer steps inside one face
_PROGRESS = 0.9  # of the distance before; steps that bring less end the rounds
_FINER = (1.0, 0.5)  # parts of the deflection at which borders are sampled until all faces come out right
_HAIR = 1e-4
_LEAST_AREA = 0.95  # of the face; a part that turns away from the plane is missing
_LEAST_RISE = 0.3  # cosine of normals with the plane a face is triangulated in


class _Use(NamedTuple):
    """One use of an edge by a face: numbers (K,) of its vertices and their parameters (K, 2) on the surface."""

    numbers: np.ndarray
    at: np.ndarray
    degenerate: bool
    seam: bool


class _Inner(NamedTuple):
    """Vertices inside a face: their numbers (P,) and parameters (P, 2)."""

    numbers: np.ndarray
    at: np.ndarray


_NO_INNER = _Inner(np.zeros(0, np.int64), np.zeros((0, 2)))
Densities = Tuple[np.ndarray, np.ndarray]


class SolidTriangles(NamedTuple):
    """The triangles of a solid, and the number (T,) of the face that each belongs to."""

    mesh: meshes.Mesh
    faces: np.ndarray


def solid_triangles(solid: Part.Shape, deflection: float, angle: float) -> SolidTriangles:
    """Return the triangles of a solid.

    Parameters
    ----------
    solid : Part.Shape
    deflection : float, mm
        Distance of chords from the surface.
    angle : float
        Greatest angle between neighbouring chords of one face.

    Raises
    ------
    KernelError
        If a face has a border or a surface that these rules do not serve.
    MeshError
        If a border crosses itself.
    DependencyError
        If a face needs scipy, which is not installed.
    """
    for part in _FINER:
        border = BorderSamples(solid, part * deflection, angle)
        try:
            found = [_FaceTriangles(face, border, deflection, angle).triangles for face in solid.Faces]
            break
        except KernelError:
            if part == _FINER[-1]:
                raise
    labels = np.repeat(np.arange(len(found)), [len(t) for t in found])
    triangles = np.concatenate(found)
    used, numbers = np.unique(triangles, return_inverse=True)
    return SolidTriangles(meshes.Mesh(border.vertices[used], numbers.reshape(-1, 3)), labels)


class _FaceTriangles:
    """One face on its way to triangles."""

    def __init__(self, face: Part.Face, border: BorderSamples, deflection: float, angle: float) -> None:
        self._face, self._surface, self._border = face, face.Surface, border
        self._deflection, self._angle = deflection, angle
        self._sign = -1 if face.Orientation == "Reversed" else 1
        self.triangles = self._flat() if self._surface.isPlanar(_FLAT) else self._curved()

    # ------------------------------------------------------------------------------------------------- flat faces

    def _flat(self) -> np.ndarray:
        u0, u1, v0, v1 = self._face.ParameterRange
        normal = self._normals(np.array([[(u0 + u1) / 2, (v0 + v1) / 2]]))[0] * self._sign
        segments = np.concatenate(
            [np.stack([s.numbers[:-1], s.numbers[1:]], 1) for s in map(self._border.of, self._real_edges())]
        )
        return self._in_plane(segments, np.zeros(0, np.int64), normal)

    def _real_edges(self) -> List[Part.Edge]:
        return [e for e in self._face.Edges if not (e.Degenerated or e.isSeam(self._face))]

    def _in_plane(self, segments: np.ndarray, inner: np.ndarray, normal: np.ndarray) -> np.ndarray:
        """Triangles between segments (S, 2) and through inner vertices (P,), seen along ``normal``."""
        used, numbers = np.unique(np.concatenate([segments.ravel(), inner]), return_inverse=True)
        seen = self._border.vertices[used] @ plane_axes(normal).T
        return used[triangulate(seen, numbers[: segments.size].reshape(-1, 2))]

    # ----------------------------------------------------------------------------------------------- curved faces

    def _curved(self) -> np.ndarray:
        uses = self._uses()
        bends, breaks = self._bends()
        sides = self._sides(uses)
        if sides is None and (breaks[0] or breaks[1]):
            raise KernelError("a trimmed face must have no kink inside")
        plane = self._plane(uses) if sides is None else None
        most = self._deflection * (1 if sides is not None else _TRIMMED)
        over_u, over_v = grid_densities(bends, most, self._angle)
        finer, before = 1.0, np.inf
        for _ in range(_ROUNDS):
            densities = over_u * finer, over_v * finer
            if sides is not None:
                triangles, inner = self._grid(sides, bends, densities, breaks)
            elif plane is None:
                triangles, inner = self._in_parameters(uses, bends, even_steps(bends, densities, _SLENDER))
            else:
                triangles, inner = self._along_plane(plane, uses, bends, even_steps(bends, densities, 1.0))
            triangles = triangles[(triangles != np.roll(triangles, 1, 1)).all(1)]
            off = self._distance(triangles, uses, inner)
            if off <= most * (1 + _HAIR) or off > _PROGRESS * before:  # else the border's steps are what counts
                break
            finer, before = finer * float(np.clip(1.05 * np.sqrt(off / most), 1.1, 1.5)), off
        if off > _EXCESS * most:
            raise KernelError(f"triangles must lie within {self._deflection:.3g} mm of a face, got {off:.3g} mm")
        return triangles[:, ::-1] if self._sign < 0 else triangles

    def _distance(self, triangles: np.ndarray, uses: List[_Use], inner: _Inner) -> float:
        """Greatest distance (mm) of edges from the surface, by its normals at the corners.

        Raises
        ------
        KernelError
            If a triangle is turned over.
        """
        numbers = np.concatenate([*(use.numbers for use in uses), inner.numbers])
        used, first = np.unique(numbers, return_index=True)
        at = np.concatenate([*(use.at for use in uses), inner.at])[first]
        normals = self._normals(at)[np.searchsorted(used, triangles)]
        corners = self._border.vertices[triangles]
        if facing(corners, normals).min(initial=1) < _LEAST_FACING:
            raise KernelError("triangles of a face must not fold over")
        smooth = (np.abs(normals).max(2) > 0).all(1)  # a pole has no normal
        return float(sagittas(corners, normals)[smooth].max(initial=0))

    def _uses(self) -> List[_Use]:
        found = []
        for wire in self._face.Wires:
            for edge in wire.OrderedEdges:
                on_surface = self._face.curveOnSurface(edge)
                if on_surface is None:
                    raise KernelError("an edge of a curved face must have its parameters on the surface")
                samples = self._border.of(edge)
                at = [on_surface[0].value(t) for t in samples.at.tolist()]
                parameters = np.array([(p.x, p.y) for p in at])
                found.append(_Use(samples.numbers, parameters, edge.Degenerated, edge.isSeam(self._face)))
        return found

    def _bends(self) -> Tuple[Bends, Tuple[List[float], List[float]]]:
        """How the surface bends all over the face's range, and the parameters of its kinks."""
        u0, u1, v0, v1 = self._face.ParameterRange
        (u, u_breaks), (v, v_breaks) = self._fine("U", u0, u1), self._fine("V", v0, v1)
        if len(u) * len(v) > _MOST:
            raise KernelError(f"a surface must be told by {_MOST} points at most, got {len(u)} x {len(v)}")
        places = np.stack(np.meshgrid(u, v, indexing="ij"), 2).reshape(-1, 2)
        du, dv, duu, duv, dvv = (self._derivatives(places, *n) for n in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)))
        normal = np.cross(du, dv)
        length = np.linalg.norm(normal, axis=1)
        normal /= np.maximum(length, 1e-9 * length.max())[:, None]
        columns = [np.linalg.norm(du, axis=1), np.linalg.norm(dv, axis=1)]
        columns += [np.abs((second * normal).sum(1)) for second in (duu, duv, dvv)]
        return Bends(u, v, *(c.reshape(len(u), len(v)) for c in columns)), (u_breaks, v_breaks)

    def _fine(self, name: str, first: float, last: float) -> Tuple[np.ndarray, List[float]]:
        surface = self._surface
        if not isinstance(surface, Part.BSplineSurface):
            return np.linspace(first, last, _INTERVALS + 1), []
        knots, multiplicities = getattr(surface, f"get{name}Knots")(), getattr(surface, f"get{name}Multiplicities")()
        at, doubtful = between_knots(knots, multiplicities, getattr(surface, f"{name}Degree"), first, last, _PER_SPAN)
        return at, [t for t in doubtful if self._has_kink(name, t, BESIDE * (last - first))]

    def _has_kink(self, name: str, at: float, beside: float) -> bool:
        """Return whether the normals on both sides of a knot's line part."""
        u0, u1, v0, v1 = self._face.ParameterRange
        low, high = (v0, v1) if name == "U" else (u0, u1)
        across = low + (high - low) * (np.arange(_INTERVALS) + 0.5) / _INTERVALS
        sides = []
        for t in (at - beside, at + beside):
            line = np.stack([np.full(_INTERVALS, t), across], 1)
            sides.append(self._normals(line if name == "U" else line[:, ::-1]))
        return bool(((sides[0] * sides[1]).sum(1) < SMOOTH).any())

    def _derivatives(self, at: np.ndarray, along_u: int, along_v: int) -> np.ndarray:
        get = self._surface.getDN
        return point_array([get(u, v, along_u, along_v) for u, v in at.tolist()])

    def _normals(self, at: np.ndarray) -> np.ndarray:
        """Unit normals (P, 3) of the surface at parameters (P, 2), 0 where it has none."""
        normal = np.cross(self._derivatives(at, 1, 0), self._derivatives(at, 0, 1))
        length = np.linalg.norm(normal, axis=1)
        return normal / np.maximum(length, 1e-9 * max(float(length.max()), 1e-300))[:, None]

    def _add(self, at: np.ndarray) -> _Inner:
        value = self._surface.value
        return _Inner(self._border.add(point_array([value(u, v) for u, v in at.tolist()])), at)

    # -------------------------------------------------------------------------------------------- four-sided faces

    def _sides(self, uses: List[_Use]) -> Optional[List[Side]]:
        """The sides at low v, high v, low u, high u if the border is the rectangle of the parameters, else None."""
        if len(self._face.Wires) != 1:
            return None
        u0, u1, v0, v1 = self._face.ParameterRange
        ranges, sides = ((u0, u1), (v0, v1)), []
        of_side: List[List[_Use]] = [[], [], [], []]
        for use in uses:
            side = next((k for k in range(4) if _lies_on(use.at, ranges, k)), None)
            if side is None:
                return None
            of_side[side].append(use)
        for k, some in enumerate(of_side):
            side = _joined(some, 0 if k < 2 else 1, ranges[0 if k < 2 else 1])
            if side is None:
                return None
            sides.append(side)
        return sides

    def _grid(
        self, sides: List[Side], bends: Bends, densities: Densities, breaks: Tuple[list, list]
    ) -> Tuple[np.ndarray, _Inner]:
        u = spread(bends.u, densities[0].max(1), breaks[0])[1:-1]
        v = spread(bends.v, densities[1].max(0), breaks[1])[1:-1]
        steps = [len(side.at) - 1 for side in sides]
        if len(u) and not len(v) and max(steps[2:]) == 1:
            return four_sided(sides, u, v, np.zeros((len(u), 0), np.int64)), _NO_INNER
        if len(v) and not len(u) and max(steps[:2]) == 1:
            return four_sided(sides, u, v, np.zeros((0, len(v)), np.int64)), _NO_INNER
        u, v = (inner if len(inner) else (of[:1] + of[-1:]) / 2 for inner, of in ((u, bends.u), (v, bends.v)))
        places = np.stack(np.meshgrid(u, v, indexing="ij"), 2).reshape(-1, 2)
        inner = self._add(places)
        return four_sided(sides, u, v, inner.numbers.reshape(len(u), len(v))), inner

    # ----------------------------------------------------------------------------------------------- trimmed faces

    def _in_parameters(self, uses: List[_Use], bends: Bends, densities: Densities) -> Tuple[np.ndarray, _Inner]:
        """Triangles in the plane of the parameters, stretched so that steps are 1 long."""
        over_u, over_v = densities[0].max(1), densities[1].max(0)

        def stretched(at: np.ndarray) -> np.ndarray:
            return np.stack([reached(bends.u, over_u, at[:, 0]), reached(bends.v, over_v, at[:, 1])], 1)

        u, v = spread(bends.u, over_u)[1:-1], spread(bends.v, over_v)[1:-1]
        places = np.stack(np.meshgrid(u, v, indexing="ij"), 2).reshape(-1, 2)
        border, numbers, lines = _border_in_parameters([(use.numbers, stretched(use.at)) for use in uses])
        seen = stretched(places)
        keep = inside(seen, border, lines) & (distances(seen, border, lines) > _CLEARANCE)
        inner = self._add(places[keep])
        found = triangulate(np.concatenate([border, seen[keep]]), lines)
        return np.concatenate([numbers, inner.numbers])[found], inner

    def _plane(self, uses: List[_Use]) -> Optional[np.ndarray]:
        """Normal (3,) of a plane over which a face with a seam or a pole rises like a field of heights, or None."""
        if not any(use.degenerate or use.seam for use in uses):
            return None
        normals = self._normals(np.concatenate([use.at for use in uses if not (use.degenerate or use.seam)]))
        total = normals.sum(0)
        length = float(np.linalg.norm(total))
        return total / length if length and (normals @ total).min() > _LEAST_RISE * length else None

    def _along_plane(
        self, normal: np.ndarray, uses: List[_Use], bends: Bends, densities: Densities
    ) -> Tuple[np.ndarray, _Inner]:
        """Triangles seen along a normal (3,), where a face has neither seam nor pole."""
        places, steps = _rows(bends, densities)
        lines = np.concatenate(
            [np.stack([u.numbers[:-1], u.numbers[1:]], 1) for u in uses if not (u.degenerate or u.seam)]
        )
        axes = plane_axes(normal).T
        border = self._border.vertices @ axes
        seen = point_array([self._surface.value(u, v) for u, v in places.tolist()]) @ axes
        keep = inside(seen, border, lines) & (distances(seen, border, lines) > _CLEARANCE * steps)
        inner = self._add(places[keep])
        triangles = self._in_plane(lines, inner.numbers, normal)
        area = meshes.mesh_area(meshes.Mesh(self._border.vertices, triangles))
        if not area > _LEAST_AREA * self._face.Area:
            raise KernelError("a trimmed face with a seam or a pole must not turn away from its middle plane")
        return triangles, inner


def _border_in_parameters(uses: List[Tuple[np.ndarray, np.ndarray]]) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points (P, 2) of a border in the plane of parameters, their vertices' numbers (P,), and segments (S, 2) of them.

    Edges meet where they name the same vertex in the same place: at a seam a vertex has two places.
    """
    numbers = np.concatenate([n for n, _ in uses])
    points = np.concatenate([p for _, p in uses])
    keys = np.column_stack([numbers, np.floor(points / _SAME_PLACE + _OFF_TIES)])
    _, first, place = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    ends = np.cumsum([len(n) for n, _ in uses])
    starts = np.setdiff1d(np.arange(len(numbers)), ends - 1)
    place = place.reshape(-1)
    return points[first], numbers[first], np.stack([place[starts], place[starts + 1]], 1)


def _rows(bends: Bends, densities: Densities) -> Tuple[np.ndarray, np.ndarray]:
    """Places (P, 2) in rows of v, each with its own steps of u, none on a seam, and the lengths (P,) of steps there."""
    over_v = densities[1].max(0)
    places, steps = [], []
    for v in spread(bends.v, over_v)[1:-1].tolist():
        of_row = np.array([np.interp(v, bends.v, column) for column in densities[0]])
        u = spread(bends.u, of_row)
        middle = (u[1:] + u[:-1]) / 2
        places.append(np.stack([middle, np.full(len(middle), v)], 1))
        step = np.interp(v, bends.v, bends.along_v.max(0)) / np.interp(v, bends.v, over_v)
        steps.append(np.full(len(middle), step))
    if not places:
        raise KernelError("a trimmed face with a seam or a pole must be bent both ways")
    return np.concatenate(places), np.concatenate(steps)


def plane_axes(normal: np.ndarray) -> np.ndarray:
    """Return two unit axes (2, 3) of the plane across a unit normal (3,), counter-clockwise about it."""
    first = np.cross(normal, np.eye(3)[int(np.argmin(np.round(np.abs(normal), 6)))])
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(normal, first)])


def _lies_on(at: np.ndarray, ranges: Tuple[Tuple[float, float], Tuple[float, float]], side: int) -> bool:
    """Return whether parameters (K, 2) lie on side 0 to 3 of a rectangle: low v, high v, low u, high u."""
    across = 1 if side < 2 else 0
    low, high = ranges[across]
    return bool((np.abs(at[:, across] - (low, high)[side % 2]) <= _ON_SIDE * (high - low)).all())


def _joined(uses: List[_Use], along: int, ends: Tuple[float, float]) -> Optional[Side]:
    """One side of all the edges that lie on it, or None if they leave a gap."""
    if not uses:
        return None
    low, high = ends
    rising = [(u.at[:, along], u.numbers) if u.at[0, along] < u.at[-1, along] else (u.at[::-1, along], u.numbers[::-1])
              for u in uses]  # fmt: skip
    rising.sort(key=lambda part: part[0][0])
    at, numbers = rising[0]
    for next_at, next_numbers in rising[1:]:
        if next_numbers[0] != numbers[-1]:
            return None
        at, numbers = np.concatenate([at, next_at[1:]]), np.concatenate([numbers, next_numbers[1:]])
    hair = _ON_SIDE * (high - low)
    complete = abs(at[0] - low) <= hair and abs(at[-1] - high) <= hair and (np.diff(at) > 0).all()
    return Side(at, numbers) if complete else None
