# SPDX-License-Identifier: LGPL-2.1-or-later
"""Explanations: complete, true to the thesis, with sources that can be looked up, and the page that lists them."""

from __future__ import annotations

import importlib.util
import os
import re
from pathlib import Path

import pytest

from freecad_trabecula.core.analysis.morphometry import AXIS_TABLE, TABLE
from freecad_trabecula.core.analysis.passport import DEFINITIONS
from freecad_trabecula.core.bodies import Check
from freecad_trabecula.core.explanations import registry
from freecad_trabecula.core.explanations.explanation import NONE, Explanation, routes_found
from freecad_trabecula.errors import ParameterError

ROOT = Path(__file__).resolve().parents[3]
SHARED = Path(os.environ["TRABECULA_DATA"]).parent if os.environ.get("TRABECULA_DATA") else ROOT.parent / "shared"
THESIS = SHARED / "thesis" / "ramin-2010-automated-design-of-trabecular-structures.txt"
EVERY = [registry.explanation(key) for key in registry.all_keys()]
DOI = re.compile(r"10\.\d{4,9}/[-._;()/:A-Za-z0-9]+$")  # what Crossref recommends to check by


def test_every_number_has_name_formula_and_source_and_says_whether_there_is_a_second_route():
    for one in EVERY:
        assert one.name and one.formula and one.source and one.second, one.key
        assert not (one.second == NONE and (one.check or one.beside or one.tolerance)), one.key


def test_no_key_is_there_twice():
    assert len(registry.all_keys()) == sum(len(group) for _, group in registry.GROUPS)


def test_a_number_that_is_the_second_route_of_another_has_an_entry_and_names_that():
    for one in EVERY:
        if one.beside:
            assert registry.explanation(one.beside).beside == one.key


def test_every_measure_of_a_body_and_every_score_has_an_entry_with_its_own_definition():
    for symbol, (name, _, definition, source) in {**TABLE, **AXIS_TABLE}.items():
        one = registry.explanation(registry.measure_key(symbol))
        assert (one.name, one.symbol, one.formula, one.source) == (name, symbol, definition, source)
    for symbol, definition in DEFINITIONS.items():
        assert registry.explanation(f"passport.{symbol}").formula == definition


def test_an_unknown_number_is_refused_by_its_key():
    with pytest.raises(ParameterError, match="must be one of .* that are explained, got 'design.beauty'"):
        registry.explanation("design.beauty")


def test_sources_are_the_thesis_an_article_a_book_or_said_to_be_our_own():
    for one in EVERY:
        assert re.search(r"thesis|DOI 10\.|own definition|Underwood, Quantitative Stereology, 1970", one.source), one


def test_every_doi_is_well_formed():
    found = [doi for one in EVERY for text in one for doi in re.findall(r"DOI (\S+)", str(text))]
    assert len(found) > 20
    assert [doi for doi in found if not DOI.match(doi.rstrip(";,"))] == []


@pytest.fixture(scope="module")
def thesis():
    if not THESIS.is_file():
        pytest.skip(f"the thesis' text is not there: {THESIS}; sources of {len(EVERY)} numbers are not looked up")
    return THESIS.read_text(encoding="utf-8", errors="replace")


def test_every_equation_that_is_named_stands_in_the_thesis(thesis):
    equations = {number for one in EVERY for number in re.findall(r"Eq\. (\d\.\d+)", one.source)}
    assert {"2.1", "2.2", "5.1", "6.1", "6.2", "6.6"} <= equations
    assert [number for number in sorted(equations) if f"({number})" not in thesis] == []


def test_every_section_and_table_that_is_named_stands_in_the_thesis(thesis):
    found = {"section": set(), "table": set(), "chapter": set()}
    for one in (one for one in EVERY if one.source.startswith("thesis")):
        for kind, numbers in re.findall(r"(section|table|chapter)s? ([\d., and]+)", one.source):
            found[kind] |= set(re.findall(r"\d+(?:\.\d+)*", numbers))
    sections, tables, chapters = found.values()
    assert {"2.4.7", "5.2.3.1", "5.4", "6.2.1"} <= sections and {"4.2", "5.11"} <= tables and chapters == {"9"}
    assert [one for one in sorted(sections) if not re.search(rf"^{re.escape(one)}\.? ?[A-Z]", thesis, re.M)] == []
    assert [one for one in sorted(tables) if not re.search(rf"Table {re.escape(one)}\b", thesis)] == []


def test_both_routes_are_found_by_the_checks_name_and_by_the_number_beside():
    checks = [Check("volume along x, sum", 2.0, 2.5, 0.2, 0.3)._asdict(), Check("rods", 1, 1, 0, 0)._asdict()]
    volume = registry.explanation("slices.volume")
    assert routes_found(volume, checks) == ["volume along x, sum: 2 against 2.5, 0.2 apart (at most 0.3)"]
    values = {"morphometry.BV/TV": 0.25, "morphometry.BV/TV.vox": 0.2}
    assert routes_found(registry.explanation("morphometry.BV/TV"), (), values) == ["0.25 against 0.2, 0.25 of it apart"]
    assert routes_found(registry.explanation("morphometry.Tb.Th"), checks, values) == []


def test_what_a_reader_is_told_has_symbol_unit_and_tolerance():
    one = Explanation("k", "porosity", "P", "%", "a / b", "thesis Eq. 2.2", "rays", "1e-6")
    assert one.rows(["1 against 2"]) == [
        ("number", "porosity (P), %"),
        ("formula", "a / b"),
        ("source", "thesis Eq. 2.2"),
        ("second route", "rays; 1e-6"),
        ("both routes", "1 against 2"),
    ]


@pytest.mark.parametrize("value", [0.0, 3.125, 16.0, 123456.0])
def test_a_check_is_read_from_its_text(value):
    check = Check("watertight scaffold: faulty edges", value, 0.5, 0.25, 0.5)
    assert Check.from_text(str(check)) == check


@pytest.mark.parametrize("text", ["", "a: 1 against 2", "a: 1 against b, 0 apart (at most 0)", "nothing"])
def test_what_is_no_check_is_none(text):
    assert Check.from_text(text) is None


def test_the_page_is_what_the_tool_writes():
    specification = importlib.util.spec_from_file_location("measures", str(ROOT / "tools" / "measures_page.py"))
    tool = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(tool)
    assert tool.PAGE.read_text(encoding="utf-8") == registry.page(), "run python3 tools/measures_page.py"
