# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes: boxes, shapes and files; what is refused, mended, noticed."""

import math
import os
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import MeshPart
import numpy as np
import Part

from freecad_trabecula.core import meshes
from freecad_trabecula.errors import EnvelopeError, ExportError, ParameterError
from freecad_trabecula.geometry.envelopes import box_envelope, envelope_from_shape, load_envelope
from freecad_trabecula.geometry.mesh_solids import MOST_TRIANGLES

Vector = FreeCAD.Vector
ROOT = Path(__file__).resolve().parent.parent.parent
EXAMPLES = ROOT / "resources" / "examples"
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))


def mesh_of(shape, deflection=0.1):
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection, AngularDeflection=0.3, Relative=False)


class InFolder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="trabecula-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def path(self, name):
        return str(self.folder / name)


class Boxes(unittest.TestCase):
    def test_a_box_has_its_volume_centre_and_twelve_triangles(self):
        box = box_envelope(10, 8, 6)
        self.assertAlmostEqual(box.volume, 480, places=9)
        self.assertEqual(len(box.mesh.triangles), 12)
        self.assertAlmostEqual(meshes.mesh_volume(box.mesh), 480, places=9)
        np.testing.assert_allclose(box.centre, [5, 4, 3], atol=1e-12)
        self.assertEqual((box.region.low, box.region.high), ((0, 0, 0), (10, 8, 6)))
        self.assertEqual(box.notes, ())

    def test_faces_are_found_by_number_and_by_alias(self):
        box = box_envelope(10, 8, 6)
        self.assertAlmostEqual(box.face("top").CenterOfMass.z, 6)
        self.assertAlmostEqual(box.face("Face6").CenterOfMass.z, 6)
        self.assertAlmostEqual(box.face("left").CenterOfMass.x, 0)
        self.assertAlmostEqual(box.face("back").CenterOfMass.y, 8)
        self.assertEqual(box.face_names, ("Face1", "Face2", "Face3", "Face4", "Face5", "Face6"))

    def test_points_inside_and_outside_are_told_apart(self):
        box = box_envelope(10, 8, 6)
        points = np.array([[5, 4, 3], [9.99, 0.01, 5.99], [10.01, 4, 3], [5, -0.01, 3], [5, 4, 6.5]])
        self.assertEqual(box.contains(points).tolist(), [True, True, False, False, False])

    def test_an_unknown_face_is_refused_with_the_names_there_are(self):
        for name in ("Face7", "Face0", "lid", "", "face1"):
            with self.assertRaisesRegex(EnvelopeError, "one of Face1..Face6 or left, right, .*got '%s'" % name):
                box_envelope(1, 1, 1).face(name)

    def test_a_size_that_is_zero_negative_or_no_number_is_refused(self):
        for sizes in ((0, 1, 1), (1, -2, 1), (1, 1, float("nan")), (float("inf"), 1, 1)):
            with self.assertRaisesRegex(EnvelopeError, "must be greater than 0 mm"):
                box_envelope(*sizes)


