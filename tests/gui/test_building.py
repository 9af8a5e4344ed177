# SPDX-License-Identifier: LGPL-2.1-or-later
"""Building in another process: progress, cancel, one step to undo, results, editing what was built."""

import time

import FreeCAD
import FreeCADGui
from window import Heartbeat, WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.parameters import Coupling
from freecad_trabecula.core.presets import preset
from freecad_trabecula.features import results
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.figures import checks_of
from freecad_trabecula.gui.recomputing import WorkBar
from freecad_trabecula.gui.results_panel import ResultsPanel
from freecad_trabecula.gui.rod_commands import switch_view


def tick(panel, *kinds):
    """Choose the bodies to be built."""
    for kind, box in panel.build_bar.boxes.items():
        box.setChecked(kind in kinds)


def bars():
    """Return the bars of builds that were left to the status bar."""
    found = FreeCADGui.getMainWindow().statusBar().findChildren(WorkBar)
    return [bar for bar in found if bar.isVisible()]


class BuildTest(WindowTest):
    def setUp(self):
        super().setUp()
        results.clear()

    def test_cancel_in_the_middle_answers_at_once_and_changes_nothing(self):
        panel = self.open_preset("case6")
        tick(panel, "network", "scaffold")
        panel.build()
        self.assertTrue(wait(lambda: panel.build_bar.bar.value() > 0, 60), "no progress was reported")
        self.assertTrue(panel.build_bar.what.text())
        started = time.monotonic()
        panel.build_bar.cancel_button.click()
        self.assertLess(time.monotonic() - started, 1.0)
        self.assertIsNone(panel._building)
        self.assertEqual((self.names(), self.document.UndoNames), ([], []))
        self.assertTrue(panel.fields.sections.isEnabled())
        settle(2.0)
        self.assertEqual(self.names(), [])

    def test_closing_the_document_while_it_is_built_ends_the_work(self):
        panel = self.open_preset("case1")
        panel.build()
        settle(0.5)
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 30))
        self.assertIsNone(panel._building)

    def start_and_leave(self, name="case1"):
        """Build a design of the thesis and leave it to the status bar; return the bar there."""
        before = bars()
        panel = self.open_preset(name)
        tick(panel, "network", "scaffold")
        panel.build()
        self.assertTrue(wait(lambda: panel.build_bar.bar.value() > 0, 60))
        panel.build_bar.leave_button.click()
        settle(0.2)
        self.assertFalse(panel.is_open or FreeCADGui.Control.activeDialog())
        (bar,) = [one for one in bars() if one not in before]
        return bar

    def test_two_builds_left_to_the_status_bar_go_on_side_by_side_and_do_not_mix(self):
        first = self.document
        self.start_and_leave("case6")
        second = FreeCAD.newDocument("Second")
        self.start_and_leave("case1")
        self.assertEqual((first.Objects, second.Objects, len(bars())), ([], [], 2))
        self.assertTrue(wait(lambda: not bars(), 240))
        settle(0.5)
        layouts = []
        for document in (first, second):
            # FreeCAD marks a step of another document by an arrow in the one that is active
            own = [name for name in document.UndoNames if not name.startswith("-> ")]
            self.assertEqual(own, ["Design rods"])
            network = document.getObject("Network")
            self.assertTrue(network.isValid() and document.getObject("Scaffold").isValid())
            layouts.append(network.Wireframe.PoreLayout)
            while document.UndoNames:
                document.undo()
            self.assertEqual(document.Objects, [])
        self.assertEqual(layouts, [preset("case6").pores.layout, preset("case1").pores.layout])
        self.assertEqual(self.dialogs, [])

    def test_ok_leaves_a_build_too_and_the_bar_of_the_status_bar_ends_it(self):
        design = make.make_design(self.document, preset("case1"))
        panels.open_change(design.wireframe)
        panel = panels.current()
        self.wait_for_estimate(panel)
        panel.fields.seed.set_value(8)
        tick(panel, "scaffold")
        panel.build()
        panel.accept()
        self.assertFalse(panel.is_open)
        self.assertFalse(panels.open_change(design.wireframe), "a design that is built is open to be changed")
        (bar,) = bars()
        bar.button.click()
        settle(2.0)
        self.assertEqual((bars(), design.wireframe.Seed, self.document.getObject("Scaffold")), ([], 1, None))
        self.assertTrue(panels.open_change(design.wireframe))

    def test_a_design_that_is_deleted_while_it_is_built_in_the_status_bar_is_told(self):
        design = make.make_design(self.document, preset("case1"))
        panels.open_change(design.wireframe)
        panel = panels.current()
        self.wait_for_estimate(panel)
        tick(panel, "scaffold")
        panel.build()
        panel.accept()
        self.document.removeObject(design.wireframe.Name)
        self.assertTrue(wait(lambda: not bars(), 120))
        settle(0.5)
        self.assertEqual(
            (self.dialogs, self.document.getObject("Scaffold")), (["Wireframe was deleted meanwhile"], None)
        )

    def test_built_bodies_come_in_one_step_and_the_results_open(self):
        panel = self.open_preset("case1")
        tick(panel, "network", "scaffold")
        with Heartbeat() as heart:
            self.build(panel)
        self.assertEqual(self.document.UndoNames, ["Design rods"])
        self.assertIn("Network", self.names())
        self.assertIn("Scaffold", self.names())
        self.assertTrue(wait(lambda: isinstance(panels.current(), ResultsPanel), 30))
        report = panels.current()
        self.assertIn("75 rods, porosity", report.headline.text())
        self.assertTrue(all(check.ok for check in checks_of(self.wireframe())), checks_of(self.wireframe()))
        self.assertGreater(report.figures.rowCount(), 10)
        self.assertLess(heart.longest, 2.0)
        report.reject()
        self.document.undo()
        self.assertEqual(self.names(), [])
        self.document.redo()
        self.assertEqual(self.document.getObject("Network").Rods, 75)

    def test_a_double_click_opens_the_panel_with_the_values_and_a_change_is_built(self):
        panel = self.open_preset("case1")
        tick(panel, "network")
        self.build(panel)
        panels.current().reject()
        wireframe = self.wireframe()
        self.assertTrue(wireframe.ViewObject.Proxy.doubleClicked(wireframe.ViewObject))
        self.assertTrue(wait(FreeCADGui.Control.activeDialog, 30))
        panel = panels.current()
        self.assertEqual(panel.fields.job().wireframe, wireframe.Proxy.parameters(wireframe))
        self.wait_for_estimate(panel)
        self.change(panel, lambda: panel.fields.seed.set_value(5))
        panel.accept()
        self.assertTrue(wait(lambda: not panel.is_open, 120))
        settle(0.5)
        self.assertEqual(wireframe.Seed, 5)
        self.assertTrue(self.document.getObject("Network").UpToDate)
        self.assertEqual(len(self.document.UndoNames), 2)
        self.document.undo()
        self.assertEqual(wireframe.Seed, 1)

    def test_a_double_click_on_a_body_opens_the_results(self):
        panel = self.open_preset("case1")
        tick(panel, "network")
        self.build(panel)
        panels.current().reject()
        view = self.document.getObject("Network").ViewObject
        view.Proxy.doubleClicked(view)
        self.assertTrue(wait(lambda: isinstance(panels.current(), ResultsPanel), 30))

    def test_rods_and_channels_are_switched(self):
        panel = self.open_preset("case1")
        tick(panel, "network", "scaffold")
        self.build(panel)
        panels.current().reject()
        channels = next(obj for obj in self.document.Objects if getattr(obj, "Role", "") == "channels")
        network = self.document.getObject("Network")
        for expected in (True, False):
            switch_view(self.wireframe())
            self.assertEqual(channels.ViewObject.Visibility, expected)
            self.assertEqual(network.ViewObject.Visibility, not expected)

    def test_a_work_that_fails_tells_its_sentence_and_changes_nothing(self):
        panel = self.open_preset("case1")
        # the preview is not asked: the child process must refuse
        panel.fields.couplings._couplings = [Coupling("Face1", "Face1")]
        panel.build()
        self.assertTrue(wait(lambda: self.dialogs, 60))
        self.assertIn("coupled with itself", self.dialogs[0])
        self.assertEqual(self.names(), [])
        self.assertTrue(panel.fields.sections.isEnabled())
