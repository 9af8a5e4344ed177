# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in German: texts, choices, refusals, decimal commas; documents, files and macros as in every language."""

import json
import re
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from window import WindowTest, press, settle, type_into
from words import choices_of, command_texts, english_in, label_texts

from freecad_trabecula import make
from freecad_trabecula.core.analysis.morphometry import TABLE
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.passport import DEFINITIONS
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.explanations.registry import all_keys, explanation
from freecad_trabecula.core.language import Language
from freecad_trabecula.core.laws import KINDS, Law
from freecad_trabecula.core.parameters import PoreParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.gui import language, panels, transactions
from freecad_trabecula.gui.analysis_dock import dock_of_window
from freecad_trabecula.gui.fields import NumberField
from freecad_trabecula.gui.form import field_for
from freecad_trabecula.gui.help_dock import show_help
from freecad_trabecula.gui.help_pages import GLOSSARY
from freecad_trabecula.gui.law_field import LawField
from freecad_trabecula.gui.outcome import Estimate, porosity_text
from freecad_trabecula.gui.qt import LEAST_TAB
from freecad_trabecula.gui.report_writing import report_words
from freecad_trabecula.gui.voxel_dock import voxel_dock

#: Read by tests/run.py, which writes it into FreeCAD's settings.
LANGUAGE = "German"


def nothing(*_):
    """Do nothing."""


class TextTest(WindowTest):
    def test_freecad_and_its_numbers_are_german(self):
        self.assertEqual(FreeCADGui.getLocale(), "German")
        self.assertEqual(language.decimal_point(), ",")

    def test_commands_have_german_texts_and_tooltips(self):
        self.assertEqual(command_texts("Trabecula_Design")[0], "Stäbe entwerfen")
        self.assertEqual(command_texts("Trabecula_Voxels")[0], "Voxel entwerfen")
        self.assertIn("Die Kanäle aus dem Hüllkörper schneiden", command_texts("Trabecula_Scaffold")[1])

    def test_words_that_a_module_translates_when_it_is_imported_are_german(self):
        from freecad_trabecula.gui import analysis_plots, voxel_form

        self.assertIn(("sliced_area", "Schnittfläche"), analysis_plots.KINDS)
        self.assertIn(("seed", "Startwert", 1), voxel_form._SEED)

    def test_the_design_panel_is_german(self):
        panel = self.open_preset("case1")
        texts = label_texts(panel.form)
        for words in ("Hüllkörper", "Startwert", "Stellen auf", "Kopplungen"):
            self.assertTrue(any(words in text for text in texts), words)
        self.assertIn("Eine Zahl", panel.fields.seed.widget.toolTip())
        self.assertIn("Stäbe", panel.outcome.headline.text())

    def test_the_panels_of_analyses_and_voxels_are_german(self):
        self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        panels.open_voxels(self.document)
        texts = label_texts(panels.current().form)
        for words in ("Probe", "Voxelgröße", "Strategie"):
            self.assertIn(words, texts)
        self.assertIn("trabekulär", choices_of(panels.current().fields.strategy))
        panels.current().reject()
        panels.open_analysis(self.document)
        texts = label_texts(panels.current().form)
        for words in ("Körper", "Achsen", "Dicke"):
            self.assertIn(words, texts)


class ChoiceTest(unittest.TestCase):
    def test_choices_are_shown_in_german_and_kept_as_they_are(self):
        field = field_for(PoreParameters, "layout", nothing)
        self.assertEqual(choices_of(field.widget), ["Kreis", "Spline"])
        field.set_value("circle")
        self.assertEqual((field.widget.currentText(), field.value()), ("Kreis", "circle"))

    def test_every_kind_of_law_comes_back(self):
        for kind in KINDS:
            law = Law(kind, 0.25, 0.25 if kind == "constant" else 0.75, (0.0, 0.5, 1.0), "0.2 + 0.05 * z")
            field = LawField("mm", 0.05, nothing)
            field.set_value(law)
            self.assertEqual(field.value(), law)


