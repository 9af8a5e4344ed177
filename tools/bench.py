# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our time beside a rival's on the same work, in one run (``make bench``): CPU seconds and peak memory.

Every piece runs in a process of its own under FreeCAD, ours and the rival's in turn; then slices of a mesh
(``bench_slices.py``) and voxel designs (``bench_voxels.py``). A whole run writes docs/performance.md; ``ARGS="--only
scaffold slices"`` chooses pieces, and renews the parts of slices and voxels if these are chosen, ``ARGS=--growth``
measures how time and memory grow with the rods and draws docs/pictures/growth.png.
"""

import argparse
import dataclasses
import json
import resource
import sys
import tempfile
import time
from pathlib import Path

import bench_slices
import bench_voxels
import generated_page
import under_freecad

ROOT = Path(__file__).resolve().parent.parent
GROWTH = (5, 7, 10, 14, 20, 28)  # rods a direction and row: 75, 147, 300, 588, 1200, 2352 rods
MESH_UP_TO = 1200  # rods; beyond, the exact union takes minutes and says nothing new
CELL = 0.1  # mm


def designed(name, n=None):
    """Return job, envelope and wireframe of a preset, or of case 6 with n x n rods a direction in a cube of n mm."""
    from freecad_trabecula.core.parameters import PathParameters, PrismParameters
    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.geometry.design import make_design

    job = preset(name)
    if n:
        edge = max(10.0, float(n))
        prism = PrismParameters(l=edge, w=edge, h=edge, n_x=n, n_y=n, n_z=n)
        job = dataclasses.replace(job, prism=prism, path=PathParameters("box", box=(0.4 * edge,) * 3))
    design = make_design(job)
    return job, design.envelope, design.wireframe


def clock(work):
    """Return a result, its CPU seconds and the peak memory so far in GB."""
    start = time.process_time()
    result = work()
    return result, time.process_time() - start, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6


# ------------------------------------------------------------------------------------------------------- the pieces


def solids_ours():
    """Case 6 as valid solids of the right volume in a document."""
    import FreeCAD
    import numpy as np

    from freecad_trabecula.core.rods import rod_volumes
    from freecad_trabecula.core.wireframe import skin
    from freecad_trabecula.geometry.rod_solids import rod_solids

    job, _, made = designed("case6")
    document = FreeCAD.newDocument("Bench")

    def work():
        import Part

        network = document.addObject("Part::Feature", "Network")
        network.Shape = Part.makeCompound(list(rod_solids(made, job.rods)))
        document.recompute()
        return network.Shape

    shape, seconds, memory = clock(work)
    fine = rod_volumes(skin(made, job.rods, 65))
    apart = np.abs(np.array([s.Volume for s in shape.Solids]) / fine - 1)
    bad = sum(not s.isValid() for s in shape.Solids) + int((apart > 1e-3).sum())
    return seconds, memory, f"{len(shape.Solids)} solids, {bad} bad, volumes within {apart.max():.1e}"


def _end_wires(made):
    import Part
    from FreeCAD import Vector

    from freecad_trabecula.core.rods import build_rods

    rods = build_rods(made.paths, made.ends, 2, 16)
    flat = rods.poles @ rods.frames[:, :, None, :2] + rods.stations.centres[:, :, None, None]

    def edge(poles):
        curve = Part.BezierCurve()
        curve.setPoles([Vector(*p) for p in poles])
        return curve.toShape()

    for r in range(len(made)):
        path = Part.Wire([edge(piece) for piece in made.paths[r]])
        yield path, [Part.Wire([edge(piece) for piece in flat[r, k]]) for k in (0, 1)]


def solids_pipes():
    """The same rods swept by Part's own pipe shells (corrected Frenet)."""
    import Part

    _, _, made = designed("case6")
    wires = list(_end_wires(made))

    def work():
        good, failed = [], 0
        for path, ends in wires:
            try:
                shell = Part.BRepOffsetAPI.MakePipeShell(path)
                shell.setFrenetMode(True)
                for end in ends:
                    shell.add(end)
                shell.build()
                shell.makeSolid()
                shape = shell.shape()
                good.append(shape) if shape.isValid() and shape.Volume > 0 else None
                failed += not (shape.isValid() and shape.Volume > 0)
            except (Part.OCCError, RuntimeError, ValueError):
                failed += 1
        return good, failed

    (good, failed), seconds, memory = clock(work)
    return seconds, memory, f"{len(good)} solids, {failed} failed"


