# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walks through the three doors in a real FreeCAD window, picturing each step (``make tour``, ``make tour-latest``).

The pictures go to build/tour/<version>. ``--docs`` (``make tour ARGS=--docs``) then writes docs/tutorial-*.md and
docs/pictures/tour-*.png from what is there: all steps on the oldest FreeCAD, one sheet a door for each newer one. Needs
Pillow for the last part. What is walked, and what the pages say, stands in ``tour_window.py`` and in the guide itself.
"""

import argparse
import json
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import gallery  # noqa: E402  the folder comes first
from gallery import tests  # noqa: E402

DOORS = ("rods", "measure", "voxels")
COLOURS, MOST_BYTES = 128, 100_000
SHEET = 3, (420, 263)  # pictures beside each other, pixels of each


def read_arguments():
    """Return the command line's choices."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", choices=DOORS, default=list(DOORS), help="doors (default: all)")
    parser.add_argument("--out", default="build/tour", help="folder of the pictures (default: %(default)s)")
    parser.add_argument("--docs", action="store_true", help="write the pages; walks only if no picture is there")
    return parser.parse_args()


def walk(doors, out):
    """Walk through doors in this FreeCAD; return those that failed."""
    out.mkdir(parents=True, exist_ok=True)
    facts = tests.freecad_facts(out)
    folder = out / facts["freecad"]
    folder.mkdir(exist_ok=True)
    print("FreeCAD %s" % facts["freecad"], flush=True)
    return [door for door in doors if not gallery.take("tour-" + door, folder, facts)]


def write_pages(out):
    """Write tutorials and pictures from all walks that are there; return the sum of the pictures' sizes, bytes."""
    from PIL import Image

    places = sorted((path for path in out.iterdir() if path.is_dir()), key=lambda path: version_of(path.name))
    pictures, total = ROOT / "docs" / "pictures", 0
    for door in DOORS:
        records = [(path, json.loads((path / f"tour-{door}.json").read_text(encoding="utf-8"))) for path in places]
        oldest, record = records[0]
        for step in record["steps"]:
            name = step["picture"] + ".png"
            total += save_small(Image.open(oldest / name), pictures / name)
        sheets = []
        for path, other in records[1:]:
            shots = [Image.open(path / (step["picture"] + ".png")) for step in other["steps"]]
            name = f"tour-{door}-{path.name}.png"
            total += save_small(sheet_of(shots, Image), pictures / name)
            sheets.append((path.name, name))
        (ROOT / "docs" / f"tutorial-{door}.md").write_text(page_of(record, oldest.name, sheets), encoding="utf-8")
    return total


def version_of(name):
    """Return the numbers of a version, to be sorted by."""
    return tuple(int(part) for part in name.split(".") if part.isdigit())


def save_small(image, path):
    """Save a picture with a palette; return its size, bytes, which must be small."""
    for colours in (COLOURS, COLOURS // 2, COLOURS // 4, COLOURS // 8):
        image.convert("RGB").quantize(colours, dither=0).save(path, optimize=True)
        if path.stat().st_size < MOST_BYTES:
            return path.stat().st_size
    sys.exit("%s is larger than %d bytes" % (path.name, MOST_BYTES))


def sheet_of(shots, module):
    """Return pictures side by side, one row below the other."""
    columns, size = SHEET
    rows = -(-len(shots) // columns)
    sheet = module.new("RGB", (columns * size[0], rows * size[1]), "white")
    for number, shot in enumerate(shots):
        place = number % columns * size[0], number // columns * size[1]
        sheet.paste(shot.convert("RGB").resize((size[0] - 8, size[1] - 8), module.LANCZOS), place)
    return sheet


def page_of(record, version, sheets):
    """Return the tutorial of one door."""
    lines = ["# Tutorial: " + record["title"], ""]
    lines += ["Walked and pictured by `make tour` with FreeCAD %s; written by `make tour ARGS=--docs`." % version, ""]
    for number, step in enumerate(record["steps"]):
        lines += ["## %s%s" % ("%d. " % number if number else "", step["title"]), ""]
        lines += [" ".join(filter(None, (step["text"], step["more"]))), ""]
        lines += ["![%s](pictures/%s.png)" % (step["title"], step["picture"]), ""]
    for name, sheet in sheets:
        lines += ["## The same with FreeCAD %s" % name, ""]
        lines += ["The steps in the order above, from left to right and downwards.", ""]
        lines += ["![All steps with FreeCAD %s](pictures/%s)" % (name, sheet), ""]
    lines += ["See also: [the commands](commands/README.md), [glossary](glossary.md)", ""]
    return "\n".join(lines)


def main():
    """Walk, or write the pages; return the exit code."""
    choices = read_arguments()
    out = (ROOT / choices.out).resolve()
    if choices.docs and any(out.glob("*/tour-voxels.json")):
        print("%d bytes of pictures" % write_pages(out))
        return 0
    failed = walk(choices.only, out)
    if choices.docs and not failed:
        print("%d bytes of pictures" % write_pages(out))
    return 1 if failed else 0


if __name__ == "__main__":
    os.chdir(str(ROOT))
    sys.exit(main())
