# SPDX-License-Identifier: LGPL-2.1-or-later
"""List ranking against walking link by link."""

import numpy as np
import pytest

from freecad_trabecula.core.analysis.chains import order_chains


def scrambled(lengths, open_ones):
    """Links, group of each node, and the chains they were made from, nodes numbered as if by chance."""
    total = sum(lengths)
    names = np.argsort((np.arange(total, dtype=np.uint64) + np.uint64(5)) * np.uint64(0x9E3779B97F4A7C15))
    follow, group, chains, first = np.empty(total, np.int32), np.empty(total, np.int32), [], 0
    for k, length in enumerate(lengths):
        chain = names[first : first + length]
        follow[chain] = np.roll(chain, -1)
        if k in open_ones:
            follow[chain[-1]] = chain[-1]
        group[chain] = k % 3
        chains.append(chain.tolist())
        first += length
    return follow, group, chains


@pytest.mark.parametrize("lengths", [[1], [1, 1, 2, 3], [5000], [17, 400, 1, 90, 33, 2500, 3]])
@pytest.mark.parametrize("open_ones", [(), (0, 2, 5)])
def test_chains_and_rings_come_out_in_their_own_order_and_that_of_their_groups(lengths, open_ones):
    follow, group, chains = scrambled(lengths, open_ones)
    ranked = order_chains(follow, group)
    nodes = np.empty(len(follow), int)
    nodes[ranked.place] = np.arange(len(follow))
    assert ranked.group.tolist() == sorted(ranked.group.tolist())
    found = {}
    for part, which in zip(np.split(nodes, np.cumsum(ranked.sizes)[:-1]), ranked.group):
        assert (group[part] == which).all()
        assert (follow[part[:-1]] == part[1:]).all()
        assert follow[part[-1]] in (part[0], part[-1])
        found[min(part)] = len(part)
    assert found == {min(chain): len(chain) for chain in chains}
    for k in open_ones:
        if k < len(chains):  # an open chain begins at its start
            first = ranked.place[chains[k][0]]
            assert ranked.place[chains[k]].tolist() == list(range(first, first + len(chains[k])))


def test_no_nodes_have_no_chains():
    ranked = order_chains(np.zeros(0, np.int32), np.zeros(0, np.int32))
    assert len(ranked.place) == len(ranked.sizes) == len(ranked.group) == 0
