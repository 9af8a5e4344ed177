# SPDX-License-Identifier: LGPL-2.1-or-later
"""Morphometry of a body as a whole: every measure with its symbol, unit, definition and source, in one table.

Symbols are those of bone histomorphometry (Dempster et al. 2013, DOI 10.1002/jbmr.1805) and of its guidelines for
micro-CT (Bouxsein et al. 2010, DOI 10.1002/jbmr.141). The volume of reference is the body's box.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Dict, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from ...errors import MeshError
from ..progress import Progress, part, silent
from ..triples import triple
from .anisotropy import Fabric, fabric_of_triangles, fabric_of_voxels
from .branches import Branches
from .connectivity import connectivity
from .thickness import SizeDistribution, local_thickness, size_distribution
from .triangles import Soup
from .voxelise import Voxels, fitting_size, voxelise

_ASBMR = "Dempster et al. 2013, DOI 10.1002/jbmr.1805"
_SPHERES = "Hildebrand and Ruegsegger 1997, DOI 10.1046/j.1365-2818.1997.1340694.x"
_EULER = "Odgaard and Gundersen 1993, DOI 10.1016/8756-3282(93)90245-6"
_MIL = "Whitehouse 1974, DOI 10.1111/j.1365-2818.1974.tb03878.x; Harrigan and Mann 1984, DOI 10.1007/BF00540446"
_INTERCEPTS = "Underwood, Quantitative Stereology, 1970 (S_V = 2 P_L)"
_THESIS = "thesis ch. 9 (interconnectivity of trabeculae); graph of the slices"
_CUT = 1e-6  # of the box: a triangle so near to one of its faces is where the sample was cut
_APART = 0.02  # between the mesh's and the voxels' volume; more, and the mesh overlaps itself

#: symbol: name, unit, definition, source.
TABLE: Dict[str, Tuple[str, str, str, str]] = {
    "BV/TV": ("bone volume fraction", "1", "BV over TV; porosity is 1 less it", _ASBMR),
    "BV/TV.vox": ("bone volume fraction, by voxels", "1", "share of solid voxels: the second route", _ASBMR),
    "TV": ("total volume", "mm3", "volume of the body's box", _ASBMR),
    "BV": ("bone volume", "mm3", "volume by the triangles; what overlaps counts twice", _ASBMR),
    "BS": ("bone surface", "mm2", "area of the triangles, those in the box's faces (cuts) left out", _ASBMR),
    "BS/BV": ("specific bone surface", "1/mm", "BS over BV", _ASBMR),
    "BS/BV.vox": (
        "specific bone surface, by voxels",
        "1/mm",
        "twice the surfaces crossed per length by parallel lines in all directions, over BV/TV.vox: the second route",
        _INTERCEPTS,
    ),
    "Tb.Th": ("trabecular thickness", "mm", "mean over the solid of the largest inscribed sphere's diameter", _SPHERES),
    "Tb.Th.SD": ("its standard deviation", "mm", "over the solid", _SPHERES),
    "Tb.Th.max": ("largest trabecular thickness", "mm", "diameter of the largest sphere in the solid", _SPHERES),
    "Tb.Sp": (
        "trabecular separation",
        "mm",
        "mean over the void inside the box of the largest inscribed sphere's diameter: mean pore size",
        _SPHERES,
    ),
    "Tb.Sp.SD": ("its standard deviation", "mm", "over the void", _SPHERES),
    "Tb.Sp.max": ("largest trabecular separation", "mm", "diameter of the largest sphere in the void", _SPHERES),
    "Po.D10": ("pore diameter, 10 % of the void", "mm", "a tenth of the void has spheres up to it", _SPHERES),
    "Po.D50": ("pore diameter, 50 % of the void", "mm", "half of the void has spheres up to it", _SPHERES),
    "Po.D90": ("pore diameter, 90 % of the void", "mm", "nine tenths of the void have spheres up to it", _SPHERES),
    "Tb.N": (
        "trabecular number",
        "1/mm",
        "1 / (Tb.Th + Tb.Sp); programs that measure between mid-axes, or divide BV/TV by Tb.Th, get other numbers",
        "Bouxsein et al. 2010, DOI 10.1002/jbmr.141",
    ),
    "Parts": ("number of parts", "1", "pieces of solid voxels, 26 neighbours", _EULER),
    "Cavities": ("closed cavities", "1", "pieces of void voxels, 6 neighbours, that touch no face of the box", _EULER),
    "Euler": ("Euler number", "1", "parts less handles plus cavities, of the voxels as a closed body", _EULER),
    "Conn": (
        "connectivity",
        "1",
        "1 less what the body adds to the Euler number of the structure it was cut out of: the box's faces count half, "
        "its edges a quarter, its corners an eighth",
        _EULER,
    ),
    "Conn.D": ("connectivity density", "1/mm3", "Conn over TV", _EULER),
    "MIL.max": ("longest mean intercept length", "mm", "longest half axis of the fabric ellipsoid, by voxels", _MIL),
    "MIL.min": ("shortest mean intercept length", "mm", "shortest half axis of the fabric ellipsoid, by voxels", _MIL),
    "DA": (
        "degree of anisotropy",
        "1",
        "MIL.max over MIL.min by lines through the voxels, up to 10 % low; 1 = isotropic; 1 - 1/DA^2 goes from 0 to 1",
        _MIL,
    ),
    "DA.mesh": (
        "degree of anisotropy, by triangles",
        "1",
        "DA by all lines through BS, from its normals: the second route, exact",
        _MIL,
    ),
}

#: Measures along an axis, whose name follows the symbol after a dot: name, unit, definition, source.
AXIS_TABLE: Dict[str, Tuple[str, str, str, str]] = {
    "Br": (
        "branches per mm",
        "1/mm",
        "chains of trabeculae that go on from slice to slice, each overlapping one of the next and no other, over the "
        "distance from the first slice to the last",
        _THESIS,
    ),
    "Jn": (
        "junctions per mm",
        "1/mm",
        "trabeculae that overlap several of the next slice (splits) or of the one before (joins), over that distance",
        _THESIS,
    ),
    "Lp": ("loops", "1", "overlaps less trabeculae plus parts of the graph: ways that part and meet again", _THESIS),
}


class Measure(NamedTuple):
    """One measure of a body.

    Attributes
    ----------
    symbol, name : str
    value : float
        nan where the body has no such measure; inf for the anisotropy of endless plates and rods.
    unit, definition, source : str
    """

    symbol: str
    name: str
    value: float
    unit: str
    definition: str
    source: str


@dataclass(frozen=True)
class Morphometry:
    """All measures of a body, and the distributions behind them.

    Attributes
    ----------
    voxel : float, mm
        Edge of the voxels.
    shape : tuple of three ints
        Numbers of voxels along x, y, z.
    measures : tuple of Measure
        In the order of ``TABLE``.
    thickness_edges, spacing_edges : ndarray of shape (B + 1,), mm
        Borders of bins one voxel wide.
    thickness_shares, spacing_shares : ndarray of shape (B,)
        Shares of the solid by thickness and of the void by spacing (pore size distribution).
    fabric_axes : ndarray of shape (3, 3)
        Unit vectors of the fabric ellipsoid as rows, the longest first; nan where there is none.
    notes : tuple of str
        What could not be measured, and why; where two routes part.
    """

    voxel: float
    shape: Tuple[int, int, int]
    measures: Tuple[Measure, ...]
    thickness_edges: np.ndarray
    thickness_shares: np.ndarray
    spacing_edges: np.ndarray
    spacing_shares: np.ndarray
    fabric_axes: np.ndarray
    notes: Tuple[str, ...] = ()

    def __getitem__(self, symbol: str) -> float:
        """Return the value of a measure by its symbol; KeyError if the body has none."""
        return {one.symbol: one.value for one in self.measures}[symbol]


def measure(soup: Soup, voxel: Optional[float] = None, progress: Progress = silent) -> Morphometry:
    """Return the morphometry of a body in its box.

    Parameters
    ----------
    soup : Soup
    voxel : float, mm, optional
        Edge of the voxels; by default ``voxelise.fitting_size``: 100 to 200 along the box's longest edge.
    progress : callable

    Raises
    ------
    ParameterError
        If the voxels' size cannot be, or the box is flat.
    DependencyError
        If scipy is missing.

    Notes
    -----
    A mesh that is not closed has no inside: then there are no measures, and a note that says so.
    """
    triangles = np.asarray(soup.triangles, np.float64)
    voxel = fitting_size(triangles, soup.box) if voxel is None else voxel
    try:
        voxels = voxelise(triangles, voxel, soup.box, part(progress, 0.0, 0.05))
    except MeshError as error:
        return _without_measures(voxel, str(error))
    return _measured(triangles, voxels, soup.box, progress)


def measure_voxels(voxels: Voxels, progress: Progress = silent) -> Morphometry:
    """Return the morphometry of voxels that have no mesh: what needs triangles is left out."""
    return _measured(None, voxels, None, progress)


def with_branches(morphometry: Morphometry, branches: Mapping[str, Branches]) -> Morphometry:
    """Return a morphometry with the interconnectivity along axes added, the measures of ``AXIS_TABLE`` for each."""
    added = []
    for axis, graph in branches.items():
        values = {"Br": graph.branches_per_mm, "Jn": graph.junctions_per_mm, "Lp": float(graph.loops)}
        for symbol, (name, unit, definition, source) in AXIS_TABLE.items():
            words = f"{name} along {axis}"
            added.append(Measure(f"{symbol}.{axis}", words, values[symbol], unit, definition, source))
    return replace(morphometry, measures=(*morphometry.measures, *added))


def _measured(
    triangles: Optional[np.ndarray], voxels: Voxels, box: Optional[np.ndarray], progress: Progress
) -> Morphometry:
    notes: List[str] = []
    values: Dict[str, float] = {"TV": voxels.volume, "BV/TV.vox": voxels.solid_fraction}
    if triangles is not None and box is not None:
        values.update(_mesh_values(triangles, box, voxels.solid_fraction, notes))
    thickness, spacing = _sizes(voxels, notes, part(progress, 0.05, 0.7))
    values.update(_size_values(thickness, spacing))
    values.update(_connectivity_values(voxels, values["TV"], part(progress, 0.7, 0.75)))
    fabric = _fabric(voxels, notes, part(progress, 0.75, 1.0))
    if fabric is not None:
        values["BS/BV.vox"] = fabric.surface_density / voxels.solid_fraction
        values.update({"MIL.max": fabric.lengths[0], "MIL.min": fabric.lengths[2], "DA": fabric.anisotropy})
    measures = tuple(
        Measure(symbol, name, float(values[symbol]), unit, definition, source)
        for symbol, (name, unit, definition, source) in TABLE.items()
        if symbol in values
    )
    return Morphometry(
        voxels.size,
        triple(int(n) for n in voxels.solid.shape[::-1]),
        measures,
        thickness.edges,
        thickness.shares,
        spacing.edges,
        spacing.shares,
        np.full((3, 3), np.nan) if fabric is None else fabric.axes,
        tuple(notes),
    )


def _without_measures(voxel: float, reason: str) -> Morphometry:
    nothing = np.zeros(0)
    edges = np.zeros(1)
    note = f"the body could not be measured as a whole: {reason}"
    return Morphometry(voxel, (0, 0, 0), (), edges, nothing, edges, nothing, np.full((3, 3), np.nan), (note,))


def uncut(triangles: np.ndarray, box: np.ndarray) -> np.ndarray:
    """Return the triangles that do not lie in a face of the box: the surface that is no cut of the sample."""
    near = _CUT * np.ptp(box, axis=0)
    in_face = np.zeros(len(triangles), bool)
    for axis in range(3):
        for end in (0, 1):
            in_face |= (np.abs(triangles[:, :, axis] - box[end, axis]) <= near[axis]).all(1)
    return triangles[~in_face]


def _mesh_values(triangles: np.ndarray, box: np.ndarray, by_voxels: float, notes: List[str]) -> Dict[str, float]:
    total = float(np.ptp(box, axis=0).prod())
    a, b, c = (triangles - box[0]).transpose(1, 0, 2)
    volume = float((a * np.cross(b, c)).sum() / 6)
    surface = uncut(triangles, box)
    sides = np.cross(surface[:, 1] - surface[:, 0], surface[:, 2] - surface[:, 0])
    area = float(np.sqrt((sides**2).sum(1)).sum() / 2)
    values = {"TV": total, "BV": volume, "BV/TV": volume / total, "BS": area, "BS/BV": area / volume}
    if abs(volume / total / by_voxels - 1) > _APART:
        notes.append(
            f"BV/TV is {volume / total:.4f} by triangles and {by_voxels:.4f} by voxels: parts of the mesh overlap "
            f"(then the voxels are right), or are thinner than a voxel"
        )
    try:
        values["DA.mesh"] = fabric_of_triangles(surface, total).anisotropy
    except MeshError as error:
        notes.append(f"DA.mesh: {error}")
    return values


def _sizes(voxels: Voxels, notes: List[str], progress: Progress) -> Tuple[SizeDistribution, SizeDistribution]:
    """Thickness of the solid, spacing of the void; empty where there is none."""
    found = []
    for name, inside, start, end in (
        ("Tb.Th", voxels.solid, 0.0, 0.25),
        ("Tb.Sp", ~voxels.solid, 0.25, 1.0),
    ):
        try:
            local = local_thickness(inside, voxels.size, part(progress, start, end))
        except MeshError as error:
            notes.append(f"{name}: {error}")
            local = np.zeros(0, np.float32)
        found.append(size_distribution(local, voxels.size))
    return found[0], found[1]


def _size_values(thickness: SizeDistribution, spacing: SizeDistribution) -> Dict[str, float]:
    values = {}
    for symbol, sizes in (("Tb.Th", thickness), ("Tb.Sp", spacing)):
        if sizes.largest > 0:
            values.update({symbol: sizes.mean, f"{symbol}.SD": sizes.deviation, f"{symbol}.max": sizes.largest})
    if spacing.largest > 0:
        values.update({f"Po.D{share}": spacing.quantile(share / 100) for share in (10, 50, 90)})
    if thickness.largest > 0 and spacing.largest > 0:
        values["Tb.N"] = 1 / (thickness.mean + spacing.mean)
    return values


def _connectivity_values(voxels: Voxels, total: float, progress: Progress) -> Dict[str, float]:
    found = connectivity(voxels.solid, progress)
    return {
        "Parts": found.parts,
        "Cavities": found.cavities,
        "Euler": found.euler,
        "Conn": found.connections,
        "Conn.D": found.connections / total,
    }


def _fabric(voxels: Voxels, notes: List[str], progress: Progress) -> Optional[Fabric]:
    try:
        return fabric_of_voxels(voxels, progress=progress)
    except MeshError as error:
        notes.append(f"DA: {error}")
        return None
