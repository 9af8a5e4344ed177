# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which number a row of the reports shows: the words of its first cells, and the key of its explanation."""

from __future__ import annotations

from typing import Dict, List, Sequence

from ..analysis.morphometry import TABLE
from ..analysis.passport import DEFINITIONS
from .registry import TOTAL_KEYS, measure_key

_DESIGN = {
    "rods": "design.rods",
    "porosity, % (Eq. 2.2)": "design.porosity",
    "union of the rods, %": "design.union_porosity",
    "plain sum of the rods, %": "design.sum_porosity",
    "volume of the envelope, mm3": "design.envelope_volume",
    "volume of layers added to it, mm3": "design.layers_volume",
    "volume of the channels, mm3": "design.channel_volume",
    "volume of the scaffold, mm3": "design.scaffold_volume",
    "volume of loose pieces taken away, mm3": "design.loose",
    "volume of closed voids, mm3": "design.voids",
    "pieces: scaffold": "design.pieces",
    "pieces: channels": "design.openings",
    "pieces: loose": "design.loose",
    "pieces: closed_voids": "design.voids",
    "pieces: closed voids": "design.voids",
    "time of all, s": "design.seconds",
    "time of the network, s": "design.seconds",
    "time of the network a rod, s": "design.seconds_per_rod",
    "manual design a rod, s (thesis 2.3.3)": "design.manual_time",
    "size, mm": "design.pore_size",
    "estimated area s^2, mm2": "design.pore_area_estimated",
    "true area, mm2": "design.pore_area",
}
_SLICES = {
    "slices": "slices.slices",
    "spoilt slices": "slices.spoilt_slices",
    "total number of rods": "slices.rods",
    "total number of plates": "slices.plates",
    "plates, voids among them": "slices.all_plates",
    "rods, by the rule that turning does not change": "slices.rods",
    "plates, by that rule": "slices.plates",
    "trabecular area range, mm2": "slices.trabecular_area",
    "the same, net of holes, mm2": "slices.net_area",
    "porosity range, %": "slices.porosity",
    "sliced area, mm2": "slices.sliced_area",
    "mean sliced area, mm2": "slices.mean_sliced_area",
    "contours a slice": "slices.contours",
    "outer contours a slice": "slices.outer_contours",
    "sum of area x thickness, mm3": "slices.volume",
    "mean bone fraction, %": "slices.bone_fraction",
    "branches a mm": "morphometry.Br",
    "junctions a mm": "morphometry.Jn",
    "loops: ways that part and meet again": "morphometry.Lp",
}
_TOTALS = ("Total number of rods", "Total number of plates", "Trabecular area range (mm2)", "Sliced area (mm2)")
_VOXELS = {
    "layers N x M x P": "voxels.layers",
    "solid voxels": "voxels.voxels",
    "volume, mm³": "voxels.volume",
    "bone fraction BV/TV": "voxels.bone_fraction",
    "components (6-neighbours)": "voxels.components",
    "share of the largest": "voxels.largest_fraction",
    "floating voxels": "voxels.floating",
    "closed cavities": "voxels.closed_cavities",
    "contacts by an edge alone": "voxels.edge_contacts",
    "contacts by a corner alone": "voxels.corner_contacts",
    "largest alpha, beta": "voxels.table_values",
    "smallest possible caps on alpha, beta": "voxels.smallest_cap",
    "mean thickness of the sample (2 BV/BS), voxels": "voxels.mean_thickness",
    "triangles of the mesh": "voxels.triangles",
    "its volume against the voxels'": "voxels.volume",
}
#: Heads of columns that are numbers, where rows are samples, axes or couplings.
_HEADS = {
    "mean": "comparison.mean",
    "largest": "comparison.largest",
    "in the middle": "comparison.middle",
    "equal layers": "comparison.equal_layers",
    "meetings": "comparison.meetings",
    "initial sites 1": "design.available",
    "final sites 1": "design.left",
    "attempts": "design.attempts",
    "delta": "voxels.delta",
    "trabeculae (mean)": "voxels.trabeculae",
    "asked for": "voxels.asked",
    "mean deviation": "voxels.trabecula_deviation",
    "sites": "design.sites",
}
_WORDS: Dict[str, Dict[str, str]] = {
    "design": _DESIGN,
    "slice analysis": {**_SLICES, **{symbol: measure_key(symbol) for symbol in TABLE}},
    "slice comparison": {
        **dict(zip(_TOTALS, TOTAL_KEYS)),
        **{symbol: f"passport.{symbol}" for symbol in DEFINITIONS},
    },
    "voxel design": _VOXELS,
}


def keys_of_table(kind: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> List[str]:
    """Return the keys of the numbers that a table of a report shows, in its order, each once.

    Parameters
    ----------
    kind : str
        ``design``, or the kind that stands in the record.
    head, rows
        The table's texts.

    Examples
    --------
    >>> keys_of_table("design", ("output", "value"), [("rods", "147"), ("seed", "1")])
    ['design.rods']
    """
    words = _WORDS[kind]
    found = [words[cell] for row in rows for cell in row[:2] if cell in words]
    found += [_HEADS[cell] for cell in head if cell in _HEADS and not (cell == "mean" and kind == "design")]
    return list(dict.fromkeys(found))
