# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slices of one mesh by Trabecula and by others: time, memory, and whether they agree (``make bench`` runs it too).

    python3 tools/bench_slices.py               speed: every row of the goals, others beside ours
    python3 tools/bench_slices.py --compare     100 planes of each axis, plane by plane against the others
    python3 tools/bench_slices.py --growth      how time and memory grow; draws docs/pictures/slices-growth.png

The mesh is trab_ior_10mm_13MB.stl of the folder TRABECULA_DATA (default: ../shared/data), or the one given as
``--mesh``. Every piece runs in a process of its own, on one thread: CPU seconds from before the file is read to after
the last result (imports not counted), peak memory of the whole process. manifold3d and trimesh are asked if they can be
imported, FreeCAD's own ``Mesh.crossSections`` if there is a FreeCAD.
"""

import argparse
import importlib.util
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import generated_page
import under_freecad

ROOT = Path(__file__).resolve().parent.parent
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))
MESH = "trab_ior_10mm_13MB.stl"
THESIS_SECONDS = 1323 + 1468 + 1266  # Table 5.2: analysis of another sample of this size, on a computer of 2010
REPEATS = 3

#: work, mesh split in, planes an axis, piece, others, goal
ROWS = (
    ("file to measures of every contour, 3 x 100 planes", 1, 100, "contours", ("manifold3d", "trimesh", "FreeCAD"),
     "0.4 s, 150 MB"),
    ("the same, every triangle split in 8", 8, 100, "contours", ("manifold3d", "trimesh"), "1.8 s, 400 MB"),
    ("sliced areas only", 1, 100, "areas", (), "0.2 s"),
    ("sliced areas only, split in 8", 8, 100, "areas", (), "0.6 s"),
    ("3 x 1000 planes", 1, 1000, "contours", (), "1.3 s"),
    ("3 x 1000 planes, split in 8", 8, 1000, "contours", (), "6 s, 800 MB"),
)  # fmt: skip
GROWTH_SPLITS, GROWTH_PLANES = (1, 4, 8, 16), (10, 30, 100, 300, 1000)


# ------------------------------------------------------------------------------------------------------- the meshes


def split(triangles, into):
    """Split every triangle in 4 at the middles of its edges, in 8 or in 16; what was closed stays closed."""
    import numpy as np

    if into == 1:
        return triangles
    if into == 16:
        return split(split(triangles, 4), 4)
    a, b, c = triangles.transpose(1, 0, 2)
    half = np.float32(0.5)
    d, e, f = (a + b) * half, (b + c) * half, (c + a) * half
    parts = [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
    if into == 8:  # two of the four again, about their middles: inside, where no neighbour minds
        m, n = ((p + q + r) / np.float32(3) for p, q, r in (parts[0], parts[3]))
        parts = [*parts[1:3], (a, d, m), (d, f, m), (f, a, m), (d, e, n), (e, f, n), (f, d, n)]
    return np.stack([np.stack(part, 1) for part in parts], 1).reshape(-1, 3, 3)


def split_file(mesh, into, folder):
    """Return the path of the mesh with every triangle split; made by a process of its own.

    Linux counts the memory of a process from that of the one that started it: this one must stay small.
    """
    if into == 1:
        return str(mesh)
    path = Path(folder) / f"split{into}.stl"
    if not path.exists() and start("split", mesh, into, path):
        raise SystemExit("the mesh could not be split")
    return str(path)


def write_split(mesh, into, path):
    """Write the mesh with every triangle split."""
    import numpy as np

    from freecad_trabecula.core.stl import read_triangles

    corners = split(np.ascontiguousarray(read_triangles(mesh)), into)
    records = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    records["corners"] = corners
    Path(path).write_bytes(bytes(80) + np.uint32(len(corners)).tobytes() + records.tobytes())


def planes_of(box, count):
    """Middles of ``count`` layers along each axis."""
    import numpy as np

    return [low + (np.arange(count) + 0.5) * (high - low) / count for low, high in zip(*box)]


# ------------------------------------------------------------------------------------------------------- the pieces


def contours(path, count):
    """Ours, with neighbours, contours and all their measures."""
    import numpy as np

    from freecad_trabecula.core.analysis.contours import contour_measures
    from freecad_trabecula.core.analysis.neighbours import neighbours
    from freecad_trabecula.core.analysis.parameters import SliceParameters
    from freecad_trabecula.core.analysis.slices import slice_contours
    from freecad_trabecula.core.analysis.triangles import read_soup

    def work():
        soup = read_soup(path, "mm")
        partners, found = neighbours(soup.triangles), []
        for axis, heights in zip("xyz", planes_of(soup.box, count)):
            slices = slice_contours(soup.triangles, axis, heights, partners=partners)
            m = contour_measures(slices, SliceParameters())
            counted = np.abs(m.area) > 1e-6
            found.append((np.bincount(m.plane, m.area, count), np.bincount(m.plane, np.abs(m.area), count),
                          np.bincount(m.plane[counted], minlength=count), int((~slices.closed).sum())))  # fmt: skip
            del slices, m
        return found

    return work


def union(path, count):
    """Ours, with all that overlaps united."""
    import numpy as np

    from freecad_trabecula.core.analysis.analysis import contours_of
    from freecad_trabecula.core.analysis.contours import contour_measures
    from freecad_trabecula.core.analysis.parameters import SliceParameters
    from freecad_trabecula.core.analysis.triangles import read_soup

    def work():
        soup, found = read_soup(path, "mm"), []
        for axis, heights in zip("xyz", planes_of(soup.box, count)):
            chosen = SliceParameters(at="heights", heights=tuple(heights), fill="union")
            m = contour_measures(contours_of(soup, chosen, axis)[0], chosen)
            some = np.abs(m.area) > 1e-6
            number = np.bincount(m.plane[some], minlength=count)
            found.append((np.bincount(m.plane, m.area, count), np.bincount(m.plane, np.abs(m.area), count), number, 0))
        return found

    return work


def areas(path, count):
    """Ours, without contours."""
    from freecad_trabecula.core.analysis.slices import sliced_areas
    from freecad_trabecula.core.analysis.triangles import read_soup

    def work():
        soup = read_soup(path, "mm")
        return [
            (sliced_areas(soup.triangles, axis, heights), None, None, 0)
            for axis, heights in zip("xyz", planes_of(soup.box, count))
        ]

    return work


def manifold3d(path, count):
    """manifold3d: weld, make a solid, slice it: areas and numbers of contours of the union."""
    import manifold3d as library
    import numpy as np

    from freecad_trabecula.core.stl import read_stl

    def work():
        mesh = read_stl(path)
        # in single precision, as in the file, so that nothing falls together
        solid = library.Manifold(library.Mesh(mesh.vertices.astype(np.float32), mesh.triangles.astype(np.uint32)))
        low, high = mesh.vertices.min(0), mesh.vertices.max(0)
        found = []
        for k, heights in enumerate(planes_of((low, high), count)):
            turned = solid.transform(np.eye(4)[[(k + 1) % 3, (k + 2) % 3, k]][:, [0, 1, 2, 3]])
            slices = [turned.slice(h) for h in heights]
            area, number = np.array([s.area() for s in slices]), [s.num_contour() for s in slices]
            found.append((area, None, lambda slices=slices, number=number: counted(slices, number), 0))
        return found

    def counted(slices, number):
        """Numbers of contours above 1e-6 mm2: ours does not count smaller ones either."""
        for plane, s in enumerate(slices):
            for polygon in s.to_polygons():
                (u, v), (p, q) = polygon.T, np.roll(polygon, -1, 0).T
                number[plane] -= int(abs((u * q - p * v).sum()) / 2 <= 1e-6)
        return number

    return work


def trimesh(path, count):
    """Slice with trimesh: paths of all planes, areas of their polygons."""
    import numpy as np
    import trimesh as library

    def work():
        mesh, found = library.load(path), []
        for k, heights in enumerate(planes_of(mesh.bounds, count)):
            sections = mesh.section_multiplane(np.zeros(3), np.eye(3)[k], heights)
            area = [0.0 if s is None else s.area for s in sections]
            number = [0 if s is None else len(s.polygons_closed) for s in sections]
            found.append((np.array(area), None, np.array(number), 0))
        return found

    return work


def freecad(path, count):
    """FreeCAD's own Mesh.crossSections with eps 1e-6: its polylines run either way: only sums of |area| count."""
    import Mesh
    import numpy as np
    from FreeCAD import Vector

    def work():
        mesh, found = Mesh.Mesh(path), []
        b = mesh.BoundBox
        box = (b.XMin, b.YMin, b.ZMin), (b.XMax, b.YMax, b.ZMax)
        for k, heights in enumerate(planes_of(box, count)):
            normal = [0.0, 0.0, 0.0]
            normal[k] = 1.0
            sections = mesh.crossSections([(Vector(*(h * n for n in normal)), Vector(*normal)) for h in heights], 1e-6)
            area, number, opened = np.zeros(count), np.zeros(count, int), 0
            for plane, polylines in enumerate(sections):
                for polyline in polylines:
                    points = np.array([tuple(p) for p in polyline])[:, [(k + 1) % 3, (k + 2) % 3]]
                    is_open = np.abs(points[0] - points[-1]).max() > 1e-6
                    opened += is_open
                    u, v = (points - points[0]).T
                    size = abs((u[:-1] * v[1:] - u[1:] * v[:-1]).sum()) / 2
                    area[plane] += 0.0 if is_open else size
                    number[plane] += size > 1e-6
            found.append((None, area, number, opened))
        return found

    return work


