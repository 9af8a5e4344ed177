# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small samples, whose designs have little freedom, and an exact check of their counts that is independent of ours.

Boxes of 4 to 12 layers, some full or nearly so: beams, tubes, crosses, plates, dense and sparse bone; the beams sliced
at odd voxel sizes, so that rounded counts belong to no voxels; voxels thrown at random.
"""

from __future__ import annotations

from itertools import product
from typing import Dict, Iterator, Optional, Tuple

import numpy as np

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.core.voxels.connectivity import closed_cavities, edge_contacts, parts
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.sources import targets_of_triangles
from freecad_trabecula.core.voxels.targets import Targets, targets_of_voxels
from freecad_trabecula.core.voxels.texture import Texture, trabecular_field

BOXES = ((4, 4, 4), (6, 6, 6), (8, 8, 8), (5, 7, 9), (4, 6, 12), (12, 5, 4), (10, 10, 10), (12, 12, 12))
DENSITIES = (0.1, 0.25, 0.5, 0.75, 0.9, 0.97)
ODD = tuple(product((0.375, 0.5, 0.75, 1.0), (0.5, 0.75), (0.5, 0.6)))  # mm, of beams of 4 mm
THROWN = 40


def beams(shape: tuple) -> Dict[str, np.ndarray]:
    """Return shapes that go through the box along z, of full thickness where they are, (P, M, N) bool."""
    _, m, n = shape
    y, x = np.mgrid[:m, :n]
    found = {}
    for arm in (1, 2, 3):
        if 2 * arm < min(m, n):
            found[f"L, arms of {arm}"] = (x < arm) | (y < arm)
            found[f"tube, wall of {arm}"] = (x < arm) | (y < arm) | (x >= n - arm) | (y >= m - arm)
            found[f"cross, arms of {arm}"] = (abs(2 * x - n + 1) <= arm) | (abs(2 * y - m + 1) <= arm)
    return {name: np.broadcast_to(plan, shape).copy() for name, plan in found.items() if plan.any()}


def blocks(shape: tuple) -> Dict[str, np.ndarray]:
    """Return blocks and plates, some layers of them full."""
    p, m, n = shape
    z, y, x = np.mgrid[:p, :m, :n]
    post = (abs(2 * x - n + 1) <= 1 + n % 2) & (abs(2 * y - m + 1) <= 1 + m % 2)
    return {
        "box less a corner": ~((z >= p // 2) & (y >= m // 2) & (x >= n // 2)),
        "box less a voxel": ~((z == p - 1) & (y == m - 1) & (x == n - 1)),
        "two plates and a post": (z == 0) | (z == p - 1) | post,
        "comb of plates": (x == 0) | (z % 2 == 0),
        "three plates that cross": (x == n // 2) | (y == m // 2) | (z == p // 2),
        "frame": ((x % (n - 1) == 0).astype(int) + (y % (m - 1) == 0) + (z % (p - 1) == 0)) >= 2,
        "stairs": x * p <= z * n + n,
    }


def bone(shape: tuple, density: float) -> np.ndarray:
    """Return a piece of bone with so many of its voxels solid, its first layer along z full."""
    field = trabecular_field(Texture((6.0,) * 3), shape, int(1000 * density), ("small",))
    solid = field > np.quantile(field, 1 - density)
    solid[0] = True
    return solid


def thrown(number: int) -> Optional[Targets]:
    """Return the counts of voxels thrown into a small box, but not these; None if all cells or none are hit."""
    drawn = Stream(number, "thrown").uniform(4)
    shape = tuple((4 + 4 * drawn[:3]).astype(int))
    solid = (Stream(number, "voxels").many(int(np.prod(shape))) < 0.1 + 0.8 * drawn[3]).reshape(shape)
    if solid.all() or not solid.any():
        return None
    counts = targets_of_voxels(solid)
    return Targets(counts.d, counts.e, counts.c)


def samples() -> Iterator[Tuple[str, str, Targets]]:
    """Yield kind, name and targets of every small sample."""
    for shape in BOXES:
        solids: Dict[str, np.ndarray] = {**beams(shape), **blocks(shape)}
        for name, solid in solids.items():
            yield "shapes", f"{name} in {shape}", targets_of_voxels(solid)
        for density in DENSITIES:
            yield "bone", f"bone of {density:g} in {shape}", targets_of_voxels(bone(shape, density))
    for name, solid in beams((8, 8, 8)).items():
        mesh = block_mesh(solid, (0.5, 0.5, 0.5))
        for size in ODD:
            targets = targets_of_triangles(mesh.vertices[mesh.triangles], VoxelParameters(size=size))
            yield "sliced at odd sizes", f"{name} at {size} mm", targets
    for number in range(THROWN):
        targets = thrown(number)
        if targets is not None:
            yield "thrown", f"thrown {number} into {targets.shape}", targets


def keeps_rules(solid: Optional[np.ndarray], targets: Targets) -> bool:
    """Return whether a sample has these counts and is itself one part without cavities and contacts by an edge."""
    if solid is None or solid.shape != targets.shape:
        return False
    has = all(np.array_equal(solid.sum(axes), c) for axes, c in zip(((0, 1), (0, 2), (1, 2)), targets.counts))
    return has and len(parts(solid)[1]) == 2 and len(closed_cavities(solid)[1]) == 1 and edge_contacts(solid) == 0


def counts_exist(targets: Targets) -> bool:
    """Return whether any voxels have these counts, by a program of its own: lines along z, and what lies in them.

    Raises
    ------
    RuntimeError
        If the program came to no end.
    """
    from scipy.optimize import Bounds, LinearConstraint, milp
    from scipy.sparse import eye, kron, vstack

    p, m, n = targets.shape
    ones = [np.ones((1, k)) for k in (p, m, n)]
    layers = vstack(
        [
            kron(eye(p), kron(ones[1], ones[2])),
            kron(ones[0], kron(eye(m), ones[2])),
            kron(ones[0], kron(ones[1], eye(n))),
        ]
    )
    sums = np.concatenate([targets.c, targets.e, targets.d]).astype(float)
    cells = p * m * n
    result = milp(
        np.zeros(cells),
        integrality=np.ones(cells),
        bounds=Bounds(0, 1),
        constraints=LinearConstraint(layers.tocsr(), sums, sums),
        options={"presolve": False},  # that of scipy 1.10 is wrong now and then
    )
    if result.status not in (0, 2):
        raise RuntimeError(f"the program of {cells} cells came to no end: {result.message}")
    return result.status == 0
