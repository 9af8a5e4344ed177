# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scaffold in the document, as a mesh: what the channels leave of the envelope; and the other bodies of the cut."""

from __future__ import annotations

import time
from typing import Any, Dict, NamedTuple, Optional, Tuple

import Mesh

from ..core.bodies import Bodies, Check
from ..core.meshes import join, printable
from ..core.parameters import ScaffoldParameters
from ..core.progress import Progress, silent
from ..errors import KernelError, ParameterError
from ..geometry.cutting import make_bodies
from ..geometry.mesh_objects import mesh_object
from . import results
from .arguments import given_object
from .base import read_parameters
from .feature import UP_TO_DATE, Feature, Property, is_a, result, show_in_place
from .network import wireframe_object
from .on_demand import OUT_OF_DATE, OnDemand, on_demand
from .wireframe import Inputs, made

#: What the other bodies of a scaffold are.
ROLES = ("channels", "loose", "voids")


class Cut(NamedTuple):
    """A scaffold with all that is told about it.

    Attributes
    ----------
    figures : dict
        Values of the read-only properties, by name; volumes mm3, porosities %.
    checks : tuple of Check
    meshes : dict of Mesh.Mesh
        ``scaffold`` and ``ROLES``.
    bodies : Bodies or None
        Meshes in double precision; None if the scaffold was cut in another process.
    """

    figures: Dict[str, Any]
    checks: Tuple[Check, ...]
    meshes: Dict[str, Mesh.Mesh]
    bodies: Optional[Bodies] = None


