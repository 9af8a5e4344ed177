# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in a process of its own, started from the window: progress, time left, an end at once when cancelled."""

from __future__ import annotations

import math
import os
import shutil
import tempfile
import time
from pathlib import Path
from typing import Any, Callable, List, Mapping, NamedTuple, Optional, Set

import FreeCAD
from PySide import QtCore

from ..core.time_left import TimeLeft
from ..errors import KernelError, TrabeculaError
from ..shell.launch import PROGRAMS, START, child_environment, decode, freecad_program
from .language import in_words
from .preferences import child_threads
from .qt import invoke_later

translate = FreeCAD.Qt.translate
_GRACE = 500  # ms from closing its standard input until a child that does not end is killed
#: The same for work that writes into folders of the user's: what it has begun is removed there.
TIDY_GRACE = 4000
_TICK = 1000  # ms between two looks at the clock while nothing is reported


class Progress(NamedTuple):
    """Share done (0..1), what is being done, seconds left (None: not known yet)."""

    share: float
    what: str
    left: Optional[float]


class ChildWork(QtCore.QObject):
    """Runs ``run(options, report)`` of a module of ours under FreeCAD's console program.

    Once started it lives until its process is gone, whoever has forgotten it by then.

    Parameters
    ----------
    module : str
        E.g. ``freecad_trabecula.shell.worker``.
    options : dict
    folder : str
        Working folder; it is removed when the process has ended.
    """

    progressed = QtCore.Signal(object)
    #: The work was done; the folder still holds the results.
    succeeded = QtCore.Signal(str)
    failed = QtCore.Signal(str)
    _running: Set[ChildWork] = set()

    def __init__(self, module: str, options: Mapping[str, Any], folder: str) -> None:
        super().__init__()
        self._folder = folder
        self._buffer = b""
        self._chatter: List[str] = []
        self._error = ""
        self._code: Optional[int] = None
        self._silent = False
        self._left, self._latest = TimeLeft(time.monotonic), Progress(0.0, "", None)
        self._ticks = QtCore.QTimer(self)
        self._ticks.timeout.connect(lambda: self._tell(self._latest.share, self._latest.what))
        self.process = QtCore.QProcess()
        environment = QtCore.QProcessEnvironment()
        for name, value in child_environment(module, options).items():
            environment.insert(name, value)
        for name, value in child_threads().items():
            environment.insert(name, value)
        self.process.setProcessEnvironment(environment)
        self.process.setProcessChannelMode(QtCore.QProcess.MergedChannels)
        self.process.readyReadStandardOutput.connect(self._read)
        self.process.finished.connect(self._finished)
        self.process.errorOccurred.connect(self._not_started)

    def start(self) -> None:
        """Start the process.

        Raises
        ------
        DependencyError
            If FreeCAD's console program is not found.
        """
        try:
            words = console_program()
        except TrabeculaError:
            shutil.rmtree(self._folder, ignore_errors=True)
            raise
        _end_with_window()
        ChildWork._running.add(self)
        self._ticks.start(_TICK)
        self.process.start(words[0], [*words[1:], START])

    def cancel(self, grace: int = _GRACE) -> None:
        """End the work; nothing more is heard of it. After ``grace``, ms, a process that goes on is killed."""
        self._silent = True
        self._ticks.stop()
        self.process.closeWriteChannel()
        QtCore.QTimer.singleShot(grace, self._kill)

    def _kill(self) -> None:
        if self.process.state() != QtCore.QProcess.NotRunning:
            self.process.kill()

    @classmethod
    def end_all(cls) -> None:
        """End all work at once, for the event loop will not come back: FreeCAD is being closed."""
        works = list(cls._running)
        for work in works:
            work.cancel()
        end = time.monotonic() + _GRACE / 1000
        for work in works:
            left = max(int(1000 * (end - time.monotonic())), 1)
            if work.process.state() != QtCore.QProcess.NotRunning and not work.process.waitForFinished(left):
                work.process.kill()
                work.process.waitForFinished(_GRACE)

    # ----------------------------------------------------------------------------------------------- what it says

    def _read(self) -> None:
        *lines, self._buffer = (self._buffer + bytes(self.process.readAllStandardOutput())).split(b"\n")
        for raw in lines:
            line = raw.decode("utf-8", "replace")
            message = decode(line)
            if message is None:
                self._chatter.append(line)
                del self._chatter[:-500]
            else:
                self._take(message)

    def _take(self, message: Mapping[str, Any]) -> None:
        kind = message["kind"]
        if kind == "progress" and not self._silent:
            self._left.report(float(message["share"]))
            self._tell(float(message["share"]), message["what"])
        elif kind == "error":
            self._error = message["text"]
        elif kind == "trace":
            self._chatter.append(message["text"])
        elif kind == "end":
            self._code = message["code"]

    def _tell(self, share: float, what: str) -> None:
        """Tell how far it is; between two reports the time left runs down."""
        self._latest = Progress(share, what, self._left.seconds())
        if what and not self._silent:
            self.progressed.emit(self._latest)

    def _finished(self, *_: Any) -> None:
        self._ticks.stop()
        self._read()
        if not self._silent:
            if self._code == 0:
                self.succeeded.emit(self._folder)
            else:
                FreeCAD.Console.PrintLog("\n".join(self._chatter) + "\n")
                self.failed.emit(self._error or "FreeCAD's console program ended before its work was done")
        self._end()

    def _not_started(self, error: Any) -> None:
        self._ticks.stop()
        if error == QtCore.QProcess.FailedToStart:
            QtCore.QTimer.singleShot(0, self._tell_not_started)  # Windows knows it within ``start``

    def _tell_not_started(self) -> None:
        if not self._silent:
            self.failed.emit(f"FreeCAD's console program could not be started: {self.process.errorString()}")
        self._end()

    def _end(self) -> None:
        shutil.rmtree(self._folder, ignore_errors=True)
        QtCore.QTimer.singleShot(0, lambda: ChildWork._running.discard(self))  # not within its own signal


