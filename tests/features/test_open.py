# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that earlier releases saved open, compute, can be edited and saved again, on every FreeCAD."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

import FreeCAD

sys.path.append(str(Path(__file__).resolve().parent))

from freecad_trabecula import make
from freecad_trabecula.features import results
from freecad_trabecula.features.feature import is_a

FILES = sorted((Path(__file__).resolve().parents[1] / "data").glob("*.FCStd"))
SEEN = ("Rods", "Count", "Porosity", "RodVolume", "ScaffoldVolume", "Facets", "Edits", "Failed", "Seed", "PoreSizes")


def state(document):
    """Return what a user sees of our objects: the properties that are neither keys nor times."""
    found = {}
    for obj in document.Objects:
        for name in SEEN if is_a(obj) else ():
            if hasattr(obj, name):
                value = getattr(obj, name)
                found[obj.Name, name] = round(value.Value, 6) if hasattr(value, "Value") else value
    return found


class OpenTest(unittest.TestCase):
    def setUp(self):
        results.clear()
        self.assertTrue(FILES)
        self.documents = []

    def tearDown(self):
        for name in self.documents:
            FreeCAD.closeDocument(name)

    def open(self, path):
        document = FreeCAD.openDocument(str(path))
        self.documents.append(document.Name)
        return document

    def test_each_opens_with_every_object_whole_and_nothing_is_computed_again(self):
        for path in FILES:
            with self.subTest(file=path.name):
                document = self.open(path)
                ours = [obj for obj in document.Objects if is_a(obj)]
                self.assertGreaterEqual(len({obj.Proxy.Type for obj in ours}), 7)
                before = state(document)
                document.recompute(None, True)
                self.assertEqual([obj.Label for obj in document.Objects if not obj.isValid()], [])
                self.assertEqual([obj.Label for obj in ours if not getattr(obj, "UpToDate", True)], [])
                self.assertEqual(state(document), before)
                self.assertEqual([kind for kind, _ in results._kept if kind in ("network", "scaffold", "solid")], [])

    def test_each_can_be_edited_and_only_what_is_touched_is_built(self):
        for path in FILES:
            with self.subTest(file=path.name):
                document = self.open(path)
                network = document.getObject("Network")
                rods = network.Rods
                make.set_pore(network.Wireframe, "Face3.1.1", 0.45)
                document.recompute()
                self.assertEqual((network.Rods, network.Rebuilt, network.isValid()), (rods, 1, True))

    def test_each_is_saved_again_as_it_was(self):
        for path in FILES:
            with self.subTest(file=path.name), tempfile.TemporaryDirectory() as folder:
                document = self.open(path)
                before = state(document)
                document.saveCopy(os.path.join(folder, "again.FCStd"))
                results.clear()
                self.assertEqual(state(self.open(os.path.join(folder, "again.FCStd"))), before)


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
