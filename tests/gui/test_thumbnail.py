# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saved files hold a picture of the view, unless that was switched off; FreeCAD's preference stays as it is."""

import tempfile
import zipfile
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest, settle

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.gui.thumbnail import ENTRY

GROUP = "User parameter:BaseApp/Preferences/Document"


class ThumbnailTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.folder = tempfile.TemporaryDirectory()
        self.path = str(Path(self.folder.name) / "saved.FCStd")

    def tearDown(self):
        FreeCAD.ParamGet(GROUP).RemBool("SaveThumbnail")
        super().tearDown()
        self.folder.cleanup()

    def save(self):
        """Save and return the entries of the file."""
        self.document.saveAs(self.path)
        with zipfile.ZipFile(self.path) as archive:
            self.assertIsNone(archive.testzip())
            return archive.namelist()

    def test_a_design_is_saved_with_a_picture_once_and_opens_again(self):
        make.make_design(self.document, preset("case1"))
        FreeCADGui.activeDocument().activeView().viewIsometric()
        FreeCADGui.activeDocument().activeView().fitAll()
        settle(0.3)
        before = FreeCAD.ParamGet(GROUP).GetContents()
        for _ in range(2):
            self.assertEqual(self.save().count(ENTRY), 1)
        self.assertEqual(FreeCAD.ParamGet(GROUP).GetContents(), before)
        with zipfile.ZipFile(self.path) as archive:
            image = QtGui.QImage.fromData(archive.read(ENTRY))
        edge = image.width()  # ours 128, that of FreeCAD 1.1 256
        self.assertIn(edge, (128, 256))
        self.assertEqual(image.height(), edge)
        rows = [[image.pixel(x, y) for x in range(edge)] for y in range(edge)]
        # the ground may change from row to row, not along one: what differs is the design
        self.assertGreater(sum(edge - max(map(row.count, set(row))) for row in rows), 100)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(self.path)
        self.assertEqual(self.document.getObject("Wireframe").Rods, 75)

    def test_who_has_switched_pictures_off_gets_none(self):
        FreeCAD.ParamGet(GROUP).SetBool("SaveThumbnail", False)
        make.make_design(self.document, preset("case1"))
        self.assertNotIn(ENTRY, self.save())
