# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels that are closed by others while a worker is busy: with the dialog, the document, the object."""

import itertools

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore, QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.child_work import ChildWork
from freecad_trabecula.gui.site_panel import open_site_panel

#: Seconds in which a worker that was not stopped would have told what it found.
LATE = 2.0
BRACKETS = itertools.count(1)


class EndsTest(WindowTest):
    """Base: no error may go unseen, and nothing goes on in the end."""

    def setUp(self):
        super().setUp()
        self.name = self.document.Name

    def assert_ended(self, panel):
        """The panel is closed, tells nothing more, and has left no process, no selection gate, nothing in the scene."""
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 5), "the dialog is still open")
        self.assertFalse(panel.is_open)
        settle(LATE)
        self.assertEqual((self.errors, self.dialogs), ([], []))
        self.assertTrue(wait(lambda: not ChildWork._running, 10), "a process goes on")
        if self.name in FreeCAD.listDocuments():
            box = self.document.addObject("Part::Box", "Free")
            self.document.recompute()
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(self.document.Name, box.Name, "Face1")
            self.assertEqual(len(FreeCADGui.Selection.getSelectionEx()), 1, "a selection gate is left")

    def close_in_every_way(self, open_busy, objects=()):
        """Close a panel that ``open_busy`` opens by closeDialog, by deleting each of some objects, with the document.

        ``open_busy`` makes what it needs in ``self.document`` and returns the panel, at work.
        """
        ways = [lambda: FreeCADGui.Control.closeDialog(), lambda: FreeCAD.closeDocument(self.name)]
        ways += [lambda name=name: self.document.removeObject(name) for name in objects]
        for way in ways:
            panel = open_busy()
            way()
            self.assert_ended(panel)
            if self.name in FreeCAD.listDocuments():
                FreeCAD.closeDocument(self.name)
            self.document = FreeCAD.newDocument(self.name)
            settle(0.2)

    def bracket(self):
        """A body with voids in its box, unlike those before: what was computed of them is at hand."""
        bracket = self.document.addObject("Part::Feature", "Sample")
        bracket.Shape = Part.makeBox(4, 4, 4 + 0.5 * next(BRACKETS)).cut(Part.makeBox(2, 2, 99))
        return bracket

    def box(self):
        box = self.document.addObject("Part::Box", "Sample")
        box.Length = box.Width = box.Height = 4
        self.document.recompute()
        return box

    def select(self, obj):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, obj.Name)


class DesignEndsTest(EndsTest):
    def busy_estimate(self):
        FreeCADGui.runCommand("Trabecula_Preset_case6")
        panel = panels.current()
        self.assertTrue(wait(lambda: panel.worker._busy, 20))
        return panel

    def test_while_the_estimate_is_on_its_way(self):
        self.close_in_every_way(self.busy_estimate)

    def test_just_after_a_drawing_was_sent_and_before_it_was_heard(self):
        """The signal of another thread waits in the event loop when the dialog closes."""
        panel = self.busy_estimate()
        sent = []
        send = panel.worker._send
        panel.worker._send = lambda signal, value: (send(signal, value), sent.append(value))
        while not sent:  # the event loop stands still meanwhile
            pass
        FreeCADGui.Control.closeDialog()
        self.assert_ended(panel)

    def test_while_it_builds_a_design_that_is_there(self):
        def open_busy():
            self.document.UndoMode = 1
            design = make.make_design(self.document, preset("case1"), ("scaffold",))
            before = [obj.Name for obj in self.document.Objects]
            panels.open_change(design.wireframe)
            panel = panels.current()
            self.wait_for_estimate(panel)
            panel.fields.seed.set_value(7)
            panel.build()
            self.assertTrue(wait(lambda: panel.build_bar.bar.value() > 0, 60))
            self.assertEqual([obj.Name for obj in self.document.Objects], before)
            return panel

        self.close_in_every_way(open_busy, ("Wireframe", "Envelope"))

    def test_what_was_hidden_for_the_preview_comes_back_and_the_preview_goes(self):
        box = self.box()
        self.select(box)
        FreeCADGui.runCommand("Trabecula_Design")
        panel = panels.current()
        self.assertTrue(wait(lambda: box.ViewObject.Transparency > 0, 20))
        FreeCADGui.Control.closeDialog()
        self.assert_ended(panel)
        self.assertEqual(box.ViewObject.Transparency, 0)
        self.assertEqual(FreeCADGui.ActiveDocument.ActiveView.getSceneGraph().findChild(panel.preview.node), -1)

    def test_an_envelope_that_is_deleted_leaves_the_panel_with_a_new_prism(self):
        box = self.box()
        self.select(box)
        FreeCADGui.runCommand("Trabecula_Design")
        panel = panels.current()
        self.assertTrue(wait(lambda: panel.worker._busy, 20))
        self.assertEqual(panel.envelope, box)
        self.document.removeObject(box.Name)
        settle(LATE)
        self.assertEqual((panel.is_open, panel.envelope, self.errors, self.dialogs), (True, None, [], []))
        panel.reject()
        self.assert_ended(panel)


