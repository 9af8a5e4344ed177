# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles from OBJ, PLY and 3MF files of any program; STL is in ``stl``. Nothing of a file is taken unless all is."""

from __future__ import annotations

import io
import re
import zipfile
import zlib
from pathlib import Path
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple, Union
from xml.etree import ElementTree

import numpy as np

from ..errors import ExportError, MeshError
from .mesh_formats import PLY_TYPES
from .stl import read_triangles

Triangles = Tuple[np.ndarray, str]

#: Units of 3MF (core specification 1.3, 3.4) by ours.
_UNITS_3MF = {"micron": "um", "millimeter": "mm", "centimeter": "cm", "inch": "inch", "foot": "foot", "meter": "m"}
_LARGEST_MODEL = 4 << 30  # bytes of a 3MF model unpacked: 10^7 triangles; more is no model but a trap
_DEEPEST = 16  # components of components


def read_mesh(path: Union[str, Path]) -> Triangles:
    """Return the triangles of an STL, OBJ, PLY or 3MF file, and its unit if it has one (3MF), else "".

    Polygons are cut into triangles from their first corner.

    Returns
    -------
    triangles : ndarray of shape (T, 3, 3), float32
        In the file's unit; equal vertices are rounded alike.
    unit : str

    Raises
    ------
    MeshError
        If the file is none of these, is cut off or empty, or names vertices that it does not have.
    ExportError
        If it cannot be read.
    """
    path = Path(path)
    kind = path.suffix.lower()
    if kind == ".stl":
        return read_triangles(path), ""
    if kind not in _READERS:
        raise MeshError(f"{path}: a mesh file must end in .stl, .obj, .ply or .3mf, got {kind or 'nothing'!r}")
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ExportError(f"{path} could not be read: {error.strerror or error}") from error
    try:
        points, corners, unit = _READERS[kind](data)
    except MeshError as error:
        raise MeshError(f"{path}: {error}") from error
    except (ValueError, KeyError, IndexError, OverflowError) as error:
        raise MeshError(f"{path} is no proper {kind[1:].upper()} file: {error}") from error
    if not len(corners):
        raise MeshError(f"{path} must hold at least one triangle, got 0")
    if corners.min() < 0 or corners.max() >= len(points):
        named = f"{corners.min()}..{corners.max()}"
        raise MeshError(f"{path}: triangles must name vertices 0..{len(points) - 1}, got {named}")
    with np.errstate(over="ignore"):
        triangles = np.asarray(points, np.float64).astype(np.float32)[corners]
    if not np.isfinite([triangles.min(), triangles.max()]).all():
        raise MeshError(f"{path}: co-ordinates must be finite")
    return triangles, unit


class _Read(NamedTuple):
    points: np.ndarray
    corners: np.ndarray
    unit: str


def _fans(sizes: np.ndarray, names: np.ndarray) -> np.ndarray:
    """Triangles (T, 3) of polygons: their numbers of corners, and all corners one after another."""
    if (sizes < 3).any():
        raise MeshError(f"each face must have at least three corners, got {int(sizes.min())}")
    first = np.cumsum(sizes) - sizes
    of = np.repeat(np.arange(len(sizes)), sizes - 2)
    step = np.arange(len(of)) - np.repeat(np.cumsum(sizes - 2) - sizes + 2, sizes - 2)
    return np.stack([names[first[of]], names[first[of] + step + 1], names[first[of] + step + 2]], 1)


# --------------------------------------------------------------------------------------------------------------- OBJ


def _obj(data: bytes) -> _Read:
    text = data.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ")  # lines that go on
    rows = [line.split()[1:4] for line in re.findall(rb"^[ \t]*v[ \t][^\r\n]*", text, re.MULTILINE)]
    if any(len(row) != 3 for row in rows):
        raise MeshError("each vertex must have three co-ordinates")
    points = np.array(rows, dtype="S32").astype(np.float64).reshape(-1, 3)
    faces, sizes = [], []
    if re.search(rb"^[ \t]*f[ \t][^\r\n]*-\d", text, re.MULTILINE):  # counted backwards from where they stand
        seen = 0
        for kind, line in re.findall(rb"^[ \t]*([vf])[ \t]([^\r\n]*)", text, re.MULTILINE):
            seen += kind == b"v"
            if kind == b"f":
                numbers = [int(word.split(b"/")[0]) for word in line.split(b"#")[0].split()]
                faces += [n - 1 if n > 0 else seen + n for n in numbers]
                sizes.append(len(numbers))
    else:
        for line in re.findall(rb"^[ \t]*f[ \t]([^\r\n]*)", text, re.MULTILINE):
            words = line.split(b"#")[0].split()
            faces += [int(word.split(b"/")[0]) - 1 for word in words]
            sizes.append(len(words))
    return _Read(points, _fans(np.array(sizes, np.int64), np.array(faces, np.int64)), "")


