# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records as Python: what is written evaluates to the same record, short, and only with what differs."""

import dataclasses
import math

import pytest

from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.laws import Law, constant, uniform
from freecad_trabecula.core.parameters import Coupling, FaceParameters, PathParameters, PoreParameters, SiteEdit
from freecad_trabecula.core.presets import PRESETS, preset
from freecad_trabecula.core.python_text import WIDTH, Name, call_text, import_lines, python_text, same
from freecad_trabecula.core.voxels.parameters import VoxelParameters


def evaluated(text, used):
    """What the text makes, with the names that its own import lines bring."""
    names = {}
    exec("\n".join(import_lines(used)), names)  # noqa: S102  what a user does
    return eval(text, names)  # noqa: S307


RECORDS = [
    PoreParameters(),
    PoreParameters("circle", constant(0.3), corners=5, scatter=0.1),
    PathParameters("box", points=((1.0, 2.0, 3.0),), box=(1e-3, 2.0, 1 / 3)),
    Coupling("A", "B", path=PathParameters("tension", tension_first=uniform(1, 2))),
    FaceParameters("Face5", 'it\'s "A"', origin=(0.1, 0.2, 0.3)),
    SiteEdit("Face1.1.1", "pore", size=0.4, turns=(0.1, 0.2, 0.3, 0.4)),
    SliceParameters(at="heights", heights=(0.5, 1.0), fill="union"),
    SliceParameters(low=1.0),
    VoxelParameters(size=0.05, strategy="minimum-zeros", seed=7),
    Law("expression", 0.0, 2.0, expression="0.5 * sin(x) + u"),
]


@pytest.mark.parametrize("record", RECORDS, ids=lambda one: type(one).__name__)
def test_what_is_written_evaluates_to_the_same_record(record):
    used = set()
    assert same(evaluated(python_text(record, used), used), record)


@pytest.mark.parametrize("name", PRESETS)
def test_every_design_of_the_thesis_comes_back(name):
    job, used = preset(name).wireframe, set()
    assert evaluated(python_text(job, used), used) == job


def test_defaults_are_not_written():
    assert python_text(PoreParameters(), set()) == "PoreParameters()"
    assert python_text(PoreParameters(corners=5), set()) == "PoreParameters(corners=5)"


def test_long_calls_have_an_argument_a_line_and_no_line_is_too_long():
    couplings, used = tuple(Coupling(f"Face{k}", f"Face{k + 1}", "same", limit=k + 1) for k in range(9)), set()
    text = python_text(couplings, used)
    assert max(map(len, text.splitlines())) <= WIDTH
    assert text.count("\n") == 10
    assert evaluated(text, used) == couplings


def test_a_tuple_of_one_stays_a_tuple():
    for length in (1, 200):  # in one line, and in several
        assert evaluated(python_text(("a" * length,), set()), set()) == ("a" * length,)


@pytest.mark.parametrize("text", ["plain", 'a "b"', "it's", "back\\slash", "two\nlines", "ä µ ³"])
def test_texts_keep_their_quotes_and_lines(text):
    assert evaluated(python_text(text, set()), set()) == text


def test_names_of_variables_are_no_texts():
    assert call_text("f", [("", Name("document")), ("name", "document")], set()) == 'f(document, name="document")'


def test_nan_is_equal_to_nan_and_to_nothing_else():
    assert same(math.nan, math.nan) and not same(math.nan, 1.0) and not same(1.0, math.nan)
    assert same(SliceParameters(), SliceParameters()) and not same(SliceParameters(low=0.0), SliceParameters())
    fields = {f.name for f in dataclasses.fields(SliceParameters) if isinstance(f.default, float)}
    assert {"low", "high"} <= fields
