# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that earlier releases saved open, compute, can be edited and saved again, on every FreeCAD.

``save_fixture.py`` made them; those that end in ``-freecad1`` were saved by FreeCAD 1.1.
"""

import os
import sys
import tempfile
import unittest
from pathlib import Path

import FreeCAD

sys.path.append(str(Path(__file__).resolve().parent))

from opened_files import FILES, assert_same, state

from freecad_trabecula import make
from freecad_trabecula.features import results
from freecad_trabecula.features.feature import Feature, is_a
from freecad_trabecula.features.migrations import SCHEMA_VERSION

#: Kinds of objects that one file of a release at least holds.
KINDS = frozenset(
    ["PrismSites", "FaceSites", "Wireframe", "Network", "Scaffold", "Body", "SolidScaffold", "Analysis", "VoxelDesign"]
)


class OpenTest(unittest.TestCase):
    def setUp(self):
        results.clear()
        self.documents = []

    def tearDown(self):
        for name in self.documents:
            FreeCAD.closeDocument(name)

    def open(self, path):
        document = FreeCAD.openDocument(str(path))
        self.documents.append(document.Name)
        return document

    def test_the_files_of_a_release_hold_every_kind_of_object_and_are_small(self):
        found = set()
        for path in FILES:
            self.assertLess(path.stat().st_size, 300e3, path.name)
            found |= {type(obj.Proxy).__name__ for obj in self.open(path).Objects if is_a(obj)}
        self.assertEqual(found, KINDS)
        every = {cls.__name__ for cls in all_classes(Feature) if cls.Type and cls.__module__.startswith("freecad_")}
        self.assertEqual(every, KINDS)

    def test_each_opens_with_every_object_whole_and_nothing_is_computed_again(self):
        for path in FILES:
            with self.subTest(file=path.name):
                document = self.open(path)
                ours = [obj for obj in document.Objects if is_a(obj)]
                self.assertEqual({obj.SchemaVersion for obj in ours}, {SCHEMA_VERSION})
                before = state(document)
                self.assertGreater(len(before), 10)
                document.recompute(None, True)
                self.assertEqual([obj.Label for obj in document.Objects if not obj.isValid()], [])
                self.assertEqual([obj.Label for obj in ours if not getattr(obj, "UpToDate", True)], [])
                assert_same(self, state(document), before)
                made = ("network", "scaffold", "solid", "analysis", "voxels")
                self.assertEqual([kind for kind, _ in results._kept if kind in made], [])

    def test_each_computed_anew_gives_the_numbers_that_its_file_holds(self):
        for path in FILES:
            with self.subTest(file=path.name):
                document = self.open(path)
                before = state(document)
                results.clear()
                for obj in document.Objects:
                    if hasattr(obj, "RodKeys"):
                        obj.RodKeys = []
                    if hasattr(obj, "ResultKey"):
                        obj.ResultKey = ""
                for obj in [one for one in document.TopologicalSortedObjects[::-1] if is_a(one)]:
                    make.update(obj)
                assert_same(self, state(document), before)

    def test_each_can_be_edited_and_only_what_is_touched_is_built(self):
        for path in [one for one in FILES if one.name.startswith("prism")]:
            with self.subTest(file=path.name):
                document = self.open(path)
                network = document.getObject("Network")
                rods = network.Rods
                make.set_pore(network.Wireframe, "Face3.1.1", 0.45)
                document.recompute()
                self.assertEqual((network.Rods, network.Rebuilt, network.isValid()), (rods, 1, True))

    def test_an_expression_of_a_file_goes_on_driving_its_design(self):
        for path in [one for one in FILES if one.name.startswith("anatomical")]:
            with self.subTest(file=path.name):
                document = self.open(path)
                wireframe = document.getObject("Wireframe")
                self.assertEqual(wireframe.Seed, 11)
                document.getObject("Table").set("A1", "=5")
                document.recompute()
                self.assertEqual((wireframe.Seed, wireframe.isValid()), (7, True))

    def test_each_is_saved_again_as_it_was(self):
        for path in FILES:
            with self.subTest(file=path.name), tempfile.TemporaryDirectory() as folder:
                document = self.open(path)
                before = state(document)
                document.saveCopy(os.path.join(folder, "again.FCStd"))
                results.clear()
                assert_same(self, state(self.open(os.path.join(folder, "again.FCStd"))), before)


def all_classes(cls):
    """Return all classes made of a class."""
    found = cls.__subclasses__()
    return found + [deeper for one in found for deeper in all_classes(one)]


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
