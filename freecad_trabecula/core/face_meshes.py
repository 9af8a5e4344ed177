# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of one face from its parameters: where curves and surfaces are sampled, and grids joined to their border.

A chord over a step h of a parameter lies off a curve by |c'' across c'| h²/8; a quadrangle's diagonal off a surface by
(L du² + 2 M du dv + N dv²)/8 with its second fundamental form L, M, N. Steps follow from that, so that two kernels that
agree on points and derivatives give the same samples: no search, no threshold that rounding could turn.
"""

from __future__ import annotations

from typing import List, NamedTuple, Sequence, Tuple

import numpy as np

_HAIR = 1e-6  # of a step; a count of steps that is whole but for rounding stays so
_LEAST_DENSITY = 0.02  # of the greatest; flat stretches of a bent curve get a few samples too
_LEAST_ALONG = 0.05  # of the greatest first derivative; towards a pole steps of the turning parameter vanish


class Side(NamedTuple):
    """One side of a four-sided face: parameters (K,) along it, rising, and numbers (K,) of the vertices there."""

    at: np.ndarray
    numbers: np.ndarray


class Bends(NamedTuple):
    """How a surface bends at u (U,) x v (V,): lengths of its first derivatives and |L|, |M|, |N|, all (U, V)."""

    u: np.ndarray
    v: np.ndarray
    along_u: np.ndarray
    along_v: np.ndarray
    uu: np.ndarray
    uv: np.ndarray
    vv: np.ndarray


def steps_per_unit(bend: np.ndarray, along: np.ndarray, deflection: float, angle: float) -> np.ndarray:
    """Return the least density of samples: steps per unit of the parameter.

    Parameters
    ----------
    bend : ndarray of shape (N,)
        Part of the second derivative across the first.
    along : ndarray of shape (N,)
        Length of the first derivative.
    deflection : float, mm
        Greatest distance of chords.
    angle : float
        Greatest angle between neighbouring chords.
    """
    return np.maximum(np.sqrt(bend / (8 * deflection)), bend / (np.maximum(along, 1e-12 * along.max()) * angle))


def spread(at: np.ndarray, density: np.ndarray, breaks: Sequence[float] = (), least: int = 1) -> np.ndarray:
    """Return parameters (K,) from the first to the last of ``at``, spaced by a density.

    Parameters
    ----------
    at : ndarray of shape (N,)
        Rising parameters, close enough for the density to be linear between them.
    density : ndarray of shape (N,)
        Samples per unit.
    breaks : sequence of float
        Parameters that must be among the samples, such as kinks.
    least : int
        Of steps between two breaks.
    """
    steps = _steps(at, density)
    ends = np.interp([at[0], *breaks, at[-1]], at, steps)
    found: List[np.ndarray] = []
    for low, high in zip(ends[:-1], ends[1:]):
        count = max(least, int(np.ceil(high - low - _HAIR)))
        found.append(np.interp(np.linspace(low, high, count + 1)[:-1], steps, at))
    return np.concatenate([*found, [float(at[-1])]])


def reached(at: np.ndarray, density: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Return how many steps (P,) lie between the start and places (P,), as ``spread`` counts them."""
    return np.interp(places, at, _steps(at, density))


def _steps(at: np.ndarray, density: np.ndarray) -> np.ndarray:
    density = np.maximum(density, max(_LEAST_DENSITY * float(density.max()), 1e-12 / float(at[-1] - at[0])))
    return np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2 * np.diff(at))])


def grid_densities(bends: Bends, deflection: float, angle: float) -> Tuple[np.ndarray, np.ndarray]:
    """Return densities over u and over v, both (U, V), of a grid whose diagonals keep the deflection."""
    along_u, along_v = (np.maximum(a, _LEAST_ALONG * a.max()) for a in (bends.along_u, bends.along_v))
    # 2 M du dv is at most M (|Su|/|Sv| du² + |Sv|/|Su| dv²)
    uu, vv = bends.uu + bends.uv * along_u / along_v, bends.vv + bends.uv * along_v / along_u
    over_u = steps_per_unit(uu, along_u, deflection, angle)
    over_v = steps_per_unit(vv, along_v, deflection, angle)
    least = 1 / np.ptp(bends.u), 1 / np.ptp(bends.v)  # a step is no longer than the face
    du, dv = 1 / np.maximum(over_u.max(1), least[0]), 1 / np.maximum(over_v.max(0), least[1])
    off = uu * du[:, None] ** 2 + vv * dv**2
    finer = np.sqrt(max(1.0, float(off.max()) / (8 * deflection)))
    return np.maximum(over_u * finer, least[0]), np.maximum(over_v * finer, least[1])


