# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in Italian: texts of commands, panels and tooltips; the packed translations are those of the .ts files."""

import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import FreeCADGui
from PySide import QtCore
from window import WindowTest
from words import command_texts, label_texts

from freecad_trabecula.gui import language, panels
from freecad_trabecula.gui.commands import COMMANDS

ROOT = Path(__file__).resolve().parents[2]
#: Read by tests/run.py, which writes it into FreeCAD's settings.
LANGUAGE = "Italian"


class TextTest(WindowTest):
    def test_freecad_and_its_numbers_are_italian(self):
        self.assertEqual(FreeCADGui.getLocale(), "Italian")
        self.assertEqual(language.decimal_point(), ",")

    def test_commands_have_italian_texts_and_tooltips(self):
        self.assertEqual(command_texts("Trabecula_Design")[0], "Progetta aste")
        self.assertIn("Tagliare i canali dall'involucro", command_texts("Trabecula_Scaffold")[1])

    def test_every_command_is_italian_in_menu_and_tooltip(self):
        shown = {name: one for name, one in COMMANDS.items() if FreeCADGui.Command.get(name).getAction()}
        self.assertGreater(len(shown), 25)  # those in the menus of groups have no entry of their own
        for name, command in shown.items():
            with self.subTest(command=name):
                text, tip = command_texts(name)
                english = type(command).__dict__.get("TEXT", "")
                if english:  # others are made of words that were translated before
                    self.assertNotEqual(text, english.replace("&", ""))
                self.assertNotIn(command.TIP if type(command).__dict__.get("TIP") else "Select ", tip)

    def test_the_design_panel_is_italian(self):
        panel = self.open_preset("case1")
        texts = label_texts(panel.form)
        for words in ("Involucro", "Seme", "Siti su"):
            self.assertIn(words, texts)
        self.assertIn("Un solo numero", panel.fields.seed.widget.toolTip())
        self.assertIn("aste", panel.outcome.headline.text())

    def test_the_panel_of_voxels_is_italian(self):
        self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        panels.open_voxels(self.document)
        self.assertIn("Lato dei voxel", label_texts(panels.current().form))


class PackedTest(unittest.TestCase):
    def test_the_packed_files_hold_the_translations_of_the_ts_files(self):
        for code in ("de", "it"):
            path = ROOT / "resources" / "translations" / f"Trabecula_{code}.ts"
            translator = QtCore.QTranslator()
            self.assertTrue(translator.load(str(path.with_suffix(".qm"))))
            count = 0
            for context in ElementTree.parse(path).getroot().iter("context"):
                for message in context.iter("message"):
                    source, target = message.findtext("source"), message.findtext("translation") or ""
                    packed = translator.translate(context.findtext("name"), source) or ""
                    self.assertEqual(packed, target, (code, source))
                    count += bool(target)
            self.assertGreater(count, 500)
