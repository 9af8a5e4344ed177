# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design panel as a user meets it: presets, values, estimate, build, cancel, undo, edit, the document closed."""

import time

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import Heartbeat, WindowTest, press, settle, type_into, wait

from freecad_trabecula.core.presets import preset
from freecad_trabecula.gui import panels


class PanelTest(WindowTest):
    def test_a_preset_is_previewed_and_its_porosity_estimated(self):
        panel = self.open_preset("case1")
        self.assertIn("75 rods", panel.outcome.headline.text())
        vertices = panel.preview._rods.vertexProperty.getValue().vertex
        self.assertGreater(vertices.getNum(), 75 * 9 * 8)
        self.assertEqual(self.names(), [])

    def test_the_values_shown_are_those_of_the_preset(self):
        panel = self.open_preset("case5")
        self.assertEqual(panel.fields.job(), preset("case5"))

    def test_a_typed_value_is_taken_and_changes_the_estimate(self):
        panel = self.open_preset("case1")
        before = panel.outcome.headline.text()
        size = panel.fields.pores.fields["size"]
        self.change(panel, lambda: type_into(size.high.widget, "1.1"))
        self.assertEqual(panel.fields.job().pores.size.high, 1.1)
        self.assertNotEqual(panel.outcome.headline.text(), before)

    def test_a_length_in_inches_is_converted(self):
        panel = self.open_preset("case1")
        type_into(panel.fields.prism.fields["l"].widget, "1 in")
        self.assertAlmostEqual(panel.fields.job().prism.l, 25.4, places=9)

    def test_the_arrow_keys_step_a_value(self):
        panel = self.open_preset("case1")
        box = panel.fields.prism.fields["n_x"].widget
        press(box, 0x01000013)  # Qt.Key_Up
        self.assertEqual(panel.fields.job().prism.n_x, 6)

    def test_a_size_range_upside_down_is_refused_in_the_panel_and_nothing_is_lost(self):
        panel = self.open_preset("case1")
        type_into(panel.fields.pores.fields["size"].low.widget, "0.9")
        self.assertTrue(wait(lambda: "low &lt;= high" in panel.outcome.message.text(), 30))
        self.change(panel, lambda: type_into(panel.fields.pores.fields["size"].low.widget, "0.2"))
        self.assertEqual(panel.fields.job(), preset("case1"))

    def test_a_border_of_half_the_edge_is_refused_with_the_rule(self):
        panel = self.open_preset("case1")
        type_into(panel.fields.prism.fields["a_x"].widget, "5")
        self.assertTrue(wait(lambda: "edge / 2 = 5 mm" in panel.outcome.message.text(), 30))

    def test_build_after_a_refused_value_shows_the_sentence_and_starts_nothing(self):
        panel = self.open_preset("case1")
        type_into(panel.fields.prism.fields["a_x"].widget, "7")
        panel.build()
        self.assertEqual(len(self.dialogs), 1)
        self.assertIn("border distance", self.dialogs[0])
        self.assertEqual(self.names(), [])

    def test_cancel_leaves_the_document_as_it_was(self):
        panel = self.open_preset("case1")
        panel.reject()
        settle()
        self.assertEqual(self.names(), [])
        self.assertEqual(self.document.UndoNames, [])
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_ok_keeps_the_design_in_one_step_that_can_be_undone_and_redone(self):
        panel = self.open_preset("case1")
        panel.accept()
        self.assertTrue(wait(lambda: not panel.is_open, 60))
        self.assertEqual(self.names(), ["Envelope", "Sites", "Wireframe"])
        self.assertEqual(self.document.UndoNames, ["Design rods"])
        self.document.undo()
        self.assertEqual(self.names(), [])
        self.document.redo()
        self.assertEqual(self.wireframe().Rods, 75)

    def test_a_second_panel_does_not_open(self):
        panel = self.open_preset("case1")
        panels.open_new(self.document)
        self.assertIs(panels.current(), panel)

    def test_closing_the_document_closes_the_panel(self):
        panel = self.open_preset("case1")
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 30))
        self.assertFalse(panel.is_open)

    def test_the_preview_leaves_nothing_in_the_scene(self):
        scene = FreeCADGui.getDocument(self.document.Name).mdiViewsOfType("Gui::View3DInventor")[0].getSceneGraph()
        before = scene.getNumChildren()
        panel = self.open_preset("case1")
        self.assertEqual(scene.getNumChildren(), before + 1)
        panel.reject()
        self.assertEqual(scene.getNumChildren(), before)

    def test_the_form_fits_into_the_dock_at_1280_pixels(self):
        window = FreeCADGui.getMainWindow()
        window.resize(1280, 800)
        panel = self.open_preset("case6")
        for section in range(6):
            panel.fields.sections.open(section)
            settle(0.1)
            for widget in panel.form.findChildren(QtGui.QWidget):
                if widget.isVisible() and isinstance(widget, (QtGui.QAbstractButton, QtGui.QAbstractSpinBox)):
                    right = widget.mapTo(panel.form, widget.rect().topRight()).x()
                    self.assertLessEqual(right, panel.form.width(), widget.metaObject().className())


class SpeedTest(WindowTest):
    """CPU seconds, not wall time: the machine of the tests has other things to do."""

    def test_a_dragged_value_of_147_rods_is_followed_ten_times_a_second(self):
        panel = self.open_preset("case6")
        seconds, served = [], panel.worker._serve

        def timed(request):
            started = time.thread_time()
            try:
                served(request)
            finally:
                seconds.append(time.thread_time() - started)

        panel.worker._serve = timed
        drawn = []
        panel.worker.drawn.connect(lambda outline: drawn.append(outline.job is None))
        size = panel.fields.pores.fields["size"]
        started, own = time.monotonic(), time.thread_time()
        step = 0
        while len(drawn) < 12 and time.monotonic() - started < 60:
            size.high.widget.setProperty("rawValue", 0.6 + 0.01 * (step % 20))
            step += 1
            settle(0.03)
        own = (time.thread_time() - own) / max(len(drawn), 1)
        drafts = sorted(seconds)[: sum(drawn)]
        self.assertGreaterEqual(sum(drawn), 6, "drafts while the value is dragged")
        self.assertLess(drafts[len(drafts) // 2], 0.1, "the preview's thread")
        self.assertLess(own, 0.1, "the window's thread")

    def test_the_estimate_comes_within_a_second_of_work_and_the_window_answers(self):
        panel = self.open_preset("case6")
        with Heartbeat() as heart:
            started = time.process_time()
            self.change(panel, panel.fields.next_seed.click)
            used = time.process_time() - started
        self.assertLess(used, 2.0)  # of which the picture, drawn without a graphics card, takes a good part
        self.assertLess(heart.longest, 1.0)
