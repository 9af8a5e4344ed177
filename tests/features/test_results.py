# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results by keys: found again, handed over as files, refused when they are not whole."""

import json
import sys
import tempfile
import unittest
from collections import namedtuple
from dataclasses import replace
from pathlib import Path

import FreeCAD
import Mesh
import numpy as np
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import small_job

from freecad_trabecula.errors import ExportError
from freecad_trabecula.features import packing, results
from freecad_trabecula.features.network import Rods
from freecad_trabecula.geometry.design import make_design
from freecad_trabecula.geometry.fingerprints import fingerprint


class KeysTest(unittest.TestCase):
    def setUp(self):
        results.clear()

    def test_equal_inputs_have_equal_keys_and_any_change_another(self):
        job = small_job()
        keys = {
            results.key_of("a", job),
            results.key_of("b", job),
            results.key_of("a", replace(job, seed=2)),
            results.key_of("a", replace(job, pores=replace(job.pores, scatter=1e-12))),
            results.key_of("a", [job]),
        }
        self.assertEqual(len(keys), 5)
        self.assertEqual(results.key_of("a", small_job()), results.key_of("a", job))

    def test_a_result_is_made_once(self):
        made = []
        for _ in range(3):
            results.found_or_made("wireframe", "k", lambda: made.append(1) or "value")
        self.assertEqual((len(made), results.find("wireframe", "k")), (1, "value"))
        self.assertIsNone(results.find("network", "k"))

    def test_the_oldest_of_a_kind_go_and_those_used_last_stay(self):
        for k in range(30):
            results.keep("network", str(k), k)
            results.find("network", "0")
        self.assertEqual(results.find("network", "0"), 0)
        self.assertEqual(results.find("network", "29"), 29)
        self.assertIsNone(results.find("network", "5"))

    def test_an_error_while_making_is_passed_on_and_nothing_is_kept(self):
        with self.assertRaises(ZeroDivisionError):
            results.found_or_made("network", "k", lambda: 1 // 0)
        self.assertIsNone(results.find("network", "k"))


class FilesTest(unittest.TestCase):
    def setUp(self):
        results.clear()
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

    def test_results_are_found_again_by_their_keys(self):
        results.keep("wireframe", "w", (1, 2))
        results.keep("scaffold", "s", {"porosity": 0.5})
        results.save(self.folder.name, ("wireframe", "w"), ("scaffold", "s"))
        results.clear()
        self.assertEqual(results.load(self.folder.name), 2)
        self.assertEqual(results.find("wireframe", "w"), (1, 2))
        self.assertEqual(results.find("scaffold", "s"), {"porosity": 0.5})

    def test_half_written_results_are_refused(self):
        with self.assertRaisesRegex(ExportError, "written to the end"):
            results.load(self.folder.name)
        results.keep("wireframe", "w", np.arange(3))
        results.save(self.folder.name, ("wireframe", "w"))
        (Path(self.folder.name) / "0-wireframe" / "arrays.npz").unlink()
        with self.assertRaisesRegex(ExportError, "written to the end"):
            results.load(self.folder.name)
        index = json.loads((Path(self.folder.name) / "results.json").read_text())
        self.assertEqual([one["kind"] for one in index], ["wireframe"])


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
