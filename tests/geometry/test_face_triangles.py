# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of curved bodies by our own rules: closed, near the surface, face by face."""

import math
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.core import meshes
from freecad_trabecula.core.face_meshes import facing
from freecad_trabecula.errors import DependencyError, KernelError
from freecad_trabecula.geometry.border_samples import BorderSamples
from freecad_trabecula.geometry.face_triangles import plane_axes, solid_triangles
from freecad_trabecula.geometry.tessellation import ANGULAR_DEFLECTION, default_deflection, tessellate

Vector = FreeCAD.Vector
EXAMPLES = Path(__file__).resolve().parent.parent.parent / "resources" / "examples"
X, Y = Vector(1, 0, 0), Vector(0, 1, 0)


def wavy_block():
    """A block under a spline surface, 20 mm wide."""
    rows = [
        [Vector(x, y, 6 + math.sin(x / 3 + 1) * math.cos(y / 4 + 1)) for y in range(0, 21, 2)] for x in range(0, 21, 2)
    ]
    top = Part.BSplineSurface()
    top.interpolate(rows)
    return top.toShape().extrude(Vector(0, 0, -8)).common(Part.makeBox(20, 20, 20))


def bodies():
    """Solids by name: whole surfaces, trimmed ones, with seams and poles, holes, fillets, splines, bones."""
    box = Part.makeBox(20, 20, 8)
    found = {
        "cylinder": Part.makeCylinder(5, 10),
        "part of a cylinder": Part.makeCylinder(5, 10, Vector(1, 2, 3), X, 200),
        "sphere": Part.makeSphere(5),
        "cone": Part.makeCone(5, 0, 3),
        "blunt cone": Part.makeCone(5, 2, 3),
        "torus": Part.makeTorus(5, 2),
        "eighth of a sphere": Part.makeSphere(5).common(Part.makeBox(10, 10, 10)),
        "plate with a hole": box.cut(Part.makeCylinder(4, 8, Vector(10, 10, 0))),
        "rounded box": box.makeFillet(2, box.Edges),
        "cylinder with a hole across": Part.makeCylinder(5, 20).cut(Part.makeCylinder(2, 20, Vector(-10, 0, 10), X)),
        "spline block": wavy_block(),
        "round spline plate": wavy_block().common(Part.makeCylinder(7, 20, Vector(10, 10, 0))),
        "spline plate with a hole": wavy_block().cut(Part.makeCylinder(3, 20, Vector(9, 11, 0))),
    }
    for name in ("cranial_plate", "femur_metaphysis"):
        shape = Part.Shape()
        shape.read(str(EXAMPLES / f"{name}.step"))
        found[name] = shape
    return {name: shape.Solids[0] for name, shape in found.items()}


BODIES = bodies()


def own(solid, deflection=0.0):
    return solid_triangles(solid, deflection or default_deflection(solid), ANGULAR_DEFLECTION)


