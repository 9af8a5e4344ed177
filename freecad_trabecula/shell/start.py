# SPDX-License-Identifier: LGPL-2.1-or-later
"""Executed by FreeCAD (see launch.py): calls a command's ``run(options, report)``, ends with its exit code."""

from __future__ import annotations

import importlib
import json
import os
import shutil
import signal
import sys
import threading
import time
import traceback
from types import TracebackType
from typing import Any, Dict, Optional, Type

_VARIABLE = "TRABECULA_COMMAND"
_LAST_WAIT = 20.0  # s from the end of standard input until the process is ended in the midst of its work


def _find_package() -> None:
    """Make this checkout's package importable, before any other Trabecula that FreeCAD may have loaded at its start."""
    here = os.path.dirname(os.path.realpath(__file__))
    root = os.path.dirname(os.path.dirname(here))
    loaded = getattr(sys.modules.get("freecad_trabecula"), "__file__", None) or ""
    if os.path.realpath(loaded) != os.path.join(root, "freecad_trabecula", "__init__.py"):
        for name in [n for n in sys.modules if n.split(".")[0] == "freecad_trabecula"]:
            del sys.modules[name]
    # FreeCAD puts the folder of a script on the path: its modules are to be found in their package only
    sys.path[:] = [root] + [p for p in sys.path if os.path.realpath(p) not in (here, root)]


class Session:
    """Runs a command: its messages, its exit code, its end.

    As a context manager it takes every exception and makes of it one sentence and an exit code: 2 for wrong input, 1
    otherwise, with the trace when it was not raised on purpose.
    """

    def __init__(self) -> None:
        from freecad_trabecula import errors
        from freecad_trabecula.shell import launch

        self._errors, self._launch = errors, launch
        # What was given is wrong, as against: something went wrong.
        self._refusals = (
            *(errors.ParameterError, errors.EnvelopeError, errors.DependencyError),
            *(errors.ContourError, errors.InfeasibleError),
        )
        self.code = launch.FAILED
        self._lock = threading.Lock()
        self._stopped = threading.Event()
        self._temporary = ""

    def report(self, kind: str, **more: Any) -> None:
        """Send a message: one that ``launch.Child`` hands on, ``trace`` (``text``), ``end`` (``code``), ``temporary``.

        The last names in ``path`` a folder that is to vanish with the process.

        Raises
        ------
        Cancelled
            With ``progress``, if the process is to stop.
        """
        if kind == "progress" and self._stopped.is_set():
            raise self._errors.Cancelled("stopped; nothing was written")
        if kind == "temporary":
            self._temporary = more["path"]
        data = self._launch.encode(dict(more, kind=kind))
        try:
            with self._lock:
                while data:
                    data = data[os.write(1, data) :]
        except OSError:
            self._stopped.set()  # nobody listens any more

    def watch(self) -> None:
        """Stop when standard input is closed: whoever started this process has gone, or wants it to end."""

        def wait_for_the_end() -> None:
            while os.read(0, 4096):
                pass
            self._stopped.set()
            # Work that reports no progress is ended in its midst; nothing half written may stay.
            time.sleep(_LAST_WAIT)
            self.sweep()
            os._exit(self._launch.STOPPED)

        threading.Thread(target=wait_for_the_end, daemon=True).start()

    def sweep(self) -> None:
        """Remove the temporary folder, if one was named and is still there."""
        if self._temporary:
            shutil.rmtree(self._temporary, ignore_errors=True)

    def __enter__(self) -> Session:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> bool:
        errors, launch = self._errors, self._launch
        if error is None or kind is None:
            return True
        if isinstance(error, errors.Cancelled):
            self.code = launch.STOPPED
            self.report("error", text=str(error))
        elif isinstance(error, self._refusals):
            self.code = launch.WRONG_INPUT
            self.report("error", text=str(error))
        elif isinstance(error, errors.ExportError):
            self.report("error", text=f"{error}; nothing was written")
        else:
            self.report("trace", text="".join(traceback.format_exception(kind, error, trace)))
            text = str(error) if isinstance(error, errors.TrabeculaError) else f"unexpected {kind.__name__}: {error}"
            if isinstance(error, MemoryError):
                text = "there is not enough memory; fewer rods or planes, coarser meshes or cells need less"
            self.report("error", text=text, unexpected=True)
        return True


def start(task: Dict[str, Any]) -> None:
    """Run a task and end the process."""
    _find_package()
    for name in ("SIGPIPE", "SIGXFSZ"):  # 1.1 leaves them to kill: no reader, no room; Python makes errors of them
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    session = Session()
    session.watch()
    with session:
        session.code = importlib.import_module(task["module"]).run(task["options"], session.report)
    session.sweep()
    session.report("end", code=session.code)
    sys.stdout.flush()
    # FreeCAD would give 0 to a script that raises, run it a second time, and may crash while it takes itself apart.
    os._exit(session.code)


if _VARIABLE in os.environ:
    start(json.loads(os.environ.pop(_VARIABLE)))
