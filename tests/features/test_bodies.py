# SPDX-License-Identifier: LGPL-2.1-or-later
"""What counts as a body in a document: meshes, solids, PartDesign bodies as wholes; not lines, shells, or steps."""

import sys
import unittest
from pathlib import Path

import FreeCAD
import Mesh
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase

from freecad_trabecula.features.bodies import has_solid, is_body, is_mesh, whole, wholes


class BodiesTest(DocumentCase):
    def feature(self, shape):
        obj = self.document.addObject("Part::Feature", "Body")
        obj.Shape = shape
        return obj

    def pad(self):
        """A PartDesign body of one pad, moved by 20 mm along X; returns body, sketch and pad."""
        body = self.document.addObject("PartDesign::Body", "Body")
        sketch = body.newObject("Sketcher::SketchObject", "Sketch")
        corners = [FreeCAD.Vector(*point) for point in ((0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0))]
        for first, second in zip(corners, [*corners[1:], corners[0]]):
            sketch.addGeometry(Part.LineSegment(first, second))
        pad = body.newObject("PartDesign::Pad", "Pad")
        pad.Profile, pad.Length = sketch, 2
        body.Placement.Base.x = 20
        self.document.recompute()
        return body, sketch, pad

    def test_a_solid_alone_or_in_a_compound_is_a_body_and_lines_and_shells_are_none(self):
        box = Part.makeBox(1, 2, 3)
        line = Part.makeLine(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(1, 0, 0))
        for shape, expected in (
            (box, True),
            (Part.makeCompound([box]), True),
            (Part.makeCompound([line]), False),
            (box.Shells[0], False),
            (line, False),
        ):
            self.assertEqual(is_body(self.feature(shape)), expected, shape.ShapeType)

    def test_a_mesh_with_triangles_is_a_body_and_no_solid(self):
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        self.assertFalse(is_body(mesh))
        mesh.Mesh = Mesh.createBox(1, 1, 1)
        self.assertEqual((is_mesh(mesh), has_solid(mesh), is_body(mesh)), (True, False, True))

    def test_a_part_design_body_counts_once_and_its_steps_mean_it(self):
        body, sketch, pad = self.pad()
        self.assertEqual([is_body(obj) for obj in (body, sketch, pad)], [True, False, False])
        self.assertEqual(whole(pad), body)
        self.assertEqual(wholes([pad, sketch, body]), [body])
        self.assertAlmostEqual(whole(pad).Shape.BoundBox.XMin, 20)

    def test_a_body_in_a_part_is_itself(self):
        part, box = self.document.addObject("App::Part", "Part"), self.feature(Part.makeBox(1, 1, 1))
        part.addObject(box)
        self.assertEqual((whole(box), is_body(box), is_body(part)), (box, True, False))


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
