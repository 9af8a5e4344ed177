# SPDX-License-Identifier: LGPL-2.1-or-later
"""What documents weigh and what it takes to open them: file, CPU seconds, memory; a table, printed and left as a page.

Every document is made and saved in one FreeCAD and opened in another, which has computed nothing: opening is reading.
``--only case6 voxels`` chooses documents, ``--page docs/opening.md`` writes the page (default: build/opening/).
"""

import argparse
import dataclasses
import json
import resource
import sys
import tempfile
import time
from pathlib import Path

import under_freecad
from validate import table

ROOT = Path(__file__).resolve().parent.parent
HEAD = (
    "document",
    "in it",
    "file, MB",
    "opened, CPU s",
    "recomputed, CPU s",
    "memory before, GB",
    "peak memory, GB",
)
TEXT = """# What documents weigh, and what it takes to open them

Written by `python3 tools/open_times.py --page docs/opening.md`; one run on FreeCAD {version}, CPU seconds of one
process without a window. A document is made and saved in one process and opened in another. "Recomputed": all its
objects touched and the document computed, which finds every result in the file. "Memory before": FreeCAD with the
workbench loaded.

{table}

A document keeps meshes as single-precision triangles, voxels as bits (48 in a number), wireframes and analyses as lists
of numbers; networks and solid scaffolds are FreeCAD's own shapes. [documents.md](documents.md) says what is kept where.
The panels say beforehand how many rods or voxels a design has, and what time and memory it takes.
"""


def _preset(name, *parts):
    def fill(document):
        from freecad_trabecula import make
        from freecad_trabecula.core.presets import preset

        design = make.make_design(document, preset(name), parts)
        return f"{design.wireframe.Rods} rods, " + (" and ".join(parts) or "wireframe only")

    return fill


def _twelve_hundred(*parts):
    def fill(document):
        import bench

        from freecad_trabecula import make

        job = bench.designed("case6", 20)[0]
        job = dataclasses.replace(job, scaffold=dataclasses.replace(job.scaffold, engine="mesh"))
        design = make.make_design(document, job, parts)
        return f"{design.wireframe.Rods} rods, " + (" and ".join(parts) or "wireframe only")

    return fill


def _example(name):
    def fill(document):
        from freecad_trabecula.features.examples import make_example

        make_example(document, name)
        return "example project"

    return fill


def _voxels(document):
    from freecad_trabecula import make
    from freecad_trabecula.core.presets import example_file
    from freecad_trabecula.core.voxels.parameters import VoxelParameters

    size = 0.04
    design = make.make_voxel_design(document, example_file("shrew_bone_a.ply"), VoxelParameters(size=(size,) * 3))
    cells = design.LayersX * design.LayersY * design.LayersZ
    return f"{cells:,} voxels, {design.Voxels:,} of them solid, {design.Mesh.CountFacets:,} triangles"


DOCUMENTS = {
    **{f"case{number}": _preset(f"case{number}", "scaffold") for number in range(1, 7)},
    "case6 with network": _preset("case6", "network", "scaffold"),
    "cranial": _preset("cranial", "scaffold"),
    "femur": _preset("femur", "scaffold"),
    "1,200 rods": _twelve_hundred("scaffold"),
    "voxels": _voxels,
    "example rods": _example("rods"),
    "example measure": _example("measure"),
    "example voxels": _example("voxels"),
}


def make_document(name, path):
    """Make and save a document; return what is in it."""
    import FreeCAD

    document = FreeCAD.newDocument("Opened")
    said = DOCUMENTS[name](document)
    document.saveAs(path)
    return {"said": said}


def open_document(path):
    """Open a document and compute it; return CPU seconds and memory."""
    import FreeCAD

    from freecad_trabecula import make  # noqa: F401  what FreeCAD's start would load

    def memory():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6

    before, start = memory(), time.process_time()
    document = FreeCAD.openDocument(path)
    opened = time.process_time()
    peak = memory()
    for obj in document.Objects:
        obj.touch()
    document.recompute()
    bad = [obj.Label for obj in document.Objects if not obj.isValid() or not getattr(obj, "UpToDate", True)]
    if bad:
        raise RuntimeError(f"{path}: not up to date after opening: {bad}")
    version = ".".join(FreeCAD.Version()[:2])
    return {
        "opened": opened - start,
        "recomputed": time.process_time() - opened,
        "before": before,
        "peak": peak,
        "version": version,
    }


def main(arguments):
    """Make or open one document; inside FreeCAD."""
    options = parse(arguments)
    found = make_document(options.make, options.file) if options.make else open_document(options.file)
    Path(options.result).write_text(json.dumps(found))
    return 0


def measured(names):
    """Return a row for each document, and FreeCAD's version."""
    rows, version = [], ""
    with tempfile.TemporaryDirectory() as folder:
        file, result = str(Path(folder) / "one.FCStd"), str(Path(folder) / "result.json")
        for name in names:
            made = _in_freecad(["--make", name, "--file", file, "--result", result], result)
            opened = _in_freecad(["--file", file, "--result", result], result)
            size, version = Path(file).stat().st_size / 1e6, opened["version"]
            numbers = [f"{opened[key]:.2f}" for key in ("opened", "recomputed", "before", "peak")]
            rows.append([name, made["said"], f"{size:.2f}", *numbers])
            print(" | ".join(rows[-1]), flush=True)
    return rows, version


def _in_freecad(arguments, result):
    Path(result).unlink() if Path(result).exists() else None
    if under_freecad.run(__file__, arguments):
        raise SystemExit(f"open_times: FreeCAD failed with {arguments}")
    return json.loads(Path(result).read_text())


def parse(arguments):
    """Return the options."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="*", default=list(DOCUMENTS), choices=list(DOCUMENTS))
    parser.add_argument("--page", default=str(ROOT / "build" / "opening" / "opening.md"))
    parser.add_argument("--make", default="")
    parser.add_argument("--file", default="")
    parser.add_argument("--result", default="")
    return parser.parse_args(arguments)


if __name__ == "__main__":
    chosen = parse(sys.argv[1:])
    found_rows, found_version = measured(chosen.only)
    page = Path(chosen.page)
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(TEXT.format(version=found_version, table=table(HEAD, found_rows)), encoding="utf-8")
    print(f"written: {page}")
