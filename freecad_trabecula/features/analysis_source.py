# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an analysis slices: an object of the document or a file, as triangles, here or in another process."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, NamedTuple, Sequence

import Mesh
import numpy as np
import Part

from ..core.analysis.triangles import UNITS, Soup, guessed_unit, read_soup
from ..core.estimates import Body, Work, body_of, triangles_of_solid
from ..core.file_bodies import body_of_file, reading_work
from ..core.parameters import RodParameters
from ..core.progress import Progress, silent
from ..core.records import from_record, to_record
from ..core.wireframe import without
from ..errors import ExportError, ParameterError
from ..geometry.fingerprints import fingerprint
from ..geometry.sections import mesh_soup, rods_soup, shape_soup
from . import results
from .feature import is_a
from .network import Network
from .packing import read_value, write_value
from .wireframe import Wireframe, recall

_BENT_ONE_WAY = (Part.Plane, Part.Cylinder, Part.Cone)  # these get few triangles
_SOME_RODS = 30  # whose triangles are counted for all
_RECORD, _MESH, _SHAPE, _RODS = "{}.json", "{}.bms", "{}.bin", "{}-rods"


class Source(NamedTuple):
    """A body to be sliced.

    Attributes
    ----------
    kind : str
        ``mesh``, ``shape``, ``rods`` or ``file``.
    name : str
        Label of the object, name of the file.
    key : str
        Changes when the body does; quick to tell.
    body : object
        FreeCAD mesh, shape, ``Wireframe`` object or path.
    """

    kind: str
    name: str
    key: str
    body: Any


def object_source(obj: Any) -> Source:
    """Return a document object as a body to be sliced; of a network its rods, as they are shown.

    Raises
    ------
    ParameterError
        If it has neither a mesh nor a solid.
    """
    own = getattr(obj, "ResultKey", "") if is_a(obj) else ""
    if is_a(obj, Wireframe, Network) and obj.Placement.isIdentity():
        wireframe = obj if is_a(obj, Wireframe) else obj.Wireframe
        if own and wireframe is not None and wireframe.ResultKey == own:
            return Source("rods", obj.Label, results.key_of("rods", own), wireframe)
    mesh = getattr(obj, "Mesh", None)
    if mesh is not None:
        if not mesh.CountFacets:
            raise ParameterError(f"what is sliced must have triangles, got none in {obj.Label}")
        return Source("mesh", obj.Label, results.key_of("mesh", own, _mesh_mark(mesh)), mesh)
    shape = getattr(obj, "Shape", None)
    if shape is None or not shape.Solids:
        raise ParameterError(f"what is sliced must be a mesh or have a solid, got {obj.Label} without")
    return Source("shape", obj.Label, results.key_of("shape", own or fingerprint(shape), str(shape.Placement)), shape)


def _mesh_mark(mesh: Mesh.Mesh) -> list:
    box = mesh.BoundBox
    sizes = [box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax, mesh.Volume, mesh.Area]
    return [mesh.CountPoints, mesh.CountFacets, *(float(f"{size:.7g}") for size in sizes)]


def file_source(path: str) -> Source:
    """Return a file as a body to be sliced.

    Raises
    ------
    ExportError
        If it is not there.
    """
    try:
        facts = Path(path).stat()
    except OSError as error:
        raise ExportError(f"the file {path} could not be read: {error.strerror or error}") from error
    return Source("file", Path(path).name, results.key_of("file", str(path), facts.st_size, facts.st_mtime_ns), path)


def soup_of_source(source: Source, unit: str, deflection: float, progress: Progress = silent) -> Soup:
    """Return the triangles of a source.

    Parameters
    ----------
    source : Source
    unit : str
        Of a file: ``auto``, ``mm``, ``m`` ...
    deflection : float, mm
        Distance of the triangles from a solid; 0 chooses it.
    progress : callable

    Raises
    ------
    TrabeculaError
        If there are none, or they cannot be read.
    """
    progress(0, 1, "triangles")
    if source.kind == "file":
        return read_soup(source.body, unit)
    if source.kind == "mesh":
        return mesh_soup(source.body, source.name)
    if source.kind == "rods":
        value, parameters = _rods(source.body)
        return rods_soup(value.wireframe, parameters, source.name)
    return shape_soup(source.body, deflection, source.name, progress)


