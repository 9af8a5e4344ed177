# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the objects of a document can be coloured by, and the colours of their faces, edges or triangles."""

from __future__ import annotations

from functools import partial
from typing import Any, Callable, List, Optional, Tuple

import FreeCAD
import numpy as np

from ..core.analysis.parameters import AXES
from ..core.colours import Colouring, by_value
from ..core.meshes import Mesh as CoreMesh
from ..core.rod_colours import RECOVERY, ROD_COLOURINGS, failed_lines, rod_colouring
from ..core.voxels.design import VoxelDesign as CoreVoxels
from ..core.voxels.trabeculae import trabecula_counts
from ..core.wireframe import Wireframe as CoreWireframe
from ..errors import ParameterError
from ..geometry.mesh_objects import core_mesh
from . import results
from .analysis import Analysis, analysis_of
from .feature import is_a
from .network import Network
from .scaffold import Body, Scaffold
from .voxel_design import VoxelDesign, voxel_design_of
from .wireframe import Wireframe, recall

PLAIN = "plain"
_POROSITY = tuple(f"porosity along {axis}" for axis in AXES)
_TRABECULAE = tuple(f"trabeculae along {axis}" for axis in AXES)
#: What layers and slices can be coloured by; not every object by each.
LAYER_COLOURINGS = (*_POROSITY, *_TRABECULAE)
_INWARDS = 1e-3  # of a layer: a triangle between two layers belongs to that with the material


def choices(obj: Any) -> Tuple[str, ...]:
    """Return what an object can be coloured by, ``plain`` first; nothing for objects without a body."""
    if is_a(obj, Network, Wireframe):
        return (PLAIN, *ROD_COLOURINGS)
    if is_a(obj, VoxelDesign):
        return (PLAIN, *LAYER_COLOURINGS)
    if is_a(obj, Scaffold, Body) or (not is_a(obj) and hasattr(obj, "Mesh") and _analyses(obj)):
        return (PLAIN, *_POROSITY)
    return ()


def colouring_of(obj: Any, by: str) -> Colouring:
    """Return the colours of an object: of a network's faces, a wireframe's path edges, a mesh's triangles.

    Parameters
    ----------
    obj : document object
    by : str
        One of ``choices(obj)`` but ``plain``.

    Raises
    ------
    ParameterError
        If it cannot be coloured by that, or there is nothing yet.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> network = make.make_network(make.make_design(FreeCAD.newDocument(), preset("case1")).wireframe)
    >>> colouring_of(network, "coupling").legend.entries[0].name
    'Face1 - Face2'
    """
    return colouring_work(obj, by)()


def colouring_work(obj: Any, by: str) -> Callable[[], Colouring]:
    """Return what is left to compute for ``colouring_of``, which touches the document no more: for another thread.

    Raises
    ------
    ParameterError
        As ``colouring_of``.
    """
    if by == PLAIN or by not in choices(obj):
        raise ParameterError(
            f"{obj.Label} can be coloured by one of {', '.join(choices(obj)[1:]) or '(none)'}, got {by!r}"
        )
    if is_a(obj, Network):
        return partial(_of_rods, *_network_rods(obj), by)
    if is_a(obj, Wireframe):
        return partial(_of_rods, _shown(obj), np.repeat(np.arange(len(_shown(obj))), 2), by)  # a path has two pieces
    return _triangles_work(obj, by)


def axis_of(by: str) -> int:
    """Return the axis, 0, 1, 2, of one of ``LAYER_COLOURINGS``.

    Examples
    --------
    >>> axis_of("porosity along z")
    2
    """
    return AXES.index(by[-1])


def layers_work(obj: Any, by: str) -> Callable[[], Colouring]:
    """Return what is left to compute for the colours of a voxel design's layers, (S, 3): for another thread.

    Parameters
    ----------
    obj : document object
    by : str
        One of ``LAYER_COLOURINGS``.

    Raises
    ------
    ParameterError
        If there is no design yet.
    """
    layers = _layers_of_voxels(obj, by)
    return lambda: by_value(layers()[1], by, _unit(by))


def _unit(by: str) -> str:
    return "%" if by in _POROSITY else ""


def _of_rods(wireframe: CoreWireframe, rods: np.ndarray, by: str) -> Colouring:
    return rod_colouring(wireframe, by).of(rods)


def missing_of(obj: Any, by: str) -> np.ndarray:
    """Return the lines (F, 2, 3), mm, that stand for what the legend counts and the object has not: failed rods."""
    if by != RECOVERY:
        return np.zeros((0, 2, 3))
    return failed_lines(_shown(obj.Wireframe if is_a(obj, Network) else obj))


