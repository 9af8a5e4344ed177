#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voxel designs measured as bones are: from the STL of a design, beside the bone; written to docs/validation-voxels.md.

``python3 tools/voxel_bones.py [--page FILE]``. Designs of the shrew cube and the human bone (0.1 mm, seed 1, with and
without numbers of trabeculae) are written as STL, read back and sliced in the middles of their layers: the second route
to their counts. Morphometry is that of bone and design by the same code. The bones are looked for in the folder
TRABECULA_DATA (default: ../shared/data).
"""

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

import numpy as np  # noqa: E402

from freecad_trabecula.core.analysis.analysis import analyse  # noqa: E402
from freecad_trabecula.core.analysis.parameters import SliceParameters  # noqa: E402
from freecad_trabecula.core.analysis.triangles import read_soup  # noqa: E402
from freecad_trabecula.core.meshes import printable  # noqa: E402
from freecad_trabecula.core.stl import write_stl  # noqa: E402
from freecad_trabecula.core.voxels.blocks import block_mesh  # noqa: E402
from freecad_trabecula.core.voxels.design import make_design  # noqa: E402
from freecad_trabecula.core.voxels.parameters import VoxelParameters  # noqa: E402
from freecad_trabecula.core.voxels.sources import read_targets  # noqa: E402

DATA = Path(os.environ.get("TRABECULA_DATA") or ROOT.parent / "shared" / "data")
SAMPLES = {"shrew cube, 10 mm": "shrew_cube_10mm.stl", "human bone, 10 mm": "trab_ior_10mm_13MB.stl"}
SYMBOLS = ("BV/TV", "BS/BV.vox", "Tb.Th", "Tb.Sp", "Tb.N", "Conn.D", "DA")
AXES = ("x", "y", "z")
INTRODUCTION = """# Voxel designs measured as bones are

Made by `python3 tools/voxel_bones.py`: seed 1, voxels of 0.1 mm, blocks written as STL, read back and sliced. The
largest difference of a layer's sliced area from its target is what single precision leaves. BS/BV is that of voxels
(lines), since the stairs of blocks have half as much surface again as the bone.

Without counting, the fitted texture comes near in thickness, spacing, number, connectivity and (human bone)
anisotropy, and far from the number of contours of the human bone, whose trabeculae of two voxels the design joins.
Counting brings the contours near and the rest away: the shrew cube, with five trabeculae a layer, gets far too thick,
the human bone too connected and isotropic. The share of rods is not a target and is not met for the human bone.
"""


def measured(path, thickness):
    """Return the analysis of a file with its morphometry."""
    return analyse(read_soup(path, "mm"), SliceParameters(thickness=thickness), True)


def designed(path, trabeculae, folder):
    """Return the analysis of a design from its STL, the greatest error of a sliced area, and CPU seconds."""
    parameters = VoxelParameters(trabeculae=trabeculae)
    targets = read_targets(path, parameters)
    start = time.process_time()
    design = make_design(targets, parameters)
    seconds = time.process_time() - start
    file = Path(folder) / "design.stl"
    write_stl(file, printable(block_mesh(design.voxels, targets.voxel, targets.origin)))
    found = measured(file, targets.voxel[0])
    worst = 0.0
    for axis, counts in zip(AXES, targets.counts):
        # an end layer without a voxel is none of the mesh's
        used = np.flatnonzero(counts)
        wanted = counts[used[0] : used[-1] + 1] * targets.voxel[0] ** 2
        worst = max(worst, float(np.abs(found.profiles[axis].sliced_area / wanted - 1).max()))
    return found, worst, seconds


def rows(bone, designs):
    """Return the table's rows: one for each measure, bone and designs side by side."""
    values = [{m.symbol: m for m in one.morphometry.measures} for one in (bone, *designs)]
    for symbol in SYMBOLS:
        if all(symbol in column for column in values):
            unit = values[0][symbol].unit
            yield [f"{symbol}, {unit}" if unit else symbol, *(f"{column[symbol].value:.4g}" for column in values)]
    everything = [one.summary(axis) for one in (bone, *designs) for axis in AXES]
    columns = [everything[k : k + 3] for k in range(0, len(everything), 3)]
    shares = [sum(s.rods for s in c) / max(1, sum(s.rods + s.plates for s in c)) for c in columns]
    yield ["rods among outer contours (thesis' rule), %", *(f"{100 * share:.1f}" for share in shares)]
    for axis in AXES:
        means = [float(one.profiles[axis].outer_contours.mean()) for one in (bone, *designs)]
        yield [f"outer contours a slice along {axis.upper()}, mean", *(f"{mean:.1f}" for mean in means)]


def main(arguments):
    """Measure, print and write the page; return 0 if every sliced area is right."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--page", default=str(ROOT / "docs" / "validation-voxels.md"))
    page = Path(parser.parse_args(arguments).page)
    lines, status = [INTRODUCTION], 0
    for name, file in SAMPLES.items():
        bone = measured(DATA / file, 0.1)
        with tempfile.TemporaryDirectory() as folder:
            found = [designed(DATA / file, trabeculae, folder) for trabeculae in ("off", "xyz")]
        status |= any(worst > 1e-5 for _, worst, _ in found)
        lines += [f"## {name}", "", "| | bone | design | design, trabeculae counted |", "|---|---|---|---|"]
        lines += ["| " + " | ".join(row) + " |" for row in rows(bone, [one for one, _, _ in found])]
        lines += ["| sliced areas off by at most | | " + " | ".join(f"{worst:.1g}" for _, worst, _ in found) + " |"]
        lines += ["| CPU s of the design | | " + " | ".join(f"{seconds:.1f}" for _, _, seconds in found) + " |", ""]
    text = "\n".join(lines)
    print(text)
    page.write_text(text, encoding="utf-8")
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
