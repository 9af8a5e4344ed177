# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench as FreeCAD starts it: registered, with an icon that can be drawn on light and dark."""

import unittest
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtGui, QtSvg

ROOT = Path(__file__).resolve().parents[2]
ICONS = ROOT / "resources" / "icons"


class WorkbenchTest(unittest.TestCase):
    def test_freecad_found_the_workbench_and_its_icon(self):
        workbenches = FreeCADGui.listWorkbenches()
        self.assertIn("TrabeculaWorkbench", workbenches)
        self.assertTrue(Path(workbenches["TrabeculaWorkbench"].Icon).is_file())

    def test_the_workbench_is_shown_by_its_name(self):
        self.assertTrue(FreeCADGui.activateWorkbench("TrabeculaWorkbench"))
        self.assertEqual(FreeCADGui.activeWorkbench().name(), "TrabeculaWorkbench")

    def test_package_xml_names_the_class_that_was_registered_and_files_that_exist(self):
        metadata = FreeCAD.Metadata(str(ROOT / "package.xml"))
        content = metadata.Content["workbench"][0]
        self.assertIn(content.Classname, FreeCADGui.listWorkbenches())
        self.assertTrue((ROOT / metadata.Icon).is_file())
        self.assertTrue(metadata.supportsCurrentFreeCAD())


class IconTest(unittest.TestCase):
    def test_every_icon_is_small_and_stands_out_on_light_and_on_dark(self):
        icons = sorted(ICONS.rglob("*.svg"))
        self.assertTrue(icons)
        for path in icons:
            with self.subTest(icon=path.name):
                self.assertLessEqual(path.stat().st_size, 10_000)
                for background in ("#ffffff", "#2b2b2b"):
                    self.assertGreaterEqual(self.share_that_stands_out(path, background), 0.05)

    def share_that_stands_out(self, path, background):
        """Return the share of an icon's pixels that differ clearly in lightness from the background."""
        image = QtGui.QImage(32, 32, QtGui.QImage.Format_ARGB32)
        ground = QtGui.QColor(background)
        image.fill(ground)
        painter = QtGui.QPainter(image)
        # Not by QIcon, which needs a plug-in that FreeCAD does without.
        QtSvg.QSvgRenderer(str(path)).render(painter)
        painter.end()
        lightness = [QtGui.QColor(image.pixel(x, y)).lightness() for x in range(32) for y in range(32)]
        return sum(abs(value - ground.lightness()) > 60 for value in lightness) / len(lightness)