def even_steps(bends: Bends, densities: Tuple[np.ndarray, np.ndarray], ratio: float) -> Tuple[np.ndarray, np.ndarray]:
    """Return the densities, raised where steps one way are more than ``ratio`` times as long as the other way."""
    over_u, over_v = densities
    along_u, along_v = (np.maximum(a, _LEAST_ALONG * a.max()) for a in (bends.along_u, bends.along_v))
    of_u, of_v = over_u / along_u, over_v / along_v  # steps per mm
    return np.maximum(over_u, along_u * of_v / ratio), np.maximum(over_v, along_v * of_u / ratio)


def zipped(first: Side, second: Side) -> np.ndarray:
    """Return the triangles (K, 3) between two rows of vertices; from the first row to the second turns to the left.

    The row advances whose next step has its middle first, so that equal rows give the same triangles everywhere.
    """
    a, b = (np.asarray(side.at, float) for side in (first, second))
    middle_a, middle_b = (a[1:] + a[:-1]) / 2, (b[1:] + b[:-1]) / 2
    hair = _HAIR * max(np.ptp(a), np.ptp(b), 1e-300) / max(len(a), len(b))
    steps = np.concatenate([np.zeros(len(middle_a), int), np.ones(len(middle_b), int)])
    order = np.argsort(np.concatenate([middle_a - hair, middle_b]), kind="stable")
    of_second = steps[order]
    i = np.cumsum(1 - of_second) - (1 - of_second)
    j = np.cumsum(of_second) - of_second
    ahead = np.where(
        of_second, second.numbers[np.minimum(j + 1, len(b) - 1)], first.numbers[np.minimum(i + 1, len(a) - 1)]
    )
    return np.stack([first.numbers[i], ahead, second.numbers[j]], 1)


def four_sided(sides: Sequence[Side], u: np.ndarray, v: np.ndarray, inner: np.ndarray) -> np.ndarray:
    """Return the triangles (T, 3) of a face whose parameters fill a rectangle; counter-clockwise in (u, v).

    Parameters
    ----------
    sides : sequence of four Side
        Low v and high v (parameters u), low u and high u (parameters v), as the borders are sampled. A side that is
        one point (a pole) may name its vertex any number of times.
    u, v : ndarrays of shape (U,), (V,)
        Grid lines inside the rectangle.
    inner : ndarray of shape (U, V), int
        Numbers of the grid's vertices. Without any, the two longer opposite sides are joined.
    """
    low_v, high_v, low_u, high_u = sides
    if not inner.size:
        if max(len(low_u.at), len(high_u.at)) > max(len(low_v.at), len(high_v.at)):
            found = [zipped(low_u, high_u)[:, ::-1]]
        else:
            found = [zipped(low_v, high_v)]
    else:
        found = [
            zipped(low_v, Side(u, inner[:, 0])),
            zipped(high_v, Side(u, inner[:, -1]))[:, ::-1],
            zipped(low_u, Side(v, inner[0]))[:, ::-1],
            zipped(high_u, Side(v, inner[-1])),
        ]
        a, b, c, d = (part.ravel() for part in (inner[:-1, :-1], inner[1:, :-1], inner[1:, 1:], inner[:-1, 1:]))
        found += [np.stack([a, b, c], 1), np.stack([a, c, d], 1)]
    triangles = np.concatenate(found)
    return triangles[(triangles != np.roll(triangles, 1, 1)).all(1)]


def sagittas(vertices: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Return how far the longest edge's chord of each triangle lies off the surface, ndarray (T,), mm.

    Parameters
    ----------
    vertices, normals : ndarray of shape (T, 3, 3)
        Corners and the surface's unit normals there. On a circle |n1 - n0| = h/R, so h |n1 - n0|/8 is h²/8R.
    """
    along, turn = np.roll(vertices, -1, 1) - vertices, np.roll(normals, -1, 1) - normals
    return np.abs((along * turn).sum(2)).max(1) / 8


def facing(vertices: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Return the cosine (T,) of each triangle's normal with the mean of the surface's normals at its corners."""
    own = np.cross(vertices[:, 1] - vertices[:, 0], vertices[:, 2] - vertices[:, 0])
    mean = normals.sum(1)
    length = np.linalg.norm(own, axis=1) * np.linalg.norm(mean, axis=1)
    return (own * mean).sum(1) / np.maximum(length, 1e-300)
