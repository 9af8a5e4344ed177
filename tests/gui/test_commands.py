# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands: registered with texts and icons, usable when they can do something, recorded, files written."""

import os
import sys
import tempfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest, wait

from freecad_trabecula import make
from freecad_trabecula.core.job import job_from_json
from freecad_trabecula.core.presets import preset
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.gui import commands, export_dialog, install, panels, rod_commands, transactions
from freecad_trabecula.gui.child_work import time_text

PLACED = [name for _, _, names in commands.GROUPS for name in names if name]


class CommandTest(WindowTest):
    def test_every_command_has_a_text_a_tooltip_and_an_icon(self):
        for name in commands.COMMANDS:
            with self.subTest(command=name):
                info = FreeCADGui.Command.get(name).getInfo()
                self.assertTrue(info["menuText"] and info["toolTip"])
                self.assertTrue(os.path.isfile(info["pixmap"]))

    def test_every_tooltip_says_what_must_be_selected_or_be_there(self):
        for name, command in commands.COMMANDS.items():
            with self.subTest(command=name):
                self.assertRegex(command.TIP, "(Select|Needs) ")

    def test_every_command_has_its_place_and_no_two_have_the_same_keys(self):
        self.assertEqual(len(PLACED), len(set(PLACED)))
        groups = [one for one in commands.COMMANDS.values() if hasattr(one, "GetCommands")]
        self.assertEqual({*PLACED, *(name for one in groups for name in one.GetCommands())}, set(commands.COMMANDS))
        keys = [command.KEYS for command in commands.COMMANDS.values() if command.KEYS]
        self.assertEqual(len(keys), len(set(keys)))

    def test_the_toolbars_and_the_menu_hold_the_commands_in_the_order_of_work(self):
        window = FreeCADGui.getMainWindow()
        every = window.menuBar().findChildren(QtGui.QMenu)
        ours = next(menu for menu in every if menu.title() == "&Trabecula")
        below = [menu for menu in every if any(one == menu.menuAction() for one in ours.actions())]
        menus = {menu.title(): menu for menu in [ours, *below]}  # FreeCAD has its own Help
        for title, submenu, names in commands.GROUPS:
            texts = [commands.COMMANDS[name].TEXT for name in names if name]
            for place in (window.findChild(QtGui.QToolBar, title), menus[submenu or "&Trabecula"]):
                found = [one.text().replace("&", "") for one in place.actions() if not one.isSeparator()]
                self.assertEqual([text for text in found if text in texts], texts)

    def test_without_a_design_only_what_makes_one_can_be_used(self):
        self.assertTrue(FreeCADGui.Command.get("Trabecula_Design").isActive())
        for name in ("Trabecula_Network", "Trabecula_Results", "Trabecula_Export", "Trabecula_SaveJob"):
            self.assertFalse(FreeCADGui.Command.get(name).isActive(), name)

    def test_while_a_panel_is_open_no_other_can_be(self):
        self.open_preset("case1")
        for name in ("Trabecula_Design", "Trabecula_OpenJob", "Trabecula_Preset_case2"):
            self.assertFalse(FreeCADGui.Command.get(name).isActive(), name)
            self.assertEqual(commands.COMMANDS[name].reason(), "close the open task panel first")

    def test_without_a_document_a_preset_makes_one(self):
        FreeCAD.closeDocument(self.document.Name)
        FreeCADGui.runCommand("Trabecula_Preset_case1")
        self.assertIsNotNone(FreeCAD.ActiveDocument)
        self.assertFalse(FreeCADGui.Control.activeDialog())  # the document has a turn of the event loop to itself
        self.assertTrue(wait(FreeCADGui.Control.activeDialog, 30))
        self.wait_for_estimate(panels.current())
        self.assertEqual(len(FreeCAD.listDocuments()), 1)

    def test_the_design_command_opens_the_selected_design(self):
        make.make_design(self.document, preset("case2"))
        FreeCADGui.Selection.addSelection(self.document.Name, "Sites")
        FreeCADGui.runCommand("Trabecula_Design")
        panel = panels.current()
        self.assertEqual(panel.wireframe.Name, "Wireframe")
        self.assertEqual(panel.fields.job().pores, preset("case2").pores)

    def test_a_command_that_cannot_be_used_says_why_and_no_longer_when_it_can(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        cases = (
            ("Trabecula_FaceSites", "select a solid"),
            ("Trabecula_AnalyseNow", "select a network, a scaffold, a mesh or a solid"),
        )
        for name, sentence in cases:
            with self.subTest(command=name):
                FreeCADGui.Selection.clearSelection()
                command = FreeCADGui.Command.get(name)
                action = command.getAction()[0]
                self.assertFalse(command.isActive())
                for words in (action.toolTip(), action.statusTip()):
                    self.assertIn("Not now: " + sentence, words)
                FreeCADGui.Selection.addSelection(box)
                self.assertTrue(command.isActive())
                for words in (action.toolTip(), action.statusTip()):
                    self.assertNotIn("Not now", words)
                    self.assertIn(commands.COMMANDS[name].TIP[:40], words)  # FreeCAD breaks lines

    def test_each_reason_names_what_is_missing(self):
        reasons = {
            "Trabecula_Scaffold": "there is no design of rods yet",
            "Trabecula_Compare": "there is no analysis yet",
            "Trabecula_VoxelExport": "there is no voxel design yet",
            "Trabecula_Design": "",
        }
        for name, reason in reasons.items():
            self.assertEqual(commands.COMMANDS[name].reason(), reason)
        make.make_design(self.document, preset("case1"))
        self.assertEqual(commands.COMMANDS["Trabecula_Switch"].reason(), "build a scaffold first")
        self.assertEqual(commands.COMMANDS["Trabecula_Export"].reason(), "build a scaffold or a network first")
        FreeCAD.closeDocument(self.document.Name)
        self.assertEqual(commands.COMMANDS["Trabecula_FaceSites"].reason(), "no document is open")

    def test_building_from_the_toolbar_builds_and_opens_the_results(self):
        make.make_design(self.document, preset("case1"))
        FreeCADGui.runCommand("Trabecula_Network")
        self.assertTrue(wait(lambda: self.document.getObject("Network") is not None, 120))
        self.assertTrue(wait(lambda: hasattr(panels.current(), "histogram"), 30))
        self.assertEqual(self.dialogs, [])

    def test_channels_before_a_scaffold_are_refused(self):
        design = make.make_design(self.document, preset("case1"))
        with self.assertRaisesRegex(ParameterError, "build the scaffold first"):
            rod_commands.switch_view(design.wireframe)

    def test_what_a_panel_does_can_be_run_as_a_macro(self):
        lines = []
        panel = self.open_preset("case1")

        def record(line):
            lines.append(line)
            transactions.record(line)

        with mock.patch("freecad_trabecula.gui.building.record", record):
            panel.accept()
            self.assertTrue(wait(lambda: not panel.is_open, 60))
        self.document.undo()
        self.assertEqual(self.names(), [])
        exec("\n".join(lines), {})  # noqa: S102  this is what a macro is
        self.assertEqual(self.wireframe().Rods, 75)


class TransactionTest(WindowTest):
    def test_an_error_takes_everything_back(self):
        with self.assertRaises(ParameterError), transactions.transaction(self.document, "Fails"):
            self.document.addObject("Part::Box", "Box")
            raise ParameterError("a rule")
        self.assertEqual((self.names(), self.document.UndoNames), ([], []))

    def test_an_error_on_purpose_becomes_a_dialog_and_another_does_not(self):
        with transactions.told():
            raise ParameterError("rule, value, unit")
        self.assertEqual(self.dialogs, ["rule, value, unit"])
        with self.assertRaises(ZeroDivisionError), transactions.told():
            raise ZeroDivisionError


class FilesTest(WindowTest):
    def test_a_saved_job_opens_with_the_same_values(self):
        make.make_design(self.document, preset("case4"))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "own.json")
            with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, "")):
                FreeCADGui.runCommand("Trabecula_SaveJob")
            self.assertEqual(job_from_json(Path(path).read_text(encoding="utf-8")).wireframe, preset("case4").wireframe)
            with mock.patch.object(QtGui.QFileDialog, "getOpenFileName", lambda *_: (path, "")):
                FreeCADGui.runCommand("Trabecula_OpenJob")
            self.assertEqual(panels.current().fields.job().wireframe, preset("case4").wireframe)

    def test_a_job_file_with_an_unknown_key_is_refused_by_its_name(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bad.json")
            Path(path).write_text('{"schema": 1, "porez": {}}', encoding="utf-8")
            with mock.patch.object(QtGui.QFileDialog, "getOpenFileName", lambda *_: (path, "")):
                FreeCADGui.runCommand("Trabecula_OpenJob")
        self.assertEqual(len(self.dialogs), 1)
        self.assertIn("porez", self.dialogs[0])
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_the_size_shown_before_is_that_of_the_file(self):
        design = make.make_design(self.document, preset("case1"))
        network = make.make_network(design.wireframe)
        expected = export_dialog.estimated_size(network, "brep")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "network.brep")
            export_dialog.write_body(network, path)
            self.assertLess(abs(os.path.getsize(path) - expected), 0.2 * expected)

    def test_exporting_to_a_folder_that_is_missing_is_refused(self):
        design = make.make_design(self.document, preset("case1"))
        network = make.make_network(design.wireframe)
        with transactions.told():
            export_dialog.write_body(network, "/nowhere/network.step")
        self.assertEqual(len(self.dialogs), 1)
        self.assertIn("/nowhere", self.dialogs[0])

    def test_labels_that_no_file_can_have_are_offered_as_names_that_it_can(self):
        body, asked = self.document.addObject("Part::Box", "Box"), []
        self.document.Label, body.Label = "Hüfte 1/2", 'Gerüst: <a\\b> "neu"?'
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *words: asked.append(words[2]) or ("", "")):
            self.assertIsNone(export_dialog.ask_and_write(body, "stl", None))
        self.assertRegex(os.path.basename(asked[0]), r"^[A-Za-z0-9_-]+\.stl$")  # ASCII that every system takes
        for word in ("Huefte", "1", "2", "Geruest", "a", "b", "neu"):
            self.assertIn(word, os.path.basename(asked[0])[:-4].replace("-", "_").split("_"))

    def test_a_design_without_bodies_has_nothing_to_export(self):
        design = make.make_design(self.document, preset("case1"))
        with self.assertRaisesRegex(ParameterError, "build one first"):
            export_dialog.export_design(design.wireframe)

    def test_sizes_and_times_are_said_as_people_say_them(self):
        self.assertEqual(export_dialog.size_text(950), "950 B")
        self.assertEqual(export_dialog.size_text(1.5e9), "1.50 GB")
        self.assertEqual(time_text(0.2), "1 s")
        self.assertEqual(time_text(61), "1 min 1 s")


