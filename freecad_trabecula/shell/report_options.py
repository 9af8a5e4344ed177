# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of ``report`` on the command line. Standard library only."""

from __future__ import annotations

import argparse
import os
from typing import Any, Dict, Optional

from .option_values import PROGRAM

EXAMPLES = f"""\
examples:
  {PROGRAM} report out/case6 out/bone out/comparison --out report.html
  {PROGRAM} report out/voxels --title "Voxels of a shrew's femur" --out report.html

The page needs no network and no other file. Exit code: 0 written; 1 it could not be written; 2 wrong input.
"""


def report_options(parser: argparse.ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("folders", metavar="FOLDER", nargs="+", help="results of design, analyse, compare or voxels")
    parser.add_argument("--out", metavar="FILE", help="the page, a file that ends in .html", required=True)
    parser.add_argument("--title", metavar="TEXT", default="", help="title of the page (default: the parts' names)")
    parser.add_argument("--quiet", action="store_true", help="no progress and no summary, errors only")


def check_report(options: Dict[str, Any]) -> Optional[str]:
    """Return what is wrong with the options, or nothing."""
    if os.path.splitext(options["out"])[1].lower() not in (".html", ".htm"):
        return f"--out must name a file that ends in .html, got {options['out']}"
    return None
