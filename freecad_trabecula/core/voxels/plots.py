# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a voxel design (matplotlib, which is optional): counts as Fig. 6.13 to 6.15, tables, layers as Fig. 6.16."""

from __future__ import annotations

import math
from typing import Any, Dict, Sequence

import numpy as np

from ..analysis.plots import COLOURS, new_figure
from .design import VoxelDesign
from .targets import AXES
from .trabeculae import trabecula_counts
from .verification import layer_counts

_LAYERS_SHOWN = 6


def design_figures(design: VoxelDesign) -> Dict[str, Any]:
    """Return all figures of a design by the names of their files, without suffix.

    Raises
    ------
    DependencyError
        If matplotlib is missing.
    """
    return {
        "layer_counts": counts_figure(design),
        "trabeculae": trabeculae_figure(design),
        "tables": tables_figure(design),
        "layers": layers_figure(design),
    }


def counts_figure(design: VoxelDesign) -> Any:
    """Return real sliced areas, targets and the design's own counts along the three axes (Fig. 6.13 to 6.15)."""
    figure = new_figure(9, 9)
    targets = design.targets
    counts = layer_counts(design.voxels)
    for k, axes in enumerate(figure.subplots(3, 1)):
        across = math.prod(edge for a, edge in enumerate(targets.voxel) if a != k)
        place = targets.origin[k] + (np.arange(targets.layers[k]) + 0.5) * targets.voxel[k]
        if targets.areas is not None:
            axes.plot(place, targets.areas[k], color=COLOURS[1], label="real", linewidth=3, alpha=0.5)
        axes.step(place, targets.counts[k] * across, where="mid", color=COLOURS[0], label="target")
        axes.plot(place, counts[k] * across, ".", color=COLOURS[6], label="design", markersize=2)
        axes.set(xlabel=f"{AXES[k].upper()}, mm", ylabel="sliced area, mm²")
        axes.set_ylim(bottom=0)
        axes.legend(loc="lower right")
    return figure


def trabeculae_figure(design: VoxelDesign) -> Any:
    """Return the number of trabeculae per layer, the design's and those asked for or the sample's own."""
    figure = new_figure(9, 9)
    wanted = design.targets.trabeculae
    label = "asked for"
    if wanted is None and design.targets.sample is not None:
        wanted, label = trabecula_counts(design.targets.sample), "sample"
    for k, (axes, counts) in enumerate(zip(figure.subplots(3, 1), trabecula_counts(design.voxels))):
        if wanted is not None:
            axes.plot(wanted[k], color=COLOURS[1], label=label, linewidth=3, alpha=0.5)
        axes.plot(counts, color=COLOURS[0], label="design")
        axes.set(xlabel=f"layer along {AXES[k].upper()}", ylabel="trabeculae")
        axes.set_ylim(bottom=0)
        axes.legend(loc="lower right")
    return figure


def tables_figure(design: VoxelDesign) -> Any:
    """Return both tables as pictures, layer 0 along Z at the bottom (Fig. 6.6)."""
    figure = new_figure(10, 5)
    for axes, name, table, axis in zip(figure.subplots(1, 2), ("alpha", "beta"), (design.alpha, design.beta), "XY"):
        picture = axes.imshow(table.T, origin="lower", cmap="viridis", interpolation="nearest", aspect="auto")
        axes.set(title=name, xlabel=f"layer along {axis}", ylabel="layer along Z")
        figure.colorbar(picture, ax=axes, label="voxels")
    return figure


def layers_figure(design: VoxelDesign, layers: Sequence[int] = ()) -> Any:
    """Return layers along Z, the sample's above the design's where there is one.

    Parameters
    ----------
    design : VoxelDesign
    layers : sequence of int
        Which; none means six over the whole height.
    """
    count = len(design.voxels)
    layers = layers or np.unique(np.linspace(0, count - 1, min(_LAYERS_SHOWN, count)).round().astype(int)).tolist()
    sample = design.targets.sample
    rows = [("sample", sample)] if sample is not None else []
    rows.append((design.parameters.strategy, design.voxels))
    figure = new_figure(2.2 * len(layers) + 0.4, 2.4 * len(rows) + 0.2)
    for line, (name, voxels) in zip(figure.subplots(len(rows), len(layers), squeeze=False), rows):
        for axes, layer in zip(line, layers):
            axes.imshow(voxels[layer], origin="lower", cmap="binary", vmin=0, vmax=1, interpolation="nearest")
            axes.set(xticks=[], yticks=[], title=f"{name}, layer {layer}")
    return figure