class NumberTest(unittest.TestCase):
    def test_lengths_and_pure_numbers_are_shown_and_typed_with_a_comma(self):
        for unit in ("mm", ""):
            field = NumberField(unit, 0.1, nothing)
            field.set_value(1.5)
            self.assertIn("1,5", field.widget.text())
            type_into(field.widget, "0,75")
            self.assertAlmostEqual(field.value(), 0.75, places=12)

    def test_a_small_length_is_typed_in_millimetres(self):
        field = NumberField("mm", 0.1, nothing)
        for typed, wanted in (("0,05", 0.05), ("0,08", 0.08), ("1,5", 1.5)):
            field.set_value(0.03)
            type_into(field.widget, typed)
            self.assertAlmostEqual(field.value(), wanted, places=12, msg=typed)

    def test_a_point_that_is_typed_is_a_comma(self):
        wanted = {"0.5": 0.5, "1.25": 1.25, "1.125": 1.125, "12,5": 12.5, "2,": 2.0}
        lengths = {"0.5 mm": 0.5, "500 µm": 0.5, "0.25 cm": 2.5, "0.5*3 mm": 1.5}
        for unit, typed in (("mm", {**wanted, **lengths}), ("", wanted)):
            field = NumberField(unit, 0.1, nothing)
            for text, value in typed.items():
                field.set_value(0.3)
                type_into(field.widget, text)
                self.assertAlmostEqual(field.value(), value, places=9, msg=(unit, text))

    def test_thousands_that_are_pasted_may_be_parted_by_either_sign_or_a_blank(self):
        wanted = {
            "1.234,5": "1.234,5",
            "1,234.5": "1.234,5",
            "1 234,5": "1234,5",
            "1.234.567": "1.234.567",
            "a.b": "a.b",
        }
        for text, meant in wanted.items():
            self.assertEqual(language.typed_numbers(text), meant)
        for unit in ("mm", ""):
            field = NumberField(unit, 0.1, nothing)
            line = field.widget.findChild(QtGui.QLineEdit)
            QtGui.QApplication.clipboard().setText("1.234,5")
            line.selectAll()
            line.paste()
            press(line, QtCore.Qt.Key_Return)
            self.assertAlmostEqual(field.value(), 1234.5, places=9, msg=unit)

    def test_labels_have_commas(self):
        self.assertEqual(language.local_number(0.5), "0,5")
        self.assertEqual(language.filled("{:.2f} {}", 0.125, 3), "0,12 3")
        self.assertEqual(language.place_text((0.5, 1.0, -2.25), ".2f"), "(0,50; 1,00; -2,25) mm")
        self.assertEqual(porosity_text(Estimate(0.3612, 0.0004, 0.5, ())), "36,12 ± 0,04")

    def test_files_and_macros_have_points(self):
        from freecad_trabecula.core.job import job_to_json
        from freecad_trabecula.gui.document_work import parameters_text

        text = job_to_json(preset("case1"))
        self.assertEqual(json.loads(text)["pores"]["layout"], preset("case1").pores.layout)
        self.assertNotRegex(text, r"\d,\d")
        self.assertIn("scatter=0.25", parameters_text(PoreParameters(scatter=0.25)))


