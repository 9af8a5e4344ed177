# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a command under FreeCAD, in a process of its own, from any Python: standard library only.

FreeCAD's own parser never sees an option (they travel as JSON in an environment variable), its exit code is not
believed (0 even when a script raised), and its chatter is kept apart: what the process has to say comes as marked lines
on its standard output, everything else is kept for the trace. The window starts its long work the same way.
"""

from __future__ import annotations

import collections
import importlib.util
import io
import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any, Callable, Deque, Dict, List, Mapping, Optional, Sequence

from ..errors import DependencyError
from .arguments import PROGRAM, read_arguments

#: Programs that run FreeCAD without a window, in the order in which they are looked for.
PROGRAMS = ("freecadcmd", "FreeCADCmd", "freecad.cmd")
VARIABLE = "TRABECULA_COMMAND"
MARK = "\x1etrabecula "
START = str(Path(__file__).resolve().with_name("start.py"))
FAILED, WRONG_INPUT, STOPPED = 1, 2, 130
_GRACE = 5.0  # s that a stopped process has to tidy up after itself
_KEPT_LINES = 5000  # of FreeCAD's chatter, for the trace

Message = Dict[str, Any]


# ------------------------------------------------------------------------------------------ what is needed to start it


def freecad_program() -> List[str]:
    """Return the words that run FreeCAD without a window.

    FREECADCMD comes first, then PATH, then the Python that runs this, if FreeCAD can be imported there.

    Raises
    ------
    DependencyError
        If there is no FreeCAD.
    """
    chosen = os.environ.get("FREECADCMD", "").strip()
    if chosen:
        words = [chosen] if os.path.exists(chosen) else shlex.split(chosen)
        if not words or shutil.which(words[0]) is None:
            raise DependencyError(f"FREECADCMD must name a program that can be run, got {chosen!r}")
        return words
    for name in PROGRAMS:
        found = shutil.which(name)
        if found:
            return [found]
    python = os.path.basename(sys.executable or "").lower().startswith("python")
    if python and importlib.util.find_spec("FreeCAD") and importlib.util.find_spec("numpy"):
        return [sys.executable]
    raise DependencyError(
        f"FreeCAD is needed, and none of {', '.join(PROGRAMS)} was found on PATH: install FreeCAD (on Debian: apt "
        "install freecad), or set FREECADCMD to its console program"
    )


def child_environment(module: str, options: Mapping[str, Any]) -> Dict[str, str]:
    """Return the environment in which ``START``, given to FreeCAD, calls ``run(options, report)`` of a module.

    Parameters
    ----------
    module : str
        Full name, e.g. ``freecad_trabecula.shell.design``.
    options : dict
        JSON-able. The process ends by itself as soon as its standard input is closed.
    """
    environment = {k: v for k, v in os.environ.items() if k not in ("PYTHONHOME", "PYTHONSTARTUP")}
    environment[VARIABLE] = json.dumps({"module": module, "options": dict(options)})
    return environment


def decode(line: str) -> Optional[Message]:
    """Return the message in a line of the process's standard output, or None for FreeCAD's own chatter."""
    if not line.startswith(MARK):
        return None
    try:
        return json.loads(line[len(MARK) :])
    except ValueError:
        return None


def encode(message: Mapping[str, Any]) -> bytes:
    """Return a message as a line of its own, whatever stood on the line before."""
    return ("\n" + MARK + json.dumps(message) + "\n").encode("ascii")


# ------------------------------------------------------------------------------------------------- the running process


class Child:
    """A command that runs under FreeCAD.

    Parameters
    ----------
    module, options
        As ``child_environment`` takes them.
    receive : callable
        Called with each message: ``kind`` is ``progress`` (``share`` 0..1, ``what``), or ``text``, ``warning`` or
        ``error`` (``text``).

    Raises
    ------
    DependencyError
        If there is no FreeCAD, or it cannot be started.
    """

    def __init__(self, module: str, options: Mapping[str, Any], receive: Callable[[Message], None]) -> None:
        self._receive = receive
        self._chatter: Deque[str] = collections.deque(maxlen=_KEPT_LINES)
        self._temporary = ""
        self._code: Optional[int] = None
        words = freecad_program()
        try:
            self._process = subprocess.Popen(
                [*words, START],
                env=child_environment(module, options),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                # Ctrl-C at the terminal is ours alone: the process is stopped in good order below.
                start_new_session=True,
            )
        except OSError as error:
            raise DependencyError(f"FreeCAD could not be started by {' '.join(words)}: {error.strerror}") from error

    def wait(self) -> int:
        """Hand on all messages until the process ends; return its exit code."""
        for raw in self._process.stdout or ():
            line = raw.decode("utf-8", "replace")
            message = decode(line)
            if message is None:
                if line.strip():
                    self._chatter.append(line)
            elif message["kind"] == "temporary":
                self._temporary = message["path"]
            elif message["kind"] == "trace":
                self._chatter.append(message["text"])
            elif message["kind"] == "end":
                self._code = message["code"]
            else:
                self._receive(message)
        status = self._process.wait()
        self._sweep()
        if self._code is None:
            self._died(status)
        return FAILED if self._code is None else self._code

    def stop(self) -> None:
        """End the process, by its own means if it can, and remove what it leaves."""
        if self._process.stdin:
            self._process.stdin.close()
        drain = threading.Thread(target=lambda: collections.deque(self._process.stdout or (), maxlen=0), daemon=True)
        drain.start()  # else the process could wait for ever to be rid of its last words
        try:
            self._process.wait(_GRACE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        drain.join(_GRACE)
        self._sweep()

    def save_trace(self) -> str:
        """Write what FreeCAD said, and the trace of the failure, into a new file; return its name."""
        handle, name = tempfile.mkstemp(prefix="trabecula-", suffix=".log")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.writelines(self._chatter)
        return name

    def _died(self, status: int) -> None:
        how = f"signal {-status}" if status < 0 else f"exit code {status}"
        text = f"FreeCAD ended before its work was done ({how}); nothing was written"
        self._receive({"kind": "error", "text": text, "unexpected": True})

    def _sweep(self) -> None:
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe:
                pipe.close()
        if self._temporary:
            shutil.rmtree(self._temporary, ignore_errors=True)


# ------------------------------------------------------------------------------------------------------- on the screen


class Screen:
    """Shows messages: texts on standard output; progress, warnings and errors on standard error."""

    def __init__(self, program: str, quiet: bool) -> None:
        self.unexpected = False
        self._program, self._quiet = program, quiet
        self._live = sys.stderr.isatty()
        self._shown = ("", -10.0)

    def show(self, message: Message) -> None:
        """Show one message of a ``Child``."""
        kind = message["kind"]
        if kind == "progress":
            self._progress(message["what"], 100 * message["share"])
        elif kind == "text" and not self._quiet:
            self._clear()
            sys.stdout.write(message["text"] + "\n")
            sys.stdout.flush()
        elif kind in ("warning", "error"):
            self._clear()
            word = "warning: " if kind == "warning" else ""
            self.unexpected |= bool(message.get("unexpected"))
            sys.stderr.write(f"{self._program}: {word}{message['text']}\n")

    def _progress(self, what: str, percent: float) -> None:
        if self._quiet:
            return
        if self._live:
            sys.stderr.write(f"\r\x1b[K{percent:3.0f} %  {what}")
        elif what != self._shown[0] or percent >= self._shown[1] + 10:
            sys.stderr.write(f"{percent:3.0f} %  {what}\n")
            self._shown = what, percent
        sys.stderr.flush()

    def _clear(self) -> None:
        if self._live and not self._quiet:
            sys.stderr.write("\r\x1b[K")


def _raise_stop(number: int, frame: object) -> None:
    raise KeyboardInterrupt


def _lost(stream: Any) -> Any:
    """Return a stream; one that was closed (``2>&-``) becomes one that loses what it is told."""
    return open(os.devnull, "w", encoding="utf-8") if stream is None else stream  # until the process ends


def _run(arguments: Sequence[str]) -> int:
    """Run a command in a process of its own, and show what it says; return the exit code."""
    command, options = read_arguments(arguments)
    screen = Screen(f"{PROGRAM} {command.name}", bool(options.get("quiet")))
    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), _raise_stop)
    try:
        child = Child(command.module, options, screen.show)
    except DependencyError as error:
        screen.show({"kind": "error", "text": str(error)})
        return WRONG_INPUT
    try:
        code = child.wait()
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # a second Ctrl-C must not stop the tidying up
        child.stop()
        screen.show({"kind": "error", "text": "stopped; nothing was written"})
        return STOPPED
    except OSError:
        child.stop()
        raise
    if screen.unexpected:
        screen.show({"kind": "error", "text": f"the trace is in {child.save_trace()}"})
    return code


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return the exit code."""
    sys.stdout, sys.stderr = _lost(sys.stdout), _lost(sys.stderr)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a sign that the terminal does not have is written as its number
            stream.reconfigure(errors="backslashreplace")
    try:
        try:
            return _run(arguments)
        finally:
            sys.stdout.flush()  # what goes wrong with it has a sentence here; at the interpreter's end it has a trace
    except KeyboardInterrupt:  # before there was anything to stop
        return STOPPED
    except OSError as error:
        # The reader of our standard output has gone (| head), or its disk is full: there is nobody to talk to.
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115  the interpreter flushes it when it ends
        if not isinstance(error, BrokenPipeError):
            sys.stderr.write(f"{PROGRAM}: standard output could not be written: {error.strerror}\n")
        return FAILED
