# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 6 of the thesis, at once: 147 curved rods with random pores in a 10 mm cube.

Run it:  freecadcmd resources/examples/case6.py

It writes scaffold.stl, channels.stl, network.step and case6.FCStd into the folder TRABECULA_OUT (default: where it is
run).
"""

import os
import sys

import FreeCAD

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.shell.script import run_script

OUT = os.environ.get("TRABECULA_OUT", ".")


def main():
    """Make the design, say what it is, and write it."""
    document = FreeCAD.newDocument("case6")
    design = make.make_design(document, preset("case6"), parts=("network", "scaffold"))

    print("rods:", design.wireframe.Rods, "of which mended:", len(design.wireframe.Recoveries))
    print(
        "rods' volume, mm3:", design.network.RodVolume.Value, "by solids,", design.network.MeshVolume.Value, "by meshes"
    )
    print("porosity, %:", design.scaffold.Porosity, "by the", design.scaffold.EngineUsed, "engine")
    print(*design.scaffold.Checks, sep="\n")

    channels = make.body_objects(design.scaffold)[0]
    make.export(design.scaffold, os.path.join(OUT, "scaffold.stl"))
    make.export(channels, os.path.join(OUT, "channels.stl"))
    make.export(design.network, os.path.join(OUT, "network.step"))
    document.saveAs(os.path.join(OUT, "case6.FCStd"))


run_script(main)
