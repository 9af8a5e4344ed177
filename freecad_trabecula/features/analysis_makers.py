# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that analyse a body's slices in a document and lay analyses side by side."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Optional, Sequence, Union

import FreeCAD
import numpy as np

from ..core.analysis import comparison, passport
from ..core.analysis.parameters import SliceParameters
from ..core.analysis.triangles import UNITS
from ..core.booleans import manifold_available
from ..core.progress import Progress, silent
from ..core.voxels.parameters import VoxelParameters
from ..errors import ParameterError
from ..geometry.sections import exact_areas
from .analysis import Analysis, analysis_of, write_slice_parameters
from .arguments import given_in, given_object, given_objects, given_value
from .base import read_parameters
from .containers import place_beside
from .feature import is_a, update
from .makers import add, all_or_nothing
from .network import Network
from .voxel_design import VoxelDesign
from .wireframe import Wireframe


def make_analysis(
    document: FreeCAD.Document,
    source: Union[Any, str],
    parameters: Optional[SliceParameters] = None,
    morphometry: bool = False,
    unit: str = "auto",
    envelope: Any = "design",
    progress: Progress = silent,
) -> Any:
    """Add the slice analysis of a body and return the object.

    Parameters
    ----------
    document : App.Document
    source : document object or str
        A mesh, a solid, a network or scaffold of ours, or the path of a file.
    parameters : SliceParameters, optional
        By default those of ``default_parameters``.
    morphometry : bool
        Also measure the body as a whole on voxels.
    unit : str
        Of a file.
    envelope : document object, "design" or None
        To whose slices the porosity refers; None: the body's box; by default the envelope of a design of ours, if it
        is one.
    progress : callable

    Raises
    ------
    TrabeculaError
        If there is nothing to slice, or a value is refused; the document is as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> analysis = make.make_analysis(box.Document, box)
    >>> analysis.Slices, round(analysis.SliceVolume.Value, 9)
    (90, 24.0)
    """
    is_file = isinstance(source, str)
    if not is_file:
        given_in(document, given_object(source))
    if unit not in ("auto", *UNITS):
        raise ParameterError(f"the unit of a file must be one of auto, {', '.join(UNITS)}, got {unit!r}")
    given_value(parameters, SliceParameters, type(None))
    if envelope == "design":
        envelope = None if is_file else design_envelope(source)
    given_in(document, envelope)
    with all_or_nothing(document):
        obj = add(document, Analysis, "Analysis", "App::FeaturePython")
        if is_file:
            obj.File, obj.Unit, obj.Envelope = source, unit, envelope
            obj.Label = f"Analysis {Path(source).stem}"
        else:
            place_beside(obj, source)
            obj.Source, obj.Envelope = source, envelope
            obj.Label = f"Analysis {source.Label}"
        write_slice_parameters(obj, parameters or default_parameters(None if is_file else source))
        obj.Morphometry = morphometry
        update(obj, progress)
    return obj


def change_analysis(
    obj: Any,
    parameters: SliceParameters,
    morphometry: bool = False,
    envelope: Any = None,
    progress: Progress = silent,
) -> None:
    """Slice the source of an analysis object in another way.

    Raises
    ------
    TrabeculaError
        If a value is refused; the document is as it was.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.analysis.parameters import SliceParameters
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> analysis = make.make_analysis(box.Document, box)
    >>> make.change_analysis(analysis, SliceParameters(thickness=0.5))
    >>> analysis.Slices
    18
    """
    given_value(parameters, SliceParameters)
    given_in(given_object(obj, Analysis).Document, envelope)
    with all_or_nothing(obj.Document, [obj]):
        write_slice_parameters(obj, parameters)
        obj.Morphometry, obj.Envelope = morphometry, envelope
        update(obj, progress)


def exact_slices(obj: Any, axis: str, progress: Progress = silent) -> np.ndarray:
    """Return the sliced areas (S,), mm2, that the kernel finds where an analysis object slices triangles.

    The second route to ``profiles[axis].sliced_area``, without triangles; slow.

    Parameters
    ----------
    obj : document object
        An analysis of a solid.
    axis : str
        One of its axes.
    progress : callable

    Raises
    ------
    ParameterError
        If it slices no solid, or not along this axis.
    KernelError
        If the kernel cannot cut.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> make.exact_slices(make.make_analysis(box.Document, box), "x").round(9)[:2].tolist()
    [12.0, 12.0]
    """
    profiles = analysis_of(obj).profiles
    shape = getattr(obj.Source, "Shape", None)
    if shape is None or not shape.Solids:
        raise ParameterError(f"exact slices are those of a solid, got {obj.Source.Label if obj.Source else 'a file'}")
    if axis not in profiles:
        raise ParameterError(f"the axis must be one of {', '.join(profiles)}, got {axis!r}")
    return exact_areas(shape, axis, profiles[axis].coordinate, progress)


def default_parameters(source: Any) -> SliceParameters:
    """Return the parameters that suit a body: crossing rods united where that can be done, voxels layer by layer."""
    if is_a(source, VoxelDesign):
        return SliceParameters(thickness=min(read_parameters(source, VoxelParameters).size))
    unites = is_a(source, Network, Wireframe) and manifold_available()
    return SliceParameters(fill="union" if unites else "winding")


def design_envelope(obj: Any) -> Any:
    """Return the envelope of the design to which one of our objects belongs; None for all else."""
    if not is_a(obj):
        return None
    if is_a(obj, VoxelDesign):
        return obj.Envelope
    owner = getattr(obj, "Scaffold", None) or obj
    wireframe = owner if is_a(owner, Wireframe) else getattr(owner, "Wireframe", None)
    return getattr(wireframe, "Envelope", None)


def compare_analyses(
    analyses: Sequence[Any], thickness: Optional[float] = None, alignment: str = "start"
) -> comparison.Comparison:
    """Lay two or more analysis objects side by side (tables 5.11 to 5.13).

    Parameters
    ----------
    analyses : sequence of document objects
        The first is the reference of the differences.
    thickness : float, mm, optional
        Of the shared layers; by default the largest of the analyses.
    alignment : str
        What is laid on each other: ``start``, ``centre`` or ``own`` zero.

    Raises
    ------
    ParameterError
        If they have nothing in common.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> boxes = [make.make_box(FreeCAD.newDocument(), 2, 3, h) for h in (3, 4)]
    >>> found = make.compare_analyses([make.make_analysis(box.Document, box) for box in boxes])
    >>> found.axes["x"].values["sliced_area"].round(9)[:, 0].tolist()
    [9.0, 12.0]
    """
    given_value(thickness, int, float, type(None))
    return comparison.compare([analysis_of(obj) for obj in given_objects(analyses)], thickness, alignment)


def passport_of(
    first: Any, second: Any, thickness: Optional[float] = None, alignment: str = "start"
) -> passport.Passport:
    """Score one analysis object against another, the reference first; arguments as for ``compare_analyses``.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> box = make.make_box(FreeCAD.newDocument(), 2, 3, 4)
    >>> analysis = make.make_analysis(box.Document, box)
    >>> {score.value for score in make.passport_of(analysis, analysis).whole if score.symbol in ("L1", "KS")}
    {0.0}
    """
    return passport.passport(analysis_of(first), analysis_of(second), thickness, alignment)
