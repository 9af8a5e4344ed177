# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a tool's ``main(arguments)`` inside FreeCAD: ``sys.exit(under_freecad.run(__file__))`` at the end of the tool.

FreeCAD's console reads options itself and gives exit code 0 to a script that raises, so the arguments travel in the
environment variable TRABECULA_TOOL, and the exit code is ours.
"""

import json
import os
import runpy
import subprocess
import sys
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VARIABLE = "TRABECULA_TOOL"


def run(script, arguments=None, **more):
    """Run ``script``'s ``main`` under FreeCAD with ``arguments`` (default: this process's) and return its exit code."""
    sys.path.insert(0, str(ROOT))
    from freecad_trabecula.shell.launch import freecad_program

    call = {"script": str(Path(script).resolve()), "arguments": list(sys.argv[1:] if arguments is None else arguments)}
    environment = dict(os.environ, **{VARIABLE: json.dumps(call)})
    return subprocess.call([*freecad_program(), str(Path(__file__).resolve())], env=environment, **more)


def _inside():
    call = json.loads(os.environ.pop(VARIABLE))
    status = 1
    try:
        sys.path[:0] = [str(ROOT), str(Path(call["script"]).parent)]
        sys.argv = [call["script"], *call["arguments"]]
        status = runpy.run_path(call["script"], run_name="tool")["main"](call["arguments"]) or 0
    except SystemExit as stop:
        status = stop.code if isinstance(stop.code, int) else 1
    except BaseException:
        traceback.print_exc(file=sys.__stderr__)
    finally:
        sys.stdout.flush()
        sys.__stdout__.flush()
        os._exit(status)


if VARIABLE in os.environ and "FreeCAD" in sys.modules:
    _inside()
