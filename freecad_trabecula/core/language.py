# SPDX-License-Identifier: LGPL-2.1-or-later
"""The language that a page is written in: core knows English only, the window hands over its own words."""

from __future__ import annotations

from typing import Callable, NamedTuple

#: Gives a text or a number of ours in the reader's language.
Words = Callable[[str], str]


class Language(NamedTuple):
    """A language.

    Attributes
    ----------
    code : str
        As HTML has it: ``en``, ``de``.
    words : callable
        Gives our English texts, and numbers as Python writes them, as a reader of that language expects them.
    """

    code: str
    words: Words


#: The words as they stand in the code.
ENGLISH = Language("en", str)
