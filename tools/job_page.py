# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes docs/job.md, the description of the job file, from the parameter classes themselves.

``python3 tools/job_page.py`` writes it; with ``--check`` it only says whether the page is up to date (exit code 1 if
not).
"""

import argparse
import dataclasses
import json
import sys
import typing
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from freecad_trabecula.core import parameters as p  # noqa: E402
from freecad_trabecula.core.job import MOST_RODS, Job, job_from_json  # noqa: E402
from freecad_trabecula.core.laws import KINDS, Law  # noqa: E402
from freecad_trabecula.core.presets import PRESETS  # noqa: E402

PAGE = ROOT / "docs" / "job.md"
#: Title, class, where it stands, and what is to be said of it.
SECTIONS = (
    ("The job itself", Job, "", "One object. It needs either a `prism` or an `envelope` file with `faces`."),
    (
        "`prism`",
        p.PrismParameters,
        "prism",
        "A cuboid with one corner at the origin. Its faces are called Face1 (x = 0), Face2 (x = l), Face3 (y = 0), "
        "Face4 (y = w), Face5 (z = 0), Face6 (z = h). Sites follow Eq. 2.1: the n sites of an axis lie evenly between "
        "the two border distances. Where `faces` are given too, these make the sites, and n and a count for nothing.",
    ),
    (
        "`faces[]`",
        p.FaceParameters,
        "faces[]",
        "Faces with sites by curvilinear co-ordinates (thesis 4.2.2): from the origin every `c_v` along the line v, "
        "and from each of these points every `c_u` along a line u, as long as the border is not nearer than `b_v` and "
        "`b_u`.",
    ),
    ("`pores`", p.PoreParameters, "pores", "Pores of all faces."),
    ("`path`", p.PathParameters, "path", "Paths of the rods; a coupling may have a `path` of its own."),
    (
        "`couplings[]`",
        p.Coupling,
        "couplings[]",
        "Pairs of faces, in order: a site used by an earlier coupling is not free for a later one, unless that one "
        "says `reuse`. The face with fewer free sites is used fully.",
    ),
    ("`rods`", p.RodParameters, "rods", "Surface of the rods, and how faulty ones are mended."),
    ("`scaffold`", p.ScaffoldParameters, "scaffold", "From rods to channels."),
    ("`scaffold.layers`", p.LayerParameters, "scaffold.layers", "Compact layers on chosen faces (thesis 4.3.1)."),
    (
        "`edits[]`",
        p.SiteEdit,
        "edits[]",
        "Changes of single sites and pores by hand. A site is called `face.i.j`, as the report and the window show it; "
        "one that was added is called `face.hand.n`.",
    ),
    (
        "Laws",
        Law,
        "a law",
        "How a number varies over the design: `pores.size`, `pores.turn`, `pores.pull`, `path.tension_first` and "
        "`path.tension_second` are laws. Their random numbers belong to the site or the rod, so that a change in one "
        "place reshuffles nothing elsewhere.",
    ),
)
#: Ranges that the classes' metadata do not hold; tests/core/test_job_page.py tries them out.
RANGES = {
    (Job, "schema"): "1",
    (Job, "seed"): f"0 .. {p.LARGEST_SEED}",
    (p.PrismParameters, "l"): ">= 0.001",
    (p.PrismParameters, "w"): ">= 0.001",
    (p.PrismParameters, "h"): ">= 0.001",
    (p.PrismParameters, "a_x"): ">= 0, < l / 2",
    (p.PrismParameters, "a_y"): ">= 0, < w / 2",
    (p.PrismParameters, "a_z"): ">= 0, < h / 2",
    (p.FaceParameters, "c_u"): "> 0",
    (p.FaceParameters, "c_v"): "> 0",
    (p.FaceParameters, "b_u"): ">= 0",
    (p.FaceParameters, "b_v"): ">= 0",
    (p.FaceParameters, "d1"): "not zero",
    (p.FaceParameters, "d2"): "not zero",
    (p.PoreParameters, "size"): ">= 0.001",
    (p.PathParameters, "box"): ">= 0 each",
    (p.PathParameters, "tension_first"): "> 0",
    (p.PathParameters, "tension_second"): "> 0",
    (p.Coupling, "association"): ", ".join(p.ASSOCIATIONS),
    (p.RodParameters, "deflection"): ">= 0",
    (p.LayerParameters, "thickness"): "> 0",
    (p.ScaffoldParameters, "cell"): "> 0",
    (p.ScaffoldParameters, "seconds"): ">= 1",
    (p.ScaffoldParameters, "memory_gb"): ">= 0.5",
    (p.SiteEdit, "size"): ">= 0.001",
    (p.SiteEdit, "turns"): "0 .. 1 each",
    (Law, "kind"): ", ".join(KINDS),
    (Law, "low"): "<= high, but for linear and radial",
    (Law, "direction"): "not zero",
    (Law, "expression"): "1 to 500 characters",
}
#: Law is used everywhere and has no metadata of its own.
LAW_WORDS = {
    "kind": "constant: `low`; uniform: at random between `low` and `high` (Eq. 2.4); normal: at random, mean half-way, "
    "sd a sixth of the range; linear: from `low` to `high` along `direction` over the envelope's box; radial: from "
    "`low` at the centre to `high` at the box's farthest corner; expression: a formula, clipped to `low` .. `high`",
    "low": "Least value; in the unit of the number that varies",
    "high": "Greatest value",
    "direction": "Direction of a linear law; its length does not count",
    "expression": "Formula of x, y, z (mm) and u (random, 0 .. 1): + - * / % ** ( ), pi, e, sin, cos, tan, exp, "
    "log, sqrt, abs, floor, ceil, hypot, min, max, sign",
}

INTRODUCTION = f"""\
<!-- Written by tools/job_page.py from the parameter classes: change those, then run it. -->
# The job file

