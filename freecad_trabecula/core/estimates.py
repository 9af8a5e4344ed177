# SPDX-License-Identifier: LGPL-2.1-or-later
"""What slicing, measuring, comparing and saving will take, before it is done: CPU seconds, memory, sizes of files.

All follows from few numbers of a body: its triangles, box, volume and surface. The constants were fitted to what
``tools/estimates.py`` measures (2 cores of 2020, numpy 1.24); its table, said beside came, is in docs/seeing.md. Of the
bodies there, four bones of 1 to 10 mm, 12,000 to 2,000,000 triangles, 30 to 1,000 planes an axis:

| work | grows with | measured |
|---|---|---|
| crossings of triangles, neighbours | triangles | 3.8e-6 to 5.8e-6 s each |
| slicing | segments | 1.9e-7 to 3.6e-7 s each, and 1e-7 s for a triangle and axis |
| segments of a plane | square root of surface x triangles, over the extent | 1.19 to 1.26 times |
| contours of a plane | solid area, over the mean thickness squared | 1/11.1 to 1/10.1 times |
| branches | crossings of rows with contours | 2.2e-6 to 5.7e-6 s each, rising with their number |
| morphometry | voxels | 1.4e-6 to 2.5e-6 s each |
| rows of contours.csv, of the workbook | contours | 283 to 308, 50 to 71 bytes |
"""

from __future__ import annotations

import math
from typing import Dict, NamedTuple, Sequence, Tuple

import numpy as np

from . import engines
from .analysis.branches import MOST_ROWS, ROWS_PER_LAYER
from .analysis.parameters import SliceParameters, axis_frame, plane_heights
from .analysis.voxelise import DEFAULT_CELLS, size_for
from .report_text import size_words
from .voxels.design import Estimate

#: Less than this need not be said: seconds, bytes.
HEAVY = (5.0, 50e6)
_CROSSINGS, _SLICING, _CONTOURS = 6e-6, (1e-7, 2e-7), (1e-7, 1.3e-7)  # s; of the pairs per triangle and per segment
_SEGMENTS, _STRUT = 1.22, 10.7
_BRANCHES = (6.6e-7, 1.13)  # s, and the power of the crossings
_MORPHOMETRY = (0.8, 1.5e-6)  # s, s a voxel
_LEAST = (0.03, 1.3e7)  # s, bytes of any analysis
_MEMORY = (150.0, 12.0, 6e7, 33.0)  # bytes a triangle, a segment; of the morphometry: always, a voxel
_TABLES = (1.3e-5, 303.0, 66.0, 36.0, 12e3)  # s and bytes a contour; bytes a slice: profile, branches; report
_WORKBOOK = (7.2e-5, 50.0, 30.0, 8e3)  # s and bytes a contour; bytes a slice; the rest
_PLOT = (0.4, 1.2e5)  # s and bytes of a plot
_COMPARED = (2e-6, 1.6, 1e-5, 4.2e5)  # s a contour; plots of it: s an axis, s a contour, bytes an axis
#: By kind of a file of layers: s a segment, bytes a segment besides its two numbers, a contour, a slice.
_LAYERS = {"ssl": (5e-7, 2.0, 2.0, 24.0), "cli": (1.4e-6, 2.0, 27.0, 20.0), "svg": (5.5e-7, 3.0, 0.0, 190.0)}
_ROD, _MENDED = 1e-3, 0.083  # s; of a rod, of one that is to be mended
_SOLIDS = (4.2e-5, 4e7, 2.6e3)  # s a triangle; bytes: always, a triangle
_SCAFFOLD = (0.15, 1.75, 4e7)  # s; times the engine's own seconds; bytes beside the engine's
_VARIANT_ROD = 2.2e-3  # s; a rod with its share of the estimate by rays and of the picture
_VARIANT_VOXELS = (0.35, 5e-7)  # s, s a cell
_CURVED, _FACE = 150.0, 20  # triangles of a solid: times its surfaces over its volume to 4/3; of a face bent one way


class Work(NamedTuple):
    """What some work will take.

    Attributes
    ----------
    seconds : float
        CPU seconds.
    memory : float
        Bytes at the peak.
    files : float
        Bytes that are written.
    """

    seconds: float
    memory: float = 0.0
    files: float = 0.0

    @property
    def is_heavy(self) -> bool:
        """Whether it must be said before it is begun."""
        return self.seconds > HEAVY[0] or max(self.memory, self.files) > HEAVY[1]

    @property
    def words(self) -> str:
        """The estimate in words.

        Examples
        --------
        >>> Work(12.3, 2.5e8).words
        'about 12 s, 250 MB of memory'
        """
        parts = [f"about {two_digits(self.seconds):,} s" if self.seconds >= 1 else "less than 1 s"]
        sizes = ((self.memory, "memory"), (self.files, "files"))
        return ", ".join([*parts, *(f"{size_words(two_digits(size))} of {what}" for size, what in sizes if size)])

    def times(self, count: int) -> Work:
        """Return what this work takes so many times, one after the other; its files count once."""
        return self._replace(seconds=count * self.seconds)

    def and_then(self, other: Work) -> Work:
        """Return what this work and another after it take."""
        return Work(self.seconds + other.seconds, max(self.memory, other.memory), self.files + other.files)


