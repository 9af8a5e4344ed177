# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets from files: a mesh, the folder of an analysis, CSV tables, a design's own targets.json, voxels."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ...errors import ExportError, MeshError, ParameterError
from ..analysis.analysis import Analysis
from ..analysis.folder import REPORT, load_analysis
from ..analysis.slices import sliced_areas
from ..analysis.triangles import read_soup
from ..analysis.voxelise import mean_thickness, voxelise
from ..parameters import require
from ..progress import Progress, part, silent
from ..triples import triple
from .parameters import VoxelParameters
from .slabs import slab_volumes
from .targets import AXES, Targets, layer_counts_of_box, targets_from_areas
from .trabeculae import trabecula_counts
from .volume_files import read_npy
from .volume_sources import VOLUMES, targets_of_volume

#: Suffixes of meshes, as ``analysis.triangles.read_soup`` knows them.
MESHES = (".stl", ".obj", ".ply", ".3mf")
AREA, COUNT = "sliced_area_mm2", "voxels"
_OPEN = 1e-7  # of the surface: what sums of single precision leave
_SAME = 1e-3  # relative: a layer of 0.1 mm written with four digits


def read_targets(
    path: Union[str, Path],
    parameters: VoxelParameters,
    progress: Progress = silent,
    threshold: Optional[float] = None,
) -> Targets:
    """Return the targets that a file asks for.

    Parameters
    ----------
    path : str or Path
        A mesh; the folder of an analysis; a CSV file with the columns ``axis``, ``layer`` and ``sliced_area_mm2`` or
        ``voxels``; ``targets.json`` of a design; a volume of voxels (NPY, NRRD, TIFF, a folder of images).
    parameters : VoxelParameters
    progress : callable
    threshold : float, optional
        Of a volume: values above it are material; None: Otsu's.

    Raises
    ------
    ParameterError
        If the file is none of these or does not fit the voxel size.
    MeshError, InfeasibleError
        If a mesh is not closed; if a layer is asked for more than it holds.
    """
    path = Path(path)
    require(path.exists(), "there must be a file or folder of that name", str(path))
    kind = path.suffix.lower()
    if path.is_dir() and (path / REPORT).exists():
        return targets_of_analysis(path, parameters)
    if path.is_dir() or kind in VOLUMES:
        return targets_of_volume(path, parameters, threshold, progress)
    if kind in MESHES:
        return targets_of_triangles(read_triangles(path), parameters, progress)
    if kind == ".csv":
        return targets_of_csv(path, parameters)
    if kind == ".json":
        return targets_of_json(path)
    raise ParameterError(
        f"targets are read from {', '.join((*MESHES, *VOLUMES))}, .csv, .json, the folder of an analysis or a folder "
        f"of images, got {path.name}"
    )


def layers_of_source(path: Union[str, Path], parameters: VoxelParameters) -> Tuple[int, int, int]:
    """Return how many layers N, M, P the targets of a file have, before they are made: for an estimate.

    Raises
    ------
    ParameterError
        As ``read_targets``.
    """
    path = Path(path)
    if path.suffix.lower() not in MESHES or path.is_dir():
        return read_targets(path, parameters).layers
    triangles = read_triangles(path)
    edges = triangles.max((0, 1)).astype(float) - triangles.min((0, 1))
    return layer_counts_of_box(edges, parameters.size, parameters.areas)


def read_triangles(path: Union[str, Path]) -> np.ndarray:
    """Return the triangles of a mesh, (T, 3, 3) mm.

    Raises
    ------
    ParameterError
        If the file cannot be read or is damaged.
    """
    try:
        return read_soup(path).triangles
    except (ExportError, MeshError) as error:
        raise ParameterError(str(error)) from error


