# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design driven by a spreadsheet: each number of a table is a number of the design; the file is driven.FCStd.

Run it:  freecadcmd resources/examples/spreadsheet.py
"""

import os
import sys

import FreeCAD

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.shell.script import run_script

#: Alias of a cell, what stands in it, and the properties that it drives.
TABLE = (
    ("Edge", "=10 mm", ("Envelope.Length", "Envelope.Width", "Envelope.Height")),
    ("RodsAcross", "=5", ("Sites.SitesX", "Sites.SitesY", "Sites.SitesZ")),
    ("Border", "=Edge / 10", ("Sites.BorderX", "Sites.BorderY", "Sites.BorderZ")),
    ("Seed", "=3", ("Wireframe.Seed",)),
    # a pore fills at most the step between two sites
    ("LargestPore", "=(Edge - 2 * Border) / (RodsAcross - 1) * 0.4", ("Wireframe.PoreSizeHigh",)),
    ("SmallestPore", "=LargestPore / 4", ("Wireframe.PoreSizeLow",)),
)


def drive(document):
    """Add the table to a document and bind the design to it; return the sheet."""
    sheet = document.addObject("Spreadsheet::Sheet", "Table")
    for row, (alias, content, paths) in enumerate(TABLE, 1):
        sheet.set(f"A{row}", alias)
        sheet.set(f"B{row}", content)
        sheet.setAlias(f"B{row}", alias)
        for path in paths:
            name, _, property_name = path.partition(".")
            document.getObject(name).setExpression(property_name, f"Table.{alias}")
    document.recompute()
    return sheet


def main():
    """Make case 1 follow a table, then change the table."""
    document = FreeCAD.newDocument("driven")
    design = make.make_design(document, preset("case1"), parts=("scaffold",))
    wireframe, scaffold = design.wireframe, design.scaffold
    sheet = drive(document)

    def show(what):
        document.recompute()
        make.update(scaffold)
        bad = [obj.Label for obj in document.Objects if not obj.isValid()]
        if bad:
            raise RuntimeError(f"{what}: not computed: {bad}")
        largest = wireframe.PoreSizeHigh.Value
        volume = scaffold.EnvelopeVolume.Value
        print(
            f"{what}: {wireframe.Rods} rods, pores up to {largest:.3g} mm, {volume:.0f} mm3, {scaffold.Porosity:.2f} %"
        )

    show("as it is")
    sheet.set("B1", "=20 mm")
    show("edges of 20 mm")
    sheet.set("B2", "=4")
    show("4 rods across")
    document.saveAs(os.path.join(os.environ.get("TRABECULA_OUT", "."), "driven.FCStd"))


run_script(main)
