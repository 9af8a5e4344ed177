#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trabecular designs of real bone, seed after seed: exact, parts, cavities, contacts, trabeculae, CPU seconds.

    python3 tools/voxel_runs.py seeds [--seeds 20] [--contacts edge] [--trabeculae off] [--thickness 1] [--void 1]
    python3 tools/voxel_runs.py masks [--data DIR]       # a sphere and the femur's head, filled; by all strategies
    python3 tools/voxel_runs.py small [--seeds 3]        # small samples with full layers: solved and refused
    python3 tools/voxel_runs.py growth                   # 50^3 to 512^3; draws docs/pictures/voxels-growth.png
    python3 tools/voxel_runs.py grown --edges 400 --waves 8 [--profile 20]  # one box; which functions take the time

Samples are the shrew cube and the human bone at 0.1 mm. Times are CPU seconds of one thread; the texture is fitted once
for a sample, and its time is told apart. ``--pictures DIR``: layers of the bone above those of designs.
"""

from __future__ import annotations

import argparse
import cProfile
import json
import os
import resource
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

import numpy as np  # noqa: E402
from small_samples import counts_exist, keeps_rules, samples  # noqa: E402

from freecad_trabecula.core.progress import silent  # noqa: E402
from freecad_trabecula.core.stl import read_triangles  # noqa: E402
from freecad_trabecula.core.voxels.connectivity import (  # noqa: E402
    closed_cavities,
    corner_contacts,
    edge_contacts,
    parts,
)  # fmt: skip
from freecad_trabecula.core.voxels.design import make_design  # noqa: E402
from freecad_trabecula.core.voxels.masks import main_part, targets_within  # noqa: E402
from freecad_trabecula.core.voxels.parameters import VoxelParameters  # noqa: E402
from freecad_trabecula.core.voxels.registry import find_strategy, strategy_names  # noqa: E402
from freecad_trabecula.core.voxels.sources import mask_of_triangles, read_targets  # noqa: E402
from freecad_trabecula.core.voxels.strategies import trabecular  # noqa: E402
from freecad_trabecula.core.voxels.targets import Targets  # noqa: E402
from freecad_trabecula.core.voxels.trabeculae import mean_deviation, trabecula_counts  # noqa: E402
from freecad_trabecula.core.voxels.variants import chance_overlap, overlaps  # noqa: E402
from freecad_trabecula.core.voxels.verification import layer_errors  # noqa: E402
from freecad_trabecula.errors import ExactnessError, InfeasibleError  # noqa: E402

DATA = Path(os.environ.get("TRABECULA_DATA") or ROOT.parent / "shared" / "data")
WAVE = 14.0  # voxels: the human bone's at 0.1 mm
#: Edge and goal, of seconds and of memory in GB.
GOALS = ([(100, 2.5), (200, 5), (400, 60), (512, 180)], [(400, 3), (512, 6)])
SAMPLES = {"shrew": "shrew_cube_10mm.stl", "human": "trab_ior_10mm_13MB.stl"}


def made(targets, parameters, mask=None, most=0):
    """Return a design and its CPU seconds; tell on stderr the functions, so many, that take most of them."""
    profile = cProfile.Profile(time.process_time)
    strategy = find_strategy(parameters.strategy)
    start = time.process_time()
    if most:
        profile.enable()
    voxels = strategy.design(targets, parameters, mask, silent)
    profile.disable()
    seconds = time.process_time() - start
    if most:
        profile.create_stats()
        shown = sorted(((spent[3], *spent[2::-2], place) for place, spent in profile.stats.items()), reverse=True)
        print("    with    own   calls of what", file=sys.stderr)
        for whole, own, calls, (file, row, name) in shown[:most]:
            print(f"{whole:8.2f} {own:6.2f} {calls:7d} {Path(file).name}:{row} {name}", file=sys.stderr)
    return voxels, seconds


def line(name, voxels, targets, seconds, mask=None):
    """Print what was found of one design; returns whether it is exact, one part, without cavities."""
    wrong = len(layer_errors(voxels, targets))
    count, cavities = len(parts(voxels)[1]) - 1, len(closed_cavities(voxels, mask)[1]) - 1
    outside = "" if mask is None else f", outside the mask {np.count_nonzero(voxels & ~mask)}"
    contacts = f"contacts by an edge {edge_contacts(voxels)}, by a corner {corner_contacts(voxels)}{outside}"
    print(f"{name}: {voxels.sum()} voxels, layers off {wrong}, parts {count}, closed cavities {cavities}, {contacts}, "
          f"{seconds:.2f} s", flush=True)  # fmt: skip
    return wrong == 0 and count == 1 and cavities == 0


def seeds(options):
    """Design both samples with every seed."""
    trabecular.design(Targets([16] * 8, [16] * 8, [16] * 8), VoxelParameters())  # tables are made once
    for name, file in SAMPLES.items():
        chosen = {word: getattr(options, word) for word in ("contacts", "trabeculae", "thickness", "void")}
        targets = read_targets(options.data / file, VoxelParameters(**chosen))
        start = time.process_time()
        texture = trabecular.chosen_texture(targets, VoxelParameters())
        waves = ", ".join(f"{w:.1f}" for w in texture.wavelengths)
        print(f"{name}: {targets.layers} layers, {targets.total} voxels; waves {waves} voxels, mix {texture.mix:.2f}, "
              f"fitted in {time.process_time() - start:.2f} s")  # fmt: skip
        designs, times, good, deviations = [], [], 0, []
        for seed in range(1, options.seeds + 1):
            try:
                voxels, seconds = made(targets, VoxelParameters(seed=seed, **chosen), None, options.profile)
            except ExactnessError as error:
                print(f"{name} seed {seed}: refused: {error}", flush=True)
                continue
            good += line(f"{name} seed {seed}", voxels, targets, seconds)
            pairs = zip(trabecula_counts(voxels), trabecula_counts(targets.sample))
            deviations.append([100 * mean_deviation(count, goal) for count, goal in pairs])
            designs.append(voxels)
            times.append(seconds)
        if not designs:
            continue
        shared = overlaps(designs)[~np.eye(len(designs), dtype=bool)]
        x, y, z = np.mean(deviations, 0)
        print(f"{name}: {good} of {options.seeds} exact in one part without cavities; median {np.median(times):.2f} s, "
              f"longest {max(times):.2f} s; trabeculae per layer off by {x:.1f} / {y:.1f} / {z:.1f} % along X / Y / Z, "
              f"{np.mean(deviations):.1f} % together")  # fmt: skip
        if len(designs) > 1:
            print(f"{name}: variants overlap by {shared.mean():.3f} ({shared.min():.3f} to {shared.max():.3f}); "
                  f"chance {chance_overlap(designs[0]):.3f}")  # fmt: skip
        if options.pictures:
            picture(options.pictures / f"{name}-{options.trabeculae}.png", [targets.sample, *designs[:2]])


def picture(path, solids):
    """Write layers of solids, one row each: two along z, y and x."""
    from PIL import Image

    rows = []
    side = max(max(solid.shape) for solid in solids) + 6
    for solid in solids:
        tiles = []
        for axis in range(3):
            for share in (0.3, 0.6):
                layer = np.take(solid, int(share * solid.shape[axis]), axis)
                tile = np.full((side, side), 128, np.uint8)
                tile[: layer.shape[0], : layer.shape[1]] = np.where(layer, 0, 255)
                tiles.append(tile)
        rows.append(np.concatenate(tiles, 1))
    path.parent.mkdir(parents=True, exist_ok=True)
    image = np.kron(np.concatenate(rows), np.ones((2, 2), np.uint8))
    Image.fromarray(image).save(path)
    print(f"{path}: the bone's layers above, designs below")


def masks(options):
    """Fill a sphere, and the femur's upper end, with 30 % of bone."""
    z, y, x = np.ogrid[:100, :100, :100]
    ball = (z - 49.5) ** 2 + (y - 49.5) ** 2 + (x - 49.5) ** 2 <= 2500
    parameters = VoxelParameters(wavelength=1.4)
    for density in (0.1, 0.3, 0.6):
        targets = targets_within(ball, (density,) * 3)
        line(f"sphere at {density:g}", *_filled(targets, parameters, ball))
    _by_tables("sphere at 0.3", targets_within(ball, (0.3,) * 3), VoxelParameters(), ball, options)
    femur = 1000.0 * read_triangles(options.data / "anatomy" / "FemurR.stl").astype(float)  # the file is in metres
    corners = femur.reshape(-1, 3)
    long = int(np.argmax(np.ptp(corners, 0)))
    top = corners[corners[:, long] > corners[:, long].max() - 60.0]
    low, size = top.min(0), 0.8  # mm
    layers = np.ceil(np.ptp(top, 0) / size).astype(int)
    # any targets of that shape say where the cells are
    box = Targets(*(np.zeros(n, int) for n in layers), (size,) * 3, tuple(low.tolist()))
    mask = main_part(mask_of_triangles(femur, box, "half"))
    targets = targets_within(mask, (0.3,) * 3, (size,) * 3, box.origin)
    parameters = VoxelParameters(size=size, wavelength=8 * size)
    line(f"femur, upper 60 mm, {mask.sum()} cells of {size} mm", *_filled(targets, parameters, mask))
    _by_tables("femur", targets, parameters, mask, options)


