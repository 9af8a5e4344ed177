# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voxel designs in the window: panel, work elsewhere, layers side by side, shapes of layers, files."""

import os
import tempfile
import time
from pathlib import Path
from unittest.mock import patch

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin
from PySide import QtGui
from window import Heartbeat, WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.colours import scale_colours
from freecad_trabecula.core.stl import read_stl
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.registry import find_strategy, strategy_names
from freecad_trabecula.errors import ExportError, ParameterError
from freecad_trabecula.features import results
from freecad_trabecula.features.relations import type_of
from freecad_trabecula.gui import colouring, panels, view_providers
from freecad_trabecula.gui.background import is_busy
from freecad_trabecula.gui.layer_dialog import LayerDialog, make_shapes
from freecad_trabecula.gui.merged_blocks import MODE
from freecad_trabecula.gui.preferences import preferred_colour
from freecad_trabecula.gui.voxel_dock import KIND, show_layers, voxel_dock
from freecad_trabecula.gui.voxel_export import VoxelExportDialog, write_images, write_voxels
from freecad_trabecula.gui.voxel_layers import DESIGN, KINDS

HALF = VoxelParameters(size=(0.5, 0.5, 0.5))


def million_voxels(folder):
    """Write a sample of 100^3 voxels at random, smooth over four, into a folder; return its path."""
    noise = Stream(1, "sample").uniform(100**3).reshape(100, 100, 100)
    blurred = sum(np.roll(noise, (i, j, k), (0, 1, 2)) for i in range(4) for j in range(4) for k in range(4))
    path = os.path.join(folder, "sample.npy")
    np.save(path, blurred > np.quantile(blurred, 0.7))
    return path


