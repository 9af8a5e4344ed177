# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of pages that commands write: one part changes, the others stay."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import generated_page  # noqa: E402


@pytest.fixture
def page(tmp_path, monkeypatch):
    monkeypatch.setattr(generated_page, "DOCS", tmp_path)
    path = tmp_path / "page.md"
    path.write_text("# Title\n<!-- a: begin -->\nold\n<!-- a: end -->\nkept\n<!-- b: begin -->\nb\n<!-- b: end -->\n")
    return path


def test_a_part_is_written_and_all_else_stays(page):
    generated_page.write_part("page.md", "a", "new\n")
    assert (
        page.read_text()
        == "# Title\n<!-- a: begin -->\nnew\n<!-- a: end -->\nkept\n<!-- b: begin -->\nb\n<!-- b: end -->\n"
    )


def test_a_page_without_the_marks_is_refused_and_stays(page):
    before = page.read_text()
    with pytest.raises(ValueError, match="two marks of the part.*'c'"):
        generated_page.write_part("page.md", "c", "new")
    assert page.read_text() == before


def test_the_pages_in_docs_have_the_marks_of_their_parts():
    performance = (ROOT / "docs" / "performance.md").read_text(encoding="utf-8")
    for part in ("rods", "slices", "voxels"):
        assert performance.index(f"<!-- {part}: begin -->") < performance.index(f"<!-- {part}: end -->")
    assert "<!-- morphometry: begin -->" in (ROOT / "docs" / "analysis.md").read_text(encoding="utf-8")
