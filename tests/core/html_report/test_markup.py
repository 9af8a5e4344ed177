# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our Markdown as HTML: structure kept, everything else text."""

import pytest

from freecad_trabecula.core.html_report.markup import html_of, rows_of


def test_headings_go_down_by_the_level():
    assert html_of("# one\n\n## two", level=1) == "<h2>one</h2>\n<h3>two</h3>"


def test_lines_between_head_and_rows_may_have_no_spaces():
    assert html_of("| a | b |\n|---|---|\n| x | 2 |").count("<td") == 2


def test_a_table_has_head_rows_and_what_is_told_after_it():
    seen = []

    def told(head, rows):
        seen.append((head, rows))
        return "<hr>"

    html = html_of("| what | value |\n| --- | --- |\n| a \\| b | 1.5 |", told)
    assert seen == [(["what", "value"], [["a | b", "1.5"]])]
    assert html.count("<th>") == 2 and "<td>a | b</td>" in html and "<td class='n'>1.5</td>" in html
    assert html.endswith("<hr>")


def test_lists_bold_words_and_links_to_files():
    html = html_of("- **bad** thing\n- other\n\nThe scores are in [passport.md](passport.md).")
    assert "<li><strong>bad</strong> thing</li><li>other</li>" in html
    assert "<p>The scores are in passport.md.</p>" in html


@pytest.mark.parametrize("name", ["<script>alert(1)</script>", '"><img src=x onerror=alert(1)>', "a & b", "</style>"])
def test_names_stay_text_wherever_they_stand(name):
    for page in (f"# {name}", f"| {name} |\n| --- |\n| {name} |", f"- {name}", f"a {name} b", f"**{name}**"):
        html = html_of(page)
        assert "<script" not in html and "<img" not in html and "</style" not in html and "a & b" not in html
    assert "<" not in rows_of([(name, name)]).replace("<d", "").replace("</d", "")


def test_pictures_are_left_out():
    assert html_of("![caption](layers.png)") == ""
    assert html_of("![caption](layers.png)\n\ncaption.") == "<p>caption.</p>"
