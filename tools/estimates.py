# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said before some work beside what came: seconds, memory, sizes of files.

    python3 tools/estimates.py           prints the table
    python3 tools/estimates.py --docs    writes it into docs/seeing.md too; with --only WORD some lines

Bones are those of the folder TRABECULA_DATA (default: ../shared/data). Every piece runs in a process of its own: CPU
seconds of the work, peak memory of the process less that before. Designs run under FreeCAD, the rest without.
"""

import argparse
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
from bench_slices import DATA, split

ROOT = Path(__file__).resolve().parent.parent
BONE, TINY, SHREW = "trab_ior_10mm_13MB.stl", "trab_ior_1p17mm_tiny.stl", "shrew_cube_10mm.stl"
FINE = "trab_ior_3p86mm_12MB.stl"
#: Name, piece, its arguments.
PIECES = (
    ("slices, 11,620 triangles, 3 x 30 planes", "slices", (TINY, 1, 30, False)),
    ("slices, 258,470 triangles, 3 x 100 planes", "slices", (BONE, 1, 100, False)),
    ("slices, 258,470 triangles, 3 x 1000 planes", "slices", (BONE, 1, 1000, False)),
    ("slices, 2,067,760 triangles, 3 x 100 planes", "slices", (BONE, 8, 100, False)),
    ("the same and morphometry, 11,620 triangles", "slices", (TINY, 1, 100, True)),
    ("the same and morphometry, 154,298 triangles", "slices", (SHREW, 1, 100, True)),
    ("the same and morphometry, 238,310 triangles", "slices", (FINE, 1, 100, True)),
    ("the same and morphometry, 258,470 triangles", "slices", (BONE, 1, 100, True)),
    ("slices of an OBJ, reading included, 258,470 triangles, 3 x 100 planes", "text", (BONE, ".obj", 100)),
    ("slices of an STL as text, reading included, 258,470 triangles, 3 x 100 planes", "text", (BONE, ".stl", 100)),
    ("tables and plots, 1,523 contours", "folder", (SHREW, 100)),
    ("tables and plots, 25,309 contours", "folder", (BONE, 100)),
    ("tables and plots, 75,050 contours", "folder", (BONE, 300)),
    ("workbook, 25,309 contours", "workbook", (BONE, 100)),
    ("workbook, 75,050 contours", "workbook", (BONE, 300)),
    *((f"{kind.upper()}, {planes} planes an axis", "layers", (BONE, planes, kind)) for kind in ("ssl", "cli", "svg")
      for planes in (30, 300)),
    ("comparison and plots, 2 x 25,309 contours", "comparison", (BONE, 100)),
    ("comparison and plots, 2 x 75,050 contours", "comparison", (BONE, 300)),
    ("case 6: rods, solids, scaffold", "design", ("case6",)),
    ("case 1: rods, solids, scaffold", "design", ("case1",)),
    ("femur: rods, solids, scaffold", "design", ("femur",)),
    ("10 other seeds by rays, case 6", "seeds", ("case6", 10, "rays")),
    ("5 other seeds with scaffolds, case 6", "seeds", ("case6", 5, "scaffold")),
    ("3 other seeds by rays, femur", "seeds", ("femur", 3, "rays")),
    ("3 other seeds of voxels, 104 x 94 x 104", "seeds", (BONE, 3, 0.1)),
)  # fmt: skip
UNDER_FREECAD = ("design", "seeds")


class Bone:
    """A bone, sliced, with what is known of it beforehand."""

    def __init__(self, name, into, planes):
        import numpy as np

        from freecad_trabecula.core.analysis.parameters import SliceParameters
        from freecad_trabecula.core.analysis.triangles import Soup, read_soup
        from freecad_trabecula.core.estimates import body_of, planes_of
        from freecad_trabecula.core.file_bodies import body_of_file

        self.soup = read_soup(DATA / name, "mm")
        self.body = body_of_file(DATA / name)
        if into > 1:
            self.soup = Soup(split(np.ascontiguousarray(self.soup.triangles), into), "mm", name)
            self.body = body_of(self.soup.triangles)
        self.parameters = SliceParameters(thickness=float(np.ptp(self.soup.box, axis=0).max()) / planes)
        self.planes = list(planes_of(self.parameters, self.soup.box).values())

    def contours(self):
        """All contours, by axis."""
        from freecad_trabecula.core.analysis.analysis import contours_of

        return {axis: contours_of(self.soup, self.parameters, axis)[0] for axis in self.parameters.axes}

    def analysis(self):
        """Slices and measures; for each axis numbers of planes and contours."""
        from freecad_trabecula.core.analysis.analysis import analyse

        found = analyse(self.soup, self.parameters, False)
        return found, [(len(one), int(one.contours.sum())) for one in found.profiles.values()]


def slices(name, into, planes, morphometry):
    """Said, and the work."""
    from freecad_trabecula.core.analysis.analysis import analyse
    from freecad_trabecula.core.estimates import analysis_work

    bone = Bone(name, into, planes)

    def work(_):
        analyse(bone.soup, bone.parameters, morphometry)
        bone.contours()

    return analysis_work(bone.body, bone.planes, morphometry), work


def text(name, kind, planes):
    """Said of a mesh file at a glance, and its reading and slicing."""
    from freecad_trabecula.core.analysis.analysis import analyse
    from freecad_trabecula.core.analysis.parameters import SliceParameters
    from freecad_trabecula.core.analysis.triangles import read_soup
    from freecad_trabecula.core.estimates import analysis_work, planes_of
    from freecad_trabecula.core.file_bodies import body_of_file, reading_work

    path = Path(tempfile.mkdtemp()) / f"bone{kind}"
    child = os.fork()  # the writing needs memory of its own
    if not child:
        _write_text(path, read_soup(DATA / name, "mm").triangles)
        os._exit(0)
    os.waitpid(child, 0)
    body = body_of_file(path)
    parameters = SliceParameters(thickness=body.size / planes)
    said = reading_work(path, body.triangles)
    said = said.and_then(analysis_work(body, list(planes_of(parameters, body.box).values())))

    def work(_):
        from freecad_trabecula.core.analysis.analysis import contours_of

        soup = read_soup(path, "mm")
        analyse(soup, parameters, False)
        for axis in parameters.axes:
            contours_of(soup, parameters, axis)
        path.unlink()

    return said, work


def _write_text(path, triangles):
    """An OBJ, or an STL as text."""
    import numpy as np

    from freecad_trabecula.core.mesh_formats import write_obj
    from freecad_trabecula.core.meshes import Mesh

    if path.suffix == ".obj":
        vertices, places = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
        write_obj(path, Mesh(vertices.astype(float), places.reshape(-1, 3)))
        return
    with open(path, "w", encoding="ascii") as file:
        file.write("solid bone\n")
        for corners in triangles.tolist():
            lines = "".join("vertex {:.6e} {:.6e} {:.6e}\n".format(*corner) for corner in corners)
            file.write(f"facet normal 0 0 0\nouter loop\n{lines}endloop\nendfacet\n")
        file.write("endsolid bone\n")


def folder(name, planes):
    """Said, and the work."""
    from freecad_trabecula.core.analysis.branches import trace_branches
    from freecad_trabecula.core.analysis.folder import save_analysis
    from freecad_trabecula.core.analysis.plots import analysis_figures, save_figure
    from freecad_trabecula.core.estimates import saving_work

    bone = Bone(name, 1, planes)
    (found, counts), every = bone.analysis(), bone.contours()

    def work(place):
        least = bone.parameters.least_area
        branches = {axis: trace_branches(one, found.measures[axis], least) for axis, one in every.items()}
        for title, figure in analysis_figures(found):
            save_figure(figure, place / f"{title}.png", "png")
        save_analysis(found, place, branches=branches)

    return saving_work(counts, found.summary("z").mean_bone_fraction), work


def workbook(name, planes):
    """Said, and the work."""
    from freecad_trabecula.core.analysis.workbook import write_workbook
    from freecad_trabecula.core.estimates import workbook_work

    found, counts = Bone(name, 1, planes).analysis()
    return workbook_work(counts), lambda place: write_workbook(place / "a.xlsx", found.profiles, found.measures)


def layers(name, planes, kind):
    """Said of what is known before anything is sliced, and the work."""
    from freecad_trabecula.core import estimates
    from freecad_trabecula.core.analysis.cli_layers import write_cli
    from freecad_trabecula.core.analysis.ssl import write_ssl
    from freecad_trabecula.core.analysis.svg_layers import write_svg

    bone = Bone(name, 1, planes)
    every, thickness = bone.contours(), bone.parameters.thickness
    writers = {
        "ssl": lambda path, one: write_ssl(path, one, thickness, path.name),
        "cli": lambda path, one: write_cli(path, one, thickness),
        "svg": lambda path, one: write_svg(path, one),
    }
    cut, count = estimates.segments(bone.body, bone.planes), estimates.contours(bone.body, bone.planes)
    said = estimates.layers_work(kind, cut, count, sum(n for n, _ in bone.planes), bone.body.box)
    return said, lambda place: [writers[kind](place / f"{axis}.{kind}", one) for axis, one in every.items()]


def comparison(name, planes):
    """Said, and the work."""
    from freecad_trabecula.core.analysis.comparison import compare
    from freecad_trabecula.core.analysis.passport import passport
    from freecad_trabecula.core.analysis.plots import comparison_figures, save_figure
    from freecad_trabecula.core.estimates import comparison_work

    found, counts = Bone(name, 1, planes).analysis()

    def work(place):
        compared = compare([found, found])
        passport(found, found)
        for title, figure in comparison_figures(compared, [found, found]):
            save_figure(figure, place / f"{title}.png", "png")

    return comparison_work(2 * sum(one for _, one in counts), len(counts), True), work


def design(name):
    """Said of a job as soon as its envelope is there, and the design; under FreeCAD."""
    import FreeCAD

    from freecad_trabecula import make
    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.features import results

    document, job = FreeCAD.newDocument(), preset(name)
    envelope = make.make_job_envelope(document, job)
    said = make.estimate_design(job, envelope.Shape)
    results.clear()
    return said, lambda _: make.make_design(document, job, ("network", "scaffold"), envelope)


def seeds(name, count, by):
    """Said, and the work; under FreeCAD."""
    import FreeCAD

    from freecad_trabecula import make
    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.core.variants import RAYS, SCAFFOLD
    from freecad_trabecula.core.voxels.parameters import VoxelParameters
    from freecad_trabecula.features.estimates import variants_work

    document = FreeCAD.newDocument()
    if by in ("rays", "scaffold"):
        obj, by = make.make_design(document, preset(name)).wireframe, {"rays": RAYS, "scaffold": SCAFFOLD}[by]
    else:
        obj, by = make.make_voxel_design(document, str(DATA / name), VoxelParameters(size=(by,) * 3)), RAYS
    return variants_work(obj, count, by), lambda _: make.make_variants(obj, list(range(101, 101 + count)), by)


def measured(said, work):
    """What came: CPU seconds, bytes of memory and of files; what was said before them."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with tempfile.TemporaryDirectory() as place:
        start = time.process_time()
        work(Path(place))
        seconds = time.process_time() - start
        size = sum(path.stat().st_size for path in Path(place).rglob("*") if path.is_file())
    more = 1024 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
    return [*said, seconds, more, size]


