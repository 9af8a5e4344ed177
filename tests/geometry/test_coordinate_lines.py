# SPDX-License-Identifier: LGPL-2.1-or-later
"""Co-ordinate lines against closed arc lengths: circles, ellipses, great circles, meridians, slants, splines."""

import math
import unittest
from pathlib import Path

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.errors import KernelError, ParameterError
from freecad_trabecula.geometry.coordinate_lines import BORDER, MEETING, ROUND, CoordinateLine, tangential
from freecad_trabecula.geometry.surfaces import FaceSurface

Vector = FreeCAD.Vector
EXAMPLES = Path(__file__).resolve().parent.parent.parent / "resources" / "examples"


def line_on(face, origin, direction, meetings=()):
    surface = FaceSurface(face)
    return surface, CoordinateLine(surface, surface.nearest(Vector(*origin)), Vector(*direction), meetings)


def femur_face(number):
    shape = Part.Shape()
    shape.read(str(EXAMPLES / "femur_metaphysis.step"))
    return shape.Faces[number - 1]


class Lengths(unittest.TestCase):
    def test_a_straight_line_ends_where_the_rectangle_ends(self):
        _, line = line_on(Part.makeBox(10, 8, 6).Faces[5], (3, 4, 6), (3, 4, 0))
        self.assertAlmostEqual(line.plus.length, 5, places=9)  # at y = 8
        self.assertAlmostEqual(line.minus.length, 5, places=9)  # in the corner (0, 0)
        self.assertEqual((line.plus.end, line.minus.end, line.closed), (BORDER, BORDER, False))

    def test_an_oblique_line_on_a_cylinder_is_an_ellipse(self):
        _, line = line_on(Part.makeCylinder(5, 100).Faces[0], (-5, 0, 50), (0, 1, 1))
        a, b = 5 * math.sqrt(2), 5.0
        t = np.linspace(0, 2 * math.pi, 2001)[:-1]  # the trapezium rule is exact to rounding for periodic functions
        length = np.hypot(a * np.sin(t), b * np.cos(t)).mean() * 2 * math.pi
        self.assertEqual((line.closed, line.plus.end), (True, ROUND))
        self.assertAlmostEqual(line.plus.length, length, delta=1e-6)

    def test_lines_on_a_sphere_are_great_circles(self):
        for direction in ((0, 1, 0), (4, 0, -3), (1, 2, 3)):  # round, through both poles, oblique
            surface, line = line_on(Part.makeSphere(5).Faces[0], (3, 0, 4), direction)
            self.assertTrue(line.closed)
            self.assertAlmostEqual(line.plus.length, 10 * math.pi, delta=1e-6)
            third = surface.point(line.at(10 * math.pi / 3))
            self.assertAlmostEqual(third.getAngle(Vector(3, 0, 4)), 2 * math.pi / 3, delta=1e-7)

    def test_a_dome_is_followed_across_its_pole_to_the_rim(self):
        dome = Part.makeSphere(5, Vector(), Vector(0, 0, 1), 30, 90, 360)
        face = next(f for f in dome.Faces if isinstance(f.Surface, Part.Sphere))
        beside = (0.4, 0.3, math.sqrt(25 - 0.25))
        for origin, direction in (((0, 0, 5), (1, 0, 0)), (beside, (4, 3, 0)), ((0, 1e-7, 5), (0, 1, 0))):
            _, line = line_on(face, origin, direction)
            self.assertAlmostEqual(line.plus.length + line.minus.length, 5 * 2 * math.pi / 3, delta=1e-6)

    def test_a_meridian_and_the_outer_equator_of_a_torus_have_their_lengths(self):
        for direction, length in (((0, 0, 1), 4 * math.pi), ((0, 1, 0), 14 * math.pi)):
            _, line = line_on(Part.makeTorus(5, 2).Faces[0], (7, 0, 0), direction)
            self.assertTrue(line.closed)
            self.assertAlmostEqual(line.plus.length, length, delta=1e-6)

    def test_a_line_on_a_cone_ends_at_the_apex_and_at_the_rim(self):
        _, line = line_on(Part.makeCone(5, 0, 12).Faces[0], (2.5, 0, 6), (-5, 0, 12))
        self.assertAlmostEqual(line.plus.length, 6.5, delta=1e-6)
        self.assertAlmostEqual(line.minus.length, 6.5, delta=1e-6)

    def test_lengths_scale_with_the_body(self):
        for scale in (1e-2, 1, 1e3):
            _, line = line_on(Part.makeTorus(5 * scale, 2 * scale).Faces[0], (7 * scale, 0, 0), (0, 1, 1))
            _, unit = line_on(Part.makeTorus(5, 2).Faces[0], (7, 0, 0), (0, 1, 1))
            self.assertAlmostEqual(line.plus.length / unit.plus.length / scale, 1, delta=1e-6)

    def test_a_line_far_from_the_origin_of_space_is_as_long(self):
        sphere = Part.makeSphere(5, Vector(1e5, -2e5, 3e5))
        _, line = line_on(sphere.Faces[0], (1e5 + 3, -2e5, 3e5 + 4), (1, 2, 3))
        self.assertAlmostEqual(line.plus.length, 10 * math.pi, delta=1e-6)


