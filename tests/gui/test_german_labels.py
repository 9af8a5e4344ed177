# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a German window makes: labels, undo steps, report view in German; names, scripts and files not."""

import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest, settle, wait
from words import english_in

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.features.relations import type_of
from freecad_trabecula.gui import preferences
from freecad_trabecula.gui.example_projects import _write
from freecad_trabecula.gui.export_dialog import ask_and_write
from freecad_trabecula.gui.labels import english_label, file_name, label_new
from freecad_trabecula.gui.transactions import transaction

#: Read by tests/run.py, which writes it into FreeCAD's settings.
LANGUAGE = "German"
#: The English label of an object of each kind, by its name, and the German one.
GERMAN = {"Wireframe": "Drahtmodell", "Network": "Netzwerk", "Envelope": "Hüllkörper", "Sites": "Stellen"}
ITALIAN = {"Involucro": "Envelope", "Analisi Rete": "Analysis Network", "Voxel Pezzi staccati002": "Voxels Loose002"}


def labels(document):
    """Return the labels of a document's objects by their names."""
    return {obj.Name: obj.Label for obj in document.Objects}


class LabelTest(WindowTest):
    def build_network(self):
        panel = self.open_preset("case1")
        for kind, box in panel.build_bar.boxes.items():
            box.setChecked(kind == "network")
        self.build(panel)

    def test_what_is_built_has_german_labels_and_english_names_in_one_step(self):
        self.build_network()
        self.assertEqual(labels(self.document), GERMAN)
        self.assertEqual(self.document.UndoNames, ["Stäbe entwerfen"])
        self.document.undo()
        self.assertEqual(labels(self.document), {})
        self.document.redo()
        self.assertEqual(labels(self.document), GERMAN)

    def test_an_expression_may_use_name_or_label_and_both_last(self):
        self.build_network()
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "=Wireframe.Rods")
        sheet.set("A2", "=<<Drahtmodell>>.Rods")
        self.document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "design.FCStd"
            self.document.saveAs(str(path))
            again = FreeCAD.openDocument(str(path))
            again.Wireframe.touch()
            again.recompute()
            rods = again.Wireframe.Rods
            self.assertEqual(labels(again)["Wireframe"], "Drahtmodell")
            self.assertEqual((again.Sheet.A1, again.Sheet.A2), (rods, rods))

    def test_what_a_script_makes_has_english_labels(self):
        make.make_design(self.document, preset("case1"))
        self.assertEqual({obj.Label for obj in self.document.Objects}, {obj.Name for obj in self.document.Objects})

    def test_a_script_of_a_german_design_makes_the_same_design_with_its_labels(self):
        self.build_network()
        text = make.design_as_script(self.document.Wireframe)
        FreeCAD.newDocument("Again")
        exec(compile(text, "script", "exec"), {})  # noqa: S102  what a user does
        made = next(one for one in FreeCAD.listDocuments().values() if one not in (self.document,) and one.Objects)
        self.assertEqual(made.Wireframe.Label, "Drahtmodell")
        self.assertEqual(made.Wireframe.Rods, self.document.Wireframe.Rods)
        self.assertEqual(made.Network.Label, "Netzwerk")

    def test_every_kind_of_object_has_a_german_label_and_goes_back_to_the_english_one(self):
        before = {obj.Name for obj in self.document.Objects}
        ring = self.torus()
        make.make_design(self.document, preset("case1"), ("network", "scaffold"))
        make.make_analysis(self.document, self.document.Scaffold, SliceParameters(thickness=1.0))
        make.make_voxel_design(self.document, ring, VoxelParameters(size=(1.0, 1.0, 1.0)))
        make.make_layer_shapes(self.document.VoxelDesign, [0], True)
        english = labels(self.document)
        label_new(self.document, before)
        german = labels(self.document)
        self.assertEqual(german["Analysis"], "Analyse Gerüst")
        self.assertEqual(german["VoxelDesign"], "Voxel Torus")
        self.assertEqual(german["Layers"], "Schichten von Voxel Torus")
        self.assertEqual([name for name in german if german[name] == english[name]], ["Torus"])
        self.assertEqual({name: english_label(label) for name, label in german.items()}, english)

    def test_a_label_of_the_user_and_one_that_only_looks_like_ours_stay(self):
        with transaction(self.document, "Test"):
            box = self.document.addObject("Part::Box", "Box")
            box.Label = "Scaffold"
            other = make.make_box(self.document)
            other.Label = "Platte"
        self.assertEqual((box.Label, other.Label), ("Scaffold", "Platte"))

    def test_a_document_of_another_language_is_left_as_it_is_and_known(self):
        for italian, english in ITALIAN.items():
            self.assertEqual(english_label(italian), english)
        with tempfile.TemporaryDirectory() as folder:
            box = make.make_box(self.document)
            box.Label = "Involucro"
            path = Path(folder) / "italian.FCStd"
            self.document.saveAs(str(path))
            again = FreeCAD.openDocument(str(path))
            self.assertEqual(labels(again), {"Envelope": "Involucro"})

    def test_the_example_is_german_and_its_analyses_go_by_the_new_labels(self):
        document = _write("voxels")
        self.assertEqual(document.Label, "Beispiel_Voxel")
        found = labels(document)
        self.assertEqual((found["Bone"], found["VoxelDesign"]), ("Knochen", "Voxel Knochen"))
        analyses = [obj for obj in document.Objects if type_of(obj) == "Trabecula::Analysis"]
        self.assertEqual([obj.Label for obj in analyses], ["Analyse Knochen", "Analyse Voxel Knochen"])
        self.assertEqual([make.analysis_of(obj).name for obj in analyses], ["Knochen", "Voxel Knochen"])


