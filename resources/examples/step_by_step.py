# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every step by itself: rods between the flat faces of a can, two convergence points, larger pores towards the top.

Run it:  freecadcmd resources/examples/step_by_step.py

It writes scaffold.stl and can.FCStd into the folder TRABECULA_OUT (default: where it is run).
"""

import os
import sys

import FreeCAD

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
from freecad_trabecula import make
from freecad_trabecula.core.laws import Law
from freecad_trabecula.core.parameters import (
    Coupling,
    FaceParameters,
    LayerParameters,
    PathParameters,
    PoreParameters,
    ScaffoldParameters,
)
from freecad_trabecula.core.wireframe import WireframeParameters
from freecad_trabecula.shell.script import run_script

OUT = os.environ.get("TRABECULA_OUT", ".")


def main():
    """Fill a can, step by step."""
    document = FreeCAD.newDocument("can")

    # The body to be filled: any object with one solid.
    can = document.addObject("Part::Cylinder", "Can")
    can.Radius, can.Height = 6, 10
    document.recompute()

    # Sites on its flat faces by curvilinear co-ordinates: spacings c and distances b from the border, mm.
    spacing = {"c_u": 1.5, "c_v": 1.5, "b_u": 0.7, "b_v": 0.7}
    sites = [
        make.make_face_sites(can, FaceParameters("Face2", "top", **spacing)),
        make.make_face_sites(can, FaceParameters("Face3", "bottom", **spacing)),
    ]

    # Which faces are joined, along which paths, by pores of which size.
    parameters = WireframeParameters(
        pores=PoreParameters(size=Law("linear", 0.3, 0.7, direction=(0, 0, 1))),
        path=PathParameters("centre", points=((-2.0, 0.0, 5.0), (2.0, 0.0, 5.0)), choice="nearest"),
        couplings=(Coupling("bottom", "top", association="random"),),
        seed=7,
    )
    wireframe = make.make_wireframe(can, sites, parameters)
    print(wireframe.Status)

    # Envelope less rods, with a compact layer of 1 mm that closes the bottom.
    scaffold = make.make_scaffold(wireframe, ScaffoldParameters(layers=LayerParameters(("bottom",), 1.0)))
    print(scaffold.Status)

    # Parameters are properties: change one and recompute. A scaffold waits until it is updated, for it takes seconds.
    wireframe.PathKind = "straight"
    document.recompute()
    print("after an edit, the scaffold is", scaffold.Status)
    make.update(scaffold)
    print(scaffold.Status)

    make.export(scaffold, os.path.join(OUT, "scaffold.stl"))
    document.saveAs(os.path.join(OUT, "can.FCStd"))


run_script(main)