def read_mask(path: Union[str, Path], targets: Targets, boundary: str, progress: Progress = silent) -> np.ndarray:
    """Return the cells that may be solid, (P, M, N) bool: from a closed mesh, or an NPY file of the targets' shape.

    Parameters
    ----------
    path : str or Path
    targets : Targets
    boundary : str
        Cells that a mesh cuts: ``half``: those with their centre inside; ``touched`` and ``inside``: those with any, or
        all, of 3 x 3 x 3 points inside.
    progress : callable

    Raises
    ------
    ParameterError
        If the file cannot be read, is of another shape, or no cell is inside.
    """
    path = Path(path)
    if path.suffix.lower() != ".npy":
        return mask_of_triangles(read_triangles(path), targets, boundary, progress, path.name)
    mask = read_npy(path) > 0
    require(mask.shape == targets.shape, f"the mask must have the shape {targets.shape}", mask.shape)
    return _some_cells(mask, path.name)


def mask_of_triangles(
    triangles: np.ndarray, targets: Targets, boundary: str, progress: Progress = silent, name: str = "it"
) -> np.ndarray:
    """Return the cells of the targets that lie in a closed mesh, (P, M, N) bool; ``boundary`` as for ``read_mask``.

    Raises
    ------
    ParameterError
        If the mesh is not closed, or no cell is inside.
    """
    return _some_cells(cells_inside(triangles, targets.layers, targets.voxel, targets.origin, boundary, progress), name)


def cells_inside(
    triangles: np.ndarray,
    layers: Tuple[int, int, int],
    voxel: Sequence[float],
    origin: Sequence[float],
    boundary: str,
    progress: Progress = silent,
) -> np.ndarray:
    """Return the cells of a grid of N, M, P layers that lie in a closed mesh, (P, M, N) bool, as ``read_mask``."""
    fine = 1 if boundary == "half" else 3
    size = np.asarray(voxel, float) / fine
    points = _voxelised(triangles, np.asarray(origin, float), triple(fine * n for n in layers), size, progress)
    points = points.reshape([k for n in layers[::-1] for k in (n, fine)])
    return points.any((1, 3, 5)) if boundary == "touched" else points.all((1, 3, 5))


def _some_cells(mask: np.ndarray, name: str) -> np.ndarray:
    require(bool(mask.any()), f"a mask must have at least one cell; {name} has in the targets' box", 0, "cells")
    return mask


def targets_of_triangles(triangles: np.ndarray, parameters: VoxelParameters, progress: Progress = silent) -> Targets:
    """Return the targets of a closed mesh: sections through the layers' middles (Eq. 6.1), or slab volumes.

    Parameters
    ----------
    triangles : ndarray of shape (T, 3, 3), mm
    parameters : VoxelParameters
    progress : callable

    Raises
    ------
    MeshError
        If the mesh is empty or not closed.
    ParameterError
        If a voxel is larger than the mesh, or there are too many.
    """
    if not len(triangles):
        raise MeshError("a sample must have at least one triangle, got 0")
    check_closed(triangles)
    low, high = (triangles.min((0, 1)).astype(float), triangles.max((0, 1)).astype(float))
    layers = layer_counts_of_box(high - low, parameters.size, parameters.areas)
    areas = []
    for axis, count in enumerate(layers):
        progress(axis, 6, "sliced areas")
        size = parameters.size[axis]
        if parameters.areas == "slab":
            planes = low[axis] + np.arange(count + 1) * size
            planes[[0, -1]] += (-1e-6 * size, 1e-6 * size)
            areas.append(np.maximum(slab_volumes(triangles, axis, planes) / size, 0.0))
        else:
            areas.append(sliced_areas(triangles, AXES[axis], low[axis] + (np.arange(count) + 0.5) * size))
    sample = _voxelised(triangles, low, layers, parameters.size, part(progress, 0.5, 1.0))
    counts = trabecula_counts(sample) if parameters.trabeculae != "off" else None
    areas = [np.where(np.abs(a) < 1e-9, 0.0, a) for a in areas]
    return targets_from_areas(areas, parameters, tuple(low.tolist()), sample, counts, mean_thickness(triangles))


