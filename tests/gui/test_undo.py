# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command that changes a document is one step: undo gives back exactly what there was, redo what there came."""

import json
import os
import re
import tempfile
from pathlib import Path

import FreeCAD
import FreeCADGui
import Part
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.job import job_to_json
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.commands import COMMANDS
from freecad_trabecula.gui.document_work import is_busy
from freecad_trabecula.gui.layer_dialog import make_shapes
from freecad_trabecula.gui.rod_commands import switch_view

#: Commands that change no document: they open, show or write.
LOOKING = [
    "Trabecula_Compare",
    "Trabecula_CopyScript",
    "Trabecula_Export",
    "Trabecula_Help",
    "Trabecula_MeasureFile",
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
#: Commands that do, each with a test below (tables and variants: in their own files); of presets one stands for all.
#: Sites on faces and jobs open the same panel as a preset, whose end is the same step.
CHANGING = [
    "Trabecula_Analysis",
    "Trabecula_AnalyseNow",
    "Trabecula_Design",
    "Trabecula_EditSite",
    "Trabecula_FaceSites",
    "Trabecula_LayerShapes",
    "Trabecula_Network",
    "Trabecula_OpenJob",
    "Trabecula_Scaffold",
    "Trabecula_Switch",
    "Trabecula_Variants",
    "Trabecula_VoxelTables",
    "Trabecula_Voxels",
]
#: FreeCAD's own import and a recompute: tested where they are.
OF_FREECAD = ("Trabecula_Body", "Trabecula_Renew")
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
    if hasattr(value, "Document") and hasattr(value, "Name"):
        return "-> " + value.Name
    return value if isinstance(value, (bool, int, float, str, type(None))) else _ADDRESS.sub("", str(value))


class UndoTest(WindowTest):
    def test_every_command_is_known_here(self):
        known = (*LOOKING, *CHANGING, *OF_FREECAD)
        self.assertEqual([one for one in COMMANDS if one not in known and not one.startswith(PREFIXES)], [])
        self.assertEqual([one for one in known if one not in COMMANDS], [])

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
        found = state(self.document)
        self.assertEqual(sorted(found), sorted(expected))
        for name, told in expected.items():
            for key, value in told.items():
                self.assertEqual(found[name].get(key), value, (name, key))

    def has(self, name, *more):
        """Return a question: whether the document has an object, and the panel is done."""
        return lambda: self.document.getObject(name) is not None and all(one() for one in more)

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
            self.open_preset("case1")
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
                panels.open_job(self.document, os.fspath(path))
                self.accept()

            self.assert_one_step(act, self.has("Wireframe"))

    def test_network_and_scaffold_from_the_toolbar(self):
        design = make.make_design(self.document, preset("case1"))
        for command, name in (("Trabecula_Network", "Network"), ("Trabecula_Scaffold", "Voids")):
            done = lambda: hasattr(panels.current(), "histogram")  # noqa: E731
            self.assert_one_step(lambda command=command: self.run_on(command, design.wireframe), self.has(name, done))

    def test_rods_or_channels(self):
        design = make.make_design(self.document, preset("case1"), ("scaffold",))
        self.assert_one_step(lambda: switch_view(design.wireframe))

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
        commands = [name for name in COMMANDS if name in ("Trabecula_Colour_coupling", "Trabecula_Sight_xray")]
        self.assertEqual(len(commands), 2)
        for command in commands:
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
        self.assert_one_step(lambda: make_shapes(design, range(0, 3), True))

    def idle(self):
        """Whether no work for the document is on its way."""
        panel = panels.current() if FreeCADGui.Control.activeDialog() else None
        return not is_busy() and getattr(panel, "_work", None) is None

    def test_an_error_leaves_the_document_as_it_was(self):
        design = make.make_voxel_design(self.document, self.bracket(), VoxelParameters(size=(0.5, 0.5, 0.5)))
        before, steps = state(self.document), list(self.document.UndoNames)
        from freecad_trabecula.gui.transactions import told

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
