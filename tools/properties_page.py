# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the properties of all objects, made from the code, put into docs/documents.md between its two marks.

Run it:  python3 tools/properties_page.py          (--check: only say whether the page is as the code is)
"""

import sys
from pathlib import Path

import under_freecad

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "documents.md"
MARKS = ("<!-- properties: made by tools/properties_page.py -->", "<!-- end of properties -->")
#: In the order in which a design uses them: class, FreeCAD's type.
OBJECTS = (
    ("prism_sites", "PrismSites", "Part::FeaturePython"),
    ("face_sites", "FaceSites", "Part::FeaturePython"),
    ("wireframe", "Wireframe", "Part::FeaturePython"),
    ("network", "Network", "Part::FeaturePython"),
    ("scaffold", "Scaffold", "Mesh::FeaturePython"),
    ("scaffold", "Body", "Mesh::FeaturePython"),
    ("solid_scaffold", "SolidScaffold", "Part::FeaturePython"),
    ("analysis", "Analysis", "App::FeaturePython"),
    ("voxel_design", "VoxelDesign", "Mesh::FeaturePython"),
)


def rows_of(document, module, name, kind):
    """Return heading and rows of one class."""
    import importlib

    cls = getattr(importlib.import_module(f"freecad_trabecula.features.{module}"), name)
    obj = document.addObject(kind, name)
    before = set(obj.PropertiesList)
    cls(obj)
    rows = []
    for one in sorted(set(obj.PropertiesList) - before, key=lambda one: (_order(obj, one), one)):
        modes = obj.getEditorMode(one)
        told = "hidden" if "Hidden" in modes else "result" if "ReadOnly" in modes else ""
        kind_text = obj.getTypeIdOfProperty(one).replace("App::Property", "")
        doc = obj.getDocumentationOfProperty(one).replace("|", "\\|")
        rows.append(f"| `{one}` | {kind_text} | {obj.getGroupOfProperty(one)} | {told} | {doc} |")
    return f"### {name}: `{cls.Type}`, {kind}", cls.__doc__.strip().splitlines()[0], rows


def _order(obj, name):
    group = obj.getGroupOfProperty(name)
    return ("Hidden" in obj.getEditorMode(name), group == "Results", group != "Base", group)


def text():
    """Return the tables."""
    import FreeCAD

    document = FreeCAD.newDocument("Properties")
    parts = []
    for module, name, kind in OBJECTS:
        heading, doc, rows = rows_of(document, module, name, kind)
        head = ["| property | type | group | | what |", "|---|---|---|---|---|"]
        parts.append("\n".join([heading, "", doc, "", *head, *rows]))
    return "\n\n".join(parts)


def main(arguments):
    """Write the tables, or look whether they are as the code is; inside FreeCAD."""
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    new = f"{before}{MARKS[0]}\n\n{text()}\n\n{MARKS[1]}{after}"
    if "--check" in arguments:
        if new != page:
            print("docs/documents.md: run tools/properties_page.py")
        return int(new != page)
    PAGE.write_text(new, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(under_freecad.run(__file__))
