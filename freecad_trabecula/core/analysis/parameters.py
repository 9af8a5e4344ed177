# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user chooses of a slice analysis (thesis Fig. 5.1, Table 5.1), and the planes that follow from it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Tuple

import numpy as np

from ...errors import ParameterError
from ..parameters import require

AXES = ("x", "y", "z")
PLANES = ("middle", "bottom", "heights")
SMOOTHINGS = ("off", "normal", "heavy")
FILLS = ("winding", "union")
MOST_PLANES = 100_000  # along one axis; 10^5 planes of a 13 MB file take a minute and 15 GB of contours


def _f(default: Any, unit: str, doc: str, **more: Any) -> Any:
    return field(default=default, metadata=dict(unit=unit, doc=doc, **more))


@dataclass(frozen=True)
class SliceParameters:
    """How a body is sliced, its slices mended, and its contours judged.

    Raises
    ------
    ParameterError
        If a value breaks its rule.
    """

    thickness: float = _f(0.1, "mm", "Thickness of a layer")
    axes: Tuple[str, ...] = _f(AXES, "", "Axes of the planes: x, y, z, or a direction such as 0.6,0.8,0")
    at: str = _f("middle", "", "Planes at the layers' middles, at their bottoms (thesis), at heights", choices=PLANES)
    heights: Tuple[float, ...] = _f((), "mm", "Co-ordinates of the planes along the axis, ascending")
    low: float = _f(math.nan, "mm", "Where the layers begin; nan: where the body does")
    high: float = _f(math.nan, "mm", "Where the layers end; nan: where the body does")
    gap: float = _f(0.01, "mm", "Gap fill: largest gap of an open contour that is closed", low=0.0)
    iterations: int = _f(5, "", "Gap fill: rounds of closing", low=0)
    filter_open: float = _f(0.0, "mm", "Open contours shorter than this are left out", low=0.0)
    filter_closed: float = _f(0.0, "mm", "Closed contours of a shorter perimeter are left out", low=0.0)
    smoothing: str = _f("off", "", "Points that hardly turn a contour are left out", choices=SMOOTHINGS)
    compensation: float = _f(0.0, "mm", "Contours are offset by this into the material (tool compensation)")
    fill: str = _f("winding", "", "What overlaps counts as often as it overlaps, or once (union)", choices=FILLS)
    rod_ratio: float = _f(0.6, "", "A contour that fills so much of its box is a rod, else a plate", low=0.0, high=1.0)
    least_area: float = _f(1e-6, "mm2", "Contours of no more area are not counted", low=0.0)

    def __post_init__(self) -> None:
        require(math.isfinite(self.thickness) and self.thickness > 0, "the thickness of a layer must be greater than 0",
                f"{self.thickness:g}", "mm")  # fmt: skip
        object.__setattr__(self, "axes", tuple(axis_name(axis) for axis in self.axes))
        require(len(self.axes) > 0, "there must be at least one axis to slice along", repr(self.axes))
        require(len(set(self.axes)) == len(self.axes), "every axis may be named once", ", ".join(self.axes))
        for name, allowed in (("at", PLANES), ("smoothing", SMOOTHINGS), ("fill", FILLS)):
            value = getattr(self, name)
            require(value in allowed, f"{name} must be one of {', '.join(allowed)}", repr(value))
        self._check_heights()
        for name in ("gap", "filter_open", "filter_closed", "least_area"):
            value = getattr(self, name)
            require(math.isfinite(value) and value >= 0, f"{name} must be at least 0", f"{value:g}", "mm")
        require(self.iterations >= 0, "rounds of gap fill must be at least 0", self.iterations)
        require(math.isfinite(self.compensation), "the compensation must be finite", f"{self.compensation:g}", "mm")
        require(0 <= self.rod_ratio <= 1, "the ratio from which a contour is a rod must lie in 0..1", self.rod_ratio)

    def _check_heights(self) -> None:
        object.__setattr__(self, "heights", tuple(float(height) for height in self.heights))
        require((self.at == "heights") == bool(self.heights), "heights must be given with at='heights', and only then",
                f"at={self.at!r} and {len(self.heights)} heights")  # fmt: skip
        require(len(self.heights) <= MOST_PLANES, f"there may be at most {MOST_PLANES} heights", len(self.heights))
        require(all(map(math.isfinite, self.heights)), "heights must be finite", self.heights, "mm")
        rising = all(a < b for a, b in zip(self.heights, self.heights[1:]))
        require(rising, "heights must rise", self.heights, "mm")
        for name in ("low", "high"):
            require(not math.isinf(getattr(self, name)), f"{name} must be finite, or nan for the body's own", "inf")
        limits = f"{self.low:g} and {self.high:g}"
        require(not self.low >= self.high, "a range of layers must satisfy low < high", limits, "mm")


