# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of ``analyse`` and ``compare``: read without numpy, refused in one sentence with exit code 2."""

from __future__ import annotations

import os

import pytest
from shell_runs import check_refusal

from freecad_trabecula.core.analysis import comparison, parameters, plots, triangles
from freecad_trabecula.shell import slice_options
from freecad_trabecula.shell.arguments import read_arguments


def options_of(*words):
    return read_arguments(list(words))[1]


def test_what_is_not_said_is_left_to_the_parameters():
    options = options_of("analyse", "a.stl", "--out", "x")
    assert options["file"] == os.path.abspath("a.stl") and options["out"] == os.path.abspath("x")
    assert (options["unit"], options["plots"], options["axes"]) == ("auto", "png", [])
    kept = ("thickness", "at", "gap", "iterations", "filter_open", "filter_closed", "smoothing", "compensation")
    assert all(options[name] is None for name in (*kept, "fill", "rod_ratio", "heights", "range"))
    assert not any(options[name] for name in ("ssl", "cli", "svg", "xlsx", "quiet", "no_morphometry"))


def test_choices_are_those_of_the_core():
    assert (*slice_options.PLANES, "heights") == parameters.PLANES
    assert ("auto", *triangles.UNITS) == slice_options.UNITS
    assert slice_options.SMOOTHINGS == parameters.SMOOTHINGS
    assert slice_options.FILLS == parameters.FILLS
    assert (*plots.FORMATS, "none") == slice_options.PLOTS
    assert slice_options.ALIGNMENTS == comparison.ALIGNMENTS


@pytest.mark.parametrize(
    ("text", "axes"),
    [
        ("xyz", ["x", "y", "z"]),
        ("z,X", ["z", "x"]),
        ("y", ["y"]),
        ("0.6,0.8,0", ["0.6,0.8,0.0"]),
        (" x , z ", ["x", "z"]),
    ],
)
def test_axes_are_letters_or_a_direction(text, axes):
    assert options_of("analyse", "a.stl", "--axes", text, "--out", "x")["axes"] == [axes]


def test_axes_add_up():
    options = options_of("analyse", "a.stl", "--axes", "x", "--axes=-1,0,2", "--out", "x")
    assert options["axes"] == [["x"], ["-1.0,0.0,2.0"]]


@pytest.mark.parametrize(("text", "ends"), [("1:2", [1, 2]), ("-1.5:", [-1.5, None]), (":2e1", [None, 20])])
def test_a_range_has_one_end_or_two(text, ends):
    assert options_of("analyse", "a.stl", f"--range={text}", "--out", "x")["range"] == ends


def test_heights_and_negative_numbers_are_read():
    options = options_of("analyse", "a.stl", "--heights=-1,2.5", "--compensation", "-0.05", "--out", "x")
    assert options["heights"] == [-1, 2.5] and options["compensation"] == -0.05


def test_samples_become_absolute():
    options = options_of("compare", "a.stl", "~/b", "--out", "x")
    assert options["samples"] == [os.path.abspath("a.stl"), os.path.expanduser("~/b")]
    assert (options["align"], options["layer"]) == ("start", None)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["analyse"], "the following arguments are required: FILE, --out"),
        (["analyse", "a.stl"], "required: --out"),
        (["analyse", "a.stl", "b.stl", "--out", "x"], "unrecognized arguments: b.stl"),
        (["analyse", "a.stl", "--out", "x", "--thickness", "thin"], "it must be a number, got 'thin'"),
        (["analyse", "a.stl", "--out", "x", "--thickness", "nan"], "it must be a number, got 'nan'"),
        (["analyse", "a.stl", "--out", "x", "--thickness", "inf"], "it must be a number, got 'inf'"),
        (["analyse", "a.stl", "--out", "x", "--iterations", "1.5"], "it must be a whole number, got '1.5'"),
        (["analyse", "a.stl", "--out", "x", "--axes", "w"], "axes must read xyz, x,z or a direction"),
        (["analyse", "a.stl", "--out", "x", "--axes", ""], "axes must read xyz, x,z or a direction"),
        (["analyse", "a.stl", "--out", "x", "--axes", "1,2"], "axes must read xyz, x,z or a direction"),
        (["analyse", "a.stl", "--out", "x", "--axes", "1,2,three"], "it must be a number, got 'three'"),
        (["analyse", "a.stl", "--out", "x", "--range", "5"], "a range must read LOW:HIGH, LOW: or :HIGH, got '5'"),
        (["analyse", "a.stl", "--out", "x", "--range", ":"], "a range must read"),
        (["analyse", "a.stl", "--out", "x", "--heights", "1,,2"], "it must be a number, got ''"),
        (["analyse", "a.stl", "--out", "x", "--heights", "1", "--range", "0:2"], "--heights and --range exclude"),
        (["analyse", "a.stl", "--out", "x", "--heights", "1", "--at", "bottom"], "--heights and --at exclude"),
        (["analyse", "a.stl", "--out", "x", "--unit", "ell"], "invalid choice: 'ell'"),
        (["analyse", "a.stl", "--out", "x", "--plots", "gif"], "invalid choice: 'gif'"),
        (["compare", "a.stl", "--out", "x"], "a comparison needs at least two samples, got 1"),
        (["compare", "--out", "x"], "the following arguments are required: SAMPLE"),
        (["compare", "a", "b", "--out", "x", "--align", "end"], "invalid choice: 'end'"),
    ],
)
def test_wrong_words_are_refused_in_one_sentence(words, message, capsys):
    check_refusal(words, message, capsys)


@pytest.mark.parametrize("command", ["analyse", "compare"])
def test_help_names_every_option_the_exit_codes_and_what_unsound_means(command, capsys):
    with pytest.raises(SystemExit) as stop:
        read_arguments([command, "--help"])
    text = capsys.readouterr().out
    assert stop.value.code == 0
    for option in options_of(command, "a", *(["b"] if command == "compare" else []), "--out", "x"):
        assert option in ("file", "samples") or "--" + option.replace("_", "-") in text
    assert "Exit code: 0" in text and "FREECADCMD" in text
    assert "sound" in text and "numbers are written all the same" in text
    assert f" {command} " in text.split("examples:")[1] and " design " not in text.split("examples:")[1]
