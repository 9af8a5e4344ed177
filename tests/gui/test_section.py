# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section plane: where it cuts, what fills the cut, and that nothing is left of it."""

import tempfile
from pathlib import Path

import FreeCAD
import FreeCADGui
import numpy as np
import Part
from pivy import coin
from PySide import QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.analysis.cross_section import Sections
from freecad_trabecula.core.colours import BLUE, VERMILION
from freecad_trabecula.core.presets import preset
from freecad_trabecula.gui import colouring
from freecad_trabecula.gui.section import Picture
from freecad_trabecula.gui.section_dock import section_dock


class PictureTest(WindowTest):
    def test_material_is_painted_and_voids_are_clear(self):
        import MeshPart

        tube = Part.makeCylinder(2, 4).cut(Part.makeCylinder(1, 4))
        mesh = MeshPart.meshFromShape(Shape=tube, LinearDeflection=0.01)
        triangles = np.array([facet.Points for facet in mesh.Facets])
        contours = Sections(triangles, "z").at(1.0)
        picture = Picture(np.array([-2.0, -2.0]), np.array([2.0, 2.0]))
        picture.paint(contours, [(np.ones(len(contours.plane), bool), (1.0, 0.0, 0.0))])
        self.assertEqual(picture.colour_at(1.5, 0.0), (255, 0, 0, 255))
        self.assertEqual(picture.colour_at(0.0, 0.5)[3], 0)
        self.assertEqual(picture.colour_at(1.9, 1.9)[3], 0)


class SectionTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.plate = self.document.addObject("Part::Feature", "Plate")
        self.plate.Shape = Part.makeBox(10, 2, 10)
        self.rod = self.document.addObject("Part::Feature", "Rod")
        self.rod.Shape = Part.makeBox(2, 2, 10, FreeCAD.Vector(0, 6, 0))
        self.scene = FreeCADGui.activeDocument().activeView().getSceneGraph()
        self.before = self.scene.getNumChildren()
        FreeCADGui.activeDocument().activeView().fitAll()
        FreeCADGui.runCommand("Trabecula_Section")
        self.dock = section_dock()
        self.dock.take_axis("z")
        self.assertTrue(wait(lambda: len(self.dock.section._bodies) == 2, 20))

    def tearDown(self):
        self.dock.hide()
        self.dock.fill.set_value("plain")
        self.dock.other_side.setChecked(False)
        self.dock.axes["z"].setChecked(True)
        super().tearDown()

    def kept(self, *point):
        """Return whether a point is drawn."""
        return self.dock.section._clip.plane.getValue().isInHalfSpace(coin.SbVec3f(*(float(one) for one in point)))

    def test_it_begins_in_the_middle_and_follows_axis_height_and_side(self):
        self.assertEqual(self.dock.height_field.value(), 5.0)
        self.assertEqual([self.kept(1, 1, z) for z in (4.9, 5.1)], [True, False])
        self.dock.place(8.0)
        self.assertEqual([self.kept(1, 1, z) for z in (7.9, 8.1)], [True, False])
        self.dock.other_side.setChecked(True)
        self.assertEqual([self.kept(1, 1, z) for z in (7.9, 8.1)], [False, True])
        self.dock.take_axis("y")
        self.assertEqual(self.dock.height_field.value(), 4.0)
        self.assertEqual([self.kept(1, y, 1) for y in (3.9, 4.1)], [False, True])

    def test_as_seen_it_lies_across_the_view_and_what_is_nearer_is_not_drawn(self):
        view = FreeCADGui.activeDocument().activeView()
        view.viewIsometric()
        self.dock.take_axis("free")
        direction = view.getViewDirection()
        middle = FreeCAD.Vector(5, 4, 5)
        self.assertFalse(self.kept(*(middle - direction)))
        self.assertTrue(self.kept(*(middle + direction)))

    def test_the_cut_is_filled_with_rods_and_plates_and_the_legend_counts_them(self):
        """Seen along y the plate is a square: a rod; across z both: a bar of 10 x 2 fills its box as well."""
        self.dock.fill.set_value("rods and plates")
        (legend,) = colouring.legends_of(self.document.Name)
        self.assertEqual([(one.name, one.colour, one.count) for one in legend.legend.entries],
                         [("rods", BLUE, 2), ("plates", VERMILION, 0)])  # fmt: skip
        self.dock.fill.set_value("none")
        self.assertEqual(colouring.legends_of(self.document.Name), ())

    def test_the_view_shows_the_cut_where_the_body_was(self):
        view = FreeCADGui.activeDocument().activeView()
        view.viewTop()
        view.fitAll()
        self.dock.fill.set_value("rods and plates")
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "cut.png")
            view.saveImage(path, 600, 600, "White")
            image = QtGui.QImage(path)
        seen = [image.pixelColor(x, y).getRgb()[:3] for x in range(0, 600, 4) for y in range(0, 440, 4)]
        blue = int((abs(np.array(seen) - BLUE).max(1) < 20).sum())
        self.assertGreater(blue, 500)

    def test_what_is_hidden_or_clear_is_not_cut(self):
        self.rod.ViewObject.Visibility = False
        self.assertTrue(wait(lambda: len(self.dock.section._bodies) == 1, 10))
        self.rod.ViewObject.Visibility = True
        self.assertTrue(wait(lambda: len(self.dock.section._bodies) == 2, 10))
        self.rod.ViewObject.Transparency = 80
        self.assertTrue(wait(lambda: len(self.dock.section._bodies) == 1, 10))

    def test_a_network_that_is_made_meanwhile_has_colours_of_its_faces(self):
        network = make.make_network(make.make_design(self.document, preset("case1")).wireframe)
        network.ViewObject.ColourBy = "coupling"
        settle(0.5)
        self.assertGreater(len(network.ViewObject.DiffuseColor), 75)

    def test_nothing_is_left_of_it_and_the_document_does_not_change(self):
        self.dock.fill.set_value("rods and plates")
        names, modified = self.names(), FreeCADGui.activeDocument().Modified
        FreeCADGui.runCommand("Trabecula_Section")
        settle(0.2)
        self.assertEqual(self.scene.getNumChildren(), self.before)
        self.assertEqual(colouring.legends_of(self.document.Name), ())
        self.assertEqual((self.names(), FreeCADGui.activeDocument().Modified), (names, modified))
        self.assertEqual(self.document.UndoNames, [])

    def test_it_goes_with_its_document(self):
        FreeCAD.closeDocument(self.document.Name)
        settle(0.2)
        self.assertFalse(self.dock.isVisible())
        self.assertIsNone(self.dock.section)
        self.document = FreeCAD.newDocument("Next")
