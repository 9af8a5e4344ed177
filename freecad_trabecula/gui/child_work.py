# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in a process of its own, started from the window: progress, time left, an end at once when cancelled."""

from __future__ import annotations

import os
import shutil
import tempfile
import time
from pathlib import Path
from typing import Any, Callable, List, Mapping, NamedTuple, Optional

import FreeCAD
from PySide import QtCore

from ..errors import KernelError, TrabeculaError
from ..shell.launch import PROGRAMS, START, child_environment, decode, freecad_program
from .preferences import child_threads

_GRACE = 4000  # ms from closing its standard input until a child that does not end is killed
_SURE = 0.03  # share of the work from which on the time left is guessed


class Progress(NamedTuple):
    """Share done (0..1), what is being done, seconds left (None: not known yet)."""

    share: float
    what: str
    left: Optional[float]


class ChildWork(QtCore.QObject):
    """Runs ``run(options, report)`` of a module of ours under FreeCAD's console program.

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

    def __init__(self, module: str, options: Mapping[str, Any], folder: str) -> None:
        super().__init__()
        self._folder = folder
        self._buffer = b""
        self._chatter: List[str] = []
        self._error = ""
        self._code: Optional[int] = None
        self._silent = False
        self._started = time.monotonic()
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
        words = console_program()
        self.process.start(words[0], [*words[1:], START])

    def cancel(self) -> None:
        """End the work; nothing more is heard of it."""
        self._silent = True
        self.process.closeWriteChannel()
        QtCore.QTimer.singleShot(_GRACE, self._kill)

    def _kill(self) -> None:
        if self.process.state() != QtCore.QProcess.NotRunning:
            self.process.kill()

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
            share = float(message["share"])
            self.progressed.emit(Progress(share, message["what"], self._left(share)))
        elif kind == "error":
            self._error = message["text"]
        elif kind == "trace":
            self._chatter.append(message["text"])
        elif kind == "end":
            self._code = message["code"]

    def _left(self, share: float) -> Optional[float]:
        return (time.monotonic() - self._started) * (1 - share) / share if share > _SURE else None

    def _finished(self, *_: Any) -> None:
        self._read()
        if not self._silent:
            if self._code == 0:
                self.succeeded.emit(self._folder)
            else:
                FreeCAD.Console.PrintLog("\n".join(self._chatter) + "\n")
                self.failed.emit(self._error or "FreeCAD's console program ended before its work was done")
        shutil.rmtree(self._folder, ignore_errors=True)

    def _not_started(self, error: Any) -> None:
        if error == QtCore.QProcess.FailedToStart and not self._silent:
            self.failed.emit(f"FreeCAD's console program could not be started: {self.process.errorString()}")
            shutil.rmtree(self._folder, ignore_errors=True)


def task_work(prepare: Callable[[str], None]) -> ChildWork:
    """Return the work, not yet started, of a task that ``prepare(folder)`` writes.

    Raises
    ------
    TrabeculaError
        What ``prepare`` raises; the folder is removed then.
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
    return ChildWork("freecad_trabecula.shell.worker", {"folder": folder}, folder)


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
