# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compatible pairs of tables within a mask, where each line has a bound of its own: the cells of the mask in it.

A table exists if and only if a flow does, and so does the rest of one after each row that is drawn. Given alpha, all
voxels are one flow too, from the lines (x, z) through the cells of the mask and the lines (y, z) to the layers along Y:
beta is drawn as a table of its own, and then changed by as little as that flow asks for.
"""

from __future__ import annotations

from typing import Optional, Tuple

import numpy as np

from ...errors import ExactnessError, InfeasibleError, ParameterError
from ..progress import Progress, part, silent
from ..streams import Stream
from .exact_search import is_small, searched_design
from .feasibility import caps_of
from .flows import completed_table, greatest_flow, refuse_cut
from .layer_fill import layer_sums
from .masks import allowed_voxels
from .parameters import VoxelParameters
from .plane_offsets import FORBIDDEN, newton_offsets, polished, solid_of
from .tables import REDRAWS, Table, draw_row, start_near
from .targets import Targets
from .texture import Texture, trabecular_field

_PARTS = 1024  # weights of a draw are whole
_FREE_TRIES = 3  # pairs drawn freely; then alpha is that of voxels whose counts are nearly right


def masked_caps(targets: Targets, parameters: VoxelParameters, mask: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Return the most voxels in each line (x, z) and (y, z): ndarrays (P, N), (P, M), as the tables' rows lie."""
    cells = layer_sums(mask)
    alpha, beta = (np.minimum(table.T, cap) for table, cap in zip(cells, caps_of(targets, parameters)))
    return alpha, beta


def check_tables_exist(targets: Targets, parameters: VoxelParameters, mask: np.ndarray) -> None:
    """Refuse targets that no tables within a mask meet.

    Raises
    ------
    InfeasibleError
        Naming the layers of two axes that contradict each other.
    """
    caps_alpha, caps_beta = masked_caps(targets, parameters, mask)
    for first, second, caps in (("z", "x", caps_alpha), ("z", "y", caps_beta), ("y", "x", mask.sum(0))):
        rows, columns = (targets.counts["xyz".index(axis)] for axis in (first, second))
        cut = completed_table(rows, columns, caps)[1]
        if cut is not None:
            refuse_cut(cut, first, second, "within the mask" + _caps_in_words(parameters))


def _caps_in_words(parameters: VoxelParameters) -> str:
    caps = [(name, getattr(parameters, f"cap_{name}")) for name in ("alpha", "beta")]
    named = " and ".join(f"a cap of {cap} on {name}" for name, cap in caps if cap)
    return f" and with {named}" if named else ""


def masked_pair(
    targets: Targets,
    parameters: VoxelParameters,
    mask: np.ndarray,
    progress: Progress = silent,
    wishes: Tuple[Optional[np.ndarray], Optional[np.ndarray]] = (None, None),
) -> Tuple[np.ndarray, np.ndarray, int, int, int]:
    """Return alpha (N, P), beta (M, P), and how many pairs and rows were drawn again; as ``table_pairs.draw_pair``.

    Raises
    ------
    InfeasibleError
        If no tables exist within the mask, with the layers that contradict; of a small mask, if no design does.
    ExactnessError
        If none of the alphas drawn leaves a beta.
    ParameterError
        If pairs are to be found by try-and-repeat.
    DependencyError
        If scipy is missing.
    """
    if parameters.pairing == "repeat":
        raise ParameterError("pairing 'repeat' fills boxes only; pairing 'constraint' works within a mask")
    check_tables_exist(targets, parameters, mask)
    caps_alpha, caps_beta = masked_caps(targets, parameters, mask)
    stream = Stream(parameters.seed, "voxels", "tables")
    tries = min(parameters.tries, 8)
    for attempt in range(tries):
        step = part(progress, attempt / tries, (attempt + 1) / tries)
        if attempt >= _FREE_TRIES:
            if is_small(targets, mask):
                break
            wishes = _nearly_right(targets, mask, parameters.seed, attempt, part(step, 0.0, 0.4))
        near = [None if wish is None else wish.T for wish in wishes]
        first = draw_table(targets.c, targets.d, caps_alpha, parameters.solver, stream, part(step, 0.4, 0.6), near[0])
        second = draw_table(targets.c, targets.e, caps_beta, parameters.solver, stream, part(step, 0.6, 0.8), near[1])
        step(0.8, 1.0, "tables")
        beta = compatible_beta(targets.e, first.cells, second.cells, caps_beta, mask)
        if beta is not None:
            redrawn, other = first.redrawn + second.redrawn, first.levelled + second.levelled
            return first.cells.T, beta.T, attempt + 1, redrawn, other
    if is_small(targets, mask):
        return (*layer_sums(searched_design(targets, parameters, mask)), tries, 0, 0)
    raise ExactnessError(
        f"no pair of tables was found within the mask in {tries} tries{_caps_in_words(parameters)}; strategy "
        "trabecular, which needs no tables, may find a design"
    )


def _nearly_right(
    targets: Targets, mask: np.ndarray, seed: int, attempt: int, progress: Progress
) -> Tuple[np.ndarray, np.ndarray]:
    """Tables of voxels within the mask, along a random field, whose counts are nearly those asked for."""
    field = trabecular_field(Texture((8.0,) * 3), targets.shape, seed, ("tables", attempt), progress)
    return layer_sums(solid_near(field, targets, mask, progress))


