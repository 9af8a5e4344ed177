# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs as wholes in the window: copied as a script."""

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset


class CopyScriptTest(WindowTest):
    def test_what_is_copied_makes_the_design_again(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        make.switch_off_site(wireframe, "Face1.2.3")
        FreeCADGui.Selection.addSelection(self.document.Name, "Sites")
        FreeCADGui.runCommand("Trabecula_CopyScript")
        text = QtGui.QApplication.clipboard().text()
        self.assertIn("are on the clipboard", FreeCADGui.getMainWindow().statusBar().currentMessage())
        names = {}
        exec(text, names)  # noqa: S102  what a user does
        self.assertNotEqual(names["document"].Name, self.document.Name)
        self.assertEqual((names["wireframe"].Rods, names["wireframe"].Edits), (74, wireframe.Edits))
        self.assertEqual(names["wireframe"].PoreSizes, wireframe.PoreSizes)
        self.assertEqual(self.dialogs, [])

    def test_it_is_greyed_out_without_a_design_and_tells_why_one_in_error_cannot_be_copied(self):
        self.assertFalse(FreeCADGui.Command.get("Trabecula_CopyScript").isActive())
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        self.assertTrue(FreeCADGui.Command.get("Trabecula_CopyScript").isActive())
        wireframe.Couplings = ["no record"]
        self.document.recompute()
        FreeCADGui.runCommand("Trabecula_CopyScript")
        self.assertEqual(len(self.dialogs), 1)
        self.assertIn("must be without error", self.dialogs[0])
        self.assertEqual(len(FreeCAD.listDocuments()), 1)
