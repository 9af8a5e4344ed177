# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field engine's grid: its nodes, and slab by slab what the rays through them tell.

Winding numbers at the nodes come from the rays along x; the crossings of the grid's edges from the rays along all
three axes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Iterator, List, NamedTuple, Optional, Tuple

import numpy as np

from ..errors import MeshError, ParameterError
from .meshes import Mesh, bounds, mesh_volume
from .rays import RayGrid, crossing_blocks

# A vertex keeps this share of a cell from the nodes, so that no two fall together in single precision.
_MARGIN = 0.01
_SLAB = 800_000  # nodes worked on at once: about 100 MB
_LAYERS = 16  # but not fewer layers than these: each slab looks at its triangles anew
_MOST_NODES = 4_000_000_000  # the vertices of more might not fit their 32-bit numbers


def _within(body: str, rods: np.ndarray, envelope: np.ndarray) -> np.ndarray:
    """True where a body is, from the winding numbers of the rods and of the envelope."""
    return (envelope > 0) & ((rods > 0) if body == "channels" else (rods <= 0))


@dataclass(frozen=True)
class NodeGrid:
    """The grid: node (i, j, k) at low + (i, j, k) * step, with a border as ``Surface`` wants it.

    ``flush``: the envelope is a box along the axes, whose faces are the outermost nodes.
    """

    low: np.ndarray
    step: np.ndarray
    cells: np.ndarray
    flush: bool

    @classmethod
    def of_envelope(cls, envelope: Mesh, cell: float) -> NodeGrid:
        """Return the grid for an envelope.

        Raises
        ------
        ParameterError
            If the envelope is thinner than two cells (mm), or the cells are too many.
        """
        low, high = bounds(envelope)
        if (high - low).min() < 2 * cell:
            raise ParameterError(
                f"the envelope must be at least two cells thick; it measures {high - low} mm, a cell {cell:g} mm"
            )
        cells = np.ceil((high - low) / cell - 1e-9)
        if np.prod(cells + 3) > _MOST_NODES:
            raise ParameterError(
                f"a field may have {_MOST_NODES:.1g} nodes; a cell size of {cell:g} mm needs {np.prod(cells + 3):.2g}"
            )
        if _is_box(envelope, low, high):
            return cls(low, (high - low) / cells, cells.astype(int), True)
        # half a cell of space, so that flat faces on the bounds run between the nodes
        return cls(low - cell / 2, np.full(3, float(cell)), cells.astype(int) + 1, False)

    @property
    def shape(self) -> Tuple[int, int, int]:
        """Nodes along z, y, x with the border."""
        return tuple((self.cells[::-1] + 3).tolist())  # type: ignore[return-value]

    def places(self, axis: int) -> np.ndarray:
        """Co-ordinates (N,) of the nodes along an axis with the border, which lies on the outermost nodes."""
        return self.low[axis] + self.step[axis] * np.arange(-1, self.cells[axis] + 2).clip(0, self.cells[axis])

    def below(self, values: np.ndarray, axis: int) -> np.ndarray:
        """Return how many nodes of a line (without border) lie below each value."""
        return np.ceil((values - self.low[axis]) / self.step[axis]).clip(0, self.cells[axis] + 1).astype(np.int64)

    def grid(self, axis: int, layer: int, layers: int) -> RayGrid:
        """Rays along an axis through the nodes of some layers in z."""
        u, v = (axis + 1) % 3, (axis + 2) % 3
        first = {2: layer}
        count = {0: int(self.cells[0]) + 1, 1: int(self.cells[1]) + 1, 2: layers}
        low, step = self.low.tolist(), self.step.tolist()
        return RayGrid(
            axis, (low[u], low[v]), (step[u], step[v]), (first.get(u, 0), first.get(v, 0)), (count[u], count[v])
        )


def _is_box(envelope: Mesh, low: np.ndarray, high: np.ndarray) -> bool:
    """True if every triangle lies in a face of the bounding box and the volume is the box's."""
    hair = 1e-9 * (high - low).max()
    corners = envelope.corners
    on_face = (np.abs(corners - low) <= hair).all(1) | (np.abs(corners - high) <= hair).all(1)
    return bool(on_face.any(1).all() and np.isclose(mesh_volume(envelope), np.prod(high - low), rtol=1e-6))