def _by_tables(name, targets, parameters, mask, options):
    """Fill a mask by every strategy of tables."""
    designs = []
    for strategy in strategy_names():
        if "pairing" in find_strategy(strategy).OPTIONS:
            filled = _filled(targets, replace(parameters, strategy=strategy), mask)
            line(f"{name}, {strategy}", *filled)
            designs.append(filled[0])
    if options.pictures:
        picture(options.pictures / f"{name.split()[0]}-tables.png", [mask, *designs])


def _filled(targets, parameters, mask):
    voxels, seconds = made(targets, parameters, mask)
    return voxels, targets, seconds, mask


def small(options):
    """Design every small sample with every seed; print what was refused, and whether an exact check agrees."""
    found, worst = {}, 0.0
    for kind, name, targets in samples():
        for seed in range(1, options.seeds + 1):
            start = time.process_time()
            try:
                design = make_design(targets, VoxelParameters(seed=seed, size=targets.voxel, contacts=options.contacts))
                held = len(parts(design.voxels)[1]) == 2 and len(closed_cavities(design.voxels)[1]) == 1
                touch = options.contacts != "any" and edge_contacts(design.voxels)
                result = "solved" if held and not touch else "wrong"
            except (ExactnessError, InfeasibleError) as error:
                result = _refusal(targets, error)
                print(f"{name}, seed {seed}: {result}: {error}", flush=True)
            seconds = time.process_time() - start
            worst = max(worst, seconds)
            row = found.setdefault(kind, {})
            row[result] = row.get(result, 0) + 1
            row["CPU s"] = row.get("CPU s", 0.0) + seconds
    for kind, row in found.items():
        print(f"{kind}: " + ", ".join(f"{what} {count:.4g}" for what, count in sorted(row.items())))
    print(f"longest {worst:.1f} s")
    return any(row.get("wrong", 0) + row.get("wrongly refused", 0) for row in found.values())