_ends: List[bool] = []


def _end_with_window() -> None:
    """Have no process outlive FreeCAD; said to Qt once."""
    if not _ends:
        _ends.append(True)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(ChildWork.end_all)


def start_task(
    prepare: Callable[[str], None],
    progressed: Callable[[Progress], None],
    succeeded: Callable[[str], None],
    failed: Callable[[str], None],
) -> ChildWork:
    """Start the work of a task and return it.

    Parameters
    ----------
    prepare : callable
        Writes the task into the folder that it takes.
    progressed, succeeded, failed : callable
        Called by the signals of ``ChildWork``, until it is cancelled.

    Raises
    ------
    TrabeculaError
        What ``prepare`` raises, or that the process cannot be started; the folder is removed then.
    """
    folder = tempfile.mkdtemp(prefix="trabecula-")
    try:
        prepare(folder)
    except TrabeculaError:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    except OSError as error:
        shutil.rmtree(folder, ignore_errors=True)
        raise KernelError(f"the work could not be handed over in {folder}: {error}") from error
    work = ChildWork("freecad_trabecula.shell.worker", {"folder": folder}, folder)
    work.progressed.connect(progressed)
    work.succeeded.connect(succeeded)
    work.failed.connect(failed)
    work.start()
    invoke_later(_load_views)
    return work


def _load_views() -> None:
    """Load what FreeCAD itself would load when the first mesh is shown, which takes it 0.15 s: now nobody waits."""
    import MeshGui  # noqa: F401


def console_program() -> List[str]:
    """Return the words that run FreeCAD without a window: FREECADCMD, beside this FreeCAD, or on PATH.

    Raises
    ------
    DependencyError
        If there is none.
    """
    if not os.environ.get("FREECADCMD", "").strip():
        own = Path(QtCore.QCoreApplication.applicationFilePath()).parent
        for folder in (own, Path(FreeCAD.getHomePath()) / "bin"):
            for name in PROGRAMS:
                for ending in ("", ".exe"):
                    if (folder / (name + ending)).is_file():
                        return [str(folder / (name + ending))]
    return freecad_program()


def time_text(seconds: float) -> str:
    """Return a time left as a person would say it.

    Examples
    --------
    >>> time_text(4.2), time_text(130)
    ('5 s', '2 min 10 s')
    """
    whole = max(int(-(-seconds // 1)), 1)
    return f"{whole} s" if whole < 60 else f"{whole // 60} min {whole % 60} s"


def progress_text(progress: Progress) -> str:
    """Return what is being done and how long it still takes, in round numbers: they are looked at, not reckoned with.

    Examples
    --------
    >>> progress_text(Progress(0.5, "rods", 130.0)), progress_text(Progress(0.9, "rods", 3.0))
    ('rods, about 2 min left', 'rods, a few seconds left')
    """
    what, left = in_words(progress.what), progress.left
    if left is None:
        return what
    if left < 5:
        return translate("Trabecula", "{}, a few seconds left").format(what)
    if left < 55:
        return translate("Trabecula", "{}, about {} s left").format(what, 5 * math.ceil(left / 5))
    minutes = int(left / 60 + 0.5)
    if minutes < 60:
        return translate("Trabecula", "{}, about {} min left").format(what, max(minutes, 1))
    return translate("Trabecula", "{}, about {} h {} min left").format(what, minutes // 60, minutes % 60)
