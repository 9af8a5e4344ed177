# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences: the page keeps them, new objects begin with them, wrong ones fall back, nothing computed reads them."""

import ast
import os
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from window import WindowTest, wait

from freecad_trabecula import make
from freecad_trabecula.core.laws import uniform
from freecad_trabecula.core.parameters import ENGINES
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.registry import strategy_names
from freecad_trabecula.features.voxel_design import SURFACES
from freecad_trabecula.gui import panels, preferences
from freecad_trabecula.gui.child_work import ChildWork
from freecad_trabecula.gui.looks import look_of

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "freecad_trabecula"


def group():
    """Return where FreeCAD keeps our preferences."""
    return FreeCAD.ParamGet(preferences.GROUP)


class PreferencesTest(WindowTest):
    """A test that begins and ends without any preference stored."""

    def setUp(self):
        super().setUp()
        self.told, self._tell = [], preferences._tell
        preferences._tell = self.told.append
        self.clear()

    def tearDown(self):
        preferences._tell = self._tell
        self.clear()
        super().tearDown()

    @staticmethod
    def clear():
        """Forget what is stored."""
        for entry in preferences.ENTRIES.items():
            getattr(group(), "Rem" + entry[1].kind)(entry[0])


class PageTest(PreferencesTest):
    def in_dialog(self, act):
        """Open FreeCAD's preferences, do something with the dialog, and press OK."""
        done = []

        def look():
            dialog = QtGui.QApplication.activeModalWidget()
            if dialog is None:
                QtCore.QTimer.singleShot(200, look)
                return
            done.append(act(dialog))
            dialog.findChild(QtGui.QDialogButtonBox).button(QtGui.QDialogButtonBox.Ok).click()

        QtCore.QTimer.singleShot(300, look)
        FreeCADGui.runCommand("Std_DlgPreferences", 0)
        self.assertTrue(wait(lambda: bool(done), 20.0))
        return done[0]

    def test_what_the_page_is_given_is_kept_and_read(self):
        def fill(dialog):
            for name, value in (("PoreSmallest", 0.25), ("VoxelSize", 0.05), ("Seed", 7)):
                dialog.findChild(QtGui.QAbstractSpinBox, name).setValue(value)
            dialog.findChild(QtGui.QComboBox, "Engine").setCurrentIndex(2)
            return [one.windowTitle() for one in dialog.findChildren(QtGui.QWidget, "Trabecula_Preferences")]

        self.assertEqual(len(self.in_dialog(fill)), 1)
        self.assertEqual(preferences.preference("PoreSmallest"), 0.25)
        self.assertEqual(preferences.preference("Seed"), 7)
        self.assertEqual(preferences.new_voxels().size, (0.05,) * 3)
        self.assertEqual(preferences.new_job().scaffold.engine, "field")
        self.assertEqual(self.told, [])

    def test_the_page_shows_the_defaults_of_the_code(self):
        def read(dialog):
            spins = {one.objectName(): one.value() for one in dialog.findChildren(QtGui.QSpinBox)}
            spins.update({one.objectName(): one.value() for one in dialog.findChildren(QtGui.QDoubleSpinBox)})
            boxes = {one.objectName(): one.currentIndex() for one in dialog.findChildren(QtGui.QComboBox)}
            boxes.update({one.objectName(): one.isChecked() for one in dialog.findChildren(QtGui.QCheckBox)})
            return {**spins, **boxes}

        shown = self.in_dialog(read)
        for name, entry in preferences.ENTRIES.items():
            if entry.kind in ("Int", "Float", "Bool"):
                self.assertAlmostEqual(float(shown[name]), float(entry.default), places=9, msg=name)
        self.in_dialog(lambda dialog: None)  # stored as they were shown
        for name, entry in preferences.ENTRIES.items():
            if entry.kind == "Unsigned":
                self.assertEqual(preferences.preference(name) >> 8, entry.default >> 8, name)

    def test_the_form_has_one_widget_for_each_preference_and_one_item_for_each_word(self):
        tree = ElementTree.parse(preferences.PAGE)
        stored = {}
        for widget in tree.iter("widget"):
            names = {one.get("name"): one.findtext("cstring") for one in widget.findall("property")}
            if "prefEntry" in names:
                self.assertEqual(names["prefPath"], "Mod/Trabecula")
                stored[names["prefEntry"]] = len(widget.findall("item"))
        self.assertEqual(set(stored), set(preferences.ENTRIES))
        words = {"Engine": ENGINES, "Strategy": preferences.STRATEGIES, "VoxelSurface": SURFACES}
        self.assertEqual({name: stored[name] for name in words}, {name: len(one) for name, one in words.items()})

    def test_every_strategy_that_can_be_preferred_is_there(self):
        self.assertLessEqual(set(preferences.STRATEGIES), set(strategy_names()))
        self.assertGreaterEqual(len(preferences.STRATEGIES), 6)

    def test_the_page_has_an_icon(self):
        self.assertTrue((ROOT / "resources" / "icons" / "preferences-trabecula.svg").is_file())
        self.assertFalse(FreeCADGui.getIcon("preferences-trabecula").isNull())


