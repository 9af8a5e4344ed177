# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saves the documents that test_open.py opens: run once for each release, under the oldest and the newest FreeCAD.

Run it:  freecadcmd tests/features/save_fixture.py
         sh tools/newest_freecad.sh run freecadcmd tests/features/save_fixture.py
It writes tests/data/KIND-VERSION.FCStd, VERSION from package.xml, and KIND-VERSION-freecad1.FCStd under FreeCAD 1.x;
files of older releases stay as they are. Together they hold one object of every kind.
"""

import os
import re
import sys
import traceback
from dataclasses import replace
from pathlib import Path

import FreeCAD
import Part

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(Path(__file__).resolve().parent)]
from document_case import small_job  # noqa: E402

from freecad_trabecula import make  # noqa: E402
from freecad_trabecula.core.analysis.parameters import SliceParameters  # noqa: E402
from freecad_trabecula.core.parameters import (  # noqa: E402
    Coupling,
    FaceParameters,
    LayerParameters,
    RodParameters,
    ScaffoldParameters,
)
from freecad_trabecula.core.presets import preset  # noqa: E402
from freecad_trabecula.core.voxels.parameters import VoxelParameters  # noqa: E402
from freecad_trabecula.core.wireframe import WireframeParameters  # noqa: E402

_COARSE = RodParameters(deflection=0.05)


def prism(document):
    """A prism with rods, all bodies of them, changes by hand; sites on a cylinder and a solid scaffold."""
    scaffold = ScaffoldParameters(layers=LayerParameters(("Face6",), 0.5))
    job = replace(small_job(n=2, kind="box"), seed=11, rods=_COARSE, scaffold=scaffold)
    design = make.make_design(document, job, ("network", "scaffold"))
    make.set_pore(design.wireframe, "Face1.1.1", 0.5, (0.1, 0.9, 0.2, 0.8))
    make.move_site(design.wireframe, "Face2.1.1", (10, 1.5, 1.5))
    for obj in (design.network, design.scaffold, *make.body_objects(design.scaffold)):
        make.update(obj)
    can = document.addObject("Part::Cylinder", "Can")
    can.Radius, can.Height = 4, 6
    document.recompute()
    spacing = {"c_u": 3.0, "c_v": 3.0, "b_u": 0.7, "b_v": 0.7}
    faces = (FaceParameters("Face2", "A", **spacing), FaceParameters("Face3", "B", **spacing))
    sites = [make.make_face_sites(can, one) for one in faces]
    couplings = (Coupling("A", "B", limit=2),)
    make.make_solid_scaffold(make.make_wireframe(can, sites, WireframeParameters(rods=_COARSE, couplings=couplings)))


def anatomical(document):
    """A curved plate from a file with a few rods, all four changes by hand, an expression from a spreadsheet."""
    job = preset("cranial")
    couplings = tuple(replace(one, limit=3) for one in job.couplings[:2])
    design = make.make_design(document, replace(job, rods=_COARSE, couplings=couplings))
    wireframe = design.wireframe
    first = make.wireframe_of(wireframe).sites[couplings[0].first]
    names, points = first.names, first.points.tolist()
    make.switch_off_site(wireframe, names[0])
    make.set_pore(wireframe, names[1], 0.6)
    make.move_site(wireframe, names[2], [value + 0.05 for value in points[2]])
    make.add_site(wireframe, couplings[0].first, points[0])
    sheet = document.addObject("Spreadsheet::Sheet", "Table")
    sheet.set("A1", "=9")
    document.recompute()
    wireframe.setExpression("Seed", "Table.A1 + 2")
    document.recompute()
    make.make_network(wireframe)


def analysis(document):
    """Two analyses, of a solid and of a mesh, which can be compared."""
    box = make.make_box(document, 3, 4, 5, "Block")
    hole = document.addObject("Part::Feature", "Ring")
    hole.Shape = Part.makeBox(3, 4, 5).cut(Part.makeBox(1, 2, 5, FreeCAD.Vector(1, 1, 0)))
    make.make_analysis(document, box, SliceParameters(thickness=0.5))
    make.make_analysis(document, hole, SliceParameters(thickness=0.5), envelope=box, morphometry=True)


def voxels(document):
    """Voxels of a body and of an analysis, their layers as solids, their union with a body."""
    ring = document.addObject("Part::Feature", "Ring")
    ring.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
    parameters = VoxelParameters(size=(0.5, 0.5, 0.5))
    design = make.make_voxel_design(document, ring, parameters)
    make.make_voxel_design(document, make.make_analysis(document, ring, SliceParameters(thickness=0.5)), parameters)
    make.make_layer_shapes(design, [0, 7], True)
    make.make_layer_shapes(design, [3])
    make.combine_with_body(design, make.make_box(document, 4, 4, 2), "union")


#: A document each.
KINDS = {"prism": prism, "anatomical": anatomical, "analysis": analysis, "voxels": voxels}


def main():
    """Write the files."""
    version = re.search(r"<version>(.*)</version>", (ROOT / "package.xml").read_text(encoding="utf-8")).group(1)
    newer = "" if FreeCAD.Version()[0] == "0" else "-freecad1"
    for kind, fill in KINDS.items():
        document = FreeCAD.newDocument(kind)
        fill(document)
        bad = [obj.Label for obj in document.Objects if not obj.isValid()]
        if bad:
            raise RuntimeError(f"{kind}: not computed: {bad}")
        path = ROOT / "tests" / "data" / f"{kind}-{version}{newer}.FCStd"
        document.saveAs(str(path))
        sys.__stdout__.write(f"\n{path.name}: {path.stat().st_size / 1000:.0f} KB, {len(document.Objects)} objects\n")
        FreeCAD.closeDocument(document.Name)


# FreeCAD would give the exit code 0 to a script that raises, and run it a second time.
try:
    main()
except BaseException:
    traceback.print_exc()
    os._exit(1)
sys.__stdout__.flush()
os._exit(0)
