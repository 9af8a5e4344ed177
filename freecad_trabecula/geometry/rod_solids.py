# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods as solids: bicubic strips that follow the paths exactly, and planar caps. No Boolean, no loft, no sewing."""

from __future__ import annotations

from functools import lru_cache
from typing import Iterator, List, NamedTuple, Union

import numpy as np
import Part

from ..core.parameters import RodParameters
from ..core.progress import Progress, silent
from ..core.rods import true_volumes
from ..core.strips import Strips, rod_strips, ruled, straight, strip_volumes
from ..core.wireframe import Wireframe, without
from ..errors import KernelError
from .brep_text import BrepText, places, read_brep
from .spline_solids import spline_solid

VOLUME_TOLERANCE = 1e-3  # relative, of a solid's volume against that of its triangles
_WITHIN = 0.99  # of the tolerance; quadratures differ by less
_MORE = 3  # times that the number of sections is doubled where the volume is another


def rod_solids(wireframe: Wireframe, parameters: RodParameters, progress: Progress = silent) -> Iterator[Part.Shape]:
    """Yield the solid of each rod of a wireframe.

    Parameters
    ----------
    wireframe : Wireframe
    parameters : RodParameters
        Curved rods are laid through ``stations`` sections, or twice, four, eight times as many where the volume asks
        for it; straight ones need three, or two if they have the same section all along.
    progress : callable

    Raises
    ------
    KernelError
        If a rod is no valid solid, or its volume is not that of its triangles within ``VOLUME_TOLERANCE``.

    Examples
    --------
    >>> from freecad_trabecula.core.presets import preset
    >>> from freecad_trabecula.geometry.design import make_design
    >>> design = make_design(preset("case1"))
    >>> solid = next(rod_solids(design.wireframe, RodParameters()))
    >>> len(solid.Faces), solid.isValid()
    (6, True)
    """
    for rod in measured_rods(wireframe, parameters, progress):
        yield rod.solid


class MeasuredRod(NamedTuple):
    """A rod's solid, its volume by the kernel and that of the rod itself (mm³)."""

    solid: Part.Shape
    volume: float
    true_volume: float


def measured_rods(
    wireframe: Wireframe, parameters: RodParameters, progress: Progress = silent
) -> Iterator[MeasuredRod]:
    """Yield what ``rod_solids`` yields, with the volumes that were worked out for it: a third of the work."""
    if not len(wireframe):
        return
    expected = true_volumes(wireframe.paths, wireframe.ends)
    patches = _patches_needed(wireframe, _halves(parameters.stations), expected)
    texts: List[str] = [""] * len(wireframe)
    for count in np.unique(patches).tolist():
        which = np.nonzero(patches == count)[0]
        for k, text in zip(which.tolist(), rod_texts(without(wireframe, which), count)):
            texts[k] = text
    for k, name in enumerate(wireframe.names):
        progress(k, len(wireframe), "solids of rods")
        solid = read_brep(texts[k])
        volume = solid.Volume
        if not _close(volume, expected[k]):
            bent = spline_solid(without(wireframe, np.array([k])), float(expected[k]), VOLUME_TOLERANCE)
            solid, volume = (bent, bent.Volume) if bent else (solid, volume)
        if not _close(volume, expected[k]):
            raise KernelError(
                f"a rod's solid must have its mesh's volume within {VOLUME_TOLERANCE:g}, got {volume:g} and "
                f"{expected[k]:g} mm3 for rod {name}"
            )
        if not solid.isValid():
            raise KernelError(f"a rod must be a valid solid, got one that is not for rod {name}")
        yield MeasuredRod(solid.Solids[0], volume, float(expected[k]))


def _patches_needed(wireframe: Wireframe, halves: int, expected: np.ndarray) -> np.ndarray:
    """Patches (R,) along each of a path's pieces with which the strips have the volumes (R,), by quadrature."""
    needed = np.full(len(wireframe), halves * 2**_MORE)
    left = np.arange(len(wireframe))
    for doubling in range(_MORE):
        some = without(wireframe, left)
        volumes = strip_volumes(rod_strips(some.paths, some.ends, halves * 2**doubling))
        close = np.abs(volumes - expected[left]) <= _WITHIN * VOLUME_TOLERANCE * expected[left]
        needed[left[close]] = halves * 2**doubling
        left = left[~close]
        if not len(left):
            break
    return needed


