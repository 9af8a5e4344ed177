# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the command line. Standard library only: it runs in any Python 3.8 or later, without numpy.

A further sub-command is one more ``Command`` in ``COMMANDS``: its options here, its work in a module of its own whose
``run(options, report)`` is called under FreeCAD and returns the exit code.
"""

from __future__ import annotations

import argparse
import os
import sys
from typing import IO, Any, Callable, Dict, NamedTuple, Optional, Sequence, Tuple

from . import report_options, slice_options, voxel_options
from .option_values import PROGRAM, pair, whole_number

#: The engines of core/parameters.py, which needs numpy; a test holds the two lists together.
ENGINES = ("auto", "mesh", "field", "brep")
#: Further formats of the scaffold and the channels, besides STL (geometry/files.py; held by a test too).
MORE_FORMATS = ("obj", "ply", "3mf", "brep")


_DESIGN_EXAMPLES = f"""\
examples:
  {PROGRAM} design --preset case6 --out build/case6
  {PROGRAM} design --preset case6 --seed 7 --set pores.size.high=0.6 --set prism.n_x=9 --out build/other
  {PROGRAM} design --preset femur --save-job femur.json
  {PROGRAM} design --job femur.json --engine field --out build/femur
  {PROGRAM} design --envelope implant.step --couple Face3:Face5 --couple Face1:Face2 --out build/implant

