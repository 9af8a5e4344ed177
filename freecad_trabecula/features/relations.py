# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which objects of a document belong together: a design, its sites, what was made of it."""

from __future__ import annotations

from typing import Any, List


def type_of(obj: Any) -> str:
    """Return the word by which one of our objects is known; empty for others."""
    name = getattr(getattr(obj, "Proxy", None), "Type", "")
    return name if isinstance(name, str) and name.startswith("Trabecula::") else ""


def wireframe_of(obj: Any) -> Any:
    """Return the wireframe to which one of our objects belongs, None if there is none."""
    kind = type_of(obj)
    if kind == "Trabecula::Wireframe":
        return obj
    if kind in ("Trabecula::FaceSites", "Trabecula::PrismSites"):
        return next((one for one in obj.InList if type_of(one) == "Trabecula::Wireframe"), None)
    if kind == "Trabecula::Body":
        return wireframe_of(obj.Scaffold)
    return getattr(obj, "Wireframe", None) if kind else None


def products_of(wireframe: Any) -> List[Any]:
    """Return networks and scaffolds made of a wireframe."""
    return [one for one in wireframe.InList if type_of(one) and getattr(one, "Wireframe", None) == wireframe]


def roles_of(scaffold: Any) -> List[Any]:
    """Return channels, loose pieces and voids that belong to a scaffold."""
    return [one for one in scaffold.InList if type_of(one) == "Trabecula::Body" and one.Scaffold == scaffold]


def parts_of(wireframe: Any) -> List[Any]:
    """Return all bodies made of a wireframe, parts of scaffolds included."""
    return [part for one in products_of(wireframe) for part in (one, *roles_of(one))]
