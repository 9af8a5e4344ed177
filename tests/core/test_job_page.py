# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/job.md says what is true: it is written from the classes, its ranges are tried out, its examples are jobs."""

from __future__ import annotations

import dataclasses
import importlib.util
import json
import re
import typing
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.job import Job, job_from_json
from freecad_trabecula.core.laws import KINDS, Law
from freecad_trabecula.core.records import from_record
from freecad_trabecula.errors import ParameterError

ROOT = Path(__file__).resolve().parents[2]


def load_tool():
    specification = importlib.util.spec_from_file_location("job_page", str(ROOT / "tools" / "job_page.py"))
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


TOOL = load_tool()
CLASSES = [cls for _, cls, _, _ in TOOL.SECTIONS]
PAGE = (ROOT / "docs" / "job.md").read_text(encoding="utf-8")


def fields_with_ranges():
    for cls in CLASSES:
        for field in dataclasses.fields(cls):
            words = TOOL.range_words(cls, field)
            if words and cls is not Job:
                yield pytest.param(cls, field, words, id=f"{cls.__name__}.{field.name}")


def test_the_page_is_what_the_tool_writes():
    assert TOOL.page() == PAGE, "run python3 tools/job_page.py"


def test_every_class_of_the_format_has_its_table():
    found, waiting = set(), [Job]
    while waiting:
        cls = waiting.pop()
        found.add(cls)
        for hint in typing.get_type_hints(cls).values():
            for one in (hint, *typing.get_args(hint)):
                if dataclasses.is_dataclass(one) and one not in found:
                    waiting.append(one)
    assert found - set(CLASSES) == set()


def test_every_key_is_on_the_page():
    for cls in CLASSES:
        for field in dataclasses.fields(cls):
            assert f"| `{field.name}` |" in PAGE


def test_every_law_is_explained():
    assert set(TOOL.LAW_WORDS) == {field.name for field in dataclasses.fields(Law)}
    for kind in KINDS:
        assert kind + ":" in TOOL.LAW_WORDS["kind"]


def test_the_examples_are_jobs():
    examples = re.findall(r"```json\n(.*?)```", PAGE, re.DOTALL)
    assert len(examples) == 3
    for text in examples:
        assert job_from_json(text).couplings


def test_ranges_name_existing_keys():
    for cls, name in TOOL.RANGES:
        assert name in {field.name for field in dataclasses.fields(cls)}


# ------------------------------------------------------------------------------------- the ranges, tried out

#: What a class needs besides the field under test.
NEEDED = {"Coupling": {"first": "A", "second": "B"}, "SiteEdit": {"site": "A.1.1"}, "Law": {"expression": "x"}}


def accepts(cls, field, value):
    record = dict(NEEDED.get(cls.__name__, {}), **{field.name: value})
    if field.name in ("l", "w", "h"):
        record.update(a_x=0, a_y=0, a_z=0)
    if cls is Law and field.name == "direction":
        record["kind"] = "linear"
    if cls is Law and field.name == "expression":
        record["kind"] = "expression"
    try:
        from_record(cls, record, "x")
    except ParameterError:
        return False
    return True


def as_value(field, number, cls):
    """Return a number in the form that the field has."""
    hint = typing.get_type_hints(cls)[field.name]
    if hint is Law:
        return {"kind": "constant", "low": number}
    if hint is int:
        return int(number)
    if "Tuple" in str(hint):
        return [number] * (1 if "..." in str(hint) else 3)
    return number


@pytest.mark.parametrize(("cls", "field", "words"), list(fields_with_ranges()))
def test_the_range_on_the_page_is_the_range_that_is_kept(cls, field, words):
    whole = typing.get_type_hints(cls)[field.name] is int
    step = 1 if whole else 1e-4
    between = re.fullmatch(r"(\S+) \.\. (\S+?)( each)?", words)
    least = re.match(r">=? (\S+?)(,| each|$)", words)
    if between:
        low, high = float(between[1]), float(between[2])
        assert accepts(cls, field, as_value(field, low, cls)) and accepts(cls, field, as_value(field, high, cls))
        assert not accepts(cls, field, as_value(field, low - step, cls))
        assert not accepts(cls, field, as_value(field, high + step, cls))
    elif least:
        low = float(least[1])
        strictly = words.startswith("> ")
        assert accepts(cls, field, as_value(field, low, cls)) != strictly
        assert accepts(cls, field, as_value(field, low + step, cls))
        assert not accepts(cls, field, as_value(field, low - step, cls))
        if "/ 2" in words:
            assert accepts(cls, field, np.nextafter(5.0, 0.0)) and not accepts(cls, field, 5.0)
    elif words == "not zero":
        assert not accepts(cls, field, [0, 0, 0]) and accepts(cls, field, [0, 0, 1e-3])
    elif words == "1 to 500 characters":
        assert accepts(cls, field, "x" + "+1" * 249) and not accepts(cls, field, "x" + "+1" * 250)
        assert not accepts(cls, field, "")
    elif words.startswith("<= high"):
        assert accepts(cls, field, 1.0) and not accepts(cls, field, 1.1)
    else:
        for word in words.split(", "):
            extra = {"move": {"point": [0, 0, 0]}, "add": {"point": [0, 0, 0]}}.get(word, {})
            from_record(cls, dict(NEEDED.get(cls.__name__, {}), **{field.name: word}, **extra), "x")
        assert not accepts(cls, field, "something else")


def test_a_page_out_of_date_is_noticed(tmp_path, monkeypatch):
    old = tmp_path / "job.md"
    old.write_text(PAGE + json.dumps("more"), encoding="utf-8")
    monkeypatch.setattr(TOOL, "PAGE", old)
    monkeypatch.setattr(TOOL.sys, "argv", ["job_page.py", "--check"])
    assert TOOL.main() == 1