class Shapes(unittest.TestCase):
    def test_triangles_of_curved_bodies_are_closed_and_near_in_volume(self):
        torus, cone, pipe = (
            Part.makeTorus(5, 2),
            Part.makeCone(5, 0, 8),
            Part.makeCylinder(5, 9).cut(Part.makeCylinder(3, 9)),
        )
        cases = ((Part.makeSphere(5), 500 * math.pi / 3), (torus, 40 * math.pi**2), (cone, 200 * math.pi / 3))
        for shape, volume in (*cases, (pipe, 144 * math.pi)):
            envelope = envelope_from_shape(shape, deflection=0.02)
            self.assertTrue(meshes.is_closed(envelope.mesh))
            self.assertAlmostEqual(envelope.volume / volume, 1, places=9)
            self.assertAlmostEqual(meshes.mesh_volume(envelope.mesh) / volume, 1, delta=0.02)

    def test_a_placed_body_keeps_its_place(self):
        sphere = Part.makeCylinder(2, 6)
        sphere.Placement = FreeCAD.Placement(Vector(100, -50, 20), FreeCAD.Rotation(Vector(0, 1, 0), 90))
        envelope = envelope_from_shape(sphere)
        np.testing.assert_allclose(envelope.centre, [103, -50, 20], atol=1e-9)
        np.testing.assert_allclose(envelope.low, [100, -52, 18], atol=1e-9)
        np.testing.assert_allclose(envelope.high, [106, -48, 22], atol=1e-9)
        points = np.array([[105.9, -50, 20], [106.1, -50, 20], [103, -51.9, 20], [103, -52.1, 20]])
        self.assertEqual(envelope.contains(points).tolist(), [True, False, True, False])

    def test_a_cavity_is_outside(self):
        envelope = envelope_from_shape(Part.makeSphere(5).cut(Part.makeSphere(3)))
        self.assertEqual(envelope.contains(np.array([[0, 0, 0], [0, 4, 0], [0, 6, 0]])).tolist(), [False, True, False])
        self.assertAlmostEqual(envelope.volume, 4 * math.pi / 3 * 98, places=6)

    def test_one_solid_in_a_compound_is_taken_without_a_choice(self):
        self.assertEqual(
            envelope_from_shape(Part.Compound([Part.makeBox(1, 2, 3)])).volume, Part.makeBox(1, 2, 3).Volume
        )

    def test_one_of_several_solids_is_chosen_by_name_or_number(self):
        two = Part.Compound([Part.makeBox(10, 10, 10), Part.makeSphere(3, Vector(30, 0, 0))])
        for choice in ("Solid2", 2, "2"):
            self.assertAlmostEqual(envelope_from_shape(two, choice).volume, 36 * math.pi, places=6)

    def test_aliases_name_faces(self):
        envelope = envelope_from_shape(Part.makeBox(1, 2, 3), aliases={"A": "Face6", "E": "Face5"})
        self.assertAlmostEqual(envelope.face("A").CenterOfMass.z, 3)
        with self.assertRaisesRegex(EnvelopeError, "or A, E, got 'B'"):
            envelope.face("B")

    def test_a_solid_that_is_inside_out_is_turned_and_that_is_said(self):
        envelope = envelope_from_shape(Part.makeBox(2, 3, 4).reversed())
        self.assertAlmostEqual(envelope.volume, 24, places=9)
        self.assertAlmostEqual(meshes.mesh_volume(envelope.mesh), 24, places=9)
        self.assertRegex(envelope.notes[0], "inside out .*-24 mm3.* turned")
        self.assertEqual(tuple(envelope.face("Face6").normalAt(0, 0)), (0, 0, 1))

    def test_tiny_and_huge_bodies_are_noticed(self):
        self.assertRegex(envelope_from_shape(Part.makeBox(0.4, 0.1, 0.1)).notes[0], "only 0.4 mm large.*metres")
        self.assertRegex(envelope_from_shape(Part.makeBox(400000, 9, 9)).notes[0], "4e\\+05 mm large.*micrometres")
        self.assertEqual(envelope_from_shape(Part.makeBox(999, 9, 9)).notes, ())


