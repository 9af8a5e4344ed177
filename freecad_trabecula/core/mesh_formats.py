# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes as PLY, OBJ and 3MF files; STL is in ``stl``.

FreeCAD's own writers give OBJ six decimals and 3MF six digits: volumes then differ by 1e-5 and near vertices fall
together (measured on 0.20.2 and 1.1.3). These keep double precision (PLY) or the nine digits that single precision
needs, and write as fast.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from pathlib import Path
from typing import Callable, Dict, Iterator, NamedTuple, Sequence, Union
from xml.sax.saxutils import escape

import numpy as np

from ..errors import MeshError, ParameterError
from .meshes import Mesh, printable
from .stl import stl_bytes, whole_file, write_stl

_BLOCK = 100_000  # lines of text formatted at once
_LEVEL = 4  # of 3MF's compression: higher ones take twice as long for 3 % less
_SAMPLES, _SAMPLE = 8, 1000  # stretches of lines, and lines in each, from which a text's size is estimated
PLY_TYPES = {
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1",
    "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
    "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
}  # fmt: skip


# --------------------------------------------------------------------------------------------------------------- PLY


def ply_bytes(mesh: Mesh) -> bytes:
    """Return a mesh as binary PLY: vertices as doubles, triangles as they are numbered; nothing is lost."""
    faces = np.empty(len(mesh.triangles), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, mesh.triangles
    return _ply_header(mesh) + np.ascontiguousarray(mesh.vertices, "<f8").tobytes() + faces.tobytes()


def _ply_header(mesh: Mesh) -> bytes:
    return (
        "ply\nformat binary_little_endian 1.0\ncomment Trabecula, mm\n"
        f"element vertex {len(mesh.vertices)}\nproperty double x\nproperty double y\nproperty double z\n"
        f"element face {len(mesh.triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    ).encode("ascii")


def mesh_from_ply(data: bytes) -> Mesh:
    """Return the mesh in a binary little-endian PLY of triangles: what ``ply_bytes`` and FreeCAD write.

    Raises
    ------
    MeshError
        If it is anything else, or incomplete.
    """
    end = data.find(b"end_header\n")
    if not data.startswith(b"ply") or end < 0:
        raise MeshError("a PLY file must begin with its header")
    header = data[:end].decode("ascii", "replace")
    if "format binary_little_endian" not in header:
        raise MeshError("the PLY file must be binary, little-endian")
    elements = re.findall(r"element (\w+) (\d+)\n((?:property .*\n)*)", header + "\n")
    if [name for name, _, _ in elements] != ["vertex", "face"]:
        raise MeshError(f"the PLY file must hold vertices and faces, got {[name for name, _, _ in elements]}")
    start, columns = end + len(b"end_header\n"), []
    for _, count, properties in elements:
        kind = np.dtype([field for line in properties.splitlines() for field in _ply_fields(line.split())])
        if start + int(count) * kind.itemsize > len(data):
            raise MeshError("the PLY file ends too early")
        columns.append(np.frombuffer(data, kind, int(count), start))
        start += int(count) * kind.itemsize
    vertices, faces = columns
    if len(faces) and (faces["count"] != 3).any():
        raise MeshError("the faces of the PLY file must be triangles")
    points = np.stack([vertices[c].astype(float) for c in "xyz"], 1)
    return Mesh(points, faces["corners"].astype(np.int64).reshape(-1, 3))


def _ply_fields(words: Sequence[str]) -> list:
    if words[1] == "list":
        return [("count", "<" + PLY_TYPES[words[2]]), ("corners", "<" + PLY_TYPES[words[3]], 3)]
    return [(words[2], "<" + PLY_TYPES[words[1]])]


# ------------------------------------------------------------------------------------------------------- OBJ and 3MF


_VERTEX_OBJ, _TRIANGLE_OBJ = "v %.9g %.9g %.9g\n", "f %d %d %d\n"
_VERTEX_3MF, _TRIANGLE_3MF = '<vertex x="%.9g" y="%.9g" z="%.9g"/>\n', '<triangle v1="%d" v2="%d" v3="%d"/>\n'


def _lines(form: str, rows: np.ndarray) -> Iterator[str]:
    """Yield text in which each row (N, 3) fills in the line ``form``, block by block."""
    for start in range(0, len(rows), _BLOCK):
        block = rows[start : start + _BLOCK]
        yield (form * len(block)) % tuple(block.ravel().tolist())


def write_ply(path: Union[str, Path], mesh: Mesh) -> None:
    """Write a mesh as binary PLY, doubles.

    Raises
    ------
    ExportError
        If the file cannot be written; so for all formats: what stood under that name before stays.
    """
    with whole_file(path) as file:
        file.write(ply_bytes(mesh))


def write_obj(path: Union[str, Path], mesh: Mesh) -> None:
    """Write a mesh as Wavefront OBJ; lengths in mm, nine digits (see ``meshes.printable``)."""
    with whole_file(path) as file:
        file.write(b"# Trabecula, mm\n")
        for text in _lines(_VERTEX_OBJ, mesh.vertices):
            file.write(text.encode("ascii"))
        for text in _lines(_TRIANGLE_OBJ, mesh.triangles + 1):
            file.write(text.encode("ascii"))


def write_3mf(path: Union[str, Path], mesh: Mesh) -> None:
    """Write a mesh as 3MF (core specification 1.3), unit mm, nine digits (see ``meshes.printable``)."""
    name = Path(path).stem
    with whole_file(path) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=_LEVEL) as package:
        package.writestr(_entry("[Content_Types].xml"), _CONTENT_TYPES)
        package.writestr(_entry("_rels/.rels"), _RELATIONS)
        with package.open(_entry("3D/3dmodel.model"), "w", force_zip64=True) as model:
            model.write(_MODEL_HEAD.replace("NAME", escape(name, {'"': "&quot;"})).encode("utf-8"))
            for text in _lines(_VERTEX_3MF, mesh.vertices):
                model.write(text.encode("ascii"))
            model.write(b"</vertices>\n<triangles>\n")
            for text in _lines(_TRIANGLE_3MF, mesh.triangles):
                model.write(text.encode("ascii"))
            model.write(_MODEL_TAIL.encode("ascii"))


def _entry(name: str) -> zipfile.ZipInfo:
    """An entry without the time of day: equal meshes make equal files."""
    entry = zipfile.ZipInfo(name)
    entry.compress_type = zipfile.ZIP_DEFLATED
    return entry


def _obj_size(mesh: Mesh) -> int:
    return _text_size(_VERTEX_OBJ, mesh.vertices) + _text_size(_TRIANGLE_OBJ, mesh.triangles + 1)


def _3mf_size(mesh: Mesh) -> int:
    size = _text_size(_VERTEX_3MF, mesh.vertices, packed=True) + _text_size(_TRIANGLE_3MF, mesh.triangles, packed=True)
    return size + len(_CONTENT_TYPES) + len(_RELATIONS)


class MeshFormat(NamedTuple):
    """How a mesh is written in a format.

    Attributes
    ----------
    write : callable
        ``(path, mesh)``.
    size : callable
        ``(mesh) -> bytes``, about, without writing it.
    """

    write: Callable[[Union[str, Path], Mesh], None]
    size: Callable[[Mesh], int]


#: By the files' ending. A new format is a line here; the shell takes it when ``shell/arguments.py`` names it too.
FORMATS: Dict[str, MeshFormat] = {
    "stl": MeshFormat(lambda path, mesh: write_stl(path, printable(mesh)), lambda mesh: stl_bytes(len(mesh.triangles))),
    "ply": MeshFormat(
        write_ply, lambda mesh: len(_ply_header(mesh)) + 24 * len(mesh.vertices) + 13 * len(mesh.triangles)
    ),
    "obj": MeshFormat(lambda path, mesh: write_obj(path, printable(mesh)), _obj_size),
    "3mf": MeshFormat(lambda path, mesh: write_3mf(path, printable(mesh)), _3mf_size),
}


def estimated_size(kind: str, mesh: Mesh) -> int:
    """Return about how many bytes a mesh takes in one of ``FORMATS``: STL and PLY exactly, texts by a sample.

    Raises
    ------
    ParameterError
        If ``kind`` is something else.
    """
    if kind not in FORMATS:
        raise ParameterError(f"a mesh format must be one of {', '.join(FORMATS)}, got {kind!r}")
    return FORMATS[kind].size(mesh)


def _text_size(form: str, rows: np.ndarray, packed: bool = False) -> int:
    """Bytes of the lines of all rows, judged by stretches of neighbours: what compression gains comes from these."""
    if not len(rows):
        return 0
    starts = np.unique(np.linspace(0, max(len(rows) - _SAMPLE, 0), _SAMPLES).astype(int))
    size = lines = 0
    for start in starts:
        block = rows[start : start + _SAMPLE]
        text = "".join(_lines(form, block)).encode("ascii")
        size += len(zlib.compress(text, _LEVEL)) if packed else len(text)
        lines += len(block)
    return round(size / lines * len(rows))


_CONTENT_TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
_RELATIONS = """<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
_MODEL_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Trabecula</metadata>
<resources>
<object id="1" name="NAME" type="model">
<mesh>
<vertices>
"""
_MODEL_TAIL = """</triangles>
</mesh>
</object>
</resources>
<build>
<item objectid="1"/>
</build>
</model>
"""
