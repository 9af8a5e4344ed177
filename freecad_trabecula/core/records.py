# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frozen dataclasses to plain records (JSON) and back, with a clear error for every unknown key and wrong type."""

from __future__ import annotations

import dataclasses
import typing
from functools import lru_cache
from typing import Any, Dict, Type, TypeVar

from ..errors import ParameterError

T = TypeVar("T")


def to_record(value: Any, everything: bool = False) -> Any:
    """Return dicts, lists, strings, numbers for a dataclass; defaults are left out unless ``everything``."""
    if dataclasses.is_dataclass(value):
        record = {}
        for f in dataclasses.fields(value):
            own = getattr(value, f.name)
            if everything or f.default is dataclasses.MISSING or own != f.default:
                record[f.name] = to_record(own, everything)
        return record
    if isinstance(value, tuple):
        return [to_record(v, everything) for v in value]
    return value


@lru_cache(maxsize=None)
def types_of_fields(cls: type) -> Dict[str, Any]:
    """Return the types of a dataclass's fields, by name; worked out once, since a panel asks for dozens.

    Examples
    --------
    >>> from freecad_trabecula.core.parameters import PrismParameters
    >>> types_of_fields(PrismParameters)["l"]
    <class 'float'>
    """
    return typing.get_type_hints(cls)


def from_record(cls: Type[T], record: Any, where: str) -> T:
    """Return the dataclass ``cls`` made from a record.

    Parameters
    ----------
    cls : type
        A dataclass whose fields are numbers, strings, bools, dataclasses, or tuples of them.
    record : dict
        Keys are field names; missing ones take the default.
    where : str
        Where the record stands, for messages: ``job.pores``.

    Raises
    ------
    ParameterError
        If a key is unknown, a value has the wrong type, or the class refuses it.
    """
    if not isinstance(record, dict):
        raise ParameterError(f"{where} must be an object with keys, got {_kind(record)}")
    kind: type = cls
    hints = types_of_fields(kind)
    names = [f.name for f in dataclasses.fields(cls)]  # type: ignore[arg-type]
    for key in record:
        if key not in names:
            raise ParameterError(f"{where} has no key {key!r}; known are {', '.join(names)}")
    values: Dict[str, Any] = {k: _value(hints[k], v, f"{where}.{k}") for k, v in record.items()}
    try:
        return cls(**values)
    except ParameterError as error:
        raise ParameterError(f"{where}: {error}") from error


def _value(hint: Any, value: Any, where: str) -> Any:
    origin, args = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Union:  # Optional
        return None if value is None else _value(args[0], value, where)
    if isinstance(hint, type) and dataclasses.is_dataclass(hint):
        return from_record(hint, value, where)
    if origin is tuple:
        return _tuple(args, value, where)
    if hint is float and isinstance(value, (int, float)) and not isinstance(value, bool):
        try:
            return float(value)
        except OverflowError as error:
            raise ParameterError(f"{where} must be a number a computer can hold, got {value}") from error
    if hint is int and isinstance(value, int) and not isinstance(value, bool):
        return value
    if hint in (str, bool) and isinstance(value, hint):
        return value
    raise ParameterError(f"{where} must be {_WORDS.get(hint, hint)}, got {_kind(value)}")


def _tuple(args: tuple, value: Any, where: str) -> tuple:
    if not isinstance(value, (list, tuple)):
        raise ParameterError(f"{where} must be a list, got {_kind(value)}")
    if args[-1] is Ellipsis:
        return tuple(_value(args[0], v, f"{where}[{i}]") for i, v in enumerate(value))
    if len(value) != len(args):
        raise ParameterError(f"{where} must have {len(args)} values, got {len(value)}")
    return tuple(_value(a, v, f"{where}[{i}]") for i, (a, v) in enumerate(zip(args, value)))


_WORDS = {float: "a number", int: "a whole number", str: "a text", bool: "true or false"}


def _kind(value: Any) -> str:
    return f"{value!r:.60} ({type(value).__name__})"
