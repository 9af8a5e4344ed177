# SPDX-License-Identifier: LGPL-2.1-or-later
"""A release, step by step: ``make release`` (VERSION=0.2.0 names a new version first).

    python3 tools/release.py                     all steps; the archive is left in build/release
    python3 tools/release.py --version 0.2.0     writes version and day into package.xml, CITATION.cff, CHANGELOG.md
    python3 tools/release.py --draft             no release, but a try: tells all that would forbid one

The version stands in package.xml; the other two files are made to agree. Steps: package.xml and the files that must
agree with it; nothing uncommitted; translations fresh; ruff, the layers, the house style, links, licences; the
archive, made twice, equal byte by byte; installed from the archive into a clean FreeCAD home, here and on the newest
FreeCAD. The first step that fails ends it with exit code 1. It writes no tag and sends nothing: the last line says
what is left to do.
"""

import argparse
import datetime
import hashlib
import re
import subprocess
import sys
import time
from pathlib import Path

import archive
import check_package

ROOT = Path(__file__).resolve().parent.parent
PYTHON = "/usr/bin/python3"
PYTEST = (PYTHON, "-m", "pytest", "-q", "-p", "no:cacheprovider")
#: Tests of the tree as a package; .ci/run has all the others.
PACKAGE_TESTS = ("test_package", "test_docs", "test_licences", "test_style", "test_imports", "test_checklist")


def set_version(root, version, day):
    """Write a version and its day into the files that name them.

    Raises
    ------
    SystemExit
        If the version is no x.y.z, is not above the present one, or the changelog has nothing unreleased.
    """
    if not re.match(r"\d+\.\d+\.\d+$", version):
        sys.exit("release: a version is x.y.z, got %r" % version)
    present = check_package.version_of(root)
    if numbers_of(version) < numbers_of(present):
        sys.exit("release: the version must not go back from %s, got %s" % (present, version))
    changes = (
        ("package.xml", r"<version>[^<]*", "<version>" + version),
        ("package.xml", r"<date>[^<]*", "<date>" + day),
        ("CITATION.cff", r"(?m)^version: .*", "version: " + version),
        ("CITATION.cff", r"(?m)^date-released: .*", "date-released: " + day),
        ("CHANGELOG.md", r"(?m)^## \S+ \(unreleased\)$", "## %s (%s)" % (version, day)),
    )
    texts = {name: (root / name).read_text(encoding="utf-8") for name, _, _ in changes}
    for name, old, new in changes:
        if len(re.findall(old, texts[name])) != 1:
            sys.exit("release: %s must hold %s once" % (name, old))
        texts[name] = re.sub(old, new, texts[name])
    for name, text in texts.items():
        (root / name).write_text(text, encoding="utf-8")


def numbers_of(version):
    """Return a version as numbers that can be compared."""
    return [int(number) for number in version.split(".")]


def check_files():
    """Return what forbids a release of the tree as it is."""
    faults = check_package.faults_of(ROOT)
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    if "(unreleased)" in changelog:
        faults.append("CHANGELOG.md says unreleased: name the version, make release VERSION=x.y.z")
    status = subprocess.run(["git", "-C", str(ROOT), "status", "--porcelain"], stdout=subprocess.PIPE, check=True)
    if status.stdout.strip():
        faults.append("what is released must be committed:\n" + status.stdout.decode("utf-8", "replace"))
    return faults


def step(title, command, failed=None):
    """Run one step and end everything if it fails; with a list ``failed`` note its title there and go on."""
    started = time.time()
    print("==== " + title, flush=True)
    done = subprocess.run([str(word) for word in command], cwd=str(ROOT), stdin=subprocess.DEVNULL, check=False)
    if done.returncode and failed is not None:
        failed.append(title)
    elif done.returncode:
        sys.exit("release: %s failed (exit code %d)" % (title, done.returncode))
    print("==== %s: %.0f s" % (title, time.time() - started), flush=True)


def make_archive(folder, version):
    """Write the archive and the sum of its bytes, and see that a second one is equal; return its path."""
    folder.mkdir(parents=True, exist_ok=True)
    path = archive.write_archive(folder / ("%s-%s.zip" % (archive.NAME, version)))
    again = archive.write_archive(folder / "again.zip")
    same = again.read_bytes() == path.read_bytes()
    again.unlink()
    if not same:
        sys.exit("release: the archive was not the same twice")
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    path.with_suffix(".zip.sha256").write_text("%s  %s\n" % (digest, path.name), encoding="ascii")
    print(
        "==== archive: %s, %.1f MB, sha256 %s" % (path.relative_to(ROOT), path.stat().st_size / 1e6, digest), flush=True
    )
    return path


def main():
    """Run the steps; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", metavar="X.Y.Z", help="write this version first")
    parser.add_argument("--draft", action="store_true", help="try the steps on a tree that is not ready")
    choices = parser.parse_args()
    if choices.version:
        set_version(ROOT, choices.version, datetime.date.today().isoformat())
        print("release: version %s is written; commit it, then: make release" % choices.version)
        return 0
    faults = check_files()
    for fault in faults:
        print("release: " + fault, flush=True)
    if faults and not choices.draft:
        return 1
    version = check_package.version_of(ROOT)
    print("==== package.xml, CITATION.cff, CHANGELOG.md: version %s" % version, flush=True)
    failed = ["files"] * bool(faults) if choices.draft else None
    step("translations", (PYTHON, "tools/translations.py", "--check"), failed)
    step("lint", ("make", "lint"), failed)
    tests = [ROOT / "tests" / (name + ".py") for name in PACKAGE_TESTS]
    step("tests of the package", (*PYTEST, *(one for one in tests if one.exists())), failed)
    path = make_archive(ROOT / "build" / "release", version)
    step("installed from the archive, this FreeCAD", (*PYTEST, "tests/release"), failed)
    step("the newest FreeCAD is there", ("sh", "tools/newest_freecad.sh", "build"), failed)
    newest = ("sh", "tools/newest_freecad.sh", "run")
    step("installed from the archive, newest FreeCAD", (*newest, *PYTEST, "tests/release"), failed)
    if failed:
        sys.exit("release: as a release this would have failed: " + ", ".join(failed))
    print("release: %s is ready. Left to do: run .ci/run, then git tag v%s && git push --tags" % (path.name, version))
    return 0


if __name__ == "__main__":
    sys.exit(main())
