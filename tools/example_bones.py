# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts the two specimens of real bone in resources/examples out of the shrew cube of the shared data (CC0).

``python3 tools/example_bones.py ../shared/data/shrew_cube_10mm.stl``: two cubes of 4 mm, the largest piece
of each, moved to the origin, as PLY. Needs manifold3d.
"""

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from freecad_trabecula.core.booleans import combine  # noqa: E402
from freecad_trabecula.core.mesh_formats import write_ply  # noqa: E402
from freecad_trabecula.core.meshes import Mesh, mesh_volume, split  # noqa: E402
from freecad_trabecula.core.stl import read_stl  # noqa: E402
from freecad_trabecula.core.voxels.blocks import block_mesh  # noqa: E402

EDGE = 4.0  # mm
#: Lowest corner of each specimen in the cube, mm: two places of one bone that differ in porosity.
CORNERS = {"a": (0.5, 0.5, 0.5), "b": (5.0, 0.5, 0.5)}


def main():
    """Cut both and say what they are."""
    bone = read_stl(sys.argv[1])
    for name, corner in CORNERS.items():
        box = block_mesh(np.ones((1, 1, 1), bool), (EDGE,) * 3, corner)
        piece = max(split(combine([bone, box], "intersection")), key=mesh_volume)
        path = ROOT / "resources" / "examples" / ("shrew_bone_%s.ply" % name)
        write_ply(path, Mesh(piece.vertices - np.array(corner), piece.triangles))
        share = mesh_volume(piece) / EDGE**3
        print("%s: %d triangles, BV/TV %.3f, %d bytes" % (path.name, len(piece.triangles), share, path.stat().st_size))


if __name__ == "__main__":
    main()
