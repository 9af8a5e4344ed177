# SPDX-License-Identifier: LGPL-2.1-or-later
"""The B-Rep engine on the thesis' six cases: how far it comes, time, memory, volumes, and what STEP keeps.

``python3 tools/brep_table.py [case1 ...]`` (FREECADCMD chooses the FreeCAD) runs each case in a process of its own and
prints one row for each. Seconds are CPU seconds of the engine alone; the memory is the whole process's peak. Exit code
1 if a case that is called finished is not valid, or its volume is not the mesh's within 0.2 %, before or after STEP.
"""

import argparse
import json
import resource
import sys
import tempfile
import time
from pathlib import Path

import under_freecad

CASES = ("case1", "case2", "case3", "case4", "case5", "case6")
BOUND = 2e-3  # relative, of volumes
HEAD = (
    "| case | FreeCAD, kernel | rods cut | CPU s | peak GB | solid mm3 | mesh mm3 | difference | faces | valid "
    "| STEP read back mm3 |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|"
)


def measure(name, seconds):
    """Return one row of the table as a dictionary; inside FreeCAD."""
    import dataclasses

    import FreeCAD
    import Part

    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.geometry.design import make_design
    from freecad_trabecula.geometry.scaffold_solids import cut_solid

    job = preset(name)
    design = make_design(job)
    limits = dataclasses.replace(job.scaffold, seconds=seconds)
    start = time.process_time()
    made = cut_solid(design.envelope, design.wireframe, job.rods, limits)
    row = {"case": name, "seconds": time.process_time() - start, **made._asdict()}
    row["peak_gb"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e9
    row["freecad"] = f"{'.'.join(FreeCAD.Version()[:3])}, {Part.OCC_VERSION}"
    row["shown"], row["faces"], row["valid"] = made.shape.Volume, len(made.shape.Faces), made.shape.isValid()
    del row["shape"]
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / f"{name}.step")
        made.shape.exportStep(path)
        again = Part.Shape()
        again.read(path)
    row["step"], row["step_valid"] = again.Volume, again.isValid()
    return row


def is_right(row):
    """Return whether a row holds what it says: valid, and three volumes that agree."""
    agree = abs(row["volume"] / row["mesh_volume"] - 1) <= BOUND and abs(row["step"] / row["shown"] - 1) <= BOUND
    return row["valid"] and agree


def line(row):
    """Return a row of the table as text."""
    difference = row["volume"] / row["mesh_volume"] - 1
    return (
        f"| {row['case']} | {row['freecad']} | {row['rods']} of {row['wanted']} | {row['seconds']:.0f} "
        f"| {row['peak_gb']:.2f} | {row['volume']:.4f} | {row['mesh_volume']:.4f} | {difference:+.1e} | {row['faces']} "
        f"| {'yes' if row['valid'] else 'NO'} | {row['step']:.4f}{'' if row['step_valid'] else ' (not valid)'} |"
        + (f"\n\n{row['case']}: {row['reason']}\n" if row["reason"] else "")
    )


def main(arguments):
    """Measure one case; inside FreeCAD."""
    options = parse(arguments)
    Path(options.result).write_text(json.dumps(measure(options.cases[0], options.seconds)), encoding="utf-8")
    return 0


def parse(arguments):
    """Return the options."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cases", nargs="*", default=list(CASES))
    parser.add_argument("--seconds", type=float, default=3600.0, help="time budget of each case")
    parser.add_argument("--result", default="")
    return parser.parse_args(arguments)


def table(options):
    """Print the table and return the exit code."""
    print(HEAD, flush=True)
    good = True
    with tempfile.TemporaryDirectory() as folder:
        for case in options.cases:
            path = Path(folder) / f"{case}.json"
            under_freecad.run(__file__, [case, "--seconds", str(options.seconds), "--result", str(path)])
            if not path.exists():
                print(f"| {case} | ended without a result |", flush=True)
                good = False
                continue
            row = json.loads(path.read_text(encoding="utf-8"))
            print(line(row), flush=True)
            good = good and is_right(row)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(table(parse(sys.argv[1:])))
