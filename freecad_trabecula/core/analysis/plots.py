# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of analyses and comparisons: figures 5.8 to 5.74 of the thesis (matplotlib, which is optional).

The ``draw_...`` functions draw into axes that are given; the ``..._figures`` functions make whole figures. Colours are
those of Okabe and Ito, which the colour-blind tell apart; curves differ by their dashes too.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Sequence, Tuple, Union

import numpy as np

from ..axis_range import shown_range
from ..optional_packages import optional_module
from ..stl import whole_file
from .contours import ContourMeasures
from .passport import trabecular_areas
from .profiles import Profile

if TYPE_CHECKING:
    from .analysis import Analysis
    from .comparison import Comparison, SharedAxis

FORMATS = ("png", "svg", "pdf")
#: Okabe and Ito, Color Universal Design, 2008.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
_DASHES: Tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1.5, 1)), (0, (5, 1, 1, 1)))
_DPI = 150  # of PNG: a figure of 9 inches is 1350 pixels wide
_AREA_BINS = 40
_COORDINATE_BINS = 200  # at most, of a heat map
#: name of a profile's quantity: label, factor
_LABELS = {
    "sliced_area": ("sliced area, mm²", 1.0),
    "porosity": ("porosity, %", 100.0),
    "contours": ("contours", 1.0),
    "outer_contours": ("outer contours", 1.0),
    "largest_area": ("largest trabecular area, mm²", 1.0),
}
#: What a quantity is computed from, where that is larger than itself may be: a porosity is 100 % less a share.
SIZES = {"porosity": 100.0}
_STARTS = {"start": "from the low end", "centre": "from the middle", "own": ""}


def require_matplotlib() -> Any:
    """Return the module matplotlib.

    Raises
    ------
    DependencyError
        If it is missing; the message says how to install it.
    """
    for part in ("matplotlib.figure", "matplotlib"):
        module = optional_module(part, "plots need matplotlib")
    return module


def new_figure(width: float, height: float) -> Any:
    """Return an empty figure (matplotlib.figure.Figure), sizes in inches, that belongs to no window."""
    return require_matplotlib().figure.Figure(figsize=(width, height), layout="constrained")


def save_figure(figure: Any, path: Union[str, Path], kind: str) -> None:
    """Write a figure in one of ``FORMATS``; the same figure gives the same file.

    Raises
    ------
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    dates: Dict[str, Dict[str, Any]] = {"png": {}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}
    with require_matplotlib().rc_context({"svg.hashsalt": "trabecula"}), whole_file(path) as file:
        figure.savefig(file, format=kind, dpi=_DPI, metadata=dates[kind])


# -------------------------------------------------------------------------------------------------------- one analysis


def analysis_figures(analysis: Analysis) -> Iterator[Tuple[str, Any]]:
    """Yield the figures of an analysis with their names: figures 5.8 to 5.15 of the thesis."""
    for name in ("sliced_area", "porosity"):
        figure = new_figure(8, 4.5)
        axes = figure.subplots()
        draw_profiles(axes, analysis.profiles, name)
        _level(axes, SIZES.get(name, 0.0))
        axes.set_title(_short(analysis.name), loc="left")
        yield name, figure
    figure = new_figure(8, 2.4 * len(analysis.profiles) + 0.6)
    rows = figure.subplots(len(analysis.profiles), 1, squeeze=False, sharey=True)[:, 0]
    for axes, profile in zip(rows, analysis.profiles.values()):
        draw_counts(axes, profile)
    rows[0].set_title(_short(analysis.name), loc="left")
    rows[0].set_ylim(bottom=0)
    for axes in rows[1:]:
        axes.get_legend().remove()
    yield "number_of_trabeculae", figure
    for axis, profile in analysis.profiles.items():
        yield f"trabecular_area_{axis}", _area_figure(analysis, axis, profile)


def draw_profiles(axes: Any, profiles: Mapping[str, Profile], quantity: str) -> None:
    """Draw a quantity of the slices along all axes into one diagram (figures 5.8, 5.9)."""
    label, factor = _LABELS[quantity]
    for number, (axis, profile) in enumerate(profiles.items()):
        values = factor * np.asarray(getattr(profile, quantity), float)
        _curve(axes, profile.coordinate, values, number, f"along {_title(axis)}")
        spoilt = np.flatnonzero(profile.spoilt)
        if len(spoilt):
            axes.plot(
                *(profile.coordinate[spoilt], values[spoilt], "x"), color=COLOURS[number % len(COLOURS)], label="spoilt"
            )
    _finish(axes, "co-ordinate, mm", label)
    _legend_above(axes)


def draw_counts(axes: Any, profile: Profile) -> None:
    """Draw the number of contours, as the thesis counts trabeculae, and of outer contours (figures 5.13 to 5.15)."""
    _curve(axes, profile.coordinate, profile.contours, 0, "contours (as the thesis counts)")
    _curve(axes, profile.coordinate, profile.outer_contours, 1, "outer contours")
    _finish(axes, f"{_title(profile.axis)}, mm", "number of trabeculae")
    _legend_above(axes)


def draw_areas(axes: Any, profile: Profile, measures: ContourMeasures) -> None:
    """Draw every contour's area against its co-ordinate, rods and plates apart, voids below 0 (5.10 to 5.12)."""
    where = profile.coordinate[measures.plane]
    outer, rod = measures.area > 0, measures.is_rod
    kinds = (("plates", outer & ~rod, "^", 1), ("rods", outer & rod, "o", 0), ("voids", measures.area < 0, "v", 2))
    for label, rows, marker, number in kinds:
        axes.plot(
            *(where[rows], measures.area[rows], marker),
            **{"color": COLOURS[number], "markersize": 2.5, "markeredgewidth": 0, "alpha": 0.7, "rasterized": True},
            label=label,
        )
    axes.axhline(0, color="0.4", linewidth=0.8)
    _finish(axes, f"{_title(profile.axis)}, mm", "trabecular area, mm²\n(voids below 0)")
    _legend_above(axes, markerscale=2.5)


