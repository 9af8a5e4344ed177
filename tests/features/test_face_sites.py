# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites of one face in the document: they follow their envelope, and say when their face has vanished."""

import sys
from pathlib import Path

import FreeCAD
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core.parameters import Coupling, FaceParameters
from freecad_trabecula.core.wireframe import WireframeParameters


class FaceSitesTest(DocumentCase):
    def test_a_square_face_holds_the_grid_that_its_spacing_asks_for(self):
        sites = make.make_face_sites(
            make.make_box(self.document), FaceParameters("Face6", "top", c_u=2, c_v=2, b_u=1, b_v=1)
        )
        self.assertEqual(sites.Count, 25)
        points = sorted((round(v.X, 9), round(v.Y, 9), round(v.Z, 9)) for v in sites.Shape.Vertexes)
        self.assertEqual(
            points, sorted((x, y, 10.0) for x in (1.0, 3.0, 5.0, 7.0, 9.0) for y in (1.0, 3.0, 5.0, 7.0, 9.0))
        )

    def test_a_larger_envelope_gets_more_sites_with_the_next_recompute(self):
        box = make.make_box(self.document)
        sites = make.make_face_sites(box, FaceParameters("Face6", c_u=2, c_v=2, b_u=1, b_v=1))
        box.Length = 14
        self.document.recompute()
        self.assertEqual(sites.Count, 35)

    def test_origin_and_directions_survive_their_file(self):
        parameters = FaceParameters("Face6", "A", (3.0, 3.0, 10.0), (1.0, 1.0, 0.0), None, 1.0, 1.0, 0.5, 0.5)
        sites = make.make_face_sites(make.make_box(self.document), parameters)
        count = sites.Count
        sites = self.reopened().getObject("Sites_A")
        self.assertEqual(sites.Proxy.parameters(sites), parameters)
        make.update(sites)
        self.assertEqual(sites.Count, count)

    def test_a_face_that_vanishes_with_an_edit_of_the_envelope_is_named_and_comes_back(self):
        box, tool = make.make_box(self.document), make.make_box(self.document, 4, 4, 4, "Tool")
        pit = FreeCAD.Vector(3, 3, 8)
        tool.Placement.Base = pit
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, tool
        self.document.recompute()
        self.assertEqual(len(cut.Shape.Faces), 11)
        faces = cut.Shape.Faces
        floor = next(k + 1 for k, f in enumerate(faces) if (f.CenterOfMass - FreeCAD.Vector(5, 5, 8)).Length < 1e-6)
        sites = make.make_face_sites(cut, FaceParameters(f"Face{floor}", "floor", c_u=1, c_v=1))
        self.assertEqual(sites.Count, 9)
        tool.Placement.Base.x = 30
        self.document.recompute()
        self.assertFalse(sites.isValid())
        self.assertRegex(sites.Status, f"sites Sites floor lost their face Face{floor}: Cut has Face1..Face6; choose")
        self.assertEqual((sites.Count, len(sites.Shape.Vertexes)), (9, 9))
        tool.Placement.Base = pit
        self.document.recompute()
        self.assertEqual((sites.State, sites.Count), (["Up-to-date"], 9))

    def filleted(self, *edges):
        """Return a cube without a history and two opposite faces with sites; then some edges of it are rounded."""
        body = self.document.addObject("Part::Feature", "Body")
        body.Shape = Part.makeBox(10, 10, 10)
        spacing = {"c_u": 3.0, "c_v": 3.0, "b_u": 2.0, "b_v": 2.0}
        middles = {"Face5": (5.0, 5.0, 0.0), "Face6": (5.0, 5.0, 10.0)}
        sites = [make.make_face_sites(body, FaceParameters(name, "", one, **spacing)) for name, one in middles.items()]
        couplings = (Coupling("Face5", "Face6", "same"),)
        wireframe = make.make_wireframe(body, sites, WireframeParameters(couplings=couplings))
        self.assertEqual(wireframe.Rods, 9)
        if edges:
            body.Shape = body.Shape.makeFillet(1, [body.Shape.Edges[k] for k in edges])
            self.document.recompute()
        return body, sites, wireframe

    def test_a_face_that_a_fillet_gave_another_number_is_found_again_and_the_design_stays(self):
        body, sites, wireframe = self.filleted(0)
        for one, z, label in zip(sites, (0, 10), ("Face5", "Face6")):
            (name,) = one.Face[1]
            face = body.Shape.getElement(name)
            self.assertEqual((face.BoundBox.ZMin, face.BoundBox.ZMax), (z, z))
            self.assertEqual({v.Z for v in one.Shape.Vertexes}, {float(z)})
            self.assertEqual(f"its face, {label} so far, is now {name} of Body" in one.Status, name != label)
            self.assertEqual(one.Proxy.parameters(one).label, label)
        self.assertNotEqual([one.Face[1][0] for one in sites], ["Face5", "Face6"])
        self.assertEqual((wireframe.isValid(), wireframe.Rods), (True, 9))
        self.document.recompute()
        self.assertEqual([one.State for one in sites], [["Up-to-date"]] * 2)

    def test_a_body_that_was_moved_or_turned_keeps_its_sites(self):
        body, sites, _ = self.filleted()
        body.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90))
        self.document.recompute()
        self.assertEqual([one.Face[1] for one in sites], [["Face5"], ["Face6"]])
        self.assertEqual([one.FaceName for one in sites], ["", ""])

    def test_another_body_without_such_faces_is_refused_by_the_faces_that_were_lost(self):
        body, sites, wireframe = self.filleted()
        body.Shape = Part.makeSphere(5)
        self.document.recompute()
        for one, name in zip(sites, ("Face5", "Face6")):
            self.assertRegex(one.Status, f"lost their face {name}: Body has Face1..Face1; choose another face")
        self.assertEqual(wireframe.Rods, 9)

    def test_a_face_that_was_chosen_by_hand_is_not_given_back(self):
        body, sites, _ = self.filleted()
        sites[1].Face, sites[1].OriginGiven = (body, ["Face1"]), False
        self.document.recompute()
        self.assertEqual((sites[1].Face[1], {v.X for v in sites[1].Shape.Vertexes}), (["Face1"], {0.0}))
        body.Shape = Part.makeBox(12, 10, 10)
        self.document.recompute()
        self.assertEqual(sites[1].Face[1], ["Face1"])

    def test_a_face_is_found_again_after_its_file_was_opened(self):
        body, _, _ = self.filleted()
        document = self.reopened()
        body, sites = document.getObject("Body"), document.getObject("Sites_Face6")
        cube = body.Shape
        body.Shape = cube.makeFillet(1, [cube.Edges[0]])
        document.recompute()
        self.assertEqual({v.Z for v in sites.Shape.Vertexes}, {10.0})

    def test_sites_need_one_face(self):
        box = make.make_box(self.document)
        sites = make.make_face_sites(box, FaceParameters("Face1"))
        sites.Face = (box, ["Face1", "Face2"])
        self.document.recompute()
        self.assertRegex(sites.Status, "must be linked to 1 face, got 2")
        sites.Face = None
        self.document.recompute()
        self.assertRegex(sites.Status, "must be linked to 1 face, got 0")