# ------------------------------------------------------------------------------------------------------------- axes


def axis_name(axis: Any) -> str:
    """Return the name of an axis: ``x``, ``y``, ``z``, or three numbers with commas for any other direction.

    Parameters
    ----------
    axis : str or sequence of 3 numbers
        A direction need not have the length 1.

    Raises
    ------
    ParameterError
        If it is no direction.

    Examples
    --------
    >>> axis_name((0.6, 0.8, 0.0)), axis_name("Z")
    ('0.6,0.8,0', 'z')
    """
    if isinstance(axis, str) and axis.strip().lower() in AXES:
        return axis.strip().lower()
    try:
        numbers = [float(part) for part in (axis.split(",") if isinstance(axis, str) else axis)]
    except (TypeError, ValueError):
        numbers = []
    fits = len(numbers) == 3 and all(map(math.isfinite, numbers)) and math.hypot(*numbers[:2]) + abs(numbers[2]) > 1e-9
    if not fits:
        raise ParameterError(f"an axis must be x, y, z or a direction of three numbers such as 0.6,0.8,0, got {axis!r}")
    return ",".join(f"{number:.17g}" if float(f"{number:g}") != number else f"{number:g}" for number in numbers)


def axis_frame(axis: str) -> np.ndarray:
    """Return the frame (3, 3) of an axis: rows are the first and second in-plane direction and the axis itself.

    In-plane directions of x are (y, z), of y (z, x), of z (x, y); so for directions near them. Seen against the axis
    (from its positive end) the first turns to the second counter-clockwise.
    """
    name = axis_name(axis)
    direction = np.eye(3)[AXES.index(name)] if name in AXES else np.array([float(part) for part in name.split(",")])
    direction = direction / np.abs(direction).max()  # squares of large numbers would be endless
    direction = direction / np.sqrt((direction**2).sum())
    largest = int(np.argmax(np.abs(direction)))
    first = np.eye(3)[(largest + 1) % 3]
    first = first - (first @ direction) * direction
    first /= np.sqrt((first**2).sum())
    return np.stack([first, np.cross(direction, first), direction]) + 0.0  # no -0


# ----------------------------------------------------------------------------------------------------------- planes


def plane_heights(parameters: SliceParameters, low: float, high: float) -> np.ndarray:
    """Return the co-ordinates (S,) of the planes along an axis, mm, ascending.

    Parameters
    ----------
    low, high : float, mm
        Where the body begins and ends along the axis; the range of the parameters, if any, replaces them.

    Raises
    ------
    ParameterError
        If the range misses the body, or if there would be more than ``MOST_PLANES`` planes.

    Notes
    -----
    A layer belongs to the body if its middle does (its bottom, with planes at the bottoms). What is thinner than a
    layer is cut once, in its middle (at its bottom).
    """
    if parameters.at == "heights":
        return np.array(parameters.heights)
    first = low if math.isnan(parameters.low) else parameters.low
    last = high if math.isnan(parameters.high) else parameters.high
    meets = first <= high and last >= low and first <= last
    require(meets, f"the range of layers must meet the body, {low:g}..{high:g} mm", f"{first:g}..{last:g}", "mm")
    thickness, extent = parameters.thickness, last - first
    layers = extent / thickness
    slack = 1e-6  # of a layer: single precision leaves so much of a whole number of them
    if layers > MOST_PLANES:
        raise ParameterError(
            f"there may be at most {MOST_PLANES} planes along an axis; {extent:g} mm in layers of {thickness:g} mm "
            f"are {layers:.0f} planes, which would take about {layers / 1e5:.1f} times the minute and 15 GB that "
            f"{MOST_PLANES} take; layers of at least {extent / MOST_PLANES:.2g} mm are possible"
        )
    if parameters.at == "bottom":
        return first + thickness * np.arange(max(1, math.ceil(layers - slack)))
    if layers < 1:
        return np.array([first + extent / 2])
    return first + thickness * (np.arange(max(1, math.floor(layers + 0.5 - slack))) + 0.5)