A job file is described in docs/job.md; --save-job writes one with every field in it. FreeCAD is run by the command in
the environment variable FREECADCMD, or else freecadcmd or FreeCADCmd on PATH. Exit code: 0 all checks held; 1 a check
failed or something broke; 2 wrong input; 130 stopped. A run that is stopped leaves the folder as it was.
"""


class Command(NamedTuple):
    """A sub-command.

    Attributes
    ----------
    name, summary : str
    module : str
        The module whose ``run(options, report) -> int`` does the work under FreeCAD.
    add_options : callable
        Adds its options to a parser.
    check : callable
        Returns what is wrong with a set of options as one sentence, or nothing.
    paths : tuple of str
        Options that name files or folders, or lists of them: they are made absolute before FreeCAD is started.
    examples : str
        The end of its help.
    """

    name: str
    summary: str
    module: str
    add_options: Callable[[argparse.ArgumentParser], None]
    check: Callable[[Dict[str, Any]], Optional[str]]
    paths: Tuple[str, ...]
    examples: str = ""


class Parser(argparse.ArgumentParser):
    """A parser that says what is wrong in one sentence."""

    def error(self, message: str) -> None:
        """Print the sentence and leave with exit code 2."""
        sys.stderr.write(f"{self.prog}: {message} (--help shows what there is)\n")
        sys.exit(2)

    def print_help(self, file: Optional[IO[str]] = None) -> None:
        """Print the help; where it cannot be written argparse itself would say nothing."""
        (file or sys.stdout).write(self.format_help())


def _design_options(parser: argparse.ArgumentParser) -> None:
    source = parser.add_argument_group("what is designed")
    one = source.add_mutually_exclusive_group()
    one.add_argument(
        "--preset", metavar="NAME", help="a design of the thesis: case1 .. case6, prism420, ...; 'list' prints all"
    )
    one.add_argument("--job", metavar="FILE", help="a job file (JSON, docs/job.md)")
    source.add_argument(
        "--envelope",
        metavar="FILE",
        help="STEP, IGES, BREP or STL file of the body to be filled, instead of the job's own; without faces of the "
        "job or --couple, its faces that lie opposite each other are coupled",
    )
    source.add_argument(
        "--couple",
        metavar="FACE:FACE",
        type=pair,
        action="append",
        default=[],
        help="couple two faces of --envelope, named as FreeCAD names them; may be repeated, order counts",
    )
    source.add_argument("--seed", metavar="N", type=whole_number, help="one number reproduces all random draws")
    source.add_argument("--engine", choices=ENGINES, help="how the scaffold is made (default: chosen by an estimate)")
    source.add_argument(
        "--set",
        metavar="NAME=VALUE",
        action="append",
        default=[],
        help="set a field of the job, e.g. path.kind=centre or couplings.0.on=false; may be repeated",
    )
    result = parser.add_argument_group("what is written")
    result.add_argument(
        "--out",
        metavar="DIR",
        help="folder for scaffold.stl, channels.stl, network.step, design.FCStd, report.json, report.md",
    )
    result.add_argument(
        "--also",
        metavar="FORMAT",
        choices=MORE_FORMATS,
        action="append",
        default=[],
        help=f"scaffold and channels in a further format: {', '.join(MORE_FORMATS)} (brep: the network); may be "
        "repeated",
    )
    result.add_argument(
        "--save-job", metavar="FILE", help="write the job with all its fields; without --out nothing is designed"
    )
    result.add_argument("--quiet", action="store_true", help="no progress and no summary, errors only")


def _check_design(options: Dict[str, Any]) -> Optional[str]:
    if options["preset"] == "list":
        return None
    if not (options["preset"] or options["job"] or options["envelope"]):
        return "what is to be designed? one of --preset, --job or --envelope is needed"
    if not (options["out"] or options["save_job"]):
        return "where shall it go? --out DIR is needed (or --save-job FILE, to write the job only)"
    if options["couple"] and not options["envelope"]:
        return "--couple names faces of --envelope, which is not given"
    return None


COMMANDS: Tuple[Command, ...] = (
    Command(
        "design",
        "design a network of rods, its channels and a scaffold",
        "freecad_trabecula.shell.design",
        _design_options,
        _check_design,
        ("job", "envelope", "out", "save_job"),
        _DESIGN_EXAMPLES,
    ),
    Command(
        "analyse",
        "measure every slice of a body, and its morphometry",
        "freecad_trabecula.shell.analyse",
        slice_options.analyse_options,
        slice_options.check_analyse,
        ("file", "out"),
        slice_options.ANALYSE_EXAMPLES,
    ),
    Command(
        "compare",
        "compare analyses on shared axes, with a passport of scores",
        "freecad_trabecula.shell.compare",
        slice_options.compare_options,
        slice_options.check_compare,
        ("samples", "out"),
        slice_options.COMPARE_EXAMPLES,
    ),
    Command(
        "voxels",
        "design voxels with exactly the sliced areas of a sample along X, Y and Z",
        "freecad_trabecula.shell.voxels",
        voxel_options.voxel_options,
        voxel_options.check_voxels,
        ("file", "out", "mask", "tables"),
        voxel_options.EXAMPLES,
    ),
    Command(
        "report",
        "tell folders of results in one HTML page",
        "freecad_trabecula.shell.report",
        report_options.report_options,
        report_options.check_report,
        ("folders", "out"),
        report_options.EXAMPLES,
    ),
)


def _absolute(path: str) -> str:
    path.encode("utf-8")  # reports hold it
    return os.path.abspath(os.path.expanduser(path))


def make_parser() -> argparse.ArgumentParser:
    """Return the parser of the whole command line."""
    form = argparse.RawDescriptionHelpFormatter
    parser = Parser(prog=PROGRAM, description="Trabecula: trabecular (bone-like) structures.", formatter_class=form)
    kinds = parser.add_subparsers(dest="command", metavar="COMMAND", parser_class=Parser)
    for command in COMMANDS:
        title = command.summary[0].upper() + command.summary[1:] + " (lengths in mm)."
        own = kinds.add_parser(
            command.name, help=command.summary, description=title, epilog=command.examples, formatter_class=form,
            allow_abbrev=False,
        )  # fmt: skip
        command.add_options(own)
    return parser


def read_arguments(arguments: Sequence[str]) -> Tuple[Command, Dict[str, Any]]:
    """Return the sub-command and its options, file names made absolute.

    Parameters
    ----------
    arguments : sequence of str
        Without the program's name.

    Raises
    ------
    SystemExit
        With code 2 after one sentence for wrong usage, 0 after ``--help``.
    """
    parser = make_parser()
    options = vars(parser.parse_args(arguments))
    chosen = options.pop("command")
    if chosen is None:
        parser.error(f"a command is needed: {', '.join(c.name for c in COMMANDS)}")
    command = next(c for c in COMMANDS if c.name == chosen)
    wrong = command.check(options)
    if wrong:
        parser.prog = f"{PROGRAM} {command.name}"
        parser.error(wrong)
    try:
        for name in command.paths:
            value = options[name]
            if isinstance(value, list):
                options[name] = [_absolute(path) for path in value]
            elif value:
                options[name] = _absolute(value)
    except OSError as error:
        parser.error(f"the folder in which the command was given cannot be read: {error.strerror}")
    except UnicodeEncodeError as error:
        parser.error(f"the name of a file must be text in UTF-8, got {error.object!r}")
    return command, options
