# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voxel designs: our time beside integer programming's, the thesis' and the prototype's (``make bench`` runs it too).

    python3 tools/bench_voxels.py [--largest 512]    # writes its part of docs/performance.md

Integer programming (HiGHS in scipy) gets the same targets in the same run, in a box of 40^3: larger ones take it
minutes. The prototype is a first sketch of our own method; its times were written down once. Every piece runs in a
process of its own on one thread: CPU seconds of the work (imports and reading the sample not counted), peak memory of
the whole process. The samples are those of the folder TRABECULA_DATA (default ../shared/data).
"""

import argparse
import json
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import generated_page

ROOT = Path(__file__).resolve().parent.parent
DATA = Path(os.environ.get("TRABECULA_DATA") or ROOT.parent / "shared" / "data")
SHREW, HUMAN = "shrew_cube_10mm.stl", "trab_ior_10mm_13MB.stl"

#: work, piece, the thesis or the prototype (measured when it was written), goal
ROWS = (
    ("tables and layers, thesis' route, 103 x 94 x 103", "thesis", "thesis 1382 s", "1 s"),
    ("sliced areas on three axes, 40^3, human bone", "small", "", "1 s"),
    ("trabecular 100^3, shrew cube", "shrew any", "thesis could not; prototype 0.5 s", "1 s"),
    ("trabecular 104 x 94 x 104, human bone", "human any", "thesis could not; prototype 0.7 s", "1 s"),
    ("no contact by an edge alone, shrew cube", "shrew edge", "prototype 0.7 s", "2.5 s"),
    ("no contact by an edge alone, human bone", "human edge", "prototype 2.1 s", "2.5 s"),
    ("trabeculae counted on three axes, human bone", "human counted", "prototype 24 s", "15 s, 3 %"),
    ("200^3, waves of 14 voxels", "box 200", "prototype 5 s", "5 s"),
    ("400^3, waves of 14 voxels", "box 400", "prototype 62 s, 4.8 GB", "60 s, 3 GB"),
    ("400^3, waves of 8 voxels", "box 400 8", "-", "60 s, 3 GB"),
    ("512^3, waves of 14 voxels", "box 512", "-", "180 s, 6 GB"),
    ("mesh of a 100^3 design, watertight, written", "mesh", "-", "5 s"),
    ("log10 of the numbers of tables and designs", "count", "-", "10 s, 1 %"),
)


def clock(work):
    """Return a result and its CPU seconds."""
    start = time.process_time()
    result = work()
    return result, time.process_time() - start


def held(voxels, targets):
    """Return in words whether a design is what it must be."""
    from freecad_trabecula.core.voxels.connectivity import closed_cavities, edge_contacts, parts
    from freecad_trabecula.core.voxels.verification import layer_errors

    return (
        f"layers off {len(layer_errors(voxels, targets))}, parts {len(parts(voxels)[1]) - 1}, closed cavities "
        f"{len(closed_cavities(voxels)[1]) - 1}, contacts by an edge {edge_contacts(voxels)}"
    )


def trabecular(file, contacts, trabeculae):
    """Return CPU seconds of a design of a sample, the fit of its texture included, and what it is."""
    import scipy.ndimage  # noqa: F401  imports are not counted
    from voxel_runs import made

    from freecad_trabecula.core.voxels.parameters import VoxelParameters
    from freecad_trabecula.core.voxels.sources import read_targets
    from freecad_trabecula.core.voxels.trabeculae import mean_deviation, trabecula_counts

    parameters = VoxelParameters(contacts=contacts, trabeculae=trabeculae)
    targets = read_targets(DATA / file, parameters)
    voxels, seconds = made(targets, parameters)
    pairs = zip(trabecula_counts(voxels), trabecula_counts(targets.sample))
    off = 100 * sum(mean_deviation(count, goal) for count, goal in pairs) / 3
    counted = "" if trabeculae == "off" else f", trabeculae a layer off by {off:.1f} %"
    return seconds, held(voxels, targets) + counted


def box(edge, waves="14"):
    """Return CPU seconds and peak memory of a box of the human bone's profiles, and its faults."""
    command = [sys.executable, str(ROOT / "tools" / "voxel_runs.py"), "grown", "--edges", edge, "--waves", waves]
    shown = subprocess.run([*command, "--data", str(DATA)], check=True, stdout=subprocess.PIPE).stdout
    _, _, seconds, memory, faults = json.loads(shown)
    return seconds, f"faults {faults}", memory


def thesis():
    """Return CPU seconds of tables and layers by the thesis' first strategy, and whether they are exact."""
    from voxel_checks import thesis_targets

    from freecad_trabecula.core.voxels.design import make_design
    from freecad_trabecula.core.voxels.parameters import VoxelParameters
    from freecad_trabecula.core.voxels.verification import layer_errors

    targets = thesis_targets(DATA)
    design, seconds = clock(lambda: make_design(targets, VoxelParameters(strategy="minimum-zeros")))
    return seconds, f"layers off {len(layer_errors(design.voxels, targets))}"


def small_targets():
    """Return the targets of the human bone in 40^3 voxels."""
    from freecad_trabecula.core.voxels.parameters import VoxelParameters
    from freecad_trabecula.core.voxels.sources import read_targets

    return read_targets(DATA / HUMAN, VoxelParameters(size=0.25))


