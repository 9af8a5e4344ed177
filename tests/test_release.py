# SPDX-License-Identifier: LGPL-2.1-or-later
"""The release's own steps: the version is written into every file that names it, and refused when it is wrong."""

import importlib
import shutil
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FILES = ("package.xml", "CITATION.cff", "CHANGELOG.md", "InitGui.py", "pyproject.toml", "LICENSE")


@pytest.fixture
def release(monkeypatch):
    """The tool, imported with the tools beside it."""
    monkeypatch.syspath_prepend(str(ROOT / "tools"))
    for name in ("archive", "check_package", "release"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    return importlib.import_module("release")


@pytest.fixture
def tree(tmp_path):
    """A copy of the files that name the version, with something unreleased."""
    for name in FILES:
        shutil.copy(str(ROOT / name), str(tmp_path / name))
    for name in ("resources", "LICENSES"):
        shutil.copytree(str(ROOT / name), str(tmp_path / name))
    text = (tmp_path / "CHANGELOG.md").read_text(encoding="utf-8")
    heading = "## 0.0.9 (unreleased)\n\n* Something.\n\n"
    text = text if "(unreleased)" in text else text.replace("## ", heading + "## ", 1)
    (tmp_path / "CHANGELOG.md").write_text(text, encoding="utf-8")
    return tmp_path


def test_a_version_is_written_into_all_files_that_name_it(release, tree):
    release.set_version(tree, "9.1.2", "2031-02-03")
    assert release.check_package.faults_of(tree) == []
    assert release.check_package.version_of(tree) == "9.1.2"
    assert "## 9.1.2 (2031-02-03)" in (tree / "CHANGELOG.md").read_text(encoding="utf-8")
    assert "date-released: 2031-02-03" in (tree / "CITATION.cff").read_text(encoding="utf-8")


@pytest.mark.parametrize("version", ["1.2", "v1.2.3", "1.2.3-rc1", "0.0.1"])
def test_a_version_that_is_none_or_goes_back_is_refused_and_nothing_is_written(release, tree, version):
    before = {name: (tree / name).read_bytes() for name in FILES}
    with pytest.raises(SystemExit, match="version"):
        release.set_version(tree, version, "2031-02-03")
    assert {name: (tree / name).read_bytes() for name in FILES} == before


def test_a_changelog_without_anything_unreleased_is_refused(release, tree):
    release.set_version(tree, "9.1.2", "2031-02-03")
    with pytest.raises(SystemExit, match="CHANGELOG"):
        release.set_version(tree, "9.1.3", "2031-02-04")
    assert release.check_package.version_of(tree) == "9.1.2"


def test_ten_is_above_nine(release):
    assert release.numbers_of("0.10.0") > release.numbers_of("0.9.9")
