# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of voxel designs."""

from __future__ import annotations

from typing import Any

from ..features.relations import type_of
from . import panels
from .command import Command, PanelCommand, active_document, document_or_new, selected_objects
from .layer_dialog import ask_and_make
from .voxel_dock import KIND, show_layers, voxel_dock
from .voxel_export import export_voxels
from .voxel_panel import is_sample


def _design() -> Any:
    """The voxel design that is selected, else the document's latest; None if there is none."""
    chosen = [obj for obj in selected_objects() if type_of(obj) == KIND]
    every = [obj for obj in active_document().Objects if type_of(obj) == KIND] if active_document() else []
    return (chosen or every[-1:] or [None])[0]


class DesignVoxels(PanelCommand):
    """Opens the panel of voxel designs: for the selected design, or for a new one of the selected sample."""

    NAME, ICON, NEEDS = "Trabecula_Voxels", "Trabecula_voxels", ""
    TEXT, TIP = "Design voxels", "Design voxels with the sliced areas of a body or an analysis along X, Y and Z"

    def run(self, index: int) -> None:
        """Open the panel."""
        document, chosen = document_or_new(), selected_objects()
        design = next((obj for obj in chosen if type_of(obj) == KIND), None)
        panels.open_voxels(document, design, next((obj for obj in chosen if is_sample(obj)), None))


class ShowLayers(Command):
    """Shows the dock of voxel layers."""

    NAME, ICON, NEEDS = "Trabecula_VoxelLayers", "Trabecula_layers", ""
    TEXT, TIP = "Voxel layers", "Show or hide the layers of sample and design side by side, with their counts"

    def run(self, index: int) -> None:
        """Show or hide it."""
        if voxel_dock().isVisible():
            voxel_dock().hide()
        else:
            show_layers(_design())


class OfDesign(Command):
    """A command that needs a voxel design."""

    NEEDS = "document"

    def IsActive(self) -> bool:
        """Return whether there is one."""
        return super().IsActive() and _design() is not None


class LayerShapes(OfDesign):
    """Makes wires or solids of layers."""

    NAME, ICON = "Trabecula_LayerShapes", "Trabecula_layer_shapes"
    TEXT, TIP = "Layer shapes", "Outlines of a range of layers as wires, or the layers as solids, after an estimate"

    def run(self, index: int) -> None:
        """Ask for the layers and make them."""
        ask_and_make(_design())


class ExportVoxels(OfDesign):
    """Writes a voxel design into files."""

    NAME, ICON = "Trabecula_VoxelExport", "Trabecula_voxel_export"
    TEXT, TIP = "Export voxels", "Write mesh, voxels or images of the layers; sizes are shown first"

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        export_voxels(_design())


#: In the order of toolbar and menu.
COMMANDS = (DesignVoxels, ShowLayers, LayerShapes, ExportVoxels)
