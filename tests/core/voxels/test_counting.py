# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of solutions: against lists of all of them, closed forms and the literature."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.counting import (
    bounded_solutions,
    count_designs,
    count_systems,
    counting_record,
    free_solutions,
    log10_of,
    row_designs,
)
from freecad_trabecula.core.voxels.design import VoxelDesign, make_design
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.targets import targets_of_voxels
from freecad_trabecula.errors import ParameterError


@pytest.mark.parametrize("n", range(9))
def test_solutions_are_as_many_as_there_are(n):
    most, least = [4, 2, 3], [1, 0, 2]
    free = [x for x in itertools.product(range(n + 1), repeat=3) if sum(x) == n]
    assert free_solutions(n, 3) == len(free)
    within = [x for x in free if all(low <= v <= high for v, low, high in zip(x, least, most))]
    assert bounded_solutions(n, most, least) == len(within)


def test_the_example_of_the_thesis():
    # 6.2.2.1: n = 1220, k = 103; bounds that hold everything change nothing
    assert free_solutions(1220, 103) == math.comb(1322, 102) == bounded_solutions(1220, [1220] * 103)
    assert log10_of(free_solutions(1220, 103)) == pytest.approx(154.645, abs=1e-3)
    assert bounded_solutions(1220, [94] * 103) < free_solutions(1220, 103)


def test_one_row_of_the_thesis():
    # 6.2.4: N = 103 and 50 voxels; with v columns without need fewer
    assert row_designs(103, 50) == math.factorial(103) // (math.factorial(50) * math.factorial(53))
    assert row_designs(103, 50, 3) == math.comb(100, 50)
    # the same as an equation whose variables lie between 0 and 1
    assert row_designs(20, 7) == bounded_solutions(7, [1] * 20)


def test_bounds_that_leave_nothing_have_no_solution():
    assert bounded_solutions(10, [3, 3, 3]) == 0
    assert bounded_solutions(1, [3, 3], [1, 1]) == 0
    assert bounded_solutions(2, [0, 3], [1, 1]) == 0


def test_designs_of_a_small_box_are_about_as_many_as_there_are():
    # all pairs of layers of 3 x 4, by their sums along x and y
    layers = np.array(list(itertools.product((0, 1), repeat=12))).reshape(-1, 3, 4)
    sums = np.hstack([layers.sum(1), layers.sum(2)])
    voxels = np.array([[[1, 0, 1, 0], [0, 1, 0, 1], [1, 0, 0, 1]], [[0, 1, 0, 1], [1, 0, 1, 0], [0, 1, 1, 0]]], bool)
    targets = targets_of_voxels(voxels)
    asked = np.concatenate([targets.d, targets.e])
    index = {}
    for row, count in zip(*np.unique(sums, axis=0, return_counts=True)):
        index[tuple(row)] = int(count)
    exact = sum(
        count * index.get(tuple(asked - row), 0) for row, count in index.items() if sum(row) == 2 * targets.c[0]
    )
    found = count_designs(targets, Stream(1, "designs"))
    assert found.log10 == pytest.approx(math.log10(exact), abs=4 * found.standard_error)
    assert found.standard_error < 0.05


def test_empty_and_full_layers_leave_nothing_to_choose():
    inner = Stream(1, "v").many(64).reshape(4, 4, 4) < 0.5
    wrapped = np.zeros((6, 4, 4), bool)
    wrapped[1:5] = inner
    wrapped[5] = True
    own, around = (count_designs(targets_of_voxels(v), Stream(1, "designs")).log10 for v in (inner, wrapped))
    assert around == pytest.approx(own, abs=1e-6)


def test_a_design_is_counted_with_its_tables():
    voxels = Stream(2, "v").many(6 * 7 * 8).reshape(6, 7, 8) < 0.4
    design = make_design(targets_of_voxels(voxels), VoxelParameters(strategy="minimum-zeros"))
    counts = count_systems(design)
    assert all(math.isfinite(c.log10) and c.log10 > 0 for c in counts)
    assert counts.layers.log10 < counts.designs.log10 + 1
    again = count_systems(design)
    assert [c.log10 for c in again] == [c.log10 for c in counts]
    assert all(row["samples"] > 0 and row["standard_error"] >= 0 for row in counting_record(design).values())


@pytest.mark.parametrize(("most", "least"), [([1], [0, 0]), ([], []), ([3], [-1])])
def test_bounds_that_cannot_be_are_refused(most, least):
    with pytest.raises(ParameterError, match="two bounds|must not be negative"):
        bounded_solutions(2, most, least)


def test_a_design_in_a_mask_is_not_counted():
    voxels = np.eye(3, dtype=bool)[None]
    design = VoxelDesign(voxels, targets_of_voxels(voxels), VoxelParameters(strategy="minimum-zeros"), voxels)
    with pytest.raises(ParameterError, match="counted in boxes, not in, got a mask"):
        count_systems(design)


def test_an_equation_without_variables_is_refused():
    with pytest.raises(ParameterError, match="k >= 1"):
        free_solutions(3, 0)