class Hits(NamedTuple):
    """Crossings of the grid's edges along one axis: lower node (flat, in the slab), place, signs of both."""

    node: np.ndarray
    at: np.ndarray
    rods: np.ndarray
    envelope: np.ndarray


class NodeRays:
    """Casts the rays slab by slab and counts what is unusual: see ``field.FieldFigures``."""

    def __init__(self, nodes: NodeGrid, rods: np.ndarray, envelope: Optional[np.ndarray]) -> None:
        self.nodes = nodes
        self.several = self.lost = 0
        self._meshes = [rods] if envelope is None else [rods, envelope]
        self._heights = [(m[:, :, 2].min(1), m[:, :, 2].max(1)) for m in self._meshes]

    def slabs(self) -> Iterator[Slab]:
        """Yield the slabs from below; each begins with the last layer of the one before."""
        layers, rows, columns = self.nodes.shape
        thickness = max(_LAYERS, _SLAB // (rows * columns))
        windings = np.zeros((2, rows, columns), np.int16)
        base = 0
        while base < layers - 1:
            top = base + thickness if base + thickness < layers - 2 else layers - 1
            slab = self._slab(base, top, windings)
            yield slab
            windings = np.stack([slab.rods[-1], slab.envelope[-1]])
            base = top

    def _slab(self, base: int, top: int, before: np.ndarray) -> Slab:
        nodes = self.nodes
        layers, rows, columns = nodes.shape
        first, last = base + 1, min(top, layers - 2)  # layers without the border
        height = nodes.places(2)
        near = [
            mesh[(low <= height[top]) & (high >= height[base])]
            for mesh, (low, high) in zip(self._meshes, self._heights)
        ]
        windings = np.zeros((2, top - base + 1, rows, columns), np.int16)
        windings[:, 0] = before
        if nodes.flush:
            windings[1, 1 : last - base + 1, 1:-1, 1:-1] = 1
        hits = []
        for axis in range(3):
            grid = nodes.grid(axis, first - 1, last - base)
            crossed = [_crossed(mesh, grid) for mesh in near]
            if axis == 0:
                for winding, (i, j, at, sign) in zip(windings, crossed):
                    winding[1 : last - base + 1, 1:-1, 1:-1] = self._windings(i, j, at, sign, last - base)
            hits.append(
                Hits(*map(np.concatenate, zip(*(self._hits(axis, k, c, base, top) for k, c in enumerate(crossed)))))
            )
        return Slab(self, base, windings[0], windings[1], hits)

    def _windings(self, i: np.ndarray, j: np.ndarray, at: np.ndarray, sign: np.ndarray, layers: int) -> np.ndarray:
        """Winding numbers [z, y, x] at the nodes of some layers from the crossings of rays along x."""
        shape = (layers, self.nodes.cells[1] + 1, self.nodes.cells[0] + 2)
        place = (j * shape[1] + i) * shape[2] + self.nodes.below(at, 0)
        winding = np.bincount(place, sign, int(np.prod(shape))).reshape(shape).cumsum(2)
        if winding[:, :, -1].any():
            open_rays = int(np.count_nonzero(winding[:, :, -1]))
            raise MeshError(
                f"rods must be closed meshes: each ray must leave as often as it enters, {open_rays} do not"
            )
        return winding[:, :, :-1]

    def _hits(
        self, axis: int, mesh: int, crossed: Tuple[np.ndarray, ...], base: int, top: int
    ) -> Tuple[np.ndarray, ...]:
        """Columns of ``Hits`` from the crossings of one mesh (0: rods, 1: envelope)."""
        i, j, at, sign = crossed
        below = self.nodes.below(at, axis)
        index = {(axis + 1) % 3: i + 1, (axis + 2) % 3: j + 1, axis: below - base if axis == 2 else below}
        met = (below > 0) & (below <= self.nodes.cells[axis])
        if axis == 2:
            met &= (index[2] >= 0) & (index[2] < top - base)
        _, rows, columns = self.nodes.shape
        met = np.nonzero(met)[0]
        node = ((index[2] * rows + index[1]) * columns + index[0])[met]
        none = np.zeros(len(met), np.int8)
        return (node, at[met], sign[met], none) if mesh == 0 else (node, at[met], none, sign[met])


def _crossed(triangles: np.ndarray, grid: RayGrid) -> Tuple[np.ndarray, ...]:
    blocks = list(crossing_blocks(triangles, grid))
    none = [(np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0), np.zeros(0, np.int8))]
    return tuple(np.concatenate(column) for column in zip(*(blocks or none)))


