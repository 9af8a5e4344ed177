# SPDX-License-Identifier: LGPL-2.1-or-later
"""package.xml is right, and each rule of tools/check_package.py finds what breaks it."""

import importlib.util
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
specification = importlib.util.spec_from_file_location("check_package", str(ROOT / "tools" / "check_package.py"))
check_package = importlib.util.module_from_spec(specification)
specification.loader.exec_module(check_package)
FILES = ("package.xml", "InitGui.py", "CITATION.cff", "CHANGELOG.md", "pyproject.toml", "LICENSE")
FILES += ("resources/icons/trabecula.svg", "resources/examples/LICENSE.BMFToolkit", "LICENSES/CC0-1.0.txt")


def test_nothing_is_wrong_with_our_package():
    assert check_package.faults_of(ROOT) == []


@pytest.fixture
def tree(tmp_path):
    """A copy of the files that are looked at."""
    for name in FILES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(str(ROOT / name), str(tmp_path / name))
    assert check_package.faults_of(tmp_path) == []
    return tmp_path


#: File, what stands there, what stands there instead, a word of the fault that it must give.
FAULTS = {
    "no xml": ("package.xml", "</package>", "", "no XML"),
    "another namespace": ("package.xml", "wiki.freecad.org/Package_Metadata", "wiki.freecad.org/Other", "root must be"),
    "another format": ("package.xml", 'format="1"', 'format="2"', "root must be"),
    "no icon": ("package.xml", "<icon>resources/icons/trabecula.svg</icon>\n  <tag>", "<tag>", "<icon> is required"),
    "an unknown tag": ("package.xml", "<tag>bone</tag>", "<tags>bone</tags>", "<tags> is unknown"),
    "two dates": ("package.xml", "<maintainer", "<date>2026-01-01</date><maintainer", "<date> must stand once"),
    "an empty tag": ("package.xml", "<tag>bone</tag>", "<tag></tag>", "<tag> is empty"),
    "a name that is no file's": (
        "package.xml",
        "<name>Trabecula</name>\n  <desc",
        "<name>Tra/becula</name><desc",
        "file's name",
    ),
    "a version of two numbers": ("package.xml", "<freecadmin>0.20.2", "<freecadmin>0.20", "<freecadmin> must be x.y.z"),
    "a Python of three numbers": ("package.xml", "<pythonmin>3.8", "<pythonmin>3.8.1", "<pythonmin> must be"),
    "a day that is not": ("package.xml", "</date>", "-31</date>", "<date> must be YYYY-MM-DD"),
    "a date in words": ("package.xml", "<date>2026", "<date>26 Nov 2026", "<date> must be YYYY-MM-DD"),
    "nobody to write to": ("package.xml", ' email="trabecula@users.noreply.github.com"', "", "needs an email"),
    "a licence by a nickname": ("package.xml", ">LGPL-2.1-or-later<", ">LGPL2.1+<", "SPDX"),
    "a licence without its text": ("package.xml", 'file="LICENSE"', 'file="COPYING"', "file of <license>"),
    "an unknown address": ("package.xml", 'type="bugtracker"', 'type="issues"', "unknown type"),
    "no readme": ("package.xml", 'type="readme"', 'type="website"', "type='readme'> is needed"),
    "no branch": ("package.xml", ' branch="main"', "", "needs a branch"),
    "an address in clear": (
        "package.xml",
        "https://github.com/trabecula/trabecula<",
        "http://github.com/t/t<",
        "https",
    ),
    "a package that is not allowed": ("package.xml", ">openpyxl<", ">manifold3d<", "manifold3d"),
    "a dependency without a type": ("package.xml", '<depend type="python">numpy', "<depend>numpy", "'numpy'"),
    "optional perhaps": ("package.xml", 'optional="true">scipy', 'optional="maybe">scipy', "true or false"),
    "no workbench": ("package.xml", "workbench>", "macro>", "one <workbench>"),
    "another class": ("InitGui.py", "class TrabeculaWorkbench(", "class Trabecula(", "<classname>"),
    "an icon that is missing": ("package.xml", "<icon>resources/icons/trabecula.svg", "<icon>icons/t.svg", "no SVG"),
    "an icon that is large": ("resources/icons/trabecula.svg", "</svg>", "<!--" + "x" * 10_000 + "--></svg>", "bytes"),
    "another version in the citation": ("CITATION.cff", "version: 0.", "version: 9.", "CITATION.cff must say version"),
    "another day in the citation": ("CITATION.cff", "released: 2026", "released: 1999", "must say date-released"),
    "another version in the changelog": ("CHANGELOG.md", "## 0.1.0", "## 0.0.9", "CHANGELOG.md must begin"),
    "another Python in the settings": ("pyproject.toml", '"py38"', '"py312"', "aim at the least Python"),
}


@pytest.mark.parametrize("what", sorted(FAULTS))
def test_what_breaks_a_rule_is_found(tree, what):
    name, old, new, words = FAULTS[what]
    text = (tree / name).read_text(encoding="utf-8")
    assert old in text
    (tree / name).write_text(text.replace(old, new), encoding="utf-8")
    found = check_package.faults_of(tree)
    assert any(words in fault for fault in found), found
