# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD itself, and its Addon Manager where it has a reader of its own, read package.xml as it is written."""

import importlib.util
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import FreeCAD

ROOT = Path(__file__).resolve().parents[2]
SPACE = "{https://wiki.freecad.org/Package_Metadata}"


def texts(node, tag):
    """Return the texts of a node's children of a kind."""
    return [child.text for child in node.findall(SPACE + tag)]


class MetadataTest(unittest.TestCase):
    def setUp(self):
        self.path = str(ROOT / "package.xml")
        self.written = ElementTree.parse(self.path).getroot()
        self.bench = self.written.find(f"{SPACE}content/{SPACE}workbench")

    def test_freecad_reads_every_field_as_it_is_written(self):
        read = FreeCAD.Metadata(self.path)
        for tag, value in (
            *(("name", read.Name), ("description", read.Description), ("version", read.Version), ("icon", read.Icon)),
            *(("freecadmin", read.FreeCADMin),),
        ):
            self.assertEqual([str(value)], texts(self.written, tag), tag)
        self.assertEqual([one["name"] for one in read.Maintainer], texts(self.written, "maintainer"))
        self.assertEqual([one["name"] for one in read.License], texts(self.written, "license"))
        self.assertEqual([one["location"] for one in read.Urls], texts(self.written, "url"))
        self.assertEqual(sorted(read.Tag), sorted(texts(self.written, "tag")))
        self.assertEqual([one["package"] for one in read.Depend], texts(self.written, "depend"))
        self.assertTrue(read.supportsCurrentFreeCAD())
        bench = read.Content["workbench"][0]
        self.assertEqual([bench.Name, bench.Classname, bench.Icon], [
            self.bench.findtext(SPACE + tag) for tag in ("name", "classname", "icon")
        ])  # fmt: skip

    def test_the_addon_manager_reads_every_dependency_with_its_kind(self):
        if importlib.util.find_spec("addonmanager_metadata") is None:
            self.assertLess(FreeCAD.Version()[:2], ["1", "0"])  # the Addon Manager of 0.20 uses FreeCAD's reader
            return
        from addonmanager_metadata import DependencyType, MetadataReader, UrlType

        read = MetadataReader.from_file(self.path)
        written = self.written.findall(SPACE + "depend")
        self.assertEqual(
            [(one.package, DependencyType(one.dependency_type).name, one.optional) for one in read.depend],
            [(one.text, one.get("type"), one.get("optional") == "true") for one in written],
        )
        self.assertEqual(
            [(one.location, UrlType(one.type).name) for one in read.url],
            [(one.text, one.get("type")) for one in self.written.findall(SPACE + "url")],
        )
        self.assertEqual([one.name for one in read.license], texts(self.written, "license"))
        for tag in ("version", "freecadmin", "pythonmin"):
            (text,) = texts(self.written, tag)
            numbers = [*map(int, text.split(".")), 0][:3]
            self.assertEqual(getattr(read, tag).version_as_list[:3], numbers, tag)
