# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide: its doors, the marks of its steps from the document alone, the whole circle of each door in the window."""

import os
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
import Mesh
from PySide import QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import example_file
from freecad_trabecula.features.examples import rods_job
from freecad_trabecula.features.stages import DONE, STALE
from freecad_trabecula.gui import analysis_saving, command, export_dialog, guide_dock, panels
from freecad_trabecula.gui.analysis_dock import dock_of_window
from freecad_trabecula.gui.doors import DOORS, LATER, NEXT, OPEN
from freecad_trabecula.gui.voxel_dock import voxel_dock

BONE = example_file("shrew_bone_a.ply")


class GuideCase(WindowTest):
    def setUp(self):
        super().setUp()
        self.guide = guide_dock.guide_dock()
        self.guide.open()

    def tearDown(self):
        for dock in (self.guide, dock_of_window(), voxel_dock()):
            dock.hide()
        super().tearDown()

    def begin(self, name):
        self.guide.cards[name].begin.click()
        settle(0.1)

    def marks(self):
        self.guide.look()
        return {row.shown.step.name: row.shown.mark for row in self.guide.rows if not row.isHidden()}

    def click(self, name):
        """Click on a step as a user does."""
        self.guide.look()
        row = next(row for row in self.guide.rows if row.shown.step.name == name and not row.isHidden())
        self.assertTrue(row.button.isEnabled(), name)
        row.button.click()
        settle(0.2)

    def wait_for(self, name, mark=DONE, seconds=90):
        found = wait(lambda: self.marks().get(name) == mark, seconds)
        self.assertTrue(found, f"{name} is {self.marks().get(name)}, dialogs: {self.dialogs}")

    def click_of(self, name):
        """Return the name of the command that a click on a step runs."""
        self.guide.look()
        return next(row.shown.click[0] for row in self.guide.rows if row.shown.step.name == name and not row.isHidden())

    def add_bone(self):
        bone = self.document.addObject("Mesh::Feature", "Bone")
        bone.Mesh = Mesh.Mesh(BONE)
        return bone

    def measure_bone_file(self):
        with mock.patch.object(QtGui.QFileDialog, "getOpenFileName", lambda *_: (BONE, "")):
            FreeCADGui.runCommand("Trabecula_MeasureFile")
        panels.current().fields.layers.fields["thickness"].set_value(0.2)
        panels.current().accept()


class DoorsTest(GuideCase):
    def test_the_guide_shows_three_doors_with_pictures_and_words_until_one_is_chosen(self):
        self.assertEqual(self.guide.pages.currentIndex(), 0)
        self.assertEqual(list(self.guide.cards), [door.name for door in DOORS])
        for card in self.guide.cards.values():
            labels = card.findChildren(QtGui.QLabel)
            self.assertTrue(any(label.pixmap() is not None and not label.pixmap().isNull() for label in labels))
        self.begin("voxels")
        self.assertEqual(self.guide.pages.currentIndex(), 1)
        self.guide.back.click()
        self.assertEqual(self.guide.pages.currentIndex(), 0)

    def test_every_click_of_every_step_is_a_command_that_is_there(self):
        stages = self.guide.stages()
        for door in DOORS:
            names = [step.name for step in door.steps]
            self.assertEqual(len(names), len(set(names)))
            for step in door.steps:
                click = step.click(stages)
                self.assertTrue(click is None or click[0] in command.REGISTERED, step.name)

    def test_in_an_empty_document_the_first_step_is_next_and_the_last_come_later(self):
        for door, last in (("rods", "compare"), ("measure", "compare"), ("voxels", "export")):
            with self.subTest(door=door):
                self.begin(door)
                marks = list(self.marks().items())
                self.assertEqual(marks[0][1], NEXT)
                self.assertEqual(dict(marks)[last], LATER)
                self.guide.leave()

    def test_it_opens_with_the_workbench_only_when_wanted_and_nothing_is_there(self):
        opened = []
        self.document.addObject("Part::Box", "Box")
        for at_start, objects, expected in ((True, True, 0), (False, False, 0), (True, False, 1)):
            if not objects:
                self.document.removeObject("Box") if self.document.getObject("Box") else None
            with mock.patch.object(guide_dock, "_docks", []), mock.patch.object(
                guide_dock, "opens_at_start", lambda at_start=at_start: at_start
            ), mock.patch.object(guide_dock, "invoke_later", opened.append):
                guide_dock.welcome()
            self.assertEqual(len(opened), expected)

    def test_the_switch_of_the_first_page_is_kept(self):
        before = guide_dock.opens_at_start()
        self.guide.at_start.setChecked(not before)
        self.assertEqual(guide_dock.opens_at_start(), not before)
        self.guide.at_start.setChecked(before)

    def test_a_step_whose_command_cannot_run_says_why_and_changes_nothing(self):
        self.begin("rods")
        self.open_preset("case1")
        self.click("design")
        self.assertIn("close the open task panel first", FreeCADGui.getMainWindow().statusBar().currentMessage())
        self.assertEqual(self.names(), [])


