# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyses as diagrams and rows of tables: figures 5.8 to 5.74 and tables 5.2 to 5.13 of the thesis. No window."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, List, NamedTuple, Sequence, Tuple

import FreeCAD
import numpy as np

from ..core.analysis.analysis import Analysis
from ..core.analysis.comparison import Comparison, SharedAxis, compare, range_text
from ..core.analysis.passport import passport
from ..core.analysis.plots import COLOURS, SIZES, area_edges, coordinate_edges
from ..core.explanations.registry import TOTAL_KEYS, measure_key
from .chart import Counts, Curve, Diagram
from .figures import with_powers
from .language import in_words, local_number, with_decimals

translate = FreeCAD.Qt.translate
_GREY = "#999999"
_MOST_LETTERS = 16  # of a name in a diagram or a table
#: Kinds of diagrams: key, title of the tab.
KINDS = (
    ("sliced_area", translate("Trabecula", "Sliced area")),
    ("porosity", translate("Trabecula", "Porosity")),
    ("contours", translate("Trabecula", "Trabeculae")),
    ("areas", translate("Trabecula", "Areas")),
    ("heat", translate("Trabecula", "Heat map")),
)
#: Which numbers each kind of diagram shows: of one analysis, of several.
KEYS = {
    "sliced_area": ("slices.sliced_area",),
    "porosity": ("slices.porosity",),
    "contours": ("slices.contours", "slices.outer_contours"),
    "areas": ("slices.trabecular_area", "slices.rods"),
    "heat": ("slices.trabecular_area",),
}
COMPARED_KEYS = dict(KEYS, heat=("comparison.mean", "slices.sliced_area"))
_LABELS = {
    "sliced_area": (translate("Trabecula", "sliced area, mm²"), 1.0),
    "porosity": (translate("Trabecula", "porosity, %"), 100.0),
    "contours": (translate("Trabecula", "number of trabeculae"), 1.0),
}


class Row(NamedTuple):
    """A line of a table: what, values beside it, the key of their explanation; ``tip`` says more."""

    words: str
    values: Sequence[str]
    key: str
    tip: str = ""


def title(axis: str) -> str:
    """Return an axis as a reader knows it: X, Y, Z or (0.6,0.8,0)."""
    return axis.upper() if len(axis) == 1 else f"({axis})"


# --------------------------------------------------------------------------------------------------- one analysis


def diagram_of(analysis: Analysis, kind: str, axis: str) -> Diagram:
    """Return a diagram of one analysis.

    Parameters
    ----------
    analysis : Analysis
    kind : str
        A key of ``KINDS``.
    axis : str
        The axis that stands out, or the only one.
    """
    across = translate("Trabecula", "co-ordinate along {}, mm").format(title(axis))
    if kind == "areas":
        return _areas(analysis, axis, across)
    if kind == "heat":
        return _heat_map(analysis, axis, across)
    label, factor = _LABELS[kind]
    if kind == "contours":
        profile = analysis.profiles[axis]
        words = (translate("Trabecula", "contours (as the thesis)"), translate("Trabecula", "outer contours"))
        columns = (profile.contours, profile.outer_contours)
        lines = [Curve(w, profile.coordinate, c, COLOURS[k]) for k, (w, c) in enumerate(zip(words, columns))]
        return Diagram(across, label, [*lines, *_spoilt(profile, profile.contours)])
    curves: List[Curve] = []
    for number, (name, profile) in enumerate(analysis.profiles.items()):
        values, colour = factor * np.asarray(getattr(profile, kind), float), COLOURS[number % len(COLOURS)]
        words = translate("Trabecula", "along {}").format(title(name))
        curves.append(Curve(words, profile.coordinate, values, colour, faint=name != axis))
        if name == axis:
            curves += _spoilt(profile, values)
    return Diagram(across, label, sorted(curves, key=lambda curve: not curve.faint), size=SIZES.get(kind, 0.0))


def _spoilt(profile: Any, values: np.ndarray) -> List[Curve]:
    """Slices on which the mesh is not closed, marked."""
    rows = np.flatnonzero(profile.spoilt)
    if not len(rows):
        return []
    return [Curve(translate("Trabecula", "spoilt"), profile.coordinate[rows], values[rows], "#d64545", marks=True)]


