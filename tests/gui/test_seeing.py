# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen: colours with a meaning and their legend, saved and given back; ways to look through; all undone."""

import re
import tempfile
from pathlib import Path
from unittest.mock import patch

import FreeCAD
import FreeCADGui
import Mesh
import numpy as np
import Part
from pivy import coin
from PySide import QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core import recovery
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.colours import SCALE
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rod_colours import rod_colouring
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.features import results
from freecad_trabecula.gui import colouring, commands


def node_of(root, kind):
    """Return the first node of a kind below a node, found by hand: children of groups, one by one."""
    if root.isOfType(kind.getClassTypeId()):
        return root
    if root.isOfType(coin.SoGroup.getClassTypeId()):
        for k in range(root.getNumChildren()):
            found = node_of(root.getChild(k), kind)
            if found is not None:
                return found
    return None


def shown_material(view):
    """Return the material of the display mode that a view shows, not of one that is switched off."""
    modes = node_of(view.RootNode, coin.SoSwitch)
    return node_of(modes.getChild(modes.whichChild.getValue()), coin.SoMaterial)


class ColourTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.wireframe_object = make.make_design(self.document, preset("case6")).wireframe
        self.network = make.make_network(self.wireframe_object)

    def colours(self):
        return np.array([row[:3] for row in self.network.ViewObject.DiffuseColor])

    def pixels_in_the_corner(self, view, colour):
        """Return how many pixels of the lower left quarter of the view have nearly a colour."""
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "view.png")
            view.saveImage(path, 800, 600, "White")
            image = QtGui.QImage(path)
        seen = [image.pixelColor(x, y).getRgb()[:3] for x in range(400) for y in range(300, 600)]
        return int((abs(np.array(seen) - colour).max(1) < 12).sum())

    def run_command(self, name):
        FreeCADGui.runCommand(name)
        settle(0.1)

    def test_each_rod_has_the_colour_of_its_coupling_and_plain_ones_come_back_by_undo_and_by_command(self):
        plain = self.colours()
        self.assertEqual(len(plain), 1)
        self.run_command("Trabecula_Colour_coupling")
        wanted = rod_colouring(make.wireframe_of(self.wireframe_object), "coupling")
        at = 0
        for solid, colour in zip(self.network.Shape.Solids, wanted.colours):
            for face in self.colours()[at : at + len(solid.Faces)]:
                self.assertLess(abs(face - colour / 255).max(), 3e-3)
            at += len(solid.Faces)
        self.assertEqual(len(self.colours()), at)
        self.assertEqual(self.document.UndoNames[0], "Colour by")
        legends = colouring.legends_of(self.document.Name)
        counts = [[(one.name, one.count) for one in legend.legend.entries] for legend in legends]
        self.assertIn([("Face1 - Face2", 49), ("Face3 - Face4", 49), ("Face5 - Face6", 49)], counts)
        self.document.undo()
        settle(0.1)
        self.assertEqual(self.network.ViewObject.ColourBy, "plain")
        self.assertEqual((len(self.colours()), colouring.legends_of(self.document.Name)), (1, ()))
        self.run_command("Trabecula_Colour_size")
        self.run_command("Trabecula_Colour_plain")
        self.assertLess(abs(self.colours() - plain).max(), 1e-6)
        self.assertEqual(self.dialogs, [])

    def test_rods_stay_solid_and_a_transparency_stays_what_it_was(self):
        for share in (0, 60):
            self.network.ViewObject.Transparency = share
            for by in ("size", "plain"):
                self.network.ViewObject.ColourBy = by
                settle(0.1)
                self.assertEqual(self.network.ViewObject.Transparency, share)

    def test_a_hidden_or_deleted_object_has_no_legend(self):
        self.wireframe_object.ViewObject.Visibility = False
        self.network.ViewObject.ColourBy = "recovery"
        settle(0.1)
        (legend,) = colouring.legends_of(self.document.Name)
        self.assertEqual([one.count for one in legend.legend.entries], [145, 2])  # make validate: 2 mended
        self.network.ViewObject.Visibility = False
        self.assertEqual(colouring.legends_of(self.document.Name), ())
        self.network.ViewObject.Visibility = True
        self.assertEqual(len(colouring.legends_of(self.document.Name)), 1)
        self.document.removeObject(self.network.Name)
        settle(0.1)
        self.assertEqual(colouring.legends_of(self.document.Name), ())

    def test_failed_rods_are_lines_that_are_hidden_with_their_object_and_with_other_colours(self):
        self.wireframe_object.ViewObject.Visibility = False
        self.network.ViewObject.Visibility = False
        mended = [one.rod for one in make.wireframe_of(self.wireframe_object).recoveries]
        results.clear()
        with patch.object(recovery, "REMEDIES", dict.fromkeys(recovery.FAULTS, ())):
            wireframe = make.make_design(self.document, preset("case6")).wireframe
        network = make.make_network(wireframe)
        wireframe.ViewObject.Visibility = False
        self.assertEqual(sorted(wireframe.Failed), sorted(mended))
        network.ViewObject.ColourBy = "recovery"
        settle(0.1)
        lines = colouring._lost[self.document.Name][network.Name]
        sites = make.wireframe_of(self.wireframe_object).sites
        ends = [re.fullmatch(r"(Face\d).(\d+).(\d+)-(Face\d).(\d+).(\d+)", name).groups() for name in wireframe.Failed]
        wanted = [
            [sites[face].points[(sites[face].index == [int(i), int(j)]).all(1)][0] for face, i, j in (e[:3], e[3:])]
            for e in ends
        ]
        drawn = np.array([point.getValue() for point in lines._ends.point.getValues()]).reshape(-1, 2, 3)
        self.assertLess(abs(drawn - wanted).max(), 1e-4)
        shown = lambda: lines.node.whichChild.getValue() == coin.SO_SWITCH_ALL  # noqa: E731
        self.assertTrue(shown())
        network.ViewObject.Visibility = False
        self.assertFalse(shown())
        network.ViewObject.Visibility = True
        self.assertTrue(shown())
        network.ViewObject.ColourBy = "size"
        settle(0.1)
        self.assertFalse(shown())
        self.document.removeObject(network.Name)
        self.assertEqual(colouring._lost[self.document.Name], {})

    def test_a_mesh_that_is_not_ours_is_coloured_by_its_slices_while_it_has_an_analysis(self):
        self.wireframe_object.ViewObject.Visibility = self.network.ViewObject.Visibility = False
        bone = self.document.addObject("Mesh::Feature", "Bone")
        bone.Mesh = Mesh.createCone(3, 1, 6, True, 0.5, 40)
        command = commands.COMMANDS["Trabecula_Colour_porosity_z"]
        self.assertIn("nothing that is seen", command.reason())
        analysis = make.make_analysis(self.document, bone, SliceParameters(thickness=0.5))
        self.assertEqual(command.reason(), "")
        self.run_command("Trabecula_Colour_porosity_z")
        material = shown_material(bone.ViewObject)
        seen = lambda: material.diffuseColor.getNum()  # noqa: E731
        self.assertEqual(seen(), bone.Mesh.CountFacets)
        (legend,) = colouring.legends_of(self.document.Name)
        porosity = 100 * make.analysis_of(analysis).profiles["z"].porosity
        self.assertAlmostEqual(legend.legend.high, porosity.max())
        self.assertEqual(legend.name, "Bone")
        make.change_analysis(analysis, SliceParameters(thickness=2.0))
        settle(0.2)
        (other,) = colouring.legends_of(self.document.Name)
        self.assertNotEqual(other.legend.high, legend.legend.high)
        bone.ViewObject.Visibility = False
        self.assertEqual(colouring.legends_of(self.document.Name), ())
        bone.ViewObject.Visibility = True
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "bone.FCStd")
            self.document.saveCopy(path)
            again = FreeCAD.openDocument(path)
            settle(0.5)
            self.assertEqual(again.Bone.ViewObject.ColourBy, "porosity along z")
            self.assertEqual(len(colouring.legends_of(again.Name)), 1)
            FreeCAD.closeDocument(again.Name)
        self.run_command("Trabecula_Colour_plain")
        self.assertEqual((seen(), colouring.legends_of(self.document.Name)), (1, ()))
        self.document.undo()
        settle(0.2)
        self.assertEqual((seen(), len(colouring.legends_of(self.document.Name))), (bone.Mesh.CountFacets, 1))
        self.document.undo()
        settle(0.2)
        self.assertEqual((seen(), colouring.legends_of(self.document.Name)), (1, ()))

    def test_the_legend_is_in_the_view_and_neither_picked_nor_boxed(self):
        view = FreeCADGui.activeDocument().activeView()
        scene = view.getSceneGraph()
        before = scene.getNumChildren()
        view.viewIsometric()
        view.fitAll()
        settle(0.3)
        height = view.getCameraNode().height.getValue()
        self.run_command("Trabecula_Colour_size")
        self.assertEqual(scene.getNumChildren(), before + 1)
        self.assertGreater(self.pixels_in_the_corner(view, SCALE[-1]), 30)
        view.fitAll()
        settle(0.3)
        self.assertAlmostEqual(view.getCameraNode().height.getValue() / height, 1.0, 3)
        self.run_command("Trabecula_Colour_plain")
        self.assertEqual(scene.getNumChildren(), before)

    def test_colours_follow_a_new_seed(self):
        self.network.ViewObject.ColourBy = "size"
        settle(0.1)
        self.wireframe_object.Seed = 9
        make.update(self.wireframe_object)
        make.update(self.network)
        settle(0.2)
        wanted = rod_colouring(make.wireframe_of(self.wireframe_object), "size")
        faces = [len(solid.Faces) for solid in self.network.Shape.Solids]
        self.assertLess(abs(self.colours() - np.repeat(wanted.colours, faces, 0) / 255).max(), 3e-3)

    def test_paths_are_coloured_and_pores_keep_their_colour(self):
        view = self.wireframe_object.ViewObject
        plain = view.LineColor[:3]
        view.ColourBy = "coupling"
        settle(0.1)
        lines = view.LineColorArray
        self.assertEqual(len(lines), len(self.wireframe_object.Shape.Edges))
        self.assertNotEqual(lines[0][:3], plain)
        self.assertEqual(lines[2 * self.wireframe_object.Rods][:3], plain)

    def test_what_is_chosen_is_saved_and_shown_again(self):
        self.wireframe_object.ViewObject.Visibility = False
        self.network.ViewObject.ColourBy = "coupling"
        settle(0.1)
        before = self.colours()
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "coloured.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
            settle(0.3)
            self.network = self.document.getObject("Network")
            self.assertEqual(self.network.ViewObject.ColourBy, "coupling")
            self.assertLess(abs(self.colours() - before).max(), 3e-3)
            self.assertEqual([one.legend.quantity for one in colouring.legends_of(self.document.Name)], ["coupling"])
            self.network.ViewObject.ColourBy = "plain"
            settle(0.1)
            self.assertEqual(len(self.colours()), 1)
            self.assertLess(abs(self.colours()[0] - (0.93, 0.85, 0.68)).max(), 3e-3)


