# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the objects of a document worked out twice: both values and their difference, for every number that has them."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Sequence

from ..core.bodies import Check
from ..core.couplings import CouplingRow
from ..core.explanations.explanation import routes_found
from ..core.explanations.registry import explanation, measure_key
from .analysis import Analysis, analysis_of
from .arguments import given_object
from .base import records_of
from .feature import is_a
from .network import MOST_DIFFERENCE, Network
from .relations import products_of
from .solid_scaffold import SolidScaffold
from .voxel_design import VoxelDesign
from .wireframe import Wireframe


def found_routes(obj: Any, key: str) -> Sequence[str]:
    """Return both values of a number of an object and how far they are apart, a sentence each; none if it has none.

    Parameters
    ----------
    obj : document object
        A wireframe (with all that was made of it), an analysis or a voxel design.
    key : str
        Of the number (``core.explanations.registry``).

    Raises
    ------
    ParameterError
        If there is no such number.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> make.found_routes(make.make_analysis(box.Document, box), "slices.volume")[0]
    'volume along x, sum of area x thickness against the mesh, mm3: 24 against 24, 0 apart (at most 0.05)'
    """
    given_object(obj)
    return routes_found(explanation(key), [one._asdict() for one in checks_of(obj)], _values(obj))


def checks_of(obj: Any) -> List[Check]:
    """Return what an object, and of a wireframe what was made of it, worked out twice."""
    if is_a(obj, Wireframe):
        found = [_rods_check(obj)]
        for one in products_of(obj):
            found += checks_of(one)
        return found
    if is_a(obj, Network) and obj.RodVolume.Value:
        name = "volume of the rods, solids against meshes, mm3"
        return [_check(name, obj.RodVolume.Value, obj.MeshVolume.Value)]
    if is_a(obj, SolidScaffold) and obj.SolidVolume.Value:
        name = "volume of the scaffold, solid against mesh, mm3"
        return [_check(name, obj.SolidVolume.Value, obj.MeshVolume.Value)]
    if is_a(obj, VoxelDesign) and obj.VoxelVolume.Value:
        name = "volume of the mesh and of the voxels, mm3"
        return [_check(name, obj.MeshVolume.Value, obj.VoxelVolume.Value, 1e-9)]
    parsed = (Check.from_text(text) for text in getattr(obj, "Checks", ()))
    return [one for one in parsed if one is not None]


def _check(name: str, value: float, second: float, most: float = MOST_DIFFERENCE) -> Check:
    return Check(name, value, second, abs(value / second - 1), most)


def _rods_check(obj: Any) -> Check:
    """Rods by the wireframe, and by its table of couplings."""
    coupled = sum(row.rods for row in records_of(obj.CouplingTable, CouplingRow, "row"))
    name = "rods made, of those that were coupled"
    return Check(name, float(obj.Rods), float(coupled), float(abs(obj.Rods - coupled)), 0.0)


def _values(obj: Any) -> Mapping[str, float]:
    """Numbers that are second routes to one another: those of a body as a whole."""
    whole = analysis_of(obj).morphometry if is_a(obj, Analysis) and obj.ResultKey else None
    found: Dict[str, float] = {}
    for one in whole.measures if whole is not None else ():
        found[measure_key(one.symbol)] = one.value
    return found