def _rods_and_box(name, n=None):
    from freecad_trabecula.core.rods import rod_mesh
    from freecad_trabecula.core.wireframe import skin

    job, envelope, made = designed(name, n)
    return job, envelope, rod_mesh(skin(made, job.rods), 0.2)


def _bodies(name, n, engine):
    from freecad_trabecula.core.bodies import scaffold_bodies
    from freecad_trabecula.core.parameters import ScaffoldParameters

    _, envelope, (vertices, triangles) = _rods_and_box(name, n)
    wanted = ScaffoldParameters(engine=engine, cell=CELL)
    bodies, seconds, memory = clock(lambda: scaffold_bodies(vertices, triangles, envelope.mesh, wanted))
    bad = [c.name for c in bodies.checks if not c.ok]
    volume = bodies.parts.scaffold_volume
    text = f"{len(vertices)} rods, {len(vertices) * len(triangles)} triangles, scaffold {volume:.3f} mm3"
    return seconds, memory, text + (f", FAILED {bad}" if bad else ", all checks held")


def _library(name, n=None):
    """manifold3d alone: solids from the same triangles, union, difference, intersection, meshes out."""
    import manifold3d as library
    import numpy as np

    _, envelope, (vertices, triangles) = _rods_and_box(name, n)

    def solid(points, corners):
        return library.Manifold(library.Mesh64(np.ascontiguousarray(points), corners.astype(np.uint64)))

    def work():
        rods = library.Manifold.batch_boolean([solid(v, triangles) for v in vertices], library.OpType.Add)
        box = solid(envelope.mesh.vertices, envelope.mesh.triangles)
        scaffold, channels = box - rods, box ^ rods
        scaffold.to_mesh64(), channels.to_mesh64()
        return scaffold.volume()

    volume, seconds, memory = clock(work)
    return seconds, memory, f"{len(vertices)} rods, scaffold {volume:.3f} mm3"


