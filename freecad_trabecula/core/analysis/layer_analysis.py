# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis of a file of layers (SSL): one axis, no mesh; what the thesis did in Excel (5.2.3)."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any, Dict, Tuple

import numpy as np

from ...errors import ContourError, ParameterError
from ..progress import Progress, part, silent
from .analysis import Analysis
from .contours import Contours, contour_measures
from .parameters import AXES, SliceParameters, axis_frame
from .profiles import make_profile
from .repair import mend
from .ssl import LayerFile

_EVEN = 1e-3  # of a layer: distances between planes that differ by less are equal


def analyse_layers(
    layers: LayerFile, name: str, parameters: SliceParameters, progress: Progress = silent
) -> Tuple[Analysis, Contours]:
    """Return the analysis of layers as they stand in a file, and their contours as they were mended.

    Parameters
    ----------
    layers : LayerFile
    name : str
        Of the sample.
    parameters : SliceParameters
        Thickness and planes are replaced by the file's; ``at`` says whether Z is the middle or the bottom of a layer.
        The one axis is the file's.

    Raises
    ------
    ContourError
        If there are no layers.
    ParameterError
        If the parameters ask for heights or a range: the planes are the file's.

    Notes
    -----
    Porosity refers to the rectangle that holds all contours: the file knows no other box. Layers that do not follow
    each other at their thickness are taken as planes at given heights.
    """
    begun = time.process_time()
    contours = layers.contours
    if not len(contours.heights):
        raise ContourError(f"{name} must hold at least one layer, got 0")
    if parameters.at == "heights" or parameters.low == parameters.low or parameters.high == parameters.high:
        raise ParameterError("a file of layers is read as it is: heights and a range cannot be chosen")
    parameters = _own_planes(layers, replace(parameters, axes=(contours.axis,)))
    mended, repairs = mend(contours, parameters, part(progress, 0.0, 0.5))
    measures = contour_measures(mended, parameters, part(progress, 0.5, 1.0))
    low, high = (contours.points.min(0), contours.points.max(0)) if len(contours.points) else (np.zeros(2), np.zeros(2))
    area = float((high - low).prod())
    profile = make_profile(mended, measures, parameters, np.array(area), repairs.spoilt)
    analysis = Analysis(
        name=name,
        unit=layers.unit,
        parameters=parameters,
        box=_box(contours, low, high, parameters),
        facts=None,
        profiles={contours.axis: profile},
        measures={contours.axis: measures},
        seconds=time.process_time() - begun,
        repairs={contours.axis: repairs},
    )
    return analysis, mended


def _own_planes(layers: LayerFile, parameters: SliceParameters) -> SliceParameters:
    """Return the parameters with the planes of the file."""
    heights, thicknesses = layers.contours.heights, layers.thicknesses
    thickness = float(np.median(thicknesses))
    steps = np.append(np.diff(heights), thickness)
    if np.abs(np.concatenate([steps, thicknesses]) - thickness).max() <= _EVEN * thickness:
        return replace(parameters, thickness=thickness)
    given: Dict[str, Any] = {"at": "heights", "heights": tuple(heights.tolist())}
    return replace(parameters, thickness=thickness, **given)


def _box(contours: Contours, low: np.ndarray, high: np.ndarray, parameters: SliceParameters) -> np.ndarray:
    """Box (2, 3) of the layers, mm; of an oblique axis that of its corners in space."""
    below = 0.0 if parameters.at == "bottom" else parameters.thickness / 2
    ends = contours.heights[0] - below, contours.heights[-1] - below + parameters.thickness
    frame = axis_frame(contours.axis)
    if contours.axis in AXES:
        frame = np.round(frame)
    corners = np.array([[u, v, w] for u in (low[0], high[0]) for v in (low[1], high[1]) for w in ends]) @ frame
    return np.stack([corners.min(0), corners.max(0)])
