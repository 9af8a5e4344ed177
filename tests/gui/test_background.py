# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work that the panels of analyses and voxel designs leave to the status bar, as the design panel does."""

import FreeCAD
import FreeCADGui
import Part
from PySide import QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.features import results
from freecad_trabecula.features.relations import type_of
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.analysing import Wish, analyse_at_once
from freecad_trabecula.gui.background import is_busy, of_window, work_at_once
from freecad_trabecula.gui.child_work import ChildWork
from freecad_trabecula.gui.notice import notices
from freecad_trabecula.gui.recomputing import WorkBar
from freecad_trabecula.gui.site_panel import open_site_panel

KINDS = {"Trabecula_Analysis": "Trabecula::Analysis", "Trabecula_Voxels": "Trabecula::VoxelDesign"}
THICKNESS, EDGE = 0.01, 0.5  # mm
BEING_COMPUTED = "is being computed: the status bar shows how far it is"


class BackgroundTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.add_body()

    def add_body(self):
        """Put the body alone into the document; nothing of it is at hand."""
        results.clear()
        for name in self.names():
            self.document.removeObject(name)
        self.body = self.document.addObject("Part::Feature", "Sample")
        self.body.Shape = Part.makeBox(4, 4, 5).cut(Part.makeBox(2, 2, 99))
        self.document.recompute()

    def tearDown(self):
        for work in of_window().works():
            of_window().cancel(work)
        super().tearDown()

    def at_work(self, command, obj=None):
        """Open a panel on the body, or on an object that is there, and have it work."""
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, (obj or self.body).Name)
        FreeCADGui.runCommand(command)
        panel = panels.current()
        if command == "Trabecula_Voxels":
            panel.fields.edges[0].set_value(EDGE)
        else:
            panel.fields.layers.fields["thickness"].set_value(THICKNESS)
        panel.work()
        self.assertIsNotNone(panel._work, (self.dialogs, panel.message.text()))
        return panel

    def leave(self, command, obj=None):
        """Have a panel work and leave that to the status bar by its button."""
        panel = self.at_work(command, obj)
        self.assertFalse(panel.build_bar.leave_button.isHidden())
        panel.build_bar.leave_button.click()
        settle(0.2)
        self.assertFalse(panel.is_open or FreeCADGui.Control.activeDialog())

    def wait_for_all(self):
        self.assertTrue(wait(lambda: not is_busy(), 240))
        settle(0.3)

    def of_kind(self, command):
        return [obj for obj in self.document.Objects if type_of(obj) == KINDS[command]]

    def bars(self):
        found = FreeCADGui.getMainWindow().statusBar().findChildren(WorkBar)
        return [bar for bar in found if bar.isVisible()]

    def made(self, command):
        """An object of a kind, made of the body."""
        if command == "Trabecula_Voxels":
            return make.make_voxel_design(self.document, self.body, VoxelParameters(size=(1.0, 1.0, 1.0)))
        return make.make_analysis(self.document, self.body, SliceParameters(thickness=0.5))

    def test_both_go_on_side_by_side_and_each_comes_as_one_step_to_undo(self):
        before = self.names()
        for command in KINDS:
            self.leave(command)
        self.assertEqual((self.names(), len(self.bars())), (before, 2))
        self.wait_for_all()
        self.assertEqual((self.dialogs, self.bars()), ([], []))
        for command in KINDS:
            (obj,) = self.of_kind(command)
            self.assertTrue(obj.isValid())
        self.assertEqual(sorted(self.document.UndoNames), ["Analyse", "Design voxels"])
        (analysis,) = self.of_kind("Trabecula_Analysis")
        self.assertAlmostEqual(analysis.SliceVolume.Value, 4 * 4 * 5 - 2 * 2 * 5, delta=0.1)
        while self.document.UndoNames:
            self.document.undo()
        self.assertEqual(self.names(), before)

    def test_another_panel_is_opened_and_worked_meanwhile(self):
        self.leave("Trabecula_Analysis")
        panel = self.open_preset("case1")
        for kind, box in panel.build_bar.boxes.items():
            box.setChecked(kind == "network")
        self.build(panel)
        panels.current().reject()
        self.wait_for_all()
        self.assertEqual(len(self.of_kind("Trabecula_Analysis")), 1)
        self.assertEqual(sorted(self.document.UndoNames), ["Analyse", "Design rods"])
        self.assertEqual(self.dialogs, [])

    def test_ok_leaves_the_work_too_and_the_bar_in_the_status_bar_ends_it(self):
        for command in KINDS:
            with self.subTest(command):
                panel = self.at_work(command)
                panel.accept()
                self.assertFalse(panel.is_open)
                (bar,) = self.bars()
                bar.button.click()
                settle(0.5)
                self.assertEqual((self.bars(), self.names(), self.document.UndoNames), ([], ["Sample"], []))
                self.assertTrue(wait(lambda: not ChildWork._running, 30))

    def test_ok_of_a_panel_at_rest_does_the_work_and_closes(self):
        for command in KINDS:
            with self.subTest(command):
                panel = self.at_work(command)
                panel.cancel()
                panel.accept()
                self.assertTrue(panel.is_open)
                self.assertTrue(wait(lambda panel=panel: not panel.is_open, 240), self.dialogs)
                self.assertEqual(len(self.of_kind(command)), 1)
                settle(0.3)

    def test_an_object_that_is_being_computed_is_not_opened_nor_changed_otherwise(self):
        for command in KINDS:
            with self.subTest(command):
                obj = self.made(command)
                self.leave(command, obj)
                obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
                settle(0.2)
                self.assertFalse(FreeCADGui.Control.activeDialog())
                said = FreeCADGui.getMainWindow().statusBar().currentMessage()
                self.assertEqual(said, f"{obj.Label} {BEING_COMPUTED}")
                self.wait_for_all()
                obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
                self.assertTrue(wait(FreeCADGui.Control.activeDialog, 10))
                panels.current().reject()
                settle(0.3)
                self.assertEqual(len(self.of_kind(command)), 1)

    def test_a_change_by_one_click_of_what_is_being_computed_is_refused(self):
        analysis = self.made("Trabecula_Analysis")
        self.leave("Trabecula_Analysis", analysis)
        wish = Wish(self.document.Name, SliceParameters(thickness=0.25), "Sample", analysis=analysis.Name)
        with self.assertRaisesRegex(ParameterError, BEING_COMPUTED):
            work_at_once(wish.order(), lambda obj: None)

    def test_sites_of_a_design_that_is_being_built_are_not_opened(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        panels.open_change(wireframe)
        panel = panels.current()
        self.wait_for_estimate(panel)
        panel.build()
        panel.leave()
        open_site_panel(wireframe)
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertIn(BEING_COMPUTED, FreeCADGui.getMainWindow().statusBar().currentMessage())

    def test_what_is_deleted_meanwhile_is_said_at_the_end(self):
        for command in KINDS:
            for gone in ("body", "object"):
                with self.subTest(command, gone=gone):
                    self.add_body()
                    self.dialogs.clear()
                    obj = self.made(command) if gone == "object" else None
                    self.leave(command, obj)
                    name = obj.Name if obj else "Sample"
                    self.document.removeObject(name)
                    self.wait_for_all()
                    self.assertEqual(self.dialogs, [f"{name} was deleted meanwhile"])
                    self.assertEqual(self.of_kind(command), [])

    def test_a_body_that_changes_meanwhile_is_worked_on_as_it_is_in_the_end(self):
        self.leave("Trabecula_Analysis")
        self.body.Shape = Part.makeBox(1, 2, 3)
        self.document.recompute()
        starts, start = [], ChildWork.start
        ChildWork.start = lambda work: (starts.append(work), start(work))
        try:
            self.wait_for_all()
        finally:
            ChildWork.start = start
        (analysis,) = self.of_kind("Trabecula_Analysis")
        self.assertAlmostEqual(analysis.SliceVolume.Value, 6.0, delta=0.01)
        self.assertEqual((len(starts), self.document.UndoNames.count("Analyse")), (1, 1))

    def test_an_envelope_that_is_moved_meanwhile_is_filled_where_it_is_in_the_end(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        panels.open_change(wireframe)
        panel = panels.current()
        self.wait_for_estimate(panel)
        panel.fields.seed.set_value(9)
        panel.build_bar.boxes["scaffold"].setChecked(True)
        panel.build()
        panel.leave()
        wireframe.Envelope.Placement.Base = FreeCAD.Vector(0, 0, 100)
        self.wait_for_all()
        self.assertEqual((self.dialogs, wireframe.Seed), ([], 9))
        self.assertGreater(self.document.getObject("Scaffold").Mesh.BoundBox.ZMin, 99.9)

    def test_a_step_of_another_panel_is_not_cut_in_two(self):
        self.leave("Trabecula_Voxels")

        class Foreign:
            """A task panel of another workbench."""

            def __init__(self):
                self.form = QtGui.QLabel("foreign")

        FreeCADGui.Control.showDialog(Foreign())
        self.document.openTransaction("Foreign")
        self.body.Label = "Renamed"
        self.assertTrue(wait(lambda: all(not work._process for work in of_window().works()), 240))
        settle(0.5)
        self.assertEqual((self.of_kind("Trabecula_Voxels"), len(self.bars())), ([], 1))
        self.body.Label2 = "and described"
        self.document.commitTransaction()
        FreeCADGui.Control.closeDialog()
        self.wait_for_all()
        self.assertEqual(len(self.of_kind("Trabecula_Voxels")), 1)
        self.assertEqual(self.document.UndoNames, ["Design voxels", "Foreign"])
        self.document.undo()
        self.document.undo()
        self.assertEqual((self.body.Label, self.body.Label2), ("Sample", ""))

    def test_the_end_is_told_elsewhere_and_show_leads_to_the_object(self):
        self.leave("Trabecula_Analysis")
        other = FreeCAD.newDocument("Other")
        FreeCAD.setActiveDocument(other.Name)
        self.wait_for_all()
        self.assertEqual(FreeCAD.ActiveDocument, other)
        (analysis,) = self.of_kind("Trabecula_Analysis")
        self.assertEqual(notices().texts(), [f"{self.document.Label}: {analysis.Label} is done"])
        notices()._rows[0].show_button.click()
        self.assertEqual(FreeCAD.ActiveDocument, self.document)
        self.assertEqual(FreeCADGui.Selection.getSelection(), [analysis])

    def test_one_click_is_work_of_the_same_kind(self):
        analyse_at_once(self.body, lambda obj: None)
        self.assertTrue(is_busy(self.document.Name, "analysis"))
        self.assertFalse(is_busy(self.document.Name, "voxels") or is_busy("Other"))
        self.wait_for_all()
        self.assertEqual(len(self.of_kind("Trabecula_Analysis")), 1)
