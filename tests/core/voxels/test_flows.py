# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flows and tables whose cells have a bound each, against every table and every cut."""

from __future__ import annotations

import itertools
import sys

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.flows import completed_table, greatest_flow, refuse_cut
from freecad_trabecula.errors import DependencyError, InfeasibleError


def test_the_greatest_flow_is_the_smallest_of_all_cuts():
    for seed in range(30):
        capacities = (Stream(seed, "arcs").uniform(25) * 6).astype(int).reshape(5, 5)
        capacities[np.tril_indices(5)] = 0
        capacities[4] = 0
        order = [3, 0, 1, 2, 4]  # the source is the last node but one
        full = np.zeros((5, 5), int)
        full[np.ix_(order, order)] = capacities
        tails, heads = np.nonzero(full)
        flow = greatest_flow(tails, heads, full[tails, heads], 5)
        cuts = []
        for inner in itertools.product((False, True), repeat=3):
            side = np.array([*inner, True, False])
            cuts.append(int(full[np.ix_(side, ~side)].sum()))
        assert flow.total == min(cuts) == int(full[np.ix_(flow.reached, ~flow.reached)].sum())
        assert ((flow.amounts >= 0) & (flow.amounts <= full[tails, heads])).all()
        for node in range(3):
            assert flow.amounts[heads == node].sum() == flow.amounts[tails == node].sum()


def tables_there_are(caps):
    """Row and column sums of every table with cells 0..caps."""
    found = set()
    for cells in itertools.product(*(range(cap + 1) for cap in caps.ravel())):
        table = np.array(cells).reshape(caps.shape)
        found.add((tuple(table.sum(1).tolist()), tuple(table.sum(0).tolist())))
    return found


@pytest.mark.parametrize("seed", range(12))
def test_a_table_is_found_exactly_when_there_is_one_and_its_cut_proves_that_there_is_none(seed):
    caps = (Stream(seed, "caps").uniform(6) * 3.2).astype(int).reshape(2, 3)
    exist = tables_there_are(caps)
    for rows in itertools.product(range(6), repeat=2):
        for columns in itertools.product(range(5), repeat=3):
            if sum(rows) != sum(columns):
                continue
            cells, cut = completed_table(np.array(rows), np.array(columns), caps)
            assert (cut is None) == ((rows, columns) in exist)
            if cut is None:
                assert (cells.sum(1) == rows).all() and (cells.sum(0) == columns).all()
                assert ((cells >= 0) & (cells <= caps)).all()
            else:
                others = [r for i, r in enumerate(rows) if i not in cut.rows]
                assert cut.asked == sum(columns[j] for j in cut.columns)
                assert cut.held == caps[np.ix_(cut.rows, cut.columns)].sum() and cut.others == sum(others)
                assert cut.asked > cut.held + cut.others


def test_what_is_begun_stays_where_it_may():
    start = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 0]])
    cells, cut = completed_table(np.ones(3, int), np.ones(3, int), np.ones((3, 3), int), start)
    assert cut is None and (cells == np.eye(3, dtype=int)).all()


def test_a_cut_is_told_by_its_layers():
    _, cut = completed_table(np.array([2, 1]), np.array([3, 0]), np.array([[1, 2], [1, 2]]))
    with pytest.raises(InfeasibleError, match="here layer 0 along X ask for 3 voxels together, but layer"):
        refuse_cut(cut, "z", "x", "here")


def test_without_scipy_it_says_what_is_missing(monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.sparse", None)
    with pytest.raises(DependencyError, match="need scipy 1.6 or later; install it with: .*pip install scipy"):
        completed_table(np.ones(1, int), np.ones(1, int), np.ones((1, 1), int))
