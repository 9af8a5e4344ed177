# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages of docs whose parts are written by commands: each part stands between its own two marks."""

from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"


def write_part(page, part, text):
    """Write one part of a page of docs; what other commands wrote there stays.

    Parameters
    ----------
    page : str
        Name of the page in docs.
    part : str
        What stands in the two marks.
    text : str
        Markdown.

    Raises
    ------
    ValueError
        If the page lacks a mark.
    """
    path = DOCS / page
    begin, end = f"<!-- {part}: begin -->", f"<!-- {part}: end -->"
    whole = path.read_text(encoding="utf-8")
    if whole.count(begin) != 1 or whole.count(end) != 1 or whole.index(begin) > whole.index(end):
        raise ValueError(f"docs/{page} must have the two marks of the part, in order and once, got none for {part!r}")
    before, rest = whole.split(begin)
    path.write_text(f"{before}{begin}\n{text.strip()}\n{end}{rest.split(end)[1]}", encoding="utf-8")
    print(f"part {part} of docs/{page} written")


def write_bench(name, text):
    """Write a page of its own into build/bench."""
    path = ROOT / "build" / "bench" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text + "\n", encoding="utf-8")
    print(f"written to {path}")


def save_picture(figure, name):
    """Write a figure of matplotlib as a picture of docs."""
    figure.tight_layout()
    path = DOCS / "pictures" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)
    print(f"drawn in {path}")