def _halves(stations: int) -> int:
    """Patches along each of a path's two pieces that make at least so many sections."""
    return max(1, stations // 2)


def _close(volume: float, expected: float) -> bool:
    return abs(volume - expected) <= VOLUME_TOLERANCE * expected


# ------------------------------------------------------------------------------------------------------ as BREP text


def rod_texts(wireframe: Wireframe, halves: int, beyond: Union[float, np.ndarray] = 0.0) -> List[str]:
    """Return each rod's solid as BREP text.

    Parameters
    ----------
    wireframe : Wireframe
    halves : int
        Patches along each of a path's two pieces; straight rods have one, or one in all if their section stays.
    beyond : float or ndarray (R, 2), mm
        Prolongs the rods by that distance, measured across their end planes.
    """
    texts: List[str] = [""] * len(wireframe)
    unbent = straight(wireframe.paths)
    beyond = np.broadcast_to(beyond, (len(wireframe), 2))
    for kind, patches in ((unbent, 1), (~unbent, halves)):
        which = np.nonzero(kind)[0]
        if not len(which):
            continue
        some = without(wireframe, which)
        strips = rod_strips(some.paths, some.ends, patches, beyond[which])
        even = ruled(strips)
        for degree, part in ((1, even), (3, ~even)):
            if part.any():
                for k, text in zip(which[part], strip_texts(strips.take(part), degree)):
                    texts[k] = text
    return texts


def strip_texts(strips: Strips, degree: int = 3) -> List[str]:
    """Return each rod's solid as BREP text; ``degree`` 1 is for ruled rods."""
    count, corners, spans = strips.patches.shape[:3]
    poles, knots = spline_poles(strips.patches), strips.knots
    if degree == 1:
        poles, knots = poles[:, :, :, [0, -1]], knots[:, [0, -1]]
    template = _template(corners, knots.shape[1], degree)
    rings = poles[:, :, :, [0, -1]].transpose(0, 3, 1, 2, 4)  # (R, 2, M, 4, 3)
    beside = np.repeat(knots[:, None], corners, 1)
    each = [
        rings.reshape(count, -1),
        np.concatenate([poles[:, :, 0].reshape(count, corners, -1), beside], 2).reshape(count, -1),
        np.concatenate([poles.reshape(count, corners, -1), beside], 2).reshape(count, -1),
        strips.caps.reshape(count, -1),
        rings[:, :, :, 0].reshape(count, -1),
    ]
    return [template % tuple(row) for row in np.concatenate(each, 1).tolist()]


def spline_poles(patches: np.ndarray) -> np.ndarray:
    """Poles (R, M, 4, 2K, 3) of C1 cubic B-splines from patches (R, M, S, 4, 4, 3), less those at joints."""
    inner = np.moveaxis(patches[:, :, :, :, 1:3], 2, 3)
    inner = inner.reshape(*inner.shape[:3], -1, 3)
    return np.concatenate([patches[:, :, 0, :, :1], inner, patches[:, :, -1, :, 3:]], 3)


@lru_cache(maxsize=64)
def _template(corners: int, knots: int, degree: int) -> str:
    """Text of a rod with places for: end rings, long edges with knots, strips with knots, caps, vertices."""
    text = BrepText()
    rows = 3 * (knots if degree == 1 else 2 * knots)
    sides = [
        text.add_line_2d(*line) for line in (((0, 0), (1, 0)), ((0, 1), (1, 0)), ((0, 0), (0, 1)), ((1, 0), (0, 1)))
    ]
    rings = [[text.add_spline(places(12), (0, 1)) for _ in range(corners)] for _ in range(2)]
    along = [text.add_spline(places(rows), places(knots), degree) for _ in range(corners)]
    strips = [text.add_strip(places(4 * rows), places(knots), degree) for _ in range(corners)]
    caps = [text.add_plane(*[places(3)] * 4) for _ in range(2)]
    vertices = [[text.add_vertex(places(3)) for _ in range(corners)] for _ in range(2)]

    def after(k: int) -> int:
        return (k + 1) % corners

    around = [
        [
            text.add_edge(rings[end][k], (0, 1), [(sides[end], strips[k])], (vertices[end][k], vertices[end][after(k)]))
            for k in range(corners)
        ]
        for end in range(2)
    ]
    long = [
        text.add_edge(
            along[k], (0, 1), [(sides[2], strips[k]), (sides[3], strips[k - 1])], (vertices[0][k], vertices[1][k])
        )
        for k in range(corners)
    ]
    faces = []
    for k in range(corners):
        border = [(around[0][k], False), (long[after(k)], False), (around[1][k], True), (long[k], True)]
        faces.append((text.add_face(strips[k], [text.add_wire(border)]), False))
    for end in range(2):
        wire = text.add_wire((edge, False) for edge in around[end])
        faces.append((text.add_face(caps[end], [wire]), end == 0))
    return text.text(text.add_solid([faces]))
