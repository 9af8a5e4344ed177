# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts hand to the functions of ``make``: each is looked at first, and refused in one sentence.

FreeCAD's own objects would say no more than that an attribute is missing, somewhere further down.
"""

from __future__ import annotations

import re
from typing import Any, List, Sequence, Type

from ..errors import ParameterError
from .feature import Feature, is_a


def given_object(obj: Any, *kinds: Type[Feature]) -> Any:
    """Return a document object: any, or one of ours of the given classes.

    Raises
    ------
    ParameterError
        If it is something else.
    """
    if not (hasattr(obj, "TypeId") and hasattr(obj, "Document")):
        raise ParameterError(f"an object of a document is needed, got {obj!r:.60}")
    if kinds and not is_a(obj, *kinds):
        raise ParameterError(f"the object must be of the kind {_words(kinds)}, got {obj.Label} ({obj.TypeId})")
    return obj


def given_in(document: Any, *objects: Any) -> None:
    """Refuse objects of another document, which links do not reach; None among them is passed over.

    Raises
    ------
    ParameterError
        If one is of another document, or no object of a document.
    """
    for obj in objects:
        if obj is not None and given_object(obj).Document != given_document(document):
            raise ParameterError(
                f"the object must be in the document {document.Label}, got {obj.Label} of {obj.Document.Label}"
            )


def given_objects(objects: Any, *kinds: Type[Feature]) -> List[Any]:
    """Return a list of document objects; arguments and errors are those of ``given_object``."""
    if not isinstance(objects, (list, tuple)):
        raise ParameterError(f"a list of objects is needed, got {objects!r:.60}")
    return [given_object(obj, *kinds) for obj in objects]


def given_document(document: Any) -> Any:
    """Return a document.

    Raises
    ------
    ParameterError
        If it is something else.
    """
    if not (hasattr(document, "Objects") and hasattr(document, "addObject")):
        raise ParameterError(f"a document is needed, got {document!r:.60}")
    return document


def given_value(value: Any, *types: type) -> Any:
    """Return a value of one of the given types.

    Raises
    ------
    ParameterError
        If it is of another type.
    """
    if not isinstance(value, types):
        names = " or ".join(one.__name__ for one in types)
        raise ParameterError(f"a value of the type {names} is needed, got {value!r:.60}")
    return value


def given_numbers(numbers: Any) -> List[int]:
    """Return whole numbers, at least one.

    Raises
    ------
    ParameterError
        If there is none, or one is no whole number.
    """
    try:
        found = list(numbers)
    except TypeError:
        raise ParameterError(f"a list of whole numbers is needed, got {numbers!r:.60}") from None
    whole = [one for one in found if isinstance(one, int) or hasattr(one, "__index__")]
    if not found or len(whole) < len(found):
        raise ParameterError(f"a list of whole numbers is needed, got {found!r:.60}")
    return [int(one) for one in found]


def _words(kinds: Sequence[type]) -> str:
    """Return the words for classes of ours: ``VoxelDesign`` is a voxel design."""
    return " or ".join(re.sub(r"(?<!^)(?=[A-Z])", " ", one.__name__).lower() for one in kinds)
