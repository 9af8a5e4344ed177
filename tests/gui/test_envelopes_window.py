# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes in the window: bodies of the document, files, picked faces, and what must be refused."""

from dataclasses import replace

import FreeCAD
import FreeCADGui
import Mesh
import Part
from window import WindowTest, settle, wait

from freecad_trabecula.core.presets import preset
from freecad_trabecula.errors import EnvelopeError
from freecad_trabecula.features.bodies import is_solid
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.picking import FaceGate


class EnvelopeTest(WindowTest):
    def add(self, shape, name="Body"):
        obj = self.document.addObject("Part::Feature", name)
        obj.Shape = shape
        self.document.recompute()
        return obj

    def open_on(self, obj, faces):
        """Open the panel on faces of an object and wait until its envelope is checked."""
        panels.open_on_faces(self.document, obj, faces)
        panel = panels.current()
        self.assertTrue(wait(lambda: panel.body.is_ready or self.refused(panel), 30))
        return panel

    def refused(self, panel):
        return panel.outcome.message.text() if not panel.outcome.message.isHidden() else ""

    def test_faces_of_a_cylinder_are_coupled_and_previewed(self):
        panel = self.open_on(self.add(Part.makeCylinder(4, 8)), ["Face2", "Face3"])
        self.assertEqual([one.label for one in panel.fields.faces.value()], ["A", "B"])
        self.change(panel, panel.fields.couplings._add)
        self.assertEqual([(c.first, c.second) for c in panel.fields.couplings.value()], [("A", "B")])
        self.assertGreater(int(panel.outcome.headline.text().split("<b>")[1].split(" ")[0]), 4)

    def test_the_design_of_a_body_is_kept_on_that_body(self):
        body = self.add(Part.makeCylinder(4, 8))
        panel = self.open_on(body, ["Face2", "Face3"])
        self.change(panel, panel.fields.couplings._add)
        wait(lambda: panel._drawn is not None, 30)
        panel.accept()
        self.assertTrue(wait(lambda: not panel.is_open, 60))
        wireframe = self.wireframe()
        self.assertEqual(wireframe.Envelope, body)
        self.assertEqual([list(one.Face[1]) for one in wireframe.Sites], [["Face2"], ["Face3"]])
        self.assertEqual(self.document.UndoNames, ["Design rods"])

    def test_clicks_pick_faces_and_a_second_click_takes_one_away(self):
        body = self.add(Part.makeBox(10, 8, 6))
        panel = self.open_on(body, ["Face1"])
        panel.fields.faces.pick_button.setChecked(True)
        for face in ("Face2", "Face6", "Face2"):
            FreeCADGui.Selection.addSelection(self.document.Name, body.Name, face, 1, 2, 3)
            settle(0.1)
        self.assertEqual([one.face for one in panel.fields.faces.value()], ["Face1", "Face6"])

    def test_a_face_of_another_body_an_edge_and_a_whole_body_are_not_let_through(self):
        body, other = self.add(Part.makeBox(10, 8, 6)), self.add(Part.makeBox(1, 1, 1), "Other")
        gate = FaceGate(body)
        self.assertTrue(gate.allow(self.document, body, "Face3"))
        for obj, sub in ((other, "Face3"), (body, "Edge3"), (body, "")):
            self.assertFalse(gate.allow(self.document, obj, sub))
            self.assertIn("Body", gate.notAllowedReason)

    def test_the_gate_goes_with_the_panel(self):
        body, other = self.add(Part.makeBox(10, 8, 6)), self.add(Part.makeBox(1, 1, 1), "Other")
        for way_out in (lambda panel: panel.reject(), lambda panel: FreeCADGui.Control.closeDialog()):
            panel = self.open_on(body, ["Face1"])
            panel.fields.faces.pick_button.setChecked(True)
            way_out(panel)
            settle()
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(self.document.Name, other.Name, "Edge1")
            self.assertEqual(len(FreeCADGui.Selection.getSelectionEx(self.document.Name)), 1)
            self.assertFalse(panel.picker.active)

    def test_a_picked_point_becomes_the_origin_of_its_face(self):
        body = self.add(Part.makeBox(10, 8, 6))
        panel = self.open_on(body, ["Face6"])
        panel.fields.faces.origin_button.click()
        FreeCADGui.Selection.addSelection(self.document.Name, body.Name, "Face6", 2.0, 3.0, 6.0)
        settle(0.1)
        self.assertEqual(panel.fields.faces.value()[0].origin, (2.0, 3.0, 6.0))

    def test_two_solids_in_one_body_are_refused_with_their_number(self):
        both = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, FreeCAD.Vector(5, 0, 0))])
        panel = self.open_on(self.add(both), ["Face1"])
        self.assertTrue(wait(lambda: self.refused(panel), 30))
        self.assertIn("2", self.refused(panel))

    def test_a_shell_is_offered_no_design(self):
        self.assertFalse(is_solid(self.add(Part.makeBox(1, 1, 1).Shells[0])))

    def test_an_envelope_becomes_transparent_and_is_given_back_as_it_was(self):
        body = self.add(Part.makeBox(10, 8, 6))
        panel = self.open_on(body, ["Face1"])
        self.assertGreaterEqual(body.ViewObject.Transparency, 80)
        panel.reject()
        self.assertEqual(body.ViewObject.Transparency, 0)

    def test_a_box_of_the_document_gives_its_edges_which_stay_its_own(self):
        box = self.document.addObject("Part::Box", "Box")
        box.Length, box.Width, box.Height = 20, 12, 8
        self.document.recompute()
        panels.open_new(self.document, preset("case1"), box)
        panel = panels.current()
        self.wait_for_estimate(panel)
        prism = panel.fields.job().prism
        self.assertEqual((prism.l, prism.w, prism.h), (20.0, 12.0, 8.0))
        self.assertFalse(panel.fields.prism.fields["l"].widget.isEnabled())

    def test_an_envelope_that_is_changed_while_the_panel_is_open_is_followed(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        panels.open_new(self.document, preset("case1"), box)
        panel = panels.current()
        self.wait_for_estimate(panel)

        def longer():
            box.Length = 30
            self.document.recompute()

        self.change(panel, longer)
        self.assertEqual(panel.fields.job().prism.l, 30.0)
        self.assertEqual(tuple(panel._drawn.prism.axes[0])[1], 30.0)

    def test_an_anatomical_preset_opens_its_file_and_cancel_takes_it_away_again(self):
        FreeCADGui.runCommand("Trabecula_Preset_cranial")
        panel = panels.current()
        self.wait_for_estimate(panel, 120)
        self.assertEqual([obj.Label for obj in self.document.Objects], ["cranial_plate"])
        self.assertEqual(panel.fields.faces.value(), preset("cranial").faces)
        panel.reject()
        self.assertEqual(self.names(), [])

    def pad(self):
        """A PartDesign body of one step of 10 x 8 x 6 mm, 20 mm along X."""
        body = self.document.addObject("PartDesign::Body", "Design")
        step = body.newObject("PartDesign::AdditiveBox", "Pad")
        step.Length, step.Width, step.Height = 10, 8, 6
        body.Placement.Base.x = 20
        self.document.recompute()
        return body

    def test_a_click_on_a_part_design_body_means_the_body_where_it_is_seen(self):
        body = self.pad()
        FreeCADGui.Selection.addSelection(self.document.Name, body.Name, "Pad.Face6", 25, 4, 6)
        FreeCADGui.runCommand("Trabecula_FaceSites")
        panel = panels.current()
        self.assertTrue(wait(lambda: panel.body.is_ready, 30))
        self.assertEqual(panel.envelope, body)
        self.assertEqual([one.face for one in panel.fields.faces.value()], ["Face6"])
        self.assertNotIn("Pad", [panel.fields.envelope.itemText(k) for k in range(panel.fields.envelope.count())])
        panel.fields.faces.pick_button.setChecked(True)
        FreeCADGui.Selection.addSelection(self.document.Name, body.Name, "Pad.Face5", 25, 4, 0)
        settle(0.1)
        self.assertEqual([one.face for one in panel.fields.faces.value()], ["Face6", "Face5"])

    def test_faces_of_a_step_that_is_not_the_last_are_not_taken_for_those_of_the_body(self):
        body = self.pad()
        chamfer = body.newObject("PartDesign::Chamfer", "Chamfer")
        chamfer.Base, chamfer.Size = (self.document.getObject("Pad"), ["Edge1"]), 1
        self.document.recompute()
        FreeCADGui.Selection.addSelection(self.document.Name, body.Name, "Pad.Face6", 25, 4, 6)
        FreeCADGui.runCommand("Trabecula_FaceSites")
        self.assertEqual(panels.current().envelope, body)
        self.assertEqual(list(panels.current().fields.faces.value()), [])

    def test_a_body_in_a_moved_part_is_picked_previewed_and_filled_where_it_is_seen(self):
        part, body = self.document.addObject("App::Part", "Part"), self.add(Part.makeBox(10, 8, 6))
        part.addObject(body)
        part.Placement.Base = FreeCAD.Vector(50, 0, 0)
        self.document.recompute()
        panel = self.open_on(body, ["Face5", "Face6"])
        self.assertEqual(panel.preview._frame.matrix.getValue()[3][0], 50)
        panel.fields.faces.origin_button.click()
        FreeCADGui.Selection.addSelection(self.document.Name, part.Name, body.Name + ".Face6", 52.0, 3.0, 6.0)
        settle(0.1)
        self.assertEqual(panel.fields.faces.value()[1].origin, (2.0, 3.0, 6.0))
        self.change(panel, panel.fields.couplings._add)
        panel.accept()
        self.assertTrue(wait(lambda: not panel.is_open, 60))
        self.assertEqual(self.wireframe().getParentGeoFeatureGroup(), part)

    def mesh(self, shape):
        obj = self.document.addObject("Mesh::Feature", "Bone")
        obj.Mesh = Mesh.Mesh(shape.tessellate(0.1))
        return obj

    def test_a_closed_mesh_becomes_a_solid_that_cancel_takes_away_again(self):
        bone = self.mesh(Part.makeBox(10, 8, 6))
        FreeCADGui.Selection.addSelection(bone)
        FreeCADGui.runCommand("Trabecula_Design")
        panel = panels.current()
        self.assertTrue(wait(lambda: panel.body.is_ready or self.refused(panel), 30), self.refused(panel))
        self.assertAlmostEqual(panel.envelope.Shape.Volume, 480, 3)
        self.assertEqual((panel.envelope.Label, bone.Visibility), ("Bone (solid)", False))
        panel.reject()
        self.assertEqual((self.names(), bone.Visibility), (["Bone"], True))

    def test_a_mesh_with_a_hole_is_refused_and_nothing_can_be_built(self):
        box = Part.makeBox(10, 8, 6)
        bone = self.mesh(Part.makeShell(box.Faces[:5]))
        FreeCADGui.Selection.addSelection(bone)
        FreeCADGui.runCommand("Trabecula_Design")
        panel = panels.current()
        self.assertTrue(wait(lambda: "1 holes with 4 open edges" in self.refused(panel), 30), self.refused(panel))
        panel.build()
        panel.accept()
        self.assertEqual(len(self.dialogs), 2)
        self.assertTrue(all("a mesh must be closed" in text for text in self.dialogs), self.dialogs)
        self.assertEqual((panel.is_open, self.names()), (True, ["Bone"]))

    def test_a_solid_that_is_still_being_checked_can_be_built_in_and_a_mesh_not_yet(self):
        for body in (self.add(Part.makeCylinder(4, 8.25)), self.mesh(Part.makeBox(10, 8, 6.25))):
            panels.open_new(self.document, envelope=body)
            panel = panels.current()
            self.assertFalse(panel.body.is_ready)
            if body.Name == "Bone":
                with self.assertRaisesRegex(EnvelopeError, "wait a moment"):
                    panel.body.check_ready()
            else:
                panel.body.check_ready()  # as "Build scaffold" does with a document that was opened just now
            panel.reject()
            settle(0.3)

    def test_what_has_no_solid_is_refused_by_its_name_and_no_prism_is_offered_in_its_place(self):
        shell = self.add(Part.makeBox(1, 1, 1).Shells[0], "Surface")
        FreeCADGui.Selection.addSelection(shell)
        FreeCADGui.runCommand("Trabecula_Design")
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual(len(self.dialogs), 1)
        self.assertIn("got Surface", self.dialogs[0])

    def test_a_file_that_is_missing_is_refused_by_its_name(self):
        job = replace(preset("cranial"), envelope="/nowhere/bone.step")
        panels.open_new(self.document, job)
        panel = panels.current()
        self.assertTrue(wait(lambda: "bone.step" in self.refused(panel), 30))
        self.assertEqual(self.names(), [])
