# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an option of the command line may be: texts to values, refused in one sentence. Standard library only."""

from __future__ import annotations

import argparse
import math
from typing import List, Optional

#: How the command line is called.
PROGRAM = "python3 -m freecad_trabecula"


def whole_number(text: str) -> int:
    """Return a whole number."""
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"it must be a whole number, got {text!r}") from None


def pair(text: str) -> str:
    """Return the names of two faces, FACE:FACE, without blanks."""
    first, colon, second = text.partition(":")
    if not (colon and first.strip() and second.strip()) or ":" in second:
        raise argparse.ArgumentTypeError(f"two faces must read FACE:FACE, e.g. Face1:Face2, got {text!r}")
    return f"{first.strip()}:{second.strip()}"


def number(text: str) -> float:
    """Return a finite number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"it must be a number, got {text!r}")
    return value


def axes(text: str) -> List[str]:
    """Return the axes in ``xyz``, ``x,z`` or a direction of three numbers."""
    words = [word.strip().lower() for word in text.split(",")]
    if len(words) == 3 and not set("".join(words)) & set("xyz"):
        return [",".join(repr(number(word)) for word in words)]
    letters = "".join(words)
    if not letters or set(letters) - set("xyz"):
        raise argparse.ArgumentTypeError(f"axes must read xyz, x,z or a direction such as 0.6,0.8,0, got {text!r}")
    return list(letters)


def heights(text: str) -> List[float]:
    """Return the numbers in ``0.5,1,2``."""
    return [number(word) for word in text.split(",")]


def value_range(text: str) -> List[Optional[float]]:
    """Return both ends of ``LOW:HIGH``, None for one that is left out."""
    low, colon, high = text.partition(":")
    if not colon or not (low.strip() or high.strip()):
        raise argparse.ArgumentTypeError(f"a range must read LOW:HIGH, LOW: or :HIGH, got {text!r}")
    return [number(end) if end.strip() else None for end in (low, high)]
