# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as files: a value of dataclasses, tuples, arrays, shapes and meshes to a folder and back.

``value.json`` holds the structure; arrays stand in ``arrays.npz``, shapes in binary BREP, meshes in FreeCAD's own
binary form. No pickle: what another process wrote is data, not code.
"""

from __future__ import annotations

import dataclasses
import importlib
import json
from pathlib import Path
from typing import Any, List

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
    """Arrays, shapes and meshes of one value."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.arrays: List[np.ndarray] = []
        self.shapes = self.meshes = 0


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
        return _unpacked(json.loads((folder / "value.json").read_text(encoding="utf-8")), folder, arrays)


def _packed(value: Any, files: _Files) -> Any:
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, np.ndarray):
        files.arrays.append(value)
        return {"array": len(files.arrays) - 1}
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Part.Shape):
        files.shapes += 1
        name = f"{files.shapes}.bin"
        value.exportBinary(str(files.folder / name))
        return {"shape": name}
    if isinstance(value, Mesh.Mesh):
        files.meshes += 1
        name = f"{files.meshes}.bms"
        value.write(str(files.folder / name))
        return {"mesh": name}
    if isinstance(value, dict):
        return {"dict": [[_packed(k, files), _packed(v, files)] for k, v in value.items()]}
    names = _field_names(value)
    if names:
        fields = {name: _packed(getattr(value, name), files) for name in names}
        return {"class": _class_name(type(value)), "fields": fields}
    if isinstance(value, (tuple, list)):
        return {"list" if isinstance(value, list) else "tuple": [_packed(v, files) for v in value]}
    raise ExportError(f"results must be numbers, texts, arrays, shapes, meshes or records of them, got {type(value)}")


def _field_names(value: Any) -> List[str]:
    if dataclasses.is_dataclass(value):
        return [f.name for f in dataclasses.fields(value)]
    return list(getattr(value, "_fields", ()))


def _unpacked(value: Any, folder: Path, arrays: Any) -> Any:
    if not isinstance(value, dict):
        return value
    (kind, inner), *fields = value.items()
    if kind == "array":
        return arrays[f"arr_{inner}"]
    if kind == "shape":
        shape = Part.Shape()
        shape.importBinary(str(folder / inner))
        return shape
    if kind == "mesh":
        mesh = Mesh.Mesh()
        mesh.read(str(folder / inner))
        return mesh
    if kind == "dict":
        return {_unpacked(k, folder, arrays): _unpacked(v, folder, arrays) for k, v in inner}
    if kind == "class":
        return _class_named(inner)(**{name: _unpacked(v, folder, arrays) for name, v in fields[0][1].items()})
    values = [_unpacked(v, folder, arrays) for v in inner]
    return values if kind == "list" else tuple(values)
