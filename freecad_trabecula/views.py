# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who gives an object its view provider: the window says so at its start, so that documents need not know the window.

InitGui.py imports this module whenever FreeCAD's window starts; it imports nothing but the standard library.
"""

from __future__ import annotations

from typing import Any, Callable, List

_attachers: List[Callable[[Any], None]] = []


def attach_views_with(attach: Callable[[Any], None]) -> None:
    """Have ``attach(obj)`` called for objects that have no view provider; without a window nobody is."""
    _attachers[:] = [attach]


def attach_view(obj: Any) -> None:
    """Give an object its view provider, if there is a window and it has none (made without one)."""
    view = getattr(obj, "ViewObject", None)
    if view is not None and view.Proxy in (None, 0):
        for attach in _attachers:
            attach(obj)
