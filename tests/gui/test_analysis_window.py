# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slice analyses in the window: panel, one click, plots with the slice under the cursor, comparison."""

import math
import os
import tempfile
import time
from dataclasses import replace

import FreeCAD
import FreeCADGui
import Mesh
import numpy as np
from PySide import QtCore, QtGui
from window import Heartbeat, WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.features import results
from freecad_trabecula.features.on_demand import COMPUTING
from freecad_trabecula.features.relations import type_of
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.analysis_dock import KIND, dock_of_window, show_analyses
from freecad_trabecula.gui.analysis_plots import KINDS, compared_diagram, comparison_of, diagram_of
from freecad_trabecula.gui.analysis_saving import save
from freecad_trabecula.gui.background import is_busy
from freecad_trabecula.gui.chart import axes_of, nice_steps
from freecad_trabecula.gui.commands import COMMANDS
from freecad_trabecula.gui.preferences import preferred_colour
from freecad_trabecula.gui.slice_view import legend_of, plane_corners

COARSE = SliceParameters(thickness=0.5)


class AnalysisCase(WindowTest):
    def setUp(self):
        super().setUp()
        results.clear()

    def tearDown(self):
        dock_of_window().hide()
        super().tearDown()

    def analyses(self):
        return [obj for obj in self.document.Objects if type_of(obj) == KIND]

    def select(self, obj):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, obj.Name)

    def open_panel(self, obj):
        self.select(obj)
        FreeCADGui.runCommand("Trabecula_Analysis")
        return panels.current()

    def analyse(self, panel):
        panel.work()
        self.assertTrue(wait(lambda: panel._work is None, 120), self.dialogs)
        settle(0.3)


