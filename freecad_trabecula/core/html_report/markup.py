# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Markdown of our reports as HTML: headings, tables, lists, paragraphs, bold; everything else is text.

Pictures and links are left out: a report in one file has its own pictures, and no other files.
"""

from __future__ import annotations

import re
from html import escape
from typing import Callable, List, Sequence, Tuple

from ..language import Words

#: ``told(head, rows)`` gives the HTML that follows a table.
Told = Callable[[Sequence[str], Sequence[Sequence[str]]], str]

_PICTURE, _LINK = re.compile(r"!\[[^\]]*\]\([^)]*\)"), re.compile(r"\[([^\]]*)\]\([^)]*\)")
_BOLD = re.compile(r"\*\*(.+?)\*\*")
_POWER = re.compile(r"\bmm\^?([23])\b")
_BETWEEN = re.compile(r"(?<!\\)\|")


def nothing_told(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return nothing: what follows a table by default."""
    return ""


def html_of(markdown: str, told: Told = nothing_told, level: int = 1, words: Words = str) -> str:
    """Return a page of a report as HTML.

    Parameters
    ----------
    markdown : str
    told : callable
    level : int
        By how much headings go down: the page's own becomes h2 with 1.
    words : callable
        Puts each text (a heading, a cell, a paragraph, a point of a list; what is bold by itself) into a language.

    Examples
    --------
    >>> html_of("# a < b")
    '<h2>a &lt; b</h2>'
    """
    blocks = re.split(r"\n{2,}", markdown.strip())
    return "\n".join(one for one in (_block(block, told, level, words) for block in blocks) if one)


def _block(block: str, told: Told, level: int, words: Words) -> str:
    lines = block.split("\n")
    marks = re.match(r"(#+) (.*)", block, re.DOTALL)
    if marks:
        depth = min(len(marks[1]) + level, 6)
        return f"<h{depth}>{_text(marks[2], words)}</h{depth}>"
    if len(lines) > 1 and lines[0].startswith("|") and set(lines[1]) <= set("|- "):
        return table(_cells(lines[0]), [_cells(line) for line in lines[2:]], told, words)
    if all(line.startswith("- ") for line in lines):
        return "<ul>" + "".join(f"<li>{_text(line[2:], words)}</li>" for line in lines) + "</ul>"
    text = _text(_PICTURE.sub("", block).strip(), words)
    return f"<p>{text}</p>" if text else ""


def _cells(line: str) -> List[str]:
    return [cell.strip().replace("\\|", "|") for cell in _BETWEEN.split(line)[1:-1]]


def _text(text: str, words: Words) -> str:
    parts = [_part(one, words) for one in _BOLD.split(text)]
    return "".join(f"<strong>{part}</strong>" if number % 2 else part for number, part in enumerate(parts))


def _part(text: str, words: Words) -> str:
    """A text within which nothing is bold; blanks at its ends stay."""
    core = text.strip()
    said = text.replace(core, words(core)) if core else text
    return escape(_POWER.sub(lambda found: "mm" + {"2": "²", "3": "³"}[found[1]], _LINK.sub(r"\1", said)))


def table(head: Sequence[str], rows: Sequence[Sequence[str]], told: Told = nothing_told, words: Words = str) -> str:
    """Return a table; columns of numbers stand to the right, long texts wrap."""
    parts = ["<div class='wide'><table><thead><tr>", *(f"<th>{_text(cell, words)}</th>" for cell in head)]
    parts.append("</tr></thead><tbody>")
    for row in rows:
        parts.append("<tr>" + "".join(f"<td{_side(cell)}>{_text(cell, words)}</td>" for cell in row) + "</tr>")
    parts.append("</tbody></table></div>")
    return "".join(parts) + told(head, rows)


def _side(cell: str) -> str:
    return " class='n'" if re.fullmatch(r"[-+]?[\d.,]+(e[-+]?\d+)?( to [-\d.e+]+)?( [%A-Za-z³²]+)?|-", cell) else ""


def rows_of(pairs: Sequence[Tuple[str, str]]) -> str:
    """Return pairs of words, in the reader's language, as a list of terms."""
    return "<dl>" + "".join(f"<dt>{escape(term)}</dt><dd>{_text(text, str)}</dd>" for term, text in pairs) + "</dl>"
