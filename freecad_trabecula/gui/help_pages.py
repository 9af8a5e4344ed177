# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of the help: the files of ``docs``, their headings, and where a word is found in them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Iterator, List, NamedTuple, Sequence, Tuple

DOCS = Path(__file__).resolve().parents[2] / "docs"
CONTENTS, GLOSSARY = "README.md", "glossary.md"
MOST_HITS = 60  # passages that a search shows: more are not read
MOST_WORD = 18  # characters of a word that are kept together in a table
QUOTED = 180  # characters of each
_FENCE = "```"


class Hit(NamedTuple):
    """A passage in which all words of a search stand.

    Attributes
    ----------
    page, title : str
        File within the docs, and its first heading.
    heading : str
        The heading above it; the title itself at the beginning.
    text : str
    """

    page: str
    title: str
    heading: str
    text: str


def page_of_command(name: str) -> str:
    """Return the page of a command, within the docs; commands of a group share the group's.

    Examples
    --------
    >>> page_of_command("Trabecula_Design"), page_of_command("Trabecula_Preset_case6")
    ('commands/Design.md', 'commands/Presets.md')
    """
    short, _, member = name[len("Trabecula_") :].partition("_")
    return f"commands/{short}{'s' if member else ''}.md"


def page_in(language: str, page: str) -> str:
    """Return a page, within the docs, in a language if there is one, else the English one.

    Examples
    --------
    >>> page_in("de", "glossary.md"), page_in("de", "method.md"), page_in("en", "glossary.md")
    ('glossary.de.md', 'method.md', 'glossary.md')
    """
    other = f"{page[: -len('.md')]}.{language}.md"
    return other if (DOCS / other).is_file() else page


def slug(heading: str) -> str:
    """Return a heading as a forge writes it behind the # of a link.

    Examples
    --------
    >>> slug("2. Sites (Eq. 2.1, thesis 4.2.2)")
    '2-sites-eq-21-thesis-422'
    """
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def passages_of(text: str) -> Iterator[Tuple[str, str]]:
    """Yield a page's headings (without #), paragraphs, points of lists, rows of tables, each with its heading."""
    heading, fenced, open_lines = "", False, []
    for line in [*text.splitlines(), ""]:
        fenced ^= line.lstrip().startswith(_FENCE)
        is_heading = not fenced and re.match(r"#{1,6} ", line) is not None
        if open_lines and (is_heading or fenced or not line.strip() or re.match(r"\s*([-*|`]|\d+\.) ?", line)):
            yield heading, " ".join(open_lines)
            open_lines = []
        if is_heading:
            heading = line.lstrip("#").strip()
            yield heading, heading
        elif line.strip() and not line.startswith(("<!--", _FENCE)):
            open_lines.append(line.strip())


def pages() -> List[str]:
    """Return the English pages within the docs, the table of contents first."""
    names = sorted(path.relative_to(DOCS).as_posix() for path in DOCS.rglob("*.md") if "." not in path.stem)
    return sorted(names, key=lambda name: (name != CONTENTS, name.count("/"), name))


def find(words: str) -> List[Hit]:
    """Return the passages in which all words stand, headings before texts.

    Parameters
    ----------
    words : str
        In any case, separated by spaces.
    """
    wanted = words.lower().split()
    hits = []
    for page in pages() if wanted else ():
        title = ""
        for heading, text in passages_of((DOCS / page).read_text(encoding="utf-8")):
            title = title or heading
            if all(word in text.lower() for word in wanted):
                hits.append(Hit(page, title, heading, text))
    return sorted(hits, key=lambda hit: hit.text != hit.heading)


def plain(text: str) -> str:
    """Return a passage without its marks, so that it can be quoted.

    Examples
    --------
    >>> plain("| *rod* | the solid along a [path](glossary.md) |")
    'rod · the solid along a path'
    """
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    cells = [cell.strip() for cell in text.strip("|").split("|")]
    return re.sub(r"[*`<>#]|^- ", "", " · ".join(cell for cell in cells if cell))


def around(text: str, word: str) -> str:
    """Return the part of a text about a word, cut at spaces.

    Examples
    --------
    >>> around("a rod", "rod")
    'a rod'
    """
    place = max(text.lower().find(word), 0)
    first = text.rfind(" ", 0, max(place - QUOTED // 3, 0)) + 1
    last = text.find(" ", first + QUOTED)
    return ("… " if first else "") + (text[first:] if last < 0 else text[first:last] + " …")


def page_of_hits(words: str, title: str, nothing: str) -> str:
    """Return what a search found as a page with links.

    Parameters
    ----------
    words, title, nothing : str
        What was looked for, the page's heading, and what it says if nothing was found.
    """
    hits = find(words)
    rows = [f"# {title}", ""]
    for hit in hits[:MOST_HITS]:
        place = hit.title if hit.title == hit.heading else f"{hit.title}: {hit.heading}"
        quoted = "" if hit.text == hit.heading else around(plain(hit.text), words.lower().split()[0])
        rows += [f"[{plain(place)}]({hit.page}#{slug(hit.heading)})  ", quoted, ""]
    return "\n".join(rows if hits else [*rows, nothing])


def column_shares(texts: Sequence[Sequence[str]]) -> List[float]:
    """Return the shares of a table's width: each column has room for its longest word, long texts get the rest.

    Examples
    --------
    >>> column_shares([["ab", "cd"], ["one two", "three"]])
    [0.385, 0.615]
    """
    longest = [max((len(word) for text in column for word in text.split()), default=1) for column in texts]
    words = [min(word, MOST_WORD) + 3 for word in longest]
    lines = [max(map(len, column)) ** 0.5 * max(word, 3) ** 0.5 for word, column in zip(words, texts)]
    wanted = [max(word, line) for word, line in zip(words, lines)]
    return [round(one / sum(wanted), 3) for one in wanted]
