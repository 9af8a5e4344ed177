# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of properties in docs/documents.md are those of the code; tools/properties_page.py makes them."""

import importlib.util
import sys
import unittest
from pathlib import Path

import FreeCAD

ROOT = Path(__file__).resolve().parents[2]


class DocumentsPageTest(unittest.TestCase):
    def setUp(self):
        sys.path.insert(0, str(ROOT / "tools"))
        self.addCleanup(sys.path.remove, str(ROOT / "tools"))
        specification = importlib.util.spec_from_file_location("page", str(ROOT / "tools" / "properties_page.py"))
        self.page = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(self.page)
        self.addCleanup(lambda: [FreeCAD.closeDocument(name) for name in list(FreeCAD.listDocuments())])

    def test_every_property_stands_in_its_table(self):
        tables = (ROOT / "docs" / "documents.md").read_text(encoding="utf-8").split(self.page.MARKS[0])[1]
        document = FreeCAD.newDocument("Page")
        for module, name, kind in self.page.OBJECTS:
            heading, _, rows = self.page.rows_of(document, module, name, kind)
            self.assertIn(heading, tables)
            for row in rows:
                self.assertIn(row, tables, f"{name}: run python3 tools/properties_page.py")


if FreeCAD.GuiUp:
    raise unittest.SkipTest("runs in the console")