def _refusal(targets, error):
    """Return what a refusal is worth."""
    if keeps_rules(targets.sample, targets):
        return "wrongly refused"
    if not counts_exist(targets):
        return "no voxels have these counts"
    return "no design keeps the rules" if isinstance(error, InfeasibleError) else "not known"


def grown(options):
    """Design one box of the human bone's profiles; print its edge, waves, CPU seconds, peak memory in GB, faults."""
    targets = read_targets(options.data / SAMPLES["human"], VoxelParameters())
    share = [counts / size for counts, size in zip(targets.counts, targets.layer_sizes)]
    (edge,) = options.edges
    at = [np.interp((np.arange(edge) + 0.5) / edge * len(s), np.arange(len(s)) + 0.5, s) for s in share]
    finer = targets_within(np.ones((edge,) * 3, bool), at)
    waves = options.waves or WAVE * edge / 100
    chosen = VoxelParameters(wavelength=waves * finer.voxel[0], rods=0.3, contacts=options.contacts)
    voxels, seconds = made(finer, chosen, None, options.profile)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    faults = len(layer_errors(voxels, finer)) + abs(len(parts(voxels)[1]) - 2) + edge_contacts(voxels)
    print(json.dumps([edge, waves, seconds, peak, faults]))


def growth(options):
    """Design boxes of growing resolution, with waves that grow with them and waves of 14 voxels; draw the growth."""
    found = {"waves grow with the box": [], f"waves of {WAVE:g} voxels": []}
    for (name, rows), waves in zip(found.items(), (0, WAVE)):
        for edge in options.edges:
            words = ["--edges", str(edge), "--waves", str(waves), "--contacts", options.contacts]
            command = [sys.executable, __file__, "grown", *words, "--data", str(options.data)]
            rows.append(json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout))
            _, _, seconds, peak, faults = rows[-1]
            print(f"{edge}^3, {name}: {seconds:.1f} s, peak {peak:.2f} GB, faults {faults}", flush=True)
    draw_growth(found)
    return any(row[4] for rows in found.values() for row in rows)


def draw_growth(found):
    """Draw seconds and memory against the voxels into docs/pictures/voxels-growth.png (needs matplotlib)."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4))
    for name, rows in found.items():
        edges, _, seconds, memory, _ = zip(*rows)
        for axis, values in zip(axes, (seconds, memory)):
            axis.loglog([edge**3 for edge in edges], values, "o-", label=name)
    for axis, goals, label in zip(axes, GOALS, ("CPU seconds, field included", "peak memory, GB")):
        axis.loglog(*zip(*[(edge**3, goal) for edge, goal in goals]), "kx", label="goals")
        axis.set_xticks([edge**3 for edge in edges], [f"{edge}³" for edge in edges])
        axis.minorticks_off()
        axis.set_xlabel("cells of the box")
        axis.set_ylabel(label)
        axis.grid(True, alpha=0.3)
        axis.legend(loc="upper left")
    figure.tight_layout()
    path = ROOT / "docs" / "pictures" / "voxels-growth.png"
    figure.savefig(path, dpi=110)
    print(f"drawn in {path}")


def main():
    """Read the command line and run one check."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("check", choices=("seeds", "masks", "small", "growth", "grown"))
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--contacts", default="edge", choices=("any", "edge", "corner"))
    parser.add_argument("--trabeculae", default="off")
    parser.add_argument("--thickness", type=int, default=1)
    parser.add_argument("--void", type=int, default=1)
    parser.add_argument("--edges", type=int, nargs="+", default=[50, 100, 200, 400, 512])
    parser.add_argument("--waves", type=float, default=0, help="of one box, voxels; 0: they grow with it")
    parser.add_argument(
        "--profile", type=int, default=0, help="of seeds and one box: so many functions, by their CPU seconds"
    )
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--data", type=Path, default=DATA)
    options = parser.parse_args()
    checks = {"seeds": seeds, "masks": masks, "small": small, "growth": growth, "grown": grown}
    return int(bool(checks[options.check](options)))


if __name__ == "__main__":
    sys.exit(main())
