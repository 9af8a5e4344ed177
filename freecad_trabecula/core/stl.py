# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL files: binary and ASCII in, binary out, whole or not at all."""

from __future__ import annotations

import os
import re
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO, Iterator, Union

import numpy as np

from ..errors import ExportError, MeshError
from .meshes import Mesh, weld

_HEADER = 80  # bytes before the count; must not begin with "solid", by which readers know the ASCII kind
_RECORD = np.dtype([("normal", "<f4", (3,)), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_BLOCK = 100_000  # triangles written at once: 5 MB
_READ = 1 << 15  # triangles read at once: they stay in the processor's cache
_NUMBERS = re.compile(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)")


def stl_bytes(triangle_count: int) -> int:
    """Return the size in bytes of a binary STL file with so many triangles."""
    return _HEADER + 4 + _RECORD.itemsize * triangle_count


def read_stl(path: Union[str, Path]) -> Mesh:
    """Return the mesh of an STL file; exactly equal corners become one vertex.

    Raises
    ------
    MeshError
        If the file is no STL, is cut off, is empty, or holds numbers that are not finite.
    ExportError
        If the file cannot be read.
    """
    return weld(read_triangles(path))


def read_triangles(path: Union[str, Path]) -> np.ndarray:
    """Return the triangles of an STL file, ndarray of shape (T, 3, 3), float32, mm, as they stand in it.

    Raises
    ------
    MeshError, ExportError
        As ``read_stl``.
    """
    path = Path(path)
    try:
        size = path.stat().st_size
        with path.open("rb") as file:
            head = file.read(_HEADER + 4)
            count = int.from_bytes(head[_HEADER:], "little")
            if size >= _HEADER + 4 and size == stl_bytes(count):  # also where the header says "solid"
                triangles = _records(file, count, path)
            elif _is_text(head):
                triangles = _parsed(head + file.read(), path)
            else:
                raise MeshError(_size_rule(path, size, count))
    except OSError as error:
        raise ExportError(f"{path} could not be read: {error.strerror or error}") from error
    return _checked(triangles, path)


def _records(file: BinaryIO, count: int, path: Path) -> np.ndarray:
    """Corners of the records that follow, laid out co-ordinate by co-ordinate; never more than a block in memory."""
    by_coordinate = np.empty((3, 3, count), np.float32)
    for start in range(0, count, _READ):
        part = np.fromfile(file, _RECORD, min(_READ, count - start))["corners"]
        if len(part) < min(_READ, count - start):
            raise MeshError(f"{path}: the file became shorter while it was read, at triangle {start + len(part)}")
        by_coordinate[:, :, start : start + len(part)] = part.T
    return by_coordinate.transpose(2, 1, 0)


def _is_text(head: bytes) -> bool:
    return head.lstrip()[:5].lower() == b"solid" and not any(byte > 126 or byte < 9 for byte in head)


def _size_rule(path: Path, size: int, count: int) -> str:
    if size < _HEADER + 4:
        return f"{path}: a binary STL file has at least {_HEADER + 4} bytes, got {size}"
    whole, rest = divmod(size - _HEADER - 4, _RECORD.itemsize)
    return (
        f"{path}: the size of a binary STL file must be 84 + 50 bytes for each triangle; "
        f"its header says {count} triangles, {size} bytes hold {whole} and {rest} bytes more"
    )


def _parsed(text: bytes, path: Path) -> np.ndarray:
    """Corners in an ASCII file, whatever its line ends, indents and capitals; all solids in it together."""
    text = text.lower()
    if b"endsolid" not in text[-1000:]:
        raise MeshError(f"{path}: an ASCII STL file must end with 'endsolid'; this one is cut off")
    numbers, facets = _NUMBERS.findall(text), text.count(b"endfacet")
    if len(numbers) != 3 * facets:
        raise MeshError(f"{path}: each facet must have three vertices, got {len(numbers)} vertices in {facets} facets")
    try:
        return np.array(numbers, dtype="S32").astype(np.float64).astype(np.float32).reshape(-1, 3, 3)
    except ValueError as error:
        raise MeshError(f"{path}: co-ordinates must be numbers: {error}") from error


def _checked(triangles: np.ndarray, path: Path) -> np.ndarray:
    if not len(triangles):
        raise MeshError(f"{path}: an STL file must hold at least one triangle, got 0")
    if not np.isfinite([triangles.min(), triangles.max()]).all():  # nan goes through both
        bad = int(np.argmin(np.isfinite(triangles).all((1, 2))))
        raise MeshError(
            f"{path}: co-ordinates must be finite; triangle {bad + 1} of {len(triangles)} has {triangles[bad].ravel()}"
        )
    return triangles


def write_stl(path: Union[str, Path], mesh: Mesh) -> None:
    """Write a binary STL file.

    Vertices are rounded to single precision; pass ``meshes.printable(mesh)`` so that none fall together.

    Raises
    ------
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    with whole_file(path) as file:
        file.write(b"Trabecula".ljust(_HEADER) + np.uint32(len(mesh.triangles)).astype("<u4").tobytes())
        for start in range(0, len(mesh.triangles), _BLOCK):
            corners = mesh.vertices[mesh.triangles[start : start + _BLOCK]]
            normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            length = np.sqrt((normals**2).sum(1, keepdims=True))
            records = np.zeros(len(corners), _RECORD)
            records["normal"] = normals / np.where(length > 0, length, 1.0)
            records["corners"] = corners
            file.write(records.tobytes())


@contextmanager
def whole_file(path: Union[str, Path]) -> Iterator[BinaryIO]:
    """Open a file for writing that gets its name only when all is written: for ``with``; yields a binary file.

    Raises
    ------
    ExportError
        If anything fails on the way: a full disk, a folder that is read-only or missing. Nothing half written is left.
    """
    path = Path(path)
    part = path.with_name(f".{path.name}.{os.getpid()}.part")  # same folder: os.replace works only within a file system
    try:
        with part.open("w+b") as file:  # writers of TIFF read what they wrote
            yield file
        os.replace(part, path)
    except OSError as error:
        raise ExportError(f"{path} could not be written: {error.strerror or error}") from error
    finally:
        with suppress(OSError):  # renamed, or never made
            part.unlink()
