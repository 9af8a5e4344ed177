#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of voxel designs that take longer than a test: random targets, the thesis' two cases, numbers of designs.

    python3 tools/voxel_checks.py targets --count 1000   # targets of random designs, all solved?
    python3 tools/voxel_checks.py thesis [--data DIR]    # cases 1 and 2 of chapter 6 re-made, beside the thesis' times
    python3 tools/voxel_checks.py count [--data DIR]     # how many designs there are, with standard errors

Times are CPU seconds of one thread.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

import numpy as np  # noqa: E402

from freecad_trabecula.core.streams import Stream  # noqa: E402
from freecad_trabecula.core.voxels.counting import bounded_solutions, count_systems, log10_of  # noqa: E402
from freecad_trabecula.core.voxels.design import make_design  # noqa: E402
from freecad_trabecula.core.voxels.feasibility import smallest_cap  # noqa: E402
from freecad_trabecula.core.voxels.parameters import VoxelParameters  # noqa: E402
from freecad_trabecula.core.voxels.report import THESIS_SECONDS, connection_record  # noqa: E402
from freecad_trabecula.core.voxels.sources import read_targets  # noqa: E402
from freecad_trabecula.core.voxels.table_pairs import draw_pair, pair_rates  # noqa: E402
from freecad_trabecula.core.voxels.targets import Targets, targets_of_voxels  # noqa: E402
from freecad_trabecula.core.voxels.verification import layer_errors  # noqa: E402
from freecad_trabecula.errors import TrabeculaError  # noqa: E402

DATA = Path(os.environ.get("TRABECULA_DATA") or ROOT.parent / "shared" / "data")
BONE = "trab_ior_10mm_13MB.stl"
STRATEGIES = ("minimum-zeros", "sequential", "random-layers")


def random_design(seed: int) -> np.ndarray:
    """Return random voxels of a random box, more of them on one side."""
    edges = 2 + (Stream(seed, "box").uniform(3) * 14).astype(int)
    density, slope = Stream(seed, "density").uniform(2)
    share = density * (1 + 1.6 * (slope - 0.5) * np.linspace(-1, 1, edges[0]))
    return Stream(seed, "voxels").many(int(np.prod(edges))).reshape(edges) < share[:, None, None]


def check_targets(count: int) -> int:
    """Design for the targets of random designs by three strategies; return how many failed."""
    failed = done = seed = 0
    start = time.process_time()
    while done < count:
        seed += 1
        voxels = random_design(seed)
        if not 0 < voxels.sum() < voxels.size:
            continue
        targets = targets_of_voxels(voxels)
        done += 1
        for strategy in STRATEGIES:
            solver = ("proportional", "thesis")[seed % 2]
            try:
                design = make_design(targets, VoxelParameters(strategy=strategy, seed=seed, solver=solver))
                failed += bool(layer_errors(design.voxels, targets))
            except TrabeculaError as error:
                failed += 1
                print(f"seed {seed}, {strategy}: {error}")
    seconds = time.process_time() - start
    print(
        f"{done} targets of random designs of 2..15 layers, {len(STRATEGIES)} strategies: {failed} failed; "
        f"{seconds:.1f} s"
    )
    return failed


def thesis_targets(data: Path) -> Targets:
    """Return targets of 103 x 94 x 103 layers: those of a real sample, without its last layers."""
    whole = read_targets(data / BONE, VoxelParameters(strategy="sequential"))
    return targets_of_voxels(whole.sample[:103, :94, :103])


def remake_thesis(data: Path) -> int:
    """Make cases 1 and 2 of chapter 6 again; print times and floating voxels."""
    targets, failed = thesis_targets(data), 0
    print(f"{' x '.join(map(str, targets.layers))} layers, {targets.total} voxels")
    for strategy, cap in (("minimum-zeros", 40), ("sequential", 30)):
        # the densest layers of this sample are denser than those of the thesis: 30 is too low for them
        cap = max(cap, smallest_cap(targets.c, targets.d), smallest_cap(targets.c, targets.e))
        parameters = VoxelParameters(
            strategy=strategy, cap_alpha=cap, cap_beta=cap, solver="thesis", direction="columns"
        )
        start = time.process_time()
        draw_pair(targets, parameters)
        tables = time.process_time() - start
        start = time.process_time()
        design = make_design(targets, parameters)
        whole = time.process_time() - start
        wrong = layer_errors(design.voxels, targets)
        failed += bool(wrong)
        held = connection_record(design.voxels)
        print(
            f"{strategy}, cap {cap}: tables {tables:.3f} s, layers and checks {whole - tables:.3f} s (thesis "
            f"{' + '.join(map(str, THESIS_SECONDS[strategy]))} s); {'NOT exact' if wrong else 'exact'}; "
            f"{held['components']} components, {100 * held['floating_voxels'] / targets.total:.1f} % of the voxels "
            f"outside the largest, {held['single_voxels']} single"
        )
        for solver in ("thesis", "proportional"):
            rates = pair_rates(
                targets, VoxelParameters(strategy=strategy, cap_alpha=cap, cap_beta=cap, solver=solver), 10
            )
            print(f"  try and repeat, solver {solver}: {rates}")
    return failed


def count_all(data: Path) -> int:
    """Print how many solutions and designs there are."""
    start = time.process_time()
    for cap in (1220, 94, 40, 30):
        print(f"1220 voxels in 103 variables up to {cap}: 10^{log10_of(bounded_solutions(1220, [cap] * 103)):.3f}")
    print(f"{time.process_time() - start:.2f} s")
    design = make_design(thesis_targets(data), VoxelParameters(strategy="minimum-zeros"))
    start = time.process_time()
    counts = count_systems(design)
    seconds = time.process_time() - start
    for name, count in counts._asdict().items():
        print(
            f"{name}: 10^{count.log10:.2f}, standard error {count.standard_error:.2f}, effective {count.effective:.1f}"
        )
    print(f"{seconds:.1f} s")
    errors = [c.standard_error / c.log10 for c in counts if np.isfinite(c.standard_error)]
    return int(seconds > 10 or max(errors) > 0.01)


def main() -> int:
    """Run what the words ask for; return how much failed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("targets", "thesis", "count"))
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--data", type=Path, default=DATA)
    chosen = parser.parse_args()
    if chosen.what == "targets":
        return check_targets(chosen.count)
    if not (chosen.data / BONE).exists():
        print(f"{BONE} is not in {chosen.data}: name its folder by --data")
        return 2
    return {"thesis": remake_thesis, "count": count_all}[chosen.what](chosen.data)


if __name__ == "__main__":
    sys.exit(main())
