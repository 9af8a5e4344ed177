# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis' tables beside ours (``make validate``): docs/validation.md, then the pages of slices and of voxels.

Chapter 3: ten seeds a case, union and plain sum of the rods against the thesis' porosity; case 1 against crossing
cylinders in closed form; time a rod. Chapter 4: tables 4.1 to 4.6 of both studies. Without words docs/validation.md is
written, then docs/validation-slices.md by ``thesis_chapter5.py`` and docs/validation-voxels.md by ``voxel_bones.py``.
``--seeds N`` takes fewer seeds; that page is left in build/validate, or where ``--page FILE`` says, and the others are
not made.
"""

import argparse
import subprocess
import sys
import time
from pathlib import Path

import under_freecad

ROOT = Path(__file__).resolve().parent.parent
CASES = ("case1", "case2", "case3", "case4", "case5", "case6")
WITHIN = 1.5  # standard deviations of ten seeds, in which cases 3 to 6 are to meet the thesis
CASE_2 = """Case 2's 55.27 % is not met. Its rods are those of case 3, orthogonal instead of paired at random, and half
as many (75 against 147), for which the thesis gives 44.49 %: no reading of the pores that leaves cases 3 to 6 near
gives case 2 more than about 32 % (the plain sum). We report what is computed."""
CASE_1 = """The thesis' 16.66 % is the plain sum of the channels' volumes; it is expected to be 75 x pi/4 x 0.28 mm2 x
10 mm / 1000 mm3."""


def mean_and_sd(values):
    """Return the mean and the sample standard deviation (0 for one value)."""
    mean = sum(values) / len(values)
    spread = sum((v - mean) ** 2 for v in values) / max(len(values) - 1, 1)
    return mean, spread**0.5


def table(head, rows):
    """Return a markdown table."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows])


def case_figures(name, seeds):
    """Return union and sum (%), seconds of CPU a rod, recoveries and failures of one case over seeds."""
    from freecad_trabecula.core.booleans import exact_union_volume
    from freecad_trabecula.core.job import with_seed
    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.core.rods import rod_mesh, rod_volumes
    from freecad_trabecula.core.wireframe import skin
    from freecad_trabecula.geometry.design import make_design
    from freecad_trabecula.geometry.rod_solids import rod_solids

    found = {"name": name, "union": [], "sum": [], "closed": [], "seconds": 0.0, "rods": 0, "mended": 0, "failed": 0}
    for seed in seeds:
        job = with_seed(preset(name), seed)
        start = time.process_time()
        design = make_design(job)
        envelope, made = design.envelope, design.wireframe
        rods = skin(made, job.rods)
        if seed == seeds[0]:
            list(rod_solids(made, job.rods))
            found["seconds"] = (time.process_time() - start) / len(made)
        whole = job.prism.l * job.prism.w * job.prism.h
        found["union"].append(100 * exact_union_volume(*rod_mesh(rods, 0.1), inside=envelope.mesh) / whole)
        found["sum"].append(100 * rod_volumes(rods).sum() / whole)
        if name == "case1":
            found["closed"].append(100 * closed_form(made)[1] / whole)
        found["rods"] += len(made)
        found["mended"] += len(made.recoveries)
        found["failed"] += len(made.failed)
    return found


def closed_form(wireframe):
    """Return sum and union, mm3, of case 1's channels as crossing cylinders."""
    import closed_forms

    sizes = [wireframe.pores[face].size.reshape(5, 5) for face in ("Face1", "Face3", "Face5")]
    return closed_forms.case1_volumes(sizes[0], sizes[1].T, sizes[2])


def chapter_3(seeds):
    """Return the section on the six cases, and whether it is as it must be."""
    import closed_forms

    from freecad_trabecula.core.presets import THESIS

    rows, good, figures = [], True, {}
    for name in CASES:
        f = figures[name] = case_figures(name, seeds)
        thesis = THESIS[name]
        (union, union_sd), (total, total_sd) = mean_and_sd(f["union"]), mean_and_sd(f["sum"])
        ours, sd = (total, total_sd) if name == "case1" else (union, union_sd)
        off = (ours - thesis.porosity) / sd if sd else float("nan")
        if name != "case2":
            good &= f["failed"] == 0 and (len(seeds) < 10 or abs(off) <= WITHIN)
        rows.append((name, f["rods"] // len(seeds), f"{union:.2f} ({union_sd:.2f})", f"{total:.2f} ({total_sd:.2f})",
                     f"{thesis.porosity:.2f}", f"{off:+.1f} sd{' of the sum' if name == 'case1' else ''}", f["mended"],
                     f["failed"],
                     f"{1000 * f['seconds']:.0f} ms", f"{thesis.seconds_per_rod:g} s"))  # fmt: skip
    head = ("case", "rods", "union % (sd)", "plain sum % (sd)", "thesis %", "ours less thesis", "rods mended", "failed",
            "CPU a rod", "thesis a rod")  # fmt: skip
    expected = [v / 10 for v in closed_forms.expected_case1_volumes()]
    apart = max(abs(a / b - 1) for a, b in zip(figures["case1"]["union"], figures["case1"]["closed"]))
    good &= apart < 1e-3
    text = f"""## Chapter 3: six cubes

Seeds {seeds[0]} to {seeds[-1]}. "CPU a rod" is all that makes the network: sites, couplings, paths, recovery, solids,
their volumes checked.

{table(head, rows)}

Case 1: {CASE_1} Expectation of the sum {expected[0]:.2f} %, of the union {expected[1]:.2f} % (crossing cylinders,
inclusion and exclusion, by quadrature). Seed by seed the mesh's union and the cylinders' differ by {apart:.1e} at most.

Case 2: {CASE_2}
"""
    return text, good


