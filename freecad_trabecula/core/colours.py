# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that carry meaning: a scale for numbers, classes for names, and the legend that says what they mean.

Both are told apart by colour-blind eyes: the scale's lightness rises evenly, and no two classes differ by red and green
alone.
"""

from __future__ import annotations

from typing import NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike

Colour = Tuple[int, int, int]
#: Low to high: Viridis without its darkest end, so that it stands out on dark and light (BSD, van der Walt, Smith).
SCALE: Tuple[Colour, ...] = ((68, 57, 131), (49, 104, 142), (33, 145, 140), (94, 201, 98), (253, 231, 37))
#: Okabe and Ito's colours (Color Universal Design, 2008), black left out.
CLASSES: Tuple[Colour, ...] = (
    *((230, 159, 0), (86, 180, 233), (0, 158, 115), (240, 228, 66)),
    *((0, 114, 178), (213, 94, 0), (204, 121, 167), (150, 150, 150)),
)
ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE, GREY = CLASSES


class Entry(NamedTuple):
    """A class in a legend: its name, its colour, how many there are."""

    name: str
    colour: Colour
    count: int  # type: ignore[assignment]  # of tuple.count, which nobody asks a class for


class Legend(NamedTuple):
    """What colours mean: a range of numbers, or classes.

    Attributes
    ----------
    quantity : str
        E.g. ``size``.
    unit : str
        Of the range; empty for shares and counts.
    low, high : float
        Of the scale.
    entries : tuple of Entry
        Classes; none: the scale is meant.
    """

    quantity: str
    unit: str = ""
    low: float = 0.0
    high: float = 0.0
    entries: Tuple[Entry, ...] = ()


class Colouring(NamedTuple):
    """Colours (N, 3), uint8, of N things, and what they mean."""

    colours: np.ndarray
    legend: Legend

    def of(self, numbers: np.ndarray) -> Colouring:
        """Return the colouring of things each of which belongs to one of these, by its number."""
        return self._replace(colours=self.colours[numbers])


def scale_colours(shares: ArrayLike) -> np.ndarray:
    """Return the colours (..., 3) of 0..255 for shares 0..1 of a range; nan is grey.

    Examples
    --------
    >>> scale_colours(np.array([0.0, 1.0, np.nan])).tolist()
    [[68, 57, 131], [253, 231, 37], [150, 150, 150]]
    """
    shares, table = np.asarray(shares, float), np.array(SCALE, float)
    places = np.linspace(0, 1, len(table))
    known = np.where(np.isfinite(shares), shares, 0.0)
    colours = np.stack([np.interp(known, places, table[:, channel]) for channel in range(3)], -1)
    return np.where(np.isfinite(shares)[..., None], np.round(colours), GREY).astype(np.uint8)


def by_value(values: ArrayLike, quantity: str, unit: str = "", bounds: ArrayLike = ()) -> Colouring:
    """Return the colouring of things by a number (N,); nan is grey, the range that of ``bounds`` or of the others.

    Examples
    --------
    >>> by_value([2.0, 4.0, 3.0], "size", "mm").legend[1:4]
    ('mm', 2.0, 4.0)
    """
    values, known = np.asarray(values, float), np.asarray(bounds, float)
    known = known if len(known) else values
    known = known[np.isfinite(known)]
    low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 0.0)
    shares = (values - low) / max(high - low, 1e-12 * max(abs(high), 1e-300))
    return Colouring(scale_colours(shares), Legend(quantity, unit, low, high))


def by_class(
    classes: np.ndarray, names: Sequence[str], quantity: str, colours: Sequence[Colour] = CLASSES
) -> Colouring:
    """Return the colouring of things by the number (N,) of their class; classes without any are not in the legend.

    Examples
    --------
    >>> by_class(np.array([1, 1, 0]), ["X", "Y", "Z"], "coupling").legend.entries[1]
    Entry(name='Y', colour=(86, 180, 233), count=2)
    """
    classes = np.asarray(classes, int)
    counts = np.bincount(classes, minlength=len(names))
    table = [colours[k % len(colours)] for k in range(len(names))]
    entries = [Entry(name, table[k], int(counts[k])) for k, name in enumerate(names) if counts[k]]
    chosen = np.array(table or [GREY], np.uint8)[classes] if len(classes) else np.zeros((0, 3), np.uint8)
    return Colouring(chosen, Legend(quantity, entries=tuple(entries)))
