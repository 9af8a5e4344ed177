# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saves the document that test_open.py opens: run once for each release, under the oldest FreeCAD.

Run it:  freecadcmd tests/features/save_fixture.py
It writes tests/data/prism-VERSION.FCStd, VERSION from package.xml; files of older releases stay as they are.
"""

import os
import re
import sys
import traceback
from dataclasses import replace
from pathlib import Path

import FreeCAD

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(Path(__file__).resolve().parent)]
from document_case import small_job  # noqa: E402

from freecad_trabecula import make  # noqa: E402
from freecad_trabecula.core.parameters import (  # noqa: E402
    Coupling,
    FaceParameters,
    LayerParameters,
    RodParameters,
    ScaffoldParameters,
)
from freecad_trabecula.core.wireframe import WireframeParameters  # noqa: E402


def fill(document):
    """Put one object of each kind into a document."""
    coarse = RodParameters(deflection=0.05)
    scaffold = ScaffoldParameters(layers=LayerParameters(("Face6",), 0.5))
    job = replace(small_job(n=2, kind="box"), seed=11, rods=coarse, scaffold=scaffold)
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
    make.make_solid_scaffold(make.make_wireframe(can, sites, WireframeParameters(rods=coarse, couplings=couplings)))


def main():
    """Write the file."""
    version = re.search(r"<version>(.*)</version>", (ROOT / "package.xml").read_text(encoding="utf-8")).group(1)
    document = FreeCAD.newDocument("fixture")
    fill(document)
    document.saveAs(str(ROOT / "tests" / "data" / f"prism-{version}.FCStd"))


# FreeCAD would give the exit code 0 to a script that raises, and run it a second time.
try:
    main()
except BaseException:
    traceback.print_exc()
    os._exit(1)
sys.stdout.flush()
os._exit(0)