class PanelNumberTest(WindowTest):
    def take_commas(self, panel):
        """Type 0,5 into every number field that can hold it; return how many there were."""
        fields = [one for one in panel.form.findChildren(QtGui.QAbstractSpinBox) if not isinstance(one, QtGui.QSpinBox)]
        for box in fields:
            if isinstance(box, QtGui.QDoubleSpinBox) and not box.minimum() <= 0.5 <= box.maximum():
                continue
            if not box.isEnabledTo(panel.form):
                continue
            type_into(box, "0,5")
            shown = box.property("rawValue") if box.property("rawValue") is not None else box.value()
            self.assertAlmostEqual(float(shown), 0.5, places=9, msg=box.toolTip())
            self.assertIn("0,5", box.text(), box.toolTip())
        return len(fields)

    def test_every_number_field_of_the_panels_takes_a_comma_and_shows_it(self):
        self.assertGreater(self.take_commas(self.open_preset("case6")), 15)
        panels.current().reject()
        self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        for open_panel in (panels.open_voxels, panels.open_analysis):
            open_panel(self.document)
            self.assertGreater(self.take_commas(panels.current()), 3)
            panels.current().reject()

    def test_heights_are_typed_with_commas_between_blanks(self):
        self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        panels.open_analysis(self.document)
        fields = panels.current().fields
        fields.layers.fields["at"].set_value("heights")
        fields.heights.setText("0,5 1,25; 2")
        self.assertEqual(fields.value().heights, (0.5, 1.25, 2.0))
        fields.set_value(fields.value())
        self.assertEqual(fields.heights.text(), "0,5 1,25 2")

    def test_tables_on_disk_have_points(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        analysis = make.make_analysis(self.document, box, SliceParameters(thickness=0.3))
        self.document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            make.save_analysis(analysis, folder, plots="none")
            tables = sorted(Path(folder).rglob("*.csv"))
            self.assertTrue(tables)
            for table in tables:
                head, *rows = table.read_text(encoding="utf-8").splitlines()
                self.assertTrue(all(len(row.split(",")) == len(head.split(",")) for row in rows), table.name)
            self.assertTrue(any("0.15" in table.read_text(encoding="utf-8") for table in tables))  # first middle


class SpeechTest(WindowTest):
    def test_a_refusal_is_told_in_german_with_its_value(self):
        with self.assertRaises(ParameterError) as caught:
            PoreParameters(corners=1)
        with transactions.told():
            raise caught.exception
        self.assertEqual(self.dialogs, [language.in_words(str(caught.exception))])
        self.assertIn("muss", self.dialogs[0])
        self.assertIn("1", self.dialogs[0])

    def test_a_message_without_a_template_stays_as_it_is(self):
        self.assertEqual(language.in_words("quux frobnicated"), "quux frobnicated")

    def test_the_state_of_an_object_stays_english_in_the_document_and_is_german_in_the_window(self):
        with tempfile.TemporaryDirectory() as folder:
            wireframe = make.make_design(self.document, preset("case1")).wireframe
            self.document.recompute()
            path = Path(folder) / "design.FCStd"
            self.document.saveAs(str(path))
            self.assertIn("rods", wireframe.Status)
            self.assertIn("Stäbe", language.in_words(wireframe.Status))


class PropertyTest(WindowTest):
    def test_what_a_property_is_can_be_read_in_german(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        for name in ("PoreLayout", "Rods", "Seed"):
            said = wireframe.getDocumentationOfProperty(name)
            self.assertNotEqual(FreeCAD.Qt.translate("App::Property", said), said, name)
        self.assertTrue(QtCore.QCoreApplication.translate("App::Property", "Engine that cut the channels"))


class ExplanationTest(unittest.TestCase):
    def test_no_explanation_of_a_number_is_english(self):
        for key in all_keys():
            for word, text in explanation(key).rows((), language.in_words):
                self.assertEqual(english_in(text), "", (key, word, text))

    def test_both_routes_are_told_with_commas(self):
        both = "scaffold: 1.25 against 2.5, 0.5 apart (at most 0.1)"
        found = explanation("design.porosity").rows([both], language.in_words)
        self.assertEqual(found[-1], ("both routes", "Gerüst: 1,25 gegen 2,5, 0,5 auseinander (höchstens 0,1)"))


class TabsTest(WindowTest):
    def test_the_tabs_of_the_docks_can_be_read_and_reached_beside_a_panel(self):
        for dock in (dock_of_window(), voxel_dock()):
            dock.open()
            dock.setFloating(True)
            dock.resize(640, 330)
            settle(0.3)
            bar = dock.tabs.tabBar()
            for k in range(bar.count()):
                dock.tabs.setCurrentIndex(k)
                settle(0.05)
                self.assertTrue(bar.rect().contains(bar.tabRect(k)), (bar.tabText(k), bar.tabRect(k), bar.rect()))
                whole = bar.tabSizeHint(k).width()
                self.assertGreaterEqual(bar.tabRect(k).width(), min(whole, LEAST_TAB), bar.tabText(k))
                self.assertEqual(bar.tabToolTip(k), bar.tabText(k))
            dock.setFloating(False)
            dock.hide()


class GlossaryTest(WindowTest):
    def test_the_glossary_is_german_and_the_pages_that_nobody_translated_are_there(self):
        dock = show_help(GLOSSARY)
        self.assertIn("der Körper, der gefüllt wird", dock.view.toPlainText())
        show_help("method.md#3-couplings-thesis-245-423")
        self.assertIn("Couplings", dock.view.toPlainText())
        dock.hide()


class ReportTest(WindowTest):
    maxDiff = None

    def pieces(self):
        """Return what a report of everything says, as pairs of what core says and what is written."""
        found = {}

        def words(text):
            found[text] = report_words(text)
            return found[text]

        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "report.html"
            make.write_report(self.document, path, language=Language(language.language(), words))
            page = path.read_text(encoding="utf-8")
        self.assertIn('<html lang="de">', page)
        return found

    @unittest.skipUnless(manifold_available(), "manifold3d is not installed: nothing that needs Booleans is tested")
    def test_nothing_of_a_report_is_english(self):
        make.make_design(self.document, preset("case1"), ("network", "scaffold"))
        body = self.document.addObject("Part::Feature", "Winkel")
        body.Shape = make.make_box(self.document, 4, 4, 4).Shape.cut(make.make_box(self.document, 2, 2, 4).Shape)
        half = SliceParameters(thickness=0.5)
        for _ in range(2):
            make.make_analysis(self.document, body, half, morphometry=True)
        make.make_voxel_design(self.document, body, VoxelParameters(size=(0.5, 0.5, 0.5)))
        self.document.recompute()
        found = self.pieces()
        self.assertGreater(len(found), 300)
        self.assertEqual({text: said for text, said in found.items() if english_in(said)}, {})
        # names of parameters are those of scripts, signs of measures and authors the same everywhere
        named = {*VoxelParameters.__dataclass_fields__, *TABLE, *DEFINITIONS, *(f"{one} area" for one in DEFINITIONS)}
        own = re.compile(r".*DOI|.*\(S_V|FreeCAD \d|.*Winkel|Wireframe$|Face\d")
        kept = [text for text, said in found.items() if text == said and text not in named and not own.match(text)]
        self.assertEqual([text for text in kept if re.search(r"[A-Za-z]{3}", text)], [])
        self.assertEqual(found["porosity, % (Eq. 2.2)"], "Porosität, % (Gl. 2.2)")