class TreeTest(EndsTest):
    """Whether the tree or the Tasks are in front where one lies behind the other."""

    def setUp(self):
        super().setUp()
        window = FreeCADGui.getMainWindow()
        self.docks = {dock.objectName(): dock for dock in window.findChildren(QtGui.QDockWidget)}
        if "Model" in self.docks:  # FreeCAD 1.x; before, both are pages of one dock, and FreeCAD brings the tree back
            window.addDockWidget(QtCore.Qt.LeftDockWidgetArea, self.docks["Tasks"])
            window.tabifyDockWidget(self.docks["Model"], self.docks["Tasks"])
            self.docks["Tasks"].show()
        self.turn_to("Model")

    def turn_to(self, name):
        if "Model" in self.docks:
            self.docks[name].raise_()
        settle(0.5)

    def front(self):
        if "Model" in self.docks:
            return next(name for name in ("Model", "Tasks") if not self.docks[name].visibleRegion().isEmpty())
        pages = self.docks["Combo View"].findChild(QtGui.QTabWidget)
        return pages.tabText(pages.currentIndex())

    def test_the_tree_comes_back_when_a_panel_and_the_next_have_closed(self):
        self.assertEqual(self.front(), "Model")
        wireframe = make.make_design(self.document, preset("case1"), ("network",)).wireframe
        panels.open_results(self.document.Name, wireframe)
        settle(0.5)
        self.assertEqual(self.front(), "Tasks")
        panels.current().reject()
        panels.open_results(self.document.Name, wireframe)  # as after a build
        settle(0.5)
        self.assertEqual(self.front(), "Tasks")
        panels.current().reject()
        settle(0.5)
        self.assertEqual(self.front(), "Model")

    def test_tasks_that_were_in_front_before_stay_there(self):
        if "Model" not in self.docks:
            return  # FreeCAD 0.20 always turns to the tree
        self.turn_to("Tasks")
        panels.open_results(self.document.Name, make.make_design(self.document, preset("case1")).wireframe)
        settle(0.5)
        panels.current().reject()
        settle(0.5)
        self.assertEqual(self.front(), "Tasks")


class BodyEndsTest(EndsTest):
    """Panels on a design that is there."""

    def design(self):
        return make.make_design(self.document, preset("case1"), ("network",)).wireframe

    def test_results(self):
        def open_busy():
            panels.open_results(self.document.Name, self.design())
            return panels.current()

        self.close_in_every_way(open_busy, ("Wireframe",))

    def test_sites(self):
        def open_busy():
            open_site_panel(self.design())
            return panels.current()

        self.close_in_every_way(open_busy, ("Wireframe",))

    def test_sites_that_are_recomputed_when_the_dialog_closes(self):
        wireframe = self.design()
        open_site_panel(wireframe)
        panel = panels.current()
        FreeCADGui.Control.closeDialog()
        site = wireframe.Sites[0]
        wireframe.Seed = 5
        self.document.recompute()
        FreeCADGui.Selection.addSelection(self.document.Name, site.Name, "Vertex1")
        self.assert_ended(panel)


class WorkEndsTest(EndsTest):
    """Panels whose work another process does."""

    def at_work(self, command):
        """Open a panel on a body and have it work."""
        self.select(self.bracket())
        FreeCADGui.runCommand(command)
        panel = panels.current()
        if command == "Trabecula_Voxels":
            panel.fields.edges[0].set_value(0.5)
        else:
            panel.fields.layers.fields["thickness"].set_value(0.004)
        panel.work()
        self.assertIsNotNone(panel._work, (self.dialogs, panel.message.text(), panel.is_open, panel.obj))
        return panel

    def test_an_analysis_and_a_voxel_design_at_work(self):
        for command in ("Trabecula_Analysis", "Trabecula_Voxels"):
            with self.subTest(command):
                self.close_in_every_way(lambda command=command: self.at_work(command))

    def test_a_body_that_is_deleted_meanwhile_is_told_and_nothing_comes(self):
        for command in ("Trabecula_Analysis", "Trabecula_Voxels"):
            with self.subTest(command):
                panel = self.at_work(command)
                self.document.removeObject("Sample")
                self.assertTrue(wait(lambda panel=panel: panel._work is None, 120))
                settle(0.5)
                self.assertEqual((self.errors, self.dialogs), ([], ["Sample was deleted meanwhile"]))
                self.assertEqual((panel.is_open, self.document.Objects), (True, []))
                panel.reject()
                self.dialogs.clear()
                self.assert_ended(panel)
                self.document.removeObject("Free")

    def test_an_object_that_is_deleted_while_it_is_changed_begins_anew(self):
        obj = make.make_voxel_design(self.document, self.bracket(), VoxelParameters(size=(0.5, 0.5, 0.5)))
        panels.open_voxels(self.document, obj)
        panel = panels.current()
        panel.fields.edges[0].set_value(0.25)
        panel.work()
        self.assertIsNotNone(panel._work, self.dialogs)
        self.document.removeObject(obj.Name)
        self.assertEqual((panel.obj, panel._work), (None, None))
        settle(LATE)
        self.assertEqual([one.Name for one in self.document.Objects], ["Sample"])
        panel.reject()
        self.assert_ended(panel)
