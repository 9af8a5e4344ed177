# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks package.xml against the rules of FreeCAD's Addon Manager, and what must agree with it in other files.

    python3 tools/check_package.py          prints each fault, exit code 1 if there is one
    python3 tools/check_package.py version  prints the version

Rules: the package metadata of format 1 (https://wiki.freecad.org/Package_Metadata and FreeCAD's Addon Academy, "Addon
Manifest"), as the Addon Manager's own reader applies them. Needs the standard library only.
"""

import ast
import datetime
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SPACE = "{https://wiki.freecad.org/Package_Metadata}"
REQUIRED = ("name", "version", "date", "description", "maintainer", "license", "icon", "content")
KNOWN = {*REQUIRED, *("url", "author", "depend", "conflict", "replace", "tag", "freecadmin", "freecadmax", "pythonmin")}
URLS = ("repository", "readme", "bugtracker", "documentation", "website", "discussion")
#: Python packages that the Addon Manager installs (both of FreeCAD's lists of allowed packages), as far as of use here.
ALLOWED = ("numpy", "scipy", "matplotlib", "openpyxl", "pillow", "scikit-image", "trimesh", "networkx", "pandas")
INTERNAL = ("part", "mesh", "partdesign", "draft", "spreadsheet", "fem", "sketcher", "import", "points", "plot")
MOST_ICON = 10_000  # bytes
#: Licences by the identifiers of SPDX that files of a workbench may have.
SPDX = ("LGPL-2.1-or-later", "Zlib", "CC0-1.0", "CC-BY-4.0", "CC-BY-SA-4.0", "MIT", "BSD-3-Clause", "Apache-2.0")
_THREE = re.compile(r"\d+\.\d+\.\d+$")


def children(node, tag):
    """Return the children of a kind."""
    return node.findall(SPACE + tag)


def text_of(node, tag):
    """Return the text of the one child of a kind; empty if there is none."""
    return (node.findtext(SPACE + tag) or "").strip()


def faults_of_tags(root, package):
    """Return what is wrong with the tags: missing, unknown, doubled, empty."""
    faults = []
    if package.tag != SPACE + "package" or package.get("format") != "1":
        faults.append('the root must be <package format="1" xmlns="%s">' % SPACE[1:-1])
    faults += ["<%s> is required" % tag for tag in REQUIRED if not children(package, tag)]
    names = [child.tag[len(SPACE) :] for child in package]
    faults += ["<%s> is unknown" % name for name in sorted(set(names) - KNOWN)]
    for tag in ("name", "version", "date", "description", "icon", "content", "freecadmin", "pythonmin"):
        if names.count(tag) > 1:
            faults.append("<%s> must stand once" % tag)
    faults += ["<%s> is empty" % child.tag[len(SPACE) :] for child in package if not len(child) and not child.text]
    if re.search(r'[/\\?%*:|"<>]', text_of(package, "name")):
        faults.append("<name> must be valid as a file's name, got %r" % text_of(package, "name"))
    return faults


def faults_of_values(root, package):
    """Return what is wrong with version, date, least versions, people, licences, addresses and dependencies."""
    faults = []
    for tag in ("version", "freecadmin"):
        if not _THREE.match(text_of(package, tag)):
            faults.append("<%s> must be x.y.z, got %r" % (tag, text_of(package, tag)))
    if not re.match(r"3\.\d+$", text_of(package, "pythonmin")):
        faults.append("<pythonmin> must be 3.x, got %r" % text_of(package, "pythonmin"))
    try:
        datetime.date(*map(int, text_of(package, "date").split("-")))
    except (TypeError, ValueError):
        faults.append("<date> must be YYYY-MM-DD, got %r" % text_of(package, "date"))
    for one in children(package, "maintainer"):
        if "@" not in one.get("email", ""):
            faults.append("<maintainer> needs an email")
    for one in children(package, "license"):
        if one.text not in SPDX:
            faults.append("<license> must be an SPDX identifier, got %r" % one.text)
        if not (root / one.get("file", "none")).is_file():
            faults.append("the file of <license> is missing: %r" % one.get("file"))
    faults += faults_of_urls(children(package, "url"))
    for one in children(package, "depend"):
        known = {"python": ALLOWED, "internal": INTERNAL}.get(one.get("type"), ())
        if one.text not in known:
            faults.append("<depend type=%r> is not among those that are allowed: %r" % (one.get("type"), one.text))
        if one.get("optional") not in (None, "true", "false"):
            faults.append("optional must be true or false, got %r" % one.get("optional"))
    return faults


def faults_of_urls(urls):
    """Return what is wrong with the addresses."""
    kinds = [one.get("type") for one in urls]
    faults = ["<url> has an unknown type: %r" % kind for kind in kinds if kind not in URLS]
    faults += ["<url type=%r> is needed" % kind for kind in ("repository", "readme", "bugtracker") if kind not in kinds]
    faults += [
        "the repository needs a branch" for one in urls if one.get("type") == "repository" and not one.get("branch")
    ]
    return faults + [
        "an address must be https, got %r" % one.text for one in urls if not (one.text or "").startswith("https://")
    ]


def faults_of_content(root, package):
    """Return what is wrong with the workbench: its class, its folder, its icons."""
    faults = []
    classes = [
        node for node in ast.parse((root / "InitGui.py").read_text("utf-8")).body if isinstance(node, ast.ClassDef)
    ]
    benches = package.findall("%scontent/%sworkbench" % (SPACE, SPACE))
    if len(benches) != 1:
        faults.append("<content> must hold one <workbench>, got %d" % len(benches))
    for bench in benches:
        name = text_of(bench, "classname")
        if name not in [one.name for one in classes]:
            faults.append("<classname> must be the class of InitGui.py, got %r" % name)
        folder = root / (text_of(bench, "subdirectory") or text_of(bench, "name"))
        for path in (folder / text_of(bench, "icon"), root / text_of(package, "icon")):
            if not path.is_file() or path.suffix != ".svg":
                faults.append("the icon is no SVG that is there: %s" % path.name)
            elif path.stat().st_size > MOST_ICON:
                faults.append("the icon must have at most %d bytes, got %d" % (MOST_ICON, path.stat().st_size))
    return faults


def faults_of_other_files(root, package):
    """Return where another file says another version, date or least Python."""
    faults = []
    version, date = text_of(package, "version"), text_of(package, "date")
    cited = (root / "CITATION.cff").read_text("utf-8")
    for key, value in (("version", version), ("date-released", date)):
        if not re.search(r"^%s: %s$" % (key, re.escape(value)), cited, re.MULTILINE):
            faults.append("CITATION.cff must say %s: %s" % (key, value))
    headings = re.findall(r"^## (\S+) \(([^)]*)\)$", (root / "CHANGELOG.md").read_text("utf-8"), re.MULTILINE)
    if not headings or headings[0] not in ((version, date), (version, "unreleased")):
        faults.append("CHANGELOG.md must begin with ## %s (%s), or (unreleased)" % (version, date))
    target = "py" + text_of(package, "pythonmin").replace(".", "")
    if 'target-version = "%s"' % target not in (root / "pyproject.toml").read_text("utf-8"):
        faults.append("pyproject.toml must aim at the least Python of package.xml, %s" % target)
    return faults


def faults_of(root):
    """Return all that is wrong, as sentences."""
    try:
        package = ElementTree.parse(str(root / "package.xml")).getroot()
    except ElementTree.ParseError as error:
        return ["package.xml is no XML: %s" % error]
    checks = (faults_of_tags, faults_of_values, faults_of_content, faults_of_other_files)
    return [fault for check in checks for fault in check(root, package)]


def version_of(root):
    """Return the version: package.xml is where it stands."""
    return text_of(ElementTree.parse(str(root / "package.xml")).getroot(), "version")


def main():
    """Print the faults; return the exit code."""
    if sys.argv[1:] == ["version"]:
        print(version_of(ROOT))
        return 0
    faults = faults_of(ROOT)
    for fault in faults:
        print("package: " + fault)
    if not faults:
        print("package: version %s, nothing is wrong" % version_of(ROOT))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
