# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula``: the command line, in any Python 3.8 or later (docs/job.md)."""

from __future__ import annotations

import sys

from .shell.launch import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