class Files(InFolder):
    def test_step_iges_and_brep_give_the_same_body(self):
        body = Part.makeBox(10, 20, 30).cut(Part.makeBox(4, 4, 30, Vector(3, 8, 0)))
        body.exportStep(self.path("b.step"))
        body.exportIges(self.path("b.igs"))
        body.exportBrep(self.path("b.brep"))
        for name in ("b.step", "b.igs", "b.brep"):
            envelope = load_envelope(self.path(name))
            self.assertAlmostEqual(envelope.volume, 5520, places=6)
            self.assertEqual(len(envelope.face_names), 10)
        self.assertRegex(load_envelope(self.path("b.igs")).notes[0], "10 faces were sewn to a solid")

    def test_splines_survive_iges(self):
        body = Part.Shape()
        body.read(str(EXAMPLES / "femur_metaphysis.step"))
        body.exportIges(self.path("f.iges"))
        envelope = load_envelope(self.path("f.iges"))
        self.assertAlmostEqual(envelope.volume / body.Volume, 1, delta=1e-5)
        self.assertEqual(len(envelope.face_names), 4)

    def test_iges_faces_that_bound_no_body_are_refused(self):
        Part.Compound(Part.makeBox(1, 2, 3).Faces[:5]).exportIges(self.path("open.igs"))
        with self.assertRaisesRegex(EnvelopeError, "must bound a closed body; these 5 do not"):
            load_envelope(self.path("open.igs"))

    def test_units_of_a_step_file_become_millimetres(self):
        Part.makeBox(10, 20, 30).exportStep(self.path("mm.step"))
        text = Path(self.path("mm.step")).read_text()
        self.assertIn("SI_UNIT(.MILLI.,.METRE.)", text)
        Path(self.path("cm.step")).write_text(text.replace("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT(.CENTI.,.METRE.)"))
        np.testing.assert_allclose(load_envelope(self.path("cm.step")).high, [100, 200, 300], atol=1e-6)

    def test_meshes_become_solids_with_whole_plane_faces(self):
        body = Part.makeBox(10, 20, 30).cut(Part.makeBox(5, 5, 30))
        for name in ("b.stl", "b.obj", "b.ply"):
            mesh_of(body).write(self.path(name))
            envelope = load_envelope(self.path(name))
            self.assertAlmostEqual(envelope.volume, 5250, places=6)
            self.assertEqual(len(envelope.face_names), 8)

    def test_a_mesh_of_a_body_with_a_cavity_keeps_it(self):
        mesh_of(Part.makeBox(10, 10, 10).cut(Part.makeBox(2, 2, 2, Vector(4, 4, 4)))).write(self.path("b.stl"))
        self.assertAlmostEqual(load_envelope(self.path("b.stl")).volume, 992, places=6)

    def test_one_of_two_bodies_in_a_mesh_file_is_chosen(self):
        mesh = mesh_of(Part.makeBox(10, 10, 10))
        mesh.addMesh(mesh_of(Part.makeBox(1, 2, 3, Vector(20, 0, 0))))
        mesh.write(self.path("b.stl"))
        with self.assertRaisesRegex(EnvelopeError, "one solid of 2 must be chosen.*Solid2 \\(1 x 2 x 3 mm, 6 mm3\\)"):
            load_envelope(self.path("b.stl"))
        self.assertAlmostEqual(load_envelope(self.path("b.stl"), "Solid2").volume, 6, places=6)

    def test_a_mesh_that_is_inside_out_is_turned_and_that_is_said(self):
        mesh = mesh_of(Part.makeBox(2, 3, 4))
        mesh.flipNormals()
        mesh.write(self.path("b.stl"))
        envelope = load_envelope(self.path("b.stl"))
        self.assertAlmostEqual(envelope.volume, 24, places=6)
        self.assertRegex(envelope.notes[0], "mesh was inside out")

    def test_the_anatomical_examples_are_envelopes(self):
        for name, faces in (("cranial_plate.step", 12), ("femur_metaphysis.step", 4)):
            envelope = load_envelope(EXAMPLES / name)
            self.assertEqual((len(envelope.face_names), envelope.notes), (faces, ()))
            self.assertAlmostEqual(meshes.mesh_volume(envelope.mesh) / envelope.volume, 1, delta=2e-3)
            self.assertTrue(envelope.contains(envelope.centre[None])[0])


