# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of earlier releases in the window: icons in the tree, colours, panels, the same results after a recompute."""

import sys
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from window import WindowTest, settle, wait

sys.path.append(str(Path(__file__).resolve().parents[1] / "features"))

from opened_files import FILES, assert_same, state

from freecad_trabecula.features import results
from freecad_trabecula.features.feature import is_a
from freecad_trabecula.features.relations import type_of
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.looks import look_of
from freecad_trabecula.gui.qt import icon_path
from freecad_trabecula.gui.recomputing import of_window
from freecad_trabecula.gui.view_providers import ViewProvider

#: Objects that hold numbers only.
_UNSEEN = ("Trabecula::Analysis",)


def icons_in_tree(label):
    """Return the icons of the rows below a document's in the tree, by the labels of its objects."""
    found = {}

    def walk(model, parent, is_inside):
        for row in range(model.rowCount(parent)):
            index = model.index(row, 0, parent)
            text = index.data()
            if is_inside:
                found[text] = index.data(QtCore.Qt.DecorationRole)
            walk(model, index, is_inside or text == label)

    for tree in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget):
        walk(tree.model(), QtCore.QModelIndex(), False)
    return found


class OpenedFilesTest(WindowTest):
    def with_each(self, look):
        """Open each file of an earlier release, look at it, close it again; nothing may have gone wrong by then."""
        for path in FILES:
            with self.subTest(file=path.name):
                results.clear()
                document = FreeCAD.openDocument(str(path))
                settle(0.5)
                look(document)
                FreeCAD.closeDocument(document.Name)
                settle(0.2)
                self.assertEqual((self.errors, self.dialogs), ([], []))

    def test_there_are_files(self):
        self.assertGreaterEqual(len(FILES), 5)

    def test_each_object_has_its_view_provider_its_icon_in_the_tree_and_its_look(self):
        def look(document):
            icons = icons_in_tree(document.Label)
            for obj in filter(is_a, document.Objects):
                with self.subTest(object=obj.Name):
                    view, looks = obj.ViewObject, look_of(obj)
                    self.assertIsInstance(view.Proxy, ViewProvider)
                    self.assertTrue(Path(icon_path(looks.icon)).is_file())
                    self.assertFalse(icons[obj.Label].pixmap(QtCore.QSize(16, 16)).isNull())
                    # FreeCAD itself hides what was made without a window: its own bodies stay so
                    self.assertEqual(view.Visibility, looks.visible)
                    if type_of(obj) not in _UNSEEN:
                        colour = view.ShapeColor[:3]
                        for found, wanted in zip(colour, looks.colour):
                            self.assertAlmostEqual(found, wanted, delta=1 / 255)

        self.with_each(look)

    def test_a_recompute_of_all_leaves_the_same_volumes(self):
        def look(document):
            before = state(document)
            self.assertGreater(len(before), 10)
            for obj in document.Objects:
                obj.touch()
            document.recompute()
            self.assertTrue(wait(lambda: not of_window()._wanted, 180))
            settle(0.5)
            self.assertEqual([obj.Label for obj in document.Objects if not obj.isValid()], [])
            assert_same(self, state(document), before)

        self.with_each(look)

    def test_each_panel_opens_on_what_a_file_holds_and_closes_without_a_change(self):
        def look(document):
            before = state(document)
            for obj in filter(is_a, document.Objects):
                with self.subTest(object=obj.Name):
                    panels.open_for(document.Name, obj.Name)
                    if FreeCADGui.Control.activeDialog():  # sites alone belong to no design
                        settle(0.3)
                        panels.current().reject()
                        settle(0.1)
            self.assertFalse(FreeCADGui.Control.activeDialog())
            assert_same(self, state(document), before)

        self.with_each(look)