class FileNameTest(WindowTest):
    def test_a_proposed_name_is_ascii_and_that_of_an_english_window(self):
        with transaction(self.document, "Test"):
            box = make.make_box(self.document)
        self.assertEqual(box.Label, "Hüllkörper")
        self.assertEqual(file_name(box, ".stl"), "Window-Envelope.stl")
        asked = []
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *given: asked.append(given[2]) or ("", "")):
            ask_and_write(box, "step", lambda *_: None)
        self.assertEqual(Path(asked[0]).name, "Window-Envelope.step")

    def test_labels_of_the_user_are_kept_as_far_as_ascii_goes(self):
        box = self.document.addObject("Part::Box", "Box")
        wanted = {"Große Ähre 2": "Grosse_Aehre_2", "plaque carrée": "plaque_carree", "骨": "Box", "a/b": "a_b"}
        for label, name in wanted.items():
            box.Label = label
            self.assertEqual(file_name(box, ".stl"), f"Window-{name}.stl")


class ReportViewTest(WindowTest):
    def reported(self, action):
        """Return what an action adds to FreeCAD's report view."""
        dock = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "Report view")
        page = dock.findChild(QtGui.QTextEdit)
        before = len(page.toPlainText())
        action()
        wait(lambda: len(page.toPlainText()) > before, 5)
        settle(0.2)
        return page.toPlainText()[before:]

    def test_a_refusal_of_an_object_is_german_there_and_english_in_the_document(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe

        def refuse():
            wireframe.PathBox = FreeCAD.Vector(-1, 0, 0)
            self.document.recompute()
            self.assertTrue(wait(lambda: "must" in wireframe.Status, 60), wireframe.Status)

        said = self.reported(refuse)
        self.assertIn("muss", said)
        self.assertIn("must", wireframe.Status)
        for line in said.splitlines():
            if "errors." in line:
                self.assertEqual(english_in(line.partition(": ")[2]), "", line)

    def test_a_preference_that_breaks_its_rule_is_told_in_german(self):
        group = FreeCAD.ParamGet(preferences.GROUP)
        group.SetInt("Threads", -5)
        try:
            said = self.reported(lambda: preferences.preference("Threads"))
        finally:
            group.RemInt("Threads")
        self.assertIn("Einstellungen von Trabecula: Threads muss in 0..1024 liegen, hier -5; 0 wird genommen", said)
