# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dialogs of voxel designs in the window: tables edited, a layer watched while it is filled."""

import os
import tempfile

import FreeCADGui
from PySide import QtCore
from test_voxel_panel import VoxelCase
from window import settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.table_files import read_tables_xlsx
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.gui import table_dialog
from freecad_trabecula.gui.background import is_busy
from freecad_trabecula.gui.propagation_dialog import watch_layer
from freecad_trabecula.gui.table_dialog import TableDialog

SMALL = VoxelParameters(size=(1.0, 1.0, 1.0), strategy="random-layers")
HALF_FULL = ((0.5, 0.5),)
CURVES = DrawnCurves((6.0, 6.0, 6.0), HALF_FULL, HALF_FULL, HALF_FULL)


class DialogCase(VoxelCase):
    def design(self, strategy="random-layers"):
        """Six layers of 18 voxels along each axis: tables have room for edits."""
        parameters = VoxelParameters(size=(1.0, 1.0, 1.0), strategy=strategy)
        return make.make_voxel_design(self.document, CURVES, parameters)

    def dialog(self, obj):
        dialog = TableDialog(FreeCADGui.getMainWindow(), obj)
        self.addCleanup(dialog.close)
        return dialog

    def type_into(self, model, line, layer, number):
        """Change a cell as its editor would."""
        index = model.index(model.cells.shape[1] - layer, line + 1)
        return model.setData(index, str(number))


class TablesTest(DialogCase):
    def test_the_tables_stand_as_in_figure_6_6(self):
        obj = self.design()
        design, model = make.voxel_design_of(obj), self.dialog(obj).models[0]
        text = [[model.index(row, column).data() for column in range(7)] for row in range(7)]
        self.assertEqual((text[0], [row[0] for row in text]), (["", *["18"] * 6], ["", *["18"] * 6]))
        self.assertEqual(text[6][1:], [str(cell) for cell in design.alpha[:, 0]])
        self.assertEqual((model.headerData(0, QtCore.Qt.Horizontal), model.headerData(6, QtCore.Qt.Vertical)),
                         ("sum", "Z 0"))  # fmt: skip

    def test_a_wrong_cell_marks_its_sums_and_cannot_be_designed_with(self):
        dialog = self.dialog(self.design())
        model = dialog.models[0]
        before = int(model.cells[2, 3])
        self.assertTrue(self.type_into(model, 2, 3, before + 1))
        self.assertEqual(model.index(3, 0).data(), "19 ≠ 18")
        self.assertTrue(model.error(2, -1) and model.error(-1, 3) and not model.error(1, -1))
        self.assertIn("table alpha: row 3 sums to 19, asked for 18; 2 sums or cells are wrong", dialog.message.text())
        self.assertFalse(dialog.use.isEnabled())
        for text in ("-1", "1.5", "many", ""):
            self.assertFalse(self.type_into(model, 2, 3, text))
        dialog.show_design()
        self.assertEqual(int(model.cells[2, 3]), before)
        self.assertFalse(dialog.reset.isEnabled())

    def test_tables_whose_layer_no_voxels_fill_are_marked(self):
        dialog = self.dialog(self.design())
        alpha, beta = (table.copy() for table in dialog.tables())
        # a layer of three full columns has three voxels in every row: 6, 6, 6, 0, 0, 0 does not go with it
        for table in (alpha, beta):
            table[:] = 3
            table[:3, :3], table[3:, :3], table[:3, 3:], table[3:, 3:] = 6, 0, 0, 6
        dialog.show_tables((alpha, beta))
        self.assertIn("No voxels fill layer 0 along Z; 6 layers do not go", dialog.message.text())
        self.assertFalse(dialog.use.isEnabled())

    def test_edited_tables_are_designed_with_in_one_step(self):
        obj = self.design()
        edited = [table.copy() for table in (make.voxel_design_of(obj).alpha, make.voxel_design_of(obj).beta)]
        edited[0][:], edited[1][:] = 3, 3  # three voxels in every line: exist in a layer of 6 x 6

        def choose(dialog):
            dialog.show_tables(tuple(edited))
            self.assertTrue(dialog.use.isEnabled(), dialog.message.text())
            return True

        run, table_dialog.run_dialog = table_dialog.run_dialog, choose
        try:
            FreeCADGui.runCommand("Trabecula_VoxelTables")
        finally:
            table_dialog.run_dialog = run
        self.assertTrue(wait(lambda: not is_busy(), 120), self.dialogs)
        settle(0.2)
        found = make.voxel_design_of(obj)
        self.assertTrue((found.alpha == 3).all() and (found.beta == 3).all(), self.dialogs)
        self.assertEqual(self.document.UndoNames[0], "Design voxels")
        self.document.undo()
        self.assertEqual(list(obj.Alpha), [])

    def test_a_strategy_without_tables_shows_them_and_says_so(self):
        dialog = self.dialog(self.design("trabecular"))
        self.assertIn("Strategy trabecular makes voxels without tables", dialog.message.text())
        model = dialog.models[0]
        self.assertFalse(model.flags(model.index(1, 1)) & QtCore.Qt.ItemIsEditable)

    def test_tables_go_into_files_and_come_back(self):
        dialog = self.dialog(self.design())
        own = [table.copy() for table in dialog.tables()]
        with tempfile.TemporaryDirectory() as folder:
            book, sheet = os.path.join(folder, "tables.xlsx"), os.path.join(folder, "beta.csv")
            dialog.write(book)
            dialog.tabs.setCurrentIndex(1)
            dialog.write(sheet)
            self.assertTrue((read_tables_xlsx(book)[0].cells == own[0]).all())
            dialog.models[0].cells[0, 0] += 1
            dialog.models[1].cells[0, 0] += 1
            dialog.read(sheet)
            self.assertFalse((dialog.tables()[0] == own[0]).all())
            dialog.read(book)
            self.assertTrue((dialog.tables()[0] == own[0]).all() and (dialog.tables()[1] == own[1]).all())
            with open(sheet, "w", encoding="ascii") as file:
                file.write(",1,1\n2,1,1\n")
            with self.assertRaisesRegex(ParameterError, "table beta must have 6 lines and 6 layers .* got 2 and 1"):
                dialog.read(sheet)


