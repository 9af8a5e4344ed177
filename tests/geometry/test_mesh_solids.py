# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids from meshes."""

import unittest

import FreeCAD
import Mesh
import MeshPart
import numpy as np
import Part

from freecad_trabecula.errors import EnvelopeError
from freecad_trabecula.geometry.mesh_solids import MOST_TRIANGLES, solids_of_mesh

Vector = FreeCAD.Vector


def mesh_of(shape, deflection=0.1):
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection, AngularDeflection=0.3, Relative=False)


class Solids(unittest.TestCase):
    def test_a_box_gets_its_six_faces_back(self):
        (solid,), notes = solids_of_mesh(mesh_of(Part.makeBox(1, 2, 3)))
        self.assertEqual((len(solid.Faces), solid.isValid(), notes), (6, True, []))
        self.assertAlmostEqual(solid.Volume, 6, places=6)

    def test_a_curved_body_keeps_its_triangles(self):
        mesh = mesh_of(Part.makeSphere(5), 0.5)
        (solid,), _ = solids_of_mesh(mesh)
        self.assertEqual(len(solid.Faces), mesh.CountFacets)

    def test_triangles_without_area_are_left_out(self):
        mesh = mesh_of(Part.makeBox(1, 2, 3))
        corner = Vector(0, 0, 0)
        mesh.addFacet(corner, corner, Vector(1, 0, 0))
        (solid,), _ = solids_of_mesh(mesh)
        self.assertEqual(len(solid.Faces), 6)

    def test_a_cavity_belongs_to_the_body_around_it(self):
        mesh = mesh_of(Part.makeBox(10, 10, 10))
        mesh.addMesh(mesh_of(Part.makeBox(10, 10, 10, Vector(20, 0, 0)).cut(Part.makeBox(2, 2, 2, Vector(24, 4, 4)))))
        solids, _ = solids_of_mesh(mesh)
        np.testing.assert_allclose(sorted(solid.Volume for solid in solids), [992, 1000], atol=1e-6)

    def test_a_mesh_inside_out_is_turned(self):
        mesh = mesh_of(Part.makeBox(1, 2, 3))
        mesh.flipNormals()
        (solid,), notes = solids_of_mesh(mesh)
        self.assertAlmostEqual(solid.Volume, 6, places=6)
        self.assertEqual(notes, ["the mesh was inside out; its triangles have been turned round"])


class Refusals(unittest.TestCase):
    def refuse(self, mesh, pattern):
        with self.assertRaisesRegex(EnvelopeError, pattern):
            solids_of_mesh(mesh)

    def test_no_triangles(self):
        self.refuse(Mesh.Mesh(), "must have triangles, got 0")

    def test_holes_are_counted(self):
        mesh = mesh_of(Part.makeSphere(5), 0.5)
        mesh.removeFacets([3, mesh.CountFacets // 2])
        self.refuse(mesh, "got 2 holes with 6 open edges")

    def test_an_edge_of_four_triangles(self):
        mesh = mesh_of(Part.makeBox(1, 1, 1))
        mesh.addMesh(mesh_of(Part.makeBox(1, 1, 1, Vector(1, 1, 0))))
        self.refuse(mesh, "1 edges of more than two")

    def test_triangles_turned_unevenly(self):
        mesh = mesh_of(Part.makeBox(1, 1, 1))
        facets = [[tuple(p) for p in facet.Points] for facet in mesh.Facets]
        facets[0].reverse()
        self.refuse(Mesh.Mesh(facets), "3 edges of triangles turned unevenly")

    def test_too_many_triangles_are_refused_before_any_work(self):
        mesh = mesh_of(Part.makeSphere(50), 0.02)
        self.assertGreater(mesh.CountFacets, MOST_TRIANGLES)
        self.refuse(mesh, f"at most {MOST_TRIANGLES} triangles to become a solid, got {mesh.CountFacets}: reduce it")
