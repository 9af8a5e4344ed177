# SPDX-License-Identifier: LGPL-2.1-or-later
"""Single sites and pores by hand: every change rebuilds only the rods that it touches.

Run it:  freecadcmd resources/examples/by_hand.py
"""

import os
import sys

import FreeCAD

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.shell.script import run_script


def main():
    """Change a design of case 1 by hand."""
    document = FreeCAD.newDocument("by_hand")
    design = make.make_design(document, preset("case1"), parts=("network",))
    wireframe, network = design.wireframe, design.network

    def show(what):
        document.recompute()
        print(f"{what}: {network.Rods} rods, {network.Rebuilt} built again, {network.RodVolume.Value:.2f} mm3")

    show("case 1")
    make.set_pore(wireframe, "Face1.3.3", size=0.8)
    show("one pore larger")
    make.move_site(wireframe, "Face1.2.2", (0, 3.5, 3.5))
    show("one site moved")
    make.switch_off_site(wireframe, "Face5.3.3")
    show("one site switched off")
    for face, x in (("Face1", 0), ("Face2", 10)):
        make.add_site(wireframe, face, (x, 4.2, 4.2))
    show("a site added on two faces")
    make.take_back_edits(wireframe, "Face1.2.2")
    show("one move taken back")


run_script(main)
