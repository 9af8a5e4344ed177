# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fingerprints: equal for equal shapes, whatever way they went, and for no others."""

import tempfile
import unittest
from pathlib import Path

import FreeCAD
import Part

from freecad_trabecula.geometry.fingerprints import fingerprint


class FingerprintTest(unittest.TestCase):
    def test_equal_shapes_have_one_and_others_another(self):
        box = Part.makeBox(1, 2, 3)
        moved = Part.makeBox(1, 2, 3, FreeCAD.Vector(0, 0, 1e-3))
        marks = {
            fingerprint(s) for s in (box, moved, Part.makeBox(1, 2, 3.001), Part.makeSphere(1), Part.makeSphere(2))
        }
        self.assertEqual(len(marks), 5)
        self.assertEqual(fingerprint(Part.makeBox(1, 2, 3)), fingerprint(box))

    def test_one_pole_of_a_surface_makes_a_difference(self):
        face = Part.makeSphere(1).toNurbs().Faces[0]
        surface = face.Surface
        mark = fingerprint(face)
        surface.setPole(2, 2, surface.getPole(2, 2) + FreeCAD.Vector(0, 0, 1e-4))
        self.assertNotEqual(fingerprint(surface.toShape()), mark)

    def test_it_survives_the_text_of_a_brep_and_its_binary_form(self):
        shape = Part.makeCylinder(1.1, 2.3).fuse(Part.makeBox(3, 3, 0.7)).removeSplitter()
        for write, read in (("exportBrep", "importBrep"), ("exportBinary", "importBinary")):
            with tempfile.TemporaryDirectory() as folder:
                path = str(Path(folder) / "shape")
                getattr(shape, write)(path)
                again = Part.Shape()
                getattr(again, read)(path)
            self.assertEqual(fingerprint(again), fingerprint(shape))
