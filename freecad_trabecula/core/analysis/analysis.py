# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole analysis of a body: its slices along each axis, measured; what is said of it in sum."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any, Dict, Optional, Tuple

import numpy as np

from ..progress import Progress, part, silent
from .branches import Branches, trace_branches
from .contours import ContourMeasures, Contours, contour_measures
from .neighbours import neighbours
from .parameters import SliceParameters, plane_heights
from .profiles import Profile, ProfileSummary, make_profile, summarise
from .repair import Repairs, mend
from .slices import Placed, placed, slice_contours, sliced_areas
from .soundness import MeshFacts, mesh_facts
from .triangles import Soup


@dataclass(frozen=True)
class Analysis:
    """A body and the profiles along its axes.

    Attributes
    ----------
    name, unit : str
        Where the triangles are from, and what is known of their unit.
    parameters : SliceParameters
    box : ndarray of shape (2, 3), mm
        Lowest and highest co-ordinates of the body.
    facts : MeshFacts
        What is right and wrong with the triangles.
    profiles : dict of str to Profile
    measures : dict of str to ContourMeasures
        By the names of the axes.
    morphometry : Morphometry or None
        If it was asked for.
    seconds : float
        CPU time that the analysis took.
    repairs : dict of str to Repairs
        What was mended on each plane.
    """

    name: str
    unit: str
    parameters: SliceParameters
    box: np.ndarray
    facts: Optional[MeshFacts]
    profiles: Dict[str, Profile]
    measures: Dict[str, ContourMeasures]
    morphometry: Optional[Any] = None
    seconds: float = 0.0
    repairs: Dict[str, Repairs] = field(default_factory=dict)

    def summary(self, axis: str) -> ProfileSummary:
        """Return ranges and totals along an axis: a column of the thesis' Tables 5.2 to 5.10."""
        return summarise(self.profiles[axis], self.measures[axis], self.parameters)


def analyse(soup: Soup, parameters: Optional[SliceParameters] = None, morphometry: bool = True,
            progress: Progress = silent, envelope: Optional[Soup] = None) -> Analysis:  # fmt: skip
    """Return the analysis of a body.

    Parameters
    ----------
    parameters : SliceParameters, optional
        By default the thesis': layers of 0.1 mm along x, y and z, cut in their middles.
    morphometry : bool
        Also measure the body as a whole on voxels (BV/TV, Tb.Th, Conn.D ...) and its branches along each axis.
    envelope : Soup, optional
        What the porosity refers to on every plane; by default the rectangle of the body's box.

    Raises
    ------
    ParameterError
        If a range of layers misses the body, or there would be too many planes.
    DependencyError
        If the parameters need a package that is missing.
    """
    parameters = parameters or SliceParameters()
    begun = time.process_time()
    partners = neighbours(soup.triangles, part(progress, 0.0, 0.05))
    share = (0.4 if morphometry else 0.7) / len(parameters.axes)
    profiles, measures, repairs = {}, {}, {}
    branches: Dict[str, Branches] = {}
    for k, axis in enumerate(parameters.axes):
        step = part(progress, 0.05 + k * share, 0.05 + (k + 1) * share)
        contours, repairs[axis], corners = _mended(soup, parameters, axis, partners, part(step, 0.0, 0.7))
        measures[axis] = contour_measures(contours, parameters, part(step, 0.7, 0.9))
        if morphometry:
            least = parameters.least_area
            branches[axis] = trace_branches(contours, measures[axis], least, progress=part(step, 0.9, 1.0))
        area, name = _envelope_area(corners, contours, parameters, envelope)
        profiles[axis] = make_profile(contours, measures[axis], parameters, area, repairs[axis].spoilt, name)
        del contours, corners  # before those of the next axis are made
    done = 0.05 + share * len(parameters.axes)
    facts = mesh_facts(soup, partners, part(progress, done, done + 0.25))
    whole = None
    if morphometry:
        from .morphometry import measure, with_branches

        whole = with_branches(measure(soup, progress=part(progress, 0.7, 1.0)), branches)
    return Analysis(soup.source, soup.unit, parameters, soup.box, facts, profiles, measures, whole,
                    time.process_time() - begun, repairs)  # fmt: skip


def contours_of(soup: Soup, parameters: SliceParameters, axis: str, progress: Progress = silent,
                partners: Optional[np.ndarray] = None) -> Tuple[Contours, Repairs]:  # fmt: skip
    """Return the mended contours along an axis, and what was mended: for views and layer files.

    Parameters
    ----------
    partners : ndarray of shape (3 T,), optional
        From ``neighbours``, if known.

    Raises
    ------
    ParameterError, DependencyError
        As ``analyse``.
    """
    return _mended(soup, parameters, axis, partners, progress)[:2]


def _mended(soup: Soup, parameters: SliceParameters, axis: str, partners: Optional[np.ndarray],
            progress: Progress) -> Tuple[Contours, Repairs, Placed]:  # fmt: skip
    corners = placed(soup.triangles, axis)
    heights = plane_heights(parameters, float(corners.height.min()), float(corners.height.max()))
    side = "above" if parameters.at == "bottom" else "below"  # a layer's bottom belongs to the layer
    contours = slice_contours(soup.triangles, axis, heights, part(progress, 0.0, 0.8), partners, side)
    return (*mend(contours, parameters, part(progress, 0.8, 1.0)), corners)


def _envelope_area(corners: Placed, contours: Contours, parameters: SliceParameters,
                   envelope: Optional[Soup]) -> Tuple[np.ndarray, str]:  # fmt: skip
    """What the porosity refers to on each plane, mm², and its name."""
    if envelope is not None:
        side = "above" if parameters.at == "bottom" else "below"
        return sliced_areas(envelope.triangles, contours.axis, contours.heights, side), envelope.source or "envelope"
    width, height = (float(c.max()) - float(c.min()) for c in (corners.first, corners.second))
    return np.full(len(contours.heights), width * height), "box"
