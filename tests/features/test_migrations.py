# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of an older schema are brought up when they are opened; what used a renamed property uses its new name."""

import sys
import unittest
from pathlib import Path
from unittest import mock

import FreeCAD

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula.features import migrations
from freecad_trabecula.features.migrations import rename_property
from freecad_trabecula.features.wireframe import Wireframe

#: Name in the older schema, name today.
OLD_NAMES = {"RandomSeed": "Seed", "LargestPore": "PoreSizeHigh", "Law": "PoreSizeLaw", "Slope": "PoreSizeDirection"}


def as_older(obj, names):
    """Give an object's properties the names that they had: what the older version would have written."""
    for old, new in names.items():
        value, kind = getattr(obj, new), obj.getTypeIdOfProperty(new)
        choices = obj.getEnumerationsOfProperty(new) if kind == "App::PropertyEnumeration" else None
        obj.removeProperty(new)
        obj.addProperty(kind, old, "Pores", "As it was called")
        if choices:
            setattr(obj, old, choices)
        setattr(obj, old, value)


def step(obj):
    """Bring a wireframe from that schema to the next."""
    for old, new in OLD_NAMES.items():
        rename_property(obj, old, new)


class MigrationTest(DocumentCase):
    def older_file(self):
        """Save a design of the older schema with expressions of every form, and return its key before."""
        self.document.Label = "Bone"
        design = self.make(small_job())
        wireframe, sheet = design.wireframe, self.document.addObject("Spreadsheet::Sheet", "Sheet")
        wireframe.Label = "The rods"
        sheet.set("A1", "7")
        reader = self.document.addObject("Spreadsheet::Sheet", "Reader")
        other = self.document.addObject("Part::Box", "Other")
        as_older(wireframe, OLD_NAMES)
        self.document.recompute()
        wireframe.setExpression("RandomSeed", "Sheet.A1 + 1")
        wireframe.setExpression("PoreSizeLow", "LargestPore / 2 - .LargestPore / 4")
        wireframe.setExpression("Slope.x", "LargestPore / 1 mm")
        other.setExpression("Length", "Wireframe.LargestPore * 10")
        other.setExpression("Width", "<<The rods>>.LargestPore * 20 + <<The rods>>.PoreSizeLow")
        reader.set("B1", "=Wireframe.LargestPore * 3")
        reader.set("B2", "LargestPore is a word")
        wireframe.SchemaVersion = 1
        return wireframe.LargestPore.Value

    def opened(self):
        """Open the file as the version after would."""
        steps = {1: step}
        self.enterContext_(mock.patch.object(migrations, "SCHEMA_VERSION", 2))
        self.enterContext_(mock.patch.object(Wireframe, "MIGRATIONS", steps))
        document = self.reopened()
        return document, document.getObject("Wireframe")

    def enterContext_(self, context):  # noqa: N802
        """Enter a context until the end of the test; unittest has this since Python 3.11."""
        context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)

    def test_an_older_file_opens_with_new_names_and_old_values(self):
        largest = self.older_file()
        _, wireframe = self.opened()
        self.assertEqual(wireframe.SchemaVersion, 2)
        self.assertEqual([name for name in OLD_NAMES if name in wireframe.PropertiesList], [])
        self.assertEqual(wireframe.PoreSizeHigh.Value, largest)
        self.assertIn("expression", wireframe.getEnumerationsOfProperty("PoreSizeLaw"))
        self.assertEqual(wireframe.getGroupOfProperty("PoreSizeHigh"), "Pores")

    def test_every_expression_that_used_an_old_name_uses_the_new_one_and_gives_the_same(self):
        largest = self.older_file()
        document, wireframe = self.opened()
        engine = {path.lstrip("."): text.replace(" ", "") for path, text in wireframe.ExpressionEngine}
        self.assertEqual(set(engine), {"Seed", "PoreSizeLow", "PoreSizeDirection.x"})
        for _, text in [*wireframe.ExpressionEngine, *document.Other.ExpressionEngine]:
            self.assertNotIn("LargestPore", text)
        self.assertEqual(document.Reader.getContents("B2").lstrip("'"), "LargestPore is a word")
        wireframe.PoreSizeHigh = 0.9
        document.recompute()
        self.assertNotEqual(largest, 0.9)
        self.assertEqual(wireframe.Seed, 8)
        self.assertAlmostEqual(wireframe.PoreSizeLow.Value, 0.225)
        self.assertAlmostEqual(wireframe.PoreSizeDirection.x, 0.9)
        self.assertAlmostEqual(document.Other.Length.Value, 9)
        self.assertAlmostEqual(document.Other.Width.Value, 18.225)
        self.assertAlmostEqual(document.Reader.B1.Value, 2.7)
        self.assertEqual([obj.Label for obj in document.Objects if not obj.isValid()], [])

    def test_an_object_without_a_step_for_a_schema_is_brought_up_too(self):
        self.older_file()
        document, _ = self.opened()
        sites = document.getObject("Sites")
        self.assertEqual((sites.SchemaVersion, sites.Count), (2, 54))

    def test_renaming_what_is_not_there_does_nothing(self):
        wireframe = self.make(small_job()).wireframe
        before = wireframe.PropertiesList
        rename_property(wireframe, "Nowhere", "Seed")
        self.assertEqual(wireframe.PropertiesList, before)


class RenamedTest(unittest.TestCase):
    """Which of the words of an expression mean the property."""

    def setUp(self):
        self.document = FreeCAD.newDocument("T")
        self.addCleanup(FreeCAD.closeDocument, "T")
        self.obj = self.document.addObject("App::FeaturePython", "Rods")
        self.obj.Label = "my > rods"

    def test_words_that_mean_it_are_changed_and_no_others(self):
        cases = {
            "Rods.Size * 2": "Rods.Extent * 2",
            "Rods.Size.x + Rods.Sizes": "Rods.Extent.x + Rods.Sizes",
            "<<my > rods>>.Size": "<<my > rods>>.Extent",
            "T#Rods.Size": "T#Rods.Extent",
            "Other.Size + Rods.Other.Size": "Other.Size + Rods.Other.Size",
            "<<Rods.Size>>": "<<Rods.Size>>",
            "Size + .Size": "Size + .Size",
            "2Size": "2Size",
        }
        for before, after in cases.items():
            self.assertEqual(migrations.renamed(before, self.obj, "Size", "Extent", False), after)

    def test_in_its_own_expressions_the_name_alone_means_it(self):
        cases = {"Size + .Size": "Extent + .Extent", "Other.Size": "Other.Size", "Size.x / 2": "Extent.x / 2"}
        for before, after in cases.items():
            self.assertEqual(migrations.renamed(before, self.obj, "Size", "Extent", True), after)
