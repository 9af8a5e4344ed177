# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of results as files and back."""

import sys
import tempfile
import unittest
from collections import namedtuple
from pathlib import Path

import FreeCAD
import Mesh
import numpy as np
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import small_job

from freecad_trabecula.errors import ExportError
from freecad_trabecula.features import packing
from freecad_trabecula.features.network import Rods
from freecad_trabecula.geometry.design import make_design


class PackingTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def there_and_back(self, value):
        place = Path(self.folder.name) / "value"
        packing.write_value(value, place)
        return packing.read_value(place)

    def test_a_wireframe_comes_back_bit_by_bit(self):
        wireframe = make_design(small_job(kind="box")).wireframe
        back = self.there_and_back(wireframe)
        self.assertEqual(back.keys(), wireframe.keys())
        self.assertEqual(back.names, wireframe.names)
        self.assertEqual(back.rows, wireframe.rows)
        self.assertEqual(list(back.sites), list(wireframe.sites))
        for face, sites in wireframe.sites.items():
            self.assertTrue((back.sites[face].points == sites.points).all())
            self.assertEqual(back.sites[face].on.dtype, bool)

    def test_shapes_meshes_and_numbers_come_back(self):
        box = Part.makeBox(1, 2, 3, FreeCAD.Vector(0.1, 0.2, 0.3))
        mesh = Mesh.createSphere(2.0, 12)
        rods = Rods(("k",), ("n",), Part.makeCompound([box]), np.array([6.0]), np.array([6.0]))
        back, again, facts = self.there_and_back((rods, mesh, {"a": [1, 2.5, None, True, "x", np.int64(3)]}))
        self.assertEqual((back.keys, back.names), (("k",), ("n",)))
        self.assertAlmostEqual(back.compound.Solids[0].Volume, 6.0, 12)
        self.assertEqual(back.compound.Solids[0].BoundBox.XMin, box.BoundBox.XMin)
        self.assertEqual((again.CountPoints, again.CountFacets), (mesh.CountPoints, mesh.CountFacets))
        self.assertEqual(facts, {"a": [1, 2.5, None, True, "x", 3]})

    def test_only_our_own_classes_are_packed_and_unpacked(self):
        with self.assertRaisesRegex(ExportError, "must be of classes of freecad_trabecula"):
            self.there_and_back(namedtuple("Foreign", "a")(1))
        place = Path(self.folder.name) / "value"
        packing.write_value((1, 2), place)
        (place / "value.json").write_text('{"class": "os:system", "fields": {}}', encoding="utf-8")
        with self.assertRaisesRegex(ExportError, "got 'os:system'"):
            packing.read_value(place)

    def test_a_wireframe_becomes_a_text_and_numbers_and_comes_back_bit_by_bit(self):
        wireframe = make_design(small_job(kind="box")).wireframe
        text, numbers = packing.to_numbers(wireframe)
        self.assertTrue(all(type(number) is float for number in numbers))
        back = packing.from_numbers(text, numbers)
        self.assertEqual(back.keys(), wireframe.keys())
        self.assertEqual((back.names, back.rows), (wireframe.names, wireframe.rows))
        self.assertEqual(back.sites["Face1"].index.dtype, wireframe.sites["Face1"].index.dtype)

    def test_texts_of_another_version_are_refused(self):
        text, numbers = packing.to_numbers(make_design(small_job()).wireframe)
        for other, some in (
            (text.replace('"paths"', '"ways"'), numbers),
            (text.replace("core.wireframe:", "core.gone:"), numbers),
            (text, numbers[:-5]),
            (text[:-5], numbers),
            ("", []),
        ):
            with self.assertRaisesRegex(ExportError, "value of this version"):
                packing.from_numbers(other, some)
        with self.assertRaisesRegex(ExportError, "must be numbers, texts"):
            packing.to_numbers(Part.makeBox(1, 1, 1))
