# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slices as SVG: one drawing with all layers side by side, each a group with its height, in mm.

The corners in a group are those of the slice: the group's ``transform`` puts it at its place in the sheet and turns the
second axis upwards. Material is filled, voids are not (nonzero fill: contours keep their direction); open polylines are
drawn as red lines.
"""

from __future__ import annotations

from pathlib import Path
from typing import Tuple, Union
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from ..progress import Progress, silent
from ..stl import whole_file
from .contours import Contours
from .layer_corners import distinct_corners

_DECIMALS = 6  # 1 nm
_GAP = 0.08  # of a slice's larger side, between two slices
_TEXT = 0.05  # of the same, height of letters


def write_svg(path: Union[str, Path], contours: Contours, name: str = "", progress: Progress = silent) -> None:
    """Write contours as one SVG drawing.

    Parameters
    ----------
    path : str or Path
    contours : Contours
    name : str
        Title of the drawing; by default the file's name.

    Raises
    ------
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    points, starts, plane, closed = distinct_corners(contours, 1.0, _DECIMALS)
    first = np.searchsorted(plane, np.arange(len(contours.heights) + 1))
    low, high = (points.min(0), points.max(0)) if len(points) else (np.zeros(2), np.ones(2))
    side = float((high - low).max())
    pitch = high - low + np.array([_GAP, _GAP + 1.5 * _TEXT]) * side
    columns = max(int(np.ceil(np.sqrt(len(contours.heights)))), 1)
    rows = max(-(-len(contours.heights) // columns), 1)
    size = pitch * [columns, rows] + _GAP * side
    with whole_file(path) as file:
        file.write(_opening(name or Path(path).stem, contours.axis, (float(size[0]), float(size[1]))).encode("utf-8"))
        for layer, height in enumerate(contours.heights.tolist()):
            progress(layer, len(contours.heights), "drawing layers")
            corner = pitch * [layer % columns, layer // columns] + _GAP * side
            across, down = float(corner[0] - low[0]), float(corner[1] + high[1])
            drawn = [
                _path(points[starts[contour] : starts[contour + 1]], bool(closed[contour]))
                for contour in range(first[layer], first[layer + 1])
            ]
            which = closed[first[layer] : first[layer + 1]]
            material = " ".join(text for text, full in zip(drawn, which) if full)
            lines = " ".join(text for text, full in zip(drawn, which) if not full)
            opens = f'<path class="open" d="{lines}"/>\n' if lines else ""
            place = f'x="{corner[0]:.4f}" y="{corner[1] + high[1] - low[1] + 1.2 * _TEXT * side:.4f}"'
            file.write(
                f'<g id="layer{layer}" data-height="{height:.{_DECIMALS}f}" '
                f'transform="translate({across:.6f} {down:.6f}) scale(1 -1)">\n'
                f'<path class="material" d="{material}"/>\n{opens}</g>\n'
                f'<text font-size="{_TEXT * side:.4f}" {place}>{height:.4g} mm</text>\n'.encode("ascii")
            )
        file.write(b"</svg>\n")


def _opening(name: str, axis: str, size: Tuple[float, float]) -> str:
    width, height = size
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.4f}mm" height="{height:.4f}mm" '
        f'viewBox="0 0 {width:.4f} {height:.4f}" data-axis={quoteattr(axis)}>\n'
        f"<title>{escape(name)}</title>\n"
        "<style>.material{fill:#44546a;fill-rule:nonzero}"
        f".open{{fill:none;stroke:#d55e00;stroke-width:{0.002 * max(size):.4f}}}"
        "text{font-family:sans-serif}</style>\n"
        '<rect width="100%" height="100%" fill="white"/>\n'
    )


def _path(corners: np.ndarray, is_closed: bool) -> str:
    values = tuple(corners.ravel().tolist())
    text = "M" + " L".join([f"%.{_DECIMALS}f %.{_DECIMALS}f"] * len(corners)) % values
    return text + (" Z" if is_closed else "")