class OnTheFemur(unittest.TestCase):
    def test_a_line_is_as_long_as_the_section_that_the_kernel_makes(self):
        face = femur_face(2)
        surface = FaceSurface(face)
        for direction in (Vector(1, 0, 0), Vector(0, 0, 1), Vector(1, 0.3, 0.7)):
            line = CoordinateLine(surface, surface.centre(), direction)
            plane = Part.makePlane(200, 200, Vector(), line.across)
            plane.translate(line.origin - plane.CenterOfMass)
            edges = [e for e in face.section(plane).Edges if e.distToShape(Part.Vertex(line.origin))[0] < 1e-3]
            # The kernel's curve is fitted; its own error is some 1e-4 mm.
            self.assertAlmostEqual(line.plus.length + line.minus.length, sum(e.Length for e in edges), delta=1e-3)

    def test_arc_length_is_the_limit_of_the_chords(self):
        surface = FaceSurface(femur_face(1))
        line = CoordinateLine(surface, surface.centre(), Vector(1, 0.3, 0.7))
        s = np.linspace(0, line.plus.length, 2049)
        points = np.array([tuple(surface.point(line.at(a))) for a in s.tolist()])
        chords = [np.linalg.norm(np.diff(points[::step], axis=0), axis=1).sum() for step in (1, 2)]
        self.assertAlmostEqual(line.plus.length, (4 * chords[0] - chords[1]) / 3, delta=1e-6)
        self.assertTrue(all(abs((Vector(*p) - line.origin).dot(line.across)) < 1e-9 for p in points))

    def test_a_face_that_was_triangulated_gives_the_same_line_to_the_last_digit(self):
        lengths = []
        for deflection in (None, 0.5, 0.05):
            face = femur_face(1)
            if deflection:
                face.tessellate(deflection)
            surface = FaceSurface(face)
            lengths.append(CoordinateLine(surface, surface.centre(), Vector(1, 0, 1)).plus.length)
        self.assertEqual(lengths[1:], lengths[:1] * 2)


class Stops(unittest.TestCase):
    def test_a_line_ends_at_a_meeting_that_is_on_it_and_passes_one_that_is_not(self):
        face = Part.makeBox(10, 8, 6).Faces[5]
        _, line = line_on(face, (3, 4, 6), (1, 0, 0), [Vector(8, 4, 6), Vector(7, 4.001, 6)])
        self.assertEqual(line.plus.end, MEETING)
        self.assertAlmostEqual(line.plus.length, 5, places=9)

    def test_crossings_with_a_plane_leave_out_the_one_named(self):
        _, line = line_on(Part.makeSphere(5).Faces[0], (5, 0, 0), (0, 1, 0))
        found = line.crossings(Vector(), Vector(1, 0, 0), but=2.5 * math.pi)
        np.testing.assert_allclose([tuple(p) for p in found], [[0, -5, 0]], atol=1e-6)
        both = line.crossings(Vector(), Vector(1, 0, 0), but=0.0)
        self.assertEqual(len(both), 2)

    def test_an_origin_on_the_border_leads_inwards_only(self):
        _, line = line_on(Part.makeBox(10, 8, 6).Faces[5], (0, 4, 6), (1, 0, 0))
        self.assertAlmostEqual(line.plus.length, 10, places=9)
        self.assertEqual(line.minus.length, 0)

    def test_a_line_along_the_border_ends_at_its_corners(self):
        _, line = line_on(Part.makeBox(10, 8, 6).Faces[5], (3, 8, 6), (1, 0, 0))
        self.assertAlmostEqual(line.plus.length, 7, places=9)
        self.assertAlmostEqual(line.minus.length, 3, places=9)


class Refusals(unittest.TestCase):
    def test_a_direction_along_the_normal_is_refused(self):
        with self.assertRaisesRegex(ParameterError, "must not be along the face's normal .*\\(0, 0, 2\\)"):
            tangential(Vector(0, 0, 2), Vector(0, 0, 1))

    def test_an_origin_without_a_normal_is_refused(self):
        with self.assertRaisesRegex(KernelError, "no normal at"):
            line_on(Part.makeCone(5, 0, 12).Faces[0], (0, 0, 12), (1, 0, 0))
