# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frozen parameter records as the Python that makes them: only what differs from their defaults, in short lines."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Iterable, List, Sequence, Set

from .laws import Law
from .parameters import Coupling, FaceParameters, SiteEdit

#: Columns of a line; longer calls have an argument a line.
WIDTH = 110
_STEP = "    "
#: Fields at the front that are written without their names, because everybody knows them by their place.
_PLACES = {Law: 3, Coupling: 2, FaceParameters: 1, SiteEdit: 2}


def python_text(value: Any, used: Set[type], column: int = 0, margin: str = "") -> str:
    """Return Python that evaluates to a value.

    Parameters
    ----------
    value : dataclass, tuple, list, str, number, bool or None
    used : set of type
        Takes up the classes that the text names, for ``import_lines``.
    column : int
        Characters that stand before the text in its first line.
    margin : str
        White space before the line in which the text begins.

    Examples
    --------
    >>> python_text((Coupling("A", "B"), Coupling("B", "C", limit=3)), set())
    '(Coupling("A", "B"), Coupling("B", "C", limit=3))'
    """
    if dataclasses.is_dataclass(value):
        used.add(type(value))
        return call_text(type(value).__name__, _arguments(value), used, column, margin)
    if isinstance(value, tuple):
        parts = [("", one) for one in value]
        return call_text("", parts, used, column, margin, "," if len(parts) == 1 else "")
    if isinstance(value, str):
        return str(value) if isinstance(value, Name) else _quoted(value)
    if isinstance(value, float) and not math.isfinite(value):
        return f'float("{value}")'
    return repr(value)


def call_text(
    name: str, arguments: Sequence[Any], used: Set[type], column: int = 0, margin: str = "", tail: str = ""
) -> str:
    """Return a call, in one line if there is room, else with an argument a line.

    Parameters
    ----------
    name : str
    arguments : sequence of (str, object)
        Keyword ("" for none) and value; a ``Name`` is written as it stands.
    used, column, margin
        As for ``python_text``.
    tail : str
        Stands before the bracket that closes.

    Examples
    --------
    >>> call_text("make.make_box", [("", Name("document")), ("l", 12.5)], set())
    'make.make_box(document, l=12.5)'
    """
    heads = [f"{key}=" if key else "" for key, _ in arguments]
    texts = [head + python_text(value, used, -(10**6)) for head, (_, value) in zip(heads, arguments)]
    line = f"{name}({', '.join(texts)}{tail})"
    if column + len(line) <= WIDTH or not arguments:
        return line
    inner = margin + _STEP
    rows = [
        inner + head + python_text(value, used, len(inner + head) + 1, inner) + ","
        for head, (_, value) in zip(heads, arguments)
    ]
    return "\n".join([f"{name}(", *rows, f"{margin})"])


class Name(str):
    """A variable of the script: written without quotes."""

    __slots__ = ()


def _arguments(value: Any) -> List[Any]:
    """Keyword and value of each field that has to be written."""
    places, found = _PLACES.get(type(value), 0), []
    for number, field in enumerate(dataclasses.fields(value)):
        own = getattr(value, field.name)
        if number < places:
            found.append(("", own))
        elif not same(own, field.default):
            found.append((field.name, own))
    return found


def same(first: Any, second: Any) -> bool:
    """Return whether two values of parameters are equal; nan is equal to nan."""
    if isinstance(first, float) and isinstance(second, float) and math.isnan(first):
        return math.isnan(second)
    if dataclasses.is_dataclass(first) and type(first) is type(second):
        return all(same(getattr(first, f.name), getattr(second, f.name)) for f in dataclasses.fields(first))
    return bool(first == second)


def import_lines(used: Iterable[type]) -> List[str]:
    """Return the lines that import classes, one a module, in order.

    Examples
    --------
    >>> import_lines({SiteEdit, Coupling})
    ['from freecad_trabecula.core.parameters import Coupling, SiteEdit']
    """
    modules = sorted({one.__module__ for one in used})
    return [
        f"from {module} import {', '.join(sorted(one.__name__ for one in used if one.__module__ == module))}"
        for module in modules
    ]


def _quoted(text: str) -> str:
    """A text in double quotes where that needs no escapes."""
    return repr(text) if '"' in text or repr(text)[0] == '"' or "\\" in text else f'"{repr(text)[1:-1]}"'
