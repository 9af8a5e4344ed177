# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of ``voxels``. Standard library only, as ``arguments``."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any, Dict, List, Optional

from .option_values import PROGRAM, number, whole_number

_MODULES = Path(__file__).resolve().parent.parent / "core" / "voxels" / "strategies"
#: Named as their modules, which need numpy: they are not imported here.
STRATEGIES = tuple(sorted(one.stem.replace("_", "-") for one in _MODULES.glob("[a-z]*.py")))
#: Of core/voxels, held by a test.
CHOICES = {
    "areas": ("middle", "slab"),
    "correction": ("remainders", "random"),
    "total": ("mean", "x", "y", "z"),
    "solver": ("proportional", "thesis"),
    "pairing": ("constraint", "repeat"),
    "direction": ("columns", "rows"),
    "field": ("noise", "gyroid", "sheets", "centre", "border"),
    "contacts": ("any", "edge", "corner"),
    "trabeculae": ("off", "x", "y", "z", "xy", "xz", "yz", "xyz"),
    "boundary": ("half", "touched", "inside"),
}
PLOTS = ("png", "svg", "pdf", "none")
IMAGES = ("png", "bmp", "tiff", "none")
#: Options that are fields of VoxelParameters of the same name, dashes for underscores.
FIELDS = (
    *("size", "strategy", "seed", *CHOICES, "cap_alpha", "cap_beta", "tries"),
    *("wavelength", "rods", "thickness", "void"),
)

EXAMPLES = f"""\
examples:
  {PROGRAM} voxels bone.stl --size 0.1 --out build/bone
  {PROGRAM} voxels bone.stl --size 0.1,0.1,0.2 --trabeculae xyz --seed 7 --out build/other
  {PROGRAM} voxels build/analysis --size 0.1 --strategy minimum-zeros --cap-alpha 40 --cap-beta 40 --out build/case1
  {PROGRAM} voxels femur.stl --size 0.2 --density 0.3 --wavelength 1.6 --out build/femur
  {PROGRAM} voxels bone.stl --size 0.05 --estimate

FILE is a mesh (STL, OBJ, PLY, 3MF), the folder of an analysis with layers as thick as the voxels, a CSV file with the
columns axis, layer and sliced_area_mm2 (or voxels), targets.json of an earlier design, or a volume: NPY of voxels
[z, y, x], NRRD, TIFF, or a folder of images, whose own voxel size is taken where they have one. The folder gets
design.npy (bool, axes [z, y, x]), targets.json (D per layer along X, E along Y, C along Z), design.stl (blocks,
watertight), alpha.csv and beta.csv, images of the layers, report.json, report.md and plots. Exit code: 0 exact and
watertight; 1 the search gave up or something broke, nothing is written; 2 wrong input, or targets that no design can
meet; 130 stopped. A run that is stopped leaves the folder as it was. FreeCAD is run by the command in the environment
variable FREECADCMD, or else freecadcmd or FreeCADCmd on PATH.
"""


def triple(text: str) -> List[float]:
    """Return one number, or three between commas, as three numbers."""
    words = text.split(",")
    if len(words) not in (1, 3):
        raise argparse.ArgumentTypeError(f"it must be one number or three between commas, got {text!r}")
    numbers = [number(word) for word in words]
    return numbers * 3 if len(numbers) == 1 else numbers


