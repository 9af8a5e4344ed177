# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameter classes as properties of document objects, and back.

This is the only place where a frozen parameter class becomes properties and back. The rule: prefix of the class
(``Pore``, ``Path``, ...) + the field's name in CamelCase, or the name that ``BINDINGS`` gives it. Property names are a
file format: they never change without a migration. Lengths are ``App::PropertyLength`` (mm), so that expressions and
units work.
"""

from __future__ import annotations

import dataclasses
import json
import typing
from typing import Any, Callable, Dict, Iterable, List, NamedTuple, Sequence, Tuple, Type, TypeVar

import FreeCAD

from ..core import laws
from ..core.analysis.parameters import SliceParameters
from ..core.parameters import (
    FaceParameters,
    LayerParameters,
    PathParameters,
    Point,
    PoreParameters,
    PrismParameters,
    RodParameters,
    ScaffoldParameters,
)
from ..core.records import from_record, to_record, types_of_fields
from ..core.voxels.parameters import VoxelParameters
from ..errors import ParameterError

T = TypeVar("T")

_MOST = 2**31 - 1


class Binding(NamedTuple):
    """How a parameter class appears on an object: prefix and group of its properties, other names, fields left out."""

    prefix: str
    group: str
    names: Dict[str, str] = {}
    without: Tuple[str, ...] = ()


#: Parameter classes that become properties. ``names`` gives the whole property name, without the prefix.
BINDINGS: Dict[type, Binding] = {
    PoreParameters: Binding("Pore", "Pores"),
    PathParameters: Binding("Path", "Paths"),
    RodParameters: Binding("Rod", "Rods"),
    LayerParameters: Binding("Layer", "Layers"),
    PrismParameters: Binding(
        "",
        "Sites",
        {
            **{f"n_{axis}": f"Sites{axis.upper()}" for axis in "xyz"},
            **{f"a_{axis}": f"Border{axis.upper()}" for axis in "xyz"},
        },
        ("l", "w", "h"),
    ),
    FaceParameters: Binding(
        "",
        "Sites",
        {
            "name": "FaceName",
            "d1": "DirectionU",
            "d2": "DirectionV",
            "c_u": "SpacingU",
            "c_v": "SpacingV",
            "b_u": "BorderU",
            "b_v": "BorderV",
        },
        ("face",),
    ),
    ScaffoldParameters: Binding("", "Scaffold", {"seconds": "TimeBudget", "memory_gb": "MemoryBudget"}),
    SliceParameters: Binding("Slice", "Slices", {}, ("low", "high", "heights", "compensation")),
    VoxelParameters: Binding("Voxel", "Voxels"),
}


class _Kind(NamedTuple):
    """How values of one type are kept: properties (type, suffix, doc, constraint), and value to properties and back."""

    properties: Callable[[dataclasses.Field], Iterable[Tuple[str, str, str, Any]]]
    read: Callable[[Any, str], Any]
    write: Callable[[Any, str, Any], None]


# ------------------------------------------------------------------------------------------------------- the kinds


def _number(obj: Any, name: str) -> float:
    return float(getattr(getattr(obj, name), "Value", getattr(obj, name)))


def _triple(vector: FreeCAD.Vector) -> Point:
    return (vector.x, vector.y, vector.z)


def _float_type(field: dataclasses.Field) -> Tuple[str, Any]:
    meta = field.metadata
    if meta["unit"] == "mm":
        return "App::PropertyLength", None
    if "low" in meta or "high" in meta:
        low, high = meta.get("low", -_MOST), meta.get("high", _MOST)
        return "App::PropertyFloatConstraint", (float(low), float(high), 0.05)
    return "App::PropertyFloat", None


def _one(property_type: str) -> Callable[[dataclasses.Field], Iterable[Tuple[str, str, str, Any]]]:
    return lambda field: [(property_type, "", field.metadata["doc"], None)]


def _float_properties(field: dataclasses.Field) -> Iterable[Tuple[str, str, str, Any]]:
    property_type, constraint = _float_type(field)
    return [(property_type, "", field.metadata["doc"], constraint)]


def _int_properties(field: dataclasses.Field) -> Iterable[Tuple[str, str, str, Any]]:
    constraint = (field.metadata.get("low", 0), field.metadata.get("high", _MOST), 1)
    return [("App::PropertyIntegerConstraint", "", field.metadata["doc"], constraint)]


def _text_properties(field: dataclasses.Field) -> Iterable[Tuple[str, str, str, Any]]:
    choices = field.metadata.get("choices")
    if choices:
        return [("App::PropertyEnumeration", "", field.metadata["doc"], list(choices))]
    return [("App::PropertyString", "", field.metadata["doc"], None)]


def _law_properties(field: dataclasses.Field) -> Iterable[Tuple[str, str, str, Any]]:
    doc, (property_type, constraint) = field.metadata["doc"], _float_type(field)
    return [
        ("App::PropertyEnumeration", "Law", f"{doc}: how it varies over the design", list(laws.KINDS)),
        (property_type, "Low", f"{doc}: the constant value, or the least; linear, radial: at the start", constraint),
        (property_type, "High", f"{doc}: the greatest value; linear, radial: at the end", constraint),
        ("App::PropertyVector", "Direction", f"{doc}: direction in which a linear law grows", None),
        ("App::PropertyString", "Expression", f"{doc}: formula of x, y, z (mm) and a random u in 0..1", None),
    ]


def _read_law(obj: Any, name: str) -> laws.Law:
    low, high = _number(obj, name + "Low"), _number(obj, name + "High")
    direction = _triple(getattr(obj, name + "Direction"))
    return laws.Law(getattr(obj, name + "Law"), low, high, direction, getattr(obj, name + "Expression"))


def _write_law(obj: Any, name: str, law: laws.Law) -> None:
    setattr(obj, name + "Law", law.kind)
    setattr(obj, name + "Low", float(law.low))
    setattr(obj, name + "High", float(law.high))
    setattr(obj, name + "Direction", FreeCAD.Vector(*law.direction))
    setattr(obj, name + "Expression", law.expression)


def _optional_properties(field: dataclasses.Field) -> Iterable[Tuple[str, str, str, Any]]:
    doc = field.metadata["doc"]
    if field.metadata["unit"] == "mm":  # the zero point is a point: whether it is given is a switch of its own
        return [
            ("App::PropertyVectorDistance", "", doc, None),
            ("App::PropertyBool", "Given", f"On: the value counts. {doc}", None),
        ]
    return [("App::PropertyVector", "", f"{doc} (the zero vector)", None)]


def _read_optional(obj: Any, name: str) -> Any:
    value = getattr(obj, name)
    given = getattr(obj, name + "Given") if hasattr(obj, name + "Given") else value.Length > 0
    return _triple(value) if given else None


def _write_optional(obj: Any, name: str, value: Any) -> None:
    setattr(obj, name, FreeCAD.Vector(*(value or (0.0, 0.0, 0.0))))
    if hasattr(obj, name + "Given"):
        setattr(obj, name + "Given", value is not None)


def _plain(property_type: str, read: Callable[[Any], Any], write: Callable[[Any], Any]) -> _Kind:
    return _Kind(
        _one(property_type),
        lambda obj, name: read(getattr(obj, name)),
        lambda obj, name, value: setattr(obj, name, write(value)),
    )


_KINDS: Dict[Any, _Kind] = {
    bool: _plain("App::PropertyBool", bool, bool),
    int: _plain("", int, int)._replace(properties=_int_properties),
    str: _plain("", str, str)._replace(properties=_text_properties),
    float: _Kind(_float_properties, _number, lambda obj, name, value: setattr(obj, name, float(value))),
    laws.Law: _Kind(_law_properties, _read_law, _write_law),
    Point: _plain("App::PropertyVectorDistance", _triple, lambda point: FreeCAD.Vector(*point)),
    typing.Optional[Point]: _Kind(_optional_properties, _read_optional, _write_optional),
    Tuple[Point, ...]: _plain(
        "App::PropertyVectorList",
        lambda points: tuple(_triple(p) for p in points),
        lambda points: [FreeCAD.Vector(*p) for p in points],
    ),
    Tuple[str, ...]: _plain("App::PropertyStringList", tuple, list),
}


# --------------------------------------------------------------------------------- parameter class <-> properties


def property_name(cls: type, field: str) -> str:
    """Return the name of the property (of a law or an optional point: its first part) that keeps a field.

    Examples
    --------
    >>> property_name(PoreParameters, "scatter"), property_name(PrismParameters, "n_x")
    ('PoreScatter', 'SitesX')
    """
    binding = BINDINGS[cls]
    return binding.names.get(field) or binding.prefix + "".join(
        part[:1].upper() + part[1:] for part in field.split("_")
    )


def _fields(cls: type) -> Iterable[Tuple[dataclasses.Field, str, Any]]:
    """Yield field, property name and type of each field that becomes properties."""
    hints = types_of_fields(cls)
    for field in dataclasses.fields(cls):
        if field.name not in BINDINGS[cls].without:
            yield field, property_name(cls, field.name), hints[field.name]


def add_parameters(obj: Any, cls: type) -> None:
    """Add the properties of a parameter class that the object lacks, with the class's defaults; set the limits of all.

    FreeCAD does not save the limits of constrained numbers, hence this is called for restored objects too.
    """
    for field, name, hint in _fields(cls):
        if hint in BINDINGS:
            add_parameters(obj, hint)
            continue
        kind, missing = _KINDS[hint], False
        for property_type, suffix, doc, constraint in kind.properties(field):
            if not hasattr(obj, name + suffix):
                obj.addProperty(property_type, name + suffix, BINDINGS[cls].group, doc + _letter(cls, field.name))
                missing = True
                if isinstance(constraint, list):
                    setattr(obj, name + suffix, constraint)
            if isinstance(constraint, tuple):
                setattr(obj, name + suffix, (getattr(obj, name + suffix), *constraint))
        if missing:
            kind.write(obj, name, field.default)


def _letter(cls: type, name: str) -> str:
    """A field's own name, for the description of a property that has another."""
    return f" ({name})" if name in BINDINGS[cls].names else ""


