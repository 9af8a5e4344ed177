# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ``analyse`` and ``compare`` are given: a file of a body or of layers, or the folder of an earlier analysis."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Tuple

from ..core.analysis.analysis import Analysis, analyse, contours_of
from ..core.analysis.contours import Contours
from ..core.analysis.folder import load_analysis
from ..core.analysis.layer_analysis import analyse_layers
from ..core.analysis.morphometry import measure
from ..core.analysis.parameters import SliceParameters
from ..core.analysis.ssl import UNITS, read_ssl
from ..core.analysis.triangles import Soup, read_soup
from ..core.estimates import (
    Work,
    analysis_work,
    body_of,
    contours,
    layers_work,
    planes_of,
    saving_work,
    segments,
    workbook_work,
)
from ..core.progress import Progress, part, silent
from ..errors import DependencyError, EnvelopeError, ExportError, KernelError, MeshError, ParameterError
from ..geometry.envelopes import SHAPE_FILES, load_shape
from ..geometry.sections import shape_soup

MESH_FILES = (".stl", ".obj", ".ply", ".3mf")
#: Options that are fields of the parameters; an option that was not given leaves the field's default.
_FIELDS = ("thickness", "at", "gap", "iterations", "filter_open", "filter_closed", "smoothing", "compensation", "fill")


class Sample(NamedTuple):
    """A body with its analysis.

    Attributes
    ----------
    analysis : Analysis
    soup : Soup or None
        Its triangles, if it has any.
    layers : dict of axis to Contours
        Contours that came from a file of layers.
    notes : tuple of str
        What is to be said of the file.
    """

    analysis: Analysis
    soup: Optional[Soup] = None
    layers: Mapping[str, Contours] = {}
    notes: Tuple[str, ...] = ()

    def contours(self, axis: str, progress: Progress) -> Contours:
        """Return the mended contours along an axis."""
        if axis in self.layers or self.soup is None:
            return self.layers[axis]
        return contours_of(self.soup, self.analysis.parameters, axis, progress)[0]


def parameters_of(options: Mapping[str, Any]) -> SliceParameters:
    """Return the parameters that the options describe.

    Raises
    ------
    ParameterError
        If one breaks its rule.
    """
    chosen: Dict[str, Any] = {name: options[name] for name in (*_FIELDS, "rod_ratio") if options[name] is not None}
    if options["axes"]:
        chosen["axes"] = tuple(axis for one in options["axes"] for axis in one)
    if options.get("heights"):
        chosen.update(at="heights", heights=tuple(options["heights"]))
    low, high = options.get("range") or (None, None)
    chosen.update({name: end for name, end in (("low", low), ("high", high)) if end is not None})
    return SliceParameters(**chosen)


def read_sample(
    path: str, options: Mapping[str, Any], progress: Progress, tell: Callable[[Work], None] = lambda work: None
) -> Sample:
    """Return a body, analysed as the options say, or as it was analysed earlier if the path is a folder.

    Parameters
    ----------
    path : str
    options : dict
    progress : callable
    tell : callable
        Takes what the analysis and its files will take, once the body was read.

    Raises
    ------
    ParameterError
        If the file or the folder cannot be read, or an option breaks its rule.
    """
    if Path(path).is_dir():
        return Sample(load_analysis(path))
    parameters = parameters_of(options)
    if path.lower().endswith(".ssl"):
        return _layers(path, options, parameters, progress)
    progress(0.0, 1.0, f"reading {Path(path).name}")
    try:
        soup, notes = read_body(path, options["unit"], part(progress, 0.0, 0.05))
    except (MeshError, ExportError) as error:  # what was given is wrong: not something that failed on the way
        raise ParameterError(str(error)) from error
    tell(_work(soup, parameters, options))
    return _measured(soup, notes, parameters, not options["no_morphometry"], part(progress, 0.05, 1.0))


