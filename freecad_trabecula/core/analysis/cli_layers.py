# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common Layer Interface, ASCII form, version 2.00: contours out.

A layer is named by the height of its upper surface; a first layer without contours gives the thickness of the next.
Polylines carry a direction: 0 clockwise (void), 1 counter-clockwise (material), 2 open; closed ones repeat their first
corner at the end. Source: Common Layer Interface, version 2.00, Brite EuRam project BE 5278, 1994.
"""

from __future__ import annotations

from pathlib import Path
from typing import List, Union

import numpy as np

from ...errors import ParameterError
from ..progress import Progress, silent
from ..stl import whole_file
from .contours import Contours
from .layer_corners import distinct_corners

_DECIMALS = 6  # 1 nm


def write_cli(
    path: Union[str, Path],
    contours: Contours,
    thickness: float,
    above: float = 0.5,
    name: str = "",
    progress: Progress = silent,
) -> None:
    """Write contours as ASCII CLI, in mm.

    Parameters
    ----------
    path : str or Path
    contours : Contours
    thickness : float, mm
        Of each layer.
    above : float
        What of the layer lies above its plane: 0.5 for planes at the middle, 1 for planes at the bottom.
    name : str
        Label of the part; by default the file's name.

    Raises
    ------
    ParameterError
        If the thickness is not above 0.
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    if not thickness > 0:
        raise ParameterError(f"the thickness of a layer must be above 0 mm, got {thickness:g}")
    points, starts, plane, closed = distinct_corners(contours, 1.0, _DECIMALS)
    first = np.searchsorted(plane, np.arange(len(contours.heights) + 1))
    surfaces = contours.heights + above * thickness
    with whole_file(path) as file:
        file.write(_header(name or Path(path).stem, points, surfaces, thickness).encode("ascii", "replace"))
        for layer, surface in enumerate(surfaces.tolist()):
            progress(layer, len(surfaces), "writing layers")
            parts = [f"$$LAYER/{surface:.{_DECIMALS}f}\n"]
            for contour in range(first[layer], first[layer + 1]):
                parts.append(_polyline(points[starts[contour] : starts[contour + 1]], bool(closed[contour])))
            file.write("".join(parts).encode("ascii"))
        file.write(b"$$GEOMETRYEND\n")


def _header(name: str, points: np.ndarray, surfaces: np.ndarray, thickness: float) -> str:
    label = "".join(c if c.isprintable() and c != "$" else "_" for c in name)
    bottom = float(surfaces[0]) - thickness if len(surfaces) else 0.0
    lines = ["$$HEADERSTART", "$$ASCII", "$$UNITS/1.0", "$$VERSION/200", f"$$LABEL/1,{label}"]
    if len(points):
        box = [*points.min(0), bottom, *points.max(0), surfaces[-1]]
        lines.append("$$DIMENSION/" + ",".join(f"{value:.{_DECIMALS}f}" for value in box))
    lines += [f"$$LAYERS/{len(surfaces) + 1:06d}", "$$HEADEREND", "$$GEOMETRYSTART"]
    return "\n".join([*lines, f"$$LAYER/{bottom:.{_DECIMALS}f}\n"])


def _polyline(corners: np.ndarray, is_closed: bool) -> str:
    direction = 2
    if is_closed:
        x, y = corners.T
        direction = int((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() > 0)
        corners = np.concatenate([corners, corners[:1]])
    values: List[float] = corners.ravel().tolist()
    return (
        f"$$POLYLINE/1,{direction},{len(corners)}," + ",".join([f"%.{_DECIMALS}f"] * len(values)) % tuple(values) + "\n"
    )
