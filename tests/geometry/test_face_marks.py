# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces found again by points that lie on them, whatever their number is."""

import unittest

import FreeCAD
import Part

from freecad_trabecula.geometry.face_marks import face_mark, faces_like, found_again


class FaceMarksTest(unittest.TestCase):
    def test_every_face_of_any_body_is_like_itself_and_like_no_other(self):
        torus = Part.makeTorus(10, 2, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0, 360, 90)
        for shape in (Part.makeBox(1, 2, 3), Part.makeCylinder(2, 5), Part.makeCone(1, 3, 4), torus):
            for number, face in enumerate(shape.Faces):
                shares = faces_like(shape, face_mark(face))
                self.assertEqual([k for k, share in enumerate(shares) if share > 0], [number])
                self.assertEqual(shares[number], 1)

    def test_both_sides_of_a_thin_wall_are_told_apart_by_their_normals(self):
        wall = Part.makeBox(10, 10, 5e-5)
        shares = faces_like(wall, face_mark(wall.Faces[5]))
        self.assertEqual((shares[4], shares[5]), (0, 1))

    def test_a_ring_whose_middle_is_open_has_a_mark(self):
        ring = Part.makeCylinder(5, 1).cut(Part.makeCylinder(4.9, 1))
        top = next(face for face in ring.Faces if abs(face.CenterOfMass.z - 1) < 1e-9)
        self.assertGreater(len(face_mark(top)), 0)
        self.assertEqual(max(faces_like(ring, face_mark(top))), 1)

    def test_a_face_half_of_which_was_cut_away_is_found(self):
        box = Part.makeBox(10, 10, 10)
        mark = face_mark(box.Faces[5])
        rest = box.cut(Part.makeBox(5, 10, 4, FreeCAD.Vector(0, 0, 6)))
        number = found_again(rest, mark, 6, False)
        self.assertAlmostEqual(rest.Faces[number - 1].CenterOfMass.z, 10)

    def test_with_as_many_faces_a_number_holds_when_the_body_grows(self):
        mark = face_mark(Part.makeBox(10, 10, 10).Faces[1])
        self.assertEqual(found_again(Part.makeBox(12, 10, 10), mark, 2, True), 2)

    def test_with_as_many_faces_in_another_order_the_face_itself_counts(self):
        box = Part.makeBox(1, 2, 3)
        turned = Part.makeSolid(Part.makeShell(box.Faces[::-1]))
        self.assertEqual(found_again(turned, face_mark(box.Faces[5]), 6, True), 1)

    def test_a_face_that_is_nowhere_is_not_found(self):
        self.assertIsNone(found_again(Part.makeSphere(3), face_mark(Part.makeBox(1, 1, 1).Faces[0]), 1, False))
