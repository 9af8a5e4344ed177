# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that look at each other through a solid."""

import unittest
from pathlib import Path

import FreeCAD
import Part

from freecad_trabecula.geometry.opposite_faces import opposite_faces

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"


class OppositeFacesTest(unittest.TestCase):
    def test_a_boxs_faces_pair_up_the_largest_first(self):
        pairs = opposite_faces(Part.makeBox(30, 20, 5))
        self.assertEqual(pairs, [("Face5", "Face6"), ("Face3", "Face4"), ("Face1", "Face2")])

    def test_small_faces_are_edges_and_stay_alone(self):
        pairs = opposite_faces(Part.makeBox(100, 100, 2))
        self.assertEqual(pairs, [("Face5", "Face6")])

    def test_a_turned_box_has_the_same_pairs(self):
        box = Part.makeBox(30, 20, 5)
        box.rotate(FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(1, 1, 0.5), 37)
        self.assertEqual(opposite_faces(box), opposite_faces(Part.makeBox(30, 20, 5)))

    def test_a_cylinder_has_its_ends_opposite_and_its_side_alone(self):
        cylinder = Part.makeCylinder(5, 10)
        pairs = opposite_faces(cylinder)
        self.assertEqual(len(pairs), 1)
        ends = [cylinder.Faces[int(name[4:]) - 1].Surface for name in pairs[0]]
        self.assertTrue(all(isinstance(surface, Part.Plane) for surface in ends))

    def test_bodies_without_opposite_faces_have_no_pair(self):
        corners = [FreeCAD.Vector(*c) for c in ((0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9))]
        faces = [
            Part.Face(Part.makePolygon([corners[k] for k in (*c, c[0])]))
            for c in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
        ]
        for body in (Part.makeSphere(5), Part.Solid(Part.Shell(faces))):
            self.assertEqual(opposite_faces(body), [])

    def test_faces_that_look_away_from_each_other_across_a_gap_are_no_pair(self):
        # the inner faces of a U look at each other through the air
        u_shape = Part.makeBox(30, 10, 30).cut(Part.makeBox(20, 10, 25, FreeCAD.Vector(5, 0, 5)))
        for first, second in opposite_faces(u_shape):
            a, b = (u_shape.Faces[int(name[4:]) - 1] for name in (first, second))
            middle = (a.CenterOfMass + b.CenterOfMass) * 0.5
            inward = (b.CenterOfMass - a.CenterOfMass).normalize()
            self.assertLess(a.normalAt(0, 0).dot(inward), 0, (first, second, middle))

    def test_an_implant_has_its_broad_sides_opposite(self):
        path = EXAMPLES / "cranial_plate.step"
        if not path.exists():
            self.skipTest(f"no {path}")
        plate = Part.Shape()
        plate.read(str(path))
        faces = plate.Solids[0].Faces
        broadest = sorted(range(len(faces)), key=lambda k: -faces[k].Area)[:2]
        first = opposite_faces(plate.Solids[0])[0]
        self.assertEqual({int(name[4:]) - 1 for name in first}, set(broadest))


if __name__ == "__main__":
    unittest.main()