PIECES = {
    "contours": contours,
    "areas": areas,
    "union": union,
    "manifold3d": manifold3d,
    "trimesh": trimesh,
    "FreeCAD": freecad,
}


def main(arguments):
    """Run one piece and write [CPU s, MB, results]; ours and libraries' in plain Python, FreeCAD's inside FreeCAD."""
    options = parse(arguments)
    if options.piece == "split":
        write_split(options.mesh, options.planes, options.result)
        return 0
    work = PIECES[options.piece](options.mesh, options.planes)
    start = time.process_time()
    found = work()
    seconds = time.process_time() - start
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3
    found = [[x() if callable(x) else x for x in axis] for axis in found]  # what need not be timed
    plain = [[x.tolist() if hasattr(x, "tolist") else x for x in axis] for axis in found]
    Path(options.result).write_text(json.dumps([seconds, memory, plain]))
    return 0


def start(piece, mesh, planes, result):
    """Run one piece in a process of its own and return its exit code."""
    arguments = ["--piece", piece, "--result", str(result), "--mesh", str(mesh), "--planes", str(planes)]
    if piece == "FreeCAD":
        return under_freecad.run(__file__, arguments, stdout=subprocess.DEVNULL)
    paths = os.pathsep.join([str(ROOT), str(ROOT / "tools"), *sys.path[1:]])
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", PYTHONPATH=paths)
    return subprocess.call([sys.executable, __file__, *arguments], env=environment)