class VoxelCase(WindowTest):
    def setUp(self):
        super().setUp()
        results.clear()

    def tearDown(self):
        voxel_dock().hide()
        super().tearDown()

    def bracket(self):
        """A box of 4 mm less one of 2 x 2 x 4 mm: 48 mm3, layers along Z of 12 mm2."""
        bracket = self.document.addObject("Part::Feature", "Bracket")
        whole, less = make.make_box(self.document, 4, 4, 4), make.make_box(self.document, 2, 2, 4)
        bracket.Shape = whole.Shape.cut(less.Shape)
        return bracket

    def designs(self):
        return [obj for obj in self.document.Objects if type_of(obj) == KIND]

    def reopen(self):
        """Save the document, close it, forget all results and open the file."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            results.clear()
            self.document = FreeCAD.openDocument(path)

    def open_panel(self, obj=None):
        FreeCADGui.Selection.clearSelection()
        if obj is not None:
            FreeCADGui.Selection.addSelection(self.document.Name, obj.Name)
        FreeCADGui.runCommand("Trabecula_Voxels")
        panel = panels.current()
        panel.fields.edges[0].set_value(0.5)
        return panel

    def work(self, panel):
        panel.work()
        self.assertTrue(wait(lambda: panel._work is None, 180), self.dialogs)
        settle(0.3)


class PanelTest(VoxelCase):
    def test_voxels_are_designed_in_one_step_and_their_layers_open(self):
        bracket = self.bracket()
        panel = self.open_panel(bracket)
        self.assertIn("8 x 8 x 8 layers, 512 cells", panel.message.text())
        with Heartbeat() as beat:
            self.work(panel)
        self.assertLess(beat.busiest, 0.5)
        self.assertEqual(self.dialogs, [])
        (obj,) = self.designs()
        self.assertTrue(obj.Exact and obj.Watertight)
        self.assertEqual((obj.Voxels, obj.Components), (384, 1))
        self.assertEqual((bracket.Visibility, obj.ViewObject.isVisible()), (False, True))
        self.assertEqual(self.document.UndoNames[0], "Design voxels")
        self.assertTrue(voxel_dock().isVisible())
        panel.reject()
        self.document.undo()
        self.assertEqual((self.designs(), bracket.Visibility), ([], True))

    def test_the_window_answers_while_a_million_voxels_are_designed_and_shown(self):
        with tempfile.TemporaryDirectory() as folder:
            panel = self.open_panel()
            panel.fields.source.set_file(million_voxels(folder))
            panel.fields.edges[0].set_value(0.1)
            panel.fields.strategy.setCurrentText("minimum-zeros")
            with Heartbeat() as beat:
                self.work(panel)
                (obj,) = self.designs()
                self.assertTrue(wait(lambda: obj.ViewObject.Proxy.blocks.is_whole, 60))
        self.assertTrue(obj.Exact)
        self.assertEqual(self.dialogs, [])
        self.assertLess(beat.busiest, 0.6, beat.longest)  # FreeCAD takes and draws the mesh in one go

    def test_the_same_panel_changes_the_design_that_it_made(self):
        panel = self.open_panel(self.bracket())
        self.work(panel)
        self.assertFalse(panel.fields.source.isEnabled())
        panel.fields.edges[0].set_value(1.0)
        panel.fields.strategy.setCurrentText("minimum-zeros")
        self.work(panel)
        (obj,) = self.designs()
        self.assertEqual((obj.Voxels, make.voxel_design_of(obj).parameters.strategy), (48, "minimum-zeros"))

    def test_a_double_click_opens_the_panel_with_the_values(self):
        chosen = VoxelParameters(size=(0.5, 0.5, 1.0), strategy="sequential", seed=7, cap_alpha=8, direction="rows")
        obj = make.make_voxel_design(self.document, self.bracket(), chosen, surface="smooth")
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        self.assertTrue(wait(FreeCADGui.Control.activeDialog, 10))
        fields = panels.current().fields
        self.assertEqual((fields.value(), fields.surface.value()), (chosen, "smooth"))
        self.assertFalse(fields.is_cube.isChecked())

    def test_cancel_answers_at_once_and_changes_nothing(self):
        panel = self.open_panel(self.bracket())
        panel.fields.edges[0].set_value(0.025)
        panel.work()
        settle(2.0)
        started = time.monotonic()
        panel.cancel()
        self.assertLess(time.monotonic() - started, 1.0)
        settle(2.0)
        self.assertEqual((self.designs(), self.document.UndoNames[:1], self.dialogs), ([], [], []))

    def test_what_is_too_large_or_too_coarse_is_refused_at_once(self):
        panel = self.open_panel(self.bracket())
        for edge, words in (
            (0.001, "would take about"),
            (5.0, "must not be larger than the sample"),
            (0.0, "at least"),
        ):
            panel.fields.edges[0].set_value(edge)
            self.assertIn(words, panel.message.text())
            self.assertFalse(panel.build_bar.build_button.isEnabled())
        panel.accept()
        self.assertEqual((len(self.dialogs), self.designs()), (1, []))
        panel.fields.edges[0].set_value(0.5)
        self.assertTrue(panel.build_bar.build_button.isEnabled())

    def test_a_sample_of_which_there_is_no_design_is_told_and_nothing_is_made(self):
        panel = self.open_panel(make.make_box(self.document, 4, 4, 4))
        self.work(panel)
        self.assertEqual((len(self.dialogs), self.designs()), (1, []))
        self.assertIn("must have voids", self.dialogs[0])

    def test_without_a_sample_the_panel_asks_for_one(self):
        panel = self.open_panel()
        self.assertIn("choose an object or a file", panel.message.text())
        panel.accept()
        self.assertEqual(len(self.dialogs), 1)

    def test_every_strategy_shows_its_own_choices_and_what_it_does(self):
        fields = self.open_panel(self.bracket()).fields
        for number, name in enumerate(strategy_names()):
            fields.strategy.setCurrentIndex(number)
            module = find_strategy(name)
            self.assertEqual(fields.strategy.toolTip(), module.SUMMARY)
            shown = {one for one, field in fields.options.fields.items() if not field.widget.isHidden()}
            self.assertEqual(shown, set(module.OPTIONS) - {"boundary"})
            self.assertEqual(fields.envelope.isEnabled(), "boundary" in module.OPTIONS)

    def test_an_analysis_gives_its_own_voxel_size(self):
        analysis = make.make_analysis(self.document, self.bracket(), SliceParameters(thickness=0.4))
        FreeCADGui.Selection.addSelection(self.document.Name, analysis.Name)
        FreeCADGui.runCommand("Trabecula_Voxels")
        panel = panels.current()
        self.assertEqual(panel.fields.value().size, (0.4, 0.4, 0.4))
        self.assertIn("10 x 10 x 10", panel.message.text())
        panel.fields.edges[0].set_value(0.5)
        self.assertIn("slice it again", panel.message.text())

    def test_a_file_is_a_sample_and_what_the_panel_does_can_be_run_as_a_macro(self):
        from freecad_trabecula.gui import document_work

        lines, record = [], document_work.record
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "sample.npy")
            array = np.zeros((4, 4, 4), bool)
            array[:, :, 1:3] = True
            np.save(path, array)
            document_work.record = lambda text: (lines.append(text), record(text))
            try:
                panel = self.open_panel()
                panel.fields.source.set_file(path)
                self.work(panel)
            finally:
                document_work.record = record
            exec("\n".join(lines), {})  # noqa: S102
        first, second = self.designs()
        self.assertEqual((first.Voxels, first.ResultKey), (32, second.ResultKey))


class LookTest(VoxelCase):
    def test_the_three_sides_of_blocks_are_told_apart_from_aslant(self):
        make.make_voxel_design(self.document, self.bracket(), HALF)
        view = FreeCADGui.activeDocument().activeView()
        view.viewIsometric()
        view.fitAll()
        settle(0.5)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "view.png")
            view.saveImage(path, 200, 200, "White")
            image = QtGui.QImage(path)
        counts = {}
        for x in range(200):
            for y in range(200):
                colour = QtGui.QColor(image.pixel(x, y))
                if colour.lightness() < 250:
                    counts[colour.lightness() // 4] = counts.get(colour.lightness() // 4, 0) + 1
        self.assertGreaterEqual(sum(count > 1000 for count in counts.values()), 3)


class MergedBlocksTest(VoxelCase):
    def design(self, surface="blocks"):
        """About 37,000 voxels at random, whose faces are more than are drawn at once while the camera moves."""
        thirds, rising = ((0.5, 0.3),), ((0.0, 0.15), (1.0, 0.45))
        chosen = VoxelParameters(size=(0.1, 0.1, 0.1), strategy="random-layers")
        curves = DrawnCurves((5.0, 5.0, 5.0), thirds, thirds, rising)
        obj = make.make_voxel_design(self.document, curves, chosen, surface=surface)
        view = FreeCADGui.activeDocument().activeView()
        view.viewIsometric()
        view.fitAll()
        if surface == "blocks":
            self.assertTrue(wait(lambda: obj.ViewObject.Proxy.blocks.is_whole, 30))
        settle(1.0)
        return obj, view

    def test_a_sample_of_the_blocks_is_seen_until_all_have_been_computed(self):
        thirds = ((0.5, 0.3),)
        chosen = VoxelParameters(size=(0.1, 0.1, 0.1), strategy="random-layers")
        obj = make.make_voxel_design(self.document, DrawnCurves((5.0, 5.0, 5.0), thirds, thirds, thirds), chosen)
        blocks = obj.ViewObject.Proxy.blocks
        self.assertFalse(blocks.is_whole)
        few = sum(len(one.numVertices) for one in _shapes_of(blocks.fine))
        self.assertGreater(few, 6)
        self.assertEqual(blocks.coarse.getNumChildren(), 0)
        self.assertTrue(wait(lambda: blocks.is_whole, 30))
        self.assertGreater(sum(len(one.numVertices) for one in _shapes_of(blocks.fine)), few)
        self.assertEqual(blocks.coarse.getNumChildren(), 6)

    def test_a_design_that_is_closed_while_its_blocks_are_computed_leaves_no_trace(self):
        thirds = ((0.5, 0.3),)
        chosen = VoxelParameters(size=(0.1, 0.1, 0.1), strategy="random-layers")
        make.make_voxel_design(self.document, DrawnCurves((5.0, 5.0, 5.0), thirds, thirds, thirds), chosen)
        FreeCAD.closeDocument(self.document.Name)
        settle(2.0)  # a traceback in the log would fail the file
        self.document = FreeCAD.newDocument("Next")

    def test_many_blocks_are_drawn_merged_and_coarser_while_the_camera_moves(self):
        obj, view = self.design()
        self.assertEqual(obj.ViewObject.DisplayMode, MODE)
        blocks = obj.ViewObject.Proxy.blocks
        self.assertTrue(wait(lambda: blocks.fine.getNumChildren() == 6, 20))
        self.assertTrue(wait(lambda: blocks.switch.whichChild.getValue() == 0, 10))
        view.viewFront()
        view.redraw()
        self.assertTrue(wait(lambda: blocks.switch.whichChild.getValue() == 1, 10))
        self.assertTrue(wait(lambda: blocks.switch.whichChild.getValue() == 0, 10))
        counts = [sum(len(one.numVertices) for one in _shapes_of(part)) for part in (blocks.coarse, blocks.fine)]
        self.assertLess(counts[0], 30_001)
        self.assertGreater(counts[1], counts[0])
        self.assertLess(2 * counts[1], obj.Mesh.CountFacets)

    def test_merged_blocks_look_like_their_mesh(self):
        obj, view = self.design()
        images = {}
        for mode in (MODE, "Shaded"):
            obj.ViewObject.DisplayMode = mode
            settle(1.0)
            picture = _picture(view)
            images[mode] = (picture.max(2) + picture.min(2)) / 2  # lightness
        difference = np.abs(images[MODE] - images["Shaded"])
        self.assertGreater(images["Shaded"].std(), 10)
        self.assertLess(difference.mean(), 6)

    def test_a_large_mesh_is_not_counted_for_the_property_editor(self):
        few = make.make_voxel_design(self.document, self.bracket(), HALF)
        self.assertEqual(few.getEditorMode("Mesh"), [])
        with patch.object(view_providers, "MOST_COUNTED", few.Mesh.CountFacets - 1):
            many = make.make_voxel_design(self.document, self.bracket(), HALF)
        self.assertEqual(many.getEditorMode("Mesh"), ["Hidden"])
        make.change_voxel_design(many, VoxelParameters(size=(1.0, 1.0, 1.0)))
        self.assertEqual(many.getEditorMode("Mesh"), [])

    def colour(self, obj, by):
        """Choose what the colours mean; wait until they are seen, or for plain ones for a moment."""
        obj.ViewObject.ColourBy = by
        legends = lambda: colouring.legends_of(self.document.Name)  # noqa: E731
        self.assertTrue(wait(lambda: bool(legends()) == (by != "plain"), 60), by)
        settle(0.5)

    def test_layers_of_merged_blocks_have_their_colours_and_plain_ones_come_back_at_once(self):
        obj, _ = self.design()
        blocks, z = obj.ViewObject.Proxy.blocks, 2
        plain = _shapes_of(blocks.fine)
        with Heartbeat() as beat:
            self.colour(obj, "porosity along z")
        self.assertLess(beat.busiest, 0.5)
        self.assertEqual(obj.ViewObject.DisplayMode, MODE)
        design = make.voxel_design_of(obj)
        porosity = 100 * (1 - design.voxels.mean((1, 2)))
        shares = (porosity - porosity.min()) / (porosity.max() - porosity.min())
        seen = set()
        for one in _shapes_of(blocks.fine):
            colour, _, shape = _shapes_of(one)
            corners = np.array([point.getValue() for point in shape.vertexProperty.getValue().vertex.getValues()])
            colours = np.array([each.getValue() for each in colour.rgb.getValues()])
            self.assertEqual(len(colours), len(corners))
            places = corners[:, z].reshape(-1, 4) / design.targets.voxel[z]
            normal = shape.vertexProperty.getValue().normal[0].getValue()[z]
            layers = np.floor((places.min(1) + places.max(1)) / 2 - 0.5 * normal + 1e-3).astype(int)
            self.assertLess((places.max(1) - places.min(1)).max(), 1.001)  # no face reaches over two layers
            wanted = np.repeat(scale_colours(shares[layers]), 4, 0) / 255
            self.assertLess(abs(colours - wanted).max(), 1e-5)
            seen |= set(layers.tolist())
        self.assertEqual(seen, set(range(50)))
        obj.ViewObject.ColourBy = "plain"
        settle(0.2)
        self.assertEqual([one.this for one in _shapes_of(blocks.fine)], [one.this for one in plain])
        self.assertTrue(blocks.is_whole)

    def test_coloured_blocks_look_like_their_coloured_mesh_and_are_seen_so_in_an_opened_file(self):
        obj, view = self.design()
        self.colour(obj, "porosity along z")
        images = {MODE: _picture(view)}
        obj.ViewObject.DisplayMode = "Shaded"
        _, binding = colouring._looks_of_triangles(obj.ViewObject)
        self.assertTrue(wait(lambda: binding.value.getValue() == coin.SoMaterialBinding.PER_FACE, 60))
        settle(0.5)
        images["Shaded"] = _picture(view)
        obj.ViewObject.DisplayMode = MODE
        self.colour(obj, "porosity along z")
        self.reopen()
        (again,) = self.designs()
        self.assertTrue(wait(lambda: colouring.legends_of(self.document.Name), 60))
        settle(1.0)
        self.assertEqual(again.ViewObject.DisplayMode, MODE)
        images["opened"] = _picture(FreeCADGui.activeDocument().activeView())
        for name in ("Shaded", "opened"):
            self.assertLess(np.abs(images[MODE] - images[name]).mean(), 6, name)
        hues = images[MODE].max(2) - images[MODE].min(2)
        self.assertGreater((hues > 40).sum(), 500)  # not the colour of bone, and not white

    def test_a_smooth_surface_and_few_blocks_stay_as_they_are(self):
        obj, _ = self.design("smooth")
        self.assertEqual(obj.ViewObject.DisplayMode, "Shaded")
        few = make.make_voxel_design(self.document, self.bracket(), HALF)
        self.assertEqual(few.ViewObject.DisplayMode, "Shaded")


def _picture(view, edge=120):
    """Return the view as red, green and blue (edge, edge, 3)."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "view.png")
        view.saveImage(path, edge, edge, "White")
        image = QtGui.QImage(path)
    return np.array([[image.pixelColor(x, y).getRgb()[:3] for x in range(edge)] for y in range(edge)], float)


