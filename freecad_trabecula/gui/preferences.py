# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user prefers (Edit > Preferences > Trabecula), read and checked in one place.

Preferences are read when an object, its panel or a view of it is made, never when an object is computed: a document
gives the same results wherever it is opened, and a script the same objects whoever runs it. A stored value that breaks
a rule is told in the report view, and the default is taken.
"""

from __future__ import annotations

import math
import os
from dataclasses import replace
from typing import Any, Callable, Dict, NamedTuple, Tuple

import FreeCAD
import FreeCADGui

from ..core.analysis.parameters import SliceParameters
from ..core.job import Job
from ..core.laws import uniform
from ..core.parameters import ENGINES, LARGEST_SEED
from ..core.presets import preset
from ..core.voxels.parameters import VoxelParameters
from ..errors import ParameterError
from ..features.voxel_design import SURFACES
from .language import filled, in_words
from .qt import RESOURCES

translate = FreeCAD.Qt.translate

GROUP = "User parameter:BaseApp/Preferences/Mod/Trabecula"
PAGE = RESOURCES / "ui" / "preferences.ui"
#: Words behind the entries of the page's combo boxes, whose number is what is stored: new ones come last.
STRATEGIES = ("trabecular", "minimum-zeros", "sequential", "random-layers", "by-field", "best-tables")
_MOST_THREADS = 1024
_DEFAULT_JOB, _DEFAULT_SLICES, _DEFAULT_VOXELS = preset("case6"), SliceParameters(), VoxelParameters()


class Entry(NamedTuple):
    """A preference: kind of the stored value, default, rule in words, and whether a value keeps it."""

    kind: str
    default: Any
    rule: str = ""
    is_good: Callable[[Any], bool] = lambda value: True


def _length(default: float) -> Entry:
    return Entry(
        "Float",
        default,
        translate("Trabecula", "must be a length above 0 mm"),
        lambda value: math.isfinite(value) and value > 0,
    )


def _choice(words: Tuple[str, ...], default: str) -> Entry:
    rule = translate("Trabecula", "must be the number of one of {}").format(", ".join(words))
    return Entry("Int", words.index(default), rule, lambda value: 0 <= value < len(words))


def _whole(default: int, most: int) -> Entry:
    rule = translate("Trabecula", "must lie in {}..{}").format(0, most)
    return Entry("Int", default, rule, lambda value: 0 <= value <= most)


def _colour(code: str) -> Entry:
    return Entry("Unsigned", int(code[1:] + "ff", 16))


#: All preferences, by the name under which FreeCAD keeps them.
ENTRIES: Dict[str, Entry] = {
    "Seed": _whole(_DEFAULT_JOB.seed, LARGEST_SEED),
    "PoreSmallest": _length(_DEFAULT_JOB.pores.size.low),
    "PoreLargest": _length(_DEFAULT_JOB.pores.size.high),
    "Engine": _choice(ENGINES, _DEFAULT_JOB.scaffold.engine),
    "SliceThickness": _length(_DEFAULT_SLICES.thickness),
    "VoxelSize": _length(_DEFAULT_VOXELS.size[0]),
    "Strategy": _choice(STRATEGIES, _DEFAULT_VOXELS.strategy),
    "VoxelSurface": _choice(SURFACES, SURFACES[0]),
    "ColourWireframe": _colour("#4073b3"),
    "ColourRods": _colour("#edd9ad"),
    "ColourScaffold": _colour("#edd9ad"),
    "ColourChannels": _colour("#599ea6"),
    "ColourRodContours": _colour("#0072b2"),
    "ColourPlateContours": _colour("#d55e00"),
    "ColourSample": _colour("#d55e00"),
    "ColourDesign": _colour("#0072b2"),
    "ExportFolder": Entry(
        "String",
        "",
        translate("Trabecula", "must be a folder that is there"),
        lambda folder: not folder or os.path.isdir(folder),
    ),
    "Threads": _whole(0, _MOST_THREADS),
    "ShowStartPanel": Entry("Bool", True),
}


def preference(name: str) -> Any:
    """Return a preference; its default, with a line in the report view, if the stored value breaks its rule."""
    entry = ENTRIES[name]
    value = getattr(FreeCAD.ParamGet(GROUP), "Get" + entry.kind)(name, entry.default)
    if entry.is_good(value):
        return value
    told = translate("Trabecula", "{} {}, got {}; {} is taken")
    _tell(filled(told, name, entry.rule, value, entry.default))
    return entry.default


def _tell(text: str) -> None:
    FreeCAD.Console.PrintWarning(translate("Trabecula", "Trabecula's preferences: {}").format(text) + "\n")


def add_page() -> None:
    """Add the page to FreeCAD's preferences; once, when the workbench is first chosen."""
    FreeCADGui.addPreferencePage(str(PAGE), "Trabecula")


# ---------------------------------------------------------------------------------------- defaults for new objects


def new_job() -> Job:
    """Return the job with which the panel of a new design begins."""
    job = replace(_DEFAULT_JOB, name="design", seed=preference("Seed"))
    job = replace(job, scaffold=replace(job.scaffold, engine=ENGINES[preference("Engine")]))
    low, high = preference("PoreSmallest"), preference("PoreLargest")
    try:
        return replace(job, pores=replace(job.pores, size=uniform(low, high)))
    except ParameterError as error:
        told = translate("Trabecula", "PoreSmallest and PoreLargest: {}; {:g} and {:g} mm are taken")
        _tell(filled(told, in_words(str(error)), job.pores.size.low, job.pores.size.high))
        return job


def new_slices(parameters: SliceParameters) -> SliceParameters:
    """Return parameters that suit a body with the preferred thickness, unless they bring one of their own."""
    if parameters.thickness != _DEFAULT_SLICES.thickness:
        return parameters
    return replace(parameters, thickness=preference("SliceThickness"))


def new_voxels() -> VoxelParameters:
    """Return the parameters with which the panel of a new voxel design begins."""
    size, strategy = preference("VoxelSize"), STRATEGIES[preference("Strategy")]
    return VoxelParameters(size=(size,) * 3, strategy=strategy, seed=preference("Seed"))


def new_surface() -> str:
    """Return the surface of a new voxel design: a word of ``features.voxel_design.SURFACES``."""
    return SURFACES[preference("VoxelSurface")]


# ----------------------------------------------------------------------------------------------------- all the rest


def preferred_colour(name: str) -> str:
    """Return a preferred colour as ``#rrggbb``."""
    return f"#{preference(name) >> 8 & 0xFFFFFF:06x}"


def shares(name: str) -> Tuple[float, float, float]:
    """Return a preferred colour as shares of red, green and blue, 0..1."""
    code = preferred_colour(name)
    return tuple(int(code[k : k + 2], 16) / 255 for k in (1, 3, 5))


def folder_for(document: Any) -> str:
    """Return the folder in which a dialog for a file to be written opens: the preferred one, or the document's."""
    return preference("ExportFolder") or os.path.dirname(document.FileName if document is not None else "")


def child_threads() -> Dict[str, str]:
    """Return environment variables that limit the threads of a process for long work; none: as many as it likes.

    They are heeded by what numpy and scipy calculate with (OpenBLAS, MKL, OpenMP). Our own code and manifold3d use one
    thread; FreeCAD's kernel does not ask.
    """
    threads = preference("Threads")
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
    return dict.fromkeys(names, str(threads)) if threads else {}