class WatchTest(DialogCase):
    def test_a_layer_of_a_design_is_filled_step_by_step(self):
        obj = self.design()
        dialog = watch_layer(obj)
        dialog.layer.setValue(2)
        design = make.voxel_design_of(obj)
        self.assertEqual(dialog.alpha.text(), " ".join(str(cell) for cell in design.alpha[:, 2]))
        solved = int((design.beta[:, 2] > 0).sum())
        self.assertEqual(len(dialog.steps), solved + 1)
        for _ in range(solved):
            dialog.go(1)
        self.assertTrue((dialog.view.step.voxels.sum(0) == design.alpha[:, 2]).all())
        self.assertIn("the layer is filled", dialog.words.text())
        dialog.go(-1)
        self.assertIn("next row", dialog.words.text())
        dialog.direction.setCurrentIndex(1)
        self.assertEqual(dialog.slider.value(), 0)
        self.assertIn("next column", dialog.words.text())
        dialog.close()

    def test_it_runs_by_itself_to_the_end(self):
        FreeCADGui.runCommand("Trabecula_WatchLayer")
        from freecad_trabecula.gui.propagation_dialog import _open

        dialog = _open[0]
        dialog.play_button.setChecked(True)
        dialog.timer.setInterval(20)
        self.assertTrue(wait(lambda: dialog.slider.value() == dialog.slider.maximum(), 20))
        self.assertTrue(wait(lambda: not dialog.timer.isActive(), 5))
        self.assertFalse(dialog.play_button.isChecked())
        dialog.close()

    def test_conditions_that_end_a_layer_are_told_and_bad_numbers_too(self):
        dialog = watch_layer(None)
        # a row needs three columns, of which only two are not empty
        for line, text in ((dialog.alpha, "3 3 0 0"), (dialog.beta, "1 2 3")):
            line.setText(text)
        dialog.refresh()
        dialog.go(10**9)
        self.assertIn("N − v = 4 − 2 = 2", dialog.conditions[0].text())
        self.assertIn("true", dialog.conditions[0].text())
        self.assertIn("false", dialog.conditions[1].text())
        self.assertIn("no design with these numbers any more", dialog.words.text())
        for text, words in (("1 x", "must be whole numbers"), ("9 9 9 9", "must lie in 0..3"), ("3 2 0 0", "same sum")):
            dialog.alpha.setText(text)
            dialog.refresh()
            self.assertIn(words, dialog.view.words)
            self.assertFalse(dialog.slider.isEnabled())
        dialog.close()
