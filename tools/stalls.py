# SPDX-License-Identifier: LGPL-2.1-or-later
"""For how long the window does not answer while long work is done and shown.

    python3 tools/stalls.py                    measures with this machine's FreeCAD and prints a table
    sh tools/newest_freecad.sh run /usr/bin/python3 tools/stalls.py    with the newest
    python3 tools/stalls.py --docs             writes the table of docs/seeing.md from what has been measured

A window of its own under Xvfb for each kind of work, from the click until the result is seen. Beats 5 ms apart tell the
longest stretch between two turns of the event loop: by the clock, and in processor time of the window's thread, which
other work on the machine does not lengthen. The last column names what the thread did in the busiest stretch: the
innermost line of ours and the innermost of all, as a second thread saw them. ``--only voxels report`` chooses works,
``--pictures`` leaves one of the screen after each step. What is found stays in build/stalls/<version of FreeCAD>.
"""

import argparse
import json
import os
import shutil
import sys
from pathlib import Path

import generated_page

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

import run as tests  # noqa: E402  the folder comes first

WORKS = (
    *("alone", "rods", "femur", "preview", "analysis", "voxels", "colours", "report", "seeds", "documents"),
    "examples",
)
GOAL = 0.2  # s
TIMEOUT = 1200  # s a work


def read_arguments():
    """Return the command line's choices."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", choices=WORKS, default=list(WORKS), help="works (default: all)")
    parser.add_argument("--out", default="build/stalls", help="folder of the logs (default: %(default)s)")
    parser.add_argument("--pictures", action="store_true", help="leave a picture of each step there")
    parser.add_argument("--docs", action="store_true", help="measure nothing, write docs/seeing.md")
    return parser.parse_args()


def measured(work, folder, facts, pictures):
    """Return the rows that a window of its own has measured, and whether all went well."""
    home, log, found = tests.make_home(facts), folder / (work + ".log"), folder / (work + ".json")
    found.write_text("[]", encoding="utf-8")
    choice = json.dumps({"work": work, "result": str(found), "pictures": str(folder) if pictures else ""})
    environment = dict(tests.test_environment(facts, folder), FREECAD_USER_HOME=str(home), TRABECULA_STALLS=choice)
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24 -dpi 96", "freecad"]
    try:
        status = tests.run_process([*command, str(ROOT / "tools" / "stalls_window.py")], environment, log, TIMEOUT)
    finally:
        shutil.rmtree(str(home), ignore_errors=True)
    faults = tests.unexpected_tracebacks(log.read_text(encoding="utf-8", errors="replace"))
    good = status == 0 and not faults
    if not good:
        print("FAIL %s\n%s" % (work, "\n".join(faults) or tests.tail(log, 30)), flush=True)
    return json.loads(found.read_text(encoding="utf-8")), good


def measure(choices, out):
    """Measure and print a table; return the exit code: 1 if a work failed."""
    out.mkdir(parents=True, exist_ok=True)
    facts = tests.freecad_facts(out)
    folder = out / facts["freecad"]
    folder.mkdir(exist_ok=True)
    print("FreeCAD %s\n" % facts["freecad"], flush=True)
    print("| work | step | longest, s | busy, s | over %.1f s | where |\n|---|---|---|---|---|---|" % GOAL, flush=True)
    good = True
    for work in choices.only:
        rows, went_well = measured(work, folder, facts, choices.pictures)
        good = good and went_well
        for row in rows:
            over = "yes" if row["busy"] > GOAL else ""
            words = (work, row["step"], "%.2f" % row["wall"], "%.2f" % row["busy"], over, row["where"])
            print("| %s |" % " | ".join(words), flush=True)
    return 0 if good else 1


def versions(out):
    """Return the folders of what has been measured, the oldest FreeCAD first."""
    found = [path for path in out.iterdir() if path.is_dir() and any(path.glob("*.json"))] if out.is_dir() else []
    return sorted(found, key=lambda path: [int(part) for part in path.name.split(".")])


def worst(folder):
    """Return the rows of a FreeCAD by their steps, in the order of the works; of a step that several take the worst."""
    found = {}
    for path in (folder / (work + ".json") for work in WORKS):
        for row in json.loads(path.read_text(encoding="utf-8")) if path.exists() else []:
            found[row["step"]] = max(row, found.get(row["step"], row), key=lambda one: one["busy"])
    return found


def table(folders):
    """Return the table of docs/seeing.md: a row for each step, two columns for each FreeCAD; bold above the goal."""
    lines = ["| work | %s |" % " | ".join("FreeCAD %s: busy, s | by the clock" % folder.name for folder in folders)]
    lines.append("|---|" + "---|---|" * len(folders))
    found = [worst(folder) for folder in folders]
    for step in dict.fromkeys(step for rows in found for step in rows):
        cells = [step]
        for row in (rows.get(step) for rows in found):
            busy, wall = ("%.2f" % row["busy"], "%.2f" % row["wall"]) if row else ("", "")
            cells += ["**%s**" % busy if row and row["busy"] > GOAL else busy, wall]
        lines.append("| %s |" % " | ".join(cells))
    return "\n".join(lines)


def main():
    """Do what was asked for; return the exit code."""
    choices = read_arguments()
    out = (ROOT / choices.out).resolve()
    if not choices.docs:
        return measure(choices, out)
    folders = versions(out)
    if not folders:
        raise SystemExit("%s must hold what was measured, got nothing: run this without --docs first" % out)
    generated_page.write_part("seeing.md", "stalls", table(folders))
    return 0


if __name__ == "__main__":
    os.chdir(str(ROOT))
    sys.exit(main())
