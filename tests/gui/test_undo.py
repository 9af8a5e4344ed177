# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command that changes a document is one step: undo gives back exactly what there was, redo what there came."""

import inspect
import json
import math
import os
import re
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
import Mesh
import Part
from PySide import QtCore, QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.job import job_to_json
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.features.stages import DONE, STALE, state_of
from freecad_trabecula.gui import layer_dialog, panels, table_dialog
from freecad_trabecula.gui.background import is_busy
from freecad_trabecula.gui.commands import COMMANDS
from freecad_trabecula.gui.layer_dialog import make_shapes
from freecad_trabecula.gui.recomputing import of_window
from freecad_trabecula.gui.transactions import told, transaction
from freecad_trabecula.gui.variants_dialog import VariantsDialog

#: Commands that change no document: they open, show or write.
LOOKING = [
    "Trabecula_Compare",
    "Trabecula_CopyScript",
    "Trabecula_Export",
    "Trabecula_Help",
    "Trabecula_Plots",
    "Trabecula_Results",
    "Trabecula_RodInfo",
    "Trabecula_SaveAnalyses",
    "Trabecula_SaveJob",
    "Trabecula_Section",
    "Trabecula_Start",
    "Trabecula_VoxelExport",
    "Trabecula_VoxelLayers",
    "Trabecula_WatchLayer",
    "Trabecula_WriteReport",
]
#: Commands that do, each with the test below that runs it; of presets, colours and ways to look through one stands for
#: all.
CHANGING = {
    "Trabecula_Analysis": "test_analyses_at_once_and_from_the_panel",
    "Trabecula_AnalyseNow": "test_analyses_at_once_and_from_the_panel",
    "Trabecula_Body": "test_a_body_from_a_file",
    "Trabecula_Design": "test_a_design_that_is_changed",
    "Trabecula_EditSite": "test_a_pore_by_hand",
    "Trabecula_FaceSites": "test_sites_on_faces",
    "Trabecula_LayerShapes": "test_voxels_and_shapes_of_their_layers",
    "Trabecula_MeasureFile": "test_a_file_that_is_measured",
    "Trabecula_Network": "test_network_and_scaffold_from_the_toolbar",
    "Trabecula_OpenJob": "test_a_job_that_is_opened",
    "Trabecula_Renew": "test_what_is_brought_up_to_date",
    "Trabecula_Scaffold": "test_network_and_scaffold_from_the_toolbar",
    "Trabecula_Switch": "test_rods_or_channels",
    "Trabecula_Variants": "test_another_seed_that_is_taken",
    "Trabecula_VoxelTables": "test_edited_tables",
    "Trabecula_Voxels": "test_voxels_and_shapes_of_their_layers",
    "Trabecula_Preset_case1": "test_a_preset",
    "Trabecula_Colour_coupling": "test_colours_and_ways_to_look_through",
    "Trabecula_Sight_xray": "test_colours_and_ways_to_look_through",
}
PREFIXES = ("Trabecula_Preset", "Trabecula_Colour", "Trabecula_Sight")
_ADDRESS = re.compile(r" (object )?at 0x[0-9a-f]+")
_SEEN = ("Visibility", "Transparency", "ColourBy")
#: What FreeCAD itself sets or leaves when it takes objects back.
_OWN = ("Label2", "ExpressionEngine", "Seconds")


def state(document):
    """Return all objects with their properties, class and look, in a form that can be compared."""
    found = {}
    for obj in document.Objects:
        told = {name: _plain(getattr(obj, name)) for name in obj.PropertiesList if name not in _OWN}
        told["Proxy"] = type(getattr(obj, "Proxy", None)).__name__
        view = obj.ViewObject
        told.update({"view " + name: getattr(view, name) for name in _SEEN if hasattr(view, name)})
        found[obj.Name] = told
    return found


