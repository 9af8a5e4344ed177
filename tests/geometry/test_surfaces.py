# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface under a face: normals, centres, borders."""

import math
import unittest

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.errors import KernelError
from freecad_trabecula.geometry.surfaces import FaceSurface, solve_two

Vector = FreeCAD.Vector


def top_of(shape):
    return max(shape.Faces, key=lambda f: (f.CenterOfMass.z, f.Area))


class Normals(unittest.TestCase):
    def test_normals_of_a_sphere_point_outwards_also_at_its_poles(self):
        surface = FaceSurface(Part.makeSphere(5).Faces[0])
        for point in ((0, 0, 5), (0, 0, -5), (5, 0, 0), (0, 3, -4), (1e-9, 0, 5)):
            normal = surface.normal(surface.nearest(Vector(*point)))
            np.testing.assert_allclose(tuple(normal), np.array(point) / 5, atol=1e-6)

    def test_a_cavitys_normals_point_into_the_cavity(self):
        hollow = Part.makeSphere(5).cut(Part.makeSphere(3))
        inner = min(hollow.Faces, key=lambda f: f.Area)
        surface = FaceSurface(inner)
        np.testing.assert_allclose(tuple(surface.normal(surface.nearest(Vector(3, 0, 0)))), [-1, 0, 0], atol=1e-9)

    def test_the_apex_of_a_cone_has_no_normal(self):
        surface = FaceSurface(Part.makeCone(5, 0, 12).Faces[0])
        with self.assertRaisesRegex(KernelError, "no normal at \\(.*12\\) mm"):
            surface.normal(surface.nearest(Vector(0, 0, 12)))


class Centres(unittest.TestCase):
    def test_the_centre_of_a_plane_face_is_its_centre_of_mass(self):
        corners = [Vector(0, 0, 0), Vector(6, 0, 0), Vector(0, 9, 0), Vector(0, 0, 0)]
        surface = FaceSurface(Part.Face(Part.makePolygon(corners)))
        np.testing.assert_allclose(tuple(surface.point(surface.centre())), [2, 3, 0], atol=1e-9)

    def test_the_centre_of_a_closed_side_lies_opposite_its_seam_at_half_its_height(self):
        surface = FaceSurface(Part.makeCylinder(5, 8).Faces[0])
        np.testing.assert_allclose(tuple(surface.point(surface.centre())), [-5, 0, 4], atol=1e-9)

    def test_the_centre_of_a_face_whose_middle_is_a_hole_lies_inside_the_face(self):
        plate = Part.makeBox(20, 20, 2).cut(Part.makeCylinder(3, 2, Vector(10, 10, 0)))
        surface = FaceSurface(top_of(plate))
        centre = surface.centre()
        self.assertTrue(surface.has(centre))
        off = (surface.point(centre) - Vector(10, 10, 2)).Length
        self.assertTrue(3 < off < 3.6, off)

    def test_the_centre_of_a_horseshoe_lies_on_the_horseshoe(self):
        shoe = Part.makeBox(20, 20, 2).cut(Part.makeBox(10, 18, 2, Vector(5, 0, 0)))
        surface = FaceSurface(top_of(shoe))
        self.assertTrue(surface.has(surface.centre()))


class Borders(unittest.TestCase):
    def crossings(self, face, base, across):
        found = FaceSurface(face).border_crossings(Vector(*base), Vector(*across))
        return sorted(tuple(round(c, 9) + 0.0 for c in p) for p in found)

    def test_a_plane_cuts_a_rectangle_and_its_hole_four_times(self):
        plate = Part.makeBox(20, 20, 2).cut(Part.makeCylinder(3, 2, Vector(10, 10, 0)))
        found = self.crossings(top_of(plate), (0, 11, 0), (0, 1, 0))
        x = math.sqrt(8)
        np.testing.assert_allclose(found, [[0, 11, 2], [10 - x, 11, 2], [10 + x, 11, 2], [20, 11, 2]], atol=1e-9)

    def test_an_edge_that_dips_through_the_plane_between_two_samples_is_found(self):
        plate = Part.makeBox(20, 20, 2).cut(Part.makeCylinder(3, 2, Vector(10, 10, 0)))
        found = self.crossings(top_of(plate), (0, 13 - 1e-7, 0), (0, 1, 0))
        half = math.sqrt(9 - (3 - 1e-7) ** 2)
        np.testing.assert_allclose([p[0] for p in found], [0, 10 - half, 10 + half, 20], atol=1e-7)

    def test_a_plane_above_the_hole_cuts_the_outline_only(self):
        plate = Part.makeBox(20, 20, 2).cut(Part.makeCylinder(3, 2, Vector(10, 10, 0)))
        self.assertEqual(len(self.crossings(top_of(plate), (0, 13 + 1e-7, 0), (0, 1, 0))), 2)

    def test_seams_and_smooth_poles_are_no_border_but_an_apex_is(self):
        self.assertEqual(self.crossings(Part.makeSphere(5).Faces[0], (0, 0, 0), (0, 1, 0)), [])
        cone = Part.makeCone(5, 0, 12).Faces[0]
        found = self.crossings(cone, (0, 0, 0), (0, 1, 0))
        self.assertEqual(sorted(set(found)), [(-5, 0, 0), (0, 0, 12), (5, 0, 0)])


class Equations(unittest.TestCase):
    def test_two_equations_are_solved_also_when_one_unknown_does_not_count(self):
        self.assertEqual(solve_two(2, 1, 1, 3, 5, 10), (1, 3))
        self.assertEqual(solve_two(0, 2, 0, 0, 6, 0), (0, 3))
        self.assertEqual(solve_two(4, 0, 0, 0, 8, 0), (2, 0))
        self.assertEqual(solve_two(0, 0, 0, 0, 1, 1), (0, 0))