A job holds all that a design needs: envelope, sites, pores, couplings, paths, seed, scaffold. It is a JSON text. The
window saves and loads it, and the command line runs it, in any Python 3.8 or later:

    python3 -m freecad_trabecula design --job implant.json --out build/implant
    python3 -m freecad_trabecula design --preset case6 --save-job my_case.json

The second line writes a preset with every key there is: the easiest start. Presets are {", ".join(PRESETS)}.

Lengths are mm. A key that is left out has its default; an unknown key, a wrong type, a number that is not finite or
breaks a rule is refused, with its place, the rule and the value. A file name of an envelope is looked for in the folder
of the job file first. A job of more than {MOST_RODS:,} rods is refused with an estimate of its time and memory.

Single keys can be set on the command line, lists by number from 0:

    --set pores.size.high=0.6 --set prism.n_x=9 --set couplings.0.on=false --set path.kind=centre
    --set 'path.box=[2, 2, 2]' --set 'pores.size={{"kind": "linear", "low": 0.2, "high": 0.8}}'
"""
EXAMPLES = (
    (
        "The thesis' case 6, with another seed and smaller pores",
        """\
{
  "name": "small pores",
  "prism": {"l": 10, "w": 10, "h": 10, "n_x": 7, "n_y": 7, "n_z": 7, "a_x": 1, "a_y": 1, "a_z": 1},
  "pores": {"layout": "spline", "size": {"kind": "uniform", "low": 0.2, "high": 0.5}, "sections": 2},
  "path": {"kind": "box", "box": [4, 4, 4]},
  "couplings": [
    {"first": "Face1", "second": "Face2"},
    {"first": "Face3", "second": "Face4"},
    {"first": "Face5", "second": "Face6"}
  ],
  "seed": 7
}
""",
    ),
    (
        "An implant from a STEP file: two couplings share a face, rods bend through its centre",
        """\
{
  "name": "implant",
  "envelope": "implant.step",
  "faces": [
    {"face": "Face1", "name": "A", "c_u": 3, "c_v": 3, "b_u": 1.5, "b_v": 1.5, "d1": [0, 0, 1], "d2": [1, 0, 0]},
    {"face": "Face2", "name": "B", "c_u": 2, "c_v": 2},
    {"face": "Face3", "name": "C"}
  ],
  "path": {"kind": "centre"},
  "couplings": [
    {"first": "A", "second": "B"},
    {"first": "A", "second": "C", "limit": 20, "path": {"kind": "tension"}}
  ],
  "scaffold": {"layers": {"faces": ["B"], "thickness": 1, "closed": true}}
}
""",
    ),
    (
        "Pores that grow from the bottom to the top, two convergence points, a pore by hand, the field engine",
        """\
{
  "name": "graded",
  "prism": {"l": 12, "w": 12, "h": 20, "n_x": 8, "n_y": 8, "n_z": 14},
  "pores": {"size": {"kind": "linear", "low": 0.3, "high": 0.7, "direction": [0, 0, 1]}},
  "path": {"kind": "box", "points": [[6, 6, 6], [6, 6, 14]], "choice": "nearest", "box": [3, 3, 3]},
  "couplings": [
    {"first": "Face1", "second": "Face2"},
    {"first": "Face3", "second": "Face4"}
  ],
  "edits": [
    {"site": "Face1.1.1", "action": "off"},
    {"site": "Face1.4.7", "action": "pore", "size": 0.9, "turns": [0.5, 0.5, 0.5, 0.5]}
  ],
  "scaffold": {"engine": "field", "cell": 0.08}
}
""",
    ),
)


RESULTS = """\
## What the command writes

`--out DIR` receives all files together at the end of the run; a run that fails or is stopped (Ctrl-C, a signal, a
crash) leaves the folder as it was. Files of the same names are replaced, others are left alone.