class LayerColourTest(WindowTest):
    def setUp(self):
        super().setUp()
        body = self.document.addObject("Part::Feature", "Body")
        body.Shape = Part.makeBox(4, 4, 2).fuse(Part.makeBox(2, 4, 2, FreeCAD.Vector(0, 0, 2)))
        self.design = make.make_voxel_design(self.document, body, VoxelParameters(size=(0.5, 0.5, 0.5)))
        body.ViewObject.Visibility = False

    def test_triangles_have_the_colour_of_their_layer(self):
        """The lower half is full: porosity 0 %; the upper one half full: 50 %."""
        self.design.ViewObject.ColourBy = "porosity along z"
        settle(0.1)
        (legend,) = colouring.legends_of(self.document.Name)
        self.assertEqual(legend.legend[1:4], ("%", 0.0, 50.0))
        material = shown_material(self.design.ViewObject)
        self.assertEqual(material.diffuseColor.getNum(), self.design.Mesh.CountFacets)
        for facet in self.design.Mesh.Facets:
            middle = sum(point[2] for point in facet.Points) / 3 - 0.01 * facet.Normal.z
            colour = np.array(material.diffuseColor[facet.Index].getValue())
            self.assertLess(abs(colour - np.array(SCALE[0 if middle < 2 else 4]) / 255).max(), 3e-3)

    def test_plain_again_is_one_colour(self):
        for by in ("trabeculae along x", "plain"):
            self.design.ViewObject.ColourBy = by
            settle(0.1)
        material = shown_material(self.design.ViewObject)
        self.assertEqual(material.diffuseColor.getNum(), 1)
        colour = np.array(material.diffuseColor[0].getValue())
        self.assertLess(abs(colour - (0.93, 0.85, 0.68)).max(), 3e-3)

    def test_many_triangles_get_the_same_colours_piece_by_piece_while_the_window_answers(self):
        few, material = colouring.LEAST_FACETS, shown_material(self.design.ViewObject)
        self.design.ViewObject.ColourBy = "trabeculae along z"
        settle(0.1)
        wanted = [material.diffuseColor[k].getValue() for k in range(material.diffuseColor.getNum())]
        legends = colouring.legends_of(self.document.Name)
        self.design.ViewObject.ColourBy = "porosity along z"
        settle(0.1)
        try:
            colouring.LEAST_FACETS = 0
            self.design.ViewObject.ColourBy = "trabeculae along z"
            self.assertTrue(wait(lambda: colouring.legends_of(self.document.Name) == legends, 10))
            self.assertEqual([material.diffuseColor[k].getValue() for k in range(len(wanted))], wanted)
            self.design.ViewObject.ColourBy = "porosity along x"
            colouring.colour(self.design)  # on its way
            self.design.ViewObject.ColourBy = "plain"
            settle(1.0)
            self.assertEqual(material.diffuseColor.getNum(), 1)
            self.assertEqual(colouring.legends_of(self.document.Name), ())
        finally:
            colouring.LEAST_FACETS = few

    def test_a_scaffold_without_an_analysis_is_refused_and_with_one_coloured(self):
        design = make.make_design(self.document, preset("case1"))
        scaffold = make.make_scaffold(design.wireframe)
        FreeCADGui.Selection.addSelection(scaffold)
        FreeCADGui.runCommand("Trabecula_Colour_porosity_z")
        settle(0.1)
        self.assertIn("analyse it first", self.dialogs[0])
        self.assertEqual((scaffold.ViewObject.ColourBy, colouring.legends_of(self.document.Name)), ("plain", ()))
        make.make_analysis(self.document, scaffold)
        FreeCADGui.runCommand("Trabecula_Colour_porosity_z")
        self.assertTrue(wait(lambda: colouring.legends_of(self.document.Name), 20))  # many triangles come later
        self.assertEqual(len(self.dialogs), 1)
        (legend,) = colouring.legends_of(self.document.Name)
        self.assertEqual(legend.name, scaffold.Label)
        self.assertGreater(legend.legend.high, legend.legend.low)


