# SPDX-License-Identifier: LGPL-2.1-or-later
"""One seed, one result on every version: write what a FreeCAD draws, or compare what two of them wrote.

``python3 tools/same_seed.py write FILE.npz`` (runs under FreeCAD; FREECADCMD chooses which) designs every preset, a
network on faces at right angles and laws of every kind, and cuts three scaffolds; ``python3 tools/same_seed.py compare
A.npz B.npz`` wants the same draws, pairs, tables and recoveries exactly, co-ordinates within 1e-9 mm and the volumes of
all meshes (envelopes, rods, scaffolds, channels) within 1e-6.
"""

import dataclasses
import json
import sys

import under_freecad

SEEDS = (1, 2, 3)
COORDINATE_TOLERANCE = 1e-9  # mm
VOLUME_TOLERANCE = 1e-6  # relative
SCAFFOLDS = ("case6 seed 1", "cranial seed 1", "femur seed 1")  # designs whose channels are cut, too
VOLUMES = ("envelope", "volumes", "bodies")


def jobs():
    """Return the jobs compared, by name."""
    from freecad_trabecula.core.job import with_seed
    from freecad_trabecula.core.laws import Law
    from freecad_trabecula.core.parameters import Coupling, PathParameters
    from freecad_trabecula.core.presets import PRESETS, preset

    found = {f"{name} seed {seed}": with_seed(preset(name), seed) for name in PRESETS for seed in SEEDS}
    case6 = preset("case6")
    angles = tuple(Coupling(a, b) for a, b in (("Face1", "Face3"), ("Face2", "Face5"), ("Face4", "Face6")))
    found["right angles"] = dataclasses.replace(case6, couplings=angles)
    for kind in ("normal", "linear", "radial", "expression"):
        size = Law(kind, 0.2, 0.8, expression="0.2 + 0.06*z*u")
        pores = dataclasses.replace(case6.pores, size=size, scatter=0.1, corners=6)
        found[f"{kind} law"] = dataclasses.replace(case6, pores=pores)
    found["tension"] = dataclasses.replace(case6, path=PathParameters("tension"))
    return found


def main(arguments):
    """Design everything and write it; runs inside FreeCAD."""
    import FreeCAD
    import numpy as np

    from freecad_trabecula.core.meshes import mesh_volume
    from freecad_trabecula.core.rods import rod_volumes
    from freecad_trabecula.core.wireframe import skin
    from freecad_trabecula.geometry.cutting import make_bodies
    from freecad_trabecula.geometry.design import make_design

    arrays, texts = {}, {"freecad": ".".join(FreeCAD.Version()[:3])}
    for name, job in jobs().items():
        design = make_design(job)
        made = design.wireframe
        envelope = design.envelope.mesh
        arrays[f"{name}: envelope"] = np.array([mesh_volume(envelope), len(envelope.triangles)])
        arrays[f"{name}: pairs"] = made.site_numbers
        arrays[f"{name}: sizes"] = np.concatenate([p.size for p in made.pores.values()])
        arrays[f"{name}: paths"] = made.paths
        arrays[f"{name}: volumes"] = rod_volumes(skin(made, job.rods))
        listed = [dataclasses.astuple(r) for r in made.recoveries]
        table = [dataclasses.astuple(row) for row in made.rows]
        texts[name] = [list(made.names), listed, list(made.failed), list(made.outside), table]
        if name in SCAFFOLDS:
            bodies = make_bodies(job.wireframe, made, design.envelope, design.faces, job.scaffold)
            arrays[f"{name}: bodies"] = np.array([mesh_volume(bodies.scaffold), mesh_volume(bodies.channels)])
    np.savez_compressed(arguments[1], texts=json.dumps(texts), **arrays)
    print(f"FreeCAD {texts['freecad']}: {len(jobs())} designs written to {arguments[1]}")
    return 0


def compare(first, second):
    """Print what differs between two files; return 0 if nothing does beyond the tolerances."""
    import numpy as np

    a, b = np.load(first), np.load(second)
    texts = [json.loads(str(f["texts"])) for f in (a, b)]
    versions = [t.pop("freecad") for t in texts]
    wrong = [f"{name}: names, recoveries or faults differ" for name in texts[0] if texts[0][name] != texts[1].get(name)]
    largest = dict.fromkeys((*VOLUMES, "paths", "sizes"), 0.0)
    for key in a.files:
        kind = key.rsplit(": ")[-1]
        if key == "texts":
            continue
        if key not in b.files or a[key].shape != b[key].shape:
            wrong.append(f"{key}: not in both, or of another length")
        elif kind == "pairs":
            wrong += [f"{key} differ"] if (a[key] != b[key]).any() else []
        else:
            scale = np.abs(a[key]) if kind in VOLUMES else 1.0
            largest[kind] = max(largest[kind], float((np.abs(a[key] - b[key]) / scale).max(initial=0)))
    limits = {kind: VOLUME_TOLERANCE if kind in VOLUMES else COORDINATE_TOLERANCE for kind in largest}
    wrong += [f"{kind} differ by {largest[kind]:.2g}" for kind in limits if not largest[kind] <= limits[kind]]
    mended = sum(len(text[1]) for text in texts[0].values())
    print(f"FreeCAD {versions[0]} and {versions[1]}: {len(texts[0])} designs; same names, pairs, tables and {mended} "
          f"mended rods; sizes to {largest['sizes']:.1g} mm, paths to {largest['paths']:.1g} mm; volumes of envelopes' "
          f"meshes to {largest['envelope']:.1g}, rods to {largest['volumes']:.1g}, {len(SCAFFOLDS)} scaffolds and "
          f"their channels to {largest['bodies']:.1g}" if not wrong else "\n".join(wrong))  # fmt: skip
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) == 4 and sys.argv[1] == "compare":
        sys.exit(compare(*sys.argv[2:]))
    if len(sys.argv) != 3 or sys.argv[1] != "write":
        sys.exit(__doc__)
    sys.exit(under_freecad.run(__file__))
