# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs all of Trabecula's tests and counts them: ``/usr/bin/python3 tests/run.py`` (``make test``).

Three parts: *plain* (pytest, plain Python), *document* (unittest under freecadcmd) and *window* (unittest in a FreeCAD
window on a display of its own). A file's folder says which part it belongs to. Document and window files run in
a process each, with a home of their own, so that a crash or a hang is one file's failure. The last line is
``N passed, N failed, N skipped``; a part, or a file, without tests counts as failed. Needs the standard library only.
"""

import argparse
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TESTS = ROOT / "tests"
#: Which part the tests of a folder belong to; "" is the folder tests itself.
PARTS = {
    "": "plain",
    "core": "plain",
    "shell": "plain",
    "examples": "plain",
    "release": "plain",
    "geometry": "document",
    "features": "document",
    "gui": "window",
}
#: Seconds after which a process is ended: all of the plain tests, one file of the others.
TIMEOUTS = {"plain": 2700, "document": 600, "window": 600}
#: A refusal raised on purpose by an object's execute: FreeCAD reports it with its traceback, and this last line.
REFUSAL = "<class 'freecad_trabecula.errors."
#: Settings in the home of the tests: no start page, which starts a web browser; no guide; numbers by language.
SETTINGS = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters>
  <FCParamGroup Name="Root">
    <FCParamGroup Name="BaseApp">
      <FCParamGroup Name="Preferences">
        <FCParamGroup Name="General">
          <FCText Name="AutoloadModule">PartWorkbench</FCText>
          <FCText Name="Language">{language}</FCText>
          <FCInt Name="UseLocaleFormatting" Value="1"/>
        </FCParamGroup>
        <FCParamGroup Name="Mod">
          <FCParamGroup Name="Trabecula">
            <FCBool Name="ShowStartPanel" Value="0"/>
          </FCParamGroup>
          <FCParamGroup Name="Start">
            <FCBool Name="ShowOnStartup" Value="0"/>
            <FCBool Name="FirstStart2024" Value="0"/>
          </FCParamGroup>
        </FCParamGroup>
      </FCParamGroup>
    </FCParamGroup>
  </FCParamGroup>
</FCParameters>
"""


class Outcome:
    """What came of one file, or of all the plain tests."""

    def __init__(self, name, passed=0, failed=0, skipped=0, reasons=(), seconds=0.0, text=""):
        self.name = name
        self.passed = passed
        self.failed = failed
        self.skipped = skipped
        self.reasons = list(reasons)
        self.seconds = seconds
        self.text = text

    def line(self):
        """Return one line for the reader."""
        state = "FAIL" if self.failed else "ok"
        counts = "%d passed, %d failed, %d skipped" % (self.passed, self.failed, self.skipped)
        return "%-4s %-45s %s (%.1f s)" % (state, self.name, counts, self.seconds)


def read_arguments():
    """Return the command line's choices."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", default=[], metavar="PATH", help="test files or folders")
    parser.add_argument("--match", metavar="WORD", help="only tests whose name contains WORD")
    parser.add_argument("--out", default="build/test", help="folder for logs and counts (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=min(os.cpu_count() or 1, 4), help="processes at once")
    return parser.parse_args()


def chosen_files(only):
    """Return the test files of each part; those below the paths `only`, if there are any."""
    wanted = [Path(path).resolve() for path in only]
    for path in wanted:
        if not path.exists():
            sys.exit("no such test file or folder: %s" % path)
    files = {part: [] for part in ("plain", "document", "window")}
    for path in sorted(TESTS.rglob("test_*.py")):
        if wanted and not any(path == one or one in path.parents for one in wanted):
            continue
        folder = path.relative_to(TESTS).parts[0] if path.parent != TESTS else ""
        if folder not in PARTS:
            sys.exit("tests/run.py does not know how to run the tests in tests/%s: add it to PARTS" % folder)
        files[PARTS[folder]].append(path)
    return {part: paths for part, paths in files.items() if paths or not wanted}


def freecad_facts(folder):
    """Return what freecadcmd says of itself (see tools/freecad_facts.py)."""
    path = folder / "facts.json"
    command = ["freecadcmd", str(ROOT / "tools" / "freecad_facts.py")]
    environment = dict(os.environ, TRABECULA_FACTS=str(path))
    subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True)
    return json.loads(path.read_text(encoding="utf-8"))


def run_process(command, environment, log, timeout):
    """Run a command with its output in `log`; return its exit code, None if it took too long and was ended."""
    with open(log, "wb") as output:
        process = subprocess.Popen(
            command,
            env=environment,
            cwd=str(ROOT),
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            return process.wait(timeout)
        except subprocess.TimeoutExpired:
            return None
        finally:
            # Also what it left behind: the display's server, a child of a test.
            end_group(process)


def end_group(process):
    """End a process and all that it started."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, number)
        except ProcessLookupError:
            break
        time.sleep(0.1)
    process.wait()


