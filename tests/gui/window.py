# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window's tests share: waiting with the event loop running, keys and clicks, a clean end of each test."""

import sys
import time
import traceback
import unittest

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

WORKBENCH = "TrabeculaWorkbench"


def wait(condition=lambda: False, seconds=30.0):
    """Run the event loop until a condition holds or the time is over; return whether it held."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        if condition():
            return True
        time.sleep(0.005)
    return False


def settle(seconds=0.3):
    """Run the event loop for a while."""
    wait(seconds=seconds)


def press(widget, key, text=""):
    """Press and release a key on a widget."""
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtGui.QApplication.sendEvent(widget, QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, text))


def type_into(box, text):
    """Type a text into a spin box in place of what it holds, and press Return."""
    line = box.findChild(QtGui.QLineEdit)
    QtGui.QApplication.processEvents()
    line.setFocus()
    QtGui.QApplication.processEvents()
    line.selectAll()
    for letter in text:
        press(line, 0, letter)
        QtGui.QApplication.processEvents()  # as between the keys of a person
    press(line, QtCore.Qt.Key_Return)


class Heartbeat:
    """Measures for how long the window's thread did not answer, and how much it computed meanwhile.

    Attributes
    ----------
    longest : float, s
        By the clock: on a machine with other work to do also what that took.
    busiest : float, s
        Of the thread's own processor time.
    """

    def __init__(self):
        self.longest = self.busiest = 0.0
        self._last = self._last_busy = 0.0
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)

    def _beat(self):
        now, busy = time.perf_counter(), time.thread_time()
        self.longest = max(self.longest, now - self._last)
        self.busiest = max(self.busiest, busy - self._last_busy)
        self._last, self._last_busy = now, busy

    def __enter__(self):
        self._last, self._last_busy = time.perf_counter(), time.thread_time()
        self._timer.start(5)
        return self

    def __exit__(self, *_):
        self._timer.stop()


class WindowTest(unittest.TestCase):
    """A test in the window: starts in our workbench with a new document, ends with none and no panel."""

    def setUp(self):
        from freecad_trabecula.gui import transactions

        FreeCADGui.activateWorkbench(WORKBENCH)
        self.dialogs, self.errors = [], []
        self._hook, sys.excepthook = sys.excepthook, self._note
        self._show_error = transactions.show_error
        transactions.show_error = self.dialogs.append
        self.document = FreeCAD.newDocument("Window")
        settle(0.1)

    def _note(self, kind, error, trace):
        """Keep what a slot raised, which Qt passes on to nobody."""
        self.errors.append("".join(traceback.format_exception(kind, error, trace)))
        self._hook(kind, error, trace)

    def tearDown(self):
        from freecad_trabecula.gui import panels, transactions

        transactions.show_error = self._show_error
        if FreeCADGui.Control.activeDialog():
            panel = panels.current()
            panel.reject()
        FreeCADGui.Selection.clearSelection()
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        settle(0.1)
        sys.excepthook = self._hook
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual(self.errors, [])

    def torus(self):
        """Add a torus about Z, radii 5 and 2 mm, and return it."""
        obj = self.document.addObject("Part::Torus", "Torus")
        obj.Radius1, obj.Radius2 = 5, 2
        self.document.recompute()
        return obj

    def open_preset(self, name="case1"):
        """Open the design panel with a preset and return it once the porosity is estimated."""
        from freecad_trabecula.gui import panels

        FreeCADGui.runCommand("Trabecula_Preset_" + name)
        self.assertTrue(wait(FreeCADGui.Control.activeDialog, 30), "no panel")  # later, if there was no document
        panel = panels.current()
        self.wait_for_estimate(panel)
        return panel

    def wait_for_estimate(self, panel, seconds=60.0):
        """Wait until the panel shows a porosity of its present values."""
        self.assertTrue(wait(lambda: "≈" in panel.outcome.headline.text(), seconds), "no estimate")

    def change(self, panel, action):
        """Change a value and wait for the new porosity; return the seconds that it took."""
        panel.outcome.headline.setText("")
        started = time.monotonic()
        action()
        self.wait_for_estimate(panel)
        return time.monotonic() - started

    def build(self, panel, seconds=240.0):
        """Build and wait for the end."""
        panel.build()
        self.assertTrue(
            wait(lambda: not panel.is_open, seconds), f"not built in {seconds:g} s; dialogs: {self.dialogs}"
        )
        settle(0.5)
        self.assertEqual(self.dialogs, [])

    def names(self):
        """Return the names of the document's objects."""
        return [obj.Name for obj in self.document.Objects]

    def wireframe(self):
        """Return the document's wireframe."""
        return next(obj for obj in self.document.Objects if obj.Name.startswith("Wireframe"))
