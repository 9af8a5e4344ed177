# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis' chapter 5 beside ours: tables 5.1, 5.2 and 5.5 to 5.13, written to docs/validation-slices.md.

Our cases 5 and 6, the femur study and real bone, sliced as the thesis sliced its samples (planes at the layers'
bottoms, 0.1 mm, the anatomical study 0.2 mm). The networks are united and cut at the envelope, as the thesis' were. The
bone is looked for in the folder TRABECULA_DATA (default: ../shared/data). ``--page FILE`` writes elsewhere.
"""

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

import under_freecad

ROOT = Path(__file__).resolve().parent.parent
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))
BONE = "trab_ior_10mm_13MB.stl"
AXES = ("x", "y", "z")

#: Tables 5.1 to 5.10 by sample and row, values for X, Y, Z; the box and the file's size stand alone.
THESIS = {
    "bone": {
        "box": "10.356 x 9.45 x 10.4 mm", "file": "13.5 MB, binary",
        "slicing": (27, 30, 25), "ssl": (4.44, 2.14, 6.79), "analysis": (1323, 1468, 1266),
        "rods": (504, 457, 278), "plates": (684, 820, 850),
        "trabecular": ("-1.967 to 17.56", "-11.99 to 27.38", "-2.07 to 14.53"),
        "porosity": ("74.92 to 89.9", "77.41 to 85.47", "77.12 to 87.8"),
        "sliced": ("10.1 to 25.08", "14.53 to 22.59", "12.2 to 22.88"),
    },
    "humerus": {
        "rods": (2428, 2653, 1406), "plates": (4859, 5038, 6956),
        "trabecular": ("-6.24 to 55.25", "-3.37 to 56.987", "-5.55 to 46.7"),
        "sliced": ("0.069 to 81.837", "0.09 to 74.31", "0.0125 to 61.765"),
    },
    "case5": {
        "box": "10 x 10 x 10 mm", "file": "13.6 MB, ASCII",
        "slicing": (46, 43, 52), "ssl": (4.64, 4.3, 4.8), "analysis": (2002, 1965, 1866),
        "rods": (1739, 1830, 1818), "plates": (1782, 1765, 1773),
        "trabecular": ("0.00018 to 56.96", "0.00011 to 62.58", "0.0002 to 56.12"),
        "porosity": ("39.41 to 79.11", "35.1 to 79.28", "40.26 to 79.6"),
        "sliced": ("20.81 to 60.589", "20.71 to 64.89", "20.407 to 59.74"),
    },
    "case6": {
        "box": "10 x 10 x 10 mm", "file": "24 MB, ASCII",
        "slicing": (50, 57, 53), "ssl": (4.45, 4.91, 4.7), "analysis": (2285, 2066, 2178),
        "rods": (1733, 1686, 1913), "plates": (1851, 1737, 1900),
        "trabecular": ("0.00047 to 54.917", "0.0003 to 59.77", "0.0001 to 57.78"),
        "porosity": ("38.18 to 81.51", "34.297 to 82.937", "36.75 to 81.29"),
        "sliced": ("18.49 to 61.818", "17.06 to 65.7", "18.705 to 63.245"),
    },
    "femur": {
        "box": "20.929 x 16.476 x 23.038 mm", "file": "87.8 MB, ASCII",
        "slicing": (107, 99, 170), "ssl": (8.5, 8.2, 10.9), "analysis": (3798, 3909, 4541),
        "rods": (3683, 2934, 4680), "plates": (2107, 2075, 2216),
        "trabecular": ("-10.175 to 53.884", "-6.93 to 55.79", "-2.335 to 40.095"),
        "sliced": ("0.182 to 65.095", "0.2165 to 73.295", "0.028 to 46.346"),
    },
}  # fmt: skip
#: Section 5.4: sections with the same sliced area and the same number of trabeculae; sliced area in the middle, design
#: less bone; the same of the largest contour. mm².
COMPARED = {
    "case5": {"area": (10, 4, 4), "count": (7, 7, 6), "middle": (43, 50, 44.5), "largest": (45, 55, 50)},
    "case6": {"area": (3, 3, 3), "count": (4, 4, 0), "middle": (38, 46, 48), "largest": (33, 40, 49)},
}
TITLES = {"bone": "cubic bone sample", "case5": "cubic case 5", "case6": "cubic case 6", "femur": "anatomical study"}
NOTES = """The thesis' own files were never published. **The bone is another sample of the same kind** (human trabecular
bone of the same laboratory and pixel size, 3.9 mm mirrored to the thesis' box), so that its areas are of the same
order, not the same, and its contours many more (77 a slice along X, the thesis' sample has 11); since it is mirrored,
its slices are not independent. The anatomical study is a femur's metaphysis, the thesis' a mouse's humerus: layer and
design rules are alike, not the shape, and there is no real bone to hold it against (table 5.13 has two columns of the
thesis' and one of ours for each axis). Designs are those of one seed.

Totals count every contour once a slice, voids included, and call plates what is no rod, as the thesis' columns do; the
thesis gives no least area, ours is 1e-6 mm2. Our seconds are CPU seconds of one core; the slicing time includes finding
each triangle's neighbours, the analysis time is that of all measures of all contours."""


def design_mesh(name):
    """Return the united rods of a preset inside its envelope: the network that the thesis slices."""
    from freecad_trabecula.core.booleans import combine, unite
    from freecad_trabecula.core.meshes import printable
    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.core.rods import rod_mesh
    from freecad_trabecula.core.wireframe import skin
    from freecad_trabecula.geometry.design import make_design

    job = preset(name)
    design = make_design(job)
    rods = unite(*rod_mesh(skin(design.wireframe, job.rods), 0.25 * job.pores.size.high))
    return printable(combine([rods, design.envelope.mesh], "intersection"))


def analysed(path, thickness, folder):
    """Return our analysis of an STL file, with the seconds and sizes of tables 5.1, 5.5, 5.7, 5.9."""
    from freecad_trabecula.core.analysis.analysis import analyse, contours_of
    from freecad_trabecula.core.analysis.contours import contour_measures
    from freecad_trabecula.core.analysis.parameters import SliceParameters
    from freecad_trabecula.core.analysis.ssl import write_ssl
    from freecad_trabecula.core.analysis.triangles import read_soup

    parameters = SliceParameters(thickness=thickness, at="bottom")
    soup = read_soup(path, "mm")
    slicing, measuring, sizes = [], [], []
    for axis in AXES:
        start = time.process_time()
        contours = contours_of(soup, parameters, axis)[0]
        middle = time.process_time()
        contour_measures(contours, parameters)
        slicing.append(middle - start)
        measuring.append(time.process_time() - middle)
        write_ssl(folder / f"{axis}.ssl", contours, thickness)
        sizes.append((folder / f"{axis}.ssl").stat().st_size / 1e6)
    found = analyse(soup, parameters, morphometry=False)
    box = " x ".join(f"{edge:.5g}" for edge in found.box[1] - found.box[0])
    return found, {"box": f"{box} mm", "file": f"{path.stat().st_size / 1e6:.1f} MB, binary",
                   "slicing": slicing, "ssl": sizes, "analysis": measuring}  # fmt: skip


def table(head, rows):
    """Return a markdown table."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows])


def side_by_side(words, thesis, ours):
    """Return a row: the thesis' and our value for each axis in turn."""
    return [words, *(cell for pair in zip(thesis, ours) for cell in pair)]


HEAD = ["", *(f"{axis.upper()} {whose}" for axis in AXES for whose in ("thesis", "ours"))]


def slicing_tables(name, analysis, facts, number):
    """Return two tables of one sample: slicing data, and main data of the analysis."""
    from freecad_trabecula.core.analysis.comparison import range_text, totals_of

    thesis, title = THESIS[name], TITLES[name]
    chosen = analysis.parameters
    first = [
        ("Boundary box", thesis["box"], facts["box"]),
        ("STL file size", thesis["file"], facts["file"]),
        ("Gap fill, maximum and iterations", "0.01 mm, 5", f"{chosen.gap:g} mm, {chosen.iterations}"),
        ("Contour filter, open and closed", "0, 0 mm", f"{chosen.filter_open:g}, {chosen.filter_closed:g} mm"),
        ("Smoothing", "off", chosen.smoothing),
        ("Layer thickness", "0.2 mm" if name == "femur" else "0.1 mm", f"{chosen.thickness:g} mm"),
        ("Tool compensation", "0 mm", f"{chosen.compensation:g} mm"),
        *((f"Slicing time, {axis.upper()}", f"{thesis['slicing'][k]} s", f"{facts['slicing'][k]:.2f} s")
          for k, axis in enumerate(AXES)),
        *((f"SSL file size, {axis.upper()}", f"{thesis['ssl'][k]} MB", f"{facts['ssl'][k]:.2f} MB")
          for k, axis in enumerate(AXES)),
    ]  # fmt: skip
    totals = [totals_of(analysis, axis) for axis in AXES]
    second = [
        side_by_side("Analysis time (s)", thesis["analysis"], [f"{s:.2f}" for s in facts["analysis"]]),
        side_by_side("Total number of rods", thesis["rods"], [t.rods for t in totals]),
        side_by_side("Total number of plates", thesis["plates"], [t.plates for t in totals]),
        side_by_side("Trabecular area range (mm2)", thesis["trabecular"],
                     [range_text(t.trabecular_area) for t in totals]),
    ]  # fmt: skip
    if "porosity" in thesis:
        porosity = [range_text(tuple(100 * p for p in t.porosity)) for t in totals]
        second.append(side_by_side("Porosity range (%)", thesis["porosity"], porosity))
    second.append(side_by_side("Sliced area (mm2)", thesis["sliced"], [range_text(t.sliced_area) for t in totals]))
    return f"""## Tables {number}: {title}

{table(("", "thesis", "ours"), first)}

{table(HEAD, second)}
"""


def compared(name, bone, design, number):
    """Return table 5.11 or 5.12: the design and the bone, thesis' and ours, and what section 5.4 says of the two."""
    from freecad_trabecula.core.analysis.comparison import compare
    from freecad_trabecula.core.analysis.passport import passport

    comparison = compare([bone, design])
    ours = comparison.table()[1]
    rows = []
    for row, key in zip(ours, ("rods", "plates", "trabecular", "sliced")):
        thesis = [THESIS[sample][key][k] for k in range(3) for sample in ("bone", name)]
        rows += [(row[0] + ", thesis", *thesis), (row[0] + ", ours", *row[1:])]
    head = ("", *(f"{axis.upper()} {which}" for axis in AXES for which in ("bone", TITLES[name])))
    said, shared = COMPARED[name], [comparison.axes[axis] for axis in AXES]
    areas, counts, largest = (
        [axis.difference(quantity) for axis in shared] for quantity in ("sliced_area", "contours", "largest_area")
    )
    text = [
        side_by_side("Sections with the same sliced area", said["area"], [d.meetings for d in areas]),
        side_by_side("Sections with as many trabeculae", said["count"], [d.meetings for d in counts]),
        side_by_side("Sliced area in the middle, design less bone (mm2)", said["middle"],
                     [f"{d.middle:.1f}" for d in areas]),
        side_by_side("Largest contour in the middle, design less bone (mm2)", said["largest"],
                     [f"{d.middle:.1f}" for d in largest]),
    ]  # fmt: skip
    scores = passport(bone, design)
    whole = [(s.of, s.symbol, f"{s.value:.3g}") for s in scores.whole]
    return f"""## Table {number}: {TITLES[name]} and cubic bone sample

{table(head, rows)}

{table(HEAD, text)}

Sections are the same where the curves meet. {" ".join(comparison.notes)}

{table(("passport, whole", "score", "value"), whole)}
"""


def femur_table(femur):
    """Return table 5.13: the thesis' bone and design, and our design."""
    from freecad_trabecula.core.analysis.comparison import range_text, totals_of

    totals = [totals_of(femur, axis) for axis in AXES]
    ours = {
        "rods": [t.rods for t in totals], "plates": [t.plates for t in totals],
        "trabecular": [range_text(t.trabecular_area) for t in totals],
        "sliced": [range_text(t.sliced_area) for t in totals],
    }  # fmt: skip
    words = {"rods": "Total number of rods", "plates": "Total number of plates",
             "trabecular": "Trabecular area range (mm2)", "sliced": "Sliced area (mm2)"}  # fmt: skip
    rows = [
        (words[key], *(of[key][k] for k in range(3) for of in (THESIS["humerus"], THESIS["femur"], ours)))
        for key in words
    ]
    head = ("", *(f"{a.upper()} {which}" for a in AXES for which in ("thesis' bone", "thesis' design", "our design")))
    return f"## Table 5.13: anatomical study and the thesis' mouse humerus\n\n{table(head, rows)}\n"


def main(arguments):
    """Write and print the page; runs inside FreeCAD."""
    from freecad_trabecula.core.stl import write_stl

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--page", default=str(ROOT / "docs" / "validation-slices.md"))
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        paths = {"bone": DATA / BONE}
        if not paths["bone"].exists():
            print(f"{paths['bone']} is not there: name its folder in TRABECULA_DATA")
            return 1
        for name in ("case5", "case6", "femur"):
            paths[name] = folder / f"{name}.stl"
            write_stl(paths[name], design_mesh(name))
        made = {name: analysed(path, 0.2 if name == "femur" else 0.1, folder) for name, path in paths.items()}
    numbers = {"bone": "5.1 and 5.2", "case5": "5.5 and 5.6", "case6": "5.7 and 5.8", "femur": "5.9 and 5.10"}
    found = {name: analysis for name, (analysis, _) in made.items()}
    parts = [slicing_tables(name, *made[name], numbers[name]) for name in numbers]
    parts += [compared("case5", found["bone"], found["case5"], "5.11")]
    parts += [compared("case6", found["bone"], found["case6"], "5.12"), femur_table(found["femur"])]
    command = "python3 tools/thesis_chapter5.py"
    page = f"# The thesis' chapter 5 beside ours\n\nMade by `{command}`.\n\n{NOTES}\n\n" + "\n".join(parts)
    Path(options.page).write_text(page, encoding="utf-8")
    print(page)
    print(f"written to {options.page}")
    return 0


if __name__ == "__main__":
    sys.exit(under_freecad.run(__file__))