def small():
    """Return CPU seconds of a trabecular design in a small box, and what it is."""
    from voxel_runs import made

    from freecad_trabecula.core.voxels.parameters import VoxelParameters

    targets = small_targets()
    voxels, seconds = made(targets, VoxelParameters(size=0.25))
    return seconds, held(voxels, targets)


def integer_program():
    """Return CPU seconds of HiGHS for the same box, one unknown a voxel, one equation a layer, and what it is."""
    import numpy as np
    from scipy.optimize import Bounds, LinearConstraint, milp
    from scipy.sparse import csr_matrix, vstack

    targets = small_targets()
    goals = (targets.c, targets.e, targets.d)
    shape = tuple(len(goal) for goal in goals)
    cells = int(np.prod(shape))
    layers = vstack([
        csr_matrix((np.ones(cells), (place.ravel(), np.arange(cells))), shape=(edge, cells))
        for place, edge in zip(np.indices(shape), shape)
    ])  # fmt: skip
    wanted = np.concatenate(goals)
    found, seconds = clock(lambda: milp(
        np.zeros(cells), integrality=np.ones(cells), bounds=Bounds(0, 1),
        constraints=LinearConstraint(layers.tocsr(), wanted, wanted),
    ))  # fmt: skip
    if found.x is None:
        return seconds, found.message
    return seconds, held(found.x.reshape(shape) > 0.5, targets)


def mesh():
    """Return CPU seconds of blocks made and written as STL, and their triangles."""
    from freecad_trabecula.core.stl import write_stl
    from freecad_trabecula.core.voxels.blocks import block_mesh
    from freecad_trabecula.core.voxels.design import make_design
    from freecad_trabecula.core.voxels.parameters import VoxelParameters
    from freecad_trabecula.core.voxels.sources import read_targets

    design = make_design(read_targets(DATA / SHREW, VoxelParameters()), VoxelParameters())
    with tempfile.NamedTemporaryFile(suffix=".stl") as file:
        blocks, making = clock(lambda: block_mesh(design.voxels, design.targets.voxel))
        _, writing = clock(lambda: write_stl(file.name, blocks))
    return making + writing, f"{len(blocks.triangles)} triangles"


def count():
    """Return CPU seconds of all estimates for one design, and the largest standard error beside its logarithm."""
    from voxel_checks import thesis_targets

    from freecad_trabecula.core.voxels.counting import count_systems
    from freecad_trabecula.core.voxels.design import make_design
    from freecad_trabecula.core.voxels.parameters import VoxelParameters

    design = make_design(thesis_targets(DATA), VoxelParameters(strategy="minimum-zeros"))
    counts, seconds = clock(lambda: count_systems(design))
    worst = max(100 * found.standard_error / found.log10 for found in counts)
    return seconds, f"standard errors up to {worst:.1g} %; designs 10^{counts.designs.log10:.2f}"


PIECES = {"thesis": thesis, "small": small, "milp": integer_program, "mesh": mesh, "count": count}


def piece(name):
    """Return [CPU s, GB, what came out] of one piece."""
    kind, _, what = name.partition(" ")
    if kind == "box":
        seconds, text, memory = box(*what.split())
        return [seconds, memory, text]
    if kind in ("shrew", "human"):
        counted = what == "counted"
        chosen = ("edge", "xyz") if counted else (what, "off")
        seconds, text = trabecular(SHREW if kind == "shrew" else HUMAN, *chosen)
    else:
        seconds, text = PIECES[kind]()
    return [seconds, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6, text]


def measured(name):
    """Return CPU seconds and GB of a piece in a process of its own, and what came out, in words."""
    shown = subprocess.run([sys.executable, __file__, "--piece", name], stdout=subprocess.PIPE)
    if shown.returncode:
        return "failed", f"exit code {shown.returncode}"
    seconds, memory, text = json.loads(shown.stdout)
    return f"{seconds:.2f}, {memory:.2f}", text


def run(largest=512):
    """Measure every row in a process of its own, boxes up to an edge, and write the part of the page."""
    import numpy
    import scipy

    lines = ["| work | ours: CPU s, GB | others: CPU s | goal | result |", "|---|---|---|---|---|"]
    for work, name, other, goal in ROWS:
        if name.startswith("box") and int(name.split()[1]) > largest:
            continue
        figures, text = measured(name)
        if name == "small":
            theirs, what = measured("milp")
            other = f"integer programming: {theirs}; {what}"
        lines.append(f"| {work} | {figures} | {other} | <= {goal} | {text} |")
        print(lines[-1], flush=True)
    head = (
        f"Made by `make bench`: Python {platform.python_version()}, numpy {numpy.__version__}, scipy "
        f"{scipy.__version__}, {os.cpu_count()} cores, one thread."
    )
    generated_page.write_part("performance.md", "voxels", head + "\n\n" + "\n".join(lines))
    return 0


def main():
    """Run one piece, or all."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    sys.path.insert(0, str(ROOT))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--piece", default="")
    parser.add_argument("--largest", type=int, default=512, help="boxes up to this edge, voxels")
    chosen = parser.parse_args()
    if not chosen.piece:
        return run(chosen.largest)
    print(json.dumps(piece(chosen.piece)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
