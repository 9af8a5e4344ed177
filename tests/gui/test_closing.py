# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents, and FreeCAD itself, that are closed while work goes on: no process survives, nothing is told.

The processes are stopped (SIGSTOP), so that none of them can end by itself: whoever is gone was killed.
"""

import json
import os
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.features import results
from freecad_trabecula.gui import child_work, panels
from freecad_trabecula.gui.background import is_busy
from freecad_trabecula.gui.building import Writing
from freecad_trabecula.gui.child_work import ChildWork
from freecad_trabecula.gui.notice import notices
from freecad_trabecula.gui.recomputing import of_window as recomputing

#: Seconds in which a killed process is gone, on a busy machine too.
PATIENCE = 20.0
COMMANDS = {"build": "Trabecula_Design", "analysis": "Trabecula_Analysis", "voxels": "Trabecula_Voxels"}


def is_running(number):
    """Return whether there is a process of a number that has not ended."""
    try:
        text = Path(f"/proc/{number}/stat").read_text(encoding="ascii", errors="replace")
    except OSError:
        return False
    return text.rpartition(")")[2].split()[0] != "Z"


class ClosingTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.add_body()

    def add_body(self):
        """A body in the document, of which nothing is at hand."""
        results.clear()
        if self.document.getObject("Sample") is None:
            self.body = self.document.addObject("Part::Feature", "Sample")
            self.body.Shape = Part.makeBox(4, 4, 5).cut(Part.makeBox(2, 2, 99))
            self.document.recompute()

    def start(self, kind):
        """Have work of a kind begin in its panel; return the panel."""
        if kind == "build":
            panel = self.open_preset("case1")
            panel.build()
            return panel
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, self.body.Name)
        FreeCADGui.runCommand(COMMANDS[kind])
        panel = panels.current()
        panel.work()
        return panel

    def stopped_child(self):
        """Stop the process that works, and return its number."""
        self.assertTrue(wait(lambda: any(one.process.processId() for one in ChildWork._running), 30), self.dialogs)
        (number,) = [int(one.process.processId()) for one in ChildWork._running]
        os.kill(number, signal.SIGSTOP)
        self.assertTrue(is_running(number))
        return number

    def assert_killed_by_closing(self, number):
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(wait(lambda: not is_running(number), PATIENCE), "the process goes on")
        settle(0.5)
        self.assertEqual((self.dialogs, self.errors, notices().texts()), ([], [], []))
        self.assertFalse(is_busy() or recomputing().bars() or FreeCADGui.Control.activeDialog())
        self.assertTrue(wait(lambda: not ChildWork._running, 10))
        self.document = FreeCAD.newDocument("Window")

    def test_a_process_has_less_than_a_second_to_end_by_itself(self):
        self.assertLess(child_work._GRACE, 1000)

    def test_work_in_the_background_ends_with_its_document(self):
        for kind in COMMANDS:
            with self.subTest(kind):
                self.add_body()
                self.start(kind).leave()
                self.assert_killed_by_closing(self.stopped_child())

    def test_work_of_an_open_panel_ends_with_its_document(self):
        for kind in COMMANDS:
            with self.subTest(kind):
                self.add_body()
                self.start(kind)
                self.assert_killed_by_closing(self.stopped_child())

    def test_an_analysis_by_one_click_and_a_recompute_end_with_their_document(self):
        FreeCADGui.Selection.addSelection(self.document.Name, self.body.Name)
        FreeCADGui.runCommand("Trabecula_AnalyseNow")
        self.assert_killed_by_closing(self.stopped_child())
        wireframe = make.make_design(self.document, preset("case6")).wireframe
        wireframe.Seed = 5
        self.document.recompute()
        self.assert_killed_by_closing(self.stopped_child())

    def test_a_design_that_is_being_written_goes_with_its_document(self):
        panel = self.start("build")
        panel.leave()
        write, seen = Writing._write_design, []

        def close_after(writing):
            write(writing)
            seen.append(writing)
            QtCore.QTimer.singleShot(0, lambda: FreeCAD.closeDocument("Window"))

        Writing._write_design = close_after
        try:
            self.assertTrue(wait(lambda: seen, 120), self.dialogs)
            settle(1.0)
        finally:
            Writing._write_design = write
        self.assertNotIn("Window", FreeCAD.listDocuments())
        self.assertEqual((self.dialogs, self.errors, notices().texts(), is_busy()), ([], [], [], False))
        self.document = FreeCAD.newDocument("Window")

    def test_closing_one_document_leaves_the_work_of_another(self):
        self.start("analysis").leave()
        other = FreeCAD.newDocument("Other")
        settle(0.2)
        FreeCAD.closeDocument(other.Name)
        self.assertTrue(is_busy(self.document.Name))
        self.assertTrue(wait(lambda: not is_busy(), 240))
        self.assertEqual(len([one for one in self.names() if one.startswith("Analysis")]), 1)


#: Run in a FreeCAD of its own: work of each kind is left to the background, its process stopped, the window closed.
SCRIPT = """
import json, os, signal, sys
import FreeCAD, FreeCADGui, Part
sys.path.insert(0, {tests!r})
from window import wait
from freecad_trabecula.gui import panels
from freecad_trabecula.gui.child_work import ChildWork
from freecad_trabecula.core.presets import preset
from PySide import QtCore, QtGui