def descriptions(cls: type) -> List[str]:
    """Return what each property of a parameter class is, in the words that the property editor shows.

    Examples
    --------
    >>> descriptions(LayerParameters)[1]
    'Thickness of the layer'
    """
    return [
        doc + _letter(cls, field.name)
        for field, _, hint in _fields(cls)
        if hint not in BINDINGS
        for _, _, doc, _ in _KINDS[hint].properties(field)
    ]


def write_parameters(obj: Any, parameters: Any) -> None:
    """Set an object's properties from a parameter object."""
    for field, name, hint in _fields(type(parameters)):
        value = getattr(parameters, field.name)
        if hint in BINDINGS:
            write_parameters(obj, value)
        else:
            _KINDS[hint].write(obj, name, value)


def read_parameters(obj: Any, cls: type, **fixed: Any) -> Any:
    """Return the checked parameter object that an object's properties describe.

    Parameters
    ----------
    obj : document object
    cls : type
        A parameter class of ``BINDINGS``.
    **fixed
        Values of the fields that are no properties.

    Raises
    ------
    ParameterError
        If the class refuses the values.
    """
    values = dict(fixed)
    for field, name, hint in _fields(cls):
        try:
            values[field.name] = read_parameters(obj, hint) if hint in BINDINGS else _KINDS[hint].read(obj, name)
        except ParameterError as error:
            unit = field.metadata["unit"]
            raise ParameterError(f"{name}{' (' + unit + ')' if unit else ''}: {error}") from error
    return cls(**values)


# -------------------------------------------------------------------------------------- records <-> lists of texts


def lines_of(records: Sequence[Any]) -> List[str]:
    """Return records as readable lines of JSON, one each, for a string-list property."""
    return [json.dumps(to_record(record), ensure_ascii=False) for record in records]


def records_of(lines: Sequence[str], cls: Type[T], what: str) -> Tuple[T, ...]:
    """Return the checked records in the lines of a string-list property; empty lines are passed over.

    Raises
    ------
    ParameterError
        If a line is no JSON, or not a record of ``cls``; the message counts the lines from 1.
    """
    found = []
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            record = json.loads(line)
        except (ValueError, RecursionError) as error:
            raise ParameterError(f"{what} {number} must be one JSON object, got {line!r:.80}: {error}") from error
        found.append(from_record(cls, record, f"{what} {number}"))
    return tuple(found)
