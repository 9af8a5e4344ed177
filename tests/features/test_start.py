# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's start leaves: the package loaded, so that documents may hold its objects, and the tests announced.

Also that the examples in the docstrings of the modules that need FreeCAD are true.
"""

import doctest
import importlib
import sys
import unittest
from pathlib import Path

import FreeCAD

ROOT = Path(__file__).resolve().parents[2]
OPTIONS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS


class StartTest(unittest.TestCase):
    def test_the_package_is_loaded_so_that_objects_may_be_restored(self):
        self.assertIn("freecad_trabecula", sys.modules)

    def test_the_document_tests_are_announced_to_freecads_test_runner(self):
        self.assertIn("TestTrabecula", FreeCAD.__unit_test__)

    def test_the_announced_tests_are_found_by_name(self):
        suite = unittest.defaultTestLoader.loadTestsFromName("TestTrabecula")
        self.assertGreater(suite.countTestCases(), 3)

    def test_no_window_is_needed_to_import_the_parts_that_make_documents(self):
        for path in sorted((ROOT / "freecad_trabecula").glob("[gfm]*/*.py")) + [ROOT / "freecad_trabecula" / "make.py"]:
            if path.parent.name != "gui" and path.exists():
                with self.subTest(module=path.stem):
                    importlib.import_module(".".join(path.relative_to(ROOT).with_suffix("").parts))
        self.assertFalse(FreeCAD.GuiUp)
        self.assertNotIn("FreeCADGui", sys.modules)


class DocstringExamplesTest(unittest.TestCase):
    def test_the_examples_of_the_modules_that_need_freecad_are_true(self):
        paths = [*ROOT.glob("freecad_trabecula/geometry/*.py"), *ROOT.glob("freecad_trabecula/features/*.py")]
        for path in [*sorted(paths), ROOT / "freecad_trabecula" / "make.py"]:
            if path.exists() and ">>> " in path.read_text(encoding="utf-8"):
                with self.subTest(module=path.stem):
                    module = importlib.import_module(".".join(path.relative_to(ROOT).with_suffix("").parts))
                    result = doctest.testmod(module, optionflags=OPTIONS)
                    self.assertEqual(result.failed, 0)
                for name in FreeCAD.listDocuments():
                    FreeCAD.closeDocument(name)
