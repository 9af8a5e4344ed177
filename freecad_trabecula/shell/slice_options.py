# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of ``analyse`` and ``compare``. Standard library only, as ``arguments``."""

from __future__ import annotations

import argparse
from typing import Any, Dict, Optional

from .option_values import PROGRAM, axes, heights, number, value_range, whole_number

#: Of core/analysis, which needs numpy; held by a test too.
PLANES = ("middle", "bottom")
UNITS = ("auto", "mm", "cm", "m", "um", "inch", "foot")
SMOOTHINGS = ("off", "normal", "heavy")
FILLS = ("winding", "union")
PLOTS = ("png", "svg", "pdf", "none")
ALIGNMENTS = ("start", "centre", "own")

_END = """\
FreeCAD is run by the command in the environment variable FREECADCMD, or else freecadcmd or FreeCADCmd on PATH.
"""

ANALYSE_EXAMPLES = f"""\
examples:
  {PROGRAM} analyse bone.stl --thickness 0.1 --out build/bone
  {PROGRAM} analyse scaffold.step --axes xz --at bottom --ssl --xlsx --out build/scaffold
  {PROGRAM} analyse bone.stl --axes 0.6,0.8,0 --range=-2:5 --plots none --no-morphometry --out build/turned
  {PROGRAM} analyse slices.ssl --axes z --unit inch --out build/slices

The folder gets profile_x.csv ... (one row per slice), contours_x.csv ... (one row per contour), report.json, report.md
and plots. Exit code: 0 the mesh is sound and the checks held (sum of area x thickness against the volume of the mesh,
within half a layer times the variation of the area); 1 the mesh is unsound (open, inside out, facets turned or there
twice) or a check failed: the numbers are written all the same, and marked; 1 also if something broke, then nothing is
written; 2 wrong input; 130 stopped. Facets without area or through others are counted and said; they are no fault. A
run that is stopped leaves the folder as it was.
{_END}"""

COMPARE_EXAMPLES = f"""\
examples:
  {PROGRAM} compare bone.stl scaffold.stl --thickness 0.1 --out build/comparison
  {PROGRAM} compare build/bone build/case5 build/case6 --out build/comparison

Each of A, B ... is a file (analysed as the options say) or the folder of an earlier analysis; A is the reference. The
folder gets comparison.csv (totals and ranges), comparison_x.csv ... (profiles on shared layers), passport.md and
passport.json (scores), report.json, report.md and plots. Exit code: 0 all meshes are sound and their checks held; 1 one
is not: the numbers are written all the same, and it is named; 1 also if something broke, then nothing is written; 2
wrong input; 130 stopped. A run that is stopped leaves the folder as it was.
{_END}"""


def _slicing_options(parser: argparse.ArgumentParser) -> None:
    """Add what analyse and compare have in common: how a body is sliced, mended and judged."""
    planes = parser.add_argument_group("how it is sliced")
    planes.add_argument("--thickness", metavar="MM", type=number, help="of a layer (default: 0.1; SSL: the file's)")
    planes.add_argument(
        "--axes",
        metavar="AXES",
        type=axes,
        action="append",
        default=[],
        help="xyz (default), x,z or a direction such as 0.6,0.8,0; may be repeated; of an SSL file the one axis that "
        "it was sliced along (default: z)",
    )
    planes.add_argument("--at", choices=PLANES, help="planes at the layers' middles (default) or at their bottoms")
    planes.add_argument("--unit", choices=UNITS, default="auto", help="of the file (default: its own, or by its size)")
    mending = parser.add_argument_group("how contours are mended and judged (defaults: the thesis')")
    mending.add_argument("--gap", metavar="MM", type=number, help="gap fill: widest gap closed (default: 0.01)")
    mending.add_argument("--iterations", metavar="N", type=whole_number, help="gap fill: rounds (default: 5)")
    mending.add_argument("--filter-open", metavar="MM", type=number, help="leave out shorter open contours (0)")
    mending.add_argument("--filter-closed", metavar="MM", type=number, help="leave out shorter closed contours (0)")
    mending.add_argument("--smoothing", choices=SMOOTHINGS, help="fewer points in a contour (default: off)")
    mending.add_argument("--compensation", metavar="MM", type=number, help="offset of the contours (default: 0)")
    mending.add_argument("--fill", choices=FILLS, help="what overlaps counts as often as it does (default), or once")
    mending.add_argument("--rod-ratio", metavar="R", type=number, help="a rod fills so much of its box (default: 0.6)")


def analyse_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of ``analyse``."""
    parser.add_argument("file", metavar="FILE", help="STL, OBJ, PLY, 3MF, STEP, IGES, BREP or SSL")
    _slicing_options(parser)
    parser.add_argument(
        "--heights",
        metavar="MM,MM,...",
        type=heights,
        help="planes at these co-ordinates (--heights=-1,2 if negative)",
    )
    parser.add_argument("--range", metavar="LOW:HIGH", type=value_range, help="layers in a range only (--range=-2:5)")
    parser.add_argument(
        "--no-morphometry",
        action="store_true",
        help="leave out BV/TV, Tb.Th, Tb.Sp, Conn.D, DA and interconnectivity (they take longest)",
    )
    result = parser.add_argument_group("what is written")
    result.add_argument("--out", metavar="DIR", required=True, help="folder for tables, report and plots")
    result.add_argument("--plots", choices=PLOTS, default="png", help="kind of the plots (default: png)")
    result.add_argument("--ssl", action="store_true", help="contours as Stratasys SSL, slices_x.ssl ...")
    result.add_argument("--cli", action="store_true", help="contours as Common Layer Interface, slices_x.cli ...")
    result.add_argument("--svg", action="store_true", help="contours as drawings, slices_x.svg ...")
    result.add_argument("--xlsx", action="store_true", help="slices.xlsx, columns A to H of the thesis' template")
    result.add_argument("--quiet", action="store_true", help="no progress and no summary, errors only")


def check_analyse(options: Dict[str, Any]) -> Optional[str]:
    """Return what is wrong with a set of options, or nothing."""
    if options["heights"] and options["range"]:
        return "--heights and --range exclude each other"
    if options["heights"] and options["at"]:
        return "--heights and --at exclude each other"
    return None


def compare_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of ``compare``."""
    parser.add_argument(
        "samples", metavar="SAMPLE", nargs="+", help="files, or folders of earlier analyses; two or more"
    )
    _slicing_options(parser)
    parser.add_argument("--layer", metavar="MM", type=number, help="of the shared layers (default: the thickest)")
    parser.add_argument(
        "--align",
        choices=ALIGNMENTS,
        default="start",
        help="samples side by side by their low ends (default), their middles, or their own co-ordinates",
    )
    parser.add_argument("--no-morphometry", action="store_true", help="leave it out where a file is analysed")
    result = parser.add_argument_group("what is written")
    result.add_argument("--out", metavar="DIR", required=True, help="folder for tables, passport, report and plots")
    result.add_argument("--plots", choices=PLOTS, default="png", help="kind of the plots (default: png)")
    result.add_argument("--quiet", action="store_true", help="no progress and no summary, errors only")


def check_compare(options: Dict[str, Any]) -> Optional[str]:
    """Return what is wrong with a set of options, or nothing."""
    if len(options["samples"]) < 2:
        return f"a comparison needs at least two samples, got {len(options['samples'])}"
    return None