def voxel_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of ``voxels``."""
    parser.add_argument("file", metavar="FILE", help="where the targets come from: mesh, analysis, CSV, JSON, volume")
    _target_options(parser.add_argument_group("what is asked for"))
    _strategy_options(parser.add_argument_group("how it is filled"))
    result = parser.add_argument_group("what is written")
    result.add_argument("--out", metavar="DIR", help="folder for the design, its mesh, images, report and plots")
    result.add_argument("--images", choices=IMAGES, default="png", help="images of the layers (default: png)")
    result.add_argument("--plots", choices=PLOTS, default="png", help="kind of the plots (default: png)")
    result.add_argument("--xlsx", action="store_true", help="tables.xlsx: alpha and beta as in the thesis' Fig. 6.6")
    result.add_argument("--no-mesh", action="store_true", help="leave out design.stl")
    result.add_argument("--count", action="store_true", help="estimate how many designs there are")
    result.add_argument("--rates", metavar="N", type=whole_number, help="draw N pairs of tables, tell how many fit")
    result.add_argument("--estimate", action="store_true", help="tell voxels, memory and time; nothing is designed")
    result.add_argument("--quiet", action="store_true", help="no progress and no summary, errors only")


def _target_options(group: Any) -> None:
    group.add_argument("--size", metavar="MM", type=triple, help="edge of a voxel, or dx,dy,dz (default: 0.1)")
    group.add_argument("--threshold", metavar="VALUE", type=number, help="of a volume or images: values above it are "
                       "material (default: Otsu's)")  # fmt: skip
    group.add_argument("--areas", choices=CHOICES["areas"], help="sections at the layers' middles (default) or slabs")
    group.add_argument("--correction", choices=CHOICES["correction"], help="to one total: by largest remainders "
                       "(default), or random layers as in the thesis")  # fmt: skip
    group.add_argument("--total", choices=CHOICES["total"], help="whose total it is (default: mean; thesis: z)")
    group.add_argument("--trabeculae", choices=CHOICES["trabeculae"], help="axes along which their number per layer is "
                       "a target too (default: off)")  # fmt: skip
    group.add_argument("--density", metavar="R", type=number, help="FILE is an envelope, not a sample: this share of "
                       "its cells in every layer")  # fmt: skip
    group.add_argument("--mask", metavar="FILE", help="envelope: a mesh or an NPY file; solid lies within it only")
    group.add_argument("--boundary", choices=CHOICES["boundary"], help="voxels at its boundary (default: half: by "
                       "their centres)")  # fmt: skip
    group.add_argument("--tables", metavar="FILE", help="XLSX, or folder of alpha.csv and beta.csv: given tables, "
                       "whose sums are the targets")  # fmt: skip


def _strategy_options(group: Any) -> None:
    group.add_argument("--strategy", choices=STRATEGIES, help="default: trabecular")
    group.add_argument("--seed", metavar="N", type=whole_number, help="one number reproduces all random draws")
    group.add_argument("--cap-alpha", metavar="N", type=whole_number, help="most voxels in a line (x, z) (thesis: 40)")
    group.add_argument("--cap-beta", metavar="N", type=whole_number, help="most voxels in a line (y, z) (thesis: 40)")
    group.add_argument("--solver", choices=CHOICES["solver"], help="rows of tables (default: proportional)")
    group.add_argument("--pairing", choices=CHOICES["pairing"], help="tables fit by construction (default), or are "
                       "drawn until they do")  # fmt: skip
    group.add_argument("--tries", metavar="N", type=whole_number, help="pairs of tables tried (default: 200)")
    group.add_argument("--direction", choices=CHOICES["direction"], help="lines solved one by one (default: columns)")
    group.add_argument("--field", choices=CHOICES["field"], help="for by-field and best-tables (default: noise)")
    group.add_argument("--wavelength", metavar="MM", type=triple, help="of the texture, one or three (default: the "
                       "sample's)")  # fmt: skip
    group.add_argument("--rods", metavar="W", type=number, help="0 sheets .. 1 rods (default: 0.3)")
    group.add_argument("--contacts", choices=CHOICES["contacts"], help="avoided: by an edge alone (default), by a "
                       "corner too; any: none")  # fmt: skip
    group.add_argument("--thickness", metavar="N", type=whole_number, help="least thickness in voxels (default: 1)")
    group.add_argument("--void", metavar="N", type=whole_number, help="least void in voxels (default: 1)")


def check_voxels(options: Dict[str, Any]) -> Optional[str]:
    """Return what is wrong with a set of options, or nothing."""
    if not (options["out"] or options["estimate"]):
        return "where shall it go? --out DIR is needed (or --estimate, to be told only)"
    if options["rates"] is not None and options["rates"] < 1:
        return f"--rates must be at least 1, got {options['rates']}"
    if (options["count"] or options["rates"]) and (options["mask"] or options["density"] is not None):
        return "--count and --rates are about boxes: they do not go with --mask and --density"
    if options["boundary"] and not options["mask"] and options["density"] is None:
        return "--boundary is about --mask or --density, and neither is given"
    if options["density"] is not None and (options["mask"] or options["tables"]):
        return "--density makes FILE the envelope: --mask and --tables do not go with it"
    return None
