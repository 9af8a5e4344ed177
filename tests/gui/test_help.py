# SPDX-License-Identifier: LGPL-2.1-or-later
"""The help in the window: each panel's question mark, the glossary, links, pictures, the way back, the search."""

from pathlib import Path

import FreeCADGui
from PySide import QtCore, QtGui
from window import WindowTest, settle

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.gui import commands, panels
from freecad_trabecula.gui.analysis_dock import dock_of_window
from freecad_trabecula.gui.help_dock import help_dock, show_help
from freecad_trabecula.gui.help_pages import DOCS, GLOSSARY, page_of_command, passages_of, slug
from freecad_trabecula.gui.rod_dock import dock_of_window as rod_dock
from freecad_trabecula.gui.voxel_dock import voxel_dock


def pictures_of(document):
    """Return (name, width in pixels) of the pictures of a page."""
    found, block = [], document.begin()
    while block.isValid():
        part = block.begin()
        while not part.atEnd():
            form = part.fragment().charFormat()
            if form.isImageFormat():
                name = form.toImageFormat().name()
                image = document.resource(QtGui.QTextDocument.ImageResource, QtCore.QUrl(name))
                found.append((name, image.width()))
            part += 1
        block = block.next()
    return found


class HelpTest(WindowTest):
    def tearDown(self):
        help_dock().hide()
        super().tearDown()

    def shown(self):
        """Return the page that is shown, within the docs."""
        self.assertTrue(help_dock().isVisible())
        return Path(help_dock().view.page()).resolve().relative_to(DOCS).as_posix()

    def press(self, widget, tip):
        """Press the button of a widget whose tooltip begins so."""
        (button,) = [one for one in widget.findChildren(QtGui.QToolButton) if one.toolTip().startswith(tip)]
        self.assertTrue(button.isVisible())
        button.click()
        settle(0.2)

    def test_the_question_mark_of_every_panel_opens_its_page_and_the_glossary_is_beside_it(self):
        make.make_design(self.document, preset("case1"))
        opened = (
            *(("Trabecula_Design", "Design"), ("Trabecula_EditSite", "EditSite"), ("Trabecula_Results", "Results")),
            *(("Trabecula_Analysis", "Analysis"), ("Trabecula_Voxels", "Voxels")),
        )
        for command, page in opened:
            with self.subTest(panel=command):
                FreeCADGui.runCommand(command)
                settle(0.5)
                form = panels.current().form
                self.press(form, "Help")
                self.assertEqual(self.shown(), f"commands/{page}.md")
                self.press(form, "Glossary")
                self.assertEqual(self.shown(), GLOSSARY)
                panels.current().reject()

    def test_the_question_mark_lies_over_nothing_of_the_panel(self):
        panel = self.open_preset("case1")
        settle(0.3)
        inside = panel.form.help.geometry()
        for child in panel.form.children():
            if child is not panel.form.help and isinstance(child, QtGui.QWidget) and child.isVisible():
                self.assertFalse(child.geometry().intersects(inside), child)

    def test_the_question_mark_of_every_dock_opens_its_page(self):
        rod_dock().show()
        for dock, page in ((dock_of_window(), "Plots"), (voxel_dock(), "VoxelLayers"), (rod_dock(), "RodInfo")):
            if dock is not rod_dock():
                dock.open()
            dock.raise_()
            settle(0.3)
            self.press(dock, "Help")
            self.assertEqual(self.shown(), f"commands/{page}.md")
            dock.hide()

    def test_the_command_shows_the_contents_and_hides_them(self):
        FreeCADGui.runCommand("Trabecula_Help")
        self.assertEqual(self.shown(), "README.md")
        FreeCADGui.runCommand("Trabecula_Help")
        self.assertFalse(help_dock().isVisible())

    def test_every_command_has_a_page_those_of_a_group_its_groups(self):
        self.assertGreater(len(commands.COMMANDS), 30)
        for name in commands.COMMANDS:
            self.assertTrue((DOCS / page_of_command(name)).is_file(), name)

    def test_the_page_of_a_command_has_the_commands_name_for_its_heading(self):
        for name in (name for name in commands.COMMANDS if name.count("_") == 1):
            text = (DOCS / page_of_command(name)).read_text(encoding="utf-8")
            heading = next(passages_of(text))[0]
            self.assertEqual(heading, FreeCADGui.Command.get(name).getInfo()["menuText"].replace("&", ""), name)

    def test_a_link_to_a_heading_leads_there_and_back_leads_back(self):
        show_help("README.md")
        show_help("method.md#3-couplings-thesis-245-423")
        settle(0.3)
        view = help_dock().view
        self.assertEqual(slug(view.textCursor().block().text()), "3-couplings-thesis-245-423")
        self.assertGreater(view.verticalScrollBar().value(), 300)
        view.backward()
        self.assertEqual(self.shown(), "README.md")
        view.forward()
        self.assertEqual(self.shown(), "method.md")

    def test_a_click_on_a_link_leads_to_a_page_of_another_folder(self):
        show_help("commands/Help.md")
        settle(0.3)
        view = help_dock().view
        cursor = view.document().find("contents", view.document().find("See also"))
        place = QtCore.QPointF(view.cursorRect(cursor).center() - QtCore.QPoint(8, 0))
        left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
        for kind, held in ((QtCore.QEvent.MouseButtonPress, left), (QtCore.QEvent.MouseButtonRelease, none)):
            event = QtGui.QMouseEvent(kind, place, left, held, QtCore.Qt.NoModifier)
            QtGui.QApplication.sendEvent(view.viewport(), event)
        self.assertEqual(self.shown(), "README.md")

    def test_pictures_fit_the_page(self):
        show_help("commands/Design.md")
        settle(0.4)
        for width in (300, 700):
            help_dock().resize(width, 600)
            settle(0.5)
            view = help_dock().view
            found = dict(pictures_of(view.document()))
            icon, shot = found["../../resources/icons/Trabecula_design.svg"], found["../pictures/design-sites.png"]
            self.assertEqual(icon, 32)
            self.assertGreater(shot, 0.7 * view.viewport().width())
            self.assertLessEqual(shot, view.viewport().width())

    def test_a_search_shows_where_words_stand_and_its_links_lead_there(self):
        dock = show_help()
        dock.words.setText("Hermite")
        dock.words.returnPressed.emit()
        self.assertIn("Hermite", dock.view.toPlainText())
        self.assertIn("method.md", dock.view.toHtml())
        dock.words.setText("nosuchword")
        dock.words.returnPressed.emit()
        self.assertIn("Nothing was found", dock.view.toPlainText())
        dock.view.backward()
        self.assertIn("Hermite", dock.view.toPlainText())

    def test_every_page_is_shown_with_its_heading(self):
        for path in sorted(DOCS.rglob("*.md")):
            with self.subTest(page=path.name):
                show_help(path.relative_to(DOCS).as_posix())
                heading = next(passages_of(path.read_text(encoding="utf-8")))[0]
                self.assertIn(heading.replace("`", ""), help_dock().view.toPlainText()[:300])
