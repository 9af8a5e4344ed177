# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs by every strategy that fills tables: exact, repeatable, cancelled, refused."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.design import estimate, make_design, target_notes
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.targets import Targets, targets_from_areas, targets_of_voxels
from freecad_trabecula.core.voxels.verification import layer_errors
from freecad_trabecula.errors import Cancelled, InfeasibleError, ParameterError

STRATEGIES = ("minimum-zeros", "sequential", "random-layers", "best-tables", "by-field")


def chosen(strategy="minimum-zeros", **more):
    return VoxelParameters(strategy=strategy, **more)


def random_targets(seed=1, shape=(14, 13, 12)):
    bits = Stream(seed, "test").many(int(np.prod(shape))).reshape(shape)
    return targets_of_voxels(bits < 0.1 + 0.3 * np.linspace(0, 1, shape[1])[:, None])


@pytest.mark.parametrize("strategy", STRATEGIES)
@pytest.mark.parametrize("direction", ["rows", "columns"])
def test_every_strategy_is_exact_on_three_axes(strategy, direction):
    design = make_design(random_targets(), chosen(strategy, direction=direction))
    assert layer_errors(design.voxels, design.targets) == []
    assert (design.alpha.sum(1) == design.targets.d).all() and (design.beta.sum(1) == design.targets.e).all()


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_the_same_seed_gives_the_same_design_and_another_seed_another(strategy):
    first, again, other = (make_design(random_targets(), chosen(strategy, seed=s)).voxels for s in (3, 3, 4))
    assert (first == again).all() and (first != other).any()


def test_the_thesis_cases_are_exact_and_take_less_than_a_second():
    # a sample of the size, density and unevenness of the thesis': 103 x 94 x 103, 172466 voxels
    wave = [1 + 0.3 * np.sin(np.linspace(0, 7, n)) for n in (103, 94, 103)]
    areas = [w / w.sum() * 1724.66 for w in wave]
    for strategy, cap in (("minimum-zeros", 40), ("sequential", 30)):
        targets = targets_from_areas(areas, chosen(correction="random", total="z"))
        assert targets.total == 172466
        start = time.process_time()
        design = make_design(targets, chosen(strategy, cap_alpha=cap, cap_beta=cap, solver="thesis"))
        assert time.process_time() - start < 1.0
        assert design.alpha.max() <= cap and design.beta.max() <= cap


def test_a_field_draws_the_voxels_to_where_it_is_high():
    targets = targets_of_voxels(np.indices((12, 12, 12)).sum(0) % 4 == 0)
    middle = np.zeros((12, 12, 12), bool)
    middle[3:9, 3:9, 3:9] = True
    inside = {f: make_design(targets, chosen("by-field", field=f)).voxels[middle].sum() for f in ("centre", "border")}
    assert inside["centre"] > inside["border"]


def test_layers_that_are_empty_between_others_are_told():
    voxels = np.zeros((5, 4, 4), bool)
    voxels[[0, 4]] = True
    assert any("layer 1 along Z is empty between others" in note for note in target_notes(targets_of_voxels(voxels)))


def test_a_sample_thinner_than_three_voxels_is_warned_of():
    thin = replace(random_targets(), thickness=0.15)
    assert "mean thickness is 1.5 voxels; below 3" in target_notes(thin)[0]
    assert "voxels of 0.05 mm would resolve them" in target_notes(thin)[0]
    assert target_notes(replace(thin, thickness=0.4)) == ()


def test_an_estimate_grows_with_the_cells():
    small, large = estimate((100, 100, 100), "minimum-zeros"), estimate((200, 200, 200), "minimum-zeros")
    assert large.cells == 8 * small.cells and large.seconds == pytest.approx(8 * small.seconds)
    assert "200 x 200 x 200 layers, 8,000,000 cells" in large.words


def test_cancelling_stops_the_design():
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        make_design(random_targets(), chosen(), progress=stop)


# ------------------------------------------------------------------------------------------------------- refusals


def test_targets_without_a_design_are_refused_before_any_strategy_runs():
    counts = [np.array(c) for c in ((4, 2), (4, 2), (4, 2, 0))]
    for strategy in STRATEGIES:
        with pytest.raises(InfeasibleError, match="the layers contradict each other"):
            make_design(Targets(*counts), chosen(strategy))


def test_a_mask_with_no_voxels_or_of_another_shape_is_refused():
    targets = random_targets()
    with pytest.raises(ParameterError, match="at least one voxel, got 0"):
        make_design(targets, chosen(), np.zeros(targets.shape, bool))
    with pytest.raises(ParameterError, match=r"must have the shape \(14, 13, 12\), got \(12, 13, 14\)"):
        make_design(targets, chosen(), np.ones((12, 13, 14), bool))


def test_caps_that_make_it_impossible_are_refused_with_the_smallest():
    with pytest.raises(InfeasibleError, match=r"the cap on alpha must be at least \d+, got 2"):
        make_design(random_targets(), chosen(cap_alpha=2))


def test_an_estimate_of_too_many_is_a_refusal():
    with pytest.raises(ParameterError, match="GB of memory"):
        estimate((2200, 2200, 2200), "minimum-zeros")


def test_given_tables_are_refused_where_the_strategy_heeds_none():
    targets = targets_of_voxels(Stream(1, "bits").many(120).reshape(4, 5, 6) < 0.4)
    design = make_design(targets, VoxelParameters(strategy="minimum-zeros"))
    given = replace(targets, tables=(design.alpha, design.beta))
    with pytest.raises(ParameterError, match="given tables need .*by-field, minimum-zeros.*, got trabecular"):
        make_design(given, VoxelParameters())
