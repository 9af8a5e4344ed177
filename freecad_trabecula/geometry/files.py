# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes, shapes and documents as files, whole or not at all.

FreeCAD returns without a word when it wrote half a document because the disk was full (measured on 0.20.2 and 1.1.3).
Every file is therefore written under another name, looked at, and then takes its own.
"""

from __future__ import annotations

import os
import re
import tempfile
import zipfile
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Callable, Dict, Iterator, Sequence, Union

import FreeCAD
import Part

from ..core import mesh_formats
from ..core.meshes import Mesh
from ..errors import ExportError, ParameterError

PathLike = Union[str, Path]

_SHAPE_WRITERS: Dict[str, str] = {
    ".step": "exportStep",
    ".stp": "exportStep",
    ".brep": "exportBrep",
    ".brp": "exportBrep",
    ".iges": "exportIges",
    ".igs": "exportIges",
}
#: How a whole file of the kernel ends: STEP with its last line, BREP with the shape's number and place after a star,
#: IGES with the terminate section's only line.
_ENDS = {
    "exportStep": re.compile(rb"END-ISO-10303-21;\s*$"),
    "exportBrep": re.compile(rb"\*\s+[+-]\d+ \d+\s*$"),
    "exportIges": re.compile(rb"T[0 ]*1\s*$"),
}
MESH_FORMATS = tuple(mesh_formats.FORMATS)
SHAPE_FORMATS = tuple(kind[1:] for kind in _SHAPE_WRITERS)
_SAMPLE = 6  # solids written to estimate the size of all


def write_mesh(path: PathLike, mesh: Mesh) -> None:
    """Write a mesh as binary STL, PLY, OBJ or 3MF, by the name's extension; unit mm.

    Vertices that single precision would merge are nudged apart, so that a closed mesh stays closed in the file.

    Raises
    ------
    ParameterError
        If the extension is none of ``MESH_FORMATS``.
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    _writer(path, {f".{kind}": one.write for kind, one in mesh_formats.FORMATS.items()})(path, mesh)


def write_shape(path: PathLike, shape: Part.Shape) -> None:
    """Write a shape as STEP, BREP or IGES, by the name's extension.

    Raises
    ------
    ParameterError
        If the extension is none of ``SHAPE_FORMATS``, or the shape is empty.
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    method = _writer(path, _SHAPE_WRITERS)
    if shape.isNull() or not shape.Faces:
        raise ParameterError(f"a shape must have faces to be written into {Path(path).name}, got none")
    with replacing(path) as part:
        getattr(shape, method)(part)
        with open(part, "rb") as file:
            file.seek(max(os.path.getsize(part) - 200, 0))
            if not _ENDS[method].search(file.read()):
                raise ExportError(f"{path} could not be written whole: is the disk full?")


def write_document(path: PathLike, document: FreeCAD.Document) -> None:
    """Write a document as FCStd; the open document keeps its own name.

    Raises
    ------
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    with replacing(path) as part:
        document.saveCopy(part)
        try:
            with zipfile.ZipFile(part) as archive:
                whole = "Document.xml" in archive.namelist()
        except (zipfile.BadZipFile, FileNotFoundError):
            whole = False
        if not whole:
            raise ExportError(f"{path} could not be written whole: is the disk full?")


def _writer(path: PathLike, writers: Dict) -> Callable:
    kind = Path(path).suffix.lower()
    if kind not in writers:
        raise ParameterError(f"the file's extension must be one of {', '.join(writers)}, got {Path(path).name!r}")
    return writers[kind]


@contextmanager
def replacing(path: PathLike) -> Iterator[str]:
    """Give the name of a new file in the same folder; it takes the name ``path`` when the ``with`` block has gone well.

    For writers that want a name; ``stl.whole_file`` is for those that take an open file.

    Raises
    ------
    ExportError
        If writing fails, or leaves no file; nothing half written is left.
    """
    path = Path(path)
    part = path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}")  # the extension tells FreeCAD the format
    try:
        if not path.parent.is_dir():  # FreeCAD would make it
            raise NotADirectoryError(0, f"{path.parent} is no folder")
        yield str(part)
        os.replace(part, path)
    except ExportError:
        raise
    except (OSError, FreeCAD.Base.FreeCADError) as error:
        why = getattr(error, "strerror", None) or str(error)
        raise ExportError(f"{path} could not be written: {why}") from error
    finally:
        with suppress(OSError):  # renamed, or never made
            part.unlink()


# ---------------------------------------------------------------------------------------------------- sizes beforehand


def estimate_mesh_size(kind: str, mesh: Mesh) -> int:
    """Return about how many bytes a mesh takes in a file, within 20 % (STL and PLY: exactly), before it is written.

    Parameters
    ----------
    kind : str
        One of ``MESH_FORMATS``.
    mesh : Mesh
    """
    return mesh_formats.estimated_size(kind, mesh)


def estimate_shape_size(kind: str, solids: Sequence[Part.Shape]) -> int:
    """Return about how many bytes solids take together in a STEP, BREP or IGES file; a few are written to find out.

    Parameters
    ----------
    kind : str
        One of ``SHAPE_FORMATS``.
    solids : sequence of Part.Shape
        Bodies of like complexity, as rods are.

    Raises
    ------
    ExportError
        If the sample cannot be written.
    """
    if not solids:
        return 0
    step = max(len(solids) // _SAMPLE, 1)
    sample = list(solids)[::step][:_SAMPLE]
    sizes = []
    with tempfile.TemporaryDirectory(prefix="trabecula-") as folder:
        path = Path(folder) / f"sample.{kind}"
        for some in (sample[:1], sample):
            write_shape(path, Part.makeCompound(some))
            sizes.append(path.stat().st_size)
    if len(sample) == 1:
        return sizes[0] * len(solids)
    each = (sizes[1] - sizes[0]) / (len(sample) - 1)
    return round(sizes[1] + each * (len(solids) - len(sample)))
