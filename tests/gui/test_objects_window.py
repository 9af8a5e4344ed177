# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our objects in the window: their look, files made without a window, single sites and pores, rods at a click."""

import os
import subprocess
import tempfile
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest, settle

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.features.relations import parts_of, products_of, wireframe_of
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.child_work import console_program
from freecad_trabecula.gui.looks import LOOKS
from freecad_trabecula.gui.rod_dock import RodDock, rod_facts
from freecad_trabecula.gui.view_providers import ViewProvider

ROOT = Path(__file__).resolve().parents[2]
HEADLESS = """
import sys
sys.path.insert(0, {root!r})
import FreeCAD
from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
document = FreeCAD.newDocument("Headless")
design = make.make_design(document, preset("case1"))
make.make_network(design.wireframe)
document.saveAs({path!r})
sys.stdout.flush()
import os
os._exit(0)
"""


class LookTest(WindowTest):
    def test_every_kind_of_object_has_an_icon_that_exists(self):
        for kind, look in LOOKS.items():
            with self.subTest(kind=kind):
                self.assertTrue((ROOT / "resources" / "icons" / (look.icon + ".svg")).is_file())

    def test_new_objects_have_view_providers_icons_and_children(self):
        design = make.make_design(self.document, preset("case1"))
        for obj in (*design.sites, design.wireframe):
            self.assertIsInstance(obj.ViewObject.Proxy, ViewProvider)
            self.assertTrue(os.path.isfile(obj.ViewObject.Proxy.getIcon()))
        children = design.wireframe.ViewObject.Proxy.claimChildren()
        self.assertEqual(children, [design.envelope, *design.sites])

    def test_a_right_click_offers_what_can_be_done_with_the_object_and_does_it(self):
        design = make.make_design(self.document, preset("case1"))
        menu = QtGui.QMenu()
        FreeCADGui.Selection.addSelection(self.document.Name, design.wireframe.Name)
        design.wireframe.ViewObject.Proxy.setupContextMenu(design.wireframe.ViewObject, menu)
        actions = {action.text(): action for action in menu.actions()}
        self.assertEqual(list(actions), ["Design rods", "Results", "Analyse at once", "Export", "Copy as script"])
        self.assertTrue(actions["Results"].isEnabled())
        actions["Results"].trigger()
        self.assertTrue(hasattr(panels.current(), "histogram"))

    def test_objects_know_their_design(self):
        design = make.make_design(self.document, preset("case1"))
        network = make.make_network(design.wireframe)
        for obj in (design.wireframe, *design.sites, network):
            self.assertEqual(wireframe_of(obj), design.wireframe)
        self.assertEqual(products_of(design.wireframe), [network])
        self.assertEqual(parts_of(design.wireframe), [network])

    def test_a_box_belongs_to_no_design(self):
        self.assertIsNone(wireframe_of(self.document.addObject("Part::Box", "Box")))

    def test_a_file_made_without_a_window_is_seen_and_edited_in_one(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "headless.FCStd")
            script = Path(folder) / "headless.py"
            script.write_text(HEADLESS.format(root=str(ROOT), path=path), encoding="utf-8")
            subprocess.run([*console_program(), str(script)], check=True, stdout=subprocess.DEVNULL, timeout=120)
            document = FreeCAD.openDocument(path)
            settle()
            network = document.getObject("Network")
            self.assertIsInstance(network.ViewObject.Proxy, ViewProvider)
            self.assertTrue(network.ViewObject.Visibility)
            panels.open_for(document.Name, "Wireframe")
            panel = panels.current()
            self.wait_for_estimate(panel)
            self.assertEqual(panel.fields.job().pores, preset("case1").pores)
            panel.reject()

    def test_a_saved_file_comes_back_with_its_looks(self):
        make.make_design(self.document, preset("case1"))
        wireframe = self.wireframe()
        wireframe.ViewObject.Visibility = False
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            document = FreeCAD.openDocument(path)
            settle()
            found = next(obj for obj in document.Objects if obj.Name == "Wireframe")
            self.assertIsInstance(found.ViewObject.Proxy, ViewProvider)
            self.assertFalse(found.ViewObject.Visibility)
            self.assertEqual(found.ViewObject.Proxy.claimChildren()[0].Name, "Envelope")


class SiteTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.design = make.make_design(self.document, preset("case3"))
        FreeCADGui.Selection.addSelection(self.document.Name, "Wireframe")
        FreeCADGui.runCommand("Trabecula_EditSite")
        self.panel = panels.current()
        self.before = list(self.document.UndoNames)

    def steps(self):
        """Return the steps to undo that were added, the last one first."""
        return self.document.UndoNames[: len(self.document.UndoNames) - len(self.before)]

    def edits(self):
        return [(edit.site, edit.action) for edit in make.edits_of(self.design.wireframe)]

    def test_a_click_on_a_site_shows_it(self):
        FreeCADGui.Selection.addSelection(self.document.Name, "Sites", "Vertex60", 0, 0, 0)
        settle(0.1)
        self.assertEqual(self.panel.site.value(), "Face2.2.4")

    def test_a_click_on_the_envelope_shows_nothing_new(self):
        before = self.panel.site.value()
        FreeCADGui.Selection.addSelection(self.document.Name, "Envelope", "Face1", 0, 0, 0)
        self.assertEqual(self.panel.site.value(), before)

    def test_a_pore_is_set_in_one_step_to_undo(self):
        self.panel.site.set_value("Face1.2.3")
        self.panel.size.set_value(0.55)
        self.panel._set_pore()
        self.assertEqual(self.edits(), [("Face1.2.3", "pore")])
        pores = make.wireframe_of(self.design.wireframe).pores["Face1"]
        names = make.wireframe_of(self.design.wireframe).sites["Face1"].names
        self.assertEqual(pores.size[names.index("Face1.2.3")], 0.55)
        self.assertEqual(self.steps(), ["Set pore"])
        self.document.undo()
        self.assertEqual(self.edits(), [])

    def test_setting_a_pore_as_it_is_changes_no_curve(self):
        before = make.wireframe_of(self.design.wireframe).pores["Face1"].angles.copy()
        self.panel.site.set_value("Face1.4.4")
        self.panel._set_pore()
        after = make.wireframe_of(self.design.wireframe).pores["Face1"].angles
        self.assertLess(abs(after - before).max(), 1e-9)  # though components are shown with three decimals

    def test_a_site_is_moved_and_switched_off_and_both_are_taken_back(self):
        self.panel.site.set_value("Face1.2.3")
        self.panel.point.set_value((0.0, 2.5, 3.5))
        self.panel._move()
        self.panel.site.set_value("Face1.1.1")
        self.panel._switch_off()
        self.assertEqual(self.edits(), [("Face1.2.3", "move"), ("Face1.1.1", "off")])
        self.assertEqual(self.design.wireframe.Rods, 146)
        self.panel.edits.list.setCurrentRow(1)
        self.panel.edits._take_back()
        self.assertEqual(self.edits(), [("Face1.2.3", "move")])
        self.assertEqual(self.steps(), ["Take back", "Switch site off", "Move site"])

    def test_a_place_off_the_face_is_refused_with_the_distance_and_nothing_changes(self):
        self.panel.site.set_value("Face1.2.3")
        self.panel.point.set_value((5.0, 2.5, 3.5))
        self.panel._move()
        self.assertEqual(len(self.dialogs), 1)
        self.assertIn("5 mm", self.dialogs[0])
        self.assertEqual((self.edits(), self.steps()), ([], []))

    def test_a_negative_size_is_refused(self):
        self.panel.size.set_value(-1.0)
        self.panel._set_pore()
        self.assertEqual(len(self.dialogs), 1)
        self.assertEqual(self.edits(), [])


class RodTest(WindowTest):
    def test_a_rod_tells_its_sites_sections_and_length(self):
        wireframe = make.wireframe_of(make.make_design(self.document, preset("case3")).wireframe)
        facts = dict(rod_facts(wireframe, 10))
        self.assertEqual(facts["Rod"], wireframe.names[10])
        self.assertEqual("-".join((facts["First site"], facts["Second site"])), wireframe.names[10])
        chord = wireframe.paths[10, 1, 3] - wireframe.paths[10, 0, 0]
        self.assertEqual(facts["Length"], f"{float((chord**2).sum() ** 0.5):.3f} mm")

    def test_a_face_of_the_network_is_traced_to_its_rod(self):
        design = make.make_design(self.document, preset("case1"))
        network = make.make_network(design.wireframe)
        dock = RodDock()
        faces = [len(solid.Faces) for solid in network.Shape.Solids]
        for rod in (0, 1, 40, 74):
            for face in (sum(faces[:rod]) + 1, sum(faces[: rod + 1])):
                self.assertEqual(dock.rod_number(network, f"Face{face}"), rod)
        self.assertIsNone(dock.rod_number(design.envelope, "Face1"))
        dock.deleteLater()

    def test_the_dock_listens_only_while_it_is_seen(self):
        make.make_network(make.make_design(self.document, preset("case1")).wireframe)
        FreeCADGui.runCommand("Trabecula_RodInfo")
        settle()
        FreeCADGui.Selection.addSelection(self.document.Name, "Network", "Face7", 0, 0, 0)
        from freecad_trabecula.gui.rod_dock import dock_of_window

        dock = dock_of_window()
        self.assertEqual(dock.table.item(0, 1).text(), self.document.getObject("Network").RodNames[1])
        FreeCADGui.runCommand("Trabecula_RodInfo")
        settle()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, "Network", "Face1", 0, 0, 0)
        self.assertEqual(dock.table.item(0, 1).text(), self.document.getObject("Network").RodNames[1])
