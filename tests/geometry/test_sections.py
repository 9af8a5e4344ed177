# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and solids as triangles to be sliced, and a solid's exact slices."""

import math
import unittest

import FreeCAD
import Mesh
import numpy as np
import Part

from freecad_trabecula.core.analysis.slices import sliced_areas
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rods import true_volumes
from freecad_trabecula.errors import EnvelopeError, MeshError
from freecad_trabecula.geometry.design import make_design
from freecad_trabecula.geometry.sections import exact_areas, mesh_soup, rods_soup, shape_soup


def volume(soup):
    """Return the volume of closed triangles by the divergence theorem."""
    a, b, c = soup.triangles.astype(float).transpose(1, 0, 2)
    return float((a * np.cross(b, c)).sum() / 6)


class SoupTest(unittest.TestCase):
    def test_a_mesh_gives_its_triangles_where_it_is_placed(self):
        mesh = Mesh.createBox(1, 2, 3)
        mesh.Placement = FreeCAD.Placement(FreeCAD.Vector(10, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        soup = mesh_soup(mesh, "box")
        self.assertEqual((soup.triangles.shape, soup.source), ((12, 3, 3), "box"))
        self.assertAlmostEqual(volume(soup), 6.0, 5)
        self.assertTrue(np.allclose(np.ptp(soup.box, axis=0), (2, 1, 3), atol=1e-6))
        self.assertAlmostEqual(float(soup.box.mean(0)[0]), 10.0, 5)

    def test_a_mesh_without_triangles_is_refused(self):
        with self.assertRaisesRegex(MeshError, "at least one triangle, got 0"):
            mesh_soup(Mesh.Mesh())

    def test_solids_of_a_compound_are_all_there_and_placed(self):
        one, two = Part.makeBox(1, 1, 1), Part.makeSphere(1, FreeCAD.Vector(5, 0, 0))
        soup = shape_soup(Part.makeCompound([one, two]), 0.001)
        self.assertAlmostEqual(volume(soup), 1 + 4 / 3 * math.pi, delta=0.02)

    def test_a_face_is_refused_by_name(self):
        with self.assertRaisesRegex(EnvelopeError, "plate must have at least one solid, got a face without one"):
            shape_soup(Part.makePlane(1, 1), 0.0, "plate")

    def test_rods_are_closed_and_have_their_volumes(self):
        job = preset("case5")
        wireframe = make_design(job).wireframe
        soup = rods_soup(wireframe, job.rods)
        exact = float(true_volumes(wireframe.paths, wireframe.ends).sum())
        self.assertLess(abs(volume(soup) / exact - 1), 0.01)  # the channels' own deflection


class ExactTest(unittest.TestCase):
    def test_a_sphere_is_cut_in_circles_along_any_axis(self):
        sphere = Part.makeSphere(3, FreeCAD.Vector(1, 2, 3))
        for axis, middle in (("x", 1.0), ("y", 2.0), ("z", 3.0), ("0.6,0.8,0", 0.6 + 1.6)):
            heights = middle + np.array([-2.5, -1.0, 0.0, 1.7, 3.5])
            expected = np.pi * np.maximum(9 - (heights - middle) ** 2, 0)
            found = exact_areas(sphere, axis, heights)
            self.assertLess(np.abs(found - expected).max(), 1e-6, axis)

    def test_a_box_with_a_cavity_loses_it(self):
        body = Part.makeBox(4, 4, 4).cut(Part.makeSphere(1, FreeCAD.Vector(2, 2, 2)))
        self.assertAlmostEqual(float(exact_areas(body, "z", np.array([2.0]))[0]), 16 - math.pi, 9)

    def test_triangles_of_a_torus_are_cut_to_their_deflection_as_the_solid_is(self):
        torus = Part.makeTorus(5, 2)
        heights = np.linspace(-1.9, 1.9, 9)
        exact = exact_areas(torus, "z", heights)
        expected = np.pi * 4 * 5 * np.sqrt(4 - heights**2)  # pi ((R + s)^2 - (R - s)^2)
        self.assertLess(np.abs(exact / expected - 1).max(), 1e-9)
        meshed = sliced_areas(shape_soup(torus, 0.002).triangles, "z", heights)
        self.assertLess(np.abs(meshed / exact - 1).max(), 0.01)

    def test_a_shell_is_refused(self):
        with self.assertRaisesRegex(EnvelopeError, "at least one solid"):
            exact_areas(Part.makeBox(1, 1, 1).Shells[0], "x", np.array([0.5]))


if __name__ == "__main__":
    unittest.main()