def two_digits(value: float) -> int:
    """Return a number of which two digits are said: more would not be true.

    Examples
    --------
    >>> two_digits(137.2), two_digits(0.4)
    (140, 0)
    """
    return round(float(f"{value:.2g}"))


class Body(NamedTuple):
    """What is known of a body before it is sliced; nan where it is not.

    Attributes
    ----------
    triangles : int
    box : ndarray of shape (2, 3), mm
        Lowest and highest co-ordinates.
    volume : float, mm³
    surface : float, mm²
    """

    triangles: int
    box: np.ndarray
    volume: float = math.nan
    surface: float = math.nan

    @property
    def thickness(self) -> float:
        """Mean thickness 2 V / S, mm."""
        return 2 * abs(self.volume) / self.surface if self.surface > 0 else math.nan

    @property
    def room(self) -> float:
        """Volume of the box, mm³."""
        return float(np.ptp(self.box, axis=0).prod())

    @property
    def size(self) -> float:
        """Longest side of the box, mm."""
        return float(np.ptp(self.box, axis=0).max())

    def scaled(self, factor: float) -> Body:
        """Return what is known of the body in another unit."""
        return Body(self.triangles, factor * self.box, factor**3 * self.volume, factor**2 * self.surface)


#: Planes along an axis and how far the body reaches along it, mm.
Planes = Sequence[Tuple[int, float]]


