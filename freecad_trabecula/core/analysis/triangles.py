# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles to be sliced: what a file or a mesh gives, in millimetres."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Tuple, Union

import numpy as np

from ...errors import MeshError, ParameterError
from ..mesh_readers import read_mesh
from ..meshes import Mesh

#: Millimetres in a unit of length.
UNITS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "um": 0.001, "inch": 25.4, "foot": 304.8}
LARGEST = 1e6  # mm; a kilometre is no bone, and 1e30 in a file is a fault
_LIKELY_MM = (0.5, 2000.0)  # size of a body whose file has no unit: an ROI of 0.5 mm to a human


@dataclass(frozen=True)
class Soup:
    """Triangles without a structure, counter-clockwise seen from outside.

    Attributes
    ----------
    triangles : ndarray of shape (T, 3, 3), float32, mm
        Triangle, corner, co-ordinate.
    unit : str
        What the numbers were before they became mm, and how that is known: ``mm``, ``m (guessed from the size)``.
    source : str
        The file or object they are from.

    Raises
    ------
    MeshError
        If there are no triangles, or co-ordinates that are not finite or larger than ``LARGEST``.
    """

    triangles: np.ndarray
    unit: str = "mm"
    source: str = ""

    def __post_init__(self) -> None:
        triangles = np.asarray(self.triangles, np.float32)
        if triangles.ndim != 3 or triangles.shape[1:] != (3, 3):
            raise MeshError(f"triangles must have the shape (count, 3, 3), got {triangles.shape}")
        if not len(triangles):
            raise MeshError(f"{self.source or 'a mesh'} must have at least one triangle, got 0")
        by_coordinate = np.ascontiguousarray(triangles.transpose(2, 1, 0))  # as ``by_corners`` wants them
        object.__setattr__(self, "triangles", by_coordinate.transpose(2, 1, 0))
        low, high = self.box
        if not max(-low.min(), high.max()) <= LARGEST:  # nan fails too
            raise MeshError(
                f"{self.source or 'a mesh'}: co-ordinates must be finite and at most {LARGEST:g} mm, "
                f"got {low.min():g}..{high.max():g} mm"
            )

    @property
    def box(self) -> np.ndarray:
        """Lowest and highest co-ordinates (2, 3), mm."""
        points = by_corners(self.triangles)
        return np.stack([points.min(1), points.max(1)]).astype(float)


def by_corners(triangles: np.ndarray) -> np.ndarray:
    """Return co-ordinates (3, 3 T): x, y, z of all first corners, then of all second, then of all third ones.

    Without a copy for the triangles of a ``Soup``, which lie in memory like that.
    """
    return np.ascontiguousarray(triangles.transpose(2, 1, 0)).reshape(3, -1)


def soup_of(mesh: Mesh, source: str = "") -> Soup:
    """Return the triangles of a mesh in mm; vertices are rounded to single precision, equal ones alike."""
    return Soup(mesh.vertices.astype(np.float32)[mesh.triangles], source=source)


def read_soup(path: Union[str, Path], unit: str = "auto") -> Soup:
    """Return the triangles of an STL, OBJ, PLY or 3MF file.

    Parameters
    ----------
    unit : str
        ``mm``, ``cm``, ``m``, ``um``, ``inch``; ``auto`` takes the unit of the file if it has one (3MF), else guesses
        from the size: a body of less than 0.5 mm is taken for one in metres, of more than 2 m for one in micrometres.

    Raises
    ------
    MeshError
        If the file is none of these, is cut off or empty, or has co-ordinates that cannot be.
    ExportError
        If it cannot be read.
    ParameterError
        If the unit is unknown.
    """
    if unit != "auto" and unit not in UNITS:
        raise ParameterError(f"the unit must be auto or one of {', '.join(UNITS)}, got {unit!r}")
    path = Path(path)
    triangles, own = read_mesh(path)
    said = unit
    if unit == "auto":
        points = by_corners(triangles)
        unit, said = (own, f"{own} (the file's)") if own else guessed_unit(float(np.ptp(points, axis=1).max()))
    if UNITS[unit] != 1.0:
        triangles = triangles * np.float32(UNITS[unit])
    return Soup(triangles, said, path.name)


def guessed_unit(size: float) -> Tuple[str, str]:
    """Return the unit in which a body of a size is likely to be, and how that is said."""
    low, high = _LIKELY_MM
    unit = "mm" if not 0 < size < low and not size > high else "m" if size < low else "um"
    return unit, unit if unit == "mm" else f"{unit} (guessed: the body would be {size:g} mm large)"
