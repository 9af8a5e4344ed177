# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scaffold in the document as a solid, for STEP: made by the B-Rep engine, on demand only."""

from __future__ import annotations

from typing import Any

from ..core.parameters import ScaffoldParameters
from ..core.progress import Progress, silent
from ..errors import KernelError
from ..geometry.scaffold_solids import SolidCut, cut_solid
from . import results
from .base import read_parameters
from .feature import result, show_in_place
from .network import wireframe_object
from .on_demand import OnDemand, on_demand
from .wireframe import Inputs, made


class SolidScaffold(OnDemand):
    """Envelope less channels, as a solid; only a complete one is shown."""

    Type = "Trabecula::SolidScaffold"
    KIND = "solid"
    PARAMETERS = (ScaffoldParameters,)
    PROPERTIES = (
        *on_demand(False),
        result("Integer", "RodsCut", "Rods that were cut away"),
        result("Integer", "RodsWanted", "Rods of the wireframe"),
        result("Bool", "Complete", "Whether all rods were cut"),
        result("String", "Reason", "Why it stopped, if it did"),
        result("Float", "Porosity", "Share of the envelope that is not scaffold, % (Eq. 2.2)"),
        result("Volume", "ScaffoldVolume", "Volume of the scaffold as it is shown"),
        result("Volume", "SolidVolume", "Volume of the solid, loose pieces included"),
        result("Volume", "MeshVolume", "Volume of the same cut by the mesh engine: the independent route"),
        result("Float", "Difference", "Difference between both volumes, %"),
        result("Float", "Seconds", "Time that it took, s"),
    )

    def key(self, obj: Any) -> str:
        """Return the key of the present inputs."""
        owner = wireframe_object(obj)
        return solid_key(owner.Proxy.key(owner), read_parameters(obj, ScaffoldParameters))

    def make(self, obj: Any, progress: Progress) -> SolidCut:
        """Cut the rods away."""
        owner = wireframe_object(obj)
        return solid_of(owner.Proxy.inputs(owner), read_parameters(obj, ScaffoldParameters), progress)

    def show(self, obj: Any, value: SolidCut) -> None:
        """Show how far it came, and the solid if it is complete."""
        obj.RodsCut, obj.RodsWanted, obj.Complete = value.rods, value.wanted, value.complete
        obj.Reason, obj.Seconds = value.reason, value.seconds
        obj.SolidVolume, obj.MeshVolume = value.volume, value.mesh_volume
        obj.Difference = 100 * abs(value.volume / value.mesh_volume - 1)
        if not value.complete:
            raise KernelError(
                f"a solid scaffold must have all its channels: the B-Rep engine came to {value.rods} of {value.wanted} "
                f"rods, then {value.reason}; the mesh scaffold stands"
            )
        obj.ScaffoldVolume = value.shape.Volume
        obj.Porosity = 100 * (1 - value.shape.Volume / wireframe_object(obj).Envelope.Shape.Volume)
        show_in_place(obj, "Shape", value.shape)

    def said(self, obj: Any) -> str:
        """Return the number of rods and the double entry."""
        return f"porosity {obj.Porosity:.2f} %, {obj.RodsCut} rods cut; solid and mesh differ by {obj.Difference:.2g} %"


def solid_key(wireframe: str, parameters: ScaffoldParameters) -> str:
    """Return the key of a solid scaffold of the wireframe with that key."""
    return results.key_of("solid", wireframe, parameters)


def solid_of(inputs: Inputs, parameters: ScaffoldParameters, progress: Progress = silent) -> SolidCut:
    """Return the solid scaffold of a wireframe's inputs, as far as it comes."""
    return cut_solid(inputs.envelope, made(inputs), inputs.parameters.rods, parameters, progress)
