# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proxies that keep nothing: all data are properties, which FreeCAD saves itself."""

from __future__ import annotations

from typing import Any


class Stateless:
    """Base of proxies and view providers. FreeCAD 0.20 calls the second pair of methods, later ones the first."""

    def dumps(self) -> None:
        """Return the state: none."""
        return None

    def loads(self, state: Any) -> None:
        """Take the state: none."""
        return None

    def __getstate__(self) -> None:
        return None

    def __setstate__(self, state: Any) -> None:
        return None
