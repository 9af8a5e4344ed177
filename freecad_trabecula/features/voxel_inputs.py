# SPDX-License-Identifier: LGPL-2.1-or-later
"""All that a voxel design depends on: a body, an analysis or drawn curves; an envelope, parameters, given tables."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ..core.analysis.analysis import Analysis as CoreAnalysis
from ..core.progress import Progress
from ..core.records import to_record
from ..core.voxels.drawn_curves import DrawnCurves, targets_of_curves
from ..core.voxels.parameters import VoxelParameters
from ..core.voxels.sources import MESHES, read_targets, targets_of_profiles, targets_of_triangles
from ..core.voxels.targets import AXES, Targets
from ..errors import ExportError, ParameterError
from . import results
from .analysis import Analysis, analysis_of
from .analysis_source import Source, file_source, object_source, read_source_soup, soup_of_source, write_source
from .feature import is_a
from .packing import read_value, write_value

#: Names of what another process reads.
_BODY, _ENVELOPE, _PROFILES, _DRAWN = "body", "envelope", "profiles", "drawn"
#: Tables alpha and beta, their cells one after the other as in ``alpha.ravel()``.
FlatTables = Tuple[Tuple[int, ...], Tuple[int, ...]]
CURVES = tuple(f"Curve{axis.upper()}" for axis in AXES)  # properties


class Inputs(NamedTuple):
    """All that a voxel design depends on; its targets come from a body, from an analysis, or from drawn curves."""

    body: Optional[Source]
    profiles: Optional[CoreAnalysis]
    mark: str
    envelope: Optional[Source]
    parameters: VoxelParameters
    surface: str
    curves: Optional[DrawnCurves] = None
    tables: Optional[FlatTables] = None

    @property
    def key(self) -> str:
        """Changes when one of them does."""
        envelope = self.envelope.key if self.envelope else ""
        chosen = json.dumps(to_record(self.parameters, everything=True))
        more = (json.dumps(self.tables),) if self.tables else ()  # without tables as ever: documents keep the key
        return results.key_of("voxels", self.mark, envelope, chosen, self.surface, *more)

    def targets(self, body: Optional[np.ndarray], progress: Progress) -> Targets:
        """Return the targets.

        Parameters
        ----------
        body : ndarray of shape (T, 3, 3), mm, or None
            Triangles of the sample, if it has any.
        progress : callable

        Raises
        ------
        TrabeculaError
            If there are no such targets, or the tables have another shape.
        """
        if self.curves is not None:
            found = targets_of_curves(self.curves, self.parameters)
        elif self.profiles is not None:
            found = targets_of_profiles(self.profiles, self.parameters)
        elif body is not None:
            found = targets_of_triangles(body, self.parameters, progress)
        else:
            found = read_targets(self.body.body, self.parameters, progress)
        return found if self.tables is None else replace(found, tables=_shaped(self.tables, found))


def _shaped(tables: FlatTables, targets: Targets) -> Tuple[np.ndarray, np.ndarray]:
    """Tables (N, P), (M, P)."""
    n, m, p = targets.layers
    for name, cells, lines in (("alpha", tables[0], n), ("beta", tables[1], m)):
        if len(cells) != lines * p:
            raise ParameterError(
                f"table {name} must have {lines} x {p} cells for these targets, got {len(cells)}: its tables were "
                "given for another sample or voxel size"
            )
    return np.array(tables[0], np.int64).reshape(n, p), np.array(tables[1], np.int64).reshape(m, p)


def inputs_of(
    sample: Any,
    parameters: VoxelParameters,
    envelope: Any = None,
    surface: str = "blocks",
    tables: Optional[Sequence[Any]] = None,
) -> Inputs:
    """Return all that a design depends on.

    Parameters
    ----------
    sample : document object, str or DrawnCurves
        A body, an analysis, the path of a file, or curves.
    parameters : VoxelParameters
    envelope : document object or None
    surface : str
    tables : pair of arrays (N, P), (M, P), or None
        alpha and beta when they are given.

    Raises
    ------
    ParameterError
        If there is no such sample.
    """
    within = object_source(envelope) if envelope is not None else None
    flat = flat_tables(tables)
    if isinstance(sample, DrawnCurves):
        mark = json.dumps(to_record(sample, everything=True))
        return Inputs(None, None, mark, within, parameters, surface, sample, flat)
    if is_a(sample, Analysis):
        return Inputs(None, analysis_of(sample), sample.ResultKey, within, parameters, surface, None, flat)
    body = existing_file(sample) if isinstance(sample, str) else object_source(sample)
    return Inputs(body, None, body.key, within, parameters, surface, None, flat)


def flat_tables(tables: Optional[Sequence[Any]]) -> Optional[FlatTables]:
    """Return tables as plain whole numbers, one after the other, or None."""
    if tables is None:
        return None
    try:
        alpha, beta = ([int(cell) for cell in np.asarray(table).ravel()] for table in tables)
    except (TypeError, ValueError):
        raise ParameterError(f"tables must be alpha and beta, of whole numbers, got {tables!r:.60}") from None
    return (tuple(alpha), tuple(beta)) if alpha else None


def curves_of(obj: Any) -> Optional[DrawnCurves]:
    """Return the curves that a voxel design keeps, or None.

    Raises
    ------
    ParameterError
        If they are no curves.
    """
    if not getattr(obj, CURVES[0]):
        return None
    curves = [tuple((point.x, point.y) for point in getattr(obj, name)) for name in CURVES]
    return DrawnCurves(tuple(obj.CurveEdges), *curves)


def keep_curves(obj: Any, curves: Optional[DrawnCurves]) -> None:
    """Keep curves in a voxel design, or none."""
    for name, points in zip(CURVES, curves.curves if curves is not None else ((), (), ())):
        setattr(obj, name, [(place, share, 0.0) for place, share in points])
    obj.CurveEdges = curves.edges if curves is not None else (0.0, 0.0, 0.0)


def sample_of(obj: Any) -> Any:
    """Return the sample of a voxel design: an object, the path of a file, or curves.

    Raises
    ------
    ParameterError
        If there is none.
    """
    found = obj.Source or obj.File or curves_of(obj)
    if not found:
        raise ParameterError(f"{obj.Label} must have a sample, a source, a file or drawn curves, got none")
    return found


def existing_file(path: str) -> Source:
    """Return a file, or the folder of an analysis.

    Raises
    ------
    ParameterError
        If it is not there.
    """
    try:
        return file_source(path)
    except ExportError as error:
        raise ParameterError(str(error)) from error


def is_table(body: Source) -> bool:
    """Return whether a source holds counts or voxels instead of triangles."""
    return body.kind == "file" and Path(body.body).suffix.lower() not in MESHES


def triangles_of(source: Source, progress: Progress) -> np.ndarray:
    """Return the triangles of a source, (T, 3, 3) mm."""
    return soup_of_source(source, "auto", 0.0, progress).triangles


# -------------------------------------------------------------------------------------------- for another process


def write_inputs(folder: Path, inputs: Inputs) -> Dict[str, Any]:
    """Write what another process needs to compute a design; return the record of its task."""
    for source, name in ((inputs.body, _BODY), (inputs.envelope, _ENVELOPE)):
        if source is not None:
            write_source(source, folder, name)
    if inputs.profiles is not None:
        write_value(inputs.profiles, folder / _PROFILES)
    write_value((inputs.curves, inputs.tables), folder / _DRAWN)
    return {
        "key": inputs.key,
        "parameters": to_record(inputs.parameters),
        "surface": inputs.surface,
        "table": inputs.body.body if inputs.body is not None and is_table(inputs.body) else "",
        "profiles": inputs.profiles is not None,
        "body": inputs.body is not None,
        "envelope": inputs.envelope is not None,
    }


def read_inputs(
    folder: Path, record: Dict[str, Any], parameters: VoxelParameters, progress: Progress
) -> Tuple[Inputs, Optional[np.ndarray], Optional[np.ndarray]]:
    """Return what ``write_inputs`` wrote, and the triangles of sample and envelope, None where there are none."""
    profiles = read_value(folder / _PROFILES) if record["profiles"] else None
    curves, tables = read_value(folder / _DRAWN)
    table = record["table"]
    body = None
    if record["body"] and not table:
        body = read_source_soup(folder, _BODY, "auto", 0.0, progress).triangles
    envelope = read_source_soup(folder, _ENVELOPE, "auto", 0.0, progress).triangles if record["envelope"] else None
    source = existing_file(table) if table else None
    return Inputs(source, profiles, "", None, parameters, record["surface"], curves, tables), body, envelope