def main(arguments):
    """A piece, in a process of its own."""
    piece, options, path = arguments
    sys.path.insert(0, str(ROOT))
    Path(path).write_text(json.dumps(measured(*globals()[piece](*json.loads(options)))))
    return 0


def run(piece, options):
    """Run a piece; return what was said and what came."""
    with tempfile.TemporaryDirectory() as place:
        path = str(Path(place) / "found.json")
        arguments = [piece, json.dumps(options), path]
        if piece in UNDER_FREECAD:
            status = under_freecad.run(__file__, arguments, stdout=subprocess.DEVNULL)
        else:
            status = subprocess.call([sys.executable, __file__, *arguments])
        if status:
            raise SystemExit(f"{piece} {options} ended with {status}")
        return json.loads(Path(path).read_text())


def table(rows):
    """The rows as markdown: seconds, MB of memory, MB of files, each said, came and their ratio."""
    lines = [
        "| work | s: said | came | ratio | memory, MB: said | came | ratio | files, MB: said | came | ratio |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for name, found in rows:
        cells = [name]
        for said, came, unit in zip(found[:3], found[3:], (1.0, 1e6, 1e6)):
            cells += [f"{said / unit:.3g}", f"{came / unit:.3g}", f"{said / came:.2f}"] if said and came else [""] * 3
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def _with_others(lines):
    """The table with the lines of the page for the works that were not measured now."""
    page = (generated_page.DOCS / "seeing.md").read_text(encoding="utf-8")
    before = page.split("<!-- estimates: begin -->")[1].split("<!-- estimates: end -->")[0].strip().splitlines()
    found = {line.split(" | ")[0][2:]: line for line in [*before[2:], *lines[2:]]}
    return "\n".join([*lines[:2], *(found[name] for name, *_ in PIECES if name in found)])


def _all():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--docs", action="store_true", help="write the table into docs/seeing.md")
    parser.add_argument("--only", default="", help="a part of the names of works")
    chosen = parser.parse_args()
    rows = []
    for name, piece, options in PIECES:
        if chosen.only in name:
            rows.append((name, run(piece, options)))
            print(table(rows[-1:]).splitlines()[-1], flush=True)
    if chosen.docs:
        generated_page.write_part("seeing.md", "estimates", _with_others(table(rows).splitlines()))


if __name__ == "__main__":
    if len(sys.argv) == 4 and sys.argv[1] in globals():
        sys.exit(main(sys.argv[1:]))
    _all()