| file | what it is |
|---|---|
| `scaffold.stl`, `channels.stl` | both bodies, binary, closed; read again and compared before the run ends |
| `network.step` | the rods, one solid each |
| `scaffold.step` | the scaffold as a solid, with `--engine brep` |
| `design.FCStd` | the document, everything in it editable |
| `report.md` | tables after the thesis' 3.1 to 3.6 and 4.1 to 4.6 |
| `report.json` | the same for scripts |
| `scaffold.obj`, `.ply`, `.3mf`, `channels.*`, `network.brep` | with `--also obj`, `ply`, `3mf`, `brep` |

Keys of `report.json` (volumes mm3, sizes mm, times s, file sizes bytes):

| key | what it is |
|---|---|
| `rods`, `seed`, `name` | |
| `porosity`, `porosity_percent` | 1 - scaffold / envelope (Eq. 2.2): of what is exported |
| `union_porosity_percent` | what the rods fill of the envelope |
| `sum_porosity_percent` | the plain sum of the rods, crossings counted twice |
| `volume_mm3` | `envelope`, `layers`, `channels`, `scaffold`, `loose`, `closed_voids`, `rods` |
| `watertight`, `ok`, `checks` | each check with both values, their difference and what it may be |
| `engine` | `asked`, `used`, `why` |
| `pieces` | connected pieces of scaffold and channels, loose pieces, closed voids |
| `faces`, `couplings` | tables 4.1, 4.2 |
| `pores` | sizes, estimated areas s^2, true areas, histogram of sizes |
| `recoveries`, `failed_rods`, `outside_rods`, `warnings` | by the rods' names |
| `seconds`, `seconds_by_step`, `cpu_seconds` | of all; of each step; processor time of all |
| `seconds_of_network`, `seconds_per_rod` | of sites, paths, rods, as the thesis counts |
| `manual_seconds`, `manual_seconds_per_rod` | estimated for manual design (thesis 2.3.3) |
| `files`, `versions`, `thesis`, `job` | sizes; programs; the thesis' figures for a preset; the whole job |

Scaffold + channels + loose pieces = envelope + layers: the first of the checks.

The exit code is 0 only if all checks held; 1 if one failed or something broke (one sentence says what, and where the
trace is); 2 for wrong input, with one sentence; 130 if the run was stopped.
"""


def type_words(hint):
    """Return the type of a field in words."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Union:
        return type_words(arguments[0]) + " or null"
    if origin is tuple:
        inner = type_words(arguments[0])
        if arguments[-1] is Ellipsis:
            return "list of " + {"number": "numbers", "text": "texts", "object": "objects"}.get(inner, inner)
        return f"{len(arguments)} numbers"
    if hint is Law:
        return "law"
    if dataclasses.is_dataclass(hint):
        return "object"
    return {float: "number", int: "whole number", str: "text", bool: "true or false"}[hint]


def range_words(cls, field):
    """Return the range of a field in words; empty if anything goes."""
    if (cls, field.name) in RANGES:
        return RANGES[cls, field.name]
    data = field.metadata
    if "choices" in data:
        return ", ".join(data["choices"])
    low, high = data.get("low"), data.get("high")
    if low is None and high is None:
        return ""
    return f">= {low:g}" if high is None else f"{low:g} .. {high:g}"


def default_words(default):
    """Return a default as it would stand in the file, short."""
    if isinstance(default, Law):
        return f"{default.kind} {default.low:g}" + ("" if default.kind == "constant" else f" .. {default.high:g}")
    if dataclasses.is_dataclass(default):
        return "see below"
    return "`" + json.dumps(default) + "`"


def table(cls):
    """Return the table of a class's fields, as lines."""
    hints = typing.get_type_hints(cls)
    lines = ["| key | type | unit | default | range | what it is |", "|---|---|---|---|---|---|"]
    for field in dataclasses.fields(cls):
        words = LAW_WORDS[field.name] if cls is Law else field.metadata["doc"]
        cells = (f"`{field.name}`", type_words(hints[field.name]), field.metadata.get("unit", ""),
                 default_words(field.default), range_words(cls, field), words)  # fmt: skip
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return lines


def page():
    """Return the whole page."""
    lines = [INTRODUCTION]
    for title, cls, _, words in SECTIONS:
        lines += [f"## {title}", "", words, "", *table(cls), ""]
    lines += ["## Examples", ""]
    for title, text in EXAMPLES:
        job_from_json(text)
        lines += [title + ":", "", "```json", text.rstrip(), "```", ""]
    return "\n".join([*lines, RESULTS])


def main():
    """Write or check the page; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing, exit with 1 if the page is out of date")
    if parser.parse_args().check:
        fresh = PAGE.exists() and PAGE.read_text(encoding="utf-8") == page()
        print("docs/job.md is up to date" if fresh else "docs/job.md is out of date: run python3 tools/job_page.py")
        return 0 if fresh else 1
    PAGE.write_text(page(), encoding="utf-8")
    print("wrote docs/job.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())
