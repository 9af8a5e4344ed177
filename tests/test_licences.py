# SPDX-License-Identifier: LGPL-2.1-or-later
"""Licences: each file of the tree has a row in docs/licences.md, and the texts of the licences are here."""

import fnmatch
import re
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import tomllib

ROOT = Path(__file__).resolve().parent.parent
#: Licences and settings say themselves what they are.
PLAIN = ("LICENSE", "LICENSES/*", "REUSE.toml", "CITATION.cff", "package.xml", "Makefile", "pyproject.toml", ".*")

MADE = {".git", "build", "__pycache__", ".ruff_cache", ".pytest_cache"}


def tracked_files():
    """Return the files of the tree, as git knows them; without git all but what tests and tools make."""
    command = ["git", "-c", "safe.directory=*", "-C", str(ROOT), "ls-files"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return done.stdout.splitlines()
    names = (path.relative_to(ROOT) for path in ROOT.rglob("*") if path.is_file())
    return [str(name) for name in names if not MADE.intersection(name.parts) and name.suffix != ".pyc"]


def rows_of_licences():
    """Return {pattern of files: licence} of the page."""
    text = (ROOT / "docs" / "licences.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`[^|]*) \| ([\w.-]+) \|", text, re.MULTILINE)
    return {pattern: licence for names, licence in rows for pattern in re.findall(r"`([^`]+)`", names)}


def licence_of(name, rows):
    """Return the licence of a file by the most precise row that it fits; None if it fits none."""
    fitting = [one for one in rows if fnmatch.fnmatch(name, one) or fnmatch.fnmatch(name, one.replace("**/", ""))]
    return rows[max(fitting, key=len)] if fitting else None


def test_every_file_has_a_licence_in_the_page():
    rows = rows_of_licences()
    names = [name for name in tracked_files() if not any(fnmatch.fnmatch(name, one) for one in PLAIN)]
    assert len(names) > 400
    assert [name for name in names if not licence_of(name, rows) and not name.endswith("LICENSE.BMFToolkit")] == []
    assert licence_of("resources/examples/femur_metaphysis.step", rows) == "Zlib"
    assert licence_of("resources/examples/shrew_bone_a.ply", rows) == "CC0-1.0"
    assert licence_of("freecad_trabecula/core/rods.py", rows) == "LGPL-2.1-or-later"


def test_a_file_of_another_kind_has_none():
    assert licence_of("resources/examples/skull.stl", rows_of_licences()) is None


def test_the_text_of_each_licence_that_is_named_is_here():
    named = set(rows_of_licences().values())
    assert {path.stem for path in (ROOT / "LICENSES").iterdir()} == named
    assert (ROOT / "LICENSES" / "LGPL-2.1-or-later.txt").read_bytes() == (ROOT / "LICENSE").read_bytes()


def test_the_package_names_every_licence_that_a_file_has():
    package = ElementTree.parse(str(ROOT / "package.xml")).getroot()
    named = {one.text for one in package.findall("{https://wiki.freecad.org/Package_Metadata}license")}
    assert named == set(rows_of_licences().values())


def test_what_machines_read_says_the_same():
    notes = tomllib.loads((ROOT / "REUSE.toml").read_text(encoding="utf-8"))["annotations"]
    rows = rows_of_licences()
    for one in notes[1:]:
        for name in one["path"]:
            assert (ROOT / name).is_file()
            if name in rows:
                assert rows[name] == one["SPDX-License-Identifier"]
    assert (notes[0]["path"], notes[0]["SPDX-License-Identifier"]) == ("**", "LGPL-2.1-or-later")