def _shapes_of(node):
    return [node.getChild(k) for k in range(node.getNumChildren())]


class DockTest(VoxelCase):
    def setUp(self):
        super().setUp()
        self.obj = make.make_voxel_design(self.document, self.bracket(), HALF)
        self.dock = show_layers(self.obj)
        settle(0.4)

    def test_layers_of_both_stand_side_by_side_with_their_counts(self):
        design = make.voxel_design_of(self.obj)
        for axis, shape in enumerate(((8, 8), (8, 8), (8, 8))):
            self.dock.take_axis(axis)
            self.dock.slider.setValue(1)
            image = self.dock.design.image
            self.assertEqual((image.height(), image.width()), shape)
            asked = (32, 32, 48)[axis]  # by hand: 8 or 12 mm2 of 0.25 mm2
            self.assertIn(f"{asked} made, {asked} asked for", self.dock.design.words)
            self.assertIn(f"{asked} asked for", self.dock.sample.words)
            solid = QtGui.QColor(preferred_colour(DESIGN)).rgb()
            seen = [[image.pixel(x, 7 - y) == solid for x in range(8)] for y in range(8)]
            self.assertTrue((np.array(seen) == np.take(design.voxels, 1, 2 - axis)).all())

    def test_diagrams_show_target_and_design_and_move_the_layer(self):
        for number, (kind, _) in enumerate(KINDS):
            self.dock.tabs.setCurrentIndex(number)
            chart = self.dock.charts[kind]
            self.assertEqual(bool(chart.diagram.curves), kind != "trabeculae")
            self.assertTrue(wait(lambda chart=chart: chart.diagram.curves, 30), kind)  # trabeculae are counted aside
            curves = chart.diagram.curves
            self.assertEqual(len(curves), 2, kind)
            self.assertTrue(np.allclose(curves[0].y, curves[1].y), kind)  # exact; a bracket has one design only
        self.dock.charts["voxels"].pointed.emit(3.6)
        self.assertEqual((self.dock.layer, self.dock.slider.value(), self.dock.number.value()), (7, 7, 7))
        node = self.dock._slice_plane._corners.point
        self.assertAlmostEqual(node[0].getValue()[2], 3.75, 5)

    def test_the_sample_of_an_opened_file_is_worked_out_elsewhere(self):
        self.reopen()
        settle(0.5)
        self.dock.show_objects()
        self.assertIsNotNone(self.dock.design.image)
        self.assertIn("being worked out", self.dock.sample.words)
        self.assertTrue(wait(lambda: self.dock.sample.image is not None, 120))

    def test_a_million_voxels_are_turned_over_without_waiting(self):
        with tempfile.TemporaryDirectory() as folder:
            path = million_voxels(folder)
            parameters = VoxelParameters(size=(0.1, 0.1, 0.1), strategy="minimum-zeros")
            obj = make.make_voxel_design(self.document, path, parameters)
        self.dock.show_objects(obj)
        self.assertTrue(wait(lambda: obj.ViewObject.Proxy.blocks.is_whole, 30))
        obj.ViewObject.Visibility = False  # what the 3D view takes without a graphics card is not measured
        settle(0.5)
        with Heartbeat() as beat:
            for axis in range(3):
                self.dock.take_axis(axis)
                for layer in range(0, 100, 9):
                    self.dock.slider.setValue(layer)
                    settle(0.02)
        self.assertLess(beat.busiest, 0.1)

    def test_undo_and_closing_empty_it(self):
        self.document.removeObject(self.obj.Name)
        settle(0.4)
        self.assertIsNone(self.dock.layers)
        self.assertIn("Design voxels", self.dock.design.words)
        FreeCAD.closeDocument(self.document.Name)
        settle(0.4)
        self.assertIsNone(self.dock._slice_plane)
        self.document = FreeCAD.newDocument("Next")

    def test_one_click_slices_the_design_layer_by_layer(self):
        FreeCADGui.Selection.addSelection(self.document.Name, self.obj.Name)
        FreeCADGui.runCommand("Trabecula_AnalyseNow")
        self.assertTrue(wait(lambda: not is_busy(), 180), self.dialogs)
        settle(0.3)
        from freecad_trabecula.gui.analysis_dock import dock_of_window

        dock_of_window().hide()
        (analysis,) = (obj for obj in self.document.Objects if type_of(obj) == "Trabecula::Analysis")
        targets, profiles = make.voxel_design_of(self.obj).targets, make.analysis_of(analysis).profiles
        for axis, counts in zip("xyz", targets.counts):
            self.assertTrue(np.allclose(profiles[axis].sliced_area, 0.25 * counts, atol=1e-5))


