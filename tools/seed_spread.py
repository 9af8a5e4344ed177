# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the porosity of the thesis' cases spreads over seeds 1 to 10, by *Other seeds* (docs/study.md).

``python3 tools/seed_spread.py [--scaffold]``: by rays, or by the scaffold of each.
"""

import sys

import under_freecad

CASES = ("case3", "case4", "case5", "case6")
SEEDS = range(1, 11)


def main(arguments):
    """Print a row a case."""
    import FreeCAD

    from freecad_trabecula import make
    from freecad_trabecula.core.presets import THESIS, preset
    from freecad_trabecula.core.variants import RAYS, SCAFFOLD, spread

    by = SCAFFOLD if "--scaffold" in arguments else RAYS
    output = open(1, "w", encoding="utf-8", buffering=1, closefd=False)  # noqa: SIM115
    print("| case | mean, % | sd, % | least, % | greatest, % | thesis, % |\n|---|---|---|---|---|---|", file=output)
    for case in CASES:
        wireframe = make.make_design(FreeCAD.newDocument(case), preset(case)).wireframe
        variants = make.make_variants(wireframe, SEEDS, by)
        found = spread(variants.values(variants.spreads))
        numbers = " | ".join(f"{value:.2f}" for value in found[:4])
        print(f"| {case} | {numbers} | {THESIS[case].porosity:.2f} |", file=output)


if __name__ == "__main__":
    sys.exit(under_freecad.run(__file__))
