# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as files, or as a text and numbers in a document: values of dataclasses, tuples, arrays, shapes, meshes.

In a folder ``value.json`` holds the structure; arrays stand in ``arrays.npz``, shapes in binary BREP, meshes in
FreeCAD's own binary form. In a document arrays are parts of one list of numbers. No pickle: what is read is data.
"""

from __future__ import annotations

import dataclasses
import importlib
import json
import math
from pathlib import Path
from typing import Any, List, Sequence, Tuple

import Mesh
import numpy as np
import Part

from ..errors import ExportError

_PACKAGE = __name__.split(".")[0] + "."


def _class_name(cls: type) -> str:
    return f"{cls.__module__}:{cls.__name__}"


def _class_named(name: str) -> type:
    """Return one of our own classes: files can name no other."""
    module, _, cls = name.partition(":")
    if not module.startswith(_PACKAGE):
        raise ExportError(f"results must be of classes of {_PACKAGE[:-1]}, got {name!r}")
    return getattr(importlib.import_module(module), cls)


class _Files:
    """Arrays, shapes and meshes of one value, in a folder."""

    def __init__(self, folder: Path, arrays: Any = None) -> None:
        self.folder, self.read = folder, arrays
        self.arrays: List[np.ndarray] = []
        self.others = 0

    def put_array(self, array: np.ndarray) -> Any:
        """Take an array; return where it is."""
        self.arrays.append(array)
        return len(self.arrays) - 1

    def array(self, place: int) -> np.ndarray:
        """Return the array at a place."""
        return self.read[f"arr_{place}"]

    def put(self, value: Any) -> Any:
        """Take a shape or a mesh; return where it is, None for other values."""
        self.others += 1
        if isinstance(value, Part.Shape):
            value.exportBinary(str(self.folder / f"{self.others}.bin"))
            return {"shape": f"{self.others}.bin"}
        if isinstance(value, Mesh.Mesh):
            value.write(str(self.folder / f"{self.others}.bms"))
            return {"mesh": f"{self.others}.bms"}
        return None

    def get(self, kind: str, name: str) -> Any:
        """Return a shape or a mesh."""
        if kind == "shape":
            shape = Part.Shape()
            shape.importBinary(str(self.folder / name))
            return shape.Solids[0] if shape.ShapeType == "Solid" else shape  # a solid knows its centre
        mesh = Mesh.Mesh()
        mesh.read(str(self.folder / name))
        return mesh


class _Numbers:
    """Arrays of one value as one list of numbers; it holds no shapes and no meshes."""

    def __init__(self, numbers: Sequence[float] = ()) -> None:
        self.numbers = np.asarray(numbers, float)
        self.parts: List[np.ndarray] = []
        self.count = 0

    def put_array(self, array: np.ndarray) -> Any:
        """Take an array; return where it is."""
        self.parts.append(array.astype(float).ravel())
        self.count += array.size
        return [self.count - array.size, array.dtype.str, list(array.shape)]

    def array(self, place: Any) -> np.ndarray:
        """Return the array at a place."""
        start, dtype, shape = place
        part = self.numbers[start : start + math.prod(shape)]
        return part.reshape(shape).astype(np.dtype(dtype))

    def put(self, value: Any) -> Any:
        """Take nothing."""
        return None


def write_value(value: Any, folder: Path) -> None:
    """Write a value into a new folder."""
    folder.mkdir(parents=True, exist_ok=True)
    files = _Files(folder)
    text = json.dumps(_packed(value, files))
    np.savez(str(folder / "arrays.npz"), *files.arrays)
    (folder / "value.json").write_text(text, encoding="utf-8")


def read_value(folder: Path) -> Any:
    """Return the value that ``write_value`` wrote."""
    with np.load(str(folder / "arrays.npz"), allow_pickle=False) as arrays:
        return _unpacked(json.loads((folder / "value.json").read_text(encoding="utf-8")), _Files(folder, arrays))


def to_numbers(value: Any) -> Tuple[str, List[float]]:
    """Return a value without shapes and meshes as a text and a list of numbers."""
    store = _Numbers()
    text = json.dumps(_packed(value, store))
    return text, np.concatenate([np.zeros(0), *store.parts]).tolist()


def from_numbers(text: str, numbers: Sequence[float]) -> Any:
    """Return the value that ``to_numbers`` made into a text and numbers.

    Raises
    ------
    ExportError
        If they are not such a value, or one of another version.
    """
    try:
        return _unpacked(json.loads(text), _Numbers(numbers))
    except (ValueError, TypeError, AttributeError, KeyError, ImportError) as error:
        raise ExportError(f"what a document holds must be a value of this version: {error}") from error


def _packed(value: Any, store: Any) -> Any:
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, np.ndarray):
        return {"array": store.put_array(value)}
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, dict):
        return {"dict": [[_packed(k, store), _packed(v, store)] for k, v in value.items()]}
    names = _field_names(value)
    if names:
        fields = {name: _packed(getattr(value, name), store) for name in names}
        return {"class": _class_name(type(value)), "fields": fields}
    if isinstance(value, (tuple, list)):
        return {"list" if isinstance(value, list) else "tuple": [_packed(v, store) for v in value]}
    packed = store.put(value)
    if packed is None:
        raise ExportError(f"results must be numbers, texts, arrays or records of them, got {type(value)}")
    return packed


def _field_names(value: Any) -> List[str]:
    if dataclasses.is_dataclass(value):
        return [f.name for f in dataclasses.fields(value)]
    return list(getattr(value, "_fields", ()))


def _unpacked(value: Any, store: Any) -> Any:
    if not isinstance(value, dict):
        return value
    (kind, inner), *fields = value.items()
    if kind == "array":
        return store.array(inner)
    if kind in ("shape", "mesh"):
        return store.get(kind, inner)
    if kind == "dict":
        return {_unpacked(k, store): _unpacked(v, store) for k, v in inner}
    if kind == "class":
        return _class_named(inner)(**{name: _unpacked(v, store) for name, v in fields[0][1].items()})
    values = [_unpacked(v, store) for v in inner]
    return values if kind == "list" else tuple(values)