def tail(log, lines=80):
    """Return the end of a log."""
    return "\n".join(log.read_text(encoding="utf-8", errors="replace").splitlines()[-lines:])


def test_environment(facts, folder):
    """Return the environment of every test process: byte code and large test files have their places."""
    environment = dict(os.environ)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        environment.pop(name, None)
    data = ROOT.parent / "shared" / "data"
    if data.is_dir():
        environment.setdefault("TRABECULA_DATA", str(data))
    environment["TRABECULA_PACKAGES"] = facts["packages"]
    environment["PYTHONPYCACHEPREFIX"] = str(folder / "pycache")
    environment["LC_ALL"] = "C.UTF-8"
    environment["QTWEBENGINE_DISABLE_SANDBOX"] = "1"
    environment["LIBGL_ALWAYS_SOFTWARE"] = "1"
    return environment


def language_of(path):
    """Return the language of the window that a test file wants: its line ``LANGUAGE = "German"``, else English."""
    found = re.search(r'^LANGUAGE = "(\w+)"$', path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    return found[1] if found else "English"


def make_home(facts, language="English"):
    """Return a new folder for FREECAD_USER_HOME: default settings, the user's additional packages, this workbench."""
    home = Path(tempfile.mkdtemp(prefix="trabecula-home-"))
    (home / "user.cfg").write_text(SETTINGS.format(language=language), encoding="utf-8")
    packages = Path(facts["user_data"]) / "AdditionalPythonPackages"
    if packages.is_dir():
        (home / "AdditionalPythonPackages").symlink_to(packages)
    (home / "Mod").mkdir()
    (home / "Mod" / "Trabecula").symlink_to(ROOT)
    return home


# ------------------------------------------------------------------------------------------------------ the parts


def run_plain(files, choices, facts, environment, folder):
    """Run pytest on the plain tests; return their common outcome."""
    report, log = folder / "plain.xml", folder / "plain.log"
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-ra",
        "-p",
        "no:cacheprovider",
        "--continue-on-collection-errors",
        "--junitxml=%s" % report,
    ]
    if choices.match:
        command += ["-k", choices.match]
    home = make_home(facts)
    # For the tests of the command line, which start FreeCAD.
    environment = dict(environment, FREECAD_USER_HOME=str(home))
    started = time.time()
    try:
        status = run_process(command + [str(path) for path in files], environment, log, TIMEOUTS["plain"])
    finally:
        shutil.rmtree(str(home), ignore_errors=True)
    outcome = Outcome("tests in plain Python (%d files)" % len(files), seconds=time.time() - started)
    if report.exists():
        for suite in ElementTree.parse(str(report)).iter("testsuite"):
            failed = int(suite.get("failures", 0)) + int(suite.get("errors", 0))
            outcome.failed += failed
            outcome.skipped += int(suite.get("skipped", 0))
            outcome.passed += int(suite.get("tests", 0)) - failed - int(suite.get("skipped", 0))
        outcome.reasons = sorted({skip.get("message", "") for skip in ElementTree.parse(str(report)).iter("skipped")})
    # 5: no test was found, which the caller judges.
    if status not in (0, 5) and not outcome.failed:
        outcome.failed = 1
    if outcome.failed:
        outcome.text = tail(log, 400)
    return outcome


def unexpected_tracebacks(text):
    """Return the tracebacks of a FreeCAD log, without those of refusals raised on purpose by an object's execute."""
    found = []
    for block in text.split("Traceback (most recent call last):")[1:]:
        # The first line that is not indented names the error.
        lines = re.split(r"^(?=\S)", block.lstrip("\n"), maxsplit=1, flags=re.MULTILINE)
        error = lines[1].splitlines()[0] if len(lines) > 1 else ""
        if not error.startswith(REFUSAL):
            found.append("Traceback:\n" + lines[0] + error)
    return found


