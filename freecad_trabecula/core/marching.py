# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marching cubes, from a generated table of the 256 cases, so that the surface is always a closed 2-manifold.

Corner c of a cell has the offsets (x, y, z) = bits 0, 1, 2 of c; case = sum of 2**c over the corners inside. On each
face of the cell the segments follow from the face's four corners alone, so two cells that share a face agree; the
segments of all faces join to loops; loops are cut into triangles by chords that run through the cell, never in one of
its faces, so no chord is met twice. Lorensen and Cline 1987 (doi:10.1145/37402.37422) left holes at ambiguous faces;
here one material is always separated there.
"""

from __future__ import annotations

import itertools
from functools import lru_cache
from typing import Callable, Dict, Iterator, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from .meshes import Mesh

#: The 12 edges of a cell: (axis, lower corner).
EDGES: Tuple[Tuple[int, int], ...] = tuple((a, c) for a in range(3) for c in range(8) if not c >> a & 1)
_NUMBER = {frozenset((c, c | 1 << a)): e for e, (a, c) in enumerate(EDGES)}
# corners of the six faces, counter-clockwise seen from outside the cell
_FACES = tuple(
    tuple(
        p ^ (end << a)
        for p in ((0, 1 << v, 1 << u | 1 << v, 1 << u) if not end else (0, 1 << u, 1 << u | 1 << v, 1 << v))
    )
    for a, u, v in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
    for end in (0, 1)
)


class CaseTable(NamedTuple):
    """Triangles of all cases in one list.

    Attributes
    ----------
    first : ndarray of shape (257,), int64
        Case c has the triangles first[c] .. first[c + 1] - 1.
    edges : ndarray of shape (N, 3), int64
        Edges of the cell (indices into EDGES) on which the corners lie, counter-clockwise seen from outside the body.
    """

    first: np.ndarray
    edges: np.ndarray


@lru_cache(maxsize=2)
def case_table(separate_inside: bool = True) -> CaseTable:
    """Return the triangles of the 256 cases.

    Parameters
    ----------
    separate_inside : bool
        On a face whose inside corners lie across a diagonal: True keeps these two apart, False joins them. A body and
        its complement get the same surface if one is made with True and the other with False.
    """
    if not separate_inside:
        other = case_table(True)
        lists = [other.edges[other.first[255 - case] : other.first[256 - case], ::-1] for case in range(256)]
    else:
        lists = [np.array(_case_triangles(case), np.int64).reshape(-1, 3) for case in range(256)]
    first = np.concatenate([[0], np.cumsum([len(triangles) for triangles in lists])])
    return CaseTable(first, np.concatenate(lists))


def case_loops(case: int, separate_inside: bool = True) -> List[List[int]]:
    """Return the closed loops of edges (indices into EDGES) of a case, counter-clockwise seen from outside the body."""
    after: Dict[int, int] = {}
    for face in _FACES:
        after.update(_face_segments(face, case, separate_inside))
    loops = []
    while after:
        loop = [min(after)]
        edge = after.pop(loop[0])
        while edge != loop[0]:
            loop.append(edge)
            edge = after.pop(edge)
        loops.append(loop)
    return loops


def _face_segments(face: Tuple[int, ...], case: int, separate_inside: bool) -> Dict[int, int]:
    """Directed segments of one face, edge to edge: each cuts off one run of inside corners (or of outside corners)."""
    inside = [bool(case >> c & 1) for c in face]
    edge = [_NUMBER[frozenset((face[k], face[(k + 1) % 4]))] for k in range(4)]
    out = [k for k in range(4) if inside[k] and not inside[(k + 1) % 4]]
    into = [k for k in range(4) if not inside[k] and inside[(k + 1) % 4]]
    if separate_inside:  # a run of inside corners ends at k: it began at the last way in before k
        pairs = [(k, (k + 1 + max((j - k - 1) % 4 for j in into)) % 4) for k in out]
    else:  # a run of outside corners begins after k: it ends at the next way in
        pairs = [(k, (k + 1 + min((j - k - 1) % 4 for j in into)) % 4) for k in out]
    return {edge[j]: edge[k] for k, j in pairs}


def _case_triangles(case: int) -> List[Tuple[int, int, int]]:
    triangles: List[Tuple[int, int, int]] = []
    for loop in case_loops(case):
        best = _triangulation(tuple(loop))
        if best is None:
            raise AssertionError(f"case {case}: no triangulation without chords in faces")
        triangles.extend(best)
    return triangles


def _triangulation(loop: Tuple[int, ...]) -> Optional[List[Tuple[int, int, int]]]:
    """Shortest triangulation of a loop by chords that avoid the faces (dynamic programming); None if there is none."""
    middle = np.array([[c & 1, c >> 1 & 1, c >> 2 & 1] for _, c in EDGES]) + 0.5 * np.eye(3)[[a for a, _ in EDGES]]

    def length(i: int, j: int) -> float:
        if j - i == 1 or (i == 0 and j == len(loop) - 1):
            return 0.0
        p, q = middle[loop[i]], middle[loop[j]]
        if ((p == q) & ((p == 0) | (p == 1))).any():
            return np.inf
        return float(np.linalg.norm(p - q))

    @lru_cache(maxsize=None)
    def best(i: int, j: int) -> Tuple[float, Tuple[Tuple[int, int, int], ...]]:
        if j - i < 2:
            return length(i, j), ()
        options = []
        for k in range(i + 1, j):
            a, b = best(i, k), best(k, j)
            options.append((a[0] + b[0] + length(i, j), a[1] + b[1] + ((loop[i], loop[k], loop[j]),)))
        return min(options, key=lambda option: option[0])

    cost, triangles = best(0, len(loop) - 1)
    return list(triangles) if np.isfinite(cost) else None


#: ``place(axis, nodes)``: points (N, 3), mm, on the edges that run from the nodes (N,) of a slab along the axis.
Place = Callable[[int, np.ndarray], np.ndarray]


class Surface:
    """The surface of one body, made slab by slab from inside and outside at the nodes of a grid.

    The grid has a border: one layer of nodes on every side that are outside and lie where their neighbours lie (cells
    of no thickness). So a body that reaches the grid's faces is closed there by flat faces with sharp edges.

    Parameters
    ----------
    shape : tuple of two ints
        Nodes along y and x with the border, (NY, NX).
    separate_inside : bool
        As in ``case_table``.
    """

    def __init__(self, shape: Tuple[int, int], separate_inside: bool) -> None:
        self._shape = shape
        self._table = case_table(separate_inside)
        steps = np.array([1, shape[1], shape[0] * shape[1]])
        to_edge = [3 * sum(int(steps[k]) for k in range(3) if c >> k & 1) + a for a, c in EDGES]
        self._to_edges = np.array(to_edge)[self._table.edges]
        self._points: List[np.ndarray] = []
        self._triangles: List[np.ndarray] = []
        self._count = 0
        self._last = np.full(
            shape + (3,), -1, np.int32
        )  # vertices of the last layer's edges: the next slab shares them

    def add(self, inside: np.ndarray, place: Place, first: bool, last: bool) -> None:
        """Add the cells between the layers of a slab.

        Parameters
        ----------
        inside : ndarray of shape (L + 1, NY, NX), bool
            Layer 0 is the last layer of the slab before, or the lower border.
        place : Place
        first, last : bool
            Whether layer 0 is the lower border, and layer L the upper one.
        """
        flags = _changes(inside)
        ends = self._ends(len(inside), first, last)
        vertices = np.full(inside.shape + (3,), -1, np.int32)
        vertices[0] = self._last
        for axis, end, other, other_end in _shared(ends):
            flags[axis][_line({axis: end[0], other: other_end[1]})] = False
        for axis in range(3):
            nodes = np.flatnonzero(flags[axis])
            vertices.reshape(-1, 3)[nodes, axis] = np.arange(self._count, self._count + len(nodes))
            self._count += len(nodes)
            self._points.append(place(axis, nodes))
        for axis, end, other, other_end in _shared(ends):
            of_other = vertices[_line({axis: end[1], other: other_end[0]}) + (other,)]
            vertices[_line({axis: end[0], other: other_end[1]}) + (axis,)] = of_other
        self._triangles.append(self._cell_triangles(inside, vertices))
        self._last = vertices[-1].copy()

    def _ends(self, layers: int, first: bool, last: bool) -> List[List[Tuple[int, int]]]:
        """For each axis the cells of no thickness in this slab: (index of their edges, index of the node inside)."""
        ends = [[(0, 1), (count - 2, count - 2)] for count in self._shape[::-1]]
        return ends + [[(0, 1)] * first + [(layers - 2, layers - 2)] * last]

    def _cell_triangles(self, inside: np.ndarray, vertices: np.ndarray) -> np.ndarray:
        case = _cases(inside)
        cells = np.flatnonzero((case != 0) & (case != 255))
        case = case[cells]
        count = np.diff(self._table.first)[case]
        entry = np.arange(count.sum()) + np.repeat(self._table.first[case] - np.cumsum(count) + count, count)
        triangles = vertices.ravel()[np.repeat(3 * cells, count)[:, None] + self._to_edges[entry]]
        a, b, c = triangles.T
        flat = (a == b) | (b == c) | (c == a)  # cells of no thickness in two directions
        return triangles[~flat] if flat.any() else triangles

    def mesh(self) -> Mesh:
        """Return the surface; the builder is empty afterwards."""
        return Mesh(_stacked(self._points, np.float64), _stacked(self._triangles, np.int32))


def _changes(inside: np.ndarray) -> List[np.ndarray]:
    """For each axis, True at nodes (L + 1, NY, NX) whose edge has one end inside; not again on layer 0 for x and y."""
    flags = [np.zeros(inside.shape, bool) for _ in range(3)]
    flags[0][1:, :, :-1] = inside[1:, :, 1:] != inside[1:, :, :-1]
    flags[1][1:, :-1] = inside[1:, 1:] != inside[1:, :-1]
    flags[2][:-1] = inside[1:] != inside[:-1]
    return flags


def _shared(ends: List[List[Tuple[int, int]]]) -> Iterator[Tuple[int, Tuple[int, int], int, Tuple[int, int]]]:
    """Where a node has border edges along two axes, which end in one point: (axis, end, earlier axis, its end)."""
    for other, axis in ((0, 1), (0, 2), (1, 2)):
        for end, other_end in itertools.product(ends[axis], ends[other]):
            yield axis, end, other, other_end


def _line(at: Dict[int, int]) -> Tuple[Union[int, slice], ...]:
    """Index into a [z, y, x] array where the given axes have the given indices."""
    return tuple(at.get(axis, slice(None)) for axis in (2, 1, 0))


def _cases(inside: np.ndarray) -> np.ndarray:
    """Case of the cell above each node of the layers 0..L-1, flat, uint8; 0 for nodes at the upper ends of x and y."""
    layers, rows, columns = inside.shape
    case = np.zeros((layers - 1, rows, columns), np.uint8)
    bits = inside.view(np.uint8)
    for c in range(8):
        x, y, z = c & 1, c >> 1 & 1, c >> 2
        case[:, :-1, :-1] |= bits[z : layers - 1 + z, y : rows - 1 + y, x : columns - 1 + x] << np.uint8(c)
    return case.ravel()


def _stacked(blocks: List[np.ndarray], dtype: type) -> np.ndarray:
    """Blocks (N, 3) as one array; each is let go as soon as it is copied, since they may fill half of the memory."""
    result: np.ndarray = np.empty((sum(len(block) for block in blocks), 3), dtype)
    end = len(result)
    while blocks:
        block = blocks.pop()
        result[end - len(block) : end] = block
        end -= len(block)
    return result
