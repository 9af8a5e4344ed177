# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window gives to objects of documents, which need not know it: view providers, words in its language.

InitGui.py imports this module whenever FreeCAD's window starts; it imports nothing but the standard library.
"""

from __future__ import annotations

from typing import Any, Callable, List

_attachers: List[Callable[[Any], None]] = []
_words: List[Callable[[str], str]] = []


def attach_views_with(attach: Callable[[Any], None]) -> None:
    """Have ``attach(obj)`` called for objects that have no view provider; without a window nobody is."""
    _attachers[:] = [attach]


def say_with(words: Callable[[str], str]) -> None:
    """Have what objects write to the report view said by ``words(text)``; without a window it is English."""
    _words[:] = [words]


def in_words(text: str) -> str:
    """Return what an object says in the language of the window, if there is one."""
    for words in _words:
        return words(text)
    return text


def attach_view(obj: Any) -> None:
    """Give an object its view provider, if there is a window and it has none (made without one)."""
    view = getattr(obj, "ViewObject", None)
    if view is not None and view.Proxy in (None, 0):
        for attach in _attachers:
            attach(obj)