def _voxelised(
    triangles: np.ndarray, low: np.ndarray, layers: Tuple[int, int, int], size: ArrayLike, progress: Progress
) -> np.ndarray:
    """Voxels of a mesh on the design's own grid, (P, M, N) bool; cells that are no cubes are made so first."""
    scaled = (np.asarray(triangles, float) - low) / np.asarray(size)
    try:
        return voxelise(scaled, 1.0, ((0.0, 0.0, 0.0), layers), progress).solid
    except MeshError as error:
        raise ParameterError(f"a mesh must be closed to be filled with voxels: {error}") from error


def check_closed(triangles: np.ndarray) -> None:
    """Refuse a mesh whose vector area is not 0, as that of every closed mesh is, or whose volume is negative.

    Raises
    ------
    ParameterError
        If the mesh is open or inside out.
    """
    a, b, c = (np.asarray(triangles[:, k], float) for k in range(3))
    normals = np.cross(b - a, c - a)
    open_area, surface = np.linalg.norm(normals.sum(0)) / 2, np.linalg.norm(normals, axis=1).sum() / 2
    if open_area > _OPEN * surface:
        raise ParameterError(
            f"a sample's mesh must be closed, got an open area of {open_area:.3g} mm²: mend it first "
            "(Mesh > Analyze > Evaluate and repair)"
        )
    volume = float(((a - a.mean(0)) * normals).sum()) / 6
    require(volume > 0, "a sample's mesh must not be inside out; its volume is", f"{volume:.4g}", "mm³")


def targets_of_analysis(folder: Union[str, Path], parameters: VoxelParameters) -> Targets:
    """Return the targets of the analysis in a folder; errors are those of ``targets_of_profiles``."""
    return targets_of_profiles(load_analysis(folder), parameters)


def targets_of_profiles(analysis: Analysis, parameters: VoxelParameters) -> Targets:
    """Return the targets of an analysis along X, Y and Z whose layers are as thick as the voxels (thesis 6.2.1).

    Raises
    ------
    ParameterError
        If an axis is missing, or its layers are not as thick as the voxels.
    """
    areas = areas_of_profiles(analysis, parameters.size)
    counts = [analysis.profiles[axis].outer_contours.astype(np.int64) for axis in AXES]
    facts = analysis.facts
    thickness = 2 * facts.volume / facts.area if facts is not None and facts.area > 0 else math.nan
    asked = triple(counts) if parameters.trabeculae != "off" else None
    return targets_from_areas(areas, parameters, triple(analysis.box[0].tolist()), None, asked, thickness)


def areas_of_profiles(analysis: Analysis, thickness: Sequence[float]) -> List[np.ndarray]:
    """Return the sliced areas of an analysis along X, Y and Z, mm², whose layers have these thicknesses, mm.

    Raises
    ------
    ParameterError
        As ``targets_of_profiles``.
    """
    areas = []
    for axis, size in zip(AXES, thickness):
        require(
            axis in analysis.profiles,
            f"an analysis along X, Y and Z is needed; {analysis.name} has",
            ", ".join(sorted(analysis.profiles)),
        )
        profile = analysis.profiles[axis]
        _check_thickness(profile.thickness, size, axis, len(profile.sliced_area))
        areas.append(np.where(profile.sliced_area < 0, 0.0, profile.sliced_area))
    return areas


def _check_thickness(thickness: float, size: float, axis: str, layers: int) -> None:
    if abs(thickness - size) > _SAME * size:
        more = round(layers * thickness / size)
        raise ParameterError(
            f"voxels must be as large as the layers of the sample, {thickness:g} mm along {axis.upper()}, got {size:g} "
            f"mm, which makes {more} layers of the sample's {layers}: slice it again with layers of {size:g} mm"
        )