class RodsDoorTest(GuideCase):
    def design(self):
        return make.make_design(self.document, rods_job(), ("scaffold",))

    def test_the_selected_one_of_two_bodies_is_designed_in(self):
        first, _ = (self.document.addObject("Part::Box", name) for name in ("First", "Second"))
        self.document.recompute()
        self.begin("rods")
        FreeCADGui.Selection.addSelection(first)
        self.click("design")
        self.assertEqual(panels.current().envelope, first)

    def test_from_a_body_to_a_comparison_that_moves_and_files(self):
        box = self.document.addObject("Part::Box", "Box")
        box.Length = box.Width = box.Height = 4
        self.document.recompute()
        self.begin("rods")
        self.assertEqual(self.marks()["body"], DONE)
        self.click("design")
        panel = panels.current()
        self.assertEqual(panel.envelope.Name, "Box")
        wait(lambda: panel.body.is_ready, 30)
        panel.fields.set_job(rods_job())
        settle(0.3)
        self.build(panel)
        self.wait_for("build")
        panels.current().reject()
        self.assertEqual(self.marks()["analyse"], NEXT)
        self.click("analyse")
        self.wait_for("analyse")
        self.add_bone()
        self.document.recompute()
        self.click("bone")
        self.wait_for("bone")
        self.click("compare")
        self.wait_for("compare")
        dock = dock_of_window()
        before = dock._comparison.axes["z"].values["sliced_area"].copy()
        self.assertEqual((self.marks()["change"], self.marks()["export"]), (NEXT, OPEN))
        self.click("change")
        panel = panels.current()
        self.wait_for_estimate(panel)
        self.change(panel, lambda: panel.fields.pores.fields["size"].high.set_value(1.1))
        panel.accept()
        self.assertTrue(wait(lambda: not panel.is_open, 90), self.dialogs)
        self.wait_for("analyse")
        moved = lambda: abs(dock._comparison.axes["z"].values["sliced_area"] - before).max() > 0.1  # noqa: E731
        self.assertTrue(wait(lambda: dock._comparison is not None and moved(), 60), "the comparison stands still")
        self.assertEqual(self.marks()["compare"], DONE)
        self.export_scaffold()
        self.assertEqual(self.dialogs, [])

    def export_scaffold(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scaffold.stl")
            with mock.patch.object(export_dialog, "run_dialog", lambda _: True), mock.patch.object(
                QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, "")
            ):
                self.click("export")
            self.assertGreater(os.path.getsize(path), 1000)

    def test_marks_come_from_the_file_alone_and_one_click_renews_what_is_out_of_date(self):
        design = self.design()
        make.make_analysis(self.document, design.scaffold)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "left.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            settle(0.5)
            marks = self.marks()
            self.assertEqual([marks[name] for name in ("design", "build", "analyse", "bone")], [DONE, DONE, DONE, NEXT])
            scaffold = self.document.getObject("Scaffold")
            before = scaffold.Porosity
            self.wireframe().Seed += 1
            self.document.recompute()
            self.wait_for("build", STALE)
            self.assertEqual(self.marks()["analyse"], STALE)
            self.click("build")
            self.wait_for("build")
            self.wait_for("analyse")
            self.assertNotEqual(scaffold.Porosity, before)
            self.assertIn("everything is up to date", command.REGISTERED["Trabecula_Renew"].reason())

    def test_cancelling_in_the_middle_leaves_the_steps_as_they_were(self):
        self.begin("rods")
        self.click("design")
        panel = panels.current()
        self.wait_for_estimate(panel)
        panel.build()
        settle(0.3)
        panel.reject()
        self.assertEqual((self.names(), self.marks()["design"]), ([], OPEN))

    def test_closing_the_document_in_the_middle_shows_the_doors_again(self):
        self.begin("rods")
        self.click("design")
        self.wait_for_estimate(panels.current())
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 10))
        self.guide.look()
        self.assertEqual(self.guide.pages.currentIndex(), 0)
        self.assertEqual(self.dialogs, [])

    def test_a_wrong_selection_does_not_mislead_a_step(self):
        design = self.design()
        bone = self.add_bone()
        FreeCADGui.Selection.addSelection(self.document.Name, bone.Name)
        self.click("analyse")
        self.wait_for("analyse")
        (analysis,) = [obj for obj in self.document.Objects if hasattr(obj, "SliceVolume")]
        self.assertEqual(analysis.Source, design.scaffold)