def answer():
    box = QtGui.QApplication.activeModalWidget()
    for button in box.findChildren(QtGui.QDialogButtonBox) if box is not None else ():
        for one in button.buttons():
            if button.buttonRole(one) == QtGui.QDialogButtonBox.DestructiveRole:
                one.click()
                return

answers = QtCore.QTimer()
answers.timeout.connect(answer)

def run():
    FreeCADGui.activateWorkbench("TrabeculaWorkbench")
    for command in {commands!r}:
        document = FreeCAD.newDocument()
        body = document.addObject("Part::Feature", "Sample")
        body.Shape = Part.makeBox(4, 4, 5).cut(Part.makeBox(2, 2, 99))
        document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(document.Name, body.Name)
        if command == "Trabecula_Design":
            panels.open_new(document, preset("case6"))
            wait(lambda: "\\N{{ALMOST EQUAL TO}}" in panels.current().outcome.headline.text(), 120)
            panels.current().build()
        else:
            FreeCADGui.runCommand(command)
            panels.current().work()
        panels.current().leave()
        wait(lambda: not FreeCADGui.Control.activeDialog(), 10)
        wait(seconds=0.3)
    wait(lambda: all(one.process.processId() for one in ChildWork._running), 30)
    numbers = [int(one.process.processId()) for one in ChildWork._running]
    for number in numbers:
        os.kill(number, signal.SIGSTOP)
    with open({result!r}, "w") as file:
        json.dump(numbers, file)
    answers.start(50)
    FreeCADGui.getMainWindow().close()

QtCore.QTimer.singleShot(1000, run)
"""


class FreeCADClosedTest(WindowTest):
    def test_no_process_survives_freecad(self):
        with tempfile.TemporaryDirectory() as folder:
            home, result, script = (Path(folder) / name for name in ("home", "result.json", "close.py"))
            shutil.copytree(os.environ["FREECAD_USER_HOME"], home, symlinks=True)
            script.write_text(
                SCRIPT.format(tests=str(Path(__file__).parent), result=str(result), commands=tuple(COMMANDS.values())),
                encoding="utf-8",
            )
            environment = dict(os.environ, FREECAD_USER_HOME=str(home))
            environment.pop("TRABECULA_TEST", None)
            program = QtCore.QCoreApplication.applicationFilePath()
            done = []
            with open(Path(folder) / "log.txt", "wb") as log:
                process = subprocess.Popen([program, str(script)], env=environment, stdout=log, stderr=log)
                try:
                    wait(lambda: process.poll() is not None, 120)
                    done.append(process.poll())
                finally:
                    process.kill()
                    process.wait()
            said = (Path(folder) / "log.txt").read_text(encoding="utf-8", errors="replace")
            self.assertIsNotNone(done[0], "FreeCAD was not closed: " + said)
            self.assertTrue(result.exists(), said)
            numbers = json.loads(result.read_text())
        self.assertEqual(len(numbers), len(COMMANDS), said)
        left = [number for number in numbers if is_running(number)]
        for number in left:
            os.kill(number, signal.SIGKILL)
        self.assertEqual(left, [], said)
        self.assertNotIn("Traceback", said)
