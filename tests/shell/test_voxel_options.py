# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of ``voxels``: the same lists as the core's, refused in one sentence."""

from __future__ import annotations

import os
from dataclasses import fields

import pytest

from freecad_trabecula.core.analysis import plots
from freecad_trabecula.core.voxels import image_stacks
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.registry import strategy_names
from freecad_trabecula.shell import voxel_options
from freecad_trabecula.shell.arguments import read_arguments

OUT = ("--out", "x")


def options_of(*words):
    return read_arguments(["voxels", *words])[1]


def test_strategies_choices_and_kinds_are_those_of_the_core():
    assert set(voxel_options.STRATEGIES) == set(strategy_names())
    choices = {f.name: tuple(f.metadata["choices"]) for f in fields(VoxelParameters) if "choices" in f.metadata}
    choices.pop("strategy", None)
    assert choices == voxel_options.CHOICES
    assert set(voxel_options.PLOTS) == {*plots.FORMATS, "none"}
    assert set(voxel_options.IMAGES) == {*image_stacks.KINDS, "none"}


def test_every_field_of_the_parameters_has_an_option():
    assert set(voxel_options.FIELDS) == {f.name for f in fields(VoxelParameters)}
    options = options_of("bone.stl", *OUT)
    assert all(options[name] is None for name in voxel_options.FIELDS)


def test_a_size_is_one_number_or_three():
    assert options_of("bone.stl", "--size", "0.1", *OUT)["size"] == [0.1, 0.1, 0.1]
    assert options_of("bone.stl", "--size", "0.1,0.2,0.3", *OUT)["size"] == [0.1, 0.2, 0.3]


def test_file_names_become_absolute():
    options = options_of("bone.stl", "--mask", "m.stl", "--tables", "t.xlsx", *OUT)
    assert [options[k] for k in ("file", "mask", "tables", "out")] == [
        os.path.abspath(n) for n in ("bone.stl", "m.stl", "t.xlsx", "x")
    ]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([*OUT], "the following arguments are required: FILE"),
        (["bone.stl"], "where shall it go? --out DIR is needed (or --estimate"),
        (["bone.stl", *OUT, "--size", "0.1,0.2"], "must be one number or three between commas, got '0.1,0.2'"),
        (["bone.stl", *OUT, "--size", "big"], "it must be a number, got 'big'"),
        (["bone.stl", *OUT, "--strategy", "magic"], "invalid choice: 'magic'"),
        (["bone.stl", *OUT, "--seed", "1.5"], "it must be a whole number, got '1.5'"),
        (["bone.stl", *OUT, "--rates", "0"], "--rates must be at least 1, got 0"),
        (["bone.stl", *OUT, "--boundary", "half"], "--boundary is about --mask or --density"),
        (["bone.stl", *OUT, "--density", "0.3", "--mask", "m.stl"], "--density makes FILE the envelope"),
        (["bone.stl", *OUT, "--density", "0.3", "--count"], "--count and --rates are about boxes"),
        (["bone.stl", *OUT, "--images", "gif"], "invalid choice: 'gif'"),
    ],
)
def test_wrong_usage_is_refused_in_one_sentence(capsys, words, message):
    with pytest.raises(SystemExit) as end:
        options_of(*words)
    assert end.value.code == 2
    assert message in capsys.readouterr().err
