# SPDX-License-Identifier: LGPL-2.1-or-later
"""All explanations by key, and the page that lists them (docs/measures.md)."""

from __future__ import annotations

from typing import Dict, List, Sequence, Tuple

from ...errors import ParameterError
from ..analysis.morphometry import AXIS_TABLE
from . import design_numbers, slice_numbers, voxel_numbers
from .explanation import Explanation

#: Titles and their numbers, in the order of the page.
GROUPS: Tuple[Tuple[str, Sequence[Explanation]], ...] = (
    ("Designs of rods, scaffolds, variants", design_numbers.NUMBERS),
    ("Slices", slice_numbers.SLICES),
    ("Bodies as wholes (morphometry)", slice_numbers.MEASURES),
    ("Comparisons", slice_numbers.DIFFERENCES),
    ("Scores of the slice passport", slice_numbers.SCORES),
    ("Voxel designs", voxel_numbers.NUMBERS),
)
#: Keys of the rows of ``Comparison.table`` (tables 5.11 to 5.13).
TOTAL_KEYS = ("slices.all_rods", "slices.all_plates", "slices.trabecular_area", "slices.sliced_area")
_BY_KEY: Dict[str, Explanation] = {one.key: one for _, group in GROUPS for one in group}
_HEAD = """# Why each number is what it is

Every number that a panel, a page or a report shows: how it is worked out, where that stands, and by which other route
it is checked. Where there is no second route it says *none*. In the window a click on a row tells the same with the
values found. Made by `python3 tools/measures_page.py`.
"""


def explanation(key: str) -> Explanation:
    """Return the explanation of a number.

    Raises
    ------
    ParameterError
        If there is none of that key.

    Examples
    --------
    >>> explanation("design.porosity").source
    'thesis Eq. 2.2'
    """
    found = _BY_KEY.get(key)
    if found is None:
        raise ParameterError(f"a number must be one of {len(_BY_KEY)} that are explained, got {key!r}")
    return found


def all_keys() -> Tuple[str, ...]:
    """Return the keys of all numbers."""
    return tuple(_BY_KEY)


def measure_key(symbol: str) -> str:
    """Return the key of a measure of a body; of one along an axis (``Br.x``) that without the axis.

    Examples
    --------
    >>> measure_key("Tb.Th"), measure_key("Jn.z")
    ('morphometry.Tb.Th', 'morphometry.Jn')
    """
    head = symbol.split(".")[0]
    return f"morphometry.{head if head in AXIS_TABLE else symbol}"


def page() -> str:
    """Return docs/measures.md."""
    parts = [_HEAD]
    for title, group in GROUPS:
        rows: List[Tuple[str, ...]] = [("number", "unit", "formula", "source", "second route"), ("---",) * 5]
        rows += [_row(one) for one in group]
        table = "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows)
        parts.append(f"## {title}\n\n{table}\n")
    return "\n".join(parts)


def _row(one: Explanation) -> Tuple[str, ...]:
    words: List[str] = [one.name]
    if one.symbol and one.symbol not in one.name:
        words.append(f"*{one.symbol}*")
    second = f"{one.second}; {one.tolerance}" if one.tolerance else one.second
    return ", ".join(words), one.unit, one.formula, one.source, second