class RefusedShapes(unittest.TestCase):
    def test_a_body_that_is_too_large_or_too_long_for_its_width_is_refused_before_the_kernel_fails(self):
        for sizes, message in (
            ((1e12, 10, 10), "at most 1e\\+06 mm large, got 1e\\+12 mm"),
            ((1e5, 0.5, 1), "at most 100000 times its least, got 1e\\+05 and 0.5 mm"),
        ):
            with self.assertRaisesRegex(EnvelopeError, message):
                envelope_from_shape(Part.makeBox(*sizes))

    def refuse(self, shape, pattern, solid=None):
        with self.assertRaisesRegex(EnvelopeError, pattern):
            envelope_from_shape(shape, solid)

    def test_an_empty_shape(self):
        self.refuse(Part.Shape(), "must have a shape, got an empty one")

    def test_a_closed_shell(self):
        self.refuse(Part.makeBox(1, 2, 3).Shells[0], "got a shell of 6 faces and no solid \\(closed: make a solid")

    def test_a_face(self):
        self.refuse(Part.makeBox(1, 2, 3).Faces[0], "one closed solid, got a face of 1 faces")

    def test_an_open_solid(self):
        self.refuse(Part.Solid(Part.Shell(Part.makeBox(1, 1, 1).Faces[:5])), "closed solid, got an open one of 5 faces")

    def test_several_solids_are_listed_with_their_sizes(self):
        two = Part.Compound([Part.makeBox(10, 10, 10), Part.makeSphere(3, Vector(30, 0, 0))])
        self.refuse(two, "Solid1 \\(10 x 10 x 10 mm, 1000 mm3\\), Solid2 \\(6 x 6 x 6 mm, 113.1 mm3\\)")

    def test_a_solid_that_is_not_there(self):
        two = Part.Compound([Part.makeBox(10, 10, 10), Part.makeSphere(3, Vector(30, 0, 0))])
        for choice in ("Solid3", "implant", 0, "-1"):
            self.refuse(two, "one of Solid1..Solid2, got", choice)

    def test_a_solid_whose_outline_crosses_itself(self):
        corners = [Vector(0, 0, 0), Vector(10, 10, 0), Vector(10, 0, 0), Vector(0, 10, 0), Vector(0, 0, 0)]
        self.refuse(
            Part.Face(Part.makePolygon(corners)).extrude(Vector(0, 0, 5)), "valid solid.*self-intersecting wire"
        )

    def test_a_solid_whose_faces_cross_although_the_kernel_calls_it_valid(self):
        # A pipe of radius 2.5 whose way back is 3 mm from its way out.
        path = Part.makePolygon([Vector(0, 0, 0), Vector(20, 0, 0), Vector(20, 3, 0), Vector(0, 3, 0)])
        ring = Part.Wire(Part.makeCircle(2.5, Vector(), Vector(1, 0, 0)))
        pipe = path.makePipeShell([ring], True, True, 2)
        self.assertTrue(pipe.isValid())
        self.refuse(pipe, "must not cross itself; \\d+ pairs .* longest crossing is .* mm at \\(")

    def test_a_spindle_torus(self):
        self.refuse(Part.makeTorus(2, 3), "must not cross itself")

    def test_a_negative_deflection(self):
        with self.assertRaisesRegex(ParameterError, "deflection must be 0 mm or more, got -1 mm"):
            envelope_from_shape(Part.makeBox(1, 1, 1), deflection=-1)


class RefusedFiles(InFolder):
    def test_a_file_that_is_not_there(self):
        with self.assertRaisesRegex(ExportError, "must be readable, got .*none.step"):
            load_envelope(self.path("none.step"))

    def test_a_file_of_another_kind(self):
        with self.assertRaisesRegex(EnvelopeError, "must end in one of .step, .*, got 'bone.dxf'"):
            load_envelope(self.path("bone.dxf"))

    def test_files_that_hold_something_else(self):
        for name in ("a.step", "a.igs", "a.brep", "a.stl", "a.obj", "a.ply"):
            for content in ("", "nonsense\n"):
                Path(self.path(name)).write_text(content)
                with self.assertRaises(EnvelopeError, msg=name):
                    load_envelope(self.path(name))

    def test_a_mesh_of_too_many_triangles_is_refused_with_the_limit(self):
        path = DATA / "anatomy" / "FemurR.stl"
        if not path.is_file():
            self.skipTest(f"{path} is not there")
        with self.assertRaisesRegex(EnvelopeError, f"at most {MOST_TRIANGLES} triangles to become a solid, got 14694"):
            load_envelope(path)

    def test_a_mesh_in_metres_is_noticed(self):
        mesh = mesh_of(Part.makeBox(10, 20, 30))
        mesh.transform(FreeCAD.Matrix(0.001, 0, 0, 0, 0, 0.001, 0, 0, 0, 0, 0.001, 0, 0, 0, 0, 1))
        mesh.write(self.path("b.stl"))
        self.assertRegex(load_envelope(self.path("b.stl")).notes[0], "only 0.03 mm large: was its file in metres")