def draw_heat_map(
    axes: Any, where: np.ndarray, areas: np.ndarray, edges: Tuple[np.ndarray, np.ndarray], most: float
) -> Any:
    """Draw how many areas there are against their co-ordinate; return what a colour bar needs.

    Parameters
    ----------
    axes : matplotlib axes
    where : ndarray of shape (C,), mm
        Co-ordinates of the contours.
    areas : ndarray of shape (C,), mm²
        Above 0.
    edges : pair of ndarrays, mm and mm²
        Borders of the bins.
    most : float
        Number for the brightest colour.
    """
    colors = require_matplotlib().colors
    counts = np.histogram2d(where, areas, bins=edges)[0]
    drawn = np.ma.masked_equal(counts.T, 0)
    mesh = axes.pcolormesh(
        *(edges[0], edges[1], drawn),
        **{"cmap": "viridis", "norm": colors.LogNorm(1, max(most, 2)), "rasterized": True},
    )
    axes.set_yscale("log")
    _plain_numbers(axes.yaxis)
    axes.set_ylim(edges[1][0], edges[1][-1])
    axes.set_xlim(edges[0][0], edges[0][-1])
    return mesh


def area_edges(areas: np.ndarray) -> np.ndarray:
    """Return borders of bins, mm², even in the logarithm, that hold all areas (above 0)."""
    low, high = (float(areas.min()), float(areas.max())) if len(areas) else (0.1, 1.0)
    low = max(low, high * 1e-6)  # what is smaller is dust that would squeeze the rest
    return np.geomspace(low, max(high, low * 1.01) * 1.000001, _AREA_BINS + 1)


def _area_figure(analysis: Analysis, axis: str, profile: Profile) -> Any:
    measures = analysis.measures[axis]
    figure = new_figure(8, 7)
    upper, lower = figure.subplots(2, 1, sharex=True)
    draw_areas(upper, profile, measures)
    upper.set_xlabel("")
    upper.set_title(_short(analysis.name), loc="left")
    rows = measures.area > 0
    edges = (coordinate_edges(profile), area_edges(measures.area[rows]))
    where = profile.coordinate[measures.plane[rows]]
    most = float(np.histogram2d(where, measures.area[rows], bins=edges)[0].max())
    mesh = draw_heat_map(lower, where, measures.area[rows], edges, most)
    _finish(lower, f"{_title(axis)}, mm", "area of outer contours, mm²")
    bar = figure.colorbar(mesh, ax=lower, label="contours a bin", location="bottom", aspect=60, shrink=0.6)
    _plain_numbers(bar.ax.xaxis)
    return figure


