# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes between the core and FreeCAD's kernel."""

import unittest

import FreeCAD
import Mesh
import numpy as np

from freecad_trabecula.core import meshes
from freecad_trabecula.errors import KernelError, MeshError
from freecad_trabecula.geometry.mesh_objects import core_mesh, mesh_object

TETRAHEDRON = meshes.Mesh(
    np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float),
    np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]),
)


def torus(rings, points):
    """A closed mesh of 2 x rings x points triangles."""
    u, v = np.meshgrid(np.arange(rings) / rings * 2 * np.pi, np.arange(points) / points * 2 * np.pi, indexing="ij")
    vertices = np.stack([(5 + 2 * np.cos(v)) * np.cos(u), (5 + 2 * np.cos(v)) * np.sin(u), 2 * np.sin(v)], -1)
    a = np.arange(rings * points).reshape(rings, points)
    b, d = np.roll(a, -1, 0), np.roll(a, -1, 1)
    c = np.roll(b, -1, 1)
    triangles = [np.stack([x.ravel() for x in corner], 1) for corner in ((a, b, c), (a, c, d))]
    return meshes.Mesh(vertices.reshape(-1, 3), np.concatenate(triangles))


class MeshObjectsTest(unittest.TestCase):
    def test_vertices_and_triangles_keep_their_numbers(self):
        mesh = torus(40, 30)
        points, facets = mesh_object(mesh).Topology
        np.testing.assert_allclose([tuple(p) for p in points], mesh.vertices, atol=5e-7)
        np.testing.assert_array_equal(facets, mesh.triangles)

    def test_there_and_back_keeps_all_that_single_precision_holds(self):
        mesh = meshes.printable(torus(40, 30))
        back = core_mesh(mesh_object(mesh))
        np.testing.assert_array_equal(back.vertices, mesh.vertices)
        np.testing.assert_array_equal(back.triangles, mesh.triangles)

    def test_a_mesh_that_freecad_made_has_the_volume_of_its_closed_form(self):
        box = core_mesh(Mesh.createBox(2, 3, 4))
        self.assertTrue(meshes.is_closed(box))
        self.assertAlmostEqual(meshes.mesh_volume(box), 24, places=5)

    def test_a_placed_mesh_comes_where_freecad_shows_it(self):
        box = Mesh.createBox(2, 2, 2)
        shown = [tuple(p) for p in box.Topology[0]]
        box.Placement = FreeCAD.Placement(FreeCAD.Vector(10, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        expected = [(10 - y, x, z) for x, y, z in shown]
        np.testing.assert_allclose(core_mesh(box).vertices, expected, atol=1e-5)
        self.assertFalse(box.Placement.isIdentity())

    def test_bodies_that_touch_in_a_vertex_stay_two(self):
        second = meshes.Mesh(TETRAHEDRON.vertices * -1, TETRAHEDRON.triangles[:, ::-1])
        two = meshes.join([TETRAHEDRON, second])
        result = mesh_object(two)
        self.assertEqual((result.CountPoints, result.CountFacets), (8, 8))
        self.assertEqual(meshes.components(core_mesh(result)).max() + 1, 2)

    def test_nothing_stays_nothing(self):
        empty = mesh_object(meshes.Mesh(np.zeros((0, 3)), np.zeros((0, 3), int)))
        self.assertEqual(empty.CountFacets, 0)
        self.assertEqual(len(core_mesh(empty).triangles), 0)

    def test_an_open_mesh_is_taken_as_it_is(self):
        opened = meshes.Mesh(TETRAHEDRON.vertices, TETRAHEDRON.triangles[:3])
        self.assertFalse(mesh_object(opened).isSolid())

    def test_half_a_million_triangles_take_less_than_two_seconds(self):
        import time

        mesh = torus(500, 500)
        start = time.process_time()
        back = core_mesh(mesh_object(mesh))
        self.assertLess(time.process_time() - start, 2.0)  # 0.5 s measured; vectors and tuples take 3 s
        self.assertEqual(len(back.triangles), 500_000)

    def test_a_triangle_that_names_a_vertex_there_is_none_of_is_refused(self):
        with self.assertRaises((KernelError, MeshError, IndexError)):
            mesh_object(meshes.Mesh(TETRAHEDRON.vertices, np.array([[0, 1, 9]])))


if __name__ == "__main__":
    unittest.main()
