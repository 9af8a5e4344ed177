# SPDX-License-Identifier: LGPL-2.1-or-later
"""The end of a script that ``freecadcmd`` runs: FreeCAD itself would hide that it failed."""

from __future__ import annotations

import sys
import traceback
from typing import Any, Callable


def run_script(main: Callable[[], Any]) -> None:
    """Call the function that does a script's work, then end FreeCAD: with exit code 0, or 1 if the function raised.

    FreeCAD would give the exit code 0 to a script that raises, and run it a second time.
    """
    code = 1
    try:
        main()
        code = 0
    finally:
        if code:
            traceback.print_exc()
        sys.stdout.flush()  # FreeCAD 1.1 would not print the last words into a pipe
        sys.exit(code)
