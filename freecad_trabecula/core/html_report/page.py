# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report in one file: HTML without network and other files, for screens, dark ones too, and for paper."""

from __future__ import annotations

from html import escape
from typing import List, Sequence, Tuple

from ..explanations.explanation import routes_found
from ..explanations.registry import explanation
from ..explanations.report_rows import keys_of_table
from ..language import ENGLISH, Language, Words
from .markup import html_of, rows_of, table
from .sections import MOST_BYTES, Section

_STYLE = """
:root { color-scheme: light dark; --paper: #fff; --ink: #1c1c1c; --line: #bbb; --soft: #f4efe6; --link: #7c3a1e; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #1d1b19; --ink: #e9e5df; --line: #57504a; --soft: #2a2622; --link: #ecd09a; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 62rem; padding: 1.5rem; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; margin: 0 0 .3rem; } h2 { margin: 2.5rem 0 .5rem; border-bottom: 2px solid var(--line); }
h3 { margin: 1.6rem 0 .4rem; } h1, h2, h3 { line-height: 1.25; overflow-wrap: anywhere; }
a { color: var(--link); }
.wide { overflow-x: auto; margin: .5rem 0; }
table { border-collapse: collapse; font-size: .92em; }
th, td { border: 1px solid var(--line); padding: .2rem .5rem; text-align: left; vertical-align: top;
  overflow-wrap: anywhere; }
th { background: var(--soft); overflow-wrap: normal; }
td.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
figure { margin: .5rem 0; display: inline-block; max-width: 100%; vertical-align: top; }
figure img { max-width: 100%; max-height: 24rem; background: #fff; border: 1px solid var(--line); }
figcaption { font-size: .85em; opacity: .8; }
svg { width: 29rem; max-width: 100%; height: auto; font: 11px system-ui, "DejaVu Sans", sans-serif; }
svg text { fill: currentColor; }
details { margin: .2rem 0 .8rem; padding: .2rem .6rem; background: var(--soft); border-radius: 4px; }
summary { cursor: pointer; }
dl { display: grid; grid-template-columns: 7rem 1fr; gap: .1rem .8rem; margin: .3rem 0 .8rem; font-size: .9em; }
dt { opacity: .7; } dd { margin: 0; overflow-wrap: anywhere; }
nav ul { columns: 2; padding-left: 1.2rem; }
@media print {
  :root { color-scheme: light; --paper: #fff; --ink: #000; --line: #999; --soft: #f2f2f2; --link: #000; }
  body { max-width: none; padding: 0; font-size: 10pt; } section + section { break-before: page; }
  h2, h3 { break-after: avoid; } tr, figure { break-inside: avoid; } nav { display: none; } .wide { overflow: visible; }
}
"""
_WORDS = {
    "design": "Design",
    "slice analysis": "Slice analysis",
    "slice comparison": "Comparison",
    "voxel design": "Voxel design",
}

_HEAD = "Lengths are mm. Under each table stands why its numbers are what they are."
_WHY = "Why? Formulas, sources, second routes"
_LEFT_OUT = "Left out, to keep this file small:"


def report_page(
    sections: Sequence[Section], title: str, notes: Sequence[str] = (), language: Language = ENGLISH
) -> str:
    """Return a report as one HTML page.

    Parameters
    ----------
    sections : sequence of Section
    title : str
    notes : sequence of str
        What is to be said before all else.
    language : Language
        What the page is written in; its diagrams are those of the sections.

    Returns
    -------
    str
        It needs no network and no other file; the same sections give the same text.
    """
    words = language.words
    names = [_title(one, words) for one in sections]
    room = MOST_BYTES
    parts = []
    for number, section in enumerate(sections, 1):
        told = _Told(section, words)
        body, room = _pictures(section, room, words)
        pages = [html_of(page, told.after, words=words) for page in section.pages()]
        # the first heading is the section's own; pictures come right after it
        head = f"<h2 id='part{number}'>{escape(names[number - 1])}</h2>"
        pages[0] = pages[0].split("</h2>", 1)[-1]
        parts.append("\n".join(["<section>", head, body, *pages, "</section>"]))
    listed = "".join(f"<li><a href='#part{k}'>{escape(name)}</a></li>" for k, name in enumerate(names, 1))
    said = "".join(f"<li>{escape(words(note))}</li>" for note in notes)
    return "\n".join(
        [
            "<!DOCTYPE html>",
            f'<html lang="{language.code}">',
            "<head>",
            '<meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{escape(title)}</title>",
            f"<style>{_STYLE}</style>",
            "</head>",
            "<body>",
            f"<h1>{escape(title)}</h1>",
            f"<p>{escape(words(_HEAD))}</p>",
            *([f"<ul>{said}</ul>"] if said else []),
            f"<nav><ul>{listed}</ul></nav>",
            _seeds(sections, words),
            *parts,
            "</body>",
            "</html>",
            "",
        ]
    )


def _title(section: Section, words: Words) -> str:
    return f"{words(_WORDS[section.kind])}: {section.name}"


def _seeds(sections: Sequence[Section], words: Words) -> str:
    """Seed and verdict of each part, at one glance."""
    rows = []
    for one in sections:
        seed = one.record.get("seed")
        ok = one.record.get("ok")
        verdict = "" if ok is None else words("all held" if ok else "not all held")
        checks = one.checks()
        rows.append(
            [
                _title(one, words),
                "" if seed is None else str(seed),
                f"**{verdict}**" if ok is False else verdict,
                str(len(checks)),
            ]
        )
    head = [words(one) for one in ("part", "seed", "checks", "numbers by two routes")]
    return table(head, rows)


def _pictures(section: Section, room: int, words: Words) -> Tuple[str, int]:
    """Pictures and diagrams, as far as there is room; what is left out is said."""
    parts, left_out = [], []
    for one in section.pictures:
        if len(one.content) > room:
            left_out.append(words(one.caption))
            continue
        room -= len(one.content)
        caption = escape(words(one.caption), quote=True)
        parts.append(f'<figure><img src="{one.address}" alt="{caption}"><figcaption>{caption}</figcaption></figure>')
    parts += [f"<figure>{chart}</figure>" for chart in section.charts]
    if left_out:
        parts.append(f"<p>{escape(words(_LEFT_OUT))} {escape(', '.join(left_out))}.</p>")
    return "\n".join(parts), room


class _Told:
    """Tells below each table of a section why its numbers are what they are, each number once."""

    def __init__(self, section: Section, words: Words) -> None:
        self.section, self.checks, self.values = section, section.checks(), section.values()
        self.words = words
        self._seen: List[str] = []

    def after(self, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
        """Return what follows a table."""
        keys = [key for key in keys_of_table(self.section.kind, head, rows) if key not in self._seen]
        self._seen += keys
        if not keys:
            return ""
        parts = [f"<details><summary>{escape(self.words(_WHY))}</summary>"]
        for key in keys:
            one = explanation(key)
            rows = one.rows(routes_found(one, self.checks, self.values), self.words)
            parts.append(rows_of([(self.words(term), text) for term, text in rows]))
        return "".join([*parts, "</details>"])
