# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps in a FreeCAD window: for how long it did not answer in each, and what its thread did meanwhile."""

import json
import sys
import threading
import time
from collections import Counter
from contextlib import contextmanager
from pathlib import Path

from PySide import QtGui
from window import Heartbeat, wait

GOAL = 0.2  # s


class Watched(Heartbeat):
    """A heartbeat that says what the thread did in the busiest stretch."""

    def __init__(self):
        super().__init__()
        self.where = ""
        self._seen, self._ends = [], False
        self._main = threading.get_ident()
        self._watcher = threading.Thread(target=self._watch, daemon=True)

    def _watch(self):
        while not self._ends:
            frame = sys._current_frames().get(self._main)
            if frame is not None:
                self._seen.append(place(frame))
            time.sleep(0.01)

    def _beat(self):
        before, seen, start = self.busiest, self._seen, self._last_busy
        self._seen = []
        super()._beat()
        counts = Counter(seen).most_common(8)
        if self.busiest > before and counts:
            self.where = counts[0][0]
        if self._last_busy - start > GOAL / 2:
            told = "; ".join(f"{count} {words}" for words, count in counts)
            print(f"    {self._last_busy - start:.2f} s: {told}", file=sys.__stdout__, flush=True)

    def __enter__(self):
        self._watcher.start()
        return super().__enter__()

    def __exit__(self, *_):
        super().__exit__()
        self._ends = True
        self._watcher.join()


def place(frame):
    """Return the innermost line of ours of a stack, and the innermost of all."""
    lines = []
    while frame is not None:
        file = Path(frame.f_code.co_filename)
        is_ours = "freecad_trabecula" in file.parts
        if not lines or is_ours:
            lines.append(f"{file.stem}.{frame.f_code.co_name}:{frame.f_lineno}")
        if is_ours:
            break
        frame = frame.f_back
    return " < ".join(dict.fromkeys(lines))


class Steps:
    """What has been measured, step by step.

    Parameters
    ----------
    work : str
    result : str
        File that gets the rows, anew after each step.
    pictures : str
        Folder of pictures of the screen after each step; none are taken without one.
    """

    def __init__(self, work, result, pictures=""):
        self.rows, self._work, self._result, self._pictures = [], work, Path(result), pictures

    @contextmanager
    def step(self, name):
        """Measure one step, from the click until what comes of it has been seen for a second."""
        wait(seconds=0.5)
        with Watched() as beats:
            yield
            wait(seconds=1.0)
        self.rows.append({"step": name, "wall": beats.longest, "busy": beats.busiest, "where": beats.where})
        self._result.write_text(json.dumps(self.rows), encoding="utf-8")
        if self._pictures:
            file = Path(self._pictures) / f"{self._work}-{len(self.rows)}.png"
            QtGui.QGuiApplication.primaryScreen().grabWindow(0).save(str(file))


def until(condition, seconds=600):
    """Run the event loop until a condition holds.

    Raises
    ------
    SystemExit
        If it does not in time.
    """
    if not wait(condition, seconds):
        raise SystemExit(f"not done in {seconds} s")
