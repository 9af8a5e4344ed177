# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of solids: closed, as exact as asked for, and where they cross."""

import math
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.core import meshes
from freecad_trabecula.errors import EnvelopeError, KernelError, ParameterError
from freecad_trabecula.geometry import tessellation
from freecad_trabecula.geometry.tessellation import default_deflection, find_crossing, tessellate

Vector = FreeCAD.Vector
EXAMPLES = Path(__file__).resolve().parent.parent.parent / "resources" / "examples"


class Triangles(unittest.TestCase):
    def test_those_of_a_box_are_exact(self):
        mesh = tessellate(Part.makeBox(1, 2, 3)).mesh
        self.assertEqual(len(mesh.triangles), 12)
        self.assertAlmostEqual(meshes.mesh_volume(mesh), 6, places=12)

    def test_they_are_within_twice_the_deflection_of_a_sphere(self):
        for deflection in (0.2, 0.05, 0.01):
            mesh = tessellate(Part.makeSphere(5), deflection).mesh
            centres = np.linalg.norm(mesh.corners.mean(1), axis=1)
            np.testing.assert_allclose(np.linalg.norm(mesh.vertices, axis=1), 5, atol=1e-9)
            self.assertGreater(centres.min(), 5 - 2 * deflection)

    def test_making_them_leaves_the_shape_itself_untouched(self):
        sphere = Part.makeSphere(5)
        coarse = len(sphere.tessellate(1.0)[1])
        tessellate(sphere, 0.01)
        self.assertEqual(len(sphere.tessellate(1.0)[1]), coarse)

    def test_they_lie_where_the_solid_is_placed(self):
        box = Part.makeBox(1, 2, 3)
        box.Placement = FreeCAD.Placement(Vector(10, 0, 0), FreeCAD.Rotation(Vector(0, 0, 1), 90))
        low, high = meshes.bounds(tessellate(box).mesh)
        np.testing.assert_allclose([low, high], [[8, 0, 0], [10, 1, 3]], atol=1e-9)

    def test_the_default_deflection_goes_with_the_size(self):
        self.assertAlmostEqual(default_deflection(Part.makeBox(10, 10, 10)), 0.02)
        self.assertAlmostEqual(default_deflection(Part.makeBox(1, 1, 1)), 0.002)


class Crossings(unittest.TestCase):
    def test_domes_whose_triangles_fold_at_the_pole_are_not_taken_for_crossing(self):
        shape = Part.Shape()
        shape.read(str(EXAMPLES / "cranial_plate.step"))
        for deflection in (0.005, 0.01, 0.02, 0.1):
            self.assertIsNone(find_crossing(shape.Solids[0], deflection))

    def test_sound_bodies_have_none(self):
        for shape in (Part.makeBox(1, 2, 3), Part.makeTorus(5, 2), Part.makeCone(5, 0, 3), Part.makeCylinder(1, 100)):
            self.assertIsNone(find_crossing(shape))

    def test_convex_bodies_are_not_searched_for_any_and_others_are(self):
        box = Part.makeBox(10, 8, 6)
        turned = box.copy()
        turned.rotate(Vector(1, 2, 3), Vector(1, 1, 1), 40)
        with mock.patch.object(tessellation, "kernel_mesh", side_effect=KernelError("searched")):
            for convex in (box, turned, Part.makeWedge(0, 0, 0, 2, 2, 10, 8, 6, 5, 5)):
                self.assertIsNone(find_crossing(convex))
            for other in (box.cut(Part.makeBox(5, 8, 3)).Solids[0], Part.makeSphere(5)):
                with self.assertRaisesRegex(KernelError, "searched"):
                    find_crossing(other)

    def test_the_place_of_a_crossing_is_told_where_the_solid_is(self):
        spindle = Part.makeTorus(2, 3, Vector(1000, 0, 0))  # its inner part crosses on the axis, |z| < sqrt(5)
        crossing = find_crossing(spindle, 0.02)
        self.assertGreater(crossing.pairs, 10)
        self.assertAlmostEqual(crossing.middle.x, 1000, delta=0.3)
        self.assertLess(abs(crossing.middle.z), math.sqrt(5) + 0.3)


class Refusals(unittest.TestCase):
    def test_a_deflection_below_zero_or_no_number(self):
        for deflection in (-1, float("nan"), float("inf")):
            with self.assertRaisesRegex(ParameterError, "deflection must be 0 mm or more"):
                tessellate(Part.makeBox(1, 1, 1), deflection)

    def test_a_solid_inside_out(self):
        with self.assertRaisesRegex(EnvelopeError, "volume greater than 0, got -24 mm3.*inside out"):
            tessellate(Part.makeBox(2, 3, 4).reversed(), 0.1)

    def test_an_open_solid(self):
        with self.assertRaises((KernelError, ValueError)) as caught:
            tessellate(Part.Solid(Part.Shell(Part.makeBox(1, 1, 1).Faces[:5])), 0.1)
        self.assertRegex(str(caught.exception), "4 open edges")
