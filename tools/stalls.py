# SPDX-License-Identifier: LGPL-2.1-or-later
"""For how long the window does not answer while long work is done and shown: ``python3 tools/stalls.py``.

A window of its own under Xvfb for each kind of work, from the click until the result is seen. Beats 5 ms apart tell the
longest stretch between two turns of the event loop: by the clock, and in processor time of the window's thread, which
other work on the machine does not lengthen. The last column names what the thread did in the busiest stretch: the
innermost line of ours and the innermost of all, as a second thread saw them. ``--only voxels report`` chooses works,
``--pictures`` leaves one of the screen after each step. The figures stand in docs/seeing.md.
"""

import argparse
import json
import os
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

import run as tests  # noqa: E402  the folder comes first

WORKS = ("rods", "femur", "analysis", "voxels", "colours", "report", "seeds", "preview", "documents", "examples")
GOAL = 0.2  # s
TIMEOUT = 1200  # s a work


def read_arguments():
    """Return the command line's choices."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", choices=WORKS, default=list(WORKS), help="works (default: all)")
    parser.add_argument("--out", default="build/stalls", help="folder of the logs (default: %(default)s)")
    parser.add_argument("--pictures", action="store_true", help="leave a picture of each step there")
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


def main():
    """Measure and print a table; return the exit code: 1 if a work failed."""
    choices = read_arguments()
    folder = (ROOT / choices.out).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    facts = tests.freecad_facts(folder)
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


if __name__ == "__main__":
    os.chdir(str(ROOT))
    sys.exit(main())
