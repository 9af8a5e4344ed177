# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tb.Th, Tb.Sp, DA and Conn.D of two bones, by Trabecula and by another route, in a table.

    python3 tools/morphometry_check.py                       ours alone, and our own second routes
    python3 tools/morphometry_check.py --rival PYTHON        the other programs too: a Python with porespy

Thickness and spacing are held against porespy (local_thickness), the Euler number against scikit-image (a part of
porespy), both given our voxels, thickness also with our radii rounded down to porespy's 25. Where
bone-microarchitecture is there, its thickness too: as it comes, and without the two rules that are its own (a voxel
less in diameter, no ball that reaches out of the image): ``python3 -m venv V; V/bin/pip
install porespy; V/bin/pip install --no-deps bone-microarchitecture; --rival V/bin/python``. The degree of anisotropy
by lines is held against the one that the
triangles' normals give, the connectivity against the mesh's own Euler number. The bones are looked for in the folder
TRABECULA_DATA (default: ../shared/data). Each piece runs in a process of its own on one thread: CPU seconds and peak
memory are those of the work alone. ``--page FILE`` writes the table too.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import generated_page

ROOT = Path(__file__).resolve().parent.parent
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))
BONES = ("shrew_cube_10mm.stl", "trab_ior_3p86mm_12MB.stl")
WITHIN = 0.10


