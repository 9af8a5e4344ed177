# SPDX-License-Identifier: LGPL-2.1-or-later
"""A voxel design as layers and diagrams: what is seen of one layer, and target and design along an axis. No window."""

from __future__ import annotations

import math
from typing import Any, List, Optional, Tuple

import FreeCAD
import numpy as np

from ..core.voxels.design import VoxelDesign
from ..core.voxels.targets import AXES
from ..core.voxels.trabeculae import trabecula_counts
from ..core.voxels.verification import layer_counts
from .chart import Curve, Diagram
from .preferences import preferred_colour

translate = FreeCAD.Qt.translate
#: Preferences of the colours of sample and design, in pictures and in diagrams.
SAMPLE, DESIGN = "ColourSample", "ColourDesign"
#: Kinds of diagrams: key, title of the tab.
KINDS = (
    ("voxels", translate("Trabecula", "Voxels")),
    ("areas", translate("Trabecula", "Areas")),
    ("trabeculae", translate("Trabecula", "Trabeculae")),
)


#: Which numbers each kind of diagram shows.
KEYS = {
    "voxels": ("voxels.made", "voxels.asked"),
    "areas": ("slices.sliced_area", "voxels.asked"),
    "trabeculae": ("voxels.trabeculae",),
}


def layer_of(voxels: np.ndarray, axis: int, number: int) -> np.ndarray:
    """Return a layer across X, Y or Z (0, 1, 2) of voxels (P, M, N): rows along the later of the other axes.

    Examples
    --------
    >>> [layer_of(np.zeros((2, 3, 4)), axis, 0).shape for axis in range(3)]
    [(2, 3), (2, 4), (3, 4)]
    """
    return np.take(voxels, number, axis=2 - axis)


def pixel_of(voxel: Tuple[float, float, float], axis: int) -> Tuple[float, float]:
    """Return width and height of a voxel in the picture of a layer, mm.

    Examples
    --------
    >>> [pixel_of((1, 2, 3), axis) for axis in range(3)]
    [(2, 3), (1, 3), (1, 2)]
    """
    return tuple(edge for k, edge in enumerate(voxel) if k != axis)


class Layers:
    """What the dock tells of a design; counted once.

    Parameters
    ----------
    design : VoxelDesign
    """

    def __init__(self, design: VoxelDesign) -> None:
        self.design = design
        self.made = layer_counts(design.voxels)
        self.sample_made = None if design.targets.sample is None else layer_counts(design.targets.sample)
        self._trabeculae: Optional[Tuple[Any, Any]] = None

    def middles(self, axis: int) -> np.ndarray:
        """Return where the layers' middles are, mm."""
        targets = self.design.targets
        return targets.origin[axis] + (np.arange(targets.layers[axis]) + 0.5) * targets.voxel[axis]

    def words(self, axis: int, number: int) -> Tuple[str, str]:
        """Return what stands over the sample's layer and over the design's."""
        asked, made = int(self.design.targets.counts[axis][number]), int(self.made[axis][number])
        sample = translate("Trabecula", "sample: asks for {} voxels").format(asked)
        if self.sample_made is not None:
            centres = int(self.sample_made[axis][number])
            sample = translate("Trabecula", "sample: {} asked for, {} by centres").format(asked, centres)
        return sample, translate("Trabecula", "design: {} made, {} asked for").format(made, asked)

    def diagram(self, kind: str, axis: int) -> Diagram:
        """Return a diagram of target and design along an axis; ``kind`` is a key of ``KINDS``."""
        across = translate("Trabecula", "co-ordinate along {}, mm").format(AXES[axis].upper())
        x, targets = self.middles(axis), self.design.targets
        asked = translate("Trabecula", "asked for")
        made = translate("Trabecula", "design")
        if kind == "voxels":
            curves = [Curve(asked, x, targets.counts[axis], preferred_colour(SAMPLE)),
                      Curve(made, x, self.made[axis], preferred_colour(DESIGN), marks=True)]  # fmt: skip
            return Diagram(across, translate("Trabecula", "voxels in the layer"), curves)
        if kind == "areas":
            face = math.prod(edge for k, edge in enumerate(targets.voxel) if k != axis)
            curves = [Curve(made, x, face * self.made[axis], preferred_colour(DESIGN), marks=True)]
            if targets.areas is not None:
                curves.insert(
                    0, Curve(translate("Trabecula", "sample"), x, targets.areas[axis], preferred_colour(SAMPLE))
                )
            return Diagram(across, translate("Trabecula", "sliced area, mm²"), curves)
        return Diagram(across, translate("Trabecula", "number of trabeculae"), self._trabecula_curves(axis, x))

    def has(self, kind: str) -> bool:
        """Return whether what a kind of diagram shows has been counted."""
        return kind != "trabeculae" or self._trabeculae is not None

    def count_trabeculae(self) -> None:
        """Count trabeculae, once; any thread.

        Raises
        ------
        DependencyError
            If scipy is missing.
        """
        if self._trabeculae is None:
            targets = self.design.targets
            wanted = targets.trabeculae
            if wanted is None and targets.sample is not None:
                wanted = trabecula_counts(targets.sample)
            self._trabeculae = wanted, trabecula_counts(self.design.voxels)

    def _trabecula_curves(self, axis: int, x: np.ndarray) -> List[Curve]:
        self.count_trabeculae()
        wanted, counts = self._trabeculae
        curves = [Curve(translate("Trabecula", "design"), x, counts[axis], preferred_colour(DESIGN))]
        if wanted is not None:
            is_target = self.design.targets.trabeculae is not None
            words = translate("Trabecula", "asked for") if is_target else translate("Trabecula", "sample")
            curves.insert(0, Curve(words, x, np.asarray(wanted[axis]), preferred_colour(SAMPLE)))
        return curves
