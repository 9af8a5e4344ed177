# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of voxel designs."""

from __future__ import annotations

from typing import Any

from ..features.relations import type_of
from . import panels
from .command import Command, PanelCommand, in_document, objects_of, selected_objects
from .layer_dialog import ask_and_make
from .propagation_dialog import watch_layer
from .table_dialog import ask_for_tables
from .voxel_dock import KIND, show_layers, voxel_dock
from .voxel_export import export_voxels
from .voxel_panel import design_with_tables, is_sample


def _design() -> Any:
    """The voxel design that is selected, else the document's latest; None if there is none."""
    chosen = [obj for obj in selected_objects() if type_of(obj) == KIND]
    return (chosen or objects_of(KIND)[-1:] or [None])[0]


class DesignVoxels(PanelCommand):
    """Opens the panel of voxel designs: for the selected design, or for a new one of the selected sample."""

    NAME, ICON = "Trabecula_Voxels", "Trabecula_voxels"
    TEXT, KEYS = "Design voxels", "Y, V"
    TIP = (
        "Design voxels with the sliced areas of a sample along X, Y and Z. Select a body, an analysis or a voxel design"
    )

    def run(self, index: int) -> None:
        """Open the panel."""
        chosen = selected_objects()
        design = next((obj for obj in chosen if type_of(obj) == KIND), None)
        sample = next((obj for obj in chosen if is_sample(obj)), None)
        in_document(lambda document: panels.open_voxels(document, design, sample))


class ShowLayers(Command):
    """Shows the dock of voxel layers."""

    NAME, ICON = "Trabecula_VoxelLayers", "Trabecula_layers"
    TEXT, KEYS = "Voxel layers", "Y, L"
    TIP = (
        "Show or hide the layers of sample and design with their counts. Select a voxel design, or nothing for the last"
    )

    def run(self, index: int) -> None:
        """Show or hide it."""
        if voxel_dock().isVisible():
            voxel_dock().hide()
        else:
            show_layers(_design())


class ShowTables(Command):
    """Shows the tables of a voxel design."""

    NAME, ICON, NEEDS = "Trabecula_VoxelTables", "Trabecula_tables", ("voxels",)
    TEXT, KEYS = "Tables", "Y, T"
    TIP = "See, edit, read and write the tables alpha and beta. Needs a voxel design; select one of several"

    def run(self, index: int) -> None:
        """Show them; design with what was edited."""
        obj = _design()
        tables = ask_for_tables(obj)
        if tables is not None:
            design_with_tables(obj, tables)


class WatchLayer(Command):
    """Shows how a layer is filled."""

    NAME, ICON = "Trabecula_WatchLayer", "Trabecula_watch_layer"
    TEXT, KEYS = "Watch a layer", "Y, E"
    TIP = "Watch how a layer is filled, step by step. Select a voxel design for its layers, or nothing for own numbers"

    def run(self, index: int) -> None:
        """Open the dialog."""
        watch_layer(_design())


class LayerShapes(Command):
    """Makes wires or solids of layers."""

    NAME, ICON, NEEDS = "Trabecula_LayerShapes", "Trabecula_layer_shapes", ("voxels",)
    TEXT, KEYS = "Layer shapes", "Y, H"
    TIP = "Make wires or solids of layers, after an estimate. Needs a voxel design; select one of several"

    def run(self, index: int) -> None:
        """Ask for the layers and make them."""
        ask_and_make(_design())


class ExportVoxels(Command):
    """Writes a voxel design into files."""

    NAME, ICON, NEEDS = "Trabecula_VoxelExport", "Trabecula_voxel_export", ("voxels",)
    TEXT, KEYS = "Export voxels", "Y, W"
    TIP = "Write mesh, voxels or images of layers; sizes are shown first. Needs a voxel design; select one of several"

    def run(self, index: int) -> None:
        """Ask for a file and write it."""
        export_voxels(_design())


#: In the order of toolbar and menu.
COMMANDS = (DesignVoxels, ShowLayers, ShowTables, WatchLayer, LayerShapes, ExportVoxels)
