# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small diagrams as SVG that stand in the page itself: lines on dark screens and on paper in the page's own colours."""

from __future__ import annotations

import math
from html import escape
from typing import List, NamedTuple, Sequence, Tuple

import numpy as np

from ..language import Words

#: Colours that are told apart by colour-blind readers, on light and on dark (Wong 2011, doi:10.1038/nmeth.1618).
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
_WIDTH, _HEIGHT, _LEFT, _RIGHT, _TOP, _BOTTOM = 460, 240, 52, 10, 26, 36
_TICKS = 5
_MOST_POINTS = 600


class Line(NamedTuple):
    """A curve: its name, where, and how much (arrays of one length; nan is a gap)."""

    name: str
    x: np.ndarray
    y: np.ndarray


def line_chart(title: str, across: str, lines: Sequence[Line], words: Words = str) -> str:
    """Return a diagram of curves over a common axis; an empty text if there is nothing to draw.

    ``words`` puts the title, the name of the axis and the numbers into a language.
    """
    title, across = words(title), words(across)
    lines = [_thinned(line) for line in lines if np.isfinite(line.y).any()]
    if not lines:
        return ""
    xs, ys = (np.concatenate([getattr(line, name) for line in lines]) for name in "xy")
    x_ticks, y_ticks = _ticks(np.nanmin(xs), np.nanmax(xs)), _ticks(min(np.nanmin(ys), 0.0), np.nanmax(ys))
    parts = [*_frame(title, across, x_ticks, y_ticks, words)]
    for number, line in enumerate(lines):
        colour = COLOURS[number % len(COLOURS)]
        path = _path(_place(line.x, x_ticks, _LEFT, _WIDTH - _RIGHT), _place(line.y, y_ticks, _HEIGHT - _BOTTOM, _TOP))
        parts.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
    parts += _legend([line.name for line in lines])
    return _svg(title, parts)


def bar_chart(title: str, across: str, edges: Sequence[float], counts: Sequence[float], words: Words = str) -> str:
    """Return a histogram; an empty text if there is nothing to draw. ``words`` as in ``line_chart``."""
    title, across = words(title), words(across)
    if not len(counts) or not max(counts) > 0:
        return ""
    x_ticks, y_ticks = _ticks(edges[0], edges[-1]), _ticks(0.0, max(counts))
    x = _place(np.asarray(edges, float), x_ticks, _LEFT, _WIDTH - _RIGHT)
    y = _place(np.asarray(counts, float), y_ticks, _HEIGHT - _BOTTOM, _TOP)
    parts = _frame(title, across, x_ticks, y_ticks, words)
    for left, right, top in zip(x[:-1], x[1:], y):
        parts.append(
            f'<rect x="{left + 0.5:.1f}" y="{top:.1f}" width="{max(right - left - 1, 0.5):.1f}" '
            f'height="{_HEIGHT - _BOTTOM - top:.1f}" fill="{COLOURS[0]}"/>'
        )
    return _svg(title, parts)


def _thinned(line: Line) -> Line:
    """At most so many points as can be seen."""
    step = max(1, -(-len(line.x) // _MOST_POINTS))
    return Line(line.name, np.asarray(line.x, float)[::step], np.asarray(line.y, float)[::step])


def _ticks(low: float, high: float) -> List[float]:
    """Round numbers from at most ``low`` to at least ``high``."""
    span = high - low if high > low else max(abs(high), 1.0)
    raw = span / _TICKS
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(power * factor for factor in (1, 2, 2.5, 5, 10) if power * factor >= raw * 0.999)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [step * number for number in range(first, max(last, first + 1) + 1)]


def _place(values: np.ndarray, ticks: Sequence[float], low: float, high: float) -> np.ndarray:
    return low + (np.asarray(values, float) - ticks[0]) / (ticks[-1] - ticks[0]) * (high - low)


def _path(x: np.ndarray, y: np.ndarray) -> str:
    words, pen_up = [], True
    for a, b in zip(x.tolist(), y.tolist()):
        if math.isnan(b):
            pen_up = True
            continue
        words.append(f"{'M' if pen_up else 'L'}{a:.1f} {b:.1f}")
        pen_up = False
    return "".join(words)


def _frame(title: str, across: str, x_ticks: Sequence[float], y_ticks: Sequence[float], words: Words) -> List[str]:
    parts = [f'<text x="{_LEFT}" y="14" font-weight="bold">{escape(title)}</text>']
    middle = (_LEFT + _WIDTH - _RIGHT) / 2
    parts.append(f'<text x="{middle:.0f}" y="{_HEIGHT - 4}" text-anchor="middle">{escape(across)}</text>')
    for number, place in _with_places(x_ticks, _LEFT, _WIDTH - _RIGHT, words):
        parts.append(f'<text x="{place:.1f}" y="{_HEIGHT - _BOTTOM + 14}" text-anchor="middle">{number}</text>')
    for number, place in _with_places(y_ticks, _HEIGHT - _BOTTOM, _TOP, words):
        parts.append(
            f'<path d="M{_LEFT} {place:.1f}H{_WIDTH - _RIGHT}" stroke="currentColor" stroke-opacity="0.2"/>'
            f'<text x="{_LEFT - 5}" y="{place + 4:.1f}" text-anchor="end">{number}</text>'
        )
    return parts


def _with_places(ticks: Sequence[float], low: float, high: float, words: Words) -> List[Tuple[str, float]]:
    numbers = [words(f"{float(f'{value:.6g}'):g}") for value in ticks]
    return list(zip(numbers, _place(np.asarray(ticks), ticks, low, high).tolist()))


def _legend(names: Sequence[str]) -> List[str]:
    parts: List[str] = []
    x = _WIDTH - _RIGHT
    if len(names) < 2:
        return parts
    for number in range(len(names))[::-1]:
        word = names[number] if len(names[number]) <= 14 else names[number][:13] + "…"
        x -= 7 * len(word) + 22
        colour = COLOURS[number % len(COLOURS)]
        parts.append(
            f'<path d="M{x} 10h14" stroke="{colour}" stroke-width="3"/><text x="{x + 18}" y="14">{escape(word)}</text>'
        )
    return parts


def _svg(title: str, parts: Sequence[str]) -> str:
    return (
        f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" role="img" aria-label="{escape(title, quote=True)}">'
        + "".join(parts)
        + "</svg>"
    )
