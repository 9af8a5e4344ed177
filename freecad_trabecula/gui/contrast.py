# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of words that can be read on light and dark themes: lightened or darkened until they stand out."""

from __future__ import annotations

from typing import Tuple

Rgb = Tuple[int, int, int]
#: Ratio of luminances: 4.5 is the least for text (WCAG 2.1, 1.4.3); a little more, for panels are greyer than paper.
LEAST = 5.5
_STEPS = 20


def luminance(colour: Rgb) -> float:
    """Return the relative luminance of a colour, 0 to 1 (WCAG 2.1).

    Parameters
    ----------
    colour : tuple of int
        Red, green, blue, 0 to 255.
    """
    parts = [part / 255 for part in colour]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: Rgb, other: Rgb) -> float:
    """Return how far two colours stand out from each other, 1 to 21 (WCAG 2.1).

    Examples
    --------
    >>> round(contrast((0, 0, 0), (255, 255, 255)), 6)
    21.0
    """
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def readable(code: str, paper: Rgb, least: float = LEAST) -> str:
    """Return a colour, such as ``#d64545``, as light or dark as it must be to be read as words on a paper.

    Examples
    --------
    >>> readable("#000000", (255, 255, 255)), readable("#000000", (0, 0, 0), 21.0)
    ('#000000', '#ffffff')
    """
    colour: Rgb = (int(code[1:3], 16), int(code[3:5], 16), int(code[5:7], 16))
    end = 255 if luminance(paper) < 0.18 else 0  # the grey on which black and white are read alike
    for step in range(_STEPS + 1):
        red, green, blue = (round(part + (end - part) * step / _STEPS) for part in colour)
        if contrast((red, green, blue), paper) >= least:
            break
    return f"#{red:02x}{green:02x}{blue:02x}"
