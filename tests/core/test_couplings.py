# SPDX-License-Identifier: LGPL-2.1-or-later
"""Couplings: every site once, the smaller face fully used, local randomness, the thesis' table 4.2."""

import dataclasses
import itertools
from collections import Counter

import numpy as np
import pytest

from freecad_trabecula.core.couplings import couple
from freecad_trabecula.core.parameters import Coupling
from freecad_trabecula.core.sites import Sites
from freecad_trabecula.errors import ParameterError


def face(name, count, curved=False):
    points = np.stack([np.arange(count), np.zeros(count), np.zeros(count)], 1).astype(float)
    normals = np.tile([0.0, 0.0, 1.0], (count, 1))
    if curved:
        points[:, 2] = np.arange(count) ** 2
    index = np.stack([np.arange(count), np.zeros(count)], 1).astype(int)
    return Sites(name, index, points, np.tile([1.0, 0.0, 0.0], (count, 1)), normals, np.ones(count, bool))


def faces(**counts):
    return {name: face(name, n) for name, n in counts.items()}


def test_table_4_2_of_the_thesis_comes_out():
    # H gives 10 to D, where 7 are left: the thesis' row "D-I 21, 14, 14" starts from I's 31 - 17
    sites = faces(A=111, B=25, C=12, D=33, E=73, F=17, G=15, H=10, I=31, J=5, K=12, L=15)
    order = [("L", "C"), ("F", "I"), ("K", "D"), ("D", "I"), ("H", "D"), ("G", "B"), ("B", "L"), ("J", "B"), ("H", "B"),
             ("A", "E")]  # fmt: skip
    _, rows = couple([Coupling(a, b) for a, b in order], sites, 1)
    assert [r.rods for r in rows] == [12, 17, 12, 14, 7, 15, 3, 5, 2, 73]
    assert [(r.available_first, r.available_second) for r in rows] == [
        (15, 12), (17, 31), (12, 33), (21, 14), (10, 7), (15, 25), (10, 3), (5, 7), (3, 2), (111, 73),
    ]  # fmt: skip
    assert [(r.left_first, r.left_second) for r in rows] == [
        (3, 0), (0, 14), (0, 21), (7, 0), (3, 0), (0, 10), (7, 0), (0, 2), (1, 0), (38, 0),
    ]  # fmt: skip
    assert sum(r.rods for r in rows) == 160


@pytest.mark.parametrize("a, b", [(5, 9), (9, 5), (7, 7), (1, 30)])
def test_the_smaller_face_is_used_fully_and_no_site_twice(a, b):
    pairs, _ = couple([Coupling("A", "B")], faces(A=a, B=b), 4)
    assert len(pairs[0].first) == min(a, b)
    assert len(set(pairs[0].first.tolist())) == len(set(pairs[0].second.tolist())) == min(a, b)


def test_all_associations_are_equally_likely():
    seen = Counter(
        tuple(couple([Coupling("A", "B")], faces(A=3, B=3), seed)[0][0].second.tolist()) for seed in range(3000)
    )
    assert set(seen) == set(itertools.permutations(range(3)))
    assert sum((n - 500) ** 2 / 500 for n in seen.values()) < 20.5  # 99.9 % of chi squared with 5 degrees of freedom


def test_another_coupling_leaves_the_pairs_of_the_first_alone():
    sites = faces(A=20, B=20, C=9, D=9)
    alone = couple([Coupling("A", "B")], sites, 2)[0][0]
    both = couple([Coupling("C", "D"), Coupling("A", "B")], sites, 2)[0][1]
    assert (alone.second == both.second).all()


def test_a_site_switched_off_disturbs_few_pairs():
    sites = faces(A=40, B=40)
    before = dict(zip(*(v.tolist() for v in (couple([Coupling("A", "B")], sites, 2)[0][0].first,
                                            couple([Coupling("A", "B")], sites, 2)[0][0].second))))  # fmt: skip
    on = sites["A"].on.copy()
    on[7] = False
    sites["A"] = dataclasses.replace(sites["A"], on=on)
    pairs = couple([Coupling("A", "B")], sites, 2)[0][0]
    after = dict(zip(pairs.first.tolist(), pairs.second.tolist()))
    assert 7 not in after
    assert sum(after[k] != before[k] for k in after) < 12


def test_same_association_joins_equal_numbers():
    pairs, rows = couple([Coupling("A", "B", "same")], faces(A=6, B=4), 1)
    assert pairs[0].first.tolist() == pairs[0].second.tolist() == [0, 1, 2, 3]
    assert (rows[0].left_first, rows[0].left_second) == (2, 0)


def test_a_site_may_serve_several_couplings_if_asked():
    sites = faces(A=5, B=5, C=5)
    couplings = [Coupling("A", "B"), Coupling("A", "C", reuse=True)]
    assert [r.rods for r in couple(couplings, sites, 1)[1]] == [5, 5]
    assert [r.rods for r in couple([couplings[0], Coupling("A", "C")], sites, 1)[1]] == [5, 0]


def test_a_limit_and_a_switch_are_obeyed():
    sites = faces(A=5, B=5, C=5)
    _, rows = couple([Coupling("A", "B", on=False), Coupling("A", "C", limit=2)], sites, 1)
    assert [(r.first, r.second, r.rods) for r in rows] == [("A", "C", 2)]


def test_a_curved_face_is_joined_with_itself_by_distinct_sites():
    pairs, rows = couple([Coupling("A", "A")], {"A": face("A", 9, curved=True)}, 1)
    used = pairs[0].first.tolist() + pairs[0].second.tolist()
    assert len(used) == len(set(used)) == 8
    assert rows[0].left_first == 1


def test_a_flat_face_with_itself_is_refused():
    with pytest.raises(ParameterError, match="flat face A would lie in its plane"):
        couple([Coupling("A", "A")], faces(A=5), 1)


def test_an_unknown_or_empty_face_is_refused():
    with pytest.raises(ParameterError, match=r"\(A\), got 'Z'"):
        couple([Coupling("A", "Z")], faces(A=5), 1)
    with pytest.raises(ParameterError, match="at least 1 site, got 0 on face B"):
        couple([Coupling("A", "B")], faces(A=5, B=0), 1)