def _work(soup: Soup, parameters: SliceParameters, options: Mapping[str, Any]) -> Work:
    """What the analysis of a body takes, and what ``analyse`` writes of it."""
    body, measures = body_of(soup.triangles), not options["no_morphometry"]
    planes = list(planes_of(parameters, soup.box).values())
    count, cut = contours(body, planes), segments(body, planes)
    slices = [(number, round(count / len(planes))) for number, _ in planes]
    share = abs(body.volume) / body.room if body.room and measures else 0.0
    parts = [analysis_work(body, planes, measures)]
    if "xlsx" in options:  # compare, which has none of these, writes little
        parts.append(saving_work(slices, share, options["plots"] != "none"))
        parts += [workbook_work(slices)] if options["xlsx"] else []
        number = sum(n for n, _ in planes)
        parts += [layers_work(kind, cut, count, number, soup.box) for kind in ("ssl", "cli", "svg") if options[kind]]
    return reduce(Work.and_then, parts)


def read_body(path: str, unit: str, progress: Progress = silent) -> Tuple[Soup, List[str]]:
    """Return the triangles of a body's file, and what is to be said of it.

    Raises
    ------
    MeshError, ExportError, ParameterError
        If the file is none of those known, or cannot be read.
    """
    kind = Path(path).suffix.lower()
    if kind in MESH_FILES:
        return read_soup(path, unit), []
    if kind not in SHAPE_FILES:
        kinds = ", ".join((*MESH_FILES, *SHAPE_FILES, ".ssl"))
        raise ParameterError(f"{path}: what is analysed must be a folder or a file that ends in {kinds}, got {kind!r}")
    if unit not in ("auto", "mm"):
        raise ParameterError(f"the unit of a STEP, IGES or BREP file is in the file, got --unit {unit}")
    if not Path(path).is_file():
        raise ParameterError(f"{path} could not be read: there is no such file")
    try:
        shape, notes = load_shape(path)
        soup = shape_soup(shape, source=Path(path).name, progress=progress)
    except (EnvelopeError, KernelError) as error:
        raise MeshError(f"{path} cannot be sliced: {error}") from error
    count = len(shape.Solids)
    words = f"{count} solids were sliced" if count > 1 else "the solid was sliced"
    return replace(soup, unit="mm (the file's)"), [f"{words} through {len(soup.triangles)} triangles", *notes]


def _measured(
    soup: Soup, notes: List[str], parameters: SliceParameters, morphometry: bool, progress: Progress
) -> Sample:
    analysis = analyse(soup, parameters, False, part(progress, 0.0, 0.4 if morphometry else 1.0))
    if morphometry:
        try:
            whole = measure(soup, progress=part(progress, 0.4, 1.0))
            analysis = replace(analysis, morphometry=whole)
        except (ParameterError, MeshError, DependencyError) as error:  # the slices stand without it
            notes = [*notes, f"the morphometry was left out: {error}"]
    return Sample(analysis, soup, {}, tuple(notes))


def _layers(path: str, options: Mapping[str, Any], parameters: SliceParameters, progress: Progress) -> Sample:
    if options["thickness"] is not None:
        raise ParameterError("the layers of an SSL file have their own thickness: --thickness cannot be chosen")
    if options["unit"] not in ("auto", *UNITS):
        raise ParameterError(f"the unit of an SSL file must be one of auto, {', '.join(UNITS)}, got {options['unit']}")
    axes = parameters.axes if options["axes"] else ("z",)
    if len(axes) != 1:
        raise ParameterError(f"an SSL file holds the layers along one axis, got {', '.join(axes)}")
    try:
        found = read_ssl(path, axes[0], options["unit"], part(progress, 0.0, 0.5))
    except ExportError as error:
        raise ParameterError(str(error)) from error
    analysis, contours = analyse_layers(found, Path(path).name, parameters, part(progress, 0.5, 1.0))
    return Sample(analysis, None, {axes[0]: contours}, found.notes)
