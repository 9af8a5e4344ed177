# SPDX-License-Identifier: LGPL-2.1-or-later
"""The network in the document: a compound of the rods' solids; only those whose inputs changed are built again."""

from __future__ import annotations

import hashlib
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import FreeCAD
import numpy as np
import Part

from ..core import wireframe as core
from ..core.history import rounded_keys
from ..core.parameters import RodParameters
from ..core.progress import Progress, silent
from ..errors import KernelError, ParameterError
from ..geometry.rod_solids import measured_rods
from . import results
from .arguments import given_object, given_value
from .feature import is_a, result, show_in_place
from .on_demand import OnDemand, on_demand
from .wireframe import Wireframe

FEW = 10  # rods that are built while a window waits
MOST_DIFFERENCE = 2e-3  # of a rod's volume, B-Rep against mesh: tessellation (issue: 0.2 %)


class Rods(NamedTuple):
    """The solids of a network: keys and names (R), one compound, volumes (R,) of solids and of meshes, mm3."""

    keys: Tuple[str, ...]
    names: Tuple[str, ...]
    compound: Part.Shape
    volumes: np.ndarray
    mesh_volumes: np.ndarray


class Kept(NamedTuple):
    """One rod: its solid, the solid's volume and the mesh's, mm3."""

    solid: Part.Shape
    volume: float
    mesh_volume: float


class Network(OnDemand):
    """All rods of a wireframe as solids."""

    Type = "Trabecula::Network"
    KIND = "network"
    PROPERTIES = (
        *on_demand(True),
        result("Integer", "Rods", "Number of rods"),
        result("Integer", "Rebuilt", "Rods that the last recompute built or took anew"),
        result("Volume", "RodVolume", "Sum of the solids' volumes; overlaps count twice"),
        result("Volume", "MeshVolume", "Sum of the volumes of the rods' meshes: the independent route"),
        result("Float", "Difference", "Difference between both volumes, %"),
        result("Float", "LargestDifference", "Largest difference of one rod, %"),
        result("StringList", "RodKeys", "Hash of the numbers of each rod", hidden=True),
        result("StringList", "RodNames", "Names of the rods in the order of the solids", hidden=True),
        result("FloatList", "RodVolumes", "Volumes of the solids, mm^3", hidden=True),
        result("FloatList", "RodMeshVolumes", "Volumes of the rods' meshes, mm^3", hidden=True),
    )

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs: the wireframe's."""
        owner = wireframe_object(obj)
        return owner.Proxy.key(owner)

    def make(self, obj: Any, progress: Progress) -> Rods:
        """Build the rods that the object does not have."""
        owner = wireframe_object(obj)
        wireframe = owner.Proxy.wireframe(owner)
        return build(wireframe, owner.Proxy.parameters(owner).rods, kept_rods(obj), progress)

    def make_soon(self, obj: Any, progress: Progress) -> Optional[Rods]:
        """Build the rods if few are new and the wireframe is at hand."""
        owner = wireframe_object(obj)
        found = results.find(owner.Proxy.KIND, owner.Proxy.key(owner))
        if found is None:
            return None
        parameters, kept = owner.Proxy.parameters(owner).rods, kept_rods(obj)
        new = [key for key in rod_keys(found.wireframe, parameters) if key not in kept]
        return build(found.wireframe, parameters, kept, progress) if len(new) <= FEW else None

    def show(self, obj: Any, value: Rods) -> None:
        """Check the volumes and show the solids."""
        check(value)
        old = set(obj.RodKeys)
        obj.Rebuilt = sum(key not in old for key in value.keys)
        total, mesh_total = float(value.volumes.sum()), float(value.mesh_volumes.sum())
        obj.Rods, obj.RodVolume, obj.MeshVolume = len(value.keys), total, mesh_total
        obj.Difference = 100 * abs(total - mesh_total) / max(mesh_total, 1e-300)
        obj.LargestDifference = 100 * float(differences(value).max(initial=0.0))
        obj.RodKeys, obj.RodNames = list(value.keys), list(value.names)
        obj.RodVolumes, obj.RodMeshVolumes = value.volumes.tolist(), value.mesh_volumes.tolist()
        show_in_place(obj, "Shape", value.compound)

    def said(self, obj: Any) -> str:
        """Return rods and volume."""
        return f"{obj.Rods} rods, {obj.RodVolume.Value:.4g} mm^3 with overlaps"


def wireframe_object(obj: Any) -> Any:
    """Return the wireframe object of a network or a scaffold.

    Raises
    ------
    ParameterError
        If there is none.
    """
    if not is_a(obj.Wireframe, Wireframe):
        raise ParameterError(
            f"{obj.Label} must be linked to a wireframe, got {getattr(obj.Wireframe, 'Label', 'nothing')}"
        )
    return obj.Wireframe


def kept_rods(obj: Any) -> Dict[str, Kept]:
    """Return the solids that an object shows, with their volumes, by key; also after its file was opened again."""
    return rods_by_key(shown_rods(obj))


