# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs as wholes in the window: copied as a script, told in one page."""

import os
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.gui import report_writing
from freecad_trabecula.gui.recomputing import WorkBar
from freecad_trabecula.gui.status_work import is_working


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


class WriteReportTest(WindowTest):
    def test_the_page_has_views_of_the_bodies_and_leaves_the_window_as_it_was(self):
        design = make.make_design(self.document, preset("case1"), ("network",))
        analysis = make.make_analysis(self.document, design.network)
        shown = {obj.Name: obj.ViewObject.Visibility for obj in self.document.Objects}
        opened = []
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "page")
            with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, "")), \
                    mock.patch.object(QtGui.QDesktopServices, "openUrl", opened.append):  # fmt: skip
                FreeCADGui.runCommand("Trabecula_WriteReport")
                self.assertTrue(wait(lambda: opened, 60))
            page = Path(path + ".html").read_text(encoding="utf-8")
            self.assertEqual([one.toLocalFile() for one in opened], [path + ".html"])
        self.assertIn(f"Slice analysis: {analysis.Label}", page)
        self.assertIn("must have its scaffold", page)
        self.assertEqual({obj.Name: obj.ViewObject.Visibility for obj in self.document.Objects}, shown)
        self.assertEqual(self.dialogs, [])

    def write(self, path):
        """Write the report of a box's analysis; return the bar that shows how far it is."""
        make.make_analysis(self.document, make.make_box(self.document, 2, 3, 4))
        report_writing.write(self.document, path)
        window = FreeCADGui.getMainWindow()
        self.assertTrue(wait(is_working, 10))
        return next(bar for bar in window.findChildren(WorkBar) if bar.isVisible())

    def test_it_can_be_cancelled_and_leaves_no_file(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(QtGui.QDesktopServices, "openUrl") as opened:
            bar = self.write(os.path.join(folder, "page.html"))
            bar.button.click()
            self.assertFalse(bar.isVisible())
            self.assertTrue(wait(lambda: not is_working(), 20))
            self.assertEqual(os.listdir(folder), [])
        opened.assert_not_called()
        self.assertEqual(self.dialogs, [])

    def test_a_file_that_cannot_be_written_is_told(self):
        self.write("/nowhere/page.html")
        self.assertTrue(wait(lambda: self.dialogs, 60))
        self.assertIn("nowhere", self.dialogs[0])

    def test_a_document_that_is_closed_meanwhile_is_not_told_of(self):
        make.make_analysis(self.document, make.make_box(self.document, 2, 3, 4))
        make.make_design(self.document, preset("case1"), ("network",))
        with mock.patch.object(QtGui.QDesktopServices, "openUrl") as opened:
            report_writing.write(self.document, "/nowhere/page.html")
            FreeCAD.closeDocument(self.document.Name)
            settle(1.0)
        opened.assert_not_called()
        self.assertFalse(is_working())
        self.assertEqual(self.dialogs, [])
        self.document = FreeCAD.newDocument("Next")

    def test_a_view_is_a_picture_of_the_body(self):
        design = make.make_design(self.document, preset("case1"), ("network",))
        found = {}
        for _ in report_writing.views_in_turns(self.document, found):
            pass
        (picture,) = found[design.wireframe.Name]
        image = QtGui.QImage.fromData(picture.content)
        self.assertEqual(picture.caption, "Network")
        tones = {image.pixel(x, y) for x in range(0, image.width(), 5) for y in range(0, image.height(), 5)}
        self.assertGreater(len(tones), 5)
