# SPDX-License-Identifier: LGPL-2.1-or-later
"""Greatest flows in networks of whole capacities, and tables whose cells have a bound each, which are such flows.

A table with given sums is a flow from its rows to its columns. When there is none, the least cut names rows and columns
that contradict each other (Gale 1957, doi:10.2140/pjm.1957.7.1073). scipy finds the flows (Dinic's algorithm).
"""

from __future__ import annotations

from typing import NamedTuple, Optional, Tuple

import numpy as np

from ...errors import InfeasibleError
from ..optional_packages import optional_module
from .feasibility import layers_in_words


class Flow(NamedTuple):
    """A greatest flow.

    Attributes
    ----------
    amounts : ndarray of shape (arcs,), int64
    total : int
        What reaches the sink.
    reached : ndarray of shape (nodes,), bool
        Nodes to which more could flow from the source: its side of the least cut.
    """

    amounts: np.ndarray
    total: int
    reached: np.ndarray


def greatest_flow(
    tails: np.ndarray, heads: np.ndarray, capacities: np.ndarray, nodes: int, start: Optional[np.ndarray] = None
) -> Flow:
    """Return a greatest flow from the last node but one to the last.

    Parameters
    ----------
    tails, heads, capacities : ndarrays of shape (arcs,), int
        No two arcs join the same nodes.
    nodes : int
    start : ndarray of shape (arcs,), int, optional
        A flow that there is already; as little of it as can be is led elsewhere.

    Raises
    ------
    DependencyError
        If scipy is missing or too old.

    Examples
    --------
    >>> flow = greatest_flow(np.array([2, 0, 1]), np.array([0, 1, 3]), np.array([3, 2, 5]), 4)
    >>> flow.amounts.tolist(), flow.reached.tolist()
    ([2, 2, 2], [True, False, True, False])
    """
    purpose = "tables within a mask need scipy 1.6 or later"
    graphs = optional_module("scipy.sparse.csgraph", purpose, "maximum_flow")
    csr_matrix = optional_module("scipy.sparse", purpose).csr_matrix
    amounts = np.zeros(len(tails), np.int64) if start is None else np.array(start, np.int64)
    both = np.concatenate([tails, heads]), np.concatenate([heads, tails])
    room = np.concatenate([capacities - amounts, amounts]).astype(np.int32)
    left = csr_matrix((room, both), shape=(nodes, nodes))
    left.eliminate_zeros()
    found = graphs.maximum_flow(left, nodes - 2, nodes - 1)
    more = found.flow if hasattr(found, "flow") else found.residual  # the name before scipy 1.9
    amounts += np.asarray(more[tails, heads]).ravel()
    rest = csr_matrix(left - more)
    rest.eliminate_zeros()
    reached = np.zeros(nodes, bool)
    reached[graphs.breadth_first_order(rest, nodes - 2, return_predecessors=False)] = True
    return Flow(amounts, int(amounts[heads == nodes - 1].sum()), reached)


class Cut(NamedTuple):
    """Why a table does not exist: these columns ask for more than the rows can give them.

    Attributes
    ----------
    rows : ndarray of int
        Rows that hold in these columns only what their cells' bounds allow.
    columns : ndarray of int
    asked, held : int
        By the columns together; by the rows' cells in them.
    others : int
        The sums of all other rows.
    """

    rows: np.ndarray
    columns: np.ndarray
    asked: int
    held: int
    others: int


def completed_table(
    rows: np.ndarray, columns: np.ndarray, caps: np.ndarray, start: Optional[np.ndarray] = None
) -> Tuple[np.ndarray, Optional[Cut]]:
    """Return a table with the given sums, cells 0..caps, (R, K) int64, and the cut that forbids it: None if it exists.

    Parameters
    ----------
    rows, columns : ndarrays of shape (R,), (K,), int, equal sums
    caps : ndarray of shape (R, K), int
        Most in each cell.
    start : ndarray of shape (R, K), int, optional
        Cells to begin with, within ``caps``; none of their sums above the one asked for. As few as can be are changed.

    Raises
    ------
    DependencyError
        If scipy is missing.

    Examples
    --------
    >>> completed_table(np.array([1, 2]), np.array([2, 1]), np.array([[1, 0], [2, 1]]))
    (array([[1, 0],
           [1, 1]]), None)
    """
    count, width = caps.shape
    source, sink = count + width, count + width + 1
    i, j = np.nonzero(caps)
    tails = np.concatenate([np.full(count, source), i, count + np.arange(width)])
    heads = np.concatenate([np.arange(count), count + j, np.full(width, sink)])
    capacities = np.concatenate([rows, caps[i, j], columns]).astype(np.int64)
    first = None if start is None else np.concatenate([start.sum(1), start[i, j], start.sum(0)])
    flow = greatest_flow(tails, heads, capacities, sink + 1, first)
    cells = np.zeros((count, width), np.int64)
    cells[i, j] = flow.amounts[count : count + len(i)]
    if flow.total == int(np.sum(columns)):
        return cells, None
    these, those = np.flatnonzero(flow.reached[:count]), np.flatnonzero(~flow.reached[count:source])
    held, others = int(caps[np.ix_(these, those)].sum()), int(np.sum(rows) - np.sum(rows[these]))
    return cells, Cut(these, those, int(columns[those].sum()), held, others)


def refuse_cut(cut: Cut, row_axis: str, column_axis: str, where: str) -> None:
    """Say why a table of layers along two axes does not exist.

    Raises
    ------
    InfeasibleError
        Always, naming the layers.
    """
    text = f"{where} {layers_in_words(cut.columns, column_axis)} ask for {cut.asked} voxels together, but "
    if len(cut.rows):
        text += f"{layers_in_words(cut.rows, row_axis)} have {cut.held} cells for them, and "
    raise InfeasibleError(f"{text}the other layers along {row_axis.upper()} are asked for {cut.others} in all")