def _shown(obj: Any) -> CoreWireframe:
    """The numbers that a wireframe object shows; they may be older than its parameters."""
    recall(obj)
    found = results.find(Wireframe.KIND, obj.ResultKey)
    if found is None:
        raise ParameterError(f"{obj.Label} must be computed before its rods are coloured, got: {obj.Status}")
    return found.wireframe


def _network_rods(obj: Any) -> Tuple[CoreWireframe, np.ndarray]:
    """The wireframe of a network, and the number of the rod of each of its faces."""
    wireframe = _shown(obj.Wireframe)
    numbers = {name: k for k, name in enumerate(wireframe.names)}
    missing = [name for name in obj.RodNames if name not in numbers]
    if missing:
        raise ParameterError(f"{obj.Label} must show the rods of {obj.Wireframe.Label}, got {missing[0]}: update it")
    rods = [numbers[name] for name in obj.RodNames]
    faces = [len(solid.Faces) for solid in obj.Shape.Solids]
    return wireframe, np.repeat(np.array(rods, int), faces)


# ---------------------------------------------------------------------------------------------------------- layers


def _triangles_work(obj: Any, by: str) -> Callable[[], Colouring]:
    """What is left to compute for the colours of a mesh's triangles by their layers."""
    place = axis_of(by)
    is_voxels = is_a(obj, VoxelDesign)
    if is_voxels:
        layers = _layers_of_voxels(obj, by)
    else:
        found = _analysed_slices(obj, AXES[place])
        layers = lambda: found  # noqa: E731  at hand already
    mesh = obj.Mesh
    if is_voxels and not mesh.Placement.isIdentity():  # wherever the design was moved, its layers went with it
        mesh = mesh.copy()
        mesh.Placement = FreeCAD.Placement()
    return partial(_of_layers, core_mesh(mesh), layers, place, by)


def _of_layers(mesh: CoreMesh, layers: Callable[[], Tuple[np.ndarray, np.ndarray]], place: int, by: str) -> Colouring:
    """Triangles of a mesh by the number of the layer, of those with some edges and values, in which they lie."""
    edges, values = layers()
    corners = mesh.vertices[mesh.triangles].astype(np.float32)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = across[:, place] / np.maximum(np.linalg.norm(across, axis=1), 1e-30)
    middles = corners[:, :, place].mean(1) - _INWARDS * (edges[1] - edges[0]) * normals
    numbers = np.clip(np.searchsorted(edges, middles, "right") - 1, 0, len(values) - 1)
    return by_value(values, by, _unit(by)).of(numbers)


def _layers_of_voxels(obj: Any, by: str) -> Callable[[], Tuple[np.ndarray, np.ndarray]]:
    return partial(_voxel_layers, voxel_design_of(obj), by.split()[0], axis_of(by))


def _voxel_layers(design: CoreVoxels, quantity: str, place: int) -> Tuple[np.ndarray, np.ndarray]:
    """Edges (S + 1,), mm, of the layers of a voxel design along an axis, and their values (S,)."""
    voxels, others = design.voxels, tuple(k for k in range(3) if k != 2 - place)
    if quantity == "trabeculae":
        values = trabecula_counts(voxels)[place].astype(float)
    else:
        cells = np.ones_like(voxels) if design.mask is None else design.mask
        values = 100 * (1 - voxels.sum(others) / np.maximum(cells.sum(others), 1))
        values[cells.sum(others) == 0] = np.nan
    targets = design.targets
    return targets.origin[place] + targets.voxel[place] * np.arange(len(values) + 1), values


def _analysed_slices(obj: Any, axis: str) -> Tuple[np.ndarray, np.ndarray]:
    """Edges (S + 1,), mm, of the layers of the latest analysis of an object, and their porosity (S,), %."""
    found = _analysis_along(obj, axis)
    if found is None:
        raise ParameterError(f"the porosity of slices along {axis} is that of an analysis of {obj.Label}, got none: "
                             "analyse it first")  # fmt: skip
    profile = analysis_of(found).profiles[axis]
    middles = profile.coordinate
    half = profile.thickness / 2
    edges = np.concatenate([[middles[0] - half], (middles[1:] + middles[:-1]) / 2, [middles[-1] + half]])
    return edges, 100 * np.where(profile.spoilt, np.nan, profile.porosity)


def _analysis_along(obj: Any, axis: str) -> Optional[Any]:
    return next((one for one in reversed(_analyses(obj)) if axis in analysis_of(one).profiles), None)


def _analyses(obj: Any) -> List[Any]:
    return [one for one in obj.InList if is_a(one, Analysis) and one.Source == obj and one.ResultKey]
