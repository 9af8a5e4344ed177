# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a design or a table exists, known beforehand, with the layers that contradict each other when it does not.

Tables: a table with given row and column sums and bounds exists if and only if no set of rows and columns asks for more
than its cells hold (Gale 1957, doi:10.2140/pjm.1957.7.1073; the cut of a flow). Designs: the same count for sets of
layers along X, Y and Z must hold; that is necessary.
"""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ...errors import InfeasibleError
from .parameters import VoxelParameters
from .targets import AXES, Targets, check_layers_hold

_NAMED = 6  # layers named in a message


class Shortfall(NamedTuple):
    """Columns of a table that ask for more than the rows can give them: the certificate that there is no table.

    Attributes
    ----------
    columns : ndarray of int
        The columns, fullest first.
    asked : int
        What they ask for together.
    given : int
        The most that all rows can give them.
    """

    columns: np.ndarray
    asked: int
    given: int


def table_shortfall(rows: np.ndarray, columns: np.ndarray, cap: int) -> Optional[Shortfall]:
    """Return the columns that ask for more than a table with cells 0..cap can give, or None if there is a table.

    Parameters
    ----------
    rows, columns : ndarrays of int, equal sums
        Sums of the table; its shape does not matter otherwise.
    cap : int
        Most in a cell.

    Notes
    -----
    The s fullest columns get at most sum_i min(row_i, s cap); when that is enough for every s, a table exists (Gale).

    Examples
    --------
    >>> table_shortfall(np.array([3, 1]), np.array([2, 2]), 2) is None
    True
    >>> table_shortfall(np.array([4, 0]), np.array([3, 1]), 2).columns.tolist()
    [0]
    """
    order = np.argsort(-columns, kind="stable")
    asked = np.cumsum(columns[order])
    given = most_given(rows, len(columns), cap)
    lack = asked - given
    worst = int(np.argmax(lack))
    if lack[worst] <= 0:
        return None
    return Shortfall(order[: worst + 1], int(asked[worst]), int(given[worst]))


def most_given(rows: np.ndarray, count: int, cap: int) -> np.ndarray:
    """Return the most that rows can give to s columns, s = 1..count: ndarray (count,) of sum_i min(row_i, s cap)."""
    ordered = np.sort(rows)
    below = np.concatenate([[0], np.cumsum(ordered)])
    tops = np.arange(1, count + 1) * cap
    small = np.searchsorted(ordered, tops, side="right")
    return below[small] + (len(ordered) - small) * tops


def forced_cells(counts: Sequence[np.ndarray]) -> Tuple[np.ndarray, np.ndarray]:
    """Return which cells are solid in every design, and which are void in every design; two bool (P, M, N).

    Parameters
    ----------
    counts : sequence of 3 int arrays
        Voxels of each layer along z, y, x.

    Notes
    -----
    Where the fullest layers along one axis ask for all that the layers along another can give them, the lines that are
    given whole are solid, and layers give nothing to the rest before these have all. Full and empty layers are of that
    kind. Then, until nothing changes: a layer that has its count has no more, one that needs all its cells has them.

    Examples
    --------
    >>> solid, void = forced_cells([np.array([2, 2]), np.array([2, 2]), np.array([4, 0])])
    >>> bool(solid[:, :, 0].all() and void[:, :, 1].all())
    True
    """
    shape = tuple(len(count) for count in counts)
    solid, void = np.zeros(shape, bool), np.zeros(shape, bool)
    for first, second in ((0, 1), (1, 0), (0, 2), (2, 0), (1, 2), (2, 1)):
        cap = shape[3 - first - second]
        rows, columns = counts[first], counts[second]
        order = np.argsort(-columns, kind="stable")
        lack = np.cumsum(columns[order]) - most_given(rows, len(columns), cap)
        of_solid, of_void = (np.moveaxis(cells, (first, second), (0, 1)) for cells in (solid, void))
        for width in np.flatnonzero(lack >= 0) + 1:
            of_solid[np.ix_(rows >= width * cap, np.isin(np.arange(len(columns)), order[:width]))] = True
            of_void[np.ix_(rows <= width * cap, np.isin(np.arange(len(columns)), order[width:]))] = True
    while True:
        before = np.count_nonzero(solid) + np.count_nonzero(void)
        for axis, count in enumerate(counts):
            of_solid, of_void = np.moveaxis(solid, axis, 0), np.moveaxis(void, axis, 0)
            done = of_solid.sum((1, 2)) == count
            of_void[done] |= ~of_solid[done]
            short = (~of_void).sum((1, 2)) == count
            of_solid[short] |= ~of_void[short]
        if np.count_nonzero(solid) + np.count_nonzero(void) == before:
            return solid, void


def smallest_cap(rows: np.ndarray, columns: np.ndarray) -> int:
    """Return the smallest cap with which a table of these sums exists.

    Examples
    --------
    >>> smallest_cap(np.array([4, 0]), np.array([3, 1]))
    3
    """
    low, high = 0, int(max(rows.max(), columns.max(), 0))
    while low < high:
        middle = (low + high) // 2
        if table_shortfall(rows, columns, middle) is None:
            high = middle
        else:
            low = middle + 1
    return low


def caps_of(targets: Targets, parameters: VoxelParameters) -> Tuple[int, int]:
    """Return the most voxels in a line (x, z) and in a line (y, z): M and N, or the caps chosen below them."""
    n, m, _ = targets.layers
    return min(parameters.cap_alpha or m, m), min(parameters.cap_beta or n, n)


def check_feasible(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray] = None) -> None:
    """Refuse targets that no design meets, as far as that is known beforehand.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
        Its caps.
    mask : ndarray of shape (P, M, N), bool, optional

    Raises
    ------
    InfeasibleError
        Naming the layers that contradict each other; for caps, the smallest possible.
    """
    if mask is not None:
        _check_mask_holds(targets, mask)
    _check_pairs(targets)
    _check_triples(targets)
    check_caps(targets, parameters)


def _check_mask_holds(targets: Targets, mask: np.ndarray) -> None:
    for axis, counts, across in zip(AXES, targets.counts, ((0, 1), (0, 2), (1, 2))):
        room = mask.sum(across, dtype=np.int64)
        over = np.flatnonzero(counts > room)
        if len(over):
            layer = int(over[0])
            raise InfeasibleError(
                f"within the mask layer {layer} along {axis.upper()} holds {room[layer]} voxels, but is asked for "
                f"{counts[layer]}"
            )


def _check_pairs(targets: Targets) -> None:
    """Tables over each pair of axes, whose cells are lines along the third."""
    for axis, counts, size in zip(AXES, targets.counts, targets.layer_sizes):
        check_layers_hold(axis, counts, size)
    for first, second, third in ((2, 0, 1), (2, 1, 0), (1, 0, 2)):
        rows, columns = targets.counts[first], targets.counts[second]
        lack = table_shortfall(rows, columns, targets.layers[third])
        if lack:
            raise InfeasibleError(
                f"{layers_in_words(lack.columns, AXES[second])} ask for {lack.asked} voxels together, but the layers "
                f"along {AXES[first].upper()} leave them at most {lack.given}"
            )


def _check_triples(targets: Targets) -> None:
    """Sets of the fullest layers along the three axes at once.

    A voxel counts once for each of its layers that is in the sets. Those that count more than the threshold (1 or 2)
    are no more than there are such cells. For r layers along X and s along Y, the layers along Z that make the bound
    sharpest are those above a slope.
    """
    d, e, c = (np.sort(counts)[::-1] for counts in targets.counts)
    n, m, p = targets.layers
    r, s = np.arange(n + 1)[:, None], np.arange(m + 1)[None, :]
    asked_xy = np.concatenate([[0], np.cumsum(d)])[:, None] + np.concatenate([[0], np.cumsum(e)])[None, :]
    asked_z = np.concatenate([[0], np.cumsum(c)])
    for threshold, base, slope in ((2, 0 * r * s, r * s), (1, r * s * p, r * m + n * s - r * s)):
        t = p - np.searchsorted(c[::-1], slope, side="right")  # layers with counts above the slope
        asked = asked_xy + asked_z[t]
        given = threshold * targets.total + base + slope * t
        worst = np.unravel_index(int(np.argmax(asked - given)), asked.shape)
        if asked[worst] > given[worst]:
            sets = (int(worst[0]), int(worst[1]), int(t[worst]))
            _refuse_triple(targets, sets, int(asked[worst]), int(given[worst]))


def _refuse_triple(targets: Targets, sizes: Tuple[int, int, int], asked: int, given: int) -> None:
    fullest = [np.argsort(-counts, kind="stable")[:k] for counts, k in zip(targets.counts, sizes)]
    words = [layers_in_words(chosen, axis) for chosen, axis in zip(fullest, AXES) if len(chosen)]
    raise InfeasibleError(
        f"{' and '.join(words)} ask for {asked} voxels together, each voxel counted in every such layer it lies in; "
        f"{targets.total} voxels give them at most {given}"
    )


def check_caps(targets: Targets, parameters: VoxelParameters) -> None:
    """Refuse caps on alpha or beta that leave no table.

    Raises
    ------
    InfeasibleError
        With the smallest possible cap.
    """
    cap_alpha, cap_beta = caps_of(targets, parameters)
    for name, axis, columns, cap in (("alpha", "x", targets.d, cap_alpha), ("beta", "y", targets.e, cap_beta)):
        lack = table_shortfall(targets.c, columns, cap)
        if lack:
            least = smallest_cap(targets.c, columns)
            raise InfeasibleError(
                f"the cap on {name} must be at least {least}, got {cap}: {layers_in_words(lack.columns, axis)} ask "
                f"for {lack.asked} voxels, and the layers along Z can give them {lack.given}"
            )


def layers_in_words(layers: np.ndarray, axis: str) -> str:
    """Return which layers, e.g. ``layers 2, 3 along X``."""
    chosen = sorted(int(i) for i in layers)
    named = ", ".join(str(i) for i in chosen[:_NAMED])
    if len(chosen) > _NAMED:
        named += f" ... ({len(chosen)} layers)"
    return f"layer{'s' if len(chosen) > 1 else ''} {named} along {axis.upper()}"