def measure(piece, path, count, repeats=1):
    """Return the median CPU seconds, the largest MB and the results of a piece; None if it cannot run."""
    if piece in ("manifold3d", "trimesh") and importlib.util.find_spec(piece) is None:
        return None
    found = []
    for _ in range(repeats):
        with tempfile.NamedTemporaryFile(suffix=".json") as file:
            code = start(piece, path, count, file.name)
            text = Path(file.name).read_text()
        if code or not text:
            return None
        found.append(json.loads(text))
    return sorted(f[0] for f in found)[len(found) // 2], max(f[1] for f in found), found[0][2]


# ---------------------------------------------------------------------------------------------------------- the pages


def speed(mesh):
    """Measure, print and write every row of the goals, others beside ours."""
    lines = ["| work | triangles | ours: CPU s, MB | others: CPU s, MB | goal |", "|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for work, into, count, piece, others, goal in ROWS:
            path = split_file(mesh, into, folder)
            ours = measure(piece, path, count, REPEATS)
            beside = [f"thesis: {THESIS_SECONDS} s (another sample)"] if others and into == 1 else []
            for other in others:
                theirs = measure(other, path, count)
                figures = "not installed" if theirs is None else f"{theirs[0]:.2f}, {theirs[1]:.0f}"
                beside.append(f"{other}: {figures}")
            triangles = (Path(path).stat().st_size - 84) // 50
            text = "failed" if ours is None else f"{ours[0]:.2f}, {ours[1]:.0f}"
            lines.append(f"| {work} | {triangles} | {text} | {'; '.join(beside) or '-'} | {goal} |")
            print(lines[-1], flush=True)
    text = f"{Path(mesh).name}, median of {REPEATS} runs.\n\n" + "\n".join(lines)
    generated_page.write_part("performance.md", "slices", text)


#: What is compared with what of ours, and its name.
COMPARED = (
    ("contours", "contours", "Trabecula, winding"),
    ("contours", "areas", "Trabecula, areas alone"),
    ("contours", "union", "Trabecula, union"),
    ("contours", "manifold3d", "manifold3d (union)"),
    ("union", "manifold3d", "manifold3d, against our union"),
    ("contours", "trimesh", "trimesh (even-odd)"),
    ("contours", "FreeCAD", "FreeCAD, eps 1e-6 (sums of areas without sign)"),
)


def compare(mesh, count=100):
    """Compare every plane of every axis with the others: numbers of contours, areas; print and write the table."""
    import numpy as np

    head = "| program | CPU s | MB | planes with as many contours | area: median, largest relative difference | open |"
    lines, known = [head, "|---|---|---|---|---|---|"], {}
    for piece in {name: None for pair in COMPARED for name in pair[:2]}:
        known[piece] = measure(piece, mesh, count)
    for one, other, name in COMPARED:
        ours, theirs = known[one], known[other]
        if theirs is None:
            lines.append(f"| {name} | not installed | | | | |")
            continue
        away, same, opened = [], 0, 0
        for (area, sums, number, _), (a, b, c, d) in zip(ours[2], theirs[2]):
            away.append(np.array(b if a is None else a) / np.array(sums if a is None else area) - 1)
            same = None if c is None else same + int((np.array(c) == np.array(number)).sum())
            opened += d
        away = np.abs(np.concatenate(away))
        figures = f"{np.median(away):.1e}, {away.max():.1e} | {opened}"
        counts = "-" if same is None else f"{same} of {3 * count}"
        lines.append(f"| {name} | {theirs[0]:.2f} | {theirs[1]:.0f} | {counts} | {figures} |")
    print("\n".join(lines))
    title = f"# {count} planes along each axis of {Path(mesh).name}\n\n"
    generated_page.write_bench("slices-compared.md", title + "\n".join(lines))


def grow(mesh):
    """Measure time and memory against triangles and planes, print and draw them."""
    by_triangles, by_planes = [], {}
    with tempfile.TemporaryDirectory() as folder:
        for into in GROWTH_SPLITS:
            path = split_file(mesh, into, folder)
            triangles = (Path(path).stat().st_size - 84) // 50
            row = [measure(piece, path, 100)[:2] for piece in ("contours", "areas")]
            by_triangles.append((triangles, *row[0], *row[1]))
            print("%9d triangles: contours %5.2f s %4.0f MB, areas %5.2f s %4.0f MB" % by_triangles[-1], flush=True)
            if into in (1, 8):
                by_planes[triangles] = [(count, *measure("contours", path, count)[:2]) for count in GROWTH_PLANES]
                for row in by_planes[triangles]:
                    print("%9d triangles, 3 x %4d planes: %5.2f s %4.0f MB" % (triangles, *row), flush=True)
            if into > 1:
                Path(path).unlink()
    draw(by_triangles, by_planes)


def draw(by_triangles, by_planes):
    """Draw the growth into docs/pictures/slices-growth.png (needs matplotlib)."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4), sharey=True)
    triangles, seconds, _, areas_seconds, _ = zip(*by_triangles)
    axes[0].loglog(triangles, seconds, "o-", label="contours and measures")
    axes[0].loglog(triangles, areas_seconds, "s-", label="sliced areas only")
    axes[0].set_xlabel("triangles (3 x 100 planes)")
    for count, rows in by_planes.items():
        axes[1].loglog(*list(zip(*rows))[:2], "o-", label=f"{count:,} triangles")
    axes[1].set_xlabel("planes along each of 3 axes")
    axes[0].set_ylabel("CPU seconds, file to results")
    for axis, ticks in zip(axes, ([3e5, 1e6, 2e6, 4e6], GROWTH_PLANES)):
        axis.set_xticks(ticks, [f"{tick:,.0f}" for tick in ticks], minor=False)
        axis.set_yticks([0.1, 0.2, 0.5, 1, 2, 5, 10], ["0.1", "0.2", "0.5", "1", "2", "5", "10"], minor=False)
        axis.minorticks_off()
        axis.grid(True, alpha=0.3)
        axis.legend(loc="upper left")
    generated_page.save_picture(figure, "slices-growth.png")


def parse(arguments):
    """Return the options."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compare", action="store_true")
    parser.add_argument("--growth", action="store_true")
    parser.add_argument("--mesh", default=str(DATA / MESH))
    parser.add_argument("--planes", type=int, default=100)
    parser.add_argument("--piece", default="")
    parser.add_argument("--result", default="")
    return parser.parse_args(arguments)


def run(options):
    """Do what the options ask for; return the exit code."""
    sys.path.insert(0, str(ROOT))
    sys.path.insert(0, str(ROOT / "tests"))
    import conftest  # noqa: F401  FreeCAD's folder of additional packages

    if not Path(options.mesh).exists():
        print(f"{options.mesh} is not there: give a mesh with --mesh, or its folder in TRABECULA_DATA")
        return 1
    if options.compare:
        compare(options.mesh, options.planes)
    else:
        (grow if options.growth else speed)(options.mesh)
    return 0


if __name__ == "__main__":
    chosen = parse(sys.argv[1:])
    sys.exit(main(sys.argv[1:]) if chosen.piece else run(chosen))
