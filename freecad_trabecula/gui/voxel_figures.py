# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a voxel design as rows of a table, read from the properties of its object."""

from __future__ import annotations

from typing import Any, List

import FreeCAD

from .figures import Figure, number_with_unit
from .language import local_number

translate = FreeCAD.Qt.translate


def figures_of(obj: Any) -> List[Figure]:
    """Return the figures of a voxel design; none if it has not been computed."""
    if not obj.ResultKey:
        return []
    layers = f"{obj.LayersX} × {obj.LayersY} × {obj.LayersZ}"
    rows = [
        Figure(translate("Trabecula", "Layers along X, Y, Z"), layers, "voxels.layers"),
        Figure(
            translate("Trabecula", "Exact on every layer of the three axes"),
            translate("Trabecula", "yes") if obj.Exact else translate("Trabecula", "no"),
            "voxels.made",
        ),
        Figure(translate("Trabecula", "Solid voxels"), local_number(obj.Voxels, ","), "voxels.voxels"),
        Figure(
            translate("Trabecula", "Volume of the voxels"),
            number_with_unit(obj.VoxelVolume.Value, ".4f", "mm³"),
            "voxels.volume",
        ),
        Figure(
            translate("Trabecula", "Volume of the mesh"),
            number_with_unit(obj.MeshVolume.Value, ".4f", "mm³"),
            "voxels.volume",
        ),
        Figure(
            translate("Trabecula", "Bone fraction"),
            number_with_unit(obj.BoneFraction, ".2f", "%"),
            "voxels.bone_fraction",
        ),
        Figure(translate("Trabecula", "Connected parts"), str(obj.Components), "voxels.components"),
        Figure(
            translate("Trabecula", "Share of the largest part"),
            number_with_unit(obj.LargestFraction, ".3f", "%"),
            "voxels.largest_fraction",
        ),
        Figure(translate("Trabecula", "Closed cavities"), str(obj.ClosedCavities), "voxels.closed_cavities"),
        Figure(
            translate("Trabecula", "Contacts by an edge alone"),
            local_number(obj.EdgeContacts, ","),
            "voxels.edge_contacts",
        ),
        Figure(
            translate("Trabecula", "Contacts by a corner alone"),
            local_number(obj.CornerContacts, ","),
            "voxels.corner_contacts",
        ),
    ]
    if len(obj.TrabeculaDeviation):
        words = " / ".join(local_number(value, ".2f") for value in obj.TrabeculaDeviation)
        name = translate("Trabecula", "Mean deviation of the trabeculae, %")
        rows.append(Figure(name, words, "voxels.trabecula_deviation"))
    rows.append(Figure(translate("Trabecula", "Time"), number_with_unit(obj.Seconds, ".1f", "s"), "voxels.seconds"))
    return rows
