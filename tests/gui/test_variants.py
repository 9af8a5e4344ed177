# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other seeds in the window: one click makes them elsewhere, one is taken in one step, Cancel ends at once, CSV out."""

import csv
import tempfile
import time
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.gui import commands
from freecad_trabecula.gui.variants_dialog import USUAL, VariantsDialog


def dialog():
    found = [one for one in QtGui.QApplication.topLevelWidgets() if isinstance(one, VariantsDialog) and one.isVisible()]
    return found[0] if found else None


class VariantsTest(WindowTest):
    def tearDown(self):
        if dialog() is not None:
            dialog().close()
        super().tearDown()

    def start(self):
        FreeCADGui.runCommand("Trabecula_Variants")
        self.assertTrue(wait(lambda: dialog() is not None, 5))
        return dialog()

    def test_one_click_shows_ten_with_pictures_and_spread_and_one_is_taken_in_one_step(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        found = self.start()
        heads = [found.table.horizontalHeaderItem(k).text() for k in range(found.table.columnCount())]
        self.assertEqual((found.table.rowCount(), heads), (0, ["Seed"]))  # until the first result
        self.assertTrue(wait(lambda: found.variants is not None, 120), found.message.text())
        self.assertEqual(found.table.rowCount(), USUAL)
        self.assertFalse(found.table.item(0, 0).icon().isNull())
        self.assertRegex(found.message.text(), r"porosity, %: mean \d+\.\d+, standard deviation .*of 10 variants")
        self.assertFalse(found.take_button.isEnabled())
        found.table.selectRow(3)
        settle(0.1)
        seed = found.variants.rows[3].seed
        self.assertNotEqual(seed, wireframe.Seed)
        found.take_button.click()
        self.assertTrue(wait(lambda: wireframe.Seed == seed, 10))
        self.document.undo()
        self.assertEqual(wireframe.Seed, 1)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "variants.csv"
            found.save(str(path))
            with path.open(encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual([int(row["seed"]) for row in rows], list(range(1, 11)))
        self.assertEqual(self.dialogs, [])

    def test_cancel_answers_at_once_and_it_can_begin_again(self):
        make.make_design(self.document, preset("case6"))
        found = self.start()
        self.assertTrue(wait(lambda: found.bar.value() > 0, 120))
        started = time.monotonic()
        found.cancel_button.click()
        self.assertTrue(wait(lambda: found.start_button.isEnabled(), 1))
        self.assertLess(time.monotonic() - started, 1)
        self.assertIn("Cancelled", found.message.text())
        settle(0.5)
        self.assertIsNone(found.variants)

    def test_after_its_document_was_closed_it_says_so_and_lives(self):
        make.make_design(self.document, preset("case1"))
        found = self.start()
        self.assertTrue(wait(lambda: found.variants is not None, 120), found.message.text())
        FreeCAD.closeDocument(self.document.Name)
        found.table.selectRow(0)
        found.take_button.click()
        found.start_button.click()
        self.assertEqual(len(self.dialogs), 2)
        self.assertIn("it was closed", self.dialogs[0])
        self.assertTrue(found.start_button.isEnabled())

    def test_voxels_tell_their_overlap(self):
        body = self.document.addObject("Part::Feature", "Bracket")
        body.Shape = make.make_box(self.document, 4, 4, 4).Shape.cut(make.make_box(self.document, 2, 2, 4).Shape)
        make.make_voxel_design(self.document, body, VoxelParameters(size=(0.5, 0.5, 0.5)))
        found = self.start()
        self.assertFalse(found.by.isVisible())
        self.assertTrue(wait(lambda: found.variants is not None, 120), found.message.text())
        self.assertIn("mean overlap, %", found.message.text())
        self.assertIn("chance", found.message.text())

    def test_without_a_design_it_is_greyed_out_and_says_why(self):
        make.make_analysis(self.document, make.make_box(self.document, 2, 3, 4))
        self.assertFalse(FreeCADGui.Command.get("Trabecula_Variants").isActive())
        self.assertIn("no design of rods or voxels yet", commands.COMMANDS["Trabecula_Variants"].reason())
