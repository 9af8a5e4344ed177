# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of voxel designs."""

from __future__ import annotations

from .explanation import Explanation

_OWN = "own definition"
_GALE_RYSER = "thesis section 6.2.4, by Gale 1957, DOI 10.2140/pjm.1957.7.1073"

NUMBERS = (
    Explanation(
        "voxels.layers", "layers", "N, M, P", "", "length of the sample along X, Y, Z over the voxel's edge, rounded",
        "thesis section 6.2.1",
    ),
    Explanation(
        "voxels.asked", "voxels asked for in a layer", "D, E, C", "", "Round(sliced area / area of a voxel's face), "
        "brought to one total of the three axes", "thesis Eq. 6.1", "sum of the layers along each of the three axes",
        "equal numbers",
    ),
    Explanation(
        "voxels.made", "voxels made in a layer", "", "", "count of the solid voxels of the layer",
        "thesis section 6.4", "voxels asked for, counted by a routine of its own (core/voxels/verification.py)",
        "equal numbers on every layer of the three axes, or the design is refused",
    ),
    Explanation(
        "voxels.delta", "delta", "delta_X, delta_Y, delta_Z", "", "common total less the sum of an axis' rounded "
        "counts", "thesis section 6.2.1, after Eq. 6.1",
    ),
    Explanation(
        "voxels.voxels", "solid voxels", "", "", "count of the solid voxels", "thesis Eq. 6.1",
        "sums of the targets along X, Y and Z", "equal numbers",
    ),
    Explanation(
        "voxels.volume", "volume of the voxels", "", "mm3", "solid voxels x dx dy dz", "thesis section 6.2.1",
        "volume of the mesh by the divergence theorem", "1e-9 of it for blocks; told for smooth surfaces",
        check="volume of the mesh and of the voxels",
    ),
    Explanation(
        "voxels.bone_fraction", "bone fraction", "BV/TV", "%", "100 solid voxels / voxels of the envelope",
        "Bouxsein et al. 2010, DOI 10.1002/jbmr.141",
    ),
    Explanation(
        "voxels.components", "connected parts", "", "", "parts of solid voxels, neighbours by a face",
        "thesis chapter 9",
    ),
    Explanation(
        "voxels.largest_fraction", "share of the largest part", "", "%", "100 voxels of the largest part / solid "
        "voxels", "thesis chapter 9",
    ),
    Explanation(
        "voxels.floating", "floating voxels", "", "", "solid voxels outside of the largest part", "thesis chapter 9"
    ),
    Explanation(
        "voxels.closed_cavities", "closed cavities", "", "", "parts of void voxels, neighbours by a face, that touch "
        "no border", _OWN,
    ),
    Explanation(
        "voxels.edge_contacts", "contacts by an edge alone", "", "", "edges at which two solid voxels meet across, the "
        "other two being void", _OWN,
    ),
    Explanation(
        "voxels.corner_contacts", "contacts by a corner alone", "", "", "blocks of 2 x 2 x 2 voxels with two opposite "
        "corners alone of their kind, solid or void", _OWN,
    ),
    Explanation(
        "voxels.trabeculae", "trabeculae of a layer", "", "", "parts of a layer's solid voxels, neighbours by an edge "
        "of their squares", "thesis chapter 9",
    ),
    Explanation(
        "voxels.trabecula_deviation", "mean deviation of the trabeculae", "", "%", "100 times the mean over an "
        "axis' layers of |made - asked for| / asked for", _OWN,
    ),
    Explanation(
        "voxels.table_values", "largest of the tables alpha and beta", "", "", "most solid voxels in a line (x, z) and "
        "(y, z)", "thesis Eq. 6.2 and Eq. 6.6",
    ),
    Explanation(
        "voxels.smallest_cap", "smallest possible caps", "", "", "least cap on alpha and beta with which a table has "
        "the layers' sums", _GALE_RYSER,
    ),
    Explanation(
        "voxels.mean_thickness", "mean thickness of the sample", "", "voxels", "2 BV / BS over the largest edge of a "
        "voxel", "Parfitt et al. 1983, DOI 10.1172/JCI111096",
    ),
    Explanation("voxels.triangles", "triangles of the mesh", "", "", "count", _OWN),
    Explanation("voxels.seconds", "time", "", "s", "clock time of targets, design and mesh", "thesis section 6.3.1"),
    Explanation(
        "voxels.overlap", "overlap of two variants", "", "%", "100 x twice the common solid voxels over the sum of "
        "both", "Dice 1945, DOI 10.2307/1932409", "overlap to expect of unrelated designs with the same layers",
        "no tolerance: it says how far variants are from chance",
    ),
)  # fmt: skip