class ShapesTest(VoxelCase):
    def setUp(self):
        super().setUp()
        self.obj = make.make_voxel_design(self.document, self.bracket(), HALF)

    def test_the_estimate_stands_there_before_and_the_shape_is_one_step(self):
        dialog = LayerDialog(FreeCADGui.getMainWindow(), self.obj)
        dialog.first.setValue(0)
        dialog.last.setValue(7)
        self.assertIn("48 corners", dialog.estimate.text())  # an L has six corners
        dialog.kind.setCurrentIndex(1)
        found = make_shapes(self.obj, *dialog.chosen())
        self.assertAlmostEqual(found.Shape.Volume, 48, 6)
        self.assertEqual(self.document.UndoNames[0], "Layer shapes")

    def test_a_last_layer_below_the_first_is_refused(self):
        dialog = LayerDialog(FreeCADGui.getMainWindow(), self.obj)
        dialog.first.setValue(5)
        dialog.last.setValue(4)
        self.assertIn("must not lie below the first", dialog.estimate.text())
        with self.assertRaises(ParameterError):
            dialog.work()


class ExportTest(VoxelCase):
    def setUp(self):
        super().setUp()
        self.obj = make.make_voxel_design(self.document, self.bracket(), HALF)

    def test_every_format_has_a_size_and_files_hold_the_voxels(self):
        dialog = VoxelExportDialog(FreeCADGui.getMainWindow(), [self.obj])
        voxels = make.voxel_design_of(self.obj).voxels
        self.assertEqual(dialog.format.count(), 10)
        with tempfile.TemporaryDirectory() as folder:
            for kind in ("stl", "3mf", "obj", "npy", "nrrd", "vti"):
                path = os.path.join(folder, f"design.{kind}")
                write_voxels(self.obj, path)
                size = dialog.size_of(self.obj, kind)
                self.assertLess(abs(size - os.path.getsize(path)), max(0.25 * size, 400), kind)
            self.assertTrue((np.load(os.path.join(folder, "design.npy")) == voxels).all())
            corners = read_stl(os.path.join(folder, "design.stl")).vertices
            self.assertTrue(np.allclose(np.ptp(corners, axis=0), 4, atol=1e-4))

    def test_images_go_into_a_new_folder_or_nowhere(self):
        with tempfile.TemporaryDirectory() as folder:
            images = sorted(Path(write_images(self.obj, "png", folder)).iterdir())
            self.assertEqual(len(images), 8)
            image = QtGui.QImage(str(images[0]))
            white = sum(QtGui.QColor(image.pixel(x, y)).lightness() > 200 for x in range(8) for y in range(8))
            self.assertEqual(white, 48)
            with self.assertRaisesRegex(ExportError, "need a new folder"):
                write_images(self.obj, "png", folder)
            with self.assertRaisesRegex(ExportError, "could not be written"):
                write_images(self.obj, "png", os.path.join(folder, "nowhere"))
            self.assertEqual(len(os.listdir(folder)), 1)