def planes_of(parameters: SliceParameters, box: np.ndarray) -> Dict[str, Tuple[int, float]]:
    """Return for each axis how many planes there will be and how far the body reaches, mm; none of an unknown box.

    Raises
    ------
    ParameterError
        As ``plane_heights``.

    Examples
    --------
    >>> planes_of(SliceParameters(thickness=0.5, axes=("y", "0.6,0.8,0")), np.array([[0, 0, 0], [1, 2, 3]]))
    {'y': (4, 2.0), '0.6,0.8,0': (4, 2.2)}
    """
    if not np.isfinite(box).all():
        return {}
    found, corners = {}, np.array([[box[i][0], box[j][1], box[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    for axis in parameters.axes:
        along = corners @ axis_frame(axis)[2]
        low, high = float(along.min()), float(along.max())
        found[axis] = len(plane_heights(parameters, low, high)), round(high - low, 9)
    return found


# ------------------------------------------------------------------------------------------------------- the bodies


def body_of(triangles: np.ndarray, count: int = 0) -> Body:
    """Return what is known of triangles (T, 3, 3), mm; of ``count`` triangles, of which these are a sample."""
    points = np.asarray(triangles, float)
    box = np.stack([points.min((0, 1)), points.max((0, 1))])
    a, b, c = (points[:, k] - box.mean(0) for k in range(3))
    normals = np.cross(b - a, c - a)
    share = (count or len(points)) / len(points)
    surface = float(np.sqrt((normals**2).sum(1)).sum()) / 2
    return Body(count or len(points), box, share * float((a * normals).sum()) / 6, share * surface)


def triangles_of_solid(volume: float, surface: float, curved: float, faces: int) -> int:
    """Return about how many triangles a solid gets.

    Parameters
    ----------
    volume, surface : float, mm³, mm²
    curved : float, mm²
        Surface that is bent both ways.
    faces : int

    Notes
    -----
    A triangle that stays within d of a surface of radius r has an area of the order of r d. Here d is 1/500 of the side
    of a cube of that volume (``geometry.tessellation``), and r is taken to be that of a ball, 3 V / S: right within a
    tenth for a ball and a torus.
    """
    return int(_CURVED * curved * surface / abs(volume) ** (4 / 3) + _FACE * faces) if volume else _FACE * faces


# --------------------------------------------------------------------------------------------------------- the work


def segments(body: Body, planes: Planes) -> float:
    """Return about how many segments the planes cut out of a body's triangles.

    A plane cuts as many triangles as their mean height over the extent says, and that goes with the square root of
    their mean area.
    """
    surface = body.surface if body.surface > 0 else 0.0
    return sum(n * _SEGMENTS * math.sqrt(surface * body.triangles) / extent for n, extent in planes if extent > 0)


def contours(body: Body, planes: Planes) -> float:
    """Return about how many contours the planes cut out of a body: struts of its mean thickness."""
    if not body.thickness > 0:
        return float(sum(n for n, _ in planes))
    return sum(
        n * max(abs(body.volume) / extent / (_STRUT * body.thickness**2), 1.0) for n, extent in planes if extent > 0
    )


def voxels(body: Body) -> float:
    """Return how many voxels the morphometry of a body takes; of one whose box is not known, the most."""
    if math.isnan(body.room):
        return float(DEFAULT_CELLS**3)
    return body.room / size_for(body.thickness, body.box) ** 3 if body.room > 0 else 0.0


def analysis_work(body: Body, planes: Planes, morphometry: bool = False) -> Work:
    """Return what the slice analysis of a body takes, its contours to be looked at included.

    Parameters
    ----------
    body : Body
    planes : sequence of (int, float)
        For each axis the number of planes and the extent of the body, mm.
    morphometry : bool
    """
    cut, each = segments(body, planes), len(planes) * body.triangles
    seconds = _CROSSINGS * body.triangles + sum(a * each + b * cut for a, b in (_SLICING, _CONTOURS))
    seconds += _LEAST[0]
    memory = _LEAST[1] + _MEMORY[0] * body.triangles + _MEMORY[1] * cut
    if morphometry:
        cells, share = voxels(body), abs(body.volume) / body.room if body.room > 0 else math.nan
        per_axis = contours(body, planes) / max(len(planes), 1)
        seconds += _MORPHOMETRY[0] + _MORPHOMETRY[1] * cells
        seconds += sum(branches_seconds(n, per_axis, share) for n, _ in planes)
        memory = max(memory, _MEMORY[2] + _MEMORY[3] * cells)
    return Work(seconds, memory)


def branches_seconds(planes: int, count: float, share: float) -> float:
    """Return what it takes to follow ``count`` contours along an axis that are a share of the box.

    Rows lie a quarter of a layer apart: as many cross a contour as it is wide.
    """
    if not (planes and count and share > 0):
        return 0.0
    crossed = count * min(ROWS_PER_LAYER * planes, MOST_ROWS) * math.sqrt(min(share * planes / count, 1.0))
    return _BRANCHES[0] * crossed ** _BRANCHES[1]


def saving_work(slices: Sequence[Tuple[int, int]], share: float, plots: bool = True) -> Work:
    """Return what it takes to write the folder of an analysis.

    Parameters
    ----------
    slices : sequence of (int, int)
        For each axis the numbers of planes and contours.
    share : float
        Mean of sliced area over envelope.
    plots : bool
    """
    planes, count = sum(n for n, _ in slices), sum(c for _, c in slices)
    drawn = (3 + len(slices)) * plots
    seconds = _TABLES[0] * count + sum(branches_seconds(n, c, share) for n, c in slices) + _PLOT[0] * drawn
    return Work(seconds, files=_TABLES[1] * count + sum(_TABLES[2:4]) * planes + _TABLES[4] + _PLOT[1] * drawn)


def workbook_work(slices: Sequence[Tuple[int, int]]) -> Work:
    """Return what the workbook of an analysis takes; ``slices`` as for ``saving_work``."""
    planes, count = sum(n for n, _ in slices), sum(c for _, c in slices)
    return Work(_WORKBOOK[0] * count, files=_WORKBOOK[1] * count + _WORKBOOK[2] * planes + _WORKBOOK[3])


def layers_work(kind: str, cut: float, count: float, planes: int, box: np.ndarray) -> Work:
    """Return what a file of layers takes.

    Parameters
    ----------
    kind : str
        ``ssl``, ``cli`` or ``svg``.
    cut, count : float
        Segments and contours of all planes.
    planes : int
    box : ndarray of shape (2, 3), mm
        Of the body: how many digits its co-ordinates have.
    """
    seconds, more, contour, plane = _LAYERS[kind]
    across = [f"{value:.6f}" for value in np.linspace(box[0], box[1], 64).ravel().tolist()]
    number = sum(map(len, across)) / len(across)
    return Work(seconds * cut, files=(2 * number + more) * cut + contour * count + plane * planes)


def comparison_work(count: float, axes: int, plots: bool = False) -> Work:
    """Return what the comparison of analyses with ``count`` contours in all takes, and its plots."""
    drawn = Work(_COMPARED[1] * axes + _COMPARED[2] * count, files=_COMPARED[3] * axes)
    return Work(_COMPARED[0] * count).and_then(drawn if plots else Work(0.0))


def design_work(rods: int, faulty: int) -> Work:
    """Return what so many rods take, of which so many are to be mended."""
    return Work(_ROD * rods + _MENDED * faulty)


def network_work(triangles: int) -> Work:
    """Return what the solids of rods with so many triangles in all take."""
    return Work(_SOLIDS[0] * triangles, _SOLIDS[1] + _SOLIDS[2] * triangles)


def scaffold_work(engine: engines.Estimate) -> Work:
    """Return what a scaffold takes with its pieces, volumes and checks, of what its engine takes."""
    return Work(_SCAFFOLD[0] + _SCAFFOLD[1] * engine.seconds, _SCAFFOLD[2] + engine.bytes)


def rod_variant_work(rods: int, faulty: int) -> Work:
    """Return what a design of so many rods takes with another seed, of which so many are to be mended."""
    return Work(_VARIANT_ROD * rods + _MENDED * faulty)


def voxel_work(design: Estimate) -> Work:
    """Return what a voxel design takes."""
    return Work(design.seconds, 1e9 * design.gigabytes)


def voxel_variant_work(design: Estimate) -> Work:
    """Return what a voxel design takes with another seed: itself, its counts, its picture."""
    seconds = design.seconds + _VARIANT_VOXELS[0] + _VARIANT_VOXELS[1] * design.cells
    return Work(seconds, 1e9 * design.gigabytes)
