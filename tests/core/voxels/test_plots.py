# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a design: what they draw is the design's own numbers."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("matplotlib", reason="matplotlib IS NOT INSTALLED: plots are NOT tested")

from freecad_trabecula.core.analysis.plots import save_figure
from freecad_trabecula.core.voxels.design import VoxelDesign
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.plots import counts_figure, design_figures, layers_figure
from freecad_trabecula.core.voxels.targets import targets_of_voxels

VOXELS = np.indices((7, 6, 5)).sum(0) % 3 == 0
DESIGN = VoxelDesign(VOXELS, targets_of_voxels(VOXELS, (0.1, 0.2, 0.3)), VoxelParameters(strategy="sequential"))


def test_every_figure_is_drawn_and_written(tmp_path):
    for name, figure in design_figures(DESIGN).items():
        save_figure(figure, tmp_path / f"{name}.png", "png")
        assert (tmp_path / f"{name}.png").read_bytes()[:4] == b"\x89PNG"


def test_areas_are_counts_times_the_cross_section_at_the_layers_middles():
    lines = counts_figure(DESIGN).axes[0].get_lines()
    target, design = lines[0], lines[1]
    assert target.get_xdata() == pytest.approx((np.arange(5) + 0.5) * 0.1)
    assert design.get_ydata() == pytest.approx(VOXELS.sum((0, 1)) * 0.06)
    assert target.get_ydata() == pytest.approx(design.get_ydata())


def test_sample_and_design_stand_over_each_other_layer_by_layer():
    figure = layers_figure(DESIGN, [0, 3])
    assert len(figure.axes) == 4
    assert [axes.get_title() for axes in figure.axes] == [
        *("sample, layer 0", "sample, layer 3", "sequential, layer 0", "sequential, layer 3"),
    ]
    assert (figure.axes[3].get_images()[0].get_array() == VOXELS[3]).all()