class Bodies(unittest.TestCase):
    def test_the_triangles_are_closed_and_have_the_volume(self):
        for name, solid in BODIES.items():
            with self.subTest(name):
                mesh, deflection = own(solid).mesh, default_deflection(solid)
                self.assertTrue(meshes.is_closed(mesh))
                self.assertLess(abs(meshes.mesh_volume(mesh) - solid.Volume), 0.7 * deflection * solid.Area)

    def test_a_quarter_of_the_deflection_leaves_less_than_half_of_the_difference(self):
        for name in ("cylinder", "sphere", "torus", "blunt cone", "cylinder with a hole across", "round spline plate"):
            with self.subTest(name):
                solid, d = BODIES[name], default_deflection(BODIES[name])
                coarse, fine = (abs(meshes.mesh_volume(own(solid, k * d).mesh) - solid.Volume) for k in (1, 0.25))
                self.assertLess(fine, coarse / 2)

    def test_each_face_has_its_own_triangles(self):
        for name, solid in BODIES.items():
            with self.subTest(name):
                mesh, labels = own(solid)
                a, b, c = mesh.corners.transpose(1, 0, 2)
                areas = np.bincount(labels, np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)
                np.testing.assert_allclose(areas, [face.Area for face in solid.Faces], rtol=0.02)

    def test_no_triangle_is_farther_off_round_bodies_than_four_thirds_of_the_deflection(self):
        share = np.array([[1, 1, 1], [1, 1, 0], [0, 1, 1], [1, 0, 1]]) / np.array([[3], [2], [2], [2]])
        for deflection in (0.2, 0.02):
            for name in ("sphere", "torus", "cylinder", "cylinder with a hole across"):
                mesh, labels = own(BODIES[name], deflection)
                curved = isinstance(BODIES[name].Faces[0].Surface, (Part.Cylinder, Part.Sphere, Part.Toroid))
                self.assertTrue(curved)
                x, y, z = (share @ mesh.corners[labels == 0]).reshape(-1, 3).T
                radius = {
                    "sphere": np.sqrt(x * x + y * y + z * z),
                    "torus": np.hypot(np.hypot(x, y) - 5, z) + 3,
                }.get(name, np.hypot(x, y))
                self.assertLess(np.abs(radius - 5).max(), deflection * 4 / 3, name)

    def test_a_spline_plate_is_met_within_the_deflection(self):
        solid = BODIES["spline plate with a hole"]
        deflection = 0.05
        mesh = own(solid, deflection).mesh
        middles = mesh.corners.mean(1)
        off = [solid.Shells[0].distToShape(Part.Vertex(*p))[0] for p in middles[::7].tolist()]
        self.assertLess(max(off), deflection)

    def test_no_triangle_is_turned_over(self):
        for name in ("cranial_plate", "round spline plate"):
            mesh, labels = own(BODIES[name])
            for number, face in enumerate(BODIES[name].Faces):
                corners = mesh.corners[labels == number]
                normals = []
                for point in corners.mean(1).tolist():
                    normal = np.array(face.normalAt(*face.Surface.parameter(Vector(*point))))
                    normals.append([normal] * 3)
                cosine = facing(corners, np.array(normals))
                self.assertGreater((cosine * np.sign(cosine.sum())).min(), 0.9)

    def test_a_placed_body_gets_placed_triangles(self):
        solid = Part.makeCylinder(5, 10)
        solid.Placement = FreeCAD.Placement(Vector(100, 0, 0), FreeCAD.Rotation(Y, 90))
        low, high = meshes.bounds(own(solid).mesh)
        np.testing.assert_allclose([low[0], high[0]], [100, 110], atol=1e-9)

    def test_faces_share_the_samples_of_their_edge(self):
        solid = BODIES["cylinder"]
        border = BorderSamples(solid, 0.02, ANGULAR_DEFLECTION)
        circles = [edge for edge in solid.Edges if edge.Closed]
        side, top = (
            next(f for f in solid.Faces if isinstance(f.Surface, kind)) for kind in (Part.Cylinder, Part.Plane)
        )
        shared = next(e for e in circles if any(e.isSame(other) for other in top.Edges))
        of_side = next(e for e in side.Edges if e.isSame(shared))
        np.testing.assert_array_equal(border.of(shared).numbers, border.of(of_side).numbers)
        self.assertEqual(border.of(shared).numbers[0], border.of(shared).numbers[-1])
        np.testing.assert_allclose(np.hypot(*border.vertices[:, :2].T), 5)

    def test_axes_of_a_plane_turn_about_its_normal(self):
        for normal in np.eye(3).tolist() + [[0.6, 0, -0.8]]:
            first, second = plane_axes(np.array(normal))
            np.testing.assert_allclose(np.cross(first, second), normal, atol=1e-12)


class Refusals(unittest.TestCase):
    def test_a_trimmed_face_with_a_kink_inside(self):
        roof = Part.BSplineSurface()
        poles = [[Vector(x, y, 5 - abs(x - 5)) for y in (0, 10)] for x in (0, 5, 10)]
        roof.buildFromPolesMultsKnots(poles, [2, 1, 2], [2, 2], [0, 1, 2], [0, 1], False, False, 1, 1)
        block = roof.toShape().extrude(Vector(0, 0, -20)).common(Part.makeCylinder(3, 60, Vector(5, 5, -30)))
        with self.assertRaisesRegex(KernelError, "must have no kink inside"):
            own(block.Solids[0])

    def test_without_scipy_a_trimmed_face_is_left_to_the_kernel_and_the_note_says_so(self):
        solid = BODIES["cylinder with a hole across"]
        with mock.patch.dict("sys.modules", {"scipy.spatial": None}):
            with self.assertRaisesRegex(DependencyError, "scipy"):
                own(solid)
            mesh, note = tessellate(solid)
        self.assertRegex(note, "triangles are the kernel's.*scipy")
        self.assertTrue(meshes.is_closed(mesh))
        self.assertEqual(tessellate(solid).note, "")
        self.assertEqual(tessellate(Part.makeBox(1, 2, 3)).note, "")

    def test_a_straight_edge_of_a_twisted_face_is_left_to_the_kernel(self):
        saddle = Part.BSplineSurface()
        poles = [[Vector(x, y, x * y / 10) for y in (0, 10)] for x in (0, 10)]
        saddle.buildFromPolesMultsKnots(poles, [2, 2], [2, 2], [0, 1], [0, 1], False, False, 1, 1)
        solid = saddle.toShape().extrude(Vector(0, 0, -5))
        mesh, note = tessellate(solid)
        self.assertTrue(meshes.is_closed(mesh))
        self.assertAlmostEqual(meshes.mesh_volume(mesh), 500, delta=default_deflection(solid) * 600)

    def test_triangles_that_fold_over_are_not_used(self):
        with mock.patch("freecad_trabecula.geometry.face_triangles.facing", return_value=np.array([-1.0])):
            with self.assertRaisesRegex(KernelError, "must not fold over"):
                own(BODIES["sphere"])
            self.assertRegex(tessellate(BODIES["sphere"]).note, "must not fold over")
