# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites of one face in the document: they follow their envelope, and say when their face has vanished."""

import sys
from pathlib import Path

import FreeCAD

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core.parameters import FaceParameters


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

    def test_sites_need_one_face(self):
        box = make.make_box(self.document)
        sites = make.make_face_sites(box, FaceParameters("Face1"))
        sites.Face = (box, ["Face1", "Face2"])
        self.document.recompute()
        self.assertRegex(sites.Status, "must be linked to 1 face, got 2")
        sites.Face = None
        self.document.recompute()
        self.assertRegex(sites.Status, "must be linked to 1 face, got 0")
