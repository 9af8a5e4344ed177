# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a design, and layers on faces of its envelope."""

import math
import unittest

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.job import Job
from freecad_trabecula.core.laws import constant
from freecad_trabecula.core.parameters import (
    Coupling,
    FaceParameters,
    LayerParameters,
    PathParameters,
    PoreParameters,
    PrismParameters,
    ScaffoldParameters,
)
from freecad_trabecula.errors import EnvelopeError
from freecad_trabecula.geometry.cutting import face_patch, labelled, make_bodies
from freecad_trabecula.geometry.design import make_design

SPACING = {"c_u": 2.5, "c_v": 2.5, "b_u": 1.0, "b_v": 1.0}
#: 9 round channels of 0.5 mm straight through a 10 mm cube, from its bottom to its top.
JOB = Job(
    prism=PrismParameters(),
    faces=(FaceParameters("Face5", "bottom", **SPACING), FaceParameters("Face6", "top", **SPACING)),
    pores=PoreParameters("circle", constant(0.5), sections=1),
    path=PathParameters("orthogonal"),
    couplings=(Coupling("bottom", "top", "same"),),
)
CHANNEL = math.pi / 16 * 10  # mm3


@unittest.skipUnless(manifold_available(), "manifold3d is not installed: nothing that needs mesh Booleans is tested")
class MakeBodiesTest(unittest.TestCase):
    def bodies(self, **layers):
        found = make_design(JOB)
        scaffold = ScaffoldParameters(layers=LayerParameters(**layers))
        return make_bodies(JOB.wireframe, found.wireframe, found.envelope, found.faces, scaffold)

    def test_channels_and_scaffold_have_their_closed_forms(self):
        bodies = self.bodies()
        self.assertTrue(bodies.ok)
        self.assertAlmostEqual(bodies.parts.channel_volume, 9 * CHANNEL, 6)
        self.assertAlmostEqual(bodies.porosity, 9 * CHANNEL / 1000, 9)

    def test_a_closed_layer_shortens_the_channels_by_its_thickness(self):
        for name in ("top", "Face6"):  # by its label or by FreeCAD's name
            bodies = self.bodies(faces=(name,), thickness=1.5)
            self.assertTrue(bodies.ok)
            self.assertAlmostEqual(bodies.parts.channel_volume, 9 * CHANNEL * 0.85, 6)

    def test_a_layer_outwards_adds_its_volume_and_open_ones_lengthen_the_channels(self):
        bodies = self.bodies(faces=("top",), thickness=2.0, side="outwards", closed=False)
        self.assertTrue(bodies.ok)
        self.assertAlmostEqual(bodies.added_volume, 200, 6)
        self.assertAlmostEqual(bodies.parts.channel_volume, 9 * CHANNEL * 1.2, 6)
        bodies = self.bodies(faces=("top",), thickness=2.0, side="outwards", closed=True)
        self.assertAlmostEqual(bodies.parts.channel_volume, 9 * CHANNEL, 6)

    def test_a_layer_on_a_face_that_is_not_there_is_refused(self):
        with self.assertRaisesRegex(EnvelopeError, "got 'lid'"):
            self.bodies(faces=("lid",))


class LayersTest(unittest.TestCase):
    def test_faces_with_sites_go_by_their_labels_once(self):
        found = make_design(JOB)
        layers = LayerParameters(("Face6", "Face1", "top"))
        self.assertEqual(labelled(layers, found.faces, found.envelope).faces, ("top", "Face1"))

    def test_normals_of_patches_point_out_of_the_solid_on_every_kind_of_face(self):
        pit = Part.makeBox(10, 10, 10).cut(Part.makeSphere(3, FreeCAD.Vector(5, 5, 10)))
        for solid in (pit, Part.makeCylinder(2, 5), Part.makeCone(2, 1, 4), Part.makeTorus(4, 1), Part.makeSphere(2)):
            for face in solid.Faces:
                patch = face_patch(face, 0.05)
                self.assertLess(np.abs(np.linalg.norm(patch.normals, axis=1) - 1).max(), 1e-9)
                for point, normal in zip(patch.vertices[:50], patch.normals[:50]):
                    ahead = FreeCAD.Vector(*(point + 1e-3 * normal))
                    behind = FreeCAD.Vector(*(point - 1e-3 * normal))
                    inside = [solid.isInside(p, 1e-6, True) for p in (ahead, behind)]
                    # on a sharp border both may be outside, never the one ahead inside and the one behind outside
                    self.assertNotEqual(inside, [True, False])