@dataclass(frozen=True)
class Slab:
    """Layers base..base + L of the nodes: winding numbers (L + 1, NY, NX) and crossings of the edges between them."""

    rays: NodeRays
    base: int
    rods: np.ndarray
    envelope: np.ndarray
    hits: List[Hits]

    def inside(self, body: str) -> np.ndarray:
        """True at the nodes inside a body."""
        return _within(body, self.rods, self.envelope)

    def place(self, body: str) -> Callable[[int, np.ndarray], np.ndarray]:
        """Return the function that puts vertices of a body on edges."""
        return lambda axis, edges: self._points(body, axis, edges)

    def _points(self, body: str, axis: int, edges: np.ndarray) -> np.ndarray:
        """Points (N, 3) on the edges that run along the axis from the given nodes, where the body begins or ends."""
        _, rows, columns = self.rods.shape
        index = [edges % columns, edges // columns % rows, edges // (columns * rows) + self.base]
        points = np.stack([self.rays.nodes.places(a)[index[a]] for a in range(3)], 1)
        low, high = points[:, axis], self.rays.nodes.places(axis)[index[axis] + 1]
        number = np.full(self.rods.size, -1, np.int32)
        number[edges] = np.arange(len(edges))
        hits = self.hits[axis]
        edge = number[hits.node]
        on_edge = np.nonzero(edge >= 0)[0]
        edge, hits = edge[on_edge], Hits(*(column[on_edge] for column in hits))
        count = np.bincount(edge, minlength=len(edges))
        place = (low + high) / 2
        single = count[edge] == 1
        place[edge[single]] = hits.at[single]
        several = np.nonzero(~single)[0]
        if len(several):
            begins = self.inside(body).ravel()[edges]
            length = self._lengths(body, edge[several], Hits(*(column[several] for column in hits)), low, high)
            place = np.where(count > 1, np.where(begins, low + length, high - length), place)
        self.rays.several += int((count > 1).sum())
        self.rays.lost += int(((count == 0) & (high > low)).sum())
        points[:, axis] = place.clip(low + _MARGIN * (high - low), high - _MARGIN * (high - low))
        return points

    def _lengths(self, body: str, edge: np.ndarray, hits: Hits, low: np.ndarray, high: np.ndarray) -> np.ndarray:
        """Length (N,) inside the body of each edge that is crossed more than once; low, high (N,): its ends."""
        order = np.lexsort((hits.at, edge))
        edge, hits = edge[order], Hits(*(column[order] for column in hits))
        first = np.nonzero(np.diff(edge, prepend=-1))[0]
        count = np.diff(first, append=len(edge))
        at = hits.at.clip(low[edge], high[edge])
        windings = []
        for start, sign in ((self.rods, hits.rods), (self.envelope, hits.envelope)):
            total = np.cumsum(sign, dtype=np.int64)
            windings.append(start.ravel()[hits.node] + total - np.repeat((total - sign)[first], count))
        end = np.append(at[1:], 0.0)
        end[first[1:] - 1], end[-1] = high[edge[first[1:] - 1]], high[edge[-1]]
        length = np.bincount(edge, _within(body, *windings) * (end - at), len(low))
        begins = _within(body, self.rods.ravel()[hits.node[first]], self.envelope.ravel()[hits.node[first]])
        length[edge[first]] += begins * (at[first] - low[edge[first]])
        return length
