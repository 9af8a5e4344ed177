# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes in the window: bodies of the document, files, picked faces, and what must be refused."""

from dataclasses import replace

import FreeCAD
import FreeCADGui
import Part
from window import WindowTest, settle, wait

from freecad_trabecula.core.presets import preset
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.picking import FaceGate, is_solid


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

    def test_an_anatomical_preset_opens_its_file_and_cancel_takes_it_away_again(self):
        FreeCADGui.runCommand("Trabecula_Preset_cranial")
        panel = panels.current()
        self.wait_for_estimate(panel, 120)
        self.assertEqual([obj.Label for obj in self.document.Objects], ["cranial_plate"])
        self.assertEqual(panel.fields.faces.value(), preset("cranial").faces)
        panel.reject()
        self.assertEqual(self.names(), [])

    def test_a_file_that_is_missing_is_refused_by_its_name(self):
        job = replace(preset("cranial"), envelope="/nowhere/bone.step")
        panels.open_new(self.document, job)
        panel = panels.current()
        self.assertTrue(wait(lambda: "bone.step" in self.refused(panel), 30))
        self.assertEqual(self.names(), [])