class SightTest(WindowTest):
    def test_three_ways_to_look_through_each_one_step_to_undo(self):
        design = make.make_design(self.document, preset("case1"))
        network = make.make_network(design.wireframe)
        envelope = design.wireframe.Envelope.ViewObject
        design.wireframe.ViewObject.Visibility = False
        for sight, bodies, shown in (("solid", 0, False), ("glass", 0, True), ("xray", 70, True)):
            FreeCADGui.runCommand("Trabecula_Sight_" + sight)
            self.assertEqual((network.ViewObject.Transparency, envelope.Visibility), (bodies, shown), sight)
            self.assertGreaterEqual(envelope.Transparency, 85 if shown else 0)
            self.assertEqual(self.document.UndoNames[0], "Look through")
        self.document.undo()
        self.assertEqual((network.ViewObject.Transparency, envelope.Transparency), (0, 85))

    def test_of_two_designs_only_the_selected_one_changes(self):
        first, second = (make.make_network(make.make_design(self.document, preset("case1")).wireframe) for _ in "ab")
        FreeCADGui.Selection.addSelection(second)
        FreeCADGui.runCommand("Trabecula_Sight_xray")
        self.assertEqual((first.ViewObject.Transparency, second.ViewObject.Transparency), (0, 70))

    def test_without_anything_of_ours_they_are_greyed_out(self):
        for name in ("Trabecula_Colours", "Trabecula_Sight_glass"):
            self.assertEqual(commands.COMMANDS[name].reason(), "nothing has been designed or analysed yet")
        make.make_design(self.document, preset("case1"))
        self.assertEqual(commands.COMMANDS["Trabecula_Colour_size"].reason(), "")
        self.assertIn("can be coloured", commands.COMMANDS["Trabecula_Colour_trabeculae_x"].reason())