def coordinate_edges(profile: Profile, origin: float = 0.0) -> np.ndarray:
    """Return borders of bins of the co-ordinate, mm from ``origin``: whole layers, at most 200 bins."""
    middles, half = profile.coordinate - origin, profile.thickness / 2
    if not len(middles):
        return np.array([-half, half])
    per_bin = -(-len(middles) // _COORDINATE_BINS)
    between = (middles[1:] + middles[:-1]) / 2
    edges = np.concatenate([[middles[0] - half], between[per_bin - 1 :: per_bin], [middles[-1] + half]])
    return np.unique(edges)


# -------------------------------------------------------------------------------------------------------- a comparison


def comparison_figures(comparison: Comparison, analyses: Sequence[Analysis]) -> Iterator[Tuple[str, Any]]:
    """Yield the figures of a comparison with their names: figures 5.48 to 5.74, differences under the curves."""
    for quantity in _LABELS:
        yield quantity, _difference_figure(comparison, quantity)
    yield "trabecular_area", _heat_map_figure(comparison, analyses)
    yield "area_distribution", _distribution_figure(comparison, analyses)


def _difference_figure(comparison: Comparison, quantity: str) -> Any:
    count = len(comparison.axes)
    figure = new_figure(4.2 * count + 0.8, 6)
    grid = figure.subplots(2, count, squeeze=False, sharey="row", sharex="col", gridspec_kw={"height_ratios": (2, 1)})
    for column, shared in enumerate(comparison.axes.values()):
        draw_curves(grid[0, column], shared, comparison.names, quantity)
        draw_differences(grid[1, column], shared, comparison.names, quantity)
        for axes in grid[:, column]:
            axes.label_outer()
        grid[1, column].set_xlabel(_distance(shared.axis, comparison.alignment))
        grid[0, column].set_title(f"along {_title(shared.axis)}")
    size = SIZES.get(quantity, 0.0)
    _level(grid[0, 0], size)
    _level(grid[1, 0], max(size, float(np.abs(grid[0, 0].get_ylim()).max())))
    _legend_of_all(figure, grid[0, 0])
    return figure


def draw_curves(axes: Any, shared: SharedAxis, names: Sequence[str], quantity: str) -> None:
    """Draw a quantity of all samples along one axis."""
    label, factor = _LABELS[quantity]
    for number, values in enumerate(shared.values[quantity]):
        _curve(axes, shared.middles, factor * values, number, _short(names[number]))
    _finish(axes, "", label)


def draw_differences(axes: Any, shared: SharedAxis, names: Sequence[str], quantity: str) -> None:
    """Draw by how much the samples differ from the first along one axis."""
    label, factor = _LABELS[quantity]
    for number in range(1, len(names)):
        values = factor * shared.difference(quantity, number).values
        axes.fill_between(shared.middles, values, color=COLOURS[number % len(COLOURS)], alpha=0.25, linewidth=0)
        _curve(axes, shared.middles, values, number, names[number])
    axes.axhline(0, color="0.4", linewidth=0.8)
    _finish(axes, "", "difference" + (f", {label.rpartition(', ')[2]}" if "," in label else ""))


def _heat_map_figure(comparison: Comparison, analyses: Sequence[Analysis]) -> Any:
    """Heat maps of the outer contours' areas: one row for each sample, one column for each axis, one scale for all."""
    axes_names = list(comparison.axes)
    figure = new_figure(4.2 * len(axes_names) + 0.8, 2.6 * len(analyses) + 1)
    grid = figure.subplots(len(analyses), len(axes_names), squeeze=False, sharey=True, sharex="col")
    areas = [[analysis.measures[axis].area for axis in axes_names] for analysis in analyses]
    levels = area_edges(np.concatenate([values[values > 0] for row in areas for values in row]))
    parts: List[Tuple[Any, ...]] = []
    for k, analysis in enumerate(analyses):
        for column, axis in enumerate(axes_names):
            origin, measures = comparison.axes[axis].origins[k], analysis.measures[axis]
            rows = measures.area > 0
            where = analysis.profiles[axis].coordinate[measures.plane[rows]] - origin
            edges = (coordinate_edges(analysis.profiles[axis], origin), levels)
            parts.append((grid[k, column], where, measures.area[rows], edges))
    most = max(float(np.histogram2d(where, values, bins=edges)[0].max()) for _, where, values, edges in parts)
    meshes = [draw_heat_map(axes, where, values, edges, most) for axes, where, values, edges in parts]
    for column, axis in enumerate(axes_names):
        spans = [part[3][0] for part in parts[column :: len(axes_names)]]
        grid[0, column].set_xlim(min(s[0] for s in spans), max(s[-1] for s in spans))
        grid[0, column].set_title(f"along {_title(axis)}")
        grid[-1, column].set_xlabel(_distance(axis, comparison.alignment))
    for k, name in enumerate(comparison.names):
        grid[k, 0].set_ylabel(f"{_short(name)}\narea of outer contours, mm²")
    for axes in grid.ravel():
        axes.grid(color="0.92", linewidth=0.6)
        axes.set_axisbelow(True)
    _plain_numbers(figure.colorbar(meshes[0], ax=grid, label="contours a bin", aspect=40).ax.yaxis)
    return figure


def _distribution_figure(comparison: Comparison, analyses: Sequence[Analysis]) -> Any:
    """Share of the trabeculae up to an area: what the Kolmogorov-Smirnov distance compares."""
    figure = new_figure(4.2 * len(comparison.axes) + 0.8, 4)
    row = figure.subplots(1, len(comparison.axes), squeeze=False, sharey=True, sharex=True)[0]
    for axes, axis in zip(row, comparison.axes):
        for number, analysis in enumerate(analyses):
            areas = np.sort(trabecular_areas(analysis, axis))
            share = 100 * np.arange(1, len(areas) + 1) / max(len(areas), 1)
            _curve(axes, areas, share, number, f"{_short(analysis.name)} ({len(areas)})")
        axes.set_xscale("log")
        _plain_numbers(axes.xaxis)
        _finish(axes, "trabecular area, net of holes, mm²", "trabeculae up to this area, %")
        axes.set_title(f"along {_title(axis)}")
        axes.legend(frameon=False)
        axes.label_outer()
    return figure


# --------------------------------------------------------------------------------------------------------------- words


def _curve(axes: Any, where: np.ndarray, values: np.ndarray, number: int, label: str) -> None:
    style = {"color": COLOURS[number % len(COLOURS)], "linestyle": _DASHES[number % len(_DASHES)], "linewidth": 1.4}
    axes.plot(where, values, label=label, marker="o" if len(where) == 1 else "", **style)


def _finish(axes: Any, across: str, up: str) -> None:
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    axes.grid(color="0.88", linewidth=0.6)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _level(axes: Any, size: float = 0.0) -> None:
    """Draw what is equal but for rounding as a level line; ``size`` as ``shown_range`` takes it."""
    found = axes.get_ylim()
    shown = shown_range(found[0], found[1], size)
    if shown != found:
        axes.set_ylim(shown)


def _legend_above(axes: Any, **more: Any) -> None:
    """Put the legend over the right end of a diagram, where it hides nothing; the title stands at the left."""
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), frameon=False, ncol=4, borderpad=0.2, **more)


def _legend_of_all(figure: Any, axes: Any) -> None:
    """Put one legend over all diagrams, in the room of an empty title, three names in a line."""
    handles, labels = axes.get_legend_handles_labels()
    figure.suptitle("\n" * ((len(labels) - 1) // 3) + " ", fontsize="x-large")
    figure.legend(handles, labels, loc="upper center", ncol=min(len(labels), 3), frameon=False)


def _plain_numbers(axis: Any) -> None:
    """Write 0.01, not 10^-2, along a logarithmic axis: that needs no parser of formulas."""
    ticker = require_matplotlib().ticker
    axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(ticker.NullFormatter())


def _title(axis: str) -> str:
    return axis.upper() if len(axis) == 1 else f"({axis})"


def _distance(axis: str, alignment: str) -> str:
    return f"{_title(axis)} {_STARTS[alignment]}".rstrip() + ", mm"


def _short(name: str) -> str:
    return name if len(name) <= 28 else name[:27] + "…"