def _areas(analysis: Analysis, axis: str, across: str) -> Diagram:
    profile, measures = analysis.profiles[axis], analysis.measures[axis]
    where = profile.coordinate[measures.plane]
    outer, rods = measures.area > 0, measures.is_rod
    kinds = (
        (translate("Trabecula", "plates ({})"), outer & ~rods, COLOURS[1]),
        (translate("Trabecula", "rods ({})"), outer & rods, COLOURS[0]),
        (translate("Trabecula", "voids ({})"), measures.area < 0, COLOURS[2]),
    )
    curves = [
        Curve(words.format(int(rows.sum())), where[rows], measures.area[rows], colour, marks=True)
        for words, rows, colour in kinds
        if rows.any()
    ]
    return Diagram(across, translate("Trabecula", "area, mm²"), curves)


def _heat_map(analysis: Analysis, axis: str, across: str) -> Diagram:
    profile, measures = analysis.profiles[axis], analysis.measures[axis]
    rows = measures.area > 0
    x, y = coordinate_edges(profile), area_edges(measures.area[rows])
    counts = np.histogram2d(profile.coordinate[measures.plane[rows]], measures.area[rows], bins=(x, y))[0]
    label = translate("Trabecula", "area of outer contours, mm² (light: many)")
    return Diagram(across, label, (), Counts(x, y, counts), is_log=True)


def figures_of(analysis: Analysis) -> Tuple[List[str], List[Row]]:
    """Return head and rows of a table of ranges and totals (tables 5.2, 5.5, 5.7, 5.10), then the morphometry."""
    axes = list(analysis.profiles)
    summaries = [analysis.summary(axis) for axis in axes]
    words = (
        ("slices.slices", translate("Trabecula", "Slices"), lambda s: str(s.slices)),
        ("slices.spoilt_slices", translate("Trabecula", "Spoilt slices"), lambda s: str(s.spoilt_slices)),
        ("slices.rods", translate("Trabecula", "Rods"), lambda s: str(s.rods)),
        ("slices.plates", translate("Trabecula", "Plates"), lambda s: str(s.plates)),
        (
            "slices.trabecular_area",
            translate("Trabecula", "Trabecular area, mm²"),
            lambda s: _range_text(s.trabecular_area),
        ),
        ("slices.sliced_area", translate("Trabecula", "Sliced area, mm²"), lambda s: _range_text(s.sliced_area)),
        (
            "slices.porosity",
            translate("Trabecula", "Porosity, %"),
            lambda s: _range_text((100 * s.porosity[0], 100 * s.porosity[1])),
        ),
        ("slices.contours", translate("Trabecula", "Contours"), lambda s: _range_text(s.contours)),
        ("slices.outer_contours", translate("Trabecula", "Outer contours"), lambda s: _range_text(s.outer_contours)),
        ("slices.volume", translate("Trabecula", "Volume by slices, mm³"), lambda s: number_text(s.volume)),
        (
            "slices.bone_fraction",
            translate("Trabecula", "Mean bone fraction, %"),
            lambda s: number_text(100 * s.mean_bone_fraction),
        ),
    )
    rows = [Row(name, [text(one) for one in summaries], key) for key, name, text in words]
    whole = analysis.morphometry
    for one in whole.measures if whole is not None else ():
        words = f"{one.symbol}, {one.unit}" if one.unit not in ("", "1") else one.symbol
        rows.append(
            Row(
                words,
                [number_text(one.value)],
                measure_key(one.symbol),
                f"{in_words(one.name)}: {in_words(one.definition)} ({one.source})",
            )
        )
    return [translate("Trabecula", "Quantity"), *(title(axis) for axis in axes)], rows


def _range_text(limits: Any) -> str:
    return _cell_text(range_text(limits))


def _cell_text(cell: str) -> str:
    """A number, or a range, in the language of the window."""
    low, between, high = cell.partition(" to ")
    if not between:
        return with_decimals(cell)
    return translate("Trabecula", "{} to {}").format(with_decimals(low), with_decimals(high))


