# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a design: what there is to write and how large it will be; written, and read again."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any, Callable, List, Mapping, NamedTuple, Sequence, Tuple

from ..core.bodies import Bodies, Check
from ..core.meshes import Mesh, edge_faults, mesh_volume
from ..core.progress import Progress
from ..core.report_text import size_words
from ..core.stl import read_stl
from ..errors import ExportError
from ..geometry.files import estimate_mesh_size, estimate_shape_size, write_document, write_mesh, write_shape
from .folder import ResultFolder

_STL_TOLERANCE = 1e-6  # of the envelope: what single precision may change


class Product(NamedTuple):
    """A file to be written: its name, what writes it to a path, about how many bytes it takes (0 if unknown)."""

    name: str
    write: Callable[[Path], None]
    size: int


def products(meshes: Mapping[str, Mesh], objects: Any, also: Sequence[str]) -> List[Product]:
    """Return the files of a design.

    Parameters
    ----------
    meshes : dict of Mesh
        Bodies by name.
    objects : make.Design
    also : sequence of str
        Further formats: those of meshes, and ``brep`` for the network.
    """
    network, solid = objects.network.Shape, objects.solid_scaffold
    found = [
        Product(f"{name}.{kind}", lambda path, m=mesh: write_mesh(path, m), estimate_mesh_size(kind, mesh))
        for kind in dict.fromkeys(("stl", *also))
        if kind != "brep"
        for name, mesh in meshes.items()
    ]
    for kind in ("step", *(kind for kind in ("brep",) if kind in also)):
        size = estimate_shape_size(kind, network.Solids)
        found.append(Product(f"network.{kind}", lambda path: write_shape(path, network), size))
    if solid:
        found.append(Product("scaffold.step", lambda path: write_shape(path, solid.Shape), 0))
    document = objects.wireframe.Document
    return [*found, Product("design.FCStd", lambda path: write_document(path, document), 0)]


def check_room(folder: Path, wanted: Sequence[Product]) -> None:
    """Refuse to begin if the disk has not the room that the files take.

    Raises
    ------
    ExportError
        With both sizes.
    """
    size, free = sum(product.size for product in wanted), shutil.disk_usage(folder).free
    if size > free:
        raise ExportError(
            f"the files need about {size_words(size)}, but the disk of {folder} has {size_words(free)} free"
        )


def write_products(wanted: Sequence[Product], folder: ResultFolder, progress: Progress) -> List[str]:
    """Write the files, and return their names.

    Raises
    ------
    ExportError
        If one cannot be written.
    """
    check_room(folder.aside, wanted)
    for done, product in enumerate(wanted):
        size = f", about {size_words(product.size)}" if product.size else ""
        progress(done, len(wanted), f"writing {product.name}{size}")
        product.write(folder.path(product.name))
    return [product.name for product in wanted]


def stl_checks(path: Path, mesh: Mesh, bodies: Bodies) -> Tuple[Check, ...]:
    """Return whether the STL file of a mesh, read again, is closed and has its volume."""
    found = read_stl(path)
    faults, volume, again = sum(edge_faults(found)), mesh_volume(mesh), mesh_volume(found)
    return (
        Check(f"faulty edges and triangles in {path.name}, read again", faults, 0, faults, 0),
        Check(
            f"volume of {path.name}, read again, mm3", volume, again, abs(volume - again) / bodies.body_volume,
            _STL_TOLERANCE,
        ),
    )  # fmt: skip