class PanelTest(AnalysisCase):
    def test_a_body_is_analysed_in_one_step_and_the_plots_open(self):
        panel = self.open_panel(self.torus())
        panel.fields.layers.fields["thickness"].set_value(0.5)
        self.assertIn("Z 8", panel.message.text())
        self.analyse(panel)
        (obj,) = self.analyses()
        self.assertEqual(self.document.UndoNames[0], "Analyse")
        self.assertAlmostEqual(obj.SliceVolume.Value, 2 * math.pi**2 * 5 * 4, delta=4)
        self.assertTrue(dock_of_window().isVisible())
        self.assertEqual([one.Name for one in dock_of_window().ticked()], [obj.Name])
        panel.reject()
        self.document.undo()
        self.assertEqual(self.analyses(), [])

    def test_the_same_panel_changes_the_analysis_that_it_made(self):
        panel = self.open_panel(self.torus())
        panel.fields.layers.fields["thickness"].set_value(1.0)
        self.analyse(panel)
        panel.fields.layers.fields["thickness"].set_value(0.5)
        panel.fields.axes["x"].setChecked(False)
        self.analyse(panel)
        (obj,) = self.analyses()
        self.assertEqual((obj.SliceThickness.Value, list(obj.SliceAxes)), (0.5, ["y", "z"]))
        self.assertEqual(self.document.UndoNames[:2], ["Analyse", "Analyse"])

    def test_ok_closes_the_panel_when_the_work_is_done(self):
        panel = self.open_panel(self.torus())
        panel.fields.layers.fields["thickness"].set_value(1.0)
        panel.accept()
        self.assertTrue(wait(lambda: not panel.is_open, 120))
        self.assertEqual(len(self.analyses()), 1)

    def test_a_double_click_opens_the_panel_with_the_values(self):
        chosen = SliceParameters(0.5, ("z", "0.6,0.8,0"), low=-1.5, high=1.5, gap=0.02, fill="winding", rod_ratio=0.5)
        obj = make.make_analysis(self.document, self.torus(), chosen)
        panels.open_for(self.document.Name, obj.Name)
        self.assertEqual(repr(panels.current().fields.value()), repr(chosen))

    def test_cancel_answers_at_once_and_changes_nothing(self):
        panel = self.open_panel(self.torus())
        panel.fields.layers.fields["thickness"].set_value(0.01)
        panel.fields.morphometry.setChecked(True)
        panel.work()
        settle(1.5)
        started = time.monotonic()
        panel.cancel()
        self.assertLess(time.monotonic() - started, 1.0)
        self.assertIsNone(panel._work)
        settle(2.0)
        self.assertEqual((self.analyses(), self.document.UndoNames[:1]), ([], []))

    def test_values_that_are_refused_are_told_and_nothing_is_made(self):
        panel = self.open_panel(self.torus())
        for axis in "xyz":
            panel.fields.axes[axis].setChecked(False)
        self.assertIn("at least one axis", panel.message.text())
        panel.work()
        panel.fields.axes["z"].setChecked(True)
        panel.fields.layers.fields["thickness"].set_value(0.0)
        panel.work()
        self.assertEqual(len(self.dialogs), 2)
        self.assertIn("greater than 0", self.dialogs[1])
        self.assertEqual(self.analyses(), [])

    def test_without_a_body_the_panel_asks_for_one(self):
        FreeCADGui.runCommand("Trabecula_Analysis")
        panels.current().work()
        self.assertEqual(len(self.dialogs), 1)
        self.assertIn("choose an object or a file", self.dialogs[0])

    def test_a_file_is_analysed_with_its_unit(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube.stl")
            Mesh.createBox(2, 2, 2).write(path)
            FreeCADGui.runCommand("Trabecula_Analysis")
            panel = panels.current()
            panel.fields.set_file(path)
            panel.fields.unit.setCurrentText("cm")
            panel.fields.layers.fields["thickness"].set_value(1.0)
            self.analyse(panel)
            (obj,) = self.analyses()
            self.assertAlmostEqual(obj.SliceVolume.Value, 8000, delta=1)
            panel.reject()

    def test_what_the_panel_does_can_be_run_as_a_macro(self):
        from freecad_trabecula.gui import document_work

        lines, record = [], document_work.record
        document_work.record = lambda text: (lines.append(text), record(text))
        try:
            panel = self.open_panel(self.torus())
            panel.fields.layers.fields["thickness"].set_value(0.5)
            self.analyse(panel)
        finally:
            document_work.record = record
        exec("\n".join(lines), {})  # noqa: S102
        first, second = self.analyses()
        self.assertEqual(first.ResultKey, second.ResultKey)


class DockTest(AnalysisCase):
    def setUp(self):
        super().setUp()
        self.obj = make.make_analysis(self.document, self.torus(), COARSE)
        for axis in "xyz":
            make.contours_of(self.obj, axis)
        self.dock = show_analyses([self.obj])
        settle(0.5)

    def test_every_diagram_is_painted_within_a_moment(self):
        for number, (kind, _) in enumerate(KINDS):
            with self.subTest(kind=kind), Heartbeat() as beat:
                self.dock.tabs.setCurrentIndex(number)
                settle(0.2)
                self.assertLess(beat.busiest, 0.2)
            diagram = self.dock.charts[kind].diagram
            self.assertTrue(diagram.curves or diagram.counts is not None)
        self.dock.tabs.setCurrentIndex(len(KINDS))
        self.assertEqual(self.dock.figures.item(0, 0).text(), "Slices")

    def test_equal_slices_of_a_box_are_a_level_line(self):
        box = make.make_box(self.document, 3.3, 2.7, 4.1)
        found = make.analysis_of(make.make_analysis(self.document, box))
        profile = found.profiles["x"]
        self.assertGreater(len(set(profile.sliced_area.tolist())), 1)  # rounding, of single precision
        alone = replace(found, profiles={"x": profile}, name="box")
        both = [alone, replace(alone, name="the same")]
        compared = compared_diagram(comparison_of(both), both, "heat", "x")
        for diagram in (diagram_of(alone, "sliced_area", "x"), diagram_of(alone, "porosity", "x"), compared):
            axis = axes_of(diagram)[1]
            shares = axis.share(np.concatenate([curve.y for curve in diagram.curves]))
            self.assertTrue(((shares > 0.3) & (shares < 0.7)).all(), shares)
            self.assertLess(np.ptp(shares), 1e-3)

    def test_the_slice_under_the_cursor_is_shown_with_its_plane(self):
        self.dock.take_axis("z")
        chart = self.dock.charts["sliced_area"]
        self.dock.tabs.setCurrentIndex(0)
        for share in (0.1, 0.5, 0.9):
            box = chart.box()
            place = QtCore.QPointF(box.left() + share * box.width(), box.center().y())
            kind, left, none = QtCore.QEvent.MouseMove, QtCore.Qt.NoButton, QtCore.Qt.NoModifier
            QtGui.QApplication.sendEvent(chart, QtGui.QMouseEvent(kind, place, place, left, left, none))
            profile = make.analysis_of(self.obj).profiles["z"]
            axis = chart._axes[0]
            wanted = axis.low + share * (axis.high - axis.low)
            self.assertEqual(self.dock.plane, int(np.abs(profile.coordinate - wanted).argmin()))
            one = self.dock.view.slice
            # z: a ring, its outer contour and its void
            self.assertEqual([bool(area > 0) for area in sorted(one.areas)], [False, True])
            self.assertAlmostEqual(float(one.areas.sum()), float(profile.sliced_area[self.dock.plane]), 6)
            node = self.dock._slice_plane._corners.point
            self.assertAlmostEqual(node[0].getValue()[2], float(profile.coordinate[self.dock.plane]), 4)

    def test_rods_and_plates_have_their_colours_and_voids_none(self):
        self.dock.take_axis("z")
        self.dock.show_plane(4)
        settle(0.2)
        image = self.dock.view.grab().toImage()
        counts = {}
        for x in range(image.width()):
            for y in range(24, image.height() - 60):  # words above, the legend below
                name = QtGui.QColor(image.pixel(x, y)).name().upper()
                counts[name] = counts.get(name, 0) + 1
        paper = QtGui.QColor(self.dock.view.palette().color(QtGui.QPalette.Base)).name().upper()
        colours = [preferred_colour(name).upper() for name in ("ColourRodContours", "ColourPlateContours")]
        ring, body = sum(counts.get(colour, 0) for colour in colours), self.dock.view.slice
        scale = self.dock.view._scale(body)[0]
        self.assertLess(abs(ring / (float(body.areas.sum()) * scale**2) - 1), 0.1)  # borders are smoothed
        self.assertGreater(counts.get(paper, 0), ring / 10)
        entries = {entry.name: entry.count for entry in legend_of(body).entries}
        kind = "rods" if body.rods[body.areas > 0][0] else "plates"
        self.assertEqual(entries, {"rods": 0, "plates": 0, kind: 1})

    def test_the_plane_leaves_the_view_with_the_dock(self):
        self.assertIsNotNone(self.dock._slice_plane)
        self.dock.hide()
        settle(0.2)
        self.assertIsNone(self.dock._slice_plane)

    def test_it_follows_its_source_and_the_contours_come_from_another_process(self):
        self.document.getObject("Torus").Radius2 = 1
        self.document.recompute()
        self.assertEqual(self.obj.Status, COMPUTING)
        self.assertTrue(wait(lambda: self.obj.UpToDate, 120), self.obj.Status)
        self.assertTrue(wait(lambda: self.dock.view.slice is not None, 60))
        settle(0.3)
        widest = np.abs(np.concatenate(self.dock.view.slice.contours)).max()
        self.assertLess(widest, 6.01)

    def test_contours_that_are_not_at_hand_are_worked_out_elsewhere(self):
        results.clear()
        self.dock.show_plane(3)
        self.assertIsNone(self.dock.view.slice)
        self.assertTrue(wait(lambda: self.dock.view.slice is not None, 120))

    def test_the_tree_shows_the_analysis_as_seen_with_its_icon(self):
        self.assertTrue(self.obj.ViewObject.isVisible())
        self.assertTrue(self.obj.ViewObject.Proxy.getIcon().endswith("Trabecula_analysis.svg"))

    def test_closing_the_document_empties_the_dock(self):
        FreeCAD.closeDocument(self.document.Name)
        settle(0.5)
        self.assertEqual(self.dock.list.count(), 0)
        self.assertIsNone(self.dock.view.slice)
        self.document = FreeCAD.newDocument("Next")


class CompareTest(AnalysisCase):
    def setUp(self):
        super().setUp()
        boxes = [make.make_box(self.document, 2, 2, 4), make.make_box(self.document, 2, 3, 6)]
        self.both = [make.make_analysis(self.document, box, COARSE) for box in boxes]

    def test_two_analyses_share_axes_and_get_a_passport(self):
        FreeCADGui.runCommand("Trabecula_Compare")
        dock = dock_of_window()
        dock.take_axis("z")
        settle(0.3)
        curves = dock.charts["sliced_area"].diagram.curves
        self.assertEqual([len(curve.x) for curve in curves], [8, 8])
        self.assertTrue(np.allclose(curves[1].y - curves[0].y, 2.0, atol=1e-4))
        dock.tabs.setCurrentIndex(len(KINDS))
        words = [dock.figures.item(row, 0).text() for row in range(dock.figures.rowCount())]
        self.assertIn("sliced area: L1", words)
        row = words.index("sliced area: L1")
        self.assertEqual(dock.figures.item(row, 3).text(), "0.5")  # along z 6 against 4 mm2
        self.assertEqual(self.dialogs, [])

    def test_one_is_saved_and_both_are_saved_as_a_comparison(self):
        for objects, files in (
            (self.both[:1], ("report.json", "report.md", "profile_x.csv", "contours_z.csv")),
            (self.both, ("report.json", "report.md")),
        ):
            with tempfile.TemporaryDirectory() as folder:
                done = []
                save(objects, folder, lambda done=done: done.append(True))
                self.assertTrue(wait(lambda done=done: done or self.dialogs, 180))
                self.assertEqual(self.dialogs, [])
                found = os.listdir(folder)
                self.assertEqual([name for name in files if name not in found], [])
                self.assertEqual([name for name in found if name.endswith((".part", ".tmp"))], [])

    def test_a_folder_that_cannot_be_written_is_told(self):
        with tempfile.NamedTemporaryFile() as file:
            save(self.both[:1], file.name, lambda: None)
            self.assertTrue(wait(lambda: self.dialogs, 180))
        self.assertIn("could not be made", self.dialogs[0])

    def test_analyses_with_nothing_in_common_are_told_apart_in_words(self):
        for axis, obj in zip("xy", self.both):
            make.change_analysis(obj, SliceParameters(0.5, (axis,)))
        dock = show_analyses(self.both)
        settle(0.2)
        self.assertIsNone(dock.view.slice)
        self.assertIn("axis", dock.view.notice)


class OneClickTest(AnalysisCase):
    def test_a_network_is_analysed_with_one_click(self):
        design = make.make_design(self.document, preset("case1"))
        network = make.make_network(design.wireframe)
        self.select(network)
        with Heartbeat() as beat:
            FreeCADGui.runCommand("Trabecula_AnalyseNow")
            self.assertTrue(is_busy())
            self.assertTrue(wait(lambda: not is_busy(), 180), self.dialogs)
            settle(0.5)
        self.assertLess(beat.busiest, 0.3)
        (obj,) = self.analyses()
        self.assertEqual((obj.Source, obj.Envelope), (network, design.envelope))
        self.assertTrue(dock_of_window().isVisible())
        # 75 circles, each along one axis: a slice across X cuts 25 whole rods and 50 lengthwise
        self.assertEqual(len(make.analysis_of(obj).profiles["x"]), 100)

    def test_a_document_that_is_closed_meanwhile_leaves_nothing_behind(self):
        self.select(self.torus())
        FreeCADGui.runCommand("Trabecula_AnalyseNow")
        settle(0.2)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.newDocument("Next")
        self.assertTrue(wait(lambda: not is_busy(), 120))
        settle(0.3)
        self.assertEqual((self.document.Objects, self.dialogs), ([], []))

    def test_a_selection_that_cannot_be_sliced_is_told(self):
        self.select(self.document.addObject("App::FeaturePython", "Nothing"))
        FreeCADGui.runCommand("Trabecula_AnalyseNow")
        self.assertEqual((self.dialogs, is_busy()), ([], False))
        self.assertIn("select a network", COMMANDS["Trabecula_AnalyseNow"].reason())


class NumbersTest(AnalysisCase):
    def test_ticks_are_round_and_within_the_axis(self):
        for low, high in ((0.0, 1.0), (-3.7, 12.9), (1e-6, 3e-6), (99.0, 101.0)):
            steps = nice_steps(low, high)
            self.assertTrue(3 <= len(steps) <= 12, steps)
            self.assertGreaterEqual(min(steps), low - 1e-9 * abs(high))
            self.assertLessEqual(max(steps), high * (1 + 1e-9))
            self.assertLess(np.ptp(np.diff(steps)), 1e-9 * (high - low))

    def test_a_plane_across_an_oblique_axis_lies_at_its_height(self):
        box = np.array([[0.0, 0, 0], [2, 3, 4]])
        corners = plane_corners("0.6,0.8,0", 1.5, box)
        self.assertTrue(np.allclose(corners @ (0.6, 0.8, 0), 1.5))

    def test_the_heat_map_counts_every_outer_contour_once(self):
        obj = make.make_analysis(self.document, self.torus(), COARSE)
        analysis = make.analysis_of(obj)
        counts = diagram_of(analysis, "heat", "x").counts.counts
        self.assertEqual(int(counts.sum()), int((analysis.measures["x"].area > 0).sum()))
