# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outlines of a layer: squares that share a side melt into one polygon (thesis Fig. 6.12)."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

import numpy as np

from ..parameters import require

Corner = Tuple[int, int]


def layer_outlines(layer: np.ndarray) -> List[np.ndarray]:
    """Return the closed polygons that bound a layer's solid squares.

    Parameters
    ----------
    layer : ndarray of shape (M, N), bool
        Axes y, x.

    Returns
    -------
    list of ndarray (K, 2), int
        Corners (x, y) in squares from the low corner, no three of them in line, the first not repeated; outer polygons
        counter-clockwise, holes clockwise. Squares that touch by a corner alone stay apart. Sorted by their lowest,
        then leftmost corner.

    Raises
    ------
    ParameterError
        If the array has not two axes.

    Examples
    --------
    >>> [outline.tolist() for outline in layer_outlines(np.array([[1, 1], [1, 0]], bool))]
    [[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]]
    """
    require(layer.ndim == 2, "a layer must be an array of two axes", layer.shape)
    padded = np.pad(np.asarray(layer, bool), 1)
    ways = _ways(padded)
    outlines = []
    while ways:
        start = next(iter(ways))
        outlines.append(_walk(start, ways))
    turned = [_from_lowest(np.array(o)) for o in outlines]
    return sorted(turned, key=lambda o: (o[0, 1], o[0, 0]))


def _ways(padded: np.ndarray) -> Dict[Corner, List[Corner]]:
    """From each corner of the outlines the steps (dx, dy) that leave it, material on their left."""
    ways: Dict[Corner, List[Corner]] = {}
    # (void neighbour's place, first corner of the square's side there, step along it)
    sides = (((-1, 0), (0, 0), (1, 0)), ((0, 1), (1, 0), (0, 1)), ((1, 0), (1, 1), (-1, 0)), ((0, -1), (0, 1), (0, -1)))
    inner = padded[1:-1, 1:-1]
    for (dy, dx), (x0, y0), step in sides:
        beyond = padded[1 + dy : padded.shape[0] - 1 + dy, 1 + dx : padded.shape[1] - 1 + dx]
        rows, columns = np.nonzero(inner & ~beyond)
        for x, y in zip((columns + x0).tolist(), (rows + y0).tolist()):
            ways.setdefault((x, y), []).append(step)
    return ways


def _walk(start: Corner, ways: Dict[Corner, List[Corner]]) -> List[Corner]:
    """Take one outline's steps away and return its corners."""
    corners: List[Corner] = []
    place, came = start, ways[start][0]
    first = came
    while True:
        steps = ways[place]
        # where two squares meet by a corner: to the left, which keeps to the same square
        left = (-came[1], came[0])
        step = steps[0] if len(steps) == 1 or not corners and place == start else (left if left in steps else steps[0])
        if step != came or not corners:
            corners.append(place)
        steps.remove(step)
        if not steps:
            del ways[place]
        place, came = (place[0] + step[0], place[1] + step[1]), step
        if place == start and (start not in ways or _closes(came, first, ways[start])):
            break
    if came == first:  # the start lay in the midst of a side
        corners.pop(0)
    return corners


def _closes(came: Corner, first: Corner, left_over: Sequence[Corner]) -> bool:
    """Whether an outline that is back at a corner of two squares is whole, and not about to leave it once more."""
    left = (-came[1], came[0])
    return left == first or left not in left_over


def _from_lowest(corners: np.ndarray) -> np.ndarray:
    return np.roll(corners, -int(np.lexsort((corners[:, 0], corners[:, 1]))[0]), axis=0)


def corner_count(voxels: np.ndarray) -> int:
    """Return how many corners the outlines of a design's layers along Z have in all, without tracing them.

    A point is a corner when one or three of the four squares round it are solid, and two corners when two across a
    diagonal are. What wires and solids of the outlines will take is estimated from it.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    """
    total = 0
    for layer in voxels:
        bits = np.pad(layer, 1).view(np.uint8)
        a, b, c, d = bits[:-1, :-1], bits[:-1, 1:], bits[1:, :-1], bits[1:, 1:]
        around = a + b + c + d
        total += int((around % 2 == 1).sum()) + 2 * int(((around == 2) & (a == d)).sum())
    return total
