# SPDX-License-Identifier: LGPL-2.1-or-later
"""The body to be filled: any object with one solid."""

from __future__ import annotations

from typing import Any

import Part

from ..errors import EnvelopeError


def solid_of(obj: Any) -> Part.Shape:
    """Return the shape of an envelope object, placed in the document.

    Raises
    ------
    EnvelopeError
        If there is no object, or its shape is not one closed solid.
    """
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        raise EnvelopeError(f"an envelope must have a shape, got {obj.Label + ' without one' if obj else 'nothing'}")
    if len(shape.Solids) != 1:
        raise EnvelopeError(
            f"an envelope must be 1 closed solid, got {len(shape.Solids)} in {obj.Label} ({shape.ShapeType})"
        )
    return shape