class InstallTest(WindowTest):
    def test_pip_of_this_python_installs_into_freecads_own_folder(self):
        words = install.install_words(install.package_folder())
        self.assertIn("--target", words)
        self.assertTrue(words[words.index("--target") + 1].startswith(FreeCAD.getUserAppDataDir()))
        self.assertEqual(words[-1], "manifold3d")
        self.assertIn("python", os.path.basename(words[0]))
        self.assertNotIn("freecad", os.path.basename(words[0]).lower())
        self.assertTrue(os.access(words[0], os.X_OK))
        self.assertIn(f"{sys.version_info.major}", os.path.realpath(words[0]))

    def test_the_dialog_runs_the_command_and_says_how_it_ended(self):
        with mock.patch.object(
            install, "install_words", lambda folder: [install.python_program(), "-c", "print('done')"]
        ):
            dialog = install.InstallDialog(FreeCADGui.getMainWindow(), "manifold3d is missing")
            dialog.install()
            self.assertTrue(wait(lambda: "is installed" in dialog.label.text(), 30), dialog.output.toPlainText())
        self.assertIn("done", dialog.output.toPlainText())
        dialog.close()

    def test_a_failed_installation_is_told(self):
        with mock.patch.object(
            install, "install_words", lambda folder: [install.python_program(), "-c", "raise SystemExit(1)"]
        ):
            dialog = install.InstallDialog(FreeCADGui.getMainWindow(), "manifold3d is missing")
            dialog.install()
            self.assertTrue(wait(lambda: "could not" in dialog.label.text(), 30))
        dialog.close()