def _plain(value):
    """Numbers, texts, links by name; shapes and meshes by their figures."""
    if hasattr(value, "CountFacets"):
        return (value.CountFacets, round(value.Volume, 5))
    if isinstance(value, Part.Shape):
        return None if value.isNull() else (len(value.Faces), len(value.Edges), len(value.Vertexes))
    if isinstance(value, (list, tuple)):
        return [_plain(one) for one in value]
    if isinstance(value, float) and math.isnan(value):
        return "nan"
    if hasattr(value, "Document") and hasattr(value, "Name"):
        return "-> " + value.Name
    return value if isinstance(value, (bool, int, float, str, type(None))) else _ADDRESS.sub("", str(value))


class UndoTest(WindowTest):
    def test_every_command_is_known_here(self):
        known = (*LOOKING, *CHANGING)
        self.assertEqual([one for one in COMMANDS if one not in known and not one.startswith(PREFIXES)], [])
        self.assertEqual([one for one in known if one not in COMMANDS], [])
        untested = [one for one, test in CHANGING.items() if one not in inspect.getsource(getattr(UndoTest, test))]
        self.assertEqual(untested, [])

    def assert_one_step(self, action, ready=lambda: True):
        """Undo gives back the state before an action, redo the state after."""
        settle(0.2)
        before, steps = state(self.document), list(self.document.UndoNames)
        action()
        self.assertTrue(wait(ready, 180), self.dialogs)
        settle(0.5)
        if FreeCADGui.Control.activeDialog():
            panels.current().reject()
            settle(0.2)
        self.assertEqual(self.dialogs, [])
        after = state(self.document)
        self.assertNotEqual(after, before)
        self.assertEqual(len(self.document.UndoNames), len(steps) + 1, self.document.UndoNames)
        for _ in range(2):
            self.document.undo()
            settle(0.2)
            self.assert_same(before)
            self.document.redo()
            settle(0.2)
            self.assert_same(after)

    def assert_same(self, expected):
        """Compare, once what follows the step from another process has come."""
        wait(lambda: not of_window()._wanted, 60)
        settle(0.2)
        found = state(self.document)
        self.assertEqual(sorted(found), sorted(expected))
        for name, properties in expected.items():
            for key, value in properties.items():
                self.assertEqual(found[name].get(key), value, (name, key))

    def has(self, name, *more):
        """Return a question: whether the document has an object, and the panel is done."""
        return lambda: self.document.getObject(name) is not None and all(one() for one in more)

    @staticmethod
    def chosen_file(path):
        """Answer the next question for a file."""
        return mock.patch.object(QtGui.QFileDialog, "getOpenFileName", lambda *_: (os.fspath(path), ""))

    def run_on(self, command, *objects):
        FreeCADGui.Selection.clearSelection()
        for obj in objects:
            FreeCADGui.Selection.addSelection(self.document.Name, obj.Name)
        FreeCADGui.runCommand(command)

    def accept(self):
        panel = panels.current()
        self.wait_for_estimate(panel)
        panel.accept()
        self.assertTrue(wait(lambda: not panel.is_open, 120), self.dialogs)

    def test_a_preset(self):
        def act():
            self.run_on("Trabecula_Preset_case1")
            self.accept()

        self.assert_one_step(act, self.has("Wireframe"))

    def test_a_design_that_is_changed(self):
        design = make.make_design(self.document, preset("case1"))

        def act():
            self.run_on("Trabecula_Design", design.wireframe)
            panels.current().set_job(preset("case2"))
            self.accept()

        self.assert_one_step(act)
        self.assertEqual(design.wireframe.PoreLayout, "spline")

    def test_a_job_that_is_opened(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "one.json"
            path.write_text(job_to_json(preset("case1")), encoding="utf-8")
            self.assertIn("prism", json.loads(path.read_text(encoding="utf-8")))

            def act():
                with self.chosen_file(path):
                    self.run_on("Trabecula_OpenJob")
                self.accept()

            self.assert_one_step(act, self.has("Wireframe"))

    def test_network_and_scaffold_from_the_toolbar(self):
        design = make.make_design(self.document, preset("case1"))
        for command, name in (("Trabecula_Network", "Network"), ("Trabecula_Scaffold", "Voids")):
            done = lambda: hasattr(panels.current(), "histogram")  # noqa: E731
            self.assert_one_step(lambda command=command: self.run_on(command, design.wireframe), self.has(name, done))

    def test_rods_or_channels(self):
        design = make.make_design(self.document, preset("case1"), ("scaffold",))
        self.assert_one_step(lambda: self.run_on("Trabecula_Switch", design.wireframe))

    def test_a_pore_by_hand(self):
        design = make.make_design(self.document, preset("case1"))

        def act():
            self.run_on("Trabecula_EditSite", design.wireframe)
            panel = panels.current()
            panel.site.set_value("Face1.2.3")
            panel.size.set_value(0.55)
            panel._set_pore()

        self.assert_one_step(act)

    def test_colours_and_ways_to_look_through(self):
        design = make.make_design(self.document, preset("case1"), ("network",))
        for command in ("Trabecula_Colour_coupling", "Trabecula_Sight_xray"):
            self.assert_one_step(lambda command=command: self.run_on(command, design.network))

    def bracket(self):
        bracket = self.document.addObject("Part::Feature", "Bracket")
        bracket.Shape = Part.makeBox(4, 4, 4).cut(Part.makeBox(2, 2, 4))
        return bracket

    def test_analyses_at_once_and_from_the_panel(self):
        bracket = self.bracket()
        self.assert_one_step(lambda: self.run_on("Trabecula_AnalyseNow", bracket), self.has("Analysis", self.idle))

        def act():
            self.run_on("Trabecula_Analysis", bracket)
            panel = panels.current()
            panel.fields.layers.fields["thickness"].set_value(0.5)
            panel.work()

        self.assert_one_step(act, self.has("Analysis001", self.idle))

    def test_voxels_and_shapes_of_their_layers(self):
        bracket = self.bracket()

        def act():
            self.run_on("Trabecula_Voxels", bracket)
            panel = panels.current()
            panel.fields.edges[0].set_value(0.5)
            panel.work()

        self.assert_one_step(act, self.has("VoxelDesign", self.idle))
        design = self.document.getObject("VoxelDesign")

        def make_three(dialog):
            dialog.first.setValue(0)
            dialog.last.setValue(2)
            dialog.kind.setCurrentIndex(1)
            return dialog.chosen() == (range(0, 3), True)

        with mock.patch.object(layer_dialog, "run_dialog", make_three):
            self.assert_one_step(lambda: self.run_on("Trabecula_LayerShapes", design))

    def test_edited_tables(self):
        half = ((0.5, 0.5),)
        parameters = VoxelParameters(size=(1.0, 1.0, 1.0), strategy="random-layers")
        obj = make.make_voxel_design(self.document, DrawnCurves((6.0, 6.0, 6.0), half, half, half), parameters)
        edited = [table.copy() for table in (make.voxel_design_of(obj).alpha, make.voxel_design_of(obj).beta)]
        edited[0][:], edited[1][:] = 3, 3  # three voxels in every line of a layer of 6 x 6

        def choose(dialog):
            dialog.show_tables(tuple(edited))
            return True

        with mock.patch.object(table_dialog, "run_dialog", choose):
            self.assert_one_step(lambda: self.run_on("Trabecula_VoxelTables", obj), self.idle)
        self.assertTrue((make.voxel_design_of(obj).alpha == 3).all())

    def test_another_seed_that_is_taken(self):
        wireframe = make.make_design(self.document, preset("case1")).wireframe
        self.run_on("Trabecula_Variants", wireframe)
        dialog = next(one for one in QtGui.QApplication.topLevelWidgets() if isinstance(one, VariantsDialog))
        self.addCleanup(dialog.close)
        self.assertTrue(wait(lambda: dialog.variants is not None, 120), dialog.message.text())
        dialog.table.selectRow(3)
        before = wireframe.PoreSizes
        self.assert_one_step(dialog.take_button.click, lambda: wireframe.Seed != 1 and wireframe.PoreSizes != before)

    def test_what_is_brought_up_to_date(self):
        design = make.make_design(self.document, preset("case1"), ("scaffold",))
        analysis = make.make_analysis(self.document, design.scaffold)
        design.scaffold.AutoUpdate = False
        self.document.recompute()
        with transaction(self.document, "Seed"):
            design.wireframe.Seed = 5
            self.document.recompute()
        # the rods follow by themselves; the scaffold, and so its analysis, wait
        self.assertTrue(wait(lambda: not of_window()._wanted, 120))
        settle(0.5)
        self.assertEqual((state_of(design.wireframe), state_of(design.scaffold)), (DONE, STALE))
        porosity, slices = design.scaffold.Porosity, list(analysis.Numbers)

        def is_done():
            return not of_window()._wanted and {state_of(design.scaffold), state_of(analysis)} == {DONE}

        self.assert_one_step(lambda: self.run_on("Trabecula_Renew"), is_done)
        self.assertNotEqual(design.scaffold.Porosity, porosity)
        self.assertNotEqual(list(analysis.Numbers), slices)

    def test_a_body_from_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "part.brep"
            Part.makeBox(1, 2, 3).exportBrep(os.fspath(path))

            def choose():
                dialog = QtGui.QApplication.activeModalWidget()
                dialog.findChild(QtGui.QLineEdit).setText(os.fspath(path))
                buttons = dialog.findChild(QtGui.QDialogButtonBox).buttons()
                next(one for one in buttons if one.isEnabled() and one.isDefault()).click()

            def act():
                QtCore.QTimer.singleShot(1500, choose)
                self.run_on("Trabecula_Body")

            self.assert_one_step(act, self.has("part"))

    def test_a_file_that_is_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "part.stl"
            Mesh.createBox(4.0, 4.0, 4.0).write(os.fspath(path))

            def act():
                with self.chosen_file(path):
                    self.run_on("Trabecula_MeasureFile")
                panels.current().work()

            self.assert_one_step(act, self.has("Analysis", self.idle))

    def test_sites_on_faces(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()

        def act():
            FreeCADGui.Selection.clearSelection()
            for face in ("Face1", "Face2"):
                FreeCADGui.Selection.addSelection(self.document.Name, box.Name, face)
            FreeCADGui.runCommand("Trabecula_FaceSites")
            self.accept()

        self.assert_one_step(act, self.has("Wireframe"))

    def idle(self):
        """Whether no work for the document is on its way."""
        panel = panels.current() if FreeCADGui.Control.activeDialog() else None
        return not is_busy() and getattr(panel, "_work", None) is None

    def test_an_error_leaves_the_document_as_it_was(self):
        design = make.make_voxel_design(self.document, self.bracket(), VoxelParameters(size=(0.5, 0.5, 0.5)))
        before, steps = state(self.document), list(self.document.UndoNames)
        with told():
            make_shapes(design, range(6, 12), True)
        self.assertEqual(len(self.dialogs), 1)
        self.assertEqual((state(self.document), list(self.document.UndoNames)), (before, steps))


class PasteTest(WindowTest):
    def test_what_is_copied_and_pasted_in_the_window_is_a_design_of_its_own(self):
        design = make.make_design(self.document, preset("case1"), ("network",))
        for obj in self.document.Objects:
            FreeCADGui.Selection.addSelection(self.document.Name, obj.Name)
        FreeCADGui.runCommand("Std_Copy")
        other = FreeCAD.newDocument("Pasted")
        FreeCADGui.setActiveDocument(other.Name)
        FreeCADGui.Selection.clearSelection()
        settle(0.5)
        self.assertTrue(FreeCADGui.Command.get("Std_Paste").isActive())
        FreeCADGui.runCommand("Std_Paste")
        settle(0.5)
        self.assertEqual(len(other.Objects), len(self.document.Objects))
        other.recompute()
        settle(0.5)
        network = next(obj for obj in other.Objects if obj.Name.startswith("Network"))
        self.assertEqual((network.isValid(), network.Rods, network.Wireframe.Document), (True, 75, other))
        self.assertEqual(type(network.ViewObject.Proxy).__name__, "ViewProvider")
        self.assertIs(design.network.Document, self.document)