def run_in_freecad(part, path, choices, facts, environment, folder):
    """Run one file of tests under freecadcmd or in the window; return its outcome."""
    name = str(path.relative_to(ROOT))
    label = "-".join(path.relative_to(TESTS).with_suffix("").parts)
    log, result = folder / (label + ".log"), folder / (label + ".json")
    if result.exists():
        result.unlink()
    home = make_home(facts, language_of(path))
    job = {"file": str(path), "result": str(result), "pattern": choices.match, "timeout": TIMEOUTS[part]}
    environment = dict(environment, FREECAD_USER_HOME=str(home), TRABECULA_TEST=json.dumps(job))
    command = ["freecadcmd", str(TESTS / "run_in_freecad.py")]
    if part == "window":
        command = ["xvfb-run", "-a", "-s", "-screen 0 1400x900x24", "freecad", command[1]]
    started = time.time()
    try:
        status = run_process(command, environment, log, TIMEOUTS[part])
    finally:
        shutil.rmtree(str(home), ignore_errors=True)
    outcome = Outcome(name, seconds=time.time() - started)
    judge(outcome, part, status, result, log, choices)
    return outcome


def judge(outcome, part, status, result, log, choices):
    """Fill in an outcome from what a FreeCAD process left."""
    if result.exists() and status == 0:
        counts = json.loads(result.read_text(encoding="utf-8"))
        outcome.passed, outcome.failed = counts["passed"], counts["failed"]
        outcome.skipped, outcome.reasons = counts["skipped"], counts["reasons"]
        if not (outcome.passed or outcome.failed or outcome.skipped or choices.match):
            outcome.failed = 1
            outcome.text = "no unittest.TestCase with a test was found in this file"
    else:
        outcome.failed = 1
        if status is None:
            outcome.text = "ended after %d s, its limit" % TIMEOUTS[part]
        else:
            outcome.text = "died: exit code %s" % status
    if outcome.failed:
        outcome.text = tail(log) + "\n" + outcome.text
    if part == "window":
        unexpected = unexpected_tracebacks(log.read_text(encoding="utf-8", errors="replace"))
        if unexpected and not outcome.failed:
            outcome.failed = 1
            outcome.text = "\n".join([*unexpected, "the window reported a traceback, though no test failed"])


# -------------------------------------------------------------------------------------------------- all together


def run_all(files, choices, facts, folder):
    """Run the chosen files of all parts, and say what comes of them; return their outcomes by part."""
    environment = test_environment(facts, folder)
    outcomes = {part: [] for part in files}
    with ThreadPoolExecutor(max(choices.jobs, 1)) as pool:
        waiting = []
        if files.get("plain"):
            waiting.append(("plain", pool.submit(run_plain, files["plain"], choices, facts, environment, folder)))
        for path in files.get("document", []):
            arguments = ("document", path, choices, facts, environment, folder)
            waiting.append(("document", pool.submit(run_in_freecad, *arguments)))
        for part, future in waiting:
            outcomes[part].append(future.result())
            print(outcomes[part][-1].line(), flush=True)
    # One window at a time, and nothing beside it: its tests look at the clock.
    for path in files.get("window", []):
        outcomes["window"].append(run_in_freecad("window", path, choices, facts, environment, folder))
        print(outcomes["window"][-1].line(), flush=True)
    for part, found in outcomes.items():
        if not choices.match and not any(outcome.passed or outcome.failed for outcome in found):
            outcomes[part].append(Outcome("the %s part" % part, failed=1, text="not one of its tests ran"))
    return outcomes


def main():
    """Run the tests; return the exit code."""
    choices = read_arguments()
    folder = (ROOT / choices.out).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    facts = freecad_facts(folder)
    modules = ", ".join("%s %s" % item for item in sorted(facts["modules"].items()))
    print("FreeCAD %s, Python %s, %s" % (facts["freecad"], facts["python"], modules), flush=True)
    outcomes = run_all(chosen_files(choices.only), choices, facts, folder)
    every = [outcome for found in outcomes.values() for outcome in found]
    for outcome in every:
        if outcome.failed:
            print("\n======== FAIL %s\n%s" % (outcome.name, outcome.text))
    skips = sorted({reason for outcome in every for reason in outcome.reasons})
    if skips:
        print("\nskipped, because:\n  " + "\n  ".join(skips))
    total = {name: sum(getattr(outcome, name) for outcome in every) for name in ("passed", "failed", "skipped")}
    if not total["passed"] + total["failed"]:
        total["failed"] = 1
        print("no test ran")
    (folder / "counts.json").write_text(json.dumps(total), encoding="utf-8")
    print("\nlogs are in %s" % folder)
    print("%(passed)d passed, %(failed)d failed, %(skipped)d skipped" % total, flush=True)
    return 1 if total["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
