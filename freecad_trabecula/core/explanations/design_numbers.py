# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of a design of rods and of the bodies made of it."""

from __future__ import annotations

from ..bodies import BALANCE, FIELD, RAY_ERRORS
from .explanation import Explanation

_EQ = "thesis Eq. 2.2"
_BALANCE = "scaffold + channels"
_OWN = "own definition"
_MESHES = f"at most {BALANCE:g} of the envelope apart; with the field engine {FIELD:g}"
_SUM = "scaffold + channels + loose pieces, each by its own triangles, against the envelope"
_KERNEL = "volume of the mesh of the same rods"
_KERNEL_WITHIN = "at most 0.2 % apart"

NUMBERS = (
    Explanation(
        "design.rods", "rods", "N", "", "pairs of the couplings that are on, less the rods that nothing mended",
        "thesis section 2.4.5, tables 4.2 and 4.5", "count of the pairs that were coupled", "no rod may be left out",
        check="rods made, of those that were coupled",
    ),
    Explanation(
        "design.manual_time", "time by hand", "", "h", "sum over the rods of 30 to 75 s, by curvature of the path and "
        "number of sections", "thesis section 2.3.3",
    ),
    Explanation(
        "design.rod_volume", "sum of the rods", "", "mm3", "sum of the volumes of the rods' solids by the kernel, "
        "crossings counted as often as they come", "thesis section 2.4.7", _KERNEL, _KERNEL_WITHIN,
        check="volume of the rods, solids against meshes",
    ),
    Explanation(
        "design.porosity", "porosity of the scaffold", "P", "%", "100 (V_envelope - V_scaffold) / V_envelope, volumes "
        "by the divergence theorem over the triangles of what is exported", _EQ, _SUM, _MESHES, check=_BALANCE,
    ),
    Explanation(
        "design.union_porosity", "union of the rods in the envelope", "", "%", "100 V_union / V_envelope, the union by "
        "the engine, before loose pieces are taken away or voids filled", _EQ, "union by parallel rays through the "
        "rods' own triangles: no Boolean", f"at most {RAY_ERRORS:g} standard errors of the rays apart",
        check="channels by triangles and by rays",
    ),
    Explanation(
        "design.sum_porosity", "plain sum of the rods", "", "%", "100 sum V_rod / V_envelope, crossings counted as "
        "often as they come; what the thesis added up for case 1", _EQ, "sum of the rods' solids by the kernel, where "
        "the network is built", _KERNEL_WITHIN, check="volume of the rods, solids against meshes",
    ),
    Explanation(
        "design.envelope_volume", "volume of the envelope", "V_envelope", "mm3", "divergence theorem over its "
        "triangles", _EQ, _SUM, _MESHES, check=_BALANCE,
    ),
    Explanation(
        "design.layers_volume", "volume of layers outside of the envelope", "", "mm3", "divergence theorem over their "
        "triangles", "thesis section 4.3.1", "part of the balance of all volumes", _MESHES, check=_BALANCE,
    ),
    Explanation(
        "design.scaffold_volume", "volume of the scaffold", "V_scaffold", "mm3", "divergence theorem over its "
        "triangles in double precision", _EQ, "the same in single precision, as it is in the file; and the balance of "
        "all volumes", _MESHES, check="scaffold",
    ),
    Explanation(
        "design.channel_volume", "volume of the channels", "V_voids", "mm3", "divergence theorem over the triangles of "
        "union of the rods and envelope", _EQ, "rays through the rods' own triangles", f"at most {RAY_ERRORS:g} "
        "standard errors of the rays apart", check="channels by triangles and by rays",
    ),
    Explanation(
        "design.loose", "loose pieces", "", "mm3", "connected pieces of the scaffold that channels cut off all round; "
        "they are taken away unless they are to be kept", _OWN, _SUM, _MESHES, check=_BALANCE,
    ),
    Explanation(
        "design.voids", "voids that no opening reaches", "", "mm3", "connected pieces of the channels that touch no "
        "face of the envelope", _OWN, "cavities found from the shells of the scaffold and from those of the channels",
        "equal numbers", check="cavities seen from inside and from outside",
    ),
    Explanation(
        "design.pieces", "connected pieces of the scaffold", "", "", "closed shells of its triangles, the voids "
        "inside one counted with it", _OWN,
    ),
    Explanation(
        "design.openings", "connected channels", "", "", "closed shells of their triangles, the holes "
        "inside one counted with it",
        _OWN,
    ),
    Explanation("design.seconds", "time", "", "s", "clock time of cutting the channels", "thesis section 2.4.7"),
    Explanation(
        "design.seconds_per_rod", "time for a rod", "", "s", "time over the number of rods", "thesis section 2.4.7"
    ),
    Explanation(
        "design.solid_porosity", "porosity of the STEP scaffold", "P", "%", "100 (1 - V_solid / V_envelope), volumes "
        "by the kernel", _EQ, "the same cut by the mesh engine", _KERNEL_WITHIN,
        check="volume of the scaffold, solid against mesh",
    ),
    Explanation(
        "design.solid_volume", "volume of the STEP scaffold", "", "mm3", "volume of the solid by the kernel", _EQ,
        "the same cut by the mesh engine", _KERNEL_WITHIN, check="volume of the scaffold, solid against mesh",
    ),
    Explanation(
        "design.solid_rods", "rods cut from the STEP scaffold", "", "", "rods whose channels the B-Rep engine cut, of "
        "all", _OWN, "rods of the wireframe", "equal numbers, or the scaffold is refused",
    ),
    Explanation(
        "design.available", "sites available", "", "", "sites of both faces that are on and that no earlier coupling "
        "used", "thesis tables 4.2 and 4.5", "available less left is the number of rods", "equal numbers",
    ),
    Explanation(
        "design.left", "sites left", "", "", "available sites that the coupling did not use", "thesis tables 4.2 and "
        "4.5", "available less left is the number of rods", "equal numbers",
    ),
    Explanation(
        "design.attempts", "attempts", "", "", "how often a faulty rod was drawn anew until it was sound",
        "thesis sections 3.3.5 and 4.2.4",
    ),
    Explanation(
        "design.pore_size", "size of the end sections", "s", "mm", "diameter of the circle, or side of the square "
        "through the corners, as drawn from the law of the pores", "thesis section 2.4.1",
    ),
    Explanation(
        "design.pore_area_estimated", "estimated area of the end sections", "", "mm2", "s^2", "thesis section 2.4.1",
        "true area of the curve: it is 1.46 s^2 in the mean", "no tolerance: the estimate is the thesis'",
    ),
    Explanation(
        "design.pore_area", "true area of the end sections", "", "mm2", "Green's theorem over the cubic pieces, exact",
        "own definition (docs/method.md, section 1)",
    ),
    Explanation(
        "design.sites", "sites", "", "", "points of Eq. 2.1 on a prism; points of the co-ordinate lines on other faces",
        "thesis Eq. 2.1, section 4.2.2",
    ),
    Explanation(
        "design.spread_mean", "mean porosity of the variants", "", "%", "sum of the variants' porosities over their "
        "number", _OWN,
    ),
    Explanation(
        "design.spread_sd", "standard deviation of the variants", "", "%", "sqrt(sum (P - mean)^2 / (n - 1)); of a "
        "sample, as the thesis' repeats are", _OWN,
    ),
    Explanation(
        "design.spread_range", "least and greatest of the variants", "", "%", "least and greatest of the variants' "
        "porosities", _OWN,
    ),
    Explanation(
        "design.estimate", "estimated porosity", "", "%", "100 V_union / V_envelope, the union of the rods by "
        "parallel rays through their triangles, with its standard error; loose pieces stay", _EQ, "the scaffold, once "
        "it is built", f"{RAY_ERRORS:g} standard errors, loose pieces and voids left aside",
    ),
)  # fmt: skip
