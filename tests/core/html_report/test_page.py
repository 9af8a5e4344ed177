# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page: valid, without network and files, names escaped, small, with why under its tables; folders in."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from html.parser import HTMLParser

import pytest

from freecad_trabecula.core.analysis.comparison import compare
from freecad_trabecula.core.analysis.comparison_report import save_comparison
from freecad_trabecula.core.analysis.folder import save_analysis
from freecad_trabecula.core.analysis.passport import passport
from freecad_trabecula.core.explanations.report_rows import keys_of_table
from freecad_trabecula.core.html_report.markup import html_of
from freecad_trabecula.core.html_report.page import report_page
from freecad_trabecula.core.html_report.sections import MOST_BYTES, Picture, read_section
from freecad_trabecula.errors import ParameterError

VOID = {"meta", "img", "path", "rect", "br"}
EVIL = '</title><script>alert("x")</script>&'


class Structure(HTMLParser):
    """Holds that every element is closed in order; collects elements, attributes, texts."""

    def __init__(self, page):
        super().__init__(convert_charrefs=True)
        self.open, self.seen, self.addresses, self.ids, self.texts = [], [], [], [], []
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.seen.append(tag)
        for name, value in attributes:
            assert not name.startswith("on"), name
            if name in ("src", "href"):
                self.addresses.append(value)
            if name == "id":
                self.ids.append(value)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, tag

    def handle_data(self, data):
        self.texts.append(data)


@pytest.fixture
def folders(tmp_path, measured):
    """Folders of an analysis with an evil name and of its comparison with a copy."""
    evil = replace(measured, name=EVIL)
    for name in ("analysis", "comparison"):
        (tmp_path / name).mkdir()
    save_analysis(evil, tmp_path / "analysis")
    scores = [passport(evil, replace(measured, name="b"))]
    save_comparison(compare([evil, replace(measured, name="b")]), scores, tmp_path / "comparison")
    return tmp_path


def test_the_page_is_valid_has_no_network_and_no_script_and_escapes_names(folders):
    sections = [read_section(folders / name) for name in ("analysis", "comparison")]
    page = report_page(sections, EVIL, [EVIL])
    found = Structure(page)
    assert found.open == []
    assert page.startswith("<!DOCTYPE html>") and '<html lang="en">' in page and '<meta charset="utf-8">' in page
    assert "script" not in found.seen and "link" not in found.seen and "iframe" not in found.seen
    assert EVIL in found.texts  # as text
    targets = {one[1:] for one in found.addresses if one.startswith("#")}
    assert targets == set(found.ids) and len(found.ids) == 2
    assert all(one.startswith(("#", "data:image/")) for one in found.addresses)
    assert "http" not in re.sub(r"http://www.w3.org/\S+", "", page.split("</style>")[0])
    assert "@import" not in page and "url(" not in page
    assert "prefers-color-scheme: dark" in page and "@media print" in page


def test_tables_of_the_thesis_passport_checks_and_why_are_in_it(folders):
    page = report_page([read_section(folders / name) for name in ("analysis", "comparison")], "t")
    for words in (
        "Total number of rods",
        "Trabecular area range (mm²)",
        "Kolmogorov-Smirnov",
        "Layer",
        "layer thickness",
    ):
        assert words.lower() in page.lower(), words
    assert page.count("<details>") >= 3
    assert "volume along x, sum of area x thickness against the mesh" in page
    assert "thesis Eq. 5.1" in page and page.count("<svg") == 3


def test_every_number_of_the_main_tables_has_an_explanation(folders):
    wanted = {"slice analysis": ["Slices along the axes"], "slice comparison": ["Totals and ranges", "Slice passport"]}
    for name in ("analysis", "comparison"):
        section, tables = read_section(folders / name), []
        for page in section.pages():
            html_of(page, lambda *table, to=tables: to.append(table) or "")
        main = [t for t in tables if t[1] and t[1][0][0] in ("slices", "Total number of rods", "sliced area")]
        assert len(main) >= len(wanted[section.kind])
        for head, rows in main:
            for row in rows:
                assert keys_of_table(section.kind, head, [row]), row


def test_the_same_folders_give_the_same_page(folders):
    pages = [report_page([read_section(folders / "analysis")], "t") for _ in range(2)]
    assert pages[0] == pages[1]


def test_pictures_are_taken_in_as_long_as_there_is_room(folders):
    section = read_section(folders / "analysis")
    pictures = tuple(Picture(f"p{k}", "image/png", bytes(MOST_BYTES // 2 + 1)) for k in range(2))
    page = report_page([section._replace(pictures=pictures)], "t")
    assert page.count("data:image/png") == 1 and "Left out, to keep this file small: p1." in page
    assert len(page.encode()) < 5_000_000


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "No such file"),
        ("{", "holds no JSON"),
        ("[]", "another record"),
        ('{"kind": "shopping list"}', "another record"),
        ("{}", "another record"),
    ],
)
def test_a_folder_without_a_report_of_ours_is_refused(tmp_path, content, words):
    if content is not None:
        (tmp_path / "report.json").write_text(content)
    with pytest.raises(ParameterError, match=f"must hold the report.json of design, .*{words}"):
        read_section(tmp_path)


def test_plots_that_the_report_names_are_taken_in_and_others_are_not(folders):
    place = folders / "comparison"
    record = json.loads((place / "report.json").read_text())
    record["files"] = {"areas.png": 3, "../secret.png": 3}
    (place / "report.json").write_text(json.dumps(record))
    for path in (place / "areas.png", place / "other.png", folders / "secret.png"):
        path.write_bytes(b"png")
    assert [one.caption for one in read_section(place).pictures] == ["areas"]
