# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compatible pairs of tables: alpha and beta whose layers all exist (thesis 6.2.4.3 and chapter 9).

Given alpha, a design with the counts along Y exists if and only if the k largest counts are at most
sum min(alpha, k) over all lines, for every k (Gale and Ryser, the lines (x, z) being rows of one matrix). So alpha is
checked once, and beta is then drawn row by row within what alpha leaves it: compatible by construction.
"""

from __future__ import annotations

from typing import List, NamedTuple, Optional, Tuple

import numpy as np

from ...errors import ExactnessError, InfeasibleError, ParameterError
from ..progress import Progress, part, silent
from ..streams import Stream
from .exact_search import is_small, searched_design
from .feasibility import caps_of, check_caps
from .layer_fill import layer_sums
from .masked_tables import masked_caps, masked_layers_exist, masked_pair
from .parameters import VoxelParameters
from .tables import SumError, Table, capped_ranks, fits, partner_ranks, solve_table, solve_thesis_table, table_errors
from .targets import Targets

#: Tables (N, P) and (M, P) that a pair shall be near to.
Wishes = Tuple[Optional[np.ndarray], Optional[np.ndarray]]

#: Fields of VoxelParameters that the tables heed.
TABLE_OPTIONS = ("cap_alpha", "cap_beta", "solver", "pairing", "tries", "boundary")
_SWITCHES = 20  # rounds of levelling switches, each of all pairs of rows


class TablePair(NamedTuple):
    """A compatible pair of tables.

    Attributes
    ----------
    alpha : ndarray of shape (N, P), int64
        Voxels in each line (x, z).
    beta : ndarray of shape (M, P), int64
        Voxels in each line (y, z).
    tries : int
        Pairs that were drawn until this one.
    redrawn, levelled : int
        Rows drawn again, and rows that were not drawn but chosen, so that the rest has a solution.
    """

    alpha: np.ndarray
    beta: np.ndarray
    tries: int
    redrawn: int
    levelled: int


class PairRates(NamedTuple):
    """How often tables drawn without regard for each other fit together.

    Attributes
    ----------
    pairs : int
        Pairs drawn.
    solved : int
        Pairs of which both tables came to their end.
    layers : float
        Share of compatible layers in those.
    compatible : int
        Pairs of which all layers are compatible.
    """

    pairs: int
    solved: int
    layers: float
    compatible: int


def compatible_layers(alpha: np.ndarray, beta: np.ndarray) -> np.ndarray:
    """Return which layers exist, ndarray of shape (P,), bool, by the condition of Gale and Ryser.

    Parameters
    ----------
    alpha : ndarray of shape (N, P), int
    beta : ndarray of shape (M, P), int

    Examples
    --------
    >>> compatible_layers(np.array([[2, 2], [0, 0]]), np.array([[1, 2], [1, 0]])).tolist()
    [True, False]
    """
    ranks = partner_ranks(alpha.T, len(beta), len(alpha))
    largest = np.sort(beta, axis=0)[::-1].cumsum(0).T
    return (largest <= ranks).all(1) & (alpha.sum(0) == beta.sum(0))


class PairErrors(NamedTuple):
    """What is wrong with given tables.

    Attributes
    ----------
    alpha, beta : lists of SumError
        Sums and cells; their rows are the layers along Z, their columns the lines along X or Y.
    layers : ndarray of int
        Layers along Z that no voxels can fill with these sums in columns and rows.
    """

    alpha: List[SumError]
    beta: List[SumError]
    layers: np.ndarray

    def __bool__(self) -> bool:
        return bool(self.alpha or self.beta or len(self.layers))

    def first(self) -> Tuple[str, int]:
        """Return the first wrong sum or cell in words, "" if all are right, and how many are wrong."""
        named = [f"table {name}: {one.words}" for name in ("alpha", "beta") for one in getattr(self, name)]
        return (named or [""])[0], len(named)


def pair_errors(
    targets: Targets,
    parameters: VoxelParameters,
    alpha: np.ndarray,
    beta: np.ndarray,
    mask: Optional[np.ndarray] = None,
) -> PairErrors:
    """Return what is wrong with given tables; layers are looked at when all sums and cells are right.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
        Its caps.
    alpha, beta : ndarrays of shape (N, P), (M, P), int
    mask : ndarray of shape (P, M, N), bool, optional

    Raises
    ------
    ParameterError
        If a table has another shape.
    """
    caps = caps_of(targets, parameters) if mask is None else masked_caps(targets, parameters, mask)
    first = table_errors(alpha.T, targets.c, targets.d, caps[0])
    second = table_errors(beta.T, targets.c, targets.e, caps[1])
    if first or second:
        return PairErrors(first, second, np.zeros(0, int))
    exist = compatible_layers(alpha, beta) if mask is None else masked_layers_exist(alpha, beta, mask)
    return PairErrors(first, second, np.flatnonzero(~exist))


def draw_pair(
    targets: Targets,
    parameters: VoxelParameters,
    progress: Progress = silent,
    mask: Optional[np.ndarray] = None,
    wishes: Wishes = (None, None),
) -> TablePair:
    """Return a random compatible pair of tables.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
        Solver, pairing, caps, tries, seed.
    progress : callable
    mask : ndarray of shape (P, M, N), bool, optional
        Cells that may be solid: each line has as many voxels at most as it has cells.
    wishes : pair of ndarrays (N, P), (M, P), optional
        Tables that alpha and beta shall be near to; only for pairs by constraint.

    Raises
    ------
    InfeasibleError
        If the caps or the mask allow no table.
    ExactnessError
        If no pair was compatible in the tries allowed.
    ParameterError
        If a mask is to be filled by try-and-repeat.
    DependencyError
        If there is a mask, and no scipy.
    """
    if targets.tables is not None:
        return given_pair(targets, parameters, mask)
    if mask is not None:
        return TablePair(*masked_pair(targets, parameters, mask, progress, wishes))
    stream = Stream(parameters.seed, "voxels", "tables")
    if parameters.pairing == "repeat":
        return _pair_by_repeating(targets, parameters, stream, progress)
    return _pair_by_constraint(targets, parameters, stream, progress, wishes)


def given_pair(targets: Targets, parameters: VoxelParameters, mask: Optional[np.ndarray] = None) -> TablePair:
    """Return the tables that came with the targets.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
        Its caps.
    mask : ndarray of shape (P, M, N), bool, optional

    Raises
    ------
    ParameterError
        If a sum is wrong or a cell beyond its cap; the first is named.
    InfeasibleError
        If layers of the two tables are not compatible; the first is named.
    """
    if targets.tables is None:
        raise ParameterError("given tables are needed, got none")
    alpha, beta = targets.tables
    errors = pair_errors(targets, parameters, alpha, beta, mask)
    words, count = errors.first()
    if count:
        raise ParameterError(f"{words}; {count} sums or cells are wrong")
    bad = errors.layers
    if len(bad):
        where = "" if mask is None else " within the mask"
        raise InfeasibleError(
            f"the tables are not compatible in layer {bad[0]} along Z, and {len(bad)} layers in all: no voxels{where} "
            "have these sums in columns and rows"
        )
    return TablePair(alpha, beta, 0, 0, 0)


def _pair_by_constraint(
    targets: Targets, parameters: VoxelParameters, stream: Stream, progress: Progress, wishes: Wishes
) -> TablePair:
    check_caps(targets, parameters)
    cap_alpha, cap_beta = caps_of(targets, parameters)
    n, m, _ = targets.layers
    ranks = capped_ranks(targets.c, n, cap_alpha)
    halves = part(progress, 0.0, 0.5), part(progress, 0.5, 1.0)
    near_alpha, near_beta = (None if wish is None else wish.T for wish in wishes)
    for attempt in range(1, min(parameters.tries, 8) + 1):
        first = solve_table(targets.c, targets.d, ranks, parameters.solver, stream, halves[0], near_alpha)
        for level in (False, True):
            cells = levelled_table(first.cells, cap_alpha, halves[0]) if level else first.cells
            partner = partner_ranks(cells, m, cap_beta)
            if fits(targets.e, partner.sum(0)):
                second = solve_table(targets.c, targets.e, partner, parameters.solver, stream, halves[1], near_beta)
                return _pair(cells, first, second, attempt)
    if is_small(targets):
        alpha, beta = layer_sums(searched_design(targets, parameters))
        return TablePair(alpha, beta, attempt, 0, 0)
    raise ExactnessError(
        f"no pair of tables was found in {attempt} tries that alpha <= {cap_alpha} and beta <= {cap_beta} allow: "
        "larger caps leave more room"
    )


def _pair(cells: np.ndarray, first: Table, second: Table, tries: int) -> TablePair:
    return TablePair(cells.T, second.cells.T, tries, first.redrawn + second.redrawn, first.levelled + second.levelled)


def _pair_by_repeating(targets: Targets, parameters: VoxelParameters, stream: Stream, progress: Progress) -> TablePair:
    for attempt in range(1, parameters.tries + 1):
        progress(attempt - 1, parameters.tries, "tables")
        pair = _independent_pair(targets, parameters, stream)
        if pair is not None and compatible_layers(*pair).all():
            return TablePair(pair[0], pair[1], attempt, 0, 0)
    raise ExactnessError(
        f"none of {parameters.tries} pairs of tables was compatible; pairing 'constraint' finds them by construction, "
        "and lower caps make them likelier"
    )


def _independent_pair(targets: Targets, parameters: VoxelParameters, stream: Stream) -> Optional[tuple]:
    """Alpha and beta drawn without regard for each other, or None after a dead end (thesis' solver)."""
    tables = []
    for columns, cap in zip((targets.d, targets.e), caps_of(targets, parameters)):
        if parameters.solver == "thesis":
            cells = solve_thesis_table(targets.c, columns, cap, stream)
        else:
            ranks = capped_ranks(targets.c, len(columns), cap)
            cells = solve_table(targets.c, columns, ranks, parameters.solver, stream).cells
        if cells is None:
            return None
        tables.append(cells.T)
    return tuple(tables)


def pair_rates(
    targets: Targets, parameters: VoxelParameters, pairs: int = 20, progress: Progress = silent
) -> PairRates:
    """Return how often the thesis' try-and-repeat succeeds with these caps and this solver.

    Parameters
    ----------
    targets : Targets
    parameters : VoxelParameters
    pairs : int
        Pairs to draw.
    progress : callable
    """
    stream = Stream(parameters.seed, "voxels", "rates")
    solved, layers, compatible = 0, 0.0, 0
    for done in range(pairs):
        progress(done, pairs, "rates of compatible tables")
        pair = _independent_pair(targets, parameters, stream)
        if pair is not None:
            good = compatible_layers(*pair)
            solved, layers, compatible = solved + 1, layers + float(good.mean()), compatible + int(good.all())
    return PairRates(pairs, solved, layers / max(solved, 1), compatible)


def levelled_table(cells: np.ndarray, cap: int, progress: Progress = silent) -> np.ndarray:
    """Return a table of the same sums whose cells are more even: the more even alpha is, the more counts along Y fit.

    Switches of 2 x 2 cells that lower the sum of squares, row after row, until none is left or the rounds are over.

    Parameters
    ----------
    cells : ndarray of shape (R, K), int
    cap : int
        Most in a cell.
    progress : callable
    """
    cells = cells.copy()
    for done in range(_SWITCHES):
        changed = False
        for i in range(len(cells)):
            progress(done + i / len(cells), _SWITCHES, "levelling tables")
            for j in range(i):
                gap = cells[i] - cells[j]
                high, low = int(np.argmax(gap)), int(np.argmin(gap))
                # moving one up the row i and down the row j is worth it while the gaps differ by more than 2
                step = (gap[high] - gap[low]) // 4
                step = min(step, cells[i, high], cells[j, low], cap - cells[j, high], cap - cells[i, low])
                if gap[high] - gap[low] > 2 and step == 0 and cells[i, high] and cells[j, low]:
                    step = min(1, cap - cells[j, high], cap - cells[i, low])
                if step > 0:
                    cells[i, high] -= step
                    cells[j, high] += step
                    cells[i, low] += step
                    cells[j, low] -= step
                    changed = True
        if not changed:
            break
    return cells
