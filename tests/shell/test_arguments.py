# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the command line: read without numpy, refused in one sentence with exit code 2."""

from __future__ import annotations

import os
from unittest import mock

import pytest
from shell_runs import check_refusal

from freecad_trabecula.core import parameters
from freecad_trabecula.shell import arguments
from freecad_trabecula.shell.arguments import COMMANDS, make_parser, read_arguments


def options_of(*words):
    return read_arguments(["design", *words])[1]


def test_options_have_their_defaults():
    options = options_of("--preset", "case6", "--out", "x")
    assert options == {
        "preset": "case6",
        "job": None,
        "envelope": None,
        "couple": [],
        "seed": None,
        "engine": None,
        "set": [],
        "out": os.path.abspath("x"),
        "also": [],
        "save_job": None,
        "quiet": False,
    }


def test_repeated_options_add_up_in_their_order():
    options = options_of(
        *("--envelope", "a.step", "--couple", "Face1:Face2", "--couple", " A : B ", "--out", "x"),
        *("--set", "seed=3", "--set", "name=a=b", "--also", "obj", "--also", "3mf"),
    )
    assert options["couple"] == ["Face1:Face2", "A:B"]
    assert options["set"] == ["seed=3", "name=a=b"]
    assert options["also"] == ["obj", "3mf"]


def test_file_names_become_absolute_since_freecad_may_start_elsewhere():
    options = options_of("--job", "j.json", "--envelope", "~/e.step", "--out", "o", "--save-job", "s.json")
    assert options["job"] == os.path.abspath("j.json")
    assert options["envelope"] == os.path.expanduser("~/e.step")
    assert os.path.isabs(options["out"]) and os.path.isabs(options["save_job"])


def test_the_engines_are_those_of_the_parameters():
    assert arguments.ENGINES == parameters.ENGINES


def test_the_list_of_presets_needs_no_folder():
    assert options_of("--preset", "list")["out"] is None


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([], "a command is needed: design"),
        (["dezign"], "invalid choice: 'dezign'"),
        (["design"], "what is to be designed? one of --preset, --job or --envelope is needed"),
        (["design", "--preset", "case6"], "--out DIR is needed"),
        (["design", "--preset", "case6", "--job", "j.json", "--out", "x"], "not allowed with argument --preset"),
        (["design", "--preset", "case6", "--out", "x", "--engine", "magic"], "invalid choice: 'magic'"),
        (["design", "--preset", "case6", "--out", "x", "--seed", "1.5"], "it must be a whole number, got '1.5'"),
        (["design", "--preset", "case6", "--out", "x", "--seed"], "expected one argument"),
        (["design", "--preset", "case6", "--out", "x", "--speed", "3"], "unrecognized arguments: --speed 3"),
        (["design", "--pre", "case6", "--out", "x"], "unrecognized arguments: --pre case6"),
        (["design", "--preset", "case6", "--out", "x", "stray"], "unrecognized arguments: stray"),
        (["design", "--preset", "case6", "--out", "x", "--also", "amf"], "invalid choice: 'amf'"),
        (["design", "--preset", "case6", "--out", "x", "--couple", "A:B"], "--couple names faces of --envelope"),
        (["design", "--envelope", "e.step", "--out", "x", "--couple", "A-B"], "must read FACE:FACE"),
        (["design", "--envelope", "e.step", "--out", "x", "--couple", "A:"], "must read FACE:FACE"),
        (["design", "--envelope", "e.step", "--out", "x", "--couple", "A:B:C"], "must read FACE:FACE"),
    ],
)
def test_wrong_words_are_refused_in_one_sentence(words, message, capsys):
    check_refusal(words, message, capsys)


def test_the_name_of_a_file_that_is_no_text_is_refused(capsys):
    # a byte that is none of UTF-8, as Python keeps it; reports hold the names of files
    check_refusal(["design", "--preset", "case1", "--out", "bad\udcff"], "must be text in UTF-8, got 'bad", capsys)


def test_a_folder_that_was_removed_under_the_command_is_said(capsys):
    with mock.patch("os.getcwd", side_effect=FileNotFoundError(2, "No such file or directory")):
        check_refusal(["design", "--preset", "case1", "--out", "x"], "in which the command was given", capsys)


def test_help_names_every_option_and_the_exit_codes(capsys):
    with pytest.raises(SystemExit) as stop:
        read_arguments(["design", "--help"])
    text = capsys.readouterr().out
    assert stop.value.code == 0
    for option in options_of("--preset", "case6", "--out", "x"):
        assert "--" + option.replace("_", "-") in text
    assert "Exit code: 0" in text
    assert "FREECADCMD" in text


def test_every_command_is_in_the_help_and_has_a_module():
    text = " ".join(make_parser().format_help().split())  # long ones are wrapped
    for command in COMMANDS:
        assert command.name in text and command.summary in text
        assert command.module.startswith("freecad_trabecula.shell.")
