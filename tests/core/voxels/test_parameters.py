# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choices of a voxel design: what is taken, what is refused."""

from __future__ import annotations

from dataclasses import fields

import pytest

from freecad_trabecula.core.records import from_record, to_record
from freecad_trabecula.core.voxels.parameters import VoxelParameters, check_voxel_count
from freecad_trabecula.core.voxels.registry import find_strategy, strategy_names
from freecad_trabecula.errors import ParameterError


def test_one_size_makes_a_cube_and_three_a_box():
    assert VoxelParameters(size=0.2).size == (0.2, 0.2, 0.2)
    assert VoxelParameters(size=(0.1, 0.2, 0.3)).size == (0.1, 0.2, 0.3)


def test_parameters_survive_json():
    chosen = VoxelParameters(size=(0.1, 0.2, 0.3), strategy="sequential", seed=7, cap_alpha=40, trabeculae="xz")
    assert from_record(VoxelParameters, to_record(chosen), "parameters") == chosen


def test_every_field_tells_its_unit_and_what_it_is():
    for field in fields(VoxelParameters):
        assert field.metadata["doc"] and "unit" in field.metadata


def test_every_strategy_is_a_module_with_its_name_and_summary():
    assert {"minimum-zeros", "sequential", "random-layers", "best-tables", "by-field"} <= set(strategy_names())
    for name in strategy_names():
        module = find_strategy(name)
        assert name == module.NAME and module.SUMMARY and callable(module.design)


def test_the_options_of_a_strategy_are_fields_and_every_field_of_one_is_heeded_by_some():
    options = {option for name in strategy_names() for option in find_strategy(name).OPTIONS}
    common = {"size", "strategy", "seed", "areas", "correction", "total"}
    assert options | common == {field.name for field in fields(VoxelParameters)}
    assert not options & common


@pytest.mark.parametrize(
    ("choice", "words"),
    [
        ({"size": 0.0}, "edges must be at least 0.0001 mm, got 0 mm"),
        ({"size": float("nan")}, "must be finite, got nan mm"),
        ({"size": (0.1, 0.1)}, "one number or three, got 2 numbers"),
        ({"strategy": "magic"}, "strategy must be one of .*, got 'magic'"),
        ({"seed": -1}, "seed must lie in"),
        ({"cap_alpha": -1}, "cap_alpha must be at least 0, got -1"),
        ({"solver": "guess"}, "solver must be one of proportional, thesis, got 'guess'"),
        ({"rods": 1.5}, r"rods must lie in .*1.0, got 1.5"),
        ({"wavelength": -1.0}, "wavelength must be 0 .fitted. or more, got -1 mm"),
        ({"thickness": 0}, "thickness must lie in 1..9, got 0"),
        ({"tries": 0}, "tries must be at least 1, got 0"),
    ],
)
def test_what_cannot_be_is_refused_with_the_rule(choice, words):
    with pytest.raises(ParameterError, match=words):
        VoxelParameters(**{"strategy": "sequential", **choice})


def test_ten_thousand_million_voxels_are_refused_with_an_estimate():
    with pytest.raises(ParameterError, match=r"2,000 x 2,500 x 2,000 would take about \d+ GB of memory"):
        check_voxel_count((2000, 2500, 2000))
    check_voxel_count((512, 512, 512))


def test_a_strategy_that_is_not_there_is_refused():
    with pytest.raises(ParameterError, match="'os'"):
        find_strategy("os")
