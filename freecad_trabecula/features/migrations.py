# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects of older files brought to the present schema, one step at a time; properties renamed with all that uses them.

A step is a function of an object that changes its properties from schema n to n + 1. A class names its steps in
``Feature.MIGRATIONS``; where it names none for a schema, nothing of it changed. ``docs/documents.md`` has the history.
"""

from __future__ import annotations

import re
from typing import Any, Callable, Dict, Iterator, List, Tuple

from ..errors import TrabeculaError

#: Schema of the objects that are made today.
SCHEMA_VERSION = 1

Step = Callable[[Any], None]
# a string in <<...>>, a name, a number with its unit glued on, or one other character
_TOKENS = re.compile(r"<<(?:\\.|[^>\\]|>(?!>))*>>|[^\W\d]\w*|[\d.]*\d\w*|\s+|.", re.DOTALL)
_CELL = re.compile(r'<Cell address="([A-Z]+\d+)" content="=')
_KEPT = ("Hidden", "ReadOnly")  # what setEditorMode calls the attributes that an object can change


def migrate(obj: Any, steps: Dict[int, Step]) -> None:
    """Bring an object to the present schema.

    Parameters
    ----------
    obj : document object
        With a ``SchemaVersion``; one of a later schema stays as it is.
    steps : dict
        ``steps[n]`` leads from schema n to n + 1.
    """
    for version in range(obj.SchemaVersion, SCHEMA_VERSION):
        if version in steps:
            steps[version](obj)
        obj.SchemaVersion = version + 1


def check_schema(obj: Any) -> None:
    """Refuse an object made by a later version."""
    if obj.SchemaVersion > SCHEMA_VERSION:
        raise TrabeculaError(
            f"{obj.Label} was made by a later version of Trabecula: its schema must be at most {SCHEMA_VERSION}, "
            f"got {obj.SchemaVersion}; update Trabecula"
        )


def rename_property(obj: Any, old: str, new: str) -> None:
    """Give a property another name; its value, its expression and all expressions that use it stay what they were.

    Parameters
    ----------
    obj : document object
    old : str
        Name of a property that was added to the object; if there is none (any more), nothing is done.
    new : str
    """
    if old not in obj.PropertiesList:
        return
    kind, group = obj.getTypeIdOfProperty(old), obj.getGroupOfProperty(old)
    if new not in obj.PropertiesList:
        obj.addProperty(kind, new, group, obj.getDocumentationOfProperty(old))
    if kind == "App::PropertyEnumeration":
        setattr(obj, new, obj.getEnumerationsOfProperty(old))
    setattr(obj, new, getattr(obj, old))
    obj.setEditorMode(new, [one for one in obj.getEditorMode(old) if one in _KEPT])
    _move_expressions(obj, old, new)
    obj.removeProperty(old)


def _move_expressions(obj: Any, old: str, new: str) -> None:
    """Rewrite what is bound to a property and what reads it, in all of the document."""
    for one in obj.Document.Objects:
        touched = "Touched" in one.State
        for path, expression in list(one.ExpressionEngine):
            target = _path_renamed(path, old, new) if one == obj else path
            text = renamed(expression, obj, old, new, one == obj)
            if (target, text) != (path, expression):
                one.setExpression(path, None)
                one.setExpression(target, text)
        for cell, content in _formulas(one):
            text = renamed(content, obj, old, new, False)
            if text != content:
                one.set(cell, text)
        if not touched:
            one.purgeTouched()


def _path_renamed(path: str, old: str, new: str) -> str:
    """``old``, ``.old`` or a part of it such as ``old.x``, as FreeCAD writes what an expression is bound to."""
    return re.sub(rf"^(\.?){re.escape(old)}(?!\w)", rf"\g<1>{new}", path)


def _formulas(obj: Any) -> Iterator[Tuple[str, str]]:
    """Yield cells of a spreadsheet and their formulas; FreeCAD 0.20 lists the cells that are used only in its XML."""
    if obj.TypeId == "Spreadsheet::Sheet":
        for cell in _CELL.findall(obj.cells.Content):
            yield cell, obj.getContents(cell)


def renamed(expression: str, obj: Any, old: str, new: str, own: bool) -> str:
    """Return an expression in which a property of an object has another name.

    Parameters
    ----------
    expression : str
    obj : document object
        Whose property it is: ``Name.old``, ``<<Label>>.old``, ``Document#Name.old``.
    old, new : str
    own : bool
        Whether the expression is the object's own, where ``old`` alone and ``.old`` mean it too.
    """
    tokens: List[str] = _TOKENS.findall(expression)
    owners = (obj.Name, f"<<{obj.Label}>>")
    for k, token in enumerate(tokens):
        if token == old and _owner(tokens, k) in (owners + ("",) if own else owners):
            tokens[k] = new
    return "".join(tokens)


def _owner(tokens: List[str], k: int) -> str:
    """Return what stands before the dot in front of a token: a name, ``""`` if none; ``"."`` if that is a part too."""
    if k == 0 or tokens[k - 1] != ".":
        return ""
    before = tokens[k - 2] if k > 1 else ""
    if not re.match(r"<<|[^\W\d]", before):
        return ""
    # Name.Other.old is a part of another property
    return before if k < 3 or tokens[k - 3] != "." else "."