def _shell(preset):
    """All outputs by the command line: its own process and FreeCAD's."""
    import subprocess

    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [
            "/usr/bin/python3",
            "-m",
            "freecad_trabecula",
            "design",
            "--preset",
            preset,
            "--out",
            folder,
            "--quiet",
        ]
        code = subprocess.call(command, cwd=str(ROOT), stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        report = json.loads((Path(folder) / "report.json").read_text()) if code == 0 else {}
        size = sum(f.stat().st_size for f in Path(folder).iterdir()) / 1e6
    return seconds, after.ru_maxrss / 1e6, f"exit {code}, {report.get('rods')} rods, {size:.0f} MB of files"


PIECES = {
    "solids ours": solids_ours,
    "solids pipes": solids_pipes,
    "scaffold ours": lambda: _bodies("case6", None, "mesh"),
    "scaffold library": lambda: _library("case6"),
    "prism420": lambda: _shell("prism420"),
    "cranial": lambda: _shell("cranial"),
    "femur": lambda: _shell("femur"),
    "1200 ours": lambda: _bodies("case6", 20, "mesh"),
    "1200 library": lambda: _library("case6", 20),
    "1200 field": lambda: _bodies("case6", 20, "field"),
}
#: work, our piece, rival's name and piece (or its seconds from the thesis), goal
ROWS = (
    ("case 6: rods as solids in the document", "solids ours", "Part's pipe shells", "solids pipes", "<= 3 s, none bad"),
    ("case 6: scaffold and channels", "scaffold ours", "manifold3d alone", "scaffold library", "<= 1.3 x, 6 s, 0.5 GB"),
    ("prism of 420 rods, all outputs", "prism420", "thesis", 900, "<= 30 s"),
    ("craniofacial plate, all outputs", "cranial", "thesis", 1143, "<= 30 s"),
    ("metaphysis, all outputs", "femur", "thesis", 4724, "<= 45 s"),
    ("1,200 rods in 20 mm, exact", "1200 ours", "manifold3d alone", "1200 library", "<= 1.2 x time and memory"),
    ("the same by cells of 0.1 mm", "1200 field", "our exact engine", "1200 ours", "<= 10 s, <= 0.8 GB, 0.2 %"),
)  # fmt: skip


def measure(piece, n=0):
    """Run one piece in a process of its own and return [CPU s, GB, what came out]."""
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        arguments = ["--piece", piece, "--result", file.name, "--rods", str(n)]
        code = under_freecad.run(__file__, arguments, stdout=sys.stderr)
        text = Path(file.name).read_text()
    return json.loads(text) if code == 0 and text else [float("nan"), float("nan"), f"failed, exit code {code}"]


def compare(only):
    """Measure the rows asked for, print and write the page."""
    lines = ["| work | ours: CPU s, GB | rival: CPU s, GB | ratio | goal | result |", "|---|---|---|---|---|---|"]
    known = {}
    for work, ours, rival, other, goal in ROWS:
        if only and not any(word in ours for word in only):
            continue
        for piece in (ours, other):
            if isinstance(piece, str) and piece not in known:
                known[piece] = measure(piece)
        seconds, memory, text = known[ours]
        if isinstance(other, str):
            theirs = f"{rival}: {known[other][0]:.1f}, {known[other][1]:.2f} ({known[other][2]})"
            ratio = seconds / known[other][0]
        else:
            theirs, ratio = f"{rival}: {other}, -", seconds / other
        lines.append(f"| {work} | {seconds:.1f}, {memory:.2f} | {theirs} | {ratio:.3g} | {goal} | {text} |")
        print(lines[-1], flush=True)
    generated_page.write_bench("bench.md", "# Our time beside a rival's\n\n" + "\n".join(lines))
    if not only:
        generated_page.write_part("performance.md", "rods", "Made by `make bench`.\n\n" + "\n".join(lines))


def grow():
    """Measure time and memory against the number of rods, print, and draw the plot."""
    points = {"mesh": [], "field": []}
    for n in GROWTH:
        for engine, found in points.items():
            if engine == "field" or 3 * n * n <= MESH_UP_TO:
                seconds, memory, text = measure(f"growth {engine}", n)
                found.append((3 * n * n, seconds, memory))
                print(f"{engine:5} {3 * n * n:5} rods {seconds:7.1f} s {memory:5.2f} GB  {text}", flush=True)
    rows = [f"| {e} | {r} | {s:.1f} | {m:.2f} |" for e, found in points.items() for r, s, m in found]
    generated_page.write_bench("growth.md", "| engine | rods | CPU s | GB |\n|---|---|---|---|\n" + "\n".join(rows))
    draw(points)


def draw(points):
    """Draw both curves on logarithmic axes into docs/pictures/growth.png (needs matplotlib)."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.6))
    for name, found in points.items():
        rods, seconds, memory = zip(*found)
        for axis, values in zip(axes, (seconds, memory)):
            axis.loglog(rods, values, "o-", label=f"{name} engine")
    for axis, label in zip(axes, ("CPU seconds", "peak memory, GB")):
        axis.set_xlabel("rods (spacing 1 mm)")
        axis.set_ylabel(label)
        axis.grid(True, which="both", alpha=0.3)
        axis.legend()
    generated_page.save_picture(figure, "growth.png")


def main(arguments):
    """Run one piece; inside FreeCAD."""
    options = parse(arguments)
    if options.piece.startswith("growth "):
        result = _bodies("case6", options.rods, options.piece.split()[1])
    else:
        result = PIECES[options.piece]()
    Path(options.result).write_text(json.dumps(result))
    return 0


def parse(arguments):
    """Return the options."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--growth", action="store_true")
    parser.add_argument("--piece", default="")
    parser.add_argument("--result", default="")
    parser.add_argument("--rods", type=int, default=0)
    return parser.parse_args(arguments)


if __name__ == "__main__":
    chosen = parse(sys.argv[1:])
    grow() if chosen.growth else compare(chosen.only)
    if not chosen.growth and (not chosen.only or "slices" in chosen.only):
        bench_slices.run(bench_slices.parse([]))
    if not chosen.growth and (not chosen.only or "voxels" in chosen.only):
        bench_voxels.run()
