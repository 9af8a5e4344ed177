# SPDX-License-Identifier: LGPL-2.1-or-later
"""The body to be filled: any object with one solid."""

from __future__ import annotations

from typing import Any, NamedTuple, Tuple

import Part

from ..errors import EnvelopeError
from ..geometry.envelopes import Envelope, envelope_from_shape
from ..geometry.fingerprints import fingerprint
from . import results

#: Properties of an envelope made from a file: where it came from, so that its job can be saved; what was mended.
SOURCE_FILE, SOURCE_SOLID, NOTES = "SourceFile", "SourceSolid", "Notes"


class Body(NamedTuple):
    """An envelope and the fingerprint of the shape that it is made of."""

    envelope: Envelope
    mark: str


def envelope_of(obj: Any) -> Body:
    """Return the envelope that a document object is, placed in the document.

    Raises
    ------
    EnvelopeError
        If there is no object, or its shape is not one closed solid that can be filled.
    """
    shape = _shape_of(obj)
    try:
        return checked_envelope(shape)
    except EnvelopeError as error:
        raise EnvelopeError(f"{obj.Label}: {error}") from error


def mark_of(obj: Any) -> str:
    """Return the fingerprint of the envelope that a document object is; whether it can be filled is not looked at.

    Raises
    ------
    EnvelopeError
        If there is no object, or it has no shape.
    """
    return fingerprint(_shape_of(obj))


def _shape_of(obj: Any) -> Part.Shape:
    shape = getattr(obj, "Shape", None)
    if shape is None or shape.isNull():
        raise EnvelopeError(f"an envelope must have a shape, got {obj.Label + ' without one' if obj else 'nothing'}")
    return shape


def checked_envelope(shape: Part.Shape) -> Body:
    """Return the envelope of a shape, checked once."""
    mark = fingerprint(shape)
    return Body(results.found_or_made("envelope", mark, lambda: envelope_from_shape(shape)), mark)


def is_known(obj: Any) -> bool:
    """Return whether the envelope that a document object is has been checked already."""
    return results.find("envelope", mark_of(obj)) is not None


def source_of(obj: Any) -> Tuple[str, str]:
    """Return file and solid from which an envelope was made; empty if it was not."""
    return getattr(obj, SOURCE_FILE, ""), getattr(obj, SOURCE_SOLID, "")


def fill(obj: Any, envelope: Envelope, file: str, solid: str) -> None:
    """Make a ``Part::Feature`` the envelope that a file gave, and note where it came from."""
    for kind, name, value, doc in (
        ("String", SOURCE_FILE, file, "File from which the envelope was made"),
        ("String", SOURCE_SOLID, solid, "Solid in that file"),
        ("StringList", NOTES, list(envelope.notes), "What was mended in the file's solid, and what looks wrong"),
    ):
        obj.addProperty("App::Property" + kind, name, "Base", doc)
        setattr(obj, name, value)
    obj.Shape = envelope.solid
    results.keep("envelope", fingerprint(obj.Shape), envelope)
