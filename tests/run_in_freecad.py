# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs one file of unittest cases inside FreeCAD, in the console or in the window. Started by ``run.py``.

Input is the environment variable TRABECULA_TEST: JSON with ``file``, ``result``, ``pattern`` (or null) and
``timeout`` (seconds). Output is the file ``result``: JSON with ``passed``, ``failed``, ``skipped`` and ``reasons`` (of
the skipped). The exit code is ours (FreeCAD would give 0 to a script that raises, and run it twice): 0 if a result was
written.
"""

import faulthandler
import importlib.util
import json
import os
import sys
import time
import traceback
import unittest
from pathlib import Path

import FreeCAD

ROOT = Path(__file__).resolve().parent.parent
#: ms from the start of the event loop until the tests begin: the window has then opened and settled.
SETTLING_TIME_MS = 1500
#: s after which a dialog that waits for an answer ends the run: nobody is there to give it.
DIALOG_PATIENCE = 30


class CountingResult(unittest.TextTestResult):
    """Counts each test once, by its worst outcome, however many of its parts failed."""

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)
        self.bad = set()

    def addError(self, test, error):  # noqa: N802
        """Note a test, or a class's or module's set-up, that raised."""
        super().addError(test, error)
        self.bad.add(str(test))

    def addFailure(self, test, error):  # noqa: N802
        """Note a test whose assertion failed."""
        super().addFailure(test, error)
        self.bad.add(str(test))

    def addSubTest(self, test, subtest, error):  # noqa: N802
        """Note a test one of whose parts failed."""
        super().addSubTest(test, subtest, error)
        if error is not None:
            self.bad.add(str(test))

    def addUnexpectedSuccess(self, test):  # noqa: N802
        """Note a test that was to fail and did not."""
        super().addUnexpectedSuccess(test)
        self.bad.add(str(test))

    def counts(self):
        """Return the tests passed, failed and skipped, and why these were skipped."""
        skipped = {str(test): reason for test, reason in self.skipped}
        ran = self.testsRun - len([name for name in skipped if not name.startswith("setUp")])
        # A failed setUpClass is no test that ran, but it is bad.
        failed_ran = len([name for name in self.bad if not name.startswith("setUp")])
        return {
            "passed": ran - failed_ran,
            "failed": len(self.bad),
            "skipped": len(skipped),
            "reasons": sorted(set(skipped.values())),
        }


def load_module(path):
    """Import a test file by its path."""
    # Support beside the tests (a base class, say) is importable; it comes last, so that it hides nothing.
    sys.path.append(str(path.parent))
    specification = importlib.util.spec_from_file_location(path.stem, str(path))
    module = importlib.util.module_from_spec(specification)
    sys.modules[path.stem] = module
    specification.loader.exec_module(module)
    return module


def run_file(job, stream):
    """Run the tests of one file and write their counts."""
    loader = unittest.TestLoader()
    if job["pattern"]:
        loader.testNamePatterns = ["*%s*" % job["pattern"]]
    suite = loader.loadTestsFromModule(load_module(Path(job["file"])))
    runner = unittest.TextTestRunner(stream=stream, verbosity=2, resultclass=CountingResult)
    counts = runner.run(suite).counts()
    Path(job["result"]).write_text(json.dumps(counts), encoding="utf-8")


def run_and_leave(job):
    """Run the tests and end this process."""
    # FreeCAD takes sys.stderr for its report view; the file descriptor is the runner's log.
    stream = open(2, "w", encoding="utf-8", errors="replace", buffering=1, closefd=False)  # noqa: SIM115
    faulthandler.enable(stream)
    faulthandler.dump_traceback_later(max(job["timeout"] - 20, 5), file=stream)
    status = 1
    try:
        run_file(job, stream)
        status = 0
    except BaseException:
        traceback.print_exc(file=stream)
    finally:
        faulthandler.cancel_dump_traceback_later()
        sys.stdout.flush()
        stream.flush()
        os._exit(status)


def watch_for_dialogs():
    """End this process when a modal dialog stays open, and say what it says; return the timer that looks."""
    from PySide import QtCore, QtGui

    since = {}

    def look():
        dialog = QtGui.QApplication.activeModalWidget()
        first_seen = since.setdefault(dialog, time.time())
        if dialog is None or time.time() - first_seen < DIALOG_PATIENCE:
            for other in [one for one in since if one is not dialog]:
                del since[other]
            return
        words = [label.text() for label in dialog.findChildren(QtGui.QLabel)]
        text = "a dialog waits for an answer: %r %r" % (dialog.windowTitle(), words)
        os.write(2, (text + "\n").encode("utf-8", "replace"))
        faulthandler.dump_traceback(2)
        os._exit(1)

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(1000)
    return timer


def start():
    """Run now in the console; in the window as soon as its event loop runs."""
    job = json.loads(os.environ["TRABECULA_TEST"])
    sys.path.insert(0, str(ROOT))
    if not FreeCAD.GuiUp:
        run_and_leave(job)
    from PySide import QtCore

    job["watch"] = watch_for_dialogs()
    QtCore.QTimer.singleShot(SETTLING_TIME_MS, lambda: run_and_leave(job))


start()