def _rods(wireframe: Any) -> Any:
    recall(wireframe)
    value = results.find(Wireframe.KIND, wireframe.ResultKey)
    if value is None:
        value = results.keep(Wireframe.KIND, wireframe.ResultKey, wireframe.Proxy.make(wireframe, silent))
    return value, wireframe.Proxy.parameters(wireframe).rods


def body_of_source(source: Source, unit: str = "auto") -> Body:
    """Return what can be known of a source without slicing it; quick. ``unit`` is that of a file.

    Raises
    ------
    ExportError
        If a file cannot be read.
    """
    if source.kind == "file":
        try:
            body = body_of_file(source.body)
            return body.scaled(UNITS[guessed_unit(body.size)[0] if unit == "auto" else unit])
        except OSError as error:
            raise ExportError(f"the file {source.body} could not be read: {error.strerror or error}") from error
    box = (source.body.Shape if source.kind == "rods" else source.body).BoundBox
    corners = np.array([[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]])
    if source.kind == "mesh":
        return Body(source.body.CountFacets, corners, source.body.Volume, source.body.Area)
    if source.kind == "shape":
        return _body_of_solids(source.body.Solids)._replace(box=corners)
    value, parameters = _rods(source.body)
    rods = len(value.wireframe)
    some = np.unique(np.linspace(0, rods - 1, min(rods, _SOME_RODS)).astype(int))
    soup = rods_soup(without(value.wireframe, some), parameters, source.name)
    return body_of(soup.triangles, len(soup.triangles) * rods // len(some))._replace(box=corners)


def reading_of_source(source: Source, body: Body) -> Work:
    """Return what the reading of a source of which that is known takes: of a file; all else is there.

    Raises
    ------
    ExportError
        If a file cannot be read.
    """
    if source.kind != "file":
        return Work(0.0)
    try:
        return reading_work(source.body, body.triangles)
    except OSError as error:
        raise ExportError(f"the file {source.body} could not be read: {error.strerror or error}") from error


def _body_of_solids(solids: Sequence[Part.Shape]) -> Body:
    count = 0
    for solid in solids:
        curved = sum(face.Area for face in solid.Faces if not isinstance(face.Surface, _BENT_ONE_WAY))
        count += triangles_of_solid(solid.Volume, solid.Area, curved, len(solid.Faces))
    volume, surface = (sum(getattr(solid, name) for solid in solids) for name in ("Volume", "Area"))
    return Body(count, np.zeros((2, 3)), volume, surface)


# ------------------------------------------------------------------------------------------- for another process


def write_source(source: Source, folder: Path, name: str) -> None:
    """Write a source into a folder under a name.

    Raises
    ------
    ExportError
        If it cannot be written.
    """
    record: Dict[str, Any] = {"kind": source.kind, "name": source.name, "key": source.key}
    try:
        if source.kind == "file":
            record["path"] = source.body
        elif source.kind == "mesh":
            source.body.write(str(folder / _MESH.format(name)))
        elif source.kind == "rods":
            value, parameters = _rods(source.body)
            record["rods"] = to_record(parameters)
            write_value(value.wireframe, folder / _RODS.format(name))
        else:
            source.body.exportBinary(str(folder / _SHAPE.format(name)))
        (folder / _RECORD.format(name)).write_text(json.dumps(record), encoding="utf-8")
    except OSError as error:
        raise ExportError(f"{source.name} could not be written into {folder}: {error}") from error


def read_source_soup(folder: Path, name: str, unit: str, deflection: float, progress: Progress = silent) -> Soup:
    """Return the triangles of a source that ``write_source`` wrote; errors are those of ``soup_of_source``."""
    record = json.loads((folder / _RECORD.format(name)).read_text(encoding="utf-8"))
    kind, label = record["kind"], record["name"]
    if kind == "rods":
        parameters = from_record(RodParameters, record["rods"], "rods")
        return rods_soup(read_value(folder / _RODS.format(name)), parameters, label)
    if kind == "mesh":
        body: Any = Mesh.Mesh()
        body.read(str(folder / _MESH.format(name)))
    elif kind == "shape":
        body = Part.Shape()
        body.importBinary(str(folder / _SHAPE.format(name)))
    else:
        body = record["path"]
    return soup_of_source(Source(kind, label, record["key"], body), unit, deflection, progress)