def shown_rods(obj: Any) -> Rods:
    """Return the rods that an object shows; where they stand in the envelope."""
    shape = obj.Shape.copy(False)
    shape.Placement = FreeCAD.Placement()
    names, volumes, mesh_volumes = tuple(obj.RodNames), np.array(obj.RodVolumes), np.array(obj.RodMeshVolumes)
    return Rods(tuple(obj.RodKeys), names, shape, volumes, mesh_volumes)


def rods_by_key(rods: Rods) -> Dict[str, Kept]:
    """Return rods one by one; none if their numbers do not fit together."""
    columns = rods.compound.Solids, rods.volumes.tolist(), rods.mesh_volumes.tolist()
    if any(len(column) != len(rods.keys) for column in columns):
        return {}
    return {key: Kept(*row) for key, row in zip(rods.keys, zip(*columns))}


def build(
    wireframe: core.Wireframe,
    parameters: RodParameters,
    kept: Optional[Dict[str, Kept]] = None,
    progress: Progress = silent,
) -> Rods:
    """Return the solids of all rods of a wireframe.

    Parameters
    ----------
    wireframe : Wireframe
    parameters : RodParameters
    kept : dict, optional
        Rods by key, which are not built again.
    progress : callable

    Raises
    ------
    KernelError
        If a rod cannot be built.
    """
    keys, kept = rod_keys(wireframe, parameters), kept or {}
    missing = [k for k, key in enumerate(keys) if key not in kept]
    rods = [kept.get(key) for key in keys]
    some = core.without(wireframe, np.array(missing, int))
    for k, rod in zip(missing, measured_rods(some, parameters, progress)):
        rods[k] = Kept(*rod)
    solids, volumes, others = zip(*rods) if rods else ((), (), ())
    return Rods(tuple(keys), wireframe.names, Part.makeCompound(list(solids)), np.array(volumes), np.array(others))


class RodFacts(NamedTuple):
    """What is known of one rod: number, name, names of its two sites, sizes there (mm), its volume (mm3)."""

    number: int
    name: str
    sites: Tuple[str, str]
    sizes: Tuple[float, float]
    volume: float


def rod_at(obj: Any, face: str) -> RodFacts:
    """Return the rod of a network object to which a face belongs.

    Parameters
    ----------
    obj : document object
        A network.
    face : str
        As FreeCAD names it, e.g. from a selection.

    Raises
    ------
    ParameterError
        If there is no such face.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> network = make.make_network(make.make_design(FreeCAD.newDocument(), preset("case1")).wireframe)
    >>> make.rod_at(network, "Face1").sites
    ('Face1.1.1', 'Face2.1.1')
    """
    ends = np.cumsum([len(solid.Faces) for solid in given_object(obj, Network).Shape.Solids])
    given_value(face, str)
    number = int(face[4:]) if face.startswith("Face") and face[4:].isdigit() else 0
    count = int(ends[-1]) if len(ends) else 0
    if not 1 <= number <= count:
        raise ParameterError(f"a face of {obj.Label} must be one of Face1..Face{count}, got {face!r}")
    k = int(np.searchsorted(ends, number))
    return rod_facts(obj, k)


def rod_facts(obj: Any, number: int) -> RodFacts:
    """Return what is known of the rod with a number, from 0, of a network object."""
    wireframe = wireframe_object(obj).Proxy.wireframe(obj.Wireframe)
    name = obj.RodNames[number]
    k = wireframe.names.index(name)
    coupling = wireframe_object(obj).Proxy.parameters(obj.Wireframe).couplings[int(wireframe.coupling[k])]
    first, second = wireframe.site_numbers[k].tolist()
    sites = (wireframe.sites[coupling.first].names[first], wireframe.sites[coupling.second].names[second])
    sizes = (float(wireframe.ends.first.size[k]), float(wireframe.ends.second.size[k]))
    return RodFacts(number, name, sites, sizes, float(obj.RodVolumes[number]))


def rod_keys(wireframe: core.Wireframe, parameters: RodParameters) -> List[str]:
    """Return a hash for each rod of all that its solid depends on."""
    more, keys = f" {parameters.stations}", rounded_keys(wireframe)
    return [hashlib.blake2b((key + more).encode(), digest_size=12).hexdigest() for key in keys]


def differences(rods: Rods) -> np.ndarray:
    """Return the relative differences (R,) between the volumes of solids and of meshes."""
    return np.abs(rods.volumes - rods.mesh_volumes) / np.maximum(rods.mesh_volumes, 1e-300)


def check(rods: Rods) -> None:
    """Refuse solids whose volumes the meshes contradict.

    Raises
    ------
    KernelError
        With the name of the worst rod.
    """
    off = differences(rods)
    if (off > MOST_DIFFERENCE).any():
        worst = int(off.argmax())
        raise KernelError(
            f"solid and mesh of a rod must agree within {100 * MOST_DIFFERENCE:g} % of its volume, got "
            f"{rods.volumes[worst]:.6g} and {rods.mesh_volumes[worst]:.6g} mm^3 for rod {rods.names[worst]} and "
            f"{int((off > MOST_DIFFERENCE).sum())} such rods in all"
        )