def ours(path, voxels_path):
    """Return our measures, and CPU seconds of each of their four parts; leave the voxels for the others."""
    import numpy as np

    from freecad_trabecula.core.analysis.anisotropy import fabric_of_triangles, fabric_of_voxels
    from freecad_trabecula.core.analysis.connectivity import connectivity
    from freecad_trabecula.core.analysis.morphometry import uncut
    from freecad_trabecula.core.analysis.thickness import local_thickness, size_distribution
    from freecad_trabecula.core.analysis.triangles import read_soup
    from freecad_trabecula.core.analysis.voxelise import default_size, voxelise
    from freecad_trabecula.core.meshes import weld

    soup = read_soup(path)
    found, seconds = {}, {}

    def clock(name, work):
        start = time.process_time()
        result = work()
        seconds[name] = time.process_time() - start
        return result

    size = default_size(*soup.box)
    voxels = clock("voxels", lambda: voxelise(soup.triangles, size, soup.box))
    np.save(voxels_path, voxels.solid)
    for symbol, inside in (("Tb.Th", voxels.solid), ("Tb.Sp", ~voxels.solid)):
        local = clock(symbol, lambda: local_thickness(inside, size))  # noqa: B023
        found[symbol] = size_distribution(local, size).mean
        found[symbol + ", 25 radii"] = 2 * size * rounded_down(local[inside] / (2 * size)).mean()
    topology = clock("Conn.D", lambda: connectivity(voxels.solid))
    volume = voxels.volume
    found.update({"Euler": topology.euler, "Conn.D": topology.connections / volume})
    found["DA"] = clock("DA", lambda: fabric_of_voxels(voxels)).anisotropy
    found["DA.mesh"] = fabric_of_triangles(uncut(soup.triangles, soup.box), volume).anisotropy
    mesh = weld(soup.triangles)
    # a closed surface has twice the Euler number of the body in it
    euler = len(mesh.vertices) - len(mesh.triangles) * 3 // 2 + len(mesh.triangles)
    found["Euler.mesh"] = euler // 2
    found["Conn.D.mesh"] = (topology.connections + topology.euler - euler // 2) / volume
    return {"size": size, "shape": voxels.solid.shape[::-1], "found": found, "seconds": seconds}


def rounded_down(radii):
    """Return radii in voxels as porespy has them: the next smaller one of 25 from 1 to the largest, evenly in log."""
    import numpy as np

    steps = np.logspace(0, np.log10(radii.max()), 25)
    return steps[(np.searchsorted(steps, radii * (1 + 1e-6), side="right") - 1).clip(0)]


def rival(size, voxels_path):
    """Return the other programs' measures of the same voxels; runs in their own Python."""
    import numpy as np
    import porespy
    import skimage

    solid = np.load(voxels_path)
    found, seconds = {}, {}
    for symbol, inside in (("Tb.Th", solid), ("Tb.Sp", ~solid)):
        start = time.process_time()
        radii = porespy.filters.local_thickness(inside, method="legacy")
        seconds[symbol] = time.process_time() - start
        found[symbol] = 2 * float(radii[inside].mean()) * size
    for symbol, inside in (("Tb.Th", solid), ("Tb.Sp", ~solid)):
        for words, has_rules in ((", its rules", True), (", no rules", False)):
            start = time.process_time()
            found[symbol + words] = microarchitecture(inside, size, has_rules)
            seconds[symbol + words] = time.process_time() - start
    start = time.process_time()
    found["Euler"] = int(skimage.measure.euler_number(solid, connectivity=3))
    seconds["Conn.D"] = time.process_time() - start
    names = f"porespy {porespy.__version__}, scikit-image {skimage.__version__}"
    return {"found": found, "seconds": seconds, "names": names}


def microarchitecture(inside, size, has_rules):
    """Return bone-microarchitecture's mean thickness, mm, with or without its two rules; None without it."""
    import importlib.util

    import numpy as np
    from scipy import ndimage

    package = importlib.util.find_spec("bone_microarchitecture")
    if package is None:
        return None
    # only this file: the package as a whole imports what measuring does not need
    path = Path(package.submodule_search_locations[0]) / "thickness.py"
    spec = importlib.util.spec_from_file_location("thickness_of_bone_microarchitecture", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    if not has_rules:

        def every_ball(distance, axis, _spacing):
            z, y, x = np.nonzero(axis)
            radius = distance[axis]
            order = np.argsort(radius)[::-1]
            return z[order], y[order], x[order], radius[order]

        module._sphere_centers = every_ball
        module._phase_distance = lambda binary, spacing: ndimage.distance_transform_edt(binary, sampling=spacing)
    found = module.hildebrand_thickness_map(inside, (size,) * 3, backend="cpu",
                                            diameter_margin_voxels=0.5 if has_rules else 0.0)  # fmt: skip
    return float(found[found > 0].mean())


def in_a_process(python, *arguments):
    """Run one piece in a process of its own and return what it printed as JSON."""
    environment = dict(os.environ, PYTHONPATH=str(ROOT), OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1",
                       NUMBA_NUM_THREADS="1", TQDM_DISABLE="1")  # fmt: skip
    command = [str(python), str(Path(__file__).resolve()), *map(str, arguments)]
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout.decode().splitlines()[-1])


def piece(arguments):
    """Run one piece and print its results, with the peak memory of this process in MB, as JSON."""
    if arguments[0] == "ours":
        result = ours(*arguments[1:])
    else:
        result = rival(float(arguments[1]), arguments[2])
    result["memory"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3
    print(json.dumps(result, default=float))


def rows_of(name, mine, other):
    """Return the rows of one bone, and whether all that is compared lies within 10 %."""
    found, good, rows = mine["found"], True, []
    theirs = {} if other is None else other["found"]
    seconds = {} if other is None else other["seconds"]
    sources = {
        "Tb.Th": ("mm", theirs.get("Tb.Th"), "porespy, spheres of 25 radii"),
        "Tb.Th, 25 radii": ("mm", theirs.get("Tb.Th"), "the same"),
        "Tb.Th, no rules": ("mm", theirs.get("Tb.Th, no rules"), "bone-microarchitecture, all balls, no margin"),
        "Tb.Th, its rules": ("mm", theirs.get("Tb.Th, its rules"), "the same as it comes"),
        "Tb.Sp": ("mm", theirs.get("Tb.Sp"), "porespy, spheres of 25 radii"),
        "Tb.Sp, 25 radii": ("mm", theirs.get("Tb.Sp"), "the same"),
        "Tb.Sp, no rules": ("mm", theirs.get("Tb.Sp, no rules"), "bone-microarchitecture, all balls, no margin"),
        "Tb.Sp, its rules": ("mm", theirs.get("Tb.Sp, its rules"), "the same as it comes"),
        "DA": ("1", found["DA.mesh"], "normals of the triangles"),
        "Conn.D": ("1/mm3", found["Conn.D.mesh"], "Euler number of the mesh"),
        "Euler": ("1", theirs.get("Euler"), "scikit-image"),
    }
    for symbol, (unit, value, source) in sources.items():
        plain, _, rules = symbol.partition(", ")
        if rules.endswith("rules"):
            if value is None:
                continue
            found[symbol] = found[plain]
        apart = None if value is None else found[symbol] / value - 1
        good &= apart is None or abs(apart) <= WITHIN or rules == "its rules"  # its own definition: shown, not judged
        mine_seconds = mine["seconds"].get(symbol)
        rows.append((
            name, symbol, unit, f"{found[symbol]:.4g}", "-" if value is None else f"{value:.4g}", source,
            "-" if apart is None else f"{100 * apart:+.1f} %",
            "-" if mine_seconds is None else f"{mine_seconds:.1f} s",
            f"{seconds[symbol]:.1f} s" if symbol in seconds else "-",
        ))  # fmt: skip
    return rows, good


def main(arguments):
    """Print the table; exit code 1 if a difference is above 10 %."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rival", help="a Python that has porespy")
    parser.add_argument("--page", help="a file for the table; else, with a rival, its part of docs/analysis.md")
    options = parser.parse_args(arguments)
    rows, good, lines = [], True, []
    for name in BONES:
        path = DATA / name
        if not path.exists():
            lines.append(f"{path} is not there: {name} was left out.")
            continue
        with tempfile.TemporaryDirectory() as folder:
            voxels_path = Path(folder) / "voxels.npy"
            mine = in_a_process(sys.executable, "--piece", "ours", path, voxels_path)
            other = options.rival and in_a_process(options.rival, "--piece", "rival", mine["size"], voxels_path)
        more, fine = rows_of(path.stem, mine, other or None)
        rows, good = rows + more, good and fine
        memory = f"{mine['memory']:.0f} MB" + (f", {other['memory']:.0f} MB with {other['names']}" if other else "")
        lines.append(f"{path.stem}: {mine['shape']} voxels of {mine['size']:.5f} mm; peak memory {memory}.")
    head = ("bone", "measure", "unit", "ours", "other route", "by", "difference", "our CPU", "its CPU")
    text = "\n".join(["| " + " | ".join(row) + " |" for row in (head, ["---"] * len(head), *rows)])
    verdict = f"But for the other program's own rules: {'' if good else 'NOT '}all within {100 * WITHIN:.0f} %."
    page = "\n".join([text, "", *lines, verdict, ""])
    print(page)
    if options.rival and not options.page:
        generated_page.write_part("analysis.md", "morphometry", page)
    if options.page:
        Path(options.page).write_text(page, encoding="utf-8")
    return 0 if good else 1


if __name__ == "__main__":
    if sys.argv[1:2] == ["--piece"]:
        piece(sys.argv[2:])
    else:
        sys.exit(main(sys.argv[1:]))