def targets_of_csv(path: Union[str, Path], parameters: VoxelParameters) -> Targets:
    """Return the targets of a table with one row for each layer of each axis.

    Columns: ``axis`` (x, y, z), ``layer`` (0, 1, ...), ``sliced_area_mm2`` or ``voxels``; others are ignored.

    Raises
    ------
    ParameterError
        If a column, an axis or a layer is missing, twice there, or no number; ``voxels`` must be whole numbers.
    InfeasibleError
        If the axes' counts differ in their totals.
    """
    rows = _csv_rows(Path(path))
    column = COUNT if COUNT in rows[0] else AREA
    for name in ("axis", "layer", column):
        require(name in rows[0], f"{path} must have a column {name!r}; it has", ", ".join(rows[0]))
    values: Dict[str, Dict[int, float]] = {axis: {} for axis in AXES}
    for number, row in enumerate(rows, 2):
        where = f"{path}, line {number}"
        axis = (row["axis"] or "").strip().lower()
        require(axis in values, f"{where}: the axis must be x, y or z", repr(row["axis"]))
        layer = int(_number(row["layer"], where))
        require(layer not in values[axis], f"{where}: a layer must stand there once", f"layer {layer} along {axis}")
        values[axis][layer] = _number(row[column], where)
    arrays = []
    for axis in AXES:
        layers = values[axis]
        require(sorted(layers) == list(range(len(layers))) and bool(layers),
                f"{path} must have the layers 0, 1, ... along {axis}", sorted(layers)[:5])  # fmt: skip
        arrays.append(np.array([layers[k] for k in range(len(layers))]))
    if column == COUNT:
        return Targets(*triple(arrays), parameters.size)
    return targets_from_areas(arrays, parameters)


def _csv_rows(path: Path) -> List[Dict[str, Any]]:
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            rows = list(csv.DictReader(file))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise ParameterError(f"{path} could not be read as CSV: {error}") from error
    require(bool(rows), f"{path} must have a line of names and one for each layer", len(rows), "layers")
    return rows


def _number(text: Optional[str], where: str) -> float:
    try:
        return float((text or "").strip())
    except ValueError:
        raise ParameterError(f"{where}: it must be a number, got {text!r}") from None


def targets_record(targets: Targets) -> Dict[str, Any]:
    """Return targets as plain values, with the thesis' letters: what ``targets.json`` holds."""
    record: Dict[str, Any] = {
        "D": targets.d.tolist(),
        "E": targets.e.tolist(),
        "C": targets.c.tolist(),
        "layers": dict(zip(("N", "M", "P"), targets.layers)),
        "voxels": targets.total,
        "voxel_mm": list(targets.voxel),
        "origin_mm": list(targets.origin),
        "deltas": dict(zip(("delta_X", "delta_Y", "delta_Z"), targets.deltas)),
        "mean_thickness_mm": None if math.isnan(targets.thickness) else targets.thickness,
    }
    if targets.areas is not None:
        record["sliced_area_mm2"] = {axis: areas.tolist() for axis, areas in zip(AXES, targets.areas)}
    if targets.trabeculae is not None:
        record["trabeculae"] = {axis: np.asarray(n).tolist() for axis, n in zip(AXES, targets.trabeculae)}
    return record


def targets_of_json(path: Union[str, Path]) -> Targets:
    """Return the targets in a ``targets.json``; the voxel size is the file's.

    Raises
    ------
    ParameterError
        If the file is no JSON or a key is missing.
    InfeasibleError
        As ``Targets``.
    """
    try:
        record = json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ParameterError(f"{path} could not be read as JSON: {error}") from error
    for key in ("D", "E", "C", "voxel_mm"):
        require(isinstance(record, dict) and key in record, f"{path} must hold", key)
    counts = record.get("trabeculae")
    try:
        return Targets(
            *triple(np.array(record[key]) for key in "DEC"),
            triple(float(edge) for edge in record["voxel_mm"]),
            triple(record.get("origin_mm", (0.0, 0.0, 0.0))),
            triple(record.get("deltas", {}).get(f"delta_{axis}", 0) for axis in "XYZ"),
            trabeculae=None if counts is None else triple(np.array(counts[axis]) for axis in AXES),
            thickness=math.nan if record.get("mean_thickness_mm") is None else float(record["mean_thickness_mm"]),
        )
    except (TypeError, KeyError, AttributeError) as error:
        raise ParameterError(f"{path}: its values must be lists of numbers: {error}") from error