class MeasureDoorTest(GuideCase):
    def test_from_a_file_to_a_comparison_and_tables(self):
        self.begin("measure")
        self.add_bone()  # as FreeCAD's import does, which the step's command calls
        self.document.recompute()
        self.wait_for("file")
        self.click("analyse")
        panels.current().accept()
        self.wait_for("analyse")
        self.assertEqual(self.marks()["plots"], DONE)  # the panel opened them
        self.assertEqual(self.click_of("second"), "Trabecula_Body")
        self.add_bone()
        self.document.recompute()
        self.assertEqual(self.click_of("second"), "Trabecula_AnalyseNow")
        self.click("second")
        self.wait_for("second")
        sources = [obj.Source for obj in self.document.Objects if hasattr(obj, "SliceVolume")]
        self.assertEqual(len(set(sources)), 2)
        self.click("compare")
        self.wait_for("compare")
        without_plots = mock.patch.object(analysis_saving.importlib.util, "find_spec", lambda _: None)
        with tempfile.TemporaryDirectory() as folder, without_plots, mock.patch.object(
            QtGui.QFileDialog, "getExistingDirectory", lambda *_: folder
        ):
            self.click("export")
            self.assertTrue(wait(lambda: list(Path(folder).rglob("*.csv")), 90))
            self.assertTrue(wait(lambda: not guide_dock.is_working(), 90))
        self.assertEqual(self.dialogs, [])

    def test_a_file_that_is_no_mesh_is_refused_and_leaves_the_document_empty(self):
        self.begin("measure")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "wrong.stl")
            Path(path).write_text("this is no mesh", encoding="utf-8")
            with mock.patch.object(QtGui.QFileDialog, "getOpenFileName", lambda *_: (path, "")):
                FreeCADGui.runCommand("Trabecula_MeasureFile")
            panels.current().accept()
            self.assertTrue(wait(lambda: self.dialogs, 60))
        self.assertEqual(self.names(), [])


class VoxelsDoorTest(GuideCase):
    def test_from_a_sample_to_layers_a_comparison_and_files(self):
        self.begin("voxels")
        self.add_bone()
        self.document.recompute()
        self.assertEqual(self.marks()["sample"], DONE)
        self.click("targets")
        panels.current().fields.layers.fields["thickness"].set_value(0.2)
        panels.current().accept()
        self.wait_for("targets")
        self.click("voxels")
        fields = panels.current().fields
        bone = self.document.getObject(fields.source.object_name())
        self.assertEqual((bone.TypeId, fields.value().size), ("Mesh::Feature", (0.2, 0.2, 0.2)))
        panels.current().accept()
        self.wait_for("voxels", seconds=120)
        self.assertEqual(self.marks()["targets"], DONE)
        self.assertTrue(wait(lambda: self.marks()["layers"] == DONE, 10))  # the panel opened them
        self.click("analyse")
        self.wait_for("analyse")
        self.click("compare")
        self.wait_for("compare")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "voxels.stl")
            with mock.patch("freecad_trabecula.gui.voxel_export.run_dialog", lambda _: True), mock.patch.object(
                QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, "")
            ):
                self.click("export")
            self.assertGreater(os.path.getsize(path), 1000)
        self.assertEqual(self.dialogs, [])

    def test_closing_the_document_while_voxels_are_designed_leaves_no_trace(self):
        self.begin("voxels")
        self.add_bone()
        self.click("voxels")
        panels.current().work()
        settle(0.5)
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 10))
        self.assertEqual(self.dialogs, [])


class ExamplesTest(GuideCase):
    def test_each_example_opens_with_one_click_as_a_new_document_with_all_done_but_what_is_only_seen(self):
        for door in DOORS:
            with self.subTest(example=door.name):
                self.guide.leave()
                before = set(FreeCAD.listDocuments())
                self.guide.cards[door.name].example.click()
                found = wait(lambda before=before: set(FreeCAD.listDocuments()) - before, 120)
                self.assertTrue(found, self.dialogs)
                settle(0.5)
                document = FreeCAD.ActiveDocument
                self.assertEqual(document.FileName, "")
                marks = self.marks()
                seen_only = {"plots", "layers", "compare", "change", "export"}
                self.assertTrue(all(mark == DONE for name, mark in marks.items() if name not in seen_only), marks)
                self.assertTrue(all(obj.isValid() for obj in document.Objects))
                FreeCAD.closeDocument(document.Name)
                FreeCAD.setActiveDocument(self.document.Name)
        self.assertEqual(self.dialogs, [])

    def test_a_second_example_is_not_opened_while_one_is_on_its_way(self):
        self.guide.cards["measure"].example.click()
        self.guide.cards["rods"].example.click()
        self.assertIn("on its way already", FreeCADGui.getMainWindow().statusBar().currentMessage())
        self.assertTrue(wait(lambda: len(FreeCAD.listDocuments()) == 2, 120))
