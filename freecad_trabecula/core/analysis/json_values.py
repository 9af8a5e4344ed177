# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dataclasses with arrays as JSON values and back: what is no number becomes null."""

from __future__ import annotations

import dataclasses
import json
import math
import re
import typing
import warnings
from typing import Any, Dict, Mapping, Type, TypeVar

import numpy as np

from ...errors import ParameterError

T = TypeVar("T")
#: Lists of numbers only, which stand in one line.
_NUMBERS = re.compile(r"\[\s+([-+0-9.eE,\s]|null|true|false)+?\s+\]")


def to_values(value: Any) -> Any:
    """Return dicts, lists, texts and numbers for a dataclass, named tuple, array or any of them in one another."""
    if dataclasses.is_dataclass(value):
        return {field.name: to_values(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, np.ndarray):
        return to_values(value.tolist())
    if isinstance(value, np.generic):
        return to_values(value.item())
    if hasattr(value, "_asdict"):
        return to_values(value._asdict())
    if isinstance(value, Mapping):
        return {str(key): to_values(own) for key, own in value.items()}
    if isinstance(value, (list, tuple)):
        return [to_values(own) for own in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def from_values(cls: Type[T], values: Any, where: str) -> T:
    """Return the dataclass or named tuple that ``to_values`` took apart.

    Parameters
    ----------
    cls : type
        Its fields are numbers, texts, arrays, dataclasses, or tuples and dicts of them.
    values : dict
        Missing keys take the default, keys that the class does not know are passed over.
    where : str
        For messages: the file and the place in it.

    Raises
    ------
    ParameterError
        If something is missing or of another type, or the class refuses it.
    """
    if not isinstance(values, dict):
        raise ParameterError(f"{where} must be an object with keys, got {values!r:.60}")
    hints = typing.get_type_hints(cls)
    names = [name for name in hints if name in values]
    try:
        return cls(**{name: _made(hints[name], values[name], f"{where}.{name}") for name in names})
    except TypeError as error:  # a field without default is missing
        raise ParameterError(f"{where} is incomplete: {error}") from error


def _made(hint: Any, value: Any, where: str) -> Any:
    origin, args = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Union:
        return None if value is None else _made(args[0], value, where)
    if dataclasses.is_dataclass(hint) or hasattr(hint, "_fields"):
        return from_values(hint, value, where)
    if hint is np.ndarray:
        return _array(value, where)
    if origin is tuple:
        return _tuple(args, value, where)
    if origin is dict and isinstance(value, dict):
        return {key: _made(args[1], own, f"{where}.{key}") for key, own in value.items()}
    if hint is float and value is None:
        return math.nan
    if hint is float and isinstance(value, (int, float)) and not isinstance(value, bool):
        return float(value)
    if hint is Any or (
        isinstance(hint, type) and isinstance(value, hint) and (hint is bool) == isinstance(value, bool)
    ):
        return value
    raise ParameterError(f"{where} must be {_word(hint)}, got {value!r:.60}")


def _word(hint: Any) -> str:
    return {float: "a number", int: "a whole number", str: "a text", bool: "true or false"}.get(hint, "an object")


def _tuple(args: tuple, value: Any, where: str) -> tuple:
    if not isinstance(value, list) or (args[-1] is not Ellipsis and len(args) != len(value)):
        raise ParameterError(f"{where} must be a list, got {value!r:.60}")
    hints = [args[0]] * len(value) if args[-1] is Ellipsis else args
    return tuple(_made(hint, own, f"{where}[{i}]") for i, (hint, own) in enumerate(zip(hints, value)))


def _array(value: Any, where: str) -> np.ndarray:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # numpy before 1.24 only warns of rows of different lengths
            array = np.array(value)
        if array.dtype == object:  # null among the numbers
            array = np.array(value, float)
    except (TypeError, ValueError, Warning) as error:
        raise ParameterError(f"{where} must be a list of numbers: {error}") from error
    if array.dtype.kind not in "bif":
        raise ParameterError(f"{where} must be a list of numbers, got {value!r:.60}")
    return array


def values_json(values: Dict[str, Any]) -> str:
    """Return JSON text for readers, lists of numbers in one line."""
    text = json.dumps(values, indent=2, allow_nan=False, ensure_ascii=False)
    return _NUMBERS.sub(lambda found: "[" + " ".join(found.group(0)[1:-1].split()) + "]", text) + "\n"
