# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of every panel and of each design (``make gallery``), from a real FreeCAD window of 1280 x 800 under Xvfb.

They go to build/gallery/; ``--docs`` copies those that the pages show into docs/pictures/. ``--only panels`` or
``--only case6`` takes some of them. The window's own part is ``gallery_window.py``. The page of a report is pictured by
a browser, if there is one.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

import run as tests  # noqa: E402  the folder comes first

PARTS = (
    *("panels", "analysis", "voxels", "study", "seeing", "report", "dark"),
    *("case1", "case2", "case3", "case4", "case5", "case6"),
    *("prism420", "cranial", "femur"),
)
#: Pictures that the pages show.
IN_DOCS = ("design-sites", "design-pores", "design-couplings", "results-figures", "edit-site", "cranial-preview",
           "case6-scaffold", "cranial-scaffold", "analysis-areas", "analysis-compared", "voxels-panel",
           "voxels-layers", "voxels-tables", "voxels-watch", "voxels-curves", "why-results", "variants",
           "seeing-section", "seeing-colours", "report-page")  # fmt: skip
TIMEOUT = 900  # s a part
#: Browsers that picture a page without showing it.
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
PAGE = (1000, 910)  # pixels


def read_arguments():
    """Return the command line's choices."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", choices=PARTS, default=list(PARTS), help="parts (default: all)")
    parser.add_argument("--out", default="build/gallery", help="folder of the pictures (default: %(default)s)")
    parser.add_argument("--docs", action="store_true", help="copy some into docs/pictures")
    return parser.parse_args()


def take(part, folder, facts):
    """Take the pictures of one part in a window of its own; return whether all went well."""
    home, log = tests.make_home(facts), folder / ("%s.log" % part)
    script = str(ROOT / "tools" / "gallery_window.py")
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24 -dpi 96", "freecad", script]
    started = time.time()
    try:
        for step in ("theme", part) if part == "dark" else (part,):
            choice = json.dumps({"part": step, "folder": str(folder)})
            environment = dict(tests.test_environment(facts, folder), FREECAD_USER_HOME=str(home))
            status = tests.run_process(command, dict(environment, TRABECULA_GALLERY=choice), log, TIMEOUT)
    finally:
        shutil.rmtree(str(home), ignore_errors=True)
    text = log.read_text(encoding="utf-8", errors="replace")
    faults = tests.unexpected_tracebacks(text)
    good = status == 0 and not faults
    print("%-4s %-10s %.0f s" % ("ok" if good else "FAIL", part, time.time() - started), flush=True)
    if not good:
        print(tests.tail(log, 30))
    return good


def picture_page(folder):
    """Picture the report that the window wrote, as a browser shows it; without a browser say so and leave it."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    page, picture = folder / "report.html", folder / "report-page.png"
    if browser is None:
        print("SKIPPED report-page: no browser is here, of %s" % ", ".join(BROWSERS), flush=True)
        return True
    picture.unlink(missing_ok=True)
    command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"]
    command += ["--window-size=%d,%d" % PAGE, "--screenshot=%s" % picture, page.as_uri()]
    subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
    print("%-4s report-page by %s" % ("ok" if picture.exists() else "FAIL", browser), flush=True)
    return picture.exists()


def main():
    """Take all pictures; return the exit code."""
    choices = read_arguments()
    folder = (ROOT / choices.out).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    facts = tests.freecad_facts(folder)
    print("FreeCAD %s" % facts["freecad"], flush=True)
    failed = [part for part in choices.only if not take(part, folder, facts)]
    if "report" in choices.only and "report" not in failed and not picture_page(folder):
        failed.append("report-page")
    pictures = sorted(folder.glob("*.png"))
    print("%d pictures in %s" % (len(pictures), folder))
    if choices.docs:
        target = ROOT / "docs" / "pictures"
        target.mkdir(parents=True, exist_ok=True)
        for name in IN_DOCS:
            if (folder / (name + ".png")).exists():
                shutil.copy(str(folder / (name + ".png")), str(target))
    return 1 if failed or not pictures else 0


if __name__ == "__main__":
    os.chdir(str(ROOT))
    sys.exit(main())