class NewObjectTest(PreferencesTest):
    def test_a_new_design_begins_with_them_and_a_preset_does_not(self):
        group().SetInt("Seed", 42)
        group().SetFloat("PoreSmallest", 0.3)
        group().SetFloat("PoreLargest", 0.4)
        panels.open_new(self.document)
        job = panels.current().fields.job()
        self.assertEqual((job.seed, job.pores.size), (42, uniform(0.3, 0.4)))
        panels.current().reject()
        panels.open_new(self.document, preset("case1"))
        self.assertEqual(panels.current().fields.job().seed, preset("case1").seed)

    def test_new_analyses_and_voxel_designs_begin_with_them(self):
        self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        group().SetFloat("SliceThickness", 0.5)
        group().SetInt("Strategy", preferences.STRATEGIES.index("sequential"))
        group().SetInt("VoxelSurface", 1)
        panels.open_analysis(self.document)
        self.assertEqual(panels.current().fields.value().thickness, 0.5)
        panels.current().reject()
        panels.open_voxels(self.document)
        self.assertEqual(panels.current().fields.value().strategy, "sequential")
        self.assertEqual(panels.current().fields.surface.value(), "smooth")

    def test_colours_are_given_when_an_object_is_made_and_stay(self):
        group().SetUnsigned("ColourWireframe", 0xFF0000FF)
        first = make.make_design(self.document, preset("case1")).wireframe
        self.assertEqual(first.ViewObject.LineColor[:3], (1.0, 0.0, 0.0))
        self.assertEqual(look_of(first).colour, (1.0, 0.0, 0.0))
        group().SetUnsigned("ColourWireframe", 0x00FF00FF)
        first.touch()
        self.document.recompute()
        self.assertEqual(first.ViewObject.LineColor[:3], (1.0, 0.0, 0.0))

    def test_what_is_made_by_a_script_does_not_depend_on_them(self):
        group().SetInt("Seed", 99)
        group().SetFloat("PoreSmallest", 0.01)
        design = make.make_design(self.document, preset("case1"))
        self.assertEqual(design.wireframe.Seed, preset("case1").seed)

    def test_a_recompute_does_not_read_them(self):
        wireframe = make.make_design(self.document, preset("case6")).wireframe
        before = (wireframe.Seed, wireframe.PoreSizeLow.Value, list(wireframe.PoreSizes))
        group().SetInt("Seed", 5)
        group().SetFloat("PoreSmallest", 0.7)
        wireframe.touch()
        self.document.recompute()
        self.assertEqual((wireframe.Seed, wireframe.PoreSizeLow.Value, list(wireframe.PoreSizes)), before)

    def test_only_the_window_asks_freecad_for_preferences(self):
        readers = set()
        for path in PACKAGE.rglob("*.py"):
            names = (getattr(node, "attr", "") for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
            if "ParamGet" in names:
                readers.add(path.relative_to(PACKAGE).parts[0])
        self.assertEqual(readers, {"gui"})


class WrongValueTest(PreferencesTest):
    def test_a_number_that_breaks_its_rule_falls_back_and_is_told(self):
        for name, store, value in (
            ("Seed", "SetInt", -1),
            ("PoreSmallest", "SetFloat", 0.0),
            ("VoxelSize", "SetFloat", float("nan")),
            ("Engine", "SetInt", 17),
            ("Threads", "SetInt", 5000),
            ("ExportFolder", "SetString", "/no/such/folder"),
        ):
            with self.subTest(preference=name):
                del self.told[:]
                getattr(group(), store)(name, value)
                self.assertEqual(preferences.preference(name), preferences.ENTRIES[name].default)
                self.assertEqual(len(self.told), 1)
                self.assertIn(name, self.told[0])

    def test_a_value_of_another_kind_is_passed_over(self):
        group().SetString("Threads", "many")
        self.assertEqual(preferences.preference("Threads"), 0)
        group().RemString("Threads")

    def test_pores_of_which_the_smallest_is_larger_than_the_largest_fall_back_together(self):
        group().SetFloat("PoreSmallest", 0.9)
        self.assertEqual(preferences.new_job().pores.size, preset("case6").pores.size)
        self.assertEqual(len(self.told), 1)

    def test_a_panel_opens_with_all_of_them_wrong(self):
        for name, entry in preferences.ENTRIES.items():
            if entry.kind in ("Int", "Float"):
                getattr(group(), "Set" + entry.kind)(name, -3)
        panels.open_new(self.document)
        self.assertEqual(panels.current().fields.job().seed, preset("case6").seed)
        self.assertTrue(self.told)


class WorkTest(PreferencesTest):
    def test_long_work_has_no_more_threads_than_wanted(self):
        environment = ChildWork("freecad_trabecula.shell.worker", {}, tempfile.mkdtemp()).process.processEnvironment()
        asked = os.environ.get("OMP_NUM_THREADS", "")
        self.assertEqual(environment.value("OMP_NUM_THREADS", ""), asked)
        group().SetInt("Threads", 2)
        environment = ChildWork("freecad_trabecula.shell.worker", {}, tempfile.mkdtemp()).process.processEnvironment()
        self.assertEqual(environment.value("OPENBLAS_NUM_THREADS"), "2")

    def test_dialogs_for_files_open_in_the_preferred_folder_else_beside_the_document(self):
        with tempfile.TemporaryDirectory() as folder:
            self.document.saveAs(str(Path(folder) / "here.FCStd"))
            self.assertEqual(preferences.folder_for(self.document), folder)
            group().SetString("ExportFolder", tempfile.gettempdir())
            self.assertEqual(preferences.folder_for(self.document), tempfile.gettempdir())
