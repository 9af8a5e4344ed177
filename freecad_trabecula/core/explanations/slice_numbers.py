# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of slices, of bodies as wholes (morphometry), and of comparisons.

Measures and scores have their definitions and sources in one table each, ``analysis.morphometry`` and
``analysis.passport``; here is only what these do not say: the second route.
"""

from __future__ import annotations

from typing import Dict, Tuple

from ..analysis.morphometry import AXIS_TABLE, TABLE
from ..analysis.passport import DEFINITIONS
from .explanation import NONE, Explanation

_OWN = "own definition"
_SSL, _TEMPLATE = "thesis section 5.2.3.3", "thesis section 5.2.3.1"
_COUNTED = "contours of more area than the least"

SLICES = (
    Explanation(
        "slices.slices", "slices", "S", "", "layers whose middles (or bottoms) lie in the body", "thesis section 5.2.3"
    ),
    Explanation(
        "slices.spoilt_slices", "spoilt slices", "", "", "slices through an open, turned or doubled place of the mesh",
        _OWN,
    ),
    Explanation(
        "slices.rods", "rods", "", "", "outer contours whose area is at least 0.6 of their box", _TEMPLATE,
        "rods and plates by a rule that turning the part does not change (report)", "no tolerance: another rule",
    ),
    Explanation(
        "slices.plates", "plates", "", "", "outer contours that are no rods", _TEMPLATE,
        "rods and plates by a rule that turning the part does not change (report)", "no tolerance: another rule",
    ),
    Explanation(
        "slices.all_rods", "rods of all contours", "", "", "contours whose area is at least 0.6 of their box",
        "thesis tables 5.11, 5.12 and 5.13",
    ),
    Explanation(
        "slices.all_plates", "plates of all contours", "", "", "contours that are no rods, voids among them (their "
        "area is negative)", "thesis tables 5.11, 5.12 and 5.13",
    ),
    Explanation(
        "slices.trabecular_area", "trabecular area", "A", "mm2", "sum (x_i y_i+1 - x_i+1 y_i) / 2 over the corners of "
        f"a contour, voids negative; least and greatest of the {_COUNTED}", "thesis Eq. 5.1",
    ),
    Explanation(
        "slices.net_area", "trabecular area, net of holes", "", "mm2", "area of an outer contour less those of its "
        "holes", "thesis Eq. 5.1",
    ),
    Explanation(
        "slices.sliced_area", "sliced area", "", "mm2", "sum of the areas of all contours of a slice", _SSL,
        "another program's slices in the tests; of solids the kernel's own sections (make.exact_slices)",
        "6e-15 on 960 planes; of solids what tessellation changes",
    ),
    Explanation(
        "slices.mean_sliced_area", "mean sliced area", "", "mm2", "sum of sliced areas over the number of slices",
        _SSL, "volume of the mesh over the body's length", "half a layer's variation", check="volume along",
    ),
    Explanation(
        "slices.porosity", "porosity of a slice", "", "%", "100 (1 - sliced area / area of the envelope's slice)",
        "thesis Eq. 2.2, of a slice",
    ),
    Explanation(
        "slices.contours", "contours", "", "", f"{_COUNTED} on a slice, holes among them: the thesis' number of "
        "trabeculae", _SSL,
    ),
    Explanation("slices.outer_contours", "outer contours", "", "", "contours that are no holes", _OWN),
    Explanation(
        "slices.volume", "volume by slices", "", "mm3", "sum of sliced area x thickness", _SSL,
        "volume of the triangles by the divergence theorem", "half a layer (a whole one with planes at bottoms) times "
        "the total variation of the sliced area: Niederreiter 1992, DOI 10.1137/1.9781611970081", check="volume along",
    ),
    Explanation(
        "slices.bone_fraction", "mean bone fraction", "", "%", "100 sum of sliced areas / sum of the envelope's", _OWN,
        "the same along another axis", "sum of both axes' tolerances of the volume", check="mean bone fraction",
    ),
)  # fmt: skip

DIFFERENCES = (
    Explanation(
        "comparison.mean", "mean difference", "", "", "mean over the shared layers of sample less first sample",
        "thesis section 5.4",
    ),
    Explanation(
        "comparison.largest", "largest difference", "", "", "difference of the largest size over the shared layers, "
        "with its sign; at: the middle of its layer", "thesis section 5.4",
    ),
    Explanation(
        "comparison.middle", "difference in the middle", "", "", "difference half way along the shared stretch, "
        "linear between the layers' middles", "thesis section 5.4",
    ),
    Explanation(
        "comparison.equal_layers", "equal layers", "", "", "shared layers on which both values are the same number",
        "thesis section 5.4",
    ),
    Explanation(
        "comparison.meetings", "meetings", "", "", "equal layers, and pairs of neighbours between which the curves "
        "cross", "thesis section 5.4.2",
    ),
)  # fmt: skip

#: symbol: second route, tolerance, symbol of the number that it is.
_SECOND: Dict[str, Tuple[str, str, str]] = {
    "BV/TV": ("share of solid voxels, BV/TV.vox", "more than 2 % is noted: the mesh overlaps itself", "BV/TV.vox"),
    "BV/TV.vox": ("volume by the triangles, BV/TV", "more than 2 % is noted: the mesh overlaps itself", "BV/TV"),
    "BV": ("sum of sliced area x thickness", "half a layer's variation", ""),
    "BS/BV": ("intercepts of lines through the voxels, BS/BV.vox", "no tolerance: voxels round the surface",
              "BS/BV.vox"),
    "BS/BV.vox": ("area and volume of the triangles, BS/BV", "no tolerance: voxels round the surface", "BS/BV"),
    "DA": ("normals of the triangles, DA.mesh", "up to 10 % low", "DA.mesh"),
    "DA.mesh": ("lines through the voxels, DA", "which is up to 10 % low", "DA"),
    "Euler": ("parts less handles plus cavities by another program in the tests (scikit-image)", "equal numbers", ""),
}  # fmt: skip
#: Articles in which scores are defined; the others are defined here.
_ARTICLES = {
    "r": "Pearson 1895, DOI 10.1098/rspl.1895.0041",
    "KS": "Massey 1951, DOI 10.1080/01621459.1951.10500769",
    "H": "Hellinger 1909, DOI 10.1515/crll.1909.136.210",
}


def _measures() -> Tuple[Explanation, ...]:
    found = []
    for symbol, (name, unit, definition, source) in (*TABLE.items(), *AXIS_TABLE.items()):
        second, tolerance, other = _SECOND.get(symbol, (NONE, "", ""))
        check = "volume along" if symbol == "BV" else ""
        beside = f"morphometry.{other}" if other else ""
        unit = "" if unit == "1" else unit
        key = f"morphometry.{symbol}"
        found.append(Explanation(key, name, symbol, unit, definition, source, second, tolerance, check, beside))
    return tuple(found)


def _scores() -> Tuple[Explanation, ...]:
    return tuple(
        Explanation(f"passport.{symbol}", f"score {symbol}", symbol, "", definition, _ARTICLES.get(symbol, _OWN))
        for symbol, definition in DEFINITIONS.items()
    )


MEASURES, SCORES = _measures(), _scores()