def study(name, title):
    """Return the section on one anatomical study, and whether all its rods were made."""
    from freecad_trabecula.core.booleans import exact_union_volume
    from freecad_trabecula.core.presets import THESIS, preset
    from freecad_trabecula.core.rods import rod_mesh, rod_volumes
    from freecad_trabecula.core.wireframe import skin
    from freecad_trabecula.geometry.design import make_design
    from freecad_trabecula.geometry.rod_solids import rod_solids

    job = preset(name)
    start = time.process_time()
    design = make_design(job)
    envelope, made = design.envelope, design.wireframe
    located = time.process_time() - start
    rods = skin(made, job.rods)
    list(rod_solids(made, job.rods))
    seconds = time.process_time() - start
    inside = exact_union_volume(*rod_mesh(rods, 0.25 * job.pores.size.high), inside=envelope.mesh)
    thesis = THESIS[name]
    faces = [(f.label, f.face, f.c_u, f.c_v, f.b_u, f.b_v, len(made.sites[f.label])) for f in job.faces]
    rows = [
        (r.first, r.second, r.available_first, r.available_second, r.rods, r.left_first, r.left_second)
        for r in made.rows
    ]
    remedies = sorted({(r.fault, r.remedy) for r in made.recoveries})
    counts = ", ".join(
        f"{f} by {m}: {sum((r.fault, r.remedy) == (f, m) for r in made.recoveries)}" for f, m in remedies
    )
    outputs = [
        ("rods", len(made), thesis.rods),
        ("porosity %", f"{100 * inside / envelope.volume:.2f}", thesis.porosity),
        ("plain sum of the rods %", f"{100 * rod_volumes(rods).sum() / envelope.volume:.2f}", "-"),
        ("pore locations, s", f"{located:.1f}", "240" if name == "cranial" else "539"),
        ("rod network, s", f"{seconds:.1f}", f"{thesis.seconds:g}"),
        ("a rod, s", f"{seconds / len(made):.3f}", f"{thesis.seconds_per_rod:g}"),
        ("by hand, s a rod (thesis' estimate)", thesis.manual_seconds_per_rod, thesis.manual_seconds_per_rod),
        ("rods mended", f"{len(made.recoveries)} ({counts or 'none'})", "not given"),
        ("rods failed", len(made.failed), "-"),
        ("rods that leave the envelope", f"{len(made.outside)} {' '.join(made.outside[:6])}", "not looked for"),
    ]
    text = f"""## {title}

{table(("face", "of the solid", "c_u", "c_v", "b_u", "b_v", "sites"), faces)}

{table(("face 1", "face 2", "available 1", "available 2", "rods", "left 1", "left 2"), rows)}

{table(("output", "ours (CPU)", "thesis"), outputs)}
"""
    return text, not made.failed and len(made) > 0


def prism():
    """Return the section on the prism of 420 rods."""
    f = case_figures("prism420", [1])
    total = f["seconds"] * f["rods"]
    return f"""## Section 3.4: the prism of 420 rods

{f["rods"]} rods, {f["failed"]} failed, {total:.1f} s of CPU for the network (thesis 900 s); union
{f["union"][0]:.2f} %.
""", f["failed"] == 0 and f["rods"] == 420  # fmt: skip


def main(arguments):
    """Write and print the page; runs inside FreeCAD."""
    import FreeCAD

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--page", default=None)
    options = parser.parse_args(arguments)
    version = ".".join(FreeCAD.Version()[:3])
    parts = [
        chapter_3(list(range(1, options.seeds + 1))),
        prism(),
        study("cranial", "Section 4.3.1: the craniofacial plate (tables 4.1 to 4.3)"),
        study("femur", "Section 4.3.2: the metaphysis (tables 4.4 to 4.6)"),
    ]
    page = f"# The thesis' figures beside ours\n\nMade by `make validate` on FreeCAD {version}.\n\n" + "\n".join(
        p for p, _ in parts
    )
    elsewhere = ROOT / "build" / "validate" / f"{version}.md" if arguments else ROOT / "docs" / "validation.md"
    path = Path(options.page or elsewhere)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page, encoding="utf-8")
    print(page)
    print(f"written to {path}")
    good = all(ok for _, ok in parts)
    print("all within the bounds stated" if good else "OUT OF BOUNDS: see the page")
    return 0 if good else 1


def run_all():
    """Write every page of validation; return the sum of the exit codes."""
    code = under_freecad.run(__file__)
    if sys.argv[1:]:
        return code
    others = ("thesis_chapter5.py", "voxel_bones.py")
    return code + sum(subprocess.call([sys.executable, str(ROOT / "tools" / name)]) for name in others)


if __name__ == "__main__":
    sys.exit(min(run_all(), 1))