class Scaffold(OnDemand):
    """Envelope less channels, as a closed mesh."""

    Type = "Trabecula::Scaffold"
    KIND = "scaffold"
    PARAMETERS = (ScaffoldParameters,)
    PROPERTIES = (
        *on_demand(False),
        result("String", "EngineUsed", "Engine that cut the channels"),
        result("String", "Reason", "Why this engine, and what it was expected to take"),
        result("Float", "Porosity", "Share of the envelope that is not scaffold, % (Eq. 2.2)"),
        result("Float", "UnionPorosity", "Share of the envelope inside the rods, nothing taken away or filled, %"),
        result("Float", "SumPorosity", "Plain sum of the rods' volumes over the envelope's, %"),
        result("Volume", "EnvelopeVolume", "Volume of the envelope"),
        result("Volume", "AddedVolume", "Volume of the layers outside of the envelope"),
        result("Volume", "ScaffoldVolume", "Volume of the scaffold"),
        result("Volume", "ChannelVolume", "Volume of the channels"),
        result("Volume", "LooseVolume", "Volume of the pieces that channels cut off all round"),
        result("Volume", "VoidVolume", "Volume of the voids that no opening reaches"),
        result("Integer", "LoosePieces", "Pieces that channels cut off all round"),
        result("Integer", "Voids", "Voids that no opening reaches"),
        result("Integer", "Pieces", "Connected pieces of the scaffold"),
        result("Integer", "Openings", "Connected pieces of the channels"),
        result("Bool", "Watertight", "Whether scaffold and channels are closed"),
        result("Float", "Seconds", "Time that it took, s"),
        result("StringList", "Checks", "What was worked out twice, by independent routes, and how far the two differ"),
        result("StringList", "Notes", "What is to be known"),
    )

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs."""
        owner = wireframe_object(obj)
        return scaffold_key(owner.Proxy.key(owner), read_parameters(obj, ScaffoldParameters))

    def make(self, obj: Any, progress: Progress) -> Cut:
        """Cut the channels."""
        owner = wireframe_object(obj)
        return cut(owner.Proxy.inputs(owner), read_parameters(obj, ScaffoldParameters), progress)

    def show(self, obj: Any, value: Cut) -> None:
        """Check the double entry and show the scaffold."""
        failed = [str(check) for check in value.checks if not check.ok]
        if failed:
            raise KernelError(f"two independent routes must agree, but they do not: {'; '.join(failed)}")
        for name, figure in value.figures.items():
            setattr(obj, name, figure)
        obj.Checks = [str(check) for check in value.checks]
        show_in_place(obj, "Mesh", value.meshes["scaffold"])

    def said(self, obj: Any) -> str:
        """Return the porosity and what else is to be known."""
        return "; ".join([f"porosity {obj.Porosity:.2f} % by the {obj.EngineUsed} engine", *obj.Notes])


class Body(Feature):
    """The channels of a scaffold, its loose pieces, or its voids."""

    Type = "Trabecula::Body"
    PROPERTIES = (
        Property("App::PropertyLink", "Scaffold", "Base", "The scaffold of which this is a part"),
        Property("App::PropertyEnumeration", "Role", "Base", "What this is of the scaffold", 0, list(ROLES)),
        result("Integer", "Facets", "Number of triangles"),
        result("String", "ResultKey", "Key of the inputs of the result", hidden=True),
    )

    def compute(self, obj: Any) -> str:
        """Take the mesh that the scaffold has made; an older one stays until there is a newer."""
        if not is_a(obj.Scaffold, Scaffold):
            found = getattr(obj.Scaffold, "Label", "nothing")
            raise ParameterError(f"{obj.Label} must be linked to a scaffold, got {found}")
        key = f"{obj.Scaffold.ResultKey} {obj.Role}"
        value = results.find("scaffold", obj.Scaffold.ResultKey)
        if value is not None:
            show_in_place(obj, "Mesh", value.meshes[obj.Role])
            obj.Facets, obj.ResultKey = obj.Mesh.CountFacets, key
        return UP_TO_DATE if obj.Scaffold.UpToDate and obj.ResultKey == key else OUT_OF_DATE


def scaffold_key(wireframe: str, parameters: ScaffoldParameters) -> str:
    """Return the key of a scaffold of the wireframe with that key."""
    return results.key_of("scaffold", wireframe, parameters)


def cut(inputs: Inputs, parameters: ScaffoldParameters, progress: Progress = silent) -> Cut:
    """Return the scaffold of a wireframe's inputs.

    Raises
    ------
    TrabeculaError
        If the engine cannot make it.
    """
    started = time.perf_counter()
    bodies = make_bodies(inputs.parameters, made(inputs), inputs.envelope, inputs.faces, parameters, progress)
    meshes = {
        "scaffold": bodies.scaffold,
        "channels": bodies.channels,
        "loose": join(list(bodies.loose)),
        "voids": join(list(bodies.voids)),
    }
    shown = {name: mesh_object(printable(mesh)) for name, mesh in meshes.items()}
    return Cut(figures_of(bodies, time.perf_counter() - started), bodies.checks, shown, bodies)


def bodies_of(scaffold: Any) -> Bodies:
    """Return the bodies of a scaffold object in double precision, cut again if they are not at hand.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> scaffold = make.make_scaffold(make.make_design(FreeCAD.newDocument(), preset("case1")).wireframe)
    >>> abs(make.bodies_of(scaffold).parts.scaffold_volume - scaffold.ScaffoldVolume.Value) < 1e-9
    True
    """
    key = given_object(scaffold, Scaffold).Proxy.key(scaffold)
    value = results.find(Scaffold.KIND, key)
    if value is None or value.bodies is None:
        value = results.keep(Scaffold.KIND, key, scaffold.Proxy.make(scaffold, silent))
    return value.bodies


def figures_of(bodies: Bodies, seconds: float) -> Dict[str, Any]:
    """Return the values of the read-only properties of a scaffold."""
    parts = bodies.parts
    return {
        "EngineUsed": bodies.engine,
        "Reason": bodies.reason,
        "Porosity": 100 * bodies.porosity,
        "UnionPorosity": 100 * bodies.union_porosity,
        "SumPorosity": 100 * bodies.sum_porosity,
        "EnvelopeVolume": float(bodies.envelope_volume),
        "AddedVolume": float(bodies.added_volume),
        "ScaffoldVolume": float(parts.scaffold_volume),
        "ChannelVolume": float(parts.channel_volume),
        "LooseVolume": bodies.loose_volume,
        "VoidVolume": bodies.void_volume,
        "LoosePieces": len(parts.loose),
        "Voids": len(parts.void_volumes),
        "Pieces": int(parts.pieces),
        "Openings": int(parts.openings),
        "Watertight": bodies.watertight,
        "Seconds": seconds,
        "Notes": list(bodies.notes),
    }
