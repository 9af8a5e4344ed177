# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a document: what can be filled with rods, measured, or be a sample. A cheap look, no check of them."""

from __future__ import annotations

from typing import Any, List, Sequence

from .relations import type_of

_SOLID = ("Solid", "CompSolid")


def is_mesh(obj: Any) -> bool:
    """Return whether an object has triangles."""
    mesh = getattr(obj, "Mesh", None)
    return hasattr(mesh, "CountFacets") and mesh.CountFacets > 0


def has_solid(obj: Any) -> bool:
    """Return whether an object has a solid of its own; a step of a PartDesign body has not, its body has."""
    if not obj.isDerivedFrom("Part::Feature") or whole(obj) is not obj or obj.Shape.isNull():
        return False
    kind = obj.Shape.ShapeType
    # a compound may hold lines only; ours are not looked at, which may hold a thousand solids
    return kind in _SOLID or kind == "Compound" and bool(type_of(obj) or obj.Shape.Solids)


def is_solid(obj: Any) -> bool:
    """Return whether an object that is not ours has a solid of its own."""
    return not type_of(obj) and has_solid(obj)


def is_body(obj: Any) -> bool:
    """Return whether an object that is not ours is a mesh or a solid."""
    return is_solid(obj) or (not type_of(obj) and is_mesh(obj))


def whole(obj: Any) -> Any:
    """Return the PartDesign body of which an object is a step; any other object itself.

    A click on such a body means its last step, whose shape is not placed where the body is seen.
    """
    parent = obj.getParentGeoFeatureGroup()
    return parent if parent is not None and parent.TypeId == "PartDesign::Body" else obj


def wholes(objects: Sequence[Any]) -> List[Any]:
    """Return objects with steps of PartDesign bodies replaced by their bodies, each once, in their order."""
    found: List[Any] = []
    for obj in objects:
        if whole(obj) not in found:
            found.append(whole(obj))
    return found