def number_text(value: float) -> str:
    """Return a number in four digits, a dash where there is none.

    Examples
    --------
    >>> number_text(0.123456), number_text(float("nan"))
    ('0.1235', '-')
    """
    return local_number(value, ".4g") if math.isfinite(value) else "-"


# ------------------------------------------------------------------------------------------------- a comparison


def _short(name: str) -> str:
    return name if len(name) <= _MOST_LETTERS else name[: _MOST_LETTERS - 1] + "…"


def comparison_of(analyses: Sequence[Analysis]) -> Comparison:
    """Return analyses laid side by side under short names.

    Raises
    ------
    ParameterError
        If they have nothing in common.
    """
    return compare([replace(analysis, name=_short(analysis.name)) for analysis in analyses])


def compared_diagram(comparison: Comparison, analyses: Sequence[Analysis], kind: str, axis: str) -> Diagram:
    """Return a diagram of two or more analyses on a shared axis; differences from the first for ``heat``."""
    shared = comparison.axes[axis]
    across = translate("Trabecula", "{} from the low end, mm").format(title(axis))
    if kind == "areas":
        label, curves = translate("Trabecula", "area of outer contours, mm²"), []
        for number, (name, analysis) in enumerate(zip(comparison.names, analyses)):
            measures = analysis.measures[axis]
            rows = measures.area > 0
            where = analysis.profiles[axis].coordinate[measures.plane[rows]] - shared.origins[number]
            curves.append(Curve(name, where, measures.area[rows], COLOURS[number % len(COLOURS)], marks=True))
        return Diagram(across, label, curves, is_log=True)
    if kind == "heat":
        return _differences(comparison, shared, across)
    label, factor = _LABELS[kind]
    curves = [
        Curve(name, shared.middles, factor * values, COLOURS[number % len(COLOURS)])
        for number, (name, values) in enumerate(zip(comparison.names, shared.values[kind]))
    ]
    return Diagram(across, label, curves, size=SIZES.get(kind, 0.0))


def _differences(comparison: Comparison, shared: SharedAxis, across: str) -> Diagram:
    label = translate("Trabecula", "sliced area less that of {}, mm²").format(comparison.names[0])
    curves = [Curve("", shared.middles, np.zeros(len(shared.middles)), _GREY)]
    for number in range(1, len(comparison.names)):
        values = shared.difference("sliced_area", number).values
        curves.append(Curve(comparison.names[number], shared.middles, values, COLOURS[number % len(COLOURS)]))
    return Diagram(across, label, curves, size=float(np.nanmax(np.abs(shared.values["sliced_area"]))))


def passport_of(comparison: Comparison, analyses: Sequence[Analysis]) -> Tuple[List[str], List[Row]]:
    """Return head and rows of the comparison: tables 5.11 to 5.13, then the scores of each against the first."""
    head, lines = comparison.table()
    axes = list(comparison.axes)
    count = len(comparison.names)
    rows = []
    for (words, *cells), key in zip(lines, TOTAL_KEYS):
        for number, name in enumerate(comparison.names):
            values = [_cell_text(one) for one in cells[number::count]]
            rows.append(Row(f"{with_powers(in_words(words))}: {name}", values, key))
    for number in range(1, count):
        found = passport(analyses[0], analyses[number])
        tail = f", {comparison.names[number]}" if count > 2 else ""
        whole = {(score.of, score.symbol): score for score in found.whole}
        for first in found.axes[axes[0]]:
            pair = (first.of, first.symbol)
            values = [_score(found.axes[axis], pair) for axis in axes]
            values.append(number_text(whole[pair].value) if pair in whole else "")
            words, key = f"{in_words(first.of)}: {first.symbol}{tail}", f"passport.{first.symbol}"
            rows.append(Row(words, values, key, in_words(first.definition)))
    return [translate("Trabecula", "Quantity"), *(title(axis) for axis in axes), translate("Trabecula", "Whole")], rows


def _score(scores: Any, key: Tuple[str, str]) -> str:
    return next((number_text(score.value) for score in scores if (score.of, score.symbol) == key), "-")