# --------------------------------------------------------------------------------------------------------------- PLY


class _Element(NamedTuple):
    name: str
    rows: int
    properties: List[List[str]]


def _ply(data: bytes) -> _Read:
    end = re.search(rb"end_header[ \t]*\r?\n", data)
    if not data.startswith(b"ply") or not end:
        raise MeshError("a PLY file must begin with its header")
    lines = [line.split() for line in data[: end.start()].decode("ascii", "replace").splitlines()]
    elements: List[_Element] = []
    kind = ""
    for words in lines:
        if words[:1] == ["format"]:
            kind = words[1]
        elif words[:1] == ["element"]:
            elements.append(_Element(words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1].properties.append(words[1:])
    if kind == "ascii":
        return _ply_read(elements, _AsciiPly(data[end.end() :]))
    if kind not in ("binary_little_endian", "binary_big_endian"):
        raise MeshError(f"the format of a PLY file must be ascii or binary, got {kind!r}")
    return _ply_read(elements, _BinaryPly(data, end.end(), "<" if "little" in kind else ">"))


def _ply_read(elements: List[_Element], source: Any) -> _Read:
    points, corners = np.zeros((0, 3)), np.zeros((0, 3), np.int64)
    for element in elements:
        has_list = any(words[0] == "list" for words in element.properties)
        if element.name == "vertex" and not has_list:
            names = [words[1] for words in element.properties]
            table = source.table(element)
            points = np.stack([table[names.index(axis)] for axis in "xyz"], 1)
        elif element.name == "face":
            column = [words[-1] for words in element.properties].index(
                "vertex_indices" if ["vertex_indices"] in [w[-1:] for w in element.properties] else "vertex_index"
            )
            corners = _fans(*source.lists(element, column))
        else:
            source.lists(element, None) if has_list else source.table(element)
    return _Read(points, corners, "")


class _AsciiPly:
    """Numbers of a text, one after another."""

    def __init__(self, text: bytes) -> None:
        self.numbers = np.array(text.split(), dtype="S32").astype(np.float64)
        self.at = 0

    def _taken(self, count: int) -> np.ndarray:
        part = self.numbers[self.at : self.at + count]
        if len(part) < count:
            raise MeshError("the PLY file ends too early")
        self.at += count
        return part

    def table(self, element: _Element) -> np.ndarray:
        width = len(element.properties)
        return self._taken(element.rows * width).reshape(element.rows, width).T

    def lists(self, element: _Element, column: Optional[int]) -> Tuple[np.ndarray, np.ndarray]:
        sizes, names = [], [np.zeros(0)]
        for _ in range(element.rows):
            for k, words in enumerate(element.properties):
                part = self._taken(int(self._taken(1)[0]) if words[0] == "list" else 1)
                if k == column:
                    sizes.append(len(part))
                    names.append(part)
        return np.array(sizes, np.int64), np.concatenate(names).astype(np.int64)


class _BinaryPly:
    """Records of a binary file; lists of one length are read at once, others one by one."""

    def __init__(self, data: bytes, at: int, order: str) -> None:
        self.data, self.at, self.order = data, at, order

    def _taken(self, kind: np.dtype, count: int) -> np.ndarray:
        if self.at + kind.itemsize * count > len(self.data):
            raise MeshError("the PLY file ends too early")
        part = np.frombuffer(self.data, kind, count, self.at)
        self.at += kind.itemsize * count
        return part

    def _type(self, name: str) -> np.dtype:
        return np.dtype(self.order + PLY_TYPES[name])

    def table(self, element: _Element) -> List[np.ndarray]:
        kind = np.dtype([(f"p{k}", self._type(words[0])) for k, words in enumerate(element.properties)])
        records = self._taken(kind, element.rows)
        return [records[name].astype(float) for name in kind.names or ()]

    def lists(self, element: _Element, column: Optional[int]) -> Tuple[np.ndarray, np.ndarray]:
        start = self.at
        sizes = [len(part) for part in self._row(element)] if element.rows else []
        fields = []
        for k, (words, size) in enumerate(zip(element.properties, sizes)):
            if words[0] == "list":
                fields += [(f"n{k}", self._type(words[1])), (f"p{k}", self._type(words[2]), (size,))]
            else:
                fields.append((f"p{k}", self._type(words[0])))
        kind, self.at = np.dtype(fields), start
        if start + kind.itemsize * element.rows <= len(self.data):
            records = self._taken(kind, element.rows)
            if all((records[f"n{k}"] == size).all() for k, size in enumerate(sizes) if f"n{k}" in (kind.names or ())):
                part = records[f"p{column}"].astype(np.int64) if column is not None and sizes else np.zeros((0, 1), int)
                return np.full(len(part), part.shape[1]), part.ravel()
            self.at = start
        rows = [self._row(element) for _ in range(element.rows)]
        chosen = [row[column] for row in rows] if column is not None else []
        counts = np.array([len(part) for part in chosen], np.int64)
        return counts, np.concatenate([np.zeros(0, int), *chosen]).astype(np.int64)

    def _row(self, element: _Element) -> List[np.ndarray]:
        row = []
        for words in element.properties:
            count = int(self._taken(self._type(words[1]), 1)[0]) if words[0] == "list" else 1
            row.append(self._taken(self._type(words[2] if words[0] == "list" else words[0]), count))
        return row


# --------------------------------------------------------------------------------------------------------------- 3MF


def model_of_3mf(data: bytes) -> bytes:
    """Return the XML of the model in a 3MF file.

    Raises
    ------
    MeshError
        If there is none, or the file is cut off.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as package:
            return package.read(_model_entry(package))
    except (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, NotImplementedError) as error:
        raise MeshError(f"a 3MF file must be a whole ZIP archive: {error}") from error


def _3mf(data: bytes) -> _Read:
    try:
        root = ElementTree.fromstring(model_of_3mf(data))
    except ElementTree.ParseError as error:
        raise MeshError(f"the model of a 3MF file must be proper XML: {error}") from error
    unit = root.get("unit", "millimeter")
    if unit not in _UNITS_3MF:
        raise MeshError(f"the unit of a 3MF file must be one of {', '.join(_UNITS_3MF)}, got {unit!r}")
    objects = {item.get("id"): item for item in root.iter() if _tag(item) == "object"}
    points: List[np.ndarray] = []
    corners: List[np.ndarray] = []
    for item in root.iter():
        if _tag(item) == "item":
            _place(objects, item, np.eye(4), points, corners, 0)
    if not points:
        raise MeshError("the model of a 3MF file must have an item to build")
    return _Read(np.concatenate(points), np.concatenate(corners), _UNITS_3MF[unit])


def _model_entry(package: zipfile.ZipFile) -> str:
    name = "3D/3dmodel.model"
    if "_rels/.rels" in package.namelist():
        for relation in ElementTree.fromstring(package.read("_rels/.rels")).iter():
            if relation.get("Type", "").endswith("/3dmodel"):
                name = relation.get("Target", name).lstrip("/")
    if name not in package.namelist():
        raise MeshError(f"a 3MF file must hold {name}")
    if package.getinfo(name).file_size > _LARGEST_MODEL:
        raise MeshError(f"the model of a 3MF file may have at most {_LARGEST_MODEL} bytes")
    return name


def _tag(element: ElementTree.Element) -> str:
    return element.tag.rsplit("}", 1)[-1]


def _place(objects: Dict[Optional[str], ElementTree.Element], item: ElementTree.Element, matrix: np.ndarray,
           points: List[np.ndarray], corners: List[np.ndarray], depth: int) -> None:  # fmt: skip
    """Add what an item or a component shows: the mesh of its object, or that one's components, moved."""
    if item.get("objectid") not in objects or depth > _DEEPEST:
        raise MeshError(f"items must show objects of the model, at most {_DEEPEST} deep, got {item.get('objectid')!r}")
    if "transform" in item.attrib:
        own = np.eye(4)
        own[:, :3] = np.array(item.get("transform", "").split(), float).reshape(4, 3)
        matrix = own @ matrix
    for child in objects[item.get("objectid")].iter():
        if _tag(child) == "component":
            _place(objects, child, matrix, points, corners, depth + 1)
        elif _tag(child) == "mesh":
            vertices = [[v.get(axis) for axis in "xyz"] for v in child.iter() if _tag(v) == "vertex"]
            triangles = [[t.get(key) for key in ("v1", "v2", "v3")] for t in child.iter() if _tag(t) == "triangle"]
            own_points, own_corners = np.array(vertices, float).reshape(-1, 3), np.array(triangles, int).reshape(-1, 3)
            if len(own_corners) and not 0 <= own_corners.min() <= own_corners.max() < len(own_points):
                raise MeshError(f"triangles must name vertices 0..{len(own_points) - 1} of their object")
            corners.append(own_corners + sum(len(p) for p in points))
            points.append(own_points @ matrix[:3, :3] + matrix[3, :3])


_READERS: Dict[str, Callable[[bytes], _Read]] = {".obj": _obj, ".ply": _ply, ".3mf": _3mf}