def solid_near(
    field: np.ndarray, targets: Targets, mask: Optional[np.ndarray], progress: Progress = silent
) -> np.ndarray:
    """Return voxels where a field is high, (P, M, N) bool, whose counts are nearly those asked for.

    Parameters
    ----------
    field : ndarray of shape (P, M, N), float32
        Multiples of ``texture.QUANTUM``; changed outside the mask.
    targets : Targets
    mask : ndarray of shape (P, M, N), bool, or None
    progress : callable
    """
    counts = [targets.c, targets.e, targets.d]
    allowed = allowed_voxels(counts, mask)
    if allowed is not None:
        if not allowed.any():
            return allowed
        field[~allowed] = FORBIDDEN
    offsets = newton_offsets(field, counts, progress=part(progress, 0.0, 0.6))
    return solid_of(field, polished(field, counts, offsets, progress=part(progress, 0.6, 1.0)))


def draw_table(
    rows: np.ndarray,
    columns: np.ndarray,
    caps: np.ndarray,
    solver: str,
    stream: Stream,
    progress: Progress = silent,
    wish: Optional[np.ndarray] = None,
) -> Table:
    """Return a random table with the given sums, each cell within its own bound; it never runs into a dead end.

    After each row a flow says whether the rest still has a solution; a row that leaves none is drawn again, and after
    some times taken from the solution that the last flow found.

    Parameters
    ----------
    rows, columns : ndarrays of shape (R,), (K,), int
    caps : ndarray of shape (R, K), int
    solver : str
        ``thesis``: every increment takes any cell with the same probability; ``proportional``: in proportion to what
        its column still needs and the share of the column's cells that this row has.
    stream : Stream
    progress : callable
    wish : ndarray of shape (R, K), int, optional
        Each row starts there.

    Raises
    ------
    InfeasibleError
        If there is no such table.
    """
    witness, cut = completed_table(rows, columns, caps)
    if cut is not None:
        raise InfeasibleError(
            f"no table has these sums: columns {cut.columns.tolist()} ask for {cut.asked}, and the rows can give them "
            f"{cut.held + cut.others}"
        )
    after = np.vstack([caps[::-1].cumsum(0)[::-1], np.zeros((1, len(columns)), np.int64)])
    cells, rest = np.zeros(caps.shape, np.int64), np.array(columns, np.int64)
    redrawn = kept = 0
    for i, total in enumerate(rows):
        progress(i, len(rows), "tables")
        low, high = np.maximum(rest - after[i + 1], 0), np.minimum(rest, caps[i])
        weights = np.ones_like(rest) if solver == "thesis" else rest * caps[i] * _PARTS // np.maximum(after[i], 1) + 1
        for _ in range(REDRAWS):
            start = low if wish is None else start_near(wish[i], int(total), low, high, stream)
            row = draw_row(int(total), start, high, weights, stream)
            if row is not None:
                found, cut = completed_table(rows[i + 1 :], rest - row, caps[i + 1 :])
                if cut is None:
                    witness = found
                    break
            redrawn += 1
        else:
            row, witness = witness[0], witness[1:]
            kept += 1
        cells[i] = row
        rest -= row
    return Table(cells, redrawn, kept)


def compatible_beta(
    counts: np.ndarray, alpha: np.ndarray, wish: np.ndarray, caps: np.ndarray, mask: np.ndarray
) -> Optional[np.ndarray]:
    """Return a beta, (P, M) int64, of which with alpha every layer exists within the mask; None if there is none.

    Parameters
    ----------
    counts : ndarray of shape (M,), int
        Voxels asked for in each layer along Y.
    alpha : ndarray of shape (P, N), int
        Voxels in each line (x, z).
    wish : ndarray of shape (P, M), int, within ``caps``
        The beta that it shall be near to: what the flow has within it is kept, and changed by as little as can be.
    caps : ndarray of shape (P, M), int
        Most voxels in a line (y, z).
    mask : ndarray of shape (P, M, N), bool

    Raises
    ------
    DependencyError
        If scipy is missing.
    """
    p, m, n = mask.shape
    z, y, x = np.nonzero(mask)
    lines, cells, planes = p * n, p * m, np.arange(m)
    source, sink = lines + cells + m, lines + cells + m + 1
    middle = lines + np.arange(cells)
    tails = np.concatenate([np.full(lines, source), z * n + x, middle, lines + cells + planes])
    heads = np.concatenate([np.arange(lines), lines + z * m + y, lines + cells + np.tile(planes, p), np.full(m, sink)])
    start, own = None, slice(lines + len(z), lines + len(z) + cells)
    for bounds in (wish, caps):
        capacities = np.concatenate([alpha.ravel(), np.ones(len(z), np.int64), bounds.ravel(), counts])
        flow = greatest_flow(tails, heads, capacities, sink + 1, start)
        start = flow.amounts
    return flow.amounts[own].reshape(p, m) if flow.total == int(counts.sum()) else None


def masked_layers_exist(alpha: np.ndarray, beta: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """Return which layers exist within a mask, ndarray of shape (P,), bool, by a flow each.

    Parameters
    ----------
    alpha, beta : ndarrays of shape (N, P), (M, P), int
    mask : ndarray of shape (P, M, N), bool
    """
    return np.array(
        [
            int(alpha[:, k].sum()) == int(beta[:, k].sum())
            and completed_table(beta[:, k], alpha[:, k], mask[k].astype(np.int64))[1] is None
            for k in range(len(mask))
        ]
    )
